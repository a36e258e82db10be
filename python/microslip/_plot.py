# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws figures with matplotlib, if it is installed."""

from __future__ import annotations

import sys
from typing import Any, Iterator, NamedTuple, Sequence, Tuple

import numpy as np


def print_progress(done: int, total: int) -> None:
    """Prints a line on stderr over the last one."""
    end = "\n" if done == total and total else ""
    print(f"\rmicroslip: {done}" + (f" of {total}" if total else ""), end=end, file=sys.stderr, flush=True)


def _subplots(rows: int, columns: int, size: Tuple[float, float], **options: Any) -> Any:
    try:
        from matplotlib import pyplot  # pylint: disable=import-outside-toplevel
    except ImportError:
        raise ImportError("plot wants matplotlib, which is not installed: python3-matplotlib of Debian, "
                          "or pip install matplotlib") from None
    _, axes = pyplot.subplots(rows, columns, figsize=size, layout="constrained", **options)
    return axes


def _new_axes(columns: int = 1) -> Any:
    return _subplots(1, columns, (5.5 * columns, 3.6))


def plot_traction(x: np.ndarray, bound: np.ndarray, traction: np.ndarray, axes: Any = None) -> Any:
    """Draws tractions, and their bound on both sides."""
    axes = _new_axes() if axes is None else axes
    axes.fill_between(x, -bound, bound, color="0.92", label="bound")
    axes.plot(x, traction, label="traction")
    axes.axhline(0, color="0.6", linewidth=0.6)
    axes.set(xlabel="x [mm], rolling to the right", ylabel="traction [N/mm²]")
    axes.legend()
    return axes


class PatchFields(NamedTuple):
    """Values in the elements of a patch, (M, N) in rows across the rolling; nan outside it."""

    x: np.ndarray
    y: np.ndarray
    traction: np.ndarray  #: (M, N, 2)
    slips: np.ndarray


def scaled(edges: np.ndarray, size: float) -> np.ndarray:
    """The edges of a patch of another size."""
    found = edges.copy()
    for name in ("y", "trailing", "leading"):
        found[name] *= size
    return found


def _elements_in_strips(edges: np.ndarray, values: np.ndarray) -> Iterator[Tuple[np.ndarray, np.ndarray, np.ndarray]]:
    """Yields corners and values of the elements of each lobe, whose rows have strips between the sides of `edges`.

    Elements are equal in the angle theta, x = middle + half-length cos(theta).
    """
    part = np.cos(np.pi * np.arange(values.shape[1] + 1) / values.shape[1])
    for lobe in np.unique(edges["lobe"]):
        sides = edges[edges["lobe"] == lobe]
        middle, half = (sides["leading"] + sides["trailing"]) / 2, (sides["leading"] - sides["trailing"]) / 2
        yield (middle[:, None] + half[:, None] * part, np.repeat(sides["y"][:, None], part.size, 1),
               values[sides["row"][:-1].astype(int) - 1])


def _most(fields: PatchFields) -> float:
    return float(np.nanmax(np.hypot(fields.traction[..., 0], fields.traction[..., 1])))


def _draw_patch(fields: PatchFields, edges: np.ndarray, axes: Any, most: float) -> Any:
    """Draws what plot_patch() does into axes that have a scale already, and returns the coloured part.

    most  the traction of the darkest colour and the longest arrow  [N/mm^2]
    """
    size = np.hypot(fields.traction[..., 0], fields.traction[..., 1])
    look = {"cmap": "Blues", "vmin": 0, "vmax": 1.1 * most}
    if np.isnan(size).any():
        drawn = axes.pcolormesh(fields.x[0], fields.y[:, 0], size, **look)
    else:
        for x, y, values in _elements_in_strips(edges, size):
            drawn = axes.pcolormesh(x, y, values, **look)
    for lobe in np.unique(edges["lobe"]):
        sides = edges[edges["lobe"] == lobe]
        axes.plot(np.r_[sides["trailing"], sides["leading"][::-1], sides["trailing"][:1]],
                  np.r_[sides["y"], sides["y"][::-1], sides["y"][:1]], color="0.4", linewidth=0.8)
        rows = np.unique(sides["row"].astype(int)) - 1
        part = fields.slips[rows]
        inside = ~np.isnan(size[rows])
        if min(part.shape) >= 2 and 0 < np.sum(part[inside]) < np.sum(inside):
            axes.contour(fields.x[rows], fields.y[rows], np.where(inside, part, np.nan), [0.5], colors="tab:orange")
    slips = ~np.isnan(size) & (fields.slips == 1)
    axes.plot(fields.x[slips], fields.y[slips], ".", color="tab:orange", markersize=3, label="slips", zorder=1.5)
    thin = tuple(slice(count % step // 2, None, step) for count, step in (
        (count, -(-count // 12)) for count in size.shape))
    axes.quiver(fields.x[thin], fields.y[thin], *np.moveaxis(fields.traction[thin], -1, 0), angles="xy", pivot="mid",
                scale=10 * most, width=0.004)
    axes.set_aspect("equal")
    return drawn


def plot_patch(fields: PatchFields, edges: np.ndarray, axes: Any = None) -> Any:
    """Draws the size of tractions in colour, their direction as arrows, and a dot where an element slips, with a line about
    all of them.

    edges  the table of the edges, in whose rows the elements of the fields are; rectangles leave gaps in the fields
    """
    axes = _new_axes() if axes is None else axes
    drawn = _draw_patch(fields, edges, axes, _most(fields) or 1.0)
    axes.figure.colorbar(drawn, ax=axes, label="traction [N/mm²]")
    axes.set(xlabel="x [mm], rolling to the right", ylabel="y [mm]")
    if np.any(fields.slips == 1):
        axes.legend(loc="lower right", bbox_to_anchor=(1, 1), frameon=False, markerscale=3)
    return axes


def plot_patches(patches: Sequence[Tuple[PatchFields, np.ndarray]], titles: Sequence[str]) -> Any:
    """Draws patches side by side, with one scale of places, colours and arrows; returns an array of axes.

    patches  of each the fields and the edges, as for plot_patch()
    """
    columns = 2 if len(patches) == 4 else min(len(patches), 3)
    rows = -(-len(patches) // columns)
    edges = patches[0][1]
    height = np.ptp(edges["y"]) / (edges["leading"].max() - edges["trailing"].min())  # over the width
    panels = _subplots(rows, columns, (3.1 * columns + 0.9, rows * (0.7 + 2.6 * min(max(height, 0.3), 2))),
                       sharex=True, sharey=True, squeeze=False)
    most = max(_most(fields) for fields, _ in patches) or 1.0
    for (fields, sides), title, axes in zip(patches, titles, panels.flat):
        drawn = _draw_patch(fields, sides, axes, most)
        axes.set_title(title, fontsize="medium")
    for axes in panels.flat[len(patches):]:
        axes.set_axis_off()
    for k, axes in enumerate(panels.flat[:len(patches)]):
        if k + columns >= len(patches):
            axes.set_xlabel("x [mm]")
            axes.tick_params(labelbottom=True)
        if k % columns == 0:
            axes.set_ylabel("y [mm]")
    figure = panels[0, 0].figure
    figure.colorbar(drawn, ax=panels[:, -1].tolist(), label="traction [N/mm²]")
    figure.suptitle("traction in colour and arrows; orange: slip; rolling to the right", fontsize="medium")
    return panels.flat[:len(patches)]


def plot_lines(lines: Sequence[Tuple[np.ndarray, np.ndarray, np.ndarray]], titles: Sequence[str],
               axes: Any = None) -> Any:
    """Draws tractions of line contacts over one another, from the first, which is pale, to the last.

    lines  of each x, bound and traction
    """
    axes = _new_axes() if axes is None else axes
    pale, dark = np.array([0.65, 0.8, 0.92]), np.array([0.03, 0.19, 0.42])
    for k, ((x, bound, traction), title) in enumerate(zip(lines, titles)):
        color = tuple(pale + (dark - pale) * k / max(len(lines) - 1, 1))
        for sign in (-1, 1):
            axes.plot(x, sign * bound, color=color, linewidth=0.6, linestyle=":")
        axes.plot(x, traction, color=color, label=title)
    axes.axhline(0, color="0.6", linewidth=0.6)
    axes.set(xlabel="x [mm], rolling to the right", ylabel="traction [N/mm²]")
    axes.legend(fontsize="small", title="bound dotted", loc="upper left", bbox_to_anchor=(1, 1), frameon=False)
    return axes


def plot_result(result: Any, axes: Any = None) -> Any:
    """Draws a result, see Result.plot."""
    table, history = result.traction, result.history if axes is None else None
    both = _new_axes(1 if history is None else 2) if axes is None else axes
    first = both if history is None else both[0]
    is_patch = "traction_x" in table.dtype.names
    if is_patch:
        plot_patch(PatchFields(*(result.field(name) for name in ("x", "y", "traction", "slips"))),
                   result.tables["edges"].data, first)
    else:
        plot_traction(table["x"], table["bound"], table["traction"], first)
    if history is not None:
        name = "q" if "q" in history.dtype.names else "X"
        both[1].plot(history[name], history["force"], label="along")
        both[1].set(xlabel=f"distance rolled [{result.units[name]}]", ylabel=f"force [{result.units['force']}]")
        if is_patch:
            both[1].plot(history[name], history["lateral_force"], label="across")
            both[1].legend()
    return both


def with_unit(unit: str) -> str:
    """A unit behind a number."""
    return "" if unit == "1" else f" {unit}"


_OF_PATCH = {"force": "force along", "lateral_force": "force across", "spin_moment": "moment"}
_ALONG = {"creepage": "force", "lateral_creepage": "lateral_force", "spin": "spin_moment"}
_LAWS = {"fastsim": ("FASTSIM", ":"), "fastsim_one": ("FASTSIM, one flexibility", (0, (3, 1, 1, 1))),
         "vermeulen_johnson": ("Vermeulen and Johnson", "--"), "polach": ("Polach", "-.")}


def plot_patch_curves(curves: Any, names: Any, axes: Any = None) -> Any:
    """Draws resultants over a motion, those of each curve in a colour of its own, and those of laws in other dashes.

    names  of the curves; empty for one alone
    """
    first = curves[0]
    size = np.sqrt(first.summary["half_width"] * first.summary["lateral_half_width"])
    drawn = [_ALONG[first.along]]
    if axes is None:  # the others where they are more than rounding
        drawn = [name for name in _OF_PATCH if name in drawn or max(
            np.abs(getattr(curve, name)).max() for curve in curves) > 1e-6 * first.full_sliding * (
                size if name == "spin_moment" else 1)]
    panels = np.atleast_1d(_new_axes(len(drawn))) if axes is None else [axes]
    factor, unit = (1, "1/mm") if first.along == "spin" else (100, "%")
    for panel, of in zip(panels, drawn):
        for curve, name in zip(curves, names):
            motions = factor * getattr(curve, curve.along)
            (line,) = panel.plot(motions, getattr(curve, of), label=name or "steady rolling")
            for law, values in curve.beside.items():
                if of in values.dtype.names:
                    title, dashes = _LAWS[law]
                    error = f", error {curve.summary[f'{law}_error']:.2g} of full sliding"
                    alone = len(curves) == 1
                    panel.plot(motions, values[of], linestyle=dashes, color=None if alone else line.get_color(),
                               label=title + error if alone else title if curve is first else None)
        panel.set(xlabel=f"{first.along.replace('_', ' ')} [{unit}]",
                  ylabel=f"{_OF_PATCH[of]} [{first.units[of]}]")
    panels[0].legend(fontsize="small", **({"loc": "lower left", "bbox_to_anchor": (0, 1)} if any(
        curve.beside for curve in curves) else {}))
    return panels if axes is None else axes


def plot_curve(steady: Any, axes: Any = None) -> Any:
    """Draws |F| over |w|, with full sliding."""
    axes = _new_axes() if axes is None else axes
    (line,) = axes.plot(100 * np.abs(steady.creepage), np.abs(steady.force), label="steady rolling")
    line.sticky_edges.x[:] = line.sticky_edges.y[:] = [0]  # axes begin there, and still grow with other curves
    if steady.fastsim_force is not None:
        axes.plot(100 * np.abs(steady.creepage), np.abs(steady.fastsim_force), linestyle=":", color=line.get_color(),
                  label="FASTSIM")
    axes.axhline(steady.full_sliding, color="0.6", linewidth=0.8, linestyle="--", label="full sliding")
    axes.set(xlabel="size of the creepage [%]", ylabel="size of the force [N/mm]")
    axes.autoscale_view()
    axes.legend()
    return axes
