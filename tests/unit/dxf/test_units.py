"""The unit and the hints in the header of a DXF file."""

from __future__ import annotations

import pytest
from numpy.testing import assert_array_equal

from knifetip.dxf.read import read
from knifetip.dxf.units import header_unit, hints
from knifetip.errors import NoSuchUnit
from knifetip.messages import Message
from tests.support.writers.dxf_text import dxf, line


@pytest.mark.parametrize(
    ("code", "unit", "millimetres"),
    [(1, "in", 25.4), (2, "ft", 304.8), (4, "mm", 1.0), (5, "cm", 10.0), (6, "m", 1000.0)],
)
def test_header_gives_the_unit(code: int, unit: str, millimetres: float) -> None:
    drawing = read(dxf(line(0, 0, 2, 0), units=code))
    assert (drawing.unit, drawing.stated) == (unit, unit)
    assert drawing.evidence == Message("unit.header", value=code)
    assert_array_equal(drawing.ends[0], [[0, 0], [2 * millimetres, 0]])
    assert drawing.import_report.length[0] == 2 * millimetres


@pytest.mark.parametrize("version", ["AC1006", "AC1009", "AC1015", "AC1027"])
def test_header_without_a_unit_gives_no_unit_in_any_version(version: str) -> None:
    drawing = read(dxf(line(0, 0, 2, 0), units=None, version=version))
    assert (drawing.unit, drawing.evidence.code) == ("", "unit.header-missing")
    assert_array_equal(drawing.ends[0], [[0, 0], [2, 0]])


@pytest.mark.parametrize(
    ("written", "evidence"),
    [
        ("0", "the header of the DXF file states that the drawing has no unit ($INSUNITS = 0)"),
        (
            "9",
            "the header of the DXF file states a unit that is not supported: mils ($INSUNITS = 9)",
        ),
        ("77", "the header of the DXF file states no valid unit: $INSUNITS = 77 is not defined"),
        ("-1", "the header of the DXF file states no valid unit: $INSUNITS = -1 is not defined"),
        ("MM", "the header of the DXF file states no valid unit: $INSUNITS = 'MM' is not a number"),
        (
            "1E999",
            "the header of the DXF file states no valid unit: $INSUNITS = '1E999' is not a number",
        ),
    ],
)
def test_header_with_an_unusable_unit_gives_the_reason(written: str, evidence: str) -> None:
    unit, message = header_unit({"$INSUNITS": written})
    assert (unit, str(message)) == ("", evidence)


def test_unit_of_the_caller_overrides_the_header() -> None:
    drawing = read(dxf(line(0, 0, 2, 0), units=4), "in")
    assert (drawing.unit, drawing.evidence.code, drawing.stated) == ("in", "unit.given", "mm")
    assert_array_equal(drawing.ends[0], [[0, 0], [50.8, 0]])


def test_unknown_unit_is_refused_with_the_known_ones() -> None:
    with pytest.raises(NoSuchUnit, match="mm, cm, m, in, ft, pt, px or px-90"):
        read(dxf(line(0, 0, 2, 0)), "furlong")


@pytest.mark.parametrize(
    ("variables", "expected"),
    [
        ({"$MEASUREMENT": "1"}, ["metric"]),
        ({"$MEASUREMENT": "0"}, ["imperial"]),
        ({"$LUNITS": "4"}, ["inches"]),
        ({"$LUNITS": "2", "$DIMLFAC": "1.0"}, []),
        ({"$DIMLFAC": "25.4"}, ["shown × 25.4"]),
        ({"$DIMALT": "1", "$DIMALTF": "0.03937007874"}, ["shown × 0.03937"]),
        # Most headers have the factor of alternate units, which are switched off.
        ({"$DIMALT": "0", "$DIMALTF": "25.4"}, []),
        ({"$DIMLFAC": "ten", "$MEASUREMENT": "7", "$LUNITS": ""}, []),
    ],
)
def test_other_variables_are_hints(variables: dict[str, str], expected: list[str]) -> None:
    assert [hint.kind for hint in hints(variables)] == expected
