"""annotations: the texts and dimensions of a drawing, as written in the file.

The tags of a TEXT, MTEXT, ATTRIB or DIMENSION entity become an ``Annotation`` in file units.  The
fast reader and the ezdxf reader decode the texts from the bytes of the file and do not take them
from ezdxf: texts are evidence for the unit, and ezdxf may repair them.  Texts in blocks are left
out, even if an INSERT places the block.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Sequence
from itertools import repeat
from typing import Any, Final

import numpy as np

from knifetip.dxf.encoding import unescape
from knifetip.geometry.columns import F64
from knifetip.model.drawing import Annotation

#: Kinds of entities whose texts may contain formatting codes.
_CODED: Final = frozenset({"MTEXT", "DIMENSION"})
#: Kinds of entities that contain text.
WORDS: Final = frozenset({"TEXT", "MTEXT", "ATTRIB", "DIMENSION"})
#: Group codes of the lengths that are read; only the first value of each code is used.
LENGTHS: Final = (10, 20, 11, 21, 40, 42)

#: Mask of the bits for the kind of a dimension, and the kinds that measure an angle.
_TYPES: Final = 7
_ANGULAR: Final = frozenset({2, 5})
#: Longest text that is read (characters, with formatting codes).
_LONGEST: Final = 2000

_SIGNS: Final = {"d": "°", "c": "⌀", "p": "±", "%": "%"}
_SIGN: Final = re.compile(r"%%([dcpkou%])", re.IGNORECASE)
#: A formatting code of MTEXT: an escaped character, a break, a stacked fraction, or a code that
#: only changes the appearance.
_CODE: Final = re.compile(
    r"\\(?P<sign>[\\{}])|(?P<gap>\\[PN~]|\^[IJM])|\\S(?P<stack>[^;\\]{0,60});"
    r"|\\[LlOoKkX]|\\[A-Za-z][^;\\]{0,60};|[{}]"
)


def annotation(
    kind: str, layer: str, text: str, lengths: Iterable[float], type_: int
) -> Annotation:
    """Return the annotation for a text or dimension entity.

    Parameters
    ----------
    kind, layer
        Kind of the entity, such as MTEXT, and name of its layer.
    text
        Text as written in the file, with formatting codes.
    lengths
        Values of the group codes 10, 20, 11, 21, 40 and 42 of the entity (file units); NaN for a
        group code that the entity does not have.  They are the x and y of two points, the height of
        a text and the measured length of a dimension.
    type_
        Type of a dimension, the value of its group code 70; not used for texts.
    """
    x, y, x_text, y_text, height, measure = lengths
    written = text[:_LONGEST]
    if kind == "DIMENSION":
        # Group 40 is the length of a leader, and 11 is the position of the text.
        height = 0.0
        x, y = (x, y) if math.isnan(x_text) else (x_text, y_text)
        if type_ & _TYPES in _ANGULAR:
            measure = math.nan
        written = "" if written.strip() == "<>" else written
    else:
        measure = math.nan
    if kind in _CODED:
        written = _CODE.sub(_decode_escape, written)
    if "%%" in written:
        written = _SIGN.sub(lambda match: _SIGNS.get(match[1].lower(), ""), written)
    if "\\" in written:
        written = unescape(written)
    # Missing values are NaN, which is not equal to itself.
    return Annotation(
        written.strip(),
        x if x == x else 0.0,
        y if y == y else 0.0,
        height if height == height else 0.0,
        measure,
        kind,
        layer,
    )


def has_formatting(kind: str, text: str) -> bool:
    """Return whether the text of one entity must be parsed by ``annotation``.

    The result is True if the text may contain formatting codes, which ``annotation`` decodes, or if
    it is longer than 2000 characters, because ``annotation`` shortens such texts.  All other texts
    are processed together by ``plain_annotations``.  ``kind`` is the kind of the entity, such as
    MTEXT.
    """
    return kind in _CODED or "\\" in text or "%%" in text or len(text) > _LONGEST


def plain_annotations(
    kinds: Sequence[str], layers: Sequence[str], texts: Sequence[str], lengths: F64
) -> list[Annotation]:
    """Return the annotations for n text entities whose texts have no formatting codes.

    Parameters
    ----------
    kinds, layers, texts
        Kind, layer name and text of each entity.
    lengths : (n, 6)
        Values of the group codes 10, 20, 11, 21, 40 and 42 of each entity (file units); NaN for a
        group code that the entity does not have.  Codes 10 and 20 are x and y of the text, and
        code 40 is its height; the other values are not used.
    """
    x, y, height = np.where(np.isnan(lengths), 0.0, lengths)[:, [0, 1, 4]].T.tolist()
    texts = [text.strip() for text in texts]
    rows = zip(texts, x, y, height, repeat(math.nan), kinds, layers)
    return list(map(Annotation._make, rows))


def annotation_of_tags(
    kind: str, layer: str, tags: Iterable[tuple[int, Any]], encoding: str
) -> Annotation:
    """Return the annotation for a text or dimension entity, given its tags (group code, value).

    ``encoding`` is the character encoding of values that are bytes.
    """
    text: list[str] = []
    numbers = dict.fromkeys(LENGTHS, math.nan)
    type_ = 0
    stored_codes: set[int] = set()
    in_group = False
    for code, value in tags:
        if code == 101:
            # The embedded object that follows repeats the text, divided into columns.
            break
        if code == 102:
            in_group = _text(value, encoding).startswith("{")
        elif in_group or (code in stored_codes and code != 3):
            continue
        elif code == 1 or (code == 3 and kind == "MTEXT"):
            text.append(_text(value, encoding))
        elif code in numbers:
            numbers[code] = _number(value)
        elif code == 70:
            number = _number(value)
            type_ = int(number) if math.isfinite(number) else 0
        stored_codes.add(code)
    return annotation(kind, layer, "".join(text), numbers.values(), type_)


def annotation_of_lines(kind: str, layer: str, data: bytes, encoding: str) -> Annotation:
    """Return the annotation for a text or dimension entity, given its bytes in the file.

    ``data`` contains the text lines of all tags of the entity, and ``encoding`` is the character
    encoding of these lines.
    """
    lines = data.split(b"\n")
    codes = map(int, lines[0:-1:2])
    return annotation_of_tags(kind, layer, zip(codes, lines[1::2], strict=True), encoding)


def _decode_escape(match: re.Match[str]) -> str:
    if match["gap"]:
        return " "
    if match["stack"]:
        return re.sub(r"[\^#]", "/", match["stack"])
    return match["sign"] or ""


def _text(value: Any, encoding: str) -> str:
    return (value.decode(encoding, "replace") if isinstance(value, bytes) else str(value)).strip(
        "\r\n"
    )


def _number(value: Any) -> float:
    try:
        number = float(value)
    except (ValueError, OverflowError, TypeError):
        return math.nan
    return number if math.isfinite(number) else math.nan
