"""subdivision: find the faces into which edges divide the plane.

The module also finds the face that contains each connected component of the edges.  The edges meet
only at their ends: in contrast to ``planar_graph``, no edge is split and no gap is closed.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from knifetip.geometry.columns import F64, I64, Bool
from knifetip.geometry.tolerance import JOIN
from knifetip.geometry.vertices import number_vertices
from knifetip.topology.exact_nesting import find_enclosing_faces, find_half_edges_below
from knifetip.topology.faces import trace_sides
from knifetip.topology.planar_graph import connected_components
from knifetip.topology.vertices import first_coincident

#: Signed area below which a face is the outer face of its component (mm²).
_LEAST_AREA: Final = 0.5e-6


@dataclass(frozen=True, eq=False, slots=True)
class Subdivision:
    """The f faces into which n edges divide the plane; the edges form c connected components."""

    face: I64  #: (n, 2) faces on the left and on the right of each edge
    outer: Bool  #: (f,) whether each face is the outer face of its component
    component: I64  #: (n,) component of each edge
    enclosing: I64  #: (c,) bounded face around each component, -1 for none
    depth: I64  #: (c,) number of components around each component
    start: F64  #: (n, 2) mm, start of each edge; ends that meet are exactly equal
    end: F64  #: (n, 2) mm
    bulge: F64  #: (n,)

    @property
    def closing(self) -> Bool:
        """Mask of the edges that enclose an area together with other edges, (n,).

        Such an edge separates a bounded face from the outside of its component.
        """
        outer = self.outer[self.face]
        result: Bool = outer[:, 0] != outer[:, 1]
        return result

    @property
    def merged(self) -> I64:
        """Bounded face that equals or contains each of the f faces, (f,).

        The entry of a bounded face is the face itself.  The entry of an outer face is the bounded
        face around its component, or -1 if no bounded face contains its component.
        """
        component_of_face = np.zeros(len(self.outer), np.int64)
        component_of_face[self.face] = self.component[:, None]
        result: I64 = np.where(
            self.outer, self.enclosing[component_of_face], np.arange(len(self.outer))
        )
        return result

    def count_enclosing(self, points: F64) -> I64:
        """Return the number of components that enclose each of m points, (m,).

        ``points`` is (m, 2) mm.
        """
        if len(self.bulge) == 0:
            return np.zeros(len(points), np.int64)
        half = find_half_edges_below(points, self.start, self.end, self.bulge)
        below = np.flatnonzero(half >= 0)
        face = self.face.ravel()[half[below]]
        count = np.zeros(len(points), np.int64)
        count[below] = self.depth[self.component[half[below] // 2]] + ~self.outer[face]
        return count


def subdivide(ends: F64, bulge: F64) -> Subdivision:
    """Return the faces into which n edges divide the plane.

    Parameters
    ----------
    ends, bulge : (n, 2, 2) mm and (n,)
        Start and end points and bulges of the edges, in any order and direction.  The edges must
        meet only at their ends, otherwise the faces beside them are wrong.  Of coincident edges
        only the first one divides the plane.
    """
    if len(ends) == 0:
        none = np.zeros(0, np.int64)
        no_faces = none.reshape(0, 2), np.zeros(0, np.bool_)
        return Subdivision(*no_faces, none, none, none, ends[:, 0], ends[:, 1], bulge)
    points = ends.reshape(-1, 2)
    vertex = number_vertices(points)
    position = np.empty((int(vertex.max()) + 1, 2))
    position[vertex[::-1]] = points[::-1]
    first, last = vertex[::2].copy(), vertex[1::2].copy()
    same = first_coincident(first, last, bulge, position, JOIN)
    left, right, area = trace_sides(position, first, last, bulge, same)
    component, _ = connected_components(position, first, last)
    face = np.stack([left, right], axis=1)
    outer: Bool = area < _LEAST_AREA
    enclosing, depth = find_enclosing_faces(
        position[first], position[last], bulge, face, outer, component
    )
    return Subdivision(
        face.astype(np.int64),
        outer,
        component.astype(np.int64),
        enclosing,
        depth,
        position[first],
        position[last],
        bulge,
    )
