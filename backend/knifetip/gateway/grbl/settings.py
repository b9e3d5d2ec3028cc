"""settings: the settings of grbl and grblHAL (``$n``) that the programs of a machine presuppose.

A row of the table below is one setting with the reason why its value matters.  Rows of axes stand
for several settings: ``$110`` is the one of the first axis, ``$111`` that of the second.  Rates are
mm/min and degrees/min, as in the controller; the machine file has them per second.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass

from knifetip.gateway.grbl.capabilities import Capabilities
from knifetip.gateway.presupposed import (
    Requirement,
    at_least,
    bits,
    equal_to,
    not_above,
    not_below,
    number,
    positive,
)
from knifetip.model.machine import Axis, Machine, has_spindle

_ROW = re.compile(r"\$(\d+)=(\S*)")
#: Bits of ``$10`` (grblHAL): machine positions, buffer state, work offsets; reports with all three.
_MACHINE_POSITION, _BUFFER, _WORK_OFFSET, _FULL_REPORT = 1, 2, 32, 511
#: Bit of ``$22`` (grblHAL): homing makes the place of the switch the zero of the axis.
_ZERO_AT_SWITCH = 8
#: Index of Z in masks of axes.
_Z = 2
#: Setting of grblHAL with the rotary axes, from the fourth axis on; ``$$`` does not report it.
ROTARY_AXES = 376
_FIRST_ROTARY = 3
#: A travel may be this much shorter than the machine file states (mm or degrees).
_TRAVEL_ROUNDING = 0.5

#: Value of a setting that was never set, for ``setting_lines``.
_UNSET = "0"
#: Stands for the steps per millimetre or degree, which the machine file does not state.
_STEPS = "STEPS"

Expected = Callable[[str], str]


@dataclass(frozen=True, slots=True)
class _Facts:
    """What the rows use: the machine, its controller, and the settings that were found."""

    machine: Machine
    capabilities: Capabilities
    found: Mapping[str, str]

    @property
    def axes(self) -> Iterator[tuple[int, str, Axis]]:
        """Index, letter at the controller, and axis of the machine, for each axis of both."""
        heading = self.machine.heading_letter
        for letter, axis in self.machine.axes.items():
            wire = self.capabilities.rotary_letter if letter == heading else letter
            order = self.capabilities.axes or "XYZ" + self.capabilities.rotary_letter
            if wire and wire in order:
                yield order.index(wire), letter, axis

    def mask(self, number: int) -> int | None:
        """Return the bits of a setting; None if it is not reported or no number."""
        text = self.found.get(f"${number}", "")
        return int(text) if text.isdecimal() else None


@dataclass(frozen=True, slots=True)
class _Row:
    """One setting of the machine as a whole."""

    number: int
    reason: str
    expected: Callable[[_Facts], Expected | None]  #: None: the machine does not presuppose it
    dangerous: bool = False
    required: bool = False


@dataclass(frozen=True, slots=True)
class _AxisRow:
    """One setting of each axis."""

    number: int  #: of the first axis
    reason: str
    expected: Callable[[Axis], Expected]
    dangerous: bool = False


def _laser_mode(facts: _Facts) -> Expected | None:
    return equal_to(1) if facts.machine.has_beam else None


def _spindle_mode(facts: _Facts) -> Expected | None:
    turns = any(has_spindle(one.tool) and not one.is_beam for one in facts.machine.stations)
    return equal_to(0) if turns and not facts.machine.has_beam else None


def _no_mode(facts: _Facts) -> Expected | None:
    turns = any(has_spindle(one.tool) for one in facts.machine.stations)
    return equal_to(0) if not turns else None


def _report_contents(facts: _Facts) -> Expected | None:
    """With positions of the machine, grblHAL must also report the offset of the work zero."""
    mask = facts.mask(10)
    if not facts.capabilities.grblhal or mask is None or not mask & _MACHINE_POSITION:
        return None
    return bits(on=_FULL_REPORT) if not mask & _WORK_OFFSET else None


def _reports_buffer(facts: _Facts) -> Expected | None:
    mask = facts.mask(10)
    if mask is None or mask & _BUFFER:
        return None
    return bits(on=_FULL_REPORT if facts.capabilities.grblhal else _BUFFER)


def _fastest_spindle(facts: _Facts) -> Expected | None:
    fastest = max((one.speed for one in facts.machine.stations), default=0)
    return at_least(fastest) if fastest else None


def _switch_of_z(facts: _Facts) -> Expected | None:
    homes = facts.mask(22)
    return bits(off=1 << _Z) if homes is None or homes & 1 else None


def _switches_at_zero(facts: _Facts) -> Expected | None:
    """With ``$22`` bit 3 the switch is the zero, so it must be at the end with the zero."""
    if not facts.capabilities.grblhal or not (facts.mask(22) or 0) & _ZERO_AT_SWITCH:
        return None
    on = off = 0
    for index, letter, axis in facts.axes:
        if letter in "XY":
            low = abs(axis.low) <= abs(axis.high)
            on, off = (on | 1 << index, off) if low else (on, off | 1 << index)
    return bits(on=on, off=off)


def _rotary_axes(facts: _Facts) -> Expected | None:
    """The axes that rotate tools are rotary; the axes of other letters are linear."""
    if not facts.capabilities.grblhal:
        return None
    on = off = 0
    for index, letter, _ in facts.axes:
        if index >= _FIRST_ROTARY:
            bit = 1 << (index - _FIRST_ROTARY)
            turns = any(letter in carriage.letters[3:] for carriage in facts.machine.carriages)
            on, off = (on | bit, off) if turns else (on, off | bit)
    return bits(on=on, off=off) if on or off else None


def _travel(axis: Axis) -> Expected:
    """Return an expected travel; grblHAL does not limit an axis whose travel is 0."""
    span = axis.high - axis.low
    long_enough = at_least(span - _TRAVEL_ROUNDING)
    unlimited = equal_to(0.0)

    def expected(found: str) -> str:
        if found in (long_enough(found), unlimited(found)):
            return found
        return equal_to(span)(found)

    return expected


def _above_zero(wanted: float) -> Expected:
    return positive(number(wanted))


_ROWS = (
    _Row(10, "setting.no-work-offset", _report_contents, dangerous=True),
    _Row(10, "setting.no-buffer-state", _reports_buffer),
    _Row(13, "setting.inches", lambda _: equal_to(0), dangerous=True),
    # grblHAL takes soft limits only after homing.
    _Row(22, "setting.no-homing", lambda _: bits(on=1)),
    _Row(20, "setting.no-soft-limits", lambda _: equal_to(1)),
    _Row(21, "setting.no-hard-limits", lambda _: bits(on=1)),
    _Row(23, "setting.z-homes-down", _switch_of_z, dangerous=True),
    _Row(23, "setting.homes-at-other-end", _switches_at_zero),
    _Row(30, "setting.spindle-limit", _fastest_spindle),
    _Row(32, "setting.no-laser-mode", _laser_mode, dangerous=True, required=True),
    _Row(32, "setting.laser-mode-stops-spindle", _spindle_mode, dangerous=True),
    _Row(32, "setting.laser-mode", _no_mode),
    _Row(ROTARY_AXES, "setting.rotary-axes", _rotary_axes),
)
_AXIS_ROWS = (
    _AxisRow(100, "setting.no-steps", lambda _: positive(_STEPS), dangerous=True),
    _AxisRow(
        110, "setting.no-rate", lambda axis: _above_zero(axis.velocity * 60.0), dangerous=True
    ),
    _AxisRow(110, "setting.slower", lambda axis: not_below(axis.velocity * 60.0)),
    _AxisRow(110, "setting.faster", lambda axis: not_above(axis.velocity * 60.0)),
    _AxisRow(120, "setting.no-rate", lambda axis: _above_zero(axis.acceleration), dangerous=True),
    _AxisRow(120, "setting.slower", lambda axis: not_below(axis.acceleration)),
    _AxisRow(120, "setting.faster", lambda axis: not_above(axis.acceleration)),
    _AxisRow(130, "setting.short-travel", _travel),
)


def requirements(
    machine: Machine, capabilities: Capabilities, found: Mapping[str, str]
) -> list[Requirement]:
    """Return what the programs of a machine presuppose of the settings of its controller.

    Parameters
    ----------
    machine
        The machine, as its file describes it.
    capabilities
        Axes and firmware of the controller.
    found
        Settings of the controller, as ``read`` returns them; the meaning of some depends on others.
    """
    facts = _Facts(machine, capabilities, found)
    required = [
        Requirement(f"${row.number}", row.reason, expected, row.dangerous, row.required)
        for row in _ROWS
        if (expected := row.expected(facts)) is not None
    ]
    for index, _, axis in facts.axes:
        required += [
            Requirement(f"${row.number + index}", row.reason, row.expected(axis), row.dangerous)
            for row in _AXIS_ROWS
        ]
    return required


def read(lines: Iterable[str]) -> dict[str, str]:
    """Return the settings in the answer to ``$$`` or ``$n``: value by name, such as ``$13``."""
    rows = (_ROW.match(line) for line in lines)
    return {f"${row[1]}": row[2] for row in rows if row}


def has_hard_limits(found: Mapping[str, str]) -> bool:
    """Return whether a pressed limit switch stops the machine (``$21``); True if not reported."""
    mask = found.get("$21", "")
    return not mask.isdecimal() or bool(int(mask) & 1)


def setting_lines(machine: Machine) -> list[str]:
    """Return the lines to type at grblHAL so that it has the settings of a machine.

    Settings that the machine file cannot state, such as the steps per millimetre, are left out.
    """
    letters = "".join(machine.axes)
    capabilities = Capabilities(letters, grblhal=True, program_letter=machine.heading_letter)
    facts = _Facts(machine, capabilities, {})
    typed = {10: str(_FULL_REPORT), 22: "1"}
    for one in requirements(machine, capabilities, {}):
        if (value := one.expected(_UNSET)) != _STEPS:
            typed.setdefault(int(one.setting[1:]), value)
    # A travel of 0 is permitted and means no limit; the file states one.
    typed |= {130 + index: number(axis.high - axis.low) for index, _, axis in facts.axes}
    return [f"${order}={typed[order]}" for order in sorted(typed)]
