"""checked_cleaning: clean a dieline as far as the verifier confirms that nothing is lost.

Cleaning and verifier decide by different calculations whether a piece of a fold lies in the waste,
and whether merged edges cover what was drawn.  Where lines nearly coincide or outlines are open,
both answers can be right, and the verifier would refuse every program of the drawing.  The drawing
is then cleaned less: what stays in doubt is made as it is drawn.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, Self

from knifetip.cleaning.clean import Extent, clean
from knifetip.model.cleaned import Cleaned
from knifetip.model.dieline import Dieline
from knifetip.model.verdict import Finding
from knifetip.verification.checks.cleaning.check import check_cleaning

#: The extents of cleaning after the full one, in the order in which they are tried.
_SMALLER: Final = (Extent.LOOPED, Extent.UNTRIMMED, Extent.SEPARATE, Extent.NOTHING)


@dataclass(frozen=True, eq=False, slots=True)
class CheckedCleaning:
    """Drawn and cleaned edges with the answer of the verifier; made by ``check`` only."""

    drawn: Dieline
    cleaned: Cleaned
    faults: tuple[Finding, ...]  #: what the verifier finds lost or added; empty if nothing

    @classmethod
    def check(cls, drawn: Dieline, cleaned: Cleaned) -> Self:
        """Return drawn and cleaned edges with the faults that the verifier finds between them."""
        return cls(drawn, cleaned, tuple(check_cleaning(drawn, cleaned)))


def clean_checked(dieline: Dieline) -> CheckedCleaning:
    """Clean a dieline to the largest extent in which the verifier finds no fault.

    If it finds one in every extent, the result is the least one, with its faults.

    Raises
    ------
    GeometryError, DrawingTooLarge
        See ``cleaning.clean.clean``.
    """
    checked = CheckedCleaning.check(dieline, clean(dieline))
    for extent in _SMALLER:
        if not checked.faults:
            break
        checked = CheckedCleaning.check(dieline, clean(dieline, extent))
    return checked
