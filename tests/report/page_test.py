# SPDX-License-Identifier: GPL-3.0-or-later
"""The report by its text, and what bad input makes of it.
Usage: page_test.py PROGRAMS_FOLDER FIGURES_FOLDER WORK_FOLDER"""
import os
import re
import subprocess
import sys
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools" / "report"))
from faults import FAULTS
from prose import introduction, parts_of, sections_of
from tables import ReportError
from quick_results import NOT_JUDGED, ROOT, claims_of, link_results, make_report
from small_report import STUDIES, small_claims, small_report
from structure import problems

PROGRAMS, FIGURES, WORK = map(Path, sys.argv[1:])


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.results = link_results(FIGURES, WORK / "good")
        cls.claims = claims_of(cls.results)
        cls.made = make_report(cls.results, WORK / "report.html")
        cls.text = (WORK / "report.html").read_text(encoding="utf-8")

    def test_is_made_without_a_word(self):
        self.assertEqual((self.made.returncode, self.made.stdout, self.made.stderr), (0, "", ""))

    def test_has_no_problem(self):
        self.assertGreater(len(self.claims), 50)
        self.assertEqual(problems(self.text, self.claims), [])

    def test_is_the_same_again(self):
        make_report(self.results, WORK / "again.html")
        self.assertEqual((WORK / "again.html").read_text(encoding="utf-8"), self.text)

    def test_is_small_enough_to_send(self):
        self.assertLess(len(self.text.encode()), 6_000_000)

    def test_has_all_figures_and_parameters(self):
        for figure in (self.results / "figures").iterdir():
            if not figure.name.startswith("bench_"):
                self.assertIn(f'<figure id="{figure.stem}"', self.text)
        for line in (self.results / "carter" / "claims.tsv").read_text(encoding="utf-8").splitlines():
            if match := re.fullmatch(r"#   (\S+) = (.*)", line):
                self.assertIn(f"<tr><td><code>{match[1]}</code></td><td>{match[2]}</td></tr>", self.text)

    def test_figures_have_panels_for_a_phone(self):
        """A figure or panel of more than 640 pixels has texts that are too small there."""
        cut = 0
        for name, drawing in re.findall(r'data-figure="(\w+)".*?<div class="drawing">(.*?)<figcaption>', self.text, re.DOTALL):
            whole, *panels = [list(map(float, box.split())) for box in re.findall(r'<svg[^>]*viewBox="([^"]*)"', drawing)]
            for left, top, width, height in panels or [whole]:
                self.assertLessEqual(width, 640, name)
                self.assertEqual((top, height), (0, whole[3]), name)
            if panels:
                cut += 1
                self.assertAlmostEqual(sum(panel[2] for panel in panels), whole[2], delta=0.2, msg=name)
                self.assertEqual([panel[0] for panel in panels], sorted(panel[0] for panel in panels), name)
        self.assertGreater(cut, 20)

    def test_what_is_nothing_but_rounding_has_no_digits(self):
        card = re.search(r'<article id="fractional_power-1".*?</article>', self.text, re.DOTALL)[0]
        self.assertIn("<dd>below 1 · 10<sup>−9</sup></dd>", card)

    def test_shows_rule_and_tolerance(self):
        card = re.search(r'<article id="carter-2".*?</article>', self.text, re.DOTALL)[0]
        self.assertIn("<dt>tolerance</dt><dd>±0.1</dd>", card)
        self.assertIn('<p class="rule">Rule: reproduced if the measured value is within 0.1 of 0.55; '
                      "otherwise refuted.</p>", card)
        self.assertNotIn("tolerance", re.search(r'<article id="carter-1".*?</article>', self.text, re.DOTALL)[0])

    def test_begins_with_faults_and_cures(self):
        top = self.text[:self.text.index('<h2 id="claims">')]
        self.assertEqual(len(FAULTS), 4)
        for i, fault in enumerate(FAULTS, 1):
            self.assertIn(f"<h2>{i}. {fault.name}</h2>", top)
            self.assertIn(fault.cure, top)
            self.assertEqual(top.count(f'data-figure="{fault.figure}"'), 1)

    def test_states_claims_in_full(self):
        """Claim, measured value with its meaning, rule and verdict stand in one row."""
        row = re.search(r'<tr><td class="statement"><a href="#carter-1">.*?</tr>', self.text, re.DOTALL)[0].replace("\n", "")
        self.assertRegex(row, r"wiggles arise.*<b>\d+</b>: local extrema of the traction.*"
                              r"reproduced if the measured value is above 5.*</span></td></tr>")

    def test_introduces_each_study_beside_its_figures(self):
        for name, markdown in sections_of(ROOT / "docs/studies.md").items():
            section = re.search(rf'<section id="{name}">.*?</section>', self.text, re.DOTALL)[0]
            words = re.findall(r"^[A-Za-z][A-Za-z ,]{9,}\b", markdown, re.MULTILINE)
            self.assertTrue(words, name)
            for part in words:
                self.assertIn(part, re.sub("<.*?>", "", section), name)
        steps = self.text.index("<em>Any step.</em>"), self.text.index('<figure id="open_problems_steps"')
        self.assertLess(*steps)
        self.assertNotIn('<div class="prose">', self.text[steps[0]:steps[1]])

    def test_says_where_nothing_is_judged_and_why(self):
        said = re.findall(r'<span class="unjudged">Not judged: (.*?)\.</span>', self.text)
        self.assertEqual(len(said), 2)  # in the table of all claims, and at the study
        for why in said:
            self.assertRegex(why, r"^this run has other parameters than the study: .*noise\.elements")
        verdicts = {id: claim["verdict"] for id, claim in self.claims.items()}
        self.assertEqual({id.rpartition("-")[0] for id, verdict in verdicts.items() if verdict == "not_judged"},
                         {NOT_JUDGED})
        self.assertIn(">not judged: the run has other parameters than the study<", self.text)

    def test_says_nothing_of_it_where_all_is_judged(self):
        def text_of(leave):
            text = small_report(link_results(FIGURES, WORK / "judged", leave), (*STUDIES, NOT_JUDGED))
            return re.sub("<style>.*?</style>", "", text, flags=re.DOTALL).split("<h3>Made by")[0]
        self.assertIn("not judged", text_of((NOT_JUDGED,)))
        self.assertNotIn("not judged", text_of(()))

    def test_problems_are_found(self):
        text, claims = small_report(self.results), small_claims(self.results)
        self.assertEqual(problems(text, claims), [])
        for what, pattern, replacement, found in (
                ("a lost figure", r'<figure id="carter_traction".*?</figure>', "", "no figure carter_traction"),
                ("an empty figure", r'(<figure id="carter_traction".*?<svg[^>]*>).*?</svg>', r"\1</svg>",
                 "no figure carter_traction"),
                ("a broken link", 'href="#carter-1"', 'href="#carter-0"', "#carter-0 leads nowhere"),
                ("a link to elsewhere", 'href="#carter-1"', 'href="carter.html"', "carter.html leads nowhere"),
                ("a picture from the network", "<footer>", '<footer><img src="http://x/y.png">', "network is needed"),
                ("an id twice", "<h2>carter", '<h2 id="open_problems">carter', "open_problems is there 2 times"),
                ("a lost claim", r'<article id="carter-2".*?</article>', "", "carter-2: the verdict is None"),
                ("a claim too many", '<article id="carter-2"', '<article id="carter-3"', "carter-3 is no claim"),
                ("another verdict", 'id="carter-1" class="claim reproduced"', 'id="carter-1" class="claim refuted"',
                 "carter-1: the verdict is refuted, not reproduced"),
                ("another count", r'data-count="refuted">\d+', 'data-count="refuted">99', "99 claims are said"),
                ("another statement", "<h4>accuracy decreases", "<h4>accuracy increases", "carter-2: does not say"),
                ("another rule", "(Rule: .*?) is within 0.1 of 0.55; otherwise", r"\1 is about right; otherwise",
                 "carter-2: does not say the rule"),
                ("a number that is none", r'(id="carter-1".*?<dd>)[^<]*', r"\1nan", "carter-1: says nan"),
                ("no end", "</section>", "", "has no end")):
            with self.subTest(what):
                changed, times = re.subn(pattern, replacement, text, count=1, flags=re.DOTALL)
                self.assertEqual(times, 1)
                self.assertTrue(any(found in line for line in problems(changed, claims)))


class Prose(unittest.TestCase):
    def test_becomes_html(self):
        text = ("![c](a.svg)\n\n*One* is `a < b` for c\\* and 2e-3, see [b](#b) and\n[other](x.md).\n\n| h | k |\n|---|---|\n"
                "| 1 | **2** |\n\n- x^2\n- y\n  z")
        html = "".join(html for html, _ in parts_of(text, [], {"#b": "b"}))
        self.assertEqual(re.sub("(?<=>)\n(?=<[^pdu])", "", html.replace("\N{NON-BREAKING HYPHEN}", "-")),
                         '<p><em>One</em> is <code>a &lt; b</code> for c* and 2e-3, see <a href="#b">b</a> and\nother.</p>\n'
                         '<div class="scrolls" tabindex="0"><table><thead><tr><th>h</th><th>k</th></tr></thead><tbody>'
                         "<tr><td>1</td><td><strong>2</strong></td></tr></tbody></table></div>\n"
                         "<ul><li>x<sup>2</sup></li><li>y\n  z</li></ul>\n")

    def test_has_figures_after_the_text_that_names_them(self):
        self.assertEqual(parts_of("![x](s_b.svg)\n\nFirst.\n\nMore.", ["s_a", "s_b"], {}),
                         [("<p>First.</p>\n<p>More.</p>\n", ["s_b"])])
        text = "First.\n\nSee `s_a.svg`, `..._b.svg`.\n\nMore.\n\nAgain `s_a.svg` and `s_c.svg`."
        self.assertEqual([(html.count("<p>"), names) for html, names in parts_of(text, ["s_a", "s_b", "s_c"], {})],
                         [(1, []), (2, ["s_a", "s_b"]), (1, ["s_c"])])

    def test_is_wanted_of_each_study(self):
        self.assertRaisesRegex(ReportError, "studies.md: expected a section `## new` with text",
                               introduction, {"old": "text"}, "new", "studies.md")


class Readme(unittest.TestCase):
    """The page takes the studies, their order and questions from the README."""

    def test_says_what_the_programs_say(self):
        text = (ROOT / "README.md").read_text(encoding="utf-8")
        rows = dict(re.findall(r"^\| \[(\w+)\]\(docs/studies\.md#\1\) \| (.+?) \| ", text, re.MULTILINE))
        self.assertEqual(set(rows), {scene.parent.name for scene in ROOT.glob("studies/*/study.info")})
        for study, question in rows.items():
            run = subprocess.run([PROGRAMS / study, "--help"], capture_output=True, text=True, timeout=60)
            self.assertIn(question, run.stdout.splitlines()[0])


class BadInput(unittest.TestCase):
    def refused(self, results, said, output=WORK / "bad" / "report.html"):
        """One line that says it, exit status 1, and nothing left, not even the page of before."""
        if not output.parent.is_file():
            output.parent.mkdir(exist_ok=True)
            output.write_text("older")
        run = make_report(results, output)
        self.assertEqual((run.returncode, run.stdout), (1, ""), run.stderr)
        self.assertRegex(run.stderr, rf"\Areport: [^\n]*{said}[^\n]*\n\Z")
        if output.parent.is_dir():
            self.assertEqual(list(output.parent.iterdir()), [])

    def damaged(self, file, change):
        results = link_results(FIGURES, WORK / "damaged")
        text = change((results / file).read_text(encoding="utf-8"))
        (results / file).unlink()
        if text is not None:
            (results / file).write_text(text, encoding="utf-8")
        return results

    def test_no_folder(self):
        self.refused(WORK / "none", "none: no such folder; expected what `make figures` writes")

    def test_no_claims(self):
        self.refused(self.damaged("carter/claims.tsv", lambda text: None), "carter/claims.tsv: no such file; expected")

    def test_no_provenance(self):
        self.refused(self.damaged("carter/provenance.txt", lambda text: None), "provenance.txt: no such file")
        self.refused(self.damaged("carter/provenance.txt", lambda text: "carter\n"), "expected a line `command: ...`")
        self.refused(self.damaged("carter/provenance.txt", lambda text: text.replace("'", "", 1)), "No closing quotation")

    def test_no_table_of_those_named(self):
        self.refused(self.damaged("carter/traction.tsv", lambda text: None), "carter/traction.tsv: no such file")

    def test_no_figure(self):
        self.refused(self.damaged("figures/carter_traction.svg", lambda text: None),
                     "'wiggles arise .*' names the figure carter_traction; expected none or one of carter_accuracy")
        self.refused(self.damaged("carter/claims.tsv", lambda text: text.replace("\tcarter_traction", "\tcarter_x")),
                     "names the figure carter_x; expected none or one of carter_accuracy, carter_traction")

    def test_no_headline(self):
        results = self.damaged("figures/open_problems_convergence.svg", lambda text: None)
        self.refused(results, "open_problems_convergence")

    def test_half_a_table(self):
        self.refused(self.damaged("carter/claims.tsv", lambda text: text[:-5]), "not a whole table: expected an end")
        self.refused(self.damaged("carter/claims.tsv", lambda text: text.replace("\treproduced\t", "\t")),
                     "not a whole table: expected rows of claim, ")
        self.refused(self.damaged("carter/claims.tsv", lambda text: "\n"), "expected a comment")

    def test_claims_of_another_kind(self):
        self.refused(self.damaged("carter/claims.tsv", lambda text: text.replace("\treproduced", "\tlikely")),
                     "unknown verdict 'likely'; known: reproduced, ")
        self.refused(self.damaged("carter/claims.tsv", lambda text: text.replace("figure", "picture")),
                     "expected the columns claim, .*, figure")
        self.refused(self.damaged("carter/claims.tsv", lambda text: text.replace("\tnan\t", "\tmany\t")), "'many'")
        self.refused(self.damaged("carter/claims.tsv", lambda text: re.sub("\treproduced if [^\t]*", "\t", text, count=1)),
                     "'wiggles arise .*' has no rule")

    def test_claims_that_are_judged_in_part(self):
        expected = "expected the verdict not_judged of all claims, and the reason in the first line, or neither"
        self.refused(self.damaged("carter/claims.tsv", lambda text: text.replace("\treproduced\t", "\tnot_judged\t")),
                     expected)
        self.refused(self.damaged(f"{NOT_JUDGED}/claims.tsv", lambda text: re.sub("; not judged: .*", "", text)), expected)

    def test_half_a_figure(self):
        self.refused(self.damaged("figures/carter_traction.svg", lambda text: text[:5000]), "not a whole figure")
        self.refused(self.damaged("figures/carter_traction.svg", lambda text: text.replace("viewBox", "box")),
                     "expected a figure of gnuplot")
        for title in "", "Gnuplot":
            untitled = self.damaged("figures/carter_traction.svg",
                                    lambda text: re.sub("<title>.*?</title>", f"<title>{title}</title>", text, count=1))
            self.refused(untitled, "expected a title that says what it shows")

    def test_nowhere_to_write(self):
        file = WORK / "file"
        file.write_text("")
        self.refused(link_results(FIGURES, WORK / "damaged"), "cannot be written", file / "report.html")

    def test_no_package(self):
        for name in ("jinja2", "markdown"):
            (WORK / "lacks" / name).mkdir(parents=True, exist_ok=True)
            (WORK / "lacks" / name / f"{name}.py").write_text(f"raise ImportError('no {name}')\n")
            run = subprocess.run([sys.executable, ROOT / "tools/report/report.py"], capture_output=True, text=True,
                                 env={**os.environ, "PYTHONPATH": str(WORK / "lacks" / name)})
            self.assertEqual((run.returncode, run.stderr), (1, f"report: no {name}; `tools/deps.sh report` installs it\n"))

    def test_no_arguments(self):
        run = subprocess.run([sys.executable, ROOT / "tools/report/report.py"], capture_output=True, text=True)
        self.assertEqual((run.returncode, run.stderr), (1, "report: expected RESULTS_FOLDER OUTPUT.html\n"))


if __name__ == "__main__":
    WORK.mkdir(parents=True, exist_ok=True)
    unittest.main(argv=sys.argv[:1])
