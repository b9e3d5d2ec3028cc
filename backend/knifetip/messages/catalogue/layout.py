"""layout: messages about drawings that are placed on a sheet."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "layout.changed": entry(
        "layout changed; number of copies on the sheet: {count}",
        count="count",
    ),
    "layout.drawing-changed": entry(
        "drawing {drawing} has revision {current}, and the layout was made with revision "
        "{revision}",
        "Look at the changed drawing on the sheet, and store the layout with its new revision.",
        drawing="text",
        current="count",
        revision="count",
    ),
    "layout.edge-elsewhere": entry(
        "an edge of copy {copy} is {distance:.4g} mm away from where the layout places it",
        copy="count",
        distance="number",
    ),
    "layout.edges-added": entry(
        "edges on the sheet that belong to no drawing: {count}",
        count="count",
    ),
    "layout.edges-missing": entry(
        "edges of copy {copy} are missing on the sheet",
        copy="count",
    ),
    "layout.no-unit": entry(
        "the unit of drawing {drawing} is not known, so its size on the sheet is not known",
        "Choose the unit of the drawing.",
        drawing="text",
    ),
    "layout.of-layout": entry(
        "{drawing} is a layout, and a layout cannot be placed on another sheet",
        "Place the drawings of the layout.",
        drawing="text",
    ),
    "layout.off-sheet": entry(
        "copy {copy} extends {distance:.4g} mm over the edge of the sheet",
        "Move or turn the copy, or use a larger sheet.",
        copy="count",
        distance="number",
    ),
    "layout.overlap": entry(
        "copies {copy} and {other} overlap by {area:.4g} mm²",
        "Move one of them.",
        copy="count",
        other="count",
        area="number",
    ),
    "layout.read-only": entry(
        "the lines of layout {layout} are those of its drawings, and cannot be changed in the "
        "layout",
        "Change the drawing, and store the layout with its new revision.",
        layout="text",
    ),
    "layout.sheet-fixed": entry(
        "layout {layout} states its sheet, and the order states another one",
        "Leave the sheet out of the order, or change the sheet of the layout.",
        layout="text",
    ),
    "layout.too-many-edges": entry(
        "the copies on the sheet have more than {limit} edges together",
        "Place fewer copies, or use several sheets.",
        limit="count",
    ),
}
