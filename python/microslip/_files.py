# SPDX-License-Identifier: GPL-3.0-or-later
"""Names of files, and texts that are written to them."""

from __future__ import annotations

import os
import secrets
from typing import Union

from ._errors import InputError
from ._library import call, require

Path = Union[str, bytes, "os.PathLike[str]"]


def as_path(path: Path) -> bytes:
    """Returns a path as the library takes it."""
    name = os.fsencode(path)
    if b"\0" in name:
        raise InputError.of("path", repr(path), "a path without NUL")
    return name


def read_text(path: Path, what: str, argument: str) -> str:
    """Reads a file of UTF-8; a message says what it is."""
    try:
        with open(path, encoding="utf-8-sig") as file:
            return file.read()
    except (OSError, UnicodeDecodeError) as error:
        why = error.strerror if isinstance(error, OSError) else "expected UTF-8"
        raise InputError(f"{what} '{path!s}': cannot read it: {why}", argument, str(path),
                         "a file that can be read") from None


def write_text(path: Path, text: str) -> None:
    """Writes a file as a whole or not at all.

    A link stays, and its file is replaced. What is no regular file is refused with an InputError; what the system
    refuses is an OSError.
    """
    target = require(call("py_writable_target", as_path(path)))
    folder, name = os.path.split(target)
    part = os.path.join(folder, b".%b.%b.part" % (name, secrets.token_hex(4).encode()))
    try:
        with open(part, "wb") as file:
            file.write(text.encode())
        os.replace(part, target)
    except BaseException:
        if os.path.lexists(part):
            os.unlink(part)
        raise
