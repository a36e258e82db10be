# SPDX-License-Identifier: GPL-3.0-or-later
"""Steady rolling under many loads, curves and sweeps."""
import warnings

import numpy as np
import pytest

import microslip as ms

FULL, COMPLIANCE = np.pi / 2 * 5 * 300, 2 * (1 - 0.28) / 82000


def carter_creepage(force):
    """Carter's closed form; a positive creepage has a negative force."""
    return -np.sign(force) * (1 - np.sqrt(1 - np.abs(force) / FULL)) * COMPLIANCE * 300


def carter_traction(x, force):
    """The difference of two ellipses."""
    stick = np.sqrt(1 - abs(force) / FULL)
    whole = np.sqrt(np.maximum(0, 1 - (x / 5) ** 2))
    part = stick * np.sqrt(np.maximum(0, 1 - ((x / 5 - 1 + stick) / stick) ** 2))
    return np.sign(force) * 300 * (whole - part)


def test_it_is_carters(plane, random):
    forces = random.uniform(-0.999, 0.999, (3, 7)) * FULL
    result = ms.steady(plane, force=forces)
    assert result.creepage.shape == (3, 7) and result.traction.shape == (3, 7, 40)
    assert np.allclose(result.creepage, carter_creepage(forces), rtol=1e-9)
    assert np.allclose(result.dissipation, -forces * result.creepage, rtol=1e-9)
    exact = np.array([[carter_traction(x, force) for x, force in zip(*rows)] for rows in zip(result.x, forces)])
    assert np.allclose(result.traction, exact, atol=1e-7 * 300)
    back = ms.steady(plane, creepage=result.creepage)
    assert np.allclose(back.force, forces, rtol=1e-9)
    assert np.all(result.states["violation"] < 1e-9) and np.all(result.states["status"] == 0)
    assert result.full_sliding == pytest.approx(FULL, rel=1e-12)


def test_one_load_has_no_dimension(plane):
    result = ms.steady(plane, force=-1000)
    assert result.force.shape == () and result.traction.shape == (40,) and len(result) == 1
    assert float(result.creepage) == pytest.approx(carter_creepage(-1000), rel=1e-9)
    assert "creepage = 0.00" in repr(result)


def test_threads_change_nothing(scene, random):
    creepages = random.uniform(-3e-3, 3e-3, 50)
    first, *others = (ms.steady(scene, creepage=creepages, threads=threads) for threads in (1, 2, 5))
    for other in others:
        assert np.array_equal(other.force, first.force) and np.array_equal(other.traction, first.traction)


def test_it_is_what_solve_says_whatever_the_method(scene):
    for method in ({}, {"leading_edge": "calibrated"}, {"leading_edge": "standard", "step_ratio": 0.7},
                   {"method": "chebyshev"}):
        problem = {**scene, "problem": "steady", "load.force": 3}
        one = ms.solve(problem, **method, load_force=-800)
        many = ms.steady(problem, **method, force=[-800])
        assert many.creepage[0] == one.summary["creepage"]
        assert np.array_equal(many.traction[0], one.traction["traction"])
    transient = {**scene, "problem": "transient", "load.creepage": 1, "step.ratio": 0.3, "step.scheme": "direct",
                 "motion.distance": 5, "start.type": "rest"}
    assert ms.steady(transient, force=-800).creepage == ms.steady(scene, force=-800).creepage


def test_bodies_of_different_material_creep_without_a_force(plane):
    unlike = {**plane, "material": {"shear_modulus": 3000, "poisson_ratio": 0.3, "dundurs_beta": 0.2},
              "contact": {"half_width": 5, "peak_traction": 300, "friction": 0.3}}
    result = ms.steady(unlike, force=0)
    assert abs(result.creepage) > 1e-4 and result.states["method"] == 0
    assert result.creepage == ms.solve(unlike, problem="steady", load_force=0).summary["creepage"]


@pytest.mark.parametrize("given, message", [
    ({}, "^creepage: expected either creepages or forces"),
    ({"creepage": 1, "force": 1}, "^creepage: expected either creepages or forces"),
    ({"force": [1, 1e6]}, "^load 1: .*force = 1e\\+06: expected an absolute value below full sliding"),
    ({"creepage": np.nan}, "creepage = nan: expected a finite number"),
    ({"creepage": "much"}, "^creepage = 'much': expected numbers"),
    ({"force": 1, "threads": 0}, "^threads = 0: expected a whole number >= 1"),
    ({"force": 1, "missing": "no"}, "^missing = 'no': expected 'raise' or 'nan'"),
    ({"force": 1, "target_error": 1e-3}, "target_error"),
    ({"force": 1, "grid_elemnts": 5}, "unknown key 'grid.elemnts'"),
    ({"crepage": 1}, r"^crepage: expected an argument, or a key of scenes \(did you mean 'creepage'\?\)"),
    ({"lateral_Creepage": 1}, r"^lateral_Creepage: .*did you mean 'lateral_creepage'"),
    ({"force": 1, "thread": 2}, r"^thread: .*did you mean 'threads'")])
def test_bad_input_is_named(scene, given, message):
    with pytest.raises(ms.InputError, match=message):
        ms.steady(scene, **given)


def test_loads_without_solution_are_errors_or_nan(scene):
    strict = {**scene, "solver.condition": 20}
    forces = np.array([-300, -2300])
    with pytest.raises(ms.NoSolution, match="^load 0: .*condition is .*: expected at most"):
        ms.steady(strict, force=forces)
    result = ms.steady(strict, force=forces, missing="nan")
    assert np.isnan(result.creepage[0]) and np.isnan(result.traction[0]).all()
    assert result.states["status"].tolist() == [2, 0] and "condition" in result.messages[0]
    with pytest.raises(ms.InputError):
        ms.steady(strict, force=[-300, 1e6], missing="nan")


def test_fastsim_is_beside_the_curve_as_the_program_has_it(plane, random):
    for _ in range(5):
        contact = {**plane, "contact": {"half_width": random.uniform(1, 9), "peak_traction": random.uniform(50, 500)}}
        curve = ms.creep_curve(contact, points=30, beside="fastsim")
        full = curve.full_sliding
        assert curve.fastsim_force[0] == 0 and np.all(np.diff(curve.fastsim_force) <= 0)
        deviation = (curve.fastsim_force - curve.force) / full
        assert deviation.min() > -1e-9 and 0.05 < deviation.max() <= 1 / 16 + 1e-6  # Carter's less FASTSIM's
        # Kalker's slope, of the first part in which next to nothing slips: |F| = F_max (1 - (1 - w/w_slide)^2)
        slide = 2 * (1 - 0.28) * contact["contact"]["peak_traction"] / 82000
        xi = np.minimum(1, 2 * curve.creepage / slide / 3)
        assert np.allclose(-curve.fastsim_force / full, 3 * xi - 3 * xi**2 + xi**3, atol=1e-6)
    assert ms.creep_curve(plane, points=5).fastsim_force is None
    with pytest.raises(ms.InputError, match="^beside = 'contact': expected None or 'fastsim'"):
        ms.creep_curve(plane, beside="contact")
    with pytest.raises(ms.InputError, match="^beside = 'fastsim': expected None for bodies of different material"):
        ms.creep_curve(plane, beside="fastsim", material={"dundurs_beta": 0.2}, contact_friction=0.3)


@pytest.mark.parametrize("points", [5, 12, 41])
def test_a_curve_rises_to_full_sliding_and_stays_there(plane, points):
    told = []
    curve = ms.creep_curve(plane, points=points, progress=lambda done, total: told.append((done, total)))
    assert len(curve) == points and told
    assert np.all(np.diff(curve.creepage) > 0) and np.all(np.diff(curve.force) <= 0)
    assert curve.force[0] == 0 and curve.force[-1] == pytest.approx(-FULL, rel=1e-12)
    below = curve.creepage < COMPLIANCE * 300
    assert np.allclose(curve.creepage[below], carter_creepage(curve.force[below]), rtol=1e-9)
    for wrong in ({"points": 4}, {"points": 5.5}, {"most": 1}, {"most": np.nan}):
        with pytest.raises(ms.InputError, match=f"^{list(wrong)[0]} = "):
            ms.creep_curve(plane, **wrong)
    for load in ("creepage", "force"):
        with pytest.raises(ms.InputError, match=f"^{load}: expected no loads.*ms.steady"):
            ms.creep_curve(plane, **{load: [0.001]})


def test_a_sweep_is_its_cases_one_by_one(scene):
    told = []
    over = {"load.force": np.array([-300.0, -900.0]), "contact.half_width": ["4 mm", "5 mm", "6 mm"]}
    sweep = ms.sweep(scene, over, problem="steady", threads=2, progress=lambda *counts: told.append(counts))
    assert sorted(told) == [(k, 6) for k in range(1, 7)]
    assert sweep.keys == ["load.force", "contact.half_width"] and len(sweep) == 6
    assert sweep["load.force"].tolist() == [-300] * 3 + [-900] * 3
    assert sweep["contact.half_width"].tolist() == [4, 5, 6] * 2 and sweep.units["contact.half_width"] == "mm"
    for case in sweep.cases:
        one = ms.solve(scene, problem="steady", load_force=case["load.force"],
                       contact_half_width=case["contact.half_width"])
        assert one.summary["creepage"] == case["creepage"]
    assert sweep[4].summary["creepage"] == sweep["creepage"][4]
    assert "6 cases" in repr(sweep) and "<table>" in sweep._repr_html_()


def test_sweeps_of_scenes_and_ranges(source, scene):
    sweep = ms.sweep(source / "examples/sweep.info", threads=2)
    assert len(sweep) == np.prod([len(set(sweep[key])) for key in sweep.keys])
    ranges = ms.sweep(scene, {"load.force": "-1000:250:-250"}, problem="steady")
    assert ranges["load.force"].tolist() == [-1000, -750, -500, -250]
    with pytest.raises(ms.InputError, match="sweep"):
        ms.sweep(scene, problem="steady", load_force=1)
    with pytest.raises(ms.InputError, match=r"case 2 of 2 \(grid.elements = x\): grid.elements = 'x'") as caught:
        ms.sweep(scene, {"grid.elements": [10, "x"]}, problem="steady", load_force=1)
    assert caught.value.key == "grid.elements"


def test_a_case_without_solution_is_nan_or_an_error(scene):
    given = {"problem": "steady", "solver_condition": 20, "over": {"load.force": [-300, -2300]}}
    sweep = ms.sweep(scene, **given)
    assert sweep.results[0] is None and "condition" in sweep.errors[0] and sweep.errors[1] == ""
    assert np.isnan(sweep["creepage"][0]) and sweep["creepage"][1] > 0
    with pytest.raises(ms.NoSolution):
        ms.sweep(scene, **given, missing="raise")


def test_an_interrupt_ends_a_sweep(scene):
    def stop(done, total):
        raise KeyboardInterrupt

    long = {**scene, "problem": "transient", "motion.distance": 2000, "step.ratio": 0.1, "start.type": "rest"}
    with pytest.raises(KeyboardInterrupt):
        ms.sweep(long, {"load.creepage": [1e-3] * 40, "motion.distance": [1] + [5000] * 1}, threads=2, progress=stop)


def test_large_creepages_are_warned_of(scene):
    small = {"material": {"shear_modulus": 1, "poisson_ratio": 0}, "contact": {"half_width": 1, "peak_traction": 1},
             "kernel": {"type": "plane", "length": 10}, "grid": {"elements": 20}}
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        ms.steady(scene, creepage=[0.1, -0.2])
        ms.steady(small, creepage=0.9)
        ms.creep_curve(scene)
    with pytest.warns(ms.LoadWarning, match="^creepage = -0.9: creepages above 0.2 are not small") as told:
        ms.steady(scene, creepage=[[0.3, -0.9], [0.001, 0]])
    assert len(told) == 1 and told[0].filename == __file__


def test_warnings_of_a_sweep_are_counted(scene):
    with pytest.warns(ms.LoadWarning) as told:
        ms.sweep(scene, {"load.creepage": [0.001, 0.3, 0.5, 1e10]}, problem="steady")
    assert [str(one.message).split(": creepages")[0] for one in told] == [
        "3 of 4 cases, the first is case 1: load.creepage = 0.3"]
    assert told[0].filename == __file__


def test_errors_of_rough_bounds_name_their_key(scene):
    with pytest.raises(ms.InputError) as told:
        ms.sweep(scene, {"contact.roughness": [0.1, 11]}, problem="steady", load_force=-100)
    assert "contact.roughness = 11" in str(told.value)
