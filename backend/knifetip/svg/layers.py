"""layers: what an SVG calls the layer of an element.

    inkscape:label of a layer, id of a group, label, id or class of the element -> name

SVG has no layers.  Inkscape marks groups as such; Illustrator writes its layers as groups with an
id; others name the elements.  Names that a program counts up by itself say nothing and are passed
over: what then has no name lies on layer 0, as in a DXF.
"""

from __future__ import annotations

import re
from typing import Final, NamedTuple

from knifetip.svg.document import Node


class Layer(NamedTuple):
    """A name, and whether the file itself calls it a layer."""

    name: str
    real: bool


NOWHERE: Final = Layer("", False)
NAMELESS: Final = "0"
#: Attributes that hold no name, of elements that are written by the thousand.
_NAMELESS: Final = frozenset(
    {"d", "style", "stroke", "fill", "stroke-width", "stroke-dasharray", "transform", "points"}
    | {"x", "y", "x1", "y1", "x2", "y2", "cx", "cy", "r", "rx", "ry", "width", "height"}
)

#: Names that drawing programs count up.
_COUNTED: Final = re.compile(
    r"_?(?:g|group|grp|layer|ebene|calque|livello|capa|path|pfad|compound_?path|line|linie|"
    r"polyline|polygon|rect|rectangle|circle|ellipse|use|text|svg|symbol|clip|clippath|mask|image|"
    r"shape|st|cls|fil|str|entity|object|svgid)?[-_]?(?:\d[-_\d]*)?_?",
    re.IGNORECASE,
)
_SPELLED: Final = re.compile(r"_x([0-9A-Fa-f]{2,5})_")
#: Illustrator's way to tell two of the same name apart: ``Cut_1_``.
_SECOND: Final = re.compile(r"_\d+_$")
_PREFIX: Final = re.compile(r"(?:layer|ebene|calque)[-_ ]+(?=[^\W\d])", re.IGNORECASE)
_TALLY: Final = re.compile(r"[-_ .]?\d+$")


def around(node: Node, inherited: Layer) -> Layer:
    """Return the layer of what is inside a group."""
    given = node.attributes
    name = _label(node)
    if _is_layer(node):
        return Layer(name or plain(given.get("id", "")) or inherited.name, True)
    if inherited.real:
        return inherited
    for candidate in (name, plain(given.get("id", ""))):
        if candidate and not _COUNTED.fullmatch(candidate):
            return Layer(candidate, False)
    return inherited


def own(node: Node, inherited: Layer) -> str:
    """Return the layer of an element that is a line."""
    if inherited.name:
        return inherited.name
    given = node.attributes
    if not given.keys() - _NAMELESS:
        return NAMELESS
    # Of crease1, crease2 … all are crease; a class is shared as it is.
    names = [_TALLY.sub("", one) for one in (_label(node), plain(given.get("id", "")))]
    for candidate in (*names, *given.get("class", "").split()):
        if candidate and not _COUNTED.fullmatch(candidate):
            return candidate
    return NAMELESS


def plain(identity: str) -> str:
    """Return an id without what programs add to the names that people gave."""
    name = _SPELLED.sub(lambda found: _letter(int(found[1], 16)), identity)
    return _PREFIX.sub("", _SECOND.sub("", name)).strip()


def _letter(code: int) -> str:
    return chr(code) if code < 0x110000 and chr(code).isprintable() else "_"


def _label(node: Node) -> str:
    for key, value in node.attributes.items():
        if key.endswith(":label"):
            return value.strip()
    return ""


def _is_layer(node: Node) -> bool:
    return any(
        key.endswith(":groupmode") and value == "layer" for key, value in node.attributes.items()
    )
