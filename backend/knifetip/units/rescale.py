"""rescale: interpret the file coordinates of a drawing in a different unit."""

from __future__ import annotations

from dataclasses import replace

from knifetip.messages import Message
from knifetip.model.drawing import Drawing, LocationBoxes
from knifetip.model.unit import factor


def rescale(drawing: Drawing, unit: str) -> Drawing:
    """Return the drawing with its file coordinates interpreted in another unit.

    Bulges, layers, line widths and the rows of the import report do not change.  Ellipses and
    splines were approximated by lines and arcs when the drawing was read, so a larger unit also
    increases the error of this approximation.  To keep the error within the tolerance, read the
    file again with ``unit``.

    Parameters
    ----------
    unit
        A key of ``model.unit.MILLIMETRES``.  With "" the drawing gets no unit, and its coordinates
        become those in the file.

    Raises
    ------
    NoSuchUnit
        No unit has this name.
    """
    old, new = factor(drawing.unit), factor(unit)
    rows, box = drawing.import_report.location_boxes
    import_report = replace(
        drawing.import_report,
        length=drawing.import_report.length / old * new,
        location_boxes=LocationBoxes(rows, box / old * new),
    )
    return replace(
        drawing,
        # Dividing first keeps coordinates in mm exact if they are converted to file units and back.
        ends=drawing.ends / old * new,
        import_report=import_report,
        annotations=tuple(text.scaled(old, new) for text in drawing.annotations),
        unit=unit,
        evidence=Message("unit.given" if unit else "unit.not-given"),
    )
