# SPDX-License-Identifier: GPL-3.0-or-later
"""The keys of scenes."""

from __future__ import annotations

import difflib
import functools
import html
from typing import Dict, NamedTuple

from ._arrays import shown
from ._errors import InputError
from ._library import text_of


class Key(NamedTuple):
    """A key of scenes."""

    name: str
    type: str  #: word, number, whole, list, wholes, file or text
    unit: str  #: of a number without one; "1" if it has none
    meaning: str
    accepted: str
    default: str  #: empty if there is none
    role: str  #: scenes that the key is for; empty if it is for all


class Keys(Dict[str, Key]):
    """Keys by their names, which are shown as a table."""

    def __repr__(self) -> str:
        width = max(map(len, self), default=0)
        return "\n".join(f"{name:{width}}  {_unit(key):10} {key.meaning}: {_accepted(key)}"
                         for name, key in self.items())

    def _repr_html_(self) -> str:
        rows = "".join("<tr>" + "".join(f"<td>{html.escape(cell)}</td>" for cell in (
            name, _unit(key), key.meaning, _accepted(key), key.role)) + "</tr>" for name, key in self.items())
        return ("<table><tr><th>key</th><th>unit</th><th>meaning</th><th>accepted, [default]</th><th>for</th></tr>"
                f"{rows}</table>")


def _unit(key: Key) -> str:
    return "" if key.unit == "1" else key.unit


def _accepted(key: Key) -> str:
    return key.accepted + (f" [{key.default}]" if key.default else "")


@functools.lru_cache(maxsize=None)
def _all_keys() -> Keys:
    return Keys((line.split("\t")[0], Key(*line.split("\t"))) for line in text_of("py_keys").splitlines())


def keys(part: str = "") -> Keys:
    """Lists the keys of scenes with units, meanings and accepted values.

    Parameters
    ----------
    part : str
        Only keys that have this text in their name.

    Raises
    ------
    InputError
        If there is no such key; the message has the nearest.

    >>> import microslip as ms
    >>> ms.keys("contact.half_width")
    contact.half_width  mm         half-width a of the contact: > 0
    >>> ms.keys()["load.force"].unit
    'N/mm'
    """
    found = Keys((name, key) for name, key in _all_keys().items() if part in name) if part else _all_keys()
    if found:
        return found
    parts = sorted({one for name in _all_keys() for one in (name, *name.split("."))})
    near = difflib.get_close_matches(part.strip(". ").lower(), parts, 1, 0.5)
    hint = f" (did you mean '{near[0]}'?)" if near else ""
    raise InputError(f"part = '{shown(part)}'{hint}: expected a part of the name of a key; microslip.keys() lists all",
                     "part", part, "a part of the name of a key")
