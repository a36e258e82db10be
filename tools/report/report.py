#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes one HTML page of the tables and figures of all studies. Usage: report.py RESULTS_FOLDER OUTPUT.html
Bad input is one line and exit status 1, and leaves no page, not even that of before."""
import os
import sys
from pathlib import Path

sys.dont_write_bytecode = True  # the folder holds sources only
from faults import FAULTS
from figures import read_figure
from page import page
from prose import introduction, sections_of
from tables import ReportError, read_study, studies_of

ROOT = Path(__file__).resolve().parents[2]
STUDIES = ROOT / "docs" / "studies.md"


def figures_of(results, study, prefix):
    paths = sorted((results / "figures").glob(f"{study.name}_*.svg"))
    figures = [read_figure(path, f"{prefix}-{i}-") for i, path in enumerate(paths)]
    names = {figure.name for figure in figures}
    for claim in study.claims:
        if claim.figure not in names | {"none"}:
            raise ReportError(f"{results}/{study.name}/claims.tsv: '{claim.claim}' names the figure {claim.figure}; "
                              f"expected none or one of {', '.join(sorted(names)) or 'no figures'}")
    return figures


def report(results):
    if not results.is_dir():
        raise ReportError(f"{results}: no such folder; expected what `make figures` writes")
    sections = sections_of(STUDIES)
    studies = [read_study(results, name, question, introduction(sections, name, STUDIES))
               for name, question in studies_of(ROOT / "README.md")]
    figures = {study.name: figures_of(results, study, study.name) for study in studies}
    faults = [(fault, read_figure(results / "figures" / f"{fault.figure}.svg", f"fault-{i}-"))
              for i, fault in enumerate(FAULTS, 1)]
    return page(studies, figures, faults)


def write(text, output):
    """All of it, or nothing."""
    partial = output.with_name(f".{output.name}.{os.getpid()}.part")
    try:
        output.parent.mkdir(parents=True, exist_ok=True)
        partial.write_text(text, encoding="utf-8")
        partial.replace(output)
    finally:
        partial.unlink(missing_ok=True)


def main(arguments):
    if len(arguments) != 2:
        print("report: expected RESULTS_FOLDER OUTPUT.html", file=sys.stderr)
        return 1
    results, output = map(Path, arguments)
    try:
        output.unlink(missing_ok=True)
        write(report(results), output)
    except ReportError as error:
        print(f"report: {error}", file=sys.stderr)
        return 1
    except OSError as error:
        print(f"report: {output}: cannot be written: {error.strerror}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
