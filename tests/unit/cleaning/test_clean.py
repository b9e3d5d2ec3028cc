"""``clean`` with drawings that are small enough to compute the result by hand."""

from __future__ import annotations

import numpy as np
import pytest

from knifetip.cleaning.clean import clean
from knifetip.errors import GeometryError
from knifetip.geometry import arc
from knifetip.messages import render
from knifetip.model.cleaned import Cleaned, CleaningReason
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.drawing import ImportOutcome
from tests.support.shapes import dieline, edges

CUT, CREASE, GROOVE = LineType.CUT, LineType.CREASE, LineType.V_GROOVE
PERFORATION, HALF_CUT, COMBI = LineType.PERFORATION, LineType.HALF_CUT, LineType.COMBI
IGNORED, UNCLASSIFIED = LineType.IGNORED, LineType.UNCLASSIFIED


def lines(*rows: tuple[LineType, float, float, float, float]) -> Dieline:
    """Return a dieline of lines, each from one point to another with a line type."""
    return dieline(*((kind, edges(((a, b), (c, d)))) for kind, a, b, c, d in rows))


def worked(made: Cleaned) -> list[tuple[str, list[list[float]]]]:
    """Return line type and end points of the edges that are machined, rounded to 1e-6 mm."""
    line = made.dieline
    return [
        (LineType(line.line_type[row]).word, (np.round(line.ends[row], 6) + 0.0).tolist())
        for row in range(len(line))
        if line.line_type[row] not in (IGNORED, UNCLASSIFIED)
    ]


def reasons(made: Cleaned) -> list[str]:
    return [CleaningReason(code).name for code in made.reason]


def test_a_clean_drawing_stays_bit_for_bit() -> None:
    line = lines((CUT, 0, 0, 100, 0.1), (CUT, 100, 0.1, 99.7, 50), (CREASE, 50, 0.05, 50, 40))
    made = clean(line)
    np.testing.assert_array_equal(made.dieline.ends, line.ends)
    np.testing.assert_array_equal(made.dieline.line_type, line.line_type)
    assert reasons(made) == ["AS_DRAWN"] * 3
    assert not made.changed.any()


def test_an_empty_drawing_is_clean() -> None:
    made = clean(dieline((CUT, edges())))
    assert len(made.dieline) == 0


def test_a_line_drawn_twice_and_backwards_is_worked_once() -> None:
    made = clean(lines((CUT, 0, 0, 100, 0), (CUT, 100, 0, 0, 0), (CUT, 0, 0, 100, 0)))
    assert worked(made) == [("cut", [[0, 0], [100, 0]])]
    assert reasons(made) == ["AS_DRAWN", "TWICE", "TWICE"]
    assert made.kept.tolist() == [100, 0, 0]
    assert made.merged.tolist() == [0, 100, 100]
    assert [made.replacement_row(row) for row in range(3)] == [0, 0, 0]
    assert render(made.describe(1)) == "the edge lies on edge 0 and was merged into it"


def test_two_cuts_that_share_forty_millimetres_become_one_of_a_hundred_and_fifty() -> None:
    made = clean(lines((CUT, 0, 0, 100, 0), (CUT, 60, 0, 150, 0)))
    assert worked(made) == [("cut", [[0, 0], [150, 0]])]
    assert made.kept.tolist() == [100, 50]
    assert made.merged.tolist() == [0, 40]
    assert reasons(made) == ["LONGER", "JOINED"]


def test_a_cut_on_a_crease_cuts_and_the_rest_is_creased() -> None:
    made = clean(lines((CREASE, 0, 0, 100, 0), (CUT, 60, 0, 70, 0)))
    assert worked(made) == [
        ("crease", [[0, 0], [60, 0]]),
        ("cut", [[60, 0], [70, 0]]),
        ("crease", [[70, 0], [100, 0]]),
    ]
    np.testing.assert_allclose(made.kept, [90, 10])
    np.testing.assert_allclose(made.merged, [10, 0], atol=1e-9)
    assert reasons(made) == ["SHORTENED", "AS_DRAWN"]
    # Additional pieces of an edge follow at the end, with the row of their source.
    assert made.dieline.source.tolist() == [0, 1, 0]


@pytest.mark.parametrize(
    ("one", "other", "left"),
    [
        (CUT, CREASE, ["cut"]),
        (CUT, PERFORATION, ["cut"]),
        (GROOVE, CREASE, ["v-groove"]),
        (CUT, GROOVE, ["cut"]),
        (COMBI, CREASE, ["combi"]),
        (COMBI, PERFORATION, ["combi"]),
        (PERFORATION, HALF_CUT, ["perforation"]),
        (HALF_CUT, CREASE, ["half-cut"]),
        (PERFORATION, CREASE, ["crease", "perforation"]),
        (IGNORED, CREASE, ["crease"]),
        (UNCLASSIFIED, CUT, ["cut"]),
    ],
)
def test_of_coincident_edges_the_operation_that_separates_more_is_kept(
    one: LineType, other: LineType, left: list[str]
) -> None:
    for first, second in ((one, other), (other, one)):
        made = clean(lines((first, 0, 0, 30, 40), (second, 30, 40, 0, 0)))
        assert sorted(kind for kind, _ in worked(made)) == left


def test_ignored_edges_are_left_alone_and_hide_nothing() -> None:
    line = lines((IGNORED, 0, 0, 100, 0), (IGNORED, 0, 0, 100, 0), (IGNORED, 5, 5, 5.01, 5))
    made = clean(line)
    np.testing.assert_array_equal(made.dieline.ends, line.ends)
    assert reasons(made) == ["NO_WORK"] * 3
    assert made.kept.sum() == pytest.approx(200.01)


def test_an_unclassified_edge_remains_unclassified() -> None:
    made = clean(lines((UNCLASSIFIED, 0, 0, 100, 0), (CUT, 0, 0, 100, 0)))
    assert made.dieline.line_type.tolist() == [UNCLASSIFIED, CUT]


def test_lines_0_04_mm_apart_are_merged_and_lines_0_06_mm_apart_are_not() -> None:
    assert len(worked(clean(lines((CUT, 0, 0, 100, 0), (CUT, 10, 0.009, 90, 0.009))))) == 1
    assert len(worked(clean(lines((CUT, 0, 0, 100, 0), (CUT, 10, 0.04, 90, 0.04))))) == 1
    assert len(worked(clean(lines((CUT, 0, 0, 100, 0), (CUT, 10, 0.06, 90, 0.06))))) == 2


def test_lines_that_cross_at_a_small_angle_are_two() -> None:
    assert len(worked(clean(lines((CUT, 0, 0, 100, 0), (CUT, 0, -1, 100, 1))))) == 2


def test_half_a_circle_drawn_over_a_quarter_of_it() -> None:
    half = dieline(
        (CUT, edges(((10, 0), (-10, 0)), ((0, 10), (-10, 0)))), bulge={0: 1.0, 1: np.tan(np.pi / 8)}
    )
    made = clean(half)
    assert worked(made) == [("cut", [[10, 0], [-10, 0]])]
    assert made.merged[1] == pytest.approx(5 * np.pi)


def test_arcs_of_one_circle_that_overlap_become_one() -> None:
    # Radius 10, 0° to 120° and 80° to 170°, the second counter-clockwise.
    place = np.radians([0, 120, 80, 170])
    points = 10 * np.column_stack([np.cos(place), np.sin(place)])
    line = dieline(
        (CUT, np.array([[points[0], points[1]], [points[3], points[2]]])),
        bulge={0: np.tan(np.radians(30)), 1: -np.tan(np.radians(22.5))},
    )
    made = clean(line)
    assert reasons(made) == ["LONGER", "JOINED"]
    np.testing.assert_allclose(made.dieline.ends[0], points[[0, 3]], atol=1e-9)
    assert made.dieline.bulge[0] == pytest.approx(np.tan(np.radians(42.5)))
    np.testing.assert_allclose(made.merged, [0, 10 * np.radians(40)], atol=1e-9)


def test_the_two_halves_of_a_circle_are_two_edges() -> None:
    made = clean(
        dieline((CUT, edges(((10, 0), (-10, 0)), ((-10, 0), (10, 0)))), bulge={0: 1.0, 1: 1.0})
    )
    assert reasons(made) == ["AS_DRAWN", "AS_DRAWN"]


def test_a_circle_drawn_twice_with_its_seam_elsewhere_is_cut_once() -> None:
    ends = edges(((10, 0), (-10, 0)), ((-10, 0), (10, 0)), ((0, 10), (0, -10)), ((0, -10), (0, 10)))
    made = clean(dieline((CUT, ends), bulge=dict.fromkeys(range(4), 1.0)))
    assert made.kept.sum() == pytest.approx(20 * np.pi)
    assert made.merged.sum() == pytest.approx(20 * np.pi)


def test_a_corner_left_open_is_closed_where_the_lines_cross() -> None:
    made = clean(lines((CUT, 0, 0, 99.97, 0), (CUT, 100, 0.02, 100, 50)))
    assert worked(made) == [("cut", [[0, 0], [100, 0]]), ("cut", [[100, 0], [100, 50]])]
    np.testing.assert_allclose(made.moved, [0.03, 0.02], atol=1e-9)
    np.testing.assert_allclose(made.added, [0.03, 0.02], atol=1e-9)
    assert reasons(made) == ["MOVED", "MOVED"]


def test_lines_that_cross_just_past_each_other_are_cut_back() -> None:
    made = clean(lines((CUT, 0, 0, 100.03, 0), (CUT, 100, -0.02, 100, 50)))
    assert worked(made) == [("cut", [[0, 0], [100, 0]]), ("cut", [[100, 0], [100, 50]])]
    np.testing.assert_allclose(made.added, [-0.03, -0.02], atol=1e-9)


def test_a_line_with_a_gap_becomes_one_and_the_gap_is_recorded() -> None:
    made = clean(lines((CREASE, 0, 0, 99.97, 0), (CREASE, 100, 0, 200, 0)))
    assert worked(made) == [("crease", [[0, 0], [200, 0]])]
    assert made.kept.sum() == pytest.approx(199.97)
    assert made.added.sum() == pytest.approx(0.03)


def test_a_gap_wider_than_the_tolerance_stays() -> None:
    made = clean(lines((CUT, 0, 0, 99.94, 0), (CUT, 100, 0, 200, 0)))
    assert reasons(made) == ["AS_DRAWN", "AS_DRAWN"]


def test_a_loose_end_moves_to_the_vertex_of_other_ends() -> None:
    line = lines((CUT, 0, 0, 100, 0), (CUT, 100, 0, 200, 30), (CUT, 100, 50, 100, 0.04))
    made = clean(line)
    np.testing.assert_array_equal(made.dieline.ends[:2], line.ends[:2])
    assert made.dieline.ends[2].tolist() == [[100, 50], [100, 0]]


def test_an_arc_keeps_its_bulge_when_its_end_moves() -> None:
    line = dieline((CUT, edges(((0, 0), (10, 0)), ((10.02, 0), (10.02, 30)))), bulge={0: 1.0})
    made = clean(line)
    assert made.dieline.bulge[0] == 1.0
    assert made.dieline.ends[0, 1].tolist() == made.dieline.ends[1, 0].tolist()
    assert (made.moved <= 0.05).all()


def test_t_junctions_stay() -> None:
    line = lines((CUT, 0, 0, 100, 0), (CUT, 50, 0, 50, 50), (CUT, 30, 0.03, 30, 50))
    made = clean(line)
    np.testing.assert_array_equal(made.dieline.ends, line.ends)


def test_an_end_on_the_inside_of_an_edge_does_not_go_to_the_corner_beside_it() -> None:
    line = lines((CUT, 0, 0, 100, 0), (CUT, 99.97, 0, 99.97, 50))
    made = clean(line)
    np.testing.assert_array_equal(made.dieline.ends, line.ends)


def test_lines_that_end_side_by_side_stay_two() -> None:
    line = lines((CUT, 0, 0, 100, 0), (CUT, 0, 0.03, 100, 5))
    np.testing.assert_array_equal(clean(line).dieline.ends, line.ends)


def test_a_cut_is_not_moved_to_meet_a_crease() -> None:
    line = lines((CUT, 0, 0, 100, 0), (CREASE, 100.02, 0, 200, 0))
    np.testing.assert_array_equal(clean(line).dieline.ends, line.ends)


def test_pieces_of_one_line_become_one_in_the_direction_of_the_first() -> None:
    made = clean(lines((CUT, 60, 0, 30, 0), (CUT, 0, 0, 30, 0), (CUT, 60, 0, 100, 0)))
    assert worked(made) == [("cut", [[100, 0], [0, 0]])]
    assert reasons(made) == ["LONGER", "JOINED", "JOINED"]
    assert made.kept.sum() == 100


def test_pieces_stay_apart_where_a_third_edge_ends() -> None:
    made = clean(lines((CUT, 0, 0, 50, 0), (CUT, 50, 0, 100, 0), (CREASE, 50, 0, 50, 40)))
    assert reasons(made) == ["AS_DRAWN"] * 3


def test_pieces_of_two_types_stay_two() -> None:
    made = clean(lines((CUT, 0, 0, 50, 0), (CREASE, 50, 0, 100, 0)))
    assert reasons(made) == ["AS_DRAWN"] * 2


def test_a_square_of_split_sides_is_four_edges_wherever_it_is_begun() -> None:
    corners = [(0, 0), (50, 0), (100, 0), (100, 60), (100, 100), (0, 100), (0, 30)]
    for first in range(len(corners)):
        ring = corners[first:] + corners[:first]
        pairs = zip(ring, ring[1:] + ring[:1], strict=True)
        made = clean(dieline((CUT, edges(*pairs))))
        assert len(worked(made)) == 4
        assert made.kept.sum() == 400


def test_debris_is_dropped_with_its_length() -> None:
    made = clean(lines((CUT, 0, 0, 100, 0), (CUT, 40, 20, 40.03, 20), (CREASE, 50, 0, 50, 0.04)))
    assert reasons(made) == ["AS_DRAWN", "SPECK", "SPECK"]
    np.testing.assert_allclose(made.dropped, [0, 0.03, 0.04])
    assert made.cleaned_row.tolist() == [0, -1, -1]
    assert (
        render(made.describe(1))
        == "the edge was dropped, because it is only 0.03 mm long and connects no other edges"
    )


def test_an_edge_without_length_is_debris() -> None:
    made = clean(lines((CUT, 0, 0, 100, 0), (CUT, 7, 7, 7, 7)))
    assert reasons(made) == ["AS_DRAWN", "SPECK"]


def test_a_drawing_of_debris_only_has_no_edges_to_machine() -> None:
    made = clean(lines((CUT, 7, 7, 7, 7), (CUT, 9, 9, 9.01, 9)))
    assert reasons(made) == ["SPECK", "SPECK"]
    assert worked(made) == []


def test_a_dot_of_tiny_lines_is_dropped_as_a_whole() -> None:
    ring = [(5, 5), (5.02, 5), (5.02, 5.02), (5, 5.02)]
    dot = edges(*zip(ring, ring[1:] + ring[:1], strict=True))
    made = clean(dieline((CUT, edges(((0, 0), (100, 0)))), (CUT, dot)))
    assert made.count(ImportOutcome.DROPPED) == 4
    assert made.dropped.sum() == pytest.approx(0.08)


def test_a_chamfer_below_the_tolerance_becomes_the_corner_and_a_larger_one_stays() -> None:
    small = clean(
        lines(
            (CUT, 0, 0, 100, 0), (CUT, 100, 0, 100.006, 0.006), (CUT, 100.006, 0.006, 100.006, 50)
        )
    )
    assert reasons(small) == ["MOVED", "SPECK", "MOVED"]
    assert worked(small)[0] == ("cut", [[0, 0], [100.006, 0]])
    large = clean(
        lines((CUT, 0, 0, 100, 0), (CUT, 100, 0, 100.03, 0.03), (CUT, 100.03, 0.03, 100.03, 50))
    )
    assert reasons(large) == ["AS_DRAWN"] * 3


def test_debris_that_bridges_a_wide_gap_is_kept_and_its_gaps_are_closed() -> None:
    made = clean(lines((CUT, 0, 0, 10, 0), (CUT, 10.03, 0, 10.07, 0), (CUT, 10.1, 0, 20, 0)))
    assert worked(made) == [("cut", [[0, 0], [20, 0]])]


def test_three_quarters_of_a_circle_in_fifteen_hundred_segments_are_two_arcs() -> None:
    place = np.linspace(0, 1.5 * np.pi, 1501)
    points = np.round(10 * np.column_stack([np.cos(place), np.sin(place)]), 4)
    made = clean(dieline((CUT, np.stack([points[:-1], points[1:]], axis=1))))
    rows = np.flatnonzero(made.dieline.line_type == CUT)
    assert len(rows) == 2
    radius = arc.radius(
        made.dieline.ends[rows, 0], made.dieline.ends[rows, 1], made.dieline.bulge[rows]
    )
    np.testing.assert_allclose(radius, 10, atol=0.001)
    assert made.off.max() < 0.005
    assert reasons(made)[2] == "FITTED"
    assert made.count(ImportOutcome.KEPT) == 2
    assert made.kept.sum() == pytest.approx(15 * np.pi, abs=0.001)


def test_a_line_in_tiny_segments_with_rounded_ends_is_one_line() -> None:
    x = np.linspace(0, 30, 1001)
    points = np.round(np.column_stack([x, x / 3]), 3)
    made = clean(dieline((CREASE, np.stack([points[:-1], points[1:]], axis=1))))
    assert worked(made) == [("crease", [[0, 0], [30, 10]])]
    assert made.off.max() < 0.001


def test_a_corner_in_a_flattened_curve_stays_a_corner() -> None:
    up = np.column_stack([np.linspace(0, 4, 101), np.zeros(101)])
    points = np.concatenate(
        [up, up[-1] + np.column_stack([np.zeros(100), np.arange(1, 101) * 0.04])]
    )
    made = clean(dieline((CUT, np.stack([points[:-1], points[1:]], axis=1))))
    assert worked(made) == [("cut", [[0, 0], [4, 0]]), ("cut", [[4, 0], [4, 4]])]


def test_a_coordinate_that_is_not_finite_is_refused() -> None:
    with pytest.raises(GeometryError, match="Edge 1 has a coordinate that is not a number"):
        clean(lines((CUT, 0, 0, 1, 0), (CUT, 0, 0, np.nan, 0)))


def test_coordinates_absurdly_far_away_are_refused() -> None:
    with pytest.raises(
        GeometryError,
        match=r"Edge 1 lies 1E150 mm away from the origin of the drawing, which is too far",
    ):
        clean(lines((CUT, 0, 0, 1, 0), (CUT, 0, 0, 1e150, 0)))


def test_a_cluster_of_debris_is_cleaned() -> None:
    random = np.random.default_rng(3)
    line = dieline((CUT, random.uniform(0, 0.05, (5000, 2, 2))))
    made = clean(line)
    length = arc.length(line.ends[:, 0], line.ends[:, 1], line.bulge)
    np.testing.assert_allclose(made.kept + made.merged + made.dropped, length, atol=1e-9)


def test_stretches_cover_every_edge_that_is_worked() -> None:
    made = clean(lines((CREASE, 0, 0, 100, 0), (CUT, 60, 0, 70, 0), (CUT, 90, 0, 95, 0)))
    parts = made.stretches
    first = parts.row == 0
    assert parts.begin[first].tolist() == pytest.approx([0, 0.6, 0.7, 0.9, 0.95])
    assert parts.end[first].tolist() == pytest.approx([0.6, 0.7, 0.9, 0.95, 1])
    assert parts.cleaned[first].tolist() == [0, 1, 3, 2, 4]
    assert parts.by_other_edge[first].tolist() == [False, True, False, True, False]


def test_a_short_line_that_another_divides_into_debris_is_not_lost() -> None:
    drawn = lines((CUT, 0.29, 0.84, 0.36, 0.87), (CUT, 0.26, 0.86, 0.31, 0.85))
    assert clean(drawn).dropped.tolist() == [0.0, 0.0]
