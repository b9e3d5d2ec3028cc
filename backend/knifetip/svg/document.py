"""document: the bytes of an SVG as a tree, with nothing fetched and no bomb set off.

    bytes (XML, or gzip of XML) -> Node: tag, attributes, children, text

Expat reads; this module decides what it may do.  A DOCTYPE is allowed, since most SVG files had
one, but what it names is never fetched.  The entities that Illustrator writes into it are short
plain text and are read; an entity that names another entity or a file is refused before anything
is expanded, and so is one that would swell the file.
"""

from __future__ import annotations

import zlib
from collections.abc import Iterator
from typing import Any, Final
from xml.parsers import expat

from knifetip.errors import DrawingTooLarge, NotADrawing
from knifetip.formats.limits import Limits

SVG: Final = "http://www.w3.org/2000/svg"
_GZIP: Final = b"\x1f\x8b"
#: Elements inside elements; a drawing program stays below 50.
_DEEPEST: Final = 256
#: Characters that the entities of a file may stand for, all references counted.
_SWOLLEN: Final = 1 << 20
#: Elements whose text is wanted.
_WORDS: Final = frozenset(("style", "text", "tspan", "textPath", "a"))


class Node:
    """An element, or a run of text between elements (``tag`` empty)."""

    __slots__ = ("attributes", "children", "tag", "text")

    def __init__(self, tag: str, attributes: dict[str, str], text: str = "") -> None:
        self.tag = tag
        self.attributes = attributes
        self.children: list[Node] = []
        self.text = text

    # What selectors of style sheets ask of an element, as xml.etree has it.

    def __iter__(self) -> Iterator[Node]:
        return (child for child in self.children if child.tag)

    def get(self, name: str, default: str | None = None) -> str | None:
        return self.attributes.get(name, default)

    @property
    def attrib(self) -> dict[str, str]:
        return self.attributes


def document(data: bytes, limits: Limits) -> Node:
    """Return the root of an SVG.

    Tags of SVG come without their prefix, attributes as they are written; elements of other
    vocabularies (what an editor notes for itself) are left out with all that is in them.

    Raises
    ------
    NotADrawing
        It is no SVG, is cut short or damaged, or its DOCTYPE has entities of the dangerous kind.
    DrawingTooLarge
        It has more elements, deeper ones, or more bytes when unpacked, than the limits allow.
    """
    if data.startswith(_GZIP):
        data = _unpacked(data, limits)
    reading = _Reading(data, limits)
    parser = expat.ParserCreate()
    parser.buffer_text = True
    parser.StartElementHandler = reading.start
    parser.EndElementHandler = reading.end
    parser.CharacterDataHandler = reading.words
    parser.EntityDeclHandler = reading.entity
    try:
        parser.Parse(data, True)
    except expat.ExpatError as error:
        what = expat.ErrorString(error.code) or "damaged"
        if error.code in _UNFINISHED:
            raise NotADrawing("svg.cut-short", line=error.lineno, count=reading.count) from None
        raise NotADrawing(
            "svg.damaged-at", line=error.lineno, column=error.offset, reason=what
        ) from None
    if reading.root is None:
        raise NotADrawing("svg.empty")
    return reading.root


_UNFINISHED: Final = frozenset(
    expat.errors.codes[text]
    for text in (
        expat.errors.XML_ERROR_NO_ELEMENTS,
        expat.errors.XML_ERROR_UNCLOSED_TOKEN,
        expat.errors.XML_ERROR_PARTIAL_CHAR,
        expat.errors.XML_ERROR_UNCLOSED_CDATA_SECTION,
    )
)


def _unpacked(data: bytes, limits: Limits) -> bytes:
    """Return what gzip packed, never more than the limit in memory."""
    stream = zlib.decompressobj(31)
    try:
        plain = stream.decompress(data, limits.bytes + 1)
    except zlib.error as error:
        raise NotADrawing("svg.packed-damaged", reason=error) from None
    if len(plain) > limits.bytes:
        raise DrawingTooLarge("svg.unpacks-too-far", limit=limits.bytes / 2**20)
    if not stream.eof:
        raise NotADrawing("svg.packed-cut-short")
    return plain


class _Reading:
    """The handlers of one file, and the tree as far as it is."""

    def __init__(self, data: bytes, limits: Limits) -> None:
        self.root: Node | None = None
        self.count = 0
        self._references = data.count(b"&") + data.count(b"%")
        self._limits = limits
        self._open: list[Node] = []
        self._deep = 0
        self._foreign = 0  # how deep in elements of another vocabulary
        self._prefixes = {""}

    def start(self, name: str, attributes: dict[str, str]) -> None:
        self._deep += 1
        self.count += 1
        if self._deep > _DEEPEST:
            raise DrawingTooLarge("svg.nested-too-deep", limit=_DEEPEST)
        if self.count > self._limits.entities:
            raise DrawingTooLarge(
                "reading.too-many-elements", limit=self._limits.entities, format="SVG"
            )
        if self._foreign:
            self._foreign += 1
            return
        for key, value in attributes.items():
            if value == SVG and key.startswith("xmlns:"):
                self._prefixes.add(key[6:])
        prefix, _, local = name.rpartition(":")
        if prefix not in self._prefixes:
            if self.root is None:
                raise NotADrawing("svg.other-xml", element=name[:40])
            self._foreign = 1
            return
        node = Node(local, attributes)
        if self.root is None:
            if local != "svg" or attributes.get("xmlns" + ":" * bool(prefix) + prefix, SVG) != SVG:
                raise NotADrawing("svg.other-xml", element=name[:40])
            self.root = node
        else:
            self._open[-1].children.append(node)
        self._open.append(node)

    def end(self, _name: str) -> None:
        self._deep -= 1
        if self._foreign:
            self._foreign -= 1
        else:
            self._open.pop()

    def words(self, text: str) -> None:
        if not self._foreign and self._open and self._open[-1].tag in _WORDS:
            self._open[-1].children.append(Node("", {}, text))

    def entity(
        self,
        name: str,
        is_parameter: int,
        value: str | None,
        _base: Any,
        system: str | None,
        public: str | None,
        _notation: str | None,
    ) -> None:
        if value is None or system is not None or public is not None:
            raise NotADrawing("svg.external-entity", name=name[:40])
        if is_parameter or "&" in value or "%" in value or "<" in value:
            raise NotADrawing("svg.markup-entity", name=name[:40])
        if len(value) * self._references > _SWOLLEN:
            raise NotADrawing("svg.long-entity", name=name[:40], length=len(value))
