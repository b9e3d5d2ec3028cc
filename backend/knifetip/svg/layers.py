"""layers: find the layer name of an SVG element.

SVG has no layers.  Inkscape marks groups (<g> elements) as layers; Illustrator writes layers as
groups with an id; other programs name the elements, or describe them by classes and data
attributes.  The layer name is the nearest name with a meaning (``vocabulary``), of the element or
of a group that contains it.  The name of a marked layer has priority over the names in it.

Without such a name it is the label of a group that is marked as a layer, the id of a group, or the
label, id or class of the element.  Names that a program generates, such as "path42", are ignored.
An element without a name is on layer "0", as in a DXF.
"""

from __future__ import annotations

import re
from typing import Final, NamedTuple

from knifetip.model.dieline import LineType
from knifetip.svg.document import Node
from knifetip.vocabulary import name_meaning


class Layer(NamedTuple):
    """The name of a layer, and whether the file marks the layer's <g> element as a layer."""

    name: str
    marked: bool

    @property
    def decides(self) -> bool:
        """Whether names inside the layer do not count: it is marked, and its name has a meaning."""
        return self.marked and _meaning(self.name) is not None


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
#: Values of data attributes whose names contain the meaning, as in ``data-crease="true"``.
_TRUE: Final = ("", "1", "true", "yes")
#: Longest value of a data attribute that is a name, not a description.
_LONGEST_NAME: Final = 40
_TRAILING_NUMBER: Final = re.compile(r"[-_ .]?\d+$")


def layer_of_group(node: Node, inherited: Layer) -> Layer:
    """Return the layer that the child elements of the SVG group (<g>) ``node`` inherit.

    ``inherited`` is the layer that the group itself inherits from the elements that contain it.
    """
    attributes = node.attributes
    name = _label(node)
    if _is_layer(node):
        return Layer(name or original_name(attributes.get("id", "")) or inherited.name, True)
    if inherited.decides:
        return inherited
    if meaningful := _meaningful_name(node, None):
        same = _meaning(meaningful) == _meaning(inherited.name)
        return inherited if same else Layer(meaningful, False)
    if inherited.marked or _meaning(inherited.name) is not None:
        return inherited
    for candidate in (name, original_name(attributes.get("id", ""))):
        if candidate and not _GENERATED.fullmatch(candidate):
            return Layer(candidate, False)
    return inherited


def layer_of_element(node: Node, inherited: Layer) -> str:
    """Return the layer name of an element that is not a group.

    ``inherited`` is the layer that the element inherits from the group that contains it.
    """
    attributes = node.attributes
    has_names = bool(attributes.keys() - _GEOMETRY_ATTRIBUTES)
    if has_names and not inherited.decides:
        # Generators name lines of a carton after tools: an id does not leave out a line.
        name = _meaningful_name(node, None, LineType.IGNORED)
        if name:
            return _combined_name(name, inherited.name)
    if inherited.name:
        return inherited.name
    if not has_names:
        return UNNAMED
    for candidate in (*_own_names(node), *attributes.get("class", "").split()):
        if candidate and not _GENERATED.fullmatch(candidate):
            return candidate
    return UNNAMED


def original_name(identity: str) -> str:
    """Return the name that a user entered in a drawing program, from the id that the program wrote.

    Escapes, prefixes such as "Layer " and suffixes of duplicates are removed from ``identity``.
    """
    name = _ESCAPED.sub(lambda match: _character(int(match[1], 16)), identity)
    return _PREFIX.sub("", _DUPLICATE.sub("", name)).strip()


def _meaning(name: str) -> LineType | None:
    return name_meaning(name).kind


def _combined_name(name: str, inherited: str) -> str:
    """Return the layer name of an element whose own name has a meaning.

    The layer name is that of the group that contains the element, ``inherited``, if it has the
    same meaning.
    """
    own, outer = _meaning(name), _meaning(inherited)
    if own == outer:
        return inherited
    # A border in a group of cuts may be a cut: both names together have no meaning.
    is_doubtful = own == LineType.IGNORED and outer is not None
    return f"{inherited} {name}" if is_doubtful else name


def _own_names(node: Node) -> tuple[str, str]:
    """Return label and id of an element without trailing numbers.

    The layer of crease1, crease2 … is crease; names of classes keep their numbers.
    """
    names = (_label(node), original_name(node.attributes.get("id", "")))
    return _TRAILING_NUMBER.sub("", names[0]), _TRAILING_NUMBER.sub("", names[1])


def _meaningful_name(node: Node, *without: LineType | None) -> str:
    """Return the name of an element that suggests a line type, an empty string for none.

    Classes and data attributes have priority over label and id, which may only count the element.
    If classes and data attributes suggest several line types, all their names are returned.
    A label or id with one of the meanings ``without`` does not count.
    """
    attributes = node.attributes
    names = attributes.get("class", "").split()
    for key, value in attributes.items():
        if key.startswith("data-") and len(value) <= _LONGEST_NAME:
            names.append(key.removeprefix("data-") if value.lower() in _TRUE else value.strip())
    found = {name: kind for name in names if (kind := _meaning(name)) is not None}
    if found:
        return " ".join(found) if len(set(found.values())) > 1 else next(iter(found))
    return next((name for name in _own_names(node) if _meaning(name) not in without), "")


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
