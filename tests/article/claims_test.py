#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""One claim by its name, with the verdict of its own run. Usage: claims_test.py PROGRAMS_FOLDER WORK_FOLDER"""
import re
import subprocess
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
WORK = Path(sys.argv.pop())
PROGRAMS = Path(sys.argv.pop())


def claim(name):
    return subprocess.run([sys.executable, ROOT / "tools/claims.py", "one", PROGRAMS, WORK, name], capture_output=True, text=True)


class Claims(unittest.TestCase):
    def test_have_verdict_rule_and_cost(self):
        said = claim("carter-2")
        self.assertEqual((said.returncode, said.stderr), (0, ""))
        lines = dict(re.findall(r"^  (\w+) +(.*)", said.stdout, re.MULTILINE))
        self.assertTrue(said.stdout.startswith("carter-2: accuracy decreases again for c < 0.55 (thesis, 1)\n"))
        self.assertEqual(lines["verdict"], "reproduced")
        self.assertEqual(lines["rule"], "reproduced if the measured value is within 0.1 of 0.55; otherwise refuted")
        self.assertLessEqual(abs(float(lines["measured"]) - float(lines["thesis"])), 0.1)
        self.assertRegex(lines["cost"], r"^[\d.e-]+ s, [\d.]+ MB$")

    def test_are_found_by_a_part_of_their_statement(self):
        self.assertEqual(claim("accuracy decreases").stdout.splitlines()[:-2], claim("carter-2").stdout.splitlines()[:-2])

    def test_are_named_where_none_or_several_match(self):
        for name, listed in (("carter-9", 90), ("", 90), ("Cattaneo", 1), ("leading edge", 4)):
            with self.subTest(name=name):
                said = claim(name)
                if said.returncode == 0:  # the only one
                    self.assertEqual(listed, 1)
                    continue
                self.assertEqual((said.returncode, said.stdout), (1, ""))
                self.assertTrue(said.stderr.startswith("claims: "))
                self.assertGreaterEqual(len(said.stderr.splitlines()), listed)

    def test_of_a_name_of_a_program_elsewhere_are_refused(self):
        self.assertEqual(claim("../carter-2").returncode, 1)


if __name__ == "__main__":
    unittest.main(verbosity=0)
