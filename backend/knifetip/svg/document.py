"""document: parse an SVG into a tree of limited size, without loading any other file.

``parse_document`` takes the bytes of a file, XML or gzip of XML, and returns a tree of ``Node``.

The parser is Expat; this module restricts it.  A DOCTYPE is allowed, since older SVG files have
one, but the files that the DOCTYPE names are never loaded.  Entities that contain short plain text,
as Illustrator writes them, are expanded.  Entities that refer to other entities or files, or that
would make the SVG too large, are refused before anything is expanded.
"""

from __future__ import annotations

import zlib
from collections.abc import Iterator
from typing import Any, Final
from xml.parsers import expat

from knifetip.errors import DrawingTooLarge, NotADrawing
from knifetip.formats.limits import Limits
from knifetip.formats.xml_builder import XmlBuilder

SVG: Final = "http://www.w3.org/2000/svg"
_GZIP: Final = b"\x1f\x8b"
#: Largest number of characters that an entity may expand to, over all references.
_EXPANSION: Final = 1 << 20
#: Elements whose text is kept.
_WITH_TEXT: Final = frozenset(("style", "text", "tspan", "textPath", "a"))


class Node:
    """A node of the tree of an XML document: an element, or a text, whose ``tag`` is empty."""

    __slots__ = ("attributes", "children", "tag", "text")

    def __init__(self, tag: str, attributes: dict[str, str], text: str = "") -> None:
        self.tag = tag
        self.attributes = attributes
        self.children: list[Node] = []
        self.text = text

    # The interface of xml.etree elements that cssselect2 needs.

    def __iter__(self) -> Iterator[Node]:
        return (child for child in self.children if child.tag)

    def get(self, name: str, default: str | None = None) -> str | None:
        return self.attributes.get(name, default)

    @property
    def attrib(self) -> dict[str, str]:
        return self.attributes


def parse_document(data: bytes, limits: Limits) -> Node:
    """Return the root element of an SVG.

    Tags in the tree have no namespace prefix; attributes have the names that the file contains.
    Elements of other namespaces, such as the private data of editors, are omitted with their
    content.

    Parameters
    ----------
    data
        Content of the file: XML, or gzip of XML.
    limits
        Limits of the number of elements and of the unpacked size.

    Raises
    ------
    NotADrawing
        The file is not an SVG, is truncated or damaged, or its DOCTYPE has dangerous entities.
    DrawingTooLarge
        The number or depth of elements, or the unpacked size, exceeds the limits.
    """
    if data.startswith(_GZIP):
        data = _unpack(data, limits)
    builder = _TreeBuilder(data, limits)
    builder.parse(data)
    if builder.root is None:
        raise NotADrawing("svg.empty")
    return builder.root


def _unpack(data: bytes, limits: Limits) -> bytes:
    """Return the unpacked content of gzip data.

    Raises ``NotADrawing``: the data is truncated or damaged.
    Raises ``DrawingTooLarge``: the unpacked content is larger than ``limits`` allow.
    """
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


class _TreeBuilder(XmlBuilder):
    """Builds the tree of one XML file."""

    def __init__(self, data: bytes, limits: Limits) -> None:
        super().__init__(limits, "SVG")
        self.root: Node | None = None
        self._references = data.count(b"&") + data.count(b"%")
        self._open: list[Node] = []
        self._foreign = 0  # depth within an element of another namespace
        self._prefixes = {""}

    def restrict(self, parser: expat.XMLParserType) -> None:
        parser.EntityDeclHandler = self._entity

    def start(self, name: str, attributes: dict[str, str]) -> None:
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
        if self._foreign:
            self._foreign -= 1
        else:
            self._open.pop()

    def text(self, text: str) -> None:
        if not self._foreign and self._open and self._open[-1].tag in _WITH_TEXT:
            self._open[-1].children.append(Node("", {}, text))

    def _entity(
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
        if len(value) * self._references > _EXPANSION:
            raise NotADrawing("svg.long-entity", name=name[:40], length=len(value))
