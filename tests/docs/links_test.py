#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""README, CONTRIBUTING, CHANGELOG and docs/: links lead somewhere, and commands are those that there are. Usage: links_test.py PROGRAMS"""
import re
import subprocess
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROGRAMS = Path(sys.argv.pop())
PAGES = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", ROOT / "CHANGELOG.md", *sorted(ROOT.glob("docs/*.md"))]


def text_of(page):
    return page.read_text(encoding="utf-8")


def anchor(heading):
    return re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-")


def anchors(page):
    return {anchor(heading) for heading in re.findall(r"^#+ (.+)$", text_of(page), re.MULTILINE)}


def commands(page):
    """Lines of code blocks of a shell, without comments; those that go on are one."""
    blocks = re.findall(r"^```sh\n(.*?)^```", text_of(page), re.MULTILINE | re.DOTALL)
    lines = "".join(blocks).replace("\\\n", " ").splitlines()
    return [command for line in lines if (command := re.sub(r"(^|\s)#.*", "", line).strip())]


class Links(unittest.TestCase):
    def test_lead_somewhere(self):
        for page in PAGES:
            for link in re.findall(r"\]\(([^)\s]+)\)", text_of(page)):
                with self.subTest(page=page.name, link=link):
                    name, _, place = link.partition("#")
                    target = page.parent / name if name else page
                    self.assertTrue(target.exists())
                    if place:
                        self.assertIn(place, anchors(target))


def help_of(program, *command):
    return subprocess.run([PROGRAMS / program, *command, "--help"], capture_output=True, text=True, check=True).stdout


class Commands(unittest.TestCase):
    def test_of_make_have_a_target(self):
        targets = set(re.findall(r"^([a-z-]+):", text_of(ROOT / "Makefile"), re.MULTILINE))
        targets |= {scene.parent.name for scene in ROOT.glob("studies/*/study.info")}
        for page in PAGES:
            for command in commands(page):
                if match := re.match(r"make ([a-z_-]+)", command):
                    self.assertIn(match[1], targets, f"{page.name}: {command}")

    def test_of_make_are_all_listed_by_make(self):
        makefile = text_of(ROOT / "Makefile").replace("\\\n", " ")
        targets = re.search(r"^\.PHONY: (.*)$", makefile, re.MULTILINE)[1].split()
        self.assertGreater(len(targets), 20)
        for target in set(targets) - {"help", "deps", "$(STUDIES)"}:
            self.assertRegex(makefile, rf"echo '.*make {target}[ ']", target)

    def test_write_where_git_does_not_look(self):
        """Files and folders that a command writes in the top folder are ignored."""
        if not (ROOT / ".git").exists():
            self.skipTest("no repository")
        for page in PAGES:
            for command in commands(page):
                places = re.findall(r"--(?:out|to|save) (\S+)", command)
                if match := re.match(r"microslip init (\w+)", command):
                    places.append(f"{match[1]}.info")
                for place in places:
                    with self.subTest(page=page.name, command=command):
                        ignored = subprocess.run(["git", "check-ignore", "--quiet", "--no-index", place], cwd=ROOT)
                        self.assertEqual(ignored.returncode, 0, f"{place} would be new to git")

    def test_of_programs_have_their_options(self):
        """Each option in a command line is one that --help of the program, and of its command, lists."""
        seen = 0
        for page in PAGES:
            for command in commands(page):
                words = command.split()
                name = Path(words[0]).name
                if not (PROGRAMS / name).is_file():
                    continue
                said = help_of(name)
                known = re.findall(rf"^  {name} ([a-z]+) ", said, re.MULTILINE)
                if words[1:2] and words[1] in known:
                    said = help_of(name, words[1])
                for option in re.findall(r"--[a-z-]+", command):
                    seen += 1
                    self.assertIn(option + " ", said, f"{page.name}: {command}")
        self.assertGreater(seen, 10)


if __name__ == "__main__":
    unittest.main(verbosity=0)
