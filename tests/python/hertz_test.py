# SPDX-License-Identifier: GPL-3.0-or-later
"""Hertz's contact: the program's ellipse, pressures that solve the contact, arrays, errors."""
import warnings

import numpy as np
import pytest

import microslip as ms

STEEL = {"youngs_modulus": 210000, "poisson_ratio": 0.28}


def test_it_is_the_ellipse_of_a_scene(ellipse):
    solved = ms.solve(ellipse, problem="steady", load_creepage=1e-4).summary
    found = ms.hertz(80000, radius_1=460, lateral_radius_2=300, friction=0.3, **STEEL)
    for name in ("half_width", "lateral_half_width"):
        assert getattr(found, name) == pytest.approx(solved[name], rel=1e-12)
    assert found.full_sliding == pytest.approx(solved["full_sliding_force"], rel=1e-12)
    assert found.peak_traction == pytest.approx(0.3 * found.peak_pressure, rel=1e-12)
    assert isinstance(found.half_width, float) and "half_width = 6.67644 mm" in repr(found)
    assert ms.hertz(80000, radius_1=460, lateral_radius_2=300, **STEEL).peak_traction is None


def test_pressures_press_the_bodies_into_one_another(random):
    """The displacement under the pressure is approach - x^2 sum(curvature)/2 - y^2 ...: in the middle, and along both axes.

    In polar coordinates about a point, the potential of a semi-elliptic pressure is an integral over its chords, each of
    which has a closed form: docs/ellipse.md, "Chords".
    """
    modulus = 210000 / (2 * (1 + 0.28)) / (1 - 0.28)
    angle = (np.arange(4000) + 0.5) * np.pi / 4000

    def displacement(contact, x, y):
        a, b = contact.half_width, contact.lateral_half_width
        # Along the line (x + t cos, y + t sin), 1 - x^2/a^2 - y^2/b^2 = rest - 2 middle t - bend t^2.
        bend = (np.cos(angle) / a) ** 2 + (np.sin(angle) / b) ** 2
        middle = x * np.cos(angle) / a**2 + y * np.sin(angle) / b**2
        rest = 1 - (x / a) ** 2 - (y / b) ** 2
        chords = np.pi / 2 * (rest + middle**2 / bend) / np.sqrt(bend)
        return contact.peak_pressure / (np.pi * modulus) * np.mean(chords) * np.pi

    for _ in range(20):
        radii = random.uniform(100, 1000, 4) * [1, random.choice([1, -20]), 1, random.choice([1, -20])]
        contact = ms.hertz(random.uniform(1e3, 1e5), radius_1=radii[0], radius_2=radii[1], lateral_radius_1=radii[2],
                           lateral_radius_2=radii[3], **STEEL)
        across, along = 1 / radii[2] + 1 / radii[3], 1 / radii[0] + 1 / radii[1]
        a, b = contact.half_width, contact.lateral_half_width
        assert displacement(contact, 0, 0) == pytest.approx(contact.approach, rel=1e-9)
        for part in (0.3, 1):
            assert contact.approach - displacement(contact, part * a, 0) == pytest.approx((part * a) ** 2 * along / 2, rel=1e-8)
            assert contact.approach - displacement(contact, 0, part * b) == pytest.approx((part * b) ** 2 * across / 2, rel=1e-8)
        assert contact.mean_pressure * contact.area == pytest.approx(contact.peak_pressure * contact.area * 2 / 3)


def test_spheres_have_closed_forms():
    contact = ms.hertz(1000, radius_1=50, lateral_radius_1=50, shear_modulus=80000, poisson_ratio=0.25)
    size = (3 * 1000 * 50 / (4 * 80000 / 0.75)) ** (1 / 3)
    assert contact.half_width == contact.lateral_half_width == pytest.approx(size, rel=1e-12)
    assert contact.approach == pytest.approx(size**2 / 50, rel=1e-12)


def test_arrays_are_broadcast(random):
    load, radius = random.uniform(1e4, 1e5, (3, 1)), random.uniform(300, 600, 4)
    many = ms.hertz(load, radius_1=radius, lateral_radius_2=300, friction=0.3, **STEEL)
    assert "(3, 4)" in repr(many)
    for i, j in np.ndindex(3, 4):
        one = ms.hertz(load[i, 0], radius_1=radius[j], radius_2=np.inf, lateral_radius_2=300, friction=0.3,
                       shear_modulus=210000 / 2.56, poisson_ratio=0.28)
        for name in ms.Hertz.units:
            assert getattr(many, name)[i, j] == pytest.approx(getattr(one, name), rel=1e-12), name
    assert ms.hertz([], radius_1=460, lateral_radius_2=300, **STEEL).half_width.shape == (0,)
    materials = ms.hertz(8e4, radius_1=460, lateral_radius_2=300, youngs_modulus=[2.1e5, 1e5], poisson_ratio=[0.28, 0.3])
    assert materials.approach[0] < materials.approach[1]


@pytest.mark.parametrize("given, message", [
    ({"normal_load": -1}, "^normal_load = -1: expected a number > 0"),
    ({"normal_load": [1e4, -1]}, "^contact 1: normal_load = -1: expected a number > 0"),
    ({"normal_load": np.nan}, "^normal_load = nan: expected a number"),
    ({"normal_load": "much"}, "^normal_load = 'much': expected numbers"),
    ({"normal_load": None}, "^normal_load = None: expected a number or an array"),
    ({"radius_1": [460, 0]}, r"^radius_1\[1\] = 0: expected a number that is not 0, or inf of a flat body"),
    ({"radius_1": None}, "^radius_1 = None: expected a radius of one body at least, radius_1 or radius_2"),
    ({"radius_1": [460, np.inf]}, r"^radius_1\[1\] = inf: expected a radius of one body at least"),
    ({"lateral_radius_2": None}, "^lateral_radius_1 = None: expected a radius of one body at least"),
    ({"radius_2": -400}, "^radius_2 = -400: expected a number > 0, or for a concave body one below -460, as its radius is "
                         "larger than radius_1"),
    ({"radius_1": -460}, "^radius_1 = -460: expected a number > 0, as the other body is flat, by radius_2"),
    ({"lateral_radius_1": -290}, "^lateral_radius_1 = -290: expected .* below -300, .* larger than lateral_radius_2"),
    ({"radius_1": 1e60}, r"^radius_1 = 1e[+]60: expected a number from 1e-50 to 1e50 in size, or 0 of a flat body"),
    ({"radius_1": [1, 2], "lateral_radius_2": [1, 2, 3]}, "^radius_1: expected arrays that numpy broadcasts"),
    ({"shear_modulus": 1}, "^youngs_modulus: expected either youngs_modulus or shear_modulus"),
    ({"youngs_modulus": None}, "^youngs_modulus: expected either youngs_modulus or shear_modulus"),
    ({"youngs_modulus": 0}, "^youngs_modulus = 0: expected a number > 0"),
    ({"poisson_ratio": 0.6}, "^poisson_ratio = 0.6: expected"),
    ({"friction": 11}, "^friction = 11: expected a number above 0, at most 10"),
    ({"normal_load": 1e12}, "^normal_load = 1e[+]12: expected a load under which the half-widths are below the radii")])
def test_bad_input_is_named(given, message):
    with pytest.raises(ms.InputError, match=message):
        ms.hertz(**{"normal_load": 80000, "radius_1": 460, "lateral_radius_2": 300, **STEEL, **given})


def test_large_contacts_are_warned_of():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        ms.hertz(1e6, radius_1=460, lateral_radius_2=300, **STEEL)
    with pytest.warns(ms.LoadWarning, match=r"^normal_load\[1\] = 3e[+]08: the lateral half width, .* more than a tenth") as told:
        ms.hertz([1e4, 3e8, 4e8], radius_1=4600, lateral_radius_2=300, **STEEL)
    assert told[0].filename == __file__
