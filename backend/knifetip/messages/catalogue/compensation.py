"""compensation: messages about tools, and about edges that a tool cannot process on a board."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "bridges.no-room": entry(
        "The contour at edge {edge} is {length:.1f} mm long, which is too short for {fewest:# "
        "bridge|# bridges} of {gap:.2f} mm width. The board requires bridges (uncut gaps that "
        "hold a part) at most {spacing:.1f} mm apart, and away from corners and narrow slots.",
        "Choose narrower bridges or a larger spacing of bridges in the board file, or choose "
        "a board without bridges.",
        edge="edge",
        length="number",
        fewest="count",
        gap="number",
        spacing="number",
    ),
    "bridges.divided-blank": entry(
        "The part at edge {edge} would be held by {count:# bridge|# bridges}, because cuts divide "
        "its blank. The board requires {fewest:# bridge|# bridges} (uncut gaps) on each part.",
        "Set the line type of the cuts between the parts to ignored and make them by hand, choose "
        "a smaller spacing of bridges in the board file, or choose a board without bridges.",
        edge="edge",
        count="count",
        fewest="count",
    ),
    "crease.below-base": entry(
        "{count} creases are up to {depth:.2f} mm deep, but the creasing base of {machine} permits "
        "{most:.2f} mm, the thickness of the board and the yield of the base.",
        "Choose a board with smaller crease depths, or put a soft creasing mat on the table and "
        "state its yield in the machine file.",
        count="count",
        depth="number",
        most="number",
        machine="text",
    ),
    "crease.tight-bend": entry(
        "The double crease at edge {edge} is bent with a radius of {radius:.2f} mm, which is "
        "too small for a second crease line {offset:.2f} mm inside the bend.",
        "Draw the crease with a larger radius, or set the double crease of the board to 0.",
        edge="edge",
        radius="number",
        offset="number",
    ),
    "cut.too-many-crossings": entry(
        "The drawing has more than {limit:,} pairs of cuts that cross each other or lie beside "
        "each other.",
        "Delete hatching and duplicate lines, or split the drawing into several drawings.",
        limit="count",
    ),
    "cut.too-short": entry(
        "The cut at edge {edge} is {length:.2f} mm long and ends inside a panel or at a "
        "bridge. The slanted blade of the knife needs a cut of at least {lead:.2f} mm.",
        "Set the line type of the cut to ignored, join the cut to another cut, or choose a "
        "knife with a less slanted blade.",
        edge="edge",
        length="number",
        lead="number",
    ),
    "cutter.contour-touches-itself": entry(
        "A contour touches itself at X{x:.3f} Y{y:.3f}, in the edges {edge} and {other}, so the "
        "path of a cutter of {diameter:.3g} mm diameter beside it is not closed.",
        "Trim the two edges at their intersection, or move one of them.",
        x="x",
        y="y",
        edge="edge",
        other="edge",
        diameter="number",
    ),
    "cutter.corner-loop": entry(
        "The edges {edge} and {other} cross {size:.4g} mm before the corner at X{x:.3f} Y{y:.3f}, "
        "where they meet, so the path of a cutter of {diameter:.3g} mm diameter beside them is not "
        "closed.",
        "Trim the two edges at their crossing, so that the corner is there.",
        edge="edge",
        other="edge",
        size="number",
        x="x",
        y="y",
        diameter="number",
    ),
    "cutter.interference": entry(
        "The cutter of {diameter:.2f} mm diameter does not fit beside edge {edge}: it would cut "
        "{depth:.3g} mm into the part at edge {other}. The job allows no parts of contours that "
        "the cutter leaves uncut.",
        "Choose 'Leave this part uncut' (interference 'trim') and accept the shortfalls that the "
        "verdict then lists, or choose a thinner cutter.",
        diameter="number",
        edge="edge",
        depth="number",
        other="edge",
    ),
    "cutter.misses-bridge": entry(
        "A bridge is needed on the contour at edge {edge}, {distance:.1f} mm from the start of "
        "this edge in the direction of milling, but the cutter does not reach the contour there.",
        "Choose a thinner cutter, a board with another spacing of bridges, or a board without "
        "bridges.",
        edge="edge",
        distance="number",
    ),
    "cutter.narrower-slits": entry(
        "{count:# slit|# slits} become {width:g} mm wide. The thinnest cutter of the library, "
        "'{title}', makes them {diameter:g} mm wide.",
        "Fit a cutter of {diameter:g} mm diameter, state it in the file of the machine and compile "
        "again, or accept the wide slits.",
        count="count",
        width="number",
        diameter="number",
        title="text",
    ),
    "cutter.thinner-chosen": entry(
        "The cutter of {diameter:g} mm diameter in station {station} makes the cuts: with the one "
        "of {thickest:g} mm, not all edges could be made as they are drawn.",
        diameter="number",
        station="count",
        thickest="number",
    ),
    "cutter.thinner-needed": entry(
        "The cutter of {own:g} mm diameter leaves {total:# edge|# edges} uncut. A cutter of "
        "{diameter:g} mm diameter, such as '{title}' of the library, makes {count} of them.",
        "Fit a cutter of {diameter:g} mm diameter, state it in the file of the machine and compile "
        "again, or accept the uncut edges.",
        own="number",
        total="count",
        diameter="number",
        title="text",
        count="count",
    ),
    "cutter.short-lead": entry(
        "The lead-in of the cutter is {lead:g} mm long, but must be longer than the radius of "
        "the cutter, {radius:g} mm.",
        "Correct the lead-in in the machine file.",
        lead="number",
        radius="number",
    ),
    "lead.no-corner": entry(
        "{count:# contour has|# contours have} a lead-in perpendicular to the contour, because "
        "{count:it has|they have} no outer corner that turns by at least {angle:g}° and has room "
        "for the lead-in. X and Y on the sheet in mm ({count:one contour|the first contours}): "
        "{places:; }.",
        "No action is needed. To begin at corners that turn less, set a negative angle nearer to "
        "0° for the lead-in in the machine file.",
        count="count",
        angle="number",
        places="texts",
    ),
    "lead.no-room": entry(
        "{count:# contour has|# contours have} no lead-in or no lead-out, because the tool would "
        "cut into another edge there. The tool plunges or lifts on the contour, which may leave a "
        "mark. X and Y on the sheet in mm ({count:one contour|the first contours}): {places:; }.",
        "Choose a thinner tool or a shorter lead-in, or leave more room between the edges.",
        count="count",
        places="texts",
    ),
    "lead.shortened": entry(
        "{count:# contour has|# contours have} a lead-in or a lead-out of half its length, because "
        "the tool would cut into another edge on the full length of {length:.3f} mm. X and Y on "
        "the sheet in mm ({count:one contour|the first contours}): {places:; }.",
        "For the full length, choose a thinner tool or leave more room between the edges.",
        count="count",
        length="number",
        places="texts",
    ),
    "groove.along-edge": entry(
        "The V-groove at edge {edge} meets the edge of the board at an angle of only "
        "{angle:.1f}°, so it would run along the edge of the board instead of ending there.",
        "End the groove before the edge of the board, or let it meet the edge of the board at "
        "5° or more.",
        edge="edge",
        angle="number",
    ),
    "groove.curved": entry(
        "{count:# V-groove is an arc|# V-grooves are arcs} (first: edge {edge}), which a "
        "straight blade cannot follow.",
        "Draw the V-grooves with straight lines, permit chords in the board file (groove_curve), "
        "or choose another line type for them.",
        count="count",
        edge="edge",
    ),
    "groove.overcut": entry(
        "The V-cutter cuts {overrun:.2f} mm too far at each end of a groove that ends inside "
        "the board, but the board allows an overcut of only {allowed:.2f} mm.",
        "Choose a V-cutter with a narrower blade, or allow a longer overcut in the board file.",
        overrun="number",
        allowed="number",
    ),
    "groove.runs-out": entry(
        "The V-groove at edge {edge} would continue {distance:.2f} mm beyond the edge of the "
        "board and cut into the next part.",
        "End the groove before the edge of the board, let it meet the edge of the board at a "
        "larger angle, or move the parts apart.",
        edge="edge",
        distance="number",
    ),
    "groove.through-cut": entry(
        "The V-groove at edge {groove} is {width:.2f} mm wide at the top face of the board. At "
        "{place:.1f} mm from the start of the groove, its flank reaches {through:.2f} mm "
        "sideways across the cut at edge {cut}. The cut lies only {distance:.2f} mm from the "
        "centre line of the groove. The board allows a groove to be shifted away from cuts on one "
        "side by at most {limit:.2f} mm.",
        "Move the groove and the cut {through:.2f} mm further apart, or choose a board with a "
        "shallower groove.",
        groove="edge",
        width="number",
        through="number",
        cut="edge",
        distance="number",
        place="number",
        limit="number",
    ),
    "groove.through-cut-at-it": entry(
        "The V-groove at edge {groove} is {width:.2f} mm wide at the top face of the board. At "
        "{place:.1f} mm from the start of the groove, its flank reaches {through:.2f} mm "
        "sideways across the cut at edge {cut}. The cut lies only {distance:.2f} mm from the "
        "centre line of the groove.",
        "End the groove at the cut, let the cut cross the groove at 45° or more, or move one of "
        "them.",
        groove="edge",
        width="number",
        through="number",
        cut="edge",
        distance="number",
        place="number",
    ),
    "groove.tight-bend": entry(
        "The V-groove at edge {edge} is bent with a radius of {radius:.1f} mm. A straight "
        "blade of {blade:.2f} mm width would deviate from this bend by more than {error:.3f} "
        "mm.",
        "Draw the groove with a larger radius, choose a V-cutter with a narrower blade, or "
        "allow a larger deviation in the board file.",
        edge="edge",
        radius="number",
        blade="number",
        error="number",
    ),
    "groove.too-deep": entry(
        "The V-groove at edge {edge} is {depth:.2f} mm deep, but the board is only {caliper:.2f} "
        "mm thick.",
        "Choose a shallower groove or a thicker board.",
        edge="edge",
        depth="number",
        caliper="number",
    ),
    "groove.too-short": entry(
        "The V-groove at edge {edge} is {length:.2f} mm long, but the blade is {blade:.2f} mm "
        "wide.",
        "Draw a longer groove, or choose a V-cutter with a narrower blade.",
        edge="edge",
        length="number",
        blade="number",
    ),
    "milling.contours-cross": entry(
        "Edge {edge} belongs to a contour that crosses another contour or itself at X{x:.3f} "
        "Y{y:.3f}, so it is not clear on which side the cutter must run.",
        "Trim the contours at their crossings, so that each part has one outline, or set the line "
        "type of the contour that is not to be cut to ignored. To cut both contours as they are "
        "drawn, choose a machine with a knife.",
        edge="edge",
        x="x",
        y="y",
    ),
    "milling.drawn-twice": entry(
        "{count:# cut lies|# cuts lie} at most {distance:.3f} mm beside other cuts, as edge {edge} "
        "beside edge {other}: the board cannot hold so narrow a strip, and the cutter removes it.",
        "If the same line is drawn twice, set the line type of {count:# cut|these # cuts} to "
        "ignored. Otherwise choose a machine with a knife.",
        count="count",
        distance="number",
        edge="edge",
        other="edge",
    ),
    "milling.shared-edge": entry(
        "Two parts share edge {edge}. On its line, a cutter of {diameter:g} mm diameter would cut "
        "into one of the parts at an end of the edge or at a line beside it.",
        "Move the parts at least {diameter:g} mm apart. If the edge divides one blank, set its "
        "line type to ignored and cut it by hand, or choose a machine with a knife.",
        edge="edge",
        diameter="number",
    ),
    "tool.bad-radius": entry(
        "The tool radius for a corner of a contour is negative or not a number.",
        "Correct the radius of the tool in the machine file.",
    ),
    "tool.cannot-work": entry(
        "Station {station} ({name}) of {machine} cannot be used: {reason}",
        "Correct the settings of the tool in the machine file.",
        station="count",
        name="text",
        machine="text",
        reason="message",
    ),
    "knife.park-heading": entry(
        "The blade of station {station} turns freely: before the program starts, turn it to a "
        "heading of {degrees:g}°. The program leaves it in this direction.",
        station="count",
        degrees="number",
    ),
    "tool.free-without-trail": entry(
        "the knife is set to turn freely (free), but its tip lies on its axis (trail is 0), so "
        "moves would not turn it",
    ),
    "tool.missing": entry(
        "{machine} has no tool for {count:# edge|# edges} of type {type}.",
        "Choose another line type for the edges, or another machine.",
        count="count",
        type="text",
        machine="text",
    ),
    "tool.short-lead": entry(
        "the lead-in of {lead:g} mm must be 0 or greater than the tool radius of {radius:g} mm",
        lead="number",
        radius="number",
    ),
    "tool.shallow-lead": entry(
        "the lead-in of {lead:g} mm at an angle of {angle:g}° begins nearer to the contour than "
        "the tool radius of {radius:g} mm; the angle must be between {least:.1f}° and 90°, or "
        "negative for a lead-in round a corner",
        lead="number",
        angle="number",
        radius="number",
        least="number",
    ),
    "tool.swivel-of-driven-knife": entry(
        "`swivel_depth` or `park_heading` is set, but these are only for knives that turn freely "
        "(free), and an axis of the machine turns this knife",
    ),
    "tool.tilted": entry(
        "The tool is tilted by {tilt:.2f}°, but only tools tilted by up to {limit:g}° can be "
        "lifted along their axis.",
        "Choose a tool that is tilted by at most {limit:g}°.",
        tilt="number",
        limit="number",
    ),
    "tool.without-power": entry(
        "The power of the laser is 0.",
        "Set the power of the laser in the machine file.",
    ),
    "tool.without-speed": entry(
        "The spindle speed of the cutter is 0.",
        "Set the spindle speed of the cutter in the machine file.",
    ),
    "track.too-flat": entry(
        "At the edge of the board, the direction of path {track} of the tool deviates by "
        "{angle:.2f}° from the perpendicular to this edge, but a deviation of at most "
        "{limit:g}° is allowed.",
        "End the line inside the board, or let the line cross the edge of the board closer to "
        "a right angle.",
        track="count",
        angle="number",
        limit="number",
    ),
}
