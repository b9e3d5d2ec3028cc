"""walk: a page and the forms that it repeats, where they stand.

    File, Page -> Drawn: a ledger row for every path, text and picture, and the lines

Coordinates go to points on the page as it is shown, (0, 0) being its lower left corner.  What forms
stand for is counted while it is followed.

Source: ISO 32000-1, chapters 7.7.3, 7.8 and 8.10.
"""

from __future__ import annotations

from pypdf.generic import DictionaryObject, StreamObject

from knifetip.errors import DrawingTooLarge, NotADrawing
from knifetip.geometry.affine import Matrix, chained
from knifetip.pdf.content import CutShort
from knifetip.pdf.document import EVERYWHERE, Box, File, Page
from knifetip.pdf.drawn import Drawn, Mark
from knifetip.pdf.layers import Layers
from knifetip.pdf.resources import Named
from knifetip.pdf.stream import Around, Here, State, Stream, boxed, within


def walk(file: File, page: Page) -> Drawn:
    """Return the lines and the ledger's rows of a page.

    Raises
    ------
    NotADrawing
        The page stops in the middle of something.
    DrawingTooLarge
        It has, or its forms stand for, more than the limits allow.
    """
    walker = _Walk(file)
    walker.page(page)
    return walker.drawn


def _upright(page: Page) -> tuple[Matrix, Box]:
    """Return the matrix from a page's coordinates to points as it is shown, and what is seen."""
    u = page.unit
    boundless = page.box == EVERYWHERE
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
    return turned[page.rotate], EVERYWHERE if boundless else (0.0, 0.0, wide, tall)


class _Walk:
    """What is shared by the content streams of a page."""

    def __init__(self, file: File) -> None:
        self.file = file
        self.drawn = Drawn(file.limits)
        self._here = Here(file, self.drawn, Layers(file), Named(file), set(), self.form)
        self._read = 0

    def page(self, page: Page) -> None:
        """Follow a page, and tell the ledger what is beside it."""
        matrix, seen = _upright(page)
        state = State(matrix, seen)
        none = Mark("", "")
        self.run(self._contents(page), state, Around("", (), none, page.resources))
        if notes := len(self.file.array(page.node, "/Annots")):
            what = f"{notes} notes and fields that lie on the page are not cut"
            self.drawn.row("", "annotation", none, what)
        if page.count > 1:
            what = f"only the first of {page.count} pages is read"
            self.drawn.row("", "page", none, what)

    def _contents(self, page: Page) -> bytes:
        given = self.file.entry(page.node, "/Contents")
        if "/Contents" not in page.node:
            return b""
        parts = []
        for one in given if isinstance(given, list) else [given]:
            stream = self.file.seen(one)
            if not isinstance(stream, StreamObject):
                raise NotADrawing("pdf.part-missing")
            parts.append(self.file.data(stream))
            self._count(len(parts[-1]))
        return b"\n".join(parts)

    def _count(self, size: int) -> None:
        """Refuse what stands for more drawing than a file may hold."""
        self._read += size
        most = self.file.limits.bytes
        if self._read > most:
            raise DrawingTooLarge("pdf.expands-too-far", limit=most / 2**20)

    def run(self, data: bytes, state: State, around: Around) -> None:
        """Follow a content stream."""
        try:
            Stream(self._here, state, around).follow(data)
        except CutShort as error:
            where = f"form {around.path[:-1]}" if around.path else "page"
            raise NotADrawing("pdf.content-damaged", where=where, reason=error) from None

    def form(self, node: StreamObject, state: State, around: Around) -> None:
        """Follow the content of a form."""
        file = self.file
        if (matrix := file.numbers(node, "/Matrix", 6)) is not None:
            a, b, c, d, e, f = matrix
            state = state._replace(matrix=chained(state.matrix, (a, b, c, d, e, f)))
        if (box := file.numbers(node, "/BBox", 4)) is not None:
            corners = [(x, y) for x in box[::2] for y in box[1::2]]
            state = state._replace(clip=within(state.clip, boxed(state.matrix, corners)))
        resources = file.entry(node, "/Resources")
        if isinstance(resources, DictionaryObject):
            around = around._replace(resources=resources)
        data = file.data(node)
        self._count(len(data))
        self.run(data, state, around)
