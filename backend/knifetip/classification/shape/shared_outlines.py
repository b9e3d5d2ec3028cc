"""shared_outlines: find the cuts that equal blanks share where they touch each other.

Blanks that touch are one component, and a cut between two of them looks like a fold.  A translation
maps each blank onto the next one, so it maps such a cut onto the outline of the last blank.
"""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Any, Final

import numpy as np

from knifetip.classification.shape.panels import Panels, measure_faces
from knifetip.classification.shape.roles import Role
from knifetip.geometry.columns import F64, I32, I64, U8, Bool
from knifetip.kernels import F64_2, kernel
from knifetip.topology.connected_faces import label_connected_faces
from knifetip.topology.faces import Faces
from knifetip.topology.planar_graph import PlanarGraph

#: Fewer blanks than this may be the two halves of one carton.
_FEWEST_BLANKS: Final = 3
#: Fewer panels than this are a board, a cover or a card rather than a carton.
_FEWEST_PANELS: Final = 6
#: Least fraction of the area of all panels that is repeated; the rest may be waste.
_MIN_REPEATED: Final = 0.7
#: Largest numbers of panels of a component, and of pairs of its lines, that are examined.
_MOST_PANELS: Final = 500
_MOST_PAIRS: Final = 4_000_000
#: Largest number of components that are examined.
_MOST_COMPONENTS: Final = 20
#: Greatest difference between the areas of equal panels, as a fraction.
_AREA_TOLERANCE: Final = 0.003
#: Greatest distance between the centres of equal panels, as a fraction of the largest panel's size.
_CENTRE_TOLERANCE: Final = 0.01
#: Greatest distance between a line and the image of another one (mm).
_TOLERANCE: Final = 0.2


def mark_shared_outlines(
    graph: PlanarGraph, faces: Faces, length: F64, role: U8, unit: float
) -> tuple[I32, Bool]:
    """Give the role of an outline to dividers between three or more equal cartons that touch.

    Returns the number of cartons that each component consists of, (c,), which is 1 for others, and
    the mask of pieces that may be common cuts of other equal blanks, (p,), such as cards or sleeves
    of few panels.

    Parameters
    ----------
    graph, faces
        Planar graph of a drawing, with p pieces of edges, and its faces.
    length, role : (p,) each
        Length and Role of each piece.  The function writes to ``role``.
    unit
        Number of drawing units in a millimetre.
    """
    blanks = np.ones(len(faces.outer_face), np.int32)
    divider, possible = role == Role.DIVIDER, np.zeros(len(role), np.bool_)
    if not divider.any():
        return blanks, possible
    outline = role == Role.OUTLINE
    at_rim, beside = np.zeros((2, len(faces.area)), np.bool_)
    for mask, pieces in ((at_rim, outline), (beside, outline | divider)):
        mask[faces.left[pieces]] = mask[faces.right[pieces]] = True
    least = 2 * _FEWEST_BLANKS
    chosen = np.flatnonzero(beside & (faces.area > 0.0))
    panels = np.bincount(faces.component[chosen], minlength=len(faces.outer_face))
    large = np.flatnonzero((panels >= least) & (panels <= _MOST_PANELS))[:_MOST_COMPONENTS]
    if len(large) == 0:
        return blanks, possible
    measured = measure_faces(graph, faces, length, at_rim, large)
    for component in large.tolist():
        own = chosen[faces.component[chosen] == component]
        steps, count = _steps_of_blanks(measured.take(own))
        if count < _FEWEST_BLANKS:
            continue
        pieces = np.flatnonzero((graph.component == component) & (graph.bulge == 0.0))
        inner, outer = pieces[divider[pieces]], pieces[outline[pieces]]
        if len(inner) * len(outer) > _MOST_PAIRS:
            continue
        shared = inner[_map_onto(_chords(graph, inner), _chords(graph, outer), steps, unit)]
        rest = np.setdiff1d(np.flatnonzero(divider), shared)
        sides = np.column_stack([faces.left[rest], faces.right[rest]])
        label = label_connected_faces(len(faces.area), sides)
        is_carton = len(own) >= count * _FEWEST_PANELS
        if is_carton and _groups_repeat(label[own], faces.area[own], count):
            role[shared] = Role.OUTLINE
            blanks[component] = count
        else:
            possible[shared] = True
    return blanks, possible


def _steps_of_blanks(panels: Panels) -> tuple[F64, int]:
    """Return the translations that map the panels at the outline onto other ones, (k, 2).

    Also returns the number of equal blanks: as many panels are equal to the largest one that is
    repeated, and are reached from it by these translations.  Waste between blanks is not mapped.
    """
    area, centre, _, at_rim = panels
    equal = np.abs(area[:, None] - area) <= _AREA_TOLERANCE * np.maximum(area[:, None], area)
    tolerance = _CENTRE_TOLERANCE * math.sqrt(float(area.max()))
    repeated = np.flatnonzero(equal.sum(axis=0) >= _FEWEST_BLANKS)
    if len(repeated) == 0:
        return np.empty((0, 2)), 1
    largest = int(repeated[area[repeated].argmax()])
    steps: list[F64] = []
    links = []
    for other in np.flatnonzero(equal[largest]).tolist():
        step = centre[other] - centre[largest]
        if other == largest or any(np.hypot(*(step + one)) <= tolerance for one in steps):
            continue
        mapped = equal & (np.abs(centre - centre[:, None] - step) <= tolerance).all(axis=2)
        image, source = mapped.any(axis=0), mapped.any(axis=1)
        if (image | source)[at_rim].all():
            steps.append(step)
            links.append(np.argwhere(mapped))
    if not steps:
        return np.empty((0, 2)), 1
    label = label_connected_faces(len(area), np.concatenate(links).astype(np.int32, order="C"))
    return np.array(steps), int(np.count_nonzero(label == label[largest]))


def _groups_repeat(label: I64, area: F64, count: int) -> bool:
    """Return whether each group of panels exists ``count`` times, or a multiple of it.

    Single panels that are repeated otherwise may be waste between the blanks, if they are small.
    ``label`` (m,) is the group of each panel, and ``area`` (m,) its area.
    """
    _, group = np.unique(label, return_inverse=True)
    total, panels = np.bincount(group, area), np.bincount(group)
    order = np.argsort(total, kind="stable")
    size = total[order]
    borders = np.flatnonzero(np.diff(size, prepend=0.0) > _AREA_TOLERANCE * size)
    waste = 0.0
    for first, last in pairwise([*borders.tolist(), len(size)]):
        if (last - first) % count:
            if (panels[order[first:last]] > 1).any():
                return False
            waste += size[first:last].sum()
    return bool(waste <= (1.0 - _MIN_REPEATED) * total.sum())


def _chords(graph: PlanarGraph, pieces: I64) -> F64:
    """Return the start and end of straight pieces, (k, 4)."""
    chords: F64 = np.hstack([graph.vertex[graph.start[pieces]], graph.vertex[graph.end[pieces]]])
    return chords


def _map_onto(inner: F64, outer: F64, steps: F64, unit: float) -> Bool:
    """Return the mask of lines whose image under a translation, or its inverse, lies on another.

    ``inner``, ``outer`` (k, 4) and (m, 4): ends of the lines, and of the others.
    ``steps`` (s, 2): the translations.
    ``unit``: number of drawing units in a millimetre.
    """
    both = np.concatenate([steps, -steps])
    mask: Bool = _mark_images(inner, outer, both, _TOLERANCE * unit)
    return mask


@kernel
def _mark_images(inner: F64_2, outer: F64_2, steps: F64_2, tolerance: float) -> Any:
    """Return the mask of lines whose middle is moved onto a parallel line by one of some steps."""
    found = np.zeros(len(inner), np.bool_)
    for i in range(len(inner)):
        along_x, along_y = inner[i, 2] - inner[i, 0], inner[i, 3] - inner[i, 1]
        for s in range(len(steps)):
            if found[i]:
                break
            x = 0.5 * (inner[i, 0] + inner[i, 2]) + steps[s, 0]
            y = 0.5 * (inner[i, 1] + inner[i, 3]) + steps[s, 1]
            for j in range(len(outer)):
                u, v = outer[j, 2] - outer[j, 0], outer[j, 3] - outer[j, 1]
                size = math.sqrt(u * u + v * v)
                if size == 0.0:
                    continue
                dx, dy = x - outer[j, 0], y - outer[j, 1]
                if abs(dx * v - dy * u) > tolerance * size:
                    continue
                reach = dx * u + dy * v
                if reach < 0.0 or reach > size * size:
                    continue
                if abs(along_x * v - along_y * u) <= tolerance * size:
                    found[i] = True
                    break
    return found
