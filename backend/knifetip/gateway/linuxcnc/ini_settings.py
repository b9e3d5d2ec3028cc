"""ini_settings: the settings of LinuxCNC that the programs of a machine presuppose.

linuxcncrsh reports the units of the joints and the path of the INI file, but no value of this file:
``get ini`` has no reply in version 2.9.  The gateway therefore reads the file itself, if it is on
its computer or the option ``ini`` of the address names a copy of it.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import partial
from itertools import islice
from math import inf

from knifetip.gateway.motion import Pose
from knifetip.gateway.presupposed import (
    Requirement,
    expect_between,
    not_above,
    not_below,
    number,
    one_of,
    positive,
)
from knifetip.model.machine import Machine

_SECTION = re.compile(r"\s*\[(\w+)\]")
_ENTRY = re.compile(r"\s*(\w+)\s*=\s*(\S.*?)\s*$")
_COORDINATES = re.compile(r"coordinates=([A-Za-z]+)", re.IGNORECASE)
#: A travel may be this much shorter than the machine file states (mm or degrees).
_TRAVEL_ROUNDING = 0.5
#: Units of joints, as linuxcncrsh reports them, with which the gateway takes positions wrongly.
_WRONG_UNITS = ("INCH", "CM", "RAD", "GRAD", "CUSTOM")

_Entry = partial(Requirement, assignment="{setting} = {value}")


def read(lines: Iterable[str]) -> dict[str, str]:
    """Return the entries of an INI file: value by name, such as ``[AXIS_X]MAX_VELOCITY``.

    Of an entry that occurs several times, LinuxCNC uses the first.
    """
    found: dict[str, str] = {}
    section = ""
    for line in lines:
        if header := _SECTION.match(line):
            section = header[1].upper()
        elif entry := _ENTRY.match(line):
            found.setdefault(f"[{section}]{entry[1].upper()}", entry[2])
    return found


def unit_settings(reply: str, joints: int) -> dict[str, str]:
    """Return the unit of each joint in the reply to ``get joint_units``, by ``joint_units N``."""
    return {f"joint_units {joint}": unit for joint, unit in enumerate(reply.split()[:joints])}


def requirements(machine: Machine, found: Mapping[str, str]) -> list[Requirement]:
    """Return what the programs of a machine presuppose of its LinuxCNC.

    Parameters
    ----------
    machine
        The machine, as its file describes it.
    found
        Entries of the INI file (``read``) and units of the joints (``unit_settings``).
    """
    return [*_units(found), *_axis_requirements(machine, found)]


def _units(found: Mapping[str, str]) -> Iterator[Requirement]:
    length, angle = one_of("mm", "metric"), one_of("degree", "deg")
    yield _Entry("[TRAJ]LINEAR_UNITS", "setting.unit-of-length", length, dangerous=True)
    yield _Entry("[TRAJ]ANGULAR_UNITS", "setting.unit-of-angle", angle, dangerous=True)
    for name, unit in found.items():
        if name.startswith("joint_units"):
            turns = unit in ("DEG", "RAD", "GRAD")
            reason = "setting.unit-of-angle" if turns else "setting.unit-of-length"
            wanted = "DEG" if turns else "MM"
            yield _Entry(name, reason, _unless_wrong(wanted), dangerous=True)


def _unless_wrong(wanted: str) -> Callable[[str], str]:
    """Return an ``expected`` for the unit of a joint."""
    return lambda unit: wanted if unit in _WRONG_UNITS else unit


def _axis_requirements(machine: Machine, found: Mapping[str, str]) -> Iterator[Requirement]:
    for letter, axis in machine.axes.items():
        for section in (f"[AXIS_{letter}]", *_joint_sections(letter, found)):
            for name, wanted in (
                ("MAX_VELOCITY", axis.velocity),
                ("MAX_ACCELERATION", axis.acceleration),
            ):
                setting = section + name
                stops = positive(number(wanted))
                yield _Entry(setting, "setting.no-rate", stops, dangerous=True)
                yield _Entry(setting, "setting.slower", not_below(wanted))
                if section.startswith("[AXIS"):  # the lower one of axis and joint counts
                    yield _Entry(setting, "setting.faster", not_above(wanted))
            low = _number_of(found.get(f"{section}MIN_LIMIT"))
            if low is not None:
                high = low + axis.high - axis.low
                long_enough = expect_between(high - _TRAVEL_ROUNDING, inf, high)
                yield _Entry(f"{section}MAX_LIMIT", "setting.short-travel", long_enough)


def limits_of(machine: Machine, found: Mapping[str, str]) -> tuple[Pose, Pose]:
    """Return lowest and highest positions of X, Y, Z and C in an INI file (mm and degrees).

    The narrower limit of an axis and its joints counts; an entry that is missing is no limit.

    Parameters
    ----------
    machine
        The machine, as its file describes it.
    found
        Entries of the INI file (``read``).
    """
    x, y, z, c = (_limits_of_axis(letter, found) for letter in islice(machine.axes, 4))
    return (x[0], y[0], z[0], c[0]), (x[1], y[1], z[1], c[1])


def _limits_of_axis(letter: str, found: Mapping[str, str]) -> tuple[float, float]:
    sections = (f"[AXIS_{letter}]", *_joint_sections(letter, found))
    lows = [_number_of(found.get(f"{section}MIN_LIMIT")) for section in sections]
    highs = [_number_of(found.get(f"{section}MAX_LIMIT")) for section in sections]
    return (
        max((low for low in lows if low is not None), default=-inf),
        min((high for high in highs if high is not None), default=inf),
    )


def _joint_sections(letter: str, found: Mapping[str, str]) -> list[str]:
    """Return the sections of the joints that move an axis, in a machine with trivial kinematics."""
    kinematics = found.get("[KINS]KINEMATICS", "")
    stated = _COORDINATES.search(kinematics)
    order = stated[1] if stated else found.get("[TRAJ]COORDINATES", "").replace(" ", "")
    if not kinematics.lower().startswith("trivkins"):
        return []
    return [f"[JOINT_{joint}]" for joint, axis in enumerate(order.upper()) if axis == letter]


def _number_of(text: str | None) -> float | None:
    try:
        return None if text is None else float(text.split()[0])
    except ValueError:
        return None


def setting_lines(machine: Machine) -> list[str]:
    """Return the lines of an INI file of LinuxCNC with the settings of a machine."""
    lines = ["[TRAJ]", "LINEAR_UNITS = mm", "ANGULAR_UNITS = degree"]
    for letter, axis in machine.axes.items():
        lines += [
            f"[AXIS_{letter}]",
            f"MIN_LIMIT = {number(axis.low)}",
            f"MAX_LIMIT = {number(axis.high)}",
            f"MAX_VELOCITY = {number(axis.velocity)}",
            f"MAX_ACCELERATION = {number(axis.acceleration)}",
        ]
    return lines
