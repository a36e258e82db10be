#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""README and docs/: tests and sources that are named exist, and theory.md names tests. No two types of a library have one
name. Usage: names_test.py"""
import re
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PAGES = [ROOT / "README.md", *sorted(ROOT.glob("docs/*.md"))]
THEORY = ROOT / "docs/theory.md"
FOLDERS = sorted(folder.name for folder in (ROOT / "tests").iterdir() if folder.is_dir())
FILE = rf"\b(?:tests/)?(?!\w+/NAME_)((?:{'|'.join(FOLDERS)})/\w+_test)(\.cpp|\.py)?\b"
NAME = r"`([A-Z]\w+)\.([A-Z]\w+)`"
PLACES = ("", "core/include/microslip", "core/src", "scene/include/microslip", "scene/src", "docs", "tests", "experiments/include/microslip",
          "experiments/src", "thesis/include/microslip", "capi/include")


def text_of(page):
    return page.read_text(encoding="utf-8")


def file_of(test, ending=None):
    files = [ROOT / f"tests/{test}{end}" for end in ([ending] if ending else [".cpp", ".py"])]
    return next((file for file in files if file.exists()), None)


def tests_in(file):
    """Names of GoogleTest, without those of parameters: {"Suite.Name"}."""
    return {f"{suite}.{name}" for suite, name in re.findall(r"^TEST(?:_[FP])?\(\s*(\w+),\s*(\w+)\)", text_of(file),
                                                            re.MULTILINE)}


def types_in(file):
    """Names of the types that a source defines at the left margin, outside unnamed namespaces."""
    text = re.sub(r"^namespace \{.*?^\}  // namespace$", "", text_of(file), flags=re.MULTILINE | re.DOTALL)
    return re.findall(r"^(?:class|struct) (\w+)(?: final)?(?: :[^:].*)? \{", text, re.MULTILINE)


class Types(unittest.TestCase):
    def test_have_names_of_their_own(self):
        """A linker takes one of two types with the same name for both, and says nothing."""
        places = {}
        for layer in ("core", "scene", "thesis", "program"):
            for file in sorted((ROOT / layer).rglob("*.[hc]pp")):
                for name in types_in(file):
                    places.setdefault(name, []).append(file.relative_to(ROOT))
        self.assertGreater(len(places), 200)
        self.assertEqual({name: files for name, files in places.items() if len(files) > 1}, {})


class Names(unittest.TestCase):
    def test_of_files_with_tests_exist(self):
        seen = 0
        for page in PAGES:
            for test, ending in re.findall(FILE, text_of(page)):
                seen += 1
                self.assertIsNotNone(file_of(test, ending), f"{page.name}: {test}")
        self.assertGreater(seen, 20)

    def test_of_tests_exist(self):
        known = set().union(*(tests_in(file) for file in ROOT.glob("tests/*/*_test.cpp")))
        for page in PAGES:
            for suite, name in re.findall(NAME, text_of(page)):
                self.assertTrue(f"{suite}.{name}" in known, f"{page.name}: {suite}.{name}")

    def test_of_tests_are_in_the_file_that_stands_before_them(self):
        seen = 0
        for paragraph in re.split(r"\n\s*\n", text_of(THEORY)):
            file = None
            for token in re.finditer(f"{FILE}|{NAME}", paragraph):
                test, ending, suite, name = token.groups()
                if test:
                    file = file_of(test, ending)
                    continue
                seen += 1
                self.assertIsNotNone(file, f"no file before {suite}.{name}")
                self.assertIn(f"{suite}.{name}", tests_in(file), file.name)
        self.assertGreater(seen, 20)

    def test_of_ctest_exist(self):
        listed = re.findall(r"add_test\(NAME (\S+)", text_of(ROOT / "tests/CMakeLists.txt"))
        known = re.compile("|".join(re.sub(r"\\\$\\\{\w+\\\}", r"\\w+", re.escape(name)) for name in listed))
        groups = {name.partition(".")[0] for name in listed}
        for page in PAGES:
            for name in re.findall(r"`([a-z]+\.[a-z_]+)`", text_of(page)):
                group, _, part = name.partition(".")
                if group in groups and part not in ("md", "py", "so", "info"):
                    self.assertTrue(known.fullmatch(name), f"{page.name}: {name}")

    def test_of_sources_exist(self):
        seen = 0
        for page in PAGES:
            for name in re.findall(r"`((?![^`]*NAME)[\w/.]+/[\w.]+\.(?:[ch]pp|h|py|sh|gp))`", text_of(page)):
                seen += 1
                self.assertTrue(any((ROOT / place / name).exists() for place in PLACES), f"{page.name}: {name}")
        self.assertGreater(seen, 5)

    def test_stand_in_every_section_of_theory(self):
        """A section that says something about the methods says which test proves it."""
        sections = re.split(r"^#+ (.+)$", text_of(THEORY), flags=re.MULTILINE)[1:]
        for heading, text in zip(sections[::2], sections[1::2]):
            if text.strip() and heading not in ("What is solved", "Symbols"):
                self.assertRegex(text, FILE, heading)


class Formulas(unittest.TestCase):
    """Forges read Markdown's escapes and emphasis before formulas within a line, and tables their bars."""

    def lines(self):
        """Lines of theory.md without blocks, each with its formulas."""
        text = re.sub(r"^```.*?^```$", "", text_of(THEORY), flags=re.MULTILINE | re.DOTALL)
        for line in text.splitlines():
            self.assertEqual(line.count("$") % 2, 0, line)
            yield line, line.split("$")[1::2]

    def test_are_read_alike_by_forges_and_editors(self):
        seen = 0
        for line, formulas in self.lines():
            self.assertNotIn("\\f", re.sub(r"\$[^$]*\$", "", line))
            for before, after in zip(line.split("$")[0::2], line.split("$")[2::2]):
                self.assertNotRegex(before[-1:] + after[:1], r"\w", line)
            for formula in formulas:
                seen += 1
                self.assertRegex(formula, r"^\S(.*\S)?$", line)
                self.assertNotRegex(formula, r"\\[^A-Za-z]|[*`<>]", line)
                if line.startswith("|"):
                    self.assertNotIn("|", formula)
        self.assertGreater(seen, 100)

    def test_have_no_macro_that_a_forge_refuses(self):
        self.assertNotRegex(text_of(THEORY), r"\\(operatorname|newcommand|def|label|ref|href|class)\b")

    def test_of_blocks_are_closed(self):
        fences = re.findall(r"^```(\w*)$", text_of(THEORY), re.MULTILINE)
        self.assertGreater(len(fences), 20)
        self.assertEqual(fences[::2], ["math"] * (len(fences) // 2))
        self.assertEqual(fences[1::2], [""] * (len(fences) // 2))


if __name__ == "__main__":
    unittest.main(verbosity=0)
