"""Location boxes of DXF entities that produce no geometry, also inside of blocks."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.testing import assert_allclose

from knifetip.dxf.location_boxes import box_of_tags, boxes_of_entities
from knifetip.dxf.read import read
from knifetip.model.drawing import Drawing
from tests.support.truth.readers import difference, fast_reader_accepts, read_by_both
from tests.support.writers.dxf_text import Tag, block, dxf, entity, insert, line

CUT = line(0.0, 0.0, 500.0, 0.0)
#: A boundary from (10, 20) to (40, 60), with an elevation before it and a seed point after it.
HATCH: tuple[Tag, ...] = (
    *((10, 0), (20, 0), (30, 0), (91, 1), (92, 3), (72, 0), (73, 1), (93, 4)),
    *((10, 10), (20, 20), (10, 40), (20, 20), (10, 40), (20, 60), (10, 10), (20, 60)),
    *((97, 0), (75, 0), (76, 1), (98, 1), (10, 900), (20, 900)),
)
SOLID: tuple[Tag, ...] = tuple(
    (code + step, value)
    for step, (x, y) in enumerate([(1, 2), (5, 2), (1, 9), (5, 9)])
    for code, value in ((10, x), (20, y))
)


XY: tuple[Tag, ...] = ((10, 3), (20, 4))


def file_with_markers(*entities: str) -> bytes:
    """Return a file whose entities have subclass markers, as in current DXF versions."""
    head = ((5, "A1"), (100, "AcDbEntity"), (8, "0"), (100, "AcDbLine"))
    return dxf(line(0.0, 0.0, 500.0, 0.0, *head), *entities, version="AC1015")


def boxes_by_kind(drawing: Drawing) -> dict[str, list[float]]:
    """Return the location boxes by entity type; types of entities in blocks start with "/"."""
    rows, boxes = drawing.import_report.location_boxes
    names = [
        ("/" if "/" in handle else "") + kind
        for handle, kind in zip(
            drawing.import_report.handle, drawing.import_report.kind, strict=True
        )
    ]
    return {names[row]: box for row, box in zip(rows.tolist(), boxes.tolist(), strict=True)}


@pytest.mark.parametrize(
    ("kind", "marker", "tags", "box"),
    [
        ("HATCH", "AcDbHatch", HATCH, [10, 20, 40, 60]),
        ("SOLID", "AcDbTrace", SOLID, [1, 2, 5, 9]),
        ("3DFACE", "AcDbFace", SOLID, [1, 2, 5, 9]),
        ("POINT", "AcDbPoint", ((10, 3), (20, 4)), [3, 4, 3, 4]),
        ("IMAGE", "AcDbRasterImage", (*XY, (11, 0.1), (21, 0), (13, 640), (23, 480)), [3, 4, 3, 4]),
        ("RAY", "AcDbRay", (*XY, (11, 1), (21, 0)), [3, 4, 3, 4]),
        ("LEADER", "AcDbLeader", (*XY, (10, 9), (20, 1), (211, 1), (221, 0)), [3, 1, 9, 4]),
        ("TEXT", "AcDbText", (*XY, (40, 2), (11, 50), (21, 50), (1, "Lid")), [3, 4, 3, 4]),
        (
            "DIMENSION",
            "AcDbDimension",
            (*XY, (11, 5), (21, 7), (70, 0), (100, "AcDbAlignedDimension"), (13, 0), (23, 0)),
            [0, 0, 5, 7],
        ),
        (
            "MULTILEADER",
            "AcDbMLeader",
            ((300, "CONTEXT_DATA{"), *XY, (301, "}"), (10, 1), (20, 1)),
            [3, 4, 3, 4],
        ),
    ],
)
def test_the_box_of_each_kind_contains_its_points(
    kind: str, marker: str, tags: tuple[Tag, ...], box: list[float]
) -> None:
    codes, values = zip(*tags, strict=True)
    assert box_of_tags(kind, codes, values).tolist() == box
    data = file_with_markers(entity(kind, (100, "AcDbEntity"), (8, "0"), (100, marker), *tags))
    assert fast_reader_accepts(data)
    assert boxes_by_kind(read(data)) == {kind: box}
    assert difference(*read_by_both(data)) == ""


def test_a_downward_extrusion_mirrors_x() -> None:
    down: tuple[Tag, ...] = ((230, -1),)
    drawing = read(dxf(CUT, entity("SOLID", *SOLID, *down), entity("3DFACE", *SOLID, *down)))
    assert boxes_by_kind(drawing) == {"SOLID": [-5, 2, -1, 9], "3DFACE": [1, 2, 5, 9]}


@pytest.mark.parametrize("cells", [(), ((70, 2), (44, 100))])
def test_entities_of_a_block_are_transformed_by_its_insert(cells: tuple[Tag, ...]) -> None:
    held = block("B", line(0, 0, 1, 0), entity("SOLID", *SOLID), base=(1.0, 2.0))
    # Turned by 90° about its base point, twice as large: x′ = 100 − 2 (y − 2), y′ = 50 + 2 (x − 1).
    placed = insert("B", 100.0, 50.0, (41, 2), (42, 2), (50, 90), *cells)
    data = dxf(CUT, placed, blocks=(held,))
    high = 158.0 if cells else 58.0
    assert_allclose(boxes_by_kind(read(data))["/SOLID"], [86, 50, 100, high], atol=1e-12)
    assert difference(*read_by_both(data)) == ""


def test_each_insert_has_a_row_and_a_box() -> None:
    held = block("B", entity("SOLID", *SOLID), line(0, 0, 1, 0), entity("POINT", (10, 9), (20, 9)))
    data = dxf(*(insert("B", x, 0.0) for x in (0.0, 100.0, 200.0)), blocks=(held,))
    rows, boxes = read(data).import_report.location_boxes
    # Each INSERT is followed by its entities; the second of each three rows is a line.
    assert rows.tolist() == [1, 3, 5, 7, 9, 11]
    assert boxes[:, 0].tolist() == [1, 9, 101, 109, 201, 209]
    assert difference(*read_by_both(data)) == ""


def test_the_box_of_a_polyline_contains_its_vertices() -> None:
    vertices = (entity("VERTEX", (10, x), (20, 5)) for x in (7, 30))
    tilted = entity("POLYLINE", (66, 1), (10, 0), (20, 0), (210, 1), (220, 0), (230, 0))
    data = dxf(CUT, tilted, *vertices, entity("SEQEND"))
    assert boxes_by_kind(read(data)) == {"POLYLINE": [7, 5, 30, 5]}
    assert difference(*read_by_both(data)) == ""


def test_the_box_of_a_line_without_length_is_its_point() -> None:
    assert boxes_by_kind(read(dxf(CUT, line(7.0, 8.0, 7.0, 8.0)))) == {"LINE": [7, 8, 7, 8]}


def test_boxes_are_in_the_unit_of_the_drawing() -> None:
    data = dxf(CUT, entity("POINT", (10, 2), (20, 3)), units=1)
    assert_allclose(boxes_by_kind(read(data))["POINT"], [50.8, 76.2, 50.8, 76.2])
    assert (
        boxes_by_kind(read(dxf(CUT, entity("POINT", (10, 2), (20, 3)), units=None)))["POINT"][0]
        == 2.0
    )


@pytest.mark.parametrize("x", ["nan", "inf", "1e308", "1e12"])
def test_absurd_coordinates_have_no_box(x: str) -> None:
    assert boxes_by_kind(read(dxf(CUT, entity("POINT", (10, x), (20, 3))))) == {}


def test_entities_in_paper_space_have_no_box() -> None:
    assert boxes_by_kind(read(dxf(CUT, entity("POINT", (67, 1), (10, 2), (20, 3))))) == {}


def test_numbers_of_many_digits_are_read_as_python_reads_them() -> None:
    x = "0.1000000000000000055511151231257827"
    data = f"0\nPOINT\n8\n0\n10\n{x}\n20\n5\n".encode()
    found = boxes_of_entities(data, ["POINT"], np.array([0]), np.array([[0, len(data)]]))
    assert found.tolist() == [[0.1, 5.0, 0.1, 5.0]]
