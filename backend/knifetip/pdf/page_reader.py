"""page_reader: read a PDF page with all copies of its forms (reusable content streams).

``read_page`` returns ``PageLines``: the paths, and a row of the import report for every path, text
and image.  Coordinates are points on the displayed page, with (0, 0) at its lower left corner.  The
total size of the content streams is limited; the stream of a form counts once for each copy.

Source: ISO 32000-1, chapters 7.7.3, 7.8 and 8.10.
"""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from functools import lru_cache
from typing import Final

from pypdf.generic import DictionaryObject, StreamObject

from knifetip.drawing_builder.clip import UNBOUNDED, Box, Region
from knifetip.drawing_builder.filled_region import filled_region
from knifetip.errors import DrawingTooLarge, NotADrawing
from knifetip.formats.limits import Limits
from knifetip.geometry.affine import Matrix, compose
from knifetip.messages import Message
from knifetip.pdf.content import TruncatedStream
from knifetip.pdf.document import Page, PdfFile
from knifetip.pdf.form_sizes import FormSizes
from knifetip.pdf.layers import Layers
from knifetip.pdf.page_lines import LayerMark, PageLines
from knifetip.pdf.path_builder import PathBuilder
from knifetip.pdf.resources import Resources
from knifetip.pdf.stream import PageContext, State, Stream, StreamContext

#: Largest number of other pages of which the lines are counted, and of bytes of their content.
_OTHER_PAGES: Final = 50
_OTHER_PAGES_BYTES: Final = 2 * 2**20


def read_page(file: PdfFile, page: Page) -> PageLines:
    """Return the paths, the texts and the import report of a page.

    Raises
    ------
    NotADrawing
        The content of the page is truncated.
    DrawingTooLarge
        The size of the page with all copies of its forms exceeds the limits.
    """
    reader = _PageReader(file, page, file.limits.bytes)
    reader.read_page(page)
    return reader.drawn


def report_other_pages(
    file: PdfFile, number: int, others: Sequence[tuple[int, Page]], lines: PageLines
) -> None:
    """Add a row to the import report ``lines`` of a page if the file has other pages.

    The row contains which of the other pages has the most lines, unless the pages are too many or
    too large to be read.

    Parameters
    ----------
    file
        The PDF.
    number
        Number of the page that was read.
    others
        The other pages with their numbers.
    lines
        The page that was read.
    """
    if not others:
        return
    reason = Message("import.other-pages", pages=len(others) + 1, page=number)
    segments: list[int] = []
    bytes_left = _OTHER_PAGES_BYTES
    # A damaged page is no reason to refuse the one that is read, and pypdf may raise anything.
    with suppress(Exception):
        for _, page in others if len(others) <= _OTHER_PAGES else ():
            reader = _PageReader(file, page, bytes_left)
            reader.read_page(page)
            bytes_left -= reader.bytes_read
            segments.append(len(reader.drawn.path.kind))
    if len(segments) == len(others) and any(segments):
        most = max(range(len(others)), key=segments.__getitem__)
        reason = Message(
            "import.other-pages-lines",
            others=len(others),
            page=number,
            most=others[most][0],
            lines=segments[most],
        )
    lines.row("", "page", LayerMark("", ""), reason)


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


@lru_cache(maxsize=256)
def _frame_region(left: float, low: float, right: float, high: float, matrix: Matrix) -> Region:
    """Return the region of the box of a form; a form is often drawn again with the same matrix."""
    frame = PathBuilder(Limits())
    frame.add("re", [left, low, right - left, high - low])
    return filled_region(frame.table(), matrix, even_odd=False)


class _PageReader:
    """Interprets the content streams of a page and of the forms that the page contains."""

    def __init__(self, file: PdfFile, page: Page, max_bytes: int) -> None:
        self.file = file
        self._matrix, visible = _display_matrix(page)
        self.drawn = PageLines(file.limits, visible)
        resources = Resources(file)
        self._page = PageContext(
            file, self.drawn, Layers(file), resources, visible, set(), self.form
        )
        self._form_bytes = 0
        self._form_data: dict[int, tuple[StreamObject, bytes]] = {}
        self._sizes = FormSizes(file, resources, self._data_of_form)
        self.bytes_read = 0
        self._max_bytes = max_bytes

    def read_page(self, page: Page) -> None:
        """Interpret the content of a page and collect its paths, its texts and its import report.

        The page's annotations are added to the import report as dropped.
        """
        state = State(self._matrix)
        none = LayerMark("", "")
        contents = self._contents(page)
        self._sizes.check(contents, page.resources, self._max_bytes - self.bytes_read)
        self.run(contents, state, StreamContext("", (), none, page.resources))
        if notes := len(self.file.array(page.node, "/Annots")):
            reason = Message("import.annotations", count=notes)
            self.drawn.row("", "annotation", none, reason)

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

        Raises ``DrawingTooLarge``: the total size exceeds the limit.
        """
        self.bytes_read += size
        self._refuse_beyond(self.bytes_read)

    def _refuse_beyond(self, size: int) -> None:
        if size > self._max_bytes:
            raise DrawingTooLarge("pdf.expands-too-far", limit=self._max_bytes / 2**20)

    def run(self, data: bytes, state: State, context: StreamContext) -> None:
        """Interpret a content stream of a page or of a form.

        ``data``: the unpacked content stream.
        ``state``: the graphics state at the start of the stream.
        ``context``: properties that the stream inherits from the streams that contain it.
        Raises ``NotADrawing``: the stream is truncated.
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

        ``node``: the form.
        ``state``: the graphics state at the operator that draws the form.
        ``context``: properties that the form inherits from the streams that contain it.
        """
        file = self.file
        if (matrix := file.numbers(node, "/Matrix", 6)) is not None:
            a, b, c, d, e, f = matrix
            state = state._replace(matrix=compose(state.matrix, (a, b, c, d, e, f)))
        if (box := file.numbers(node, "/BBox", 4)) is not None:
            region = _frame_region(*box, state.matrix)
            state = state._replace(clip=self._page.clip(state.clip, region))
        resources = file.entry(node, "/Resources")
        if isinstance(resources, DictionaryObject):
            context = context._replace(resources=resources)
        data = self._data_of_form(node)
        self._check_size(len(data))
        self.run(data, state, context)

    def _data_of_form(self, node: StreamObject) -> bytes:
        """Return the content stream of a form, which is unpacked once.

        Raises ``DrawingTooLarge``: the different streams of forms together exceed the limit.
        """
        cached = self._form_data.get(id(node))
        if cached is None:
            data = self.file.data(node)
            self._form_bytes += len(data)
            self._refuse_beyond(self._form_bytes)
            # The node is kept, so that no other node gets its id.
            cached = self._form_data[id(node)] = node, data
        return cached[1]
