#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the tables of docs/accuracy.md, as the order tests print them.

usage: tools/accuracy.py ORDER_TESTS [--check]     with --check, only says where the page differs

ORDER_TESTS is their program, or the folder in which a run of them left what it measured (MICROSLIP_ORDERS).

A table stands between `<!-- orders: Suite.Test -->` and `<!-- end of orders -->`; sentences are the page's own. Numbers
agree if orders differ by less than 0.05 and errors by less than a tenth: those of other processors do.
"""
import pathlib
import re
import subprocess
import sys

PAGE = pathlib.Path(__file__).resolve().parent.parent / "docs/accuracy.md"
MARK = "[   ORDER  ]"  # tests/order/measured_order.hpp
PLACE = re.compile(r"(<!-- orders: (\S+) -->\n)(.*?)(<!-- end of orders -->\n)", re.DOTALL)


def measured(output):
    """The lines of each test: {test: [[problem, size, error, ..., order], ...]}."""
    tests = {}
    for line in output.splitlines():
        if line.startswith(MARK):
            _, test, *row = line.split("\t")
            tests.setdefault(test, []).append(row)
    return tests


def table(rows):
    sizes = rows[0][1:-1:2]
    if any(row[1:-1:2] != sizes for row in rows):
        raise ValueError(f"{rows[0][0]}: expected the same numbers of elements in all rows of a test")
    lines = [["error of", *(f"N = {size}" for size in sizes), "order"], ["---"] + ["---:"] * (len(sizes) + 1)]
    lines += [[row[0], *(f"{float(error):.1e}" for error in row[2:-1:2]), row[-1]] for row in rows]
    return "".join("| " + " | ".join(cells) + " |\n" for cells in lines)


def cells_of(text):
    """The cells of a table, with its rows in the order of their names: a folder has the instances of a test in another order."""
    lines = [[cell.strip() for cell in line.strip().strip("|").split("|")] for line in text.splitlines()]
    return lines[:2] + sorted(lines[2:], key=lambda row: row[0])


def agree(old, new, is_order):
    try:
        old, new = float(old), float(new)
    except ValueError:
        return old == new
    return abs(old - new) <= (0.05 if is_order else 0.1 * new)


def differences(test, old, new):
    """Sentences that say where two tables differ by more than another processor explains."""
    old, new = cells_of(old), cells_of(new)
    if [len(row) for row in old] != [len(row) for row in new]:
        return [f"{test}: another number of rows or columns"]
    return [f"{test}, {now[0]}: {now[i]} is measured, {was[i]} is written" for was, now in zip(old, new)
            for i in range(len(now)) if not agree(was[i], now[i], i == len(now) - 1)]


def renewed(page, tests):
    """The page with all tables as they are measured, and the differences from those it has."""
    places = [place[2] for place in PLACE.finditer(page)]
    found = [f"{test}: measured, without a place on the page" for test in tests if places.count(test) != 1]
    found += [f"{test}: has a place on the page, is not measured" for test in places if test not in tests]

    def fill(place):
        if place[2] not in tests:
            return place[0]
        new = table(tests[place[2]])
        differ = differences(place[2], place[3], new)
        found.extend(differ)
        return place[1] + (new if differ else place[3]) + place[4]

    return PLACE.sub(fill, page), found


def output_of(tests):
    """Returns what the program of the tests prints, or has left in a folder."""
    if pathlib.Path(tests).is_dir():
        files = sorted(pathlib.Path(tests).iterdir())
        return "".join(file.read_text(encoding="utf-8") for file in files)
    run = subprocess.run([tests], stdout=subprocess.PIPE, text=True)
    if run.returncode != 0:
        sys.exit(f"{tests}: a test failed")
    return run.stdout


def main(tests, check):
    page, found = renewed(PAGE.read_text(encoding="utf-8"), measured(output_of(tests)))
    for sentence in found:
        print(f"docs/accuracy.md: {sentence}")
    if check:
        if found:
            print("run make accuracy")
        return 1 if found else 0
    PAGE.write_text(page, encoding="utf-8")
    return 1 if any(" place on the page" in sentence for sentence in found) else 0


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3) or sys.argv[2:] not in ([], ["--check"]):
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1], "--check" in sys.argv))
