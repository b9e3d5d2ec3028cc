"""The settings of HPGL machines, which are validated when the machine's file is loaded."""

from __future__ import annotations

from pathlib import Path

import pytest

from knifetip.errors import ControllerError, LibraryError
from knifetip.languages.hpgl.plotter import PenWork, Plotter
from knifetip.languages.registry import find_language, with_language
from knifetip.library import load
from knifetip.model.machine import Machine

TEXT = (Path(load.__file__).parent / "machines" / "flat-cutter-hpgl.toml").read_text("utf-8")
OWN = '{ title = "Ours", units = 100.0, area = [0, 0, 130000, 90000], origin = "corner", pens = 3 }'


def machine(tmp_path: Path, text: str) -> Machine:
    file = tmp_path / "cutter.toml"
    file.write_text(text, "utf-8")
    return load.machine(str(file))


def test_the_settings_of_the_shipped_machine_are_valid() -> None:
    plotter = load.machine("flat-cutter-hpgl").controller
    assert isinstance(plotter, Plotter)
    assert plotter.device.units == 40.0
    assert [(pen.number, pen.station, pen.work) for pen in plotter.pens] == [
        (1, 1, PenWork.CUT),
        (2, 2, PenWork.CREASE),
        (3, 1, PenWork.HALF_CUT),
    ]


def test_a_machine_may_describe_its_own_device(tmp_path: Path) -> None:
    text = TEXT.replace('"flat-cutter"', OWN)
    for force in (30, 24, 12):
        text = text.replace(f"force = {force}\n", "")
    plotter = machine(tmp_path, text).controller
    assert isinstance(plotter, Plotter)
    assert (plotter.device.units, plotter.device.speed, plotter.device.force) == (100.0, None, None)


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ('device = "flat-cutter"', 'device = "x"', "'x'; give one of flat-cutter, .*hp-7475a-a3"),
        ('device = "flat-cutter"', "", "controller.device is ''"),
        ("number = 3\nstation = 1", "number = 9\nstation = 1", "has pens 1 to 4"),
        ("number = 3\nstation = 1", "number = 2\nstation = 1", "must differ"),
        ('work = "half-cut"', 'work = "cut"', "do the same work"),
        ('work = "half-cut"', 'work = "crease"', "station 1 cannot crease"),
        ('work = "half-cut"', 'work = "groove"', "give one of cut, half-cut, crease"),
        ("force = 12", "force = 99", "must be 1 to 40"),
        ("number = 2\nstation = 2", "number = 2\nstation = 5", "has no station 5"),
        ("feed = 24000.0", "feed = 24100.0", "multiples of 600 from 600 to 48000"),
        ("swivel = 15.0", "swivel = 15.0\ntrail = 0.5", "compensates the trail"),
        ("high = 1300.0", "high = 1301.0", "the device reaches 0 to 1300 mm"),
        ("datum = { x = 0.0", "datum = { x = 5.0", "set the datum to 0"),
        (
            'kind = "crease-wheel"\nradius = 5.0\nwidth = 0.7',
            'kind = "cutter"\nradius = 3.0',
            "neither depths nor headings",
        ),
    ],
)
def test_an_invalid_file_is_refused_with_the_reason(
    tmp_path: Path, old: str, new: str, said: str
) -> None:
    assert old in TEXT
    with pytest.raises(LibraryError, match=said):
        machine(tmp_path, TEXT.replace(old, new, 1))


def test_a_machine_without_a_device_cannot_be_driven_with_hpgl() -> None:
    with pytest.raises(LibraryError, match=r"cannot be driven with HPGL.*Choose grblhal"):
        with_language(load.machine("demo-table"), "hpgl")


def test_hpgl_has_no_driver_and_a_hint_to_download() -> None:
    with pytest.raises(
        ControllerError, match=r"in HPGL cannot be sent to a machine.*Download the program"
    ):
        find_language("hpgl").load_driver()
