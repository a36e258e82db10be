#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Lists what docs/stability.md promises to keep, one a line: keys of scenes with unit, default and words; options and exit statuses;
tables with columns; declarations of the C interface; names of the Python package.

usage: tools/promised.py MICROSLIP [--check | --add]

Without an option it prints what there is now. --check compares with tests/promised.txt, from which nothing may vanish, and exits
with status 1 if something has; --add writes what is new into it."""
import ast
import pathlib
import re
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
RECORD = ROOT / "tests/promised.txt"
TABLES = ROOT / "tests/reference_tables"
HEADERS = sorted((ROOT / "capi/include").glob("*.h"))
PACKAGE = ROOT / "python/microslip"
sys.dont_write_bytecode = True  # the folder holds sources only
sys.path.append(str(PACKAGE))
from _head import read_head
from keys import printed


def text_of(file):
    return file.read_text(encoding="utf-8")


def keys(program):
    """Keys of scenes; a default belongs to the meaning of a scene that leaves the key out."""
    for line in printed(program, "keys", "--format", "markdown").splitlines()[2:]:
        name, _, unit, accepted, _ = (cell.strip() for cell in re.split(r"(?<!\\)\|", line)[1:-1])
        name = name.strip("`")
        default = re.search(r"\[([^]]*)\]$", accepted)
        of_line, *of_ellipse = (unit or "1").split(", ")
        yield f"key {name} [{of_line}]" + (f" default {default[1]}" if default else "")
        yield from (f"key {name} [{other}] of an ellipse" for other in of_ellipse)
        words = re.match(r"`\w+`(?:, `\w+`)*", accepted)
        for word in re.findall(r"`(\w+)`", words[0]) if words else ():
            yield f"word {name} {word}"


def options(program):
    usage = printed(program, "--help")
    commands = re.findall(r"^  microslip (\w+)", usage, re.MULTILINE)
    for command, text in [("", usage), *((name, printed(program, name, "--help")) for name in commands)]:
        yield from (f"option microslip {command} {option}".replace("  ", " ")
                    for option in re.findall(r"^  (--[a-z-]+)", text, re.MULTILINE))


def exit_statuses(_program):
    table = text_of(ROOT / "docs/scenes.md").partition("| exit status | meaning |\n|---|---|\n")[2].partition("\n\n")[0]
    yield from (f"exit status {number}" for numbers in re.findall(r"^\| ([\d, ]+) \|", table, re.MULTILINE)
                for number in numbers.split(", "))


def columns_of(file, table):
    head, rows = read_head(text_of(file))
    yield from (f"column {table} {column.name} [{column.unit}]" for column in head.columns)
    header, *rows = [line.split("\t") for line in rows.splitlines()]
    if header == ["quantity", "value", "unit"]:
        yield from (f"row {table} {quantity} [{unit}]" for quantity, _, unit in rows)


def tables(program):
    """Tables of `microslip`; those of studies may change, as their keys and claims may."""
    for file in sorted(TABLES.glob("example_*/*.tsv")):
        yield from columns_of(file, f"{file.parent.name.removeprefix('example_')}/{file.name}")
    with tempfile.TemporaryDirectory() as folder:  # the one command without a reference table for line contacts
        printed(program, "curve", ROOT / "examples/steady.info", "--points", "3", "--beside", "fastsim", "--quiet", "--out",
                folder)
        for file in sorted(pathlib.Path(folder).glob("*.tsv")):
            yield from columns_of(file, f"curve/{file.name}")
    for name in ("transient", "ellipse_transient"):  # tables of a key that no example has
        with tempfile.TemporaryDirectory() as folder:
            printed(program, ROOT / f"examples/{name}.info", "--set", "motion.distance=3", "--set", "motion.instants=1", "--quiet",
                    "--out", folder)
            for file in sorted(pathlib.Path(folder).glob("instants*.tsv")):
                yield from columns_of(file, f"{name}/{file.name}")


def declarations(_program):
    """Functions with their arguments, structs with all their members, which a program is compiled with, and constants."""
    text = re.sub(r"/\*.*?\*/|^#.*?$|extern \"C\" \{|MICROSLIP_API", "", "\n".join(map(text_of, HEADERS)), flags=re.DOTALL | re.MULTILINE)
    for enum, body in re.findall(r"enum (\w+) \{(.*?)\};", text, re.DOTALL):
        yield from (f"C enum {enum}: {' '.join(entry.split())}" for entry in body.split(","))
    for name, body in re.findall(r"struct (\w+) \{(.*?)\};", text, re.DOTALL):
        yield f"C struct {name}: {' '.join(body.split())}"
    text = re.sub(r"(?:enum|struct) \w+ \{.*?\};", "", text, flags=re.DOTALL)
    yield from (f"C {' '.join(part.split())}" for part in text.split(";")[:-1])


def call(name, function):
    """A function, and its arguments: those without a name at their places."""
    given = function.args
    yield f"{name}()"
    places = [argument.arg for argument in given.posonlyargs + given.args if argument.arg != "self"]
    yield from (f"{name}() argument {place}: {argument}" for place, argument in enumerate(places))
    yield from (f"{name}() argument {argument.arg}=" for argument in given.kwonlyargs + [given.kwarg] * bool(given.kwarg))


MADE = ("Patch", "Rolling")  # classes that users make


def parts_of(node, classes):
    """The parts of a class, and of those of the package that it builds upon."""
    bases = [classes[base.id] for base in node.bases if getattr(base, "id", "") in classes]
    return node.body + [part for base in bases for part in parts_of(base, classes)]


def members(node, classes):
    """Public methods, properties and attributes of a class; of its making only if users make it."""
    for part in parts_of(node, classes):
        if isinstance(part, ast.AnnAssign):
            yield f"{node.name}.{part.target.id}"
        elif isinstance(part, ast.FunctionDef):
            decorators = {getattr(name, "id", "") for name in part.decorator_list}
            if "property" in decorators:
                yield f"{node.name}.{part.name}"
            elif "classmethod" not in decorators and (part.name[0] != "_" or part.name == "__init__" and node.name in MADE):
                yield from call(f"{node.name}.{part.name}", part)
            yield from (f"{node.name}.{target.attr}" for target in ast.walk(part) if isinstance(target, ast.Attribute)
                        and isinstance(target.ctx, ast.Store) and getattr(target.value, "id", "") == "self")


def python_names(_program):
    trees = [ast.parse(text_of(file)) for file in sorted(PACKAGE.glob("*.py"))]
    shown = next(ast.literal_eval(part.value) for tree in trees for part in tree.body
                 if isinstance(part, ast.Assign) and getattr(part.targets[0], "id", "") == "__all__")
    classes = {part.name: part for tree in trees for part in tree.body if isinstance(part, ast.ClassDef)}
    for node in (part for tree in trees for part in tree.body if getattr(part, "name", "") in shown):
        names = call(node.name, node) if isinstance(node, ast.FunctionDef) else [node.name, *members(node, classes)]
        yield from (f"Python {name}" for name in names if not re.search(r"\._(?!_init__)", name))


def promised(program):
    """All lines, each once, sorted."""
    parts = (keys, options, exit_statuses, tables, declarations, python_names)
    return sorted({line for part in parts for line in part(program)})


def recorded():
    return text_of(RECORD).splitlines()


def vanished(before, now):
    return sorted(set(before) - set(now))


def main(program, option):
    now = promised(program)
    if not option:
        print("\n".join(now))
        return 0
    gone = vanished(recorded(), now)
    for line in gone:
        print(f"no longer there, or changed: {line}")
    if option == "--add" and not gone:
        RECORD.write_text("".join(f"{line}\n" for line in now), encoding="utf-8")
    return 1 if gone else 0


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3) or sys.argv[2:] not in ([], ["--check"], ["--add"]):
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1], "".join(sys.argv[2:])))
