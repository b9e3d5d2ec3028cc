"""page_reader: read a PDF page with all copies of its forms (reusable content streams).

``read_page`` returns ``PageLines``: the paths, and a row of the import report for every path, text
and image.  Coordinates are points on the displayed page, with (0, 0) at its lower left corner.  The
total size of the content streams is limited; the stream of a form counts once for each copy.

Source: ISO 32000-1, chapters 7.7.3, 7.8 and 8.10.
"""

from __future__ import annotations

from pypdf.generic import DictionaryObject, StreamObject

from knifetip.errors import DrawingTooLarge, NotADrawing
from knifetip.geometry.affine import Matrix, compose
from knifetip.messages import Message
from knifetip.pdf.content import TruncatedStream
from knifetip.pdf.document import UNBOUNDED, Box, Page, PdfFile
from knifetip.pdf.layers import Layers
from knifetip.pdf.page_lines import LayerMark, PageLines
from knifetip.pdf.resources import Resources
from knifetip.pdf.stream import (
    PageContext,
    State,
    Stream,
    StreamContext,
    intersect,
    transformed_box,
)


def read_page(file: PdfFile, page: Page) -> PageLines:
    """Return the paths, the texts and the import report of a page.

    Raises
    ------
    NotADrawing
        The content of the page is truncated.
    DrawingTooLarge
        The size of the page with all copies of its forms exceeds the limits.
    """
    reader = _PageReader(file)
    reader.read_page(page)
    return reader.drawn


def _display_matrix(page: Page) -> tuple[Matrix, Box]:
    """Return the matrix from page coordinates to points on the displayed page.

    The second value is the visible area of the displayed page: min x, min y, max x, max y (points).
    """
    u = page.unit
    boundless = page.box == UNBOUNDED
    left, low, right, high = (0.0, 0.0, 0.0, 0.0) if boundless else page.box
    turned: tuple[Matrix, ...] = (
        (u, 0.0, 0.0, u, -left * u, -low * u),
        (0.0, -u, u, 0.0, -low * u, right * u),
        (-u, 0.0, 0.0, -u, right * u, high * u),
        (0.0, u, -u, 0.0, high * u, -left * u),
    )
    wide, tall = (right - left) * u, (high - low) * u
    if page.rotate % 2:
        wide, tall = tall, wide
    return turned[page.rotate], UNBOUNDED if boundless else (0.0, 0.0, wide, tall)


class _PageReader:
    """Interprets the content streams of a page and of the forms that the page contains."""

    def __init__(self, file: PdfFile) -> None:
        self.file = file
        self.drawn = PageLines(file.limits)
        self._page = PageContext(file, self.drawn, Layers(file), Resources(file), set(), self.form)
        self._read = 0

    def read_page(self, page: Page) -> None:
        """Interpret the content of a page and collect its paths, its texts and its import report.

        The page's annotations, and the other pages of the file, are added to the import report as
        dropped.
        """
        matrix, visible_area = _display_matrix(page)
        state = State(matrix, visible_area)
        none = LayerMark("", "")
        self.run(self._contents(page), state, StreamContext("", (), none, page.resources))
        if notes := len(self.file.array(page.node, "/Annots")):
            reason = Message("import.annotations", count=notes)
            self.drawn.row("", "annotation", none, reason)
        if page.count > 1:
            reason = Message("import.other-pages", pages=page.count)
            self.drawn.row("", "page", none, reason)

    def _contents(self, page: Page) -> bytes:
        contents = self.file.entry(page.node, "/Contents")
        if "/Contents" not in page.node:
            return b""
        parts = []
        for one in contents if isinstance(contents, list) else [contents]:
            stream = self.file.resolve(one)
            if not isinstance(stream, StreamObject):
                raise NotADrawing("pdf.part-missing")
            parts.append(self.file.data(stream))
            self._check_size(len(parts[-1]))
        return b"\n".join(parts)

    def _check_size(self, size: int) -> None:
        """Add ``size`` bytes to the total size of the content streams that were read.

        Raises
        ------
        DrawingTooLarge
            The total size exceeds the limit.
        """
        self._read += size
        max_bytes = self.file.limits.bytes
        if self._read > max_bytes:
            raise DrawingTooLarge("pdf.expands-too-far", limit=max_bytes / 2**20)

    def run(self, data: bytes, state: State, context: StreamContext) -> None:
        """Interpret a content stream of a page or of a form.

        Parameters
        ----------
        data
            The unpacked content stream.
        state
            The graphics state at the start of the stream.
        context
            Properties that the stream inherits from the streams that contain it.

        Raises
        ------
        NotADrawing
            The stream is truncated.
        """
        try:
            Stream(self._page, state, context).interpret(data)
        except TruncatedStream as error:
            path = context.path[:-1]
            location = Message("pdf.form-named", name=path) if path else Message("pdf.page")
            raise NotADrawing(
                "pdf.content-damaged", where=location, reason=Message(error.code)
            ) from None

    def form(self, node: StreamObject, state: State, context: StreamContext) -> None:
        """Interpret the content stream of a form, with the matrix and the visible area of the form.

        Parameters
        ----------
        node
            The form.
        state
            The graphics state at the operator that draws the form.
        context
            Properties that the form inherits from the streams that contain it.
        """
        file = self.file
        if (matrix := file.numbers(node, "/Matrix", 6)) is not None:
            a, b, c, d, e, f = matrix
            state = state._replace(matrix=compose(state.matrix, (a, b, c, d, e, f)))
        if (box := file.numbers(node, "/BBox", 4)) is not None:
            corners = [(x, y) for x in box[::2] for y in box[1::2]]
            state = state._replace(
                clip=intersect(state.clip, transformed_box(state.matrix, corners))
            )
        resources = file.entry(node, "/Resources")
        if isinstance(resources, DictionaryObject):
            context = context._replace(resources=resources)
        data = file.data(node)
        self._check_size(len(data))
        self.run(data, state, context)
