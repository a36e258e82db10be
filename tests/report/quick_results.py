# SPDX-License-Identifier: GPL-3.0-or-later
"""A results folder, as `make figures` makes one, of what the tests figures.* have run and drawn."""
import csv
import itertools
import re
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
REPORT = ROOT / "tools" / "report" / "report.py"
GIVEN = ("reproduced", "corrected", "refuted", "not_comparable", "ours")
NOT_JUDGED = "world_fixed"  # the study that stays as it is


def link_results(figures_folder, results, leave=(NOT_JUDGED,)):
    """Links to single files, so that a test can put another one in the place of each. The claims of all studies
    get verdicts, except for those to leave as quick runs are."""
    shutil.rmtree(results, ignore_errors=True)
    (results / "figures").mkdir(parents=True)
    for tables in sorted(Path(figures_folder).resolve().glob("*/a/*")):
        (results / tables.name).mkdir()
        for file in tables.iterdir():
            (results / tables.name / file.name).symlink_to(file)
        for figure in tables.parents[1].glob("*.svg"):
            (results / "figures" / figure.name).symlink_to(figure)
    for claims in sorted(results.glob("*/claims.tsv")):
        if claims.parent.name not in leave:
            text = judged(claims.read_text(encoding="utf-8"))
            claims.unlink()
            claims.write_text(text, encoding="utf-8")
    return results


def judged(text):
    """A table of claims with all kinds of verdicts in turn, as no quick run has any."""
    verdicts = itertools.cycle(GIVEN)
    text = re.sub("; not judged: .*", "", text, count=1)
    return re.sub("\tnot_judged\t", lambda match: f"\t{next(verdicts)}\t", text)


def make_report(results, output):
    return subprocess.run([sys.executable, REPORT, results, output], capture_output=True, text=True, timeout=60)


def claims_of(results):
    """Rows of all claims tables, by the id of their card."""
    claims = {}
    for path in sorted(Path(results).glob("*/claims.tsv")):
        rows = [line for line in path.read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
        for i, row in enumerate(csv.DictReader(rows, delimiter="\t", quoting=csv.QUOTE_NONE), 1):
            claims[f"{path.parent.name}-{i}"] = row
    return claims
