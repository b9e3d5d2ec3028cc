"""hpgl: HPGL programs that cannot be emitted, or that the verifier rejects."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "hpgl.bad-byte": entry("The byte {byte} has no meaning here.", "Remove it.", byte="text"),
    "hpgl.bad-feed": entry(
        "{place} has a feed of {feed:g} mm/min, and {device} has whole cm/s from {slowest} to "
        "{fastest}.",
        "Give the tool a feed that is a multiple of {step:g} mm/min.",
        place="message",
        feed="number",
        device="text",
        slowest="count",
        fastest="count",
        step="number",
    ),
    "hpgl.bad-number": entry("A sign has no number, or a number has too many digits."),
    "hpgl.depth-change": entry(
        "{place} changes its depth while it works.",
        "Work in one pass.",
        place="message",
    ),
    "hpgl.ends-down": entry("The program ends with the tool down."),
    "hpgl.ends-with-pen": entry("The program ends without putting the tool away (SP0)."),
    "hpgl.force-out-of-range": entry(
        "The force (FS) is not between {low} and {high}.",
        low="count",
        high="count",
    ),
    "hpgl.initialised-again": entry("The device is initialised again (IN) after the start."),
    "hpgl.lone-letter": entry("A letter does not belong to an instruction of two letters."),
    "hpgl.loose-number": entry("A number belongs to no instruction."),
    "hpgl.moves-before-pa": entry("The line moves before absolute coordinates are stated (PA)."),
    "hpgl.needs-no-number": entry("The instruction takes no number."),
    "hpgl.needs-one-number": entry("The instruction needs exactly one number."),
    "hpgl.never-down": entry(
        "The toolpath never goes down.",
        "Give at least one edge a line type that the machine makes.",
    ),
    "hpgl.no-approach": entry(
        "{place} begins the work of its station, and no rapid leads there.",
        "Begin each station with a rapid.",
        place="message",
    ),
    "hpgl.no-device": entry(
        "{machine} has no HPGL device.",
        "Describe it under [controller] of its TOML.",
        machine="text",
    ),
    "hpgl.no-force-setting": entry("The device has no force setting (FS)."),
    "hpgl.no-instruction": entry("The program has no instruction."),
    "hpgl.no-pen": entry(
        "{machine} has no pen for {work} with station {station}.",
        "Add a [[controller.pen]] to its TOML.",
        machine="text",
        work="text",
        station="count",
    ),
    "hpgl.no-pen-selected": entry("The line lowers the tool, and no pen is selected."),
    "hpgl.no-speed": entry("The line works, and no speed has been set (VS)."),
    "hpgl.no-speed-setting": entry("The device has no speed setting (VS)."),
    "hpgl.no-terminator": entry("The program ends without a semicolon."),
    "hpgl.not-initialised": entry("The first instruction is not IN."),
    "hpgl.outside-area": entry("The line leaves the area of the device."),
    "hpgl.plunge-without-move": entry(
        "The line lowers the tool and moves nowhere, so its heading is not known.",
    ),
    "hpgl.press": entry(
        "{place} presses the tool in one place, where HPGL cannot turn it.",
        'Choose a board with short_crease = "refuse", or another machine.',
        place="message",
    ),
    "hpgl.selects-while-down": entry(
        "The line selects a pen while the tool is down.",
        "Lift it first (PU).",
    ),
    "hpgl.slanted-plunge": entry(
        "{place} goes down or up along a slope.",
        "Choose a tool that goes straight down.",
        place="message",
    ),
    "hpgl.speed-out-of-range": entry(
        "The speed (VS) is not between {low} and {high}.",
        low="count",
        high="count",
    ),
    "hpgl.swivel": entry(
        "{place} turns the head about the tip.",
        "Give the knife no trail: the device compensates it.",
        place="message",
    ),
    "hpgl.turn-in-board": entry(
        "The tool turns by {degrees:.2f}° in the board; at most {most:.2f}° is allowed.",
        "Lift it before the corner.",
        degrees="number",
        most="number",
    ),
    "hpgl.unknown-instruction": entry("The instruction {name} is not supported.", name="text"),
    "hpgl.unknown-pen": entry("The device has no such pen."),
    "hpgl.wrong-force": entry(
        "The line lowers pen {pen} with another force than its own (FS{force}).",
        pen="count",
        force="count",
    ),
    "hpgl.x-without-y": entry("An X has no Y."),
}
