"""group_codes: meaning of each DXF group code, and the codes of each entity kind."""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.dxf.fast_reader import fields as f
from knifetip.dxf.fast_reader import keywords as w
from knifetip.dxf.value_types import LAST_CODE, TEXT_VALUE, TYPE

#: Heights up to this count as 0 (file units), as in ``entities``.
FLAT: Final = 1e-6
#: Kind of an entity by its keyword; VERTEX and other keywords are handled separately.
KIND_OF: Final = np.zeros(w.COUNT, np.int64)
KIND_OF[[w.LINE, w.ARC, w.CIRCLE, w.LWPOLYLINE, w.POLYLINE, w.INSERT]] = range(1, 7)
#: The second and the third subclass marker of each kind; the first is AcDbEntity.
SECOND: Final = np.array(
    [-1, w.DB_LINE, w.DB_CIRCLE, w.DB_CIRCLE, w.DB_LWPOLYLINE, w.DB_POLYLINE, w.DB_INSERT]
)
THIRD: Final = np.array([-1, -1, w.DB_ARC, -1, -1, -1, -1])

#: Mask of the group codes of an x coordinate, which its y coordinate must follow, shape (1072,).
IS_POINT: Final = np.isin(
    np.arange(LAST_CODE + 1),
    [*range(10, 19), *range(110, 113), *range(210, 214), *range(1010, 1014)],
)

#: Mask of the group codes that are read; other group codes are skipped.
MEANS: Final = np.zeros(LAST_CODE + 1, np.bool_)
MEANS[[1, 2, 3, 5, 6, 8, 60, 62, 66, 67, 70, 71, 100, 101, 370, 410, 420]] = True
#: Column of the value for each group code up to 255, or -1.
COLUMN_OF: Final = np.full(256, -1)
for _code, _column in (
    (10, f.X), (20, f.Y), (11, f.X2), (21, f.Y2), (40, f.RADIUS), (50, f.ANGLE), (51, f.ANGLE2),
    (41, f.SCALE_X), (42, f.SCALE_Y), (44, f.SPACE_X), (45, f.SPACE_Y),
):  # fmt: skip
    COLUMN_OF[_code] = _column
#: Mask of the columns of values that each kind has, texts last; other numbers are skipped.
OF_WORDS: Final = 7
HAS: Final = np.zeros((8, f.VALUES), np.bool_)
for _kind, _columns in (
    (f.LINE, (f.X, f.Y, f.X2, f.Y2)),
    (f.ARC, (f.X, f.Y, f.RADIUS, f.ANGLE, f.ANGLE2)),
    (f.CIRCLE, (f.X, f.Y, f.RADIUS)),
    (f.INSERT, (f.X, f.Y, f.SCALE_X, f.SCALE_Y, f.ANGLE, f.SPACE_X, f.SPACE_Y)),
    (f.LWPOLYLINE, f.OF_POLYLINE),
    (f.POLYLINE, f.OF_POLYLINE),
    (OF_WORDS, f.LENGTHS),
):
    HAS[_kind, list(_columns)] = True

# Context of a tag: a kind of entity, OF_WORDS for texts, or one of the following.
VERTEX: Final = 8
UNREAD: Final = 9
ELSEWHERE: Final = 10
# Action for a tag: decide by the context, skip it, parse its decimal number, or store it.
BY_PLACE, SKIPPED, NUMBER, TAKEN = range(4)
ACTION: Final = np.zeros((ELSEWHERE + 1, LAST_CODE + 1), np.uint8)
_OF_TEXT: Final = (TYPE == TEXT_VALUE) & (np.arange(LAST_CODE + 1) < 1000)
_OF_TEXT[[0, 102, 999]] = False
ACTION[:ELSEWHERE, _OF_TEXT] = np.where(MEANS[_OF_TEXT], TAKEN, SKIPPED)
for _kind in (f.LINE, f.ARC, f.CIRCLE, f.INSERT, OF_WORDS):
    for _code, _column in enumerate(COLUMN_OF.tolist()):
        if _column >= 0 and HAS[_kind, _column]:
            ACTION[_kind, _code] = NUMBER
ACTION[f.LINE : OF_WORDS, [30, 31, 210, 220, 230]] = NUMBER
ACTION[f.LWPOLYLINE : f.INSERT, 31] = ACTION[f.LWPOLYLINE, 30] = BY_PLACE
ACTION[f.LWPOLYLINE, [10, 20, 38, 40, 41, 42, 43]] = NUMBER
ACTION[f.POLYLINE, [40, 41]] = NUMBER
ACTION[VERTEX, [10, 20, 30, 40, 41, 42, 210, 220, 230]] = NUMBER
ACTION[VERTEX, 5] = BY_PLACE
ACTION[f.LINE : OF_WORDS, 370] = TAKEN

# Bits of ``state.SEEN`` for the tags that an entity already has.
B_HANDLE, B_LAYER, B_LINETYPE, B_COLOUR, B_TRUE, B_FLAGS, B_NAME = range(7)
B_VALUE: Final = 7  # one bit for each column of the values, from this bit on
B_COLUMNS: Final = B_VALUE + f.VALUES
B_ROWS: Final = B_COLUMNS + 1
B_PAPER: Final = B_ROWS + 1
B_LINE_WIDTH: Final = B_PAPER + 1
POINT: Final = 3 << B_VALUE

#: Required tags of each kind.
NEEDED: Final = np.array(
    [
        0,
        *(
            sum(1 << (B_VALUE + value) for value in values)
            for values in (
                (f.X, f.Y, f.X2, f.Y2),
                (f.X, f.Y, f.RADIUS, f.ANGLE, f.ANGLE2),
                (f.X, f.Y, f.RADIUS),
            )
        ),
        0,
        0,
        POINT | 1 << B_NAME,
        0,
    ]
)
