"""conventions: which house's colours fit this drawing.

    Styles, lengths by role, conventions -> Fit of each

Red is a cut in one house and a crease in the next.  Shape tells which house drew this: the outlines
must come out as cuts and what divides panels as creases.  A convention that makes a crease of an
outline, or leaves one open, does not fit.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from knifetip.classification import rules as matching
from knifetip.classification.role import Role
from knifetip.classification.rules import Styles
from knifetip.geometry.columns import F64, I64, U8, Bool
from knifetip.messages import Message
from knifetip.model.dieline import LineType
from knifetip.model.profile import LineRules

#: Line types of fold lines.
FOLDS = (LineType.CREASE, LineType.V_GROOVE, LineType.PERFORATION, LineType.COMBI)
_HOW_MANY = 2000


@dataclass(frozen=True, eq=False, slots=True)
class Fit:
    """A convention that fits, and what it says of c styles."""

    name: str
    line_type: U8  #: (c,) UNCLASSIFIED where it says nothing
    message: Message  #: why it fits


def fitting(
    styles: Styles,
    asked: Bool,
    length: F64,
    count: I64,
    conventions: Sequence[LineRules],
) -> list[Fit]:
    """Return the conventions that fit, the best first.

    Parameters
    ----------
    asked : (c,)
        Styles that the profile says nothing of: the others do not count.
    length, count : (c, roles)
        How long and how many the edges of each style in each role are.
    conventions
        Profiles with only the rules that make them different.
    """
    outline = np.where(asked, length[:, Role.OUTLINE], 0.0)
    divider = np.where(asked, length[:, Role.DIVIDER], 0.0)
    if not outline.any() or not divider.any() or len(styles) > _HOW_MANY:
        return []
    found: list[tuple[float, Fit]] = []
    for convention in conventions:
        said = matching.match(styles, convention).line_type
        cut = said == LineType.CUT
        fold = np.isin(said, FOLDS)
        main = float(divider[said == LineType.CREASE].sum() / divider.sum())
        closed = outline[cut].sum() / outline.sum()
        folds = divider[fold].sum() / divider.sum()
        against = outline[~cut & (said != LineType.UNCLASSIFIED)].sum() / outline.sum()
        folded = int(count[fold & asked, Role.DIVIDER].sum())
        every = int(count[asked, Role.DIVIDER].sum())
        # A house that has creases at all has more of them than of perforations.
        if closed < 0.97 or against > 0.0 or main < 0.6 or folded < 0.6 * every:
            continue
        message = Message(
            "classification.convention", name=convention.name, folds=folded, lines=every
        )
        found.append((closed + folds + main, Fit(convention.name, said, message)))
    found.sort(key=lambda one: -one[0])
    return [fit for _, fit in found]
