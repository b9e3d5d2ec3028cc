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
    "tool-check.in-zone": entry(
        "The point lies in the keep-out zone {zone}, or so near that the tool would touch it. "
        "Nothing has moved.",
        "Choose another point.",
        zone="text",
    ),
    "tool-check.large-shift": entry(
        "A correction of a station in a tool check is at most {largest:g} mm or degrees.",
        "Measure the datum of the station again, and change it in the machine file.",
        largest="number",
    ),
    "tool-check.not-lowered": entry(
        "The tool is above the point, but was not lowered: Z would have to move to {target:.1f}, "
        "and its travel ends at {lowest:g}.",
        "Check the tool from above, and the Z of the station in the machine file.",
        target="number",
        lowest="number",
    ),
    "tool-check.not-reached": entry(
        "Z has not come to rest at {target:.1f} in time. The tool was lifted again.",
        "Check the machine, then try again.",
        target="number",
    ),
    "tool-check.not-lowered-beam": entry(
        "The laser is above the point, but was not lowered or switched on.",
        "Check its position with the pointer of the laser, if it has one.",
    ),
}
