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
    "operation.bad-override": entry(
        "A feed override of {percent} % is not possible on this machine.",
        "Choose {low} to {high} %.",
        percent="count",
        low="count",
        high="count",
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
        "The operation was not executed within {seconds:g} s and was dropped. Nothing was sent "
        "to the machine.",
        "Check the connection of the gateway to the server and to the machine, then try again.",
        seconds="number",
    ),
    "operation.gateway-absent": entry(
        "No gateway of {machine} is connected, so nothing can be sent to the machine.",
        "Switch on the machine and start its gateway.",
        machine="text",
    ),
    "operation.hands-not-clear": entry(
        "The request {request} moves {machine}, but within the last {seconds:g} s nobody has "
        "confirmed that all hands are clear of it.",
        "Make sure that nobody reaches into the machine, press Hands clear on the station page, "
        "then repeat the request.",
        request="text",
        machine="text",
        seconds="number",
    ),
    "operation.jog-ended": entry(
        "The jog {id} has ended: its button was not reported as held within {seconds:g} s, or the "
        "machine has refused it.",
        "Release the button, and press it again.",
        id="text",
        seconds="number",
    ),
    "operation.job-on-machine": entry(
        "The machine executes a job, so it does nothing else.",
        "Wait until the job has ended, or cancel it.",
    ),
    "operation.job-running": entry(
        "Job {job} is {state} on {machine}, so the machine does nothing else.",
        "Wait until the job has ended, or cancel it.",
        job="text",
        state="text",
        machine="text",
    ),
    "operation.missing-argument": entry(
        "The operation {request} needs the field {name}.",
        "Add the field to the request.",
        request="text",
        name="text",
    ),
    "operation.door-open": entry(
        "The safety door of {name} is open. Nothing was sent.",
        "Close the safety door, then press Release.",
        name="text",
    ),
    "operation.nothing-held": entry(
        "{name} is not on hold, so there is nothing to release.",
        "If an alarm locks the machine, unlock or home it.",
        name="text",
    ),
    "operation.no-controller": entry(
        "The gateway of {machine} is not connected to the controller of the machine.",
        "Switch on the controller and check its cable.",
        machine="text",
    ),
    "operation.no-result": entry(
        "The gateway received the operation, but has not reported its result.",
        "Look at the machine before you ask for anything else.",
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
    "operation.no-station": entry(
        "{machine} has no station {station}, or no point was given for it.",
        "Choose a station of the machine, and a point on its table.",
        station="number",
        machine="text",
    ),
    "operation.no-spindle": entry(
        "Station {station} of {machine} has no spindle or oscillation that is switched by hand.",
        "Choose a station with a knife that oscillates or with a cutter.",
        station="number",
        machine="text",
    ),
    "operation.stopped": entry(
        "A person has stopped {name} before the operation was complete.",
        name="text",
    ),
    "operation.unknown": entry(
        "There is no operation {id} of {machine}.",
        "Ask for the operation again: operations are kept for a short time only.",
        id="text",
        machine="text",
    ),
    "operation.override-not-confirmed": entry(
        "{name} reports a feed override of {found} % instead of {percent} %.",
        "Press the button again; if the override does not change, look at the controller.",
        name="text",
        found="count",
        percent="count",
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
    "operation.unreported": entry(
        "The controller of {machine} takes whole programs and reports nothing, so it cannot carry "
        "out the operation {request}.",
        "Use the controls of the machine itself. To see the path without work, raise or remove the "
        "tool, or draw the program with a pen.",
        machine="text",
        request="text",
    ),
    "operation.unsupported": entry(
        "{name} cannot execute the operation {request}.",
        "Carry it out at the machine.",
        name="text",
        request="text",
    ),
}
