"""placeable_inserts: find the INSERTs whose blocks array operations can place, all together."""

from __future__ import annotations

import numpy as np

from knifetip.dxf.fast_reader import fields as f
from knifetip.dxf.fast_reader.scan import Scan
from knifetip.dxf.fast_reader.segments import EntitySegments
from knifetip.dxf.fast_reader.tables import Tables
from knifetip.geometry.columns import F64, I64, Bool
from knifetip.geometry.tolerance import BULGE


def find_placeable_inserts(
    scanned: Scan,
    tables: Tables,
    segments: EntitySegments,
    rows: I64,
    one_by_one: Bool,
    polyline_width: F64,
) -> tuple[I64, I64, F64]:
    """Return the k INSERTs in model space whose blocks are placed by array operations.

    All other INSERTs are marked in ``one_by_one``, the mask of the entities that
    ``BlockExpansion`` expands.  ``rows`` are the rows in ``Scan.entity`` of the entities of
    model space.  ``polyline_width`` (e,) is the width of each wide polyline, 0 for other entities;
    an INSERT that scales its block scales this width.

    Returns
    -------
    position : (k,)
        Index of each INSERT into ``rows``.
    block : (k,)
        Row in ``Scan.block`` of the block of each INSERT.
    placement : (k, 5)
        Position x and y, scale in x and in y, and rotation in degrees of each INSERT.
    """
    inserts = (scanned.entity[:, f.KIND] == f.INSERT) & (scanned.entity[:, f.PAPER] == 0)
    position = np.flatnonzero(inserts[rows])
    insert_rows = rows[position]
    mirror, wide, high, reference = (
        scanned.entity[insert_rows, column] for column in (f.MIRROR, f.COLUMNS, f.ROWS, f.REFERENCE)
    )
    value_columns = (f.X, f.Y, f.SCALE_X, f.SCALE_Y, f.ANGLE)
    placement = np.column_stack([scanned.value[insert_rows, column] for column in value_columns])
    for column, default in ((2, 1.0), (3, 1.0), (4, 0.0)):
        placement[np.isnan(placement[:, column]), column] = default
    # Row of the block with each name; whether each block is simple, and whether it has no arcs.
    block_of_name = [tables.blocks.get(name.lower(), -1) for name in tables.names]
    block = np.array([*block_of_name, -1], np.int64)[reference]
    simple = np.zeros(len(scanned.block) + 1, np.bool_)
    straight, wide_lines = simple.copy(), simple.copy()
    for number, arcs in _simple_blocks(scanned, tables, segments).items():
        simple[number], straight[number] = True, not arcs
    wide_lines[scanned.entity[polyline_width > 0.0, f.BLOCK]] = True
    scale = placement[:, 2:4]
    columnar = (
        ~one_by_one[position]
        & simple[block]
        & (mirror == 0)
        & (np.maximum(wide, high) <= 1)
        & (scale != 0.0).all(axis=1)
        & (~wide_lines[block] | (np.abs(scale) == 1.0).all(axis=1))
        & (straight[block] | (np.abs(scale[:, 0]) == np.abs(scale[:, 1])))
    )
    one_by_one[position[~columnar]] = True
    return position[columnar], block[columnar], placement[columnar]


def _simple_blocks(scanned: Scan, tables: Tables, segments: EntitySegments) -> dict[int, bool]:
    """Return the blocks that array operations can place, and whether each block contains arcs.

    The keys of the dictionary are the rows of the blocks in ``Scan.block``.  The values are
    True for blocks with arcs: array operations cannot scale them unequally in x and y.
    """
    entity = scanned.entity
    special = (entity[:, f.KIND] == f.INSERT) | (entity[:, f.UNSUPPORTED] != 0)
    special &= entity[:, f.PAPER] == 0
    simple = {}
    for block in tables.blocks.values():
        low, size = tables.span.get(block, (0, 0))
        if not special[low : low + size].any() and not scanned.block[block, f.EXTERNAL]:
            bulge = segments.bulge[segments.first[low] : segments.first[low + size]]
            simple[block] = bool((np.abs(bulge) >= BULGE).any())
    return simple
