# SPDX-License-Identifier: GPL-3.0-or-later
"""Fixtures that the tests of the Python package share."""
import pathlib

import numpy as np
import pytest

SOURCE = pathlib.Path(__file__).resolve().parents[2]
STEEL = {"shear_modulus": 82000, "poisson_ratio": 0.28}


@pytest.fixture(name="source")
def source_folder():
    return SOURCE


@pytest.fixture(name="scene")
def strip_scene():
    """A contact for everything, by Hertz, on a strip."""
    return {"material": STEEL, "contact": {"half_width": 5, "peak_traction": 300},
            "kernel": {"type": "strip", "width": 10}, "grid": {"elements": 40}}


@pytest.fixture(name="ellipse")
def ellipse_scene():
    """A wheel on a rail: full sliding is 24 kN."""
    return {"material": {"youngs_modulus": "210 GPa", "poisson_ratio": 0.28},
            "contact": {"normal_load": "80 kN", "radius_1": 460, "lateral_radius_2": 300, "friction": 0.3},
            "grid": {"rows": 6, "elements": 8}}


@pytest.fixture(name="plane")
def plane_scene(scene):
    """The same in plane strain, which Carter solved."""
    return {**scene, "kernel": {"type": "plane", "length": 100}}


@pytest.fixture(name="random")
def random_numbers():
    return np.random.default_rng(1)
