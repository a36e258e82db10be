# SPDX-License-Identifier: GPL-3.0-or-later
"""Curves of ellipses are those of the program, and families are curves one by one."""
import os
import subprocess

import numpy as np
import pytest

import microslip as ms

COMMON = {"grid.rows": "6", "grid.elements": "8", "curve.points": "7"}


@pytest.mark.parametrize("along, changes", [
    ("creepage", {"curve.beside": "fastsim fastsim_one vermeulen_johnson polach"}),
    ("lateral_creepage", {"curve.largest": "0.004", "curve.beside": "polach", "curve.kalker_factor": "0.6"}),
    ("spin", {"curve.spins": "0 1e-4 3e-4", "curve.points": None})])
def test_curves_are_those_of_the_program_to_the_byte(along, changes, source, tmp_path):
    file = source / "examples/ellipse.info"
    keys = {key: value for key, value in {**COMMON, **changes}.items() if value is not None}
    subprocess.run([os.environ["MICROSLIP"], "curve", file, "--along", along, "--out", tmp_path / "out", "--quiet",
                    *(f"--set={key}={value}" for key, value in keys.items())], check=True)
    laws = keys.pop("curve.beside", "").split()
    curve = ms.creep_curve(file, along=along, beside=laws, points=keys.pop("curve.points", None), **keys)
    curve.write(tmp_path / "here")
    assert sorted(os.listdir(tmp_path / "here")) == ["curve.tsv", "summary.tsv"]
    for name in ("curve", "summary"):
        here, there = ((tmp_path / folder / f"{name}.tsv").read_text() for folder in ("here", "out"))
        assert here.partition("# columns")[2] == there.partition("# columns")[2]
    assert curve.along == along and list(curve.beside) == laws and len(curve) == len(curve.force)
    table = ms.read_table(tmp_path / "out/curve.tsv")
    for name in ("creepage", "lateral_creepage", "spin", "force", "lateral_force", "spin_moment", "slip_share", "change"):
        assert np.array_equal(getattr(curve, name), table[name])
    for law in laws:
        off = np.hypot(curve.beside[law]["force"] - curve.force, curve.beside[law]["lateral_force"] - curve.lateral_force)
        assert np.allclose(curve.beside[law]["error"], off / curve.full_sliding, atol=1e-12)
        assert ("spin_moment" in curve.beside[law].dtype.names) == law.startswith("fastsim")
        assert curve.summary[f"{law}_error"] == curve.beside[law]["error"].max()


def test_a_curve_is_steady_rolling_at_its_points(ellipse):
    curve = ms.creep_curve(ellipse, load={"force": -6000, "spin": 1e-4}, along="lateral_creepage", points=9)
    each = ms.steady(ellipse, force=-6000, spin=1e-4, lateral_creepage=curve.lateral_creepage)
    for name in ("lateral_force", "spin_moment", "creepage"):  # another start of Newton's method
        scale = {"creepage": 1e-2, "lateral_force": 24000, "spin_moment": 24000 * 5}[name]
        assert np.abs(getattr(curve, name) - getattr(each, name)).max() < 1e-5 * scale
    assert np.all(curve.force == pytest.approx(-6000)) and curve.lateral_creepage[0] < 0 < curve.lateral_creepage[-1]


def test_the_problem_and_steps_of_a_scene_are_left_out(source):
    few = {"grid": {"rows": 4, "elements": 5}, "points": 3}
    curve = ms.creep_curve(source / "examples/ellipse_transient.info", **few)
    assert curve.lateral_force.max() == pytest.approx(2000) and curve.spin.tolist() == [1e-4] * 3


def test_families_are_curves_one_by_one(ellipse):
    told = []
    over = {"load.spin": [0, 1e-4], "contact.friction": [0.2, 0.3, 0.4]}
    family = ms.creep_curve(ellipse, points=5, beside="fastsim", sweep=over, threads=2,
                            progress=lambda *counts: told.append(counts))
    assert len(family) == 6 and family.keys == list(over) and sorted(told) == [(k, 6) for k in range(1, 7)]
    for case, curve in zip(family.cases, family):
        one = ms.creep_curve(ellipse, points=5, beside="fastsim", load={"spin": case["load.spin"]},
                             contact_friction=case["contact.friction"])
        assert np.array_equal(curve.points, one.points) and curve.summary == one.summary
        assert case["fastsim_error"] == one.summary.fastsim_error
    given_twice = ms.creep_curve(ellipse, points=3, sweep={"load.spin": [0, 1e-4]}, load={"spin": 3e-4})
    assert given_twice["load.spin"].tolist() == [0, 1e-4] and given_twice[1].spin.tolist() == [1e-4] * 3
    assert "6 curves" in repr(family) and "<table>" in family._repr_html_()


def test_figures_have_the_resultants_that_are_not_zero(ellipse):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    alone = ms.creep_curve(ellipse, points=5)
    assert [axes.get_ylabel() for axes in alone.plot()] == ["force along [N]"]
    curve = ms.creep_curve(ellipse, points=5, load={"spin": 1e-4}, beside=["fastsim", "polach"])
    panels = curve.plot()
    assert [axes.get_ylabel() for axes in panels] == ["force along [N]", "force across [N]", "moment [N mm]"]
    assert [len(axes.lines) for axes in panels] == [3, 3, 2]  # Polach's law has no moment
    drawn = panels[0].lines[1]
    assert np.array_equal(drawn.get_ydata(), curve.beside["fastsim"]["force"])
    assert f"FASTSIM, error {curve.summary.fastsim_error:.2g} of full sliding" in drawn.get_label()
    family = ms.creep_curve(ellipse, points=5, sweep={"load.spin": [0, 1e-4]})
    assert [line.get_label() for line in family.plot()[0].lines] == ["load.spin = 0", "load.spin = 0.0001"]
    _, axes = matplotlib.pyplot.subplots()
    assert family.plot(axes) is axes and len(axes.lines) == 2
    matplotlib.pyplot.close("all")


@pytest.mark.parametrize("given, message", [
    ({"along": "up"}, "^along = 'up': expected 'creepage' or 'lateral_creepage' or 'spin'"),
    ({"beside": "carter"}, "^beside = 'carter': expected 'fastsim' or"),
    ({"beside": ["polach", "carter"]}, "^beside = 'carter': expected 'fastsim' or"),
    ({"points": 1}, "^curve.points = 1: expected 2 ... 10000|^curve.points = 1: expected"),
    ({"points": 5, "curve_points": 5}, "^points: expected this argument or curve.points, not both"),
    ({"most": 0.9}, "^most = 0.9: expected none|^most: expected none for an ellipse"),
    ({"creepage": [1, 2]}, "^creepage: expected load.creepage for a load that stays, or curve.creepages"),
    ({"spin": [1, 2]}, "^spin: expected load.spin for a load that stays, or curve.creepages"),
    ({"curve": {"creepages": [1e-3, 0]}}, "^curve.creepages = .*in rising order"),
    ({"curve": {"spins": [0, 1e-3]}}, "curve.spins"),
    ({"grid_elemnts": 3}, "unknown key 'grid.elemnts'"),
    ({"threads": 0}, "^threads = 0: expected a whole number >= 1"),
    ({"sweep": 3}, "sweep"),
    ({"sweep": {"grid.rows": [4, "x"]}}, r"case 2 of 2 \(grid.rows = x\): grid.rows = 'x'")])
def test_bad_input_is_named(ellipse, given, message):
    with pytest.raises(ms.InputError, match=message):
        ms.creep_curve(ellipse, **given)


def test_line_contacts_have_their_own_curves(scene):
    assert isinstance(ms.creep_curve(scene, points=5, along="creepage"), ms.Steady)
    with pytest.raises(ms.InputError, match="^along = 'spin': expected 'creepage' of a line contact"):
        ms.creep_curve(scene, along="spin")
    with pytest.raises(ms.InputError, match="^beside = 'polach': expected None or 'fastsim'"):
        ms.creep_curve(scene, beside="polach")


def test_points_without_solution_are_named(ellipse):
    with pytest.raises(ms.NoSolution, match="^lateral_creepage "):
        ms.creep_curve(ellipse, load={"force": -21600, "spin_moment": 54000}, along="lateral_creepage", points=3)


def test_large_motions_are_warned_of(ellipse):
    with pytest.warns(ms.LoadWarning, match="curve.creepages = 0.3: creepages above 0.2") as told:
        ms.creep_curve(ellipse, curve={"creepages": [0, 0.3]})
    assert told[0].filename == __file__
    with pytest.warns(ms.LoadWarning, match="2 of 2 cases, the first is case 0: curve.creepages = 0.3") as told:
        ms.creep_curve(ellipse, curve={"creepages": [0, 0.3]}, sweep={"load.spin": [0, 1e-4]})
    assert told[0].filename == __file__
