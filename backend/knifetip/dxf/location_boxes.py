"""location_boxes: bounding boxes that show the positions of entities without geometry to cut.

A box contains the points at which an entity is located, for example the vertices of a hatch or a
solid, or the corner of an image.  It is in the coordinates of model space, or of the block that
contains the entity.  Directions, scales and seed points are not included, although DXF writes them
with the same group codes.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Final

import numpy as np

from knifetip.dxf.byte_scan import NO_CODE, ONE, code_at, end_of_line
from knifetip.dxf.decimals import EXACT, number
from knifetip.dxf.shapes import map_points
from knifetip.geometry.columns import F64, I64, Bool
from knifetip.kernels import F64_1, I64_1, I64_2, U8_1, OutF64_1, OutF64_2, OutI64_1, kernel

# Columns of a rule: bits for the group codes, from 10 on, that are points; group codes after which
# and before which these points are used, -1 for the whole entity; whether an extrusion of −Z
# mirrors x.
_BITS, _SINCE, _UNTIL, _OWN_PLANE = range(4)
_Rule = tuple[int, int, int, int]


def _rule(*codes: int, since: int = -1, stop: int = -1, own_plane: bool = False) -> _Rule:
    return sum(1 << code - 10 for code in codes), since, stop, int(own_plane)


_RULES: Final[dict[str, _Rule]] = {
    "LINE": _rule(10, 11),
    "SPLINE": _rule(10, 11),
    "SOLID": _rule(10, 11, 12, 13, own_plane=True),
    "TRACE": _rule(10, 11, 12, 13, own_plane=True),
    "3DFACE": _rule(10, 11, 12, 13),
    "MLINE": _rule(11),
    "DIMENSION": _rule(10, 11, 13, 14),
    "OLE2FRAME": _rule(10, 11),
    # The location of a polyline is that of its vertices, which follow as separate entities.
    "POLYLINE": _rule(10, since=0, own_plane=True),
    # The height of a hatch precedes its paths, and seed points follow the paths.
    "HATCH": _rule(10, since=91, stop=75, own_plane=True),
    "MPOLYGON": _rule(10, since=91, stop=75, own_plane=True),
    # At other positions in the entity, group code 10 is a scale.
    "MULTILEADER": _rule(10, since=300, stop=301),
    "MLEADER": _rule(10, since=300, stop=301),
    **dict.fromkeys(
        ("ARC", "CIRCLE", "LWPOLYLINE", "INSERT", "TEXT", "ATTRIB", "ATTDEF", "SHAPE"),
        _rule(10, own_plane=True),
    ),
}
_OTHERS: Final = _rule(10)
#: Group code at the start of an embedded object, whose points are not used.
_EMBEDDED: Final = 101
_EXTRUSION_Z: Final = 230


def boxes_of_entities(data: bytes, kinds: Sequence[str], kind: I64, spans: I64) -> F64:
    """Return the bounding boxes of the points of k entities, (k, 4): min x, min y, max x, max y.

    All four numbers are NaN for an entity without points.

    Parameters
    ----------
    data
        Content of the file.
    kinds
        Names of kinds of entities.
    kind : (k,)
        Index into ``kinds`` for each entity.
    spans : (k, 2)
        Range of each entity in ``data``: position of its first byte, and of the byte after its last
        tag or, for a polyline, after its last vertex.
    """
    rules = np.array([_RULES.get(one, _OTHERS) for one in kinds], np.int64).reshape(-1, 4)
    box, sure = _boxes(np.frombuffer(data, np.uint8), spans, rules[kind])
    for row in np.flatnonzero(~sure).tolist():
        lines = data[slice(*spans[row].tolist())].split(b"\n")[2:]
        codes = [int(code) for code in lines[0:-1:2]]
        box[row] = box_of_tags(kinds[kind[row]], codes, lines[1::2])
    return box


def box_of_tags(kind: str, codes: Sequence[int], values: Sequence[Any]) -> F64:
    """Return the bounding box of the points of one entity, (4,): min x, min y, max x, max y.

    All four numbers are NaN if the entity has no points.  ``kind`` is the kind of the entity;
    ``codes`` and ``values`` are the group codes and the values of its tags.
    """
    number_ = [_number(code, value) for code, value in zip(codes, values, strict=True)]
    rule, box = np.array([_RULES.get(kind, _OTHERS)], np.int64), np.full((1, 4), np.nan)
    _write_box(np.array(codes, np.int64), np.array(number_, np.float64), len(codes), rule, 0, box)
    points_box: F64 = box[0]
    return points_box


def transformed_box(box: F64, linear: F64, shift: F64) -> F64:
    """Return the bounding box of k copies of a box, each with its own linear map and translation.

    Alternatively, ``box`` may contain k boxes, one for each linear map and translation.  The
    returned array then contains the bounding box of each of these boxes after its transformation.

    Parameters
    ----------
    box : (4,) or (k, 4)
        min x, min y, max x and max y of one box, or of k boxes.
    linear, shift : (k, 2, 2), (k, 2)
        Linear maps and translations.

    Returns
    -------
    (4,) or (k, 4)
        min x, min y, max x and max y, in an array of the same shape as ``box``.
    """
    middle, half = (box[..., :2] + box[..., 2:]) / 2.0, (box[..., 2:] - box[..., :2]) / 2.0
    centre, reach = (
        map_points(linear, shift, middle),
        map_points(np.abs(linear), np.zeros(2), half),
    )
    placed = np.concatenate([centre - reach, centre + reach], axis=-1)
    if box.ndim == 2:
        return placed
    return np.concatenate([placed[:, :2].min(axis=0), placed[:, 2:].max(axis=0)])


def _number(code: int, value: Any) -> float:
    if not (10 <= code <= 28 or code == _EXTRUSION_Z):
        return 0.0
    try:
        return float(value)
    except (ValueError, TypeError, OverflowError):
        return float("nan")


@kernel(allocates=False)
def _write_box(
    codes: I64_1, numbers: F64_1, count: int, rules: I64_2, row: int, box: OutF64_2
) -> None:
    """Write min x, min y, max x and max y of the points of one entity into ``box[row]``.

    Nothing is written if the entity has no points.

    ``codes``, ``numbers``, ``count``: group codes and numbers of the tags of the entity, and the
    number of tags.
    ``rules`` (k, 4): one rule for each of k entities, which determines the tags that are
    coordinates of its points.  Column 0: set of the group codes of x, one bit per code.  Column 1:
    group code after which points are read, -1 to read them from the start.  Column 2: group code at
    which reading stops, -1 for none.  Column 3: 1 if an extrusion of −Z mirrors the points, else 0.
    ``row``: index of the entity in ``rules`` and ``box``.
    """
    bits, since, stop = rules[row, _BITS], rules[row, _SINCE], rules[row, _UNTIL]
    low_x = low_y = np.inf
    high_x = high_y = -np.inf
    x, x_code = np.nan, -1
    in_points = since < 0
    has_point = False
    for tag in range(count):
        code = codes[tag]
        if code == _EMBEDDED:
            break
        if code == _EXTRUSION_Z:
            has_point = numbers[tag] < 0.0
        elif not in_points:
            in_points = code == since
        elif code == stop:
            break
        elif 10 <= code <= 18:
            is_point = bits >> (code - 10) & 1 == 1
            x, x_code = numbers[tag], code if is_point else -1
        elif 20 <= code <= 28 and x_code == code - 10:
            y = numbers[tag]
            if np.isfinite(x) and np.isfinite(y):
                low_x, high_x = min(low_x, x), max(high_x, x)
                low_y, high_y = min(low_y, y), max(high_y, y)
            x_code = -1
    if low_x <= high_x:
        if has_point and rules[row, _OWN_PLANE] == 1:
            low_x, high_x = -high_x, -low_x
        box[row, 0], box[row, 1], box[row, 2], box[row, 3] = low_x, low_y, high_x, high_y


@kernel
def _boxes(data: U8_1, spans: I64_2, rules: I64_2) -> tuple[F64, Bool]:
    """Return the bounding boxes of the points of k entities, and whether each of them is exact.

    The boxes have the shape (k, 4): min x, min y, max x, max y; NaN for an entity without points.
    The second array, (k,), is False for an entity with a tag that cannot be parsed, or with a
    number that ``decimals`` cannot round with certainty; the caller then computes the box again.

    ``spans`` (k, 2): range of each entity in ``data``: position of its first byte, and of the byte
    after its last tag or, for a polyline, after its last vertex.
    ``rules`` (k, 4): for each entity a rule that determines which group codes are coordinates of
    its points.
    """
    box, sure = np.full((len(spans), 4), np.nan), np.ones(len(spans), np.bool_)
    longest = 0
    for row in range(len(spans)):
        longest = max(longest, spans[row, 1] - spans[row, 0])
    # A tag has two lines, each with an end, and a code of one digit at least.
    codes, numbers = np.empty(longest // 3 + 1, np.int64), np.empty(longest // 3 + 1)
    for row in range(len(spans)):
        count, sure[row] = _tags(data, spans[row, 0], spans[row, 1], codes, numbers)
        _write_box(codes, numbers, count, rules, row, box)
    return box, sure


@kernel(allocates=False)
def _tags(data: U8_1, low: int, high: int, codes: OutI64_1, numbers: OutF64_1) -> tuple[int, bool]:
    """Write the group codes and numbers of the entity in ``data[low:high]``.

    They are written into ``codes`` and ``numbers``.  Returns the number of tags, and whether all
    numbers were parsed with certainty.
    """
    position: Any = np.uint64(low)
    size: Any = np.uint64(high)
    sure = True
    # The first tag is the kind of the entity.
    count = -1
    while position < size:
        code, position = code_at(data, position, size)
        if code == NO_CODE:
            return max(count, 0), False
        end: Any = end_of_line(data, position, size)
        value = 0.0
        if 10 <= code <= 28 or code == _EXTRUSION_Z:
            value, _, certainty = number(data, position, end)
            sure = sure and certainty == EXACT
        if count >= 0:
            codes[count], numbers[count] = code, value
        count += 1
        if end < size and data[end] == 13:
            end += ONE
        position = end + ONE
    return count, sure
