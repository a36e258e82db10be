#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers of the article, from the tables of results. Usage: article_numbers.py RESULTS ARTICLE.tex [OUTPUT.tex]

The article writes \\n{PLACE|FORMAT} wherever it has a number. A place is a cell of a table,
  STUDY/TABLE[column=value; column has text]column
a parameter of a study, STUDY:key, or the number of claims, claims[verdict=reproduced]. Before it may stand max, min,
median, count or abs, where several rows or values meet the conditions; "A over B" is a quotient. A format is a number of
significant digits, d for a whole number, p2 for two digits of a percentage, b for the bound of a number that is nothing but
rounding, w for words.

The output defines all of them, and \\claims and \\figuretable. A number typed by hand is an error; so is a figure that
is not a study's. Without OUTPUT the article is only checked. Errors go to stderr, one a line, with exit status 1."""
import functools
import math
import re
import statistics
import sys
from pathlib import Path

sys.dont_write_bytecode = True  # the folder holds sources only
sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "report"))
from figures import shows_measured_times
from tables import ROOT, ReportError, questions, read_study, read_table, run

BRACED = r"\{((?:[^{}]|\{[^{}]*\})*)\}"
# Places in the thesis: Fig. 6.9, Figs. 7.1 and 7.2, chapter 9, (B.30), Example 5.8.
THESIS_PLACE = r"(?:(?:Figs?\.|[Cc]hapters?|sections?|appendix|equations?|page)[~ ])?\(?[A-C\d][.\d]*\)?" \
               r"(?:(?:--|, | and |, and )\(?[A-C\d][.\d]*\)?)*"
ALLOWED_WORDS = r"\b[23]D\b|C\+\+20|C99"
# Counts up to three are words of any text; what is measured is not written out.
WRITTEN = r"\b(?:four|five|six|seven|eight|nine|ten|eleven|twelve|\w+teen|twenty|thirty|forty|fifty|sixty|seventy|eighty|ninety|" \
          r"dozens?|hundred\w*|thousand\w*|million\w*|percent|quarters?|fourths?|fifths?|sixths?|eighths?|tenths?)\b"
SILENT = ("n", "ref", "eqref", "label", "cite", "bibliography", "vspace", "hspace", "setlength",
          "input")


def blanked(text, pattern, flags=re.DOTALL):
    """The text with blanks in the place of what matches; lines stay where they are."""
    return re.sub(pattern, lambda match: re.sub(r"[^\n]", " ", match[0]), text, flags=flags)


def without_comments(text):
    return blanked(text, r"(?<!\\)%[^\n]*", 0)


def typed_numbers(text):
    """(line, what is wrong) for each number that is typed by hand."""
    text = without_comments(text)
    found = []

    def report(position, what):
        found.append((text.count("\n", 0, position) + 1, what))

    for match in re.finditer(r"\\thesis" + BRACED, text):
        if not re.fullmatch(THESIS_PLACE, " ".join(match[1].split())):
            report(match.start(), f"'{match[0]}': expected a place in the thesis, as Fig.~6.9 or chapter~9")
    formulas = r"\\formula" + BRACED + r"|\\begin\{displayed\}(.*?)\\end\{displayed\}"
    for match in re.finditer(formulas, text, re.DOTALL):
        for number in re.findall(r"\d[\d.]*", match[1] or match[2] or ""):
            if len(number) > 1:
                report(match.start(), f"'{number}' in a formula: expected constants of one digit")
    for pattern in (r"\\thesis" + BRACED, formulas, r"\\(?:" + "|".join(SILENT) + r")\b(?:\[[^]]*\])?(?:" + BRACED + ")+",
                    r"\\(?:begin|end)\{\w+\*?\}(?:\{[^{}]*(?:\{[^{}]*\}[^{}]*)*\})?",
                    r"\\multicolumn\{\d\}", ALLOWED_WORDS):
        text = blanked(text, pattern)
    for match in re.finditer(r"\S*\d\S*|" + WRITTEN, text, re.IGNORECASE):
        report(match.start(), f"'{match[0]}': a number typed by hand; expected \\n{{...}} from a table of results")
    return found


class Results:
    """Tables and claims of the studies, each read once."""

    def __init__(self, folder):
        self.folder = Path(folder)

    @functools.lru_cache(maxsize=None)
    def table(self, study, name):
        if study not in questions():
            raise ReportError(f"no study '{study}'; expected one of {', '.join(questions())}")
        return read_table(self.folder / study / f"{name}.tsv")

    @functools.lru_cache(maxsize=None)
    def claims(self):
        return [claim for study in questions() for claim in read_study(self.folder, study).claims]


def same(cell, wanted):
    try:
        return math.isclose(float(cell), float(wanted), rel_tol=1e-9)
    except ValueError:
        return cell == wanted


def meets(row, condition):
    for relation in (" has ", "!=", "="):
        column, found, wanted = condition.partition(relation)
        if found:
            cell, wanted = row[column.strip()], wanted.strip()
            return wanted in cell if relation == " has " else same(cell, wanted) == (relation == "=")
    raise ReportError(f"condition '{condition}': expected column=value, column!=value or column has text")


def cells(results, place):
    """Cells at a place, as text, and the bound up to which the first one is nothing but rounding."""
    if match := re.fullmatch(r"(\w+):([\w.]+)", place):
        names = sorted((results.folder / match[1]).glob("*.tsv"))
        parameters = dict(results.table(match[1], names[0].stem).parameters) if names else {}
        if match[2] not in parameters:
            raise ReportError(f"{match[1]} has no parameter {match[2]}")
        return parameters[match[2]].split(), None
    match = re.fullmatch(r"(?:(\w+)/)?(\w+)(?:\[(.*)\])?(\w*)", place)
    if not match:
        raise ReportError(f"'{place}': expected STUDY/TABLE[conditions]column or STUDY:key")
    study, name, conditions, column = match.groups()
    conditions = [part for part in (conditions or "").split(";") if part.strip()]
    if study is None:
        rows = [vars(claim) for claim in results.claims()]
        column, bounds = column or "claim", {}
    else:
        table = results.table(study, name)
        names = [entry[0] for entry in table.columns]
        rows = [dict(zip(names, row)) for row in table.rows]
        column, bounds = column or names[0], table.rounding
    try:
        kept = [row for row in rows if all(meets(row, condition) for condition in conditions)]
        first = next(iter(rows[0])) if rows else ""
        bound = bounds.get((column, kept[0][first]), bounds.get((column, None))) if kept else None
        return [row[column] for row in kept], bound
    except KeyError as error:
        raise ReportError(f"'{place}': no column {error}") from None


REDUCTIONS = {"max": max, "min": min, "median": statistics.median}


def value_of(results, operand):
    """The value at a place with its reduction, text or number, and its bound of rounding."""
    word, _, rest = operand.partition(" ")
    if word not in (*REDUCTIONS, "count", "abs"):
        word, rest = "", operand
    found, bound = cells(results, rest.strip())
    if word == "count":
        return len(found), None
    if word in REDUCTIONS:
        if not found:
            raise ReportError(f"'{operand}': nothing meets the conditions")
        return REDUCTIONS[word](float(cell) for cell in found), bound
    if len(found) != 1:
        raise ReportError(f"'{operand}': expected one value, found {len(found)}")
    return (abs(float(found[0])) if word == "abs" else found[0]), bound


def shown(value, digits):
    """A number with significant digits, as TeX."""
    value = float(value)
    if not math.isfinite(value):
        raise ReportError("not a finite number")
    mantissa, exponent = f"{value:.{digits - 1}e}".split("e")
    exponent = int(exponent)
    if -4 < exponent < 5:
        return f"\\ensuremath{{{float(f'{mantissa}e{exponent}'):.{max(0, digits - 1 - exponent)}f}}}"
    factor = {"1": "", "-1": "-"}.get(mantissa, f"{mantissa}\\times")
    return f"\\ensuremath{{{factor}10^{{{exponent}}}}}"


def formatted(value, form, bound):
    if form == "w":
        return in_tex(str(value))
    if form == "d":
        if float(value) != round(float(value)):
            raise ReportError(f"{value} is no whole number")
        return f"{round(float(value))}"
    if form == "b":
        if bound is None or abs(float(value)) > bound:
            raise ReportError(f"{value} is more than rounding")
        return f"\\ensuremath{{10^{{{math.ceil(math.log10(bound) - 1e-9)}}}}}"
    if match := re.fullmatch(r"(p?)([1-9])", form):
        return shown(100 * float(value), int(match[2])) + "\\,\\%" if match[1] else shown(value, int(form))
    raise ReportError(f"format '{form}': expected a digit, d, p with a digit, b or w")


def number(results, text):
    place, bar, form = text.rpartition("|")
    if not bar:
        raise ReportError("expected PLACE|FORMAT")
    above, over, below = place.partition(" over ")
    value, bound = value_of(results, above.strip())
    if over:
        value, bound = float(value) / float(value_of(results, below.strip())[0]), None
    return formatted(value, form.strip(), bound)


def in_tex(text):
    """Text of a table, for TeX."""
    text = text.replace("\\", "\\textbackslash ")
    text = re.sub(r"([%&#_{}$])", r"\\\1", text)
    text = re.sub(r"\^(-?\w+)", r"$^{\1}$", text)
    for plain, tex in (("->", r"$\to$"), ("<=", r"$\le$"), ("<", "$<$"), (">", "$>$"), ("...", r"\ldots{}")):
        text = text.replace(plain, tex)
    return text


def value_in_table(claim):
    if math.isnan(claim.measured_value):
        return "--"
    if claim.is_rounding:
        return "rounding"
    return shown(claim.measured_value, 3)


def claims_of_the_thesis(results):
    rows = []
    for claim in results.claims():
        if claim.section == "none" or claim.verdict == "ours":
            continue
        given = "--" if math.isnan(claim.thesis_value) else f"\\ensuremath{{{claim.thesis_value:.5g}}}"
        rows.append(f"{in_tex(claim.section)} & {in_tex(claim.claim)} & {given} & {value_in_table(claim)} & "
                    f"{in_tex(claim.verdict.replace('_', ' '))} \\\\")
    return "\n".join(rows)


def figures_of_the_thesis():
    """A row for each script that says which figure of the thesis it shows, with the first sentence of its comment."""
    rows = []
    for script in ROOT.glob("plots/*_*.gp"):
        comment = " ".join(line.lstrip("# ") for line in re.match(r"(?:#.*\n)+", script.read_text(encoding="utf-8"))[0].splitlines())
        if match := re.search(r"[Tt]hesis (Figs?\. \d+\.\d+(?: and \d+\.\d+)*|chapter \d+)", comment):
            place = [int(part) for part in re.findall(r"\d+", match[1])]
            without = re.sub(r" \((?:thesis [^)]*|above|below|left|right)\)", "", comment)
            shows = re.match(r"(.+?)(?:[.;:] |\.?$)", without)[1]
            rows.append((place, f"{match[1]} & {in_tex(shows)} & \\texttt{{{in_tex(script.stem)}}} \\\\"))
    return "\n".join(row for _, row in sorted(rows))


def definitions(results, keys):
    lines, errors = [], []
    for key in keys:
        try:
            lines.append(f"\\expandafter\\def\\csname n:{key}\\endcsname{{{number(results, key)}}}")
        except (ReportError, ValueError, ZeroDivisionError) as error:
            errors.append(f"\\n{{{key}}}: {error}")
    lines.append(f"\\newcommand\\claims{{{claims_of_the_thesis(results)}}}")
    lines.append(f"\\newcommand\\figuretable{{{figures_of_the_thesis()}}}")
    return "\n".join(lines) + "\n", errors


def checked(text, name):
    errors = [f"{name}:{line}: {what}" for line, what in typed_numbers(text)]
    for figure in figures_of(text):
        script = ROOT / f"plots/{figure}.gp"
        if not script.exists():
            errors.append(f"{name}: figure {figure}: expected one of plots/*.gp")
        elif shows_measured_times(script):
            errors.append(f"{name}: figure {figure}: expected no measured times, which differ from run to run")
    if "\\includegraphics" in text:
        errors.append(f"{name}: expected figures by \\studyfigure alone")
    return errors


def figures_of(text):
    return re.findall(r"\\studyfigure\{(\w+)\}", without_comments(text))


def keys_of(text):
    """Returns what stands in \\n{...}, as TeX reads it, each once."""
    keys = (" ".join(key.split()) for key in re.findall(r"\\n\{([^{}]*)\}", without_comments(text)))
    return list(dict.fromkeys(keys))


def main(results, article, output=None):
    text = Path(article).read_text(encoding="utf-8")
    errors = checked(text, Path(article).name)
    defined, more = definitions(Results(results), keys_of(text)) if output else ("", [])
    if errors + more:
        raise ReportError("\narticle: ".join(errors + more))
    if output:
        Path(output).write_text(defined, encoding="utf-8")


if __name__ == "__main__":
    run("article", "RESULTS ARTICLE.tex [OUTPUT.tex]", main, (2, 3))
