# SPDX-License-Identifier: GPL-3.0-or-later
"""Turns scenes into texts that the library reads: files, texts, dictionaries and arguments."""

from __future__ import annotations

import ctypes as c
import difflib
import os
from collections.abc import Mapping
from typing import Any, Dict, Iterable, Iterator, List, Tuple, Union

import numpy as np

from ._arrays import NotNumber, is_number, shown, text_of_number
from ._columns import NAMES_KEY, is_table, names_text, table_text
from ._errors import InputError
from ._files import read_text
from ._keys import keys
from ._library import SceneText
from ._table import Table

#: A file's name, a scene's text, or a dictionary of its keys.
Scene = Union[str, "os.PathLike[str]", Mapping[str, Any], None]


def _bad(key: str, value: Any, expected: str) -> InputError:
    text = shown(value)
    return InputError(f"{key} = '{text}': expected {expected}", key, text, expected)


def _number(key: str, value: Any) -> str:
    try:
        return text_of_number(value)
    except NotNumber as error:
        raise InputError(f"{key} = {error.value}: expected {error.expected}", key.partition("[")[0], error.value,
                         error.expected) from None


def _sections() -> set:
    return {name.partition(".")[0] for name in keys() if "." in name} | {"sweep"}


def _key_of(name: str) -> str:
    """Returns the key of an argument: load_force is load.force, contact_half_width contact.half_width."""
    if "." in name or name in keys():
        return name
    section, _, rest = name.partition("_")
    return f"{section}.{rest}" if rest and section in _sections() else name


def refuse_misspelt(overrides: Mapping[str, Any], arguments: Iterable[str]) -> None:
    """Refuses what is no key of scenes, and nearly an argument of the function that was called."""
    for name in overrides:
        if "." in _key_of(name) or name in keys() or name in _sections():
            continue
        near = difflib.get_close_matches(name.lower(), arguments, 1, 0.75)
        if near:
            expected = "an argument, or a key of scenes"
            raise InputError(f"{name}: expected {expected} (did you mean '{near[0]}'?)", name, shown(overrides[name]),
                             expected)


def _items(given: Mapping[str, Any], section: str = "") -> Iterator[Tuple[str, Any]]:
    """Yields keys with their values, from nested sections; tables and names of columns are not taken apart."""
    for name, value in given.items():
        if not isinstance(name, str):
            raise _bad(section + str(name), value, "a text as the name of a key")
        key = section + name if section else _key_of(name)
        if isinstance(value, Mapping) and not _names_file(key) and key != NAMES_KEY:
            yield from _items(value, key + ".")
        else:
            yield key, value


def _names_file(key: str) -> bool:
    known = keys().get(key)
    return known is not None and known.type == "file"


class SceneArguments:
    """A scene that has been given, with its text and arrays as they were then, but not other files."""

    def __init__(self, scene: Scene, overrides: Mapping[str, Any]):
        self._assignments: List[bytes] = []
        self._files: Dict[str, bytes] = {}
        text, name, folder = "", "scene", ""
        given: List[Tuple[str, Any]] = []
        if isinstance(scene, Mapping):
            given += _items(scene)
        elif isinstance(scene, str) and ("\n" in scene or "{" in scene):
            text = scene
        elif isinstance(scene, (str, os.PathLike)):
            name = os.fspath(scene)
            folder = os.path.join(os.path.dirname(name), "")
            text = read_text(name, "scene", "scene")
        elif scene is not None:
            raise _bad("scene", scene, "a file's name, a text or a dictionary")
        if "\0" in text:
            raise InputError(f"{name}: expected a text, not NUL bytes", "scene", "", "a text")
        given += _items(overrides)
        self._assign_all(given)
        self._texts = [text.encode(), name.encode(), folder.encode()]

    def _assign_all(self, given: List[Tuple[str, Any]]) -> None:
        last = dict(given)
        names = last.get(NAMES_KEY)
        self._names = names if isinstance(names, Mapping) and is_table(last.get("load.file")) else {}
        for key, value in given:
            text = self._text_of(key, value)
            if "=" in key or not key or "\0" in key + text:
                raise _bad(key, text, "a key of scenes, see microslip.keys(), and a text without NUL")
            self._assignments.append(f"{key}={text}".encode())

    def _text_of(self, key: str, value: Any) -> str:
        """Writes a value as in a scene; the text for None is empty, which removes the key."""
        if value is None:
            return ""
        if isinstance(value, (bool, np.bool_)):
            raise _bad(key, value, "a number, a text, or an array of numbers")
        if isinstance(value, str):
            return value
        if key == NAMES_KEY and isinstance(value, Mapping):
            # A table in memory has its names before the library reads it.
            return "" if self._names else names_text(value)
        if _names_file(key):
            return self._file_of(key, value)
        if is_number(value):
            return _number(key, value)
        return self._text_of_list(key, value)

    def _text_of_list(self, key: str, value: Any) -> str:
        try:
            values = list(value)
        except TypeError:
            raise _bad(key, value, "a number, a text, or an array of numbers") from None
        if isinstance(value, (bytes, bytearray, memoryview)):
            raise _bad(key, value, "a number, a text, or an array of numbers, not bytes")
        if key.startswith("sweep."):
            return " | ".join(self._text_of(key[len("sweep."):], one) for one in values)
        if not values:
            raise _bad(key, value, "at least one number")
        if isinstance(value, (set, frozenset)):
            raise _bad(key, value, "numbers in an order")
        return " ".join(one if isinstance(one, str) else _number(f"{key}[{place}]", one)
                        for place, one in enumerate(values))

    def _file_of(self, key: str, value: Any) -> str:
        """Returns the name of a file in memory, for arrays or the bytes of a state; a path stays as it is."""
        if isinstance(value, os.PathLike):
            return os.fspath(value)
        name = f"<{key}>"
        names = self._names if key == "load.file" else {}
        if isinstance(value, Table) and not names:
            self._files[name] = value.text.encode()
        else:
            self._files[name] = value if isinstance(value, bytes) else table_text(key, value, names)
        return name

    def in_c(self) -> Any:
        text, name, folder = self._texts
        assignments = (c.c_char_p * len(self._assignments))(*self._assignments)
        names = (c.c_char_p * len(self._files))(*(one.encode() for one in self._files))
        texts = (c.c_char_p * len(self._files))(*self._files.values())
        scene = SceneText(text, name, folder, assignments, len(assignments), names, texts, len(names))
        scene.keep = (assignments, names, texts)  # as long as the scene
        return c.byref(scene)
