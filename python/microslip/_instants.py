# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of a run: the tractions of a contact at several instants."""

from __future__ import annotations

from typing import Any, Optional, Sequence, Union

from . import _plot
from ._errors import InputError
from ._patch import Patch
from ._rolling import Rolling


def plot_instants(contacts: Union[Sequence[Patch], Sequence[Rolling]], titles: Optional[Sequence[str]] = None) -> Any:
    """Draws the tractions of a contact at several instants of a run.

    Patches are small maps side by side, with one scale of colours and arrows and what slips, as Patch.plot()
    draws them. Line contacts are curves over one another, from the first, which is pale, to the last.

    Parameters
    ----------
    contacts : list of Patch, or list of Rolling
        Copies that were kept as the contact rolled on: ``patch.copy()``, which shares what is large.
    titles : list of str, optional
        One for each; by default the distance rolled.

    Returns
    -------
    An array of matplotlib axes, one for each patch; or the axes of the curves.

    >>> import microslip as ms
    >>> patch = ms.Patch(material={"youngs_modulus": "210 GPa", "poisson_ratio": 0.28},
    ...                  contact={"normal_load": "80 kN", "radius_1": 460, "lateral_radius_2": 300, "friction": 0.3},
    ...                  grid={"rows": 6, "elements": 8})
    >>> instants = []
    >>> for creepage in (1e-3, 1e-3, -1e-3, -1e-3):
    ...     state = patch.roll(2, creepage=creepage)
    ...     instants.append(patch.copy())
    >>> axes = ms.plot_instants(instants)  # doctest: +SKIP
    """
    several = list(contacts)
    kinds = {kind for kind in (Patch, Rolling) for contact in several if isinstance(contact, kind)}
    if len(kinds) != 1 or not all(isinstance(contact, (Patch, Rolling)) for contact in several):
        raise InputError.of("contacts", ", ".join(type(contact).__name__ for contact in several) or "none",
                            "patches or line contacts, one or more of one kind")
    names = [contact._title() for contact in several] if titles is None else list(titles)
    if len(names) != len(several):
        raise InputError.of("titles", str(len(names)), f"{len(several)}, one for each contact")
    draw: Any = _plot.plot_patches if kinds == {Patch} else _plot.plot_lines
    return draw([contact._drawn() for contact in several], names)
