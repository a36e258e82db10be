# SPDX-License-Identifier: GPL-3.0-or-later
"""The report as Chromium shows it: wide and on a phone, light and dark, and printed.
Usage: browser_test.py FIGURES_FOLDER WORK_FOLDER; exit status 77 if there is no Chromium."""
import re
import sys
import unittest
from collections import Counter
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "browser"))
import webdriver
from quick_results import GIVEN, NOT_JUDGED, claims_of, link_results, make_report
from small_report import STUDIES, small_report

FIGURES, WORK = map(Path, sys.argv[1:])
VIEWS = ((1280, False), (1280, True), (390, True), (390, False))  # width, and whether it is dark
IN_BROWSER, TEXTS = (Path(__file__).with_name(name).read_text(encoding="utf-8") for name in ("in_browser.js", "texts.js"))


class Browser(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.results = link_results(FIGURES, WORK / "results")
        cls.claims = claims_of(cls.results)
        cls.page = WORK / "report.html"
        made = make_report(cls.results, cls.page)
        assert made.returncode == 0, made.stderr
        cls.figures = sorted(path.stem for path in (cls.results / "figures").iterdir())
        cls.browser = webdriver.Browser()
        cls.addClassCleanup(cls.browser.close)
        cls.shown = None

    def show(self, page, width=1280, dark=False):
        """Opens a page, unless it is open: to load it takes longest, and other windows and colours lay it out anew anyway."""
        self.browser.emulate(width, dark)
        if page != self.shown:
            self.browser.log("browser")
            self.browser.log("performance")
            self.browser.open(page)
            type(self).shown = page

    def problems(self, page, figures, width=1280, dark=False):
        self.show(page, width, dark)
        found = self.browser.run(IN_BROWSER, figures)
        if not dark:  # which moves no text
            found += self.browser.run(TEXTS)
        found += [f"on the console: {line['message']}" for line in self.browser.log("browser")]
        requests = "".join(line["message"] for line in self.browser.log("performance")
                           if '"Network.requestWillBeSent"' in line["message"])
        loaded = set(re.findall(r'"url":"([^"#]*)', requests)) - {page.resolve().as_uri()}
        return found + [f"loads {url}" for url in sorted(loaded)]

    def test_has_no_problem(self):
        for width, dark in VIEWS:
            with self.subTest(width=width, dark=dark):
                self.assertEqual(self.problems(self.page, self.figures, width, dark), [])

    def test_first_screen_has_headline_and_counts(self):
        self.show(self.page)
        shown = self.browser.run("""return [...document.querySelectorAll("#headline, .totals")].map(element =>
            element.getBoundingClientRect().bottom < innerHeight)""")
        self.assertEqual(shown, [True, True])
        said = self.browser.run("""return Object.fromEntries([...document.querySelectorAll("[data-count]")].map(
            element => [element.dataset.count, Number(element.innerText)]))""")
        in_tables = Counter(claim["verdict"] for claim in self.claims.values())
        self.assertEqual({verdict: number for verdict, number in said.items() if number}, in_tables)
        rows = self.browser.run("""return [...document.querySelectorAll(".summary tbody tr")].map(
            row => [row.cells[0].innerText, ...[...row.cells].slice(1).map(cell => parseInt(cell.innerText) || 0)])""")
        for study, *counts in rows:
            of_study = [claim["verdict"] for id, claim in self.claims.items() if id.startswith(study + "-")]
            verdicts = ("not_judged",) if study == NOT_JUDGED else GIVEN
            self.assertEqual(counts, [of_study.count(verdict) for verdict in verdicts], study)

    def test_dark_is_dark_and_maps_stay_light(self):
        colour = """return getComputedStyle(document.querySelector(arguments[0])).backgroundColor"""
        for dark in (True, False):
            self.show(self.page, dark=dark)
            shade = sum(map(int, re.findall(r"\d+", self.browser.run(colour, "body"))[:3]))
            (self.assertLess if dark else self.assertGreater)(shade, 380)
            card = "#wiggle_spectrum_matrix_linear .drawing"
            self.assertEqual(self.browser.run(colour, card), "rgb(255, 255, 255)")

    def test_fits_on_paper(self):
        self.show(self.page)
        pdf = self.browser.printed()
        self.assertTrue(pdf.startswith(b"%PDF"))
        self.assertIn(len(re.findall(rb"/Type\s*/Page\b", pdf)), range(15, 100))

    def test_problems_are_found(self):
        text = small_report(self.results)
        figures = [name for name in self.figures if name.startswith(tuple(f"{study}_" for study in STUDIES))]
        page = WORK / "small.html"
        page.write_text(text, encoding="utf-8")
        self.browser.leave()
        self.assertEqual(self.problems(page, figures), [])  # so that each of these is of a change
        for what, pattern, replacement, found in (
                ("a lost figure", r'(<figure id="carter_traction".*?<svg[^>]*>).*?</svg>', r"\1</svg>",
                 "carter_traction: 0 marks"),
                ("a figure of no size", '<figure id="carter_traction"', '<figure hidden id="carter_traction"',
                 "carter_traction: nothing to see"),
                ("a lost mark", '<circle id="carter-1-gpPt5"', "<circle", "carter_traction: no mark #carter-1-gpPt5"),
                ("a broken link", 'href="#carter-1"', 'href="#carter-0"', "#carter-0 leads nowhere"),
                ("small letters", r'(<figure id="carter_traction".*?font-size=")14', r"\g<1>4", "letters of"),
                ("a cut text", r'(<figure id="open_problems_peak".*?</svg><svg viewBox=")[\d.]+', r"\g<1>215",
                 "open_problems_peak: cut through"),
                ("a lost panel", r'(<figure id="open_problems_peak".*?</svg>)<svg viewBox.*?</svg>', r"\1",
                 "open_problems_peak: panels show"),
                ("a pale label", r'(<figure id="open_problems_convergence".*?)style="fill:light-dark\(#......', r"\1"
                 'style="fill:light-dark(#d55e00', "contrast"),
                ("too wide", "<footer>", '<footer style="width:99rem">', "px wide in"),
                ("too pale", "<footer>", '<footer><p style="color:rgb(150,150,150)">pale</p>', "contrast 3.0"),
                ("an error", "<footer>", "<footer><script>nothing()</script>", "nothing is not defined"),
                ("a picture from elsewhere", "<footer>", '<footer><img src="other.png">', "other.png")):
            with self.subTest(what):
                changed, times = re.subn(pattern, replacement, text, count=1, flags=re.DOTALL)
                self.assertEqual(times, 1)
                page = WORK / f"{what.replace(' ', '_')}.html"
                page.write_text(changed, encoding="utf-8")
                said = self.problems(page, figures)
                self.assertTrue(any(found in line for line in said), said)


if __name__ == "__main__":
    if webdriver.missing():
        print(f"skipped: {webdriver.missing()} is not installed; `tools/deps.sh browser` does it")
        sys.exit(77)
    WORK.mkdir(parents=True, exist_ok=True)
    unittest.main(argv=sys.argv[:1])
