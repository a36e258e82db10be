# SPDX-License-Identifier: GPL-3.0-or-later
"""The summary at the top of the page: faults of the thesis's scheme and their cures, a picture each."""
from dataclasses import dataclass


@dataclass
class Fault:
    name: str
    cause: str
    cure: str
    study: str
    figure: str


FAULTS = (
    Fault("The error falls in first order only",
          "The scheme acts as if the edges of the contact were elsewhere.",
          "Elements with calibrated edges are of second order. Inversion solves steady rolling in closed form.",
          "open_problems", "open_problems_convergence"),
    Fault("Small steps make the traction wiggle",
          "The difference over a short step cannot see the wave from node to node.",
          "In the scheme remembered the material keeps its displacement, and no step makes wiggles. "
          "Steady rolling by inversion has no step.",
          "carter", "carter_traction"),
    Fault("Travelling peaks of traction are smeared",
          "Each step interpolates the tractions between nodes, and so smooths them again.",
          "The scheme remembered keeps the peak for any step.",
          "open_problems", "open_problems_peak"),
    Fault("The energy balance is wrong in first order",
          "The dissipation takes tractions at the end of each step.",
          "With mean tractions over the step the balance closes to rounding.",
          "energy_balance", "energy_balance_error"),
)

WORDS = (
    ("step ratio c", "step over element, dq/dx"),
    ("stick ratio a'", "part of the contact that sticks"),
    ("N", "number of elements"),
    ("creepage", "relative rigid slip of the bodies"),
    ("bound", "largest traction: friction coefficient times pressure"),
    ("leading edge", "end of the contact where material enters"),
    ("wiggle", "oscillation from node to node that the exact solution does not have"),
    ("order", "exponent m of an error that falls as dx^m"),
    ("local extrema", "places where the traction turns; wiggles add some"),
)
