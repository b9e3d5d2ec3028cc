"""waiting: messages about the event that a job waits for, and the operator's possible actions."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "waiting.confirmed": entry(
        "Confirmed; {machine} is starting.",
        machine="text",
    ),
    "waiting.for-gateway": entry(
        "No gateway of {machine} asks for work.",
        "Switch on the machine and its gateway.",
        machine="text",
    ),
    "waiting.for-machine": entry(
        "Waiting until {machine} takes it.",
        machine="text",
    ),
    "waiting.for-person": entry(
        "No gateway of {machine} asks for work.",
        "{advice}",
        machine="text",
        advice="text",
    ),
    "waiting.for-sheet": entry(
        "Copy {copy} of {copies} is done.",
        "Put a new sheet of {board} on the table and confirm.",
        copy="count",
        copies="count",
        board="text",
    ),
    "waiting.for-start": entry(
        "Waiting for the operator at {machine}: table clear, board {board!r}{tools}.",
        "Check the table, then confirm to start.",
        machine="text",
        board="text",
        tools="message?",
    ),
    "waiting.for-turn": entry(
        "Waiting for its turn at {machine}; other jobs come first.",
        machine="text",
    ),
    "waiting.taken": entry(
        "{machine} is taken by job {job}, which is {state}.",
        machine="text",
        job="text",
        state="text",
    ),
    "waiting.taken-interrupted": entry(
        "{machine} is taken by job {job}, which is interrupted.",
        "Mark that job finished, queue it again or scrap it first.",
        machine="text",
        job="text",
    ),
    "waiting.taken-unconfirmed": entry(
        "{machine} is taken by job {job}, which waits for its confirmation.",
        machine="text",
        job="text",
    ),
    "waiting.tool": entry(
        "{name} (station {station})",
        name="text",
        station="count",
    ),
    "waiting.tools": entry(
        ", tools: {tools:, }",
        tools="messages",
    ),
    "waiting.unconfirmed-run": entry(
        "{machine} was started without the operator's confirmation: board {board!r}{tools}.",
        "Look at the table. Confirm to let the job go on, or cancel it.",
        machine="text",
        board="text",
        tools="message?",
    ),
}
