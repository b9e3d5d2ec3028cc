"""Positions of texts in the import report, and texts without a position."""

from __future__ import annotations

from knifetip import pipeline
from knifetip.presentation.import_report import annotations_by_row, import_report_rows
from tests.support.writers import dxf_text as text


def text_entity(layer: str, x: float, y: float, content: str, *more: text.Tag) -> str:
    return text.entity("TEXT", (8, layer), (10, x), (20, y), (40, 5), (1, content), *more)


def test_words_stand_where_the_file_puts_them() -> None:
    drawing = pipeline.read(
        text.dxf(
            text_entity("NOTES", 10.0, 20.0, "Rev. B"),
            text.line(0.0, 0.0, 100.0, 0.0, (8, "CUT")),
            text_entity("NOTES", 30.0, 40.0, "Glue"),
            text_entity("TITLE", 50.0, 60.0, "Box"),
        )
    )
    rows = import_report_rows(drawing)
    assert [(row.get("text"), row.get("place")) for row in rows] == [
        ("Rev. B", [10.0, 20.0, 5.0]),
        (None, None),
        ("Glue", [30.0, 40.0, 5.0]),
        ("Box", [50.0, 60.0, 5.0]),
    ]


def test_words_are_measured_in_the_unit_that_was_decided() -> None:
    drawing = pipeline.read(text.dxf(text_entity("NOTES", 1.0, 2.0, "Lid"), units=None), "in")
    assert import_report_rows(drawing)[0]["place"] == [25.4, 50.8, 127.0]


def test_words_of_a_block_or_of_the_paper_take_no_place_of_the_sheets() -> None:
    drawing = pipeline.read(
        text.dxf(
            text_entity("NOTES", 1.0, 1.0, "paper", (67, 1)),
            text.insert("STAMP", 500.0, 500.0),
            text_entity("NOTES", 7.0, 8.0, "sheet"),
            blocks=(text.block("STAMP", text_entity("NOTES", 0.0, 0.0, "stamp")),),
        )
    )
    found = annotations_by_row(drawing)
    assert [(drawing.import_report.handle[row], one.text) for row, one in found.items()] == [
        (drawing.import_report.handle[max(found)], "sheet")
    ]
