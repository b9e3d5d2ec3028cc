"""R12 knows neither LWPOLYLINE nor SPLINE nor subclass markers, and programs write all of them."""

from __future__ import annotations

import numpy as np
import pytest

from knifetip.dxf.markers import with_markers
from knifetip.model.drawing import Drawing
from readers import difference, read_by_both

LWPOLYLINE = (
    "0\nLWPOLYLINE\n5\nA1\n{entity}8\nCUT\n62\n3\n{own}90\n3\n70\n1\n"
    "10\n0\n20\n0\n10\n5\n20\n0\n10\n5\n20\n7\n1001\nOTHERS\n1070\n1\n"
)
SPLINE = (
    "0\nSPLINE\n5\nA2\n{entity}8\nCUT\n62\n3\n67\n{paper}\n{own}70\n8\n71\n2\n72\n6\n73\n3\n"
    "40\n0\n40\n0\n40\n0\n40\n1\n40\n1\n40\n1\n10\n0\n20\n0\n10\n5\n20\n0\n10\n5\n20\n7\n"
)


def drawing(version: str, entity: str) -> bytes:
    header = f"0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\n{version}\n0\nENDSEC\n"
    return f"{header}0\nSECTION\n2\nENTITIES\n{entity}0\nENDSEC\n0\nEOF\n".encode()


def read_alike(data: bytes) -> Drawing:
    ours, judged = read_by_both(data)
    assert difference(ours, judged) == ""
    assert isinstance(ours, Drawing)
    return ours


def marked(entity: str, marker: str, marks: bool, **said: int) -> str:
    return entity.format(
        entity="100\nAcDbEntity\n" if marks else "", own=f"100\n{marker}\n" if marks else "", **said
    )


@pytest.mark.parametrize("marks", [True, False])
@pytest.mark.parametrize("version", ["AC1006", "AC1009", "AC1015"])
def test_a_closed_lwpolyline_of_any_version_is_closed_and_on_its_layer(version: str, marks: bool):
    found = read_alike(drawing(version, marked(LWPOLYLINE, "AcDbPolyline", marks)))
    assert found.ends[:, 0].tolist() == [[0, 0], [5, 0], [5, 7]]
    assert found.layers == ("CUT",)
    assert found.colour.tolist() == [3, 3, 3]


@pytest.mark.parametrize("marks", [True, False])
@pytest.mark.parametrize("version", ["AC1009", "AC1015"])
def test_a_spline_of_any_version_has_its_degree_and_its_layer(version: str, marks: bool):
    found = read_alike(drawing(version, marked(SPLINE, "AcDbSpline", marks, paper=0)))
    # Every point of this parabola is (10 t - 5 t², 7 t²).
    x, y = found.ends[:, 1].T
    t = np.sqrt(y / 7.0)
    assert x == pytest.approx(10.0 * t - 5.0 * t**2, abs=1e-4)
    assert found.layers == ("CUT",)


@pytest.mark.parametrize("marks", [True, False])
def test_a_spline_of_r12_in_paper_space_stays_there(marks: bool):
    found = read_alike(drawing("AC1009", marked(SPLINE, "AcDbSpline", marks, paper=1)))
    assert len(found) == 0
    assert found.ledger.reason == ("it stands in paper space",)


def test_markers_stand_before_what_other_programs_added():
    lines = b"0\nSPLINE\n8\nCUT\n102\n{X\n70\n5\n102\n}\n70\n8\n1001\nX\n1070\n1\n0\nEOF\n"
    assert (
        with_markers(lines).split()
        == (
            b"0 SPLINE 8 CUT 102 {X 70 5 102 } 70 8 100 AcDbEntity 100 AcDbSpline 70 8 "
            b"1001 X 1070 1 0 EOF"
        ).split()
    )
