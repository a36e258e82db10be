# SPDX-License-Identifier: GPL-3.0-or-later
"""Turns numbers and arrays into what the library takes.

A value that is no number is refused: one that is masked or missing, a complex number, True and False, and a time.
"""

from __future__ import annotations

import datetime
import numbers as abstract
from typing import Any, Dict, Mapping, Tuple, Union

import numpy as np

from ._errors import InputError

#: A number, or an array of them.
Values = Union[float, "np.typing.ArrayLike", None]

_NUMBERS = "numbers"
_REAL = "real numbers"
_THERE = "numbers, none of which is masked or missing"
_NOT_BOOLS = "numbers, not True or False"
_NOT_TIMES = "numbers; times are accepted in the column t of load.file"
_NOT_BYTES = "numbers, not bytes"
_TIMES = (np.datetime64, np.timedelta64, datetime.date, datetime.timedelta)


class NotNumber(ValueError):
    """One value of several is not accepted.

    index     its place in the array
    value     as it is shown
    expected  what is accepted
    """

    def __init__(self, index: Tuple[int, ...], value: str, expected: str):
        super().__init__(value, expected)
        self.index, self.value, self.expected = index, value, expected


def shown(value: Any, most: int = 60) -> str:
    """Shows a value in one short line."""
    text = " ".join((value if isinstance(value, str) else repr(value)).split())
    return text if len(text) <= most else text[:most - 3] + "..."


def number_of(value: Any) -> float:
    """Returns the float of a single number.

    Raises a NotNumber otherwise.
    """
    if value is np.ma.masked:
        raise NotNumber((), "masked", _THERE)
    if isinstance(value, np.ndarray) and value.ndim == 0:
        return float(floats_of(value))
    if value is None or type(value).__name__ in ("NAType", "NaTType"):  # of pandas
        raise NotNumber((), shown(value), _THERE)
    if isinstance(value, (bool, np.bool_)):
        raise NotNumber((), shown(value), _NOT_BOOLS)
    if isinstance(value, (bytes, bytearray)):
        raise NotNumber((), shown(value), _NOT_BYTES)
    if isinstance(value, _TIMES):
        raise NotNumber((), shown(str(value)), _NOT_TIMES)
    if isinstance(value, (complex, np.complexfloating)):
        raise NotNumber((), shown(value), _REAL)
    try:
        if not isinstance(value, np.ndarray) and not (isinstance(value, str) and "_" in value):
            return float(value)
    except (TypeError, ValueError, OverflowError):
        pass
    raise NotNumber((), shown(repr(str(value)) if isinstance(value, str) else value), _NUMBERS)


def fields_of(dtype: np.dtype) -> Tuple[str, ...]:
    """The names of the fields of a structured type."""
    return dtype.names or ()


def is_number(value: Any) -> bool:
    """Tells whether a value is meant for a single number, and is neither a text nor a list."""
    if isinstance(value, np.ndarray):
        return value.ndim == 0
    return isinstance(value, (abstract.Number, np.generic, *_TIMES)) and not isinstance(value, (str, bytes, np.void))


def text_of_number(value: Any) -> str:
    """Writes a number so that it reads back as the same: a whole number without a point.

    Raises a NotNumber for what is none.
    """
    if isinstance(value, np.ndarray) and value.ndim == 0 and value.dtype.kind in "iu":
        value = _without_mask(value)[()]
    if isinstance(value, (int, np.integer)) and not isinstance(value, (bool, np.timedelta64)):
        return str(int(value))
    return repr(number_of(value))


def _first(where: np.ndarray) -> Tuple[int, ...]:
    return tuple(int(i) for i in np.argwhere(where)[0])


def _require_no_mask(value: np.ma.MaskedArray, place: Tuple[int, ...] = ()) -> None:
    mask = np.ma.getmaskarray(value)
    if value.dtype.names is None and mask.any():
        raise NotNumber((*place, *_first(mask)), "masked", _THERE)


def _without_mask(value: Any) -> Any:
    """Returns the values of a masked array, or of a list of such, none of which may be masked."""
    if isinstance(value, (list, tuple)):
        for place, one in enumerate(value):
            if isinstance(one, np.ma.MaskedArray):
                _require_no_mask(one, (place,))
        return value
    if not isinstance(value, np.ma.MaskedArray):
        return value
    _require_no_mask(value)
    return value.data


def floats_of(value: Any) -> np.ndarray:
    """Returns an array of floats.

    Raises a NotNumber for the first value that is no number.
    """
    try:
        array = np.asarray(_without_mask(value))
    except NotNumber:
        raise
    except (TypeError, ValueError, OverflowError):  # such as rows of different lengths
        raise NotNumber((), shown(value), _NUMBERS) from None
    kind = array.dtype.kind
    if array.dtype == float:  # which the errstate below would make ten times slower for a single number
        return array
    if kind in "fiu":
        with np.errstate(over="ignore"):
            return np.asarray(array, dtype=float)
    if kind == "V" or array.size == 0 and kind != "O":
        raise NotNumber((), shown(value), _NUMBERS)
    if kind == "c":
        complexes = array.imag != 0
        index = _first(complexes if complexes.any() else np.ones(array.shape, bool))
        raise NotNumber(index, shown(array[index]), _REAL)
    found = np.empty(array.shape)
    for index in np.ndindex(array.shape):
        one = array[index]
        try:
            if kind == "S":
                one = one.decode(errors="replace")
            found[index] = number_of(one)
        except NotNumber as error:
            raise NotNumber(index, error.value, error.expected) from None
    return found


def _at(name: str, index: Tuple[int, ...]) -> str:
    return f"{name}[{', '.join(map(str, index))}]" if index else name


def index_of(name: str, where: np.ndarray) -> str:
    """The name with the first place where something is so."""
    return _at(name, _first(where))


def require_all(name: str, values: np.ndarray, holds: np.ndarray, accepted: str) -> None:
    """Refuses the first value of an argument that does not hold."""
    if not np.all(holds):
        place, value = index_of(name, ~holds), values[~holds].flat[0]
        raise InputError(f"{place} = {value:.6g}: expected {accepted}", name, f"{value:.6g}", accepted)


def numbers(name: str, value: Any) -> np.ndarray:
    """Returns an array of floats.

    Raises an InputError that names the argument, and the place in the array, otherwise.
    """
    try:
        return floats_of(value)
    except NotNumber as error:
        raise InputError(f"{_at(name, error.index)} = {error.value}: expected {error.expected}", name, error.value,
                         error.expected) from None


def number(name: str, value: Any) -> float:
    """Returns a float; an array of one number is one.

    Raises an InputError that names the argument otherwise.
    """
    found = numbers(name, value)
    if found.size != 1:
        raise InputError(f"{name}: expected a number, not an array of {found.size}", name, shown(value), "a number")
    return float(found.reshape(()))


def broadcast(given: Mapping[str, Any], any_shape: bool = False) -> Dict[str, np.ndarray]:
    """Returns the values that are not None as arrays of one shape, of no or one dimension; errors name the first.

    any_shape  whether there may be more dimensions
    """
    columns = {name: numbers(name, value) for name, value in given.items() if value is not None}
    for name, column in columns.items():
        if column.ndim > 1 and not any_shape:
            raise InputError(f"{name}: expected a number or an array of one dimension, not of {column.ndim}",
                             name, "", "a number or an array of one dimension")
    try:
        arrays = np.broadcast_arrays(*columns.values())
    except ValueError:
        name = next(name for name, column in columns.items() if column.ndim)
        sizes = ", ".join(f"{name} {column.shape if any_shape else column.size}" for name, column in columns.items()
                          if column.ndim)
        expected = "arrays that numpy broadcasts" if any_shape else "arrays of one length"
        raise InputError(f"{name}: expected {expected}, not of {sizes}", name, sizes, expected) from None
    return {name: np.ascontiguousarray(array) if array.ndim else array.copy()
            for name, array in zip(columns, arrays)}


def record(values: np.ndarray) -> Any:
    """Turns a structured array without dimensions into a record."""
    return values.reshape(1).view(np.recarray)[0]


# Times

_PARTS_OF_SECOND = {"s": 1, "ms": 10**3, "us": 10**6, "ns": 10**9, "ps": 10**12, "fs": 10**15, "as": 10**18}
_SECONDS = {"W": 604800, "D": 86400, "h": 3600, "m": 60}


def _as_utc(value: Any) -> Any:
    """A time with a zone as one of UTC, as Python takes the difference of two clocks of one zone otherwise."""
    if isinstance(value, datetime.datetime) and value.tzinfo is not None:
        return value.astimezone(datetime.timezone.utc)
    return value


def _times_of(value: Any) -> Any:
    """Returns times as an array of numpy's, or as an array of Python's objects; None if they are none."""
    value = _without_mask(value)
    if getattr(getattr(value, "dtype", None), "tz", None) is not None:  # of pandas
        return value.to_numpy(dtype="datetime64[ns]")
    try:
        array = np.asarray(value)
    except (TypeError, ValueError, OverflowError):
        return None
    if array.ndim != 1 or array.size == 0:
        return None
    if array.dtype.kind in "mM":
        return array
    return array if array.dtype.kind == "O" and any(isinstance(one, _TIMES) for one in array) else None


def seconds_of(value: Any) -> Any:
    """Returns seconds from the first of times, or of durations; None for an array of anything else.

    Raises a NotNumber for a time that is missing, and for kinds that do not go together.
    """
    array = _times_of(value)
    if array is None:
        return None
    if array.dtype.kind == "O":
        return _seconds_of_objects(array)
    if np.isnat(array).any():
        raise NotNumber(_first(np.isnat(array)), "NaT", "times, none of which is missing")
    unit, count = np.datetime_data(array.dtype)
    if unit in ("Y", "M") and array.dtype.kind == "M":
        array, unit, count = array.astype("datetime64[D]"), "D", 1
    if unit not in _SECONDS and unit not in _PARTS_OF_SECOND:
        raise NotNumber((0,), shown(str(array[0])), "times in a unit that is a number of seconds")
    ticks = array.view(np.int64) if array.dtype.isnative else array.astype(array.dtype.newbyteorder("=")).view(np.int64)
    first = int(ticks[0])
    if max(abs(int(ticks.max()) - first), abs(int(ticks.min()) - first)) >= 2**63:
        raise NotNumber((0,), shown(str(array[0])), "times within the range of their unit")
    passed = (ticks - ticks[0]).astype(float) * count
    return passed * _SECONDS[unit] if unit in _SECONDS else passed / _PARTS_OF_SECOND[unit]


def _seconds_of_objects(array: np.ndarray) -> np.ndarray:
    found = np.empty(array.shape)
    first = _as_utc(array[0])
    for row, one in enumerate(array):
        if one is None or one is np.ma.masked or type(one).__name__ in ("NAType", "NaTType"):
            raise NotNumber((row,), shown(one), "times, none of which is missing")
        try:
            passed = _as_utc(one) - first
            found[row] = passed / np.timedelta64(1, "ns") / 1e9 if isinstance(passed, np.timedelta64) else _exact(passed)
        except (TypeError, ValueError, AttributeError):
            raise NotNumber((row,), shown(str(one)), "times of one kind, all with a time zone or none") from None
    return found


def _exact(passed: Any) -> float:
    """Seconds of a duration of Python or of pandas, which has nanoseconds besides."""
    whole = (passed.days * 86400 + passed.seconds) * 10**9 + passed.microseconds * 1000
    return (whole + int(getattr(passed, "nanoseconds", 0))) / 10**9
