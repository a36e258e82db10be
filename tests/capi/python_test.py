#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""examples/python/microslip.py: copies are contacts of their own, and a failed constructor raises its own
error only. Usage: python_test.py, with MICROSLIP_LIBRARY and PYTHONPATH set."""
import copy
import pathlib
import pickle
import subprocess
import sys
import tempfile
import unittest

import microslip

MATERIAL = microslip.Material(82000, 0.28)
CONTACT = microslip.Contact(half_width=5, peak_traction=300)
STRIP = microslip.Kernel(microslip.Kernel.STRIP, 10)
GRID = microslip.Grid(20, microslip.Grid.REMEMBERED)
MAKE = "import microslip as m; m.Rolling(m.Material(1, 0.3), m.Contact(half_width=1, peak_traction=1)"


def rolling(kind=microslip.Rolling):
    contact = kind(MATERIAL, CONTACT, STRIP, GRID)
    contact.start_from_shift(-1000)
    contact.set_force(-1500)
    return contact


class Named(microslip.Rolling):
    """One with an attribute of its own."""

    name = property(lambda self: self.notes[0])


class Copies(unittest.TestCase):
    def test_roll_on_their_own(self):
        for make in (microslip.Rolling.copy, copy.copy, copy.deepcopy, lambda one: copy.deepcopy([one, one])[1]):
            with self.subTest(make=make):
                original = rolling()
                other = make(original)
                original.advance(0.1)
                self.assertEqual(other.state.distance, 0)
                other.advance(0.1)
                self.assertEqual(list(other.traction), list(original.traction))
                other.advance(0.2)
                del other
                self.assertEqual(original.state.distance, 0.1)

    def test_keep_class_and_attributes(self):
        original = rolling(Named)
        original.notes = ["wheel"]
        for make, is_shared in ((microslip.Rolling.copy, True), (copy.copy, True), (copy.deepcopy, False)):
            other = make(original)
            self.assertIsInstance(other, Named)
            self.assertEqual(other.name, "wheel")
            self.assertEqual(other.notes is original.notes, is_shared)

    def test_within_one_deepcopy_are_one(self):
        first, second = copy.deepcopy([*[rolling()] * 2])
        self.assertIs(first, second)

    def test_go_on_from_a_file(self):
        grid = microslip.Grid(20, microslip.Grid.REMEMBERED)
        original, other = (microslip.Rolling(MATERIAL, CONTACT, STRIP, grid) for _ in range(2))
        for contact in (original, other):
            contact.set_creepage(0.002)
        for step in range(20):
            original.advance(0.1 + 0.01 * step)
        with tempfile.TemporaryDirectory() as folder:
            original.save(pathlib.Path(folder) / "a.state")
            other.restore(f"{folder}/a.state")
            self.assertRaises(microslip.Error, other.restore, f"{folder}/none")
        for step in range(20):
            for contact in (original, other):
                contact.advance(0.3)
            self.assertEqual(list(other.traction), list(original.traction))
            self.assertEqual(other.state.creepage, original.state.creepage)

    def test_by_pickling_are_refused(self):
        with self.assertRaises((ValueError, TypeError)):
            pickle.dumps(rolling())


class Jacobians(unittest.TestCase):
    def test_are_slopes_of_the_step(self):
        contact = microslip.Rolling(MATERIAL, CONTACT, STRIP, microslip.Grid(20, microslip.Grid.REMEMBERED))
        contact.start_from_shift(-1000)

        def tried(creepage, dq):
            contact.set_creepage(creepage)
            return contact.attempt_with_jacobian(dq)

        for name in ("force", "mean_force", "dissipation"):
            _, jacobian = tried(1e-3, 0.2)
            by_load = [getattr(tried(w, 0.2)[0], name) for w in (1e-3 * (1 - 1e-4), 1e-3 * (1 + 1e-4))]
            self.assertAlmostEqual((by_load[1] - by_load[0]) / 2e-7 / getattr(jacobian.by_load, name), 1, 6)
            by_length = [getattr(tried(1e-3, dq)[0], name) for dq in (0.2 * (1 - 1e-4), 0.2 * (1 + 1e-4))]
            self.assertAlmostEqual((by_length[1] - by_length[0]) / 4e-5 / getattr(jacobian.by_length, name), 1, 6)


class Shifts(unittest.TestCase):
    def test_lose_in_a_cycle_what_the_force_does(self):
        contact = microslip.Rolling(MATERIAL, CONTACT, STRIP, GRID)
        first = contact.shift_to_force(-1500)
        self.assertGreater(first.distance, 0)
        self.assertAlmostEqual(first.work - first.dissipation, contact.elastic_energy, places=12)
        back, forth = contact.shift_to_force(1500), contact.shift_to_force(-1500)
        self.assertAlmostEqual(back.distance, -forth.distance, places=12)
        self.assertAlmostEqual(back.work + forth.work, back.dissipation + forth.dissipation, places=10)
        again = contact.shift_by_distance(0.01)
        self.assertEqual(again.distance, 0.01)
        self.assertEqual(again.force, contact.state.force)
        with self.assertRaisesRegex(microslip.Error, "^force = 3000: expected an absolute value"):
            contact.shift_to_force(3000)


class Contacts(unittest.TestCase):
    def test_that_change_carry_what_they_can(self):
        contact = microslip.Rolling(MATERIAL, CONTACT, STRIP, microslip.Grid(40, microslip.Grid.REMEMBERED))
        contact.set_creepage(1)
        full = contact.full_sliding
        for size in (1, 1.2, 0.5):
            contact.set_contact(size, size)
            contact.advance(5)
            self.assertAlmostEqual(contact.state.force / (full * size**2), -1, delta=0.01)
            self.assertAlmostEqual(contact.full_sliding, full * size**2, places=9)
        contact.set_contact(0, 1)
        contact.advance(0.1)
        self.assertEqual(contact.state.force, 0)
        with self.assertRaisesRegex(microslip.Error, "^bound = -1: expected a number >= 0"):
            contact.set_contact(1, -1)


class Constructors(unittest.TestCase):
    def test_that_fail_raise_their_own_error_only(self):
        """A process of its own each, as what a destructor raises is only printed."""
        for rest, error in ((")", "TypeError"), (", m.Kernel(0, -1), m.Grid(10, 0))", "Error"),
                            (", None, 5)", "ArgumentError"), (", m.Kernel(0, 1), m.Grid(10, 0), 1)", "TypeError")):
            with self.subTest(rest=rest):
                done = subprocess.run([sys.executable, "-c", MAKE + rest], capture_output=True, text=True, check=False)
                self.assertEqual(done.returncode, 1)
                self.assertEqual(done.stderr.count("Traceback"), 1, done.stderr)
                self.assertNotIn("Exception ignored", done.stderr)
                self.assertIn(error + ":", done.stderr.splitlines()[-1])


if __name__ == "__main__":
    unittest.main(verbosity=0)
