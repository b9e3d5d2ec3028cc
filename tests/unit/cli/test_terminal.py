"""JSON output of the commands, and the language of what they print."""

from __future__ import annotations

import json
import math

import pytest

from knifetip.cli.terminal import json_bytes, report_error
from knifetip.errors import NotADrawing


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


@pytest.mark.parametrize(
    ("environment", "shown"),
    [
        ({"LANG": "de_DE.UTF-8"}, "knifetip: Die Datei ist leer.\n"),
        ({"LC_ALL": "C.UTF-8", "LANG": "de_DE.UTF-8"}, "knifetip: The file is empty.\n"),
        ({"LC_MESSAGES": "de_AT", "LANG": "en_GB"}, "knifetip: Die Datei ist leer.\n"),
        ({}, "knifetip: The file is empty.\n"),
    ],
)
def test_errors_are_in_the_language_of_the_environment(
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    environment: dict[str, str],
    shown: str,
) -> None:
    for name in ("LC_ALL", "LC_MESSAGES", "LANG"):
        monkeypatch.delenv(name, raising=False)
    for name, value in environment.items():
        monkeypatch.setenv(name, value)
    report_error(NotADrawing("reading.empty", formats=["DXF", "PDF"]))
    assert capsys.readouterr().err.startswith(shown)
