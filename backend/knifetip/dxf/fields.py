"""fields: the columns of a Scan, by name.

Kinds of entities, and what the numbers in a row of an entity, a block, a layer or of values mean.
"""

from __future__ import annotations

from typing import Final

# Kinds of entities whose tags are read; of all others only handle, layer and space are.
OTHER, LINE, ARC, CIRCLE, LWPOLYLINE, POLYLINE, INSERT = range(7)

# Columns of an entity.
(
    KIND,  # one of the above
    WORD,  # name: the kind as it is written
    BLOCK,  # row of the block that it stands in, -1 for the sheet
    HANDLE,  # byte where the handle begins
    HANDLE_SIZE,
    LAYER,  # name
    LINETYPE,  # name, -1 where it is silent
    COLOUR,  # 256 where it is silent
    TRUE_COLOUR,  # 0xRRGGBB, -1 where it is silent
    PAPER,  # stands in paper space
    FLAGS,  # group 70
    REFERENCE,  # name of the block that an INSERT places
    COLUMNS,
    ROWS,
    FIRST,  # first vertex; of words the byte where they begin
    COUNT,  # vertices; of words the bytes
    MIRROR,  # extrusion -Z
    MARKS,  # subclass markers seen
    START,  # byte of its first group code
    END,  # byte behind its last line, those of its vertices included
    ODD,  # it is not plain: only word, handle, layer and space are to be trusted
) = range(21)
WIDTH: Final = 21

# Columns of a block.
NAME, BLOCK_HANDLE, BLOCK_HANDLE_SIZE, BLOCK_LAYER, EXTERNAL = range(5)

# Columns of a layer; -1 where the table is silent of a name or a true colour.
LAYER_NAME, LAYER_COLOUR, LAYER_TRUE, LAYER_FLAGS, LAYER_LINETYPE, LAYER_PLOT = range(6)

# Columns of the values: groups 10, 20, 11, 21, 40, 50, 51, 41, 42, 44, 45.
X, Y, X2, Y2, RADIUS, ANGLE, ANGLE2, SCALE_X, SCALE_Y, SPACE_X, SPACE_Y = range(11)
VALUES: Final = 11
#: Those of ``inscriptions.LENGTHS``.
LENGTHS: Final = [X, Y, X2, Y2, RADIUS, SCALE_Y]
