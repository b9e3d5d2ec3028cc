"""program: messages about toolpaths, programs and controller languages, and faults in them."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "motion.feed": entry("cutting move"),
    "motion.lead-in": entry("lead-in"),
    "motion.lead-out": entry("lead-out"),
    "motion.lift": entry("lift"),
    "motion.plunge": entry("plunge"),
    "motion.rapid": entry("rapid move"),
    "motion.swivel": entry(
        "turn of the tool",
    ),
    "motion.unknown": entry("unknown motion type {number}", number="count"),
    "program.bad-tolerance": entry(
        "A tolerance of {tolerance} mm is too small for the path blending (rounding of "
        "corners) of the controller.",
        "Choose a tolerance of 0.001 mm or more.",
        tolerance="number",
    ),
    "program.control-byte": entry(
        "Line {line} of the program contains the byte 0x{byte}, which is a control command "
        "that the controller would execute at once.",
        "Remove the byte, or compile the job again.",
        line="count",
        byte="text",
    ),
    "program.line-too-long": entry(
        "A program line for row {row} of the toolpath has {length} characters ({line} …), but "
        "{dialect} accepts only {limit} characters.",
        "Check the coordinates of the drawing. They are too large for any table.",
        row="count",
        length="count",
        line="text",
        dialect="text",
        limit="count",
    ),
    "program.line-too-long-to-send": entry(
        "Line {line} of the program has {length} bytes, but {name} accepts only {limit} bytes.",
        "Report the error with the program file.",
        line="count",
        length="count",
        name="text",
        limit="count",
    ),
    "program.no-placement": entry(
        "{program} does not contain the position of the drawing on the sheet.",
        "Give the position with --placement X,Y. The report that knifetip program --report "
        "writes contains the position.",
        program="text",
    ),
    "program.not-bytes": entry(
        "The program is of type {type}, but must be bytes.",
        "Pass the content of the file as bytes.",
        type="text",
    ),
    "program.not-fetched": entry(
        "The program of job {job} could not be loaded from the server ({reason}). Nothing was "
        "sent to the machine.",
        "Queue the job again.",
        job="text",
        reason="text",
    ),
    "program.too-large": entry(
        "The program has {bytes:,} bytes; the limit is {limit:,}.",
        "Split the job into several sheets.",
        bytes="count",
        limit="count",
    ),
    "program.too-many-lines": entry(
        "The program has {lines:,} lines; the limit is {limit:,}.",
        "Split the job into several sheets.",
        lines="count",
        limit="count",
    ),
    "program.too-many-moves": entry(
        "The program has {moves:,} moves; the limit is {limit:,}.",
        "Split the job into several sheets.",
        moves="count",
        limit="count",
    ),
    "program.wrong-checksum": entry(
        "The program of job {job} was damaged during its transfer from the server (SHA-256 "
        "{arrived}… instead of {expected}…). Nothing was sent to the machine.",
        "Queue the job again. If this happens again, compile the job again.",
        job="text",
        arrived="text",
        expected="text",
    ),
    "toolpath.arc-too-long": entry(
        "Internal error: {place} is an arc of more than 180°: {move}.",
        "Report the error with the drawing.",
        place="message",
        move="message",
    ),
    "toolpath.empty": entry(
        "The toolpath has no moves, so nothing would be cut.",
        "Give at least one edge a line type for which the machine has a tool.",
    ),
    "toolpath.feed-too-fast": entry(
        "{place} has a feed that is too fast for any machine: {move}.",
        "Correct the feed of the tool in the machine file.",
        place="message",
        move="message",
    ),
    "toolpath.move": entry(
        "from ({start:, }) to ({end:, }), bulge {bulge}, feed {feed}",
        start="texts",
        end="texts",
        bulge="text",
        feed="text",
    ),
    "toolpath.no-approach": entry(
        "Internal error: {place} starts a cut with station {station}, but no rapid move to the "
        "start of the cut precedes it.",
        "Report the error with the drawing.",
        place="message",
        station="count",
    ),
    "toolpath.no-feed": entry(
        "{place} has no feed: {move}.",
        "Set the feed of the tool in the machine file.",
        place="message",
        move="message",
    ),
    "toolpath.not-finite": entry(
        "Internal error: {place} has a value that is not a number: {move}.",
        "Report the error with the drawing.",
        place="message",
        move="message",
    ),
    "toolpath.rapid-arc": entry(
        "Internal error: {place} is a rapid move along an arc: {move}.",
        "Report the error with the drawing.",
        place="message",
        move="message",
    ),
    "toolpath.row": entry("Row {row} of the toolpath ({motion})", row="count", motion="message"),
    "toolpath.row-of-edge": entry(
        "Row {row} of the toolpath ({motion}, edge {edge})",
        row="count",
        motion="message",
        edge="edge",
    ),
    "toolpath.swivel-without-turn": entry(
        "Internal error: row {row} of the toolpath moves the head about the tip of the tool "
        "without rotating the tool, so the feed in degrees per minute is not defined.",
        "Report the error with the drawing.",
        row="count",
    ),
    "toolpath.too-far": entry(
        "{place} is more than {limit:g} mm away from the origin: {move}.",
        "Check the unit of the drawing.",
        place="message",
        move="message",
        limit="number",
    ),
    "toolpath.unknown-motion": entry(
        "Internal error: {place} has an unknown motion type: {move}.",
        "Report the error with the drawing.",
        place="message",
        move="message",
    ),
    "toolpath.unknown-station": entry(
        "{place} uses station {station}, which {machine} does not have.",
        "Choose one of the stations {known:, }.",
        place="message",
        station="count",
        machine="text",
        known="texts",
    ),
    "travel.above": entry(
        "{tool} (station {station}) would move {excess:.2f}{unit} beyond the upper end of the "
        "travel of axis {axis}. The travel is {low:g} to {high:g}{unit}. {place}",
        "For axis X, Y or C, move or rotate the drawing on the table, or choose a larger machine. "
        "For axis Z, check the heights in the machine file.",
        tool="text",
        station="count",
        excess="number",
        unit="text",
        axis="text",
        low="number",
        high="number",
        place="message?",
    ),
    "travel.heads-too-near": entry(
        "{tool} (station {station}) would come as near as {distance:.2f} mm to the parked "
        "carriage {other}. Carriages must stay at least {least:g} mm apart. {place}",
        "Move the drawing along Y, away from the parked carriage, or give the line type to a tool "
        "on the other carriage.",
        tool="text",
        station="count",
        distance="number",
        other="count",
        least="number",
        place="message?",
    ),
    "travel.below": entry(
        "{tool} (station {station}) would move {excess:.2f}{unit} beyond the lower end of the "
        "travel of axis {axis}. The travel is {low:g} to {high:g}{unit}. {place}",
        "For axis X, Y or C, move or rotate the drawing on the table, or choose a larger machine. "
        "For axis Z, check the heights in the machine file.",
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
        "The Python entry point {name!r} of the group {group} must provide a controller language "
        "that is named {name!r}, but does not provide one.",
        "Correct or remove the Python package that declares the entry point.",
        name="text",
        group="text",
    ),
    "language.no-driver": entry(
        "Programs in {language} cannot be sent to a machine, because the gateway has no driver "
        "for this language.",
        "{advice}",
        language="text",
        advice="message?",
    ),
    "language.default-outputs": entry(
        "the machine does not state the number of digital outputs of its controller, and "
        "{language} has {count} by default, numbered from 0, so these outputs do not exist: "
        "{outputs:, }",
        "Use other outputs, or set `output_count` to the number that the controller is configured "
        "for.",
        outputs="texts",
        count="count",
        language="text",
    ),
    "language.few-outputs": entry(
        "the {language} controller has {count:# digital output|# digital outputs}, numbered from "
        "0, so these outputs do not exist: {outputs:, }",
        "Use other outputs, or correct `output_count`.",
        outputs="texts",
        count="count",
        language="text",
    ),
    "language.no-linear-axis": entry(
        "carriage {carriage} has a linear axis {letter}, but {language} has no such axis. Its "
        "linear axes are {known:, }",
        "Change the letter of the axis, or the language (dialect) of the machine.",
        carriage="count",
        letter="text",
        language="text",
        known="texts",
    ),
    "language.no-rotary-axis": entry(
        "carriage {carriage} has a rotary axis {letter}, but {language} has no such axis. Its "
        "rotary axes are {known:, }",
        "Change the letter of the axis, or the language (dialect) of the machine.",
        carriage="count",
        letter="text",
        language="text",
        known="texts",
    ),
    "language.no-settings": entry(
        "{path} is not allowed, because {language} has no settings",
        "Remove the section [controller].",
        path="text",
        language="text",
    ),
    "language.unknown": entry(
        "The controller language {name!r} does not exist.",
        "Choose one of {known:, }.",
        name="text",
        known="texts",
    ),
    "language.unusable": entry(
        "{machine} cannot be controlled with programs in {language}: {faults:; }.",
        "{faults:hint} Choose the language {own}, which the machine file names.",
        machine="text",
        language="text",
        faults="messages",
        own="text",
    ),
}
