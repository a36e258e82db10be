#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Nothing of tests/promised.txt has vanished, and tools/promised.py would see it. Usage: promised_test.py MICROSLIP"""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

sys.dont_write_bytecode = True
ROOT = Path(__file__).resolve().parents[2]
PROGRAM = Path(sys.argv.pop())
sys.path.insert(0, str(ROOT / "tools"))
import promised


class Promised(unittest.TestCase):
    now = promised.promised(PROGRAM)

    def test_names_are_there(self):
        self.assertEqual(promised.vanished(promised.recorded(), self.now), [])

    def test_are_of_every_kind(self):
        for line in ("key load.force [N/mm]", "key contact.hurst [1] default 0.8", "word step.scheme remembered",
                     "option microslip sweep --threads", "exit status 2", "column steady/traction.tsv slip [1]",
                     "row transient/summary.tsv dissipated_energy [N]",
                     "C enum microslip_status: MICROSLIP_NO_SOLUTION = 2",
                     "C struct microslip_grid: int elements; int scheme;", "C void microslip_destroy(microslip_rolling* rolling)",
                     "Python steady() argument 0: scene", "Python Rolling.roll() argument force=", "Python Rolling.copy()",
                     "Python Result.summary"):
            self.assertIn(line, self.now)

    def test_tables_of_studies_are_none_of_them(self):
        """docs/stability.md lets them change with the claims."""
        studies = {scene.parent.name for scene in ROOT.glob("studies/*/study.info")}
        self.assertGreater(len(studies), 10)
        self.assertEqual([line for line in self.now if line.startswith(("column ", "row "))
                          and line.split()[1].partition("/")[0] in studies], [])

    def test_functions_of_c_are_those_of_the_library(self):
        """The test capi.symbols holds the header to the library; here the list is held to the header."""
        header = "\n".join(map(promised.text_of, promised.HEADERS))
        listed = {line.partition("(")[0].split()[-1].lstrip("*") for line in self.now if line.startswith("C ") and "(" in line}
        self.assertGreater(len(listed), 25)
        self.assertEqual([name for name in listed if f"{name}(" not in header], [])
        self.assertEqual(header.count("\nMICROSLIP_API "), len(listed))

    def check(self, record, option):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "promised.txt"
            file.write_text("".join(f"{line}\n" for line in record), encoding="utf-8")
            with mock.patch.object(promised, "RECORD", file), mock.patch("builtins.print") as said:
                return promised.main(PROGRAM, option), said.call_count, file.read_text(encoding="utf-8").splitlines()

    def test_what_is_gone_or_changed_is_found_and_kept_in_the_list(self):
        record = sorted([*self.now, "key load.forse [N/mm]"])
        for option in ("--check", "--add"):
            self.assertEqual(self.check(record, option), (1, 1, record))

    def test_what_is_new_is_added_when_asked(self):
        self.assertEqual(self.check(self.now[1:], "--check"), (0, 0, self.now[1:]))
        self.assertEqual(self.check(self.now[1:], "--add"), (0, 0, self.now))

    def test_the_program_refuses_other_options(self):
        self.assertEqual(subprocess.run([sys.executable, promised.__file__, PROGRAM, "--drop"], capture_output=True).returncode, 1)


if __name__ == "__main__":
    unittest.main(verbosity=0)
