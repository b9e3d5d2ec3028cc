"""rescale: a drawing in another unit.

Drawing, unit -> Drawing whose numbers are taken to be in that unit, in mm
"""

from __future__ import annotations

from dataclasses import replace

from knifetip.messages import Message
from knifetip.model.drawing import Drawing, LocationBoxes
from knifetip.model.unit import factor


def rescaled(drawing: Drawing, unit: str) -> Drawing:
    """Return a drawing whose file units are these: the first time, or corrected.

    Bulges, layers and the ledger's rows stay as they are.  Ellipses and splines were fitted when
    the drawing was read and are scaled with all the rest: from mm to a larger unit their deviation
    grows too, and reading the bytes again with ``unit`` fits them anew.

    Parameters
    ----------
    unit
        One of ``model.unit.MILLIMETRES``; "" takes the unit away, back to file units.

    Raises
    ------
    NoSuchUnit
        There is no such unit.
    """
    old, new = factor(drawing.unit), factor(unit)
    rows, box = drawing.ledger.location_boxes
    ledger = replace(
        drawing.ledger,
        length=drawing.ledger.length / old * new,
        location_boxes=LocationBoxes(rows, box / old * new),
    )
    return replace(
        drawing,
        # Divided first: what is in mm loses no bit on the way to file units and back.
        ends=drawing.ends / old * new,
        ledger=ledger,
        inscriptions=tuple(words.scaled(old, new) for words in drawing.inscriptions),
        unit=unit,
        evidence=Message("unit.given" if unit else "unit.not-given"),
    )
