# SPDX-License-Identifier: GPL-3.0-or-later
"""Data as people have them: arrays of any kind give what the same numbers in a file give, or an error that names
column and row."""
import array
import datetime
import decimal
import fractions
import os
import re

import numpy as np
import pytest

import microslip as ms

try:
    import pandas
except ImportError:
    pandas = None

pytestmark = pytest.mark.filterwarnings("ignore::microslip.LoadWarning")  # of loads at random

# MICROSLIP_DATA_CASES=5000 tries as many.
CASES = int(os.environ.get("MICROSLIP_DATA_CASES", "150"))

STAMP = np.datetime64("2024-02-28T23:59:58", "ns")


@pytest.fixture(name="run")
def transient_scene(scene):
    """A run, the load of which is still missing."""
    return {**scene, "grid": {"elements": 11}, "problem": "transient", "start": {"type": "rest"},
            "solver": {"violation": 1}}


def strided(values):
    """The values in every third place of a larger array, from its end."""
    wide = np.full(3 * len(values) + 2, np.nan)
    wide[-3::-3][:len(values)] = values
    return wide[-3::-3][:len(values)]


def frozen(values):
    values = np.array(values)
    values.flags.writeable = False
    return values


# Ways to give numbers; each takes a list of floats that are multiples of 1/8, below 1000 in size.
WAYS = {
    "list": list, "tuple": tuple, "f8": np.array, "f4": lambda v: np.array(v, "f4"), "f2": lambda v: np.array(v, "f2"),
    ">f8": lambda v: np.array(v, ">f8"), ">f4": lambda v: np.array(v, ">f4"), "g": lambda v: np.array(v, "g"),
    "strided": strided, "frozen": frozen, "column": lambda v: np.asfortranarray(np.c_[v, np.zeros(len(v))])[:, 0],
    "row": lambda v: np.c_[np.zeros(len(v)), v][:, 1], "object": lambda v: np.array(v, object),
    "decimal": lambda v: [decimal.Decimal(one) for one in v], "fraction": lambda v: [fractions.Fraction(one) for one in v],
    "text": lambda v: [repr(one) for one in v], "texts": lambda v: np.array([repr(one) for one in v]),
    "array": lambda v: array.array("d", v), "masked": np.ma.array,
    "no mask": lambda v: np.ma.array(v, mask=[False] * len(v)), "scalars": lambda v: [np.float32(one) for one in v],
    "points": lambda v: [np.array(one) for one in v], "mixed": lambda v: [np.float64(v[0]), *v[1:]],
}
WHOLE = {"ints": lambda v: [int(one) for one in v], "i2": lambda v: np.array(v, "i2"), ">i4": lambda v: np.array(v, ">i4"),
         "u8": lambda v: np.array(np.abs(v), "u8") if min(v) >= 0 else np.array(v, "i8"),
         "object ints": lambda v: np.array([int(one) for one in v], object)}
if pandas:
    WAYS.update({"series": lambda v: pandas.Series(v, index=range(len(v), 0, -1)), "Index": pandas.Index,
                 "Float64": lambda v: pandas.array(v, dtype="Float64"),
                 "series of Float64": lambda v: pandas.Series(v, dtype="Float64")})
    WHOLE["Int64"] = lambda v: pandas.Series([int(one) for one in v], dtype="Int64")


def spoilt(way):
    """Puts something that is no number into one row of an array of objects."""

    def spoil(values, row):
        found = np.empty(len(values), object)
        found[:] = values
        found[row] = way(values[row])
        return found

    return spoil


def masked(values, row):
    return np.ma.array(values, mask=[k == row for k in range(len(values))])


def with_one(kind, value):
    def spoil(values, row):
        found = np.array(values, kind)
        found[row] = value(values[row])
        return found

    return spoil


# Ways to spoil one row.
SPOILT = {
    "masked": masked, "None": spoilt(lambda _: None), "nan": with_one("f8", lambda _: np.nan),
    "nan object": spoilt(lambda _: float("nan")), "inf": with_one("f4", lambda _: -np.inf),
    "complex": with_one("c16", lambda one: one + 1j), "complex object": spoilt(lambda one: np.complex128(one)),
    "True": spoilt(lambda _: True), "numpy bool": spoilt(lambda _: np.bool_(False)), "word": spoilt(lambda _: "x"),
    "1_0": spoilt(lambda _: "1_0"), "blank": spoilt(lambda _: ""), "bytes": spoilt(lambda _: b"12"),
    "day": spoilt(lambda _: datetime.date(2024, 1, 1)), "stamp": spoilt(lambda _: STAMP),
    "delta": spoilt(lambda _: np.timedelta64(3, "s")), "huge": spoilt(lambda _: 10**400),
    "list": spoilt(lambda one: [one]), "array": spoilt(lambda one: np.array([one])),
    "masked object": spoilt(lambda _: np.ma.masked), "list of masked": lambda v, row: list(masked(v, row)),
}
if pandas:
    SPOILT.update({"NA": spoilt(lambda _: pandas.NA), "NaT": spoilt(lambda _: pandas.NaT),
                   "Float64": lambda v, row: pandas.Series([None if k == row else one for k, one in enumerate(v)],
                                                           dtype="Float64")})


def written(folder, columns):
    """The same columns in a file that this test writes."""
    path = folder / "run.tsv"
    np.savetxt(path, np.array(list(columns.values())).T, header="\t".join(columns), comments="", delimiter="\t",
               fmt="%.17g")
    return path


def rows_of(random):
    """A run by distance, of numbers that float16 holds."""
    rows = int(random.integers(2, 6))
    q = np.cumsum(random.integers(1, 9, rows)) / 8
    names = ["q", *[("creepage", "force")[random.integers(2)]]]
    columns = {names[0]: q, names[1]: random.integers(0, 3, rows) / 128.0 if names[1] == "creepage"
               else random.integers(-999, 999, rows) / 1.0}
    if random.integers(2):
        columns["half_width"] = random.integers(35, 45, rows) / 8.0
    return columns


def test_any_kind_of_array_is_what_a_file_is(run, random, tmp_path):
    for _ in range(CASES):
        columns = rows_of(random)
        by_file = ms.solve(run, load={"file": written(tmp_path, columns)})
        given = {}
        for name, values in columns.items():
            ways = {**WAYS, **WHOLE} if np.all(values == np.round(values)) and name != "creepage" else WAYS
            way = list(ways)[random.integers(len(ways))]
            if way in ("f2", "texts") and name == "creepage":
                way = "f8"
            given[name] = ways[way]([float(one) for one in values])
        if random.integers(2):
            given["gear"] = ["two"] * len(columns["q"])
        by_arrays = ms.solve(run, load={"file": given})
        assert np.array_equal(by_arrays.history, by_file.history), given
        assert np.array_equal(by_arrays.traction, by_file.traction), given


def test_what_is_no_number_is_named_with_its_column_and_row(run, random):
    for _ in range(CASES):
        columns = {name: [float(one) for one in values] for name, values in rows_of(random).items()}
        name = list(columns)[random.integers(len(columns))]
        row = int(random.integers(len(columns["q"])))
        way = list(SPOILT)[random.integers(len(SPOILT))]
        given = {**columns, name: SPOILT[way](columns[name], row)}
        with pytest.raises(ms.InputError) as caught:
            ms.solve(run, load={"file": given})
        assert re.match(rf"load\.file: column '{name}', row {row + 1}: .*: expected ", str(caught.value)), (way, given)
        assert caught.value.key == "load.file" and "\n" not in str(caught.value)
        # In a column that is not read, nothing is wrong.
        other = {**columns, "remark": SPOILT[way](columns[name], row)}
        assert ms.solve(run, load={"file": other}).summary.force == ms.solve(run, load={"file": columns}).summary.force


def test_arguments_of_functions_take_the_same_arrays(scene, random):
    contact = ms.Rolling(scene, grid_elements=11)
    for _ in range(CASES):
        dq = [float(one) for one in random.integers(1, 9, int(random.integers(1, 5))) / 8]
        way, spoil = (list(table)[random.integers(len(table))] for table in (WAYS, SPOILT))
        states = contact.copy().roll(WAYS[way](dq), creepage=0.001)
        assert np.array_equal(states, contact.copy().roll(np.array(dq), creepage=0.001)), way
        loads = [one - 1 for one in dq]
        assert np.array_equal(ms.steady(scene, force=WAYS[way](loads)).creepage, ms.steady(scene, force=loads).creepage)
        row = int(random.integers(len(dq)))
        for call in (lambda bad: contact.roll(bad, creepage=0), lambda bad: contact.roll(0.1, creepage=bad),
                     lambda bad: ms.steady(scene, force=bad), lambda bad: ms.steady(scene, creepage=bad)):
            with pytest.raises(ms.InputError) as caught:
                call(SPOILT[spoil](dq, row))
            assert "\n" not in str(caught.value)
            assert str(row) in str(caught.value) or len(dq) == 1, (spoil, str(caught.value))


SINGLE = {"0-d": np.array, "0-d f4": lambda one: np.array(one, "f4"), "0-d >f8": lambda one: np.array(one, ">f8"),
          "0-d object": lambda one: np.array(one, object), "f4": np.float32, "f2": np.float16, "g": np.longdouble,
          "decimal": decimal.Decimal, "fraction": fractions.Fraction, "0-d masked": np.ma.array,
          "slice": lambda one: np.array([one, 1])[0, ...]}
NO_SINGLE = {"masked": lambda _: np.ma.masked, "0-d masked": lambda one: np.ma.array(one, mask=True),
             "complex": complex, "0-d masked int": lambda _: np.ma.array(3, mask=True),
             "0-d complex": lambda one: np.array(one + 0j), "True": lambda _: np.array(True),
             "delta": lambda one: np.timedelta64(int(one), "s"), "stamp": lambda _: STAMP,
             "0-d stamp": lambda _: np.array(STAMP), "date": lambda _: datetime.date(2024, 1, 1)}


@pytest.mark.parametrize("way", SINGLE)
def test_an_array_without_dimensions_is_a_number(scene, way):
    one = SINGLE[way]
    given = {**scene, "problem": "steady"}
    assert ms.solve(given, load_force=one(-500.0)).summary.force == -500
    assert ms.solve(given, load_force=-500, contact={"half_width": one(4.5)}).parameters["contact.half_width"] == "4.5"
    assert ms.solve(given, load_force=-500, grid={"elements": np.array(12)}).parameters["grid.elements"] == "12"
    assert ms.steady(scene, force=one(-500.0)).creepage == ms.steady(scene, force=-500).creepage
    contact, twin = ms.Rolling(scene), ms.Rolling(scene)
    contact.set_contact(one(1.125), one(1.0))
    twin.set_contact(1.125, 1)
    assert contact.roll(one(0.125), creepage=one(0.0625)).item() == twin.roll(0.125, creepage=0.0625).item()
    assert contact.attempt(one(0.25), force=one(8.0)).item() == twin.attempt(0.25, force=8).item()
    assert contact.shift(force=one(16.0)).item() == twin.shift(force=16).item()
    assert len(ms.sweep(given, {"load.force": [one(-500.0), one(-400.0)]})) == 2


@pytest.mark.parametrize("way", NO_SINGLE)
def test_what_is_no_number_is_refused_in_a_line(scene, way):
    given = {**scene, "problem": "steady", "load.force": -500}
    contact = ms.Rolling(scene)
    for call in (lambda bad: ms.solve(given, load_force=bad), lambda bad: ms.solve(given, contact={"half_width": bad}),
                 lambda bad: ms.solve(given, contact={"peak_traction": 1, "bound_polynomial": bad}),
                 lambda bad: ms.sweep(given, {"load.force": [-1, bad]}), lambda bad: ms.steady(scene, force=bad),
                 lambda bad: contact.attempt(bad, creepage=0), lambda bad: contact.set_contact(bad, 1),
                 lambda bad: contact.shift(force=bad), lambda bad: contact.start_from_shift(bad)):
        with pytest.raises(ms.InputError) as caught:
            call(NO_SINGLE[way](3.0))
        assert "\n" not in str(caught.value)


def test_lists_have_an_order_and_something_in_them(scene):
    for bad in (set((1.0, 2.0)), [], np.ma.array([1.0, 2.0], mask=[False, True]), np.eye(2), b"12", [1, True],
                np.array([1, 1j]), np.arange(3).astype("m8[s]"), [1, None]):
        with pytest.raises(ms.InputError) as caught:
            ms.solve(scene, problem="transient", load_creepage=0.001, motion_distance=1, start_type="rest",
                     step={"ratio": bad})
        assert "\n" not in str(caught.value) and caught.value.key == "step.ratio"
    large = np.arange(60.0).reshape(3, 20)
    for call in (lambda: ms.steady(scene, creepage=[large, 1]), lambda: ms.Rolling(scene, grid_elements=large),
                 lambda: ms.Rolling(scene).roll(large, creepage=0), lambda: ms.Rolling(large)):
        with pytest.raises(ms.InputError) as caught:
            call()
        assert "\n" not in str(caught.value) and len(str(caught.value)) < 250


# Clocks: each takes whole seconds from a beginning of its own, and a divisor of them.
def stamps(unit):
    return lambda ticks: np.datetime64("2024-02-28T23:59:58", unit) + np.array(ticks).astype(f"m8[{unit}]")


PARTS = {"s": 1, "ms": 10**3, "us": 10**6, "ns": 10**9}
CLOCKS = {**{f"M8[{unit}]": (stamps(unit), parts) for unit, parts in PARTS.items()},
          **{f"m8[{unit}]": (lambda ticks, unit=unit: np.array(ticks).astype(f"m8[{unit}]") + np.timedelta64(77, unit), parts)
             for unit, parts in PARTS.items()},
          ">M8[us]": (lambda ticks: stamps("us")(ticks).astype(">M8[us]"), 10**6),
          "M8[25ns]": (lambda ticks: np.array(ticks).astype("M8[25ns]"), 4 * 10**7),
          "m8[h]": (lambda ticks: np.array(ticks).astype("m8[h]"), 1 / 3600),
          "M8[D]": (lambda ticks: np.datetime64("2023-12-30", "D") + np.array(ticks), 1 / 86400),
          "strided": (lambda ticks: np.repeat(stamps("ms")(ticks), 2)[::2], 10**3),
          "masked": (lambda ticks: np.ma.array(stamps("ms")(ticks)), 10**3),
          "datetime": (lambda ticks: [datetime.datetime(2024, 2, 28, 23, 59, 58) + datetime.timedelta(milliseconds=t)
                                      for t in ticks], 10**3),
          "timedelta": (lambda ticks: [datetime.timedelta(seconds=5, microseconds=t) for t in ticks], 10**6),
          "date": (lambda ticks: [datetime.date(2024, 2, 27) + datetime.timedelta(days=t) for t in ticks], 1 / 86400),
          "object": (lambda ticks: np.array(list(stamps("ns")(ticks)), object), 10**9)}
if pandas:
    BERLIN = "2024-10-27 02:59:59"  # a second before the clocks go back
    CLOCKS.update({
        "DatetimeIndex": (lambda ticks: pandas.DatetimeIndex(stamps("ns")(ticks)), 10**9),
        "TimedeltaIndex": (lambda ticks: pandas.TimedeltaIndex(np.array(ticks).astype("m8[ns]")), 10**9),
        "Series": (lambda ticks: pandas.Series(stamps("ns")(ticks), index=np.arange(len(ticks))[::-1]), 10**9),
        "zone": (lambda ticks: pandas.DatetimeIndex(stamps("ns")(ticks)).tz_localize("UTC").tz_convert("Europe/Berlin"),
                 10**9),
        "summer": (lambda ticks: pandas.Series(pandas.Timestamp(BERLIN).tz_localize("Europe/Berlin", ambiguous=True)
                                               + pandas.to_timedelta(ticks, unit="s")), 1),
        "Timestamps": (lambda ticks: [pandas.Timestamp(one) for one in stamps("ns")(ticks)], 10**9),
        "Timestamps of a zone": (lambda ticks: list(
            pandas.Timestamp(BERLIN).tz_localize("Europe/Berlin", ambiguous=True)
            + pandas.to_timedelta(ticks, unit="s")), 1),
        "Timedeltas": (lambda ticks: [pandas.Timedelta(t, "ns") for t in ticks], 10**9)})


def run_over_time(random):
    """Ticks of a clock and what is measured at them."""
    rows = int(random.integers(2, 6))
    ticks = np.concatenate([[0], np.cumsum(random.integers(1, 50, rows - 1))])
    return [int(t) for t in ticks], random.uniform(0, 2e-3, rows)


def test_times_are_seconds_from_the_first(run, random):
    names = list(CLOCKS)
    for k in range(max(CASES, 2 * len(names))):
        clock, parts = CLOCKS[names[k % len(names)]]
        ticks, creepage = run_over_time(random)
        v = np.full(len(ticks), 2.0 * parts)  # mm a tick, twice
        expected = ms.solve(run, load={"file": {"t [s]": np.array(ticks) / parts, "v": v, "creepage": creepage}})
        for name in ("t", "t [s]", "t (s)"):
            found = ms.solve(run, load={"file": {name: clock(ticks), "v": v, "creepage": creepage}})
            assert found.history["q"][-1] == pytest.approx(2 * ticks[-1], rel=1e-12), names[k % len(names)]
            for column in expected.history.dtype.names:
                assert np.allclose(found.history[column], expected.history[column], rtol=1e-6, atol=1e-12), column
        with pytest.raises(ms.InputError, match=r"^load.file: column 't \[ms\]': expected no unit"):
            ms.solve(run, load={"file": {"t [ms]": clock(ticks), "v": v, "creepage": creepage}})
        for other in ("v", "creepage"):
            bad = {"t": ticks, "v": v, "creepage": creepage, other: clock(ticks)}
            with pytest.raises(ms.InputError, match=rf"^load.file: column '{other}', row 1: .*expected numbers; times"):
                ms.solve(run, load={"file": bad})
        with pytest.raises(ms.InputError, match="times are accepted in the column t"):
            ms.Rolling(run).roll(clock(ticks), creepage=0)


def test_times_that_are_missing_or_no_length_are_named(run):
    v, w = np.full(3, 10.0), np.full(3, 1e-3)
    day = datetime.datetime(2024, 1, 1)
    cases = {3: [[day, day + datetime.timedelta(seconds=1), None],
                 [day, day + datetime.timedelta(seconds=1), day.replace(tzinfo=datetime.timezone.utc)],
                 [day, day + datetime.timedelta(seconds=1), datetime.timedelta(1)],
                 [day, day + datetime.timedelta(seconds=1), "2024-01-02"],
                 np.array(["2024-01-01", "2024-01-02", "NaT"], "M8[ns]"),
                 np.ma.array(stamps("s")([0, 1, 2]), mask=[False, False, True])],
             1: [np.array([0, 1, 2], "m8[M]"), np.array([0, 1, 2], "m8"), np.array([-2**62 - 9, 0, 2**62], "M8[as]"),
                 ["2024-01-01", "2024-01-02", "2024-01-03"]]}
    for row, values in cases.items():
        for t in values:
            with pytest.raises(ms.InputError, match=rf"^load.file: column 't', row {row}: "):
                ms.solve(run, load={"file": {"t": t, "v": v, "creepage": w}})
    years = ms.solve(run, load={"file": {"t": np.array(["2023", "2024", "2025"], "M8[Y]"), "v": v / 1e8, "creepage": w}})
    assert years.history["t"][-1] == (365 + 366) * 86400


def test_frames_have_their_times_in_the_index(run, random):
    pytest.importorskip("pandas")
    for _ in range(max(10, CASES // 10)):
        ticks, creepage = run_over_time(random)
        v = np.full(len(ticks), 3e3)
        expected = ms.solve(run, load={"file": {"t": np.array(ticks) / 1e3, "v": v, "creepage": creepage}}).history
        frame = pandas.DataFrame({"v": v, "creepage": creepage}, index=pandas.DatetimeIndex(stamps("ms")(ticks)))
        named = frame.rename_axis("recorded")
        spans = frame.set_axis(pandas.to_timedelta(ticks, unit="ms"))
        floats = frame.set_axis(pandas.Index(np.array(ticks) / 1e3, name="t"))
        units = frame.set_axis(pandas.Index(np.array(ticks) * 1.0, name="t [ms]"))
        column = frame.reset_index(names="t")
        for one in (frame, named, spans, floats, units, column, frame.tz_localize("Europe/Berlin")):
            found = ms.solve(run, load={"file": one}).history
            for name in expected.dtype.names:
                assert np.allclose(found[name], expected[name], rtol=1e-9, atol=1e-12), one
        by_distance = frame.rename(columns={"v": "q"}).assign(q=np.arange(len(ticks)) * 1.0)
        assert "t" not in ms.solve(run, load={"file": by_distance}).history.dtype.names
        with pytest.raises(ms.InputError, match="q or t"):
            ms.solve(run, load={"file": frame.reset_index(drop=True)})


def test_columns_of_the_user_get_other_names(run, random):
    for _ in range(max(10, CASES // 10)):
        ticks, slip = run_over_time(random)
        t, speed = np.array(ticks) / 1e3, np.full(len(ticks), 10.8)
        expected = ms.solve(run, load={"file": {"t": t, "v": speed / 3.6 * 1e3, "creepage": slip}}).history
        data = {"Time, of day": ticks, "Speed [km/h]": speed, "Slip (rear)": slip * 1e2, "gear": ["two"] * len(ticks)}
        data = {name.replace("Time, of day", "Time, of day [ms]").replace("(rear)", "(%)"): v for name, v in data.items()}
        names = {"t": "Time, of day", "v": "Speed [km/h]", "creepage": "Slip"}
        tables = [data, np.rec.fromarrays(list(data.values())[:3], names=list(data)[:3])]
        if pandas:
            tables += [pandas.DataFrame(data), pandas.DataFrame(data).set_index("Time, of day [ms]")]
        for table in tables:
            own = names if table is not tables[-1] or not pandas else {**names, "t": "Time, of day [ms]"}
            for given in ({"load": {"file": table, "columns": own}}, {"load_file": table, "load_columns": own},
                          {"load.columns": own, "load.file": table}):
                found = ms.solve(run, **given).history
                for name in expected.dtype.names:
                    assert np.allclose(found[name], expected[name], rtol=1e-9, atol=1e-12)


def test_columns_of_an_ellipse_get_other_names_and_units(ellipse):
    run = {**ellipse, "problem": "transient", "start": {"type": "rest"}}
    t, v = np.array([0.0, 0.001, 0.004]), np.full(3, 1000.0)
    motions = {"creepage": np.full(3, 1e-3), "lateral_creepage": np.full(3, -5e-4), "spin": np.full(3, 1e-4)}
    expected = ms.solve(run, load={"file": {"t": t, "v": v, **motions}}).history
    data = {"Time": 1e3 * t, "Speed": v / 1e3, "Slip": 1e2 * motions["creepage"], "Side": motions["lateral_creepage"],
            "Turn": 1e3 * motions["spin"]}
    names = {"t": "Time [ms]", "v": "Speed [m/s]", "creepage": "Slip [%]", "lateral_creepage": "Side",
             "spin": "Turn [1/m]"}
    found = ms.solve(run, load={"file": data, "columns": names}).history
    for name in expected.dtype.names:
        assert np.allclose(found[name], expected[name], rtol=1e-9, atol=1e-12), name


@pytest.mark.parametrize("names, message", [
    ({"time": "Time"}, r"^load.columns: unknown column 'time'.*: expected q, t, v"),
    ({"V": "Speed"}, r"^load.columns: unknown column 'V'"),
    ({"t": "Tme"}, r"^load.columns: t = 'Tme' \(did you mean 'Time'\?\): expected one of the columns of the table, which"),
    ({"t": "Time", "q": "Time"}, r"^load.columns: q = 'Time': expected another column than that of t"),
    ({"t": 5}, r"^load.columns: t = '5': expected one of the columns"),
    ({"t": "Time"}, r"'v'.*found more of that name")])
def test_names_that_are_not_there_are_refused(run, names, message):
    data = {"Time": [0, 1], "Speed": [1, 1], "v": [1, 1], "creepage": [0, 0]}
    whole = {"v": "Speed", **names} if names == {"t": "Time"} else names
    with pytest.raises(ms.InputError, match=message) as caught:
        ms.solve(run, load={"file": data, "columns": whole})
    assert "\n" not in str(caught.value)


def test_headers_of_any_text_stay_in_their_column(run):
    q, w = [0.0, 1.0, 3.0], [1e-3, 0, 1e-3]
    expected = ms.solve(run, load={"file": {"q": q, "creepage": w}}).history
    for name in ("a b", "a,b", "a;b", "# a", "", "a\nb", "a\tb", '"a"', "[a", "ü", "\u2028", 5, "a [b", "a]"):
        for data in ({name: [9, 9, 9], "q": q, "creepage": w}, {"q": q, name: [9, 9, 9], "creepage": w}):
            found = ms.solve(run, load={"file": data}).history
            assert np.array_equal(found, expected), name


def test_a_patch_of_arrays_is_that_of_files(tmp_path):
    y = np.linspace(-4, 4, 9)
    half = 3 * np.sqrt(1 - (y / 4)**2) * (1 + y / 20)
    edges = np.c_[y, -half, half]
    x, y = (np.ravel(one) for one in np.meshgrid(np.linspace(-3, 3, 13), np.linspace(-3.5, 3.5, 15)))
    inside = np.abs(x) < 0.99 * 3 * np.sqrt(1 - (y / 4)**2) * (1 + y / 20)
    points = np.c_[x, y, 200 - x**2 - y**2][inside]
    files = {}
    for name, table, header in (("edges", edges, "y\ttrailing\tleading"), ("points", points, "x\ty\tbound")):
        files[name] = str(tmp_path / f"{name}.tsv")
        np.savetxt(files[name], table, fmt="%.17g", delimiter="\t", header=header, comments="")
    of_all = {"problem": "steady", "material": {"shear_modulus": 82000, "poisson_ratio": 0.28},
              "grid": {"rows": 6, "elements": 6}, "load": {"creepage": 0.001, "spin": 1e-4}}
    of_files = ms.solve(of_all, contact={"patch_file": files["edges"], "bound_file": files["points"]})
    of_arrays = ms.solve(of_all, contact={"patch_file": edges, "bound_file": tuple(points.T)})
    np.testing.assert_array_equal(of_arrays.traction, of_files.traction)
    assert of_arrays.summary.force < 0
    with pytest.raises(ms.InputError, match="or the arrays .y, trailing, leading."):
        ms.solve(of_all, contact={"patch_file": edges[:, :2], "bound_file": points})
