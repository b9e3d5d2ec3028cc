"""setting: messages about settings of a controller that differ from what programs presuppose."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "setting.difference": entry(
        "{setting} is {found}, expected {expected}: {reason}.",
        "Set {assignment} at the controller, or correct the machine file.",
        setting="text",
        found="text",
        expected="text",
        assignment="text",
        reason="message",
    ),
    "setting.faster": entry(
        "the controller moves the axis faster than the machine file permits",
    ),
    "setting.homes-at-other-end": entry(
        "the controller sets its zero at the homing switch, but in the machine file the zero is at "
        "the other end of the axis",
    ),
    "setting.inches": entry(
        "positions are reported in inches and would be taken as millimetres",
    ),
    "setting.laser-mode": entry(
        "laser mode is on, but the machine file has no laser",
    ),
    "setting.laser-mode-stops-spindle": entry(
        "in laser mode the controller switches the spindle off in rapid moves, so tools would "
        "enter the board while they do not turn",
    ),
    "setting.no-buffer-state": entry(
        "status reports do not contain the state of the buffers, so lost responses are noticed "
        "late",
    ),
    "setting.no-hard-limits": entry(
        "limit switches do not stop the machine",
    ),
    "setting.no-homing": entry(
        "the controller does not home, so it does not know its position after it was switched on",
    ),
    "setting.no-laser-mode": entry(
        "the controller is not in laser mode, so the laser beam would stay on during a feed hold",
    ),
    "setting.no-rate": entry(
        "the highest speed of the axis is 0, so the axis cannot move",
    ),
    "setting.no-soft-limits": entry(
        "the controller does not refuse moves beyond its travel",
    ),
    "setting.no-steps": entry(
        "the number of steps per millimetre or degree of the axis is 0, so the axis cannot move",
    ),
    "setting.no-work-offset": entry(
        "positions are reported without the offset of the work zero, so the gateway does not know "
        "where the tool is",
    ),
    "setting.rotary-axes": entry(
        "the controller takes the angle of a rotary axis as a length, or a length as an angle",
    ),
    "setting.short-travel": entry(
        "the travel is shorter than in the machine file, so the controller refuses jobs near the "
        "ends",
    ),
    "setting.slower": entry(
        "the controller moves the axis more slowly than the machine file states, so jobs take "
        "longer than stated",
    ),
    "setting.spindle-limit": entry(
        "the highest speed or power of the controller is lower than a station needs, so its tool "
        "would run more slowly or with less power",
    ),
    "setting.unit-of-angle": entry(
        "the unit of angles of the controller is not the degree",
    ),
    "setting.unit-of-length": entry(
        "the unit of length of the controller is not the millimetre, so positions would be taken "
        "wrongly",
    ),
    "setting.z-homes-down": entry(
        "homing would drive the tool down into the board",
    ),
}
