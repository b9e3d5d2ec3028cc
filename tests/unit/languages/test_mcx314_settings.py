"""The settings of an MCX314 in a machine's TOML file, and each fault of them."""

from __future__ import annotations

from pathlib import Path

import pytest

from knifetip.errors import LibraryError
from knifetip.languages.mcx314.wiring import Wiring
from knifetip.library import load

TEXT = (Path(load.__file__).parent / "machines" / "v-groove-table.toml").read_text("utf-8")


def test_the_shipped_machine_has_its_wiring() -> None:
    assert load.machine("v-groove-table").controller == Wiring(
        (200.0, 200.0, 400.0, 100.0), 50, 2000, 1_000_000, 0.0005, 5.0
    )


@pytest.mark.parametrize(
    ("old", "new", "fault"),
    [
        ("start = 2000", "start = 2010", "start is 2010, but must be a multiple of 50"),
        ("acceleration = 1000000", "acceleration = 1000", "must be a multiple of 6250"),
        ("acceleration = 1000000", "acceleration = 60000000", "at most 50000000"),
        ("multiple = 50", "multiple = 501", "multiple is 501"),
        ("refill = 0.0005", "refill = 0.0", "refill"),
        ("corner = 5.0", "corner = 91.0", "corner is 91"),
        ("velocity = 3600.0", "velocity = 7200.0", "needs 720,000 pulses per second"),
        ("x = 200.0, y", "x = 20000.0, y", "needs 20,000,000 pulses per second"),
        (
            "low = -1080.0, high = 1080.0",
            "low = -90000.0, high = 90000.0",
            "is 18,000,000 pulses long",
        ),
        ("plunge = 3000.0", "plunge = 300.0", "577 pulses per second along a diagonal"),
        ("output = 2", "output = 16", "output is 16"),
        ("output = 0", 'output = 0\nspindle = "M4"', "spindle states a direction"),
        ("output = 0", "output = 0\nspindle_speed = 900.0", "spindle states a direction"),
        ("[controller]", "[controller]\nbaud = 9600", "baud"),
    ],
)
def test_a_fault_is_named_with_its_field(tmp_path: Path, old: str, new: str, fault: str) -> None:
    assert old in TEXT
    file = tmp_path / "table.toml"
    file.write_text(TEXT.replace(old, new, 1), "utf-8")
    with pytest.raises(LibraryError, match=fault):
        load.machine(str(file))


def test_a_laser_is_refused(tmp_path: Path) -> None:
    laser = (Path(load.__file__).parent / "machines" / "laser-table.toml").read_text("utf-8")
    file = tmp_path / "table.toml"
    settings = TEXT[TEXT.index("[controller]") :]
    dialect = next(line for line in laser.splitlines() if line.startswith("dialect"))
    text = laser.replace(dialect, 'dialect = "mcx314"') + "\n" + settings
    for velocity in ("velocity = 1500.0", "velocity = 2000.0"):
        text = text.replace(velocity, "velocity = 500.0")
    file.write_text(text, "utf-8")
    with pytest.raises(LibraryError, match="must be switched on and off during a cut"):
        load.machine(str(file))
