"""Numbers in messages: no exponent, characters between thousands, rounding as ICU rounds."""

from __future__ import annotations

import math
from typing import Any

import pytest

from knifetip.messages import Message, render
from knifetip.messages.catalogue import MESSAGES
from knifetip.messages.codes import CODES
from knifetip.messages.languages import LANGUAGES, language
from knifetip.messages.numbers import Position, write_number


@pytest.mark.parametrize(
    ("value", "form", "english", "german"),
    [
        (1200.0, ".2g", "1,200", "1.200"),
        (1234.0, ".2g", "1,200", "1.200"),
        (1200.0, "g", "1,200", "1.200"),
        (1234567.8, "g", "1,234,570", "1.234.570"),
        (0.5, "g", "0.5", "0,5"),
        (0.00001234, ".3g", "0.0000123", "0,0000123"),
        (100.0, ".3g", "100", "100"),
        (12.50, "g", "12.5", "12,5"),
        (0.0, "g", "0", "0"),
        (-3.25, "g", "-3.25", "-3,25"),
        (1234.5, ".1f", "1,234.5", "1.234,5"),
        (0.125, ".2f", "0.13", "0,13"),
        (2.5, ".0f", "3", "3"),
        (1e-05, "", "0.00001", "0,00001"),
        (1234.5678, "", "1,234.5678", "1.234,5678"),
        (1234567.0, ",", "1,234,567", "1.234.567"),
        (1250.4, "d", "1,250", "1.250"),
        (4000.4, "mm", "4,000", "4.000"),
        (101.6, "mm", "101.6", "101,6"),
        (0.12345, "mm", "0.123", "0,123"),
        (3 * 2**30, "MB", "3,072.0", "3.072,0"),
        (1e15, "g", "1E15", "1E15"),
        (-2.3456785e200, ".1f", "-2.34568E200", "-2,34568E200"),
        (999999.4e9, "g", "999,999,000,000,000", "999.999.000.000.000"),
    ],
)
def test_numbers_are_written_as_a_person_writes_them(
    value: float, form: str, english: str, german: str
) -> None:
    assert write_number(value, form, language("en")) == english
    assert write_number(value, form, language("de")) == german


def test_coordinates_have_no_characters_between_thousands() -> None:
    assert write_number(Position(1234.5), ".3f", language("en")) == "1234.500"
    assert write_number(Position(1234.5), ".3f", language("de")) == "1234,500"
    assert write_number(Position(1234.5), ",.1f", language("en")) == "1,234.5"


def test_values_that_are_not_finite_are_written_as_python_does() -> None:
    assert write_number(math.inf, "g", language("en")) == "inf"


def test_an_unknown_format_is_refused() -> None:
    with pytest.raises(ValueError, match="unknown"):
        write_number(1.0, "08.3f", language("en"))


@pytest.mark.parametrize("tag", LANGUAGES)
@pytest.mark.parametrize("value", [1200.0, 1234567.5, 0.0000125])
def test_no_message_contains_an_exponent(tag: str, value: float) -> None:
    values: dict[str, Any] = {
        **{"text": "T", "count": 1200, "number": value, "texts": (), "message?": None},
        **{"message": Message("stored.text", text="", hint=""), "messages": ()},
        **{"edge": 7, "edges": (), "x": value, "y": value},
    }
    numeric = [code for code, kinds in CODES.items() if "number" in kinds.values()]
    assert len(numeric) > 250
    for code in numeric:
        found = render(
            Message(code, **{n: values[k] for n, k in MESSAGES[code].arguments.items()}), tag
        )
        assert "e+" not in found, found
        assert "e-0" not in found, found


def test_a_length_above_one_metre_is_written_in_full() -> None:
    message = Message("hpgl.travel", path="x", low=0.0, high=1200.0, least=0.0, greatest=1e6)
    assert "from 0 to 1,200 mm" in render(message)
    assert "from 0 to 1,000,000 mm" in render(message)
