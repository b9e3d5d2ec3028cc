"""A file with a number that is not a number is refused with its line, and is not cut off."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from knifetip.dxf.read import read
from knifetip.errors import NotADrawing
from knifetip.model.drawing import Drawing
from tests.support.writers.dxf_text import Tag, block, dxf, entity, insert, layer, line, tags

BAD = (
    *("160,875", "1,200.5", "160.8.75", "-1.#IND", "1.#QNAN", "16O.875", "1.5D+02", "1_000"),
    *("", "nan", "inf", "0x10", "５", "--5", "1e", "5 mm"),
)

Make = Callable[[str], str]


def point(code: int, x: object, y: object) -> tuple[Tag, Tag]:
    return (code, x), (code + 10, y)


def chain(*vertices: str, height: object = 0) -> str:
    head = entity("POLYLINE", (66, 1), *point(10, 0, 0), (30, height), (70, 0))
    return head + "".join(vertices) + entity("SEQEND")


VALUES: dict[str, Make] = {
    "line": lambda bad: line(0, 0, bad, 5),
    "height of a line": lambda bad: line(0, 0, 5, 5, (30, bad)),
    "radius of a circle": lambda bad: entity("CIRCLE", *point(10, 0, 0), (40, bad)),
    "angle": lambda bad: entity("ARC", *point(10, 0, 0), (40, 3), (50, bad), (51, 10)),
    "bulge": lambda bad: entity(
        "LWPOLYLINE", (90, 2), (70, 0), *point(10, 0, 0), (42, bad), *point(10, 5, 0)
    ),
    "vertex": lambda bad: chain(
        entity("VERTEX", *point(10, 0, 0)), entity("VERTEX", *point(10, bad, 5))
    ),
    "vertex after extension data": lambda bad: (
        entity("POLYLINE", (66, 1), *point(10, 0, 0), (70, 0), (1001, "OTHER"), (1040, 2.5))
        + entity("VERTEX", *point(10, bad, 5))
        + entity("VERTEX", *point(10, 9, 5))
        + entity("SEQEND")
    ),
    "flag": lambda bad: entity(
        "LWPOLYLINE", (90, 2), (70, bad), *point(10, 0, 0), *point(10, 5, 0)
    ),
    "axis of an ellipse": lambda bad: entity(
        "ELLIPSE", *point(10, 0, 0), *point(11, bad, 0), (40, 0.5)
    ),
    "scale of an INSERT": lambda bad: insert("A", 0, 0, (41, bad)),
    "extrusion": lambda bad: entity("CIRCLE", *point(10, 0, 0), (40, 3), (230, bad)),
}


def file(*entities: str, version: str = "AC1015") -> bytes:
    return dxf(
        line(0, 0, 100, 0), *entities, blocks=(block("A", line(0, 0, 1, 0)),), version=version
    )


def refusal(data: bytes) -> tuple[str, dict[str, object], str]:
    """Return code, arguments and text of the error for a file that is refused."""
    with pytest.raises(NotADrawing) as refused:
        read(data)
    message = refused.value.message
    return message.code, dict(message.arguments), str(refused.value)


def line_of(data: bytes, value: str) -> int:
    """Return the number of the only line with this value."""
    lines = data.decode().split("\n")
    (index,) = [index for index, text in enumerate(lines) if text == value]
    return index + 1


@pytest.mark.parametrize("version", ["AC1009", "AC1015"])
@pytest.mark.parametrize("make", VALUES.values(), ids=list(VALUES))
def test_a_value_that_is_no_number_is_refused_with_its_line(make: Make, version: str) -> None:
    data = file(make("12,5x"), version=version)
    code, arguments, _ = refusal(data)
    assert code == "dxf.not-a-number"
    assert arguments["line"] == line_of(data, "12,5x")
    assert arguments["text"] == "12,5x"


@pytest.mark.parametrize("bad", BAD)
def test_no_spelling_of_a_number_is_cut_off(bad: str) -> None:
    assert "is not a number" in refusal(file(line(0, 0, bad, 5)))[2]


@pytest.mark.parametrize("good", ["+5", "5.", ".5", "5E0", "5e-1", " 5 ", "\t5", "0005", "1e-400"])
def test_other_spellings_of_numbers_are_read(good: str) -> None:
    # ezdxf reads the file, because the fast reader does not support a damaged point.
    drawing = read(file(line(0, 0, 1, good), entity("POINT", *point(10, "x", 5))))
    assert drawing.ends[1, 1, 1] == float(good)


def test_an_integer_may_be_written_as_a_decimal_number() -> None:
    polyline = entity(
        "LWPOLYLINE", (90, "3.0"), (70, "1.0"), *point(10, 0, 0), *point(10, 5, 0), *point(10, 5, 5)
    )
    assert len(read(file(polyline))) == 4


@pytest.mark.parametrize(
    "harmless",
    [
        entity("TEXT", *point(10, "1,5", 0), (40, "5,0"), (1, "250,5 mm")),
        entity("POINT", *point(10, "1,5", 0)),
        entity("HATCH", *point(10, "-1.#IND", 0)),
        entity("DIMENSION", *point(10, "1,5", 0), (42, "1,5")),
        tags((999, "a comment, 1,5")),
        line(0, 5, 100, 5) + tags((1001, "OTHER"), (1040, "1,5")),
    ],
)
def test_a_damaged_value_of_which_no_edge_is_made_does_no_harm(harmless: str) -> None:
    drawing = read(file(harmless, line(0, 1, 50, 1)))
    assert isinstance(drawing, Drawing)
    assert 50.0 in drawing.lengths.tolist()


def test_a_damaged_value_in_a_block_is_refused() -> None:
    data = dxf(insert("A"), blocks=(block("A", line(0, 0, "1,5", 0)),))
    assert refusal(data)[1]["line"] == line_of(data, "1,5")


def test_a_damaged_base_point_of_a_block_is_refused() -> None:
    data = dxf(insert("A"), blocks=(block("A", line(0, 0, 1, 0)),))
    data = data.replace(b"2\nA\n70\n0\n10\n0.0\n", b"2\nA\n70\n0\n10\n0,1\n")
    assert refusal(data)[1] == {
        "line": line_of(data, "0,1"), "code": 10, "kind": "BLOCK", "text": "0,1",
    }  # fmt: skip


def test_a_damaged_layer_which_may_be_hidden_is_refused() -> None:
    data = dxf(line(0, 0, 1, 0), layers=(layer("CUT").replace("70\n0", "70\n0,1"),))
    assert refusal(data)[1]["kind"] == "LAYER"
    assert refusal(data)[1]["line"] == line_of(data, "0,1")


def test_blank_lines_before_the_content_count_as_lines() -> None:
    data = b"\n\r\n\n" + file(line(0, 0, "1,5", 0))
    assert refusal(data)[1]["line"] == line_of(data.replace(b"\r", b""), "1,5")


@pytest.mark.parametrize(
    ("damaged", "line_after_start"),
    [
        # The lines of code 8 and its value, then those of the other tags.
        (entity("LWPOLYLINE", (70, 0), *point(10, 0, 0), (10, 5), *point(10, 9, 9)), 11),
        (entity("LWPOLYLINE", (70, 0), *point(10, 0, 0), (20, 5), *point(10, 9, 9)), 11),
        (entity("LWPOLYLINE", (70, 0), *point(10, 0, 0), (10, 5)), 11),
        (entity("SPLINE", (70, 8), (71, 3), *point(11, 0, 0), (11, 5), *point(11, 9, 9)), 13),
    ],
)
def test_a_vertex_with_one_coordinate_is_refused(damaged: str, line_after_start: int) -> None:
    data = file(damaged)
    start = data.decode()[: data.decode().index(damaged)].count("\n")
    code, arguments, _ = refusal(data)
    assert code == "dxf.coordinate-alone"
    assert arguments["line"] == start + line_after_start


def test_a_comment_between_two_coordinates_does_no_harm() -> None:
    polyline = entity(
        "LWPOLYLINE", (70, 0), (10, 0), (999, "c"), (20, 0), *point(10, 5, 0), (38, 4)
    )
    assert len(read(file(polyline))) == 2


def test_an_insert_without_a_position_is_not_placed_at_the_origin() -> None:
    drawing = read(file(entity("INSERT", (2, "A"), (10, 5))))
    assert len(drawing) == 1
    assert drawing.import_report.reason[1].code == "import.incomplete"
