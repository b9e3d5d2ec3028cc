"""Errors of cleaning, made on purpose, and the findings about them."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from knifetip.checked_cleaning import clean_checked
from knifetip.cleaning import trim_folds
from knifetip.cleaning.clean import clean
from knifetip.geometry.columns import F64
from knifetip.model.cleaned import Cleaned, Stretches
from knifetip.model.dieline import Dieline, LineType
from knifetip.verification.checks.cleaning.check import check_cleaning
from tests.support.shapes import closed, dieline, edges

CUT, CREASE = LineType.CUT, LineType.CREASE

#: A square with a side drawn twice and one in two pieces, a crease that a cut lies on, a gap.
LINE = dieline(
    (CUT, edges(((0, 0), (100, 0)), ((100, 0), (100, 100)), ((100, 100), (0, 100)))),
    (CUT, edges(((0, 100), (0, 40)), ((0, 40), (0, 0.03)), ((100, 0), (0, 0)))),
    (CREASE, edges(((50, 20), (50, 80)))),
    (CUT, edges(((50, 40), (50, 60)), ((20, 20), (20.02, 20)))),
)


def with_changes(made: Cleaned, **changes: Any) -> Cleaned:
    return replace(made, dieline=replace(made.dieline, **changes))


def findings_text(made: Cleaned, line: Dieline = LINE) -> str:
    return " ".join(finding.text for finding in check_cleaning(line, made))


def test_a_correct_cleaning_is_accepted() -> None:
    made = clean(LINE)
    assert np.flatnonzero(made.changed).tolist() == [3, 4, 5, 6, 8]
    assert check_cleaning(LINE, made) == []


def test_an_edge_moved_by_two_hundredths_is_found_with_its_measure() -> None:
    made = clean(LINE)
    ends = made.dieline.ends.copy()
    ends[1] += (0.02, 0.0)
    findings = check_cleaning(LINE, with_changes(made, ends=ends))
    assert [finding.edge for finding in findings] == [1]
    assert findings[0].measure == pytest.approx(0.02)


def test_a_line_that_became_an_arc_is_found() -> None:
    made = clean(LINE)
    bulge = made.dieline.bulge.copy()
    bulge[1] = 0.001
    assert "the edge was moved by 0.0500 mm" in findings_text(with_changes(made, bulge=bulge))


def test_an_edge_that_is_ignored_is_found() -> None:
    made = clean(LINE)
    kinds = made.dieline.line_type.copy()
    kinds[2] = LineType.IGNORED
    assert (
        "Edge 2: Internal error in cleaning: the edge has the "
        "line type cut before cleaning and ignored after it"
        in findings_text(with_changes(made, line_type=kinds))
    )


def test_a_cut_that_became_a_crease_is_found() -> None:
    made = clean(LINE)
    kinds = made.dieline.line_type.copy()
    kinds[1] = CREASE
    assert (
        "Edge 1: Internal error in cleaning: the edge has the "
        "line type cut before cleaning and crease after it"
        in findings_text(with_changes(made, line_type=kinds))
    )


def test_an_edge_that_was_not_drawn_is_found() -> None:
    made = clean(LINE)
    line = made.dieline
    more = replace(
        line,
        ends=np.concatenate([line.ends, [[[10, 10], [30, 10]]]]),
        bulge=np.append(line.bulge, 0.0),
        line_type=np.append(line.line_type, CUT),
        source=np.append(line.source, 3),
        rule=np.append(line.rule, 0),
        confidence=np.append(line.confidence, 1.0),
        face=np.append(line.face, [[-1, -1]], axis=0),
        part=np.append(line.part, -1),
        fit_error=np.append(line.fit_error, 0.0),
    )
    assert (
        findings_text(replace(made, dieline=more))
        == "Edge 3: Internal error in cleaning: the cleaned edge "
        "corresponds to no edge of the drawing."
    )


def test_a_lengthened_edge_is_found() -> None:
    made = clean(LINE)
    ends = made.dieline.ends.copy()
    ends[1, 1] = (100, 103)
    assert (
        "Edge 1: Internal error in cleaning: the cleaned edge extends beyond all edges"
        in findings_text(with_changes(made, ends=ends))
    )


def test_a_shortened_edge_is_found() -> None:
    made = clean(LINE)
    ends = made.dieline.ends.copy()
    ends[1, 1] = (100, 99.9)
    assert "Edge 1: Internal error in cleaning: the edge was moved by 0.1000 mm" in findings_text(
        with_changes(made, ends=ends)
    )


def test_a_stretch_without_a_record_is_found() -> None:
    made = clean(LINE)
    parts = made.stretches
    keep = np.arange(len(parts)) != np.flatnonzero(parts.row == 6)[-1]
    short = Stretches(
        parts.row[keep],
        parts.begin[keep],
        parts.end[keep],
        parts.cleaned[keep],
        parts.by_other_edge[keep],
    )
    assert (
        "Edge 6: Internal error in cleaning: the lengths of the kept, merged and dropped parts"
        in findings_text(replace(made, stretches=short))
    )


def test_an_edge_that_was_dropped_is_found() -> None:
    made = clean(LINE)
    parts = made.stretches
    kinds = made.dieline.line_type.copy()
    kinds[1] = LineType.IGNORED
    gone = replace(parts, cleaned=np.where(parts.row == 1, -1, parts.cleaned))
    lost = replace(with_changes(made, line_type=kinds), stretches=gone)
    assert "Edge 1: Internal error in cleaning: 100.000 mm of the edge were lost" in findings_text(
        lost
    )


def circle_of_chords() -> Dieline:
    """Return 360 chords of a circle with radius 30 mm, each at most 0.0011 mm inside it."""
    turn = np.radians(np.arange(361.0))
    points = 30.0 * np.column_stack([np.cos(turn), np.sin(turn)])
    return dieline((CUT, np.stack([points[:-1], points[1:]], axis=1)))


def test_arcs_that_replace_chords_state_their_distance() -> None:
    line = circle_of_chords()
    made = clean(line)
    assert check_cleaning(line, made) == []
    error = made.dieline.fit_error
    too_small = with_changes(made, fit_error=0.9 * error)
    assert (
        "the edge is 0.0011 mm away from the arc that replaces it, and only 0.0010 mm are stated"
        in findings_text(too_small, line)
    )
    unstated = with_changes(made, fit_error=np.zeros(len(error)))
    assert "only 0.0000 mm are stated" in findings_text(unstated, line)


def test_an_arc_of_a_wrong_radius_for_chords_is_found() -> None:
    line = circle_of_chords()
    made = clean(line)
    # Flatter arcs, 0.3 mm off in the middle: the first chords that are too far are reported.
    bulge = np.where(made.dieline.bulge != 0.0, 0.99, 0.0)
    findings = check_cleaning(line, with_changes(made, bulge=bulge))
    assert len(findings) == 50
    assert {finding.message.code for finding in findings} == {"verify.cleaning-moved"}
    assert 0.2 < max(finding.measure for finding in findings) < 0.3


def dropped_groove(start: tuple[float, float], end: tuple[float, float]) -> str:
    """Return the findings about a cleaning that drops the last 10 mm of a groove."""
    square, window = (
        closed((0, 0), (100, 0), (100, 80), (0, 80)),
        closed((40, 30), (60, 30), (60, 50), (40, 50)),
    )
    drawn = dieline((CUT, square), (CUT, window), (LineType.V_GROOVE, edges((start, end))))
    made = clean(drawn)
    length = float(np.hypot(end[0] - start[0], end[1] - start[1]))
    ends = drawn.ends.copy()
    ends[8, 1] = ends[8, 0] + (ends[8, 1] - ends[8, 0]) * (1.0 - 10.0 / length)
    parts = Stretches(
        np.append(np.arange(9), 8),
        np.append(np.zeros(9), 1.0 - 10.0 / length),
        np.concatenate([np.ones(8), [1.0 - 10.0 / length, 1.0]]),
        np.append(np.arange(9), -1),
        np.zeros(10, np.bool_),
    )
    made = replace(made, dieline=replace(drawn, ends=ends), stretches=parts)
    return findings_text(made, drawn)


@pytest.mark.parametrize(
    ("start", "end", "fine"),
    [
        ((50, 20), (110, 20), True),  # over the outline
        ((0, 40), (50, 40), True),  # into the window
        ((50, 20), (109, 20), False),  # 1 mm of the panel is dropped too
        ((0, 20), (95, 20), False),  # on the panel
        ((0, 40), (49, 40), False),
        ((95, 20), (110, 20), False),  # what remains is shorter
    ],
)
def test_only_the_part_of_a_groove_outside_all_panels_may_be_dropped(
    start: tuple[float, float], end: tuple[float, float], fine: bool
) -> None:
    assert (dropped_groove(start, end) == "") == fine


SQUARE = closed((0, 0), (100, 0), (100, 80), (0, 80))
WINDOW = closed((40, 30), (60, 30), (60, 50), (40, 50))
FRAME = closed((-50, -50), (200, -50), (200, 200), (-50, 200))
OPEN = SQUARE.copy()
OPEN[3, 1, 1] = 30.0
ACROSS = edges(((0, 40), (100, 40)))


@pytest.mark.parametrize(
    ("fault", "contours", "fold"),
    [
        ("doubt", (OPEN, WINDOW), edges(((31, 40), (69, 40)))),
        ("form", (FRAME, SQUARE, WINDOW), ACROSS),
        ("doubt", (FRAME, SQUARE), edges(((20, 5), (99, 60)), ((85, 10), (150, 10)))),
        ("length", (SQUARE,), edges(((50, 20), (125, 20)))),
        ("side", (SQUARE, WINDOW), ACROSS),
        ("side", (SQUARE,), edges(((50, 20), (110, 20)))),
    ],
)
def test_folds_that_cleaning_drops_wrongly_are_found(
    fault: str, contours: tuple[F64, ...], fold: F64, monkeypatch: pytest.MonkeyPatch
) -> None:
    drawn = dieline(*((CUT, contour) for contour in contours), (LineType.CREASE, fold))
    assert findings_text(clean(drawn), drawn) == ""
    if fault == "doubt":
        monkeypatch.setattr(
            trim_folds._Contours, "is_doubtful", lambda _, points: np.zeros(len(points), np.bool_)
        )
    if fault == "length":
        monkeypatch.setattr(trim_folds, "OVERSHOOT", 30.0)
    if fault == "side":
        right = trim_folds._classify
        monkeypatch.setattr(trim_folds, "_classify", lambda *given: right(*given)[::-1])
    if fault in ("form", "side"):
        monkeypatch.setattr(
            trim_folds, "_find_dropped", lambda ends, bulge, parts, on_panel, in_waste: in_waste
        )
        monkeypatch.setattr(
            trim_folds._Contours, "is_doubtful", lambda _, points: np.zeros(len(points), np.bool_)
        )
    assert "were lost" in findings_text(clean(drawn), drawn)


def octagon(x: float, y: float) -> F64:
    turns = np.pi / 4.0 * np.arange(8)
    return closed(*((x + 5.0 * np.cos(turn), y + 5.0 * np.sin(turn)) for turn in turns))


@pytest.mark.parametrize(
    ("inside", "arcs", "dropped"),
    [
        ([], [], 40.0),
        # Two circles, each drawn as chords too: the chords have faces on both sides.
        (
            [octagon(40, 40), octagon(60, 60)],
            [
                ((45, 40), (35, 40)),
                ((35, 40), (45, 40)),
                ((65, 60), (55, 60)),
                ((55, 60), (65, 60)),
            ],
            40.0,
        ),
        # Two cuts that begin at the window's contour may be the open outline of a panel.
        ([edges(((30, 35), (60, 35)), ((30, 60), (60, 60)))], [], 0.0),
    ],
)
def test_cleaning_and_verifier_agree_which_cuts_in_a_window_enclose_nothing(
    inside: list[F64], arcs: list[Any], dropped: float
) -> None:
    window = closed((30, 30), (70, 30), (70, 70), (30, 70))
    cuts = np.concatenate([SQUARE, window, *inside, edges(*arcs)])
    bulge = {len(cuts) - 1 - row: 1.0 for row in range(len(arcs))}
    across = edges(((0, 50), (100, 50)))
    drawn = dieline((CUT, cuts), (CREASE, across), bulge=bulge)
    made = clean(drawn)
    assert check_cleaning(drawn, made) == []
    assert made.dropped[-1] == pytest.approx(dropped)


def test_what_an_edge_loses_at_its_two_ends_is_two_gaps() -> None:
    drawn = dieline((CUT, edges(((0, 0), (100, 0)))))
    made = clean(drawn)
    rows, ends = np.zeros(3, np.int32), np.array([0.0, 0.0004, 0.9996, 1.0])
    lost = np.array([-1, 0, -1], np.int32)
    parts = Stretches(rows, ends[:-1], ends[1:], lost, np.zeros(3, np.bool_))
    assert check_cleaning(drawn, replace(made, stretches=parts)) == []
    ends = np.array([0.0, 0.0004, 0.0008, 1.0])
    lost = np.array([-1, -1, 0], np.int32)
    parts = Stretches(rows, ends[:-1], ends[1:], lost, np.zeros(3, np.bool_))
    assert "0.080 mm of the edge were lost" in findings_text(replace(made, stretches=parts), drawn)


def test_a_fold_whose_trimming_the_verifier_doubts_is_made_as_drawn(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    fold = edges(((31, 40), (69, 40)))
    drawn = dieline((CUT, OPEN), (CUT, WINDOW), (CREASE, fold))
    monkeypatch.setattr(
        trim_folds._Contours, "is_doubtful", lambda _, points: np.zeros(len(points), np.bool_)
    )
    assert clean(drawn).dropped[-1] > 0.0
    checked = clean_checked(drawn)
    assert checked.cleaned.dropped[-1] == 0.0
    assert checked.faults == ()
    assert check_cleaning(drawn, checked.cleaned) == []
