"""Malicious bytes: each file gives a drawing or a clear error, quickly and with little memory."""

from __future__ import annotations

import time
from collections.abc import Sequence

import pytest
from hypothesis import HealthCheck, given
from hypothesis import strategies as st

from knifetip.dxf.read import read
from knifetip.errors import DrawingTooLarge, KnifetipError, NotADrawing
from knifetip.formats.limits import Limits
from tests.support.drawings import report_reasons
from tests.support.examples import examples
from tests.support.truth.readers import difference, fast_reader_accepts, read_by_both
from tests.support.writers.dxf_text import Tag, block, dxf, entity, insert, layer, line

_LINE = line(0, 0, 10, 10)


def _within(seconds: float, data: bytes) -> str:
    """Read a file within a time limit; return the text of the error, "" if it is read."""
    begin = time.process_time()
    problem = ""
    try:
        read(data)
    except KnifetipError as refused:
        problem = str(refused)
    assert time.process_time() - begin < seconds
    return problem


def _spline(knots: Sequence[object], degree: int = 3, points: int = 4) -> bytes:
    control: list[Tag] = []
    for n in range(points):
        control += [(10, n % 7 * 3.3), (20, n % 11 * 2.2), (30, 0)]
    tags: list[Tag] = [(100, "AcDbEntity"), (8, "0"), (100, "AcDbSpline"), (70, 8), (71, degree)]
    tags += [(72, len(knots)), (73, points), *((40, knot) for knot in knots)]
    return dxf(entity("SPLINE", *tags, *control), version="AC1015")


def test_nested_bomb_is_counted_and_not_expanded() -> None:
    rows = [insert(f"B{n + 1}") * 10 for n in range(9)]
    blocks = [block(f"B{n}", row) for n, row in enumerate(rows)] + [block("B9", _LINE)]
    error = _within(1.0, dxf(insert("B0"), blocks=tuple(blocks)))
    assert "2,111,111,110 entities (drawn objects), but the limit is 1,000,000" in error


def test_array_of_a_thousand_million_is_counted_and_not_expanded() -> None:
    grid = insert("A", 0, 0, (70, 32767), (71, 32767), (44, 1.0), (45, 1.0))
    assert "1,073,676,289 entities" in _within(1.0, dxf(grid, blocks=(block("A", _LINE),)))


def test_cyclic_blocks_are_dropped_and_the_rest_is_read() -> None:
    blocks = (block("A", insert("B")), block("B", insert("A"), _LINE))
    drawing = read(dxf(insert("A"), _LINE, blocks=blocks))
    assert report_reasons(drawing)[0] == "the block 'A' inserts itself"
    assert len(drawing) == 1


@pytest.mark.parametrize("value", ["1e308", "-1e308", "1e400", "9e999", "-9e999"])
def test_absurd_coordinates_drop_their_entity_alone(value: str) -> None:
    bad = [line(value, 0, 5, 5), insert("A", value, 0), insert("A", 0, 0, (41, value))]
    bad.append(entity("CIRCLE", (10, 1), (20, 0), (40, value)))
    drawing = read(dxf(*bad, line(0, 0, 3, 4), blocks=(block("A", _LINE),)))
    assert drawing.import_report.length.sum() == pytest.approx(5.0)


@pytest.mark.parametrize(
    "data",
    [
        _spline([0] * 8),
        _spline(["1e999"] * 8),
        _spline([-1e308, 0, 0, 0, 1, 1, 1, 1e308]),
        _spline([0, 1]),
        _spline([0] * 4 + [1] * 4, degree=1000),
        _spline([0] * 4 + [1] * 4, degree=-3),
        _spline([0] * 91 + [1] * 91, degree=90, points=91),
    ],
)
def test_spline_with_absurd_knots_is_dropped(data: bytes) -> None:
    drawing = read(data)
    assert len(drawing) == 0
    assert "damaged" in report_reasons(drawing)[0]


def test_spline_through_twenty_thousand_points_is_not_solved() -> None:
    tags: list[Tag] = [(100, "AcDbEntity"), (8, "0"), (100, "AcDbSpline"), (70, 8), (71, 3)]
    for n in range(20_000):
        tags += [(11, n % 77 * 3.3), (21, n % 11 * 2.2), (31, 0)]
    data = dxf(entity("SPLINE", *tags), version="AC1015")
    assert _within(5.0, data) == ""
    assert "has 20,000 fit points, but the limit is 1,000" in report_reasons(read(data))[0]


def test_half_a_gigabyte_is_refused_before_anything() -> None:
    assert "the limit is 64.0 MB" in _within(0.5, bytes(500 * 10**6))


def test_large_file_for_ezdxf_alone_is_refused() -> None:
    data = dxf(_LINE, entity("SEQEND"))
    with pytest.raises(DrawingTooLarge, match="features that take long to read"):
        read(data, limits=Limits(slow_bytes=len(data) - 1))
    assert len(read(dxf(_LINE), limits=Limits(slow_bytes=10))) == 1


def test_million_entities_are_refused_unread() -> None:
    assert "1,000,000 entities" in _within(20.0, dxf("0\nPOINT\n" * 1_000_000))


def test_file_cut_at_every_byte_is_read_whole_or_refused() -> None:
    whole = dxf(_LINE, insert("A", 20), entity("TEXT", (1, "x")), blocks=(block("A", _LINE),))
    complete = 0
    for size in range(len(whole) - 4):
        try:
            drawing = read(whole[:size])
        except KnifetipError:
            continue
        complete += 1
        # All sections are closed; only the end mark is missing.
        assert whole[size:].replace(b"0\nEOF\n", b"").strip(b"\n0EOF") == b""
        assert len(drawing) == 2
    assert complete == 3


@pytest.mark.parametrize(
    ("data", "word"),
    [
        (b"\x00" * 1000, "empty"),
        (bytes(range(256)) * 100, "binary file"),
        (dxf(_LINE).decode().encode("utf-16-le"), "not a DXF"),
        (b"0\n" * 100_000, "no section"),
        (b"{" * 100_000, "a JSON file"),
    ],
)
def test_files_that_are_no_dxf_are_refused(data: bytes, word: str) -> None:
    with pytest.raises(NotADrawing, match=word):
        read(data)


def test_lone_carriage_returns_end_lines_too() -> None:
    assert len(read(dxf(_LINE).replace(b"\n", b"\r"))) == 1


def test_polyline_and_spline_without_markers_are_read() -> None:
    polyline = entity("LWPOLYLINE", (90, 2), (70, 0), (10, 0), (20, 0), (10, 30), (20, 40))
    spline = entity(
        "SPLINE", (70, 8), (71, 3), (72, 8), (73, 4), *((40, k) for k in [0] * 4 + [1] * 4)
    )
    spline += "".join(f"10\n0\n20\n{y}\n30\n0\n" for y in (0, 3, 6, 10))
    data = dxf(polyline, spline, version="AC1009")
    assert fast_reader_accepts(data)
    drawings = read_by_both(data)
    assert difference(*drawings) == ""
    assert read(data).import_report.length.tolist() == pytest.approx([50.0, 10.0])
    headless = data[data.index(b"0\nSECTION\n2\nENTITIES") :]
    assert read(headless).import_report.length.tolist() == pytest.approx([50.0, 10.0])


_WHOLE = dxf(
    _LINE,
    insert("A", 5, 5, (50, 30.0)),
    entity("POLYLINE", (66, 1), (70, 1)),
    entity("VERTEX", (10, 0), (20, 0)),
    entity("VERTEX", (10, 5), (20, 0), (42, 0.5)),
    entity("SEQEND"),
    entity("TEXT", (10, 1), (20, 2), (40, 3), (1, "250 mm")),
    blocks=(block("A", _LINE, entity("ARC", (10, 0), (20, 0), (40, 2), (50, 0), (51, 91))),),
)
#: Like ``_WHOLE``, with a handle in every record.
_HANDLED = (
    dxf(
        line(0, 0, 10, 10, (5, "10")),
        entity("POLYLINE", (5, "11"), (66, 1)),
        entity("VERTEX", (5, "12"), (10, 0), (20, 0)),
        entity("VERTEX", (5, "13"), (10, 5), (20, 0)),
        entity("SEQEND", (5, "14")),
        insert("A", 20, 0, (5, "15")),
        blocks=(
            block("A", line(0, 0, 3, 0, (5, "16"), (6, "DASHED")))
            .replace("0\nENDBLK\n", "0\nENDBLK\n5\n17\n")
            .replace("0\nBLOCK\n", "0\nBLOCK\n5\n18\n"),
        ),
        layers=(layer("CUT").replace("2\nCUT", "5\n19\n2\nCUT"),),
    )
    .replace(b"2\nLAYER\n", b"2\nLAYER\n5\n1A\n")
    .replace(
        b"0\nENDTAB\n",
        b"0\nENDTAB\n0\nTABLE\n2\nDIMSTYLE\n5\n1B\n70\n1\n0\nDIMSTYLE\n105\n1C\n"
        b"2\nISO\n5\nnone\n0\nENDTAB\n",
    )
    .replace(
        b"0\nEOF\n",
        b"0\nSECTION\n2\nOBJECTS\n0\nDICTIONARY\n5\n1D\n0\nENDSEC\n0\nEOF\n",
    )
)


def test_file_in_which_every_part_has_a_handle_is_plain() -> None:
    assert fast_reader_accepts(_HANDLED)
    assert difference(*read_by_both(_HANDLED)) == ""


@pytest.mark.parametrize(("last", "plain"), [("A", False), ("B", True)])
def test_handles_with_distant_values_are_distinguished(last: str, plain: bool) -> None:
    handles = ("FFFFFFFFA", "2", "5000", f"FFFFFFFF{last}")
    data = dxf(*(line(x, 0, x, 5, (5, handle)) for x, handle in enumerate(handles)))
    assert fast_reader_accepts(data) == plain
    assert difference(*read_by_both(data)) == ""


@pytest.mark.parametrize("number", range(0x10, 0x1E), ids="{:X}".format)
@pytest.mark.parametrize("other", ["10C&", "0", "19", "12345678901234567890", ""])
def test_invalid_and_repeated_handles_are_left_to_ezdxf(number: int, other: str) -> None:
    handle = f"{number:X}"
    if handle == other:
        return
    code = b"105" if handle == "1C" else b"5"
    before = b"\n%b\n%b\n" % (code, handle.encode())
    assert _HANDLED.count(before) == 1
    data = _HANDLED.replace(before, b"\n%b\n%b\n" % (code, other.encode()))
    assert not fast_reader_accepts(data)
    assert difference(*read_by_both(data)) == ""


@pytest.mark.parametrize(
    ("before", "after"),
    [
        (b"2\nCUT\n", b""),
        (b"2\nDIMSTYLE\n", b"2\nDIMSTYLES\n"),
        (b"2\nLAYER\n", b""),
        (b"2\nLAYER\n", b"2\nLTYPE\n"),
        (b"0\nTABLE\n2\nLAYER\n", b""),
        (b"0\nENDTAB\n0\nTABLE\n", b"0\nTABLE\n"),
        (b"0\nENDTAB\n0\nENDSEC\n", b"0\nENDSEC\n"),
    ],
)
def test_table_that_is_unusual_is_left_to_ezdxf(before: bytes, after: bytes) -> None:
    data = _HANDLED.replace(before, after, 1)
    assert data != _HANDLED
    assert not fast_reader_accepts(data)
    assert difference(*read_by_both(data)) == ""


_SCRAPS: tuple[bytes, ...] = (
    b"0\n",
    b"\n",
    b" ",
    b"10\n5\n",
    b"8\nCUT\n",
    b"62\n300\n",
    b"0\nLINE\n",
    b"1e308",
)
_SCRAPS += (b"0\nSEQEND\n", b"100\nAcDbLine\n", b"230\n-1\n", b"67\n1\n", b"nan", b"\x00", b"\xff")


@st.composite
def _damaged(draw: st.DrawFn) -> bytes:
    data = bytearray(draw(st.sampled_from((_WHOLE, _HANDLED))))
    for _ in range(draw(st.integers(1, 3))):
        at = draw(st.integers(0, len(data) - 1))
        how = draw(st.integers(0, 3))
        if how == 0:
            data[at] = draw(st.integers(0, 255))
        elif how == 1:
            del data[at : at + draw(st.integers(1, 12))]
        elif how == 2:
            data[at:at] = draw(st.sampled_from(_SCRAPS))
        else:
            lines = bytes(data).split(b"\n")
            tag = 2 * draw(st.integers(0, max(len(lines) // 2 - 1, 0)))
            again = lines[tag : tag + 2]
            lines[tag : tag + 2] = again * draw(st.sampled_from((0, 2)))
            data = bytearray(b"\n".join(lines) or b"\n")
    return bytes(data)


@examples(250, suppress_health_check=list(HealthCheck))
@given(_damaged())
def test_damage_ends_in_a_drawing_or_a_refusal_the_same_for_both_readers(data: bytes) -> None:
    ours, reference = read_by_both(data)
    if isinstance(ours, KnifetipError) or isinstance(reference, KnifetipError):
        assert str(ours) == str(reference)
    else:
        assert difference(ours, reference) == ""


def test_more_layers_than_fifteen_bits_keep_their_edges() -> None:
    count = (1 << 15) + 100
    drawing = read(dxf(*(line(n, 0, n, 1, (8, f"L{n}")) for n in range(count))), "mm")
    assert drawing.layers == tuple(f"L{n}" for n in range(count))
    assert drawing.layer.tolist() == list(range(count))
