# SPDX-License-Identifier: GPL-3.0-or-later
"""Turns scenes into texts that the library reads: files, texts, dictionaries and arguments."""

from __future__ import annotations

import ctypes as c
import os
from collections.abc import Mapping
from typing import Any, Dict, Iterator, List, Optional, Tuple, Union

import numpy as np

from ._errors import InputError
from ._keys import keys
from ._library import SceneText
from ._table import Table

#: A file's name, a scene's text, or a dictionary of its keys.
Scene = Union[str, "os.PathLike[str]", Mapping[str, Any], None]

# Columns of a table that is given as arrays without names.
_COLUMNS = {"contact.bound_file": ("x", "bound"), "start.file": ("x", "traction")}


def _bad(key: str, value: Any, expected: str) -> InputError:
    shown = value if isinstance(value, str) else repr(value)
    shown = shown if len(shown) <= 60 else shown[:57] + "..."
    return InputError(f"{key} = '{shown}': expected {expected}", key, shown, expected)


def _number(value: Any) -> str:
    return repr(float(value)) if isinstance(value, (float, np.floating)) else str(value)


def _sections() -> set:
    return {name.partition(".")[0] for name in keys() if "." in name} | {"sweep"}


def _key_of(name: str) -> str:
    """Returns the key of an argument: load_force is load.force, contact_half_width contact.half_width."""
    if "." in name or name in keys():
        return name
    section, _, rest = name.partition("_")
    return f"{section}.{rest}" if rest and section in _sections() else name


def _items(given: Mapping[str, Any], section: str = "") -> Iterator[Tuple[str, Any]]:
    """Yields keys with their values, from nested sections; tables are not taken apart."""
    for name, value in given.items():
        if not isinstance(name, str):
            raise _bad(section + str(name), value, "a text as the name of a key")
        key = section + name if section else _key_of(name)
        if isinstance(value, Mapping) and not _names_file(key):
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
        if isinstance(scene, Mapping):
            self._assign_all(scene)
        elif isinstance(scene, str) and ("\n" in scene or "{" in scene):
            text = scene
        elif isinstance(scene, (str, os.PathLike)):
            name = os.fspath(scene)
            folder = os.path.join(os.path.dirname(name), "")
            text = _text_of_file(name)
        elif scene is not None:
            raise _bad("scene", scene, "a file's name, a text or a dictionary")
        if "\0" in text:
            raise InputError(f"{name}: expected a text, not NUL bytes", "scene", "", "a text")
        self._assign_all(overrides)
        self._texts = [text.encode(), name.encode(), folder.encode()]

    def _assign_all(self, given: Mapping[str, Any]) -> None:
        for key, value in _items(given):
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
        if _names_file(key):
            return self._file_of(key, value)
        if isinstance(value, (int, float, np.integer, np.floating)):
            return _number(value)
        try:
            values = list(value)
        except TypeError:
            raise _bad(key, value, "a number, a text, or an array of numbers") from None
        if key.startswith("sweep."):
            return " | ".join(self._text_of(key[len("sweep."):], one) for one in values)
        if not values:
            raise _bad(key, value, "at least one number")
        return " ".join(one if isinstance(one, str) else _number(one) for one in values)

    def _file_of(self, key: str, value: Any) -> str:
        """Returns the name of a file in memory, for arrays or the bytes of a state; a path stays as it is."""
        if isinstance(value, os.PathLike):
            return os.fspath(value)
        name = f"<{key}>"
        if isinstance(value, Table):
            self._files[name] = value.text.encode()
        else:
            self._files[name] = value if isinstance(value, bytes) else _columns_text(key, value)
        return name

    def in_c(self) -> SceneText:
        text, name, folder = self._texts
        assignments = (c.c_char_p * len(self._assignments))(*self._assignments)
        names = (c.c_char_p * len(self._files))(*(one.encode() for one in self._files))
        texts = (c.c_char_p * len(self._files))(*self._files.values())
        scene = SceneText(text, name, folder, assignments, len(assignments), names, texts, len(names))
        scene.keep = (assignments, names, texts)  # as long as what points to them
        return scene


def _text_of_file(name: str) -> str:
    try:
        with open(name, encoding="utf-8-sig", newline=None) as file:
            return file.read()
    except (OSError, UnicodeDecodeError) as error:
        why = error.strerror if isinstance(error, OSError) else "expected UTF-8"
        raise InputError(f"scene '{name}': cannot read it: {why}", "scene", name, "a file that can be read") from None


def _columns_text(key: str, value: Any) -> bytes:
    """Writes arrays as the text of a table: a dictionary, a structured array, or columns in their order."""
    names, arrays = _columns_of(key, value)
    columns = [np.asarray(array) for array in arrays]
    sizes = {column.shape for column in columns}
    if len(sizes) != 1 or any(column.ndim != 1 for column in columns):
        raise _bad(key, "arrays of shapes " + ", ".join(str(one.shape) for one in columns),
                   "columns of the same length")
    rows = zip(*(map(_number, column.tolist()) for column in columns))
    return "\n".join(["\t".join(names), *("\t".join(row) for row in rows), ""]).encode()


def _with_unit(name: str, units: Mapping[str, str]) -> str:
    return f"{name} [{units[name]}]" if name in units else name


def _columns_of(key: str, value: Any) -> Tuple[List[str], List[Any]]:
    named: Optional[Mapping[str, Any]] = value if isinstance(value, Mapping) else None
    fields = getattr(getattr(value, "dtype", None), "names", None)
    if fields:
        named = {name: value[name] for name in fields}
    elif hasattr(value, "to_dict") and hasattr(value, "columns"):  # a frame of pandas
        units = value.attrs.get("units", {})
        named = {_with_unit(str(name), units): value[name] for name in value.columns}
    if named is not None:
        return list(named), list(named.values())
    names = _COLUMNS.get(key)
    columns = list(value.T) if isinstance(value, np.ndarray) and value.ndim == 2 else value
    if names is None or not isinstance(columns, (list, tuple)) or len(columns) != len(names):
        wanted = "a file, or a dictionary of columns"
        raise _bad(key, value, wanted + (f", or the arrays ({', '.join(names)})" if names else ""))
    return list(names), list(columns)
