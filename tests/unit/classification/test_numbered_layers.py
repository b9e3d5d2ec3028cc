"""Layers whose names only count."""

from __future__ import annotations

import pytest

from knifetip.classification.numbered_layers import find_numbered_layers
from knifetip.classification.questions import list_questions
from tests.support.classification import BLANK, classified, drawing_of, style

BLACK, BLUE = (7, -1, "CONTINUOUS"), (5, -1, "CONTINUOUS")


def layers(count: int, *looks: tuple[int, int, str], name: str = "p-{}") -> dict[str, str]:
    return find_numbered_layers(
        (name.format(number), look) for number in range(count) for look in looks
    )


def test_layers_that_count_the_parts_of_a_drawing_are_a_series() -> None:
    assert layers(26, BLACK, BLUE) == {f"p-{number}": "p-0 … p-25" for number in range(26)}


@pytest.mark.parametrize(
    "found",
    [
        pytest.param(layers(3, BLACK, BLUE), id="few layers"),
        pytest.param(layers(9, BLACK), id="one layer per line type is possible"),
        pytest.param(layers(26, BLACK, BLUE, name="cut {}"), id="the name has a meaning"),
        pytest.param(layers(26, BLACK, BLUE, name="{}x4"), id="two numbers"),
        pytest.param(
            find_numbered_layers((f"L{at}", (at, -1, "CONTINUOUS")) for at in range(26)),
            id="each layer has a colour of its own",
        ),
    ],
)
def test_other_layers_are_no_series(found: dict[str, str]) -> None:
    assert found == {}


def test_many_layers_of_one_look_are_a_series() -> None:
    assert set(layers(10, BLACK).values()) == {"p-0 … p-9"}


def test_a_series_is_asked_about_in_one_question_by_colour() -> None:
    slits = [
        ([(20.0 + 10.0 * at, 50.0, 26.0 + 10.0 * at, 50.0 + side)], style(f"p-{at}", colour))
        for at in range(5)
        for side, colour in ((0.0, 140), (6.0, 30))
    ]
    sheet = drawing_of((BLANK[:4], style("outline", colour=90)), *slits)
    asked = list_questions(sheet, classified(sheet))
    assert [question.layer for question in asked] == ["p-0 … p-4"] * 2
    assert [len(question.edges) for question in asked] == [5, 5]
    assert "p-0 … p-4" in asked[0].text


def test_many_layers_with_few_colours_are_a_series_although_each_has_one_colour() -> None:
    styles = [(f"p-{number}", number % 2) for number in range(12)]
    assert find_numbered_layers(styles) == dict.fromkeys(
        (layer for layer, _ in styles), "p-0 … p-11"
    )
    # Twelve layers in six colours may be line types.
    assert find_numbered_layers([(f"p-{number}", number % 6) for number in range(12)]) == {}
