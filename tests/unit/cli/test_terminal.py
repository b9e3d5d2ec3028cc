"""JSON output of the commands."""

from __future__ import annotations

import json
import math

from knifetip.cli.terminal import json_bytes


def test_json_is_indented_and_ends_with_a_newline() -> None:
    data = {"name": "Größe", "numbers": [1, 0.1], "empty": [], "none": None}
    assert json_bytes(data).decode() == (
        '{\n  "name": "Größe",\n  "numbers": [\n    1,\n    0.1\n  ],\n'
        '  "empty": [],\n  "none": null\n}\n'
    )


def test_numbers_in_json_are_read_back_exactly() -> None:
    numbers = [0.1 + 0.2, 1e-7, 4.961240324519167e-05, 1e22, -0.0]
    assert json.loads(json_bytes(numbers)) == numbers


def test_numbers_that_are_not_finite_are_null() -> None:
    assert json.loads(json_bytes([math.nan, math.inf])) == [None, None]
