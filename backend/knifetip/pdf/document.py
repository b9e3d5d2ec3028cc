"""document: the first page of a PDF, with what it may draw and how large it is.

    bytes -> File (objects, each in bounded time and size) -> Page

pypdf finds the objects; nothing is taken from it without a type.  What is encrypted is refused, and
so is a stream that does not unpack to its end, because the lines at its end would be missing.

Source: ISO 32000-1, chapters 7.5, 7.7 and 14.11.2.
"""

from __future__ import annotations

import io
import logging
import math
import time
import zlib
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any, Final

from pypdf import PdfReader, apply_configuration
from pypdf.generic import (
    ArrayObject,
    DictionaryObject,
    EncodedStreamObject,
    IndirectObject,
    NameObject,
    NullObject,
    PdfObject,
    StreamObject,
)

from knifetip.errors import DrawingTooLarge, KnifetipError, NotADrawing
from knifetip.formats.limits import REACH, Limits
from knifetip.model.unit import MILLIMETRES

# pypdf tells of everything that it mends; the ledger tells the user what matters.
logging.getLogger("pypdf").addHandler(logging.NullHandler())

#: left, low, right, high (points).
Box = tuple[float, float, float, float]
EVERYWHERE: Final[Box] = (-math.inf, -math.inf, math.inf, math.inf)

#: Nodes of the page tree on the way to the first page.
_NODES: Final = 1000
_INHERITED: Final = ("/Resources", "/MediaBox", "/CropBox", "/Rotate")
#: The last bytes of a file, in which readers look for its end.
_TAIL: Final = 1024


class File:
    """The objects of a PDF."""

    def __init__(self, data: bytes, limits: Limits) -> None:
        self.limits = limits
        self._until = time.monotonic() + limits.seconds
        start = data.find(b"%PDF", 0, _TAIL)
        if start < 0:
            raise NotADrawing("pdf.no-header")
        if b"%%EOF" not in data.rstrip(b"\0\t\n\f\r ")[-_TAIL:]:
            raise NotADrawing("pdf.cut-short", bytes=len(data))
        try:
            self._reader = _Reader(_Timed(data[start:], self.in_time), self.in_time)
            locked = self._reader.is_encrypted
        except KnifetipError:
            raise
        except Exception:
            if b"/Encrypt" not in data:
                raise
            locked = True
        if locked:
            raise NotADrawing("pdf.encrypted")
        self.root: DictionaryObject = self._reader.root_object

    def in_time(self) -> None:
        """Refuse a file that has taken too long.

        Raises
        ------
        DrawingTooLarge
        """
        if time.monotonic() > self._until:
            raise DrawingTooLarge("reading.too-slow", seconds=self.limits.seconds, format="PDF")

    def seen(self, value: object) -> Any:
        """Return what a reference refers to; None for nothing."""
        for _ in range(16):
            if not isinstance(value, IndirectObject):
                return None if isinstance(value, NullObject) else value
            self.in_time()
            value = value.get_object()
        return None

    def entry(self, holder: object, key: str) -> Any:
        """Return an entry of a dictionary, None where there is none or no dictionary."""
        if not isinstance(holder, DictionaryObject) or key not in holder:
            return None
        return self.seen(holder.raw_get(key))

    def array(self, holder: object, key: str) -> list[Any]:
        """Return an entry that is an array, its references as they are; else an empty one."""
        found = self.entry(holder, key)
        return list(found) if isinstance(found, ArrayObject) else []

    def numbers(self, holder: object, key: str, count: int) -> list[float] | None:
        """Return an entry that is so many finite numbers."""
        found = [number(self.seen(value)) for value in self.array(holder, key)]
        if len(found) != count or not all(map(math.isfinite, found)):
            return None
        return found

    def data(self, stream: StreamObject) -> bytes:
        """Return the data of a stream, unpacked.

        Raises
        ------
        NotADrawing
            It does not unpack to its end.
        DrawingTooLarge
            It has more bytes than a file may have.
        """
        packing = self.entry(stream, "/Filter")
        steps = packing if isinstance(packing, ArrayObject) else [packing]
        steps = [self.seen(step) for step in steps]
        if not steps or steps[-1] != "/FlateDecode" or "/DecodeParms" in stream:
            return stream.get_data()
        # pypdf is content with what it gets out of a damaged stream; a carton needs all its lines.
        outer = EncodedStreamObject()
        outer[NameObject("/Filter")] = ArrayObject(steps[:-1])
        outer._data = stream._data
        return _unpacked(outer.get_data(), self.limits.bytes)


class _Reader(PdfReader):
    """pypdf's reader, which looks at the clock before each object of an object stream."""

    def __init__(self, stream: io.BytesIO, in_time: Callable[[], None]) -> None:
        self._in_time = in_time
        super().__init__(stream)

    def cache_get_indirect_object(self, generation: int, idnum: int) -> PdfObject | None:
        self._in_time()
        return super().cache_get_indirect_object(generation, idnum)


class _Timed(io.BytesIO):
    """A file that stops being read when its time is over."""

    def __init__(self, data: bytes, in_time: Callable[[], None]) -> None:
        super().__init__(data)
        self._in_time = in_time

    def read(self, size: int | None = -1, /) -> bytes:
        self._in_time()
        return super().read(size)


@contextmanager
def bounded(limits: Limits) -> Iterator[None]:
    """Let pypdf unpack no more than the streams that hold objects have; drawings are larger."""
    most = limits.bytes // 4
    with apply_configuration(
        maximum_declared_stream_length=limits.bytes,
        array_based_stream_maximum_output_length=most,
        zlib_maximum_output_length=most,
        zlib_maximum_recovery_input_length=0,
        lzw_maximum_output_length=most,
        run_length_maximum_output_length=most,
        stream_decoding_work_maximum_length=2 * limits.bytes,
        disable_legacy_handling=True,
    ):
        yield


def _unpacked(data: bytes, most: int) -> bytes:
    stream = zlib.decompressobj()
    try:
        plain = stream.decompress(data, most + 1)
    except zlib.error as error:
        raise NotADrawing("pdf.stream-damaged", reason=error) from None
    if len(plain) > most:
        raise DrawingTooLarge("pdf.stream-too-large", limit=most / 2**20)
    if not stream.eof:
        raise NotADrawing("pdf.stream-cut-short")
    return plain


def number(value: object) -> float:
    """Return a number as it is, anything else as NaN."""
    return float(value) if isinstance(value, (int, float)) else math.nan


@dataclass(frozen=True, slots=True)
class Page:
    """The first page."""

    node: DictionaryObject
    resources: DictionaryObject
    box: Box  #: what of it is seen, in its own coordinates
    rotate: int  #: quarter turns clockwise in which it is shown
    unit: float  #: points to a unit of its coordinates
    count: int  #: how many pages the file says it has


def first_page(file: File) -> Page:
    """Return the first page of a file.

    Raises
    ------
    NotADrawing
        It has no page.
    DrawingTooLarge
        The page is larger than any drawing may be.
    """
    pages = file.entry(file.root, "/Pages")
    node, inherited = _leaf(file, pages)
    unit = number(file.entry(node, "/UserUnit"))
    unit = unit if 0.0 < unit < math.inf else 1.0
    media = _box(file, inherited, "/MediaBox")
    crop = _box(file, inherited, "/CropBox")
    box = media or crop or EVERYWHERE
    if media and crop:
        left, low = map(max, media[:2], crop[:2])
        right, high = map(min, media[2:], crop[2:])
        # A crop beside the page is a mistake, and shows nothing: programs then show all.
        box = (left, low, right, high) if left < right and low < high else media
    widest = max(map(abs, box)) * unit * MILLIMETRES["pt"]
    if math.isfinite(widest) and widest > REACH:
        raise DrawingTooLarge("pdf.page-too-large", size=widest, limit=REACH)
    turn = number(file.entry(inherited, "/Rotate"))
    rotate = round(turn / 90.0) % 4 if math.isfinite(turn) else 0
    resources = file.entry(inherited, "/Resources")
    if not isinstance(resources, DictionaryObject):
        resources = DictionaryObject()
    count = file.entry(pages, "/Count")
    return Page(node, resources, box, rotate, unit, count if isinstance(count, int) else 1)


def _leaf(file: File, pages: object) -> tuple[DictionaryObject, DictionaryObject]:
    """Return the first page, and what it has from the nodes around it."""
    stack: list[tuple[Any, DictionaryObject]] = [(pages, DictionaryObject())]
    for _ in range(_NODES):
        if not stack:
            break
        node, above = stack.pop()
        node = file.seen(node)
        if not isinstance(node, DictionaryObject):
            continue
        inherited = DictionaryObject(above)
        inherited.update({key: node.raw_get(key) for key in _INHERITED if key in node})
        if "/Kids" not in node:
            return node, inherited
        stack += [(kid, inherited) for kid in reversed(file.array(node, "/Kids")[:_NODES])]
    raise NotADrawing("pdf.no-page")


def _box(file: File, holder: DictionaryObject, key: str) -> Box | None:
    sides = file.numbers(holder, key, 4)
    if sides is None:
        return None
    x, y, right, high = sides
    box = min(x, right), min(y, high), max(x, right), max(y, high)
    return box if box[0] < box[2] and box[1] < box[3] else None
