# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes are solved as the program solves them, however they are given."""
import concurrent.futures
import os
import pathlib
import pickle
import subprocess

import numpy as np
import pytest

import microslip as ms

EXAMPLES = ("steady", "line", "ellipse", "transient", "ellipse_transient", "cylinder", "run")


@pytest.mark.parametrize("name", EXAMPLES)
def test_tables_are_those_of_the_program_to_the_byte(name, source, tmp_path):
    file = source / "examples" / f"{name}.info"
    changes = {"grid.elements": "30"}
    if name == "cylinder":
        changes["motion.distance"] = "2"
    elif name.startswith("ellipse"):
        changes = {"grid.rows": "6", "grid.elements": "8"}
    elif name == "run":
        changes["motion.distance"] = "300"
    options = [f"--set={key}={value}" for key, value in changes.items()]
    subprocess.run([os.environ["MICROSLIP"], file, "--out", tmp_path / "out", *options], check=True)
    result = ms.solve(file, **changes)
    result.write(tmp_path / "here")
    tables = sorted(path.name for path in (tmp_path / "out").glob("*.tsv"))
    assert tables == sorted(f"{table}.tsv" for table in result.tables)
    for table in tables:
        assert (tmp_path / "here" / table).read_bytes() == (tmp_path / "out" / table).read_bytes()


def test_a_scene_is_a_file_a_text_a_dictionary_or_arguments(source):
    file = source / "examples/steady.info"
    text = file.read_text()
    keys = {"problem": "steady", "material": {"shear_modulus": "82 GPa", "poisson_ratio": 0.28},
            "contact": {"half_width": "5 mm", "peak_traction": 300}, "kernel": {"type": "strip", "width": 10},
            "grid.elements": np.int64(100), "load": {"force": np.float32(-1500)}}
    expected = ms.solve(file)
    for result in (ms.solve(str(file)), ms.solve(text), ms.solve(keys), ms.solve(**keys),
                   ms.solve(file, load_force=-1500), ms.solve(file, load={"force": "-1.5 kN/mm"}),
                   ms.solve(file, load_force=None, load_force_ratio=-1500 / expected.summary["full_sliding_force"])):
        assert result.summary["creepage"] == pytest.approx(expected.summary["creepage"], rel=1e-12)
        assert np.allclose(result.traction["traction"], expected.traction["traction"])


def test_relative_files_are_those_beside_the_scene(source, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    result = ms.solve(source / "examples/run.info", motion_distance=100, grid_elements=20)
    assert "t" in result.history.dtype.names


def test_fields_units_and_evidence(scene):
    result = ms.solve(scene, problem="transient", load={"creepage": 0.002}, motion={"distance": 5}, step={"ratio": 0.5},
                      start={"type": "rest"})
    assert result.summary.force == result.summary["force"] == result.history["force"][-1]
    assert result.units["force"] == "N/mm" and result.units["q"] == "mm" and result.units["traction"] == "N/mm^2"
    assert set(result.traction["region"]) == {"A", "S"}
    assert result.evidence["residual"] < 1e-10 and result.warnings == []
    assert result.parameters["step.scheme"] == "remembered"
    assert result.shifts is None and ms.solve(scene, problem="steady", load_force=1).history is None
    assert "force" in repr(result) and "<table>" in result._repr_html_()
    for name, unit in result.units.items():  # one unit a name
        assert all(table.units.get(name, unit) == unit for table in result.tables.values())


def test_instants_end_with_the_traction(scene):
    rolling = {**scene, "problem": "transient", "load": {"creepage": 0.002}, "start": {"type": "rest"}, "step": {"ratio": 0.5}}
    result = ms.solve(rolling, motion={"distance": 5, "instants": 3})
    last = result.instants[result.instants["instant"] == 3]
    assert (last["q"] == 5).all() and np.unique(result.instants["instant"]).size == 3
    for name in result.traction.dtype.names:
        assert (last[name] == result.traction[name]).all()
    assert ms.solve(rolling, motion={"distance": 5}).instants is None


def test_arrays_take_the_place_of_files(scene, tmp_path):
    x, bound = np.array([-4.5, -1, 2, 4]), np.array([20, 250, 200, 30.5])
    np.savetxt(tmp_path / "bound.tsv", np.c_[x, bound], header="x\tbound", comments="", delimiter="\t")
    common = {**scene, "problem": "steady", "load": {"force": -500}}
    named = np.rec.fromarrays([x, bound], names="x,bound")
    results = [ms.solve(common, contact={"half_width": 5, "peak_traction": None, "bound_file": given})
               for given in (tmp_path / "bound.tsv", (x, bound), np.c_[x, bound], {"x": x, "bound": bound}, named)]
    for result in results[1:]:
        assert result.summary["creepage"] == results[0].summary["creepage"]


def test_a_run_of_arrays_is_that_of_a_file(source):
    """With units in the names of columns, or in the table that was read; numbers alone are in mm, N and s."""
    table = ms.read_table(source / "examples/run.tsv")
    assert table.units["v"] == "km/h"
    rows = {"t": table["t"], "v [km/h]": table["v"], "omega[rad/s]": table["omega"],
            "normal_load": table["normal_load"]}  # kN/m is N/mm
    few = {"grid_elements": 20, "motion_distance": 400}
    by_file = ms.solve(source / "examples/run.info", **few)
    for given in (table, rows, {**rows, "v [km/h]": None, "v": table["v"] / 3.6 * 1e3}):
        given = {name: value for name, value in given.items() if value is not None} if given is not table else table
        by_arrays = ms.solve(source / "examples/run.info", load_file=given, **few)
        assert by_arrays.summary["force"] == pytest.approx(by_file.summary["force"], rel=1e-9)


def test_an_accuracy_may_be_asked_for(plane):
    grid_free = {key: value for key, value in plane.items() if key != "grid"}
    result = ms.solve(grid_free, problem="steady", target_error=1e-6, load_force=-1000)
    full, compliance = np.pi / 2 * 5 * 300, 2 * (1 - 0.28) / 82000
    carter = (1 - np.sqrt(1 - 1000 / full)) * compliance * 300
    assert result.summary["creepage"] == pytest.approx(carter, rel=1e-6)


@pytest.mark.parametrize("change, key, value, expected", [
    ({"material": {"shear_modulus": 0}}, "material.shear_modulus", "0", "a number > 0"),
    ({"contact": {"half_width": "5 kg"}}, "contact.half_width", "5 kg", "a number in mm or another"),
    ({"grid_elements": 3.5}, "grid.elements", "3.5", "a whole number"),
    ({"grid_elements": float("nan")}, "grid.elements", "nan", "a whole number"),
    ({"kernel_type": "cube"}, "kernel.type", "cube", "strip or plane"),
    ({"load_force": 1e9}, "load.force", "1e+09", "an absolute value below full sliding"),
    ({"load_force": True}, "load.force", "True", "a number, a text"),
    ({"load_force": object}, "load.force", "<class 'object'>", "a number, a text"),
    ({"grid_elemnts": 3}, "grid.elemnts", "", "did you mean 'grid.elements'"),
    ({"load_creepage": 1}, "load.creepage", "", "None takes a key away"),
    ({"sweep": {"load.force": [1, 2]}}, "sweep.load.force", "", "microslip.sweep"),
    ({"load_force": None}, "load.creepage", "", "load.force"),
    ({"contact_bound_file": (1, 2, 3)}, "contact.bound_file", "(1, 2, 3)", "(x, bound)"),
    ({"contact": {"peak_traction": None, "bound_file": ([0, 1], [2])}}, "contact.bound_file", "", "the same length"),
    ({"contact": {"peak_traction": None, "bound_file": ([1, 0], [2, 3])}}, "contact.bound_file", "", "ascending"),
    ({"contact": {"peak_traction": None, "bound_file": "none.tsv"}}, "contact.bound_file", "none.tsv", "cannot read"),
])
def test_errors_name_key_value_and_what_is_accepted(scene, change, key, value, expected):
    given = {**scene, "problem": "steady", "load": {"force": -1000}}
    with pytest.raises(ValueError) as caught:
        ms.solve(given, **change)
    error = caught.value
    assert isinstance(error, ms.InputError)
    assert error.key == key
    assert value in error.value
    assert expected in error.expected
    assert "\n" not in str(error)
    again = pickle.loads(pickle.dumps(error))
    assert (str(again), again.key, again.expected) == (str(error), error.key, error.expected)


def test_errors_of_files_name_them_and_the_line(source, tmp_path):
    with pytest.raises(ms.InputError, match="^scene 'none.info': cannot read it: No such file"):
        ms.solve("none.info")
    file = tmp_path / "a.info"
    file.write_text((source / "examples/steady.info").read_text().replace("elements 100", "elements x"))
    with pytest.raises(ms.InputError, match=r"a\.info:\d+: grid\.elements = 'x': expected a whole number") as caught:
        ms.solve(file)
    assert (caught.value.key, caught.value.value) == ("grid.elements", "x")
    for scene in (5, b"problem steady"):
        with pytest.raises(ms.InputError, match="expected a file's name, a text or a dictionary"):
            ms.solve(scene)


def test_no_solution_is_an_error_of_its_own(scene):
    with pytest.raises(ms.NoSolution, match="condition is .*: expected at most"):
        ms.solve(scene, problem="steady", load_force=-1000, solver_condition=1)


def test_doubts_are_warnings(scene):
    with pytest.warns(ms.LoadWarning, match="step.ratio = 0.001: this scheme is safe"):
        result = ms.solve(scene, problem="steady", leading_edge="standard", step_ratio=1e-3, load_force=-1000)
    assert any(line.startswith("step.ratio") for line in result.warnings)


def test_progress_counts_to_the_end_and_can_stop(scene, capsys):
    long = {**scene, "problem": "transient", "load.creepage": 0.002, "motion.distance": 25000, "step.ratio": 0.1,
            "start.type": "rest"}  # seconds on any machine, unless it is stopped
    told = []

    def tell(done, total):
        told.append((done, total))
        if len(told) == 3:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        ms.solve(long, progress=tell)
    assert len(told) == 3 and all(0 < done < total == 1000000 for done, total in told)
    ms.solve(long, motion_distance=3000, progress=True)  # takes seconds
    assert "microslip: " in capsys.readouterr().err


def test_several_threads_solve_at_once(scene):
    def force(creepage):
        return ms.solve(scene, problem="steady", load_creepage=creepage).summary["force"]

    creepages = np.linspace(1e-4, 3e-3, 24)
    with concurrent.futures.ThreadPoolExecutor(4) as pool:
        assert list(pool.map(force, creepages)) == list(map(force, creepages))


def test_states_of_rolling_start_a_scene(scene, tmp_path):
    rolling = ms.Rolling(scene)
    rolling.roll(np.full(30, 0.25), creepage=0.001)
    rolling.save(tmp_path / "a.state")
    for state in (tmp_path / "a.state", (tmp_path / "a.state").read_bytes()):
        result = ms.solve(scene, problem="transient", start={"type": "state", "state": state},
                          load={"creepage": 0.001}, step={"ratio": 1}, motion={"distance": 8.5})
        twin = rolling.copy()
        assert result.history["force"][-1] == twin.roll(np.full(4, 0.25))["force"][-1]


def test_keys_are_all_with_units():
    keys = ms.keys()
    assert keys["contact.half_width"].unit == "mm" and keys["kernel.type"].accepted == "strip, plane, winkler, symbol"
    assert set(ms.keys("load.")) == {name for name in keys if "load." in name}
    assert "load.force" in repr(keys) and "<table>" in keys._repr_html_()


def test_keys_that_are_not_there_name_the_nearest():
    for part, near in (("lod", "load"), ("contact.halfwidth", "contact.half_width"), ("Grid", "grid"),
                       ("kernal.", "kernel"), ("creepag3", "creepage")):
        with pytest.raises(ms.InputError, match=rf"^part = '{part}' \(did you mean '{near}'\?\)"):
            ms.keys(part)
    with pytest.raises(ms.InputError, match="^part = 'xyzzy': expected a part of the name of a key"):
        ms.keys("xyzzy")


def test_what_is_installed_is_typed():
    assert (pathlib.Path(ms.__file__).parent / "py.typed").exists()


@pytest.mark.parametrize("scheme", ["remembered", "direct", "relaxed"])
def test_fields_of_ellipses_have_rows_across_the_rolling(source, scene, scheme):
    result = ms.solve(source / "examples/ellipse_transient.info", grid={"rows": 6, "elements": 8}, step_scheme=scheme,
                      step_ratio=0.9, step_relaxation=None if scheme != "relaxed" else 1, motion_distance=8)
    table, x, y = result.traction, result.field("x"), result.field("y")
    assert x.shape == y.shape == (6, 8) and np.all(np.diff(x, axis=1) < 0) and np.all(np.diff(y, axis=0) > 0)
    area, traction, slips = (result.field(name) for name in ("area", "traction", "slips"))
    assert traction.shape == result.field("slip").shape == (6, 8, 2) and slips.dtype == bool
    assert np.isnan(area).any() == (scheme != "remembered") and np.nansum(area) == pytest.approx(table["area"].sum())
    for row in table:  # each is where its coordinates say
        at = np.unravel_index(np.argmin(np.hypot(x - row["x"], y - row["y"])), x.shape)
        assert abs(x[at] - row["x"]) + abs(y[at] - row["y"]) < 1e-9
        assert traction[at].tolist() == [row["traction_x"], row["traction_y"]] and slips[at] == (row["zone"] == "S")
        assert result.field("bound")[at] == row["bound"]
    with pytest.raises(ms.InputError, match="^name = 'pressure': expected traction, slip, slips, x, y, "):
        result.field("pressure")
    with pytest.raises(ms.InputError, match="^name: expected a result of an ellipse"):
        ms.solve(scene, problem="steady", load_force=1).field("x")
