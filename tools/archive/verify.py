#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks an archive: every file has the sum that it states, and studies, run again, give its tables.
Usage: verify.py ARCHIVE.tar PROGRAMS WORK_FOLDER [STUDY ...]"""
import hashlib
import shutil
import subprocess
import sys
import tarfile
from pathlib import Path

sys.dont_write_bytecode = True  # the folder holds sources only
sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "report"))
from tables import ReportError, run


class Damaged(ValueError):
    """Says what is wrong with an archive, in one line."""


def unpack(archive, work):
    """The archive's one folder, below a new work folder."""
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    with tarfile.open(archive) as tar:
        members = tar.getmembers()
        for member in members:
            if not member.isfile() or member.name.startswith("/") or ".." in Path(member.name).parts:
                raise Damaged(f"{member.name}: expected files below one folder")
            target = work / member.name
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(tar.extractfile(member).read())
    tops = {Path(member.name).parts[0] for member in members}
    if len(tops) != 1:
        raise Damaged(f"expected one folder, found {len(tops)}")
    return work / tops.pop()


def check_sums(folder):
    """The number of files, all of which are as SHA256SUMS states."""
    sums = folder / "SHA256SUMS"
    if not sums.is_file():
        raise Damaged("no SHA256SUMS")
    stated = {name: digest for digest, name in (line.split("  ", 1) for line in sums.read_text().splitlines())}
    there = {str(path.relative_to(folder)) for path in folder.rglob("*") if path.is_file()} - {"SHA256SUMS"}
    for name in sorted(there ^ set(stated)):
        raise Damaged(f"{name}: {'has no sum' if name in there else 'is missing'}")
    for name, digest in sorted(stated.items()):
        if hashlib.sha256((folder / name).read_bytes()).hexdigest() != digest:
            raise Damaged(f"{name}: another content than SHA256SUMS states")
    return len(stated)


def rerun(folder, programs, work, study):
    """Runs a study of the archive again and compares its tables, first by bytes and then by tolerances."""
    tables = folder / "tables" / study
    if not tables.is_dir():
        raise Damaged(f"no tables of a study '{study}'")
    again = work / "again"
    subprocess.run([programs / study, "--quiet", "--scene", folder / f"scenes/{study}/study.info", "--out", again / study], check=True)
    names = sorted(path.name for path in tables.glob("*.tsv"))
    other = [name for name in names if not (again / study / name).is_file()
             or (again / study / name).read_bytes() != (tables / name).read_bytes()]
    if not other:
        return f"{study}: {len(names)} tables are the same bytes"
    compared = subprocess.run([programs / "compare_tables", again, folder / "tables", study], capture_output=True, text=True)
    if compared.returncode != 0:
        raise Damaged(f"{study}: {', '.join(other)} differ:\n{compared.stdout}{compared.stderr}")
    return f"{study}: {len(names)} tables agree, {len(names) - len(other)} of them with the same bytes"


def main(archive, programs, work, *studies):
    try:
        folder = unpack(archive, Path(work))
        print(f"{archive}: {check_sums(folder)} files have their sums")
        for study in studies:
            print(rerun(folder, Path(programs), Path(work), study))
    except (OSError, ValueError, tarfile.TarError, subprocess.CalledProcessError) as error:
        raise ReportError(f"{archive}: {error}") from None


if __name__ == "__main__":
    run("verify-archive", "ARCHIVE.tar PROGRAMS WORK_FOLDER [STUDY ...]", main, range(3, sys.maxsize))
