"""Cartons in the conventions of other companies: each edge is right or asked, never wrong."""

from __future__ import annotations

import numpy as np
import pytest

from knifetip import pipeline
from knifetip.cleaning.clean import clean
from knifetip.library import load
from knifetip.model.dieline import LineType
from tests.support.cartons.companies import COMPANIES, Company
from tests.support.cartons.company_files import company_file, truth
from tests.support.cartons.kinds import KINDS

#: Blanks with common cuts in one style: which faces form one blank cannot be determined.
_UNKNOWABLE = ("One layer, all black, six-up",)


@pytest.mark.parametrize("company", COMPANIES, ids=lambda company: company.name)
def test_edges_and_units_of_a_company_are_right_or_asked(company: Company) -> None:
    rules = load.profile("default")
    edges = wrong = asked = 0
    first = COMPANIES.index(company)
    for seed in range(first, first + 3):
        data, strokes, kind = company_file(company, seed)
        drawing = pipeline.read(data)
        if drawing.unit:
            corners = np.array([(s.x0, s.y0, s.x1, s.y1) for s in strokes]).reshape(-1, 2)
            size = np.ptp(corners, axis=0).max()
            assert np.ptp(drawing.ends.reshape(-1, 2), axis=0).max() == pytest.approx(size, 0.02)
        correct, _ = truth(drawing, strokes)
        dieline = pipeline.classify(drawing, rules)
        line_type = dieline.line_type
        unclassified = line_type == LineType.UNCLASSIFIED
        edges, asked = edges + len(line_type), asked + int(unclassified.sum())
        wrong += int((~unclassified & (line_type != correct)).sum())
        cleaned = clean(dieline)
        sums = cleaned.kept + cleaned.merged + cleaned.dropped
        np.testing.assert_allclose(sums, drawing.lengths, atol=1e-6, err_msg=kind)
    assert wrong <= (0.01 * edges if company.name in _UNKNOWABLE else 0)
    assert edges > asked


def test_every_kind_of_carton_is_drawn_by_some_company() -> None:
    assert len(COMPANIES) + 3 > len(KINDS)
    assert len({company.name for company in COMPANIES}) == len(COMPANIES) >= 75
