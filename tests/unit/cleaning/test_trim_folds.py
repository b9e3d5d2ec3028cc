"""Folds that cross the outline of a panel or a window, and what cleaning drops of them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from knifetip.cleaning.clean import clean
from knifetip.geometry.columns import F64
from knifetip.messages import render
from knifetip.model.cleaned import Cleaned, CleaningReason
from knifetip.model.dieline import Dieline, LineType
from knifetip.verification.checks.cleaning.check import check_cleaning
from tests.support.shapes import closed, dieline, edges

CUT, GROOVE, CREASE = LineType.CUT, LineType.V_GROOVE, LineType.CREASE

PANEL = closed((0, 0), (100, 0), (100, 80), (0, 80))
WINDOW = closed((40, 30), (60, 30), (60, 50), (40, 50))


def grooved(*lines: tuple[tuple[float, float], tuple[float, float]]) -> Dieline:
    """Return a dieline of a panel with a window, eight cuts, and of grooves."""
    return dieline((CUT, PANEL), (CUT, WINDOW), (GROOVE, edges(*lines)))


def grooves_of(made: Cleaned) -> list[list[list[float]]]:
    """Return the ends of the grooves that remain, rounded to 1e-6 mm."""
    rows = made.dieline.line_type == GROOVE
    ends: list[list[list[float]]] = (np.round(made.dieline.ends[rows], 6) + 0.0).tolist()
    return ends


def test_a_groove_past_the_outline_ends_on_it() -> None:
    drawn = grooved(((20, -5), (20, 90)))
    made = clean(drawn)
    assert grooves_of(made) == [[[20, 0], [20, 80]]]
    assert made.dropped[8] == pytest.approx(15.0)
    assert made.kept[8] == pytest.approx(80.0)
    assert made.reason[8] == CleaningReason.OFF_PANEL
    assert render(made.describe(8)) == (
        "the edge was kept, with these changes: a part of the fold, 15 mm long, was dropped "
        "because it lies outside all panels"
    )
    assert check_cleaning(drawn, made) == []


@pytest.mark.parametrize(
    ("cut", "ends"),
    [
        # It begins 0.001 mm beside the groove and would meet it 0.08 mm or 0.01 mm farther on.
        (((20.001, 80.2), (20.3, 99.5)), [[20, 0], [20, 84]]),
        (((20.001, 80.2), (21.3, 88.0)), [[20, 0], [20, 84]]),
        # It crosses the groove at 0.6°.
        (((19.99, 80.1), (20.07, 87.9)), [[20, 0], [20, 84]]),
        # It begins where the groove leaves the panel.
        (((20.001, 80.04), (20.3, 99.5)), [[20, 0], [20, 80]]),
    ],
)
def test_a_piece_that_a_cut_touches_without_dividing_it_stays(
    cut: tuple[tuple[float, float], tuple[float, float]], ends: list[list[float]]
) -> None:
    # The cut is the left side of a second panel, with a gap between it and the first panel.
    sides = edges(cut, (cut[1], (60, 99)), ((60, 99), (60, 80)))
    drawn = dieline((CUT, PANEL), (CUT, sides), (GROOVE, edges(((20, 0), (20, 84)))))
    made = clean(drawn)
    assert grooves_of(made) == [ends]
    assert check_cleaning(drawn, made) == []


def test_a_groove_through_a_window_becomes_two() -> None:
    drawn = grooved(((0, 40), (100, 40)))
    made = clean(drawn)
    assert grooves_of(made) == [[[0, 40], [40, 40]], [[60, 40], [100, 40]]]
    assert made.dropped[8] == pytest.approx(20.0)
    assert check_cleaning(drawn, made) == []


def test_a_groove_through_corners_of_a_window_is_divided_there() -> None:
    # The diagonal passes exactly through two corners of the window.
    drawn = grooved(((10, 0), (90, 80)))
    assert grooves_of(clean(drawn)) == [[[10, 0], [40, 30]], [[60, 50], [90, 80]]]


def test_a_window_with_round_sides_is_not_its_chords() -> None:
    # A circle of radius 10 about (50, 40), from two arcs with the chord on x = 50.
    circle = edges(((50, 30), (50, 50)), ((50, 50), (50, 30)))
    drawn = dieline((CUT, PANEL), (CUT, circle), (GROOVE, edges(((0, 46), (100, 46)))))
    drawn = replace(drawn, bulge=np.array([0.0] * 4 + [1.0, 1.0, 0.0]))
    made = clean(drawn)
    assert grooves_of(made) == [[[0, 46], [42, 46]], [[58, 46], [100, 46]]]
    assert check_cleaning(drawn, made) == []


def test_a_stub_drawn_as_an_edge_of_its_own_is_dropped() -> None:
    drawn = grooved(((20, 0), (20, 80)), ((20, 80), (20, 85)))
    made = clean(drawn)
    assert grooves_of(made) == [[[20, 0], [20, 80]]]
    assert made.reason[9] == CleaningReason.OFF_PANEL
    assert render(made.describe(9)) == (
        "the edge was dropped, because it belongs to a fold and lies outside all panels"
    )
    assert check_cleaning(drawn, made) == []


@pytest.mark.parametrize(
    "line",
    [
        ((20, -0.0015), (20, 80.0019)),  # within the tolerance of a joint
        ((20, 0.049), (20, 79.98)),
        ((20, 0), (20, 80)),
        ((0, 30), (40, 30)),  # ends at a corner of the window
        ((110, 0), (110, 80)),  # no part on a panel
        ((42, 35), (58, 35)),
    ],
)
def test_a_groove_without_a_part_outside_its_panel_is_not_changed(
    line: tuple[tuple[float, float], tuple[float, float]],
) -> None:
    drawn = grooved(line)
    made = clean(drawn)
    np.testing.assert_array_equal(made.dieline.ends, drawn.ends)
    assert not made.changed.any()


def test_a_slit_across_a_groove_does_not_divide_it() -> None:
    drawn = dieline(
        (CUT, PANEL), (CUT, edges(((20, 40), (30, 40)))), (GROOVE, edges(((25, 0), (25, 80))))
    )
    assert not clean(drawn).changed.any()


OVER = [0.003, 0.01, 0.05, 0.3, 3.0, 19.5]


@pytest.mark.parametrize("over", OVER)
@pytest.mark.parametrize("kind", [CREASE, GROOVE, LineType.COMBI])
@pytest.mark.parametrize("backwards", [False, True])
def test_a_fold_over_the_outline_ends_on_it(over: float, kind: LineType, backwards: bool) -> None:
    line = edges(((20, -over), (30, 80 + over)))
    drawn = dieline((CUT, PANEL), (kind, line[:, ::-1] if backwards else line))
    made = clean(drawn)
    at = np.sort(made.dieline.ends[4], axis=0)
    np.testing.assert_allclose(at[:, 1], [0, 80], atol=1e-9)
    slope = np.hypot(80 + 2 * over, 10) / (80 + 2 * over)
    assert made.dropped[4] == pytest.approx(2 * over * slope)
    assert check_cleaning(drawn, made) == []


@pytest.mark.parametrize(
    "line",
    [
        ((20, -20.1), (20, 80)),
        ((20, -11), (20, 10)),
        ((105, 10), (115, 10)),
        ((10, 0.1), (90, -0.1)),
        ((20, -150), (20, 230)),
        ((45, 35), (55, 45)),
    ],
    ids=["long", "mostly outside", "outside", "along it", "longer both ways", "in the window"],
)
def test_other_folds_stay_as_they_are_drawn(
    line: tuple[tuple[float, float], tuple[float, float]],
) -> None:
    drawn = dieline((CUT, PANEL), (CUT, WINDOW), (CREASE, edges(line)))
    assert not clean(drawn).changed.any()


def test_overshoots_at_both_ends_are_together_shorter_than_the_rest() -> None:
    strip = closed((0, 0), (100, 0), (100, 20), (0, 20))
    for over, trimmed in ((9.9, True), (10.1, False)):
        drawn = dieline((CUT, strip), (CREASE, edges(((20, -over), (20, 20 + over)))))
        made = clean(drawn)
        assert made.changed.any() == trimmed
        assert check_cleaning(drawn, made) == []


def test_a_curved_fold_ends_on_the_outline() -> None:
    # A semicircle of radius 20 about (50, -1) begins and ends 1 mm below the panel.
    drawn = dieline((CUT, PANEL), (CREASE, edges(((70, -1), (30, -1)))))
    made = clean(replace(drawn, bulge=np.array([0.0] * 4 + [1.0])))
    reach = np.sqrt(20.0**2 - 1.0)
    np.testing.assert_allclose(
        made.dieline.ends[4:], edges(((50 + reach, 0), (50 - reach, 0))), atol=1e-9
    )


def test_a_fold_that_leaves_through_a_corner_ends_there() -> None:
    drawn = dieline((CUT, PANEL), (CREASE, edges(((-0.3, -0.3), (50, 50)))))
    np.testing.assert_allclose(clean(drawn).dieline.ends[4:], edges(((0, 0), (50, 50))), atol=1e-9)


def test_an_overshoot_that_was_drawn_twice_is_dropped_twice() -> None:
    drawn = dieline((CUT, PANEL), (CREASE, edges(((20, 0), (20, 85)), ((20, 40), (20, 90)))))
    made = clean(drawn)
    assert made.dieline.ends[4].tolist() == [[20, 0], [20, 80]]
    np.testing.assert_allclose(made.dropped[4:], [5, 10])
    assert check_cleaning(drawn, made) == []


def test_an_overshoot_that_another_edge_touches_stays() -> None:
    drawn = dieline((CUT, PANEL), (CREASE, edges(((20, 0), (20, 85)), ((20, 85), (40, 95)))))
    assert not clean(drawn).changed.any()


def test_an_overshoot_of_20_mm_is_dropped() -> None:
    drawn = dieline((CUT, PANEL), (CREASE, edges(((20, -20), (20, 80)))))
    assert clean(drawn).dropped[4] == pytest.approx(20.0)


def test_one_line_of_two_contours_divides_folds() -> None:
    # Two squares touch at (40, 40), and their sides continue each other there.
    sides = edges(((0, 40), (80, 40)), ((40, 0), (40, 80)), ((0, 40), (0, 0)), ((0, 0), (40, 0)),
                  ((80, 40), (80, 80)), ((80, 80), (40, 80)))  # fmt: skip
    drawn = dieline((CUT, sides), (CREASE, edges(((20, 0), (20, 43)))))
    made = clean(drawn)
    assert made.dieline.ends[6].tolist() == [[20, 0], [20, 40]]
    assert check_cleaning(drawn, made) == []


def test_an_outline_with_a_small_gap_is_closed() -> None:
    gapped = PANEL.copy()
    gapped[3, 1, 1] = 1.0
    drawn = dieline((CUT, gapped), (CREASE, edges(((20, 0), (20, 83)))))
    made = clean(drawn)
    assert made.dieline.ends[4].tolist() == [[20, 0], [20, 80]]
    assert check_cleaning(drawn, made) == []


OPEN = PANEL.copy()
OPEN[3, 1, 1] = 30.0


@pytest.mark.parametrize(
    ("contours", "line"),
    [
        # The outline has a gap of 30 mm, so the window looks like an outline.
        ((OPEN, WINDOW), ((30, 40), (70, 40))),
        ((OPEN, WINDOW), ((0, 40), (100, 40))),
        # In an open outline, a part in a window looks like a hole in a panel.
        ((OPEN, closed((10, 10), (90, 10), (90, 70), (10, 70)), WINDOW), ((35, 40), (65, 40))),
        # The strip between two slits is closed by its ends only.
        ((PANEL, edges(((20, 30), (80, 30)), ((20, 31.5), (80, 31.5)))), ((50, 0), (50, 80))),
        # A frame around the blank makes the blank look like its hole.
        ((closed((-50, -50), (200, -50), (200, 200), (-50, 200)), PANEL), ((20, -5), (20, 85))),
        (
            (closed((-50, -50), (200, -50), (200, 200), (-50, 200)), PANEL, WINDOW),
            ((0, 40), (100, 40)),
        ),
    ],
    ids=["open", "open across", "part in a window", "strip", "frame", "frame and window"],
)
def test_a_fold_of_an_open_or_doubtful_panel_is_never_dropped(
    contours: tuple[F64, ...], line: tuple[tuple[float, float], tuple[float, float]]
) -> None:
    drawn = dieline(*((CUT, contour) for contour in contours), (CREASE, edges(line)))
    assert not clean(drawn).changed.any()


def test_a_second_fold_outside_shows_that_a_panel_is_there() -> None:
    # Without an outline only the window is closed; the board is cut to size.
    folds = edges(((25, 40), (75, 40)), ((10, 10), (90, 60)), ((10, 60), (90, 70)))
    drawn = dieline((CUT, WINDOW), (CREASE, folds))
    assert not clean(drawn).changed.any()


def test_cuts_that_overshoot_a_corner_are_no_open_outline() -> None:
    sides = edges(((-0.4, 0), (100.4, 0)), ((100, -0.4), (100, 80.4)),
                  ((100.4, 80), (-0.4, 80)), ((0, 80.4), (0, -0.4)))  # fmt: skip
    drawn = dieline((CUT, sides), (CREASE, edges(((20, 0), (20, 83)))))
    made = clean(drawn)
    assert made.dieline.ends[4].tolist() == [[20, 0], [20, 80]]
    assert check_cleaning(drawn, made) == []


def test_a_fold_across_a_notch_is_interrupted_there() -> None:
    notched = closed((0, 0), (40, 0), (40, 30), (48, 30), (48, 0), (100, 0), (100, 80), (0, 80))
    drawn = dieline((CUT, notched), (CREASE, edges(((0, 20), (100, 20)))))
    made = clean(drawn)
    creases = made.dieline.ends[made.dieline.line_type == CREASE]
    assert creases.tolist() == [[[0, 20], [40, 20]], [[48, 20], [100, 20]]]
    assert check_cleaning(drawn, made) == []


def test_a_part_in_a_window_is_a_panel() -> None:
    part = closed((45, 35), (55, 35), (55, 45), (45, 45))
    drawn = dieline((CUT, PANEL), (CUT, WINDOW), (CUT, part), (GROOVE, edges(((0, 40), (100, 40)))))
    made = clean(drawn)
    assert grooves_of(made) == [[[0, 40], [40, 40]], [[45, 40], [55, 40]], [[60, 40], [100, 40]]]
    assert check_cleaning(drawn, made) == []


def test_an_overshoot_beside_a_cut_at_a_small_angle_is_dropped() -> None:
    # The cut that begins at the end of the fold leaves it by only 1.1°, as in a narrow slot.
    outline = closed((0, 0), (49, -50), (50, 0), (51, 0), (51, -50), (100, 0), (100, 80), (0, 80))
    drawn = dieline((CUT, outline), (CREASE, edges(((50, 80), (50, -0.25)))))
    made = clean(drawn)
    assert made.dropped[8] == pytest.approx(0.25)
    assert check_cleaning(drawn, made) == []


def test_a_fold_that_only_a_dropped_piece_touches_has_a_free_end() -> None:
    """Two rings are around each end of an upright fold, and the other fold is dropped in a ring."""
    centres = [(0, 0), (50, 0), (100, 0), (50, 100)]
    rings = edges(
        *(
            ((x - way * radius, y), (x + way * radius, y))
            for x, y in centres
            for radius in (0.75, 1.0)
            for way in (1.0, -1.0)
        )
    )
    folds = edges(((0, 0), (100, 0)), ((50, 0), (50, 100)))
    drawn = dieline((CUT, rings), (CREASE, folds), bulge=dict.fromkeys(range(len(rings)), 1.0))
    made = clean(drawn)
    assert check_cleaning(drawn, made) == []
    assert made.dropped[-1] == 0.0
