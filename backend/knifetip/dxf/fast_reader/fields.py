"""fields: column numbers of the arrays in the class ``Scan``, and numbers of the entity kinds.

A ``Scan`` contains the entities, blocks and layers of a DXF file as rows of arrays.
"""

from __future__ import annotations

from typing import Final

# Kinds of entities whose tags are read.  Of OTHER only handle, layer and space are read.
OTHER, LINE, ARC, CIRCLE, LWPOLYLINE, POLYLINE, INSERT = range(7)

# Columns of an entity.
(
    KIND,  # one of the kinds above
    WORD,  # index of the name of the kind, as written
    BLOCK,  # row of the block that contains it, -1 for model space
    HANDLE,  # position of the handle
    HANDLE_SIZE,
    LAYER,  # index of the name
    LINETYPE,  # index of the name, -1 if not given
    COLOUR,  # 256 if not given
    TRUE_COLOUR,  # 0xRRGGBB, -1 if not given
    LINE_WIDTH,  # group 370 (1/100 mm or BYLAYER …), -1 if not given
    PAPER,  # whether the entity is in paper space
    FLAGS,  # group 70
    REFERENCE,  # index of the name of the block that an INSERT places
    COLUMNS,
    ROWS,
    FIRST,  # first vertex of a polyline, or position of a text
    COUNT,  # number of vertices, or number of bytes of a text
    MIRROR,  # extrusion -Z
    MARKS,  # number of subclass markers
    START,  # position of its first group code
    END,  # position after its last line, including the lines of its vertices
    UNSUPPORTED,  # unsupported: only word, handle, layer and space are valid
) = range(22)
WIDTH: Final = 22

# Columns of a block.
NAME, BLOCK_HANDLE, BLOCK_HANDLE_SIZE, BLOCK_LAYER, EXTERNAL = range(5)

# Columns of a layer; -1 if the table has no name, no true colour or no line width.
(
    LAYER_NAME, LAYER_COLOUR, LAYER_TRUE, LAYER_FLAGS, LAYER_LINETYPE, LAYER_PLOT, LAYER_LINE_WIDTH,
) = range(7)  # fmt: skip
LAYER_WIDTH: Final = 7

# Columns of the values: groups 10, 20, 11, 21, 40, 50, 51, 41, 42, 44, 45.
X, Y, X2, Y2, RADIUS, ANGLE, ANGLE2, SCALE_X, SCALE_Y, SPACE_X, SPACE_Y = range(11)
VALUES: Final = 11
# Columns of the values of a polyline: its widths (file units), NaN if not given.
LEAST_WIDTH, MOST_WIDTH = X, Y  # of all widths of its vertices
STARTS, ENDS = X2, Y2  # number of vertices with a width at the start and at the end of a segment
START_WIDTH, END_WIDTH = RADIUS, SCALE_X  # of the vertices without one; 43 of an LWPOLYLINE
OF_POLYLINE: Final = [LEAST_WIDTH, MOST_WIDTH, STARTS, ENDS, START_WIDTH, END_WIDTH]
#: Columns of the group codes ``annotations.LENGTHS``.
LENGTHS: Final = [X, Y, X2, Y2, RADIUS, SCALE_Y]
