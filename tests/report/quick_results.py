# SPDX-License-Identifier: GPL-3.0-or-later
"""A results folder, as `make figures` makes one, of what the tests figures.* have run and drawn."""
import csv
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
REPORT = ROOT / "tools" / "report" / "report.py"


def link_results(figures_folder, results):
    """Links to single files, so that a test can put another one in the place of each."""
    shutil.rmtree(results, ignore_errors=True)
    (results / "figures").mkdir(parents=True)
    for tables in sorted(Path(figures_folder).resolve().glob("*/a/*")):
        (results / tables.name).mkdir()
        for file in tables.iterdir():
            (results / tables.name / file.name).symlink_to(file)
        for figure in tables.parents[1].glob("*.svg"):
            (results / "figures" / figure.name).symlink_to(figure)
    return results


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
