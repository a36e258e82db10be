# SPDX-License-Identifier: GPL-3.0-or-later
"""Words and numbers of tables as they are set on the page."""
import math
import re
from html import escape


SIGNS = (("...", "…"), ("+-", "±"), ("->", "→"), ("sqrt(", "√("), (" - ", " − "), ("= -", "= −"), ("A'", "A′"))
LETTERS = {"alpha": "α", "beta": "β", "nu": "ν", "pi": "π"}


def number(value, digits=4):
    if math.isnan(value):
        return "–"
    mantissa, exponential, exponent = f"{value:.{digits}g}".partition("e")
    power = f" · 10<sup>{minus(str(int(exponent)))}</sup>" if exponential else ""
    return minus(mantissa) + power


def minus(text):
    return text.replace("-", "−")


def prose(text):
    """As HTML. Powers are raised, and numbers that were printed with all their digits lose most of them."""
    text = re.sub(r"\b\d+\.\d{7,}(e[-+]?\d+)?", lambda match: f"{float(match[0]):.4g}", text)
    for plain, sign in SIGNS:
        text = text.replace(plain, sign)
    text = re.sub(r"\b(alpha|beta|nu|pi)\b", lambda match: LETTERS[match[1]], text)
    text = escape(text, quote=False)
    text = re.sub(r"\b(\d(?:\.\d+)?)e(-?)\+?0*(\d+)\b", raised_power, text)
    return re.sub(r"\^(-?\w)", lambda match: f"<sup>{minus(match[1])}</sup>", text)


def raised_power(match):
    factor = "" if match[1] == "1" else match[1] + " · "
    return f"{factor}10<sup>{minus(match[2])}{match[3]}</sup>"


def unit(text):
    if text == "1":
        return ""
    times = "&nbsp;·&nbsp;" if text[0].isdigit() else "&nbsp;"
    return times + prose(text.replace("-", " - "))


def words(verdict):
    return verdict.replace("_", " ")
