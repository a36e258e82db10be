# SPDX-License-Identifier: GPL-3.0-or-later
"""Curves of the resultants of an ellipse, or of another patch, over one of its motions."""

from __future__ import annotations

from typing import Any, Dict, Iterable, List, Mapping, Optional, Tuple, Union

import numpy as np

from . import _plot
from ._errors import InputError
from ._library import MOTIONS, RESULTANTS
from ._result import Cases, Progress, Tables, require_word, shown_progress, threads_of, warn_of
from ._scene import SceneArguments
from ._sweep import Sweep, solve_all, warnings_of
from ._table import Table

LAWS = ("fastsim", "fastsim_one", "vermeulen_johnson", "polach")


class PatchCurve(Tables):
    """Resultants in steady rolling of a patch over one of its motions; a number for each point.

    Attributes
    ----------
    along : str
        The motion that varies: creepage, lateral_creepage or spin.
    creepage, lateral_creepage, spin : numpy.ndarray
        Motions [1, 1, 1/mm].
    force, lateral_force, spin_moment : numpy.ndarray
        Resultants [N, N, N mm].
    slip_share, change : numpy.ndarray
        The part of the area that slips [1], and the change of the result from rows and elements that are a third fewer,
        over full sliding [1].
    beside : dict of numpy.ndarray
        For each law that was asked for a structured array with force, lateral_force and error, which is the size of the
        difference of the force over full sliding; of FASTSIM with spin_moment, too.
    full_sliding : float
        The largest force that the bound allows  [N].
    points : numpy.ndarray
        All columns as a structured array, with force_ratio (size of the force over full sliding) and, where the scene
        has a normal load, traction_coefficient.
    summary : numpy.record
        full_sliding_force, Kalker's coefficients c11, c22, c23, c33 of the elements, the largest error of each law, ...
    tables, units, parameters, warnings
        As of Result.
    """

    def __init__(self, tables: Dict[str, Table]):
        super().__init__(tables)
        self.points = tables["curve"].data
        self.along = self.parameters["curve.along"]
        self.creepage, self.lateral_creepage, self.spin = (self.points[name] for name in MOTIONS)
        self.force, self.lateral_force, self.spin_moment = (self.points[name] for name in RESULTANTS)
        self.slip_share, self.change = self.points["slip_share"], self.points["change"]
        self.full_sliding = float(self.summary["full_sliding_force"])
        self.beside: Dict[str, np.ndarray] = {law: self._by(law) for law in LAWS if f"{law}_error" in
                                              self.points.dtype.names}

    def _by(self, law: str) -> np.ndarray:
        names = [name for name in (*RESULTANTS, "error") if f"{law}_{name}" in self.points.dtype.names]
        found = np.empty(len(self.points), [(name, float) for name in names])
        for name in names:
            found[name] = self.points[f"{law}_{name}"]
        return found

    def __len__(self) -> int:
        return len(self.points)

    def __repr__(self) -> str:
        motions = self.points[self.along]
        return (f"<microslip.PatchCurve: {len(self)} points, {self.along} from {motions.min():.6g} to "
                f"{motions.max():.6g}{_plot.with_unit(self.units[self.along])}>")

    def to_pandas(self) -> Any:
        """Returns a pandas.DataFrame with one row per point."""
        return self.tables["curve"].to_pandas()

    def plot(self, axes: Any = None) -> Any:
        """Draws the resultants that are not 0 over the motion, with the laws, whose errors are in the legend.

        Parameters
        ----------
        axes : matplotlib axes, optional
            Axes to draw into; then the force or moment along the motion alone is drawn.

        Returns
        -------
        An array of the axes that were drawn into, or the axes that were given.
        """
        return _plot.plot_patch_curves([self], [""], axes)


class PatchCurves(Sweep):
    """Curves of all combinations of lists of values; indexed and iterated over, it gives the curves.

    Attributes
    ----------
    cases, keys, results, errors, units
        As of Sweep: the swept keys and the numbers of the summaries, a row a curve.
    """

    def __repr__(self) -> str:
        return f"<microslip.PatchCurves over {', '.join(self.keys)}: {len(self)} curves>"

    def plot(self, axes: Any = None) -> Any:
        """Draws all curves, as PatchCurve.plot() draws one."""
        names = [", ".join(f"{key} = {_shown(row[key])}" for key in self.keys) for row in self.cases]
        return _plot.plot_patch_curves(self.results, names, axes)


def _shown(value: Any) -> str:
    return f"{value:.6g}" if isinstance(value, (float, np.floating)) else str(value)


def laws_of(beside: Union[str, Iterable[str], None]) -> Optional[str]:
    """Returns laws as a scene has them; None if none is given."""
    if beside is None:
        return None
    names: List[str] = [beside] if isinstance(beside, str) else list(beside)
    for name in names:
        require_word("beside", name, LAWS)
    return " ".join(names) if names else "nothing"


def curves_of(scene: Any, overrides: Mapping[str, Any], along: Optional[str], points: Optional[int],
              beside: Union[str, Iterable[str], None], threads: Optional[int],
              progress: Progress) -> Union[PatchCurve, PatchCurves]:
    """Computes the curve of a scene, or those of its sweep."""
    if along is not None:
        require_word("along", along, MOTIONS)
    given: Dict[str, Tuple[Any, str]] = {"along": (along, "curve.along"), "points": (points, "curve.points"),
                                         "beside": (laws_of(beside), "curve.beside")}
    for name, (value, key) in given.items():
        if value is not None and (key in overrides or key.replace(".", "_") in overrides):
            raise InputError(f"{name}: expected this argument or {key}, not both", name, str(value), "one of both")
    keys = {key: value for value, key in given.values() if value is not None}
    swept = overrides.get("sweep")
    given_keys = {**overrides, **keys}
    if isinstance(swept, Mapping):  # lists go before values, as those of ms.sweep()
        del given_keys["sweep"]
        given_keys = {**{key: None for key in swept}, **given_keys, "sweep": swept}
    cases = Cases(SceneArguments(scene, given_keys), True, PatchCurve)
    cores, told = threads_of(threads), shown_progress(progress)
    if not cases.keys:
        warn_of(cases.warnings(0), depth=4)
        curve = cases.solve(0, told)
        warn_of((line for line in curve.warnings if line not in cases.warnings(0)), depth=4)
        return curve
    warn_of(warnings_of(cases), depth=4)
    results, errors = solve_all(cases, cores, told, "raise")
    return PatchCurves(cases.keys, cases.values, results, errors)
