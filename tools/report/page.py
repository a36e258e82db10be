# SPDX-License-Identifier: GPL-3.0-or-later
"""The page: first screen, all claims, and a section for each study. Its text is page.html."""
import math
import re
from collections import Counter
from pathlib import Path

from faults import WORDS
from prose import parts_of
from tables import GIVEN, NOT_JUDGED, module
from text import number, prose, unit, words

jinja2 = module("jinja2")
Markup = module("markupsafe").Markup

MEANING = {
    "reproduced": "it holds",
    "corrected": "it holds in modified form: another number, cause or range",
    "refuted": "it does not hold",
    "not_comparable": "the thesis does not say enough for a comparison",
    "ours": "a finding of microslip, not a claim of the thesis",
    NOT_JUDGED: "the run has other parameters than the study",
}
# Sides of a figure in its caption; `right` alone may mean correct.
SIDES = re.compile(r"\bLeft\b|\bRight\b|\bleft\b|(?<=\()right(?=\))|(?<=left and )right\b|(?<=[,;] )right\b")
BELOW = {"Left": "Above", "Right": "Below", "left": "above", "right": "below"}


def page(studies, figures, faults):
    """`figures` has the figures of each study, by its name; `faults` pairs each fault with its figure."""
    environment = jinja2.Environment(loader=jinja2.FileSystemLoader(Path(__file__).parent), autoescape=True, trim_blocks=True,
                                     lstrip_blocks=True, undefined=jinja2.StrictUndefined)
    environment.filters.update(caption=caption_of, measured=measured, words=words, number=lambda *value: Markup(number(*value)),
                               prose=lambda text: Markup(prose(text)))
    environment.tests["stated"] = lambda value: not math.isnan(value)
    places = {f"#{study.name}": study.name for study in studies}
    programs = sorted({study.provenance["program"].partition(" (microslip) ")[2] for study in studies})
    return environment.get_template("page.html").render(
        studies=studies, figures=figures, faults=faults, meaning=MEANING, given=GIVEN, dictionary=WORDS, programs=programs,
        compilers=sorted({study.provenance.get("compiler", "unknown") for study in studies}),
        parts={study.name: exhibits(study, figures[study.name], places) for study in studies},
        count_verdicts=lambda claims: Counter(claim.verdict for claim in claims))


def measured(claim):
    return Markup(("below " + number(claim.rounding) if claim.is_rounding else number(claim.measured_value)) + unit(claim.unit))


def caption_of(figure):
    """Where panels may stand one below the other, each name of a side has the word for that beside it."""
    text = prose(figure.caption)
    if figure.has_panels:
        text = SIDES.sub(lambda match: f'<span class="beside">{match[0]}</span><span class="below">{BELOW[match[0]]}</span>', text)
    return Markup(text)


def exhibits(study, figures, places):
    """The text of a study with the figures that each part of it names; then the other figures."""
    by_name = {figure.name: figure for figure in figures}
    parts = [(text, [by_name.pop(name) for name in names])
             for text, names in parts_of(study.introduction, list(by_name), places)]
    return [*parts, ("", list(by_name.values()))]
