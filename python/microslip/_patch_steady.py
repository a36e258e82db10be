# SPDX-License-Identifier: GPL-3.0-or-later
"""Steady rolling of a contact ellipse, or of another patch, under many loads."""

from __future__ import annotations

import ctypes as c
import html
from typing import Any, Dict, List, Mapping, Tuple, Union

import numpy as np

from . import _plot
from ._arrays import Values, fields_of
from ._errors import InputError
from ._library import MOTIONS, PATCH_STATE, RESULTANTS, PatchCells, PatchSolutions, call, require_ok
from ._patch import UNITS, PatchOfScene, loads_of
from ._result import warn_of
from ._table import html_table, to_pandas

_ROOM = 512  # of a message, in bytes
_CELLS = tuple(name for name, _ in PatchCells._fields_)


class PatchSteady:
    """Steady rolling of a patch under one or many loads; fields and tractions have the shape of the loads.

    Attributes
    ----------
    creepage, lateral_creepage, spin : numpy.ndarray
        Motions [1, 1, 1/mm].
    force, lateral_force, spin_moment : numpy.ndarray
        Resultants [N, N, N mm].
    dissipation, slip_share : numpy.ndarray
        Energy lost per mm rolled [N], and the part of the area that slips [1].
    states : numpy.ndarray
        The same as a structured array, with full_sliding, residual and iterations.
    change : numpy.ndarray
        Of the result from rows and elements that are a third fewer, over full sliding: errors are below 2e-3 plus 1.5
        times the change, and under strong spin below 7e-3 plus 2.5 times the change [1].
    x, y, area, bound : numpy.ndarray
        Centres of elements [mm], their areas [mm^2], and the bound there [N/mm^2]; of the shape (M, N).
    traction, slip : numpy.ndarray
        Along and across, of the shape (..., M, N, 2)  [N/mm^2], [1].
    slips : numpy.ndarray
        Whether elements slip, of the shape (..., M, N), of bool.
    full_sliding : float
        The largest force that the bound allows  [N].
    status : numpy.ndarray
        0, or 2 where there is no solution.
    messages : list of str
        For each load the reason why it has no solution; empty if it has one.
    units : dict of str
    """

    units: Dict[str, str] = {**UNITS, "change": "1", "x": "mm", "y": "mm", "area": "mm^2", "bound": "N/mm^2",
                             "traction": "N/mm^2", "slip": "1"}

    def __init__(self, states: np.ndarray, change: np.ndarray, cells: Dict[str, np.ndarray], status: np.ndarray,
                 messages: List[str], read: PatchOfScene):
        self.states, self.change, self.status, self.messages = states, change, status, messages
        self.creepage, self.lateral_creepage, self.spin = (states[name] for name in MOTIONS)
        self.force, self.lateral_force, self.spin_moment = (states[name] for name in RESULTANTS)
        self.dissipation, self.slip_share = states["dissipation"], states["slip_share"]
        self.x, self.y, self.area, self.bound = (cells[name] for name in ("x", "y", "area", "bound"))
        self.traction, self.slip, self.slips = cells["traction"], cells["slip"], cells["slips"]
        self.full_sliding: float = call("py_patch_full_sliding", read.handle)
        self._edges = read.edges

    def __len__(self) -> int:
        return self.states.size

    def __repr__(self) -> str:
        if self.states.size == 1:
            shown = ", ".join(f"{name} = {self.states[name].flat[0]:.6g}"
                              + ("" if self.units[name] == "1" else f" {self.units[name]}")
                              for name in MOTIONS + RESULTANTS)
            return f"<microslip.PatchSteady: {shown}>"
        return f"<microslip.PatchSteady: {self.states.size} loads>"

    def _repr_html_(self) -> str:
        lines = "".join(f"<p>{html.escape(line)}</p>" for line in self.messages if line)
        return html_table(self.states.reshape(-1), self.units, caption="steady rolling") + lines

    def to_pandas(self) -> Any:
        """Returns a pandas.DataFrame with one row per load."""
        return to_pandas(self.states.reshape(-1), self.units)

    def plot(self, axes: Any = None, load: Union[int, Tuple[int, ...]] = ()) -> Any:
        """Draws tractions, as Patch.plot() does.

        Parameters
        ----------
        axes : matplotlib axes, optional
        load : int or tuple, optional
            Which one of several loads; the last one if it is not given.

        Returns
        -------
        The axes that were drawn into.
        """
        if not isinstance(load, tuple):
            load = (load,)
        if not load:
            load = (-1,) * self.states.ndim
        fields = _plot.PatchFields(self.x, self.y, self.traction[load], self.slips[load])
        return _plot.plot_patch(fields, self._edges, axes)


def solve_loads(read: PatchOfScene, given: Mapping[str, Values], threads: int, told: Any) -> PatchSteady:
    """Solves loads of any shape, each on its own, so that neither threads nor other loads change a result."""
    loads, _ = loads_of(given)
    if loads is None:
        raise InputError("creepage: expected a motion or a resultant", "creepage", "", "a motion or a resultant")
    warn_of([doubt] if (doubt := read.doubt_of(loads)) else [], depth=5)
    count, size = loads.size, read.shape[0] * read.shape[1]
    room = max(count, 1)  # without loads, places are those of no load at all
    flat = loads.reshape(-1) if count else np.zeros(1, loads.dtype)
    states, changes = np.zeros(room, PATCH_STATE), np.full(room, np.nan)
    for name in fields_of(PATCH_STATE)[:-1]:
        states[name] = np.nan
    statuses, messages = np.zeros(room, np.intc), np.zeros(room, f"S{_ROOM}")
    cells = {name: np.full((room, size), 0 if name == "slips" else np.nan, np.intc if name == "slips" else float)
             for name in _CELLS}
    at_once = 4 * threads  # so that an interrupt is noticed
    for at in range(0, room, at_once):
        part = slice(at, min(at + at_once, room))
        out = PatchSolutions(states[part].ctypes.data, changes[part].ctypes.data, statuses[part].ctypes.data,
                             messages[part].ctypes.data, _ROOM,
                             PatchCells(*(cells[name][part].ctypes.data for name in _CELLS)))
        require_ok(call("py_patch_steady", read.handle, flat[part].ctypes.data, part.stop - at, threads, c.byref(out)))
        if told is not None and count:
            told(part.stop, count)
    whole = loads.shape + read.shape
    found = {name: cells[name][np.argmin(statuses)].reshape(read.shape) for name in ("x", "y", "area", "bound")}
    for name in ("traction", "slip"):
        found[name] = np.stack([cells[f"{name}_{axis}"][:count] for axis in "xy"], -1).reshape(whole + (2,))
    found["slips"] = cells["slips"][:count].astype(bool).reshape(whole)
    return PatchSteady(states[:count].reshape(loads.shape), changes[:count].reshape(loads.shape), found,
                       statuses[:count].reshape(loads.shape), [line.decode() for line in messages[:count]], read)
