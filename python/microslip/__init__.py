# SPDX-License-Identifier: GPL-3.0-or-later
"""Rolling contact with friction by boundary elements, for any time step: contact ellipses and line contacts.

    import microslip as ms

    result = ms.solve("steady.info", load_force=-1500)   # a scene: a file, a text, or a dictionary
    result.summary["creepage"], result.traction["x"]     # numpy structured arrays; result.units

    ms.steady(scene, creepage=[...])                     # forces and tractions of many loads
    ms.creep_curve(scene).plot()
    ms.sweep(scene, {"contact.half_width": [4, 5, 6]})   # many scenes on all cores

    rolling = ms.Rolling(scene)                          # step by step, for simulations
    rolling.roll(dq, creepage=w)                         # of numbers or arrays
    patch = ms.Patch(scene)                              # the same of an ellipse; patch.traction, patch.plot()
    patch.roll(dq, creepage=w, spin=phi)
    table = ms.CreepTable()                              # forces of ellipses from a table, in a microsecond
    table.forces(w, eta, phi, half_width=a, ...)

Units are mm and N; of a line contact per mm of width, so that its forces are in N/mm. Rolling is towards +x. A
positive creepage w = (v - omega R)/v gives negative tractions and a negative force, which acts on v.

Keys of scenes: ms.keys(), and docs/scenes.md. Errors are ms.InputError, a ValueError, and ms.NoSolution.
"""

from ._creep_table import CreepForces, CreepTable, CreepTableErrors
from ._errors import Error, InputError, LoadWarning, NoSolution
from ._hertz import Hertz, hertz
from ._instants import plot_instants
from ._keys import Key, Keys, keys
from ._library import text_of as _text_of
from ._patch import Patch, PatchFactors
from ._patch_curve import PatchCurve, PatchCurves
from ._patch_steady import PatchSteady
from ._result import Result, solve
from ._rolling import Load, Rolling
from ._steady import Steady, creep_curve, steady
from ._sweep import Sweep, sweep
from ._table import Column, Table, read_table

__version__ = _text_of("version")

__all__ = ["Column", "CreepForces", "CreepTable", "CreepTableErrors", "Error", "Hertz", "InputError", "Key", "Keys",
           "Load", "LoadWarning", "NoSolution", "Patch", "PatchCurve", "PatchCurves", "PatchFactors", "PatchSteady",
           "Result", "Rolling", "Steady", "Sweep", "Table", "creep_curve", "hertz", "keys", "plot_instants", "read_table",
           "solve", "steady", "sweep"]
