"""testpiece: names of wizards and figures, and messages about test pieces and measures."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "testpiece.all-through": entry(
        "Even the first cut goes through, so the knife is deeper than programmed by more than "
        "{reach:.3g} mm.",
        "Raise the offset in Z of the station by this length, and cut the piece again.",
        reach="number",
    ),
    "testpiece.bad-range": entry(
        "The range of good flaps needs a first and a last flap, and the first must not be greater "
        "than the last.",
        "Enter both numbers of the comb, or leave both empty.",
    ),
    "testpiece.crease-depth": entry(
        "Depth of creases",
    ),
    "testpiece.crease-depth.description": entry(
        "Two combs of flaps, creased to increasing depths along and across the grain",
    ),
    "testpiece.crease-depth.instruction": entry(
        "Fold each flap, counting from the slanted corner: comb A has creases along the grain, "
        "comb B across it. Note the first flap that stays folded and the last whose liner does not "
        "crack.",
    ),
    "testpiece.deflection": entry(
        "Deflection of a cutter",
    ),
    "testpiece.deflection.description": entry(
        "A milled rectangle whose sides show how far the board pushes the cutter away",
    ),
    "testpiece.deflection.instruction": entry(
        "Measure width and height of the rectangle in the middle of its sides, with a calliper.",
    ),
    "testpiece.figure.angle": entry(
        "Angle between the axes X and Y",
    ),
    "testpiece.figure.back": entry(
        "d, distance of the tip from the axis, across the blade",
    ),
    "testpiece.figure.crease-across": entry(
        "Depth of creases across the grain",
    ),
    "testpiece.figure.crease-along": entry(
        "Depth of creases along the grain",
    ),
    "testpiece.figure.deflection-x": entry(
        "Deflection in X",
    ),
    "testpiece.figure.deflection-y": entry(
        "Deflection in Y",
    ),
    "testpiece.figure.half-width": entry(
        "r, distance of the tip from the axis, along the blade",
    ),
    "testpiece.figure.offset-x": entry(
        "Offset of the station in X",
    ),
    "testpiece.figure.offset-y": entry(
        "Offset of the station in Y",
    ),
    "testpiece.figure.offset-z": entry(
        "Offset of the station in Z",
    ),
    "testpiece.figure.pulses-x": entry(
        "Pulses per mm of X",
    ),
    "testpiece.figure.pulses-y": entry(
        "Pulses per mm of Y",
    ),
    "testpiece.figure.scale-x": entry(
        "Scale of X (travelled / drawn)",
    ),
    "testpiece.figure.scale-y": entry(
        "Scale of Y (travelled / drawn)",
    ),
    "testpiece.implausible": entry(
        "{measure} is {value:g} mm, but {drawn:g} mm was drawn, so the measure is not plausible.",
        "Check the measure and its unit. If it is right, adjust the machine roughly first.",
        measure="text",
        value="number",
        drawn="number",
    ),
    "testpiece.impossible": entry(
        "The new value would be {value:.4g} mm, but it must be at least {least:g} mm.",
        "Check the measure and its sign.",
        value="number",
        least="number",
    ),
    "testpiece.knife-depth": entry(
        "Depth of a knife",
    ),
    "testpiece.knife-depth.description": entry(
        "A row of short cuts, each deeper than the one before",
    ),
    "testpiece.knife-depth.instruction": entry(
        "Turn the piece over. Count the cuts from the cut-off corner (each fifth is longer), and "
        "note the first that is seen from below over its whole length.",
    ),
    "testpiece.no-depth": entry(
        "Programs of {machine} do not set the depth of a tool, so it cannot be measured.",
        "Set the depth at the machine.",
        machine="text",
    ),
    "testpiece.no-knife": entry(
        "{machine} makes its cuts without a knife, and only cuts of a knife are a reference for "
        "the offset of another tool.",
        "Set the offset with the tool check at the station.",
        machine="text",
    ),
    "testpiece.no-parallelogram": entry(
        "Sides and diagonals differ by {difference:.3g} mm from those of any parallelogram.",
        "Measure them again, each from corner to corner, and enter how exactly you can read them.",
        difference="number",
    ),
    "testpiece.none-through": entry(
        "No cut goes through, so the knife is shallower than programmed by more than "
        "{reach:.3g} mm.",
        "Lower the offset in Z of the station by this length, and cut the piece again.",
        reach="number",
    ),
    "testpiece.nothing-measured": entry(
        "No comb was judged.",
        "Enter the first and the last good flap of comb A, of comb B, or of both.",
    ),
    "testpiece.other-station": entry(
        "In this board, station {station} does not make lines of the type {type}. The station that "
        "makes them: {other} (0: none).",
        "Choose a board that suits the tool of the station, or the other station.",
        type="text",
        station="count",
        other="count",
    ),
    "testpiece.other-tool": entry(
        "The tool of station {station} is not measured with this test piece.",
        "Choose another test piece or another station.",
        station="count",
    ),
    "testpiece.squareness": entry(
        "Squareness and scale",
    ),
    "testpiece.squareness.description": entry(
        "A rectangle whose sides and diagonals show scale and angle of the axes",
    ),
    "testpiece.squareness.instruction": entry(
        "Measure both sides and both diagonals, with a steel rule or a long calliper. The slit is "
        "beside the lower left corner.",
    ),
    "testpiece.station-offset": entry(
        "Offset of a station",
    ),
    "testpiece.station-offset.description": entry(
        "Lines of the tool 20 mm beside lines of the knife, along X and Y",
    ),
    "testpiece.station-offset.instruction": entry(
        "Measure from the cut to the middle of the line of the tool beside it, once along X and "
        "once along Y.",
    ),
    "testpiece.unknown-station": entry(
        "{machine} has no station {station}.",
        "Choose a station of the machine.",
        machine="text",
        station="count",
    ),
    "testpiece.v-cutter": entry(
        "Offsets of a V-cutter",
    ),
    "testpiece.v-cutter.description": entry(
        "Grooves of two cuts in opposite directions, whose traces should meet",
    ),
    "testpiece.v-cutter.instruction": entry(
        "Look at the groove at the right edge with a loupe and measure the distance of the two "
        "cuts at its bottom. Then measure one cut of the inner groove in the top face; the marks "
        "beside it are 1 mm apart and begin at the ends of the line.",
    ),
}
