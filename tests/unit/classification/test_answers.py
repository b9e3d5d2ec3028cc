"""What follows from the line types that the user gives to some edges."""

from __future__ import annotations

import numpy as np
import pytest

from knifetip import pipeline
from knifetip.library import load
from knifetip.model.drawing import Drawing
from knifetip.model.interpretation import NO_OVERRIDE
from tests.support.classification import Line, box, drawing_of, style, words

BLANK = box(0, 0, 400, 300)
#: Slits on two layers whose names have no meaning, and one of another colour.
SLITS: list[Line] = [(50.0 + 40.0 * at, 100.0, 70.0 + 40.0 * at, 100.0) for at in range(6)]
SHEET = drawing_of(
    (BLANK, style(colour=90)),
    (SLITS[:3], style("Layer 1", 40)),
    (SLITS[3:5], style("Layer 2", 40)),
    (SLITS[5:], style("Layer 2", 50)),
)
ASKED = slice(4, 10)


def answered(answers: dict[int, int], sheet: Drawing = SHEET) -> list[str]:
    """Return the line types of the slits after the user gave some of them, by row."""
    overrides = np.full(len(sheet), NO_OVERRIDE, np.uint8)
    for row, kind in answers.items():
        overrides[row] = kind
    return words(pipeline.classify(sheet, load.profile("default"), overrides))[ASKED]


CUT, CREASE = 1, 2
OPEN = "unclassified"


def test_open_edges_with_the_look_of_answered_ones_follow() -> None:
    assert answered({}) == [OPEN] * 6
    assert answered({4: CREASE, 5: CREASE, 6: CREASE}) == ["crease"] * 5 + [OPEN]


@pytest.mark.parametrize(
    ("answers", "left"),
    [
        pytest.param({4: CREASE, 5: CREASE}, 4, id="more edges are open than answered"),
        pytest.param({4: CREASE, 5: CREASE, 6: CUT}, 3, id="the answers differ"),
    ],
)
def test_nothing_follows_from_too_few_or_different_answers(
    answers: dict[int, int], left: int
) -> None:
    assert answered(answers).count(OPEN) == left


def test_nothing_follows_where_edges_of_the_look_were_decided_otherwise() -> None:
    sheet = drawing_of((BLANK, style(colour=40)), (SLITS, style(colour=40)))
    assert answered({4: CREASE, 5: CREASE, 6: CREASE}, sheet).count(OPEN) == 3


def test_layers_with_names_are_looks_of_their_own() -> None:
    sheet = drawing_of(
        (BLANK, style(colour=90)),
        (SLITS[:3], style("Haken", 40)),
        (SLITS[3:], style("Lasche", 40)),
    )
    assert answered({4: CREASE, 5: CREASE, 6: CREASE}, sheet).count(OPEN) == 3
