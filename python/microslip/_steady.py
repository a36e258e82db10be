# SPDX-License-Identifier: GPL-3.0-or-later
"""Solves steady rolling under many loads."""

from __future__ import annotations

import ctypes as c
import html
from typing import Any, Dict, Iterable, List, Optional, Union

import numpy as np

from . import _plot
from ._arrays import Values, numbers, shown
from ._errors import InputError
from ._library import (CREEPAGE, FORCE, MOTIONS, RESULTANTS, STATUS_OF_NO_SOLUTION, STEADY, SteadyNodes, call, error_of,
                       free_with, require, require_ok, text_of)
from ._patch import PatchOfScene
from ._patch_curve import PatchCurve, PatchCurves, curves_of
from ._patch_steady import PatchSteady, solve_loads
from ._result import Progress, require_word, shown_progress, threads_of, warn_of
from ._scene import Scene, SceneArguments, refuse_misspelt
from ._table import html_table, to_pandas

_ROOM = 512  # of a message, in bytes


class Steady:
    """Steady rolling under one or many loads; fields and tractions have the shape of the loads.

    Attributes
    ----------
    creepage, force, dissipation : numpy.ndarray
        w [1], F [N/mm], and -w F [N/mm].
    states : numpy.ndarray
        The same and the evidence of each load, as a structured array: stick_edge [mm], where the one stick zone begins
        (nan where elements replace the inversion), residual, violation, dissipation_error, condition,
        adhesion_elements, slip_elements, method (0 inversion, 1 elements) and status (0, or 2 where there is no
        solution).
    x, bound, traction, slip, displacement : numpy.ndarray
        Values at the nodes, in the last dimension.
    full_sliding : float
        The largest force that the bound allows  [N/mm].
    fastsim_force : numpy.ndarray or None
        Force by Kalker's simplified theory at the same creepages, with ms.creep_curve(beside="fastsim")  [N/mm].
    messages : list of str
        For each load the reason why it has no solution; empty if it has one.
    units : dict of str
    """

    units: Dict[str, str] = {
        "creepage": "1", "force": "N/mm", "dissipation": "N/mm", "stick_edge": "mm", "residual": "1", "violation": "1",
        "dissipation_error": "1", "condition": "1", "adhesion_elements": "1", "slip_elements": "1", "method": "1",
        "status": "1", "x": "mm", "bound": "N/mm^2", "traction": "N/mm^2", "slip": "1", "displacement": "mm"}

    def __init__(self, states: np.ndarray, nodes: Dict[str, np.ndarray], full_sliding: float, messages: List[str]):
        self.states, self.full_sliding, self.messages = states, full_sliding, messages
        self.creepage, self.force = states["creepage"], states["force"]
        self.dissipation = states["dissipation"]
        self.x, self.bound, self.traction = nodes["x"], nodes["bound"], nodes["traction"]
        self.slip, self.displacement = nodes["slip"], nodes["displacement"]
        self.fastsim_force: Optional[np.ndarray] = None

    def __len__(self) -> int:
        return self.states.size

    def __repr__(self) -> str:
        if self.states.size == 1:
            return (f"<microslip.Steady: creepage = {self.creepage.flat[0]:.6g}, force = {self.force.flat[0]:.6g} "
                    "N/mm>")
        return f"<microslip.Steady: {self.states.size} loads>"

    def _repr_html_(self) -> str:
        lines = "".join(f"<p>{html.escape(line)}</p>" for line in self.messages if line)
        return html_table(self.states.reshape(-1), self.units, caption="steady rolling") + lines

    def to_pandas(self) -> Any:
        """Returns a pandas.DataFrame with one row per load."""
        return to_pandas(self.states.reshape(-1), self.units)

    def plot(self, axes: Any = None) -> Any:
        """Draws the force over the creepage; for one load, tractions within their bound."""
        if self.states.size == 1:
            return _plot.plot_traction(self.x.reshape(-1), self.bound.reshape(-1), self.traction.reshape(-1), axes)
        return _plot.plot_curve(self, axes)


class _Contact:
    """A contact that has been read by the library."""

    def __init__(self, arguments: SceneArguments):
        self.handle = require(call("py_steady_read", arguments.in_c()))
        free_with(self, "py_steady_destroy", self.handle)
        self.nodes = call("py_steady_size", self.handle)
        self.full_sliding = call("py_full_sliding", self.handle)

    def solve(self, kind: int, loads: np.ndarray, threads: int, told: Any = None) -> Steady:
        """Solves loads of any shape."""
        count = loads.size
        flat = np.ascontiguousarray(loads, dtype=float).reshape(-1)
        states = np.zeros(count, STEADY)
        nodes = {name: np.empty((count, self.nodes)) for name, _ in SteadyNodes._fields_}
        messages = np.zeros(count, f"S{_ROOM}")
        at_once = 16 * threads  # so that an interrupt is noticed
        for at in range(0, count, at_once):
            part = slice(at, min(at + at_once, count))
            rows = SteadyNodes(*(values[part].ctypes.data for values in nodes.values()))
            require_ok(call("py_steady_solve", self.handle, kind, flat[part].ctypes.data, part.stop - at, threads,
                            states[part].ctypes.data, c.byref(rows), messages[part].ctypes.data, _ROOM))
            if told is not None:
                told(part.stop, count)
        return Steady(states.reshape(loads.shape),
                      {name: values.reshape(loads.shape + (self.nodes,)) for name, values in nodes.items()},
                      self.full_sliding, [line.decode() for line in messages])

    def warn_of_creepages(self, creepages: np.ndarray) -> None:
        """Tells the user who called, two frames above, of the largest if it is doubtful."""
        flat = np.ascontiguousarray(creepages, dtype=float).reshape(-1)
        doubt = text_of("py_steady_doubt", self.handle, CREEPAGE, flat.ctypes.data, flat.size)
        warn_of([doubt] if doubt else [], depth=4)

    def fastsim(self, creepages: np.ndarray) -> np.ndarray:
        """Returns forces by FASTSIM, with the flexibility that gives it the slope of this contact without slip."""
        small = 1e-9 * float(np.abs(creepages).max())
        without_slip = self.solve(CREEPAGE, np.array(small), 1)
        _raise_first(without_slip.states["status"], without_slip.messages, "raise")
        forces, at = np.empty(creepages.size), np.ascontiguousarray(creepages, dtype=float)
        require_ok(call("py_fastsim", self.handle, abs(float(without_slip.force)) / small, at.ctypes.data, at.size,
                        forces.ctypes.data))
        return forces


def steady(scene: Scene = None, *, creepage: Values = None, force: Values = None, lateral_creepage: Values = None,
           spin: Values = None, lateral_force: Values = None, spin_moment: Values = None,
           threads: Optional[int] = None, progress: Progress = None, missing: str = "raise",
           **overrides: Any) -> Union[Steady, PatchSteady]:
    """Solves steady rolling: the force of a creepage, or the creepage of a force, with tractions.

    Parameters
    ----------
    scene : str, path or dict
        A scene as for ms.solve(). Its load and motion are left out. Its method is taken if its problem is
        steady; the default is `inversion`, with ten digits.
    creepage : float or array
        w, finite  [1].
    force : float or array
        F, less in absolute value than full sliding  [N/mm]; of an ellipse or another patch [N]; instead of creepage.
    lateral_creepage, lateral_force, spin, spin_moment : float or array, optional
        The other components of the load of an ellipse or another patch  [1, N, 1/mm, N mm], see ms.Patch; numpy
        broadcasts all of them. A component that is not given has the motion 0.
    threads : int, optional
        At once; all cores if it is not given. Results do not depend on it.
    progress : bool or function
        As of ms.solve().
    missing : {"raise", "nan"}
        Whether a load without solution raises NoSolution, or has nan as its result.
    **overrides
        As of ms.solve().

    Returns
    -------
    Steady, or PatchSteady of an ellipse or another patch

    >>> import microslip as ms
    >>> wheel = {"material": {"shear_modulus": 82000, "poisson_ratio": 0.28},
    ...          "contact": {"half_width": 5, "peak_traction": 300},
    ...          "kernel": {"type": "plane", "length": 100}, "grid": {"elements": 100}}
    >>> result = ms.steady(wheel, force=[-500, -1500])
    >>> result.creepage.round(6)
    array([0.000592, 0.002093])
    >>> result.traction.shape
    (2, 100)
    >>> ellipse = {"material": {"youngs_modulus": 210000, "poisson_ratio": 0.28},
    ...            "contact": {"normal_load": 80000, "radius_1": 460, "lateral_radius_2": 300, "friction": 0.3},
    ...            "grid": {"rows": 8, "elements": 10}}
    >>> result = ms.steady(ellipse, force=[-5000, -15000], spin=[[0], [1e-4], [2e-4]])
    >>> (1e6 * result.creepage).round(-1)
    array([[ 430., 1560.],
           [ 440., 1580.],
           [ 480., 1640.]])
    >>> result.traction.shape
    (3, 2, 8, 10, 2)
    """
    refuse_misspelt(overrides, ("scene", *MOTIONS, *RESULTANTS, "threads", "progress", "missing"))
    arguments = SceneArguments(scene, overrides)
    across = {"lateral_creepage": lateral_creepage, "spin": spin, "lateral_force": lateral_force,
              "spin_moment": spin_moment}
    require_word("missing", missing, ("raise", "nan"))
    if has_patch(arguments):
        return _steady_patch(arguments, {"creepage": creepage, "force": force, **across}, threads, progress, missing)
    for name, value in across.items():
        if value is not None:
            raise InputError(f"{name}: expected none, as a line contact rolls along one direction", name,
                             shown(value), "none")
    if (creepage is None) == (force is None):
        raise InputError("creepage: expected either creepages or forces", "creepage", str(creepage),
                         "either creepages or forces")
    contact = _read(arguments)
    name, loads = ("creepage", creepage) if force is None else ("force", force)
    found = contact.solve(CREEPAGE if force is None else FORCE, numbers(name, loads), threads_of(threads),
                          shown_progress(progress))
    _raise_first(found.states["status"], found.messages, missing)
    if force is None:
        contact.warn_of_creepages(found.creepage)
    return found


def has_patch(arguments: SceneArguments) -> bool:
    """Whether the contact of a scene has three dimensions."""
    found = call("py_has_patch", arguments.in_c())
    require(found >= 0)
    return bool(found)


def _steady_patch(arguments: SceneArguments, given: Dict[str, Values], threads: Optional[int], progress: Progress,
                  missing: str) -> PatchSteady:
    read = PatchOfScene(arguments)
    warn_of(read.warnings, depth=4)
    found = solve_loads(read, given, threads_of(threads), shown_progress(progress))
    _raise_first(found.status, found.messages, missing)
    return found


def _read(arguments: SceneArguments) -> _Contact:
    contact = _Contact(arguments)
    warn_of(text_of("py_steady_warnings", contact.handle).splitlines(), depth=4)
    return contact


def _raise_first(statuses: np.ndarray, messages: List[str], missing: str) -> None:
    """Raises the error of the first failed load; with missing="nan" a load without solution is none."""
    for number, (status, message) in enumerate(zip(statuses.flat, messages)):
        if status and not (missing == "nan" and status == STATUS_OF_NO_SOLUTION):
            raise error_of(int(status), f"load {number}: {message}" if len(messages) > 1 else message)


def creep_curve(scene: Scene = None, *, points: Optional[int] = None, most: Optional[float] = None,
                beside: Union[str, Iterable[str], None] = None, along: Optional[str] = None,
                threads: Optional[int] = None, progress: Progress = None,
                **overrides: Any) -> Union[Steady, PatchCurve, PatchCurves]:
    """Computes the curve of force and creepage in steady rolling, from rest to full sliding and beyond.

    Of an ellipse or another patch: all three resultants over one of its motions, as `microslip curve` does.

    Parameters
    ----------
    scene : str, path or dict
        As of ms.steady().
    points : int, optional
        Number of points, >= 5, by default 41: three quarters of them up to `most`, closer to one another where the
        curve bends, and the rest up to half as much creepage again, where all slides. Of a patch 2 ... 10000, by
        default 51, evenly spaced from 0 on, and on both sides of 0 where the curve has no symmetry.
    most : float, optional
        Largest force below full sliding, as a part of it, above 0, below 1, by default 0.999; of a line contact.
    beside : {None, "fastsim"}; of an ellipse one or more of fastsim, fastsim_one, vermeulen_johnson and polach
        Other curves for comparison. Of a line contact in ``.fastsim_force``: Kalker's simplified theory of like
        bodies. Of an ellipse in ``.beside``, with errors.
    along : {"creepage", "lateral_creepage", "spin"}, optional
        The motion of a patch that varies, by default that of the scene, or creepage. The load of the scene has the
        other components, motions or resultants.
    threads, progress, **overrides
        As of ms.steady(). Keys ``curve.creepages``, ``curve.spins``, ``curve.largest``, ``curve.largest_spin`` and
        ``curve.kalker_factor`` are for patches: ``curve={"spins": [0, 1e-4, 2e-4]}``. A section ``sweep`` makes a
        family: ``sweep={"load.spin": [0, 1e-4, 2e-4]}``.

    Returns
    -------
    Steady
        Results for creepages >= 0 in ascending order; the force is negative. Bodies of different material have
        another curve for creepages below zero, which ms.steady() computes.
    PatchCurve
        Of an ellipse or another patch; with a sweep PatchCurves, which are several of them.

    Raises
    ------
    InputError, NoSolution
        NoSolution names the point that has none.

    >>> import microslip as ms
    >>> curve = ms.creep_curve(material={"shear_modulus": 82000, "poisson_ratio": 0.28},
    ...                        contact={"half_width": 5, "peak_traction": 300},
    ...                        kernel={"type": "strip", "width": 10}, grid={"elements": 50}, points=9)
    >>> (curve.force / curve.full_sliding).round(2)
    array([ 0.  , -0.31, -0.55, -0.75, -0.89, -0.97, -1.  , -1.  , -1.  ])
    >>> curve = ms.creep_curve(material={"youngs_modulus": 210000, "poisson_ratio": 0.28},
    ...                        contact={"normal_load": 80000, "radius_1": 460, "lateral_radius_2": 300,
    ...                                 "friction": 0.3}, grid={"rows": 8, "elements": 10},
    ...                        load={"spin": 1e-4}, curve={"creepages": [0, 5e-4, 1e-3, 2e-3]}, beside="fastsim")
    >>> (curve.force[1:] / curve.full_sliding).round(2)
    array([-0.23, -0.44, -0.73])
    >>> curve.beside["fastsim"]["error"].round(3)
    array([0.   , 0.003, 0.009, 0.025])
    """
    refuse_misspelt(overrides, ("scene", "points", "most", "beside", "along", "threads", "progress"))
    if has_patch(SceneArguments(scene, overrides)):
        for name in ("creepage", "force", "lateral_creepage", "lateral_force", "spin", "spin_moment"):
            if name in overrides:
                keys = f"load.{name} for a load that stays, or curve.creepages or curve.spins"
                raise InputError(f"{name}: expected {keys}", name, shown(overrides[name]), keys)
        if most is not None:
            raise InputError("most: expected none for an ellipse; curve.largest is its largest creepage", "most",
                             repr(most), "none")
        return curves_of(scene, overrides, along, points, beside, threads, progress)
    if along not in (None, "creepage"):
        raise InputError.of("along", repr(along), "'creepage' of a line contact")
    points, most = 41 if points is None else points, 0.999 if most is None else most
    if not isinstance(points, (int, np.integer)) or points < 5:
        raise InputError.of("points", repr(points), "a whole number >= 5")
    if not 0 < most < 1:
        raise InputError.of("most", repr(most), "a number above 0, below 1")
    require_word("beside", beside, (None, "fastsim"))
    for load in ("creepage", "force"):
        if load in overrides:
            raise InputError(f"{load}: expected no loads, because a curve has its own; "
                             f"ms.steady(scene, {load}=...) takes them", load, repr(overrides[load]), "no loads")
    contact = _read(SceneArguments(scene, overrides))
    told, cores = shown_progress(progress), threads_of(threads)
    below = (3 * points + 3) // 4
    ratios = most * (1 - (1 - np.linspace(0, 1, below)) ** 2)
    rising = contact.solve(FORCE, -ratios * contact.full_sliding, cores, told)
    _raise_first(rising.states["status"], rising.messages, "raise")
    last = float(rising.creepage[-1])
    sliding = contact.solve(CREEPAGE, last * np.linspace(1, 1.5, points - below + 1)[1:], cores, told)
    _raise_first(sliding.states["status"], sliding.messages, "raise")
    curve = _joined(rising, sliding)
    contact.warn_of_creepages(curve.creepage)
    if beside is not None:
        curve.fastsim_force = contact.fastsim(curve.creepage)
    return curve


def _joined(first: Steady, second: Steady) -> Steady:
    nodes = {name: np.concatenate([getattr(first, name), getattr(second, name)])
             for name in ("x", "bound", "traction", "slip", "displacement")}
    return Steady(np.concatenate([first.states, second.states]), nodes, first.full_sliding,
                  first.messages + second.messages)
