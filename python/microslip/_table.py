# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads tables that microslip writes: tab-separated, behind a block of comments."""

from __future__ import annotations

import html
import os
import pathlib
import re
from typing import Any, Dict, List, Tuple, Union

import numpy as np

from ._errors import InputError
from ._files import read_text, write_text
from ._head import Column, read_head


class Table:
    """A table as a structured array, with description, units and parameters from its comments.

    Columns of numbers are floats, all others texts. A table is indexed like the array.

    Attributes
    ----------
    data : numpy.ndarray
        Structured array, one element per row of the table.
    name, description : str
    columns : dict of Column
        By their names, in their order.
    units : dict of str
        Likewise.
    parameters : dict of str
        Keys and values of the scene that made it, with defaults.
    warnings : list of str
    text : str
        The table as it was read.
    """

    def __init__(self, name: str, text: str):
        self.name, self.text = name, text
        head, rest = read_head(text)
        if not rest:
            raise InputError(f"{name}: expected a line of column names, as microslip writes tables", "path", name,
                             "a table")
        header, self.data = _read_rows(name, rest)
        self.description = head.description
        self.parameters = {key: value for key, value in head.parameters if key != "warning"}
        self.warnings = [value for key, value in head.parameters if key == "warning"]
        self.columns = {column.name: column for column in (*header, *head.columns)}
        self.units: Dict[str, str] = {column.name: column.unit for column in self.columns.values()}

    def __getitem__(self, which: Any) -> Any:
        return self.data[which]

    def __len__(self) -> int:
        return len(self.data)

    def __array__(self, dtype: Any = None, copy: Any = None) -> np.ndarray:
        return np.array(self.data, dtype=dtype) if copy else np.asarray(self.data, dtype=dtype)

    def __repr__(self) -> str:
        names = ", ".join(f"{name} [{unit}]" for name, unit in self.units.items())
        return f"<microslip.Table {self.name}: {len(self)} rows of {names}>"

    def _repr_html_(self) -> str:
        return html_table(self.data, self.units, caption=self.description)

    def to_pandas(self) -> Any:
        """Returns a pandas.DataFrame; units are in its attrs["units"]."""
        return to_pandas(self.data, self.units)

    def write(self, path: Union[str, "os.PathLike[str]"]) -> None:
        """Writes the text of the table as it was read, to the byte.

        The file is written as a whole or not at all. A link stays, and its file is replaced; what is no regular file,
        such as a device or a pipe, is refused.
        """
        write_text(path, self.text)


def _read_rows(name: str, text: str) -> Tuple[List[Column], np.ndarray]:
    """Reads the columns of the header, perhaps with units, and the rows, separated by tabs or by blanks."""
    header, _, rows = text.partition("\n")
    separator = "\t" if "\t" in header else None
    named = [_named(one) for one in (header.split("\t") if separator else re.sub(r"\s+\[", "[", header).split())]
    lines = [line for line in rows.splitlines() if line and not line.startswith("#")]
    columns = _columns_of_lines(name, [line.split(separator) for line in lines], len(named))
    return named, structured([one.name for one in named], columns, len(lines))


def structured(names: List[str], columns: List[np.ndarray], rows: int) -> np.ndarray:
    """Makes a structured array of columns."""
    data = np.empty(rows, [(name, column.dtype) for name, column in zip(names, columns)])
    for name, column in zip(names, columns):
        data[name] = column
    return data


def _named(header: str) -> Column:
    """Takes a name and its unit apart: q, q [mm] or q[mm]."""
    name, _, unit = header.strip().partition("[")
    return Column(name.strip(), unit.rstrip("] ") or "1", "")


def _columns_of_lines(name: str, cells: List[List[str]], width: int) -> List[np.ndarray]:
    for number, row in enumerate(cells, 1):
        if len(row) != width:
            raise InputError(f"{name}, row {number}: expected {width} cells, not {len(row)}", "path", name,
                             "as many cells as columns")
    return [column_of(list(texts)) for texts in zip(*cells)] or [np.empty(0) for _ in range(width)]


def column_of(texts: List[str]) -> np.ndarray:
    """Turns texts into numbers, if all of them are."""
    try:
        return np.array(texts, dtype=float)
    except ValueError:
        return np.array(texts)


def read_table(path: Union[str, "os.PathLike[str]"]) -> Table:
    """Reads a table that microslip wrote, with its units and parameters.

    Parameters
    ----------
    path : str or path
        The file, such as ``out/traction.tsv``.

    Raises
    ------
    InputError
        For a file that cannot be read or is no table.

    >>> import tempfile
    >>> import microslip as ms
    >>> wheel = {"material": {"shear_modulus": 82000, "poisson_ratio": 0.28},
    ...          "contact": {"half_width": 5, "peak_traction": 300},
    ...          "kernel": {"type": "strip", "width": 10}, "grid": {"elements": 50}}
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     ms.solve(wheel, problem="steady", load_force=-500).write(folder)
    ...     table = ms.read_table(f"{folder}/traction.tsv")
    >>> table["x"][:2], table.units["x"], table.parameters["load.force"]
    (array([-4.9, -4.7]), 'mm', '-500')
    """
    return Table(pathlib.Path(path).stem, read_text(path, "table", "path"))


def to_pandas(data: np.ndarray, units: Dict[str, str]) -> Any:
    """Turns a structured array into a pandas.DataFrame."""
    try:
        import pandas  # pylint: disable=import-outside-toplevel
    except ImportError:
        raise ImportError("to_pandas wants pandas, which is not installed: python3-pandas of Debian, "
                          "or pip install pandas") from None
    frame = pandas.DataFrame({name: data[name] for name in data.dtype.names})
    frame.attrs["units"] = dict(units)
    return frame


def html_table(data: np.ndarray, units: Dict[str, str], caption: str = "", most: int = 10) -> str:
    """Writes an HTML table of the first and the last rows."""
    names = data.dtype.names

    def with_unit(name: str) -> str:
        unit = units.get(name, "1")
        return html.escape(name if unit == "1" else f"{name} [{unit}]")

    def row(values: Any) -> str:
        cells = (f"{value:.6g}" if isinstance(value, (float, np.floating)) else html.escape(str(value))
                 for value in values)
        return "<tr>" + "".join(f"<td>{cell}</td>" for cell in cells) + "</tr>"

    rows = [row(one) for one in (data if len(data) <= most else data[:most // 2])]
    if len(data) > most:
        rows += [f'<tr><td colspan="{len(names)}">... {len(data) - most} more</td></tr>',
                 *(row(one) for one in data[-(most // 2):])]
    head = "".join(f"<th>{with_unit(name)}</th>" for name in names)
    return (f"<table><caption>{html.escape(caption)}</caption><tr>{head}</tr>{''.join(rows)}</table>")
