# SPDX-License-Identifier: GPL-3.0-or-later
"""The studies, and what they wrote: tables, provenance, claims."""
import re
import shlex
from dataclasses import dataclass
from pathlib import Path

ROUNDING = "# nothing but rounding"
NOT_JUDGED = "not_judged"
GIVEN = ("reproduced", "corrected", "refuted", "not_comparable", "ours")  # by the rule of a claim
VERDICTS = (*GIVEN, NOT_JUDGED)
CLAIM_COLUMNS = ("claim", "section", "thesis_value", "measured_value", "unit", "rule", "tolerance", "verdict", "note",
                 "figure")


class ReportError(Exception):
    """Says what is wrong, and what is expected, in one line."""


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
    rows: list  # of cells, as text
    rounding: dict  # bounds up to which numbers are nothing but rounding, by column and first cell or None


def read_table(path):
    """A table as scene/src/table.cpp writes it."""
    def bad(expected):
        return ReportError(f"{path}: not a whole table: expected {expected}")

    text = read_text(path)
    if not text.endswith("\n"):
        raise bad("an end of the last line")
    lines = text.splitlines()
    comments = [line for line in lines if line.startswith("#")]
    first = re.fullmatch(r"# (\S+): (.+)", comments[0]) if comments else None
    if not first or "# parameters" not in comments or "# columns" not in comments:
        raise bad("a comment with description, parameters and columns")
    at = comments.index("# columns")
    parameters = [tuple(line[4:].split(" = ", 1)) for line in comments[2:at]]
    end = comments.index(ROUNDING) if ROUNDING in comments[at:] else len(comments)
    columns = [re.fullmatch(r"#   (\S+) \[(.*?)\]: (.*)", line) for line in comments[at + 1:end]]
    bounds = [re.fullmatch(r"#   (\S+) up to (\S+)(?: where \S+ = (.*))?", line) for line in comments[end + 1:]]
    if not all(columns + bounds) or any(len(parameter) != 2 for parameter in parameters):
        raise bad("`key = value` and `column [unit]: meaning`")
    rounding = {(column, name): float(bound) for column, bound, name in (line.groups() for line in bounds)}
    columns = [column.groups() for column in columns]
    names = [column[0] for column in columns]
    rows = [line.split("\t") for line in lines[len(comments):]]
    if not rows or rows[0] != names or any(len(row) != len(names) for row in rows):
        raise bad("rows of " + ", ".join(names))
    return Table(Path(path).stem, first[2], parameters, columns, rows[1:], rounding)


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


@dataclass
class Study:
    name: str
    question: str
    command: str
    provenance: dict
    tables: list
    claims: list
    not_judged: str  # why, or empty
    introduction: str  # in Markdown

    @property
    def parameters(self):
        return self.tables[0].parameters


def studies_of(readme):
    """Name and question of each study, in the order of the README's table."""
    studies = re.findall(r"^\| \[(\w+)\]\(docs/studies\.md#\1\) \| (.+?) \| ", read_text(readme), re.MULTILINE)
    if not studies:
        raise ReportError(f"{readme}: expected a table of studies, | [name](docs/studies.md#name) | question | ...")
    return studies


def read_study(results, name, question, introduction=""):
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
    return Study(name, question, command, provenance, tables, claims, not_judged, introduction)
