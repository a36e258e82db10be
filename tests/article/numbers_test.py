#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers of the article: only such as come from a table, rounded as they should be. Usage: numbers_test.py"""
import math
import random
import re
import sys
import tempfile
import unittest
from decimal import Decimal
from pathlib import Path

sys.dont_write_bytecode = True
ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools/article"))
from article_numbers import Results, checked, figures_of_the_thesis, formatted, keys_of, number, shown, typed_numbers
from tables import ReportError

TABLES = Results(ROOT / "tests/reference_tables")
ARTICLE = (ROOT / "article/article.tex").read_text(encoding="utf-8")


class TypedNumbers(unittest.TestCase):
    def test_are_found(self):
        for text in ("about 12 times", "by $0.3$ of it", "order \\emph{2}", "\\formula{x=0.825347}", "\\formula{10^{-12}}",
                     "\\thesis{an error of 5.9 percent}", "\\caption{with 50 elements}", "\\n{a/b[c=1]d|2} and 2",
                     "\\multicolumn{3}{l}{of 7}", "in 3 runs % and 4", "a tenth of it",
                     "Four times", "ninety percent of it"):
            with self.subTest(text=text):
                self.assertNotEqual(typed_numbers(text), [])

    def test_are_not_what_is_no_result(self):
        for text in ("\\n{smoothing:grid.elements|d} elements", "\\ref{tab:2}", "\\cite{saad86}", "\\formula{c=1, x^{2}/2}",
                     "\\thesis{Figs.~7.1 and 7.2}", "\\thesis{chapters 4, 7 and 8}", "\\thesis{(B.30)}", "% 17 in a comment",
                     "\\begin{tabular}{@{}p{24mm}L{80mm}l@{}}", "a 2D contact", "C++20", "three questions", "often", "half-spaces"):
            with self.subTest(text=text):
                self.assertEqual(typed_numbers(text), [])

    def test_are_found_on_their_line(self):
        self.assertEqual(typed_numbers("% 1\nword\n\\n{a\nb|2} 3\n")[0][0], 4)

    def test_are_not_in_the_article(self):
        self.assertEqual(checked(ARTICLE, "article.tex"), [])

    def test_are_found_anywhere_in_the_article(self):
        """A number that is put behind any word of the text is found."""
        text = ARTICLE.partition("\\begin{document}")[2].partition("\\bibliographystyle")[0]
        places = [i for i, (a, b) in enumerate(zip(text, text[1:])) if a.isalpha() and b == " "
                  and text.rfind("{", 0, i) <= text.rfind("}", 0, i)]
        for place in random.Random(1).sample(places, 60):
            line = text[text.rfind("\n", 0, place) + 1:place]
            if "%" not in line.replace("\\%", ""):
                self.assertNotEqual(typed_numbers(text[:place + 1] + " 42" + text[place + 1:]), [], text[place - 40:place])


class Figures(unittest.TestCase):
    def test_of_measured_times_are_refused(self):
        for figure, refused in (("carter_traction", 0), ("fractional_power_cost", 1), ("speed_accuracy_force_time", 1)):
            self.assertEqual(len(checked(f"\\studyfigure{{{figure}}}{{a}}{{b}}", "article.tex")), refused, figure)


class Numbers(unittest.TestCase):
    def test_are_rounded_as_decimals(self):
        generator = random.Random(7)
        for _ in range(2000):
            value = generator.choice((-1, 1)) * 10 ** generator.uniform(-12, 9)
            digits = generator.randint(1, 6)
            text = shown(value, digits).removeprefix("\\ensuremath{").removesuffix("}")
            mantissa, _, exponent = re.sub(r"^(-?)10\^", r"\g<1>1\\times10^", text).partition("\\times10^{")
            read = float(mantissa) * 10.0 ** int(exponent.rstrip("}") or 0)
            with self.subTest(value=value, digits=digits):
                least = Decimal(10) ** (math.floor(math.log10(abs(value))) - digits + 1)
                self.assertLessEqual(abs(Decimal(read) - Decimal(value)), least * Decimal("0.500001"))

    def test_come_from_the_cell_that_is_named(self):
        cell = "carter/summary[step_ratio=0.01]"
        self.assertEqual(number(TABLES, cell + "turning_points|d"), "17")
        self.assertEqual(number(TABLES, "carter:grid.elements|d"), "30")
        self.assertEqual(number(TABLES, "max carter/summary turning_points|d".replace(" turning", "[]turning")), "17")
        self.assertEqual(number(TABLES, "count carter/summary[step_ratio!=1]|d"), "4")
        self.assertEqual(number(TABLES, f"{cell}turning_points over carter/summary[step_ratio=0.1]turning_points|2"),
                         "\\ensuremath{2.4}")
        self.assertEqual(number(TABLES, "carter/claims[claim has accuracy]thesis_value|2"), "\\ensuremath{0.55}")

    def test_of_figures_of_the_thesis_are_those_that_the_thesis_computes(self):
        listed = [row.split(" & ")[0] for row in figures_of_the_thesis().splitlines()]
        self.assertEqual(sorted(number for place in listed for number in re.findall(r"\d+(?:\.\d+)?", place)),
                         sorted("1.1 4.1 4.2 4.3 5.1 6.1 6.2 6.3 6.4 6.5 6.6 6.7 6.8 6.9 7.1 7.2 8.1 8.2 8.3 8.4 9 "
                                "10.1 10.2 10.3".split()))

    def test_are_refused_where_they_are_not_clear(self):
        for place in ("carter/summary turning_points|d", "carter/summary[]turning_points|d", "carter/summary[step_ratio=3]force|2",
                      "carter/summary[step_ratio=1]colour|2", "carter:grid.colour|d", "nothing/summary[]force|2",
                      "carter/summary[step_ratio=1]force|d", "carter/summary[step_ratio=1]force|x", "carter/summary[step_ratio=1]force",
                      "max carter/summary[step_ratio=3]force|2"):
            with self.subTest(place=place), self.assertRaises(ReportError):
                number(TABLES, place)

    def test_that_are_nothing_but_rounding_have_a_bound_only(self):
        self.assertEqual(formatted("3e-16", "b", 1e-9), "\\ensuremath{10^{-9}}")
        with self.assertRaises(ReportError):
            formatted("3e-8", "b", 1e-9)

    def test_of_the_article_name_columns_and_parameters_of_the_studies(self):
        """Quick runs have other values, but the same tables, except for those of measured accuracy and cost; claims are the same."""
        self.assertGreater(len(keys_of(ARTICLE)), 90)
        for key in keys_of(ARTICLE):
            if key.startswith("speed_accuracy/cheapest"):
                continue
            with self.subTest(key=key):
                try:
                    number(TABLES, key)
                except (ReportError, ValueError) as error:
                    absent = "" if "/claims[claim" in key else r"found 0|nothing meets|"
                    self.assertRegex(str(error), absent + r"no whole number|provenance\.txt|not a finite number|rounding")


if __name__ == "__main__":
    unittest.main(verbosity=0)
