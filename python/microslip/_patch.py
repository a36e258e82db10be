# SPDX-License-Identifier: GPL-3.0-or-later
"""A contact ellipse, or a patch of another shape, that rolls steadily and by steps."""

from __future__ import annotations

import ctypes as c
import functools
from typing import Any, Dict, Mapping, NamedTuple, Optional, Tuple

import numpy as np

from . import _plot
from ._arrays import Values, broadcast, number, numbers, record
from ._contact import Contact, alone, in_turn
from ._errors import InputError
from ._library import (MOTIONS, PATCH_LOAD, PATCH_SHIFT, PATCH_STATE, RESULTANTS, SHIFTS, PatchCells, call, error_of,
                       free_with, require, require_ok, text_of)
from ._result import Progress, shown_progress, warn_of
from ._scene import Scene, SceneArguments
from ._table import Table, html_table

# So that an interrupt is noticed, and progress is told not too often.
_STEPS_AT_ONCE = 10

UNITS = {"distance": "mm", "force": "N", "lateral_force": "N", "spin_moment": "N mm", "creepage": "1",
         "lateral_creepage": "1", "spin": "1/mm", "dissipation": "N", "full_sliding": "N", "slip_share": "1",
         "residual": "1", "iterations": "1"}


class PatchOfScene:
    """The contact patch of a scene as the library has read it, which never changes."""

    def __init__(self, arguments: SceneArguments):
        self._arguments = arguments
        self.handle = require(call("py_patch_read", arguments.in_c()))
        free_with(self, "py_patch_destroy", self.handle)
        self.shape: Tuple[int, int] = (call("py_patch_rows", self.handle), call("py_patch_elements", self.handle))

    def __deepcopy__(self, _memo: Dict[int, Any]) -> "PatchOfScene":
        return self

    def __reduce__(self) -> Any:
        return type(self), (self._arguments,)

    @property
    def warnings(self) -> list[str]:
        return text_of("py_patch_warnings", self.handle).splitlines()

    @functools.cached_property
    def edges(self) -> np.ndarray:
        return Table("edges", require(call("py_patch_edges", self.handle)).decode()).data

    def doubt_of(self, loads: np.ndarray) -> str:
        """Why the largest of prescribed motions is doubtful, empty if it is not."""
        motions = np.where(loads["prescribed"] == 0, loads["value"], 0).reshape(-1, 3)
        if len(motions) == 0:
            return ""
        for j, most in enumerate(motions[np.abs(motions).argmax(axis=0), (0, 1, 2)].tolist()):
            doubt = text_of("py_patch_doubt", self.handle, j, most) if most else ""
            if doubt:
                return f"{MOTIONS[j]} = {most:.6g}: {doubt}"
        return ""


def loads_of(given: Mapping[str, Values], motions: Tuple[str, ...] = MOTIONS,
             beside: Optional[Mapping[str, Values]] = None) -> Tuple[Optional[np.ndarray], Dict[str, np.ndarray]]:
    """Makes loads of numbers or arrays, of which those that are None are motions of 0.

    given    motions and resultants
    beside   other columns, which are broadcast with them: of one dimension at most
    Returns the loads, None if none is given, and the other columns.
    """
    for motion, resultant in zip(motions, RESULTANTS):
        if given.get(motion) is not None and given.get(resultant) is not None:
            raise InputError(f"{resultant}: expected {motion} or {resultant}, not both", resultant,
                             str(given[resultant]), f"{motion} or {resultant}")
    columns = broadcast({**(beside or {}), **given}, beside is None)
    others = {name: columns.pop(name) for name in (beside or {}) if name in columns}
    if not columns:
        return None, others
    loads = np.zeros(next(iter(columns.values())).shape, PATCH_LOAD)
    for name, column in columns.items():
        j = (motions if name in motions else RESULTANTS).index(name)
        loads["prescribed"][..., j] = name in RESULTANTS
        loads["value"][..., j] = column
    return loads, others


class PatchFactors(NamedTuple):
    """The contact over that of the scene."""

    size_factor: float  #: of the half-widths
    bound_factor: float


class Patch(Contact):
    """A contact ellipse, or a patch of another shape, under creepages and spin, or forces and a moment.

    It rolls by steps of any length, in which the material remembers its displacement, and gives steady solutions.
    A patch has M rows across the rolling, of N elements each. Fields are arrays of the shape (M, N), and those of
    vectors (M, N, 2), along and across the rolling. Rows begin at the least y; elements of a row at its leading
    edge, so that x falls.

    Parameters
    ----------
    scene : str, path or dict
        A scene as for ms.solve(), of an ellipse or another patch. The contact is taken from it: material, contact
        and grid. Its problem, load, steps, start, motion and curve are left out; step.scheme must be remembered,
        which is the default.
    **overrides
        Keys as for ms.solve().

    Notes
    -----
    A patch begins without tractions, at the distance 0. A call that fails leaves it as it was. Threads take turns,
    and ``copy.copy``, ``copy.deepcopy``, ``pickle`` and ``with`` blocks work as those of ms.Rolling.

    Loads are given by component: ``creepage`` [1] or ``force`` [N] along the rolling, ``lateral_creepage`` [1] or
    ``lateral_force`` [N] across it, ``spin`` [1/mm] or ``spin_moment`` [N mm] about the normal. A component that is
    not given has the motion 0. Forces must be below full sliding, and the moment below that of turning. With the
    motion (xi, eta, phi) the rigid slip is (xi - phi y, eta + phi x); a positive creepage gives a negative force.

    States are records with the fields distance [mm], force, lateral_force [N] and spin_moment [N mm] at the end of
    the step, creepage, lateral_creepage [1] and spin [1/mm] as means over the step, dissipation [N] (energy lost
    per mm rolled), full_sliding [N], slip_share [1] (of the area), residual [1] (largest error of the slip
    conditions, over the bound) and iterations. Units are in ``Patch.units``.

    Source: docs/ellipse.md. Order: 2 in the step and in the size of elements. Forces of 8 x 12 elements have errors
    of some 1e-3 of full sliding; a step of another length than the last one takes new matrices, which takes longer
    than the step.

    >>> import microslip as ms
    >>> patch = ms.Patch(material={"youngs_modulus": "210 GPa", "poisson_ratio": 0.28},
    ...                  contact={"normal_load": "80 kN", "radius_1": 460, "lateral_radius_2": 300, "friction": 0.3},
    ...                  grid={"rows": 8, "elements": 10})
    >>> state, slopes = patch.steady(creepage=1e-3, spin=1e-4, jacobian=True)
    >>> f"{state.force:.0f} N, {state.lateral_force:.0f} N"
    '-10453 N, -2828 N'
    >>> slopes.shape  # derivatives of the resultants, in rows, by the motions
    (3, 3)
    >>> states = patch.roll([1, 1, 1], creepage=[1e-4, 2e-4, 3e-4])
    >>> states["force"].round(-1)
    array([-110., -320., -620.])
    >>> patch.traction.shape
    (8, 10, 2)
    """

    #: Units of the fields of a state.
    units: Dict[str, str] = dict(UNITS)

    _functions = "ellipse_"

    def __init__(self, scene: Scene = None, **overrides: Any):
        self._read = PatchOfScene(SceneArguments(scene, overrides))
        self._load: Optional[np.ndarray] = None
        self._own(self._new_handle())
        self._area = float(self.area.sum())  # of the scene
        warn_of(self._read.warnings)

    def _new_handle(self) -> int:
        return require(call("py_patch_ellipse", self._read.handle))

    def _saved(self) -> bytes:
        size = c.c_size_t()
        self._call("save_to_memory", None, 0, c.byref(size))
        text = c.create_string_buffer(size.value)
        self._call("save_to_memory", text, size, None)
        return text.value

    def _take_saved(self, saved: bytes) -> None:
        self._call("restore_from_memory", saved)

    # Steady rolling

    @alone
    def steady(self, *, creepage: Values = None, lateral_creepage: Values = None, spin: Values = None,
               force: Values = None, lateral_force: Values = None, spin_moment: Values = None,
               jacobian: bool = False) -> Any:
        """Solves steady rolling in the contact that is set; what has been rolled has no part in it, and stays.

        Each solution starts from the last one, which is quick where loads change little. ms.steady() solves many
        loads on all cores, with tractions.

        Parameters
        ----------
        creepage, lateral_creepage, spin, force, lateral_force, spin_moment : float or array, optional
            A load, see ms.Patch; numpy broadcasts arrays, of any shape.
        jacobian : bool
            Whether derivatives are wanted.

        Returns
        -------
        states : numpy.record, or structured array of the shape of the loads
        jacobian : numpy.ndarray
            With ``jacobian=True``, of the shape (..., 3, 3): derivatives of force, lateral_force and spin_moment, in
            rows, by creepage, lateral_creepage and spin. They are exact where no element changes between stick and
            slip, and one-sided elsewhere.

        Raises
        ------
        InputError, NoSolution
            The message names the first load that fails, counted from 0.
        """
        loads, _ = loads_of({"creepage": creepage, "lateral_creepage": lateral_creepage, "spin": spin, "force": force,
                             "lateral_force": lateral_force, "spin_moment": spin_moment})
        if loads is None:
            loads = np.zeros((), PATCH_LOAD)
        states, slopes = np.zeros(loads.shape, PATCH_STATE), np.zeros(loads.shape + (3, 3))
        for k in range(loads.size):
            status = call("ellipse_solve_steady", self._open(), _at(loads, k), _at(states, k),
                          slopes.ctypes.data + 72 * k if jacobian else None)
            self._check_one(status, "load", k, loads)
        self._tell_once(self._read.doubt_of(loads))
        found = _shown(states)
        return (found, slopes) if jacobian else found

    # Steps

    @alone
    def roll(self, dq: Values, *, creepage: Values = None, lateral_creepage: Values = None, spin: Values = None,
             force: Values = None, lateral_force: Values = None, spin_moment: Values = None,
             size_factor: Values = None, bound_factor: Values = None, progress: Progress = None) -> Any:
        """Rolls on, by one step or by many.

        Parameters
        ----------
        dq : float or array
            Lengths of the steps, from 1e-6 to 1e6 of the ellipse's size, or below 0 to roll back  [mm]. numpy
            broadcasts arrays of one dimension, and numbers.
        creepage, lateral_creepage, spin : float or array, optional
            Motions of each step  [1, 1, 1/mm].
        force, lateral_force, spin_moment : float or array, optional
            Resultants at the end of each step, instead of motions  [N, N, N mm]. A component that is not given has
            the motion 0; without any, the load of the last step goes on.
        size_factor, bound_factor : float or array, optional
            Factors of the contact at the end of each step, as for set_contact()  [1].
        progress : bool or function
            As of ms.solve().

        Returns
        -------
        numpy.record or structured array
            The state after the step; for arrays, the states after each step.

        Raises
        ------
        InputError, NoSolution
            No step has been made then; the message names the first step that fails, counted from 0.
        """
        given = {"creepage": creepage, "lateral_creepage": lateral_creepage, "spin": spin, "force": force,
                 "lateral_force": lateral_force, "spin_moment": spin_moment}
        factors = {"size_factor": size_factor, "bound_factor": bound_factor}
        changes = any(factor is not None for factor in factors.values())
        if changes:
            factors = {name: now if factors[name] is None else factors[name]
                       for name, now in self.contact._asdict().items()}
        found, columns = loads_of(given, beside={"dq": numbers("dq", dq), **factors})
        shape = columns["dq"].shape
        loads = np.broadcast_to(self._last_load(), shape).copy() if found is None else found
        states = np.zeros(shape, PATCH_STATE)

        def roll(work: "Patch", part: slice) -> None:
            for k in range(part.start, part.stop):
                if changes:
                    status = call("ellipse_set_contact", work._open(), *(columns[name].flat[k] for name in factors))
                    work._check_one(status, "step", k, states)
                status = call("ellipse_advance", work._open(), columns["dq"].flat[k], _at(loads, k), _at(states, k))
                work._check_one(status, "step", k, states)

        if shape == () and not changes:  # the library leaves a contact as it is whose step fails
            roll(self, slice(0, 1))
        else:
            self._on_a_copy(states.size, _STEPS_AT_ONCE, shown_progress(progress), roll)
        if loads.size:
            self._load = loads.reshape(-1)[-1:].copy()
        self._tell_once(self._read.doubt_of(loads))
        return _shown(states)

    @alone
    def attempt(self, dq: float, *, creepage: Optional[float] = None, lateral_creepage: Optional[float] = None,
                spin: Optional[float] = None, force: Optional[float] = None, lateral_force: Optional[float] = None,
                spin_moment: Optional[float] = None, jacobian: bool = False) -> Any:
        """Returns the state to which a step would lead; the patch stays as it is, and so does its load.

        If roll() makes the same step next, that step costs nothing.

        Parameters
        ----------
        dq, creepage, lateral_creepage, spin, force, lateral_force, spin_moment : float
            As of roll().
        jacobian : bool
            Whether derivatives of the step are wanted.

        Returns
        -------
        state : numpy.record
        jacobian : numpy.ndarray
            With ``jacobian=True``, of the shape (3, 3): derivatives of force, lateral_force and spin_moment at the end
            of the step, in rows, by its creepage, lateral_creepage and spin. Of a step that was divided as it was not
            solved, they are those of its last part.
        """
        given = {"creepage": creepage, "lateral_creepage": lateral_creepage, "spin": spin, "force": force,
                 "lateral_force": lateral_force, "spin_moment": spin_moment}
        load = _one_load(given)
        load = self._last_load() if load is None else load
        state, slopes = np.zeros((), PATCH_STATE), np.zeros((3, 3))
        self._call("attempt", number("dq", dq), load.ctypes.data, state.ctypes.data,
                   slopes.ctypes.data if jacobian else None)
        self._tell_once(self._read.doubt_of(load))
        return (_shown(state), slopes) if jacobian else _shown(state)

    @alone
    def shift(self, *, shift: Optional[float] = None, lateral_shift: Optional[float] = None,
              rotation: Optional[float] = None, force: Optional[float] = None, lateral_force: Optional[float] = None,
              spin_moment: Optional[float] = None) -> Any:
        """Shifts the bodies without rolling, from the present tractions.

        Parameters
        ----------
        shift, lateral_shift, rotation : float, optional
            The rigid shifts and the rotation; a positive shift gives negative tractions  [mm, mm, rad].
        force, lateral_force, spin_moment : float, optional
            Resultants at the end, instead  [N, N, N mm]. A component that is not given is not shifted.

        Returns
        -------
        numpy.record
            A state with the fields shift, lateral_shift and rotation in the place of motions; its dissipation is the
            energy lost  [N mm]. The load of the next steps stays as it was.
        """
        load = _one_load({"shift": shift, "lateral_shift": lateral_shift, "rotation": rotation, "force": force,
                          "lateral_force": lateral_force, "spin_moment": spin_moment}, SHIFTS)
        if load is None:
            raise InputError("shift: expected a shift, a rotation or a resultant", "shift", "",
                             "a shift, a rotation or a resultant")
        state = np.zeros((), PATCH_SHIFT)
        self._call("shift", load.ctypes.data, state.ctypes.data)
        return _shown(state)

    @alone
    def set_speed(self, speed: float) -> None:
        """Sets the speed of rolling V for the next steps, > 0 [mm/s]; friction that falls with slip depends on it."""
        self._call("set_speed", number("speed", speed))

    @alone
    def set_contact(self, size_factor: float, bound_factor: float) -> None:
        """Sets the contact of steady solutions, and at the end of the next step; on the way there it changes linearly.

        Parameters
        ----------
        size_factor : float
            Of both half-widths over those of the scene, 1e-4 ... 100; only an ellipse changes its size  [1].
        bound_factor : float
            Of the bound, 1e-6 ... 1e6  [1]. Both factors are (P/P0)^(1/3) under another normal load by Hertz's
            theory; another friction coefficient changes the bound alone. With 0 of one or both the contact is
            lost at the end of the step: it has no tractions, resultants must be 0, and the bodies forget.
        """
        self._call("set_contact", number("size_factor", size_factor), number("bound_factor", bound_factor))

    @property
    @in_turn
    def contact(self) -> PatchFactors:
        """The factors that set_contact() set, or a step or a file."""
        return PatchFactors(*self._factors())

    @property
    @in_turn
    def load(self) -> Optional[Dict[str, float]]:
        """The load of the next step, if no other load is given, as arguments of roll(); None before the first step."""
        if self._load is None:
            return None
        kinds, values = self._load[0]
        return {pair[kind]: float(value) for pair, kind, value in zip(zip(MOTIONS, RESULTANTS), kinds, values)}

    def _last_load(self) -> np.ndarray:
        if self._load is None:
            raise InputError("load: expected a motion or a resultant to be set", "load", "",
                             "a motion or a resultant")
        return self._load[0:1].reshape(())

    # The present state

    @property
    def state(self) -> Any:
        """The present state, and the step that led to it; after a shift, motions are in mm and rad."""
        return self._filled("get_state", into=(PATCH_STATE,))[0]

    @property
    @in_turn
    def second_solution(self) -> bool:
        """Whether the last step, or the last steady solution of this object, has a second solution, as friction falls with slip."""
        return bool(call("ellipse_has_second_solution", self._open()))

    @property
    def elastic_energy(self) -> float:
        """The energy stored in the bodies  [N mm]."""
        return self._filled("get_elastic_energy", into=(float,))[0]

    @property
    def shape(self) -> Tuple[int, int]:
        """(M, N): rows across the rolling, and elements of each."""
        return self._read.shape

    @property
    def x(self) -> np.ndarray:
        """Centres of elements along the rolling, (M, N)  [mm]."""
        return self._values("x")

    @property
    def y(self) -> np.ndarray:
        """Centres of elements across the rolling, (M, N)  [mm]."""
        return self._values("y")

    @property
    def area(self) -> np.ndarray:
        """Areas of elements, (M, N)  [mm^2]."""
        return self._values("area")

    @property
    def bound(self) -> np.ndarray:
        """The bound at the centres, (M, N)  [N/mm^2]."""
        return self._values("bound")

    @property
    def traction(self) -> np.ndarray:
        """Tractions along and across, (M, N, 2)  [N/mm^2]."""
        return self._values("traction_x", "traction_y")

    @property
    def slip(self) -> np.ndarray:
        """Relative slip of the last step along and across, (M, N, 2), 0 where an element sticks  [1]; of a shift [mm]."""
        return self._values("slip_x", "slip_y")

    @property
    def slips(self) -> np.ndarray:
        """Whether elements slip, (M, N), of bool."""
        return self._values("slips", kind=np.intc).astype(bool)

    @in_turn
    def plot(self, axes: Any = None) -> Any:
        """Draws the tractions: their size in colour, their direction as arrows, and what slips by dots.

        Parameters
        ----------
        axes : matplotlib axes, optional

        Returns
        -------
        The axes that were drawn into.
        """
        fields, edges = self._drawn()
        return _plot.plot_patch(fields, edges, axes)

    @in_turn
    def _drawn(self) -> Tuple[_plot.PatchFields, np.ndarray]:
        return (_plot.PatchFields(self.x, self.y, self.traction, self.slips),
                _plot.scaled(self._read.edges, np.sqrt(self.area.sum() / self._area)))

    def _title(self) -> str:
        state = self.state
        return f"q = {state.distance:.4g} mm, {100 * state.slip_share:.0f} % slips"

    def _words(self) -> str:
        state = self.state
        return (f"of {self.shape[0]} x {self.shape[1]} elements: distance = {state.distance:.6g} mm, "
                f"force = {state.force:.6g} N, lateral_force = {state.lateral_force:.6g} N, "
                f"spin_moment = {state.spin_moment:.6g} N mm")

    def _repr_html_(self) -> str:
        return html_table(np.array([self.state], PATCH_STATE), self.units, caption="rolling of a patch")

    # Calls

    def _check_one(self, status: int, name: str, k: int, many: np.ndarray) -> None:
        """Raises what the library says about one of many, which a number alone is not."""
        if status != 0:
            message = text_of("ellipse_message", self._handle)
            raise error_of(status, f"{name} {k}: {message}" if many.ndim else message)

    @in_turn
    def _values(self, *names: str, kind: Any = float) -> np.ndarray:
        arrays = [np.empty(self.shape, kind) for _ in names]
        cells = PatchCells(**{name: array.ctypes.data for name, array in zip(names, arrays)})
        self._call("get_cells", c.byref(cells))
        return arrays[0] if len(arrays) == 1 else np.stack(arrays, -1)


def _at(array: np.ndarray, k: int) -> int:
    """The address of one of the values, which are contiguous."""
    return array.ctypes.data + k * array.itemsize


def _shown(states: np.ndarray) -> Any:
    return states if states.ndim else record(states)


def _one_load(given: Mapping[str, Any], motions: Tuple[str, ...] = MOTIONS) -> Optional[np.ndarray]:
    return loads_of({name: None if value is None else number(name, value) for name, value in given.items()}, motions)[0]
