"""missing_lines: find straight lines that are missing in the outline of a blank.

A blank is one piece: folds and other dividers join all its panels.  If the panels of a component
form several groups that only touch at points, cutting the outline would separate them, so a panel
between the groups may lack an edge.  Such an edge continues a line of one group and ends at a line
of another group that continues it in turn, as the tops of neighbouring panels do.
"""

from __future__ import annotations

from typing import Any, Final, NamedTuple

import numpy as np

from knifetip.classification.shape.roles import Role
from knifetip.geometry.columns import F64, I32, I64, U8
from knifetip.geometry.union_find import flatten, union
from knifetip.kernels import F64_1, I32_1, I32_2, U8_1, kernel

#: Largest number of blanks, and of edges of a blank, that are examined.
_MOST_BLANKS: Final = 64
_MOST_EDGES: Final = 400
#: Largest number of lines that are tried for a blank.
MOST_TRIALS: Final = 4
#: Least length of a missing line (mm).
_SHORTEST: Final = 5.0
#: Greatest distance between lines on one straight line (mm), and sine of the angle between them.
_BESIDE: Final = 0.1
_SINE: Final = 0.01
_DIVIDER, _OUTLINE = int(Role.DIVIDER), int(Role.OUTLINE)


class PanelGroups(NamedTuple):
    """The groups of panels that folds and other dividers join."""

    edge: I32  #: (n,) group of the panels beside each outline edge or divider, -1 for other edges
    number: I64  #: (c,) number of groups of each component, or of each of the blanks in it
    blanks: I64  #: (c,) number of equal blanks that each component consists of

    @classmethod
    def find(
        cls,
        role: U8,
        component: I32,
        blanks: I32,
        faces: I32,
        further_faces: I32,
        area: F64,
        least: float,
    ) -> PanelGroups:
        """Return the groups of panels of a drawing with n edges.

        Parameters
        ----------
        role, component, blanks, faces, further_faces, area
            Columns of the shape features of the edges.
        least
            Least area of a panel; smaller faces are in no group of their own.
        """
        count = int(component.max(initial=-1)) + 1
        edge, number = _find_groups(role, component, faces, further_faces, area, least, count)
        inside = component >= 0
        equal = np.ones(count, np.int64)
        equal[component[inside]] = blanks[inside]
        return cls(edge, -(-number // equal), equal)


@kernel
def _find_groups(
    role: U8_1,
    component: I32_1,
    faces: I32_2,
    further: I32_2,
    area: F64_1,
    least: float,
    count: int,
) -> Any:
    """Return the group of each of n edges, (n,), and the number of groups of ``count`` components.

    The arguments are those of ``PanelGroups.find``, and the number of components.
    """
    parent = np.arange(len(area))
    for i in range(len(role)):
        if role[i] == _DIVIDER:
            union(parent, faces[i, 0], faces[i, 1])
    for k in range(len(further)):
        left, right = further[k, 1], further[k, 2]
        if role[further[k, 0]] == _DIVIDER and area[left] > 0.0 and area[right] > 0.0:
            union(parent, left, right)
    flatten(parent)
    group = np.full(len(role), -1, np.int32)
    size = np.zeros(len(area))
    for f in range(len(area)):
        if area[f] > 0.0:
            size[parent[f]] = max(size[parent[f]], area[f])
    counted = np.zeros(len(area), np.bool_)
    groups = np.zeros(count, np.int64)
    for i in range(len(role)):
        if role[i] != _DIVIDER and role[i] != _OUTLINE:
            continue
        face = faces[i, 0] if area[faces[i, 0]] > 0.0 else faces[i, 1]
        root = parent[face]
        if size[root] < least:
            continue
        group[i] = root
        if not counted[root]:
            counted[root] = True
            groups[component[i]] += 1
    return group, groups


def find_missing_lines(
    ends: F64, bulge: F64, component: I32, groups: PanelGroups, unit: float
) -> list[F64]:
    """Return lines that may be missing in outlines whose panels are not joined.

    Each array, (k, 2, 2), has the lines of one blank, the shortest first.

    Parameters
    ----------
    ends, bulge, component : (n, 2, 2), (n,) and (n,)
        Ends, bulges and components of the edges.
    groups
        The groups of panels of the drawing.
    unit
        Number of drawing units in a millimetre.
    """
    separate = np.flatnonzero(groups.number > 1)
    if not 0 < len(separate) <= _MOST_BLANKS:
        return []
    straight = (groups.edge >= 0) & (bulge == 0.0)
    by_blank = []
    for blank in separate.tolist():
        rows = np.flatnonzero(straight & (component == blank))
        number = int(groups.blanks[blank])
        if len(rows) > _MOST_EDGES * number:
            continue
        lines = _facing_lines(ends[rows], groups.edge[rows], unit)
        by_blank += [lines] if number == 1 else _divide_equally(lines, number, unit)
    return by_blank


def _divide_equally(lines: F64, blanks: int, unit: float) -> list[F64]:
    """Divide missing lines equally among blanks of one shape in a row; return the lines of each
    blank.

    ``lines`` (k, 2, 2) are the lines of all ``blanks`` together, the shortest first.
    """
    middle = lines.mean(axis=1)
    length = np.hypot(*(lines[:, 1] - lines[:, 0]).T)
    left = np.ones(len(lines), np.bool_)
    rows: list[list[int]] = []
    for first in range(len(lines)):
        equal = np.flatnonzero(left & (np.abs(length - length[first]) <= _BESIDE * unit))
        steps = middle[equal] - middle[first]
        for step in steps[np.argsort(np.hypot(*steps.T), kind="stable")[1:]] if left[first] else ():
            images = middle[first] + np.arange(blanks)[:, None] * step
            off = np.abs(middle[equal][:, None] - images).max(axis=2)
            if (off.min(axis=0) <= _BESIDE * unit).all():
                rows.append(equal[off.argmin(axis=0)].tolist())
                left[rows[-1]] = False
                break
    return [lines[[row[at] for row in rows]] for at in range(blanks)]


def _facing_lines(ends: F64, group: I32, unit: float) -> F64:
    """Return the lines that connect facing ends of lines of two groups, the shortest first.

    The result has the shape (k, 2, 2).
    ``ends`` (m, 2, 2) are the ends of the lines, and ``group`` (m,) is the group of each line.
    """
    point = ends.reshape(-1, 2)
    along = point - ends[:, ::-1].reshape(-1, 2)
    along /= np.maximum(np.hypot(*along.T), 1e-12)[:, None]
    owner = np.repeat(group, 2)
    apart = point[None] - point[:, None]
    gap = (apart * along[:, None]).sum(axis=2)
    across = np.abs(apart[..., 0] * along[:, None, 1] - apart[..., 1] * along[:, None, 0])
    facing = (across <= _BESIDE * unit) & (gap >= _SHORTEST * unit)
    facing &= (along @ along.T) < -np.sqrt(1.0 - _SINE**2)
    gap = np.where(facing, gap, np.inf)
    nearest = gap.argmin(axis=1)
    number = np.arange(len(point))
    mutual = (gap[number, nearest] < np.inf) & (nearest[nearest] == number)
    pairs = number[mutual & (number < nearest) & (owner != owner[nearest])]
    pairs = pairs[np.argsort(gap[pairs, nearest[pairs]], kind="stable")]
    lines: F64 = np.stack([point[pairs], point[nearest[pairs]]], axis=1)
    return lines
