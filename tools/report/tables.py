# SPDX-License-Identifier: GPL-3.0-or-later
"""The studies, and what they wrote: tables, provenance, claims. Programs that read it begin by run()."""
import functools
import importlib
import os
import re
import shlex
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "python/microslip"))
from _head import read_head

NOT_JUDGED = "not_judged"
GIVEN = ("reproduced", "corrected", "refuted", "not_comparable", "ours")  # by the rule of a claim
VERDICTS = (*GIVEN, NOT_JUDGED)
CLAIM_COLUMNS = ("claim", "section", "thesis_value", "measured_value", "unit", "rule", "tolerance", "verdict", "note",
                 "figure")


class ReportError(Exception):
    """Says what is wrong, and what is expected, in one line."""


def run(name, usage, work, counts):
    """Works on the arguments of the command line, as many as `counts` has; an error is one line and exit status 1."""
    try:
        if len(sys.argv) - 1 not in counts:
            raise ReportError(f"expected {usage}")
        work(*sys.argv[1:])
    except (ReportError, OSError, subprocess.CalledProcessError) as error:
        sys.exit(f"{name}: {error}")


def module(name):
    """A module of a Debian package, for any Python."""
    sys.path.append("/usr/lib/python3/dist-packages")
    try:
        return importlib.import_module(name)
    except ImportError as error:
        sys.exit(f"report: {error}; `tools/deps.sh report` installs it")


def write_whole(path, data):
    """Writes all bytes of a file, or nothing."""
    partial = path.with_name(f".{path.name}.{os.getpid()}.part")
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        partial.write_bytes(data)
        partial.replace(path)
    finally:
        partial.unlink(missing_ok=True)


def read_text(path):
    try:
        return Path(path).read_text(encoding="utf-8")
    except FileNotFoundError:
        raise ReportError(f"{path}: no such file; expected what `make figures` writes") from None
    except (OSError, UnicodeDecodeError) as error:
        raise ReportError(f"{path}: cannot be read: {error}") from None


@dataclass
class Table:
    name: str
    description: str
    parameters: list  # of (key, value)
    columns: list  # of (name, unit, meaning)
    rounding: dict  # bounds up to which numbers are nothing but rounding, by column and first cell or None
    rows: list  # of cells, as text


def read_table(path):
    def bad(expected):
        return ReportError(f"{path}: not a whole table: expected {expected}")

    text = read_text(path)
    if not text.endswith("\n"):
        raise bad("an end of the last line")
    head, text = read_head(text)
    if not all(head[:3]):
        raise bad("a comment with description, parameters and columns")
    names = [column.name for column in head.columns]
    header, *rows = [line.split("\t") for line in text.splitlines()] or [[]]
    if header != names or any(len(row) != len(names) for row in rows):
        raise bad("rows of " + ", ".join(names))
    return Table(Path(path).stem, *head, rows)


@dataclass
class Claim:
    claim: str
    section: str
    thesis_value: float  # nan if it gives none
    measured_value: float  # nan if nothing could be measured, as in some quick runs
    unit: str
    rule: str  # how the verdict follows from the measured value
    tolerance: float  # half the width of the range that the rule accepts; nan if it has one bound
    verdict: str
    note: str
    figure: str  # or none
    id: str = ""
    rounding: float = 0  # the measured value is nothing but that, up to this

    def __post_init__(self):
        self.thesis_value, self.measured_value = float(self.thesis_value), float(self.measured_value)
        self.tolerance = float(self.tolerance)
        if not self.rule:
            raise ValueError(f"'{self.claim}' has no rule")
        if self.verdict not in VERDICTS:
            raise ValueError(f"unknown verdict '{self.verdict}'; known: {', '.join(VERDICTS)}")

    @property
    def is_rounding(self):
        return 0 < self.rounding >= abs(self.measured_value)


@dataclass
class Study:
    name: str
    question: str
    command: str
    provenance: dict
    tables: list
    claims: list
    not_judged: str  # why, or empty
    introduction: str = ""  # in Markdown

    @property
    def parameters(self):
        return self.tables[0].parameters


@functools.lru_cache(maxsize=None)
def questions():
    """The question of each study by its name, in the order of the table in README, from which CMake has them as well."""
    readme = ROOT / "README.md"
    rows = re.findall(r"^\| \[(\w+)\]\(docs/studies\.md#\1\) \| (.+?) \| ", read_text(readme), re.MULTILINE)
    if not rows:
        raise ReportError(f"{readme}: expected a table of studies, | [name](docs/studies.md#name) | question | ...")
    return dict(rows)


def read_study(results, name):
    folder = Path(results) / name
    claims_file = folder / "claims.tsv"
    table = read_table(claims_file)
    if tuple(column[0] for column in table.columns) != CLAIM_COLUMNS:
        raise ReportError(f"{claims_file}: expected the columns {', '.join(CLAIM_COLUMNS)}")
    try:
        claims = [Claim(*row, id=f"{name}-{i}",
                        rounding=table.rounding.get(("measured_value", row[0]), 0)) for i, row in enumerate(table.rows, 1)]
    except ValueError as error:
        raise ReportError(f"{claims_file}: {error}") from None
    not_judged = table.description.partition("; not judged: ")[2]
    if any((claim.verdict == NOT_JUDGED) != bool(not_judged) for claim in claims):
        raise ReportError(f"{claims_file}: expected the verdict {NOT_JUDGED} of all claims, and the reason in the first "
                          "line, or neither")
    path = folder / "provenance.txt"
    lines = read_text(path).splitlines()
    provenance = dict(line.split(": ", 1) for line in lines if ": " in line)
    provenance["program"] = lines[0] if lines else ""
    missing = [key for key in ("command", "date", "wall time", "tables") if key not in provenance]
    if missing:
        raise ReportError(f"{path}: expected a line `{missing[0]}: ...`")
    try:
        command = shlex.join(shlex.split(provenance["command"]))
    except ValueError as error:
        raise ReportError(f"{path}: command: {error}") from None
    tables = [read_table(folder / file) for file in provenance["tables"].split()]
    return Study(name, questions()[name], command, provenance, tables, claims, not_judged)
