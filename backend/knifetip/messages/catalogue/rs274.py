"""rs274: lines of a G-code program that the verifier rejects."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "rs274.after-end": entry("The line comes after the end of the program."),
    "rs274.axis-without-motion": entry("The line has axis words and no G0, G1, G2 or G3."),
    "rs274.bad-arc": entry(
        "The ends of the arc differ in radius by more than {limit:g} mm.",
        limit="number",
    ),
    "rs274.bad-character": entry(
        "The character {character!r} has no meaning here.",
        "Remove it.",
        character="text",
    ),
    "rs274.bad-feed": entry("The feed (F) is not greater than 0."),
    "rs274.bad-line-number": entry("The line number (N) is not a whole number of 0 or more."),
    "rs274.centre-without-arc": entry("The line has the centre of an arc (I, J) and no G2 or G3."),
    "rs274.change-without-station": entry(
        "The line changes the station (M6), and none has been called (T).",
    ),
    "rs274.control-byte": entry(
        "The byte {byte} acts on the controller at once, even in a comment.",
        "Remove it.",
        byte="text",
    ),
    "rs274.ends-lowered": entry("The program ends with a station lowered."),
    "rs274.ends-oscillating": entry("The program ends while a tool oscillates or turns."),
    "rs274.ends-output-on": entry("The program ends with an output on."),
    "rs274.ends-with-offset": entry(
        "The program ends with the offset of a station in force.",
        "Cancel it (G49) before the end.",
    ),
    "rs274.g64-unsupported": entry(
        "G64 is rejected by controllers without a tool table.",
        "Remove it.",
    ),
    "rs274.incomplete-arc": entry("The arc lacks X, Y, I or J."),
    "rs274.letter-without-number": entry("The letter {letter} has no number.", letter="text"),
    "rs274.line-too-long": entry(
        "The line is longer than {limit} characters, more than a controller reads.",
        limit="count",
    ),
    "rs274.missing-p": entry("The line lacks its P word."),
    "rs274.mode-g17": entry("the XY plane (G17)"),
    "rs274.mode-g21": entry("millimetres (G21)"),
    "rs274.mode-g40": entry("no radius compensation (G40)"),
    "rs274.mode-g49": entry("no tool length (G49)"),
    "rs274.mode-g54": entry("the coordinate system (G54)"),
    "rs274.mode-g90": entry("absolute distances (G90)"),
    "rs274.mode-g91-1": entry("arc centres from the start (G91.1)"),
    "rs274.mode-g94": entry("the feed mode (G94)"),
    "rs274.motion-without-axis": entry("The line has a motion word and no axis word."),
    "rs274.moves-and-switches": entry(
        "The line moves and switches something at once.",
        "Write them on two lines.",
    ),
    "rs274.moves-unstated": entry(
        "The line moves before the program states {mode}.",
        mode="message",
    ),
    "rs274.nested-comment": entry(
        "A comment opens inside another comment.",
        "Close the first one before it.",
    ),
    "rs274.no-end": entry("The program ends without M2 or M30."),
    "rs274.no-feed": entry("The line feeds, and no F has been stated since the feed mode was set."),
    "rs274.not-settled": entry(
        "The line moves before what was switched has settled.",
        "Dwell (G4) before it.",
    ),
    "rs274.number-too-large": entry("A number is beyond 1,000,000."),
    "rs274.offset-without-station": entry(
        "The line applies the offset of a station (G43), and none has been called (T).",
    ),
    "rs274.open-comment": entry("A comment is not closed.", "End it with ) on the same line."),
    "rs274.repeated-word": entry("Two words of the line set the same thing."),
    "rs274.speed-without-m3": entry("The line has a speed (S) and no M3."),
    "rs274.stray-p": entry("The P word belongs to no other word of the line, or to two."),
    "rs274.stray-q": entry("The Q word belongs to no other word of the line."),
    "rs274.timed-without-f": entry("The move is timed (G93) and has no F."),
    "rs274.too-many-digits": entry("A number has more than 15 digits."),
    "rs274.unbounded-rounding": entry(
        "The line works while nothing limits how far corners are rounded.",
        "State the limit with G64 P before it.",
    ),
    "rs274.unknown-letter": entry("The letter {letter} is not supported.", letter="text"),
    "rs274.unknown-output": entry("{machine} has no such output.", machine="text"),
    "rs274.unknown-station": entry("{machine} has no such station (T).", machine="text"),
    "rs274.unknown-word": entry("{word} is not supported.", word="text"),
    "rs274.wrong-dwell": entry(
        "The dwell (G4) does not last as long as the machine needs ({settle:g} s).",
        settle="number",
    ),
    "rs274.wrong-speed": entry("M3 has another speed (S) than the tool's."),
}
