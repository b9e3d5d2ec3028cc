"""Edges that must be folds, of a mailer, a case and several blanks."""

from __future__ import annotations

import numpy as np

from knifetip.classification.shape.features import extract_shape_features
from tests.support.cartons.kinds import crossed_case, mailer
from tests.support.cartons.plan import Plan


def required_folds(plan: Plan) -> dict[str, list[bool]]:
    """Return whether each line of a plan must be a fold, grouped by the name of its part."""
    ends = np.array([((s.x0, s.y0), (s.x1, s.y1)) for s in plan.strokes])
    features = extract_shape_features(ends, np.array([s.bulge for s in plan.strokes]))
    required: dict[str, list[bool]] = {}
    for stroke, must_fold in zip(plan.strokes, features.must_fold.tolist(), strict=True):
        required.setdefault(stroke.part, []).append(must_fold)
    return required


def test_every_crease_of_a_mailer_must_be_a_fold() -> None:
    required = required_folds(mailer(np.random.default_rng(1)))
    assert required["crease"] == [True] * 14
    assert not any([*required["outer"], *required["inner"]])


def test_slits_between_the_flaps_of_a_case_are_left_open() -> None:
    # Of ten creases and slits that end on the outline, only that of the glue flap must be a fold.
    required = required_folds(crossed_case(np.random.default_rng(1)))
    assert not any([*required["inner"], *required["outer"]])
    assert sum(required["crease"]) == 4


def test_no_folds_are_required_in_cases_that_share_a_cut() -> None:
    plan = crossed_case(np.random.default_rng(1))
    _, y0, _, y1 = plan.bounds
    plan.strokes += plan.moved(0.0, y1 - y0)
    assert not any(
        must_fold for required in required_folds(plan).values() for must_fold in required
    )


def test_no_folds_are_required_in_a_card_of_two_panels() -> None:
    plan = Plan()
    plan.rectangle(0.0, 0.0, 100.0, 60.0, "outer")
    plan.line(50.0, 0.0, 50.0, 60.0, "crease")
    assert required_folds(plan)["crease"] == [False]


def test_slits_at_the_ends_of_a_fold_are_no_folds() -> None:
    # Eight flaps round a base, the first with a lock: 6 mm slit, fold, 6 mm slit.
    plan = Plan()
    plan.polyline(
        [
            (0.0, 0.0), (100.0, 0.0), (100.0, -50.0), (100.0, -80.0), (0.0, -80.0), (0.0, -50.0),
        ],
        "outer",
    )  # fmt: skip
    plan.strokes.pop(0)
    plan.line(0.0, 0.0, 100.0, 0.0, "crease")
    for x, part in ((0.0, "inner"), (6.0, "crease"), (94.0, "inner")):
        plan.line(x, -50.0, {0.0: 6.0, 6.0: 94.0, 94.0: 100.0}[x], -50.0, part)
    x = 0.0
    for wide in (100.0, 40.0, 90.0, 35.0):
        plan.polyline([(x, 0.0), (x, 120.0)], "outer", closed=False)
        plan.strokes.pop()
        plan.line(x, 120.0, x + wide, 120.0, "outer")
        if x:
            plan.line(x, 0.0, x, 120.0, "crease")
            plan.line(x, 0.0, x + wide, 0.0, "outer")
        x += wide
    plan.line(0.0, 0.0, 0.0, 120.0, "outer")
    plan.line(x, 0.0, x, 120.0, "outer")
    required = required_folds(plan)
    assert required["inner"] == [False, False]
    assert required["crease"] == [True] * 5


def test_a_living_hinge_has_no_required_folds() -> None:
    plan = Plan()
    plan.rectangle(0.0, 0.0, 200.0, 60.0, "outer")
    for k in range(30):
        plan.line(50.0 + 3.0 * k, 0.0, 50.0 + 3.0 * k, 60.0, "inner")
    assert not any(required_folds(plan)["inner"])


def test_the_borders_on_a_map_are_no_required_folds() -> None:
    # Six countries in a row, with a bend in each border.
    plan = Plan()
    plan.rectangle(0.0, 0.0, 350.0, 60.0, "outer")
    for k in range(1, 7):
        at = 50.0 * k + k * k / 2.0
        plan.polyline([(at, 0.0), (at + 5.0, 30.0), (at, 60.0)], "inner", closed=False)
    assert not any(required_folds(plan)["inner"])
