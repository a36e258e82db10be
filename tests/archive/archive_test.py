#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Archives of quick results: the same bytes from two folders, described as RO-Crate 1.1 demands, and damage is seen.
Usage: archive_test.py PROGRAMS_FOLDER FIGURES_FOLDER WORK_FOLDER"""
import hashlib
import json
import os
import re
import shutil
import subprocess
import sys
import tarfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "report"))
from quick_results import ROOT, link_results

PROGRAMS, FIGURES, WORK = map(Path, sys.argv[1:])
sys.argv[1:] = []
DESCRIPTOR = "ro-crate-metadata.json"


def results_in(folder):
    results = link_results(FIGURES, folder)
    (results / "article.pdf").write_bytes(b"%PDF-1.5\n%%EOF\n")
    (results / "report.html").write_text("<!DOCTYPE html>", encoding="utf-8")
    return results


def archive(results, out):
    return subprocess.run([sys.executable, ROOT / "tools/archive/archive.py", results, out], capture_output=True, text=True)


def verify(path, *studies):
    return subprocess.run([sys.executable, ROOT / "tools/archive/verify.py", path, PROGRAMS, WORK / "verify", *studies],
                          capture_output=True, text=True)


def tar_of(out, what="archive"):
    return next(out.glob(f"microslip-{what}-*.tar"))


def members(path):
    """Content by the name below the archive's folder."""
    with tarfile.open(path) as tar:
        return {member.name.partition("/")[2]: tar.extractfile(member).read() for member in tar.getmembers()}


def problems(files):
    """Returns the demands of RO-Crate 1.1 that a crate does not meet."""
    document = json.loads(files[DESCRIPTOR])
    found = []
    if document.get("@context") != "https://w3id.org/ro/crate/1.1/context":
        found.append("context")
    entities = document["@graph"]
    by_id = {entity["@id"]: entity for entity in entities}
    if len(by_id) != len(entities) or any("@type" not in entity for entity in entities):
        found.append("entities need a type, and an id of their own")
    descriptor = by_id.get(DESCRIPTOR, {})
    if (descriptor.get("@type"), descriptor.get("about")) != ("CreativeWork", {"@id": "./"}) or \
            not descriptor.get("conformsTo", {}).get("@id", "").startswith("https://w3id.org/ro/crate/1.1"):
        found.append("descriptor")
    root = by_id.get("./", {})
    if root.get("@type") != "Dataset" or not all(root.get(key) for key in ("name", "description", "license", "hasPart")) or \
            not re.fullmatch(r"\d{4}-\d\d-\d\d", root.get("datePublished", "")):
        found.append("root dataset")

    def references(value):
        if isinstance(value, dict):
            if set(value) == {"@id"}:
                yield value["@id"]
            for inner in value.values():
                yield from references(inner)
        elif isinstance(value, list):
            for inner in value:
                yield from references(inner)

    found += [f"{entity['@id']}: no entity {target}" for entity in entities for value in entity.values()
              for target in references(value) if target not in by_id and not target.startswith("https://w3id.org/ro/crate/1.1")]
    described = {entity["@id"]: entity for entity in entities if entity.get("@type") == "File"}
    if set(described) != set(files) - {DESCRIPTOR, "SHA256SUMS"} or {part["@id"] for part in root.get("hasPart", [])} != set(described):
        found.append("files and parts are not the same")
    for name, entity in described.items():
        data = files.get(name, b"")
        if entity["contentSize"] != str(len(data)) or entity["sha256"] != hashlib.sha256(data).hexdigest():
            found.append(f"{name}: size or sum")
    return found


class Archive(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(WORK, ignore_errors=True)
        cls.results = results_in(WORK / "one")
        cls.made = archive(cls.results, WORK / "out")
        cls.path = tar_of(WORK / "out")
        cls.files = members(cls.path)

    def test_is_the_same_bytes_from_results_of_another_time_and_place(self):
        results = results_in(WORK / "another/place")
        for path in [*results.glob("*/provenance.txt"), *results.glob("*/*_timing.tsv")]:
            text = path.read_text(encoding="utf-8")
            path.unlink()
            path.write_text(re.sub(r"(?m)^(date|wall time|peak memory): .*", r"\1: another", text), encoding="utf-8")
            os.utime(path, (1, 1))
        self.assertEqual(archive(results, WORK / "again").returncode, 0)
        self.assertEqual(tar_of(WORK / "again").read_bytes(), self.path.read_bytes())
        self.assertNotEqual(tar_of(WORK / "again", "measured").read_bytes(), tar_of(WORK / "out", "measured").read_bytes())

    def test_is_of_no_one_and_of_no_time(self):
        with tarfile.open(self.path) as tar:
            names = [member.name for member in tar.getmembers()]
            self.assertEqual(names, sorted(names))
            self.assertEqual({(m.mtime, m.uid, m.gid, m.uname, m.gname, m.mode) for m in tar.getmembers()},
                             {(0, 0, 0, "", "", 0o644)})

    def test_has_all_tables_and_figures_in_one_of_the_two(self):
        measured = members(tar_of(WORK / "out", "measured"))
        self.assertEqual(set(self.files) & set(measured), {"SHA256SUMS"})
        both = {**self.files, **measured}
        for path in [*self.results.glob("*/*.tsv"), *self.results.glob("figures/*.svg")]:
            if path.name.startswith(("bench_", "microslip_")):
                continue
            name = str(path.relative_to(self.results))
            with self.subTest(name=name):
                self.assertEqual(both[name if name.startswith("figures") else f"tables/{name}"], path.read_bytes())
        self.assertIn("figures/fractional_power_cost.svg", measured)
        self.assertIn("figures/speed_accuracy_force_time.svg", measured)
        self.assertIn("tables/speed_accuracy/runs_timing.tsv", measured)

    def test_describes_itself(self):
        self.assertEqual(problems(self.files), [])
        graph = json.loads(self.files[DESCRIPTOR])["@graph"]
        self.assertGreater(sum(entity["@type"] == "Claim" for entity in graph), 90)
        self.assertEqual(sum(entity["@type"] == "CreateAction" for entity in graph), len(list(ROOT.glob("studies/*/study.info"))))
        meta = json.loads(self.files["codemeta.json"])
        for key in ("@context", "@type", "name", "version", "license", "author", "description"):
            self.assertTrue(meta[key], key)

    def test_description_that_is_wrong_is_found(self):
        """The check above can fail."""
        def changed(change):
            document = json.loads(self.files[DESCRIPTOR])
            change({entity["@id"]: entity for entity in document["@graph"]}, document)
            return problems({**self.files, DESCRIPTOR: json.dumps(document).encode()})
        self.assertTrue(changed(lambda by_id, _: by_id["./"].pop("license")))
        self.assertTrue(changed(lambda by_id, _: by_id["./"]["hasPart"].pop()))
        self.assertTrue(changed(lambda by_id, _: by_id["tables/carter/summary.tsv"].update(sha256="0")))
        self.assertTrue(changed(lambda _, document: document["@graph"].pop(2)))

    def test_is_verified_and_damage_is_seen(self):
        said = verify(self.path)
        self.assertEqual((said.returncode, said.stderr), (0, ""))
        data = bytearray(self.path.read_bytes())
        data[data.index(b"Carter")] ^= 1
        (WORK / "damaged.tar").write_bytes(data)
        (WORK / "short.tar").write_bytes(data[:len(data) // 2])
        for name in ("damaged.tar", "short.tar", "none.tar"):
            said = verify(WORK / name)
            with self.subTest(name=name):
                self.assertEqual((said.returncode, said.stdout), (1, ""))
                self.assertRegex(said.stderr, r"^verify-archive: .*\n$")

    def test_of_quick_tables_is_not_that_of_the_studies(self):
        """Studies that run again are compared: those of the archive's scenes are not those of --quick."""
        said = verify(self.path, "carter")
        self.assertEqual(said.returncode, 1)
        self.assertIn("carter: ", said.stderr)

    def test_without_an_article_is_refused(self):
        results = results_in(WORK / "without")
        (results / "article.pdf").unlink()
        said = archive(results, WORK / "nothing")
        self.assertEqual((said.returncode, said.stdout), (1, ""))
        self.assertRegex(said.stderr, r"^archive: .*article\.pdf: no such file; .*\n$")
        self.assertFalse((WORK / "nothing").exists())


if __name__ == "__main__":
    unittest.main(verbosity=0)
