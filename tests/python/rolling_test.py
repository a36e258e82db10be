# SPDX-License-Identifier: GPL-3.0-or-later
"""A contact that rolls: alone, copied, kept, over arrays of steps."""
import concurrent.futures
import contextlib
import copy
import gc
import os
import pickle
import stat
import subprocess
import sys
import threading
import warnings

import numpy as np
import pytest

import microslip as ms


def started(scene, kind=ms.Rolling):
    contact = kind(scene)
    contact.start_from_shift(-1000)
    contact.roll(0.1, force=-1500)
    return contact


def everything(contact):
    return [contact.state.item(), contact.elastic_energy, contact.load,
            *(getattr(contact, name).tolist() for name in
              ("x", "traction", "bound", "slip", "displacement", "zones"))]


class Named(ms.Rolling):
    """One with an attribute of its own."""

    name = property(lambda self: self.notes[0])


COPIES = {"method": ms.Rolling.copy, "copy": copy.copy, "deepcopy": copy.deepcopy,
          "twice": lambda one: copy.deepcopy([one, one])[1], "pickle": lambda one: pickle.loads(pickle.dumps(one))}


@pytest.mark.parametrize("make", COPIES.values(), ids=COPIES)
def test_copies_roll_on_their_own_to_the_bit(make, scene):
    original = started(scene, Named)
    original.notes = ["wheel"]
    original.set_contact(1.1, 0.9)
    other = make(original)
    assert isinstance(other, Named) and other.name == "wheel"
    assert everything(other) == everything(original)
    before = everything(other)
    original.roll(0.2)
    assert everything(other) == before
    other.roll(0.2)
    assert everything(other) == everything(original)
    del other
    gc.collect()
    original.roll(0.1)


def test_a_state_of_a_file_has_the_contact_that_was_set(scene, tmp_path):
    original = started(scene)
    original.set_contact(0.5, 0.5)
    original.save(tmp_path / "set")
    restored = ms.Rolling(scene)
    restored.restore(tmp_path / "set")
    assert restored.full_sliding == original.full_sliding
    with pytest.raises(ms.InputError, match="force = -1e\\+06"):
        restored.roll(0.2, force=-1e6)
    for contact in original, restored:
        contact.roll(0.2, creepage=1e-3, bound_factor=0.6)
    assert everything(restored) == everything(original)


def test_what_the_contact_set_does_not_carry_is_no_load_of_a_refused_step(scene):
    contact = ms.Rolling(scene)
    contact.roll(0.2, force=-1000)
    contact.set_contact(0.5, 0.5)
    for given, message in (({"force": -800}, "force = -800"), ({"creepage": float("nan")}, "creepage = nan"),
                           ({}, "force = -1000")):
        for step in contact.roll, contact.attempt:
            with pytest.raises(ms.InputError, match=message):
                step(0.2, **given)
    assert contact.load == ("force", -1000)
    contact.set_contact(1, 1)
    contact.roll([0.2])
    assert contact.state.force == pytest.approx(-1000)


def test_within_one_deepcopy_they_are_one(scene):
    first, second = copy.deepcopy([*[started(scene)] * 2])
    assert first is second


def test_a_pickled_contact_of_arrays_needs_no_file(scene):
    contact = ms.Rolling(scene, contact={"half_width": 5, "peak_traction": None,
                                         "bound_file": (np.array([-4, 0, 4]), np.array([100, 300, 50]))})
    contact.roll(np.full(10, 0.2), creepage=1e-3)
    again = pickle.loads(pickle.dumps(contact))
    assert everything(again) == everything(contact)
    direct = ms.Rolling(scene, step_scheme="direct")
    with pytest.raises(ms.InputError, match="expected 'remembered'"):
        pickle.dumps(direct)


def test_a_pickled_contact_of_a_file_is_that_of_the_file_as_it_was(source, tmp_path, monkeypatch):
    (tmp_path / "a.info").write_text((source / "examples/steady.info").read_text())
    monkeypatch.chdir(tmp_path)
    contact = ms.Rolling("a.info", grid_elements=20)
    contact.roll(0.3, creepage=0.001)
    (tmp_path / "a.info").unlink()
    assert everything(pickle.loads(pickle.dumps(contact))) == everything(contact)


def test_changing_what_was_given_does_not_change_the_contact(scene):
    x, bound = np.array([-4.0, 0, 4]), np.array([100.0, 300, 50])
    contact = ms.Rolling(scene, contact={"half_width": 5, "peak_traction": None, "bound_file": (x, bound)})
    bound[:] = 1
    again = pickle.loads(pickle.dumps(contact))
    assert np.array_equal(again.bound, contact.bound)


def test_arrays_of_steps_are_those_one_by_one_to_the_bit(scene, random):
    count = 1205  # of two parts
    dq, load = random.uniform(0.01, 0.6, count), random.uniform(-1, 1, count)
    sizes = random.uniform(0.8, 1.2, (2, count))
    for given in ({"creepage": 0.003 * load}, {"force": 1400 * load},
                  {"creepage": 0.003 * load, "half_width_factor": sizes[0], "bound_factor": sizes[1]},
                  {"force": 900 * load, "half_width_factor": sizes[0]}, {"creepage": 0.001}):
        contact, twin = ms.Rolling(scene), ms.Rolling(scene)
        states = contact.roll(dq, **given)
        for k in range(count):
            one = twin.roll(dq[k], **{name: value[k] if np.ndim(value) else value for name, value in given.items()})
            assert one.item() == states[k].item()
        assert everything(contact) == everything(twin)


def test_numbers_go_together_with_arrays(scene):
    contact = ms.Rolling(scene)
    assert contact.roll(0.1, creepage=[0.001, 0.002]).shape == (2,)
    assert contact.roll([0.1] * 3).shape == (3,)  # under the last creepage
    assert contact.state.creepage == 0.002
    assert contact.roll([]).shape == (0,)
    assert contact.roll([0.1] * 3, half_width_factor=1.1)["force"].shape == (3,)
    assert contact.state.distance == pytest.approx(0.8)


def test_rolling_tends_to_steady_rolling(scene):
    for given in ({"creepage": 0.0015}, {"force": -1200.0}):
        contact = ms.Rolling(scene, grid_elements=200)
        last = contact.roll(np.full(2000, 0.05), **given)[-1]
        steady = ms.steady(scene, **given)
        assert last["force"] == pytest.approx(float(steady.force), rel=1e-3)
        assert last["creepage"] == pytest.approx(float(steady.creepage), rel=1e-3)


def test_energy_is_balanced(scene, random):
    contact = ms.Rolling(scene)
    dq, creepage = random.uniform(0.01, 0.6, 500), random.uniform(-2e-3, 2e-3, 500)
    states = contact.roll(dq, creepage=creepage)
    lost = np.sum(states["dissipation"] * dq)
    given = -np.sum(states["mean_force"] * creepage * dq)
    assert lost > 0
    assert given == pytest.approx(lost + contact.elastic_energy, rel=1e-12)


@pytest.mark.parametrize("given, message", [
    ({"dq": [0.1, 1e-30, 0.1], "creepage": 0}, r"^step 1: dq = 1e-30: expected 0, or from 1e-15"),
    ({"dq": np.r_[np.full(1500, 0.1), np.nan], "creepage": 0}, r"^step 1500: dq = nan: expected 0, or from"),
    ({"dq": 0.1, "force": 12345}, r"^force = 12345: expected an absolute value below full sliding"),
    ({"dq": [0.1, 0.2], "creepage": [1, 2, 3]}, r"^dq: expected arrays of one length, not of dq 2, creepage 3"),
    ({"dq": 0.1, "creepage": 1, "force": 2}, r"^force: expected a creepage or a force, not both"),
    ({"dq": "far", "creepage": 1}, r"^dq = 'far': expected numbers"),
    ({"dq": np.ones((2, 2)), "creepage": 1}, r"^dq: expected a number or an array of one dimension"),
    ({"dq": 0.1, "creepage": 0, "half_width_factor": -1}, r"^half_width_factor = -1: expected a number >= 0")])
def test_a_call_that_fails_changes_nothing(scene, given, message):
    contact = started(scene)
    before = everything(contact)
    with pytest.raises(ms.InputError, match=message):
        contact.roll(**given)
    assert everything(contact) == before
    if np.ndim(given["dq"]) == 0:
        attempted = {name: value for name, value in given.items() if name in ("dq", "creepage", "force")}
        with contextlib.suppress(ms.InputError, ValueError):
            contact.attempt(**{**attempted, "dq": 1e-30})
        assert everything(contact) == before
    for use in (ms.Rolling(scene).roll, ms.Rolling(scene).attempt):
        with pytest.raises(ms.InputError, match="expected a creepage or a force to be set"):
            use(0.1)


def test_an_interrupt_changes_nothing(scene):
    contact = started(scene)
    before = everything(contact)

    def stop(done, total):
        assert total == 5000
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        contact.roll(np.full(5000, 0.1), creepage=0.001, progress=stop)
    assert everything(contact) == before


def test_jacobians_are_slopes_of_the_step(scene):
    contact = ms.Rolling(scene)
    contact.start_from_shift(-1000)
    for name in ("force", "mean_force", "dissipation"):
        _, jacobian = contact.attempt(0.2, creepage=1e-3, jacobian=True)
        by_load = [contact.attempt(0.2, creepage=w)[name] for w in (1e-3 * (1 - 1e-4), 1e-3 * (1 + 1e-4))]
        assert (by_load[1] - by_load[0]) / 2e-7 == pytest.approx(jacobian.by_load[name], rel=1e-6)
        by_length = [contact.attempt(dq, creepage=1e-3)[name] for dq in (0.2 * (1 - 1e-4), 0.2 * (1 + 1e-4))]
        assert (by_length[1] - by_length[0]) / 4e-5 == pytest.approx(jacobian.by_length[name], rel=1e-6)
    assert contact.state.distance == 0


def test_shifts_lose_in_a_cycle_what_the_force_does(scene):
    contact = ms.Rolling(scene)
    first = contact.shift(force=-1500)
    assert first.distance > 0
    assert first.work - first.dissipation == pytest.approx(contact.elastic_energy, rel=1e-12)
    back, forth = contact.shift(force=1500), contact.shift(force=-1500)
    assert back.distance == pytest.approx(-forth.distance, rel=1e-12)
    assert back.work + forth.work == pytest.approx(back.dissipation + forth.dissipation, rel=1e-10)
    assert contact.shift(distance=0.01).distance == 0.01
    for given in ({}, {"force": 1, "distance": 1}):
        with pytest.raises(ms.InputError, match="expected either a force or a distance"):
            contact.shift(**given)
    with pytest.raises(ms.InputError, match="^force = 3000: expected an absolute value"):
        contact.shift(force=3000)


def test_contacts_that_change_carry_what_they_can(scene):
    contact = ms.Rolling(scene)
    full = contact.full_sliding
    for size in (1, 1.2, 0.5):
        state = contact.roll(5, creepage=1, half_width_factor=size, bound_factor=size)
        assert state.force == pytest.approx(-full * size**2, rel=0.01)
        assert contact.full_sliding == pytest.approx(full * size**2)
    assert contact.roll(0.1, half_width_factor=0, bound_factor=1).force == 0
    with pytest.raises(ms.InputError, match="^bound_factor = -1: expected a number >= 0"):
        contact.set_contact(1, -1)


def test_a_file_goes_on_to_the_bit(scene, tmp_path):
    original, other = started(scene), ms.Rolling(scene)
    original.save(tmp_path / "a.state")
    other.restore(str(tmp_path / "a.state"))
    for contact in (original, other):
        contact.roll(np.full(20, 0.3), force=-1400)
    assert everything(other) == everything(original)
    with pytest.raises(ms.InputError, match="cannot read it") as caught:
        other.restore(tmp_path / "none")
    assert caught.value.key == "path"
    with pytest.raises(ms.InputError, match="grid.elements = 41: expected 40"):
        ms.Rolling(scene, grid_elements=41).restore(tmp_path / "a.state")


def test_of_a_whole_scene_the_contact_is_taken(source, scene):
    for name in ("steady", "transient", "cylinder", "run"):
        assert len(ms.Rolling(source / f"examples/{name}.info", grid_elements=30)) == 30
    assert ms.Rolling(scene, step_scheme="fractional", grid_elements=41).method == "fractional"
    with pytest.raises(ms.InputError, match="unknown key 'grid.elemnts'"):
        ms.Rolling(scene, grid_elemnts=3)
    with pytest.raises(ms.InputError, match="missing key 'grid.elements'"):
        ms.Rolling(scene, grid=None, grid_elements=None)


def test_it_is_closed_once_and_for_all(scene):
    with started(scene) as contact:
        assert "distance = 0.1 mm" in repr(contact) and "<table>" in contact._repr_html_()
    contact.close()
    assert repr(contact) == "<microslip.Rolling, closed>"
    for use in (lambda: contact.state, lambda: contact.roll(0.1), lambda: len(contact), contact.copy,
                lambda: pickle.dumps(contact)):
        with pytest.raises(ms.Error, match="closed"):
            use()


def test_other_threads_run_while_it_rolls(scene):
    """The interpreter's lock is free: this thread counts during a single call, which else would stop it."""
    contact = ms.Rolling(scene, grid_elements=400)
    counts = [0]
    seen = []

    def roll():
        seen.append(counts[0])
        contact.roll(np.full(1000, 0.02), creepage=0.001)
        seen.append(counts[0])

    rolling = threading.Thread(target=roll)
    rolling.start()
    while rolling.is_alive():
        counts[0] += 1
    assert contact.state.distance == pytest.approx(20)
    assert seen[1] - seen[0] > 1000


MAKE = "import microslip as m; m.Rolling({'material.shear_modulus': 1}"


@pytest.mark.parametrize("rest, error", [(")", "InputError"), (", 5)", "TypeError"), (", grid=3)", "InputError")])
def test_a_constructor_that_fails_raises_its_own_error_only(rest, error):
    """A process of its own, as what a destructor raises is only printed."""
    done = subprocess.run([sys.executable, "-c", MAKE + rest], capture_output=True, text=True, check=False)
    assert done.returncode == 1
    assert done.stderr.count("Traceback") == 1 and "ignored" not in done.stderr
    assert error in done.stderr.splitlines()[-1]


def test_large_creepages_are_warned_of_once(scene):
    rolling = ms.Rolling(scene)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        rolling.roll(0.1, creepage=0.2)
        rolling.roll([0.1, 0.2], force=[-100, -200])
        rolling.attempt(0.1, creepage=0.001)
    for act in (lambda one: one.roll(0.1, creepage=-0.3), lambda one: one.attempt(0.1, creepage=-0.3),
                lambda one: one.roll(np.full(50, 0.01), creepage=np.linspace(0, -0.3, 50))):
        one = rolling.copy()
        with pytest.warns(ms.LoadWarning, match="^creepage = -0.[0-9]*: creepages above 0.2") as told:
            act(one)
            act(one)
        assert len(told) == 1 and told[0].filename == __file__


def test_nothing_happens_over_no_length(scene, random):
    count = 300
    dq = np.where(random.uniform(size=count) < 0.3, 0, random.uniform(0.01, 0.6, count))
    creepage = random.uniform(-3e-3, 3e-3, count)
    moving = dq > 0
    for options in ({}, {"step_scheme": "direct"}):
        contact, twin, one_by_one = (ms.Rolling(scene, **options) for _ in range(3))
        states, expected = contact.roll(dq, creepage=creepage), twin.roll(dq[moving], creepage=creepage[moving])
        for length, load in zip(dq, creepage):
            one_by_one.attempt(0, creepage=-load)
            one_by_one.roll(length, creepage=load)
        assert np.array_equal(states[moving], expected)
        before = np.maximum(np.cumsum(moving) - 1, 0)
        standing = ~moving & (np.cumsum(moving) > 0)
        assert np.array_equal(states[standing], expected[before[standing]])
        assert everything(contact)[:2] == everything(twin)[:2] == everything(one_by_one)[:2]
        force = contact.state.force
        for act in (contact.roll, contact.attempt):
            assert act(0, force=force).force == force
            with pytest.raises(ms.InputError, match="^force = 50: expected .* a shift changes it without rolling"):
                act(0, force=50)
            if options:
                with pytest.raises(ms.InputError, match="^dq = -1: .*; the scheme remembered alone rolls back"):
                    act(-1, creepage=0)
    with pytest.raises(ms.InputError, match="^step 1: bound_factor = 0.5: expected .* a shift changes it"):
        twin = ms.Rolling(scene)
        twin.roll([0.1, 0], creepage=0, bound_factor=[1, 0.5])
    assert twin.state.distance == 0


def test_bodies_roll_back(scene):
    """Rolling back is rolling forth in the mirror; a turn keeps the force."""
    dq = np.array([0.5, 0.5, 0.3, -0.2, -0.6, -0.6, 0.4])
    creepage = np.array([1, 2, 2, 2, -1, -1, 1]) * 1e-3
    forth, back = (ms.Rolling(scene).roll(sign * dq, creepage=creepage) for sign in (1, -1))
    assert np.allclose(back["force"], -forth["force"], atol=1e-7)
    assert np.allclose(back["distance"], -np.cumsum(dq)) and np.allclose(back["dissipation"], forth["dissipation"], atol=1e-7)
    contact = ms.Rolling(scene)
    force = contact.roll(dq[:3], creepage=creepage[:3])["force"][-1]
    assert contact.attempt(-1e-6, creepage=0).force == pytest.approx(force, rel=1e-3)
    _, slopes = contact.attempt(-0.2, creepage=1e-3, jacobian=True)
    near = [contact.attempt(-0.2, creepage=1e-3 + change).force for change in (-1e-6, 1e-6)]
    assert slopes.by_load.force == pytest.approx((near[1] - near[0]) / 2e-6, rel=1e-3)


def test_zeros_have_no_sign(scene, plane):
    contact = ms.Rolling(scene)
    results = [contact.state, contact.roll(0.1, creepage=-0.0), contact.roll([0.1], force=-0.0)[0], contact.shift(force=-0.0),
               contact.attempt(0.1, creepage=0, jacobian=True)[1].by_length, *ms.steady(scene, creepage=[0, -0.0]).states,
               *ms.steady(plane, force=[0, -0.0]).states]
    for result in results:
        assert not any(np.signbit(value) for name, value in zip(result.dtype.names, result.item())
                       if value == 0), (result.dtype.names, result)
    curve = ms.creep_curve(plane, points=6, beside="fastsim")
    for values in (curve.force, curve.creepage, curve.traction, curve.slip, curve.displacement, curve.fastsim_force,
                   contact.slip, contact.traction, contact.displacement, np.array(contact.start_from_shift(-0.0))):
        assert not np.signbit(values[values == 0]).any()


def test_attempts_in_threads_are_those_of_one(scene, random):
    contact = started(scene)
    tries = [(float(dq), float(load)) for dq, load in zip(random.uniform(0.01, 0.6, 40), random.uniform(-3e-3, 3e-3, 40))]

    def attempt(one):
        state, slopes = contact.attempt(one[0], creepage=one[1], jacobian=True)
        return state.item(), slopes.item(), contact.attempt(one[0], force=1e5 * one[1]).item()

    expected = list(map(attempt, tries))
    for _ in range(5):
        with concurrent.futures.ThreadPoolExecutor(4) as pool:
            found = list(pool.map(attempt, tries))
        for one, other in zip(found, expected):  # attempts leave rounding, in whatever order they are made
            assert np.allclose(np.hstack(one[0]), np.hstack(other[0]), rtol=1e-9, atol=1e-9)
            assert np.allclose(np.hstack(one[1]), np.hstack(other[1]), rtol=1e-6, atol=1e-6)
            assert np.allclose(np.hstack(one[2]), np.hstack(other[2]), rtol=1e-9, atol=1e-9)


ABUSE = """
import pickle, sys, threading
import numpy as np
import microslip as ms
contact = ms.Rolling(material={"shear_modulus": 82000, "poisson_ratio": 0.28},
                     contact={"half_width": 5, "peak_traction": 300},
                     kernel={"type": "strip", "width": 10}, grid={"elements": 60})
contact.roll(0.1, creepage=0.001)
works = [lambda: contact.roll(np.full(20, 0.01), creepage=0.001), lambda: contact.roll(0.01, creepage=0.001),
         lambda: contact.attempt(0.1, creepage=0.002, jacobian=True), lambda: contact.copy().roll(0.1),
         lambda: (contact.traction, contact.state, contact.elastic_energy, contact.displacement, repr(contact)),
         lambda: pickle.loads(pickle.dumps(contact)), lambda: contact.set_contact(1, 1)]
failed = []

def use(first):
    for k in range(12):
        try:
            works[(first + k) % len(works)]()
        except Exception as error:
            failed.append(error)

threads = [threading.Thread(target=use, args=(k,)) for k in range(7)]
for one in threads: one.start()
for one in threads: one.join()
assert not failed, failed
rolls = sum(0.2 if (first + k) % 7 == 0 else 0.01 if (first + k) % 7 == 1 else 0 for first in range(7) for k in range(12))
assert abs(contact.state.distance - 0.1 - rolls) < 1e-9, (contact.state.distance, rolls)

def end():
    while True:
        contact.roll(np.full(2000, 0.01), creepage=0.001)

threading.Thread(target=end, daemon=True).start()
other = threading.Thread(target=contact.attempt, args=(0.1,), kwargs={"creepage": 0.1})
other.start()
print("done")
"""


def test_threads_that_share_a_contact_take_turns():
    """A process of its own, as it used to end; also while a thread still rolls at the end of the interpreter."""
    for _ in range(5):
        done = subprocess.run([sys.executable, "-c", ABUSE], capture_output=True, text=True, check=False)
        assert (done.returncode, done.stdout) == (0, "done\n"), done.stderr


def test_progress_does_not_change_the_contact_that_rolls(scene):
    contact = started(scene)
    before = everything(contact)
    for change in (lambda: contact.roll(0.1), lambda: contact.attempt(0.1), contact.close, lambda: contact.shift(force=0),
                   lambda: contact.set_contact(1, 1), lambda: contact.start_from_shift(0)):
        with pytest.raises(ms.Error, match="is rolling: expected no change of it by `progress`"):
            contact.roll([0.1, 0.1], progress=lambda *_, act=change: act())
        assert everything(contact) == before
    seen = []
    contact.roll([0.1, 0.1], progress=lambda *_: seen.append((contact.state.distance, contact.copy().roll(0.1).distance)))
    assert seen == [(pytest.approx(0.1), pytest.approx(0.2))] and contact.state.distance == pytest.approx(0.3)


def test_states_and_tables_replace_regular_files_only(scene, tmp_path):
    contact, table = started(scene), ms.solve(scene, problem="steady", load_force=-500).tables["traction"]
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / "deep").mkdir()
    refused = ["pipe", "deep"]
    with contextlib.suppress(PermissionError):  # only root makes devices: the null device by another name
        os.mknod(tmp_path / "device", stat.S_IFCHR | 0o600, os.makedev(1, 3))
        refused.append("device")
    for name in refused:
        (tmp_path / f"to-{name}").symlink_to(name)
        for path in (tmp_path / name, tmp_path / f"to-{name}"):
            before = path.stat()
            for write in (contact.save, table.write):
                with pytest.raises(ms.InputError, match=f"^path = '{path}': cannot write it: ") as caught:
                    write(path)
                assert caught.value.key == "path" and path.stat() == before
    (tmp_path / "deep/old").write_text("old")
    (tmp_path / "link").symlink_to("deep/old")
    (tmp_path / "chain").symlink_to(tmp_path / "link")
    (tmp_path / "new").symlink_to("deep/new")
    for link, file in (("chain", "old"), ("new", "new")):
        for write in (contact.save, table.write):
            write(tmp_path / link)
            assert (tmp_path / link).is_symlink()
        assert ms.read_table(tmp_path / "deep" / file).data.tolist() == table.data.tolist()
        contact.save(os.fsencode(tmp_path / link))
        ms.Rolling(scene).restore(tmp_path / "deep" / file)
    assert sorted(os.listdir(tmp_path / "deep")) == ["new", "old"]
    for write in (contact.save, table.write):
        with pytest.raises(ms.InputError, match="expected a path without NUL"):
            write(str(tmp_path / "a\0b"))
    with pytest.raises(FileNotFoundError):
        table.write(tmp_path / "none" / "a.tsv")
