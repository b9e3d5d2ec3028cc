"""sheet: messages about the sheet on the table of a machine, and about its keep-out zones,
and about the height of turns.
"""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "board.above-travel": entry(
        "The board is {caliper:g} mm thick, but the head of {machine} travels only {travel:g} mm "
        "above the table and must stay {clearance:g} mm above the board.",
        "Choose a thinner board, or a machine whose head travels higher.",
        caliper="number",
        machine="text",
        travel="number",
        clearance="number",
    ),
    "board.too-thick": entry(
        "The board is {caliper:g} mm thick, but {machine} takes board up to {limit:g} mm.",
        "Choose a thinner board or another machine. The limit is max_caliper in the machine file.",
        caliper="number",
        machine="text",
        limit="number",
    ),
    "lift.not-stated": entry(
        "Tools cannot be lifted less than usual between cuts, because the machine file of "
        "{machine} does not state to which height (turn_clearance).",
        "Let tools be lifted to the clearance of the machine, or set turn_clearance in the machine "
        "file, for example to 0.5 mm for board that lies flat.",
        machine="text",
    ),
    "sheet.bad-size": entry(
        "{text!r} is not a size of a sheet.",
        "Give the width and the height in mm as WIDTHxHEIGHT, with the distance of the drawing "
        "from the left and lower edge as WIDTHxHEIGHT:MARGIN, or outline for a sheet that was cut "
        "to the outline of the drawing.",
        text="text",
    ),
    "sheet.off-table": entry(
        "The sheet would lie from X {x:.1f}, Y {y:.1f} to X {right:.1f}, Y {top:.1f} mm, but the "
        "table of {machine} reaches from 0 to {width:.0f} × {height:.0f} mm.",
        "Choose a smaller margin or sheet, or correct the origin in the machine file.",
        x="number",
        y="number",
        right="number",
        top="number",
        machine="text",
        width="number",
        height="number",
    ),
    "sheet.smaller-than-drawing": entry(
        "The sheet of {width:.1f} × {height:.1f} mm is too small: with its margin of "
        "{margin:.1f} mm the drawing needs {needed_x:.1f} × {needed_y:.1f} mm.",
        "Enter the size and the margin of the sheet on the table, or check the unit of the "
        "drawing.",
        width="number",
        height="number",
        margin="number",
        needed_x="number",
        needed_y="number",
    ),
    "sheet.without-outline": entry(
        "The cuts of the drawing form no closed outline around all of its other lines, so the "
        "outline of the sheet is not known.",
        "Enter the width and the height of the sheet, or close the outline of the drawing.",
    ),
    "zone.work": entry(
        "{tool} (station {station}) would touch the keep-out zone {zone} at X {x:.1f}, Y {y:.1f} "
        "mm: the tool with its holder needs {reach:.1f} mm around its axis. {place}",
        "Move the clamp or stop away from the drawing and correct its zone in the machine file, "
        "or move the origin in the machine file so that the drawing lies beside the zone.",
        tool="text",
        station="count",
        zone="text",
        x="number",
        y="number",
        place="message?",
        reach="number",
    ),
}
