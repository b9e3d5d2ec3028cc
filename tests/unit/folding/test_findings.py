"""Faults of folded boxes with known measures."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import shapely

from knifetip.folding.findings import find_faults
from knifetip.folding.motion import panel_transforms
from knifetip.folding.records import FoldTree
from knifetip.geometry.columns import F64
from knifetip.model.dieline import LineType
from tests.support.shapes import BOARD, closed, dieline, edges
from tests.unit.folding.blanks import CREASE, CUT, GROOVE, cross, folded

A = 60.0


def codes(tree: FoldTree) -> list[str]:
    return [fault.message.code.removeprefix("folding.") for fault in find_faults(tree)]


@pytest.mark.parametrize("line_type", [CREASE, GROOVE])
@pytest.mark.parametrize("side_up", ["inside", "outside"])
def test_a_cube_has_no_faults(line_type: LineType, side_up: str) -> None:
    assert codes(folded(*cross(A, line_type), side_up=side_up)) == []


@pytest.mark.parametrize(("opening", "found"), [(90.0, []), (89.0, ["groove-narrow"] * 5)])
def test_a_groove_closes_up_to_its_opening(opening: float, found: list[str]) -> None:
    assert codes(folded(*cross(A, GROOVE), opening=opening)) == found


def test_a_groove_of_60_degrees_that_folds_by_90_is_found_with_its_measure() -> None:
    faults = find_faults(folded(*cross(A, GROOVE), opening=60.0))
    assert {fault.message.code for fault in faults} == {"folding.groove-narrow"}
    assert {fault.measure for fault in faults} == {30.0}
    assert sorted(fault.fold for fault in faults) == [0, 1, 2, 3, 4]


def tray(flap: float, wall: float = 40.0) -> FoldTree:
    """Fold a tray of 100 × A with two walls; one wall has a flap that folds over the tray."""
    outline = closed((0.0, -wall), (100.0, -wall), (100.0, A + wall + flap), (0.0, A + wall + flap))
    lines = [0.0, A, A + wall]
    folds = edges(*(((0.0, y), (100.0, y)) for y in lines))
    return folded((CUT, outline), (CREASE, folds))


@pytest.mark.parametrize(("flap", "beyond"), [(50.0, None), (61.0, None), (67.0, 7.0)])
def test_a_flap_that_reaches_beyond_the_opposite_wall_is_too_long(
    flap: float, beyond: float | None
) -> None:
    faults = find_faults(tray(flap))
    if beyond is None:
        assert faults == []
        return
    (fault,) = faults
    assert fault.message.code == "folding.flap-too-long"
    assert fault.measure == pytest.approx(beyond, abs=1e-3)
    x, y = fault.place
    assert 0.0 < x < 100.0
    assert y == pytest.approx(A + 40.0 + A, abs=1.0 + BOARD.caliper)


def test_a_flap_through_the_opposite_wall_is_too_long() -> None:
    # The wall at y = 0 is higher by 20 mm than the flap, which passes through it.
    outline = closed((0.0, -60.0), (100.0, -60.0), (100.0, A + 112.0), (0.0, A + 112.0))
    folds = edges(*(((0.0, y), (100.0, y)) for y in (0.0, A, A + 40.0)))
    (fault,) = find_faults(folded((CUT, outline), (CREASE, folds)))
    assert fault.message.code == "folding.flap-too-long"
    assert fault.measure == pytest.approx(12.0, abs=1e-3)


def test_walls_that_fold_through_each_other_collide() -> None:
    # Both walls have a further panel, so that none is a flap; they lean inwards.
    outline = closed((0.0, -80.0), (100.0, -80.0), (100.0, A + 80.0), (0.0, A + 80.0))
    folds = edges(*(((0.0, y), (100.0, y)) for y in (-60.0, 0.0, A, A + 60.0)))
    tree = folded((CUT, outline), (CREASE, folds))
    bottom = tree.roots[0]
    angles = {k: 135.0 if tree.folds[k].parent == bottom else 0.0 for k in range(len(tree.folds))}
    assert codes(tree) == []
    assert "collision" in codes(folded((CUT, outline), (CREASE, folds), angles=angles))


@pytest.mark.parametrize(("flap", "overlap"), [(50.0, None), (52.0, 4.0)])
def test_flaps_that_face_each_other_may_meet(flap: float, overlap: float | None) -> None:
    high = 40.0 + flap
    outline = closed((0.0, -high), (120.0, -high), (120.0, 100.0 + high), (0.0, 100.0 + high))
    folds = edges(*(((0.0, y), (120.0, y)) for y in (-40.0, 0.0, 100.0, 140.0)))
    faults = find_faults(folded((CUT, outline), (CREASE, folds)))
    if overlap is None:
        assert faults == []
        return
    (fault,) = faults
    assert fault.message.code == "folding.flaps-overlap"
    assert fault.measure == pytest.approx(overlap)


def test_a_bent_fold_stays_flat_and_is_found() -> None:
    square = closed((0.0, 0.0), (100.0, 0.0), (100.0, 80.0), (0.0, 80.0))
    bent = edges(((50.0, 0.0), (60.0, 40.0)), ((60.0, 40.0), (50.0, 80.0)))
    tree = folded((CUT, square), (CREASE, bent))
    assert codes(tree) == ["not-straight"]
    assert tree.folds[0].angle == 0.0


def test_a_curved_fold_is_not_straight() -> None:
    from knifetip.folding.fold import fold_tree
    from knifetip.folding.records import FoldOptions
    from knifetip.pipeline import clean

    square = closed((0.0, 0.0), (100.0, 0.0), (100.0, 80.0), (0.0, 80.0))
    arc = edges(((50.0, 0.0), (50.0, 80.0)))
    drawn = dieline((CUT, square), (CREASE, arc), bulge={4: 0.2})
    tree = fold_tree(clean(drawn).dieline, BOARD, FoldOptions())
    assert (len(tree.panels), codes(tree)) == (2, ["not-straight"])


def gusset(angles: dict[int, float] | None = None) -> FoldTree:
    """Fold a corner with four panels around one point: a cycle of four folds."""
    square = closed((-50.0, -50.0), (50.0, -50.0), (50.0, 50.0), (-50.0, 50.0))
    folds = edges(((0.0, -50.0), (0.0, 0.0)), ((0.0, 0.0), (0.0, 50.0)), ((-50.0, 0.0), (0.0, 0.0)),
                  ((0.0, 0.0), (50.0, 0.0)))  # fmt: skip
    return folded((CUT, square), (CREASE, folds), angles=angles)


def test_folds_around_a_point_close_only_if_their_angles_agree() -> None:
    tree = gusset()
    assert [fold.closes for fold in tree.folds].count(True) == 1
    assert len(tree.order) == 3
    gaps = [fault for fault in find_faults(tree) if fault.message.code == "folding.gap"]
    assert len(gaps) == 1
    assert gaps[0].measure > 30.0
    # Flat, all meet.
    assert codes(gusset(dict.fromkeys(range(4), 0.0))) == []


@pytest.mark.parametrize(("slot", "found"), [(True, []), (False, ["flap-too-long"])])
def test_a_tongue_may_reach_through_a_slot(slot: bool, found: list[str]) -> None:
    # The tongue leans down over the tray and meets the wall at y = 0 at a height of 25 mm.
    outline = closed(
        (0.0, -40.0), (100.0, -40.0), (100.0, A + 50.0), (70.0, A + 50.0), (70.0, A + 130.0),
        (30.0, A + 130.0), (30.0, A + 50.0), (0.0, A + 50.0),
    )  # fmt: skip
    folds = edges(
        ((0.0, 0.0), (100.0, 0.0)), ((0.0, A), (100.0, A)), ((30.0, 110.0), (70.0, 110.0))
    )
    rows = [(CUT, outline), (CREASE, folds)]
    if slot:
        rows.append((CUT, edges(((29.0, -25.0), (71.0, -25.0)))))
    flat = folded(*rows)
    (number,) = [
        k for k, fold in enumerate(flat.folds) if fold.axis[0, 1] == pytest.approx(A + 50.0)
    ]
    lean = float(np.degrees(np.arctan2(25.0, A)))
    assert codes(folded(*rows, angles={number: 90.0 + lean})) == found


def test_each_number_of_findings_is_limited() -> None:
    cubes = [
        (kind, ends + np.array((400.0 * k, 0.0)))
        for k in range(25)
        for kind, ends in cross(A, GROOVE)
    ]
    assert len(codes(folded(*cubes, opening=45.0))) == 100


def slab(tree: FoldTree, panel: int) -> F64:
    """Return the corners of a folded panel as a board with thickness, (k, 3)."""
    corners = shapely.get_coordinates(tree.panels[panel].polygon.exterior)
    placed = panel_transforms(tree, np.ones(1))[0, panel]
    faces = [np.column_stack([corners, np.full(len(corners), z)]) for z in (0.0, tree.caliper)]
    points: F64 = np.concatenate(faces) @ placed[:3, :3].T + placed[:3, 3]
    return points


def least_shift(one: F64, other: F64) -> float:
    """Return the shortest shift that separates two convex solids, of many directions (mm)."""
    turns = np.radians(np.arange(0.0, 360.0, 0.25))
    # The walls of these tests are prisms along X.
    directions = np.column_stack([np.zeros(len(turns)), np.cos(turns), np.sin(turns)])
    directions = np.concatenate([directions, np.eye(3), -np.eye(3)])
    return float(((one @ directions.T).max(0) - (other @ directions.T).min(0)).min())


@pytest.mark.parametrize("caliper", [2.0, 4.0])
@pytest.mark.parametrize("share", [0.4, 0.6, 0.9])
def test_a_flap_whose_board_lies_too_deep_in_a_wall_collides(caliper: float, share: float) -> None:
    # The wall at y = 0 goes on in a flat panel, and is higher than the flap, whose end lies in it.
    top = 2.0 * A + 40.0 + share * caliper
    outline = closed((0.0, -80.0), (100.0, -80.0), (100.0, top), (0.0, top))
    folds = edges(*(((0.0, y), (100.0, y)) for y in (-60.0, 0.0, A, A + 40.0)))
    rows = ((CUT, outline), (CREASE, folds))
    board = replace(BOARD, caliper=caliper)
    flat = [f.axis[0, 1] < -30.0 for f in folded(*rows, board=board).folds].index(True)
    tree = folded(*rows, board=board, angles={flat: 0.0})
    faults = find_faults(tree)
    if share < 0.5:
        assert faults == []
        return
    (fault,) = faults
    assert fault.message.code == "folding.solids-collide"
    assert fault.message.arguments["caliper"] == caliper
    # Half of the board lies before the middle of the wall.
    assert fault.measure == pytest.approx((0.5 + share) * caliper)
    assert fault.measure == pytest.approx(least_shift(*(slab(tree, k) for k in fault.panels)))


@pytest.mark.parametrize(("angle", "collide"), [(90.0, False), (90.5, False), (91.5, True)])
def test_walls_that_cross_at_an_acute_angle_collide(angle: float, collide: bool) -> None:
    # The bottom is 4 mm wide; the walls of 200 mm lean inwards and cross.
    outline = closed((0.0, -200.0), (100.0, -200.0), (100.0, 204.0), (0.0, 204.0))
    folds = edges(((0.0, 0.0), (100.0, 0.0)), ((0.0, 4.0), (100.0, 4.0)))
    tree = folded((CUT, outline), (CREASE, folds), angles={0: angle, 1: angle})
    faults = find_faults(tree)
    assert [one.message.code for one in faults] == ["folding.solids-collide"] * collide
    if collide:
        solids = [slab(tree, panel) for panel in faults[0].panels]
        assert faults[0].measure == pytest.approx(least_shift(*solids), abs=0.05)


@pytest.mark.parametrize("caliper", [0.5, 3.0])
def test_flaps_on_one_crease_line_lie_on_each_other(caliper: float) -> None:
    # Both walls have a flap that lies over the bottom; the boards of the flaps share one place.
    outline = closed((0.0, -70.0), (100.0, -70.0), (100.0, A + 70.0), (0.0, A + 70.0))
    folds = edges(*(((0.0, y), (100.0, y)) for y in (-40.0, 0.0, A, A + 40.0)))
    assert (
        codes(folded((CUT, outline), (CREASE, folds), board=replace(BOARD, caliper=caliper))) == []
    )
