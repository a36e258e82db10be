# SPDX-License-Identifier: GPL-3.0-or-later
"""A contact that rolls, step by step or over arrays of steps."""

from __future__ import annotations

import contextlib
import ctypes as c
from typing import Any, Dict, Iterator, Mapping, NamedTuple, Optional, Tuple

import numpy as np

from . import _plot
from ._arrays import Values, broadcast, number, numbers
from ._contact import Contact, alone, in_turn
from ._errors import Error, InputError
from ._library import JACOBIAN, SHIFT, STATE, Steps, call, require, require_ok, text_of
from ._result import Progress, shown_progress
from ._scene import Scene, SceneArguments
from ._table import html_table

_UNITS = {"distance": "mm", "force": "N/mm", "mean_force": "N/mm", "creepage": "1", "dissipation": "N/mm",
          "residual": "1", "violation": "1", "adhesion_elements": "1", "slip_elements": "1", "iterations": "1"}

# So that an interrupt is noticed: some ten milliseconds.
_STEPS_AT_ONCE = 1000


class Load(NamedTuple):
    """The load of the next steps."""

    kind: str  #: creepage or force
    value: float


class Rolling(Contact):
    """A line contact that rolls by any distances, under creepages or forces that are free to change.

    Parameters
    ----------
    scene : str, path or dict
        A scene as for ms.solve(). The contact is taken from it: material, contact, kernel, grid, basis,
        solver, direction, step.scheme and step.relaxation. Its problem, load, steps, start and motion are
        left out.
    **overrides
        Keys as for ms.solve(): ``contact={"half_width": 5, "bound_file": (x, values)}`` has a bound of arrays.

    Notes
    -----
    A contact begins without tractions, at the distance 0. A call that fails leaves it as it was.
    Contacts may be used in several threads at once. Calls with one contact take turns: each is made as a
    whole, so that ``attempt`` gives in any thread what it gives in one. ``copy.copy`` and
    ``copy.deepcopy`` make contacts of their own, and ``pickle`` keeps state and load (scheme remembered). In a
    ``with`` block it is closed at the end of the block, otherwise when it is no longer used.

    A positive creepage w = (v - omega R)/v gives negative tractions and a negative force.

    >>> import microslip as ms
    >>> rolling = ms.Rolling(material={"shear_modulus": 82000, "poisson_ratio": 0.28},
    ...                      contact={"half_width": 5, "peak_traction": 300},
    ...                      kernel={"type": "strip", "width": 10}, grid={"elements": 100})
    >>> state = rolling.roll(0.37, creepage=0.002)
    >>> round(float(state["force"]), 1)
    -71.0
    >>> import numpy as np
    >>> run = rolling.roll(np.full(1000, 0.01), creepage=np.linspace(0, 0.004, 1000))
    >>> run["force"].shape
    (1000,)
    """

    #: Units of the fields of a state.
    units: Dict[str, str] = dict(_UNITS)

    def __init__(self, scene: Scene = None, **overrides: Any):
        self._scene = SceneArguments(scene, overrides)
        self._load: Optional[Load] = None
        self._own(self._new_handle())

    def _new_handle(self) -> int:
        return require(call("py_rolling", self._scene.in_c()))

    def _saved(self) -> bytes:
        return require(call("py_save", self._open()))

    def _take_saved(self, saved: bytes) -> None:
        require_ok(call("py_restore", self._handle, saved))
        if self._load is not None:
            self._set_load(**{self._load.kind: self._load.value})

    # Steps

    @alone
    def roll(self, dq: Values, *, creepage: Values = None, force: Values = None, half_width_factor: Values = None,
             bound_factor: Values = None, progress: Progress = None) -> Any:
        """Rolls on, by one step or by many.

        Parameters
        ----------
        dq : float or array
            Lengths of the steps, 0 or from 1e-15 to 1e6 elements  [mm]; below 0 the bodies roll back, with the
            scheme remembered. numpy broadcasts arrays and numbers.
            Nothing happens in a step of 0: its state is that before, and the next step is what it would have
            been. Under a changed force or contact it is refused; shift() changes them without rolling.
        creepage : float or array, optional
            w of each step, the shift over dq  [1].
        force : float or array, optional
            F at the end of each step, less in absolute value than full sliding  [N/mm]; instead of
            creepage. Without either the load of the last step goes on.
        half_width_factor, bound_factor : float or array, optional
            Factors of the contact at the end of each step, as for set_contact()  [1].
        progress : bool or function
            As of ms.solve().

        Returns
        -------
        numpy.record or structured array
            The state after the step; for arrays, the states after each step. Units are in ``Rolling.units``.

        Raises
        ------
        InputError, NoSolution
            No step has been made then; the message names the first step that fails, counted from 0.
        """
        given = {"dq": dq, **self._load_of(creepage, force), "half_width_factor": half_width_factor,
                 "bound_factor": bound_factor}
        if (half_width_factor is None) != (bound_factor is None):
            size, bound = self._factors()
            given["half_width_factor"] = size if half_width_factor is None else half_width_factor
            given["bound_factor"] = bound if bound_factor is None else bound_factor
        columns = broadcast({**given, "dq": numbers("dq", dq)})
        if columns["dq"].ndim == 0:
            self._roll_once(**{name: float(value) for name, value in columns.items()})
            self._remember(columns)
            self._tell_once(text_of("warning", self._handle))
            return self.state
        states = np.zeros(columns["dq"].shape, STATE)
        doubt = self._roll_all(columns, states, shown_progress(progress))
        self._tell_once(doubt)
        return states

    def _roll_once(self, dq: float, creepage: Optional[float] = None, force: Optional[float] = None,
                   half_width_factor: Optional[float] = None, bound_factor: Optional[float] = None) -> None:
        """Rolls one step without the copy that an array of steps takes, which costs about as much as a step."""
        with self._settings_kept(None if half_width_factor is None else self._factors()):
            if half_width_factor is not None:
                self._call("set_contact", half_width_factor, bound_factor)
            self._set_load(creepage, force)
            self._call("advance", dq)

    @contextlib.contextmanager
    def _settings_kept(self, contact: Optional[Tuple[float, float]] = None) -> Iterator[None]:
        """Puts the load back if a call fails, and a contact that the call changes."""
        load = self._load
        try:
            yield
        except Error:
            if self._finalizer.alive:
                if contact is not None:
                    call("set_contact", self._handle, *contact)
                self._load = load  # the contact that is set may not carry it
            raise

    def _roll_all(self, columns: Dict[str, np.ndarray], states: np.ndarray, told: Any) -> str:
        """Rolls all or no steps. Returns the last warning."""
        doubt = ""

        def roll(work: "Rolling", part: slice) -> None:
            nonlocal doubt
            work._roll_at_once({name: value[part] for name, value in columns.items()}, states[part], part.start)
            doubt = text_of("warning", work._handle) or doubt

        self._on_a_copy(len(states), _STEPS_AT_ONCE, told, roll)
        if len(states) > 0:
            self._remember(columns)
        return doubt

    def _roll_at_once(self, columns: Dict[str, np.ndarray], states: np.ndarray, before: int = 0) -> None:
        pointers = {name: value.ctypes.data for name, value in columns.items()}
        steps = Steps(len(states), *(pointers.get(name) for name, _ in Steps._fields_[1:]))
        self._check(call("roll", self._open(), c.byref(steps), states.ctypes.data), before)

    def _remember(self, columns: Mapping[str, np.ndarray]) -> None:
        for kind in ("creepage", "force"):
            if kind in columns:
                self._load = Load(kind, float(columns[kind].flat[-1]))

    @alone
    def attempt(self, dq: float, *, creepage: Optional[float] = None, force: Optional[float] = None,
                jacobian: bool = False) -> Any:
        """Returns the state to which a step would lead; the contact stays as it is, and the load is set.

        If roll() makes the same step next, that step costs nothing.

        Parameters
        ----------
        dq, creepage, force : float
            As of roll().
        jacobian : bool
            Whether derivatives of the step are wanted, for the scheme remembered and dq other than 0.

        Returns
        -------
        state : numpy.record
        jacobian : numpy.record
            With ``jacobian=True``: fields ``by_load`` and ``by_length``, each with force, mean_force, creepage
            and dissipation; derivatives by the creepage or force, and by dq.
        """
        load = self._load_of(creepage, force)
        length = number("dq", dq)
        with self._settings_kept():
            self._set_load(**load)
            found = (self._filled("attempt_with_jacobian", length, into=(STATE, JACOBIAN)) if jacobian
                     else self._filled("attempt", length, into=(STATE,))[0])
        self._tell_once(text_of("warning", self._handle))
        return found

    def _load_of(self, creepage: Any, force: Any) -> Dict[str, Any]:
        """Returns the load of a step: the given one, or that of the last step."""
        if creepage is not None and force is not None:
            raise InputError("force: expected a creepage or a force, not both", "force", str(force),
                             "a creepage or a force")
        if creepage is not None or force is not None:
            return {"creepage": creepage, "force": force}
        if self._load is None:
            raise InputError("load: expected a creepage or a force to be set", "load", "", "a creepage or a force")
        return {self._load.kind: self._load.value}

    def _set_load(self, creepage: Optional[float] = None, force: Optional[float] = None) -> None:
        for kind, value in (("creepage", creepage), ("force", force)):
            if value is not None:
                load = number(kind, value)
                self._call(f"set_{kind}", load)
                self._load = Load(kind, load)

    @property
    @in_turn
    def load(self) -> Optional[Load]:
        """The load of the next step, if no other load is given; None before the first step."""
        return self._load

    @alone
    def set_speed(self, speed: float) -> None:
        """Sets the speed of rolling V for the next steps, > 0 [mm/s]; friction that falls with slip depends on it."""
        self._call("set_speed", number("speed", speed))

    @alone
    def set_contact(self, half_width_factor: float, bound_factor: float) -> None:
        """Sets the contact at the end of the next step or shift; it changes linearly on the way.

        Parameters
        ----------
        half_width_factor, bound_factor : float
            Half-width and bound over their values at the beginning, >= 0  [1]. Both are sqrt(P/P0) under
            another normal load by Hertz's theory, and another friction coefficient changes the bound alone.
            With 0, bodies do not touch. The scheme must be remembered.
        """
        self._call("set_contact", number("half_width_factor", half_width_factor),
                   number("bound_factor", bound_factor))

    @alone
    def start_from_shift(self, force: float) -> float:
        """Shifts bodies without tractions until they carry a force, and does not roll: Cattaneo's problem.

        Returns
        -------
        float
            The rigid shift  [mm].
        """
        return self._filled("start_from_shift", number("force", force), into=(float,))[0]

    @alone
    def shift(self, *, force: Optional[float] = None, distance: Optional[float] = None) -> Any:
        """Shifts the bodies without rolling, from the present tractions, to a force or by a rigid shift.

        Parameters
        ----------
        force : float
            The force at the end, less in absolute value than full sliding  [N/mm].
        distance : float
            The rigid shift, instead of a force; a positive one gives negative tractions  [mm].

        Returns
        -------
        numpy.record
            distance [mm], force [N/mm], dissipation [N] and work [N].
        """
        if (force is None) == (distance is None):
            raise InputError("force: expected either a force or a distance", "force", str(force),
                             "either a force or a distance")
        if force is not None:
            return self._filled("shift_to_force", number("force", force), into=(SHIFT,))[0]
        return self._filled("shift_by_distance", number("distance", distance), into=(SHIFT,))[0]

    # The present state

    @property
    def state(self) -> Any:
        """The present state, and the step that led to it: a numpy.record, see ``Rolling.units``."""
        return self._filled("get_state", into=(STATE,))[0]

    @property
    @in_turn
    def second_solution(self) -> bool:
        """Whether the last step has a second solution, as friction falls with slip."""
        return bool(call("has_second_solution", self._open()))

    @property
    def elastic_energy(self) -> float:
        """The energy stored in the bodies  [N]. It costs about as much as a step."""
        return self._filled("get_elastic_energy", into=(float,))[0]

    @property
    def full_sliding(self) -> float:
        """The largest force that the bound of the contact that is set allows  [N/mm]."""
        return self._filled("get_full_sliding", into=(float,))[0]

    @property
    @in_turn
    def method(self) -> str:
        """The scheme, as scenes name it."""
        return text_of("method", self._open())

    @property
    def x(self) -> np.ndarray:
        """The nodes in the contact's frame, ascending; the leading edge is x = +half_width  [mm]."""
        return self._values("nodes")

    @property
    def traction(self) -> np.ndarray:
        """Tractions p at the nodes  [N/mm^2]."""
        return self._values("traction")

    @property
    def bound(self) -> np.ndarray:
        """The bound at the nodes  [N/mm^2]."""
        return self._values("bound")

    @property
    def slip(self) -> np.ndarray:
        """Relative slip of the last step at the nodes  [1]."""
        return self._values("slip")

    @property
    def displacement(self) -> np.ndarray:
        """The displacement at the nodes  [mm]. It costs about as much as a step."""
        return self._values("displacement")

    @property
    def zones(self) -> np.ndarray:
        """0 at nodes in adhesion, else the sign of the traction that slips; no meaning where the bound is 0."""
        return self._values("zones", np.intc)

    @in_turn
    def __len__(self) -> int:
        """The number of nodes."""
        return call("size", self._open())

    @in_turn
    def plot(self, axes: Any = None) -> Any:
        """Draws tractions within their bound; returns the axes of matplotlib."""
        x, bound, traction = self._drawn()
        return _plot.plot_traction(x, bound, traction, axes)

    @in_turn
    def _drawn(self) -> Tuple[np.ndarray, np.ndarray, np.ndarray]:
        return self.x, self.bound, self.traction

    def _title(self) -> str:
        return f"q = {self.state.distance:.4g} mm"

    def _words(self) -> str:
        state = self.state
        return (f"by {self.method}, {len(self)} nodes: distance = {state.distance:.6g} mm, "
                f"force = {state.force:.6g} N/mm, creepage = {state.creepage:.6g}")

    def _repr_html_(self) -> str:
        return html_table(np.array([self.state], STATE), self.units, caption=f"rolling by {self.method}")

    @in_turn
    def _values(self, name: str, kind: Any = float) -> np.ndarray:
        values = np.empty(len(self), kind)
        self._call(f"get_{name}", values.ctypes.data, values.size)
        return values
