"""What a file says of its unit, a drawing in another one, and the question when nobody knows."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose, assert_array_equal

from dxf_text import dxf, line
from knifetip.dxf.read import read
from knifetip.dxf.units import MILLIMETRES, question, rescaled, stated
from knifetip.errors import UnitUnknown

BOX = (line(0, 0, 250, 0), line(250, 0, 250, 180))


@pytest.mark.parametrize(
    ("code", "unit", "millimetres"),
    [(1, "in", 25.4), (2, "ft", 304.8), (4, "mm", 1.0), (5, "cm", 10.0), (6, "m", 1000.0)],
)
def test_header_gives_the_unit(code, unit, millimetres):
    drawing = read(dxf(line(0, 0, 2, 0), units=code))
    assert drawing.unit == unit
    assert drawing.evidence == f"$INSUNITS = {code}"
    assert_array_equal(drawing.ends[0], [[0, 0], [2 * millimetres, 0]])
    assert drawing.ledger.length[0] == 2 * millimetres
    assert question(drawing) is None


@pytest.mark.parametrize("version", ["AC1006", "AC1009", "AC1015", "AC1027"])
def test_silent_header_gives_no_unit_whatever_the_version(version):
    drawing = read(dxf(line(0, 0, 2, 0), units=None, version=version))
    assert (drawing.unit, drawing.evidence) == ("", "the file has no $INSUNITS")
    assert_array_equal(drawing.ends[0], [[0, 0], [2, 0]])


@pytest.mark.parametrize(
    ("written", "evidence"),
    [
        ("0", "$INSUNITS = 0: the file says that it has no unit"),
        ("9", "$INSUNITS = 9: mils, which are not read"),
        ("77", "$INSUNITS = 77 has no meaning"),
        ("-1", "$INSUNITS = -1 has no meaning"),
        ("MM", "$INSUNITS = 'MM' is no number"),
        ("1E999", "$INSUNITS = '1E999' is no number"),
    ],
)
def test_header_that_says_nothing_useful_gives_no_unit_and_the_reason(written, evidence):
    assert stated({"$INSUNITS": written}) == ("", evidence)


def test_unit_of_the_caller_stands_above_the_header():
    drawing = read(dxf(line(0, 0, 2, 0), units=4), "in")
    assert (drawing.unit, drawing.evidence) == ("in", "given")
    assert_array_equal(drawing.ends[0], [[0, 0], [50.8, 0]])


def test_unknown_unit_is_refused_with_the_known_ones():
    with pytest.raises(UnitUnknown, match="mm, cm, m, in, ft"):
        read(dxf(*BOX), "furlong")
    with pytest.raises(UnitUnknown):
        rescaled(read(dxf(*BOX)), "furlong")


def test_giving_a_unit_scales_ends_and_ledger():
    silent = read(dxf(*BOX, units=None))
    inches = rescaled(silent, "in")
    assert_allclose(inches.bounds, [0, 0, 6350, 4572])
    assert_allclose(inches.ledger.length, [6350, 4572])
    assert (inches.unit, inches.evidence) == ("in", "given")
    assert_array_equal(inches.bulge, silent.bulge)


def test_giving_the_unit_later_is_the_same_as_giving_it_to_read():
    early, late = read(dxf(*BOX), "in"), rescaled(read(dxf(*BOX, units=None)), "in")
    assert_array_equal(early.ends, late.ends)
    assert_array_equal(early.ledger.length, late.ledger.length)


def test_correcting_a_unit_starts_from_file_units_again():
    wrong = read(dxf(*BOX, units=6))
    assert_allclose(rescaled(wrong, "mm").bounds, [0, 0, 250, 180])
    assert_allclose(rescaled(wrong, "").bounds, [0, 0, 250, 180])
    assert rescaled(wrong, "").unit == ""


@given(x=st.floats(-1e5, 1e5), units=st.lists(st.sampled_from([*MILLIMETRES, ""]), max_size=6))
def test_any_tour_through_the_units_comes_home(x, units):
    first = read(dxf(line(x, 0, x + 1.0, 7.0), units=4))
    drawing = first
    for unit in units:
        drawing = rescaled(drawing, unit)
    assert_allclose(rescaled(drawing, "mm").ends, first.ends, rtol=2e-15, atol=0.0)


def test_from_mm_to_mm_no_bit_changes():
    drawing = read(dxf(line(0.1, 0.7, 1 / 3, 0.123456789), units=4))
    assert rescaled(drawing, "mm").ends.tobytes() == drawing.ends.tobytes()


def test_question_states_the_size_in_each_plausible_unit():
    asked = question(read(dxf(*BOX, units=None)))
    assert asked.kind == "unit"
    assert asked.choices == ("mm", "cm", "m", "in", "ft")
    # 250 cm is a large sheet; 250 m, 250 inches (6.35 m) and 250 feet are no cartons.
    assert asked.text == (
        "The file does not say its unit. As mm the drawing is 250.0 × 180.0 mm, "
        "as cm 2500 × 1800 mm."
    )


def test_question_for_a_small_drawing_offers_inches():
    asked = question(read(dxf(line(0, 0, 10, 0), line(0, 0, 0, 7), units=None)))
    assert "as inches 254.0 × 177.8 mm" in asked.text
    assert "as mm" not in asked.text.lower()


def test_question_for_a_drawing_of_no_plausible_size_states_all():
    asked = question(read(dxf(line(0, 0, 1e5, 0), units=None)))
    assert [word in asked.text for word in ("As mm", "cm", "metres", "inches", "feet")] == [
        True
    ] * 5


def test_question_for_a_unit_that_is_not_read_names_it():
    asked = question(read(dxf(*BOX, units=9)))
    assert asked.text.startswith(
        "The file does not say a unit that is read ($INSUNITS = 9: mils, which are not read)."
    )
