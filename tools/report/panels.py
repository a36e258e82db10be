# SPDX-License-Identifier: GPL-3.0-or-later
"""Where a figure of gnuplot may be cut into panels side by side, which a phone shows one below the other."""
import re

SVG = "{http://www.w3.org/2000/svg}"
LETTER = 0.56  # width of a letter over the size of the font
WIDE = 0.2  # a mark that is so wide, over the width of the figure, belongs to the frame or the grid of a panel


def numbers(text):
    return [float(number) for number in re.findall(r"-?\d+(?:\.\d+)?", text)]


def text_extent(group, text):
    """From left to right, and whether the text may label what is on its left."""
    transform = numbers(group.get("transform", ""))
    size, anchor = float(group.get("font-size", 14)), group.get("text-anchor", "start")
    left, turned = transform[0], len(transform) > 2
    width = size if turned else LETTER * size * len("".join(text.itertext()))
    if turned:
        return left - 1.3 * size, left + 0.35 * size, False  # from a raised exponent to the descent
    left -= {"start": 0, "middle": width / 2, "end": width}[anchor]
    return left, left + width, anchor == "start"


def extents(canvas):
    for group in canvas.iter(SVG + "g"):
        for mark in group:
            if mark.tag == SVG + "text" and "".join(mark.itertext()).strip():
                yield text_extent(group, mark)
            elif mark.tag == SVG + "use":
                left = numbers(mark.get("transform", ""))[0]
                yield left - 5, left + 5, True
            elif mark.tag in (SVG + "path", SVG + "polygon"):
                xs = numbers(mark.get("d") or mark.get("points"))[::2]
                if xs:
                    yield min(xs), max(xs), True


def together(marks):
    """Marks that overlap from left to right, as one each."""
    merged = []
    for left, right, to_left in sorted(marks):
        if merged and left < merged[-1][1]:
            merged[-1][1] = max(merged[-1][1], right)
            merged[-1][2] |= to_left
        else:
            merged.append([left, right, to_left])
    return merged


def panels(canvas, width):
    """Ranges from left to right of the panels of a figure: a panel begins with what stands after a frame, and is not
    a label of it. There is one range, if the figure cannot be cut."""
    parts = together(extents(canvas))
    frames = [i for i, (left, right, _) in enumerate(parts) if right - left > WIDE * width]
    cuts, framed = [0.0], False
    for i, (left, _, is_label) in enumerate(parts):
        if framed and i <= frames[-1] and (i in frames or not is_label):
            cuts.append((parts[i - 1][1] + left) / 2)
            framed = False
        framed = framed or i in frames
    return list(zip(cuts, [*cuts[1:], float(width)]))
