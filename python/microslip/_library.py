# SPDX-License-Identifier: GPL-3.0-or-later
"""The shared library of this package: microslip.h, and the functions of python/src/interface.hpp.

Calls release the interpreter's lock, so that other threads run meanwhile.
"""

from __future__ import annotations

import ctypes as c
import pathlib
from typing import Any, Callable, Optional

import numpy as np

from ._errors import Error, InputError, NoSolution

STATUS_OF_INPUT, STATUS_OF_NO_SOLUTION, STATUS_OF_MEMORY = 1, 2, 3
STATUS_OF_STOP = 5
CREEPAGE, FORCE = 0, 1  # of microslip_load


def _dtype(*fields: str) -> np.dtype:
    """Makes a struct of C: "name" is a double, "name:int" an int."""
    return np.dtype([(name, np.intc if kind else float)
                     for name, _, kind in (field.partition(":") for field in fields)], align=True)


# The structs of microslip.h; tests/python/library_test.py holds them against it.
STATE = _dtype("distance", "force", "mean_force", "creepage", "dissipation", "residual", "violation",
               "adhesion_elements:int", "slip_elements:int", "iterations:int")
STEADY = _dtype("creepage", "force", "dissipation", "stick_edge", "residual", "violation",
                "dissipation_error", "condition", "adhesion_elements:int", "slip_elements:int", "method:int",
                "status:int")
SHIFT = _dtype("distance", "force", "dissipation", "work")
SLOPES = _dtype("force", "mean_force", "creepage", "dissipation")
JACOBIAN = np.dtype([("by_load", SLOPES), ("by_length", SLOPES)], align=True)


class Steps(c.Structure):
    _fields_ = [("count", c.c_size_t), *((name, c.c_void_p) for name in (
        "dq", "creepage", "force", "half_width_factor", "bound_factor"))]


class SteadyNodes(c.Structure):
    _fields_ = [(name, c.c_void_p) for name in ("x", "bound", "traction", "slip", "displacement")]


class SceneText(c.Structure):
    _fields_ = [("text", c.c_char_p), ("name", c.c_char_p), ("folder", c.c_char_p),
                ("assignments", c.POINTER(c.c_char_p)), ("assignment_count", c.c_size_t),
                ("file_names", c.POINTER(c.c_char_p)), ("file_texts", c.POINTER(c.c_char_p)),
                ("file_count", c.c_size_t)]


PROGRESS = c.CFUNCTYPE(c.c_int, c.c_size_t, c.c_size_t)


def _load() -> c.CDLL:
    file = pathlib.Path(__file__).with_name("_microslip.so")
    try:
        library = c.CDLL(str(file))
    except OSError as error:
        raise ImportError(f"{error}; expected the package as 'pip install .' or 'make build' makes it") from None
    handle, scene, number, size, text = c.c_void_p, c.POINTER(SceneText), c.c_double, c.c_size_t, c.c_char_p
    array = c.c_void_p
    functions: dict[str, tuple[Any, tuple[Any, ...]]] = {
        "version": (text, ()),
        "copy": (c.c_int, (handle, c.POINTER(handle))),
        "save": (c.c_int, (handle, text)),
        "restore": (c.c_int, (handle, text)),
        "destroy": (None, (handle,)),
        "message": (text, (handle,)),
        "method": (text, (handle,)),
        "warning": (text, (handle,)),
        "size": (size, (handle,)),
        "set_creepage": (c.c_int, (handle, number)),
        "set_force": (c.c_int, (handle, number)),
        "set_contact": (c.c_int, (handle, number, number)),
        "start_from_shift": (c.c_int, (handle, number, array)),
        "shift_to_force": (c.c_int, (handle, number, array)),
        "shift_by_distance": (c.c_int, (handle, number, array)),
        "advance": (c.c_int, (handle, number)),
        "roll": (c.c_int, (handle, c.POINTER(Steps), array)),
        "attempt": (c.c_int, (handle, number, array)),
        "attempt_with_jacobian": (c.c_int, (handle, number, array, array)),
        "get_state": (c.c_int, (handle, array)),
        "get_elastic_energy": (c.c_int, (handle, array)),
        "get_full_sliding": (c.c_int, (handle, array)),
        **{f"get_{values}": (c.c_int, (handle, array, size))
           for values in ("nodes", "traction", "bound", "slip", "displacement", "zones")},
        "py_error_status": (c.c_int, ()),
        "py_error_key": (text, ()),
        "py_error_message": (text, ()),
        "py_keys": (text, ()),
        "py_read": (handle, (scene, c.c_int)),
        "py_cases_destroy": (None, (handle,)),
        "py_case_count": (size, (handle,)),
        "py_swept_count": (size, (handle,)),
        "py_swept_key": (text, (handle, size)),
        "py_swept_value": (text, (handle, size, size)),
        "py_warnings": (text, (handle, size)),
        "py_solve": (handle, (handle, size, PROGRESS)),
        "py_tables_destroy": (None, (handle,)),
        "py_table_count": (size, (handle,)),
        "py_table_name": (text, (handle, size)),
        "py_table_text": (text, (handle, size)),
        "py_rolling": (handle, (scene,)),
        "py_save": (text, (handle,)),
        "py_restore": (c.c_int, (handle, text)),
        "py_writable_target": (text, (text,)),
        "py_steady_read": (handle, (scene,)),
        "py_steady_destroy": (None, (handle,)),
        "py_steady_size": (size, (handle,)),
        "py_full_sliding": (number, (handle,)),
        "py_steady_warnings": (text, (handle,)),
        "py_steady_doubt": (text, (handle, c.c_int, array, size)),
        "py_fastsim": (c.c_int, (handle, number, array, size, array)),
        "py_steady_solve": (c.c_int, (handle, c.c_int, array, size, c.c_int, array, c.POINTER(SteadyNodes),
                                      array, size)),
    }
    for name, (result, arguments) in functions.items():
        function = getattr(library, f"microslip_{name}")
        function.restype, function.argtypes = result, arguments
    return library


_library = _load()


def call(name: str, *arguments: Any) -> Any:
    """Calls the function microslip_NAME and returns its result."""
    return getattr(_library, f"microslip_{name}")(*arguments)


def text_of(name: str, *arguments: Any) -> str:
    """Calls a function that returns a text."""
    return call(name, *arguments).decode()


def error_of(status: int, message: str, key: str = "") -> Exception:
    """The exception for a status that is not 0."""
    if status == STATUS_OF_INPUT:
        return InputError.from_message(message, key)
    if status == STATUS_OF_NO_SOLUTION:
        return NoSolution(message)
    if status == STATUS_OF_MEMORY:
        return MemoryError(message)
    if status == STATUS_OF_STOP:
        return KeyboardInterrupt()
    return Error(f"an error of microslip itself, please report it: {message}")


def require(result: Any) -> Any:
    """Returns the result of a function microslip_py_*, if it is not null.

    Raises what the library says otherwise.
    """
    if result:
        return result
    raise error_of(call("py_error_status"), text_of("py_error_message"), text_of("py_error_key"))


def require_ok(status: int) -> None:
    """Raises what the library says, if a function microslip_py_* failed."""
    require(status == 0)


def as_progress(told: Optional[Callable[[int, int], Any]], raised: list[BaseException]) -> Any:
    """Makes a function of C that reports progress, and ends the work if the report raises something.

    An interrupt is noticed here, too, as the interpreter looks for one when it runs.

    told    called with what is done and the total, which is 0 if it is not known; may be None
    raised  out, what it raised
    """

    def call_back(done: int, total: int) -> int:
        try:
            if told is not None:
                told(done, total)
        except BaseException as error:  # pylint: disable=broad-except
            raised.append(error)
            return 1
        return 0

    return PROGRESS(call_back)
