"""read: the first page of a PDF, or of an Illustrator file that is one, as a Drawing.

    bytes -> Drawing: segments in mm, and a ledger row for every path, text and picture

Lines are told apart by the layer that they lie on or the spot colour that they are drawn in, by
colour and by dashes.  A PDF says its size: a unit of its page is 1/72 in, or what UserUnit says.

    bytes -> document (objects, page) -> walk (operators, forms) -> place (columns) -> Drawing
"""

from __future__ import annotations

from pypdf.errors import PyPdfError

from knifetip.drawing_builder.assemble import KnownUnit, assemble
from knifetip.drawing_builder.paths import columns
from knifetip.errors import KnifetipError, NotADrawing
from knifetip.formats.limits import Limits
from knifetip.messages import Message
from knifetip.model.drawing import Drawing
from knifetip.model.unit import MILLIMETRES, factor
from knifetip.pdf.document import File, Page, bounded, first_page
from knifetip.pdf.drawn import Drawn
from knifetip.pdf.walk import walk

#: As much of what pypdf says of damage helps somebody.
_SAID = 120


def read(
    data: bytes,
    unit: str | None = None,
    *,
    limits: Limits = Limits(),
) -> Drawing:
    """Return the drawing on the first page of a PDF.

    Parameters
    ----------
    data
        The file.
    unit
        "mm", "in" …: what the user says that a point of the page stands for.

    Returns
    -------
    Drawing
        In mm.  The lower left corner of what is shown of the page is (0, 0).

    Raises
    ------
    NotADrawing
        Not a PDF, encrypted, without a page, cut short or damaged.
    DrawingTooLarge
        A limit is exceeded.
    NoSuchUnit
        ``unit`` is no unit.
    """
    given = factor(unit) if unit else MILLIMETRES["pt"]
    limits.admit(len(data))
    try:
        with bounded(limits):
            return _read(data, unit or "", given, limits)
    except KnifetipError:
        raise
    except PyPdfError as error:
        said = str(error)[:_SAID].rstrip(".")
        raise NotADrawing(
            "reading.damaged", reason=said or "it ends too soon", format="PDF"
        ) from error
    except Exception as error:
        # pypdf makes no promise on hostile bytes, and a user's file must never end in a traceback.
        raise NotADrawing(
            "reading.unexpected", reason=type(error).__name__, format="PDF"
        ) from error


def _read(data: bytes, unit: str, given: float, limits: Limits) -> Drawing:
    file = File(data, limits)
    try:
        page = first_page(file)
        drawn = walk(file, page)
    finally:
        # To pypdf, what stops being read because its time is over looks damaged, or empty.
        file.in_time()
    if drawn.empty:
        _refuse_shell(file, page, drawn)
    table, paths, styles = drawn.gathered()
    found = columns(drawn.sheet, table, paths, given, limits, "PDF")
    evidence = "a PDF counts in points of 1/72 in"
    if page.unit != 1.0:
        evidence = f"UserUnit = {page.unit:g} points of 1/72 in"
    source = Message("unit.given") if unit else Message("unit.in-file", statement=evidence)
    known = KnownUnit(given, unit or "pt", source, "pt")
    return assemble(drawn.sheet, found, styles, drawn.inscriptions, known)


def _refuse_shell(file: File, page: Page, drawn: Drawn) -> None:
    """Refuse a PDF whose drawing is not on its page."""
    if file.entry(file.entry(file.root, "/AcroForm"), "/XFA") is not None:
        raise NotADrawing("pdf.form")
    if file.entry(file.entry(page.node, "/PieceInfo"), "/Illustrator") is not None:
        raise NotADrawing("pdf.illustrator-only")
    if not set(drawn.sheet.kind) - {"annotation", "page"}:
        raise NotADrawing("pdf.blank")
