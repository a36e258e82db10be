# SPDX-License-Identifier: GPL-3.0-or-later
"""The shared library of this package: microslip.h, microslip_ellipse.h, microslip_creep_table.h, microslip_friction.h,
and the functions of python/src/interface.hpp.

Calls release the interpreter's lock, so that other threads run meanwhile.
"""

from __future__ import annotations

import ctypes as c
import pathlib
import weakref
from typing import Any, Callable, Dict, Optional

import numpy as np

from ._arrays import fields_of
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
# Those of microslip_ellipse.h. Here the three numbers of its arrays have a name each.
MOTIONS = ("creepage", "lateral_creepage", "spin")
RESULTANTS = ("force", "lateral_force", "spin_moment")
PATCH_STATE = _dtype("distance", *RESULTANTS, *MOTIONS, "dissipation", "full_sliding", "slip_share", "residual",
                     "iterations:int")
SHIFTS = ("shift", "lateral_shift", "rotation")  # in the place of motions where nothing rolls
PATCH_SHIFT = _dtype(*(dict(zip(MOTIONS, SHIFTS)).get(name, name) for name in fields_of(PATCH_STATE)[:-1]),
                     "iterations:int")
PATCH_LOAD = np.dtype([("prescribed", np.intc, 3), ("value", float, 3)], align=True)
MATERIAL = _dtype("shear_modulus", "poisson_ratio")
BODIES = _dtype("normal_load", "radius_1", "radius_2", "lateral_radius_1", "lateral_radius_2", "friction")
ELLIPSE_CONTACT = _dtype("half_width", "lateral_half_width", "peak_traction")
# That of microslip_creep_table.h.
CREEP_TABLE_INFO = np.dtype([("poisson_ratio", float), ("least_ratio", float), ("largest_ratio", float),
                             ("states", np.intc),
                             *((f"error_{name}", float, 3) for name in ("rms", "of_99_percent", "largest"))], align=True)


class PatchCells(c.Structure):
    _fields_ = [(name, c.c_void_p) for name in (
        "x", "y", "area", "bound", "traction_x", "traction_y", "slip_x", "slip_y", "slips")]


class PatchSolutions(c.Structure):
    _fields_ = [*((name, c.c_void_p) for name in ("states", "changes", "statuses", "messages")), ("room", c.c_size_t),
                ("cells", PatchCells)]


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

# Functions by the types of their result and arguments: - stands for nothing, i for int, s for size_t, d for double,
# t for a text, and p for another pointer.
TYPES = {"-": None, "i": c.c_int, "s": c.c_size_t, "d": c.c_double, "t": c.c_char_p, "p": c.c_void_p}
FUNCTIONS = {
    "t": "version py_error_key py_error_message py_keys",
    "i": "py_error_status",
    "-p": "creep_table_close destroy ellipse_destroy py_cases_destroy py_patch_destroy py_tables_destroy py_steady_destroy",
    "tp": "message ellipse_message method warning py_patch_edges py_patch_warnings py_save py_steady_warnings py_swept",
    "sp": "size py_patch_elements py_patch_rows py_table_count py_steady_size",
    "dp": "py_full_sliding py_patch_full_sliding",
    "ip": "py_has_patch has_second_solution ellipse_has_second_solution",
    "pp": "py_patch_ellipse py_patch_read py_rolling py_steady_read",
    "tt": "py_writable_target",
    "ipt": "save restore ellipse_save ellipse_restore ellipse_restore_from_memory py_restore",
    "ipp": "copy ellipse_copy ellipse_get_cells ellipse_get_elastic_energy ellipse_get_state get_state "
           "get_elastic_energy get_full_sliding py_contact py_ellipse_contact",
    "ipd": "set_creepage set_force advance set_speed ellipse_set_speed",
    "ppii": "py_read",
    "tps": "py_warnings py_table_name py_table_text",
    "ppsp": "py_solve",
    "tpid": "py_patch_doubt",
    "tiddd": "py_motion_doubt",
    "tdd": "py_units_doubt",
    "ippp": "ellipse_shift roll",
    "ipdd": "ellipse_set_contact set_contact",
    "ippsp": "ellipse_save_to_memory",
    "ipppp": "ellipse_solve_steady",
    "ipdppp": "ellipse_attempt",
    "ipppps": "hertz_ellipse",
    "itpps": "creep_table_open",
    "ippps": "creep_table_get_info",
    "ippppsppps": "creep_table_forces_many",
    "ippsip": "py_patch_steady",
    "ipdp": "start_from_shift shift_to_force shift_by_distance attempt",
    "ipps": "get_nodes get_traction get_bound get_slip get_displacement get_zones",
    "ipdpp": "attempt_with_jacobian ellipse_advance",
    "ipdpsp": "py_fastsim",
    "tpips": "py_steady_doubt",
    "ipipsippps": "py_steady_solve",
}


def _load() -> Dict[str, Any]:
    file = pathlib.Path(__file__).with_name("_microslip.so")
    try:
        library = c.CDLL(str(file))
    except OSError as error:
        raise ImportError(f"{error}; expected the package as 'pip install .' or 'make build' makes it") from None
    functions = {}
    for types, names in FUNCTIONS.items():
        prototype = c.CFUNCTYPE(*(TYPES[one] for one in types))  # type: ignore[arg-type]
        for name in names.split():
            functions[name] = prototype((f"microslip_{name}", library))
    return functions


_functions = _load()


def call(name: str, *arguments: Any) -> Any:
    """Calls the function microslip_NAME and returns its result."""
    return _functions[name](*arguments)


def text_of(name: str, *arguments: Any) -> str:
    """Calls a function that returns a text."""
    return call(name, *arguments).decode()


def free_with(owner: Any, name: str, handle: int) -> weakref.finalize:
    """Frees a handle by the function microslip_NAME when nobody uses its owner any more.

    It is not freed when the interpreter ends, as a thread may still use it then.
    """
    finalizer = weakref.finalize(owner, call, name, handle)
    finalizer.atexit = False
    return finalizer


def error_of(status: int, message: str, key: str = "") -> BaseException:
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
