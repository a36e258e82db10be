#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes one change of tests/mutants.tsv at a time in a copy of the tree, builds, and says which test fails.

Usage: tools/mutants.py WORK_FOLDER JOBS [NAME...]   all mutants, or those named
       tools/mutants.py --check                      only whether every place of the list is there, once

The table of what caught each mutant is written to standard output and to WORK_FOLDER/mutants.tsv. The end
is 1 if a mutant is not caught, does not compile, or has no place in its file.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
LIST = ROOT / "tests" / "mutants.tsv"
LABELS = "unit|order|reference|property|capi"
TARGETS = ["unit_tests", "order_tests", "reference_tests", "property_tests", "capi_tests"]
NOT_COPIED = {".git", "build", "results", "__pycache__"}
SECONDS_OF_A_TEST = "120"  # a mutant may hang; a test that takes longer has caught it


class Mutant:
    def __init__(self, line, number):
        fields = line.rstrip("\n").split("\t")
        if len(fields) != 5:
            raise SystemExit(f"{LIST}:{number}: {len(fields)} fields: expected name, file, text, replacement, tests")
        self.name, self.file, self.text, self.replacement, self.tests = fields

    def fault(self):
        """Says what is wrong with its place, or nothing."""
        path = ROOT / self.file
        count = path.read_text().count(self.text) if path.is_file() else 0
        if count != 1:
            return f"{self.name}: '{self.text}' occurs {count} times in {self.file}: expected once"
        if self.text == self.replacement:
            return f"{self.name}: the replacement is the text itself"
        return ""


def read_list():
    lines = LIST.read_text().splitlines()
    mutants = [Mutant(line, i) for i, line in enumerate(lines, 1) if line and not line.startswith("#")]
    faults = [mutant.fault() for mutant in mutants]
    names = [mutant.name for mutant in mutants]
    faults += [f"{name}: more than one mutant has this name" for name in set(names) if names.count(name) > 1]
    return mutants, [fault for fault in faults if fault]


def files_in(folder):
    found = set()
    for path, folders, names in os.walk(folder):
        folders[:] = [name for name in folders if name not in NOT_COPIED]
        found |= {(pathlib.Path(path) / name).relative_to(folder) for name in names}
    return found


def copy_tree(to):
    """Files that are the same stay untouched, so that little is built again."""
    wanted = files_in(ROOT)
    for path in wanted:
        there = to / path
        if there.is_file() and there.read_bytes() == (ROOT / path).read_bytes():
            continue
        there.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / path, there)
    for path in files_in(to) - wanted:
        (to / path).unlink()


class Build:
    def __init__(self, work, jobs):
        self.tree, self.jobs = work / "tree", jobs
        self.folder = self.tree / "build" / "release"
        copy_tree(self.tree)
        os.environ.update(CCACHE_BASEDIR=str(self.tree), CCACHE_NOHASHDIR="1")
        if not (self.folder / "CMakeCache.txt").exists():
            launchers = [f"-DCMAKE_{language}_COMPILER_LAUNCHER=ccache" for language in ("C", "CXX")]
            self.run("cmake", "-S", self.tree, "-B", self.folder, "-DCMAKE_BUILD_TYPE=Release",
                     *(launchers if shutil.which("ccache") else []))

    def run(self, *command):
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        if done.returncode:
            print(done.stdout[-4000:], file=sys.stderr)
            raise SystemExit(f"{command[0]} failed")

    def compiles(self):
        command = ["cmake", "--build", self.folder, "-j", self.jobs, "--target", *TARGETS]
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        (self.folder / "mutant.log").write_text(done.stdout)
        return done.returncode == 0

    def failing_test(self, tests):
        """The first of those that match a regular expression, or nothing."""
        command = ["ctest", "--test-dir", self.folder, "-L", LABELS, "-R", tests, "-j", self.jobs,
                   "--stop-on-failure", "--timeout", SECONDS_OF_A_TEST]
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        if "No tests were found" in done.stdout:
            return ""
        failed = re.search(r"Test +#\d+: (.*?) \.*\**(Failed|Timeout|Exception|Not Run|Subprocess)", done.stdout)
        if done.returncode and not failed:
            print(done.stdout[-4000:], file=sys.stderr)
            raise SystemExit("ctest failed")
        return re.match(r"(\w+/)?\w+\.\w+", failed[1])[0] if failed else ""

    def verdict(self, mutant):
        """Returns the tests that catch it: the tests that the list names, or else any."""
        place = self.tree / mutant.file
        original = place.read_text()
        place.write_text(original.replace(mutant.text, mutant.replacement))
        try:
            if not self.compiles():
                return "DOES NOT COMPILE"
            return self.failing_test(mutant.tests) or self.failing_test(".") or "NOT CAUGHT"
        finally:
            place.write_text(original)


def main(arguments):
    mutants, faults = read_list()
    for fault in faults:
        print(fault, file=sys.stderr)
    if faults or arguments == ["--check"]:
        return 1 if faults else 0
    work, jobs, names = pathlib.Path(arguments[0]).resolve(), arguments[1], arguments[2:]
    unknown = set(names) - {mutant.name for mutant in mutants}
    if unknown:
        raise SystemExit(f"no such mutant: {', '.join(sorted(unknown))}")
    build = Build(work, jobs)
    print("mutants: building without a change", file=sys.stderr)
    if not build.compiles():
        raise SystemExit(f"the tree does not compile: see {build.folder}/mutant.log")
    fails = build.failing_test(".")
    if fails:
        raise SystemExit(f"{fails} fails without a change: no test can tell anything")
    rows = ["mutant\tcaught_by\tseconds"]
    print(rows[0])
    for mutant in mutants:
        if names and mutant.name not in names:
            continue
        start = time.monotonic()
        rows.append(f"{mutant.name}\t{build.verdict(mutant)}\t{time.monotonic() - start:.0f}")
        print(rows[-1], flush=True)
    (work / "mutants.tsv").write_text("\n".join(rows) + "\n")
    bad = [row for row in rows if "\tNOT CAUGHT\t" in row or "\tDOES NOT COMPILE\t" in row]
    print(f"mutants: {len(rows) - 1 - len(bad)} of {len(rows) - 1} are caught", file=sys.stderr)
    return 1 if bad else 0


if __name__ == "__main__":
    if not (sys.argv[1:] == ["--check"] or (len(sys.argv) > 2 and not sys.argv[1].startswith("-"))):
        raise SystemExit(__doc__)
    sys.exit(main(sys.argv[1:]))
