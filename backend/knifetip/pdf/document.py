"""document: open a PDF and find its first page.

``PdfFile`` gives access to the objects of the file and limits their size and the reading time.
``read_page_tree`` returns the ``Page``.

pypdf parses the objects; this module checks the type of each object.  Encrypted files that need a
password are refused.  Files with a stream that cannot be unpacked to its end are also refused,
because lines would be missing.

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

from pypdf import PasswordType, PdfReader, apply_configuration
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

from knifetip.drawing_builder.clip import UNBOUNDED, Box
from knifetip.errors import DrawingTooLarge, KnifetipError, NotADrawing
from knifetip.formats.limits import REACH, Limits
from knifetip.model.unit import MILLIMETRES

# pypdf logs everything that it repairs; the import report contains what matters to the user.
logging.getLogger("pypdf").addHandler(logging.NullHandler())

#: Largest number of nodes of the page tree that are searched for pages.
_NODES: Final = 1000
_INHERITED: Final = ("/Resources", "/MediaBox", "/CropBox", "/Rotate")
#: Number of last bytes of a file in which its end mark is searched.
_TAIL: Final = 1024


class PdfFile:
    """The objects of a PDF, which are read within limits of time and size."""

    def __init__(self, data: bytes, limits: Limits) -> None:
        self.limits = limits
        self._until = time.monotonic() + limits.seconds
        start = data.find(b"%PDF", 0, _TAIL)
        if start < 0:
            raise NotADrawing("pdf.no-header")
        if b"%%EOF" not in data.rstrip(b"\0\t\n\f\r ")[-_TAIL:]:
            raise NotADrawing("pdf.cut-short", bytes=len(data))
        try:
            self._reader = _Reader(_TimedBytes(data[start:], self.check_time), self.check_time)
            locked = self._reader.is_encrypted and not self._unlock()
        except KnifetipError:
            raise
        except Exception:
            if b"/Encrypt" not in data:
                raise
            locked = True
        if locked:
            raise NotADrawing("pdf.encrypted")
        self.root: DictionaryObject = self._reader.root_object

    def _unlock(self) -> bool:
        """Open an encrypted file with an empty password, as viewers do; return whether it opens.

        Such a file only asks its readers not to print or copy it.
        """
        return self._reader.decrypt("") != PasswordType.NOT_DECRYPTED

    def check_time(self) -> None:
        """Raise an error if the file has been open for longer than the time limit.

        Raises
        ------
        DrawingTooLarge
            The time since the file was opened exceeds the limit.
        """
        if time.monotonic() > self._until:
            raise DrawingTooLarge("reading.too-slow", seconds=self.limits.seconds, format="PDF")

    def resolve(self, value: object) -> Any:
        """Return the object to which the reference ``value`` refers.

        A value that is not a reference is returned unchanged.  None is returned if the object does
        not exist or is the null object.
        """
        for _ in range(16):
            if not isinstance(value, IndirectObject):
                return None if isinstance(value, NullObject) else value
            self.check_time()
            value = value.get_object()
        return None

    def entry(self, holder: object, key: str) -> Any:
        """Return the entry ``key`` of the dictionary ``holder``; a reference is resolved.

        None is returned if ``holder`` is not a dictionary or has no such entry.
        """
        if not isinstance(holder, DictionaryObject) or key not in holder:
            return None
        return self.resolve(holder.raw_get(key))

    def array(self, holder: object, key: str) -> list[Any]:
        """Return the items of the array that is the entry ``key`` of the dictionary ``holder``.

        The list is empty if there is no such array.  References among the items are not resolved.
        """
        entry = self.entry(holder, key)
        return list(entry) if isinstance(entry, ArrayObject) else []

    def numbers(self, holder: object, key: str, count: int) -> list[float] | None:
        """Return the array of numbers that is the entry ``key`` of the dictionary ``holder``.

        None is returned if the entry is not an array of ``count`` finite numbers.
        """
        numbers = [number(self.resolve(value)) for value in self.array(holder, key)]
        if len(numbers) != count or not all(map(math.isfinite, numbers)):
            return None
        return numbers

    def data(self, stream: StreamObject) -> bytes:
        """Return the unpacked data of a stream.

        Raises
        ------
        NotADrawing
            The data is truncated or damaged.
        DrawingTooLarge
            The unpacked data is larger than the limit of the size of a file.
        """
        packing = self.entry(stream, "/Filter")
        steps = packing if isinstance(packing, ArrayObject) else [packing]
        steps = [self.resolve(step) for step in steps]
        if not steps or steps[-1] != "/FlateDecode" or "/DecodeParms" in stream:
            return stream.get_data()
        # pypdf returns part of a damaged stream; a drawing needs all its lines.
        outer = EncodedStreamObject()
        outer[NameObject("/Filter")] = ArrayObject(steps[:-1])
        outer._data = stream._data
        return _unpack(outer.get_data(), self.limits.bytes)


class _Reader(PdfReader):
    """A pypdf reader that checks the time limit before it reads an object."""

    def __init__(self, stream: io.BytesIO, check_time: Callable[[], None]) -> None:
        self._check_time = check_time
        super().__init__(stream)

    def cache_get_indirect_object(self, generation: int, idnum: int) -> PdfObject | None:
        self._check_time()
        return super().cache_get_indirect_object(generation, idnum)


class _TimedBytes(io.BytesIO):
    """A file in memory that checks the time limit before each read."""

    def __init__(self, data: bytes, check_time: Callable[[], None]) -> None:
        super().__init__(data)
        self._check_time = check_time

    def read(self, size: int | None = -1, /) -> bytes:
        self._check_time()
        return super().read(size)


@contextmanager
def limit_pypdf(limits: Limits) -> Iterator[None]:
    """Limit the size of unpacked streams in pypdf for the duration of a ``with`` statement.

    The limit is a quarter of the limit of the size of a file, which is enough for all streams that
    pypdf unpacks.  Content streams may be larger; this module unpacks them itself.
    """
    max_bytes = limits.bytes // 4
    with apply_configuration(
        maximum_declared_stream_length=limits.bytes,
        array_based_stream_maximum_output_length=max_bytes,
        zlib_maximum_output_length=max_bytes,
        zlib_maximum_recovery_input_length=0,
        lzw_maximum_output_length=max_bytes,
        run_length_maximum_output_length=max_bytes,
        stream_decoding_work_maximum_length=2 * limits.bytes,
        disable_legacy_handling=True,
    ):
        yield


def _unpack(data: bytes, max_bytes: int) -> bytes:
    """Return the unpacked content of zlib data.

    Raises ``NotADrawing``: the data is truncated or damaged.
    Raises ``DrawingTooLarge``: the content is larger than ``max_bytes`` bytes.
    """
    stream = zlib.decompressobj()
    try:
        plain = stream.decompress(data, max_bytes + 1)
    except zlib.error as error:
        raise NotADrawing("pdf.stream-damaged", reason=error) from None
    if len(plain) > max_bytes:
        raise DrawingTooLarge("pdf.stream-too-large", limit=max_bytes / 2**20)
    if not stream.eof:
        raise NotADrawing("pdf.stream-cut-short")
    return plain


def number(value: object) -> float:
    """Return ``value`` as a float if it is a number, else NaN."""
    return float(value) if isinstance(value, (int, float)) else math.nan


@dataclass(frozen=True, slots=True)
class Page:
    """The first page of a PDF, with its visible area, rotation and unit."""

    node: DictionaryObject
    resources: DictionaryObject
    box: Box  #: the visible area, in page coordinates
    rotate: int  #: clockwise quarter turns for display
    unit: float  #: points in one unit of the page coordinates


def read_page_tree(file: PdfFile, number: int) -> tuple[Page, list[tuple[int, Page]]]:
    """Return a page of a PDF, and the other pages with their numbers.

    Of a very long file only the first pages are returned.

    Parameters
    ----------
    file
        The PDF.
    number
        Number of the page, from 1.

    Raises
    ------
    NotADrawing
        The file has no such page.
    DrawingTooLarge
        The width or height of a page is larger than the limit of a drawing.
    """
    leaves = list(_leaves(file))
    if not leaves:
        raise NotADrawing("pdf.no-page")
    if number > len(leaves):
        raise NotADrawing("pdf.no-such-page", page=number, pages=len(leaves))
    chosen = _page(file, *leaves[number - 1])
    others = [(at, _page(file, *leaf)) for at, leaf in enumerate(leaves, start=1) if at != number]
    return chosen, others


def _page(file: PdfFile, node: DictionaryObject, inherited: DictionaryObject) -> Page:
    """Return a page of a PDF.

    ``node``, ``inherited``: dictionary of the page, and the attributes that the page has or
    inherits.
    Raises ``DrawingTooLarge``: the width or height of the page is larger than the limit of a
    drawing.
    """
    unit = number(file.entry(node, "/UserUnit"))
    unit = unit if 0.0 < unit < math.inf else 1.0
    media = _box(file, inherited, "/MediaBox")
    crop = _box(file, inherited, "/CropBox")
    box = media or crop or UNBOUNDED
    if media and crop:
        left, low = map(max, media[:2], crop[:2])
        right, high = map(min, media[2:], crop[2:])
        # Programs ignore a crop box that does not overlap the page.
        box = (left, low, right, high) if left < right and low < high else media
    widest = max(map(abs, box)) * unit * MILLIMETRES["pt"]
    if math.isfinite(widest) and widest > REACH:
        raise DrawingTooLarge("pdf.page-too-large", size=widest, limit=REACH)
    turn = number(file.entry(inherited, "/Rotate"))
    rotate = round(turn / 90.0) % 4 if math.isfinite(turn) else 0
    resources = file.entry(inherited, "/Resources")
    if not isinstance(resources, DictionaryObject):
        resources = DictionaryObject()
    return Page(node, resources, box, rotate, unit)


def _leaves(file: PdfFile) -> Iterator[tuple[DictionaryObject, DictionaryObject]]:
    """Yield the pages of a PDF.

    The second value is a dictionary of the attributes that the page has or inherits from the nodes
    of the page tree that contain it.
    """
    pages = file.entry(file.root, "/Pages")
    stack: list[tuple[Any, DictionaryObject]] = [(pages, DictionaryObject())]
    for _ in range(_NODES):
        if not stack:
            return
        node, inherited_entries = stack.pop()
        node = file.resolve(node)
        if not isinstance(node, DictionaryObject):
            continue
        inherited = DictionaryObject(inherited_entries)
        inherited.update({key: node.raw_get(key) for key in _INHERITED if key in node})
        if "/Kids" not in node:
            yield node, inherited
            continue
        stack += [(kid, inherited) for kid in reversed(file.array(node, "/Kids")[:_NODES])]


def _box(file: PdfFile, holder: DictionaryObject, key: str) -> Box | None:
    sides = file.numbers(holder, key, 4)
    if sides is None:
        return None
    x, y, right, high = sides
    box = min(x, right), min(y, high), max(x, right), max(y, high)
    return box if box[0] < box[2] and box[1] < box[3] else None
