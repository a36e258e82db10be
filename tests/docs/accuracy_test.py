#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""docs/accuracy.md has the orders that the order tests have measured. Usage: accuracy_test.py FOLDER_OF_ORDERS"""
import subprocess
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "tools"))
import accuracy

ORDER_TESTS = sys.argv.pop()


def output(order="1.02", error="2.58e-02", problem="constant functions"):
    return f"[ RUN      ] A.B\n[   ORDER  ]\tA.B\t{problem}\t15\t{error}\t30\t1.26e-02\t{order}\n[       OK ] A.B (1 ms)\n"


def page(tests):
    return f"A sentence.\n\n<!-- orders: A.B -->\n{accuracy.table(tests['A.B'])}<!-- end of orders -->\nAnother one.\n"


class Comparison(unittest.TestCase):
    def found(self, text, printed):
        return accuracy.renewed(text, accuracy.measured(printed))[1]

    def setUp(self):
        self.page = page(accuracy.measured(output()))

    def test_accepts_other_processors(self):
        for printed in (output(), output(order="1.05"), output(error="2.70e-02")):
            self.assertEqual(self.found(self.page, printed), [])

    def test_sees_other_numbers_and_rows(self):
        for printed in (output(order="1.10"), output(error="3.00e-02"), output(error="2.2e-02"),
                        output(problem="linear functions"), output() + output(problem="linear functions")):
            self.assertEqual(len(self.found(self.page, printed)), 1, printed)

    def test_sees_tests_without_a_place_and_places_without_a_test(self):
        self.assertEqual(len(self.found("A sentence.\n", output())), 1)
        self.assertEqual(len(self.found(self.page, "")), 1)
        self.assertEqual(len(self.found(self.page + self.page, output())), 1)

    def test_renewed_page_is_as_measured(self):
        tests = accuracy.measured(output(order="1.50", error="3.00e-02"))
        self.assertEqual(accuracy.renewed(self.page, tests)[0], page(tests))


class Page(unittest.TestCase):
    def test_is_as_measured(self):
        run = subprocess.run([ROOT / "tools/accuracy.py", ORDER_TESTS, "--check"], stdout=subprocess.PIPE, text=True)
        self.assertEqual(run.returncode, 0, run.stdout)


if __name__ == "__main__":
    unittest.main(verbosity=0)
