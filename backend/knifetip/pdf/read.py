"""read: read a page of a PDF, or of an Illustrator file with PDF content.

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
from knifetip.errors import DrawingTooLarge, NotADrawing
from knifetip.formats.limits import Limits
from knifetip.formats.refusals import refuse_unexpected
from knifetip.messages import Message
from knifetip.model.drawing import Drawing
from knifetip.pdf.chosen_page import split_choice
from knifetip.pdf.document import Page, PdfFile, limit_pypdf, read_page_tree
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
    """Return the drawing on a page of a PDF: the one that the user has chosen, or the first.

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
    # pypdf may raise anything on hostile bytes.
    with refuse_unexpected(data, unit, limits, "PDF", (Exception,)):
        try:
            with limit_pypdf(limits):
                return _build_drawing(*split_choice(data), unit, limits)
        except PyPdfError as error:
            if reason := str(error)[:_REASON_LENGTH].rstrip("."):
                raise NotADrawing("reading.damaged", reason=reason, format="PDF") from error
            raise NotADrawing("reading.truncated", format="PDF") from error


def read_each_page(
    data: bytes, most: int, *, limits: Limits = Limits()
) -> list[Drawing | NotADrawing | DrawingTooLarge]:
    """Return the drawing on each of the first ``most`` pages of a PDF, or why there is none.

    Raises
    ------
    NotADrawing, DrawingTooLarge
        The file cannot be read, or a page is too large.
    """
    with refuse_unexpected(data, None, limits, "PDF", (Exception,)), limit_pypdf(limits):
        file = PdfFile(split_choice(data)[0], limits)
        first, others = read_page_tree(file, 1)
        found: list[Drawing | NotADrawing | DrawingTooLarge] = []
        for page in (first, *(page for _, page in others[: most - 1])):
            try:
                with refuse_unexpected(b"", None, limits, "PDF", (Exception,)):
                    found.append(_page_drawing(file, page, read_page(file, page), None))
            except (NotADrawing, DrawingTooLarge) as error:
                found.append(error)
            file.check_time()
        return found


def _build_drawing(data: bytes, number: int, unit: str | None, limits: Limits) -> Drawing:
    file = PdfFile(data, limits)
    try:
        page, others = read_page_tree(file, number)
        lines = read_page(file, page)
        report_other_pages(file, number, others, lines)
    finally:
        # A time-out inside pypdf may look like a damaged or empty file.
        file.check_time()
    return _page_drawing(file, page, lines, unit)


def _page_drawing(file: PdfFile, page: Page, lines: PageLines, unit: str | None) -> Drawing:
    """Return the drawing of the ``lines`` on a page.

    ``unit`` is the unit that the user gives for a point; None or "" if the user gives none.
    """
    if lines.empty:
        _refuse_empty(file, page, lines)
    evidence = (
        Message("unit.pdf") if page.unit == 1.0 else Message("unit.pdf-scaled", scale=page.unit)
    )
    known = KnownUnit.choose(unit, "pt", evidence)
    table, paths, styles = lines.collect(known.scale)
    segments = columns(lines.report, table, paths, known.scale, file.limits, "PDF")
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
