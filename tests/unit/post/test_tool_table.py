"""The tool table of LinuxCNC."""

from __future__ import annotations

from dataclasses import replace

from knifetip.library.load import machine
from knifetip.post.rs274.tool_table import tool_table

TABLE = machine("demo-table")


def test_each_station_has_a_line_with_its_datum_and_its_name() -> None:
    assert tool_table(TABLE).splitlines() == [
        "T1 P1 X0.0000 Y0.0000 Z0.0000 C0.0000 D0.0000 ;Oscillating knife",
        "T2 P2 X60.0000 Y0.0000 Z-1.5000 C0.0000 D30.0000 ;Crease wheel",
        "T3 P3 X-60.0000 Y0.0000 Z0.0000 C0.0000 D0.0000 ;V-cutter",
    ]


def test_the_mounting_angle_is_written_and_zero_has_no_sign() -> None:
    odd = replace(TABLE, stations=(replace(TABLE.stations[0], x=-0.00001, c=-0.5),))
    assert "X0.0000 Y0.0000 Z0.0000 C-0.5000" in tool_table(odd)


def test_a_line_break_in_a_name_is_removed() -> None:
    odd = replace(TABLE, stations=(replace(TABLE.stations[0], name="knife\nT9 P9 X99"),))
    assert len(tool_table(odd).splitlines()) == 1
