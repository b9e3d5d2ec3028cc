"""compensation: tools, and edges that they cannot make on a board."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "bridges.no-room": entry(
        "The contour at edge {edge} is {length:.1f} mm long and has no places for {fewest:# "
        "bridge|# bridges} of {gap:.2f} mm, at most {spacing:.1f} mm apart and clear of its "
        "corners and narrow slots.",
        "Choose narrower bridges or a longer spacing, or cut this board without bridges.",
        edge="count",
        length="number",
        fewest="count",
        gap="number",
        spacing="number",
    ),
    "crease.tight-bend": entry(
        "The crease at edge {edge} bends with a radius of {radius:.2f} mm, and its double would "
        "lie {offset:.2f} mm inside it.",
        "Draw a wider bend, or set the board's double crease to 0.",
        edge="count",
        radius="number",
        offset="number",
    ),
    "crease.too-short": entry(
        "The crease at edge {edge} is {length:.2f} mm long, too short for a wheel of {radius:.1f} "
        "mm radius that keeps {clearance:.2f} mm off its ends.",
        "Join it to its neighbour, ignore it, or choose a board that allows short creases to be "
        "pressed in place.",
        edge="count",
        length="number",
        radius="number",
        clearance="number",
    ),
    "cut.too-many-crossings": entry(
        "More than {limit:,} pairs of cuts cross or lie beside each other.",
        "Delete hatching and what is drawn many times over, or split the drawing.",
        limit="count",
    ),
    "cut.too-short": entry(
        "The cut at edge {edge} is {length:.2f} mm long and ends inside a panel or at a bridge; "
        "the slanted blade needs {lead:.2f} mm.",
        "Ignore it, join it to another cut, or choose a steeper blade.",
        edge="count",
        length="number",
        lead="number",
    ),
    "cutter.does-not-fit": entry(
        "The cutter of {diameter:.2f} mm does not fit into the contour at edge {edge}, nor into "
        "{others} more.",
        "Choose a thinner cutter, or ignore the contour.",
        diameter="number",
        edge="count",
        others="count",
    ),
    "cutter.misses-bridge": entry(
        "The cutter does not reach the contour at edge {edge} where a bridge is needed, "
        "{distance:.1f} mm along it.",
        "Choose a thinner cutter, another spacing of bridges, or a board without them.",
        edge="count",
        distance="number",
    ),
    "cutter.short-lead": entry(
        "The cutter's lead is {lead:g} mm, not longer than its radius of {radius:g} mm.",
        "Give the cutter a lead longer than its radius.",
        lead="number",
        radius="number",
    ),
    "groove.along-edge": entry(
        "The V-groove at edge {edge} meets the board's edge at {angle:.1f}°, almost along it, so "
        "its flanks would not leave the board.",
        "End it before the edge, or meet the edge at 5° or more.",
        edge="count",
        angle="number",
    ),
    "groove.curved": entry(
        "{count:# V-groove edge is an arc|# V-groove edges are arcs}, the first of them edge "
        "{edge}; a straight blade cannot follow an arc.",
        "Draw straight lines, or give them another line type.",
        count="count",
        edge="count",
    ),
    "groove.overcut": entry(
        "The blade runs {overrun:.2f} mm past each end of a V-groove inside the board; the board "
        "allows {allowed:.2f} mm.",
        "Choose a narrower blade, or allow a longer overcut for this board.",
        overrun="number",
        allowed="number",
    ),
    "groove.runs-out": entry(
        "The V-groove at edge {edge} would run {distance:.2f} mm over the board's edge, and cut "
        "into the board beyond.",
        "End it before the edge, meet the edge more squarely, or move the blanks apart.",
        edge="count",
        distance="number",
    ),
    "groove.through-cut": entry(
        "The V-groove at edge {groove} is {width:.2f} mm wide at the top face, and its flank runs "
        "{through:.2f} mm through the cut at edge {cut}, which lies {distance:.2f} mm beside it, "
        "{place:.1f} mm from where the groove begins.",
        "Move them {through:.2f} mm further apart, or make the groove less deep.",
        groove="count",
        width="number",
        through="number",
        cut="count",
        distance="number",
        place="number",
    ),
    "groove.through-cut-at-it": entry(
        "The V-groove at edge {groove} is {width:.2f} mm wide at the top face, and its flank runs "
        "{through:.2f} mm through the cut at edge {cut}, which lies {distance:.2f} mm beside it, "
        "{place:.1f} mm from where the groove begins.",
        "End the groove at the cut, or move one of them.",
        groove="count",
        width="number",
        through="number",
        cut="count",
        distance="number",
        place="number",
    ),
    "groove.tight-bend": entry(
        "The V-groove at edge {edge} bends with a radius of {radius:.1f} mm; a blade of "
        "{blade:.2f} mm deviates from it by more than {error:.3f} mm.",
        "Draw a wider bend, choose a narrower blade, or allow this board a larger error.",
        edge="count",
        radius="number",
        blade="number",
        error="number",
    ),
    "groove.too-deep": entry(
        "The V-groove at edge {edge} is {depth:.2f} mm deep, and the board is only {caliper:.2f} "
        "mm thick.",
        "Choose a shallower groove or a thicker board.",
        edge="count",
        depth="number",
        caliper="number",
    ),
    "groove.too-short": entry(
        "The V-groove at edge {edge} is {length:.2f} mm long, and the blade is {blade:.2f} mm "
        "wide.",
        "Draw the groove longer, or choose a narrower blade.",
        edge="count",
        length="number",
        blade="number",
    ),
    "milling.shared-edge": entry(
        "Two blanks share edge {edge}, and the cutter removes {diameter:g} mm from one or the "
        "other.",
        "Move them at least {diameter:g} mm apart, each with an edge of its own, or choose a "
        "machine with a knife.",
        edge="count",
        diameter="number",
    ),
    "tool.bad-radius": entry(
        "A tool's radius is not a number of 0 mm or more.",
        "Correct the tool.",
    ),
    "tool.cannot-work": entry(
        "Station {station} ({name}) of {machine} cannot work: {reason}",
        "Complete the tool in the machine's file.",
        station="count",
        name="text",
        machine="text",
        reason="message",
    ),
    "tool.missing": entry(
        "{machine} has no tool for {type} ({count:# edge|# edges}).",
        "Give them another line type, or choose another machine.",
        count="count",
        type="text",
        machine="text",
    ),
    "tool.tilted": entry(
        "The tool is tilted by {tilt:.2f}°, and moving along its axis lifts it only up to "
        "{limit:g}°.",
        "Choose a tool that is less tilted.",
        tilt="number",
        limit="number",
    ),
    "tool.without-power": entry("The laser has no power."),
    "tool.without-speed": entry("The cutter has no spindle speed."),
    "track.too-flat": entry(
        "Track {track} leaves the board at {angle:.2f}° from square, so its tool never leaves the "
        "board (limit {limit:g}°).",
        "End the line inside the board, or draw it across the edge.",
        track="count",
        angle="number",
        limit="number",
    ),
}
