"""scan_tables: the arrays that the fast reader's scan of a DXF file fills."""

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
    """Arrays filled by a scan; the number of used rows of each array is in ``state``."""

    entity: OutI32_2F  #: (e, ``fields.WIDTH``) what is written of each entity
    value: OutF64_2F  #: (e, ``fields.VALUES``) its decimals
    vertex: OutF64_2  #: (v, 3) x, y and bulge of the vertices of polylines
    block: OutI32_2  #: (b, 5) heads of blocks
    base: OutF64_2  #: (b, 2) their base points
    layer: OutI32_2  #: (l, 6) the layer table
    spans: OutI64_2  #: (n, 2) first and last byte of each name
    slots: OutI32_1  #: (2^16,) hash table of names, -1 where empty
    left: OutI64_2  #: (u, 5) table, row, column and bytes of numbers that are left to ``float``
    others: OutI64_1  #: (h,) values of the handles of what is no entity
