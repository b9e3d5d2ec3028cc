"""read: read the first page of a PDF, or of an Illustrator file with PDF content.

``read`` returns a Drawing with segments in mm, and a row of the import report for every path, text
and image.  Line types are distinguished by layer, spot colour, colour, dashes and line width.  The
size of the page is known: one unit of its coordinates is 1/72 in, or the multiple of 1/72 in that
the entry UserUnit of the page contains.

``document`` finds the page, ``page_reader`` interprets its operators and forms.
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
from knifetip.pdf.document import Page, PdfFile, first_page, limit_pypdf
from knifetip.pdf.page_lines import PageLines
from knifetip.pdf.page_reader import read_page, report_other_pages

#: Largest number of characters of a pypdf message in an error.
_REASON_LENGTH = 120


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
        Content of the file.
    unit
        Unit that the user gives for one point of the page: "mm", "in" …  None or "" for the true
        length of a point, 1/72 in.
    limits
        Limits of the size of the file and of the drawing.

    Returns
    -------
    Drawing
        In mm.  The lower left corner of the visible area is (0, 0).

    Raises
    ------
    NotADrawing
        The file is not a PDF, is encrypted, truncated or damaged, or has no page.
    DrawingTooLarge
        A limit is exceeded.
    NoSuchUnit
        ``unit`` is not a unit.
    """
    millimetres = factor(unit) if unit else MILLIMETRES["pt"]
    limits.admit(len(data))
    try:
        with limit_pypdf(limits):
            return _build_drawing(data, unit or "", millimetres, limits)
    except KnifetipError:
        raise
    except PyPdfError as error:
        if reason := str(error)[:_REASON_LENGTH].rstrip("."):
            raise NotADrawing("reading.damaged", reason=reason, format="PDF") from error
        raise NotADrawing("reading.truncated", format="PDF") from error
    except Exception as error:
        # pypdf may raise anything on hostile bytes, and no file may cause a traceback.
        raise NotADrawing(
            "reading.unexpected", reason=type(error).__name__, format="PDF"
        ) from error


def _build_drawing(data: bytes, unit: str, millimetres: float, limits: Limits) -> Drawing:
    file = PdfFile(data, limits)
    try:
        page = first_page(file)
        lines = read_page(file, page)
        report_other_pages(file, lines)
    finally:
        # A time-out inside pypdf may look like a damaged or empty file.
        file.check_time()
    if lines.empty:
        _refuse_empty(file, page, lines)
    table, paths, styles = lines.collect(millimetres)
    segments = columns(lines.report, table, paths, millimetres, limits, "PDF")
    evidence = (
        Message("unit.pdf") if page.unit == 1.0 else Message("unit.pdf-scaled", scale=page.unit)
    )
    source = Message("unit.given") if unit else evidence
    known = KnownUnit(millimetres, unit or "pt", source, "pt")
    return assemble(lines.report, segments, styles, lines.annotations, known)


def _refuse_empty(file: PdfFile, page: Page, lines: PageLines) -> None:
    """Raise NotADrawing for a page without paths if it is blank or has no usable PDF content.

    A page has no usable PDF content if its content is an XFA form or private data of Illustrator.
    ``lines`` contains the import report of the page.
    """
    if file.entry(file.entry(file.root, "/AcroForm"), "/XFA") is not None:
        raise NotADrawing("pdf.form")
    if file.entry(file.entry(page.node, "/PieceInfo"), "/Illustrator") is not None:
        raise NotADrawing("pdf.illustrator-only")
    if not set(lines.report.kind) - {"annotation", "page"}:
        raise NotADrawing("pdf.blank")
