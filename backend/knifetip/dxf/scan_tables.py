"""scan_tables: the arrays into which the fast reader scans a DXF file."""

from __future__ import annotations

from typing import NamedTuple

from knifetip.kernels import (
    OutF64_2,
    OutF64_2F,
    OutI32_1,
    OutI32_2,
    OutI32_2F,
    OutI64_1,
    OutI64_2,
)


class ScanTables(NamedTuple):
    """Arrays into which a DXF file is scanned.

    The number of used rows of each array is in the separate array ``state`` of the scan.
    """

    entity: OutI32_2F  #: (e, ``fields.WIDTH``) attributes of each entity, as written
    value: OutF64_2F  #: (e, ``fields.VALUES``) decimal numbers of each entity
    vertex: OutF64_2  #: (v, 3) x, y and bulge of the vertices of polylines
    block: OutI32_2  #: (b, 5) headers of blocks, columns ``fields.NAME`` …
    base: OutF64_2  #: (b, 2) base points of blocks
    layer: OutI32_2  #: (l, 7) rows of the layer table
    spans: OutI64_2  #: (n, 2) first and last byte of each name
    slots: OutI32_1  #: (2^16,) hash table of names, -1 where empty
    left: OutI64_2  #: (u, 5) table, row, column and bytes of numbers that are left to ``float``
    others: OutI64_1  #: (h,) values of the handles of objects that are not entities
