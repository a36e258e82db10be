# SPDX-License-Identifier: GPL-3.0-or-later
"""All figures in Chromium, on a desktop and on a phone: every text lies inside its picture, and no two texts overlap.
Figures are those of the studies by themselves, the sketches of the pages, and those that `microslip plot` draws of results
of every kind. The figures within the report are looked at by browser_test.py.
Usage: texts_test.py PROGRAMS FIGURES_FOLDER WORK_FOLDER; exit status 77 if there is no Chromium."""
import os
import re
import shutil
import subprocess
import sys
import unittest
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "browser"))
import webdriver
from quick_results import ROOT

PROGRAMS, FIGURES, WORK = (Path(word).resolve() for word in sys.argv[1:])
WIDTHS = (1280, 390)
VERSION = re.compile("Produced by (GNUPLOT.*)<")
IN_BROWSER = Path(__file__).with_name("texts.js").read_text(encoding="utf-8")
BOUNDS = [f"a_file_with_a_long_name_of_a_bound_{i}.tsv" for i in range(4)]
SWEEP = "sweep steady.info --quiet --set load.force= --out"

# A result is made by these words of a command line.
RESULTS = """
steady.info --out steady
steady.info --set load.force=-0.001 --out little
steady.info --set kernel.type=plane --set kernel.width= --set kernel.length=50 --out plane
line.info --out line
ellipse.info --out ellipse
ellipse.info --set contact.lateral_radius_2=30 --out long_ellipse
ellipse.info --set contact.radius_1=40 --out wide_ellipse
transient.info --out transient
transient.info --set step.ratio=0.5 --out fine
ellipse_transient.info --out steps
ellipse_transient.info --set step.scheme=direct --out rectangles
ellipse_transient.info --set load.spin=0 --set load.lateral_force= --out along
transient.info --set start.force="-100 100 -100 100" --out shifts
transient.info --set motion.instants=6 --out instants
transient.info --set motion.instants=1 --out instant
ellipse_transient.info --set motion.instants=20 --out map_instants
ellipse_transient.info --set step.scheme=direct --set motion.instants=2 --out two_maps
run.info --set motion.instants=4 --out run
transient.info --set load.force= --set load.file=turns.tsv --set start.type=rest --set motion.distance= --set motion.instants=5 --out turns
cylinder.info --set grid.elements=20 --out cylinder
sweep sweep.info --quiet --out sweep
SWEEP words --set sweep.load.creepage=1e-4:log4:1e-2 --set sweep.leading_edge="calibrated standard inversion known_edge"
SWEEP many --set sweep.load.creepage=1e-4:log4:1e-2 --set sweep.leading_edge="calibrated standard" \
 --set sweep.kernel.width="5 10" --set sweep.contact.half_width="4.5123 5.3123" --set sweep.material.poisson_ratio="0.25 0.3"
SWEEP files --set contact.peak_traction= --set load.creepage=1e-3 --set sweep.contact.bound_file="BOUNDS"
curve steady.info --quiet --out curve
curve ellipse.info --quiet --points 11 --beside "fastsim fastsim_one vermeulen_johnson polach" --out laws
curve ellipse.info --quiet --points 11 --along lateral_creepage --beside "fastsim polach" --set sweep.load.spin="0 0.2 0.5 1/m" --out families
converge steady.info --quiet --out converge
converge transient.info --quiet --out converge_transient
response steady.info --out response
response steady.info --set load.force=-100 --out response_of_little
"""
# These figures are drawn of them.
PLOTS = {"steady": "steady", "little": "little", "plane": "plane", "line": "line", "ellipse": "ellipse", "long_ellipse": "long_ellipse",
         "wide_ellipse": "wide_ellipse", "steps": "steps --figure history", "both_steps": "steps rectangles",
         "along": "along --figure history", "rectangles": "rectangles --figure ellipse", "transient": "transient", "run": "run --figure transient",
         "instants": "instants --figure instants", "instant": "instant --figure instants",
         "map_instants": "map_instants --figure instants", "two_maps": "two_maps --figure instants",
         "times_of_instants": "run --figure instants --over t", "turning_instants": "turns --figure instants",
         "cylinder": "cylinder", "sweep": "sweep", "curve": "curve", "laws": "laws", "families": "families", "converge": "converge",
         "converge_transient": "converge_transient", "response": "response", "shifts": "shifts --figure shifts",
         "three": "steady little plane", "long": "DEEP/steady DEEP/little DEEP/plane", "tractions": "steady run cylinder",
         "edge": "steady little --x 4.7:4.9", "transients": "transient fine", "begin": "run --q 10:100", "time": "run --over t",
         "early": "run --over t --time 0.1:0.2", "cylinder_time": "cylinder --over t", "words": "words",
         "upright": "files", "names": "words --over leading_edge", "many": "many", "responses": "response response_of_little"}


def run(words):
    return subprocess.run(f"'{PROGRAMS}/microslip' {words}", shell=True, cwd=WORK, capture_output=True, text=True)


def run_all(commands):
    """What the commands say, in their order; several run at once."""
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        return list(pool.map(run, commands))


def page_of(figures):
    """A page with figures as they are, scaled down where the window is narrow."""
    bodies = [f'<figure id="{figure.stem}">' + re.sub(r"<\?xml.*?\?>|<!DOCTYPE[^>]*>", "", figure.read_text(encoding="utf-8"),
                                                      flags=re.DOTALL) + "</figure>" for figure in figures]
    return ('<!DOCTYPE html><meta charset="utf-8"><meta name="viewport" content="width=device-width">'
            "<style>figure { margin: 0 } svg { display: block; max-width: 100%; height: auto }</style>" + "\n".join(bodies))


class Texts(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.browser = webdriver.Browser()
        cls.addClassCleanup(cls.browser.close)
        for number, bound in enumerate(BOUNDS):
            (WORK / bound).write_text(f"x\tbound\n-5\t0\n{number - 2}\t300\n5\t0\n", encoding="utf-8")
        (WORK / "turns.tsv").write_text("q\tcreepage\n0\t0.001\n20.123\t0.001\n-5.678\t0.001\n", encoding="utf-8")
        for kind in ("steady", "line", "ellipse", "transient", "ellipse_transient", "run", "cylinder", "sweep"):
            run(f"init {kind}")
        results = RESULTS.replace("\\\n", "").replace("SWEEP", SWEEP).replace("BOUNDS", " ".join(BOUNDS))
        for made in run_all(results.strip().splitlines()):
            assert made.returncode == 0, made.args + made.stderr

    def problems(self, page):
        """A list of them for each of the widths."""
        def at(width):
            self.browser.emulate(width)
            return self.browser.run(IN_BROWSER)

        self.browser.leave()
        self.browser.emulate(WIDTHS[0])
        self.browser.open(page)
        return [at(width) for width in WIDTHS]

    def expect_none(self, figures):
        page = WORK / "page.html"
        page.write_text(page_of(figures), encoding="utf-8")
        for width, said in zip(WIDTHS, self.problems(page)):
            with self.subTest(width=width):
                self.assertEqual(said, [])

    def test_studies(self):
        figures = sorted(FIGURES.glob("*/*.svg"))
        self.assertGreater(len(figures), 60)
        self.expect_none(figures)

    def test_pages(self):
        self.expect_none(sorted(ROOT.glob("docs/*.svg")))

    def test_sketch_is_what_its_script_draws(self):
        drawn = WORK / "signs.svg"
        subprocess.run([ROOT / "plots/draw.sh", ROOT / "plots/signs.gp", WORK, drawn], check=True)
        made, kept = drawn.read_text(encoding="utf-8"), (ROOT / "docs/signs.svg").read_text(encoding="utf-8")
        if VERSION.search(made)[1] != VERSION.search(kept)[1]:
            self.skipTest("another version of gnuplot")
        self.assertEqual(made, kept)

    def test_picture_of_the_first_page_is_what_its_commands_draw(self):
        """With the same texts, numbers and colours, and places within a tenth of a pixel, as processors round differently."""
        block = re.search(r"```sh\n(.*?)```", (ROOT / "README.md").read_text(encoding="utf-8"), re.DOTALL)[1]
        commands = re.findall(r"^microslip (.+?)(?:  +#.*)?$", block, re.MULTILINE)
        self.assertEqual([words.split()[0] for words in commands], ["init", "wheel.info", "plot"])
        for words in commands:
            made = run(words)
            self.assertEqual((made.returncode, made.stderr), (0, ""), words)
        made, kept = ((folder / "wheel.svg").read_text(encoding="utf-8") for folder in (WORK / "out", ROOT / "docs"))
        if VERSION.search(made)[1] != VERSION.search(kept)[1]:
            self.skipTest("another version of gnuplot")
        place = re.compile(r"-?\d+\.\d\d\b")
        self.assertEqual(place.sub("", made), place.sub("", kept))
        moved = max(abs(float(a) - float(b)) for a, b in zip(place.findall(made), place.findall(kept), strict=True))
        self.assertLess(moved, 0.1)

    def test_own_results(self):
        plots = (f"plot {words.replace('DEEP', str(WORK))} --to own_{name}.svg" for name, words in PLOTS.items())
        for drawn in run_all(plots):
            self.assertEqual((drawn.returncode, drawn.stderr), (0, ""), drawn.args)
        self.expect_none([WORK / f"own_{name}.svg" for name in PLOTS])

    def test_problems_are_found(self):
        """Texts that are moved out of the picture, onto one another or onto a sample, and a blank that is lost."""
        figure = ('<svg viewBox="0 0 400 200" xmlns="http://www.w3.org/2000/svg" font-size="14">'
                  '<polygon points="20,90 34,90 34,104 20,104" fill="red"/><text x="{x}" y="{y}">one text</text>'
                  '<text x="200" y="100">another<tspan>{blank}</tspan>text</text></svg>')
        for what, values, found in (("nothing", (100, 50, ","), None), ("out", (-8, 50, ","), "out of the picture"),
                                    ("above", (100, 6, ","), "out of the picture"), ("over", (230, 105, ","), "overlap"),
                                    ("near", (140, 100, ","), "overlap"), ("sample", (30, 100, ","), "on a sample"),
                                    ("blank", (100, 50, "  "), "lost a blank")):
            with self.subTest(what):
                text = figure.format(**dict(zip(("x", "y", "blank"), values)))
                (WORK / "figure.svg").write_text(text, encoding="utf-8")
                (WORK / "page.html").write_text(page_of([WORK / "figure.svg"]), encoding="utf-8")
                said = self.problems(WORK / "page.html")[0]
                self.assertTrue(any(found in line for line in said) if found else not said, said)


if __name__ == "__main__":
    if webdriver.missing():
        print(f"skipped: {webdriver.missing()} is not installed; `tools/deps.sh browser` does it")
        sys.exit(77)
    shutil.rmtree(WORK, ignore_errors=True)
    WORK.mkdir(parents=True)
    unittest.main(argv=sys.argv[:1])
