"""The table of paths that is made from polylines, arcs and curves."""

from __future__ import annotations

import pytest

from knifetip.drawing_builder.clip import UNCLIPPED
from knifetip.drawing_builder.columns import Style
from knifetip.drawing_builder.path_table import ARC, CUBIC, LINE
from knifetip.drawing_builder.shape_paths import Shape, ShapePaths
from knifetip.errors import DrawingTooLarge
from knifetip.formats.limits import Limits
from knifetip.geometry.affine import IDENTITY

CUT = Style("cut", 1, -1, "Continuous")
FOLD = Style("fold", 5, -1, "Continuous")
ARC_NUMBERS = (0.0, 0.0, 2.0, 0.0, 1.0, 1.0, 0.0, 2.0)
CURVE_NUMBERS = (0.0, 0.0, 9.0, 0.0, 1.0, 1.0, 8.0, 1.0)


def test_segments_are_in_the_order_of_their_shapes() -> None:
    paths = ShapePaths(Limits(), "SVG")
    paths.add(3, CUT, IDENTITY, Shape(arcs=[ARC_NUMBERS], polylines=[[0, 0, 1, 0, 1, 1]]))
    paths.add(5, FOLD, IDENTITY, Shape(polylines=[[5, 5, 6, 6], [7, 7, 8, 8]]))
    paths.add(7, CUT, IDENTITY, Shape(curves=[CURVE_NUMBERS]))
    table, placed = paths.table(), paths.paths()
    assert table.path.tolist() == [0, 0, 0, 1, 1, 2]
    assert table.kind.tolist() == [LINE, LINE, ARC, LINE, LINE, CUBIC]
    assert table.numbers[:, :4].tolist() == [
        [0, 0, 1, 0],
        [1, 0, 1, 1],
        [0, 0, 2, 0],
        [5, 5, 6, 6],
        [7, 7, 8, 8],
        [0, 0, 9, 0],
    ]
    assert table.numbers[5].tolist() == list(CURVE_NUMBERS)
    assert placed.row.tolist() == [3, 5, 7]
    assert [paths.styles[one] for one in placed.style.tolist()] == [CUT, FOLD, CUT]
    assert placed.clip == ()


def test_without_shapes_the_table_is_empty() -> None:
    paths = ShapePaths(Limits(), "SVG")
    assert len(paths.table().kind) == 0
    paths.add(0, CUT, IDENTITY, Shape(polylines=[[1, 2]]))
    assert len(paths.table().kind) == 0
    assert paths.paths().matrix.tolist() == [list(IDENTITY)]


def test_a_clip_of_one_shape_gives_all_shapes_a_clip() -> None:
    paths = ShapePaths(Limits(), "SVG")
    clip = UNCLIPPED.intersect_box((0, 0, 1, 1))
    paths.add(0, CUT, IDENTITY, Shape(polylines=[[0, 0, 1, 0]]))
    paths.add(1, CUT, IDENTITY, Shape(polylines=[[0, 0, 9, 0]]), clip)
    assert list(paths.paths().clip) == [UNCLIPPED, clip]


def test_more_segments_than_the_limit_are_an_error() -> None:
    paths = ShapePaths(Limits(segments=3), "SVG")
    paths.add(0, CUT, IDENTITY, Shape([[0, 0, 1, 0]], [ARC_NUMBERS], [CURVE_NUMBERS]))
    with pytest.raises(DrawingTooLarge, match="SVG file has more than 3 lines"):
        paths.add(1, CUT, IDENTITY, Shape(polylines=[[0, 0, 1, 0]]))
