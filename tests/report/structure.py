# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds what is wrong with a page, by its text alone."""
import re
from collections import Counter
from html.parser import HTMLParser

VOID = {"meta", "br", "hr", "img", "input", "link", "wbr"}
DRAWN = {"path", "polygon", "use", "text", "rect", "circle"}
NETWORK = re.compile(r"<(?:script|link|img|iframe|object|embed)\b|\bsrc=|@import|url\(|https?://")


class Page(HTMLParser):
    """Ids, links, cards of claims and drawings of figures."""

    def __init__(self, text):
        super().__init__()
        self.open, self.problems = [], []
        self.ids, self.links, self.verdicts, self.cards = Counter(), Counter(), {}, {}
        self.counts, self.drawn = {}, Counter()
        self.feed(text)
        self.close()
        self.problems += [f"<{tag}> has no end" for tag, _ in self.open]

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        if tag not in VOID:
            self.open.append((tag, attributes))
        self.note(tag, attributes)

    def handle_startendtag(self, tag, attributes):
        self.note(tag, dict(attributes))

    def note(self, tag, attributes):
        if "id" in attributes:
            self.ids[attributes["id"]] += 1
        if "href" in attributes:
            self.links[attributes["href"]] += 1
        if tag in DRAWN:
            for _, outer in self.open:
                if "data-figure" in outer:
                    self.drawn[outer["id"]] += 1
        if tag == "article":
            self.verdicts[attributes["id"]] = attributes["class"].removeprefix("claim ")

    def handle_endtag(self, tag):
        if not self.open or self.open[-1][0] != tag:
            self.problems.append(f"</{tag}> ends what is not open")
        else:
            self.open.pop()

    def handle_data(self, data):
        for tag, attributes in self.open:
            if tag == "article":
                self.cards[attributes["id"]] = self.cards.get(attributes["id"], "") + data + " "
        if self.open and "data-count" in self.open[-1][1]:
            self.counts[self.open[-1][1]["data-count"]] = int(data)


def letters(text):
    """And digits: what raised powers and typographic signs leave of a text."""
    return re.sub(r"\W", "", text)


def without_numbers(text):
    return letters(re.sub(r"\d[\d.]*(e[-+]?\d+)?", "", text))


def problems(text, claims):
    """One line for each; `claims` are rows of the tables by the ids of their cards."""
    page = Page(text)
    found = list(page.problems)
    found += [f"the id {id} is there {number} times" for id, number in page.ids.items() if number > 1]
    found += [f"{link} leads nowhere" for link in page.links if link[0] != "#" or link[1:] not in page.ids]
    found += [f"the network is needed: {match[0]}" for match in NETWORK.finditer(text)]
    for id, claim in claims.items():
        if page.verdicts.get(id) != claim["verdict"]:
            found.append(f"{id}: the verdict is {page.verdicts.get(id)}, not {claim['verdict']}")
        if letters(claim["claim"]) not in letters(page.cards.get(id, "")):
            found.append(f"{id}: does not say '{claim['claim']}'")
        if without_numbers(claim["rule"]) not in without_numbers(page.cards.get(id, "")):
            found.append(f"{id}: does not say the rule '{claim['rule']}'")
        if claim["figure"] != "none" and page.drawn[claim["figure"]] < 10:
            found.append(f"{id}: no figure {claim['figure']}")
        if "nan" in re.findall(r"\w+", page.cards.get(id, "")):
            found.append(f"{id}: says nan")
    found += [f"{id} is no claim of a table" for id in page.verdicts if id not in claims]
    in_tables = Counter(claim["verdict"] for claim in claims.values())
    found += [f"{page.counts.get(verdict)} claims are said to be {verdict}, not {in_tables[verdict]}"
              for verdict in {*page.counts, *in_tables} if page.counts.get(verdict) != in_tables[verdict]]
    return found
