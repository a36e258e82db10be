# SPDX-License-Identifier: GPL-3.0-or-later
"""Friction that falls with slip: the tables of the program, speeds, second solutions, copies, and what is refused."""
import numpy as np
import pytest

import microslip as ms

LAW = {"friction_law": "exponential", "kinetic_ratio": 0.6, "half_speed": 100, "friction_memory": 0.002}
STEEL = {"shear_modulus": 82000, "poisson_ratio": 0.28}
LINE = {"material": STEEL, "contact": {"half_width": 4, "peak_traction": 148.6, **LAW},
        "kernel": {"type": "plane", "length": 200}, "grid": {"elements": 41}, "load": {"speed": "45 m/s"}}
ELLIPSE = {"material": STEEL, "contact": {"half_width": 4, "lateral_half_width": 5, "peak_traction": 148.6, **LAW},
           "grid": {"rows": 5, "elements": 8}, "load": {"speed": "45 m/s"}}
KINDS = [(ms.Rolling, LINE), (ms.Patch, ELLIPSE)]
RUN = {"problem": "transient", "start": {"type": "rest"}, "motion": {"distance": 6}}


def without_memory(scene):
    contact = {key: value for key, value in scene["contact"].items() if key != "friction_memory"}
    return {**scene, "contact": contact}


@pytest.mark.parametrize("kind, scene", KINDS)
def test_steps_are_those_of_the_program(kind, scene):
    run = ms.solve({**scene, **RUN, "step": {"ratio": 0.5}, "load": {"speed": "45 m/s", "creepage": -0.001}})
    rolling = kind(scene)
    states = rolling.roll(np.diff(run.history["q"]), creepage=-0.001)
    assert states["force"][-1] == pytest.approx(run.summary["force"], rel=1e-9)
    assert not rolling.second_solution


@pytest.mark.parametrize("kind, scene", KINDS)
def test_a_slower_wheel_has_more_friction(kind, scene):
    fast, slow = kind(scene), kind(scene)
    slow.set_speed(9000)
    assert slow.roll(np.full(40, 0.4), creepage=-0.002)["force"][-1] \
        > 1.01 * fast.roll(np.full(40, 0.4), creepage=-0.002)["force"][-1]
    with pytest.raises(ms.InputError, match="speed = 0"):
        slow.set_speed(0)


@pytest.mark.parametrize("kind, scene", KINDS)
def test_second_solutions_are_told_and_copied(kind, scene):
    rolling = kind(without_memory(scene))
    for _ in range(200):
        rolling.roll(0.05, creepage=-0.001)
        if rolling.second_solution:
            break
    assert rolling.second_solution
    assert kind.copy(rolling).second_solution


@pytest.mark.parametrize("kind, scene", KINDS)
def test_what_has_no_such_friction_is_refused(kind, scene):
    rolling = kind(scene)
    rolling.roll(0.4, creepage=-0.001)
    with pytest.raises(ms.InputError, match="friction_law: expected none"):
        rolling.roll(-0.4, creepage=-0.001)
    with pytest.raises(ms.InputError, match="friction_law: expected none"):
        rolling.attempt(0.4, creepage=-0.001, jacobian=True)


@pytest.mark.parametrize("scene", [LINE, ELLIPSE])
def test_steady_forces_are_those_of_the_program(scene):
    creepages = [-0.0005, -0.001, -0.002]
    found = ms.steady(scene, creepage=creepages, **({"problem": "steady"} if scene is LINE else {}))
    for creepage, force in zip(creepages, found.force):
        solved = ms.solve({**scene, "problem": "steady", "load": {"speed": "45 m/s", "creepage": creepage}})
        assert force == pytest.approx(solved.summary["force"], rel=1e-8)


@pytest.mark.parametrize("kind, scene", KINDS)
def test_a_law_of_arrays_is_that_of_a_file(kind, scene, tmp_path):
    speed, ratio = np.array([0, 50.0, 400]), np.array([1, 0.8, 0.55])
    file = tmp_path / "law.tsv"
    np.savetxt(file, np.c_[speed, ratio], fmt="%.17g", delimiter="\t", header="speed\tratio", comments="")
    bodies = {key: value for key, value in scene["contact"].items() if key not in LAW}

    def forces(law):
        contact = {**bodies, "friction_law": "table", "friction_file": law, "friction_memory": 0.002}
        return kind({**scene, "contact": contact}).roll(np.full(5, 0.4), creepage=-0.004)["force"]

    assert np.array_equal(forces((speed, ratio)), forces(str(file)))
    with pytest.raises(ms.InputError, match="or the arrays .speed, ratio."):
        forces(ratio)
