"""columns: kernels that compute the segments of entities, and of blocks that INSERTs place.

The segments equal, bit for bit, the segments that the modules ``dxf.shapes`` and
``block_expansion`` compute for one entity at a time.
"""

from __future__ import annotations

from typing import Any, Final, NamedTuple

import numpy as np

from knifetip.dxf.fast_reader import fields as f
from knifetip.dxf.shapes import (
    arc_segment_count,
    cos_sin,
    mirror_segments,
    polyline_segment_count,
    sweep_angle,
    write_arc,
    write_polyline,
)
from knifetip.kernels import (
    F64_1,
    F64_2,
    F64_2A,
    F64_3,
    I32_1,
    I32_2A,
    I64_1,
    I64_2,
    OutF64_1,
    OutF64_3,
    OutI32_1,
    OutI32_2A,
    OutI64_1,
    kernel,
)

#: Style index of the segments of a block that are left out because their layer is hidden.
HIDDEN_STYLE: Final = -1


@kernel
def count_segments(entity: OutI32_2A, value: F64_2A, vertex: F64_2) -> Any:
    """Return the number of segments of each of e entities, (e,); 0 for an entity without geometry.

    Entities with an invalid radius or angle are marked in the column ``UNSUPPORTED`` of ``entity``.
    ``entity``, ``value`` and ``vertex`` are the arrays of these names in the class ``Scan``.
    """
    count = np.zeros(len(entity), np.int64)
    for row in range(len(entity)):
        kind = entity[row, f.KIND]
        if entity[row, f.PAPER] != 0 or entity[row, f.UNSUPPORTED] != 0:
            continue
        if kind == f.LINE:
            count[row] = 1
        elif kind == f.ARC or kind == f.CIRCLE:
            if not value[row, f.RADIUS] > 0.0:
                entity[row, f.UNSUPPORTED] = 1
            elif kind == f.CIRCLE:
                count[row] = arc_segment_count(360.0)
            elif value[row, f.ANGLE] == value[row, f.ANGLE2]:
                entity[row, f.UNSUPPORTED] = 1
            else:
                count[row] = arc_segment_count(
                    sweep_angle(value[row, f.ANGLE], value[row, f.ANGLE2])
                )
        elif (kind == f.LWPOLYLINE or kind == f.POLYLINE) and entity[row, f.COUNT] >= 2:
            low = entity[row, f.FIRST]
            closed = entity[row, f.FLAGS] & 1 == 1
            count[row] = polyline_segment_count(vertex, low, low + entity[row, f.COUNT], closed)
    return count


@kernel
def draw(
    entity: I32_2A, value: F64_2A, vertex: F64_2, first: OutI64_1, ends: OutF64_3, bulge: OutF64_1
) -> None:
    """Write the segments of each of e entities into ``ends``, (n, 2, 2), and ``bulge``, (n,).

    The coordinates are those of model space, or of the block that contains the entity.

    Parameters
    ----------
    entity, value, vertex
        The arrays of these names in the class ``Scan``.
    first : (e + 1,)
        Index of the first segment of each entity; the last element is the number n of segments.
    """
    for row in range(len(entity)):
        segment = first[row]
        if first[row + 1] == segment:
            continue
        kind = entity[row, f.KIND]
        x, y = value[row, f.X], value[row, f.Y]
        if kind == f.LINE:
            ends[segment, 0, 0], ends[segment, 0, 1] = x, y
            ends[segment, 1, 0], ends[segment, 1, 1] = value[row, f.X2], value[row, f.Y2]
            bulge[segment] = 0.0
            continue
        if kind == f.CIRCLE:
            write_arc(x, y, value[row, f.RADIUS], 0.0, 360.0, ends, bulge, segment)
        elif kind == f.ARC:
            start = value[row, f.ANGLE]
            sweep = sweep_angle(start, value[row, f.ANGLE2])
            write_arc(x, y, value[row, f.RADIUS], start, sweep, ends, bulge, segment)
        else:
            low = entity[row, f.FIRST]
            closed = entity[row, f.FLAGS] & 1 == 1
            write_polyline(vertex, low, low + entity[row, f.COUNT], closed, ends, bulge, segment)
        if entity[row, f.MIRROR] != 0:
            mirror_segments(ends, bulge, segment, first[row + 1])


@kernel
def is_too_far(ends: F64_3, first: I64_1, reach: float) -> Any:
    """Return the mask of the entities with a coordinate that is NaN or too large, shape (e,).

    The fast reader expands these entities one by one, and not together with the other entities.

    Parameters
    ----------
    ends : (n, 2, 2)
        Ends of the segments of all e entities (file units).
    first : (e + 1,)
        Index of the first segment of each entity; the last element is the number n of segments.
    reach
        Largest absolute value of x and of y that is not too large (file units).
    """
    result = np.zeros(len(first) - 1, np.bool_)
    for row in range(len(result)):
        for i in range(first[row], first[row + 1]):
            for end in range(2):
                x, y = ends[i, end, 0], ends[i, end, 1]
                result[row] |= not (abs(x) <= reach and abs(y) <= reach)
    return result


@kernel
def style_keys(entity: I32_2A, rows: I64_1, count: I64_1) -> Any:
    """Return the rows, style keys and line widths of the d entities with segments.

    The shapes are (d,), (d, 2) and (d,).  The two integers of a style key are equal for entities
    whose styles have equal layers, colours and linetypes.  They contain layer and linetype (32 bits
    each), and colour and true colour (25 bits).

    Parameters
    ----------
    entity
        The array ``Scan.entity``.
    rows
        Rows in ``entity`` of the entities to examine.
    count : (e,)
        Number of segments of each of the e entities in ``entity``.
    """
    with_segments = np.empty(len(rows), np.int64)
    key = np.empty((len(rows), 2), np.int64)
    line_width = np.empty(len(rows), np.int32)
    number = 0
    for row in rows:
        if count[row] > 0:
            with_segments[number] = row
            key[number, 0] = np.int64(entity[row, f.LAYER]) << 32 ^ np.int64(
                entity[row, f.LINETYPE]
            )
            colour = np.int64(entity[row, f.COLOUR]) << 25
            key[number, 1] = colour ^ np.int64(entity[row, f.TRUE_COLOUR] + 1)
            line_width[number] = entity[row, f.LINE_WIDTH]
            number += 1
    return with_segments[:number], key[:number], line_width[:number]


@kernel
def inserts(placement: F64_2, base: F64_2, move: OutF64_3) -> None:
    """Write the linear map and the translation of each of k INSERTs into ``move``, (k, 2, 3).

    Parameters
    ----------
    placement : (k, 5)
        Position x and y, scale in x and in y, and rotation in degrees of each INSERT.
    base : (k, 2)
        Base point of the block of each INSERT.
    """
    for k in range(len(placement)):
        x, y = placement[k, 0], placement[k, 1]
        scale_x, scale_y, rotation = placement[k, 2], placement[k, 3], placement[k, 4]
        cos, sin = cos_sin(rotation)
        move[k, 0, 0], move[k, 0, 1] = cos * scale_x, -sin * scale_y
        move[k, 1, 0], move[k, 1, 1] = sin * scale_x, cos * scale_y
        move[k, 0, 2] = x - (move[k, 0, 0] * base[k, 0] + move[k, 0, 1] * base[k, 1])
        move[k, 1, 2] = y - (move[k, 1, 0] * base[k, 0] + move[k, 1, 1] * base[k, 1])


class SheetRows(NamedTuple):
    """The k entities of model space in file order, and the index range of the segments of each.

    The index range refers to the array of all segments of the drawing.
    """

    entity: I64_1  #: (k,) row of each entity
    report_row: I64_1  #: (k,) row of each entity in the import report
    first: I64_1  #: (k,) number of segments before the segments of each entity
    segments: I64_1  #: (k,) number of segments of each entity, 0 for INSERTs


class EntitySegments(NamedTuple):
    """The n segments of e entities, each in coordinates of model space or of its entity's block."""

    ends: F64_3  #: (n, 2, 2) ends of the segments
    bulge: F64_1  #: (n,)
    first: I64_1  #: (e + 1,) first segment of each entity
    style: I32_1  #: (e,) style index of each entity in model space


class PlacedBlocks(NamedTuple):
    """Arrays that describe the blocks placed by j INSERTs in model space, one row per INSERT."""

    row: I64_1  #: (j,) index of each INSERT among the entities of model space
    source: I64_2  #: (j, 3) first entity of the block, its first segment, and its first style
    entities: I64_1  #: (j,) number of entities in the block
    move: F64_3  #: (j, 2, 3) linear map and translation
    style: I32_1  #: style indices of the segments of blocks, or ``HIDDEN_STYLE``


class SheetSegments(NamedTuple):
    """Arrays into which the m segments of the drawing are written (coordinates of model space)."""

    ends: OutF64_3  #: (m, 2, 2) file units
    bulge: OutF64_1  #: (m,)
    row: OutI32_1  #: (m,) row in the import report
    style: OutI32_1  #: (m,) style index


@kernel
def place(
    sheet: SheetRows, segments: EntitySegments, inserts: PlacedBlocks, out: SheetSegments
) -> None:
    """Write the segments of all entities of a drawing, in file order, into the arrays of ``out``.

    The segments of blocks are transformed to model space.

    Parameters
    ----------
    sheet
        The entities of model space.
    segments
        The segments of all entities, before transformation.
    inserts
        The INSERTs in model space, with their blocks and transformations.
    out
        Arrays that receive the segments.
    """
    rows, report_row, first_out, shown = sheet
    ends, bulge, first, style_of = segments
    position, source, children, move, styles = inserts
    out_ends, out_bulge, out_row, out_style = out
    for number in range(len(rows)):
        row = rows[number]
        segment = first_out[number]
        for i in range(first[row], first[row] + shown[number]):
            # Element by element: creating a view of a row takes longer.
            for end in range(2):
                out_ends[segment, end, 0], out_ends[segment, end, 1] = (
                    ends[i, end, 0],
                    ends[i, end, 1],
                )
            out_bulge[segment] = bulge[i]
            out_row[segment] = report_row[number]
            out_style[segment] = style_of[row]
            segment += 1
    for number in range(len(position)):
        segment = first_out[position[number]]
        low, start, style = source[number]
        m = move[number]
        turn = np.sign(m[0, 0] * m[1, 1] - m[0, 1] * m[1, 0])
        for child in range(children[number]):
            for i in range(first[low + child], first[low + child + 1]):
                if styles[style + i - start] == HIDDEN_STYLE:
                    continue
                for end in range(2):
                    x, y = ends[i, end, 0], ends[i, end, 1]
                    out_ends[segment, end, 0] = m[0, 0] * x + m[0, 1] * y + m[0, 2]
                    out_ends[segment, end, 1] = m[1, 0] * x + m[1, 1] * y + m[1, 2]
                out_bulge[segment] = turn * bulge[i]
                out_row[segment] = report_row[position[number]] + 1 + child
                out_style[segment] = styles[style + i - start]
                segment += 1
