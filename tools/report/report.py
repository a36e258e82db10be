#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes one HTML page of the tables and figures of all studies. Usage: report.py RESULTS_FOLDER OUTPUT.html
Bad input is one line and exit status 1, and leaves no page, not even that of before."""
import sys
from pathlib import Path

sys.dont_write_bytecode = True  # the folder holds sources only
from faults import FAULTS
from figures import read_figure
from page import page
from prose import introduction, sections_of
from tables import ROOT, ReportError, questions, read_study, run, write_whole

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
    studies = [read_study(results, name) for name in questions()]
    for study in studies:
        study.introduction = introduction(sections, study.name, STUDIES)
    figures = {study.name: figures_of(results, study, study.name) for study in studies}
    faults = [(fault, read_figure(results / "figures" / f"{fault.figure}.svg", f"fault-{i}-"))
              for i, fault in enumerate(FAULTS, 1)]
    return page(studies, figures, faults)


def main(results, output):
    output = Path(output)
    try:
        output.unlink(missing_ok=True)
        write_whole(output, report(Path(results)).encode())
    except OSError as error:
        raise ReportError(f"{output}: cannot be written: {error.strerror}") from None


if __name__ == "__main__":
    run("report", "RESULTS_FOLDER OUTPUT.html", main, (2,))
