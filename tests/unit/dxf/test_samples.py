"""The sample drawings can be cut and folded closed; shapely checks their geometry."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
import pytest
import shapely

from knifetip.classification.classify import classify
from knifetip.classification.questions import list_questions
from knifetip.dxf.read import read
from knifetip.dxf.samples.cartons import corrugated_tray, rigid_box_blank, samples
from knifetip.dxf.samples.contours import CREASE, CUT, V_GROOVE
from knifetip.dxf.samples.tuck_end import tuck_end_carton
from knifetip.dxf.samples.write import Layer
from knifetip.geometry import arc
from knifetip.geometry.columns import F64
from knifetip.geometry.path import Paths
from knifetip.library import load
from knifetip.model.dieline import LineType

Sheet = Sequence[tuple[Layer, Paths]]

SHEETS = {
    "tuck-end-carton": tuck_end_carton,
    "tuck-end-carton, large": lambda: tuck_end_carton(120.0, 60.0, 200.0),
    "corrugated-tray": corrugated_tray,
    "corrugated-tray, e-flute": lambda: corrugated_tray(250.0, 180.0, 70.0, 1.5),
    "rigid-box-blank": rigid_box_blank,
    "rigid-box-blank, 3 mm": lambda: rigid_box_blank(300.0, 200.0, 60.0, 3.0),
}


@pytest.fixture(params=SHEETS)
def sheet(request: pytest.FixtureRequest) -> Sheet:
    make: Callable[[], Sheet] = SHEETS[request.param]
    return make()


def segments(sheet: Sheet, *layers: Layer) -> tuple[F64, F64]:
    """Return ends, (n, 2, 2), and bulges, (n,), of all segments on some layers."""
    chosen = [paths for layer, paths in sheet if layer in layers]
    ends = [np.stack([paths.start, paths.end], axis=1) for paths in chosen]
    return np.concatenate(ends), np.concatenate([paths.bulge for paths in chosen])


def flattened(ends: F64, bulge: F64) -> list[shapely.LineString]:
    """Return segments as shapely line strings, arcs with 48 chords each."""
    count = len(bulge)
    steps = np.linspace(0.0, 1.0, 49)
    start, end = np.repeat(ends[:, 0], 49, axis=0), np.repeat(ends[:, 1], 49, axis=0)
    points = arc.point_at(start, end, np.repeat(bulge, 49), np.tile(steps, count))
    return [
        shapely.LineString(row if turned else pair)
        for row, pair, turned in zip(points.reshape(count, 49, 2), ends, bulge != 0, strict=True)
    ]


def outline(sheet: Sheet) -> shapely.Polygon:
    """Return the largest closed contour of the cuts."""
    lines = flattened(*segments(sheet, CUT))
    return max(shapely.polygonize(lines).geoms, key=lambda face: face.area)


def lines_of(sheet: Sheet, layer: Layer) -> F64:
    return segments(sheet, layer)[0]


def test_the_first_cut_is_one_closed_contour_without_gaps(sheet: Sheet) -> None:
    layer, contour = sheet[0]
    assert layer == CUT
    np.testing.assert_array_equal(contour.end, np.roll(contour.start, -1, axis=0))
    rings = shapely.line_merge(
        shapely.MultiLineString(flattened(np.stack([contour.start, contour.end], 1), contour.bulge))
    )
    assert rings.is_ring


def test_the_contour_encloses_everything_and_does_not_cross_itself(sheet: Sheet) -> None:
    _, contour = sheet[0]
    ring = shapely.line_merge(
        shapely.MultiLineString(flattened(np.stack([contour.start, contour.end], 1), contour.bulge))
    )
    board = shapely.Polygon(ring)
    assert board.is_valid
    everything = flattened(*segments(sheet, CUT, CREASE, V_GROOVE))
    assert all(board.buffer(1e-4).covers(line) for line in everything)


def test_creases_and_grooves_end_on_a_cut_or_on_each_other(sheet: Sheet) -> None:
    ends, bulge = segments(sheet, CREASE, V_GROOVE)
    assert (bulge == 0).all()
    folds = [shapely.LineString(pair) for pair in ends]
    cuts = shapely.union_all(flattened(*segments(sheet, CUT)))
    for number, pair in enumerate(ends):
        others = shapely.union_all(folds[:number] + folds[number + 1 :])
        for point in pair:
            here = shapely.Point(point)
            assert min(cuts.distance(here), others.distance(here)) < 2e-6, point


def test_nothing_is_drawn_twice(sheet: Sheet) -> None:
    lines = flattened(*segments(sheet, CUT, CREASE, V_GROOVE))
    tree = shapely.STRtree(lines)
    for number, line in enumerate(lines):
        for other in tree.query(line):
            if other > number:
                assert line.intersection(lines[other]).length < 1e-6, (line, lines[other])


def test_no_edge_is_shorter_than_a_millimetre_and_a_quarter(sheet: Sheet) -> None:
    ends, bulge = segments(sheet, CUT, CREASE, V_GROOVE)
    assert arc.length(ends[:, 0], ends[:, 1], bulge).min() > 1.25


def test_the_contour_of_every_carton_has_true_arcs(sheet: Sheet) -> None:
    _, contour = sheet[0]
    assert (np.abs(contour.bulge) > 0.05).sum() >= 6


def test_round_corners_are_smooth_where_they_join_a_side() -> None:
    _, contour = corrugated_tray()[0]
    begins, finishes = arc.tangents(contour.start, contour.end, contour.bulge)
    finishes = np.roll(finishes, 1, axis=0)
    turn = np.degrees(
        np.arctan2(
            finishes[:, 0] * begins[:, 1] - finishes[:, 1] * begins[:, 0],
            (finishes * begins).sum(axis=1),
        )
    )
    meets_arc = (contour.bulge != 0) | (np.roll(contour.bulge, 1) != 0)
    assert meets_arc.sum() == 2 * (contour.bulge != 0).sum()
    np.testing.assert_allclose(turn[meets_arc], 0.0, atol=1e-4)


# ── each closes ──────────────────────────────────────────────────────────────────────────────────


def vertical_positions(lines: F64) -> F64:
    """Return the x of all vertical lines, ascending."""
    return np.unique(lines[np.ptp(lines[:, :, 0], axis=1) < 1e-9][:, 0, 0])


def horizontal_positions(lines: F64) -> F64:
    return np.unique(lines[np.ptp(lines[:, :, 1], axis=1) < 1e-9][:, 0, 1])


def test_the_tuck_end_carton_has_four_panels_and_the_last_is_narrower() -> None:
    sheet = tuck_end_carton(90.0, 45.0, 130.0)
    positions = vertical_positions(lines_of(sheet, CREASE))
    edge = outline(sheet).bounds[2]
    np.testing.assert_allclose(np.diff([0.0, *positions, edge]), [15.0, 90.0, 45.0, 90.0, 44.5])


def test_the_tuck_end_cartons_dust_flaps_fold_half_a_millimetre_below_its_lids() -> None:
    lies = horizontal_positions(lines_of(tuck_end_carton(90.0, 45.0, 130.0), CREASE))
    # Lower tuck, lower lid, lower dust flaps, upper dust flaps, upper lid, upper tuck.
    np.testing.assert_allclose(np.diff(lies), [44.5, 0.5, 129.0, 0.5, 44.5])


def test_the_dust_flaps_do_not_meet_and_the_tuck_flaps_do_not_reach_the_other_end() -> None:
    sheet = tuck_end_carton(90.0, 45.0, 130.0)
    board = outline(sheet)
    side = shapely.box(105.0, -1.0, 150.0, 300.0)  # glue flap 15, front 90, side 45
    flaps = shapely.intersection(board, side).bounds
    height = flaps[3] - flaps[1]
    dust = (height - 129.0) / 2.0
    assert dust == pytest.approx(30.5)
    assert dust < 90.0 / 2.0
    assert board.bounds[3] == pytest.approx(44.5 + 16.0 + 130.0 + 44.5 + 16.0)


def test_the_slits_lie_on_the_line_of_the_tuck_crease_and_reach_six_millimetres_in() -> None:
    (_, _), (_, slits), (_, creases) = tuck_end_carton()
    np.testing.assert_allclose(np.hypot(*(slits.end - slits.start).T), 6.0)
    for start, end in zip(slits.start, slits.end, strict=True):
        touching = [
            crease
            for crease in np.stack([creases.start, creases.end], 1)
            if np.isclose(crease, start).all(axis=1).any()
            or np.isclose(crease, end).all(axis=1).any()
        ]
        assert len(touching) == 1
        assert np.ptp(touching[0][:, 1]) == 0.0


def test_the_trays_walls_leave_room_for_each_other() -> None:
    t = 3.0
    positions = vertical_positions(lines_of(corrugated_tray(280.0, 200.0, 80.0, t), CREASE))
    # Inner wall's ridge, outer wall's ridge, base, corner flap; and the same on the right.
    np.testing.assert_allclose(np.diff(positions), [2 * t, 80.0, t, 280.0 + 3 * t, t, 80.0, 2 * t])
    np.testing.assert_allclose(
        np.diff(horizontal_positions(lines_of(corrugated_tray(), CREASE))), [200.0 + t]
    )


def test_the_trays_tabs_fit_their_slots() -> None:
    sheet = corrugated_tray(280.0, 200.0, 80.0, 3.0)
    slots = [
        shapely.Polygon(paths.start).bounds
        for layer, paths in sheet[1:]
        if layer == CUT and (paths.bulge == 0).all()
    ]
    assert len(slots) == 4
    for low_x, low_y, high_x, high_y in slots:
        assert high_x - low_x == pytest.approx(3.5)  # caliper and half a millimetre
        assert high_y - low_y == pytest.approx(38.0)  # tab of 36 and a millimetre on either side
    positions = vertical_positions(lines_of(sheet, CREASE))
    inside = max(slots)[0] - min(slots)[2]
    assert inside == pytest.approx(280.0 - 0.5)  # the inner walls are 280 mm apart
    # Folded in, the inner wall reaches from its ridge to the base's top face, and its tab through.
    free = outline(sheet).bounds[2] - positions[-1]
    assert free == pytest.approx(80.0 - 1.5 - 0.5 + 3.5)


def test_the_trays_hand_holes_lie_on_each_other_when_it_is_rolled_over() -> None:
    sheet = corrugated_tray()
    positions = vertical_positions(lines_of(sheet, CREASE))
    ridge, fold = positions[-2], positions[-1]
    holes = [
        shapely.MultiPoint(paths.start).centroid
        for _, paths in sheet[1:]
        if (paths.bulge == 1.0).sum() == 2
    ]
    right = sorted(hole.x for hole in holes if hole.x > 315.0)
    assert len(holes) == 4
    assert ridge - right[0] == pytest.approx(right[1] - fold)
    assert {round(hole.y, 6) for hole in holes} == {183.0}


def test_the_rigid_boxs_grooves_form_its_base() -> None:
    sheet = rigid_box_blank(220.0, 150.0, 50.0, 2.0)
    grooves = lines_of(sheet, V_GROOVE)
    base = shapely.polygonize([shapely.LineString(pair) for pair in grooves]).geoms[0]
    assert base.bounds == pytest.approx((50.0, 50.0, 270.0, 200.0))
    assert len(grooves) == 4


def test_the_rigid_boxs_short_walls_stand_between_the_long_ones() -> None:
    board = outline(rigid_box_blank(220.0, 150.0, 50.0, 2.0))
    # A cut across the short wall, 10 mm above the groove; and across the long one.
    short = board.intersection(shapely.LineString([(40.0, 0.0), (40.0, 300.0)]))
    long = board.intersection(shapely.LineString([(0.0, 40.0), (400.0, 40.0)]))
    assert short.length == pytest.approx(150.0 - 2 * 2.2)
    assert long.length == pytest.approx(220.0)


def test_the_rigid_boxs_corners_are_mitred_to_the_end_of_the_groove() -> None:
    _, contour = rigid_box_blank(220.0, 150.0, 50.0, 2.0)[0]
    ends = np.stack([contour.start, contour.end], axis=1)
    for corner in ((50.0, 50.0), (270.0, 50.0), (270.0, 200.0), (50.0, 200.0)):
        meeting = ends[(np.hypot(*(ends - corner).T) < 1e-9).any(axis=0)]
        steps = np.abs(np.diff(meeting, axis=1)[:, 0])
        assert sorted(steps.tolist()) == [pytest.approx([0.0, 50.0]), pytest.approx([2.2, 2.2])]


# ── as files ─────────────────────────────────────────────────────────────────────────────────────


def test_the_samples_are_the_same_bytes_on_every_call() -> None:
    assert samples() == samples()


@pytest.mark.parametrize(
    ("name", "counts", "size"),
    [
        ("tuck-end-carton.dxf", {"cut": 60, "crease": 12}, (284.5, 251.0)),
        ("corrugated-tray.dxf", {"cut": 104, "crease": 12}, (630.0, 366.0)),
        ("rigid-box-blank.dxf", {"cut": 24, "v-groove": 4}, (320.0, 250.0)),
    ],
)
def test_a_sample_reads_back_classified_without_a_question(
    name: str, counts: dict[str, int], size: tuple[float, float]
) -> None:
    drawing = read(samples()[name])
    dieline = classify(drawing, load.profile("default"))
    assert drawing.unit == "mm"
    assert list_questions(drawing, dieline) == []
    kinds, found = np.unique(dieline.line_type, return_counts=True)
    assert dict(zip([LineType(kind).word for kind in kinds], found, strict=True)) == counts
    np.testing.assert_allclose(drawing.bounds, [0.0, 0.0, *size], atol=1e-6)
    assert size[0] <= 700.0
    assert size[1] <= 500.0
    assert (np.abs(drawing.bulge) <= 1.0).all()
