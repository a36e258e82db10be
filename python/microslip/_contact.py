# SPDX-License-Identifier: GPL-3.0-or-later
"""What contacts that roll have in common: their life, copies and files, and turns of threads."""

from __future__ import annotations

import copy as copying
import ctypes as c
import functools
import os
import threading
from typing import Any, Callable, Dict, Mapping, Optional, Tuple, TypeVar, Union, cast

import numpy as np

from ._arrays import record
from ._errors import Error
from ._files import as_path
from ._library import call, error_of, free_with, require_ok, text_of
from ._result import warn_of

# Attributes of one contact that no copy shares.
_OWN = ("_handle", "_finalizer", "_turns")

_Method = TypeVar("_Method", bound=Callable[..., Any])
_Kind = TypeVar("_Kind", bound="Contact")


class _Turns:
    """Lets one thread at a time use a contact."""

    def __init__(self) -> None:
        self.lock = threading.RLock()
        self.is_rolling = False  # an array of steps, the progress of which is being told


def in_turn(method: _Method, changes: bool = False) -> _Method:
    """Makes a method wait until no other thread uses the contact."""

    @functools.wraps(method)
    def waiting(self: "Contact", *arguments: Any, **named: Any) -> Any:
        with self._turns.lock:
            if changes and self._turns.is_rolling:
                raise Error("this contact is rolling: expected no change of it by `progress`")
            return method(self, *arguments, **named)

    return cast(_Method, waiting)


# The same for a method that changes the contact, which `progress` cannot do while it rolls.
alone = functools.partial(in_turn, changes=True)


class Contact:
    """A contact behind a handle of the library.

    A class of its own kind says with which letters its functions of C begin, and makes, saves and restores handles.
    """

    _functions = ""  # microslip_..., before the names of functions
    _warned = False  # of a creepage
    _turns: _Turns

    def _new_handle(self) -> int:
        """Returns a handle of a contact that has not rolled."""
        raise NotImplementedError

    def _saved(self) -> bytes:
        """Returns the state as a text."""
        raise NotImplementedError

    def _take_saved(self, saved: bytes) -> None:
        """Takes it, and what is set but no part of it."""
        raise NotImplementedError

    def _words(self) -> str:
        """Returns what it is, and its state, for a line that shows it."""
        raise NotImplementedError

    def _drawn(self) -> Tuple[Any, ...]:
        """Returns what is drawn of its tractions, as the functions of _plot take it."""
        raise NotImplementedError

    def _title(self) -> str:
        """Returns what stands above or beside its tractions in a picture of several."""
        raise NotImplementedError

    def _own(self, handle: int) -> None:
        vars(self).setdefault("_turns", _Turns())
        self._handle = handle
        self._finalizer = free_with(self, f"{self._functions}destroy", handle)

    # Life

    @alone
    def close(self) -> None:
        """Frees the contact; only a second close() is accepted then."""
        self._finalizer()

    def __enter__(self: _Kind) -> _Kind:
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()

    @in_turn
    def copy(self: _Kind) -> _Kind:
        """Returns an independent contact that goes on like this one, to the bit; other attributes are shared."""
        return self._copy_with(vars(self))

    __copy__ = copy

    @in_turn
    def __deepcopy__(self: _Kind, memo: Dict[int, Any]) -> _Kind:
        own = {name: value for name, value in vars(self).items() if name not in _OWN}
        other = memo[id(self)] = self._copy_with({})
        vars(other).update(copying.deepcopy(own, memo))
        return other

    def _copy_with(self: _Kind, attributes: Mapping[str, Any]) -> _Kind:
        handle = c.c_void_p()
        self._call("copy", c.byref(handle))
        other = type(self).__new__(type(self))
        vars(other).update({name: value for name, value in attributes.items() if name not in _OWN})
        other._own(handle.value)  # type: ignore[arg-type]
        return other

    @in_turn
    def __getstate__(self) -> Dict[str, Any]:
        own = {name: value for name, value in vars(self).items() if name not in _OWN}
        return {**own, "_saved": self._saved()}

    def __setstate__(self, state: Dict[str, Any]) -> None:
        saved = state.pop("_saved")
        vars(self).update(state)
        self._own(self._new_handle())
        self._take_saved(saved)

    @in_turn
    def save(self, path: Union[str, "os.PathLike[str]"]) -> None:
        """Writes the state to a file, but not the load: for restore(), or a scene's start.state.

        The file is written as a whole or not at all. A link stays, and its file is replaced; what is no regular file,
        such as a device or a pipe, is refused.
        """
        self._call("save", as_path(path))

    @alone
    def restore(self, path: Union[str, "os.PathLike[str]"]) -> None:
        """Takes the state from the file of an equal contact, and goes on to the bit; the load stays as it was set."""
        self._call("restore", as_path(path))

    @in_turn
    def __repr__(self) -> str:
        name = f"microslip.{type(self).__name__}"
        return f"<{name} {self._words()}>" if self._finalizer.alive else f"<{name}, closed>"

    def __bool__(self) -> bool:
        return True

    # Calls

    def _on_a_copy(self, count: int, at_once: int, told: Optional[Callable[[int, int], Any]],
                   roll: Callable[[Any, slice], None]) -> None:
        """Rolls `count` steps, `at_once` in each call of `roll`, on a copy that the contact then goes on as.

        So an error or an interrupt changes nothing.
        """
        work = self._copy_with({})
        self._turns.is_rolling = True
        try:
            for at in range(0, count, at_once):
                part = slice(at, min(at + at_once, count))
                roll(work, part)
                if told is not None:
                    told(part.stop, count)
        finally:
            self._turns.is_rolling = False
        self._finalizer()
        work._finalizer.detach()
        self._own(work._handle)

    def _tell_once(self, doubt: str) -> None:
        """Warns the user who called, three frames above; once, as steps are many."""
        if doubt and not self._warned:
            self._warned = True
            warn_of([doubt], depth=5)

    def _factors(self) -> Tuple[float, float]:
        """Returns those of the contact that set_contact() set, or a step or a file."""
        factors = np.ones(2)
        require_ok(call(f"py_{self._functions}contact", self._open(), factors.ctypes.data))
        return float(factors[0]), float(factors[1])

    def _open(self) -> int:
        if not self._finalizer.alive:
            raise Error("this contact is closed")
        return self._handle

    def _check(self, status: int, before: int = 0) -> None:
        """Raises what the library says.

        before  number of steps that were made before this call
        """
        if status == 0:
            return
        message = text_of(f"{self._functions}message", self._handle)
        if message.startswith("steps["):
            number, _, rest = message[len("steps["):].partition("]: ")
            message = f"step {int(number) + before}: {rest}"
        raise error_of(status, message)

    @in_turn
    def _call(self, name: str, *arguments: Any) -> None:
        self._check(call(self._functions + name, self._open(), *arguments))

    def _filled(self, name: str, *arguments: Any, into: Tuple[Any, ...]) -> Tuple[Any, ...]:
        """Calls a function that fills a number or record of each type in `into`, and returns them."""
        places = [np.zeros((), kind) for kind in into]
        self._call(name, *arguments, *(place.ctypes.data for place in places))
        return tuple(record(place) if place.dtype.names else float(place) for place in places)
