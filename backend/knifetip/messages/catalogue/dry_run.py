"""dry_run: messages about runs above the board while a job waits for its operator."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "dry-run.in-progress": entry(
        "The machine runs above the board for job {job}. The job was not started.",
        "Wait until the run has ended, or stop it. Then start the job.",
        job="text",
    ),
    "dry-run.no-job": entry(
        "No job waits for its start at this machine, so there is nothing to run above the board.",
        "Release a job for this machine, and ask before it is started.",
    ),
    "dry-run.no-lift": entry(
        "Line {line} of the dry program is not a lift straight up to Z {height:g}. Nothing was "
        "sent.",
        "Report this to the maker of knifetip, with the program of the job.",
        line="count",
        height="number",
    ),
    "dry-run.no-work": entry(
        "The program of the job does no work in the board, so it has no frame.",
        "Open the job and check its program.",
    ),
    "dry-run.not-running": entry(
        "The machine runs no program above the board, so there is nothing to hold or to resume.",
    ),
    "dry-run.other-path": entry(
        "Line {line} of the dry program leaves the path of the program. Nothing was sent.",
        "Report this to the maker of knifetip, with the program of the job.",
        line="count",
    ),
    "dry-run.switches": entry(
        "Line {line} of the dry program switches something on. Nothing was sent.",
        "Report this to the maker of knifetip, with the program of the job.",
        line="count",
    ),
    "dry-run.too-low": entry(
        "Line {line} of the dry program moves Z to {z:g}, below {height:g}. Nothing was sent.",
        "Report this to the maker of knifetip, with the program of the job.",
        line="count",
        z="number",
        height="number",
    ),
    "dry-run.unknown-line": entry(
        "Line {line} of the program cannot be run above the board: {text!r}. Nothing was sent.",
        "Have the job compiled again. A program that was edited by hand cannot be run dry.",
        line="count",
        text="text",
    ),
    "dry-run.uses-machine": entry(
        "The machine runs a program above the board.",
        "Wait until the run has ended, or stop it first.",
    ),
}
