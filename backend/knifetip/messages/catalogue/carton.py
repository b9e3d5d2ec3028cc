"""carton: names of carton styles, and messages about their dimensions."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "carton.ecma-a20.20": entry(
        "Tuck-end carton (ECMA A20.20)",
    ),
    "carton.ecma-a20.20.description": entry(
        "A tuck lid at both ends, reverse or straight, with dust flaps",
    ),
    "carton.ecma-a60.20": entry(
        "Carton with crash-lock bottom (ECMA A60.20)",
    ),
    "carton.ecma-a60.20.description": entry(
        "A tuck lid, and a glued bottom that locks when the carton is opened",
    ),
    "carton.fefco-0200": entry(
        "Slotted case, open at the top (FEFCO 0200)",
    ),
    "carton.fefco-0200.description": entry(
        "Four flaps close the base; the top is open, for a lid or a larger case",
    ),
    "carton.fefco-0201": entry(
        "Slotted case (FEFCO 0201)",
    ),
    "carton.fefco-0201.description": entry(
        "The outer flaps meet in the middle, at base and top",
    ),
    "carton.fefco-0203": entry(
        "Slotted case with full overlap (FEFCO 0203)",
    ),
    "carton.fefco-0203.description": entry(
        "The outer flaps overlap fully, at base and top",
    ),
    "carton.fefco-0215": entry(
        "Tuck box with snap-lock bottom (FEFCO 0215)",
    ),
    "carton.fefco-0215.description": entry(
        "Lid with tuck flap, and four flaps of the base that lock without glue",
    ),
    "carton.fefco-0427": entry(
        "Mailer with rolled walls (FEFCO 0427)",
    ),
    "carton.fefco-0427.description": entry(
        "Double side walls whose tabs lock in the base, and a lid with tuck flap",
    ),
    "carton.fefco-0471": entry(
        "Mailer with double floor (FEFCO 0471)",
    ),
    "carton.fefco-0471.description": entry(
        "As 0427, with inner walls that end in floor flaps on the base",
    ),
    "carton.rigid-box": entry(
        "Rigid box with V-grooves",
    ),
    "carton.rigid-box.description": entry(
        "Base or lid of greyboard whose walls fold along V-grooves",
    ),
    "carton.telescope-tray": entry(
        "Telescope tray (after FEFCO 0301)",
    ),
    "carton.telescope-tray.description": entry(
        "Base or lid whose corner flaps are glued or stitched to the walls",
    ),
    "carton.too-large": entry(
        "{parameter} {value:.4g} is too large for this style in board of {caliper:.4g} mm: it must "
        "be at most {limit:.4g} mm",
        "Choose a smaller value, or change the dimensions on which the limit depends.",
        parameter="text",
        value="number",
        limit="number",
        caliper="number",
    ),
    "carton.too-small": entry(
        "{parameter} {value:.4g} is too small for this style in board of {caliper:.4g} mm: it must "
        "be at least {limit:.4g} mm",
        "Choose a greater value, thinner board, or another style.",
        parameter="text",
        value="number",
        limit="number",
        caliper="number",
    ),
}
