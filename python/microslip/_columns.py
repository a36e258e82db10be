# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes arrays as the table that a scene would have in a file."""

from __future__ import annotations

import difflib
import os
import re
from collections.abc import Mapping
from typing import Any, Dict, List, Optional, Tuple

import numpy as np

from ._arrays import NotNumber, floats_of, seconds_of, shown
from ._errors import InputError
from ._table import Table

#: The key that gives the columns of load.file other names.
NAMES_KEY = "load.columns"

# Columns of a table that is given as arrays without names.
_IN_ORDER = {"contact.bound_file": ("x", "bound"), "contact.patch_file": ("y", "trailing", "leading"),
             "contact.friction_file": ("speed", "ratio"), "kernel.table": ("wave_number", "symbol"),
             "start.file": ("x", "traction")}

# The same where the contact has three dimensions.
_IN_ORDER_OF_PATCHES = {"contact.bound_file": ("x", "y", "bound")}

# Columns that are read. What is wrong in another column does not matter.
_READ: Dict[str, Tuple[str, ...]] = {
    **_IN_ORDER, **_IN_ORDER_OF_PATCHES,
    "load.file": ("q", "t", "v", "creepage", "force", "omega", "normal_load", "half_width", "peak_traction", "friction",
                  "lateral_creepage", "lateral_force", "spin", "spin_moment")}

# In the place of what is no number, in a column that is not read: the library refuses it if it is read.
_NOTHING = "-"


def is_table(value: Any) -> bool:
    """Tells whether the value of a key that names a file has columns in memory."""
    return value is not None and not isinstance(value, (str, bytes, os.PathLike))


def _error(key: str, message: str, value: str, expected: str) -> InputError:
    return InputError(f"{key}: {message}: expected {expected}", key, value, expected)


def table_text(key: str, value: Any, names: Mapping[str, str]) -> bytes:
    """Writes the table: a dictionary, a structured array, a frame of pandas, or columns in their order.

    names  of this package's columns, with the name of each in the table
    """
    headers, columns = _columns_of(key, value, set(names.values()))
    headers = _renamed(key, headers, names)
    if key == "load.file" and not {"q", "t"} & {_taken_apart(header)[0] for header in headers}:
        times = _times_of_index(value)
        if times is not None:
            headers, columns = ["t", *headers], [times, *columns]
    sizes = {_shape(key, value, column) for column in columns}
    if len(sizes) != 1 or any(len(size) != 1 for size in sizes):
        shapes = "arrays of shapes " + ", ".join(str(np.shape(one)) for one in columns)
        raise InputError(f"{key} = '{shown(shapes)}': expected columns of the same length", key, shapes,
                         "columns of the same length")
    written = [_cells(key, header, column) for header, column in zip(headers, columns)]
    rows = zip(*(cells for _, cells in written))
    return "\n".join([",".join(header for header, _ in written), *map(",".join, rows), ""]).encode()


def names_text(names: Mapping[str, str]) -> str:
    """Writes names of columns as a scene has them: "t = Time, v = Speed"."""
    for own, other in names.items():
        if not isinstance(own, str) or not isinstance(other, str) or re.search(r"[,=\s]", own) or re.search(
                r"[,=\r\n\0]", other):
            raise _error(NAMES_KEY, f"{shown(own)} = {shown(other)}", shown(other),
                         "names of columns as texts, without a comma or an equals sign")
    return ", ".join(f"{own} = {other}" for own, other in names.items())


def _shape(key: str, value: Any, column: Any) -> Tuple[int, ...]:
    try:
        return np.shape(column)
    except (TypeError, ValueError):
        raise _error(key, shown(value), shown(value), "columns of numbers") from None


def _with_unit(name: str, units: Mapping[str, str]) -> str:
    return f"{name} [{units[name]}]" if name in units else name


def _taken_apart(header: str) -> Tuple[str, str]:
    """Returns name and unit of "v [km/h]" or "v (km/h)"; the unit is empty if there is none."""
    found = re.fullmatch(r"\s*(.*?)\s*(?:\[([^\]]*)\]|\(([^)]*)\))\s*", header, re.DOTALL)
    return (found[1], found[2] or found[3] or "") if found and found[1] else (header.strip(), "")


def _columns_of(key: str, value: Any, wanted: set) -> Tuple[List[str], List[Any]]:
    """Returns headers and columns.

    wanted  names that the columns have besides the known ones
    """
    named: Optional[Dict[Any, Any]] = dict(value) if isinstance(value, Mapping) else None
    fields = getattr(getattr(value, "dtype", None), "names", None)
    if isinstance(value, Table):
        units = {name: unit for name, unit in value.units.items() if unit != "1"}
        named = {_with_unit(name, units): value[name] for name in value.data.dtype.names}
    elif fields:
        named = {name: value[name] for name in fields}
    elif hasattr(value, "to_dict") and hasattr(value, "columns"):  # a frame of pandas
        units = getattr(value, "attrs", {}).get("units", {})
        named = {_with_unit(str(name), units): value[name] for name in value.columns}
        index = getattr(value, "index", None)
        name = str(getattr(index, "name", None))
        if name not in named and (_taken_apart(name)[0] in _READ.get(key, ()) or name in wanted):
            named = {name: index, **named}
    if named is not None:
        return [str(name) for name in named], list(named.values())
    names = _IN_ORDER.get(key)
    columns = list(value.T) if isinstance(value, np.ndarray) and value.ndim == 2 else value
    of_patch = _IN_ORDER_OF_PATCHES.get(key, ())
    are_columns = isinstance(columns, (list, tuple)) and not any(map(np.isscalar, columns))
    if of_patch and are_columns and len(columns) == len(of_patch):
        return list(of_patch), list(columns)
    if names is None or not isinstance(columns, (list, tuple)) or len(columns) != len(names):
        wanted_text = "a file, or a dictionary of columns"
        wanted_text += f", or the arrays ({', '.join(names)})" if names else ""
        raise InputError(f"{key} = '{shown(value)}': expected {wanted_text}", key, shown(value), wanted_text)
    return list(names), list(columns)


def _times_of_index(value: Any) -> Any:
    """Returns the index of a frame if it has times, else None."""
    index = getattr(value, "index", None) if hasattr(value, "columns") else None
    kind = getattr(getattr(index, "dtype", None), "kind", "")
    return index if kind in ("m", "M") else None


def _places_of(name: str, headers: List[str]) -> List[int]:
    """Returns the columns of a name: by the whole header, by the header without its unit, or by both without units."""
    plain = [_taken_apart(header)[0] for header in headers]
    for wanted, among in ((name, [header.strip() for header in headers]), (name, plain), (_taken_apart(name)[0], plain)):
        places = [k for k, header in enumerate(among) if header == wanted]
        if places:
            return places
    return []


def _renamed(key: str, headers: List[str], names: Mapping[str, str]) -> List[str]:
    """Gives columns this package's names, and leaves their units."""
    found = list(headers)
    taken: Dict[int, str] = {}
    for own, other in names.items():
        if own not in _READ[key]:
            near = difflib.get_close_matches(str(own), _READ[key], 1)
            hint = f" (did you mean '{near[0]}'?)" if near else ""
            raise _error(NAMES_KEY, f"unknown column '{shown(own)}'{hint}", shown(own), ", ".join(_READ[key]))
        places = _places_of(str(other).strip(), headers)
        if len(places) != 1:
            near = difflib.get_close_matches(str(other), headers, 1)
            hint = f" (did you mean '{near[0]}'?)" if near and not places else ""
            raise _error(NAMES_KEY, f"{own} = '{shown(other)}'{hint}", shown(other),
                         f"one of the columns of the table, which are {', '.join(map(shown, headers))}")
        if places[0] in taken:
            raise _error(NAMES_KEY, f"{own} = '{shown(other)}'", shown(other),
                         f"another column than that of {taken[places[0]]}")
        taken[places[0]] = own
        unit = _taken_apart(headers[places[0]])[1] or _taken_apart(str(other))[1]
        found[places[0]] = f"{own} [{unit}]" if unit else own
    return found


def _cells(key: str, header: str, column: Any) -> Tuple[str, List[str]]:
    """Returns a column as it is written: its header, and a text for each row."""
    name, unit = _taken_apart(header)
    is_read = name in _READ.get(key, ())
    try:
        values = seconds_of(column) if (key, name) == ("load.file", "t") else None
        if values is not None:
            if unit not in ("", "s"):
                raise _error(key, f"column '{shown(header)}'", unit, "no unit, as times have one of their own")
            unit = "s"
        else:
            values = floats_of(column)
        if is_read and not np.isfinite(values).all():
            row = int(np.argmin(np.isfinite(values)))
            raise NotNumber((row,), repr(float(values[row])), "a finite number")
    except NotNumber as error:
        if not is_read:
            return _written(header), [_NOTHING] * len(column)
        row_text = f", row {error.index[0] + 1}" if error.index else ""
        raise _error(key, f"column '{name}'{row_text}: {error.value}", error.value, error.expected) from None
    is_known = is_read and unit
    return _written(f"{name} [{unit}]" if is_known else header), [repr(one) for one in values.tolist()]


def _written(header: str) -> str:
    """A header on one line, of which no part separates cells or begins a comment."""
    text = re.sub(r"[\s,;\"\0]+", " ", header).strip()
    return f"_{text}" if not text or text.startswith("#") else text
