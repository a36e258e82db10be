# SPDX-License-Identifier: GPL-3.0-or-later
"""Exceptions of the package."""

from __future__ import annotations

import re


class Error(Exception):
    """Base of all exceptions of microslip."""


class InputError(Error, ValueError):
    """A value is not accepted; the message is one line.

    Attributes
    ----------
    key : str
        What is wrong: a key of scenes such as ``"contact.half_width"``, or an argument; empty if the
        message is about none.
    value : str
        What was given; empty if nothing was.
    expected : str
        What is accepted; the whole message if it does not say so.

    >>> import microslip as ms
    >>> try:
    ...     ms.solve(problem="steady", material={"shear_modulus": -1, "poisson_ratio": 0.28})
    ... except ms.InputError as error:
    ...     print(error.key, error.value, error.expected, sep=" | ")
    material.shear_modulus | -1 | a number > 0
    """

    def __init__(self, message: str, key: str = "", value: str = "", expected: str = ""):
        super().__init__(message)
        self.key, self.value, self.expected = key, value, expected

    def __reduce__(self):  # an exception is pickled by its first argument alone
        return type(self), (str(self), self.key, self.value, self.expected)

    @classmethod
    def of(cls, key: str, value: str, expected: str) -> "InputError":
        """Says what was given, and what is accepted."""
        return cls(f"{key} = {value}: expected {expected}", key, value, expected)

    @classmethod
    def from_message(cls, message: str, key: str = "") -> "InputError":
        """Takes a line of the library apart: "[place: ]key = value: expected what is accepted"."""
        if "expected only one of" in message:
            message += "; None takes a key away"
        found = re.search(r"(?:^|: )([^\s=:]+) = (.*?): (?:expected )?(.*)$", message, re.DOTALL)
        if found is None:
            named = re.search(r"keys? '([^']*)'|expected only one of '([^']*)'", message)
            return cls(message, key or (named.group(1) or named.group(2) if named else ""), "", message)
        name, value, expected = found.groups()
        return cls(message, key or name, value.strip("'"), expected)


class NoSolution(Error, ArithmeticError):
    """The solver found no solution, or no solution that the scene accepts."""


class LoadWarning(UserWarning):
    """A value, or a result that is accepted, is doubtful."""
