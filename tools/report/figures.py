# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of gnuplot, made ready to stand within a page: smaller, with ids of their own, with the greys of the page,
which are others in the dark, and with their panels one below the other for a phone."""
import re
import xml.etree.ElementTree as xml
from dataclasses import dataclass
from html import escape
from pathlib import Path

from panels import panels
from tables import ReportError, read_text

SVG = "{http://www.w3.org/2000/svg}"
HREF = "{http://www.w3.org/1999/xlink}href"
SPACE = "{http://www.w3.org/XML/1998/namespace}space"

# Greys up to these levels are variables of page.css, as text and axes of the page are.
GREYS = ((40, "ink"), (90, "axis"), (165, "middle"), (200, "soft"), (235, "grid"), (255, "paper"))
NAMED = {"black": (0, 0, 0), "gray": (190, 190, 190), "white": (255, 255, 255)}
DEFAULTS = {("stroke-linecap", "butt"), ("stroke-linejoin", "miter")}
PHONE = 640  # pixels, from which on a figure with panels side by side is cut on a phone
DARK_TEXT = 0.25  # luminance of a coloured text in the dark, of contrast 5 there
MANY_COLOURS = 24  # of a colour map; the lines of a figure have at most seven, and greys


@dataclass
class Figure:
    name: str
    caption: str
    svg: str
    width: int
    has_panels: bool  # side by side, which a phone shows one below the other
    is_map: bool  # has colours that are right on white only


def rgb_of(value):
    if value in NAMED:
        return NAMED[value]
    if match := re.fullmatch(r"rgb\( *(\d+), *(\d+), *(\d+)\)", value):
        return tuple(map(int, match.groups()))
    if match := re.fullmatch(r"#(..)(..)(..)", value):
        return tuple(int(part, 16) for part in match.groups())
    return None


def page_colour(value):
    rgb = rgb_of(value)
    if rgb is None:
        return value
    if max(rgb) == min(rgb):
        return next(f"var(--{name})" for level, name in GREYS if rgb[0] <= level)
    return "#%02x%02x%02x" % rgb


def in_the_dark(rgb):
    """The colour of a text, with white added in linear light."""
    linear = [c / 12.92 if c <= 0.03928 else ((c + 0.055) / 1.055) ** 2.4 for c in (level / 255 for level in rgb)]
    luminance = sum(c * weight for c, weight in zip(linear, (0.2126, 0.7152, 0.0722)))
    white = max(0, (DARK_TEXT - luminance) / (1 - luminance))
    return "#%02x%02x%02x" % tuple(round(255 * (1.055 * (c + white * (1 - c)) ** (1 / 2.4) - 0.055)) for c in linear)


def text_style(group):
    """Returns the colours of a group of texts; in the light their colour is the attribute `fill`."""
    rgb = rgb_of(group.get("fill", ""))
    if rgb is None or max(rgb) == min(rgb) or group.find(SVG + "text") is None:
        return ""
    return f' style="fill:light-dark({page_colour(group.get("fill"))},{in_the_dark(rgb)})"'


def is_empty(element):
    return element.tag in (SVG + "g", SVG + "a") and not len(element)


def tidy(element):
    """Drops what shows nothing: titles of plots, filters, empty groups, blanks between elements."""
    in_text = element.tag in (SVG + "text", SVG + "tspan")
    for child in list(element):
        tidy(child)
        if child.tag in (SVG + "title", SVG + "desc", SVG + "filter") or is_empty(child):
            element.remove(child)
        elif not in_text:
            child.tail = None
    if not in_text and element.tag != SVG + "title":
        element.text = None


def attributes(element, prefix):
    for key, value in element.attrib.items():
        if key in ("font-family", "class") or (key, value) in DEFAULTS:
            continue
        if key in ("color", "fill", "stroke"):
            value = page_colour(value)
        elif key == "id":
            value = prefix + value
        elif key == HREF:
            key, value = "href", "#" + prefix + value.lstrip("#")
        elif key == SPACE:
            key = "xml:space"
        yield key, value.strip()


def text_of(element, prefix):
    tag = element.tag.removeprefix(SVG)
    content = escape(element.text or "", quote=False) + "".join(text_of(child, prefix) for child in element)
    named = "".join(f' {key}="{escape(value)}"' for key, value in attributes(element, prefix)) + text_style(element)
    body = f"<{tag}{named}>{content}</{tag}>" if content else f"<{tag}{named}/>"
    return body + escape(element.tail or "", quote=False)


def round_places(root):
    """To a tenth of a pixel, which halves the length of most paths."""
    for element in root.iter():
        for key in {"d", "points", "transform"}.intersection(element.keys()):
            element.set(key, re.sub(r"\d+\.\d+", lambda number: f"{float(number[0]):.1f}".removesuffix(".0"),
                                    element.get(key)))


def used_ids(root):
    return {use.get(HREF).lstrip("#") for use in root.iter(SVG + "use")}


def read_figure(path, prefix):
    """A figure whose ids begin with the prefix."""
    try:
        root = xml.fromstring(read_text(path))
    except xml.ParseError as error:
        raise ReportError(f"{path}: not a whole figure: {error}") from None
    caption = root.findtext(SVG + "title", "").strip()
    if not caption or caption == "Gnuplot":
        raise ReportError(f"{path}: expected a title that says what it shows, as plots/draw.sh writes it")
    canvas = root.find(SVG + "g")
    definitions = root.find(f"{SVG}g/{SVG}defs")
    size = re.fullmatch(r"0 0 (\d+) (\d+)", root.get("viewBox", ""))
    if definitions is None or not size:
        raise ReportError(f"{path}: expected a figure of gnuplot, with marks and a viewBox")
    tidy(root)
    background = canvas.find(SVG + "rect")
    if background is not None:
        canvas.remove(background)
    for child in canvas:
        if child is not definitions:  # whose marks are of the size of one
            round_places(child)
    used = used_ids(root)
    for definition in list(definitions):
        if definition.get("id") not in used:
            definitions.remove(definition)
    for group in root.iter(SVG + "g"):  # canvas and plots, which nothing refers to
        group.attrib.pop("id", None)
    colours = {element.get(key) for element in root.iter() for key in ("color", "fill", "stroke")}
    ranges = panels(canvas, int(size[1])) if int(size[1]) > PHONE else []
    svg = drawing(text_of(canvas, prefix), size[0], ranges, f"{prefix}all", caption)
    return Figure(Path(path).stem, caption, svg, int(size[1]), len(ranges) > 1, len(colours) > MANY_COLOURS)


def drawing(canvas, box, ranges, id, caption):
    """The figure, and for a phone its panels, which show parts of the same canvas."""
    label = f'role="img" aria-label="{escape(caption)}"'
    if len(ranges) < 2:
        return f'<svg viewBox="{box}" {label}>{canvas}</svg>'
    height = box.split()[3]
    parts = "".join(f'<svg viewBox="{left:.1f} 0 {right - left:.1f} {height}"><use href="#{id}"/></svg>'
                    for left, right in ranges)
    return (f'<svg class="whole" viewBox="{box}" {label}><g id="{id}">{canvas}</g></svg>'
            f'<div class="panels" {label}>{parts}</div>')


def shows_measured_times(script):
    """Whether a script of plots draws measured times, which differ from run to run, itself or by a script that it loads."""
    text = script.read_text(encoding="utf-8")
    loaded = [script.parent / name for name in re.findall(r'^load scripts\."/(\w+\.gpi)"', text, re.MULTILINE)]
    return "_timing.tsv" in text or any(map(shows_measured_times, loaded))
