#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Claims by their names, STUDY-NUMBER, with verdict and cost.
Usage: claims.py one PROGRAMS WORK_FOLDER NAME   runs the study of one claim, and prints its verdict, rule, time and memory
       claims.py all RESULTS                     a table of all claims that were run, with the cost of their studies
NAME is a name, or a part of the statement that only one claim has."""
import math
import subprocess
import sys
from pathlib import Path

sys.dont_write_bytecode = True  # the folder holds sources only
sys.path.insert(0, str(Path(__file__).with_name("report")))
from tables import ROOT, ReportError, questions, read_study, read_table, run

USAGE = "one PROGRAMS WORK_FOLDER NAME, or all RESULTS"


def known_claims():
    """Name, study and statement of each claim; the tables of quick runs have all of them."""
    for study in questions():
        rows = read_table(ROOT / f"tests/reference_tables/{study}/claims.tsv").rows
        for i, row in enumerate(rows, 1):
            yield f"{study}-{i}", study, row[0]


def find(name):
    known = list(known_claims())
    found = [claim for claim in known if claim[0] == name] or [claim for claim in known if name and name in claim[2]]
    if len(found) == 1:
        return found[0]
    listed = "\n".join(f"  {claim[0]:24} {claim[2]}" for claim in found or known)
    what = f"{len(found)} claims have" if found else "no claim is or has"
    raise ReportError(f"{what} '{name}'; expected one of\n{listed}")


def number(value):
    return "none" if math.isnan(value) else f"{value:.6g}"


def measured(claim):
    return f"nothing but rounding, below {claim.rounding:.1g}" if claim.is_rounding else number(claim.measured_value)


def cost(study):
    return study.provenance["wall time"], study.provenance.get("peak memory", "unknown")


def one(programs, work, name):
    """Runs the study, whole, into a folder of its own."""
    name, study, _ = find(name)
    out = Path(work) / study
    subprocess.run([Path(programs) / study, "--quiet", "--out", out], check=True)
    result = read_study(work, study)
    claim = next(claim for claim in result.claims if claim.id == name)
    where = "ours" if claim.section == "none" else f"thesis, {claim.section}"
    unit = "" if claim.unit == "1" else f" {claim.unit}"
    seconds, memory = cost(result)
    print(f"{name}: {claim.claim} ({where})\n"
          f"  verdict   {claim.verdict}\n"
          f"  rule      {claim.rule}\n"
          f"  thesis    {number(claim.thesis_value)}{'' if math.isnan(claim.thesis_value) else unit}\n"
          f"  measured  {measured(claim)}{unit}\n"
          f"  which is  {claim.note}\n"
          f"  cost      {seconds}, {memory}\n"
          f"  tables    {out}")


def every(results):
    print(f"{'name':24}{'verdict':16}{'time':>10}{'memory':>10}  statement")
    counts = {}
    for study in questions():
        result = read_study(results, study)
        seconds, memory = cost(result)
        for claim in result.claims:
            counts[claim.verdict] = counts.get(claim.verdict, 0) + 1
            print(f"{claim.id:24}{claim.verdict:16}{seconds:>10}{memory:>10}  {claim.claim}")
    print(f"{sum(counts.values())} claims: " + ", ".join(f"{n} {verdict}" for verdict, n in sorted(counts.items())))
    print("Time and memory are those of the study, which judges all of its claims in one run.")


def main(way, *arguments):
    if (way, len(arguments)) not in (("one", 3), ("all", 1)):
        raise ReportError(f"expected {USAGE}")
    (one if way == "one" else every)(*arguments)


if __name__ == "__main__":
    run("claims", USAGE, main, (2, 4))
