"""form_sizes: count what the forms of a page expand to, before any form is interpreted.

A form is a content stream that other streams draw by its name, so a file of a few kilobytes may
expand to billions of lines.  Each stream is searched once, however often it is drawn.

The operators are found by their letters alone, which takes a small part of the time of parsing.
The letters in a text or in an image may therefore be counted too; an ordinary page is far from the
limits.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable
from typing import Final, NamedTuple

from pypdf.generic import DictionaryObject, IndirectObject, StreamObject

from knifetip.errors import DrawingTooLarge
from knifetip.pdf.content import decode_name
from knifetip.pdf.document import PdfFile
from knifetip.pdf.resources import Resources

_BLANK: Final = rb"[\x00\t\n\f\r ]"
_ENDS: Final = rb"(?![^\x00\t\n\f\r \[\]/<>()%{}])"
#: The operator that draws a form or an image, with the name of the object.
_DRAW: Final = re.compile(rb"/([^\x00\t\n\f\r \[\]/<>()%{}]*)" + _BLANK + rb"+Do" + _ENDS)
#: The operators that stroke or fill a path.
_PAINT: Final = re.compile(_BLANK + rb"(?:[SsFBb]|f|[fBb]\*)" + _ENDS)


class ExpandedSize(NamedTuple):
    """What a content stream contains with all copies of its forms."""

    elements: int  #: painted paths, and drawn forms and images
    bytes: int  #: length of the content streams of the forms


class FormSizes:
    """Counts the expanded elements and bytes of content streams.

    Parameters
    ----------
    file, resources
        The PDF, and its named resources.
    data_of
        Function that returns the unpacked content stream of a form.
    """

    def __init__(
        self, file: PdfFile, resources: Resources, data_of: Callable[[StreamObject], bytes]
    ) -> None:
        self._file = file
        self._resources = resources
        self._data_of = data_of
        self._sizes: dict[tuple[object, int], ExpandedSize] = {}

    def check(self, data: bytes, resources: DictionaryObject, max_bytes: int) -> None:
        """Raise an error if a content stream expands to more than the limits allow.

        Parameters
        ----------
        data, resources
            The content stream of a page, and its resource dictionary.
        max_bytes
            Largest length of the content streams of all copies of forms.

        Raises
        ------
        DrawingTooLarge
            The number of elements, the length of the streams, or the depth of forms exceeds its
            limit.
        """
        if b"Do" not in data:
            return
        size = self._size(data, resources, ())
        if size.bytes > max_bytes:
            raise DrawingTooLarge("pdf.expands-too-far", limit=max_bytes / 2**20)
        limit = self._file.limits.entities
        if size.elements > limit:
            raise DrawingTooLarge("reading.expands-too-far", limit=limit, format="PDF")

    def _size(
        self, data: bytes, resources: DictionaryObject, containing: tuple[object, ...]
    ) -> ExpandedSize:
        """Return the size of a content stream with its forms.

        ``containing`` are the keys of the forms that contain the stream, which are not drawn again.
        """
        elements, length = sum(1 for _ in _PAINT.finditer(data)), 0
        for written, times in Counter(_DRAW.findall(data)).items():
            elements += times
            raw = self._resources.find(resources, "/XObject", decode_name(written))
            node = self._file.resolve(raw)
            if not isinstance(node, StreamObject) or self._file.entry(node, "/Subtype") != "/Form":
                continue
            key = (raw.idnum, raw.generation) if isinstance(raw, IndirectObject) else id(node)
            if key in containing:
                continue
            if len(containing) >= self._file.limits.insert_depth:
                raise DrawingTooLarge(
                    "reading.nested-too-deep", limit=self._file.limits.insert_depth, format="PDF"
                )
            inner = self._form_size(node, key, resources, containing)
            elements, length = elements + times * inner.elements, length + times * inner.bytes
        return ExpandedSize(elements, length)

    def _form_size(
        self,
        node: StreamObject,
        key: object,
        inherited: DictionaryObject,
        containing: tuple[object, ...],
    ) -> ExpandedSize:
        own = self._file.entry(node, "/Resources")
        resources = own if isinstance(own, DictionaryObject) else inherited
        cached = self._sizes.get((key, id(resources)))
        if cached is None:
            data = self._data_of(node)
            elements, length = self._size(data, resources, (*containing, key))
            cached = ExpandedSize(elements, length + len(data))
            self._sizes[key, id(resources)] = cached
        return cached
