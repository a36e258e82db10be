# SPDX-License-Identifier: GPL-3.0-or-later
"""Sections of docs/studies.md, which introduce the studies on the page."""
import re

from tables import ReportError, module, read_text

markdown = module("markdown")


def sections_of(path):
    """Markdown of each section, by its heading."""
    parts = re.split(r"^## (.+)$", read_text(path), flags=re.MULTILINE)[1:]
    return dict(zip(parts[::2], parts[1::2]))


def introduction(sections, name, path):
    if not sections.get(name, "").strip():
        raise ReportError(f"{path}: expected a section `## {name}` with text")
    return sections[name]


def typeset(text):
    text = text.replace("-&gt;", "→").replace("A'", "A′")
    text = re.sub(r"(\de)-(?=\d)", "\\1\N{NON-BREAKING HYPHEN}", text)
    return re.sub(r"\^(-?\w)", r"<sup>\1</sup>", text)


def as_html(block, places):
    """A block of Markdown; links to other pages than `places`, ids by target, become plain text."""
    def link(match):
        target = places.get(match[1])
        return f'<a href="#{target}">{match[2]}</a>' if target else match[2]

    html = re.sub(r'<a href="([^"]+)">(.*?)</a>', link, markdown.markdown(block, extensions=["tables"]), flags=re.DOTALL)
    parts = re.split("(<code>.*?</code>|<.*?>)", html, flags=re.DOTALL)
    parts[::2] = map(typeset, parts[::2])
    return re.sub("<table>.*</table>", r'<div class="scrolls" tabindex="0">\g<0></div>', "".join(parts), flags=re.DOTALL) + "\n"

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
        html = as_html(block, places)
        if parts and not named:
            parts[-1] = (parts[-1][0] + html, parts[-1][1])
        else:
            parts.append((html, named if parts else list(dict.fromkeys(images + named))))
    return parts
