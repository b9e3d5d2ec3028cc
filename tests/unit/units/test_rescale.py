"""Change the unit of a drawing."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose, assert_array_equal

from knifetip.dxf.read import read
from knifetip.errors import NoSuchUnit
from knifetip.model.unit import MILLIMETRES
from knifetip.units.rescale import rescale
from tests.support.writers.dxf_text import dxf, entity, line

BOX = (line(0, 0, 250, 0), line(250, 0, 250, 180))


def test_unknown_unit_is_refused() -> None:
    with pytest.raises(NoSuchUnit):
        rescale(read(dxf(*BOX)), "furlong")


def test_giving_a_unit_scales_ends_report_and_texts() -> None:
    words = entity("TEXT", (10, 5), (20, 6), (40, 3), (1, "350"))
    silent = read(dxf(*BOX, words, units=None))
    inches = rescale(silent, "in")
    assert_allclose(inches.bounds, [0, 0, 6350, 4572])
    assert_allclose(inches.import_report.length[:2], [6350, 4572])
    assert inches.annotations[0].x == 127.0
    assert_allclose(inches.import_report.location_boxes.box, [[127.0, 152.4, 127.0, 152.4]])
    assert (inches.unit, inches.evidence.code) == ("in", "unit.given")
    assert_array_equal(inches.bulge, silent.bulge)


def test_points_and_pixels_are_units() -> None:
    silent = read(dxf(line(0, 0, 72, 0), line(0, 0, 0, 96), units=None))
    assert_allclose(rescale(silent, "pt").bounds[2], 25.4)
    assert_allclose(rescale(silent, "px").bounds[3], 25.4)


def test_rescaling_equals_reading_in_the_unit() -> None:
    early, late = read(dxf(*BOX), "in"), rescale(read(dxf(*BOX, units=None)), "in")
    assert_array_equal(early.ends, late.ends)
    assert_array_equal(early.import_report.length, late.import_report.length)


def test_correcting_a_unit_starts_from_file_units() -> None:
    wrong = read(dxf(*BOX, units=6))
    assert_allclose(rescale(wrong, "mm").bounds, [0, 0, 250, 180])
    assert_allclose(rescale(wrong, "").bounds, [0, 0, 250, 180])
    assert rescale(wrong, "").unit == ""


@given(x=st.floats(-1e5, 1e5), units=st.lists(st.sampled_from([*MILLIMETRES, ""]), max_size=6))
def test_any_sequence_of_units_is_reversible(x: float, units: list[str]) -> None:
    first = read(dxf(line(x, 0, x + 1.0, 7.0), units=4))
    drawing = first
    for unit in units:
        drawing = rescale(drawing, unit)
    assert_allclose(rescale(drawing, "mm").ends, first.ends, rtol=4e-15, atol=1e-300)


def test_rescaling_from_mm_to_mm_is_exact() -> None:
    drawing = read(dxf(line(0.1, 0.7, 1 / 3, 0.123456789), units=4))
    assert rescale(drawing, "mm").ends.tobytes() == drawing.ends.tobytes()
