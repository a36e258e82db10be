# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads the comments at the head of a table, where microslip writes what is in it. The programs in tools read their
tables with this module as well, so it needs neither numpy nor the library."""

from __future__ import annotations

import re
from typing import Dict, List, NamedTuple, Optional, Tuple


class Column(NamedTuple):
    """Name, unit and meaning of a column."""

    name: str
    unit: str  #: "1" if it has none
    meaning: str


class Head(NamedTuple):
    """The comments of a table; all are empty in a table of another program that has none."""

    description: str
    parameters: List[Tuple[str, str]]  #: keys and values; those of "warning" are warnings
    columns: List[Column]
    rounding: Dict[Tuple[str, Optional[str]], float]  #: by column, and by the first cell of a row or None


def read_head(text: str) -> Tuple[Head, str]:
    """Returns what the comments of a table say, and the text below them."""
    comments = re.match(r"(?:#.*\n?)*", text)[0]  # type: ignore[index]
    lines = [line[1:].rstrip() for line in comments.split("\n")]
    head, part = Head(lines[0].strip().partition(": ")[2], [], [], {}), ""
    for line in lines[1:]:
        found = line.strip()
        if not line.startswith("   "):
            part = found
        elif part == "parameters":
            key, _, value = found.partition(" = ")
            head.parameters.append((key, value))
        elif part == "columns":
            column, _, rest = found.partition(" [")
            head.columns.append(Column(column, *rest.partition("]: ")[::2]))
        elif part == "nothing but rounding":
            for column, bound, row in re.findall(r"^(\S+) up to (\S+)(?: where \S+ = (.*))?$", found):
                head.rounding[column, row or None] = float(bound)
    return head, text[len(comments):]
