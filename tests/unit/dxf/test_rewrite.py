"""Files that ezdxf alone would refuse: missing markers, and hatches or images that it cannot
read.
"""

from __future__ import annotations

import io

import ezdxf
import numpy as np
import pytest
from ezdxf.lldxf.const import DXFError

from knifetip.dxf.ezdxf_reader.rewrite import lines_only, with_markers
from knifetip.model.drawing import Drawing
from tests.support.drawings import report_reasons
from tests.support.truth.readers import difference, read_by_both, reading

LINE = "0\nLINE\n5\nA0\n8\nCUT\n10\n0\n20\n0\n11\n5\n21\n0\n"
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
    ours, reference = read_by_both(data)
    assert difference(ours, reference) == ""
    assert isinstance(ours, Drawing)
    return ours


def entity_text(entity: str, marker: str, marks: bool, **values: int) -> str:
    return entity.format(
        entity="100\nAcDbEntity\n" if marks else "",
        own=f"100\n{marker}\n" if marks else "",
        **values,
    )


@pytest.mark.parametrize("marks", [True, False])
@pytest.mark.parametrize("version", ["AC1006", "AC1009", "AC1015"])
def test_a_closed_lwpolyline_of_any_version_is_closed_and_on_its_layer(
    version: str, marks: bool
) -> None:
    found = read_alike(drawing(version, entity_text(LWPOLYLINE, "AcDbPolyline", marks)))
    assert found.ends[:, 0].tolist() == [[0, 0], [5, 0], [5, 7]]
    assert found.layers == ("CUT",)
    assert found.colour.tolist() == [3, 3, 3]


@pytest.mark.parametrize("marks", [True, False])
@pytest.mark.parametrize("version", ["AC1009", "AC1015"])
def test_a_spline_of_any_version_has_its_degree_and_its_layer(version: str, marks: bool) -> None:
    found = read_alike(drawing(version, entity_text(SPLINE, "AcDbSpline", marks, paper=0)))
    # Every point of this parabola is (10 t - 5 t², 7 t²).
    x, y = found.ends[:, 1].T
    t = np.sqrt(y / 7.0)
    assert x == pytest.approx(10.0 * t - 5.0 * t**2, abs=1e-4)
    assert found.layers == ("CUT",)


@pytest.mark.parametrize("marks", [True, False])
def test_a_spline_of_r12_in_paper_space_stays_there(marks: bool) -> None:
    found = read_alike(drawing("AC1009", entity_text(SPLINE, "AcDbSpline", marks, paper=1)))
    assert len(found) == 0
    assert report_reasons(found) == ("the object is in a layout (paper space), not in the model",)


def test_markers_come_before_data_of_other_programs() -> None:
    lines = b"0\nSPLINE\n8\nCUT\n102\n{X\n70\n5\n102\n}\n70\n8\n1001\nX\n1070\n1\n0\nEOF\n"
    assert (
        with_markers(lines).split()
        == (
            b"0 SPLINE 8 CUT 102 {X 70 5 102 } 70 8 100 AcDbEntity 100 AcDbSpline 70 8 "
            b"1001 X 1070 1 0 EOF"
        ).split()
    )


#: Data of each kind that ezdxf cannot read, in R12 and in files without markers.
UNREADABLE = {
    "HATCH": "2\nSOLID\n70\n1\n71\n0\n91\n1\n92\n1\n93\n1\n72\n1\n10\n0\n20\n0\n11\n9\n21\n0\n",
    "IMAGE": "90\n0\n10\n0\n20\n0\n11\n1\n21\n0\n12\n0\n22\n1\n13\n10\n23\n10\n340\n0\n70\n7\n",
    "LEADER": "3\nSTANDARD\n71\n1\n72\n0\n76\n2\n10\n0\n20\n0\n10\n5\n20\n5\n",
    "MTEXT": "10\n0\n20\n0\n40\n5\n71\n1\n1\nglue\n",
    "REGION": "70\n1\n1\nabc\n",
    "VIEWPORT": "10\n0\n20\n0\n40\n5\n41\n5\n68\n1\n69\n1\n",
    "PDFUNDERLAY": "340\n0\n10\n0\n20\n0\n",
}


_PICTURE = "the object is an underlay (an inserted picture or PDF page), which is not cut"
REASONS = {
    "HATCH": "the object is a hatch (filled area), whose boundary is not read",
    "IMAGE": _PICTURE,
    "LEADER": "the object is a dimension or a note, which is not cut",
    "MTEXT": "the object is a text, which is not cut",
    "REGION": "the object is a region, which cannot be read",
    "VIEWPORT": "the object is a viewport, which only displays a part of the drawing",
    "PDFUNDERLAY": _PICTURE,
}


def unreadable(kind: str) -> str:
    return f"0\n{kind}\n5\nB1\n8\nNOTES\n{UNREADABLE[kind]}"


@pytest.mark.parametrize("version", ["AC1006", "AC1009", "AC1015"])
@pytest.mark.parametrize("kind", UNREADABLE)
def test_an_unreadable_entity_does_not_affect_lines(kind: str, version: str) -> None:
    data = drawing(version, LINE + unreadable(kind))
    with pytest.raises((DXFError, LookupError, AttributeError)):
        ezdxf.read(io.StringIO(data.decode()))  # otherwise the test would prove nothing
    found = read_alike(data)
    assert found.ends.tolist() == [[[0, 0], [5, 0]]]
    assert found.import_report.kind == ("LINE", kind)
    assert report_reasons(found)[1] == REASONS[kind]


@pytest.mark.parametrize("kind", UNREADABLE)
def test_an_unreadable_entity_in_a_block_does_not_affect_lines(kind: str) -> None:
    block = f"0\nBLOCK\n8\n0\n2\nB\n70\n0\n10\n0\n20\n0\n{LINE}{unreadable(kind)}0\nENDBLK\n8\n0\n"
    insert = "0\nINSERT\n8\nCUT\n2\nB\n10\n7\n20\n0\n"
    blocks = f"0\nSECTION\n2\nBLOCKS\n{block}0\nENDSEC\n"
    found = read_alike(blocks.encode() + drawing("AC1009", insert))
    assert found.ends.tolist() == [[[7, 0], [12, 0]]]
    assert found.import_report.kind == ("INSERT", "LINE", kind)


def test_an_unreadable_entity_in_a_binary_drawing_does_not_affect_lines() -> None:
    document = ezdxf.new("R2000")
    document.modelspace().add_line((0, 0), (5, 0))
    document.modelspace().add_point((1, 1))
    stream = io.BytesIO()
    document.write(stream, fmt="bin")
    # The point becomes an entity that ezdxf reads as an image without size.
    found = reading.read(stream.getvalue().replace(b"POINT\0", b"IMAGE\0"), "mm")
    assert found.ends.tolist() == [[[0, 0], [5, 0]]]
    assert found.import_report.kind == ("LINE", "IMAGE")


def test_a_polyline_with_only_its_first_marker_is_read() -> None:
    found = read_alike(drawing("AC1015", LWPOLYLINE.format(entity="100\nAcDbEntity\n", own="")))
    assert found.ends[:, 0].tolist() == [[0, 0], [5, 0], [5, 7]]


@pytest.mark.parametrize("ratio", ["0", "1e-9", "-1e-9", "0.5", "2", "1000000"])
def test_an_ellipse_corrected_by_ezdxf_is_read_alike(ratio: str) -> None:
    ellipse = (
        "0\nELLIPSE\n5\nC1\n100\nAcDbEntity\n8\nCUT\n100\nAcDbEllipse\n10\n0\n20\n0\n"
        f"11\n5\n21\n0\n40\n{ratio}\n41\n0\n42\n6.28\n"
    )
    # Without a version ezdxf assumes R12, fails at the markers, and recovers the file.
    image = f"0\nIMAGE\n5\nB1\n100\nAcDbEntity\n8\nX\n100\nAcDbRasterImage\n{UNREADABLE['IMAGE']}"
    data = f"0\nSECTION\n2\nENTITIES\n{LINE}{ellipse}{image}0\nENDSEC\n0\nEOF\n"
    assert len(read_alike(data.encode()).ends) > 1


def test_other_records_are_not_changed() -> None:
    tables = "0\nSECTION\n2\nTABLES\n0\nTABLE\n2\nLAYER\n0\nLAYER\n2\nCUT\n0\nENDTAB\n0\nENDSEC\n"
    data = tables.encode() + drawing("AC1015", LINE)
    assert lines_only(data) == data
    assert lines_only(data.replace(b"LINE", b"HELIX", 1)) == tables.encode() + drawing("AC1015", "")
