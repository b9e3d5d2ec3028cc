"""nesting: messages about searches for the places of drawings on sheets."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "nesting.failed": entry(
        "the nesting has failed because of an internal error; the best arrangement so far is kept",
        "Repeat it. If it fails again, send the log of the server to the maintainers.",
    ),
    "nesting.no-room": entry(
        "the margins leave no room on the sheet of {width:.6g} × {height:.6g} mm",
        "Reduce the margins, or use a larger sheet.",
        width="number",
        height="number",
    ),
    "nesting.of-another": entry(
        "nesting {id} belongs to another user",
        "Ask the user who began it, or an operator.",
        id="text",
    ),
    "nesting.output": entry(
        "the output file {file} has another ending than .json and .dxf",
        "Choose a name that ends with .json or .dxf.",
        file="text",
    ),
    "nesting.result": entry(
        "{file}: sheets: {sheets}; use of the board {use:.4g} %, with rectangles "
        "{rectangles:.4g} %; in holes: {in_holes}",
        file="text",
        sheets="count",
        use="number",
        rectangles="number",
        in_holes="count",
    ),
    "nesting.sheet-size": entry(
        "“{text}” is not the size of a sheet",
        "Write width and height in mm, such as 1200x800; for left-over sheets 600x400x2 for two.",
        text="text",
    ),
    "nesting.too-large": entry(
        "part {part} of {width:.6g} × {height:.6g} mm fits on no sheet within the margins",
        "Use a larger sheet, permit more turns, or reduce the margins.",
        part="count",
        width="number",
        height="number",
    ),
    "nesting.too-many-sheets": entry(
        "the copies need more than {limit} sheets",
        "Place fewer copies, or use a larger sheet.",
        limit="count",
    ),
    "nesting.unknown": entry(
        "there is no nesting {id}",
        "Begin a new one; a server keeps the last 500.",
        id="text",
    ),
}
