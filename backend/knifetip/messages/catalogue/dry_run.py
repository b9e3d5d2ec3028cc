"""dry_run: messages about runs above the board while a job waits for its operator."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "dry-run.in-progress": entry(
        "The machine is making a dry run of job {job} above the board, so the job was not started.",
        "Wait until the dry run has ended, or stop it. Then start the job.",
        job="text",
    ),
    "dry-run.no-job": entry(
        "No job waits for its start at this machine, so there is no program for a dry run above "
        "the board.",
        "Release a job for this machine, and request the dry run before the job is started.",
    ),
    "dry-run.no-lift": entry(
        "Internal error: line {line} of the dry run must lift the tool straight up to Z "
        "{height:g}, but does something else. Nothing was sent.",
        "Report this to the maker of knifetip, with the program of the job.",
        line="count",
        height="number",
    ),
    "dry-run.no-work": entry(
        "The program of the job does not touch the board, so there is no frame to trace above it.",
        "Open the job and check its program.",
    ),
    "dry-run.not-running": entry(
        "The machine is not making a dry run, so there is nothing to hold or to resume.",
    ),
    "dry-run.other-path": entry(
        "Internal error: line {line} of the dry run leaves the path of the program. Nothing was "
        "sent.",
        "Report this to the maker of knifetip, with the program of the job.",
        line="count",
    ),
    "dry-run.switches": entry(
        "Internal error: line {line} of the dry run switches an output or the spindle on. Nothing "
        "was sent.",
        "Report this to the maker of knifetip, with the program of the job.",
        line="count",
    ),
    "dry-run.too-low": entry(
        "Internal error: line {line} of the dry run moves Z to {z:g}, but Z must stay at "
        "{height:g} or higher. Nothing was sent.",
        "Report this to the maker of knifetip, with the program of the job.",
        line="count",
        z="number",
        height="number",
    ),
    "dry-run.unknown-line": entry(
        "Line {line} of the program cannot be used in a dry run above the board: {text!r}. Nothing "
        "was sent.",
        "Compile the job again. A program that was edited by hand cannot be used in a dry run.",
        line="count",
        text="text",
    ),
    "dry-run.uses-machine": entry(
        "The machine is making a dry run above the board.",
        "Wait until the dry run has ended, or stop it first.",
    ),
    "tool-check.in-zone": entry(
        "The point lies in the keep-out zone {zone}, or so near that the tool would touch it. "
        "Nothing has moved.",
        "Choose another point.",
        zone="text",
    ),
    "tool-check.large-shift": entry(
        "In a tool check, a station can be corrected by at most {largest:g} mm or degrees.",
        "Measure the datum of the station again, and change it in the machine file.",
        largest="number",
    ),
    "tool-check.not-lowered": entry(
        "The tool is above the point, but was not lowered: Z would have to move to {target:.1f}, "
        "and its travel ends at {lowest:g}.",
        "Check the tool from above. If the tool must go lower, correct the Z of the station in the "
        "machine file.",
        target="number",
        lowest="number",
    ),
    "tool-check.not-reached": entry(
        "Z did not come to rest at {target:.1f} in time, so the tool was lifted again.",
        "Check the machine, then try again.",
        target="number",
    ),
    "tool-check.not-lowered-beam": entry(
        "The laser is above the point, but was not lowered or switched on.",
        "Check its position with the pointer of the laser, if it has one.",
    ),
}
