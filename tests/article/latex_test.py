#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""LaTeX takes the article, with figures of quick results, and with noughts in the place of the numbers, which those results do
not have all of. Status 77 without LaTeX. Usage: latex_test.py FIGURES_FOLDER WORK_FOLDER"""
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
ROOT = Path(__file__).resolve().parents[2]
sys.path[1:1] = [str(ROOT / "tests/report"), str(ROOT / "tools/article")]
from article_numbers import figures_of, figures_of_the_thesis, keys_of
from quick_results import link_results

FIGURES, WORK = map(Path, sys.argv[1:])
sys.argv[1:] = []
ARTICLE = (ROOT / "article/article.tex").read_text(encoding="utf-8")


def noughts():
    lines = [f"\\expandafter\\def\\csname n:{key}\\endcsname{{0}}" for key in keys_of(ARTICLE)]
    return "\n".join([*lines, "\\newcommand\\claims{0 & 0 & 0 & 0 & 0 \\\\}", f"\\newcommand\\figuretable{{{figures_of_the_thesis()}}}", ""])


class Latex(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.results = link_results(FIGURES, WORK / "results")
        (WORK / "numbers.tex").write_text(noughts(), encoding="utf-8")

    def make(self, *arguments):
        return subprocess.run([ROOT / "tools/article/article.sh", self.results, WORK / "article.pdf", WORK / "latex", *arguments],
                              capture_output=True, text=True)

    def test_takes_the_article(self):
        self.assertGreater(len(figures_of(ARTICLE)), 8)
        said = self.make(WORK / "numbers.tex")
        self.assertEqual((said.returncode, said.stderr), (0, ""))
        self.assertEqual((WORK / "article.pdf").read_bytes()[:5], b"%PDF-")

    def test_leaves_no_article_where_a_number_is_missing(self):
        """Quick runs are not judged, so the table of costs has no entry for what they do not reach."""
        said = self.make()
        self.assertEqual(said.returncode, 1)
        self.assertRegex(said.stderr, r"(?m)^article: \\n\{")
        self.assertFalse((WORK / "article.pdf").exists())


if __name__ == "__main__":
    if not shutil.which("pdflatex"):
        print("skipped: no pdflatex (tools/deps.sh article installs it)")
        sys.exit(77)
    unittest.main(verbosity=0)
