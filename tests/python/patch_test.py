# SPDX-License-Identifier: GPL-3.0-or-later
"""A contact ellipse, or another patch, that rolls: steadily, by steps, copied, kept."""
import copy
import pickle
import threading
import warnings

import numpy as np
import pytest

import microslip as ms

FULL = 24000.0
COPIES = {"method": ms.Patch.copy, "copy": copy.copy, "deepcopy": copy.deepcopy,
          "twice": lambda one: copy.deepcopy([one, one])[1], "pickle": lambda one: pickle.loads(pickle.dumps(one))}
RESULTANTS, MOTIONS = ["force", "lateral_force", "spin_moment"], ["creepage", "lateral_creepage", "spin"]


def started(scene, kind=ms.Patch):
    patch = kind(scene)
    patch.shift(force=-4000)
    patch.roll(0.8, force=-6000, spin=1e-4)
    return patch


def everything(patch):
    return [patch.state.item(), patch.elastic_energy, patch.load, patch.contact,
            *(getattr(patch, name).tolist() for name in ("x", "y", "area", "bound", "traction", "slip", "slips"))]


def random_loads(random, count):
    """A component of each kind is a motion or a resultant; sizes reach well into sliding."""
    return {"creepage": random.uniform(-2e-3, 2e-3, count), "lateral_force": random.uniform(-9000, 9000, count),
            "spin": random.uniform(-3e-4, 3e-4, count)}


class Named(ms.Patch):
    """One with an attribute of its own."""

    name = property(lambda self: self.notes[0])


@pytest.mark.parametrize("make", COPIES.values(), ids=COPIES)
def test_copies_roll_on_their_own_to_the_bit(make, ellipse):
    original = started(ellipse, Named)
    original.notes = ["wheel"]
    original.set_contact(1.1, 0.9)
    other = make(original)
    assert isinstance(other, Named) and other.name == "wheel"
    assert everything(other) == everything(original)
    before = everything(other)
    original.roll(0.5)
    assert everything(other) == before
    other.roll(0.5)
    assert everything(other) == everything(original)
    assert other.state.full_sliding == pytest.approx(FULL * 1.1**2 * 0.9, rel=1e-9)


def test_slopes_without_slip_are_kalkers():
    """On a circle with nu = 0 they have closed forms: docs/ellipse.md. 5 x 5 elements have errors of 2e-4."""
    shear, size = 80000.0, 4.0
    patch = ms.Patch(material={"shear_modulus": shear, "poisson_ratio": 0},
                     contact={"half_width": size, "lateral_half_width": size, "peak_traction": 300},
                     grid={"rows": 8, "elements": 8})
    c11, c23, c33 = 32 / (3 * np.pi), 4 / 3, 512 / (135 * np.pi)
    expected = np.array([[-c11, 0, 0], [0, -c11, -c23 * size], [0, c23 * size, -c33 * size**2]]) * shear * size**2
    for slopes in (patch.steady(creepage=1e-9, jacobian=True)[1], patch.steady(spin=1e-9, jacobian=True)[1]):
        assert np.allclose(slopes, expected, rtol=2e-3, atol=1e-6 * shear * size**2)


def test_steady_rolling_is_that_of_solve_whatever_is_prescribed(ellipse, random):
    patch = ms.Patch(ellipse)
    patch.roll(1, creepage=1e-3)
    rolled = everything(patch)
    loads = random_loads(random, 4)
    states, slopes = patch.steady(**loads, jacobian=True)
    assert states.shape == (4,) and slopes.shape == (4, 3, 3) and everything(patch) == rolled
    for k, state in enumerate(states):
        solved = ms.solve(ellipse, problem="steady", load={name: load[k] for name, load in loads.items()}).summary
        for name in RESULTANTS + MOTIONS:  # another start of Newton's method
            scale = {"force": FULL, "lateral_force": FULL, "spin_moment": FULL * 5, "spin": 1e-3}.get(name, 1e-2)
            assert abs(state[name] - solved[name]) < 1e-5 * scale, name
        assert state["slip_share"] == pytest.approx(solved["slip_share"], abs=1e-9)
        assert state["full_sliding"] == pytest.approx(FULL, rel=1e-9)


def test_jacobians_are_slopes(ellipse):
    patch = started(ellipse)
    at = {"creepage": 4e-4, "lateral_creepage": -2e-4, "spin": 5e-5}
    for solve in (patch.steady, lambda **given: patch.attempt(0.7, **given)):
        _, slopes = solve(**at, jacobian=True)
        for j, name in enumerate(at):
            change = 1e-6 * (1 if j < 2 else 0.2)
            below, above = (solve(**{**at, name: at[name] + sign * change}) for sign in (-1, 1))
            found = [(above[of] - below[of]) / (2 * change) for of in RESULTANTS]
            assert np.allclose(slopes[:, j], found, rtol=0.02, atol=2e-3 * np.abs(slopes).max()), name


def test_attempts_are_steps_that_leave_all_as_it_was(ellipse):
    patch = started(ellipse)
    before = everything(patch)
    state = patch.attempt(0.6, creepage=1e-3, lateral_force=2000)
    assert everything(patch) == before and patch.load["force"] == -6000
    assert patch.roll(0.6, creepage=1e-3, lateral_force=2000).item() == state.item()
    assert patch.attempt(0.6).item() == patch.roll(0.6).item()


def test_arrays_of_steps_are_those_one_by_one_to_the_bit(ellipse, random):
    count = 23  # of three parts
    dq, loads = random.uniform(0.3, 1.2, count), random_loads(random, count)
    sizes = {"size_factor": random.uniform(0.95, 1.05, count), "bound_factor": random.uniform(0.95, 1.05, count)}
    for given in (loads, {**loads, "spin": 1e-4}, {**loads, **sizes}, {**loads, "bound_factor": sizes["bound_factor"]}):
        patch, twin = ms.Patch(ellipse), ms.Patch(ellipse)
        states = patch.roll(dq, **given)
        assert states.shape == (count,)
        for k in range(count):
            one = twin.roll(dq[k], **{name: value[k] if np.ndim(value) else value for name, value in given.items()})
            assert one.item() == states[k].item()
        assert everything(patch) == everything(twin)


def test_what_is_not_given_is_zero_and_a_load_goes_on(ellipse):
    patch, twin = ms.Patch(ellipse), ms.Patch(ellipse)
    for use in (patch.roll, patch.attempt):
        with pytest.raises(ms.InputError, match="^load: expected a motion or a resultant to be set"):
            use(1)
    assert patch.load is None
    patch.roll(1, creepage=1e-3, spin=1e-4)
    patch.roll(1, creepage=1e-3)
    twin.roll([1, 1], creepage=1e-3, spin=[1e-4, 0])
    assert everything(patch) == everything(twin)
    assert patch.load == {"creepage": 1e-3, "lateral_creepage": 0, "spin": 0}
    assert patch.roll([1, 1]).shape == (2,) and patch.state.creepage == 1e-3 and patch.roll([]).shape == (0,)
    twin.roll([1, 1], **patch.load)
    assert everything(patch) == everything(twin)
    assert patch.steady(creepage=[[1e-4], [2e-4]], spin=[0, 1e-4, 2e-4]).shape == (2, 3)
    assert patch.steady().force == 0


def test_rolling_tends_to_steady_rolling(ellipse):
    patch = ms.Patch(ellipse)
    for given in ({"creepage": 6e-4, "spin": 1e-4}, {"force": -9000.0, "lateral_force": 3000.0}):
        last = patch.roll(np.full(60, 2.0), **given)[-1]
        steady = patch.steady(**given)
        for name in RESULTANTS:
            scale = FULL * (5 if name == "spin_moment" else 1)
            assert abs(last[name] - steady[name]) < 2e-3 * scale, name
        for name in MOTIONS:  # half a percent of what makes all slide
            assert abs(last[name] - steady[name]) < 5e-3 * (1e-3 if name == "spin" else 5e-3), name


def test_energy_is_balanced(ellipse, random):
    """docs/ellipse.md: the loss is what the balance leaves, so that it sums up exactly."""
    patch = ms.Patch(ellipse)
    count = 20
    dq = random.uniform(0.3, 1.2, count)
    states = patch.roll(dq, creepage=random.uniform(-1e-3, 1e-3, count), lateral_creepage=5e-4)
    ends = np.array([[0] * 3] + [[state[name] for name in RESULTANTS] for state in states])
    motion = np.array([[state[name] for name in MOTIONS] for state in states])
    given = -np.sum((ends[1:] + ends[:-1]) / 2 * motion * dq[:, None])
    lost = np.sum(states["dissipation"] * dq)
    assert lost > 0 and given == pytest.approx(lost + patch.elastic_energy, rel=1e-9)


def test_fields_belong_together(ellipse):
    patch = started(ellipse)
    assert patch.shape == (6, 8) and all(getattr(patch, name).shape == (6, 8) for name in ("x", "y", "area", "bound", "slips"))
    assert patch.traction.shape == patch.slip.shape == (6, 8, 2) and patch.slips.dtype == bool
    assert np.all(np.diff(patch.x, axis=1) < 0) and np.all(np.diff(patch.y, axis=0) > 0)
    assert np.array_equal(patch.slips, np.any(patch.slip != 0, axis=2))
    size = np.hypot(*np.moveaxis(patch.traction, -1, 0))
    assert np.all(size <= patch.bound * (1 + 1e-6))
    # The element of a row in which slip begins, behind one that sticks, has less.
    behind = patch.slips & ~np.roll(patch.slips, 1, axis=1)
    within = patch.slips & ~behind
    assert within.any() and np.allclose(size[within], patch.bound[within], rtol=1e-6)
    assert np.all(size[behind] > 0.8 * patch.bound[behind])
    # Sums over elements are a coarser rule than the library's.
    force = np.sum(patch.traction * patch.area[..., None], axis=(0, 1))
    assert force[0] == pytest.approx(patch.state.force, rel=0.03)
    assert patch.state.slip_share == pytest.approx(patch.area[patch.slips].sum() / patch.area.sum(), abs=1e-12)


@pytest.mark.parametrize("given, message", [
    ({"dq": [1, 1e-30, 1], "creepage": 0}, r"^step 1: dq = 1e-30: expected a length from"),
    ({"dq": [1, np.nan], "creepage": 0}, r"^step 1: dq = nan: expected a length from"),
    ({"dq": 1, "force": 1e5}, r"^force = 1e\+05: expected less than full sliding, 24000 N"),
    ({"dq": [1, 1], "lateral_force": [0, 1e5]}, r"^step 1: lateral_force = 1e\+05: expected less than full sliding"),
    ({"dq": [1, 2], "creepage": [1, 2, 3]}, r"^dq: expected arrays of one length, not of dq 2, creepage 3"),
    ({"dq": 1, "creepage": 1, "force": 2}, r"^force: expected creepage or force, not both"),
    ({"dq": 1, "spin": 1, "spin_moment": 2}, r"^spin_moment: expected spin or spin_moment, not both"),
    ({"dq": 1, "spin": "fast"}, r"^spin = 'fast': expected numbers"),
    ({"dq": 1, "spin": np.inf}, r"^spin = inf: expected a finite number"),
    ({"dq": np.ones((2, 2)), "creepage": 1}, r"^dq: expected a number or an array of one dimension"),
    ({"dq": 1, "creepage": 0, "size_factor": 1e3}, r"^size_factor = 1000: expected a number from 1e-04 to 100, or 0"),
    ({"dq": [1, 1], "creepage": 0, "bound_factor": [1, -1]}, r"^step 1: bound_factor = -1: expected a number from 1e-06")])
def test_a_call_that_fails_changes_nothing(ellipse, given, message):
    patch = started(ellipse)
    before = everything(patch)
    with pytest.raises(ms.InputError, match=message):
        patch.roll(**given)
    assert everything(patch) == before
    with pytest.raises(ms.InputError, match="^load 1: force = 1e\\+05: expected less"):
        patch.steady(force=[1, 1e5])
    with pytest.raises(ms.InputError, match="^creepage: expected arrays that numpy broadcasts, not of creepage"):
        patch.steady(creepage=[1, 2], spin=[1, 2, 3])
    with pytest.raises(ms.InputError, match="^shift: expected a shift, a rotation or a resultant"):
        patch.shift()
    assert everything(patch) == before


def test_an_interrupt_or_a_change_by_progress_changes_nothing(ellipse):
    patch = started(ellipse)
    before = everything(patch)

    def stop(done, total):
        assert (done, total) == (10, 30)
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        patch.roll(np.full(30, 0.5), creepage=0.001, progress=stop)
    assert everything(patch) == before
    for change in (lambda: patch.roll(1), patch.close, lambda: patch.shift(force=0), lambda: patch.set_contact(1, 1),
                   lambda: patch.steady(force=0), lambda: patch.attempt(1)):
        with pytest.raises(ms.Error, match="is rolling: expected no change of it by `progress`"):
            patch.roll([0.5, 0.5], progress=lambda *_, act=change: act())
        assert everything(patch) == before


def test_shifts_go_back_and_forth(ellipse):
    patch = ms.Patch(ellipse)
    first = patch.shift(force=-12000, lateral_force=3000)
    assert first.shift > 0 > first.lateral_shift and first.rotation == 0 and first.dissipation > 0
    assert patch.state.distance == 0 and patch.load is None
    back = patch.shift(shift=-first.shift, lateral_shift=-first.lateral_shift)
    assert abs(back.force) < 0.1 * FULL and back.dissipation > 0


def test_bodies_roll_back(ellipse):
    """In the mirror along the rolling, Fx, Mz, the lateral creepage and shifts change their signs."""
    dq = np.array([1, 1, -0.5, -2, -1, 0.7])
    loads = {"creepage": np.array([5, 5, 5, 8, -4, -4]) * 1e-4, "spin": np.full(6, 1e-4)}
    lateral = np.array([1, 2, -3, 1, 1, 2]) * 1e-4
    forth = ms.Patch(ellipse).roll(dq, lateral_creepage=lateral, **loads)
    back = ms.Patch(ellipse).roll(-dq, lateral_creepage=-lateral, **loads)
    for name, sign in (("force", -1), ("lateral_force", 1), ("spin_moment", -1), ("dissipation", 1), ("distance", -1)):
        assert np.allclose(back[name], sign * forth[name], atol=1e-5 * np.abs(forth[name]).max()), name


def test_files_go_on_to_the_bit(ellipse, tmp_path):
    original, other = started(ellipse), ms.Patch(ellipse)
    original.set_contact(1.05, 0.9)
    original.save(tmp_path / "a.state")
    other.restore(str(tmp_path / "a.state"))
    assert other.contact == (1.05, 0.9)
    for patch in (original, other):
        patch.roll(np.full(5, 0.6), creepage=1e-3)
    assert everything(other) == everything(original)
    scene = {**ellipse, "problem": "transient", "load.creepage": 1e-3, "step.ratio": 1, "motion.distance": 8}
    result = ms.solve(scene, start={"type": "state", "state": (tmp_path / "a.state").read_bytes()})
    assert len(result.history) > 3
    with pytest.raises(ms.InputError, match="cannot read it"):
        other.restore(tmp_path / "none")
    with pytest.raises(ms.InputError, match="grid"):
        ms.Patch(ellipse, grid_rows=7).restore(tmp_path / "a.state")


def test_another_normal_load_is_a_scaled_contact(ellipse):
    """By Hertz's theory lengths and pressures go with P^(1/3), and so do motions that make equal parts slip."""
    patch, factor = ms.Patch(ellipse), 1.5 ** (1 / 3)
    heavier = ms.Patch(ellipse, contact_normal_load="120 kN")
    patch.set_contact(factor, factor)
    for given in ({"creepage": 1e-3, "spin": 1e-4}, {"force": -9000, "lateral_force": 3000}):
        one, other = patch.steady(**given), heavier.steady(**given)
        assert one.full_sliding == pytest.approx(1.5 * FULL, rel=1e-9)
        assert np.allclose([one[name] for name in RESULTANTS + MOTIONS], [other[name] for name in RESULTANTS + MOTIONS],
                           rtol=1e-7, atol=1e-10)
    assert patch.roll(1, creepage=1e-3, size_factor=factor, bound_factor=factor).full_sliding == pytest.approx(1.5 * FULL)
    assert patch.x.max() == pytest.approx(heavier.x.max(), rel=1e-9)


def test_patches_of_any_shape_roll(source, random):
    scene = source / "examples/patch.info"
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ms.LoadWarning)
        patch = ms.Patch(scene, grid={"rows": 8, "elements": 8})
        solved = ms.solve(scene, grid={"rows": 8, "elements": 8}, problem="steady",
                          load={"force": None, "lateral_force": None, "spin_moment": None, "creepage": 1e-3,
                                "lateral_creepage": 2e-4, "spin": 1e-4})
    motion = np.array([1e-3, 2e-4, 1e-4])
    one = patch.steady(**dict(zip(MOTIONS, motion)))
    assert np.allclose([one[name] for name in RESULTANTS], [solved.summary[name] for name in RESULTANTS], rtol=1e-4, atol=1)
    # With a bound g times as large, motions and resultants are g times as large.
    patch.set_contact(1, 1.7)
    other = patch.steady(**dict(zip(MOTIONS, 1.7 * motion)))
    assert np.allclose([other[name] / 1.7 for name in RESULTANTS], [one[name] for name in RESULTANTS], rtol=1e-6, atol=1e-3)
    assert other.dissipation == pytest.approx(1.7**2 * one.dissipation, rel=1e-6)
    assert other.full_sliding == pytest.approx(1.7 * one.full_sliding, rel=1e-9)
    assert patch.roll(1, creepage=1e-3).full_sliding == pytest.approx(1.7 * one.full_sliding, rel=1e-6)
    with pytest.raises(ms.InputError, match="half_width = 1.1|size_factor = 1.1"):
        patch.set_contact(1.1, 1)


def test_of_a_whole_scene_the_contact_is_taken(source, ellipse, scene):
    for name in ("ellipse", "ellipse_transient"):
        assert ms.Patch(source / f"examples/{name}.info", grid={"rows": 4, "elements": 5}).shape == (4, 5)
    with pytest.raises(ms.InputError, match="unknown key 'grid.elemnts'"):
        ms.Patch(ellipse, grid_elemnts=3)
    with pytest.raises(ms.InputError, match="^step.scheme = 'direct': expected remembered in microslip.Patch"):
        ms.Patch(ellipse, step_scheme="direct")
    with pytest.raises(ms.InputError, match="^contact.lateral_half_width.* microslip.Rolling rolls a line contact$"):
        ms.Patch(scene)
    with pytest.raises(ms.InputError, match="^contact.lateral_radius_2: .* microslip.Patch rolls ellipses") as caught:
        ms.Rolling(ellipse)
    assert caught.value.key == "contact.lateral_radius_2"
    with pytest.warns(ms.LoadWarning, match="^grid.rows = 40: rows and elements do not fit") as told:
        ms.Patch(ellipse, grid={"rows": 40, "elements": 3})
    assert told[0].filename == __file__


def test_large_motions_are_warned_of_once(ellipse):
    patch = ms.Patch(ellipse)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        patch.roll([1, 1], force=[-100, -200])
        patch.roll(1, creepage=0.2)
        patch.steady(spin=[0.01, 1e-3])
    for act, match in ((lambda one: one.roll(1, creepage=-0.3), "^creepage = -0.3: creepages above 0.2"),
                       (lambda one: one.attempt(1, lateral_creepage=0.3), "^lateral_creepage = 0.3: creepages above 0.2"),
                       (lambda one: one.steady(spin=[0, 0.1]), "^spin = 0.1: the slip by this spin, up to"),
                       (lambda one: one.roll([1, 1], spin=[0.1, -0.1]), "^spin = 0.1: the slip by this spin, up to")):
        one = patch.copy()
        with pytest.warns(ms.LoadWarning, match=match) as told:
            act(one)
            act(one)
        assert len(told) == 1 and told[0].filename == __file__


def test_it_is_closed_once_and_for_all(ellipse):
    with started(ellipse) as patch:
        assert "6 x 8 elements: distance = 0.8 mm" in repr(patch) and "<table>" in patch._repr_html_()
    patch.close()
    assert repr(patch) == "<microslip.Patch, closed>" and bool(patch)
    for use in (lambda: patch.state, lambda: patch.roll(1), lambda: patch.x, patch.copy, lambda: patch.steady(force=1),
                lambda: pickle.dumps(patch), lambda: patch.contact):
        with pytest.raises(ms.Error, match="closed"):
            use()


def test_threads_that_share_a_patch_take_turns(ellipse):
    patch = started(ellipse)
    works = [lambda: patch.roll(np.full(5, 0.5), creepage=0.001), lambda: patch.roll(0.5, creepage=0.001),
             lambda: patch.attempt(0.5, creepage=0.002, jacobian=True), lambda: patch.copy().roll(0.5),
             lambda: (patch.traction, patch.state, patch.elastic_energy, repr(patch)),
             lambda: pickle.loads(pickle.dumps(patch)), lambda: patch.steady(creepage=[1e-3, 2e-3])]
    failed = []

    def use(first):
        for k in range(7):
            try:
                works[(first + k) % len(works)]()
            except Exception as error:  # pylint: disable=broad-except
                failed.append(error)

    threads = [threading.Thread(target=use, args=(k,)) for k in range(7)]
    for one in threads:
        one.start()
    for one in threads:
        one.join()
    assert not failed
    assert patch.state.distance == pytest.approx(0.8 + 7 * 3.0)


def test_many_loads_are_solve_of_each_and_threads_change_nothing(ellipse, random):
    loads = {name: value.reshape(2, 3) for name, value in random_loads(random, 6).items()}
    told = []
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ms.LoadWarning)  # of coarse grids, by ms.solve
        first, *others = (ms.steady(ellipse, **loads, threads=threads, progress=lambda *counts: told.append(counts))
                          for threads in (1, 2, 5))
        assert told[-1] == (6, 6)
        assert first.force.shape == (2, 3) and first.traction.shape == first.slip.shape == (2, 3, 6, 8, 2)
        assert first.slips.shape == (2, 3, 6, 8) and first.x.shape == first.area.shape == (6, 8) and len(first) == 6
        for other in others:
            assert np.array_equal(other.states, first.states) and np.array_equal(other.traction, first.traction)
        for at in np.ndindex(2, 3):
            one = ms.solve(ellipse, problem="steady", load={name: value[at] for name, value in loads.items()})
            for name in RESULTANTS + MOTIONS + ["dissipation", "slip_share"]:
                assert float(one.summary[name]) == first.states[name][at], name
            assert first.change[at] == one.summary["change"]
            for axis, name in enumerate("xy"):
                assert np.array_equal(one.traction[f"traction_{name}"], first.traction[at][..., axis].ravel())
                assert np.array_equal(one.traction[f"slip_{name}"], first.slip[at][..., axis].ravel())
            assert np.array_equal(one.traction["x"], first.x.ravel()) and np.array_equal(one.traction["y"], first.y.ravel())
            assert np.array_equal(one.traction["zone"] == "S", first.slips[at].ravel())
    assert ms.steady(ellipse, spin=[]).traction.shape == (0, 6, 8, 2)
    one = ms.steady(ellipse, creepage=1e-3)
    assert one.force.shape == () and one.traction.shape == (6, 8, 2) and "force = -" in repr(one)


def test_loads_of_steady_rolling_that_fail(ellipse, scene):
    with pytest.raises(ms.InputError, match="^load 1: force = 1e\\+05: expected less than full sliding"):
        ms.steady(ellipse, force=[0, 1e5], missing="nan")
    strict = {**ellipse, "load.spin": 1}
    hard = {"force": [-1000.0, -0.99 * FULL], "lateral_force": [0, 0.5 * FULL]}
    with pytest.raises(ms.InputError, match="^load 1: .*expected"):
        ms.steady(strict, **hard)
    hard = {"force": [-1000.0, -0.9 * FULL], "spin_moment": [0, 0.9 * 0.5 * FULL * 5]}
    with pytest.raises(ms.NoSolution, match="^load 1: "):
        ms.steady(strict, **hard)
    found = ms.steady(strict, **hard, missing="nan")
    assert found.status.tolist() == [0, 2] and np.isnan(found.creepage).tolist() == [False, True]
    assert np.isnan(found.traction[1]).all() and found.messages[0] == "" and not np.isnan(found.x).any()
    for name in ("lateral_creepage", "spin", "lateral_force", "spin_moment"):
        with pytest.raises(ms.InputError, match=f"^{name}: expected none, as a line contact rolls"):
            ms.steady(scene, creepage=1e-3, **{name: 1})
    with pytest.raises(ms.InputError, match="^creepage: expected a motion or a resultant"):
        ms.steady(ellipse)
    with pytest.warns(ms.LoadWarning, match="^spin = 0.1: the slip by this spin") as told:
        ms.steady(ellipse, spin=[0.1, 0])
    assert len(told) == 1 and told[0].filename == __file__
