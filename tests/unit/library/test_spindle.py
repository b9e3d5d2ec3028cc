"""Spindles of stations, and the number of outputs, in the file of a machine."""

from __future__ import annotations

from importlib import resources
from pathlib import Path

import pytest

from knifetip.errors import LibraryError
from knifetip.languages.registry import with_language
from knifetip.library import load
from knifetip.model.machine import Machine
from knifetip.presentation.machine import station_json

MACHINES = resources.files("knifetip") / "library/machines"
DEMO, ROUTER, LASER = (
    (MACHINES / f"{name}.toml").read_text("utf-8")
    for name in ("demo-table", "router-table", "laser-table")
)
M4 = 'spindle = "M4"\nspindle_speed = 12000.0\n'


def loaded(path: Path, text: str) -> Machine:
    file = path / "mine.toml"
    file.write_text(text)
    return load.machine(str(file))


def test_the_spindle_of_a_station_is_that_of_its_tool_by_default() -> None:
    demo, router = load.machine("demo-table"), load.machine("router-table")
    assert [(one.spindle, one.speed) for one in demo.stations] == [("M3", 1), ("M3", 0), ("M3", 0)]
    assert (router.station(4).spindle, router.station(4).speed) == ("M3", 18000)
    assert station_json(demo.stations[1])["spindle"] == ""


def test_direction_and_speed_of_a_station_are_read(tmp_path: Path) -> None:
    machine = loaded(tmp_path, DEMO.replace("output = 0\n", f"output = 0\n{M4}"))
    assert (machine.station(1).spindle, machine.station(1).speed) == ("M4", 12000)
    # A cutter without a speed of its own has that of its station.
    text = ROUTER.replace("speed = 18000.0\n", "").replace("output = 3\n", f"output = 3\n{M4}")
    assert loaded(tmp_path, text).station(4).speed == 12000


@pytest.mark.parametrize(
    ("text", "old", "new", "expected"),
    [
        (DEMO, "output = 1\n", f"output = 1\n{M4}", "station 2 has no oscillation and no spindle"),
        (DEMO, "oscillating = true", "oscillating = false", "station 1 has no oscillation"),
        (LASER, "output = 4 ", f"{M4}output = 4 ", "station 5 has a laser"),
        (DEMO, "output = 0\n", 'output = 0\nspindle = "M5"\n', "spindle"),
        (DEMO, "output = 0\n", "output = 0\nspindle_speed = -5.0\n", "spindle_speed"),
        (DEMO, 'feed = "manual"', 'feed = "manual"\noutput_count = 2', "do not exist: 2"),
        (ROUTER, "output = 3\n", "output = 4\n", "LinuxCNC has 4 by default"),
        (ROUTER, 'feed = "manual"', 'feed = "manual"\noutput_count = 3', "do not exist: 3"),
    ],
)
def test_a_wrong_spindle_or_output_is_refused(
    tmp_path: Path, text: str, old: str, new: str, expected: str
) -> None:
    if "oscillating" in old:
        text = text.replace("output = 0\n", f"output = 0\n{M4}")
    assert old in text
    with pytest.raises(LibraryError) as refused:
        loaded(tmp_path, text.replace(old, new, 1))
    assert expected in str(refused.value)


def test_more_outputs_are_used_where_the_machine_states_them(tmp_path: Path) -> None:
    text = ROUTER.replace("output = 3\n", "output = 7\n")
    text = text.replace('feed = "manual"', 'feed = "manual"\noutput_count = 8')
    assert loaded(tmp_path, text).outputs == (1, 2, 7)


def test_a_machine_is_refused_by_a_language_that_lacks_its_outputs(tmp_path: Path) -> None:
    machine = loaded(tmp_path, DEMO.replace("output = 2\n", "output = 6\n"))
    with pytest.raises(LibraryError) as refused:
        with_language(machine, "linuxcnc")
    assert "do not exist: 6" in str(refused.value)
