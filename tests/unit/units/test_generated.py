"""Cartons in every unit with right, missing and wrong headers: never read in a wrong unit."""

from __future__ import annotations

import random
from collections import Counter

import pytest

from knifetip.model.unit import DRAWN_IN, MILLIMETRES
from knifetip.units.evidence import find_unit
from tests.support.cartons.known_size import DECIMALS, carton, carton_drawing

WORDS = (
    "", "", "", "dimensions", "texts", "title", "dimensions mm", "texts mm", "title mm",
    "texts in", "dimensions in",
)  # fmt: skip
CARTONS = 60


def outcomes(header: str, seed: int) -> Counter[tuple[str, str]]:
    """Count cartons by whether the sheet has texts, and by the result of finding the unit."""
    chance = random.Random(seed)
    count: Counter[tuple[str, str]] = Counter()
    for _ in range(CARTONS):
        one = carton(chance)
        for unit in MILLIMETRES:
            if header == "right":
                if unit not in DRAWN_IN:
                    continue
                stated = unit
            elif header == "missing":
                stated = ""
            else:
                stated = chance.choice([other for other in DRAWN_IN if other != unit])
            annotation = chance.choice(WORDS)
            drawing = carton_drawing(
                one,
                unit,
                stated,
                decimals=chance.choice(DECIMALS[unit]),
                annotation=annotation,
                chance=chance,
                turn=chance.choice([0.0, 0.0, 0.0, 0.3]),
            )
            found = find_unit(drawing).unit
            outcome = "asked" if not found else "right" if found == unit else "wrong"
            count["words" if annotation else "no words", outcome] += 1
            if outcome == "wrong":
                pytest.fail(
                    f"{one} drawn in {unit}, header {stated!r}, {annotation!r}: read in {found}"
                )
    return count


@pytest.mark.parametrize("seed", [1, 2])
@pytest.mark.parametrize(
    # Minimum percentages of sheets, with and without texts, that are read without a question.
    ("header", "with_words", "without_words"),
    [("right", 97, 82), ("missing", 96, 40), ("wrong", 93, 25)],
)
def test_no_carton_is_read_in_a_wrong_unit(
    header: str, with_words: int, without_words: int, seed: int
) -> None:
    count = outcomes(header, seed)
    for kind, least in (("words", with_words), ("no words", without_words)):
        right, asked = count[kind, "right"], count[kind, "asked"]
        assert right + asked > 40
        assert 100.0 * right / (right + asked) >= least, count
