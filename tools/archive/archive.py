#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""An archive of results that describes itself, and one of what differs from run to run.
Usage: archive.py RESULTS OUT_FOLDER

OUT_FOLDER/microslip-archive-VERSION.tar has the tables, figures, scenes, article and a description (RO-Crate 1.1): the same
bytes whenever the tables are. microslip-measured-VERSION.tar has measured times with their figures, provenance, and the
report, which shows them. Each has SHA256SUMS. Errors go to stderr in one line, with exit status 1."""
import hashlib
import io
import json
import re
import sys
import tarfile
from pathlib import Path

sys.dont_write_bytecode = True  # the folder holds sources only
sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "report"))
from crate import codemeta, crate
from figures import shows_measured_times
from tables import ROOT, ReportError, questions, read_study, run, write_whole


def version():
    return re.search(r"^project\(microslip VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text(), re.MULTILINE)[1]


def content(path):
    try:
        return path.read_bytes()
    except FileNotFoundError:
        raise ReportError(f"{path}: no such file; expected what `make figures`, `make report` and `make article` write") from None


def collect(results, studies):
    """The files of both archives, as name: bytes."""
    lasting, measured = {}, {}
    for study in studies:
        folder = results / study.name
        for table in study.tables:
            part = measured if table.name.endswith("_timing") else lasting
            part[f"tables/{study.name}/{table.name}.tsv"] = content(folder / f"{table.name}.tsv")
        measured[f"tables/{study.name}/provenance.txt"] = content(folder / "provenance.txt")
        for scene in ("study", "quick"):
            lasting[f"scenes/{study.name}/{scene}.info"] = content(ROOT / f"studies/{study.name}/{scene}.info")
        for script in sorted(ROOT.glob(f"plots/{study.name}_*.gp")):
            part = measured if shows_measured_times(script) else lasting
            part[f"figures/{script.stem}.svg"] = content(results / f"figures/{script.stem}.svg")
    for name in ("CITATION.cff", "LICENSE", "CHANGELOG.md"):
        lasting[name] = content(ROOT / name)
    lasting["tables/tolerances.txt"] = content(ROOT / "tests/reference_tables/tolerances.txt")
    lasting["article.pdf"] = content(results / "article.pdf")
    measured["report.html"] = content(results / "report.html")
    return lasting, measured


def with_sums(files):
    sums = "".join(f"{hashlib.sha256(data).hexdigest()}  {name}\n" for name, data in sorted(files.items()))
    return {**files, "SHA256SUMS": sums.encode()}


def as_json(value):
    return (json.dumps(value, indent=2, ensure_ascii=False, sort_keys=True) + "\n").encode()


def write_tar(path, folder, files):
    """All or nothing; members sorted, of no one and of no time."""
    data = io.BytesIO()
    with tarfile.open(fileobj=data, mode="w", format=tarfile.USTAR_FORMAT) as tar:
        for name in sorted(files):
            member = tarfile.TarInfo(f"{folder}/{name}")
            member.size, member.mode = len(files[name]), 0o644
            tar.addfile(member, io.BytesIO(files[name]))
    write_whole(path, data.getvalue())
    print(f"{path}: {len(files)} files, {len(data.getvalue()) / 1e6:.1f} MB")


def main(results, out):
    results, out = Path(results), Path(out)
    studies = [read_study(results, name) for name in questions()]
    lasting, measured = collect(results, studies)
    lasting["codemeta.json"] = as_json(codemeta(ROOT, version()))
    lasting["ro-crate-metadata.json"] = as_json(crate(ROOT, version(), studies, lasting))
    for what, files in (("archive", lasting), ("measured", measured)):
        name = f"microslip-{what}-{version()}"
        write_tar(out / f"{name}.tar", name, with_sums(files))


if __name__ == "__main__":
    run("archive", "RESULTS OUT_FOLDER", main, (2,))
