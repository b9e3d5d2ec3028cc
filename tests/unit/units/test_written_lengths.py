"""Lengths, units and scales in texts."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from knifetip.units.written_lengths import stated_unit, written_lengths, written_scales


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("350", [(350.0, "")]),
        ("350 mm", [(350.0, "mm")]),
        ("13,5cm", [(13.5, "cm")]),
        ('13 3/4"', [(13.75, "in")]),
        ("13-3/4", [(13.75, "in")]),
        ("13½ in", [(13.5, "in")]),
        ("13.78 in", [(13.78, "in")]),
        ("13,78 Zoll", [(13.78, "in")]),
        ("300x200x150", [(300.0, ""), (200.0, ""), (150.0, "")]),
        ("300 × 200 × 150 mm", [(300.0, "mm"), (200.0, "mm"), (150.0, "mm")]),
        ("L=300 B:120,5", [(300.0, ""), (120.5, "")]),
        ("FEFCO 0201", []),
        ("2024-05-12, 12.03.2024", []),
        ("Tel. 0711 / 123-456", []),
        ("45° R5 Ø20 10%", []),
        ("M 1:10", []),
        # 1200 or 1.2.
        ("1,200", []),
        ("99999999 0 A4", []),
    ],
)
def test_lengths_are_read_with_their_units(text: str, expected: list[tuple[float, str]]) -> None:
    assert [(one.value, one.unit) for one in written_lengths(text)] == expected


def test_half_of_the_last_decimal_place_is_returned() -> None:
    assert [one.half for one in written_lengths("350; 13.78")] == [0.5, 0.005]


@pytest.mark.parametrize(
    ("text", "unit"),
    [
        ("All dimensions in mm", "mm"),
        ("Alle Maße in mm", "mm"),
        ("UNITS: INCHES", "in"),
        ("单位: 毫米", "mm"),
        ("Cotes en cm", "cm"),
        ("dimension 300 mm", ""),
        ("a unit of minimalism", ""),
    ],
)
def test_stated_unit_is_found(text: str, unit: str) -> None:
    assert stated_unit(text) == unit


def test_scales_are_read() -> None:
    assert written_scales("Detail A, 1:10 (sheet 2:1), 16:9") == [(1, 10), (2, 1)]


@given(st.text(max_size=200))
def test_any_text_is_parsed(text: str) -> None:
    assert all(0.0 < one.value <= 20000.0 for one in written_lengths(text))
    stated_unit(text)
    written_scales(text)
