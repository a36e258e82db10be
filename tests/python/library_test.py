# SPDX-License-Identifier: GPL-3.0-or-later
"""The package's statements about the library hold against its headers, and its examples against themselves."""
import doctest
import importlib
import pkgutil
import re

import numpy as np
import pytest

import microslip
from microslip import _library

KINDS = {"double": np.dtype(float), "int": np.dtype(np.intc), "struct microslip_slopes": _library.SLOPES}
HEADERS = ("capi/include/microslip.h", "capi/include/microslip_ellipse.h", "capi/include/microslip_creep_table.h",
           "capi/include/microslip_friction.h", "python/src/interface.hpp")


def struct(header, name):
    """Names and types of a struct in C, without comments."""
    body = re.search(r"struct %s \{(.*?)\};" % name, header, re.DOTALL).group(1)
    fields = re.sub(r"/\*.*?\*/|///<[^\n]*", "", body, flags=re.DOTALL)
    return re.findall(r"([\w ]+?(?: ?\*)?(?:const\*)?) ?(\w+(?:\[\d\])?);", fields)


@pytest.mark.parametrize("name", ["state", "steady", "shift", "slopes", "jacobian"])
def test_records_are_the_structs_of_the_header(name, source):
    header = (source / "capi/include/microslip.h").read_text()
    dtype = getattr(_library, name.upper())
    fields = [(field, KINDS[kind.strip()]) for kind, field in struct(header, f"microslip_{name}")]
    assert [(field, dtype[field]) for field in dtype.names] == fields
    assert dtype.isalignedstruct


def spread(fields, names):
    """The same fields, of which arrays of three have names of their own."""
    for kind, field in fields:
        yield from ((kind, name) for name in names.get(field.partition("[")[0], [field]))


THREE = {"resultants": _library.RESULTANTS, "motion": _library.MOTIONS}


@pytest.mark.parametrize("name, record, names", [
    ("microslip_ellipse_state", "PATCH_STATE", THREE),
    ("microslip_ellipse_state", "PATCH_SHIFT", {**THREE, "motion": _library.SHIFTS}),
    ("microslip_bodies", "BODIES", {}), ("microslip_ellipse_contact", "ELLIPSE_CONTACT", {}),
    ("microslip_material", "MATERIAL", {})])
def test_records_of_ellipses_are_the_structs_of_the_headers(name, record, names, source):
    header = "".join((source / file).read_text() for file in HEADERS)
    dtype = getattr(_library, record)
    expected = [(field, KINDS[kind.strip()]) for kind, field in spread(struct(header, name), names)]
    assert [(field, dtype[field]) for field in dtype.names] == expected
    assert dtype.isalignedstruct


def test_the_record_of_a_table_is_the_struct_of_the_header(source):
    header = (source / "capi/include/microslip_creep_table.h").read_text()
    info = _library.CREEP_TABLE_INFO
    fields = [(name + (f"[{info[name].shape[0]}]" if info[name].shape else ""), info[name].base) for name in info.names]
    assert fields == [(field, KINDS[kind.strip()]) for kind, field in struct(header, "microslip_creep_table_info")]
    assert info.isalignedstruct


def test_loads_of_ellipses_are_those_of_the_header(source):
    header = (source / "capi/include/microslip_ellipse.h").read_text()
    load = _library.PATCH_LOAD
    fields = [(f"{name}[{load[name].shape[0]}]", load[name].base) for name in load.names]
    assert fields == [(field, KINDS[kind.strip()]) for kind, field in struct(header, "microslip_ellipse_load")]
    assert load.isalignedstruct


@pytest.mark.parametrize("name, file, kind", [
    ("microslip_steps", "capi/include/microslip.h", _library.Steps),
    ("microslip_steady_nodes", "capi/include/microslip.h", _library.SteadyNodes),
    ("microslip_ellipse_cells", "capi/include/microslip_ellipse.h", _library.PatchCells),
    ("microslip_py_patch_solutions", "python/src/interface.hpp", _library.PatchSolutions),
    ("microslip_py_scene", "python/src/interface.hpp", _library.SceneText)])
def test_structures_have_the_fields_of_the_header(name, file, kind, source):
    fields = [field for _, field in struct((source / file).read_text(), name)]
    assert [field for field, *_ in kind._fields_] == fields


def test_functions_have_the_types_of_the_headers(source):
    headers = "".join((source / file).read_text() for file in HEADERS)
    headers = re.sub(r"/\*.*?\*/|//[^\n]*", "", headers, flags=re.DOTALL)
    kinds = {"void": "-", "int": "i", "enum microslip_status": "i", "size_t": "s", "std::size_t": "s", "double": "d",
             "const char*": "t", "microslip_py_progress": "p"}
    declared = {}
    declaration = re.compile(r"MICROSLIP_API ([\w: ]+?\*?) ?microslip_(\w+)\((.*?)\);", re.DOTALL)
    for result, name, arguments in declaration.findall(headers):
        words = [result, *(" ".join(one.split()).rpartition(" ")[0] for one in arguments.split(",") if one != "void")]
        declared[name] = "".join(kinds.get(word, "p" if "*" in word else "?") for word in words)
    taken = {name: types for types, names in _library.FUNCTIONS.items() for name in names.split()}
    assert taken == {name: declared[name] for name in taken}


@pytest.mark.parametrize("module", [name for _, name, _ in pkgutil.iter_modules(microslip.__path__)
                                    if name != "_microslip"])
def test_examples_in_docstrings(module):
    found = importlib.import_module(f"microslip.{module}")
    result = doctest.testmod(found)
    assert result.failed == 0


def test_all_that_is_public_has_a_docstring():
    for name in microslip.__all__:
        thing = getattr(microslip, name)
        assert thing.__doc__, name
        if isinstance(thing, type):
            for member, value in vars(thing).items():
                if not member.startswith("_") and (callable(value) or isinstance(value, property)):
                    assert value.__doc__, f"{name}.{member}"


def test_examples_are_tried():
    finder = doctest.DocTestFinder()
    tried = {test.name for name in microslip.__all__ for test in finder.find(getattr(microslip, name), name)
             if test.examples}
    assert {"solve", "steady", "creep_curve", "sweep", "read_table", "keys", "hertz", "Rolling", "Patch",
            "CreepTable", "InputError"} <= tried
