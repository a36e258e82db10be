# SPDX-License-Identifier: GPL-3.0-or-later
"""The page: first screen, all claims, and a section for each study."""
import math
import re
from collections import Counter
from html import escape
from pathlib import Path

from faults import WORDS
from prose import parts_of
from tables import GIVEN, NOT_JUDGED, VERDICTS
from text import number, prose, unit, words

THESIS = "N. van der Wekken, <cite>Improving CONTACT for varying timesteps</cite> (TU Delft, 2017)"
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
WIDE = 800  # pixels, of figures with panels side by side


def count(number_of, noun):
    return f"{number_of} {noun}" + ("" if number_of == 1 else "s")


def verdict_mark(verdict):
    return f'<span class="verdict {verdict}">{words(verdict)}</span>'


def page(studies, figures, faults):
    """`figures` has the figures of each study, by its name; `faults` pairs each fault with its figure."""
    claims = [claim for study in studies for claim in study.claims]
    judged = sum(claim.verdict not in ("ours", NOT_JUDGED) for claim in claims)
    places = {f"#{study.name}": study.name for study in studies}
    sections = "\n".join(section(study, figures[study.name], places) for study in studies)
    style = Path(__file__).with_name("page.css").read_text(encoding="utf-8")
    return f"""<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>microslip: {count(len(claims), "claim")}, held against measurements</title>
<style>
{style}</style>
</head>
<body>
<header>
<h1>Rolling contact for any time step</h1>
<p class="lead">Boundary-element codes for rolling contact develop oscillations when a time step is much shorter than an
element. {THESIS}, describes them. <strong>microslip</strong> repeats the computations of the thesis, judges
{judged} of its claims by measurements, and cures four faults of its scheme. Every number on this page stands in a table,
and every figure is drawn from one.</p>
</header>
<div class="first">
{fault_block(1, *faults[0])}
<div>{summary(studies, claims)}</div>
</div>
<div class="faults">
{"".join(fault_block(i, *fault) for i, fault in enumerate(faults[1:], 2))}
{word_list()}
</div>
<h2 id="claims">All claims</h2>
{all_claims(studies)}
{sections}
<footer>{revisions(studies)}</footer>
</body>
</html>
"""


def fault_block(i, fault, figure):
    """The first one is the headline."""
    id = "headline" if i == 1 else f"fault-{i}"
    return f"""<div class="fault">
<h2>{i}. {prose(fault.name)}</h2>
{figure_block(figure, id)}<p><b>Cause.</b> {prose(fault.cause)}</p>
<p><b>Cure.</b> {prose(fault.cure)} <a href="#{fault.study}">Study {fault.study}</a></p>
</div>
"""


def word_list():
    rows = "".join(f"<div><dt>{prose(word)}</dt><dd>{prose(meaning)}</dd></div>" for word, meaning in WORDS)
    return f"""<div class="fault">
<h2>Words and signs</h2>
<dl class="words">{rows}</dl>
<p>Lengths are in mm, forces in N per mm of width. Rolling is to the right. Each claim has a rule with a tolerance, and the
verdict follows from the measured value by this rule.</p>
</div>
"""


def summary(studies, claims):
    counts = Counter(claim.verdict for claim in claims)
    verdicts = [verdict for verdict in VERDICTS if verdict != NOT_JUDGED or counts[verdict]]
    bar = "".join(f'<span class="{verdict}" style="flex-grow:{counts[verdict]}"></span>'
                  for verdict in verdicts if counts[verdict])
    totals = "".join(f'<li class="{verdict}"><b data-count="{verdict}">{counts[verdict]}</b> '
                     f"<span>{words(verdict)}: {MEANING[verdict]}</span></li>" for verdict in verdicts)
    heads = "".join(f'<th class="count">{words(verdict)}</th>' for verdict in GIVEN)
    rows = "".join(summary_row(study) for study in studies)
    return f"""<div class="bar" aria-hidden="true">{bar}</div>
<ul class="totals">{totals}</ul>
<table class="summary"><thead><tr><th>study</th>{heads}</tr></thead><tbody>{rows}</tbody></table>
<p class="next"><a href="#claims">All claims</a></p>"""


def summary_row(study):
    counts = Counter(claim.verdict for claim in study.claims)
    cells = "".join(f'<td class="count {verdict}">{counts[verdict] or "<i>·</i>"}</td>' for verdict in GIVEN)
    if study.not_judged:
        cells = f'<td class="count {NOT_JUDGED}" colspan="{len(GIVEN)}">{counts[NOT_JUDGED]} not judged</td>'
    return f'<tr><td><a href="#{study.name}">{study.name}</a></td>{cells}</tr>'


def all_claims(studies):
    groups = "".join(
        f'<tbody><tr class="group"><th colspan="4"><a href="#{study.name}">{study.name}</a> '
        f"{prose(study.question)}{not_judged(study)}</th></tr>" + "".join(claim_row(claim) for claim in study.claims) + "</tbody>"
        for study in studies)
    return f"""<table class="claims"><thead><tr><th>claim</th><th>measured</th><th>rule</th>
<th>verdict</th></tr></thead>{groups}</table>"""


def not_judged(study):
    return f'<span class="unjudged">Not judged: {escape(study.not_judged)}.</span>' if study.not_judged else ""


def values(claim):
    """Returns the value of the thesis, the measured value, and the tolerance."""
    tolerance = "" if math.isnan(claim.tolerance) else "±" + number(claim.tolerance)
    rounding = 0 < claim.rounding >= abs(claim.measured_value)
    measured = "below " + number(claim.rounding) if rounding else number(claim.measured_value)
    return number(claim.thesis_value, 6), measured + unit(claim.unit), tolerance


def origin(claim):
    """Section of the thesis, and its value if it has one."""
    if claim.section == "none":
        return "microslip"
    value = "" if math.isnan(claim.thesis_value) else f": {number(claim.thesis_value, 6)}"
    return f"thesis §&nbsp;{escape(claim.section)}{value}"


def claim_row(claim):
    measured = values(claim)[1]
    return (f'<tr><td class="statement"><a href="#{claim.id}">{prose(claim.claim)}</a> <small>{origin(claim)}</small></td>'
            f'<td class="measured"><b>{measured}</b>: {prose(claim.note)}</td><td class="rule">{prose(claim.rule)}</td>'
            f"<td>{verdict_mark(claim.verdict)}</td></tr>\n")


def claim_card(claim):
    thesis, measured, tolerance = values(claim)
    tolerated = f"<div><dt>tolerance</dt><dd>{tolerance}</dd></div>" if tolerance else ""
    link = f' <a href="#{claim.figure}">Figure</a>' if claim.figure != "none" else ""
    source = "no claim of the thesis" if claim.section == "none" else f"thesis §&nbsp;{escape(claim.section)}"
    said = f"<div><dt>{source}</dt><dd>{thesis}</dd></div>"
    return f"""<article id="{claim.id}" class="claim {claim.verdict}">
<h4>{prose(claim.claim)}</h4>
<dl>{said}<div><dt>measured</dt><dd>{measured}</dd></div>
{tolerated}<div><dt>verdict</dt><dd>{verdict_mark(claim.verdict)}</dd></div></dl>
<p>Measured: {prose(claim.note)}.{link}</p>
<p class="rule">Rule: {prose(claim.rule)}.</p>
</article>
"""


def caption_of(figure):
    """Where panels may stand one below the other, each name of a side has the word for that beside it."""
    text = prose(figure.caption)
    if not figure.has_panels:
        return text
    return SIDES.sub(lambda match: f'<span class="beside">{match[0]}</span><span class="below">{BELOW[match[0]]}</span>', text)


def figure_block(figure, id):
    kind = (" map" if figure.is_map else "") + (" wide" if figure.width > WIDE else "")
    return (f'<figure id="{id}" class="{kind.strip()}" data-figure="{figure.name}" style="max-width:{figure.width}px">'
            f'<div class="drawing">{figure.svg}</div>'
            f"<figcaption>{caption_of(figure)} <code>{figure.name}</code></figcaption></figure>\n")


def exhibit(study, figure):
    """A figure beside the claims that it shows."""
    cards = "".join(claim_card(claim) for claim in study.claims if claim.figure == figure.name)
    wide = " wide" if figure.width > WIDE or not cards else ""
    beside = f'<div class="cards">{cards}</div>' if cards else ""
    return f'<div class="exhibit{wide}">{figure_block(figure, figure.name)}{beside}</div>\n'


def gallery(study, figures):
    """Figures with claims are exhibits; the others stand side by side."""
    shown = {claim.figure for claim in study.claims}
    others = "".join(figure_block(figure, figure.name) for figure in figures if figure.name not in shown)
    return ("".join(exhibit(study, figure) for figure in figures if figure.name in shown)
            + (f'<div class="gallery">{others}</div>\n' if others else ""))


def exhibits(study, figures, places):
    """The text of a study, after each part the figures that it names; then the other figures, and claims without one."""
    by_name = {figure.name: figure for figure in figures}
    parts = []
    for text, names in parts_of(study.introduction, list(by_name), places):
        parts.append(f'<div class="prose">\n{text}</div>\n' + gallery(study, [by_name.pop(name) for name in names]))
    parts.append(gallery(study, by_name.values()))
    unseen = "".join(claim_card(claim) for claim in study.claims if claim.figure == "none")
    if unseen:
        parts.append(f'<div class="exhibit wide"><div class="cards">{unseen}</div></div>\n')
    return "".join(parts)


def section(study, figures, places):
    commands = [f"make {study.name}", study.command]
    commands += [f"plots/draw.sh plots/{figure.name}.gp results/{study.name} results/figures/{figure.name}.svg"
                 for figure in figures]
    parameters = "".join(f"<tr><td><code>{escape(key)}</code></td><td>{escape(value)}</td></tr>"
                         for key, value in study.parameters)
    tables = "".join(table_block(table) for table in study.tables)
    return f"""<section id="{study.name}">
<h2>{study.name}</h2>
<p class="question">{prose(study.question)}</p>{not_judged(study)}
{exhibits(study, figures, places)}
<h3>Made by</h3>
<pre tabindex="0"><code>{escape(chr(10).join(commands))}</code></pre>
<details><summary>{count(len(study.parameters), "parameter")}</summary>
<table class="parameters">{parameters}</table></details>
<details class="tables"><summary>{count(len(study.tables), "table")}</summary>{tables}</details>
<p class="provenance">{escape(study.provenance["program"])}; {escape(study.provenance["date"])},
{escape(study.provenance["wall time"])}. <a href="#claims">All claims</a></p>
</section>
"""


def table_block(table):
    columns = "".join(f"<tr><td><code>{escape(name)}</code></td><td>{prose(unit_) if unit_ != '1' else ''}</td>"
                      f"<td>{prose(meaning)}</td></tr>" for name, unit_, meaning in table.columns)
    return (f"<h4><code>{table.name}.tsv</code> {prose(table.description)}, {count(len(table.rows), 'row')}</h4>"
            f'<table class="columns">{columns}</table>\n')


def revisions(studies):
    programs = sorted({study.provenance["program"].partition(" (microslip) ")[2] for study in studies})
    compilers = sorted({study.provenance.get("compiler", "unknown") for study in studies})
    return f"microslip {escape('; '.join(programs))}. g++ {escape(', '.join(compilers))}."
