"""Warnings about what import left out."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

from knifetip import pipeline
from knifetip.cli import main
from knifetip.messages import hint
from knifetip.presentation.drawing import drawing_json
from knifetip.presentation.import_warnings import import_warnings
from tests.support.writers import dxf_text as text

SIDE = text.line(0.0, 0.0, 100.0, 0.0, (8, "CUT"))


def warnings(*entities: str) -> list[str]:
    return [str(one) for one in import_warnings(pipeline.read(text.dxf(SIDE, *entities)))]


def hidden(layer: str, at: float) -> str:
    return text.line(0.0, at, 100.0, at, (8, layer), (60, 1))


def test_a_drawing_of_which_nothing_was_left_out_has_no_warning() -> None:
    assert warnings() == []


def test_texts_are_left_out_without_a_warning() -> None:
    assert warnings(text.entity("TEXT", (8, "N"), (10, 0), (20, 0), (40, 5), (1, "Rev. B"))) == []


def test_objects_of_one_layer_and_reason_are_one_warning_and_the_most_come_first() -> None:
    assert warnings(hidden("A", 1.0), hidden("B", 2.0), hidden("B", 3.0)) == [
        "2 objects on layer 'B' are not cut: the object is marked as invisible.",
        "1 object on layer 'A' is not cut: the object is marked as invisible.",
    ]


def test_more_than_eight_warnings_are_counted() -> None:
    many = warnings(*(hidden(f"L{number}", float(number)) for number in range(1, 11)))
    assert len(many) == 9
    assert many[-1] == "2 further objects are not cut."


def test_the_data_of_a_drawing_have_the_warnings_with_their_hints() -> None:
    drawing = pipeline.read(text.dxf(SIDE, hidden("A", 1.0)))
    (one,) = import_warnings(drawing)
    assert hint(one).startswith("The import report lists it.")
    assert one.as_json() in drawing_json(drawing)["warnings"]


@pytest.mark.parametrize("command", ["read", "classify"])
def test_the_command_line_prints_the_warnings(
    command: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capfd: pytest.CaptureFixture[str],
) -> None:
    file = tmp_path / "hidden.dxf"
    file.write_bytes(text.dxf(SIDE, hidden("A", 1.0)))
    monkeypatch.setattr(sys, "argv", ["knifetip", command, str(file)])
    with pytest.raises(SystemExit):
        main()
    printed = capfd.readouterr()
    assert "1 object on layer 'A' is not cut" in printed.out + printed.err
