"""Shape features computed on several cores equal those of one core, bit by bit."""

from __future__ import annotations

from dataclasses import fields
from itertools import pairwise

import numpy as np
import pytest

from knifetip.classification.shape import arrows, features, measures, part_kinds
from knifetip.classification.shape.features import ShapeFeatures, extract_shape_features
from knifetip.model.drawing import Drawing
from knifetip.topology import dash_rows, gap_links, graph_nesting, intersections
from tests.support.cartons import random_drawings


def _features(drawing: Drawing) -> ShapeFeatures:
    return extract_shape_features(
        drawing.ends, drawing.bulge, drawing.annotations, bool(drawing.unit)
    )


def _five_chunks(count: int, _worth: int, _most: int | None = None) -> list[tuple[int, int]]:
    return list(pairwise(count * share // 5 for share in range(6)))


@pytest.mark.parametrize("seed", range(25))
def test_several_cores_compute_the_same_as_one(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    drawing = random_drawings.random_drawing(seed)[0]
    one = _features(drawing)
    for module in (
        *(arrows, features, measures, part_kinds),
        *(dash_rows, gap_links, graph_nesting, intersections),
    ):
        monkeypatch.setattr(module, "chunks", _five_chunks)
    five = _features(drawing)
    for column in fields(ShapeFeatures):
        np.testing.assert_array_equal(getattr(one, column.name), getattr(five, column.name))
