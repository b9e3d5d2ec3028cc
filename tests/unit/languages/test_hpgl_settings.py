"""The settings of HPGL machines, which are validated when the machine's file is loaded."""

from __future__ import annotations

from pathlib import Path

import pytest

from knifetip.errors import LibraryError
from knifetip.languages.hpgl.plotter import PenWork, Plotter
from knifetip.languages.registry import with_language
from knifetip.library import load
from knifetip.model.machine import Machine

TEXT = (Path(load.__file__).parent / "machines" / "flat-cutter-hpgl.toml").read_text("utf-8")
OWN = '{ title = "Ours", units = 100.0, area = [0, 0, 130000, 90000], origin = "corner", pens = 3 }'
SECOND = '[[controller.pen]]\nnumber = 2\nstation = 2\nwork = "crease"\nforce = 24\n'


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
    ("old", "new", "expected"),
    [
        (
            'device = "flat-cutter"',
            'device = "x"',
            "device is 'x', but must be 'flat-cutter', .*'hp-7475a-a3'",
        ),
        ('device = "flat-cutter"', "device = 3", "device is 3, but must be"),
        (
            'device = "flat-cutter"',
            f"device = {OWN}",
            "force is 30, but Ours has no force .*Remove force",
        ),
        (
            'device = "flat-cutter"',
            f"device = {OWN}".replace("130000", "-1"),
            r"area is \[0, 0, -1, 90000\], but must be",
        ),
        (
            'device = "flat-cutter"',
            f"device = {OWN}".replace("pens = 3", "pens = 3, speed = [5, 1]"),
            r"speed is \[5, 1\], but must be",
        ),
        (
            'device = "flat-cutter"',
            f"device = {OWN}".replace('"corner"', '"left"'),
            "origin is 'left', but must be 'corner' or 'centre'",
        ),
        ('device = "flat-cutter"', 'device = { title = "Ours" }', "device → units is missing"),
        ("force = 12", "strength = 12", "pen 3 → strength is not a known field"),
        ('work = "crease"\nforce = 24', "", "pen 2 → work is missing"),
        ('device = "flat-cutter"', "", "controller → device is missing"),
        (
            "number = 3\nstation = 1",
            "number = 9\nstation = 1",
            "pen 3 → number is 9, but must be at most 4",
        ),
        (
            "number = 3\nstation = 1",
            "number = 2\nstation = 1",
            "pen has the numbers 1, 2, 2; each number may occur only once",
        ),
        (
            'work = "half-cut"',
            'work = "cut"',
            "pen 3 has the same station and the same operation.*Remove one",
        ),
        (
            'work = "half-cut"',
            'work = "crease"',
            "pen 3 → work is 'crease', but the tool of station 1 cannot do this",
        ),
        (
            'work = "half-cut"',
            'work = "groove"',
            "work is 'groove', but must be 'cut', 'half-cut' or 'crease'",
        ),
        (
            "number = 2\nstation = 2",
            "number = 2\nstation = 1",
            "pen 2 → work is 'crease', but the tool of station 1 cannot",
        ),
        (SECOND, "", "station 2 has no pen"),
        ("force = 12", "force = 99", "pen 3 → force is 99, but must be from 1 to 40"),
        (
            "number = 2\nstation = 2",
            "number = 2\nstation = 5",
            "pen 2 → station is 5, but must be 1 or 2",
        ),
        (
            "feed = 24000.0",
            "feed = 24100.0",
            "station 1 → tool → feed is 24,100 .* multiples of 600 mm/min from 600 to 48,000",
        ),
        (
            "swivel = 15.0",
            "swivel = 15.0\ntrail = 0.5",
            r"station 1 → tool → trail \(knife offset\) is 0\.5 mm.*Set trail to 0",
        ),
        (
            "high = 1300.0",
            "high = 1301.0",
            "axes → x extends from 0 to 1,301 mm, but the working area in the HPGL settings "
            "extends from 0 to 1,300 mm",
        ),
        (
            "datum = { x = 0.0",
            "datum = { x = 5.0",
            "station 1 has an offset.*Set all values of datum to 0",
        ),
        (
            'kind = "crease-wheel"\nradius = 5.0\nwidth = 0.7',
            'kind = "cutter"\nradius = 3.0',
            "station 2 → tool is neither a knife nor a creasing tool",
        ),
    ],
)
def test_an_invalid_file_is_refused_with_the_reason(
    tmp_path: Path, old: str, new: str, expected: str
) -> None:
    assert old in TEXT
    with pytest.raises(LibraryError, match=expected):
        machine(tmp_path, TEXT.replace(old, new, 1))


def test_a_machine_without_a_device_cannot_be_driven_with_hpgl() -> None:
    with pytest.raises(
        LibraryError,
        match=r"cannot be controlled with programs in HPGL.*Choose the language grblhal",
    ):
        with_language(load.machine("demo-table"), "hpgl")
