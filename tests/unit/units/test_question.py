"""The question about the unit: the size in each unit, the likeliest first, and the evidence."""

from __future__ import annotations

from dataclasses import replace

from knifetip.dxf.read import read
from knifetip.model.question import Question
from knifetip.units.evidence import find_unit
from knifetip.units.question import unit_question
from knifetip.units.rescale import rescale
from tests.support.writers.dxf_text import dxf, line

BOX = (line(0, 0, 250, 0), line(250, 0, 250, 180))


def question_about(data: bytes) -> Question:
    drawing = rescale(read(data), "")
    evidence = read(data).evidence
    question = unit_question(replace(drawing, evidence=evidence), find_unit(drawing))
    assert question is not None
    return question


def test_known_unit_is_not_asked() -> None:
    drawing = read(dxf(*BOX, units=4))
    assert unit_question(drawing, find_unit(drawing)) is None


def test_question_states_the_size_in_each_unit_and_begins_with_the_likeliest() -> None:
    question = question_about(dxf(*BOX, units=None))
    assert question.kind == "unit"
    assert question.choices[0] == "mm"
    assert set(question.choices) == {"mm", "cm", "m", "in", "ft"}
    assert question.text.startswith(
        "The file does not state the unit of the drawing. In which unit is the drawing? "
        "Its possible sizes are: 250.0 × 180.0 mm if the unit is mm, "
        "2,500 × 1,800 mm if the unit is cm, 6,350 × 4,572 mm if the unit is inches,"
    )
    assert (
        "The strongest evidence for mm is: if the unit is mm, 2 of 2 different edge lengths"
        in question.text
    )


def test_small_numbers_put_centimetres_and_inches_first() -> None:
    question = question_about(dxf(line(0, 0, 10, 0), line(0, 0, 0, 7), units=None))
    assert set(question.choices[:2]) == {"cm", "in"}
    assert "100.0 × 70.0 mm" in question.text
    assert "254.0 × 177.8 mm" in question.text


def test_pixels_are_offered_where_they_are_likely() -> None:
    # 300 and 200 mm at 96 pixels per inch.
    side = [line(0, 0, 1133.858, 0), line(0, 0, 0, 755.906), line(9, 9, 9, 198.0)]
    assert "px" in question_about(dxf(*side, units=None)).choices
    assert "px" not in question_about(dxf(*BOX, units=None)).choices


def test_question_names_an_unsupported_unit() -> None:
    assert question_about(dxf(*BOX, units=9)).text.startswith(
        "The unit of the drawing is not known: "
        "the header of the DXF file states a unit that is not supported: mils ($INSUNITS = 9)."
    )


def test_question_states_that_the_evidence_contradicts_the_header() -> None:
    assert question_about(dxf(*BOX, units=6)).text.startswith(
        "The file states the unit metres, but the size of the drawing does not match this unit. "
    )
