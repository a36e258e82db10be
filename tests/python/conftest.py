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


@pytest.fixture(name="plane")
def plane_scene(scene):
    """The same in plane strain, which Carter solved."""
    return {**scene, "kernel": {"type": "plane", "length": 100}}


@pytest.fixture(name="random")
def random_numbers():
    return np.random.default_rng(1)
