# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables of creep forces: against steady solutions, limits, derivatives, arrays, errors."""
import ast
import copy
import pickle
import re
import threading
import warnings

import numpy as np
import pytest

import microslip as ms
from microslip import _creep_table

STEEL = {"shear_modulus": 82000, "poisson_ratio": 0.28}
WHEEL = {"half_width": 6, "lateral_half_width": 4.5, "peak_traction": 300, **STEEL}
RESULTANTS = ("force", "lateral_force", "spin_moment")


@pytest.fixture(name="table", scope="module")
def installed_table():
    return ms.CreepTable()


def generated(random, count, table):
    """Contacts of all shapes, and motions from nearly stick to nearly full sliding: any of them may be 0."""
    ratio = np.exp(random.uniform(*np.log(table.ratios), count) * 0.999)
    b = random.uniform(2, 9, count)
    peak = random.uniform(50, 500, count)
    size = peak / STEEL["shear_modulus"] * 10 ** random.uniform(-2, 1, count)
    direction = random.normal(size=(3, count)) * (random.random((3, count)) < 0.8)
    direction[0, ~direction.any(axis=0)] = 1
    direction *= size / np.linalg.norm(direction, axis=0)
    direction[2] /= np.sqrt(ratio) * b
    return {"creepage": direction[0], "lateral_creepage": direction[1], "spin": direction[2], "half_width": ratio * b,
            "lateral_half_width": b, "peak_traction": peak}


def full_sliding(contact):
    return 2 / 3 * np.pi * contact["half_width"] * contact["lateral_half_width"] * contact["peak_traction"]


def over_full_sliding(forces, contact):
    """(..., 3): forces over full sliding, and the moment over that times (a b)^(1/2)."""
    size = np.sqrt(contact["half_width"] * contact["lateral_half_width"])
    full = np.asarray(full_sliding(contact))
    return np.stack([forces[0] / full, forces[1] / full, forces[2] / (full * size)], -1)


def test_forces_are_those_of_steady_solutions(table, random):
    """The errors that the table states hold: those of the solution here, on some 200 elements, are added."""
    differences, own = [], []
    for ratio, rows, elements in ((0.15, 30, 7), (0.4, 20, 10), (0.9, 14, 14), (1.7, 12, 16), (4, 8, 26)):
        contact = {"half_width": 5 * ratio**0.5, "lateral_half_width": 5 / ratio**0.5, "peak_traction": 300}
        some = generated(random, 24, table)
        strain = 300 / some["peak_traction"] * np.sqrt(some["half_width"] * some["lateral_half_width"]) / 5
        motions = {"creepage": some["creepage"], "lateral_creepage": some["lateral_creepage"], "spin": some["spin"] * strain}
        solved = ms.steady({"material": STEEL, "contact": contact, "grid": {"rows": rows, "elements": elements}}, missing="nan",
                           **motions)
        there = solved.status == 0
        assert there.mean() > 0.9
        expected = over_full_sliding([getattr(solved, name)[there] for name in RESULTANTS], contact)
        found = over_full_sliding([one[there] for one in table.forces(**motions, **contact, **STEEL)], contact)
        differences.append(np.abs(found - expected))
        own.append(2e-3 + 1.5 * solved.change[there])  # the bound of ms.PatchSteady
    differences, own = np.concatenate(differences), np.concatenate(own)
    assert np.all(differences <= table.errors.largest + own[:, None])
    # 6e-4, 1.3e-3 and 7e-4 were measured.
    assert np.all(np.sqrt(np.mean(differences**2, axis=0)) < table.errors.rms + 1e-3)
    assert np.abs(expected).max() > 0.5


def test_motions_that_are_not_small_are_warned_of(table):
    """By the first of each kind; slip by spin is that at (a b)^(1/2), and normalised contacts have no such limit."""
    size = np.sqrt(WHEEL["half_width"] * WHEEL["lateral_half_width"])
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        table.forces([0.2, -0.2], 0.2, [0.199 / size, 0], **WHEEL)
        table.forces([], 5, **WHEEL)
        table.forces(5, spin=5, **{**WHEEL, "shear_modulus": 1, "peak_traction": 0.16})
    with pytest.warns(ms.LoadWarning) as told:
        table.forces(-5, **WHEEL)
    assert [str(one.message)[:40] for one in told] == ["creepage = -5: creepages above 0.2 are n"]
    assert told[0].filename == __file__
    normalised = [WHEEL["shear_modulus"], 300, 300, 300]
    with pytest.warns(ms.LoadWarning) as told:
        table.forces(0, [1, 0, -1, 2], [9, 0.19 / size, 0, 0.201 / size], **{**WHEEL, "peak_traction": normalised})
    assert [str(one.message).partition(":")[0] for one in told] == [
        "lateral_creepage[2] = -1", f"spin[3] = {0.201 / size:.6g}",
        f"the largest traction, {WHEEL['shear_modulus']:.3g} N/mm^2, is 1 of the shear modulus, "
        f"{WHEEL['shear_modulus']:.6g} N/mm^2, and strains have to be small; numbers are in N, mm and N/mm^2"]


@pytest.mark.parametrize("modulus, message", [
    ({"shear_modulus": 82}, "^the largest traction, "), ({"youngs_modulus": 2.1e11}, "^a shear modulus of 8.2e"),
    ({"youngs_modulus": 210}, "^the largest traction, ")])
def test_moduli_in_other_units_are_warned_of(table, modulus, message):
    contact = {name: value for name, value in WHEEL.items() if not name.endswith("_modulus")}
    with pytest.warns(ms.LoadWarning, match=message):
        table.forces(1e-9, **contact, **modulus)


def test_stated_errors_are_in_order(table):
    assert table.poisson_ratio == 0.28 and table.states > 1000
    assert table.ratios == pytest.approx((0.1, 10), rel=1e-12)
    rms, most, largest = table.errors
    assert np.all(0 < rms) and np.all(rms < most) and np.all(most < largest) and np.all(largest < 0.05)
    assert rms.shape == (3,) and "a/b from 0.1 to 10" in repr(table)


def test_strong_creepage_is_full_sliding(table, random):
    """Full sliding against the motion. Between its nodes the table is off by up to 4e-4 for a/b from 1/2 to 2, and for
    slender ellipses by up to 0.018."""
    given = generated(random, 200, table)
    angle = random.uniform(0, 2 * np.pi, 200)
    given.update(creepage=100 * np.cos(angle), lateral_creepage=100 * np.sin(angle), spin=np.zeros(200))
    found = over_full_sliding(table.forces(**given, **STEEL), given)
    off = np.abs(found - np.stack([-np.cos(angle), -np.sin(angle), 0 * angle], -1))
    assert np.all(off < 0.02)
    is_compact = np.abs(np.log(given["half_width"] / given["lateral_half_width"])) < np.log(2)
    assert is_compact.sum() > 20 and np.all(off[is_compact] < 1e-3)


def test_slopes_at_rest_are_kalkers(table):
    """C11, C22, C23, C33 of Kalker, Three-Dimensional Elastic Bodies in Rolling Contact (1990), table E3, for nu = 0, 1/4
    and 1/2, of which a parabola gives those for 0.28. They are right to half a percent on a circle."""
    printed = np.array([[3.40, 3.40, 0.98, 1.31], [4.12, 3.67, 1.47, 1.19], [5.20, 3.98, 1.63, 1.16]])
    nu, at = np.array([0, 0.25, 0.5]), 0.28
    c11, c22 = (np.polyval(np.polyfit(nu, printed[:, i], 2), at) for i in range(2))
    size, modulus = 5, STEEL["shear_modulus"]
    _, jacobian = table.forces(half_width=size, lateral_half_width=size, peak_traction=300, **STEEL, jacobian=True)
    assert jacobian[0, 0] == pytest.approx(-modulus * size**2 * c11, rel=0.01)
    assert jacobian[1, 1] == pytest.approx(-modulus * size**2 * c22, rel=0.01)
    assert jacobian[1, 2] == pytest.approx(-jacobian[2, 1], rel=1e-7)  # nodes are in single precision
    assert jacobian[[0, 0, 1, 2], [1, 2, 0, 0]] == pytest.approx(0, abs=1e-9 * modulus)
    creepage = 1e-7
    small = table.forces(creepage, half_width=size, lateral_half_width=size, peak_traction=300, **STEEL)
    assert small.force == pytest.approx(jacobian[0, 0] * creepage, rel=1e-3)


def require_slopes(table, given):
    """Differences over 1e-5 of mu p0/G are off by up to 1.3e-6, as third derivatives are large close to pure spin."""
    _, jacobian = table.forces(**given, **STEEL, jacobian=True)
    size = np.sqrt(given["half_width"] * given["lateral_half_width"])
    strain = given["peak_traction"] / STEEL["shear_modulus"]
    assert jacobian.shape == size.shape + (3, 3)
    for j, (name, unit) in enumerate({"creepage": strain, "lateral_creepage": strain, "spin": strain / size}.items()):
        step = 1e-5 * unit
        above, below = (over_full_sliding(table.forces(**{**given, name: given[name] + sign * step}, **STEEL), given)
                        for sign in (1, -1))
        slopes = over_full_sliding(np.moveaxis(jacobian[:, :, j], -1, 0) * unit, given)
        assert (above - below) / 2e-5 == pytest.approx(slopes, abs=2e-5)
        assert np.abs(slopes).max() > 0.5


def test_the_jacobian_has_the_slopes_of_the_forces(table, random):
    given = generated(random, 500, table)
    is_pure_spin = (given["creepage"] == 0) & (given["lateral_creepage"] == 0)
    require_slopes(table, {name: values[~is_pure_spin] for name, values in given.items()})


def test_so_it_has_at_pure_spin(table, random):
    given = generated(random, 100, table)
    given["creepage"] = random.choice([0.0, -0.0], 100)
    given["lateral_creepage"] = random.choice([0.0, -0.0], 100)
    given["spin"] = given["peak_traction"] / STEEL["shear_modulus"] * random.uniform(-1, 1, 100)
    require_slopes(table, given)


def test_arrays_are_broadcast(table, random):
    given = generated(random, 12, table)
    many, slopes = table.forces(given["creepage"][:, None], given["lateral_creepage"][:4], spin=1e-4,
                                half_width=6, lateral_half_width=random.uniform(2, 9, 4), peak_traction=300, **STEEL,
                                jacobian=True)
    assert many.force.shape == (12, 4) and slopes.shape == (12, 4, 3, 3)
    columns = [given[name] for name in ("creepage", "lateral_creepage", "spin")]
    contact = {name: given[name] for name in ("half_width", "lateral_half_width", "peak_traction")}
    all_of_them = table.forces(*columns, **contact, **STEEL)
    for k in range(12):
        one, slope = table.forces(*(column[k] for column in columns), **STEEL, jacobian=True,
                                  **{name: value[k] for name, value in contact.items()})
        assert isinstance(one.force, float) and slope.shape == (3, 3)
        assert tuple(one) == tuple(column[k] for column in all_of_them)
    assert table.forces(**WHEEL) == (0, 0, 0)
    assert table.forces([], **WHEEL).force.shape == (0,)
    young = {**WHEEL, "shear_modulus": None, "youngs_modulus": 2 * 1.28 * 82000}
    assert table.forces(1e-3, **young) == pytest.approx(table.forces(1e-3, **WHEEL), rel=1e-12)


def test_parts_of_long_arrays_are_the_whole(table, random, monkeypatch):
    given = generated(random, 50, table)
    whole, slopes = table.forces(**given, **STEEL, jacobian=True)
    monkeypatch.setattr(_creep_table, "_AT_ONCE", 7)
    parts, slopes_of_parts = table.forces(**given, **STEEL, jacobian=True)
    assert np.array_equal(whole, parts) and np.array_equal(slopes, slopes_of_parts)


def test_copies_and_files_are_the_same_table(table, source):
    expected = table.forces(1e-3, -5e-4, 2e-4, **WHEEL)
    by_path = ms.CreepTable(source / "tables/creep_forces.nc")
    for other in (by_path, copy.copy(table), copy.deepcopy(by_path), pickle.loads(pickle.dumps(table)),
                  pickle.loads(pickle.dumps(by_path))):
        assert other.forces(1e-3, -5e-4, 2e-4, **WHEEL) == expected


def test_threads_share_a_table(table, random):
    given = generated(random, 20000, table)
    expected, found = table.forces(**given, **STEEL), [None] * 4

    def look_up(k):
        found[k] = table.forces(**given, **STEEL)

    threads = [threading.Thread(target=look_up, args=(k,)) for k in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert all(np.array_equal(one, expected) for one in found)


@pytest.mark.parametrize("given, message", [
    ({"half_width": 50}, "^half_width = 50: expected from 0.45 to 45 with lateral_half_width = 4.5, as the table has a/b "
                         "from 0.1 to 10$"),
    ({"half_width": [6, 0.4]}, r"^half_width\[1\] = 0.4: expected from 0.45 to 45"),
    ({"half_width": None}, "^half_width = None: expected a number or an array"),
    ({"half_width": -6, "lateral_half_width": -4.5}, "^half_width = -6: expected a number > 0"),
    ({"peak_traction": [[300], [0]]}, r"^peak_traction\[1, 0\] = 0: expected a number > 0"),
    ({"peak_traction": np.inf}, "^peak_traction = inf: expected a number > 0"),
    ({"poisson_ratio": 0.3}, "^poisson_ratio = 0.3: expected that of the table, 0.28"),
    ({"poisson_ratio": -1, "shear_modulus": None, "youngs_modulus": 2e5}, "^poisson_ratio = -1: expected"),
    ({"poisson_ratio": [0.28, 0.28]}, "^poisson_ratio: expected a number, not an array of 2"),
    ({"shear_modulus": -1}, "^shear_modulus = -1: expected a number > 0"),
    ({"shear_modulus": np.nan}, "^shear_modulus = nan: expected a number > 0"),
    ({"youngs_modulus": 2e5}, "^youngs_modulus: expected either youngs_modulus or shear_modulus"),
    ({"creepage": np.nan}, "^creepage = nan: expected a number"),
    ({"spin": [0, np.inf]}, r"^spin\[1\] = inf: expected a number"),
    ({"spin": "fast"}, "^spin = 'fast': expected numbers"),
    ({"spin": [0, 1e200]}, "^contact 1: spin = 1e[+]200: expected a motion of at most 1e100 times peak_traction over"),
    ({"spin": 1e200}, "^spin = 1e[+]200: expected a motion of at most 1e100 times"),
    ({"spin": [0, 1], "creepage": [0, 1, 2]}, "^creepage: expected arrays that numpy broadcasts")])
def test_bad_input_is_named(table, given, message):
    with pytest.raises(ms.InputError, match=message):
        table.forces(**{**WHEEL, **given})


def test_files_that_are_no_tables_are_named(tmp_path, source):
    with pytest.raises(ms.InputError, match="^cannot read .*nowhere.nc: expected a table's file") as told:
        ms.CreepTable(tmp_path / "nowhere.nc")
    assert told.value.key == "path"
    whole = (source / "tables/creep_forces.nc").read_bytes()
    for name, text in (("text", b"text"), ("half", whole[:len(whole) // 2]), ("changed", whole[:-1] + b"\1")):
        (tmp_path / name).write_bytes(text)
        with pytest.raises(ms.InputError, match=f"^{re.escape(str(tmp_path / name))}: [^\n]*$"):
            ms.CreepTable(tmp_path / name)
    with pytest.raises(ms.InputError, match="^path = .*: expected a path without NUL"):
        ms.CreepTable("a\0b")


@pytest.mark.parametrize("page", ["python", "creep_tables"])
def test_the_example_of_the_page_has_the_values_that_it_prints(page, source):
    """An expression with a comment has the value of the comment."""
    text = (source / f"docs/{page}.md").read_text(encoding="utf-8")
    block, = (one for one in re.findall(r"^```python\n(.*?)^```", text, re.MULTILINE | re.DOTALL) if "CreepTable" in one)
    names, compared = {"np": np}, 0
    for statement in ast.parse(block).body:
        code = ast.unparse(statement)
        printed = block.splitlines()[statement.end_lineno - 1].partition("  # ")[2]
        if isinstance(statement, ast.Expr) and printed:
            assert repr(eval(code, names)) == printed.strip(), code  # pylint: disable=eval-used
            compared += 1
        else:
            exec(code, names)  # pylint: disable=exec-used
    assert compared >= 2
