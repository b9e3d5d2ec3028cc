"""checked_cleaning: clean a dieline as far as the verifier confirms that nothing is lost.

Cleaning and verifier decide by different calculations whether a piece of a fold lies in the waste,
and whether merged edges cover what was drawn.  Where lines nearly coincide or outlines are open,
both answers can be right, and the verifier would refuse every program of the drawing.  The drawing
is then cleaned less: what stays in doubt is made as it is drawn.
"""

from __future__ import annotations

from typing import Final

from knifetip.cleaning.clean import Extent, clean
from knifetip.model.cleaned import Cleaned
from knifetip.model.dieline import Dieline
from knifetip.verification.checks.cleaning_check import check_cleaning

#: The extents of cleaning after the full one, in the order in which they are tried.
_SMALLER: Final = (Extent.UNTRIMMED, Extent.SEPARATE, Extent.NOTHING)


def clean_checked(dieline: Dieline) -> Cleaned:
    """Return the dieline, cleaned to the largest extent in which the verifier finds no fault.

    For the result and the errors see ``cleaning.clean.clean``.
    """
    cleaned = clean(dieline)
    for extent in _SMALLER:
        if not check_cleaning(dieline, cleaned):
            break
        cleaned = clean(dieline, extent)
    return cleaned
