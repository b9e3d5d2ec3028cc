"""verification: messages about what the verifier finds at the edges of a drawing.

The module ``motion`` contains the messages about the motion of the axes.
"""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

_COMPILE_AGAIN: Final = (
    "Compile the job again. If the finding remains, report it as an internal error with the "
    "program file."
)

MESSAGES: Final[Entries] = {
    "verify.bad-tolerance": entry(
        "The tolerance of the verification is {tolerance} mm, which is not a valid length.",
        "Give a number greater than 0, usually 0.01 mm.",
        tolerance="text",
    ),
    "verify.base-not-rigid": entry(
        "The crease depths of the board {board}, up to {depth:.2f} mm, are given for a rigid "
        "creasing base, but the machine has a soft one: the creases become shallower and wider.",
        "Crease a sample, and adjust the crease depths of the board to the soft base.",
        board="text",
        depth="number",
    ),
    "verify.base-not-soft": entry(
        "The crease depths of the board {board}, up to {depth:.2f} mm, are given for a soft "
        "creasing base, but the machine has a rigid one: the wheel may cut the face or crush the "
        "board.",
        "Put a soft creasing mat on the table and state it in the machine file, or reduce the "
        "crease depths of the board.",
        board="text",
        depth="number",
    ),
    "verify.beside-line": entry(
        "The path of the {tool:tool} is {distance:.3f} mm away from the edge that it should "
        "follow.",
        _COMPILE_AGAIN,
        tool="text",
        distance="number",
    ),
    "verify.blade-bend": entry(
        "The knife turns by {turn:.0f}° in the board within the width of its blade, {width:g} mm, "
        "on a bend of {radius:.2f} mm radius. It cuts the top face up to {top:.3f} mm beside the "
        "line, and the rear edge of the blade runs up to {rear:.2f} mm beside it.",
        turn="number",
        width="number",
        radius="number",
        top="number",
        rear="number",
    ),
    "verify.blade-bend-too-tight": entry(
        "The bend is too tight for the knife: on a radius of {radius:.2f} mm it turns by "
        "{turn:.0f}° in the board within the width of its blade, {width:g} mm. It cuts the top "
        "face up to {top:.2f} mm beside the line (permitted: {tolerance:g} mm), and the rear edge "
        "of the blade runs up to {rear:.2f} mm beside it.",
        "Draw a bend with a radius of at least {least:.1f} mm or a sharp corner, use a knife with "
        "a steeper or narrower blade, or accept the shortfall.",
        turn="number",
        width="number",
        radius="number",
        top="number",
        rear="number",
        tolerance="number",
        least="number",
    ),
    "verify.blade-not-parked": entry(
        "At the end of the program, the freely turning blade of station {station} has a heading of "
        "{heading:.1f}°, but the next program expects {park:g}°.",
        _COMPILE_AGAIN,
        station="count",
        heading="number",
        park="number",
    ),
    "verify.blade-pushed": entry(
        "A move of {length:.2f} mm pushes the tip of the freely turning blade away from the axis "
        "of the blade instead of pulling it. The blade may then turn to either side or tear the "
        "board.",
        _COMPILE_AGAIN,
        length="number",
    ),
    "verify.bridge-near-corner": entry(
        "The bridge at {place:.3f} mm from the start of the contour is {distance:.3f} mm too "
        "close to a sharp corner.",
        "Compile the job again, or choose a smaller spacing of bridges in the board file.",
        place="number",
        distance="number",
    ),
    "verify.bridge-spacing": entry(
        "The bridge at {place:.3f} mm from the start of the contour is {distance:.3f} mm away "
        "from the next bridge, but the board allows at most {most:g} mm.",
        "Compile the job again, or allow a larger spacing of bridges in the board file.",
        place="number",
        distance="number",
        most="number",
    ),
    "verify.bridge-spare": entry(
        "The bridge at {place:.3f} mm from the start of the contour is not needed, because the "
        "bridges before and after it are only {distance:.3f} mm apart.",
        _COMPILE_AGAIN,
        place="number",
        distance="number",
    ),
    "verify.bridge-width": entry(
        "The bridge at {place:.3f} mm from the start of the contour is {width:.3f} mm wide in "
        "the top face of the board, but the board needs bridges of {planned:g} mm width.",
        "Compile the job again for this board.",
        place="number",
        width="number",
        planned="number",
    ),
    "verify.centre-off-path": entry(
        "The centre of the cutter is {distance:.4f} mm away from its planned path, and the "
        "controller may round corners by another {rounding:.4f} mm. The tolerance is "
        "{tolerance:g} mm.",
        "Increase the tolerance, or report an internal error with the program file.",
        distance="number",
        rounding="number",
        tolerance="number",
    ),
    "verify.cleaning-beyond": entry(
        "Internal error in cleaning: the cleaned edge extends beyond all edges of the drawing.",
        "Report this error with the drawing.",
    ),
    "verify.cleaning-dropped": entry(
        "Internal error in cleaning: {length:.3f} mm of the edge were lost.",
        "Report this error with the drawing.",
        length="number",
    ),
    "verify.cleaning-fit": entry(
        "Internal error in cleaning: the edge is {distance:.4f} mm away from the arc that replaces "
        "it, and only {stated:.4f} mm are stated.",
        "Report this error with the drawing.",
        distance="number",
        stated="number",
    ),
    "verify.cleaning-incomplete": entry(
        "Internal error in cleaning: the lengths of the kept, merged and dropped parts of the "
        "edge do not add up to the length of the edge.",
        "Report this error with the drawing.",
    ),
    "verify.cleaning-invented": entry(
        "Internal error in cleaning: the cleaned edge corresponds to no edge of the drawing.",
        "Report this error with the drawing.",
    ),
    "verify.cleaning-moved": entry(
        "Internal error in cleaning: the edge was moved by {distance:.4f} mm.",
        "Report this error with the drawing.",
        distance="number",
    ),
    "verify.cleaning-type": entry(
        "Internal error in cleaning: the edge has the line type {drawn} before cleaning and "
        "{worked} after it.",
        "Report this error with the drawing.",
        drawn="text",
        worked="text",
    ),
    "verify.comes-out-anywhere": entry(
        "The knife leaves the board at a point that is neither the end of an edge nor the point "
        "where it entered.",
        _COMPILE_AGAIN,
    ),
    "verify.comes-out-past": entry(
        "The knife leaves the board {distance:.3f} mm beyond the end of the edge.",
        _COMPILE_AGAIN,
        distance="number",
    ),
    "verify.comes-out-short": entry(
        "The knife leaves the board {distance:.3f} mm before the end of the edge.",
        _COMPILE_AGAIN,
        distance="number",
    ),
    "verify.contour-unreached": entry(
        "The cutter of {width:.2f} mm diameter does not fit into or beside the contour of this "
        "edge, so nothing of the contour is cut ({length:.3f} mm on this edge).",
        "Choose a thinner cutter, enlarge the opening, or accept that the contour is not cut.",
        width="number",
        length="number",
    ),
    "verify.crease-meets-cuts": entry(
        "Cuts end on {count} creases from one side. These creases are made without interruption, "
        "because all creases are made before the cuts.",
        count="count",
    ),
    "verify.crease-stops-at-cut": entry(
        "Cuts cross {count} creases. The wheel stops before these cuts, and up to {distance:.2f} "
        "mm on each side of a cut are not creased.",
        "If the fold needs this length, choose a smaller creasing wheel, or move the cut.",
        count="count",
        distance="number",
    ),
    "verify.crease-too-bent": entry(
        "The crease bends too tightly for the creasing wheel: a wheel of {wheel:g} mm radius "
        "touches the board along a straight line of {contact:.1f} mm, whose ends press up to "
        "{distance:.2f} mm beside the crease (permitted: {tolerance:g} mm). {length:.1f} mm of the "
        "crease are not pressed.",
        "Mount a creasing wheel of at most {smaller:.1f} mm radius, draw a bend with a radius of "
        "at least {radius:d} mm, change the line type to perforation or half-cut, or accept the "
        "shortfall.",
        wheel="number",
        contact="number",
        distance="number",
        tolerance="number",
        length="number",
        radius="count",
        smaller="number",
    ),
    "verify.crease-too-short": entry(
        "The crease is too short for the creasing wheel and is not made: it is {length:.2f} mm "
        "long, the wheel has a radius of {radius:.1f} mm, and it must stop {clearance:.2f} mm "
        "before each free end.",
        "Join the crease to a crease on the same straight line, set its line type to ignored, or "
        "choose a board on which short creases are pressed or a smaller creasing wheel.",
        length="number",
        radius="number",
        clearance="number",
    ),
    "verify.cut-both-ways": entry(
        "{length:.3f} mm of this edge are cut in both directions. A slanted blade then cuts the "
        "top face past both ends.",
        _COMPILE_AGAIN,
        length="number",
    ),
    "verify.cut-too-short": entry(
        "The cut is {length:.2f} mm long and ends inside a panel. The slanted blade of the knife "
        "needs a cut longer than {lead:.2f} mm, so the cut is not made.",
        "Draw a longer cut, join the cut to another cut, set its line type to ignored, or choose a "
        "knife with a less slanted blade.",
        length="number",
        lead="number",
    ),
    "verify.cuts-part": entry(
        "The cutter cuts sideways into a part, up to {depth:.3f} mm from the edge of the part.",
        "Move the parts further apart, or choose a thinner cutter.",
        depth="number",
    ),
    "verify.deep-swivel": entry(
        "The freely turning blade is turned about its tip at a depth of {depth:.2f} mm instead of "
        "{planned:g} mm.",
        _COMPILE_AGAIN,
        depth="number",
        planned="number",
    ),
    "verify.drawn-twice": entry(
        "Two lines of the type {type} lie {distance:.2f} mm apart for {length:.1f} mm, nearer than "
        "the board is thick. Is the same line drawn twice?",
        "Set the line type of one of the two to ignored, move them apart, or accept that both are "
        "made.",
        type="text",
        distance="number",
        length="number",
    ),
    "verify.fixed-blade": entry(
        "The board is best cut by an oscillating blade, and the knife of station {station} is "
        "fixed: it pushes thick or soft board together.",
        "Choose a machine with an oscillating knife, or cut a sample first.",
        station="count",
    ),
    "verify.flank-inside": entry(
        "The flank of the V-groove meets the top face of the board {distance:.4f} mm too "
        "close to the centre line of the groove. The tolerance is {tolerance:g} mm.",
        "Check the tilt and the offsets of the V-cutter in the machine file, then compile the "
        "job again.",
        distance="number",
        tolerance="number",
    ),
    "verify.flank-outside": entry(
        "The flank of the V-groove meets the top face of the board {distance:.4f} mm too far "
        "from the centre line of the groove. The tolerance is {tolerance:g} mm.",
        "Check the tilt and the offsets of the V-cutter in the machine file, then compile the "
        "job again.",
        distance="number",
        tolerance="number",
    ),
    "verify.flank-through-cut": entry(
        "A flank of the V-groove reaches {depth:.3f} mm sideways past the cut at edge {edge}. The "
        "cut lies {distance:.3f} mm from the centre line of the groove, {place:.1f} mm from the "
        "start of the groove.",
        "Move the groove and the cut further apart, or choose a shallower groove.",
        depth="number",
        edge="edge",
        distance="number",
        place="number",
    ),
    "verify.fold-angle": entry(
        "The V-groove lets the board fold by {angle:.1f}°, but the board must fold by "
        "{required:.1f}° here.",
        "Choose a V-cutter with a larger tilt, or state the fold angle of the carton in the board "
        "file (fold_angle).",
        angle="number",
        required="number",
    ),
    "verify.goes-in-anywhere": entry(
        "The knife enters the board at a point where no edge begins.",
        _COMPILE_AGAIN,
    ),
    "verify.groove-arc": entry(
        "The V-groove is an arc, which a tilted blade cannot follow.",
        "Draw the V-groove with straight lines, or choose another line type.",
    ),
    "verify.groove-past-ends": entry(
        "The V-cutter cuts {length:.2f} mm beyond the ends of the groove, but the board allows "
        "an overcut of only {most:.2f} mm.",
        "Choose a V-cutter with a narrower blade, or allow a longer overcut in the board file.",
        length="number",
        most="number",
    ),
    "verify.groove-shallower": entry(
        "The V-cutter cuts {depth:.3f} mm deep, although an earlier pass of the same groove "
        "was already {before:.3f} mm deep.",
        "Order the passes by increasing depth.",
        depth="number",
        before="number",
    ),
    "verify.groove-shifted": entry(
        "The V-groove was shifted by {distance:.2f} mm, so that its flank does not reach the cut "
        "beside it.",
        "If the fold must not move, move the cut, or set groove_shift in the board file to 0.",
        distance="number",
    ),
    "verify.groove-too-short": entry(
        "The V-groove is {length:.2f} mm long, but the blade is {blade:.2f} mm wide, so the groove "
        "is not made.",
        "Draw a longer groove, set its line type to crease or ignored, or choose a V-cutter with a "
        "narrower blade.",
        length="number",
        blade="number",
    ),
    "verify.grooves-at-angle": entry(
        "Two V-grooves meet at an angle of {angle:.1f}° at X{x:.3f} Y{y:.3f} (coordinates of the "
        "sheet), and each is {width:.2f} mm wide in the top face. Along {length:.1f} mm from there "
        "no ridge remains between them.",
        "Draw the grooves at a greater angle or end one of them before the other, choose a smaller "
        "depth of grooves in the board file, or accept the shortfall.",
        angle="number",
        x="number",
        y="number",
        width="number",
        length="number",
    ),
    "verify.grooves-meet": entry(
        "Two V-grooves lie {distance:.2f} mm apart, but each is {width:.2f} mm wide in the top "
        "face. Along {length:.1f} mm their flanks meet, and no ridge remains between them.",
        "Move the grooves apart, choose a smaller depth of grooves in the board file, or accept "
        "the shortfall.",
        distance="number",
        width="number",
        length="number",
    ),
    "verify.hanging-piece": entry(
        "The edge at X{x:.3f} Y{y:.3f} (coordinates of the sheet) lies on a part of the board "
        "that, from line {line} of the program on, hangs only on bridges or narrow necks and may "
        "therefore move.",
        "Process this edge before the cut that leaves only the bridges or necks.",
        x="number",
        y="number",
        line="count",
    ),
    "verify.inside-part": entry(
        "The cutter cuts into a finished part at X{x:.3f} Y{y:.3f} (coordinates of the sheet).",
        "Move the parts further apart, or choose a thinner cutter.",
        x="number",
        y="number",
    ),
    "verify.loose-piece": entry(
        "The edge at X{x:.3f} Y{y:.3f} (coordinates of the sheet) lies on a part of the board "
        "that line {line} of the program has already cut out, so this part of the board may move.",
        "Process this edge before the contour that cuts out this part of the board. Where "
        "contours cross, divide them at their crossings in the drawing. If a cutter makes open "
        "contours, close them, or choose a machine with a knife.",
        x="number",
        y="number",
        line="count",
    ),
    "verify.made-before": entry(
        "Station {station} processes {length:.3f} mm at X{x:.3f} Y{y:.3f} (coordinates of the "
        "sheet), although an earlier program has already made this line on the sheet.",
        "Continue from a later contour, or start a new sheet.",
        station="count",
        length="number",
        x="number",
        y="number",
    ),
    "verify.narrow-cuts": entry(
        "Two cuts lie {distance:.2f} mm apart for {length:.1f} mm. The strip or slot between them "
        "is narrower than the board is thick ({caliper:g} mm) and may tear or stay stuck.",
        distance="number",
        length="number",
        caliper="number",
    ),
    "verify.narrow-lines": entry(
        "A line of the type {type} and one of the type {other} lie {distance:.2f} mm apart for "
        "{length:.1f} mm, which is too near for a board {caliper:g} mm thick: the narrow strip "
        "between them is crushed or tears off.",
        type="text",
        other="text",
        distance="number",
        length="number",
        caliper="number",
    ),
    "verify.narrow-rim": entry(
        "The creasing wheel has a rim of {width:g} mm, which is narrow for a board {caliper:g} mm "
        "thick: it may cut into the upper face instead of creasing it.",
        "Mount a creasing wheel with a rim of at least {least:g} mm.",
        width="number",
        caliper="number",
        least="number",
    ),
    "verify.narrow-slits": entry(
        "{count} slits and cuts between two parts ({length:.1f} mm) become {width:g} mm wide: the "
        "board on each side loses half of this strip.",
        count="count",
        length="number",
        width="number",
    ),
    "verify.no-such-shortfall": entry(
        "The verdict has no finding {code} at edge {edge}.",
        "Read the findings again: the drawing or the program may have changed since.",
        code="text",
        edge="edge",
    ),
    "verify.not-acceptable": entry(
        "The finding {code} at edge {edge} is no shortfall, so it cannot be accepted. A shortfall "
        "is a line that the tool cannot make exactly as drawn.",
        "Change the drawing, the tool or the board, and compile the job again.",
        code="text",
        edge="edge",
    ),
    "verify.not-worked": entry(
        "{length:.3f} mm along the edge are left without {work}. {where}",
        _COMPILE_AGAIN,
        length="number",
        work="message",
        where="message",
    ),
    "verify.off-curve": entry(
        "The edge approximates a curve of the drawing file and is {fit:.4f} mm away from it. The "
        "path of the tool is {distance:.4f} mm away from the edge, and the controller may round "
        "corners by another {rounding:.4f} mm. The sum exceeds the tolerance of {tolerance:g} mm.",
        "Draw the curve with lines and circular arcs, or verify with a greater tolerance.",
        fit="number",
        distance="number",
        rounding="number",
        tolerance="number",
    ),
    "verify.off-line": entry(
        "The path of the {tool:tool} is {distance:.4f} mm away from the edge that it should "
        "follow, and the controller may round corners by another {rounding:.4f} mm. The "
        "tolerance is {tolerance:g} mm.",
        "Increase the tolerance, or report an internal error with the program file.",
        tool="text",
        distance="number",
        rounding="number",
        tolerance="number",
    ),
    "verify.one-pass": entry(
        "The board should be cut in passes of at most {step:g} mm, but programs for this "
        "controller do not set the depth: the knife cuts {depth:g} mm in one pass.",
        "Run the program several times, with less pressure on the knife at first.",
        step="number",
        depth="number",
    ),
    "verify.other-placement": entry(
        "The program places the drawing at X{x:.4f} Y{y:.4f} on the sheet, but the job places "
        "it at X{job_x:.4f} Y{job_y:.4f}.",
        "Compile the job again, or verify the program with the position X{x:.4f} Y{y:.4f} of the "
        "drawing.",
        x="number",
        y="number",
        job_x="number",
        job_y="number",
    ),
    "verify.outline-begun": entry(
        "The edge at X{x:.3f} Y{y:.3f} (coordinates of the sheet) lies on a part of the board "
        "whose outline the program begins to cut in line {line}, before this edge is made.",
        "Make creases, grooves, half-cuts and perforations before the outline of their part.",
        x="number",
        y="number",
        line="count",
    ),
    "verify.pass-alone": entry(
        "The cutter mills {length:.3f} mm only {depth:.3f} mm deep, and no other pass goes through "
        "the board there.",
        _COMPILE_AGAIN,
        length="number",
        depth="number",
    ),
    "verify.pass-too-deep": entry(
        "The {tool:tool} cuts {depth:.3f} mm deep in a single pass along {length:.3f} mm, but "
        "at most {step:g} mm per pass are allowed.",
        "Add a shallower pass, or allow deeper passes in the board file.",
        tool="text",
        depth="number",
        length="number",
        step="number",
    ),
    "verify.program-too-large": entry(
        "The program has {bytes:,} bytes, but the controller of {machine} takes {limit:,}.",
        "Make the drawing in several jobs, or choose another machine. The limit is program_memory "
        "in the machine file.",
        bytes="count",
        machine="text",
        limit="count",
    ),
    "verify.swivel-mark": entry(
        "The freely turning blade turns by {turn:.0f}° about its tip, and its slanted edge cuts "
        "the top face up to {mark:.2f} mm beside the line (permitted: {tolerance:g} mm).",
        "Let the blade turn at a smaller depth (`swivel_depth` of the knife), use a blade with a "
        "steeper edge, or accept the mark.",
        turn="number",
        mark="number",
        tolerance="number",
    ),
    "verify.past-end": entry(
        "The {tool:tool} continues {length:.3f} mm beyond the end of the edge.",
        _COMPILE_AGAIN,
        tool="text",
        length="number",
    ),
    "verify.past-open-cut": entry(
        "The cutter continues {length:.3f} mm beyond the end of an open cut.",
        _COMPILE_AGAIN,
        length="number",
    ),
    "verify.past-stop": entry(
        "The {tool:tool} cuts {length:.3f} mm beyond the point where it must stop.",
        _COMPILE_AGAIN,
        tool="text",
        length="number",
    ),
    "verify.perforation-bridge": entry(
        "A gap of the perforation, which begins {place:.3f} mm from the start of the edge, is only "
        "{length:.3f} mm long in the top face of the board, but it must be at least {least:.3f} mm "
        "long to hold the board.",
        "Compile the job again for this board.",
        length="number",
        place="number",
        least="number",
    ),
    "verify.perforation-cut": entry(
        "A cut of the perforation is {length:.3f} mm long instead of {planned:.3f} mm.",
        "Compile the job again for this board.",
        length="number",
        planned="number",
    ),
    "verify.perforation-gap": entry(
        "A gap of the perforation, which begins {place:.3f} mm from the start of the edge, is "
        "{length:.3f} mm long, but the board needs gaps of {planned:g} mm.",
        "Compile the job again for this board.",
        length="number",
        place="number",
        planned="number",
    ),
    "verify.perforation-uneven": entry(
        "A cut of the perforation is not where it is planned: the gap that begins {place:.3f} mm "
        "from the start of the edge is {first:.3f} mm long, and the gap after the cut "
        "{second:.3f} mm.",
        "Compile the job again for this board.",
        first="number",
        second="number",
        place="number",
    ),
    "verify.released-before": entry(
        "The edge at X{x:.3f} Y{y:.3f} (coordinates of the sheet) lies on a part of the board "
        "that an earlier program has already cut out or begun to cut out on this sheet.",
        "Continue from the first contour that is not made, or start a new sheet. If the tool did "
        "not cut through the board, state this when you continue the job.",
        x="number",
        y="number",
    ),
    "verify.replaced": entry(
        "{length:.2f} mm of this line of the type {type} are not made, because a line of the type "
        "{other} lies on it and is made instead.",
        "If the {type} is meant, set the line type of the other line to ignored.",
        type="text",
        other="text",
        length="number",
    ),
    "verify.slanted": entry(
        "Station {station} moves {distance:.3f} mm sideways (away from the axis of its tool) "
        "while the tool enters or leaves the board.",
        "Move the tool along its axis while it enters or leaves the board.",
        station="count",
        distance="number",
    ),
    "verify.stray": entry(
        "The {tool:tool} processes {length:.3f} mm of the board at X{x:.3f} Y{y:.3f} "
        "(coordinates of the sheet), where the drawing has no edge.",
        _COMPILE_AGAIN,
        tool="text",
        length="number",
        x="number",
        y="number",
    ),
    "verify.stray-along": entry(
        "The {tool:tool} processes {length:.3f} mm along edge {edge}, whose line type ({type}) "
        "must not be processed with this tool.",
        "Check the line type of the edge, then compile the job again.",
        tool="text",
        length="number",
        edge="edge",
        type="text",
    ),
    "verify.stray-plunge": entry(
        "The {tool:tool} enters the board at X{x:.3f} Y{y:.3f} (coordinates of the sheet), "
        "where the drawing has no edge.",
        _COMPILE_AGAIN,
        tool="text",
        x="number",
        y="number",
    ),
    "verify.stray-plunge-along": entry(
        "The {tool:tool} enters the board on edge {edge}, whose line type ({type}) must not be "
        "processed with this tool.",
        "Check the line type of the edge, then compile the job again.",
        tool="text",
        edge="edge",
        type="text",
    ),
    "verify.stub-too-short": entry(
        "The last {length:.2f} mm of the cut, from a corner at which the knife is lifted to an end "
        "inside a panel, are not made: there the slanted blade needs a cut longer than "
        "{lead:.2f} mm.",
        "Draw a longer stub, join its end to another cut, set its line type to ignored, or choose "
        "a knife with a less slanted blade.",
        length="number",
        lead="number",
    ),
    "verify.too-few-bridges": entry(
        "Only {bridges:# bridge holds|# bridges hold} the part, but the board needs at least "
        "{fewest:# bridge|# bridges}.",
        "Compile the job again, or require fewer bridges in the board file. Where contours "
        "cross, divide them at their crossings in the drawing.",
        bridges="count",
        fewest="count",
    ),
    "verify.unclassified": entry(
        "The edge has no line type (such as cut or crease), so the required tool is not known.",
        "Give the edge a line type.",
    ),
    "verify.unreached": entry(
        "The cutter cannot reach {length:.3f} mm of the edge, in {places:# place|# places}, "
        "without cutting into a part. The edge lies up to {distance:.3f} mm from the board that "
        "the cutter removes.",
        "Choose a thinner cutter, widen the slot, or round the inner corners with at least the "
        "radius of the cutter.",
        length="number",
        places="count",
        distance="number",
    ),
    "verify.wheel-below-base": entry(
        "The creasing wheel is pressed {depth:.3f} mm below the surface of the mat, {excess:.3f} "
        "mm deeper than the creasing base yields ({most:.3f} mm).",
        "Compile the job again for this machine, or put a soft creasing mat on the table and "
        "state its yield in the machine file.",
        depth="number",
        excess="number",
        most="number",
    ),
    "verify.where-from-start": entry(
        "The missing part begins {place:.3f} mm from the start of the edge.",
        place="number",
    ),
    "verify.where-past-end": entry(
        "The tool must also process the board beyond the end of the edge.",
    ),
    "verify.where-past-start": entry(
        "The tool must also process the board before the start of the edge.",
    ),
    "verify.wide-rim": entry(
        "The creasing wheel has a rim of {width:g} mm, which is wide for a board {caliper:g} mm "
        "thick: the bead becomes wide, and the fold has no definite line.",
        "Mount a creasing wheel with a rim of at most {most:g} mm.",
        width="number",
        caliper="number",
        most="number",
    ),
    "verify.wide-slit": entry(
        "The cutter mills {length:.3f} mm of the slit {width:.2f} mm wide, because it follows the "
        "line of the slit with its centre.",
        "Cut the slit with a knife, choose a thinner cutter, or draw the slit as an outline of the "
        "width that it should have.",
        length="number",
        width="number",
    ),
    "verify.work-creased": entry(
        "a crease",
    ),
    "verify.work-cut": entry(
        "a cut",
    ),
    "verify.work-grooved": entry(
        "a groove",
    ),
    "verify.work-grooved-from-end": entry(
        "a groove in the direction from the end to the start of the edge",
    ),
    "verify.work-grooved-from-start": entry(
        "a groove in the direction from the start to the end of the edge",
    ),
    "verify.wrong-depth": entry(
        "The {tool:tool} is {depth:.4f} mm below the top face of the board instead of "
        "{planned:.4f} mm.",
        "Compile the job again for this board.",
        tool="text",
        depth="number",
        planned="number",
    ),
    "verify.wrong-heading": entry(
        "The {tool:tool} is turned {degrees:.3f}° away from the direction of the edge, which "
        "moves its cutting edge {swing:.3f} mm sideways.",
        _COMPILE_AGAIN,
        tool="text",
        degrees="number",
        swing="number",
    ),
}
