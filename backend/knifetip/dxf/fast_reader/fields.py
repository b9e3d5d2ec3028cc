"""fields: columns of the arrays in a Scan, and numbers of the supported entity kinds."""

from __future__ import annotations

from typing import Final

# Kinds of entities whose tags are read; only handle, layer and space of all others are.
OTHER, LINE, ARC, CIRCLE, LWPOLYLINE, POLYLINE, INSERT = range(7)

# Columns of an entity.
(
    KIND,  # one of the above
    WORD,  # name: the kind as it is written
    BLOCK,  # row of its block, -1 for model space
    HANDLE,  # position of the handle
    HANDLE_SIZE,
    LAYER,  # name
    LINETYPE,  # name, -1 if not given
    COLOUR,  # 256 if not given
    TRUE_COLOUR,  # 0xRRGGBB, -1 if not given
    PAPER,  # whether it is in paper space
    FLAGS,  # group 70
    REFERENCE,  # name of the block that an INSERT places
    COLUMNS,
    ROWS,
    FIRST,  # first vertex; of a text its position
    COUNT,  # number of vertices; of a text its bytes
    MIRROR,  # extrusion -Z
    MARKS,  # subclass markers seen
    START,  # position of its first group code
    END,  # position after its last line, with those of its vertices
    ODD,  # unsupported: only word, handle, layer and space are valid
) = range(21)
WIDTH: Final = 21

# Columns of a block.
NAME, BLOCK_HANDLE, BLOCK_HANDLE_SIZE, BLOCK_LAYER, EXTERNAL = range(5)

# Columns of a layer; -1 if the table has no name or no true colour.
LAYER_NAME, LAYER_COLOUR, LAYER_TRUE, LAYER_FLAGS, LAYER_LINETYPE, LAYER_PLOT = range(6)

# Columns of the values: groups 10, 20, 11, 21, 40, 50, 51, 41, 42, 44, 45.
X, Y, X2, Y2, RADIUS, ANGLE, ANGLE2, SCALE_X, SCALE_Y, SPACE_X, SPACE_Y = range(11)
VALUES: Final = 11
#: Those of ``annotations.LENGTHS``.
LENGTHS: Final = [X, Y, X2, Y2, RADIUS, SCALE_Y]
