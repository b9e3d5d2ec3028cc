"""The faces and parts beside each edge of a dieline, compared with shapely's polygons."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from shapely import LineString, Point
from shapely.ops import polygonize

from knifetip.classification.shape.features import extract_shape_features
from knifetip.cleaning.clean import clean
from knifetip.geometry.columns import F64
from knifetip.model.dieline import Dieline, LineType
from tests.support.examples import examples
from tests.support.shapes import dieline, edges

#: Side of a square of the lattice (mm).
SIDE = 20.0


def lattice(chosen: list[bool]) -> F64:
    """Return the sides of chosen squares of a 6 × 6 lattice, without duplicates, (n, 2, 2) mm."""
    sides = set()
    for number in np.flatnonzero(chosen).tolist():
        x, y = divmod(number, 6)
        corners = [(x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)]
        for k in range(4):
            sides.add(tuple(sorted((corners[k], corners[(k + 1) % 4]))))
    return SIDE * np.array(sorted(sides), np.float64)


@examples(60)
@given(chosen=st.lists(st.booleans(), min_size=36, max_size=36).filter(any))
def test_faces_are_the_polygons_of_shapely(chosen: list[bool]) -> None:
    ends = lattice(chosen)
    features = extract_shape_features(ends, np.zeros(len(ends)))
    polygons = list(polygonize([LineString(edge) for edge in ends]))
    along = ends[:, 1] - ends[:, 0]
    left = np.stack([-along[:, 1], along[:, 0]], axis=1) / SIDE
    polygon_of: dict[int, int] = {-1: -1}
    for edge in range(len(ends)):
        for side, away in enumerate((left[edge], -left[edge])):
            point = Point(ends[edge].mean(axis=0) + away)
            inside = [k for k, polygon in enumerate(polygons) if polygon.contains(point)]
            expected = inside[0] if inside else -1
            assert polygon_of.setdefault(int(features.sides[edge, side]), expected) == expected
    assert len(polygon_of) == len(set(polygon_of.values()))


def panel_with_hole() -> Dieline:
    """Return the dieline of two blanks: one of two panels with a hole, and one without."""
    ends = edges(
        *(((0, 0), (80, 0)), ((80, 0), (80, 50)), ((80, 50), (0, 50)), ((0, 50), (0, 0))),
        ((40, 0), (40, 50)),
        *(((10, 10), (30, 10)), ((30, 10), (30, 40)), ((30, 40), (10, 40)), ((10, 40), (10, 10))),
        *(((100, 0), (150, 0)), ((150, 0), (150, 50)), ((150, 50), (100, 50))),
        ((100, 50), (100, 0)),
    )
    features = extract_shape_features(ends, np.zeros(len(ends)))
    cut, crease = LineType.CUT, LineType.CREASE
    drawn = dieline((cut, ends[:4]), (crease, ends[4:5]), (cut, ends[5:]))
    return replace(drawn, face=features.sides, part=features.part)


def test_a_hole_belongs_to_its_panel_and_its_blank() -> None:
    drawn = panel_with_hole()
    face, part = drawn.face, drawn.part
    assert len({*part[:9].tolist()}) == 1
    assert len({*part.tolist()}) == 2
    panel = face[4, 0]
    assert panel >= 0
    assert face[5:9, 1].tolist() == [panel] * 4, "the hole is drawn counter-clockwise"
    assert (face[:4, 1] == -1).all()
    assert (face[9:, 1] == -1).all()


@pytest.mark.parametrize("swapped", [(), (0,), (1,), (0, 1)])
@pytest.mark.parametrize("first", [0, 1])
def test_cleaning_keeps_faces_on_their_sides(first: int, swapped: tuple[int, ...]) -> None:
    halves = edges(((0, 50), (40, 50)), ((40, 50), (80, 50)))
    for row in swapped:
        halves[row] = halves[row, ::-1]
    rest = edges(((0, 50), (0, 0)), ((0, 0), (80, 0)), ((80, 0), (80, 50)))
    drawn = dieline((LineType.CUT, np.concatenate([halves[[first, 1 - first]], rest])))
    features = extract_shape_features(drawn.ends, np.zeros(5))
    cleaned = clean(replace(drawn, face=features.sides, part=features.part)).dieline
    (panel,) = set(features.sides[features.sides >= 0].tolist())
    (merged,) = np.flatnonzero((np.abs(cleaned.ends[:, 0] - cleaned.ends[:, 1])[:, 0] == 80)[:2])
    to_the_right = cleaned.ends[merged, 0, 0] < cleaned.ends[merged, 1, 0]
    assert cleaned.face[merged].tolist() == ([-1, panel] if to_the_right else [panel, -1])
    assert cleaned.part[merged] == features.part[0]


def test_a_dieline_without_a_graph_has_no_faces() -> None:
    plain = dieline((LineType.CUT, edges(((0, 0), (10, 0)))))
    assert (plain.face.tolist(), plain.part.tolist()) == ([[-1, -1]], [-1])
