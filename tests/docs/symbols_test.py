#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""theory.md: its formulas use the symbols of its table, each with one meaning. Usage: symbols_test.py"""
import re
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PAGE = (ROOT / "docs/theory.md").read_text(encoding="utf-8")

CONSTANTS = {"e", "i", "d", "O", r"\pi"}
GREEK = set(r"""\alpha \beta \gamma \delta \varepsilon \zeta \eta \theta \vartheta \iota \kappa \lambda \mu \nu \xi \rho \sigma
\tau \phi \varphi \chi \psi \omega \pi \Gamma \Theta \Lambda \Xi \Phi \Psi \Omega \Sigma \epsilon \ell""".split())
ACCENTS = {r"\hat", r"\bar", r"\tilde", r"\Delta"}
FONTS = {r"\mathrm", r"\mathcal", r"\mathsf"}
# Operators, relations, brackets and spaces; they may have limits, which are formulas.
COMMANDS = set(r"""\frac \tfrac \sqrt \int \sum \prod \ln \sin \cos \cosh \exp \min \infty \partial \dot \propto \to \le \ge \ne
\gt \lt \ll \approx \pm \mp \cdot \ast \dots \quad \qquad \thinspace \big \bigl \bigr \Big \left \right \text \vert""".split())


def group(tokens):
    """Takes the next token, or all of the next braces without them."""
    if not tokens:
        return []
    first = tokens.pop(0)
    if first != "{":
        return [first, *group(tokens)] if first in FONTS else [first]
    taken, depth = [], 1
    while depth:
        token = tokens.pop(0)
        depth += {"{": 1, "}": -1}.get(token, 0)
        taken.append(token)
    return taken[:-1]


def letter(tokens):
    """Takes a letter with its font and accents. None if something else comes first."""
    first = tokens.pop(0)
    if first in FONTS:
        text = "".join(group(tokens))
        return f"{first} {text}" if len(text) == 1 and first != r"\mathsf" else None
    if first in ACCENTS:
        inner = group(tokens)
        return f"{first} {letter(inner)}"
    if first in GREEK or re.fullmatch("[A-Za-z]", first):
        return first
    if first.startswith("\\") and first[1:2].isalpha():
        if first not in COMMANDS:
            raise ValueError(f"unknown command {first}")
        if first == r"\text":
            group(tokens)
    return None


def is_index(tokens):
    return all(re.fullmatch(r"[jn\d,+-]|\d+", token) for token in tokens) and tokens not in (["+"], ["-"])


def symbols(formula):
    """The symbols of a formula in TeX, in their order: letters with accents, primes and subscripts that are no indices."""
    tokens = [token for token in re.findall(r"\\[A-Za-z]+|\\.|\d+|[^\s]", formula)]
    return parsed(tokens)


def parsed(tokens):
    found = []
    while tokens:
        name = letter(tokens)
        inner = []
        while tokens and tokens[0] in ("_", "^", "'"):
            mark = tokens.pop(0)
            if mark == "'":
                name = f"{name}'" if name else None
                continue
            content = group(tokens)
            if name and mark == "^" and content == [r"\ast"]:
                name += "^*"
            elif name and mark == "_" and not is_index(content):
                name += "_" + "".join(content)
            elif name and mark == "_":
                name += "_" + "".join(content)
                inner += parsed([token for token in content])
            else:
                inner += parsed(content)
        if name:
            found.append(name)
        found += inner
    return found


def formulas(text):
    blocks = re.findall(r"^```math$(.*?)^```$", text, re.MULTILINE | re.DOTALL)
    lines = re.sub(r"^```math$.*?^```$", "", text, flags=re.MULTILINE | re.DOTALL)
    return blocks + re.findall(r"\$([^$]+)\$", lines)


def sections():
    """Texts by the anchors of their headings, without subsections."""
    parts = re.split(r"^#+ (.+)$", PAGE, flags=re.MULTILINE)[1:]
    return {heading.lower().replace(" ", "-"): text for heading, text in zip(parts[::2], parts[1::2])}


def rows():
    """Rows of the table: the symbols that a row defines, and the section that it names."""
    for line in sections()["symbols"].splitlines():
        if line.startswith("| $"):
            cells = [cell.strip() for cell in line.strip("|").split("|")]
            yield [symbols(formula)[0] for formula in re.findall(r"\$([^$]+)\$", cells[0])], cells


def listed_as(name, table):
    """The symbol of the table that a symbol of a formula is, with another index if need be; or None."""
    base, _, subscript = name.partition("_")
    indices = ["_j", "_n", "_jn"] if subscript and is_index(re.findall(r"\d+|.", subscript)) else []
    return next((known for known in [name, *(base + index for index in indices)] if known in table), None)


def used(text, table):
    """The symbols of the table in a text, and symbols that are not in the table."""
    names = {name for formula in formulas(text) for name in symbols(formula)} - CONSTANTS
    known = {name: listed_as(name, table) for name in names}
    return set(known.values()) - {None}, {name for name in names if known[name] is None}


class Symbols(unittest.TestCase):
    def setUp(self):
        self.table = [name for names, _ in rows() for name in names]
        self.assertGreater(len(self.table), 80)

    def test_of_formulas_are_in_the_table(self):
        for heading, text in sections().items():
            with self.subTest(section=heading):
                self.assertEqual(used(text, self.table)[1], set())

    def test_of_the_table_are_used(self):
        text = "\n".join(text for heading, text in sections().items() if heading != "symbols")
        self.assertEqual(set(self.table) - used(text, self.table)[0], set())

    def test_have_one_row_each(self):
        self.assertEqual(len(self.table), len(set(self.table)), sorted(self.table))

    def test_have_a_meaning_a_unit_and_a_section_that_uses_them(self):
        for names, cells in rows():
            with self.subTest(names=names):
                self.assertEqual(len(cells), 4)
                self.assertTrue(all(cells))
                anchor = re.fullmatch(r"\[[^]]+\]\(#([\w-]+)\)", cells[3])[1]
                self.assertIn(names[0], used(sections()[anchor], self.table)[0])

    def test_are_told_apart(self):
        """Formulas are taken to pieces as a reader does."""
        self.assertEqual(symbols(r"\frac{A'_{jn}}{c\,\Delta x}"), ["A'_jn", "j", "n", "c", r"\Delta x"])
        self.assertEqual(symbols(r"\int_b^{a_0} e^{i\kappa\xi}\,d\xi"),
                         ["b", "a_0", "e", "i", r"\kappa", r"\xi", "d", r"\xi"])
        self.assertEqual(symbols(r"c^\ast + F_{\mathrm{exact}}\,\mathrm{arsinh}\,\mathrm J_0"),
                         ["c^*", r"F_\mathrm{exact}", r"\mathrm J_0"])
        self.assertEqual(used(r"$\beta+\beta_D+p_2$", [r"\beta", "p_j"]), ({r"\beta", "p_j"}, {r"\beta_D"}))


if __name__ == "__main__":
    unittest.main(verbosity=0)
