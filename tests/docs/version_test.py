#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""All places have the version of CMakeLists.txt, and its date. Usage: version_test.py MICROSLIP LIBRARY"""
import ctypes
import re
import subprocess
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROGRAM, LIBRARY = sys.argv[1:]
sys.argv[1:] = []


def found(file, pattern):
    return re.search(pattern, (ROOT / file).read_text(encoding="utf-8"), re.MULTILINE)


VERSION = found("CMakeLists.txt", r"^project\(microslip VERSION (\d+\.\d+\.\d+) ")[1]


class Version(unittest.TestCase):
    def test_is_that_of_the_citation_file(self):
        self.assertEqual(found("CITATION.cff", r"^version: (.*)$")[1], VERSION)

    def test_heads_the_list_of_changes_with_the_date_of_the_citation_file(self):
        version, date = found("CHANGELOG.md", r"^## (\S+) — (\d{4}-\d\d-\d\d)$").groups()
        self.assertEqual((version, date), (VERSION, found("CITATION.cff", r"^date-released: (.*)$")[1]))

    def test_is_that_of_the_program(self):
        said = subprocess.run([PROGRAM, "--version"], capture_output=True, text=True, check=True).stdout
        self.assertIn(VERSION, said.split("revision")[0])

    def test_is_that_of_the_library_and_its_major_number_names_it(self):
        library = ctypes.CDLL(LIBRARY)
        library.microslip_version.restype = ctypes.c_char_p
        self.assertEqual(library.microslip_version().decode(), VERSION)
        self.assertTrue(LIBRARY.endswith(f"libmicroslip.so.{VERSION}"))
        self.assertIn(f"libmicroslip.so.{VERSION.partition('.')[0]}\0".encode(), Path(LIBRARY).read_bytes())

    def test_is_written_nowhere_else(self):
        """Python, pkg-config, packages and archives read it; makefiles and pages do not repeat it."""
        for file in ("pyproject.toml", "setup.py", "Makefile", "cmake/microslip.pc.in", "packaging/CMakeLists.txt", "README.md"):
            self.assertNotIn(VERSION, (ROOT / file).read_text(encoding="utf-8"), file)


if __name__ == "__main__":
    unittest.main(verbosity=0)
