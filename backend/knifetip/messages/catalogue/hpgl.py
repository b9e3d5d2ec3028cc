"""hpgl: messages about HPGL programs that cannot be emitted, or that the verifier rejects."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "hpgl.bad-address": entry(
        "{address!r} is not the address of a plotter.",
        "Write it as tcp://HOST, or as serial:///dev/ttyUSB0?baud=9600&flow=rtscts; a serial port "
        "needs flow=rtscts or flow=xonxoff, as it is set at the plotter. &buffer=1024 states how "
        "many bytes the connection and the plotter hold.",
        address="text",
    ),
    "hpgl.bad-area": entry(
        "{path} is {value}, but must be [x0, y0, x1, y1] with x0 < x1 and y0 < y1",
        "Write the corners of the area in plotter units, the lower left corner first.",
        path="text",
        value="text",
    ),
    "hpgl.bad-byte": entry(
        "The program line contains the byte {byte}, which is not allowed in an HPGL program.",
        "Remove the byte.",
        byte="text",
    ),
    "hpgl.bad-feed": entry(
        "{place} has a feed of {feed:g} mm/min, but {device} supports only multiples of "
        "{step:g} mm/min from {slowest:,} to {fastest:,} mm/min.",
        "Choose one of these feeds for the tool in the machine file.",
        place="message",
        feed="number",
        device="text",
        slowest="count",
        fastest="count",
        step="number",
    ),
    "hpgl.bad-number": entry(
        "The program line has a plus or minus sign that is not followed by a number, or a "
        "number with too many digits.",
        "Correct the number.",
    ),
    "hpgl.bad-range": entry(
        "{path} is {value}, but must be [least, greatest] with 0 < least ≤ greatest",
        "Write the two values in this order.",
        path="text",
        value="text",
    ),
    "hpgl.datum": entry(
        "{path} has an offset or an output, but an HPGL program cannot use these settings: the "
        "machine itself stores the tool offsets and lowers the tools",
        "Set all values of datum to 0 and remove output.",
        path="text",
    ),
    "hpgl.depth-change": entry(
        "{place} changes the depth of the tool during a cut, which HPGL cannot express.",
        "Choose a board and a tool with which each cut needs only one pass.",
        place="message",
    ),
    "hpgl.ends-down": entry(
        "The program ends while the tool is down.",
        "Lift the tool (PU) before the end of the program.",
    ),
    "hpgl.ends-with-pen": entry(
        "The program ends while a pen is selected.",
        "Deselect the pen (SP0) before the end of the program.",
    ),
    "hpgl.feed-not-supported": entry(
        "{path} is {value:g} mm/min, but {device} supports only multiples of {step:g} mm/min from "
        "{slowest:g} to {fastest:g}",
        "Choose one of these feeds.",
        path="text",
        value="number",
        device="text",
        step="number",
        slowest="number",
        fastest="number",
    ),
    "hpgl.force-out-of-range": entry(
        "The force (FS) in the program line is not between {low} and {high}.",
        "Give a force in this range.",
        low="count",
        high="count",
    ),
    "hpgl.initialised-again": entry(
        "The program line initialises the machine (IN) a second time.",
        "Delete the second IN.",
    ),
    "hpgl.lone-letter": entry(
        "The program line has a single letter, but each HPGL instruction has two letters.",
        "Correct the instruction.",
    ),
    "hpgl.loose-number": entry(
        "The program line has a number that belongs to no instruction.",
        "Delete the number, or add the instruction before the number.",
    ),
    "hpgl.moves-before-pa": entry(
        "The program line moves the tool before the program has chosen absolute coordinates (PA).",
        "Write PA before the first move.",
    ),
    "hpgl.needs-no-number": entry(
        "The instruction in this program line does not take a number.",
        "Delete the number.",
    ),
    "hpgl.needs-one-number": entry(
        "The instruction in this program line needs exactly one number.",
        "Give one number.",
    ),
    "hpgl.never-down": entry(
        "The toolpath never lowers a tool, so nothing would be cut.",
        "Give at least one edge a line type for which the machine has a tool.",
    ),
    "hpgl.no-approach": entry(
        "Internal error: {place} starts a cut, but no rapid move to the start of the cut "
        "precedes it.",
        "Report the error with the drawing.",
        place="message",
    ),
    "hpgl.no-device": entry(
        "The machine file of {machine} has no HPGL settings.",
        "Add the HPGL settings under [controller] in the machine file: see the page Connect a "
        "machine of the documentation.",
        machine="text",
    ),
    "hpgl.no-force": entry(
        "{path} is {value}, but {device} has no force setting (FS)",
        "Remove force.",
        path="text",
        value="text",
        device="text",
    ),
    "hpgl.no-force-setting": entry(
        "The program line sets the force (FS), but the machine has no force setting.",
        "Remove FS.",
    ),
    "hpgl.no-instruction": entry(
        "The program contains no instruction.",
        "Choose a file with an HPGL program.",
    ),
    "hpgl.no-pen": entry(
        "The machine file of {machine} assigns no pen to the operation {work} with station "
        "{station}.",
        "Add a [[controller.pen]] with this station and this operation (field work) to the "
        "machine file.",
        machine="text",
        work="text",
        station="count",
    ),
    "hpgl.no-pen-selected": entry(
        "The program line lowers the tool, but no pen is selected.",
        "Select a pen (SP) before this program line.",
    ),
    "hpgl.no-speed": entry(
        "The program line cuts, but no speed has been set.",
        "Set the speed (VS) before this program line.",
    ),
    "hpgl.no-speed-setting": entry(
        "The program line sets the speed (VS), but the machine has no speed setting.",
        "Remove VS.",
    ),
    "hpgl.no-terminator": entry(
        "The last instruction of the program has no semicolon.",
        "Add the semicolon, or send the complete program again.",
    ),
    "hpgl.not-initialised": entry(
        "The first instruction of the program is not IN (initialise).",
        "Write IN at the beginning of the program.",
    ),
    "hpgl.outside-area": entry(
        "The program line moves the tool outside the working area of the machine.",
        "Move the drawing on the table, or choose a larger machine.",
    ),
    "hpgl.not-raised": entry(
        "{name} has accepted no data for {seconds:g} s, so the command to raise the tool could not "
        "be sent. The tool may still be lowered.",
        "Stop the program at the machine and raise the tool there.",
        name="text",
        seconds="number",
    ),
    "hpgl.not-reached": entry(
        "{error} The machine still executes what is in its buffer, and the tool may remain "
        "lowered at the end.",
        "Stop the program at the machine and raise the tool there.",
        error="message",
    ),
    "hpgl.pen-cannot": entry(
        "{path} is {work!r}, but the tool of station {station} cannot do this operation",
        "Assign the pen to another station, or choose another operation in the field work.",
        path="text",
        work="text",
        station="count",
    ),
    "hpgl.plunge-without-move": entry(
        "The program line lowers the tool, but no move follows, so the direction of the tool "
        "is not known.",
        "Add a move after the instruction PD.",
    ),
    "hpgl.press": entry(
        "{place} presses a crease that is too short to be rolled: the tool is lowered at one "
        "point. Before that, the tool must be turned to the direction of the crease, which "
        "HPGL cannot express.",
        "Draw a longer crease, set the line type of the crease to ignored, or choose another "
        "machine.",
        place="message",
    ),
    "hpgl.repeated-pen": entry(
        "{path} has the same station and the same operation (field work) as another pen",
        "Remove one of the two pens, or choose another operation for one of the two pens.",
        path="text",
    ),
    "hpgl.runs-on": entry(
        "The rest of the program is not sent to {name}. The machine still executes what is in its "
        "buffer, and raises the tool after that.",
        "Stay away from the tool until the machine is at rest, or stop the program at the machine.",
        name="text",
    ),
    "hpgl.selects-while-down": entry(
        "The program line selects a pen while the tool is down.",
        "Lift the tool (PU) before the pen is selected.",
    ),
    "hpgl.send-by-hand": entry(
        "Download the program and send it with the software of the cutting machine. Stay beside "
        "the machine while it cuts, so that you can stop it.",
    ),
    "hpgl.sets-while-down": entry(
        "The program line sets the speed (VS) or the force (FS) while the tool is down.",
        "Lift the tool (PU) before the speed or the force is set.",
    ),
    "hpgl.slanted-plunge": entry(
        "{place} lowers or lifts the tool along a slope, which HPGL cannot express.",
        "Choose a tool that enters the board vertically.",
        place="message",
    ),
    "hpgl.speed-out-of-range": entry(
        "The speed (VS) in the program line is not between {low} and {high}.",
        "Give a speed in this range.",
        low="count",
        high="count",
    ),
    "hpgl.station-without-pen": entry(
        "{path} has no pen",
        "Add a [[controller.pen]] with this station.",
        path="text",
    ),
    "hpgl.swivel": entry(
        "{place} rotates the head about the tip of the knife, because the machine file sets a "
        "knife offset (trail). HPGL cannot express this rotation and does not need it: an "
        "HPGL machine itself compensates for the knife offset.",
        "Set the trail of the knife to 0 in the machine file.",
        place="message",
    ),
    "hpgl.tool-not-supported": entry(
        "{path} is neither a knife nor a creasing tool, and HPGL cannot control other tools",
        "Remove the station, or choose another controller language.",
        path="text",
    ),
    "hpgl.swivel-depth": entry(
        "{path} is {value:g} mm, but an HPGL program cannot change the depth of a lowered tool",
        "Set swivel_depth to 0.",
        path="text",
        value="number",
    ),
    "hpgl.trail": entry(
        "{path} (knife offset) is {value:g} mm, but an HPGL machine itself compensates for "
        "the offset of its knife",
        "Set trail to 0, or set free if the device does not compensate.",
        path="text",
        value="number",
    ),
    "hpgl.travel": entry(
        "{path} extends from {low:g} to {high:g} mm, but the working area in the HPGL "
        "settings extends from {least:g} to {greatest:g} mm",
        "Reduce the travel of the axis, or correct the working area in the HPGL settings.",
        path="text",
        low="number",
        high="number",
        least="number",
        greatest="number",
    ),
    "hpgl.turn-in-board": entry(
        "The tool turns by {degrees:.2f}° while it is in the board, but at most {most:.2f}° is "
        "allowed.",
        "Lift the tool before it turns.",
        degrees="number",
        most="number",
    ),
    "hpgl.unknown-instruction": entry(
        "The instruction {name} in the program line is not supported.",
        "Remove the instruction.",
        name="text",
    ),
    "hpgl.unknown-pen": entry(
        "The program line selects a pen that the machine does not have.",
        "Select a pen that is defined in the machine file.",
    ),
    "hpgl.wrong-force": entry(
        "The program line lowers pen {pen} with a force that differs from the force of this "
        "pen in the machine file (FS{force}).",
        "Write FS{force} before this program line.",
        pen="count",
        force="count",
    ),
    "hpgl.x-without-y": entry(
        "The program line has an X coordinate without a Y coordinate.",
        "Give both coordinates.",
    ),
}
