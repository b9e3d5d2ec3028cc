"""Cartons in the conventions of other companies: each edge is right or asked, never wrong."""

from __future__ import annotations

import numpy as np
import pytest

from knifetip import pipeline
from knifetip.cleaning.clean import clean
from knifetip.library import load
from knifetip.model.dieline import LineType
from tests.support.cartons.house_files import drawn, truth
from tests.support.cartons.houses import HOUSES, House
from tests.support.cartons.kinds import KINDS

#: Blanks that share their cuts, in one style: what hangs together cannot be known for certain.
_UNKNOWABLE = ("One layer, all black, six-up",)


@pytest.mark.parametrize("house", HOUSES, ids=lambda house: house.name)
def test_a_house_is_right_or_asked_about_and_its_unit_too(house: House) -> None:
    rules = load.profile("default")
    edges = wrong = asked = 0
    first = HOUSES.index(house)
    for seed in range(first, first + 3):
        data, strokes, kind = drawn(house, seed)
        drawing = pipeline.read(data)
        if drawing.unit:
            corners = np.array([(s.x0, s.y0, s.x1, s.y1) for s in strokes]).reshape(-1, 2)
            size = np.ptp(corners, axis=0).max()
            assert np.ptp(drawing.ends.reshape(-1, 2), axis=0).max() == pytest.approx(size, 0.02)
        kinds, _ = truth(drawing, strokes)
        dieline = pipeline.classify(drawing, rules)
        said = dieline.line_type
        unsaid = said == LineType.UNCLASSIFIED
        edges, asked = edges + len(said), asked + int(unsaid.sum())
        wrong += int((~unsaid & (said != kinds)).sum())
        cleaned = clean(dieline)
        sums = cleaned.kept + cleaned.merged + cleaned.dropped
        np.testing.assert_allclose(sums, drawing.lengths, atol=1e-6, err_msg=kind)
    assert wrong <= (0.01 * edges if house.name in _UNKNOWABLE else 0)
    assert edges > asked


def test_every_kind_of_carton_is_drawn_by_somebody() -> None:
    assert len(HOUSES) + 3 > len(KINDS)
    assert len({house.name for house in HOUSES}) == len(HOUSES) >= 75
