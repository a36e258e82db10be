# SPDX-License-Identifier: GPL-3.0-or-later
"""Turns numbers and arrays into what the library takes."""

from __future__ import annotations

from typing import Any, Dict, Mapping, Union

import numpy as np

from ._errors import InputError

#: A number, or an array of them.
Values = Union[float, "np.typing.ArrayLike", None]


def numbers(name: str, value: Any) -> np.ndarray:
    """An array of floats.

    Raises an InputError that names it otherwise.
    """
    try:
        return np.asarray(value, dtype=float)
    except (TypeError, ValueError):
        raise InputError(f"{name} = {value!r}: expected numbers", name, repr(value), "numbers") from None


def broadcast(given: Mapping[str, Any]) -> Dict[str, np.ndarray]:
    """Returns the values that are not None as arrays of one shape, of no or one dimension; errors name the first."""
    columns = {name: numbers(name, value) for name, value in given.items() if value is not None}
    for name, column in columns.items():
        if column.ndim > 1:
            raise InputError(f"{name}: expected a number or an array of one dimension, not of {column.ndim}",
                             name, "", "a number or an array of one dimension")
    try:
        arrays = np.broadcast_arrays(*columns.values())
    except ValueError:
        name = next(iter(columns))
        lengths = ", ".join(f"{name} {column.size}" for name, column in columns.items() if column.ndim)
        raise InputError(f"{name}: expected arrays of one length, not of {lengths}", name, lengths,
                         "arrays of one length") from None
    return {name: np.ascontiguousarray(array) if array.ndim else array.copy()
            for name, array in zip(columns, arrays)}


def record(values: np.ndarray) -> Any:
    """Turns a structured array without dimensions into a record."""
    return values.reshape(1).view(np.recarray)[0]
