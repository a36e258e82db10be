#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The program that stands in docs/multibody.md compiles as printed, in C99 without a warning, and prints what the page says.
Usage: example_test.py LIBRARY TABLE WORK_FOLDER; exit status 77 if there is no C compiler."""
import re
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
LIBRARY, TABLE, WORK = (Path(word).resolve() for word in sys.argv[1:])
PAGE = (ROOT / "docs/multibody.md").read_text(encoding="utf-8")
COMPILER = shutil.which("cc") or shutil.which("gcc") or shutil.which("clang")


class Example(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        [source] = re.findall(r"^```c\n(.*?)^```", PAGE, re.MULTILINE | re.DOTALL)
        (WORK / "contact.c").write_text(source, encoding="utf-8")
        subprocess.run([COMPILER, "-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Werror", f"-I{ROOT / 'capi/include'}",
                        "contact.c", LIBRARY, f"-Wl,-rpath,{LIBRARY.parent}", "-o", "contact"], cwd=WORK, check=True)

    def test_prints_what_the_page_says(self):
        [printed] = re.findall(r"^```\n(solved: .*?)^```", PAGE, re.MULTILINE | re.DOTALL)
        said = subprocess.run([WORK / "contact", TABLE], capture_output=True, text=True, check=True)
        self.assertEqual((said.stdout, said.stderr), (printed, ""))
        alone = subprocess.run([WORK / "contact"], capture_output=True, text=True, check=True)
        self.assertEqual(alone.stdout, printed.splitlines(keepends=True)[0])

    def test_says_why_a_table_cannot_be_read(self):
        said = subprocess.run([WORK / "contact", WORK / "none.nc"], capture_output=True, text=True)
        self.assertEqual(said.returncode, 1)
        self.assertIn("none.nc", said.stderr)


if __name__ == "__main__":
    if COMPILER is None:
        print("skipped: there is no C compiler")
        sys.exit(77)
    shutil.rmtree(WORK, ignore_errors=True)
    WORK.mkdir(parents=True)
    unittest.main(argv=sys.argv[:1], verbosity=0)
