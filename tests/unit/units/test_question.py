"""What is asked about the unit: the size in each, the likeliest first, and why."""

from __future__ import annotations

from dataclasses import replace

from knifetip.dxf.read import read
from knifetip.model.question import Question
from knifetip.units.evidence import judge
from knifetip.units.question import question
from knifetip.units.rescale import rescaled
from tests.support.writers.dxf_text import dxf, line

BOX = (line(0, 0, 250, 0), line(250, 0, 250, 180))


def asked(data: bytes) -> Question:
    drawing = rescaled(read(data), "")
    evidence = read(data).evidence
    asked = question(replace(drawing, evidence=evidence), judge(drawing))
    assert asked is not None
    return asked


def test_known_unit_is_not_asked() -> None:
    drawing = read(dxf(*BOX, units=4))
    assert question(drawing, judge(drawing)) is None


def test_question_states_the_size_in_each_unit_and_begins_with_the_likeliest() -> None:
    told = asked(dxf(*BOX, units=None))
    assert told.kind == "unit"
    assert told.choices[0] == "mm"
    assert set(told.choices) == {"mm", "cm", "m", "in", "ft"}
    assert told.text.startswith(
        "The file does not state its unit. The drawing's size would be 250.0 × 180.0 mm in mm, "
        "2500 × 1800 mm in cm, 6350 × 4572 mm in inches,"
    )
    assert "Strongest evidence for mm: in mm 2 of 2 lengths" in told.text


def test_small_numbers_put_centimetres_and_inches_first() -> None:
    told = asked(dxf(line(0, 0, 10, 0), line(0, 0, 0, 7), units=None))
    assert set(told.choices[:2]) == {"cm", "in"}
    assert "100.0 × 70.0 mm" in told.text
    assert "254.0 × 177.8 mm" in told.text


def test_pixels_are_offered_where_they_are_likely() -> None:
    # 300 and 200 mm at 96 to the inch.
    side = [line(0, 0, 1133.858, 0), line(0, 0, 0, 755.906), line(9, 9, 9, 198.0)]
    assert "px" in asked(dxf(*side, units=None)).choices
    assert "px" not in asked(dxf(*BOX, units=None)).choices


def test_question_for_a_unit_that_is_not_read_names_it() -> None:
    assert asked(dxf(*BOX, units=9)).text.startswith(
        "The file does not state a unit of length that is supported "
        "($INSUNITS = 9: mils, which are not supported)."
    )


def test_question_says_that_the_header_is_not_borne_out() -> None:
    assert asked(dxf(*BOX, units=6)).text.startswith(
        "The file states metres as its unit, but the drawing does not look like it. "
    )
