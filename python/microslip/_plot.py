# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws figures with matplotlib, if it is installed."""

from __future__ import annotations

import sys
from typing import Any

import numpy as np


def print_progress(done: int, total: int) -> None:
    """Prints a line on stderr over the last one."""
    end = "\n" if done == total and total else ""
    print(f"\rmicroslip: {done}" + (f" of {total}" if total else ""), end=end, file=sys.stderr, flush=True)


def _new_axes(columns: int = 1) -> Any:
    try:
        from matplotlib import pyplot  # pylint: disable=import-outside-toplevel
    except ImportError:
        raise ImportError("plot wants matplotlib, which is not installed: python3-matplotlib of Debian, "
                          "or pip install matplotlib") from None
    _, axes = pyplot.subplots(1, columns, figsize=(5.5 * columns, 3.6), layout="constrained")
    return axes


def plot_traction(x: np.ndarray, bound: np.ndarray, traction: np.ndarray, axes: Any = None) -> Any:
    """Draws tractions, and their bound on both sides."""
    axes = _new_axes() if axes is None else axes
    axes.fill_between(x, -bound, bound, color="0.92", label="bound")
    axes.plot(x, traction, label="traction")
    axes.axhline(0, color="0.6", linewidth=0.6)
    axes.set(xlabel="x [mm], rolling to the right", ylabel="traction [N/mm²]")
    axes.legend()
    return axes


def plot_patch(table: np.ndarray, axes: Any = None) -> Any:
    """Draws tractions of an ellipse as arrows, orange where it slips."""
    axes = _new_axes() if axes is None else axes
    slips = table["zone"] == "S"
    for of, color, label in ((~slips, "tab:blue", "sticks"), (slips, "tab:orange", "slips")):
        part = table[of]
        axes.quiver(part["x"], part["y"], part["traction_x"], part["traction_y"], color=color, label=label,
                    angles="xy", scale=15 * float(np.max(table["bound"])))
    axes.set(xlabel="x [mm], rolling to the right", ylabel="y [mm]", aspect="equal")
    axes.legend()
    return axes


def plot_result(result: Any, axes: Any = None) -> Any:
    """Draws a result, see Result.plot."""
    if "traction_x" in result.traction.dtype.names:
        return plot_patch(result.traction, axes)
    history = result.history if axes is None else None
    both = _new_axes(1 if history is None else 2) if axes is None else axes
    first = both if history is None else both[0]
    table = result.traction
    plot_traction(table["x"], table["bound"], table["traction"], first)
    if history is not None:
        name = "q" if "q" in history.dtype.names else "X"
        both[1].plot(history[name], history["force"])
        both[1].set(xlabel=f"distance rolled [{result.units[name]}]", ylabel="force [N/mm]")
    return both


def plot_curve(steady: Any, axes: Any = None) -> Any:
    """Draws |F| over |w|, with full sliding."""
    axes = _new_axes() if axes is None else axes
    (line,) = axes.plot(100 * np.abs(steady.creepage), np.abs(steady.force), label="steady rolling")
    line.sticky_edges.x[:] = line.sticky_edges.y[:] = [0]  # axes begin there, and still grow with other curves
    if steady.fastsim_force is not None:
        axes.plot(100 * np.abs(steady.creepage), np.abs(steady.fastsim_force), linestyle=":", color=line.get_color(),
                  label="FASTSIM")
    axes.axhline(steady.full_sliding, color="0.6", linewidth=0.8, linestyle="--", label="full sliding")
    axes.set(xlabel="creepage [%]", ylabel="force [N/mm]")
    axes.autoscale_view()
    axes.legend()
    return axes
