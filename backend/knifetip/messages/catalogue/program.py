"""program: toolpaths and programs that cannot be made or read."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "program.bad-tolerance": entry(
        "A tolerance of {tolerance} mm leaves nothing for the controller's path blending.",
        "Give 0.001 mm or more.",
        tolerance="number",
    ),
    "program.control-byte": entry(
        "Line {line} has the byte 0x{byte}, which the controller would execute at once.",
        "Compile the job again; a program contains none of ? ! ~ and no control bytes.",
        line="count",
        byte="text",
    ),
    "program.line-too-long": entry(
        "Row {row} of the toolpath needs a line of {length} characters ({line} …), and {dialect} "
        "accepts {limit}.",
        "Check the coordinates: they exceed any real table.",
        row="count",
        length="count",
        line="text",
        dialect="text",
        limit="count",
    ),
    "program.line-too-long-to-send": entry(
        "Line {line} has {length} bytes; {name} accepts {limit}.",
        "Compile the job again with shorter notes.",
        line="count",
        length="count",
        name="text",
        limit="count",
    ),
    "program.no-placement": entry(
        "{program} does not state where on the sheet it places the drawing.",
        "Give --placement X,Y, as its report states it.",
        program="text",
    ),
    "program.not-bytes": entry(
        "The program is a {type}, not bytes.",
        "Give the bytes of the file.",
        type="text",
    ),
    "program.not-fetched": entry(
        "The program of job {job} could not be fetched ({reason}); nothing was sent to the "
        "machine.",
        "Queue the job again.",
        job="text",
        reason="text",
    ),
    "program.too-large": entry(
        "The program has {bytes:,} bytes; at most {limit:,} are read.",
        "Split the job into several sheets.",
        bytes="count",
        limit="count",
    ),
    "program.too-many-lines": entry(
        "The program has {lines:,} lines; at most {limit:,} are read.",
        "Split the job into several sheets.",
        lines="count",
        limit="count",
    ),
    "program.too-many-moves": entry(
        "The program has {moves:,} moves; at most {limit:,} are read.",
        "Split the job into several sheets.",
        moves="count",
        limit="count",
    ),
    "program.wrong-checksum": entry(
        "The program of job {job} arrived with SHA-256 {arrived}…, not {expected}…; nothing was "
        "sent to the machine.",
        "Queue the job again; if this is repeated, compile it again.",
        job="text",
        arrived="text",
        expected="text",
    ),
    "toolpath.arc-too-long": entry(
        "{place} is an arc of more than half a turn: {move}.",
        "Send the drawing with a report: an earlier stage went wrong.",
        place="message",
        move="text",
    ),
    "toolpath.empty": entry(
        "The toolpath has no moves.",
        "Give at least one edge a line type that the machine makes.",
    ),
    "toolpath.feed-too-fast": entry(
        "{place} has a feed beyond any machine: {move}.",
        "Check the tool's feed.",
        place="message",
        move="text",
    ),
    "toolpath.no-approach": entry(
        "{place} begins the work of station {station} and is not a rapid: the head is not there "
        "yet.",
        "Begin each station with a rapid.",
        place="message",
        station="count",
    ),
    "toolpath.no-feed": entry(
        "{place} has no feed: {move}.",
        "Give the tool a feed.",
        place="message",
        move="text",
    ),
    "toolpath.not-finite": entry(
        "{place} has a value that is not a number: {move}.",
        "Send the drawing with a report: an earlier stage went wrong.",
        place="message",
        move="text",
    ),
    "toolpath.rapid-arc": entry(
        "{place} is a rapid along an arc: {move}.",
        "Send the drawing with a report: an earlier stage went wrong.",
        place="message",
        move="text",
    ),
    "toolpath.row": entry("Row {row} of the toolpath ({motion})", row="count", motion="text"),
    "toolpath.row-of-edge": entry(
        "Row {row} of the toolpath ({motion}, edge {edge})",
        row="count",
        motion="text",
        edge="count",
    ),
    "toolpath.swivel-without-turn": entry(
        "Row {row} of the toolpath is a swivel that moves without turning, so its feed in degrees "
        "per minute has no meaning.",
        "Make it a feed.",
        row="count",
    ),
    "toolpath.too-far": entry(
        "{place} is farther than {limit:g} mm away: {move}.",
        "Check the unit.",
        place="message",
        move="text",
        limit="number",
    ),
    "toolpath.unknown-motion": entry(
        "{place} has an unknown motion: {move}.",
        "Send the drawing with a report: an earlier stage went wrong.",
        place="message",
        move="text",
    ),
    "toolpath.unknown-station": entry(
        "{place} is for station {station}, which {machine} does not have.",
        "Its stations are {known:, }.",
        place="message",
        station="count",
        machine="text",
        known="texts",
    ),
    "travel.above": entry(
        "{tool} (station {station}) would go {excess:.2f}{unit} above the travel of axis {axis} "
        "({low:g} to {high:g}{unit}){place}.",
        "Place the drawing elsewhere on the table, turn it, or choose a larger machine.",
        tool="text",
        station="count",
        excess="number",
        unit="text",
        axis="text",
        low="number",
        high="number",
        place="message?",
    ),
    "travel.below": entry(
        "{tool} (station {station}) would go {excess:.2f}{unit} below the travel of axis {axis} "
        "({low:g} to {high:g}{unit}){place}.",
        "Place the drawing elsewhere on the table, turn it, or choose a larger machine.",
        tool="text",
        station="count",
        excess="number",
        unit="text",
        axis="text",
        low="number",
        high="number",
        place="message?",
    ),
    "language.bad-entry-point": entry(
        "The entry point {name!r} of {group} is not a controller language of this name.",
        "Correct or remove the package that declares it.",
        name="text",
        group="text",
    ),
    "language.no-driver": entry(
        "Programs for {language} cannot be streamed: there is no gateway driver.",
        "{advice}",
        language="text",
        advice="text",
    ),
    "language.unknown": entry(
        "There is no controller language {name!r}.",
        "Available: {known:, }.",
        name="text",
        known="texts",
    ),
    "language.unusable": entry(
        "{machine} cannot be driven with {language}: {reason}.",
        "Its own language is {own}.",
        machine="text",
        language="text",
        reason="text",
        own="text",
    ),
}
