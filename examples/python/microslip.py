# SPDX-License-Identifier: GPL-3.0-or-later
"""microslip from Python, by ctypes and numpy; microslip.h says what everything means.

The library is the file that the environment variable MICROSLIP_LIBRARY names, or else the system's.
"""

import ctypes as c
import os
from copy import deepcopy

import numpy as np


class Material(c.Structure):
    _fields_ = [("shear_modulus", c.c_double), ("poisson_ratio", c.c_double)]


class Contact(c.Structure):
    _fields_ = [("half_width", c.c_double), ("peak_traction", c.c_double),
                ("bound_x", c.POINTER(c.c_double)), ("bound_value", c.POINTER(c.c_double)),
                ("bound_rows", c.c_size_t)]


class Kernel(c.Structure):
    STRIP, PLANE = 0, 1
    _fields_ = [("type", c.c_int), ("length", c.c_double)]


class Grid(c.Structure):
    REMEMBERED, DIRECT = 0, 1
    _fields_ = [("elements", c.c_int), ("scheme", c.c_int)]


class State(c.Structure):
    _fields_ = [(name, c.c_double) for name in (
        "distance", "force", "mean_force", "creepage", "dissipation", "residual",
        "violation")] + [(name, c.c_int) for name in (
            "adhesion_elements", "slip_elements", "iterations")]


class Slopes(c.Structure):
    _fields_ = [(name, c.c_double) for name in ("force", "mean_force", "creepage", "dissipation")]


class Jacobian(c.Structure):
    _fields_ = [("by_load", Slopes), ("by_length", Slopes)]


class Shift(c.Structure):
    _fields_ = [(name, c.c_double) for name in ("distance", "force", "dissipation", "work")]


class Error(Exception):
    """A call failed; `status` is that of microslip.h, and the text says why."""

    def __init__(self, status, why):
        super().__init__(why)
        self.status = status


_file = os.environ.get("MICROSLIP_LIBRARY", "libmicroslip.so.0.1")
try:
    _library = c.CDLL(_file)
except OSError as error:
    raise ImportError(f"{error}; expected the environment variable MICROSLIP_LIBRARY to name it") from None
_handle = c.c_void_p
for _name, *_arguments in (
        ("create", *map(c.POINTER, (Material, Contact, Kernel, Grid, _handle)), c.c_char_p, c.c_size_t),
        ("copy", _handle, c.POINTER(_handle)),
        ("save", _handle, c.c_char_p),
        ("restore", _handle, c.c_char_p),
        ("set_creepage", _handle, c.c_double),
        ("set_force", _handle, c.c_double),
        ("set_contact", _handle, c.c_double, c.c_double),
        ("start_from_shift", _handle, c.c_double, c.POINTER(c.c_double)),
        ("shift_to_force", _handle, c.c_double, c.POINTER(Shift)),
        ("shift_by_distance", _handle, c.c_double, c.POINTER(Shift)),
        ("advance", _handle, c.c_double),
        ("attempt", _handle, c.c_double, c.POINTER(State)),
        ("attempt_with_jacobian", _handle, c.c_double, c.POINTER(State), c.POINTER(Jacobian)),
        ("get_state", _handle, c.POINTER(State)),
        ("get_elastic_energy", _handle, c.POINTER(c.c_double)),
        ("get_full_sliding", _handle, c.POINTER(c.c_double)),
        *((f"get_{values}", _handle, c.c_void_p, c.c_size_t) for values in (
            "nodes", "traction", "bound", "slip", "displacement", "zones"))):
    getattr(_library, f"microslip_{_name}").argtypes = _arguments
_library.microslip_destroy.argtypes = [_handle]
_library.microslip_destroy.restype = None
_library.microslip_message.argtypes = [_handle]
_library.microslip_message.restype = c.c_char_p
_library.microslip_size.argtypes = [_handle]
_library.microslip_size.restype = c.c_size_t


class Rolling:
    """A contact that rolls. Functions of microslip.h are methods, and what they give, results.

    copy.copy and copy.deepcopy copy the contact as well; it cannot be pickled, but saved to a file.
    """

    _handle = None  # until the library has made one

    def __init__(self, material, contact, kernel, grid):
        handle = _handle()
        message = c.create_string_buffer(512)
        status = _library.microslip_create(material, contact, kernel, grid, c.byref(handle),
                                           message, len(message))
        if status:
            raise Error(status, message.value.decode())
        self._handle = handle

    def __del__(self):
        _library.microslip_destroy(self._handle)

    def _call(self, name, *arguments):
        status = getattr(_library, f"microslip_{name}")(self._handle, *arguments)
        if status:
            raise Error(status, _library.microslip_message(self._handle).decode())

    def _get(self, name, result, *arguments):
        self._call(name, *arguments, c.byref(result))
        return result

    def _values(self, name, kind=float):
        values = np.empty(_library.microslip_size(self._handle), kind)
        self._call(name, values.ctypes.data, values.size)
        return values

    def copy(self):
        """An independent contact that goes on like this one; attributes of your own are shared."""
        return self._copy_with(vars(self))

    __copy__ = copy

    def __deepcopy__(self, memo):
        own = {name: value for name, value in vars(self).items() if name != "_handle"}
        other = memo[id(self)] = self._copy_with({})
        vars(other).update(deepcopy(own, memo))
        return other

    def _copy_with(self, attributes):
        other = type(self).__new__(type(self))
        vars(other).update(attributes, _handle=None)
        other._handle = self._get("copy", _handle())
        return other

    def save(self, path):
        """Writes the state to a file, without the load."""
        self._call("save", os.fsencode(path))

    def restore(self, path):
        """Goes on from the file of a like contact; the load stays as it was set."""
        self._call("restore", os.fsencode(path))

    def set_creepage(self, creepage):
        self._call("set_creepage", creepage)

    def set_force(self, force):
        self._call("set_force", force)

    def set_contact(self, half_width, bound):
        """The contact at the end of the next step, over that which was created."""
        self._call("set_contact", half_width, bound)

    def start_from_shift(self, force):
        return self._get("start_from_shift", c.c_double(), force).value

    def shift_to_force(self, force):
        return self._get("shift_to_force", Shift(), force)

    def shift_by_distance(self, distance):
        return self._get("shift_by_distance", Shift(), distance)

    def advance(self, dq):
        self._call("advance", dq)

    def attempt(self, dq):
        return self._get("attempt", State(), dq)

    def attempt_with_jacobian(self, dq):
        """The state, and the derivatives of the step."""
        state, jacobian = State(), Jacobian()
        self._call("attempt_with_jacobian", dq, c.byref(state), c.byref(jacobian))
        return state, jacobian

    state = property(lambda self: self._get("get_state", State()))
    elastic_energy = property(lambda self: self._get("get_elastic_energy", c.c_double()).value)
    full_sliding = property(lambda self: self._get("get_full_sliding", c.c_double()).value)
    nodes = property(lambda self: self._values("get_nodes"))
    traction = property(lambda self: self._values("get_traction"))
    bound = property(lambda self: self._values("get_bound"))
    slip = property(lambda self: self._values("get_slip"))
    displacement = property(lambda self: self._values("get_displacement"))
    zones = property(lambda self: self._values("get_zones", np.intc))
