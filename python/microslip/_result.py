# SPDX-License-Identifier: GPL-3.0-or-later
"""Solves scenes, alone or in sweeps."""

from __future__ import annotations

import html
import os
import pathlib
import warnings
from typing import Any, Callable, Dict, Iterable, List, Optional, Tuple, Union

import numpy as np

from . import _plot
from ._arrays import fields_of
from ._errors import InputError, LoadWarning
from ._library import as_progress, call, free_with, require, text_of
from ._scene import Scene, SceneArguments
from ._table import Table

_EVIDENCE = ("residual", "bound_violation", "slip_violation", "bound_resolution", "dissipation_error", "condition")

#: True prints a line; a function is called with what is done and the total, which is 0 if not known.
Progress = Union[bool, Callable[[int, int], Any], None]


def shown_progress(progress: Progress) -> Optional[Callable[[int, int], Any]]:
    """Returns the function to call, or None."""
    if not isinstance(progress, bool):
        return progress
    return _plot.print_progress if progress else None


def threads_of(threads: Optional[int]) -> int:
    """Returns a number of threads: all cores that this process may use, if none is given."""
    if threads is None:
        return len(os.sched_getaffinity(0))
    if isinstance(threads, int) and threads >= 1:
        return threads
    raise InputError.of("threads", repr(threads), "a whole number >= 1")


def require_word(name: str, value: Any, accepted: Tuple[Any, ...]) -> None:
    """Rejects what is none of the words."""
    if value not in accepted:
        raise InputError.of(name, repr(value), " or ".join(map(repr, accepted)))


class Tables:
    """Tables of the program, one of which is the summary."""

    def __init__(self, tables: Dict[str, Table]):
        self.tables = tables
        summary = tables["summary"]
        self.units: Dict[str, str] = {**{str(row["quantity"]): str(row["unit"]) for row in summary.data}}
        for table in tables.values():
            if table is not summary:
                self.units.update(table.units)
        self.parameters = summary.parameters
        self.summary = _record_of(summary)
        doubt = str(self.summary["warning"])
        self.warnings: List[str] = summary.warnings + ([] if doubt == "none" else [doubt])

    def _repr_html_(self) -> str:
        table = self.tables["summary"]
        doubts = "".join(f"<p>warning: {html.escape(line)}</p>" for line in self.warnings)
        rows = "".join(f"<tr><td>{html.escape(row['quantity'])}</td><td>{html.escape(_short(row['value']))}"
                       f"{html.escape(_plot.with_unit(row['unit']))}</td></tr>" for row in table.data)
        return f"<table><caption>{html.escape(table.description)}</caption>{rows}</table>{doubts}"

    def write(self, folder: Union[str, "os.PathLike[str]"]) -> None:
        """Writes the tables as files, as the program does; ms.read_table and `microslip plot` read them."""
        path = pathlib.Path(folder)
        path.mkdir(parents=True, exist_ok=True)
        for name, table in self.tables.items():
            table.write(path / f"{name}.tsv")


class Result(Tables):
    """The solution of a scene: its tables as numpy structured arrays.

    Attributes
    ----------
    summary : numpy.record
        One field per quantity: ``result.summary["force"]`` or ``result.summary.force``.
    traction : numpy.ndarray
        One row per node: x, bound, traction, slip, displacement and region, "A" in adhesion and "S" in slip. Of an
        ellipse or another patch one row per element, see field().
    history : numpy.ndarray or None
        One row per step; None for steady rolling.
    shifts : numpy.ndarray or None
        One row per shift before rolling, if there are several.
    instants : numpy.ndarray or None
        Rows as of traction at each instant of motion.instants, behind its number ``instant`` and its place ``q``.
    tables : dict of Table
        The same tables with descriptions, units and parameters.
    units : dict of str
        Units of all columns and quantities: ``result.units["force"]`` is "N/mm".
    evidence : dict of float
        Numbers that show whether the result is right, see docs/scenes.md.
    warnings : list of str
        Warnings of values and of the result; each has been a LoadWarning, too.
    parameters : dict of str
        Keys and values of the scene, with defaults and what follows from them.
    """

    def __init__(self, tables: Dict[str, Table]):
        super().__init__(tables)
        self.traction = tables["traction"].data
        self.history = tables["history"].data if "history" in tables else None
        self.shifts = tables["shifts"].data if "shifts" in tables else None
        self.instants = tables["instants"].data if "instants" in tables else None
        self.evidence: Dict[str, float] = {name: float(self.summary[name]) for name in _EVIDENCE
                                           if name in fields_of(self.summary.dtype)}

    def __repr__(self) -> str:
        shown = ", ".join(f"{name} = {self.summary[name]:.6g}" + _plot.with_unit(self.units[name])
                          for name in ("force", "creepage", "distance") if name in fields_of(self.summary.dtype))
        return f"<microslip.Result: {self.tables['summary'].description}: {shown}>"

    def to_pandas(self, table: str = "") -> Any:
        """Returns a table as a pandas.DataFrame: by default the steps if there are any, else the tractions."""
        return self.tables[table or ("history" if self.history is not None else "traction")].to_pandas()

    def field(self, name: str) -> np.ndarray:
        """Returns values in the elements of an ellipse or another patch, in rows across the rolling.

        Parameters
        ----------
        name : str
            ``traction`` or ``slip``, along and across; ``slips``, whether an element does; or a column of
            ``result.traction``.

        Returns
        -------
        numpy.ndarray
            Of the shape (M, N), of traction and slip (M, N, 2). Rows begin at the least y, and elements of a row at its
            leading edge. With step.scheme direct and relaxed, rectangles fill the contact; where there is none, numbers
            are nan, texts are empty, and nothing slips.

        >>> import microslip as ms
        >>> result = ms.solve(problem="steady", material={"youngs_modulus": "210 GPa", "poisson_ratio": 0.28},
        ...                   contact={"normal_load": "80 kN", "radius_1": 460, "lateral_radius_2": 300,
        ...                            "friction": 0.3},
        ...                   grid={"rows": 8, "elements": 10}, load={"creepage": 1e-3, "spin": "0.1 1/m"})
        >>> result.field("traction").shape, int(result.field("slips").sum())
        ((8, 10, 2), 36)
        """
        if "zone" not in self.traction.dtype.names:
            raise InputError("name: expected a result of an ellipse or another patch; that of a line contact has "
                             "columns, result.traction", "name", name, "a result of an ellipse or another patch")
        if name in ("traction", "slip"):
            return np.stack([self.field(f"{name}_{axis}") for axis in "xy"], -1)
        if name == "slips":
            return self.field("zone") == "S"
        if name not in self.traction.dtype.names:
            accepted = ("traction", "slip", "slips", *self.traction.dtype.names)
            raise InputError.of("name", repr(name), ", ".join(accepted))
        values = self.traction[name]
        if not self._has_rectangles:
            return values.reshape(int(self.summary["rows"]), int(self.summary["elements"]))
        (x, columns), (y, rows) = (_places(self.traction[axis]) for axis in "xy")
        empty = np.full((len(y), len(x)), np.nan if values.dtype.kind == "f" else "", values.dtype)
        if name in ("x", "y"):
            return x[None, ::-1] + 0 * y[:, None] if name == "x" else y[:, None] + 0 * x
        empty[rows, len(x) - 1 - columns] = values
        return empty

    @property
    def _has_rectangles(self) -> bool:
        return "method" in fields_of(self.summary.dtype) and self.summary["method"] in ("direct", "relaxed")

    def plot(self, axes: Any = None) -> Any:
        """Draws tractions within their bound and, unless rolling is steady, the force over the distance.

        Of an ellipse or another patch, the size of tractions is shown in colour, their direction by arrows, and the
        elements that slip by dots, with a line about them.

        Parameters
        ----------
        axes : matplotlib axes, optional
            Axes to draw into; then the tractions alone are drawn.

        Returns
        -------
        The axes that were drawn into.
        """
        return _plot.plot_result(self, axes)


def _places(centres: np.ndarray) -> Any:
    """The different places of the centres of rectangles, which may differ by rounding, and the number of each."""
    _, first, numbers = np.unique(np.round(centres / np.ptp(centres), 6), return_index=True, return_inverse=True)
    return centres[first], numbers


def _short(text: str) -> str:
    try:
        return f"{float(text):.6g}"
    except ValueError:
        return str(text)


def _record_of(summary: Table) -> np.record:
    """Turns the rows quantity, value, unit into one record."""
    names = [str(name) for name in summary["quantity"]]
    values: List[Union[float, str]] = []
    for text in summary["value"]:
        try:
            values.append(float(text))
        except ValueError:
            values.append(str(text))
    types = [(name, f"U{len(value)}" if isinstance(value, str) else float) for name, value in zip(names, values)]
    return np.rec.array([tuple(values)], dtype=types)[0]


class Cases:
    """Scenes that have been read by the library, to be solved.

    curve  makes the curves that are wanted of tables; None for solutions
    """

    def __init__(self, arguments: SceneArguments, is_swept: bool, curve: Optional[Callable[..., Any]] = None):
        self._make = curve or Result
        self._handle = require(call("py_read", arguments.in_c(), is_swept, curve is not None))
        free_with(self, "py_cases_destroy", self._handle)

        rows = text_of("py_swept", self._handle).split("\x1e")[:-1]
        self.keys, *self.values = [row.split("\x1f")[:-1] for row in rows]

    def __len__(self) -> int:
        return len(self.values)

    def warnings(self, case: int) -> List[str]:
        return text_of("py_warnings", self._handle, case).splitlines()

    def solve(self, case: int, told: Optional[Callable[[int, int], Any]]) -> Any:
        """Raises what `told` raises, too, which ends the work."""
        raised: List[BaseException] = []
        handle = call("py_solve", self._handle, case, as_progress(told, raised))
        if raised:
            raise raised[0]
        require(handle)
        try:
            return self._make({table.name: table for table in (
                Table(text_of("py_table_name", handle, k), text_of("py_table_text", handle, k))
                for k in range(call("py_table_count", handle)))})
        finally:
            call("py_tables_destroy", handle)


def warn_of(lines: Iterable[str], depth: int = 3) -> None:
    """Warns the user who called, `depth` frames above."""
    for line in lines:
        warnings.warn(line, LoadWarning, stacklevel=depth)


def solve(scene: Scene = None, *, progress: Progress = None, **overrides: Any) -> Result:
    """Solves a scene: steady rolling, a transient or a rolling cylinder.

    Parameters
    ----------
    scene : str, path or dict
        A file ``scene.info``; or its text, which has a brace or several lines; or a dictionary of keys,
        whose sections may be dictionaries. ``ms.keys()`` and docs/scenes.md list all keys.
    progress : bool or function
        True prints a line; a function gets the finished part and the total, which is 0 if it is not known.
    **overrides
        Keys that override the scene: as sections, ``load={"force": -1500}``, or with underscores,
        ``load_force=-1500``. Numbers may have a unit: ``"1.5 kN/mm"``. None removes a key. A key that
        names a file takes arrays instead: ``contact={"bound_file": (x, values)}``,
        ``load={"file": {"q": q, "force": force}}``.

    Returns
    -------
    Result

    Raises
    ------
    InputError
        A ValueError that names key, value and what is accepted.
    NoSolution
        If there is no solution, or no solution that the scene accepts.

    >>> import microslip as ms
    >>> result = ms.solve(problem="steady",
    ...                   material={"shear_modulus": "82 GPa", "poisson_ratio": 0.28},
    ...                   contact={"half_width": 5, "peak_traction": 300},
    ...                   kernel={"type": "strip", "width": 10},
    ...                   grid={"elements": 100}, load={"force": -1500})
    >>> result
    <microslip.Result: steady rolling, the whole contact; by inversion: force = -1500 N/mm, creepage = 0.00187727>
    >>> round(float(result.traction["traction"].min()), 1)
    -290.5
    """
    cases = Cases(SceneArguments(scene, overrides), False)
    warn_of(cases.warnings(0))
    result = cases.solve(0, shown_progress(progress))
    warn_of(line for line in result.warnings if line not in cases.warnings(0))
    return result
