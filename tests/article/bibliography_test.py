#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The bibliography: what the article cites and no more, complete entries, well-formed DOIs, and CITATION.cff in agreement
with it. Usage: bibliography_test.py"""
import re
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
ARTICLE = (ROOT / "article/article.tex").read_text(encoding="utf-8")
BIBLIOGRAPHY = (ROOT / "article/references.bib").read_text(encoding="utf-8")
CITATION = (ROOT / "CITATION.cff").read_text(encoding="utf-8")
REQUIRED = {"article": ("author", "title", "journal", "volume", "pages", "year"), "book": ("author", "title", "publisher", "year"),
            "inproceedings": ("author", "title", "booktitle", "year"), "mastersthesis": ("author", "title", "school", "year"),
            "techreport": ("author", "title", "institution", "number", "year")}
DOI = r"10\.\d{4,9}/[-._;()/:A-Za-z0-9]*[A-Za-z0-9)]"
TYPES = {"thesis": "mastersthesis", "book": "book", "report": "techreport", "conference-paper": "inproceedings", "article": "article"}


def braced(text, start):
    """The text in the braces that open at start."""
    depth = 0
    for end in range(start, len(text)):
        depth += (text[end] == "{") - (text[end] == "}")
        if depth == 0:
            return text[start + 1:end]
    raise ValueError(f"open brace at {start}")


def entries(text):
    """(type, key, fields) of each entry."""
    for match in re.finditer(r"@(\w+)\{", text):
        key, _, rest = braced(text, match.end() - 1).partition(",")
        fields = {field[1]: " ".join(braced(rest, field.end() - 1).split()) for field in re.finditer(r"(\w+) = \{", rest)}
        yield match[1], key.strip(), fields


def plain(text):
    return re.sub(r"[{}]", "", text).casefold()


def references():
    """References of CITATION.cff, each as the text of its lines."""
    return re.split(r"^  - ", CITATION.partition("\nreferences:\n")[2], flags=re.MULTILINE)[1:]


def value(reference, key):
    found = re.search(rf"^\s*{key}: (.*)$", reference, re.MULTILINE)
    return found[1].strip("\"'") if found else None


class Bibliography(unittest.TestCase):
    entries = list(entries(BIBLIOGRAPHY))

    def test_has_each_key_once(self):
        keys = [key for _, key, _ in self.entries]
        self.assertEqual(len(keys), BIBLIOGRAPHY.count("@"))
        self.assertEqual(sorted(keys), sorted(set(keys)))

    def test_is_what_the_article_cites(self):
        cited = {key.strip() for keys in re.findall(r"\\cite\{([^}]*)\}", ARTICLE) for key in keys.split(",")}
        self.assertEqual(cited, {key for _, key, _ in self.entries})

    def test_has_all_that_names_a_source(self):
        for kind, key, fields in self.entries:
            with self.subTest(key=key):
                self.assertEqual([field for field in REQUIRED[kind] if not fields.get(field)], [])
                self.assertRegex(fields["year"], r"^(18|19|20)\d\d$")
                self.assertRegex(fields.get("pages", "1"), r"^\d+(--\d+)?$")

    def test_has_well_formed_dois(self):
        dois = [fields["doi"] for _, _, fields in self.entries if "doi" in fields]
        self.assertGreaterEqual(len(dois), 3)
        self.assertEqual(len(dois), len(set(dois)))
        for doi in dois:
            self.assertRegex(doi, rf"^{DOI}$")

    def test_agrees_with_the_citation_file(self):
        by_title = {plain(fields["title"]): (kind, fields) for kind, _, fields in self.entries}
        self.assertGreaterEqual(len(references()), 3)
        for reference in references():
            title = value(reference, "title")
            with self.subTest(title=title):
                kind, fields = by_title[plain(title)]
                self.assertEqual(TYPES[value(reference, "type")], kind)
                self.assertEqual(value(reference, "year"), fields["year"])
                self.assertEqual(value(reference, "doi"), fields.get("doi"))
                families = re.findall(r"family-names: (.*)", reference)
                self.assertEqual([author.partition(",")[0] for author in fields["author"].split(" and ")], families)


if __name__ == "__main__":
    unittest.main(verbosity=0)
