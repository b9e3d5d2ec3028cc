"""Keep-out zones and envelopes in the file of a machine."""

from __future__ import annotations

from importlib import resources
from pathlib import Path

import pytest

from knifetip.errors import LibraryError
from knifetip.library import load
from knifetip.model.machine import Machine, Zone

FILE = (resources.files("knifetip") / "library/machines/demo-table.toml").read_text("utf-8")
ZONE = """
[[zone]]
name = "Left clamp"
x = -5.0
y = 500.0
width = 15.0
height = 60.0
top = 16.0
"""


def loaded(path: Path, text: str) -> Machine:
    file = path / "mine.toml"
    file.write_text(text)
    return load.machine(str(file))


def test_a_machine_has_no_zones_by_default() -> None:
    machine = load.machine("demo-table")
    assert machine.zones == ()
    assert [station.envelope for station in machine.stations] == [0.0, 0.0, 0.0]
    # The tools alone: blade width 3, wheel radius 15, and tip 6 + 1.5 beside the axis.
    reach = [station.reach for station in machine.stations]
    assert reach == pytest.approx([3.0, 15.004, 7.5], abs=1e-3)


def test_zones_and_envelopes_are_read(tmp_path: Path) -> None:
    text = FILE.replace("output = 0\n", "output = 0\nenvelope = 22.0\n") + ZONE
    machine = loaded(tmp_path, text)
    assert machine.zones == (Zone("Left clamp", -5.0, 500.0, 15.0, 60.0, 16.0),)
    assert machine.stations[0].reach == 22.0


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        ("top = 16.0", "top = 19.0", "but tools travel at travel_z = 20 mm; raise travel_z"),
        ("top = 16.0", "top = 0.0", "zone 1 → top"),
        ("width = 15.0", "width = -1.0", "zone 1 → width"),
        ("height = 60.0", "", "zone 1 → height"),
        ('name = "Left clamp"', 'name = ""', "zone 1 → name"),
        ("top = 16.0", "top = nan", "zone 1 → top"),
        ("top = 16.0", "top = 16.0\ntops = 1.0", "zone 1 → tops"),
    ],
)
def test_a_wrong_zone_is_refused_with_its_field(
    tmp_path: Path, old: str, new: str, expected: str
) -> None:
    with pytest.raises(LibraryError) as caught:
        loaded(tmp_path, FILE + ZONE.replace(old, new))
    assert expected in str(caught.value)


def test_the_turn_clearance_is_at_most_the_clearance(tmp_path: Path) -> None:
    assert load.machine("demo-table").turn_clearance == 0.5
    assert loaded(tmp_path, FILE.replace("turn_clearance = 0.5", "")).turn_clearance == 0.0
    with pytest.raises(LibraryError, match="must not be more than clearance, 2 mm"):
        loaded(tmp_path, FILE.replace("turn_clearance = 0.5", "turn_clearance = 2.1"))
