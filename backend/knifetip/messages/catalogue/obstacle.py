"""obstacle: messages that state why a connected machine takes no job, and what leads out."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "obstacle.asleep": entry(
        "{name} is in sleep mode.",
        "Check the table, then press Release to wake the controller. Home the machine afterwards.",
        name="text",
    ),
    "obstacle.busy": entry(
        "{name} executes something that does not belong to a job.",
        "Wait until it is at rest. If it stays so, press Release: the machine stops and moves no "
        "axis.",
        name="text",
    ),
    "obstacle.check-mode": entry(
        "{name} is in check mode, in which nothing moves.",
        "Press Release to end the check mode.",
        name="text",
    ),
    "obstacle.door-closed": entry(
        "{name} is on hold after its safety door was opened.",
        "Check the table, then press Release: the machine discards what it held and moves no axis. "
        "Lift the tool afterwards.",
        name="text",
    ),
    "obstacle.door-open": entry(
        "The safety door of {name} is open.",
        "Close the safety door, then press Release.",
        name="text",
    ),
    "obstacle.held": entry(
        "{name} is on hold, and no job runs on it.",
        "Check the table, then press Release: the machine discards what it held and moves no axis. "
        "Lift the tool afterwards.",
        name="text",
    ),
    "obstacle.job-door-closed": entry(
        "The job on {name} is held, because the safety door was opened.",
        "Check the table, then press Resume to continue at this place, or Stop to end the job.",
        name="text",
    ),
    "obstacle.job-door-open": entry(
        "The job on {name} is held, because the safety door is open.",
        "Close the safety door, then press Resume to continue at this place, or Stop to end the "
        "job.",
        name="text",
    ),
    "obstacle.limit-pressed": entry(
        "A limit switch of {name} is still pressed ({axes:, }).",
        "Jog these axes away from their switches until this text disappears, or home the machine. "
        "If no axis is at a switch, check the switch and its cable.",
        name="text",
        axes="texts",
    ),
    "obstacle.limit-unused": entry(
        "A limit switch of {name} is pressed ({axes:, }). It does not stop the machine, because "
        "hard limits are off.",
        "Jog these axes away from their switches. If no axis is at a switch, check the switch and "
        "its cable.",
        name="text",
        axes="texts",
    ),
    "obstacle.moves": entry(
        "{name} moves, but not for a job.",
        "Wait until it is at rest, or press Release: the machine stops and discards the rest.",
        name="text",
    ),
    "obstacle.tool-change": entry(
        "{name} waits until a tool is changed, and no job runs on it.",
        "Check that the tool is fixed, then press Release: the machine discards the rest and moves "
        "no axis.",
        name="text",
    ),
}
