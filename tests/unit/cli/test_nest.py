"""knifetip nest: drawings are placed on sheets, which are written as layouts or drawings."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from knifetip import pipeline
from knifetip.model.layout import Layout
from tests.support.command import Command
from tests.support.serving.server import square


@pytest.fixture
def drawing(tmp_path: Path) -> Path:
    """A square of 100 mm."""
    file = tmp_path / "square.dxf"
    file.write_bytes(square())
    return file


def test_the_layout_of_each_sheet_is_written(
    knifetip: Command, drawing: Path, tmp_path: Path
) -> None:
    output = tmp_path / "layout.json"
    words = ["--sheet", "430x230", "--gap", 5, "--margin", 10, "--count", 9, "--seconds", 1]
    code, printed, progress = knifetip("nest", drawing, *words, "-o", output)
    assert code == 0, progress
    assert "sheets: 2" in printed
    assert "%" in progress
    first, second = (
        Layout.model_validate_json((tmp_path / name).read_text())
        for name in ("layout.json", "layout-2.json")
    )
    assert (first.count, second.count) == (6, 3)
    assert all(one.x >= 9.95 and one.y >= 9.95 for one in first.placed)


def test_a_sheet_is_written_as_a_drawing(knifetip: Command, drawing: Path, tmp_path: Path) -> None:
    output = tmp_path / "sheet.dxf"
    words = ["--sheet", "430x230", "--left-over", "110x110", "--count", 2, "--seconds", 1]
    assert knifetip("nest", drawing, *words, "-o", output)[0] == 0
    for name in ("sheet.dxf", "sheet-2.dxf"):
        sheet = pipeline.read((tmp_path / name).read_bytes())
        assert (len(sheet), sheet.unit, sheet.layers[0]) == (4, "mm", "CUT")


@pytest.mark.parametrize(
    ("words", "text"),
    [
        (["--sheet", "12 by 8", "-o", "a.json"], "is not the size of a sheet"),
        (["--sheet", "0x8", "-o", "a.json"], "is not the size of a sheet"),
        (["--sheet", "80x80", "-o", "a.json"], "part 1 of 100 × 100 mm fits on no sheet"),
        (["--sheet", "200x200", "-o", "a.pdf"], "another ending than .json and .dxf"),
    ],
)
def test_what_cannot_be_placed_is_refused(
    knifetip: Command, drawing: Path, words: list[str], text: str
) -> None:
    code, _, error = knifetip("nest", drawing, *words)
    assert code == 3
    assert text in error


def test_a_written_layout_is_plain_json(knifetip: Command, drawing: Path, tmp_path: Path) -> None:
    output = tmp_path / "a.json"
    knifetip("nest", drawing, "--sheet", "200x200", "--grain", "y", "--seconds", 1, "-o", output)
    found = json.loads(output.read_text())
    sheet = found["sheet"]
    assert (sheet["width"], sheet["height"], sheet["grain"]) == (200, 200, "y")
    assert found["placed"][0]["turn"] in (0.0, 180.0)
