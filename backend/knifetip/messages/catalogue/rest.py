"""rest: messages about jobs that make the rest of a sheet after an interruption."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "rest.bound-to-sheet": entry(
        "Job {job} completes the sheet that lies on the machine {machine}, so its machine and its "
        "number of copies cannot be changed.",
        "Order one more copy of the whole job. It can have another machine and number of copies.",
        job="text",
        machine="text",
    ),
    "rest.continue-first": entry(
        "{interruption}",
        "Continue this sheet, {tracks} left. {interruption:hint}",
        tracks="message",
        interruption="message",
    ),
    "rest.continued-already": entry(
        "Job {other} already continues the sheet of job {job}.",
        "Continue that job instead, or cancel it before it begins.",
        job="text",
        other="text",
    ),
    "rest.continued-by": entry(
        "Job {job} continues the work of this job.",
        job="text",
    ),
    "rest.continues": entry(
        "The job was created to make the rest of the sheet of job {job}.",
        job="text",
    ),
    "rest.copy-of": entry(
        "The job was created to make the whole program of job {job} again.",
        job="text",
    ),
    "rest.line-changed": entry(
        "The machine has meanwhile reported that it executed {line} program lines of job {job}.",
        "Look at the tracks again and choose where to continue.",
        line="count",
        job="text",
    ),
    "rest.no-copies": entry(
        "No copy of job {job} remains to be ordered. It was ordered with {copies} copies.",
        "Make one more copy of the whole job if you need more.",
        job="text",
        copies="count",
    ),
    "rest.no-such-station": entry(
        "The program has no tracks of station {station}.",
        "Choose one of the stations that the list of tracks contains.",
        station="count",
    ),
    "rest.no-such-track": entry(
        "The program has no track (uninterrupted run of a tool) with the number {track}. It has "
        "{count} tracks.",
        "Choose a track from the list of tracks.",
        track="count",
        count="count",
    ),
    "rest.no-tracks": entry(
        "No track remains to be made after the chosen place.",
        "Choose an earlier place, or mark the job finished if the sheet is complete.",
    ),
    "rest.not-again": entry(
        "Job {job} makes the rest of a sheet, so it cannot be queued again from its first line.",
        "Continue it from a track, or make one more copy of the whole program.",
        job="text",
    ),
    "rest.not-executed": entry(
        "{count} tracks would be left out, although the machine reported only {executed} executed "
        "program lines. The first of them is track {track}, of station {station}.",
        "Continue from an earlier track. If these tracks are complete on the sheet, confirm that "
        "the skipped tracks are made.",
        count="count",
        track="count",
        station="count",
        executed="count",
    ),
    "rest.old-program": entry(
        "The program was made by an older version of knifetip, which did not store the tracks of a "
        "program.",
        "Make one more copy of the whole job.",
    ),
    "rest.ordered": entry(
        "Job {job} was created to make the rest of the sheet.",
        job="text",
    ),
    "rest.sheet-first": entry(
        "Job {job} is interrupted, and its sheet occupies the table.",
        "Make the rest of the sheet first, or scrap the job. Then order the remaining copies.",
        job="text",
    ),
    "rest.statement-needed": entry(
        "The machine executed {executed} program lines of job {job} for certain, and possibly "
        "more, up to line {most}. It is not known how much of {tracks:# track|# tracks} is made; "
        "the first of them is track {track}.",
        "Look at the sheet, and state the numbers of all tracks that are completely made (made). "
        "The new job makes all others.",
        job="text",
        executed="count",
        most="count",
        tracks="count",
        track="count",
    ),
    "rest.tracks": entry(
        "{count:# track|# tracks}",
        count="count",
    ),
    "rest.tracks-between": entry(
        "{least} to {most:# track|# tracks}",
        least="count",
        most="count",
    ),
    "rest.whole-ordered": entry(
        "Job {job} was created to make the whole program again.",
        job="text",
    ),
    "rest.wrong-state": entry(
        "Job {job} is {state}, so no other job can continue its work.",
        "{advice}",
        job="text",
        state="text",
        advice="message",
    ),
}
