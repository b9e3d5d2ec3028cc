"""layers: what a PDF calls the layer of a line, and whether that layer is shown.

    /OCProperties, /Properties -> Layer;    (layer, spot colour) of all lines -> one name each

A line may have two names: the layer that it lies on, and the spot colour that it is drawn in.  The
layer's is taken, unless it only says that this is a dieline, or was counted up by a program, or
lines of several spot colours lie on it: then it is the spot colour's.

Source: ISO 32000-1, chapters 8.11.2 to 8.11.4.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import Any, Final, NamedTuple

from pypdf.generic import DictionaryObject, IndirectObject, TextStringObject

from knifetip.pdf.document import File

#: On no layer, in no spot colour.
NAMELESS: Final = "0"
#: Names that programs count up.
_COUNTED: Final = re.compile(r"(?:layer|ebene|calque|livello|capa|page)?[-_\s]*\d*", re.IGNORECASE)
#: Names that say no more than that it is a dieline, or which ink stands for it.
_VAGUE: Final = re.compile(
    r"(?:die[-_\s]?(?:lines?|layer|template)?|keyline|template|technical|structural|vector|artwork|"
    r"stanz(?:e|form)|background|spot(?:[-_\s]?colou?r)?|(?:pantone|pms)\b.*)[-_\s]*\d*",
    re.IGNORECASE,
)
#: Groups that one membership may name.
_MEMBERS: Final = 1000


class Layer(NamedTuple):
    """An optional content group, or a membership in several."""

    name: str
    shown: bool


NOWHERE: Final = Layer("", True)


class Layers:
    """The optional content of a file."""

    def __init__(self, file: File) -> None:
        self._file = file
        properties = file.entry(file.root, "/OCProperties")
        default = file.entry(properties, "/D")
        self._shown = file.entry(default, "/BaseState") != "/OFF"
        self._on = {_key(one) for one in file.array(default, "/ON")}
        self._off = {_key(one) for one in file.array(default, "/OFF")}
        self._known: dict[Any, Layer] = {}

    def layer(self, given: object) -> Layer:
        """Return the layer that a property list, or the /OC of an object, stands for."""
        key = _key(given)
        found = self._known.get(key)
        if found is None:
            found = self._known[key] = self._read(given, key)
        return found

    def _read(self, given: object, key: object) -> Layer:
        node = self._file.seen(given)
        if not isinstance(node, DictionaryObject):
            return NOWHERE
        if self._file.entry(node, "/Type") != "/OCMD":
            name = self._file.entry(node, "/Name")
            shown = key not in self._off and (self._shown or key in self._on)
            return Layer(str(name).strip() if isinstance(name, TextStringObject) else "", shown)
        listed = self._file.array(node, "/OCGs") or (
            [node.raw_get("/OCGs")] if "/OCGs" in node else []
        )
        groups = [
            self._read(one, _key(one))
            for one in listed[:_MEMBERS]
            if self._file.entry(self._file.seen(one), "/Type") == "/OCG"
        ]
        if not groups:
            return NOWHERE
        on = [one.shown for one in groups]
        policy = self._file.entry(node, "/P")
        shown = {
            "/AllOn": all(on),
            "/AnyOff": not all(on),
            "/AllOff": not any(on),
        }.get(str(policy), any(on))
        return Layer(groups[0].name, shown)


def _key(given: object) -> object:
    return (given.idnum, given.generation) if isinstance(given, IndirectObject) else id(given)


def names(drawn: Iterable[tuple[str, str]]) -> dict[tuple[str, str], str]:
    """Return the name of each pair of layer and spot colour that lines are drawn with."""
    pairs = set(drawn)
    spots: dict[str, set[str]] = {}
    for layer, spot in pairs:
        spots.setdefault(layer, set()).add(spot)
    found = {}
    for layer, spot in pairs:
        both = (spot, layer) if len(spots[layer] - {""}) > 1 else (layer, spot)
        found[layer, spot] = next(
            (
                name
                for vague in (False, True)
                for name in both
                if not _COUNTED.fullmatch(name) and (vague or not _VAGUE.fullmatch(name))
            ),
            NAMELESS,
        )
    return found
