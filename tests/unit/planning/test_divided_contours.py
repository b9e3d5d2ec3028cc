"""The outline of a blank that a cut divides at X100, and of a blank beside it."""

from __future__ import annotations

import numpy as np
import pytest

from knifetip.planning.divided_contours import join_contours
from tests.support.shapes import closed, edges

#: Anticlockwise: two edges of the left part, three of the right one, and the last of the left one.
OUTLINE = closed((0, 0), (100, 0), (200, 0), (200, 100), (100, 100), (0, 100))
PART = np.array([0, 1, 1, 1, 0, 0, -1])
CUT = edges(((100, 0), (100, 100)))


@pytest.mark.parametrize(
    ("layers", "is_hole", "apart", "contours"),
    [
        ((1, 1), False, 50.0, [0, 0]),
        # The left part is cut out before the right one.
        ((2, 1), False, 50.0, [0, 1]),
        ((2, 1), False, 4.0, [0, 0]),
        ((2, 1), True, 50.0, [0, 0]),
    ],
)
def test_parts_of_different_layers_are_apart_unless_the_cutter_runs_into_another_contour(
    layers: tuple[int, int], is_hole: bool, apart: float, contours: list[int]
) -> None:
    # A blank at the right of it, which the cutter of 6 mm enters if it is nearer than that.
    other = closed(*((200 + apart + x, y) for x, y in ((0, 0), (50, 0), (50, 100), (0, 100))))
    ends = np.concatenate([OUTLINE, CUT, other])
    part = np.append(PART, np.full(4, 2))
    layer = np.append(np.array([*layers, 3])[PART], np.zeros(4, np.int64))
    removed = np.where(part < 0, 0, -1).astype(np.int8)
    if is_hole:
        removed[:6] = 1
    waste = np.where((part < 2) & is_hole, 0, removed).astype(np.int8)
    found, new_layer = join_contours(
        ends, np.zeros(len(ends)), waste, removed, part, layer, radius=3.0
    )
    assert found.tolist() == [*np.array([*contours, -1])[PART], 2, 2, 2, 2]
    one_contour = contours[0] == contours[1]
    expected = np.where(PART < 0, 3, min(layers)) if one_contour else np.array([*layers, 3])[PART]
    assert new_layer[:7].tolist() == expected.tolist()
    assert new_layer[7:].tolist() == [0, 0, 0, 0]
