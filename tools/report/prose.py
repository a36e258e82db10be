# SPDX-License-Identifier: GPL-3.0-or-later
"""Sections of docs/studies.md, which introduce the studies on the page."""
import re
from html import escape

from tables import ReportError, read_text


def sections_of(path):
    """Markdown of each section, by its heading."""
    parts = re.split(r"^## (.+)$", read_text(path), flags=re.MULTILINE)[1:]
    return dict(zip(parts[::2], parts[1::2]))


def introduction(sections, name, path):
    if not sections.get(name, "").strip():
        raise ReportError(f"{path}: expected a section `## {name}` with text")
    return sections[name]


def in_line(text, places):
    """Code, emphasis and links; links to other pages than `places`, ids by target, become plain text."""
    codes = []

    def keep(match):
        codes.append(f"<code>{escape(match[1], quote=False)}</code>")
        return f"\0{len(codes) - 1}\0"

    def link(match):
        target = places.get(match[2])
        return f'<a href="#{target}">{match[1]}</a>' if target else match[1]

    text = escape(re.sub(r"`([^`]+)`", keep, text).replace("->", "→").replace("A'", "A′"), quote=False)
    text = text.replace(r"\*", "\1")
    text = re.sub(r"!?\[([^\]]*)\]\(([^)\s]+)\)", link, text)
    text = re.sub(r"\*\*(.+?)\*\*", r"<strong>\1</strong>", text, flags=re.DOTALL)
    text = re.sub(r"\*(.+?)\*", r"<em>\1</em>", text, flags=re.DOTALL)
    text = text.replace("\1", "*")
    text = re.sub(r"(\de)-(?=\d)", "\\1\N{NON-BREAKING HYPHEN}", text)
    text = re.sub(r"\^(-?\w)", r"<sup>\1</sup>", text)
    return re.sub("\0(\\d+)\0", lambda match: codes[int(match[1])], text)


def table(lines, places):
    rows = [[cell.strip() for cell in line.strip("|").split("|")] for line in lines]
    head = "".join(f"<th>{in_line(cell, places)}</th>" for cell in rows[0])
    body = "".join("<tr>" + "".join(f"<td>{in_line(cell, places)}</td>" for cell in row) + "</tr>" for row in rows[2:])
    return f'<div class="scrolls" tabindex="0"><table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table></div>\n'


def block_as_html(block, places):
    if block.startswith("|"):
        return table(block.splitlines(), places)
    if block.startswith("- "):
        items = re.split(r"^- ", block, flags=re.MULTILINE)[1:]
        return "<ul>" + "".join(f"<li>{in_line(item.strip(), places)}</li>" for item in items) + "</ul>\n"
    return f"<p>{in_line(block, places)}</p>\n"


def named_in(block, figures):
    """Figures whose files a block names, `carter_traction.svg` or, by the end of the name, `..._linear.svg`."""
    names = re.findall(r"`(?:\.\.\.)?(\w+)\.svg`", block)
    found = [next((figure for figure in figures if figure.endswith(name)), None) for name in names]
    return [figure for figure in dict.fromkeys(found) if figure]


def parts_of(markdown, figures, places):
    """Pairs of text as HTML and the figures that it names. Text that names none goes on with the text before.
    Images are left out, as the page has the figures themselves: they follow the first text."""
    images = [figure for figure in re.findall(r"^!\[.*?\]\((\w+)\.svg\)$", markdown, re.MULTILINE) if figure in figures]
    text = re.sub(r"^!\[.*?\)$", "", markdown, flags=re.MULTILINE).strip()
    parts = []
    for block in (block.strip() for block in re.split(r"\n\s*\n", text)):
        named = [name for name in named_in(block, figures) if all(name not in earlier for _, earlier in parts)]
        html = block_as_html(block, places)
        if parts and not named:
            parts[-1] = (parts[-1][0] + html, parts[-1][1])
        else:
            parts.append((html, named if parts else list(dict.fromkeys(images + named))))
    return parts
