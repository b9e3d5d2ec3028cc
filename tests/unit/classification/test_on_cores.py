"""Shape looked at by several cores: what one core sees, to the bit."""

from __future__ import annotations

from dataclasses import fields
from itertools import pairwise

import numpy as np
import pytest

from knifetip.classification import arrows, evidence, measures, parts
from knifetip.classification.evidence import Shape, shape
from knifetip.model.drawing import Drawing
from knifetip.topology import dash_rows, gap_links, intersections, nesting
from tests.support.cartons import random_drawings


def _seen(drawing: Drawing) -> Shape:
    return shape(drawing.ends, drawing.bulge, drawing.inscriptions, bool(drawing.unit))


def _five(count: int, _worth: int, _most: int | None = None) -> list[tuple[int, int]]:
    return list(pairwise(count * share // 5 for share in range(6)))


@pytest.mark.parametrize("seed", range(25))
def test_several_cores_see_what_one_sees(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    drawing = random_drawings.random_drawing(seed)[0]
    one = _seen(drawing)
    for module in (
        *(arrows, evidence, measures, parts),
        *(dash_rows, gap_links, intersections, nesting),
    ):
        monkeypatch.setattr(module, "runs", _five)
    five = _seen(drawing)
    for column in fields(Shape):
        np.testing.assert_array_equal(getattr(one, column.name), getattr(five, column.name))
