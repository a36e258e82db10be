# SPDX-License-Identifier: GPL-3.0-or-later
"""Creep forces of contact ellipses from a table, in about a microsecond."""

from __future__ import annotations

import ctypes as c
import os
import pathlib
from typing import Any, Dict, List, NamedTuple, Optional, Tuple

import numpy as np

from ._arrays import Values, broadcast, fields_of, index_of, number, require_all, shown
from ._errors import InputError
from ._files import Path, as_path
from ._library import CREEP_TABLE_INFO, ELLIPSE_CONTACT, MATERIAL, MOTIONS, call, error_of, free_with, text_of
from ._result import warn_of

_ROOM = 512  # of a message, in bytes
_AT_ONCE = 100000  # contacts in a call, so that an interrupt is noticed
_SIZES = fields_of(ELLIPSE_CONTACT)
_LEAST, _LARGEST = 1e-50, 1e50  # of sizes, as in the library
_SIZE = "a number > 0, from 1e-50 to 1e50"
_LARGE, _NORMALISED = 0.2, 0.1  # slip that is doubtful, and strains of normalised contacts, as in the library
_PLAIN = (int, float, type(None))
_INSTALLED = pathlib.Path(__file__).with_name("creep_forces.nc")


class CreepForces(NamedTuple):
    """Resultants of steady rolling: numbers, or arrays of the shape of what was given."""

    force: Any  #: along the rolling  [N]
    lateral_force: Any  #: across it  [N]
    spin_moment: Any  #: about the normal  [N mm]


class CreepTableErrors(NamedTuple):
    """Measured errors of a table in random states; arrays of three, of force, lateral force and spin moment.

    Those of forces are over full sliding, friction coefficient times load, and that of the moment over full sliding
    times (a b)^(1/2).
    """

    rms: np.ndarray  #: root of the mean square  [1]
    of_99_percent: np.ndarray  #: not exceeded by 99 of 100 states  [1]
    largest: np.ndarray  #: [1]


class CreepTable:
    """Creep forces of contact ellipses by interpolation between solutions, for multibody codes.

    Parameters
    ----------
    path : str or path, optional
        A file of ``microslip table``; without it, the table that is installed with this package, for nu = 0.28 and
        a/b from 0.1 to 10.

    Raises
    ------
    InputError
        For a file that cannot be read, or is no table.

    Notes
    -----
    A table never changes. Any number of threads may use one, and ``copy`` and ``pickle`` read its file again. Units,
    motions and signs are those of ms.Patch: a positive creepage gives a negative force.

    Source and accuracy: docs/creep_tables.md; ``errors`` has the errors of this table. Forces and their slopes are
    exact without motion.

    >>> import microslip as ms
    >>> table = ms.CreepTable()
    >>> table
    <microslip.CreepTable: poisson_ratio = 0.28, a/b from 0.1 to 10>
    >>> wheel = ms.hertz(80000, radius_1=460, lateral_radius_2=300, youngs_modulus=210000, poisson_ratio=0.28,
    ...                  friction=0.3)
    >>> found = table.forces(creepage=1e-3, spin=[0, 1e-4], half_width=wheel.half_width,
    ...                      lateral_half_width=wheel.lateral_half_width, peak_traction=wheel.peak_traction,
    ...                      youngs_modulus=210000, poisson_ratio=0.28)
    >>> found.force.round(-3)
    array([-11000., -10000.])
    >>> abs(found.lateral_force / wheel.full_sliding).round(2)
    array([0.  , 0.12])
    """

    #: Units of what forces() gives.
    units: Dict[str, str] = {"force": "N", "lateral_force": "N", "spin_moment": "N mm"}

    def __init__(self, path: Optional[Path] = None):
        self._path = None if path is None else os.path.abspath(as_path(path))
        handle, message = c.c_void_p(), c.create_string_buffer(_ROOM)
        _check(call("creep_table_open", os.fsencode(_INSTALLED if self._path is None else self._path), c.byref(handle),
                    message, _ROOM), message, "path")
        self._handle: int = handle.value  # type: ignore[assignment]
        free_with(self, "creep_table_close", self._handle)
        info = np.zeros((), CREEP_TABLE_INFO)
        _check(call("creep_table_get_info", self._handle, info.ctypes.data, message, _ROOM), message)
        self._info = info
        self._last: Tuple[Any, Any] = (((), (), ()), None)

    @property
    def poisson_ratio(self) -> float:
        """nu of the combined bodies  [1]."""
        return float(self._info["poisson_ratio"])

    @property
    def ratios(self) -> Tuple[float, float]:
        """The least and the largest a/b  [1]."""
        return float(self._info["least_ratio"]), float(self._info["largest_ratio"])

    @property
    def states(self) -> int:
        """Number of random states in which the errors were measured; 0 if they were not."""
        return int(self._info["states"])

    @property
    def errors(self) -> CreepTableErrors:
        """Errors against solutions on more cells; all are 0 if they were not measured."""
        return CreepTableErrors(*(self._info[f"error_{name}"].copy() for name in CreepTableErrors._fields))

    def forces(self, creepage: Values = None, lateral_creepage: Values = None, spin: Values = None, *,
               half_width: Values, lateral_half_width: Values, peak_traction: Values, poisson_ratio: float,
               shear_modulus: Optional[float] = None, youngs_modulus: Optional[float] = None,
               jacobian: bool = False) -> Any:
        """Returns forces and moment of steady rolling.

        Parameters
        ----------
        creepage, lateral_creepage, spin : float or array, optional
            Motions [1, 1, 1/mm], 0 if they are not given. numpy broadcasts them and the next three, of any shape.
        half_width, lateral_half_width : float or array
            Semi-axes a along the rolling and b across it, > 0, with a/b in ``ratios``  [mm].
        peak_traction : float or array
            Friction coefficient times peak pressure, > 0  [N/mm^2]; ms.hertz() has all three.
        poisson_ratio : float
            nu, that of the table to 1e-3  [1].
        shear_modulus, youngs_modulus : float
            G or E of the combined bodies, > 0  [N/mm^2].
        jacobian : bool
            Whether derivatives are wanted.

        Returns
        -------
        forces : CreepForces
            Also as a tuple: ``force, lateral_force, spin_moment = table.forces(...)``.
        jacobian : numpy.ndarray
            With ``jacobian=True``, of the shape (..., 3, 3): derivatives of force, lateral_force and spin_moment, in
            rows, by creepage, lateral_creepage and spin. It is continuous.

        Raises
        ------
        InputError
            For the first value outside these ranges.

        Warns
        -----
        LoadWarning
            For the first motion of each kind by which slip is above 0.2, as ms.Patch does; not in normalised contacts.

        Notes
        -----
        Cost: about a microsecond for each contact of an array, and some 80 us for each call.
        """
        columns = broadcast({"creepage": creepage, "lateral_creepage": lateral_creepage, "spin": spin,
                             **{name: _given(name, value) for name, value in zip(_SIZES, (
                                 half_width, lateral_half_width, peak_traction))}}, any_shape=True)
        shape = columns["half_width"].shape
        contacts, motions = np.empty(shape + (3,)), np.zeros(shape + (3,))
        for name, column in columns.items():
            if name in MOTIONS:
                motions[..., MOTIONS.index(name)] = column
            else:
                contacts[..., _SIZES.index(name)] = column
        if not self._accepts(contacts, motions):
            self._require_ranges(columns)
        # The last material, as calls with few contacts are many.
        constants = (poisson_ratio, shear_modulus, youngs_modulus)
        of, material = self._last
        if not all(type(one) is type(other) and type(one) in _PLAIN and one == other
                   for one, other in zip(constants, of)):
            material = self._material(*constants)
            self._last = (constants, material)
        modulus = float(material["shear_modulus"])
        of_units = text_of("py_units_doubt", modulus, float(contacts[..., 2].max(initial=0)))
        warn_of(_doubts(contacts, motions, modulus) + ([of_units] if of_units else []))
        found, slopes = np.empty(shape + (3,)), np.empty(shape + (3, 3)) if jacobian else None
        message, count = c.create_string_buffer(_ROOM), motions.size // 3
        for at in range(0, count, _AT_ONCE):
            status = call("creep_table_forces_many", self._handle, material.ctypes.data,
                          contacts.ctypes.data + 24 * at, motions.ctypes.data + 24 * at,
                          min(_AT_ONCE, count - at), found.ctypes.data + 24 * at,
                          None if slopes is None else slopes.ctypes.data + 72 * at, message, _ROOM)
            _check(status, message, at=at if shape else None)
        forces = CreepForces(*(found[..., i][()] for i in range(3)))
        return (forces, slopes) if jacobian else forces

    def _accepts(self, contacts: np.ndarray, motions: np.ndarray) -> bool:
        """Whether all values are in their ranges; quick, as all mostly are."""
        with np.errstate(all="ignore"):
            return bool(((contacts >= _LEAST) & (contacts <= _LARGEST)).all() and
                        self._has(contacts[..., 0] / contacts[..., 1]).all() and np.isfinite(motions).all())

    def _has(self, ratio: np.ndarray) -> np.ndarray:
        """Whether a/b is in the table, but for rounding, as the library has it."""
        least, largest = self.ratios
        return (ratio >= least * (1 - 1e-12)) & (ratio <= largest * (1 + 1e-12))

    def _require_ranges(self, columns: Dict[str, np.ndarray]) -> None:
        for name, values in columns.items():
            if name in MOTIONS:
                require_all(name, values, np.isfinite(values), "a number")
            else:
                require_all(name, values, (values >= _LEAST) & (values <= _LARGEST), _SIZE)
        least, largest = self.ratios
        holds = self._has(columns["half_width"] / columns["lateral_half_width"])
        if not np.all(holds):
            b = columns["lateral_half_width"][~holds].flat[0]
            require_all("half_width", columns["half_width"], holds,
                        f"from {least * b:.6g} to {largest * b:.6g} with lateral_half_width = {b:.6g}, as the table has "
                        f"a/b from {least:.6g} to {largest:.6g}")

    def _material(self, poisson_ratio: float, shear_modulus: Optional[float],
                  youngs_modulus: Optional[float]) -> np.ndarray:
        if (youngs_modulus is None) == (shear_modulus is None):
            raise InputError("youngs_modulus: expected either youngs_modulus or shear_modulus", "youngs_modulus",
                             shown(youngs_modulus), "either youngs_modulus or shear_modulus")
        name, modulus = (("shear_modulus", shear_modulus) if youngs_modulus is None
                         else ("youngs_modulus", youngs_modulus))
        value, nu = number(name, _given(name, modulus)), number("poisson_ratio", _given("poisson_ratio", poisson_ratio))
        if not _LEAST <= value <= _LARGEST:
            raise InputError.of(name, f"{value:.6g}", _SIZE)
        message, material = c.create_string_buffer(_ROOM), np.zeros((), MATERIAL)
        material["poisson_ratio"] = nu
        material["shear_modulus"] = value / (2 * (1 + nu)) if shear_modulus is None and nu > -1 else value
        _check(call("creep_table_forces_many", self._handle, material.ctypes.data, None, None, 0, None, None, message,
                    _ROOM), message)
        return material

    def __repr__(self) -> str:
        least, largest = self.ratios
        return (f"<microslip.CreepTable: poisson_ratio = {self.poisson_ratio:.6g}, a/b from {least:.6g} to "
                f"{largest:.6g}>")

    def __reduce__(self) -> Any:
        return type(self), (self._path,)


def _doubts(contacts: np.ndarray, motions: np.ndarray, shear_modulus: float) -> List[str]:
    """Why motions are doubtful by which slip is large: a line for the first one of each kind."""
    if np.abs(motions).max(initial=0) * max(1, contacts[..., :2].max(initial=0)) <= _LARGE:
        return []  # quickly, as nearly all motions are small
    size = np.sqrt(contacts[..., 0] * contacts[..., 1])
    slip = np.abs(motions)
    slip[..., 2] *= size
    large = slip > _LARGE
    if not large.any():
        return []
    strain = contacts[..., 2] / (1.5 * shear_modulus)
    large &= (strain <= _NORMALISED)[..., np.newaxis]
    lines = []
    for i, name in enumerate(MOTIONS):
        if large[..., i].any():
            at = np.unravel_index(np.argmax(large[..., i]), size.shape)
            doubt = text_of("py_motion_doubt", i, motions[at][i], size[at], strain[at])
            lines.append(f"{index_of(name, large[..., i])} = {motions[at][i]:.6g}: {doubt}")
    return lines


def _given(name: str, value: Any) -> Any:
    """The value, unless it is None."""
    if value is None:
        raise InputError.of(name, "None", "a number or an array")
    return value


def _check(status: int, message: Any, key: str = "", at: Optional[int] = None) -> None:
    """Raises what the library says.

    at  number of contacts before this call; None of a single contact, which has no number
    """
    if status == 0:
        return
    text = message.value.decode(errors="replace")
    if text.startswith("contacts["):
        place, _, text = text[len("contacts["):].partition("]: ")
        text = text if at is None else f"contact {int(place) + at}: {text}"
    for i, name in enumerate(MOTIONS):
        text = text.replace(f"motion[{i}]", name)
    raise error_of(status, text, key)
