"""read: read an SVG, plain or packed (.svgz).

``read`` returns a Drawing with segments in mm, and a row of the import report for every drawable
element.  Line types are distinguished by colour, dashes and width of the stroke, and by layer,
group or id.  The modules are called in this order: ``document`` (tree of elements), ``page``
(size), ``expand`` (copies of ``use``), ``segments`` (arrays of lines and arcs).
"""

from __future__ import annotations

from knifetip.drawing_builder.assemble import KnownUnit, assemble
from knifetip.formats.limits import Limits
from knifetip.formats.refusals import refuse_unexpected
from knifetip.model.drawing import Drawing
from knifetip.model.unit import factor
from knifetip.svg.document import parse_document
from knifetip.svg.expand import expand
from knifetip.svg.page import read_page
from knifetip.svg.segments import segment_columns
from knifetip.svg.writer import pixel_unit


def read(
    data: bytes,
    unit: str | None = None,
    *,
    limits: Limits = Limits(),
) -> Drawing:
    """Return the drawing in an SVG.

    Parameters
    ----------
    data
        Content of the file, which may be packed with gzip.
    unit
        The unit that the user gives, "mm", "px" …; None if the user gives no unit.  If the file
        states the size of the page with a physical unit, this unit is replaced and the number is
        kept: "90mm" is read as 90 inches if ``unit`` is "in".  Otherwise one unit of the
        coordinates in the file has the length ``unit``.
    limits
        Limits of the size of the file and of the drawing.

    Returns
    -------
    Drawing
        In mm.  If neither the file nor the user gives a unit, the drawing is in coordinates of the
        file and its attribute ``unit`` is empty.  The lower left corner of the page is (0, 0) if
        the height of the page is known; y is upwards.

    Raises
    ------
    NotADrawing
        The file is not an SVG, or it is truncated or damaged.
    DrawingTooLarge
        A limit is exceeded.
    NoSuchUnit
        ``unit`` is not a unit.
    """
    with refuse_unexpected(data, unit, limits, "SVG"):
        root = parse_document(data, limits)
        millimetres = factor(unit) if unit else 0.0
        page = read_page(root, unit or "", millimetres, pixel_unit(root, data))
        report, paths = expand(root, page, limits)
        columns, styles = segment_columns(report, paths, page, limits)
        known = KnownUnit(page.scale, page.unit, page.evidence, page.stated_unit, page.hints)
        return assemble(report, columns, styles, paths.annotations, known)
