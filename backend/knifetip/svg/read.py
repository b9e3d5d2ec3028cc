"""read: an SVG, plain or packed (.svgz), as a Drawing.

    bytes -> Drawing: segments in mm, and a ledger row for every element that is or could be a line

Lines are told apart by the colour and the dashes of their stroke, by layer, group or id.

    bytes -> document (tree) -> page (size) -> expand (use) -> place (columns) -> Drawing
"""

from __future__ import annotations

from knifetip.drawing_builder.assemble import KnownUnit, assemble
from knifetip.errors import KnifetipError, NotADrawing
from knifetip.formats.limits import Limits
from knifetip.model.drawing import Drawing
from knifetip.model.unit import factor
from knifetip.svg.document import document
from knifetip.svg.expand import expand
from knifetip.svg.page import page
from knifetip.svg.place import columns

#: How far into a file a program says that it wrote it.
_HEAD = 4096


def read(
    data: bytes,
    unit: str | None = None,
    *,
    limits: Limits = Limits(),
) -> Drawing:
    """Return the drawing that an SVG holds.

    Parameters
    ----------
    data
        The file, or its gzip.
    unit
        "mm", "px" …: what the user says that the unit is, see ``page``.

    Returns
    -------
    Drawing
        In mm; in coordinates of the file with ``unit`` empty where neither the file nor the caller
        says one.  The lower left corner of the page is (0, 0) where it has a height, y upwards.

    Raises
    ------
    NotADrawing
        Not an SVG, cut short or damaged.
    DrawingTooLarge
        A limit is exceeded.
    NoSuchUnit
        ``unit`` is no unit.
    """
    given = factor(unit) if unit else 0.0
    limits.admit(len(data))
    try:
        root = document(data, limits)
        paper = page(root, unit or "", given, b"Adobe Illustrator" in data[:_HEAD])
        sheet, drawn = expand(root, paper, limits)
        found = columns(sheet, drawn, paper.scale, limits)
        known = KnownUnit(paper.scale, paper.unit, paper.evidence, paper.stated, paper.hints)
        return assemble(sheet, found, drawn.styles, drawn.inscriptions, known)
    except KnifetipError:
        raise
    except (ValueError, ArithmeticError, LookupError) as error:
        raise NotADrawing(
            "reading.unexpected", reason=type(error).__name__, format="SVG"
        ) from error
