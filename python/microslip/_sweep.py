# SPDX-License-Identifier: GPL-3.0-or-later
"""Solves many scenes at once."""

from __future__ import annotations

import concurrent.futures
import re
import threading
from typing import Any, Dict, List, Mapping, Optional

import numpy as np

from ._errors import Error, NoSolution
from ._keys import keys as all_keys
from ._result import Cases, Progress, require_word, shown_progress, threads_of, warn_of
from ._scene import Scene, SceneArguments
from ._table import column_of, html_table, structured, to_pandas


class Sweep:
    """The cases of a sweep, in their order; indexed and iterated over, it gives results.

    Attributes
    ----------
    cases : numpy.ndarray
        Structured array with one row per case: the swept keys, and all numbers of the summaries. These numbers are
        nan for a case without solution.
    keys : list of str
        Keys that were swept.
    results : list of Result or None
        None where there is no solution.
    errors : list of str
        Message of each case; empty if it has a solution.
    units : dict of str
    """

    def __init__(self, keys: List[str], values: List[List[str]], results: List[Any], errors: List[str]):
        self.keys, self.results, self.errors = keys, results, errors
        self.units: Dict[str, str] = {key: all_keys()[key].unit for key in keys if key in all_keys()}
        for result in results:
            if result is not None:
                self.units = {**result.units, **self.units}
        self.cases = _table_of(keys, values, results)

    def __len__(self) -> int:
        return len(self.results)

    def __getitem__(self, which: Any) -> Any:
        """Returns a case's result by its number, or a column by its name."""
        return self.cases[which] if isinstance(which, str) else self.results[which]

    def __repr__(self) -> str:
        failed = sum(1 for error in self.errors if error)
        return (f"<microslip.Sweep over {', '.join(self.keys)}: {len(self)} cases"
                f"{f', {failed} without solution' if failed else ''}>")

    def _repr_html_(self) -> str:
        return html_table(self.cases, self.units, caption=f"sweep over {', '.join(self.keys)}")

    def to_pandas(self) -> Any:
        """Returns a pandas.DataFrame with one row per case."""
        return to_pandas(self.cases, self.units)


def _table_of(keys: List[str], values: List[List[str]], results: List[Any]) -> np.ndarray:
    columns: Dict[str, Any] = {key: column_of([row[k] for row in values]) for k, key in enumerate(keys)}
    solved = [result.summary for result in results if result is not None]
    names = [name for name in (solved[0].dtype.names if solved else ())
             if all(name in one.dtype.names and one.dtype[name] == float for one in solved)]
    for name in names:
        columns[name] = np.array([np.nan if result is None else result.summary[name] for result in results])
    return structured(list(columns), list(columns.values()), len(results))


def sweep(scene: Scene = None, over: Optional[Mapping[str, Any]] = None, *, threads: Optional[int] = None,
          progress: Progress = None, missing: str = "nan", **overrides: Any) -> Sweep:
    """Solves many scenes: all combinations of lists of values.

    Parameters
    ----------
    scene : str, path or dict
        As of ms.solve(); it may have a section `sweep` of its own.
    over : dict
        Keys with their values, arrays or lists; or texts as a section `sweep` has them, "0:0.1:1". The last key
        varies fastest.
    threads : int, optional
        At once; all cores if it is not given. Results do not depend on it.
    progress : bool or function
        True prints a line; a function gets the number of finished cases and of all cases.
    missing : {"nan", "raise"}
        Whether a case without solution has nan as its result, or raises NoSolution.
    **overrides
        As of ms.solve().

    Returns
    -------
    Sweep

    Raises
    ------
    InputError
        All scenes are read before the first is solved.

    >>> import microslip as ms
    >>> wheel = {"problem": "steady", "material": {"shear_modulus": 82000, "poisson_ratio": 0.28},
    ...          "contact": {"half_width": 5, "peak_traction": 300},
    ...          "kernel": {"type": "strip", "width": 10}, "grid": {"elements": 50}}
    >>> cases = ms.sweep(wheel, {"contact.half_width": [4, 5], "load.force": [-500, -1000]})
    >>> cases
    <microslip.Sweep over contact.half_width, load.force: 4 cases>
    >>> cases["creepage"].round(6)
    array([0.00069 , 0.001536, 0.000521, 0.001128])
    """
    require_word("missing", missing, ("raise", "nan"))
    cores = threads_of(threads)
    given = {f"sweep.{key}": value for key, value in (over or {}).items()}
    removed = {key: None for key in (over or {})}
    cases = Cases(SceneArguments(scene, {**removed, **overrides, **given}), True)
    warn_of(warnings_of(cases))
    results, errors = solve_all(cases, cores, shown_progress(progress), missing)
    return Sweep(cases.keys, cases.values, results, errors)


def warnings_of(cases: Cases) -> List[str]:
    """A line for each kind of warning, which is the warning without its numbers: how many cases have it, and the
    first of them."""
    counts: Dict[str, int] = {}
    first: Dict[str, str] = {}
    for case in range(len(cases)):
        for line in cases.warnings(case):
            kind = re.sub(r"[0-9.+\-e]", "", line)
            counts[kind] = counts.get(kind, 0) + 1
            first.setdefault(kind, f"the first is case {case}: {line}")
    return [f"{count} of {len(cases)} cases, {first[kind]}" for kind, count in counts.items()]


def solve_all(cases: Cases, threads: int, told: Any, missing: str) -> Any:
    """Solves all cases in threads; an interrupt or an error ends the cases that run."""
    results: List[Any] = [None] * len(cases)
    errors = [""] * len(cases)
    stop = threading.Event()

    def look(_done: int, _total: int) -> None:
        if stop.is_set():
            raise Error("stopped")

    def solve(case: int) -> int:
        look(0, 0)
        try:
            results[case] = cases.solve(case, look)
        except NoSolution as error:
            if missing == "raise":
                raise
            errors[case] = str(error)
        return case

    with concurrent.futures.ThreadPoolExecutor(threads) as pool:
        futures = [pool.submit(solve, case) for case in range(len(cases))]
        try:
            for done, future in enumerate(concurrent.futures.as_completed(futures), 1):
                future.result()
                if told is not None:
                    told(done, len(cases))
        except BaseException:
            stop.set()
            for future in futures:
                future.cancel()
            raise
    return results, errors
