"""mcx314: messages about machines with the motion chip MCX314, their programs and their board."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    # -- machines ---------------------------------------------------------------------------------
    "mcx314.no-wiring": entry(
        "The machine file of {machine} does not state how the axes are connected to the motion "
        "chip MCX314.",
        "Add the table [controller] to the machine file, with the pulses and speeds of the axes.",
        machine="text",
    ),
    "mcx314.bad-rate": entry(
        "{path} is {value}, but must be a multiple of {step} and at most {limit}",
        "Choose another value. The steps follow from the multiple of the drive speed that "
        "[controller] states.",
        path="text",
        value="count",
        step="count",
        limit="count",
    ),
    "mcx314.axis-too-fast": entry(
        "{path} needs {rate:.0f} pulses per second, but the chip MCX314 makes at most {limit:,}",
        "Choose a lower velocity, fewer pulses per millimetre or degree, or a greater multiple of "
        "the drive speed.",
        path="text",
        rate="number",
        limit="count",
    ),
    "mcx314.axis-too-long": entry(
        "{path} is {pulses:,} pulses long, but the chip MCX314 counts at most {limit:,} in one "
        "segment",
        "Choose fewer pulses per millimetre or degree.",
        path="text",
        pulses="count",
        limit="count",
    ),
    "mcx314.feed-too-slow": entry(
        "{path} gives {rate:.0f} pulses per second along a diagonal, but programs need at least "
        "{limit:.0f} for an exact feed",
        "Choose a greater feed, or more pulses per millimetre.",
        path="text",
        rate="number",
        limit="number",
    ),
    "mcx314.tool-not-supported": entry(
        "{path} is a tool that must be switched on and off during a cut, which a program for an "
        "MCX314 cannot do",
        "Use a knife, a crease wheel, a V-cutter or a router in this station.",
        path="text",
    ),
    "mcx314.spindle-not-supported": entry(
        "{path} states a direction or a speed, but a program for an MCX314 can only switch the "
        "spindle on and off",
        "Remove spindle and spindle_speed, and set them at the drive.",
        path="text",
    ),
    # -- toolpaths --------------------------------------------------------------------------------
    "mcx314.four-axes": entry(
        "{place} moves four axes at once, but the chip MCX314 can move only three.",
        "Let the tool turn before or after its depth changes.",
        place="message",
    ),
    "mcx314.speed": entry(
        "{place} needs {rate:.0f} pulses per second, but the chip MCX314 makes only {slowest:,} to "
        "{fastest:,}.",
        "Choose another feed for the tool, or another multiple of the drive speed.",
        place="message",
        rate="number",
        slowest="count",
        fastest="count",
    ),
    "mcx314.too-far": entry(
        "{place} needs {pulses:,} pulses, but the chip MCX314 counts at most {limit:,} in one "
        "segment.",
        "Divide the edge, or use fewer pulses per millimetre.",
        place="message",
        pulses="count",
        limit="count",
    ),
    # -- programs ---------------------------------------------------------------------------------
    "mcx314.bad-header": entry(
        "The program does not begin with “MCX314 {version}”.",
        "Check that it is a program for an MCX314, in this version of the format.",
        version="count",
    ),
    "mcx314.no-pulses": entry(
        "The first instruction must be PULSES with the pulses of X, Y, Z and C.",
        "Create the program again.",
    ),
    "mcx314.other-pulses": entry(
        "The program is made for other pulses per millimetre or degree than {machine} has.",
        "Create the program for this machine.",
        machine="text",
    ),
    "mcx314.bad-line": entry(
        "The line {text!r} is not an instruction.", "Correct the line.", text="text"
    ),
    "mcx314.no-newline": entry(
        "The last line does not end with a newline.",
        "The file may be incomplete: create the program again.",
    ),
    "mcx314.no-end": entry(
        "The program does not end with END.",
        "The file may be incomplete: create the program again.",
    ),
    "mcx314.after-end": entry("The program continues after END.", "Remove the lines after END."),
    "mcx314.bad-axes": entry(
        "The line moves {count} axes at once, but the chip MCX314 moves one to three.",
        "Divide the move into moves of at most three axes.",
        count="count",
    ),
    "mcx314.out-of-range": entry(
        "A number in the line is greater than {limit:,}, the most that the chip MCX314 can count.",
        "Divide the move into shorter moves.",
        limit="count",
    ),
    "mcx314.unknown-position": entry(
        "The line moves an axis by a number of pulses, but no line before it states where the axis "
        "is.",
        "Move the axis with GO first.",
    ),
    "mcx314.bad-speed": entry(
        "The drive speed must be {slowest:,} to {fastest:,} pulses per second.",
        "Correct the drive speed.",
        slowest="count",
        fastest="count",
    ),
    "mcx314.bad-arc": entry(
        "The end of the arc is not on its circle, or the arc is a point or a whole circle.",
        "Correct the end or the centre.",
    ),
    "mcx314.no-circle": entry(
        "The line is an arc, but X and Y have different pulses per millimetre.",
        "Replace the arc by lines.",
    ),
    "mcx314.joins-nothing": entry(
        "The instruction JOIN continues the move in the line before, but that line is neither a "
        "line nor an arc.",
        "Remove JOIN.",
    ),
    "mcx314.joins-short": entry(
        "The instruction JOIN follows a segment that takes only {milliseconds:.3g} ms, but writing "
        "the next segment to the chip takes up to {refill:.3g} ms.",
        "Remove JOIN, or make the segment before it longer.",
        milliseconds="number",
        refill="number",
    ),
    "mcx314.unknown-output": entry(
        "The machine has no output {output}.", "Correct the number.", output="count"
    ),
    "mcx314.wrong-dwell": entry(
        "The dwell must last {needed} ms, the time that the selected station needs after it is "
        "switched.",
        "Correct the duration of the dwell.",
        needed="count",
    ),
    "mcx314.not-settled": entry(
        "A move begins already {seconds:g} s after an output or the oscillation was switched.",
        "Add a dwell before the move, as long as the station needs after it is switched.",
        seconds="number",
    ),
    "mcx314.ends-lowered": entry(
        "Output {output} is on at the end of the program.",
        "Switch it off before END.",
        output="count",
    ),
    "mcx314.ends-oscillating": entry(
        "The oscillation is on at the end of the program.", "Switch it off before END."
    ),
    # -- the board --------------------------------------------------------------------------------
    "mcx314.unknown-line": entry(
        "Program line {line} ({text}) is not an instruction for an MCX314.",
        "Compile the job again for this machine.",
        line="count",
        text="text",
    ),
    "mcx314.pulses-of-board": entry(
        "The program states other pulses per millimetre or degree than {name} has.",
        "Compare [controller] in the machine file with the settings of the controller board, then "
        "compile the job again.",
        name="text",
    ),
    "mcx314.lost": entry(
        "The connection to {name} is lost.",
        "Check the cable to the controller board, then check the sheet on the table.",
        name="text",
    ),
    "mcx314.silent": entry(
        "{name} has not answered for {seconds:g} s.",
        "Check that the controller board is switched on, then check the sheet on the table.",
        name="text",
        seconds="number",
    ),
    "mcx314.unreadable": entry(
        "{name} sent an answer that does not come from a board with an MCX314: {answer}",
        "Check the address of the controller.",
        name="text",
        answer="text",
    ),
    "mcx314.refused": entry(
        "{name} refused {request}: {code}.",
        "Check the table, then try again.",
        name="text",
        request="text",
        code="text",
    ),
    "mcx314.reset": entry(
        "{name} was switched off or reset. All outputs were released, and the position is unknown.",
        "Check that the tool is out of the board, then home the machine.",
        name="text",
    ),
    "mcx314.gave-up": entry(
        "{name} has received nothing from this gateway for {seconds:g} s and stopped the program.",
        "Check the connection to the controller board, then check the sheet on the table.",
        name="text",
        seconds="number",
    ),
    "mcx314.stopped": entry(
        "{name} has discarded the program at line {line}.",
        "Another program may be connected to the controller board. Check the sheet on the table.",
        name="text",
        line="count",
    ),
    "mcx314.not-at-rest": entry(
        "{name} was not at rest after {seconds:g} s.",
        "Lift the tool and raise the stations at the table.",
        name="text",
        seconds="number",
    ),
    "mcx314.not-lifted": entry(
        "The outputs are off, but the tool was not lifted. {cause}",
        "{cause:hint}",
        cause="message",
    ),
    "mcx314.alarm-unhomed": entry(
        "The axes of {name} are not homed, so their positions are unknown.",
        "Check that the tool is out of the board, then home the machine.",
        name="text",
    ),
    "mcx314.alarm-emergency": entry(
        "{name} is in emergency stop.",
        "Clear the cause, release the button, unlock and home the machine.",
        name="text",
    ),
    "mcx314.alarm-limit": entry(
        "The axis {axis} of {name} is at its limit switch.",
        "Check the table, then unlock and home the machine.",
        name="text",
        axis="text",
    ),
    "mcx314.alarm-drive": entry(
        "The drive of the axis {axis} of {name} reports a fault.",
        "Clear the fault at the drive, then unlock and home the machine.",
        name="text",
        axis="text",
    ),
    "mcx314.alarm-chip": entry(
        "The motion chip of {name} received a segment too late, or refused a segment.",
        "Check the sheet on the table, then unlock and home the machine. In the machine file, "
        "choose a slower feed, or with refill a longer time for the next segment.",
        name="text",
    ),
    "mcx314.alarm-other": entry(
        "{name} reports the alarm {alarm}.",
        "Check the table, then unlock and home the machine.",
        name="text",
        alarm="text",
    ),
}
