"""rs274: messages about the lines of a G-code program that the verifier rejects."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "rs274.active-comment": entry(
        "LinuxCNC executes the comment in the program line.",
        "Remove the comma from the comment, or delete the comment.",
    ),
    "rs274.after-end": entry(
        "The program line comes after the end of the program (M2 or M30).",
        "Delete the program line.",
    ),
    "rs274.arc-of-other-carriage": entry(
        "The program line has an arc (G2 or G3) while a station of a further carriage is selected. "
        "Controllers make arcs only with X and Y, which move the first carriage.",
        "Replace the arc by short lines (G1) with the letters of the axes of the carriage.",
    ),
    "rs274.arc-on-chord-machine": entry(
        "The program line is an arc (G2, G3), and the controller of {machine} cannot follow arcs.",
        "Create the program again, or set arcs to 'arcs' in the machine file if the controller has "
        "them and turns the tool in them.",
        machine="text",
    ),
    "rs274.axis-without-motion": entry(
        "The program line has coordinates, but no motion word (G0, G1, G2 or G3).",
        "Add G0, G1, G2 or G3.",
    ),
    "rs274.bad-arc": entry(
        "In the program line, the distance from the centre of the arc to the start of the arc "
        "differs by more than {limit:g} mm from the distance from the centre to the end of the "
        "arc.",
        "Correct the centre (I, J) or the end (X, Y) of the arc.",
        limit="number",
    ),
    "rs274.bad-character": entry(
        "The character {character!r} is not allowed at this position of the program line.",
        "Remove the character.",
        character="text",
    ),
    "rs274.bad-feed": entry(
        "The feed (F) in the program line is 0 or negative.",
        "Give a feed greater than 0.",
    ),
    "rs274.bad-line-number": entry(
        "The program line number (N) in the program line is negative, not an integer, or not at "
        "the start of the line.",
        "Correct or delete the line number.",
    ),
    "rs274.centre-without-arc": entry(
        "The program line has the centre of an arc (I, J), but no arc motion (G2 or G3).",
        "Add G2 or G3, or delete I and J.",
    ),
    "rs274.change-without-station": entry(
        "The program line changes the tool (M6), but no station (T) was selected before.",
        "Write the T word of the station before M6.",
    ),
    "rs274.control-byte": entry(
        "The program line contains the byte {byte}, a control command that the controller "
        "would execute at once, even in a comment.",
        "Remove the byte.",
        byte="text",
    ),
    "rs274.ends-lowered": entry(
        "The program ends while a station is lowered.",
        "Raise the station (M65) and lift the head before the end of the program.",
    ),
    "rs274.ends-oscillating": entry(
        "The program ends while a tool oscillates or rotates.",
        "Switch the tool off (M5) before the end of the program.",
    ),
    "rs274.ends-output-on": entry(
        "The program ends while an output is on.",
        "Switch the output off (M65) before the end of the program.",
    ),
    "rs274.ends-with-offset": entry(
        "The program ends while the offset of a station is active.",
        "Cancel the offset (G49) before the end of the program.",
    ),
    "rs274.g64-unsupported": entry(
        "The program line contains G64, which the controller of this machine does not support.",
        "Remove G64.",
    ),
    "rs274.incomplete-arc": entry(
        "The arc in the program line lacks X, Y, I or J.",
        "Give X, Y, I and J.",
    ),
    "rs274.letter-without-number": entry(
        "The letter {letter} in the program line is not followed by a number.",
        "Add the number or delete the letter.",
        letter="text",
    ),
    "rs274.line-too-long": entry(
        "The program line is longer than {limit} characters, the limit of the controller.",
        "Shorten the line.",
        limit="count",
    ),
    "rs274.missing-p": entry(
        "A command in the program line needs a P word, but the line has none.",
        "Add the P word.",
    ),
    "rs274.mode-g17": entry("the XY plane (G17)"),
    "rs274.mode-g21": entry("the unit millimetre (G21)"),
    "rs274.mode-g40": entry("radius compensation off (G40)"),
    "rs274.mode-g49": entry("tool length compensation off (G49)"),
    "rs274.mode-g54": entry(
        "the work coordinate system (G54)",
    ),
    "rs274.mode-g90": entry("absolute coordinates (G90)"),
    "rs274.mode-g91-1": entry("arc centres relative to the start of the arc (G91.1)"),
    "rs274.mode-g92-1": entry("no shift of the coordinates (G92.1)"),
    "rs274.mode-g94": entry("the feed in mm/min (G94)"),
    "rs274.motion-without-axis": entry(
        "The program line has a motion word (G0 to G3), but no coordinates.",
        "Add the coordinates or delete the motion word.",
    ),
    "rs274.moves-and-switches": entry(
        "The program line moves the head and switches an output or the spindle at the same time.",
        "Write the move and the switching command in separate program lines.",
    ),
    "rs274.moves-other-carriage": entry(
        "The feed line moves an axis of another carriage than that of the selected station.",
        "Move other carriages only in rapids (G0), or select a station of the other carriage.",
    ),
    "rs274.moves-unstated": entry(
        "The program line moves the head before the program has set {mode}.",
        "Set this mode at the beginning of the program.",
        mode="message",
    ),
    "rs274.nested-comment": entry(
        "In the program line, a comment begins inside another comment.",
        "Close the first comment before the second comment begins.",
    ),
    "rs274.no-end": entry(
        "The program has no end (M2 or M30).",
        "Add M2 as the last line of the program.",
    ),
    "rs274.no-feed": entry(
        "The program line cuts, but no feed (F) has been set since the feed mode (G93 or G94) "
        "was chosen.",
        "Add an F word.",
    ),
    "rs274.not-settled": entry(
        "The program line moves the head too soon after an output or the spindle was switched.",
        "Add a dwell (G4) before this program line.",
    ),
    "rs274.number-too-large": entry(
        "A number in the program line is larger than 1,000,000.",
        "Correct the number.",
    ),
    "rs274.offset-without-station": entry(
        "The program line applies the offset of a station (G43), but no station (T) was "
        "selected before.",
        "Write the T word of the station before G43.",
    ),
    "rs274.open-comment": entry(
        "A comment in the program line is not closed.",
        "Close the comment with a closing parenthesis in the same program line.",
    ),
    "rs274.repeated-word": entry(
        "The program line has two words that set the same value.",
        "Delete one of the two words.",
    ),
    "rs274.spindle-of-other-station": entry(
        "The station moves while the spindle or oscillation of another station is on.",
        "Switch it off (M5) before the station is changed.",
    ),
    "rs274.wrong-direction": entry(
        "The program line switches the spindle on in the wrong direction for the station.",
        "Use the word that the machine states for the station: M3 or M4.",
    ),
    "rs274.speed-without-m3": entry(
        "The program line has a spindle speed (S), but neither M3 nor M4.",
        "Add M3 or M4, or delete the speed.",
    ),
    "rs274.stray-p": entry(
        "The P word belongs to no command of the program line, or to more than one command.",
        "Delete the P word, or write the commands into separate program lines.",
    ),
    "rs274.stray-q": entry(
        "The Q word belongs to no command of the program line.",
        "Delete the Q word.",
    ),
    "rs274.switches-while-moving": entry(
        "The program line switches an output while the head may still be moving: the controller "
        "switches outputs (M64, M65) as soon as it reads them.",
        "Add a dwell (G4 P0) after the last move and before this program line.",
    ),
    "rs274.timed-without-f": entry(
        "The program line moves in inverse time mode (G93), but has no F word.",
        "Add the F word.",
    ),
    "rs274.too-many-digits": entry(
        "A number in the program line has more than 15 digits.",
        "Round the number.",
    ),
    "rs274.unbounded-rounding": entry(
        "The program line cuts, but the program does not limit by how much the controller may "
        "round corners.",
        "Set the limit with G64 P before this program line.",
    ),
    "rs274.unknown-letter": entry(
        "The letter {letter} in the program line is not supported.",
        "Remove the letter and its number.",
        letter="text",
    ),
    "rs274.unknown-output": entry(
        "The program line switches an output that {machine} does not have.",
        "Choose an output that is defined in the machine file.",
        machine="text",
    ),
    "rs274.unknown-station": entry(
        "The program line selects a station (T) that {machine} does not have.",
        "Choose a station that is defined in the machine file.",
        machine="text",
    ),
    "rs274.unknown-word": entry(
        "The word {word} in the program line is not supported.",
        "Remove the word.",
        word="text",
    ),
    "rs274.wrong-dwell": entry(
        "The dwell (G4) in the program line is shorter than the {settle:g} s that the machine "
        "needs after switching.",
        "Make the dwell {settle:g} s or longer.",
        settle="number",
    ),
    "rs274.wrong-speed": entry(
        "The spindle speed (S) at M3 or M4 differs from the speed of the station in the "
        "machine file.",
        "Correct the speed, or compile the job again.",
    ),
}
