"""Faults of folded boxes with known measures."""

from __future__ import annotations

import numpy as np
import pytest

from knifetip.folding.findings import find_faults
from knifetip.folding.records import FoldTree
from tests.support.shapes import BOARD, closed, dieline, edges
from tests.unit.folding.blanks import CREASE, CUT, GROOVE, cross, folded

A = 60.0


def codes(tree: FoldTree) -> list[str]:
    return [fault.message.code.removeprefix("folding.") for fault in find_faults(tree)]


@pytest.mark.parametrize("line_type", [CREASE, GROOVE])
@pytest.mark.parametrize("side_up", ["inside", "outside"])
def test_a_cube_has_no_faults(line_type: object, side_up: str) -> None:
    assert codes(folded(*cross(A, line_type), side_up=side_up)) == []  # type: ignore[arg-type]


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
