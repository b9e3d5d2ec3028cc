"""waiting: messages that state why a job waits, and what the operator can do."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "waiting.check-refused": entry(
        "{machine} has not begun the program: no line of it was executed. {reason}",
        "{reason:hint} Then try it again, or compile the job again, or cancel it. Other jobs of "
        "the queue go on.",
        machine="text",
        reason="message",
    ),
    "waiting.confirmed": entry(
        "The operator confirmed the job, and {machine} is starting.",
        machine="text",
    ),
    "waiting.for-controller": entry(
        "The job waits, because the gateway of {machine} (the program that sends jobs to the "
        "machine) is not connected to the controller of the machine.",
        "Switch on the controller and check its cable.",
        machine="text",
    ),
    "waiting.controller-not-connected": entry(
        "The job waits, because the gateway of {machine} is not connected to the controller of the "
        "machine. {reason}",
        "{reason:hint}",
        machine="text",
        reason="message",
    ),
    "waiting.obstacle": entry(
        "The job waits, because {machine} takes no job now. {reason}",
        "{reason:hint}",
        machine="text",
        reason="message",
    ),
    "waiting.for-end": entry(
        "The whole program was sent to {machine}, which does not report when it has finished.",
        "When the machine has finished and is at rest, confirm this on the station page or with "
        "knifetip job end: the copy is then finished. If the machine has not finished the program, "
        "cancel the job.",
        machine="text",
    ),
    "waiting.for-gateway": entry(
        "The job waits, because the gateway of {machine} (the program that sends jobs to the "
        "machine) is not connected to the server.",
        "Switch on the machine and start its gateway.",
        machine="text",
    ),
    "waiting.for-machine": entry(
        "The job waits until the gateway of {machine} (the program that sends jobs to the "
        "machine) takes the job from the queue.",
        machine="text",
    ),
    "waiting.for-person": entry(
        "The job waits, because the gateway of {machine} (the program that sends jobs to the "
        "machine) is not connected to the server.",
        "{advice}",
        machine="text",
        advice="message",
    ),
    "waiting.for-sheet": entry(
        "Copy {copy} of {copies} of the job is finished. The next copy needs a new sheet.",
        "Put a new sheet of {board} on the table, then confirm the new sheet. The machine then "
        "starts the next copy. {sheet}",
        copy="count",
        copies="count",
        board="text",
        sheet="message?",
    ),
    "waiting.for-rest": entry(
        "The job waits until the operator of {machine} confirms that the sheet of job {job}, of "
        "which it makes the rest, still lies in its place. Required: board {board!r}. {details: }",
        "Check that the sheet has not moved and that all tools are whole, then confirm the job to "
        "start it. If the sheet has moved or is gone, cancel the job.",
        machine="text",
        job="text",
        board="text",
        details="messages",
    ),
    "waiting.for-start": entry(
        "The job waits until the operator of {machine} confirms that the table is clear. "
        "Required: board {board!r}. {details: }",
        "Check the table, then confirm the job to start it.",
        machine="text",
        board="text",
        details="messages",
    ),
    "waiting.for-turn": entry(
        "The job waits until {machine} has finished the jobs that come before it in the queue.",
        machine="text",
    ),
    "waiting.on-hold": entry(
        "The job is on hold in the queue of {machine}. Other jobs are taken before it.",
        "End the hold to let the machine take the job.",
        machine="text",
    ),
    "waiting.taken": entry(
        "The job waits, because {machine} is occupied by job {job}, which is {state}.",
        machine="text",
        job="text",
        state="text",
    ),
    "waiting.taken-interrupted": entry(
        "The job waits, because {machine} is occupied by job {job}, which is interrupted.",
        "Mark that job finished, queue it again or scrap it first.",
        machine="text",
        job="text",
    ),
    "waiting.taken-unconfirmed": entry(
        "The job waits, because {machine} is occupied by job {job}, which waits for its "
        "confirmation.",
        "Confirm or cancel that job.",
        machine="text",
        job="text",
    ),
    "waiting.outdated": entry(
        "The program of the job is out of date: {changes:; }.",
        "Compile the job again. Its program is then made and verified for the present machine and "
        "board.",
        changes="messages",
    ),
    "waiting.sheet-outline": entry(
        "The sheet must be cut to the outline of the drawing.",
    ),
    "waiting.sheet-size": entry(
        "The sheet must be cut to {width:g} × {height:g} mm.",
        width="number",
        height="number",
    ),
    "waiting.tool": entry(
        "{name} (station {station})",
        name="text",
        station="count",
    ),
    "waiting.tools": entry(
        "Tools: {tools:, }.",
        tools="messages",
    ),
    "waiting.unfinished-sheet": entry(
        "The unfinished sheet of job {job} may still lie on it.",
        job="text",
    ),
    "waiting.unconfirmed-run": entry(
        "{machine} was started, but the operator has not confirmed that the table is clear. "
        "Required: board {board!r}. {details: }",
        "Check the table. Confirm the job to let it continue, or cancel it.",
        machine="text",
        board="text",
        details="messages",
    ),
}
