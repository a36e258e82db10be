# SPDX-License-Identifier: GPL-3.0-or-later
"""Hertz's contact of two bodies that touch in a point."""

from __future__ import annotations

import ctypes as c
from typing import Any, Dict, Optional, Tuple

import numpy as np

from ._arrays import Values, broadcast, fields_of, index_of, require_all, shown
from ._errors import InputError
from ._library import BODIES, ELLIPSE_CONTACT, MATERIAL, call, error_of
from ._result import warn_of

_RADII = ("radius_1", "radius_2", "lateral_radius_1", "lateral_radius_2")
_ROOM = 512  # of a message, in bytes
_SMALL = 0.1  # largest half-width over the smaller radius, at which Hertz's theory holds


class Hertz:
    """The contact of bodies that touch in a point; numbers, or arrays of the shape of what was given.

    Attributes
    ----------
    half_width, lateral_half_width : float or numpy.ndarray
        Semi-axes a along the rolling and b across it  [mm].
    peak_pressure, mean_pressure : float or numpy.ndarray
        In the centre, and load over area  [N/mm^2].
    area : float or numpy.ndarray
        [mm^2].
    approach : float or numpy.ndarray
        Of distant points of the bodies  [mm].
    peak_traction, full_sliding : float or numpy.ndarray or None
        Friction coefficient times peak pressure [N/mm^2], and times the load [N]; None without a coefficient.
    units : dict of str
    """

    units: Dict[str, str] = {"half_width": "mm", "lateral_half_width": "mm", "peak_pressure": "N/mm^2",
                             "mean_pressure": "N/mm^2", "area": "mm^2", "approach": "mm", "peak_traction": "N/mm^2",
                             "full_sliding": "N"}

    def __init__(self, axes: np.ndarray, load: np.ndarray, modulus: np.ndarray, friction: Optional[np.ndarray]):
        a, b = axes["half_width"], axes["lateral_half_width"]
        area = np.pi * a * b
        self.half_width, self.lateral_half_width, self.area = a[()], b[()], area[()]
        self.mean_pressure, self.peak_pressure = (load / area)[()], (1.5 * load / area)[()]
        longer, shorter = np.maximum(a, b), np.minimum(a, b)
        self.approach = (1.5 * load * _elliptic_k(shorter / longer) / (np.pi * modulus * longer))[()]
        self.peak_traction = None if friction is None else axes["peak_traction"][()]
        self.full_sliding = None if friction is None else (friction * load)[()]

    def __repr__(self) -> str:
        if np.ndim(self.half_width):
            return f"<microslip.Hertz: contacts of the shape {np.shape(self.half_width)}>"
        return (f"<microslip.Hertz: half_width = {self.half_width:.6g} mm, lateral_half_width = "
                f"{self.lateral_half_width:.6g} mm, peak_pressure = {self.peak_pressure:.6g} N/mm^2>")


def _elliptic_k(ratio: np.ndarray) -> np.ndarray:
    """The complete elliptic integral K of the modulus (1 - ratio^2)^(1/2), by the arithmetic-geometric mean."""
    first, second = np.ones_like(ratio), ratio
    for _ in range(10):  # which doubles the digits in each round
        first, second = (first + second) / 2, np.sqrt(first * second)
    return np.pi / (2 * first)


def hertz(normal_load: Values, *, radius_1: Values = None, radius_2: Values = None, lateral_radius_1: Values = None,
          lateral_radius_2: Values = None, poisson_ratio: Values, youngs_modulus: Values = None,
          shear_modulus: Values = None, friction: Values = None) -> Hertz:
    """Computes the contact ellipse and the pressure of two bodies, by Hertz's theory.

    Parameters
    ----------
    normal_load : float or array
        P, > 0  [N]. numpy broadcasts all arguments.
    radius_1, radius_2 : float or array, optional
        Radii of both bodies in the plane of rolling  [mm]; negative of a concave body, inf or None of a flat one.
    lateral_radius_1, lateral_radius_2 : float or array, optional
        The same across the rolling. The bodies must touch in a point: the sum of curvatures is above 0 in both
        directions, and that of one is at most 1e8 times that of the other.
    poisson_ratio : float or array
        nu of both bodies, 0 ... 0.5  [1].
    youngs_modulus, shear_modulus : float or array
        E or G of both bodies, > 0  [N/mm^2].
    friction : float or array, optional
        Coefficient, above 0, at most 10, for the bound of tractions  [1].

    Returns
    -------
    Hertz

    Raises
    ------
    InputError
        For values outside these ranges, and for a half-width that is not below the smaller radius of its direction;
        above a tenth of it, a LoadWarning is given.

    Notes
    -----
    Source: K. L. Johnson, Contact Mechanics, 1985, section 4.2. Accuracy: 1e-12 relative. A scene takes load and radii
    as they are: contact.normal_load, contact.radius_1, ...

    >>> import microslip as ms
    >>> wheel = ms.hertz(80000, radius_1=460, lateral_radius_2=300, youngs_modulus=210000, poisson_ratio=0.28,
    ...                  friction=0.3)
    >>> wheel
    <microslip.Hertz: half_width = 6.67644 mm, lateral_half_width = 5.02217 mm, peak_pressure = 1139.19 N/mm^2>
    >>> many = ms.hertz([[40000], [80000]], radius_1=[400, 460, 520], lateral_radius_2=300, youngs_modulus=210000,
    ...                 poisson_ratio=0.28)
    >>> many.half_width.round(2)
    array([[4.95, 5.3 , 5.62],
           [6.23, 6.68, 7.09]])
    """
    if (youngs_modulus is None) == (shear_modulus is None):
        raise InputError("youngs_modulus: expected either youngs_modulus or shear_modulus", "youngs_modulus",
                         shown(youngs_modulus), "either youngs_modulus or shear_modulus")
    given = {"normal_load": normal_load, "radius_1": radius_1, "radius_2": radius_2,
             "lateral_radius_1": lateral_radius_1, "lateral_radius_2": lateral_radius_2, "poisson_ratio": poisson_ratio,
             "youngs_modulus": youngs_modulus, "shear_modulus": shear_modulus, "friction": friction}
    for name in ("normal_load", "poisson_ratio"):
        if given[name] is None:
            raise InputError.of(name, "None", "a number or an array")
    columns = broadcast(given, any_shape=True)
    shape = columns["normal_load"].shape
    for name, column in columns.items():
        accepted, holds = (("a number that is not 0, or inf of a flat body", column != 0) if name in _RADII else
                           ("a number > 0", (column > 0) & np.isfinite(column)) if name == "youngs_modulus" else
                           ("a number", np.ones(shape, bool)))
        require_all(name, column, holds & ~np.isnan(column), accepted)
    _require_touching(columns, shape)
    bodies, material, axes = np.zeros(shape, BODIES), np.zeros(shape, MATERIAL), np.zeros(shape, ELLIPSE_CONTACT)
    bodies["friction"] = 1
    for name in fields_of(BODIES):
        if name in columns:
            value = columns[name]
            bodies[name] = np.where(np.isinf(value), 0, value) if name in _RADII else value
    nu = material["poisson_ratio"] = columns["poisson_ratio"]
    material["shear_modulus"] = (columns["shear_modulus"] if youngs_modulus is None
                                 else columns["youngs_modulus"] / (2 * (1 + nu)))
    message = c.create_string_buffer(_ROOM)
    for k in range(bodies.size):
        status = call("hertz_ellipse", *(array.ctypes.data + k * array.itemsize for array in (material, bodies, axes)),
                      message, _ROOM)
        if status != 0:
            text = message.value.decode()
            raise error_of(status, f"contact {k}: {text}" if shape else text)
    _require_small(columns, axes)
    return Hertz(axes, columns["normal_load"], material["shear_modulus"] / (1 - nu), columns.get("friction"))


def _require_touching(columns: Dict[str, Any], shape: Tuple[int, ...]) -> None:
    """Refuses two bodies that are both flat in one direction."""
    for pair in (_RADII[:2], _RADII[2:]):
        accepted = f"a radius of one body at least, {pair[0]} or {pair[1]}, as flat ones do not touch in a point"
        given = [name for name in pair if name in columns]
        if not given:
            raise InputError.of(pair[0], "None", accepted)
        require_all(given[0], columns[given[0]], ~np.all([np.isinf(columns[name]) for name in given], axis=0), accepted)


def _require_small(columns: Dict[str, Any], axes: np.ndarray) -> None:
    """Refuses half-widths above a radius, and warns the user, two frames above, of those above a tenth of it."""
    load = columns["normal_load"]
    doubts = []
    for width, radii in (("half_width", _RADII[:2]), ("lateral_half_width", _RADII[2:])):
        smaller = np.min([np.abs(columns[name]) for name in radii if name in columns], axis=0)
        require_all("normal_load", load, axes[width] < smaller, "a load under which the half-widths are below the radii")
        large = axes[width] > _SMALL * smaller
        if np.any(large):
            doubts.append(f"{index_of('normal_load', large)} = {load[large].flat[0]:.6g}: the "
                          f"{width.replace('_', ' ')}, {axes[width][large].flat[0]:.3g} mm, is more than a tenth of "
                          "the smaller radius; Hertz's theory is for less")
    warn_of(doubts, depth=4)
