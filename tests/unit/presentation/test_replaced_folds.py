"""Folds that are not made because cuts lie on their lines are warnings of the drawing."""

from __future__ import annotations

import numpy as np

from knifetip.cleaning.clean import clean
from knifetip.model.interpretation import NO_OVERRIDE
from knifetip.presentation.drawing import classified_json
from knifetip.presentation.outcomes import edge_outcomes
from knifetip.presentation.replaced_folds import replaced_fold_warnings
from tests.support.classification import BLANK, Line, box, classified, drawing_of, style

OUTLINE = box(0, 0, 300, 200)
FOLDS = BLANK[4:]


def warnings(*folds: Line) -> list[str]:
    """Return the warnings about a blank of 300 × 200 mm with some folds."""
    sheet = drawing_of((OUTLINE, style("CUT")), (list(folds), style("CREASE")))
    dieline = classified(sheet)
    return [str(one) for one in replaced_fold_warnings(dieline, clean(dieline), sheet.lengths)]


def test_a_crease_on_the_outline_is_told_with_its_length() -> None:
    (warning,) = warnings(*FOLDS, (0, 0, 300, 0), (300, 20, 300, 120))
    assert warning == (
        "2 edges of the line type crease lie on cuts and are not made along 400.0 mm: the cuts "
        "are made instead."
    )


def test_a_crease_that_is_longer_than_its_panel_is_told_from_ten_millimetres_on() -> None:
    assert warnings(*FOLDS) == []
    slit: Line = (100, 150, 100, 200)
    sheet = drawing_of(([*OUTLINE, slit], style("CUT")), (FOLDS, style("CREASE")))
    dieline = classified(sheet)
    (warning,) = replaced_fold_warnings(dieline, clean(dieline), sheet.lengths)
    assert (warning.arguments["count"], warning.arguments["length"]) == (1, 50.0)
    short: Line = (100, 191, 100, 200)
    sheet = drawing_of(([*OUTLINE, short], style("CUT")), (FOLDS, style("CREASE")))
    dieline = classified(sheet)
    assert replaced_fold_warnings(dieline, clean(dieline), sheet.lengths) == ()


def test_a_line_drawn_twice_in_one_style_is_no_fold() -> None:
    sheet = drawing_of(([*OUTLINE, *FOLDS, (0, 0, 300, 0)], style()))
    dieline = classified(sheet)
    assert replaced_fold_warnings(dieline, clean(dieline), sheet.lengths) == ()


def test_the_data_of_a_drawing_have_the_warning() -> None:
    sheet = drawing_of((OUTLINE, style("CUT")), ([*FOLDS, (0, 0, 300, 0)], style("CREASE")))
    dieline = classified(sheet)
    outcomes = edge_outcomes(sheet, dieline, clean(dieline))
    overrides = np.full(len(sheet), NO_OVERRIDE, np.uint8)
    data = classified_json(sheet, dieline, outcomes, (), overrides)
    assert [one["code"] for one in data["warnings"]] == ["cleaning.folds-on-cuts"]
