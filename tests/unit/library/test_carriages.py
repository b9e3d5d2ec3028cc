"""The table [gantry] of a machine file, and its errors."""

from __future__ import annotations

import tomllib
from collections.abc import Callable
from importlib import resources
from typing import Any

import pytest

from knifetip.errors import LibraryError
from knifetip.library import load
from knifetip.model.machine import Machine

FILE = (resources.files("knifetip") / "library/machines/two-carriage-table.toml").read_text("utf-8")


def changed(change: Callable[[dict[str, Any]], Any], machine: str = FILE) -> Machine:
    fields = tomllib.loads(machine)
    change(fields)
    return load.parse_machine("own", fields)


def carriage(fields: dict[str, Any]) -> dict[str, Any]:
    result: dict[str, Any] = fields["gantry"]["carriage"][0]
    return result


def test_the_shipped_machine_has_six_axes() -> None:
    machine = load.machine("two-carriage-table")
    assert list(machine.axes) == ["X", "Y", "Z", "C", "V", "A"]
    first, second = machine.carriages
    assert (first.letters, second.letters) == ("XYZC", "XVZA")
    assert (first.park, second.park) == (-220.0, 1420.0)
    assert first.axes == (machine.x, machine.y, machine.z, machine.c)
    assert second.axes[::2] == first.axes[::2]
    assert (second.axes[1].velocity, second.axes[3].high) == (1200.0, 720.0)
    assert [station.carriage for station in machine.stations] == [1, 2, 2]
    assert [machine.carriage_of(one).is_first for one in machine.stations] == [True, False, False]


def test_a_carriage_may_have_a_z_of_its_own() -> None:
    lift = {"letter": "W", "low": -5.0, "high": 40.0, "velocity": 300.0, "acceleration": 2000.0}
    machine = changed(lambda fields: carriage(fields).update(z=lift))
    assert machine.carriages[1].letters == "XVWA"
    assert machine.axes["W"].high == 40.0


def test_a_machine_without_a_gantry_has_one_carriage() -> None:
    machine = load.machine("demo-table")
    (only,) = machine.carriages
    assert machine.gantry is None
    assert (only.letters, only.park) == ("XYZC", 0.0)
    assert list(machine.axes) == ["X", "Y", "Z", "C"]


@pytest.mark.parametrize(
    ("change", "reason"),
    [
        (
            lambda fields: fields["station"][0].update(carriage=3),
            "station 1 is on carriage 3, but the machine has 2 carriages",
        ),
        (lambda fields: fields.pop("gantry"), "is on carriage 2, but the machine has 1 carriage"),
        (lambda fields: fields["station"][0].update(carriage=0), "carriage is 0, but must be at"),
        (lambda fields: carriage(fields)["y"].update(letter="Y"), "must be .*'A', 'B', 'U', 'V'"),
        (lambda fields: carriage(fields)["c"].update(letter="V"), "letters V, V; each letter"),
        (lambda fields: carriage(fields).pop("c"), "carriage 1 → c is missing"),
        (
            lambda fields: carriage(fields).update(park=1500.0),
            "parks at 1,500 mm, outside the travel of its y axis from -15 to 1,420 mm",
        ),
        (
            lambda fields: fields["gantry"].update(park=-300.0),
            "gantry parks at -300 mm, outside the travel of its y axis from -220 to 1,215 mm",
        ),
        (
            lambda fields: fields["gantry"].update(park=1215.0, min_distance=206.0),
            "park 205 mm apart, but min_distance is 206 mm",
        ),
        (lambda fields: fields["gantry"].update(min_distance=0.0), "must be greater than 0"),
        (lambda fields: fields["gantry"].update(carriage=[]), "has 0 values, but needs at least 1"),
        (
            lambda fields: carriage(fields)["y"].update(letter="B"),
            r"linear axis B, but LinuxCNC has no such axis. Its linear axes are X, Y, Z, U, V, W",
        ),
        (
            lambda fields: carriage(fields)["c"].update(letter="U"),
            "rotary axis U, but LinuxCNC has no such axis. Its rotary axes are A, B, C",
        ),
        (
            lambda fields: fields.update(dialect="hpgl"),
            "linear axis V, but HPGL has no such axis. Its linear axes are X, Y, Z",
        ),
    ],
)
def test_a_wrong_gantry_is_refused_with_the_reason(
    change: Callable[[dict[str, Any]], Any], reason: str
) -> None:
    with pytest.raises(LibraryError, match=reason):
        changed(change)


def test_grblhal_has_other_letters() -> None:
    def as_grblhal(fields: dict[str, Any]) -> None:
        fields["dialect"] = "grblhal"
        carriage(fields)["y"]["letter"] = "A"
        carriage(fields)["c"]["letter"] = "B"

    assert changed(as_grblhal).carriages[1].letters == "XAZB"


def test_the_angle_of_the_axes_is_that_of_a_machine_with_one_carriage() -> None:
    demo = (resources.files("knifetip") / "library/machines/demo-table.toml").read_text("utf-8")

    def leaning(angle: float, machine: str = demo) -> Machine:
        return changed(lambda fields: fields.update(squareness=angle), machine)

    assert changed(lambda fields: None, demo).squareness == 90.0
    assert leaning(89.5).squareness == 89.5
    for machine, angle, reason in (
        (FILE, 89.5, "machine with several carriages do not correct an angle of 89.5°"),
        (demo, 88.9, "squareness"),
        (demo, 91.1, "squareness"),
    ):
        with pytest.raises(LibraryError, match=reason):
            leaning(angle, machine)
