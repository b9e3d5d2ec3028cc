"""Edges that lie completely on others, such as a fold drawn on a cut, which needs no question."""

from __future__ import annotations

import numpy as np
import pytest

from knifetip import pipeline
from knifetip.classification.shape.features import extract_shape_features
from knifetip.library import load
from knifetip.model.dieline import LineType
from tests.support.writers.dxf_text import dxf, line

_RIM = ((0, 0, 200, 0), (200, 0, 200, 90), (200, 90, 0, 90), (0, 90, 0, 0))
_MIDDLE = (100, 0, 100, 90)


def _on(*lines: tuple[float, float, float, float]) -> list[int]:
    ends = np.array(lines, np.float64).reshape(-1, 2, 2)
    found: list[int] = extract_shape_features(ends, np.zeros(len(ends))).coincident.tolist()
    return found


def test_an_edge_lies_on_the_one_that_is_drawn_there_too() -> None:
    assert _on(*_RIM, _MIDDLE, (200, 0, 0, 0)) == [5, -1, -1, -1, -1, 0]


def test_a_part_of_a_line_lies_on_it_and_not_the_reverse() -> None:
    assert _on(*_RIM, _MIDDLE, (100, 0, 200, 0))[0] == -1
    assert _on(*_RIM, _MIDDLE, (100, 0, 200, 0))[5] == 0


def test_an_edge_over_two_others_lies_on_the_longer() -> None:
    halves = ((0, 0, 80, 0), (80, 0, 200, 0), *_RIM[1:])
    assert _on(*halves, _MIDDLE, (0, 0, 200, 0))[6] == 1


def test_an_edge_that_goes_on_beyond_the_other_does_not_lie_on_it() -> None:
    assert _on(*_RIM, _MIDDLE, (150, 0, 230, 0))[5] == -1


@pytest.mark.parametrize("crease", [(0, 0, 200, 0), (40, 0, 160, 0)])
def test_a_crease_on_a_cut_is_not_asked_about(crease: tuple[float, float, float, float]) -> None:
    text = [line(*one, (8, "Design"), (62, 1)) for one in _RIM]
    text += [line(*one, (8, "Design"), (62, 2)) for one in (_MIDDLE, crease)]
    drawing = pipeline.read(dxf(*text))
    dieline = pipeline.classify(drawing, load.profile("default"))
    assert dieline.line_type.tolist() == 4 * [LineType.CUT] + 2 * [LineType.CREASE]
    assert dieline.rules[dieline.rule[5]].code == "classification.on-cut"
    # Cleaning merges the crease into the cut.
    cleaned = pipeline.clean(dieline)
    assert cleaned.merged[5] == pytest.approx(drawing.lengths[5])
    assert cleaned.kept[4] == pytest.approx(90.0)


def test_a_crease_where_the_board_ends_is_asked_about() -> None:
    text = [line(*one, (8, "Design"), (62, 1)) for one in _RIM[1:]]
    text += [line(*one, (8, "Design"), (62, 2)) for one in (_MIDDLE, _RIM[0])]
    dieline = pipeline.classify(pipeline.read(dxf(*text)), load.profile("default"))
    assert dieline.line_type[4] == LineType.UNCLASSIFIED
