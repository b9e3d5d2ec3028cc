"""check: what a person checks at the machine before it starts a job or its next copy."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "check.begun-sheet": entry(
        "The begun sheet of job {job} lies in its place, unmoved.",
        job="text",
    ),
    "check.board": entry(
        "The board on the table is {board}. {caliper}",
        board="text",
        caliper="message?",
    ),
    "check.caliper": entry(
        "It is {caliper:g} mm thick.",
        caliper="number",
    ),
    "check.fed-sheet": entry(
        "a sheet of the stack lies in its place",
    ),
    "check.fed-table": entry(
        "the sheet before it was removed",
    ),
    "check.hands": entry(
        "Hands and people are clear of the machine.",
    ),
    "check.named": entry(
        "{id} ({text})",
        id="text",
        text="message",
    ),
    "check.setup": entry(
        "Prepared: {note}",
        note="text",
    ),
    "check.sheet-at-stops": entry(
        "The printed sheet lies at the stops, exactly where the drawing begins. {stated}",
        stated="message",
    ),
    "check.sheet-larger": entry(
        "A sheet that is larger than the drawing lies in its place. {place}",
        place="message?",
    ),
    "check.sheet-measured": entry(
        "The printed sheet has not moved since its marks were measured. {stated}",
        stated="message",
    ),
    "check.sheet-outline": entry(
        "The sheet, cut to the outline of the drawing, lies in its place. {place}",
        place="message?",
    ),
    "check.sheet-place": entry(
        "Its lower left corner is at X {x:g}, Y {y:g} mm.",
        x="number",
        y="number",
    ),
    "check.drawing-place": entry(
        "The lower left corner of the drawing is at X {x:g}, Y {y:g} mm.",
        x="number",
        y="number",
    ),
    "check.sheet-size": entry(
        "A sheet of {width:g} × {height:g} mm lies in its place. {place}",
        width="number",
        height="number",
        place="message?",
    ),
    "check.station": entry(
        "Station {station} holds {tool}, and the tool is not damaged.",
        station="count",
        tool="text",
    ),
    "check.table": entry(
        "Nothing lies on the table except the sheet.",
    ),
    "check.table-next": entry(
        "The finished sheet is removed, and nothing lies on the table except the new one.",
    ),
    "check.unfinished-sheet": entry(
        "The unfinished sheet of job {job} is removed.",
        job="text",
    ),
}
