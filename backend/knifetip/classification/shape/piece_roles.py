"""piece_roles: roles of the pieces of a planar graph, from the kinds of their components.

A piece is the part of an edge between two neighbouring vertices of the graph.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.classification.shape.part_kinds import PartKinds
from knifetip.classification.shape.roles import Role
from knifetip.geometry.columns import U8
from knifetip.geometry.parallel import chunks, parallel_map
from knifetip.kernels import U8_1, U8_2, OutU8_1, kernel
from knifetip.topology.faces import Faces, PieceSides, piece_sides
from knifetip.topology.intersections import MIN_CHUNK
from knifetip.topology.planar_graph import PlanarGraph

#: Roles of a piece by the kind of its component: with the outer face on one side, on both sides,
#: with one bounded face on both sides, and with two bounded faces.
_BLANK: Final = Role.OUTLINE, Role.STRAY, Role.SLIT, Role.DIVIDER
_SMALL: Final = Role.MARK, Role.STRAY, Role.MARK, Role.MARK
_INSIDE: Final = Role.HOLE, Role.FREE, Role.INNER, Role.INNER
_SLOT: Final = Role.SLOT, Role.FREE, Role.INNER, Role.INNER


def piece_roles(graph: PlanarGraph, faces: Faces, kinds: PartKinds) -> U8:
    """Return the role of each of the p pieces of a planar graph, (p,).

    A piece is the part of an edge between two neighbouring vertices.  Its role follows from the
    kind of its connected component, which ``kinds`` contains, and from the faces on its two sides.
    """
    # A component of several kinds gets the roles of the last of these rows.
    rows = (
        (kinds.doubtful, [Role.OPEN] * 4),
        (kinds.inside, _INSIDE),
        (kinds.slot, _SLOT),
        (kinds.small, _SMALL),
        (kinds.flat, [Role.STRAY] * 4),
        (kinds.debris, [Role.DEBRIS] * 4),
        (kinds.legend, [Role.LEGEND] * 4),
        (kinds.frame, [Role.FRAME] * 4),
        (kinds.bleed, [Role.BLEED] * 4),
        (kinds.enclosing, [Role.ENCLOSING] * 4),
        (kinds.table, [Role.TABLE] * 4),
        (kinds.labelled, [Role.LABELLED] * 4),
        (kinds.letter, [Role.LETTER] * 4),
    )
    table = np.array([_BLANK, *(roles for _, roles in rows)], np.uint8)
    row = np.zeros(len(faces.outer_face), np.uint8)
    for number, (mask, _) in enumerate(rows, start=1):
        np.putmask(row, mask, number)
    role = np.empty(len(graph.component), np.uint8)
    sides = piece_sides(graph, faces)

    def look_up(chunk: tuple[int, int]) -> None:
        _look_up_roles(table, row, sides, role, *chunk)

    parallel_map(look_up, chunks(len(role), MIN_CHUNK))
    return role


@kernel(allocates=False)
def _look_up_roles(
    table: U8_2, row: U8_1, sides: PieceSides, role: OutU8_1, begin: int, end: int
) -> None:
    """Write the roles of pieces ``begin`` … ``end`` - 1 to ``role``, (p,).

    A piece is the part of an edge between two neighbouring vertices of a planar graph.

    ``table`` (kinds, 4): role of a piece, by the kind of its component (row) and by the faces on
    its two sides (column).  Column 0: one of them is the outer face of the component; column 1:
    both are the outer face; column 2: both are the same bounded face; column 3: they are two
    different bounded faces.
    ``row`` (c,): row of ``table`` for each component.
    """
    component, left, right, outer_face = sides
    for p in range(begin, end):
        outside = outer_face[component[p]]
        if left[p] == right[p]:
            column = 1 if left[p] == outside else 2
        else:
            column = 0 if left[p] == outside or right[p] == outside else 3
        role[p] = table[row[component[p]], column]
