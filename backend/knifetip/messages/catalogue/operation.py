"""operation: messages about operations of a person at the machine, such as unlock and jog."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "operation.bad-feed": entry(
        "A feed of {feed:g} per minute is not possible on this axis.",
        "Give a feed greater than 0 and not greater than {fastest:g} per minute.",
        feed="number",
        fastest="number",
    ),
    "operation.beyond-travel": entry(
        "The move would end at {axis} {target:.3f}, beyond the travel of the axis from {low:g} to "
        "{high:g}. Nothing has moved.",
        "Jog a shorter distance, or in the other direction.",
        axis="text",
        target="number",
        low="number",
        high="number",
    ),
    "operation.expired": entry(
        "The operation was not carried out within {seconds:g} s and was dropped. Nothing was sent "
        "to the machine.",
        "Check the connection of the gateway to the server and to the machine, then try again.",
        seconds="number",
    ),
    "operation.not-at-rest": entry(
        "{name} is not at rest: it reports the state {state}. Nothing was sent.",
        "Wait until the machine has stopped. If it is in alarm, unlock or home it.",
        name="text",
        state="text",
    ),
    "operation.not-lifted": entry(
        "The tool is not lifted: Z is below {height:g}. Nothing was sent.",
        "Park the machine, or jog Z up first.",
        height="number",
    ),
    "operation.not-locked": entry(
        "{name} is not locked by an alarm, so there is nothing to unlock.",
        name="text",
    ),
    "operation.unknown-axis": entry(
        "The machine has no axis {axis!r}.",
        "Use letters of {axes}.",
        axis="text",
        axes="text",
    ),
    "operation.unknown-output": entry(
        "The machine has no output {output}.",
        "Use one of its outputs: {outputs}.",
        output="number",
        outputs="texts",
    ),
    "operation.unsupported": entry(
        "{name} cannot carry out the operation {request}.",
        "Carry it out at the machine.",
        name="text",
        request="text",
    ),
}
