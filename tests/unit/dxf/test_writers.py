"""Programs that write DXF files in mm are recognised, and are evidence for mm."""

from __future__ import annotations

import pytest

from knifetip.dxf.read import read
from knifetip.dxf.writers import writer_hints
from knifetip.units import weights
from knifetip.units.evidence import find_unit
from tests.support.writers.dxf_text import dxf, line

PSTOEDIT = {
    "$ACADVER": "AC1009",
    "$FILLMODE": "0",
    "$SPLFRAME": "1",
    "$EXTMIN": "0",
    "$EXTMAX": "1058.33",
}
INKSCAPE = {"$INSUNITS": "4", "$ACADVER": "AC1014", "$HANDSEED": "FFFF"}


@pytest.mark.parametrize(
    ("variables", "kinds"),
    [
        # 3000 pt are 3000 / 72 × 25.4 = 1058.33 mm.
        (PSTOEDIT, ["written in mm"]),
        (PSTOEDIT | {"$EXTMAX": "3000"}, []),
        (PSTOEDIT | {"$EXTMAX": "1058.4"}, []),
        (PSTOEDIT | {"$EXTMAX": "wide"}, []),
        (PSTOEDIT | {"$LUNITS": "2"}, []),
        (INKSCAPE, ["written in mm"]),
        (INKSCAPE | {"$INSUNITS": "1"}, []),
        (INKSCAPE | {"$MEASUREMENT": "1"}, []),
        ({}, []),
    ],
)
def test_headers_of_programs_that_write_mm(variables: dict[str, str], kinds: list[str]) -> None:
    assert [hint.kind for hint in writer_hints(b"0\nSECTION\n", variables)] == kinds


@pytest.mark.parametrize(
    ("head", "kinds"),
    [
        (b"999\nDXF created by Inkscape\n0\nSECTION\n", ["written in mm"]),
        (b"  999\r\nDXF created by Inkscape\r\n  0\r\nSECTION\r\n", ["written in mm"]),
        (b"999\nDXF from OpenSCAD\n0\nSECTION\n", ["modelled in mm"]),
        (b"999\nDXF from OpenSCADDER\n0\nSECTION\n", []),
        (b"999\ndxfrw 0.6.3\n0\nSECTION\n", []),
        (b"0\nSECTION\n999\nDXF from OpenSCAD\n", []),
    ],
)
def test_comments_of_programs_that_write_mm(head: bytes, kinds: list[str]) -> None:
    assert [hint.kind for hint in writer_hints(head, {})] == kinds


def test_the_program_is_evidence_for_mm_with_its_own_weight() -> None:
    plain = dxf(line(0, 0, 90, 0), line(90, 0, 90, 40), line(90, 40, 0, 0), units=None)
    by_inkscape = find_unit(read(b"999\nDXF created by Inkscape\n" + plain))
    (evidence,) = [one for one in by_inkscape.evidence if one.message.code == "unit.writer"]
    assert (evidence.unit, evidence.weight) == ("mm", weights.HINTS["written in mm"][1])
    assert str(evidence.message) == "the file was written by Inkscape, which writes lengths in mm"
    assert not [one for one in find_unit(read(plain)).evidence if one.message.code == "unit.writer"]
