"""Positions of LinuxCNC on machines whose heading has the letter A or B."""

from __future__ import annotations

import pytest

from knifetip.gateway.linuxcnc.address import LinuxcncAddress
from knifetip.gateway.linuxcnc.connection import LinuxcncConnection


@pytest.mark.parametrize(("letter", "heading"), [("A", 40.0), ("B", 50.0), ("C", 60.0)])
def test_the_heading_is_the_position_of_its_letter(letter: str, heading: float) -> None:
    connection = LinuxcncConnection(LinuxcncAddress.parse("127.0.0.1:5007"), 1.0, letter)
    assert connection._pose_in("1 2 3 40 50 60") == (1.0, 2.0, 3.0, heading)
