"""The kernel that scans DXF files: supported entities, unusual ones, and files left to ezdxf."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.testing import assert_array_equal

from knifetip.dxf.fast_reader import fields as f
from knifetip.dxf.fast_reader.scan import Scan, scan
from tests.support.writers.dxf_text import block, dxf, entity, insert, layer, line


def _scan(data: bytes) -> Scan:
    found = scan(data)
    assert found is not None
    return found


def test_line_gives_its_four_numbers_and_its_layer() -> None:
    found = _scan(dxf(line(1.5, 2, -3, 4e1, (8, "CUT"))))
    assert found.entity[0, f.KIND] == f.LINE
    assert_array_equal(found.value[0, [f.X, f.Y, f.X2, f.Y2]], [1.5, 2.0, -3.0, 40.0])
    assert found.names[found.entity[0, f.LAYER]] == b"CUT"
    assert found.entity[0, f.UNSUPPORTED] == 0


def test_polyline_gives_its_vertices_with_their_bulges() -> None:
    rows = entity("VERTEX", (10, 0), (20, 0), (42, 0.5)) + entity("VERTEX", (10, 5), (20, 1))
    found = _scan(dxf(entity("POLYLINE", (66, 1), (70, 1)) + rows + entity("SEQEND")))
    assert_array_equal(found.vertex, [[0.0, 0.0, 0.5], [5.0, 1.0, 0.0]])
    assert found.entity[0, [f.FIRST, f.COUNT, f.FLAGS]].tolist() == [0, 2, 1]


def test_entities_of_a_block_name_its_row() -> None:
    found = _scan(dxf(insert("A", 7, 8), blocks=(block("A", line(0, 0, 1, 1), base=(2, 3)),)))
    assert found.entity[:, f.BLOCK].tolist() == [0, -1]
    assert_array_equal(found.base, [[2.0, 3.0]])
    assert found.names[found.entity[1, f.REFERENCE]] == b"A"


def test_layer_table_gives_colour_and_flags() -> None:
    found = _scan(dxf(line(0, 0, 1, 1), layers=(layer("CUT", -3, 1),)))
    assert found.layer[0, [f.LAYER_COLOUR, f.LAYER_FLAGS]].tolist() == [-3, 1]


def test_numbers_of_many_digits_are_read_to_the_last_bit() -> None:
    long = "12.3000000000000007105427357601001858711242675781"
    assert _scan(dxf(line(long, 0, 1, 1))).value[0, f.X] == float(long)


@pytest.mark.parametrize(
    "text",
    [
        line(0, 0, 5, 5, (30, 3.5)),
        entity("LINE", (10, 0), (11, 5), (20, 0), (21, 5)).replace("11\n5\n20\n0\n", "20\n0\n"),
        line(0, 0, 5, 5, (8, "A"), (8, "B")),
        line(0, 0, 5, 5, (60, 1)),
        entity("CIRCLE", (10, 0), (20, 0), (40, 5), (210, 1.0), (220, 0.0), (230, 0.0)),
        entity("SPLINE", (71, 3)),
        entity("POLYLINE", (66, 1), (70, 8))
        + entity("VERTEX", (10, 0), (20, 0))
        + entity("SEQEND"),
    ],
)
def test_unusual_entity_is_odd_and_the_next_is_plain(text: str) -> None:
    found = _scan(dxf(text, line(0, 0, 1, 1)))
    assert found.entity[:, f.UNSUPPORTED].tolist() == [1, 0]


def test_odd_entity_is_found_again_by_its_bytes() -> None:
    data = dxf(line(0, 0, 5, 5, (30, 3.5)), line(0, 0, 1, 1))
    low, high = _scan(data).entity[0, [f.START, f.END]]
    assert data[low:high].startswith(b"0\nLINE\n")
    assert data[high:].startswith(b"0\nLINE\n8\n0\n10\n0\n20\n0\n11\n1\n")


@pytest.mark.parametrize(
    "data",
    [
        b"",
        b"0\nEOF\n",
        b"AutoCAD Binary DXF\r\n\x1a\x00",
        dxf(line(0, 0, 1, 1))[:-4],
        dxf(line(0, 0, 1, 1)).replace(b"\n", b"\r"),
        dxf(line(0, 0, 1, 1)).replace(b"0\nENDSEC\n0\nEOF", b"0\nEOF"),
        dxf(line(0, 0, 1, 1), entity("SEQEND")),
        dxf(entity("POLYLINE", (66, 1)), line(0, 0, 1, 1)),
        dxf(entity("POINT", (10, 1), (40, "abc"))),
        dxf(entity("POINT", (10, 1), (8, "X"), (20, 2))),
        dxf(entity("POINT", (62, "red"))),
        dxf(line("nan", 0, 5, 5)),
        dxf(line(0, 0, 1, 1, (8, " CUT"))),
        dxf(entity("LINE", (102, "{A"), (102, "{B"))),
    ],
)
def test_file_that_is_not_plain_is_left_to_ezdxf(data: bytes) -> None:
    assert scan(data) is None


def test_more_names_than_bytes_allow_are_left_to_ezdxf() -> None:
    assert scan(dxf(*(f"0\nTEXT\n8\n{n}\n" for n in range(100_000)))) is None


def test_each_of_many_names_has_its_own_number() -> None:
    count = 1 << 16
    found = _scan(dxf(*(line(n, 0, n, 1, (8, f"L{n}")) for n in range(count))))
    names = [found.names[number] for number in found.entity[:, f.LAYER].tolist()]
    assert names == [b"L%d" % number for number in range(count)]


def test_silent_values_are_not_numbers() -> None:
    assert np.isnan(_scan(dxf(insert("A"))).value[0, [f.SCALE_X, f.ANGLE]]).all()
