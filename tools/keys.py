#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the lists of keys in the documentation, as `microslip keys` and the studies' --print-keys print them.

usage: tools/keys.py MICROSLIP [--check]     with --check, only says which are not up to date
"""
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
STUDIES = sorted(scene.parent.name for scene in ROOT.glob("studies/*/study.info"))


def printed(*command):
    return subprocess.run(command, check=True, capture_output=True).stdout.decode()


def of_scenes(form):
    return lambda program: printed(program, "keys", "--format", form)


def of_studies(program):
    return "".join(f"\n## [{study}](studies.md#{study})\n\n" +
                   printed(pathlib.Path(program).parent / study, "--print-keys=markdown") for study in STUDIES)


LISTS = [
    ("docs/scenes.md", of_scenes("markdown"), "<!-- microslip keys -->\n", "<!-- end of keys -->\n"),
    ("docs/study_keys.md", of_studies, "<!-- keys of studies -->\n", "<!-- end of keys -->\n"),
    ("packaging/man/microslip-scene.5", of_scenes("man"), '.\\" microslip keys\n', '.\\" end of keys\n'),
]


def main(program, check):
    programs = [pathlib.Path(program), *(pathlib.Path(program).parent / study for study in STUDIES)]
    missing = [file.name for file in programs if not file.exists()]
    if missing:
        print(f"tools/keys.py: no program {missing[0]} beside {program}: run make build")
        return 1
    stale = []
    for name, keys, begin, end in LISTS:
        file = ROOT / name
        old = file.read_text(encoding="utf-8")
        before, rest = old.split(begin)
        _, after = rest.split(end)
        new = before + begin + keys(program) + end + after
        if new == old:
            continue
        stale.append(name)
        if not check:
            file.write_text(new, encoding="utf-8")
    for name in stale:
        print(f"{name}: " + (f"not the keys of {program}; run tools/keys.py" if check else "written"))
    return 1 if check and stale else 0


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3) or sys.argv[2:] not in ([], ["--check"]):
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1], "--check" in sys.argv))
