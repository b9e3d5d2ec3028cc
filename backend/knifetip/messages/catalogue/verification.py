"""verification: findings of the verifier."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "verify.bad-tolerance": entry(
        "A tolerance of {tolerance} mm is not a length.",
        "Give a number greater than 0, usually 0.01 mm.",
        tolerance="text",
    ),
    "verify.beam-on-rapid": entry(
        "The beam is on along a rapid of {length:.3f} mm.",
        length="number",
    ),
    "verify.beam-refocused": entry(
        "The beam is on while its focus moves by {height:.3f} mm.",
        height="number",
    ),
    "verify.beside-line": entry(
        "The {tool:tool} is {distance:.3f} mm off the line.",
        tool="text",
        distance="number",
    ),
    "verify.beyond-rotation": entry(
        "Joint {joint} turns to {position:.3f}°; its travel is {low:g} to {high:g}°.",
        joint="text",
        position="number",
        low="number",
        high="number",
    ),
    "verify.beyond-travel": entry(
        "Joint {joint} goes to {position:.3f} mm; its travel is {low:g} to {high:g} mm.",
        joint="text",
        position="number",
        low="number",
        high="number",
    ),
    "verify.bridge-near-corner": entry(
        "The bridge at {place:.3f} mm along the contour is {distance:.3f} mm too near a sharp "
        "corner.",
        place="number",
        distance="number",
    ),
    "verify.bridge-spacing": entry(
        "From the bridge at {place:.3f} mm along the contour it is {distance:.3f} mm to the next; "
        "the board allows {most:g} mm.",
        place="number",
        distance="number",
        most="number",
    ),
    "verify.bridge-spare": entry(
        "The bridge at {place:.3f} mm along the contour is not needed: without it the next two "
        "are {distance:.3f} mm apart.",
        place="number",
        distance="number",
    ),
    "verify.bridge-width": entry(
        "The bridge at {place:.3f} mm along the contour is {width:.3f} mm wide in the top face; "
        "the board needs {planned:g} mm.",
        place="number",
        width="number",
        planned="number",
    ),
    "verify.centre-off-path": entry(
        "The cutter's centre is {distance:.4f} mm off its path, and the controller may round "
        "{rounding:.4f} mm more; the tolerance is {tolerance:g} mm.",
        distance="number",
        rounding="number",
        tolerance="number",
    ),
    "verify.cleaning-beyond": entry("Cleaning: the edge is worked where nothing was drawn."),
    "verify.cleaning-dropped": entry(
        "Cleaning dropped {length:.3f} mm of the edge.",
        length="number",
    ),
    "verify.cleaning-incomplete": entry(
        "Cleaning: the stretches of the edge do not add up to its length.",
    ),
    "verify.cleaning-invented": entry("Cleaning: no part of the edge was drawn."),
    "verify.cleaning-moved": entry(
        "Cleaning moved the edge by {distance:.4f} mm.",
        distance="number",
    ),
    "verify.cleaning-type": entry(
        "Cleaning: the edge is {drawn} and is worked as {worked}.",
        drawn="text",
        worked="text",
    ),
    "verify.comes-out-anywhere": entry(
        "The knife comes out neither where an edge ends nor where it went in.",
    ),
    "verify.comes-out-past": entry(
        "The knife comes out {distance:.3f} mm past where it should.",
        distance="number",
    ),
    "verify.comes-out-short": entry(
        "The knife comes out {distance:.3f} mm short of where it should.",
        distance="number",
    ),
    "verify.crease-too-short": entry("The crease is too short for the wheel."),
    "verify.cuts-part": entry("The cutter takes {depth:.3f} mm off the part.", depth="number"),
    "verify.cutter-at-rest": entry("The cutter works while it does not turn."),
    "verify.flank-inside": entry(
        "A flank comes out {distance:.4f} mm inside its place on the top face; the tolerance is "
        "{tolerance:g} mm.",
        distance="number",
        tolerance="number",
    ),
    "verify.flank-outside": entry(
        "A flank comes out {distance:.4f} mm outside its place on the top face; the tolerance is "
        "{tolerance:g} mm.",
        distance="number",
        tolerance="number",
    ),
    "verify.flank-through-cut": entry(
        "A flank goes {depth:.3f} mm through the cut at edge {edge}, which lies {distance:.3f} mm "
        "beside the groove, {place:.1f} mm from its start.",
        depth="number",
        edge="count",
        distance="number",
        place="number",
    ),
    "verify.goes-in-anywhere": entry("The knife goes in where no edge begins."),
    "verify.groove-arc": entry("The groove is an arc, which a tilted blade cannot follow."),
    "verify.groove-past-ends": entry(
        "The blade runs {length:.2f} mm past the ends of the groove; the board allows {most:.2f} "
        "mm.",
        length="number",
        most="number",
    ),
    "verify.groove-shallower": entry(
        "The V-cutter goes {depth:.3f} mm deep after an earlier pass of {before:.3f} mm.",
        depth="number",
        before="number",
    ),
    "verify.inside-part": entry(
        "The cutter works at X{x:.3f} Y{y:.3f} of the sheet, inside a part.",
        x="number",
        y="number",
    ),
    "verify.knife-at-rest": entry("The oscillating knife cuts while its oscillation is off."),
    "verify.laser-off": entry("The laser cuts while it is off."),
    "verify.loose-piece": entry(
        "The edge is worked at X{x:.3f} Y{y:.3f} of the sheet, on a piece that line {line} has "
        "already cut loose.",
        "Cut the contour around the piece afterwards.",
        x="number",
        y="number",
        line="count",
    ),
    "verify.lowers-second": entry(
        "The line lowers station {station} while station {other} may be lowered.",
        "Release station {other} first (M65 P{output}).",
        station="count",
        other="count",
        output="count",
    ),
    "verify.moves-before-stated": entry(
        "The program moves before it states {thing}.",
        "Until it is stated, lift only, straight up to joint Z {height:.3f} mm or higher.",
        thing="message",
        height="number",
    ),
    "verify.moves-with-beam": entry(
        "The program moves before it states the spindle (M5), so a beam may still be on.",
    ),
    "verify.never-stated": entry("The program ends without stating {thing}.", thing="message"),
    "verify.no-station": entry("The line feeds, and no station has been chosen."),
    "verify.not-worked": entry(
        "{length:.3f} mm of the edge are not {work}{where}.",
        length="number",
        work="message",
        where="message",
    ),
    "verify.off-line": entry(
        "The {tool:tool} is {distance:.4f} mm off the line, and the controller may round "
        "{rounding:.4f} mm more; the tolerance is {tolerance:g} mm.",
        tool="text",
        distance="number",
        rounding="number",
        tolerance="number",
    ),
    "verify.oscillation-on": entry(
        "Station {station} works while the oscillation is on.",
        station="count",
    ),
    "verify.other-placement": entry(
        "The program states the placement X{x:.4f} Y{y:.4f}; the job has X{job_x:.4f} "
        "Y{job_y:.4f}.",
        x="number",
        y="number",
        job_x="number",
        job_y="number",
    ),
    "verify.output": entry("output {output} (M65 P{output})", output="count"),
    "verify.output-off": entry(
        "Station {station} works while its output {output} is off.",
        station="count",
        output="count",
    ),
    "verify.pass-too-deep": entry(
        "The {tool:tool} goes {depth:.3f} mm deep along {length:.3f} mm that no earlier pass has "
        "prepared; at most {step:g} mm at once is allowed.",
        tool="text",
        depth="number",
        length="number",
        step="number",
    ),
    "verify.past-end": entry(
        "The {tool:tool} runs {length:.3f} mm past the end of the edge.",
        tool="text",
        length="number",
    ),
    "verify.past-open-cut": entry(
        "The cutter goes {length:.3f} mm past the end of an open cut.",
        length="number",
    ),
    "verify.past-stop": entry(
        "The {tool:tool} works {length:.3f} mm past where it should stop.",
        tool="text",
        length="number",
    ),
    "verify.perforation-cut": entry(
        "A perforation has a cut of {length:.3f} mm; {planned:.3f} mm is planned.",
        length="number",
        planned="number",
    ),
    "verify.perforation-gap": entry(
        "The perforation has a gap of {length:.3f} mm, {place:.3f} mm from its start; the board "
        "needs gaps of {planned:g} mm.",
        length="number",
        place="number",
        planned="number",
    ),
    "verify.rapid-in-board": entry(
        "A rapid takes station {station} {depth:.3f} mm below the top of the board.",
        station="count",
        depth="number",
    ),
    "verify.slanted": entry(
        "Station {station} goes {distance:.3f} mm sideways off its own line while it plunges or "
        "lifts in the board.",
        station="count",
        distance="number",
    ),
    "verify.spindle": entry("the spindle (M5)"),
    "verify.stray": entry(
        "The {tool:tool} works {length:.3f} mm at X{x:.3f} Y{y:.3f} of the sheet, where no edge "
        "asks for it.",
        tool="text",
        length="number",
        x="number",
        y="number",
    ),
    "verify.stray-along": entry(
        "The {tool:tool} works {length:.3f} mm along edge {edge}, which is {type} and does not "
        "ask for it.",
        tool="text",
        length="number",
        edge="count",
        type="text",
    ),
    "verify.stray-plunge": entry(
        "The {tool:tool} goes down at X{x:.3f} Y{y:.3f} of the sheet, where no edge asks for it.",
        tool="text",
        x="number",
        y="number",
    ),
    "verify.stray-plunge-along": entry(
        "The {tool:tool} goes down on edge {edge}, which is {type} and does not ask for it.",
        tool="text",
        edge="count",
        type="text",
    ),
    "verify.switches-at-unknown-height": entry(
        "The line switches at a height that no line before it states.",
        "Lift to {needed:.3f} mm first.",
        needed="number",
    ),
    "verify.switches-low": entry(
        "The line switches at joint Z {height:.3f} mm.",
        "Lift to {needed:.3f} mm first.",
        height="number",
        needed="number",
    ),
    "verify.too-few-bridges": entry(
        "{bridges:# bridge holds|# bridges hold} the part; the board needs at least {fewest}.",
        bridges="count",
        fewest="count",
    ),
    "verify.turn-at-feed": entry(
        "C turns by {degrees:.4f}° at a feed in mm/min.",
        "State how long the move takes (G93).",
        degrees="number",
    ),
    "verify.turn-in-board": entry(
        "C turns by {degrees:.3f}° in the board; at most {most:.2f}° is allowed.",
        degrees="number",
        most="number",
    ),
    "verify.turn-off-path": entry(
        "C turns by {degrees:.3f}° in the board while the path turns by {path:.3f}°.",
        degrees="number",
        path="number",
    ),
    "verify.two-lowered": entry(
        "Station {station} works while station {other} is lowered too (output {output}).",
        station="count",
        other="count",
        output="count",
    ),
    "verify.unclassified": entry(
        "The edge has no line type, so its work is not known.",
        "Give it a line type.",
    ),
    "verify.unknown-position": entry(
        "The line moves from or to a position that no line before it states.",
    ),
    "verify.where-from-start": entry(", beginning {place:.3f} mm from its start", place="number"),
    "verify.where-past-end": entry(", where the tool must run out past its end"),
    "verify.where-past-start": entry(", where the tool must run out past its start"),
    "verify.work-creased": entry("creased"),
    "verify.work-cut": entry("cut"),
    "verify.work-grooved": entry("grooved"),
    "verify.work-grooved-from-end": entry("grooved from its end"),
    "verify.work-grooved-from-start": entry("grooved from its start"),
    "verify.wrong-depth": entry(
        "The {tool:tool} goes {depth:.3f} mm below the top of the board; {planned:.3f} mm is "
        "planned.",
        tool="text",
        depth="number",
        planned="number",
    ),
    "verify.wrong-feed": entry(
        "Station {station} has a feed of {feed:g} mm/min instead of {planned:g}.",
        station="count",
        feed="number",
        planned="number",
    ),
    "verify.wrong-heading": entry(
        "The {tool:tool} is turned {degrees:.3f}° off the line, so that it swings {swing:.3f} mm.",
        tool="text",
        degrees="number",
        swing="number",
    ),
    "verify.wrong-time": entry(
        "Station {station} takes {seconds:.4f} s instead of {planned:.4f} s.",
        station="count",
        seconds="number",
        planned="number",
    ),
}
