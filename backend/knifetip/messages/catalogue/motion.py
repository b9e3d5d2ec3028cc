"""motion: messages about what the verifier finds in the motion of the axes and in outputs."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "verify.beam-on-rapid": entry(
        "The laser beam is on during a rapid move of {length:.3f} mm.",
        "Switch the beam off (M5) before the rapid move.",
        length="number",
    ),
    "verify.beam-refocused": entry(
        "The laser beam is on while the head moves up or down by {height:.3f} mm.",
        "Switch the beam off (M5) before the height changes.",
        height="number",
    ),
    "verify.beyond-rotation": entry(
        "Axis {joint} turns to {position:.3f}°, but its travel is {low:g}° to {high:g}°.",
        "Turn the drawing on the table, or choose a machine whose axis has a larger range of "
        "rotation.",
        joint="text",
        position="number",
        low="number",
        high="number",
    ),
    "verify.beyond-travel": entry(
        "Axis {joint} moves to {position:.3f} mm, but its travel is {low:g} to {high:g} mm.",
        "For axis X or Y, move the drawing on the table, or choose a larger machine. For axis Z, "
        "check the heights in the machine file.",
        joint="text",
        position="number",
        low="number",
        high="number",
    ),
    "verify.cutter-at-rest": entry(
        "The cutter moves through the board while its spindle is off.",
        "Start the spindle (M3) before the cutter enters the board.",
    ),
    "verify.feed-of-other-axis": entry(
        "Station {station} is on a further carriage, and its move has a feed in mm/min (G94). A "
        "controller may apply this feed only to the travel of the gantry.",
        "State the duration of the move in inverse time mode (G93).",
        station="count",
    ),
    "verify.head-not-located": entry(
        "A carriage moves along the gantry while the position of {other} is unknown.",
        "Park all carriages at the start of the program.",
        other="text",
    ),
    "verify.heads-too-near": entry(
        "Only {distance:.2f} mm remain between {first} and {second}. Their least distance is "
        "{least:g} mm.",
        "Park the carriage that is not in use before the move.",
        first="text",
        second="text",
        distance="number",
        least="number",
    ),
    "verify.idle-head-low": entry(
        "The carriage with axis {letter} is not in use, but {letter} is at {height:.2f} mm. Its "
        "tools are above the board only at {needed:.2f} mm or higher.",
        "Lift the carriage before another one is used.",
        letter="text",
        height="number",
        needed="number",
    ),
    "verify.in-zone": entry(
        "Station {station} touches the keep-out zone {zone}: its tip is {depth:.1f} mm below the "
        "top of the zone, and its tool or holder reaches into the zone.",
        "Lead the move around the zone, or lift the tool above it.",
        station="count",
        zone="text",
        depth="number",
    ),
    "verify.knife-at-rest": entry(
        "The oscillating knife cuts while its oscillation is off.",
        "Start the oscillation (M3) before the knife enters the board.",
    ),
    "verify.laser-off": entry(
        "The laser moves along an edge while its beam is off, so the edge is not cut.",
        "Switch the beam on (M3) before the edge.",
    ),
    "verify.low-without-station": entry(
        "The head goes down to {height:.2f} mm while no station is selected. All tools clear the "
        "board only at {needed:.2f} mm or higher.",
        "Select a station before the head goes down, and lift it before the station is released.",
        height="number",
        needed="number",
    ),
    "verify.lowers-second": entry(
        "The program line lowers station {station} while station {other} may still be lowered.",
        "Raise station {other} (M65 P{output}) before this program line.",
        station="count",
        other="count",
        output="count",
    ),
    "verify.moves-before-stated": entry(
        "The program moves the head before it switches off {thing}.",
        "Switch off {thing} before the first move. Only a lift straight up, to Z {height:.3f} mm "
        "or higher, may come earlier.",
        thing="message",
        height="number",
    ),
    "verify.moves-overlap": entry(
        "The controller starts this move before the move in front of it has ended. Axis C turns "
        "differently in the two moves, so the tip leaves the path by up to {distance:.3f} mm "
        "(tolerance {tolerance:.3f} mm).",
        "Add an exact stop (G4 P0) before this program line.",
        distance="number",
        tolerance="number",
    ),
    "verify.moves-with-beam": entry(
        "The program moves the head before it switches off the spindle (M5), so a laser beam "
        "may still be on.",
        "Write M5 before the first move.",
    ),
    "verify.never-stated": entry(
        "The program never switches off {thing}, although an earlier program may have left it on.",
        "Switch off {thing} at the beginning of the program.",
        thing="message",
    ),
    "verify.no-station": entry(
        "The program line cuts, but no station (T and M6) has been selected before.",
        "Select the station before the first cut.",
    ),
    "verify.oscillation-on": entry(
        "Station {station} processes the board while the oscillation is on, although its tool "
        "must not oscillate.",
        "Switch the oscillation off (M5) before this station is used.",
        station="count",
    ),
    "verify.output": entry("output {output} (M65 P{output})", output="count"),
    "verify.output-off": entry(
        "Station {station} processes the board while its output {output} is off, so its tool is "
        "not lowered.",
        "Switch output {output} on (M64) before the station is used.",
        station="count",
        output="count",
    ),
    "verify.plunge-without-move": entry(
        "The {tool:tool} enters the board at X{x:.3f} Y{y:.3f} (coordinates of the sheet) and "
        "leaves it without a move.",
        "Delete the plunge, or compile the job again.",
        tool="text",
        x="number",
        y="number",
    ),
    "verify.rapid-in-board": entry(
        "A rapid move of station {station} is {depth:.3f} mm below the top face of the board.",
        "Lift the tool above the board before the rapid move.",
        station="count",
        depth="number",
    ),
    "verify.rapid-near-sheet": entry(
        "A rapid move of station {station} is {depth:.3f} mm below the top face of the board, and "
        "it is over the sheet, too close to the sheet, or in the mat.",
        "Lift the tool above the board before the rapid move, or keep the tool beside the sheet "
        "by the clearance of the machine.",
        station="count",
        depth="number",
    ),
    "verify.rapid-too-low": entry(
        "A rapid move of station {station} is only {height:.3f} mm above the board; the "
        "turn_clearance of the machine is {needed:g} mm.",
        "Lift the tool higher before the rapid move.",
        station="count",
        height="number",
        needed="number",
    ),
    "verify.spindle": entry("the spindle (M5)"),
    "verify.switches-at-unknown-height": entry(
        "The program line switches an output or the spindle before the program has set the "
        "height of the head.",
        "Lift the head to Z {needed:.3f} mm before this program line.",
        needed="number",
    ),
    "verify.switches-low": entry(
        "The program line switches an output or the spindle while axis Z is at {height:.3f} "
        "mm, which is too low.",
        "Lift the head to Z {needed:.3f} mm before this program line.",
        height="number",
        needed="number",
    ),
    "verify.turn-at-feed": entry(
        "Axis C turns by {degrees:.4f}° in a program line whose feed is in mm/min, so the "
        "duration of the rotation is not defined.",
        "Give the duration of the move in inverse time mode (G93).",
        degrees="number",
    ),
    "verify.turn-in-board": entry(
        "Axis C turns by {degrees:.3f}° while the tool is in the board, but at most "
        "{most:.2f}° is allowed.",
        "Lift the tool before it turns.",
        degrees="number",
        most="number",
    ),
    "verify.turn-off-path": entry(
        "Axis C turns by {degrees:.3f}° in the board, although the path of the tool turns by "
        "{path:.3f}°.",
        "Turn the tool by the same angle as the path.",
        degrees="number",
        path="number",
    ),
    "verify.turn-overlaps": entry(
        "The controller does not wait between the turn of axis C by {degrees:.2f}° in the board "
        "and the move next to it, so the tool turns while it moves.",
        "Add an exact stop (G4 P0) before this program line.",
        degrees="number",
    ),
    "verify.two-lowered": entry(
        "Station {station} processes the board while station {other} is also lowered (output "
        "{output} is on).",
        "Raise station {other} (M65 P{output}) before this station is used.",
        station="count",
        other="count",
        output="count",
    ),
    "verify.unknown-beside-zone": entry(
        "The head moves from an unknown position, and its tip is below {top:g} mm, the top of the "
        "keep-out zone {zone}, or at an unknown height. The move may lead through the zone.",
        "Lift Z above the zone before the first move of X or Y.",
        zone="text",
        top="number",
    ),
    "verify.unknown-position": entry(
        "The program line moves the head from or to a position that the program has not set.",
        "Give X, Y, Z and C before this program line.",
    ),
    "verify.wrong-feed": entry(
        "Station {station} has a feed of {feed:g} mm/min instead of {planned:g} mm/min.",
        "Compile the job again with the current machine file.",
        station="count",
        feed="number",
        planned="number",
    ),
    "verify.wrong-time": entry(
        "The move of station {station} takes {seconds:.4f} s instead of {planned:.4f} s.",
        "Compile the job again with the current machine file.",
        station="count",
        seconds="number",
        planned="number",
    ),
}
