"""A large file is scanned in parts by several cores; the result equals that of one part."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from importlib import import_module

import numpy as np
import pytest
from hypothesis import HealthCheck, given

from knifetip.dxf.fast_reader import fields as f
from knifetip.errors import KnifetipError
from knifetip.model.drawing import Drawing
from tests.support.examples import examples
from tests.support.truth.readers import difference, reading
from tests.support.writers.dxf_text import block, dxf, entity, insert, layer, line
from tests.support.writers.random_dxf import drawings

scan = import_module("knifetip.dxf.fast_reader.scan")

_CHAIN = entity("POLYLINE", (66, 1), (70, 1)) + "".join(
    entity("VERTEX", (10, x), (20, x * x), (42, 0.25 * x)) for x in range(3)
)
_SHEET = [
    line(0, 0, 1.25, 1, (8, "CUT"), (5, "1A")),
    insert("A", 20, 5, (50, 30.0), (8, "CREASE")),
    _CHAIN + entity("SEQEND"),
    entity("LWPOLYLINE", (90, 2), (70, 0), (10, 0), (20, 0), (42, -0.5), (10, 3), (20, 4)),
    entity("TEXT", (10, 1), (20, 2), (40, 3), (1, "250 mm"), (8, "NOTES")),
    entity("ARC", (10, 0), (20, 0), (40, 5), (50, 0), (51, 90), (6, "DASHED"), (5, "1B")),
    # A number with more digits than the kernel can parse.
    line("0.30000000000000004440892098500626", 0, 1, 7, (8, "LATE")),
]
_WHOLE = dxf(
    *_SHEET * 1,
    *[line(x, 0, x, 9, (8, f"L{x % 4}")) for x in range(40)],
    _CHAIN + entity("SEQEND"),
    blocks=(block("A", line(0, 0, 5, 0)),),
    layers=(layer("CUT", 1), layer("NOTES", 2)),
    version="AC1015",
)


SetParts = Callable[[int], None]


@pytest.fixture
def set_parts(monkeypatch: pytest.MonkeyPatch) -> SetParts:
    """Return a function that sets the number of cores, with parts of at least 300 bytes."""

    def cores(number: int) -> None:
        monkeypatch.setattr(scan, "_PART", 300)
        monkeypatch.setattr(scan, "core_count", lambda: number)

    return cores


def _drawing(data: bytes) -> Drawing | KnifetipError:
    found: Drawing | KnifetipError
    try:
        found = reading.read(data)
    except KnifetipError as refused:
        found = refused
    return found


@pytest.mark.parametrize("number", [2, 3, 7, 40])
def test_several_parts_give_the_result_of_one(set_parts: SetParts, number: int) -> None:
    set_parts(1)
    assert scan._split_positions(_WHOLE) == []
    one, before = scan.scan(_WHOLE), _drawing(_WHOLE)
    set_parts(number)
    cuts = scan._split_positions(_WHOLE)
    assert len(cuts) >= min(number - 1, 5)
    assert scan._scan_parts(_WHOLE, [0, *cuts, len(_WHOLE)], 5000).supported
    many = scan.scan(_WHOLE)
    np.testing.assert_array_equal(one.vertex, many.vertex)
    np.testing.assert_array_equal(one.others, many.others)
    named = (f.WORD, f.LAYER, f.LINETYPE, f.REFERENCE)
    others = [column for column in range(f.WIDTH) if column not in named]
    np.testing.assert_array_equal(one.entity[:, others], many.entity[:, others])
    for column in named:
        numbers = many.entity[:, column]
        names = [many.names[row] if row >= 0 else b"" for row in numbers]
        numbers = one.entity[:, column]
        assert names == [one.names[row] if row >= 0 else b"" for row in numbers]
    assert difference(before, _drawing(_WHOLE)) == ""


def test_a_part_that_ends_in_another_section_is_not_supported(set_parts: SetParts) -> None:
    # Most of the file is in blocks or after the section ENTITIES.
    lines = [line(0, 0, x, 1) for x in range(60)]
    long = dxf(insert("A"), blocks=(block("A", *lines),))
    set_parts(1)
    before = _drawing(long)
    set_parts(4)
    assert not scan._scan_parts(long, [0, *_before_lines(long), len(long)], 5000).supported
    assert difference(before, _drawing(long)) == ""


def _before_lines(data: bytes) -> list[int]:
    return [data.index(b"0\nLINE\n", len(data) // 2)]


@pytest.mark.parametrize(
    "broken",
    [
        # At a cut: the x of a point without its y, and an open {… group.
        "0\nLINE\n8\n0\n10\n5\n",
        "0\nLINE\n8\n0\n102\n{ACAD\n",
        "0\nLINE\n8\n0\n10\n5\n20\n",
        _CHAIN,
    ],
)
def test_structure_left_open_at_the_end_of_a_part_is_refused(
    set_parts: SetParts, broken: str
) -> None:
    data = dxf(*_SHEET, broken, *[line(x, 0, x, 9) for x in range(30)])
    set_parts(1)
    before = _drawing(data)
    at = data.rindex(broken.encode()) + len(broken)
    assert not scan._scan_parts(data, [0, at, len(data)], 5000).supported
    set_parts(9)
    assert difference(before, _drawing(data)) == ""


def test_a_second_section_after_the_first_is_detected(set_parts: SetParts) -> None:
    data = dxf(*[line(x, 0, x, 9) for x in range(60)])
    second = b"0\nSECTION\n2\nTABLES\n0\nENDSEC\n0\nEOF\n"
    data = data.replace(b"0\nEOF\n", second)
    set_parts(1)
    before = _drawing(data)
    set_parts(5)
    assert scan.scan(data) is None
    assert difference(before, _drawing(data)) == ""


def test_generated_drawings_in_parts_and_as_one(set_parts: SetParts) -> None:
    tally: Counter[bool] = Counter()

    @examples(150, suppress_health_check=list(HealthCheck))
    @given(drawings(plain=True))
    def same(data: bytes) -> None:
        set_parts(1)
        before = _drawing(data)
        set_parts(6)
        tally[bool(scan._split_positions(data))] += 1
        assert difference(before, _drawing(data)) == ""

    same()
    # The share is random, about a fifth; without any divided drawing nothing would be compared.
    assert tally[True]
