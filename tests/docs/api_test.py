#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The API pages: no warning, and no formula that MathJax cannot set. Usage: api_test.py"""
import shutil
import subprocess
import sys
import time
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "tests/browser"))
import webdriver

MATHJAX = Path("/usr/share/javascript/mathjax/MathJax.js")
DONE = "return !!(window.MathJax && MathJax.isReady && !MathJax.Hub.queue.pending && !MathJax.Hub.queue.running)"
FORMULAS = "return MathJax.Hub.getAllJax().length"
ERRORS = "return [...document.querySelectorAll('.merror, .noError')].map(error => error.textContent)"


class Formulas(unittest.TestCase):
    def wait_for_formulas(self, browser):
        end = time.monotonic() + 60
        while not browser.run(DONE):
            self.assertLess(time.monotonic(), end, "MathJax is not done")
            time.sleep(0.1)

    def test_are_set(self):
        subprocess.run([ROOT / "tools/docs.sh"], check=True)
        with webdriver.Browser() as browser:
            for page in ("index", "classmicroslip_1_1StripKernel", "classmicroslip_1_1TransientRolling"):
                with self.subTest(page=page):
                    browser.open(ROOT / f"build/docs/html/{page}.html")
                    self.wait_for_formulas(browser)
                    self.assertGreater(browser.run(FORMULAS), 0)
                    self.assertEqual(browser.run(ERRORS), [])


if __name__ == "__main__":
    lacking = None if shutil.which("doxygen") else "doxygen"
    lacking = lacking or webdriver.missing() or (None if MATHJAX.exists() else "MathJax")
    if lacking:
        print(f"skipped: {lacking} is not installed (tools/deps.sh docs browser)")
        sys.exit(77)
    unittest.main(verbosity=0)
