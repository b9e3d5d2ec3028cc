"""layers: find the layer name of an SVG element.

SVG has no layers.  Inkscape marks groups (<g> elements) as layers; Illustrator writes layers as
groups with an id; other programs name the elements.  The layer name is therefore taken from the
label of a group that is marked as a layer, the id of a group, or the label, id or class of the
element.  Names that a program generates, such as "path42", are ignored.  An element without a name
is on layer "0", as in a DXF.
"""

from __future__ import annotations

import re
from typing import Final, NamedTuple

from knifetip.svg.document import Node


class Layer(NamedTuple):
    """The name of a layer, and whether the file marks the layer's <g> element as a layer."""

    name: str
    marked: bool


NO_LAYER: Final = Layer("", False)
UNNAMED: Final = "0"
#: Attributes that contain no name; an element that has only these has no name.
_GEOMETRY_ATTRIBUTES: Final = frozenset(
    {"d", "style", "stroke", "fill", "stroke-width", "stroke-dasharray", "transform", "points"}
    | {"x", "y", "x1", "y1", "x2", "y2", "cx", "cy", "r", "rx", "ry", "width", "height"}
)

#: Names that drawing programs generate.
_GENERATED: Final = re.compile(
    r"_?(?:g|group|grp|layer|ebene|calque|livello|capa|path|pfad|compound_?path|line|linie|"
    r"polyline|polygon|rect|rectangle|circle|ellipse|use|text|svg|symbol|clip|clippath|mask|image|"
    r"shape|st|cls|fil|str|entity|object|svgid)?[-_]?(?:\d[-_\d]*)?_?",
    re.IGNORECASE,
)
#: Illustrator's escape of a character, such as ``_x0020_``.
_ESCAPED: Final = re.compile(r"_x([0-9A-Fa-f]{2,5})_")
#: The suffix that Illustrator appends to the second object of a name: ``Cut_1_``.
_DUPLICATE: Final = re.compile(r"_\d+_$")
_PREFIX: Final = re.compile(r"(?:layer|ebene|calque)[-_ ]+(?=[^\W\d])", re.IGNORECASE)
_TRAILING_NUMBER: Final = re.compile(r"[-_ .]?\d+$")


def layer_of_group(node: Node, inherited: Layer) -> Layer:
    """Return the layer that the child elements of the SVG group (<g>) ``node`` inherit.

    ``inherited`` is the layer that the group itself inherits from the elements that contain it.
    """
    attributes = node.attributes
    name = _label(node)
    if _is_layer(node):
        return Layer(name or original_name(attributes.get("id", "")) or inherited.name, True)
    if inherited.marked:
        return inherited
    for candidate in (name, original_name(attributes.get("id", ""))):
        if candidate and not _GENERATED.fullmatch(candidate):
            return Layer(candidate, False)
    return inherited


def layer_of_element(node: Node, inherited: Layer) -> str:
    """Return the layer name of an element that is not a group.

    ``inherited`` is the layer that the element inherits from the group that contains it.
    """
    if inherited.name:
        return inherited.name
    attributes = node.attributes
    if not attributes.keys() - _GEOMETRY_ATTRIBUTES:
        return UNNAMED
    # crease1, crease2 … all become the layer crease; names of classes keep their numbers.
    names = [
        _TRAILING_NUMBER.sub("", one)
        for one in (_label(node), original_name(attributes.get("id", "")))
    ]
    for candidate in (*names, *attributes.get("class", "").split()):
        if candidate and not _GENERATED.fullmatch(candidate):
            return candidate
    return UNNAMED


def original_name(identity: str) -> str:
    """Return the name that a user entered in a drawing program, from the id that the program wrote.

    Escapes, prefixes such as "Layer " and suffixes of duplicates are removed from ``identity``.
    """
    name = _ESCAPED.sub(lambda match: _character(int(match[1], 16)), identity)
    return _PREFIX.sub("", _DUPLICATE.sub("", name)).strip()


def _character(code: int) -> str:
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
