"""edge_choice: messages about options of a job that concern some edges of the drawing."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "bridge.at-corner": entry(
        "The middle of the bridge on edge {edge} is {distance:.2f} mm from an end of the edge, but "
        "the bridge and the tool need {least:.2f} mm.",
        "Move the bridge, or make it narrower.",
        edge="edge",
        distance="number",
        least="number",
    ),
    "bridge.no-outline": entry(
        "A bridge was placed on edge {edge}, but this edge is no part of the closed outline of a "
        "part.",
        "Remove the bridge, or place it on the outline of a part.",
        edge="edge",
    ),
    "bridge.too-near": entry(
        "The bridges on edge {edge} and edge {other} are {distance:.2f} mm apart, but the tool "
        "needs {least:.2f} mm from one middle to the other.",
        "Move one of the bridges, or remove it.",
        edge="edge",
        other="edge",
        distance="number",
        least="number",
    ),
    "corner-choice.no-cutter": entry(
        "A corner type was chosen for edge {edge}, but {machine} cuts with no router or laser.",
        "Remove the choice, or choose another machine.",
        edge="edge",
        machine="text",
    ),
    "corner-choice.other-type": entry(
        "A corner type was chosen for edge {edge}, which has the line type {type}, but only "
        "cuts have corner types.",
        "Remove the choice.",
        edge="edge",
        type="text",
    ),
    "crease-depth.not-set": entry(
        "A depth was chosen for crease {edge}, but programs of {machine} do not set the depth of "
        "the wheel.",
        "Remove the choice, and set the depth at the machine.",
        edge="edge",
        machine="text",
    ),
    "crease-depth.other-type": entry(
        "A depth of the crease was chosen for edge {edge}, which has the line type {type}.",
        "Remove the choice, or make the edge a crease.",
        edge="edge",
        type="text",
    ),
    "crease-depth.too-deep": entry(
        "The depth chosen for crease {edge} is {depth:g} mm, but the board is {caliper:g} mm "
        "thick.",
        "Choose a depth that is less than the thickness of the board.",
        edge="edge",
        depth="number",
        caliper="number",
    ),
    "depth.not-set": entry(
        "Passes or a depth were chosen for edge {edge}, but programs of {machine} do not set the "
        "depth of the knife.",
        "Remove the choice, and set the depth at the machine.",
        edge="edge",
        machine="text",
    ),
    "depth.of-cutter": entry(
        "A depth was chosen for edge {edge}, but the cutter or laser of station {station} always "
        "cuts through the whole board.",
        "Remove the depth; passes can be chosen for a cutter.",
        edge="edge",
        station="count",
    ),
    "depth.one-pass": entry(
        "Passes were chosen for edge {edge}, but the tool of station {station} cuts in one pass.",
        "Remove the choice, or choose another machine.",
        edge="edge",
        station="count",
    ),
    "depth.other-type": entry(
        "Passes or a depth were chosen for edge {edge}, which has the line type {type}, but they "
        "can be chosen for cuts and half-cuts only.",
        "Remove the choice.",
        edge="edge",
        type="text",
    ),
    "depth.several": entry(
        "The contour of edge {edge} and edge {other} is milled as a whole, but different passes "
        "were chosen for its edges.",
        "Choose the same passes for all edges of the contour.",
        edge="edge",
        other="edge",
    ),
    "depth.too-deep": entry(
        "The depth chosen for edge {edge} is {depth:g} mm, but on this board and table the tool "
        "may cut {most:g} mm deep.",
        "Choose a smaller depth.",
        edge="edge",
        depth="number",
        most="number",
    ),
    "depth.too-few-passes": entry(
        "{passes:# pass was|# passes were} chosen for edge {edge}, but at {step:g} mm in one pass "
        "the tool needs {least} for a depth of {depth:g} mm.",
        "Choose more passes, or leave their number to the tool.",
        edge="edge",
        passes="count",
        least="count",
        depth="number",
        step="number",
    ),
    "edge-choice.bad-syntax": entry(
        "{text!r} is not a value of {option}.",
        "Write it as EDGES:NAME=VALUE,NAME=VALUE, with the numbers of the edges and what is chosen "
        "for them, for example 12,13:passes=2.",
        text="text",
        option="text",
    ),
    "edge-choice.joined": entry(
        "Edge {edge} and edge {other} are made as one edge, but different options were chosen for "
        "them.",
        "Choose the same for both.",
        edge="edge",
        other="edge",
    ),
    "edge-choice.no-edge": entry(
        "An option was chosen for edge {row}, but the drawing has {count:# edge|# edges}, "
        "numbered from 0.",
        "Choose an edge of this drawing.",
        row="count",
        count="count",
    ),
    "lead-choice.bad": entry(
        "The tool cannot make the lead-in that was chosen for edge {edge}: {reason}.",
        "Choose a longer lead-in, or another angle.",
        edge="edge",
        reason="message",
    ),
    "lead-choice.facing": entry(
        "Edge {edge} and edge {other} face each other at {distance:.2f} mm, nearer than the tool "
        "is wide ({diameter:g} mm), but different lead-ins were chosen for their contours.",
        "Choose the same lead-in for both contours.",
        edge="edge",
        other="edge",
        distance="number",
        diameter="number",
    ),
    "lead-choice.no-cutter": entry(
        "A lead-in was chosen for edge {edge}, but {machine} cuts with no router or laser.",
        "Remove the choice. The lead-in of a knife is in the machine file.",
        edge="edge",
        machine="text",
    ),
    "lead-choice.other-type": entry(
        "A lead-in was chosen for edge {edge}, which has the line type {type}, but only cuts have "
        "lead-ins.",
        "Remove the choice.",
        edge="edge",
        type="text",
    ),
    "lead-choice.several": entry(
        "Different lead-ins were chosen for edge {edge} and edge {other} of one contour.",
        "Choose the same lead-in for all edges of the contour.",
        edge="edge",
        other="edge",
    ),
    "order.bad-syntax": entry(
        "{text!r} is not an order of edges.",
        "Write the numbers of the edges with commas between them, for example 12,3,4.",
        text="text",
    ),
    "order.enclosed": entry(
        "Edge {edge} cannot be cut before edge {other}: its contour encloses edge {other}, and "
        "what lies inside a contour is cut while the sheet still holds it.",
        "Put edge {other} before edge {edge}.",
        edge="edge",
        other="edge",
    ),
    "order.not-made": entry(
        "Edge {edge} has a place in the order of the work, but no tool makes it.",
        "Remove it from the order.",
        edge="edge",
    ),
    "order.one-track": entry(
        "Edge {other} cannot be made after edge {edge}: the tool makes it in one track, without a "
        "lift, with an edge that comes before.",
        "Give only one edge of each track a place in the order.",
        edge="edge",
        other="edge",
    ),
    "order.pieces": entry(
        "Edge {edge} cannot be made before edge {other}: holes, slits and inner contours are cut "
        "before outlines, and cuts of equal depth together, so that no tool works on loose board.",
        "Put edge {other} before edge {edge}.",
        edge="edge",
        other="edge",
    ),
    "order.tools": entry(
        "Edge {edge} cannot be made before edge {other}: the tool of station {other_station} makes "
        "all its work before that of station {station}, so that each tool is changed once.",
        "Put edge {other} before edge {edge}.",
        edge="edge",
        other="edge",
        station="count",
        other_station="count",
    ),
    "order.types": entry(
        "Edge {edge} ({type}) cannot be made before edge {other} ({other_type}): creases come "
        "first, while the board lies firmly, then V-grooves, half-cuts and perforations, and cuts "
        "last.",
        "Put edge {other} before edge {edge}.",
        edge="edge",
        other="edge",
        type="text",
        other_type="text",
    ),
    "start.at-corner": entry(
        "The start chosen on edge {edge} is {distance:.2f} mm from an end of the edge, but the "
        "cutter needs {least:.2f} mm to enter beside it.",
        "Choose a point farther from both ends of the edge, or another edge of the contour.",
        edge="edge",
        distance="number",
        least="number",
    ),
    "start.bridged": entry(
        "A start or a direction was chosen for edge {edge}, but its contour has bridges, which "
        "divide it into several cuts.",
        "Remove the choice, or choose a board without bridges.",
        edge="edge",
    ),
    "start.conflict": entry(
        "Two starts or two directions were chosen for the contour of edge {edge} and edge {other}.",
        "Remove one of the two choices.",
        edge="edge",
        other="edge",
    ),
    "start.fixed-direction": entry(
        "Edge {edge} cannot be cut in the chosen direction: the tool of station {station} must "
        "have the waste on its left.",
        "Choose the other direction, or leave the direction free.",
        edge="edge",
        station="count",
    ),
    "start.not-last": entry(
        "The cut cannot begin on edge {edge}, because it also ends there, and an edge that is cut "
        "later must release the part.",
        "Choose an edge of the contour at which the part touches only waste.",
        edge="edge",
    ),
    "start.open": entry(
        "A start or a direction was chosen for edge {edge}, but this edge belongs to no closed cut "
        "or half-cut.",
        "Remove the choice, or choose an edge of a closed contour.",
        edge="edge",
    ),
    "tool-choice.facing": entry(
        "Edge {edge} and edge {other} face each other at {distance:.2f} mm, but different tools "
        "were chosen for them, one of which cuts {diameter:g} mm wide and would cut into the other "
        "contour.",
        "Choose the same tool for both contours.",
        edge="edge",
        other="edge",
        distance="number",
        diameter="number",
    ),
    "tool-choice.no-station": entry(
        "Station {station} was chosen for edge {edge}, but {machine} has no such station.",
        "Choose one of these: {suited:, }.",
        edge="edge",
        station="count",
        machine="text",
        suited="messages",
    ),
    "tool-choice.not-made": entry(
        "A tool was chosen for edge {edge}, which has the line type {type} and is not made.",
        "Remove the choice, or give the edge another line type.",
        edge="edge",
        type="text",
    ),
    "tool-choice.other-kind": entry(
        "Station {station} ({name}) was chosen for edge {edge} ({type}), but on this machine "
        "another kind of tool makes this line type.",
        "Choose one of these: {suited:, }.",
        edge="edge",
        station="count",
        name="text",
        type="text",
        suited="messages",
    ),
    "tool-choice.several": entry(
        "The contour of edge {edge} and edge {other} is milled as a whole, but different tools "
        "were chosen for its edges.",
        "Choose the same tool for all edges of the contour.",
        edge="edge",
        other="edge",
    ),
    "tool-choice.station": entry("{station} ({name})", station="count", name="text"),
    "verify.bridge-missing": entry(
        "The program leaves no bridge at the chosen place on edge {edge}, where one of {width:g} "
        "mm should stay.",
        "Compile the job again.",
        edge="edge",
        width="number",
    ),
    "verify.bridge-not-chosen": entry(
        "The program leaves a bridge of {width:.3f} mm on edge {edge}, where none was placed.",
        "Compile the job again.",
        edge="edge",
        width="number",
    ),
    "verify.no-closed-cut": entry(
        "A direction was chosen for the closed cut with edge {edge}, but the program does not cut "
        "this contour in one run.",
        "Compile the job again.",
        edge="edge",
    ),
    "verify.other-direction": entry(
        "The program cuts edge {edge} against the chosen direction.",
        "Compile the job again.",
        edge="edge",
    ),
    "verify.other-lead": entry(
        "The contour of edge {edge} must have a lead-in of {length:.3f} mm, half of it or none, "
        "but the program enters it on a lead-in of {found:.3f} mm.",
        "Compile the job again.",
        edge="edge",
        length="number",
        found="number",
    ),
    "verify.other-order": entry(
        "Edge {edge} must be made after edge {other}, but the program begins it before, in line "
        "{line}.",
        "Compile the job again.",
        edge="edge",
        other="edge",
        line="count",
    ),
    "verify.other-passes": entry(
        "Edge {edge} must be cut in {passes:# pass|# passes} down to {depth:g} mm below the top "
        "face, but the program cuts it at these depths (mm): {found:, }.",
        "Compile the job again.",
        edge="edge",
        passes="count",
        depth="number",
        found="texts",
    ),
    "verify.other-start": entry(
        "The closed cut with edge {edge} must begin at X {x:.3f} mm, Y {y:.3f} mm on this edge, "
        "but the program begins it elsewhere.",
        "Choose a start with more room for the tool, or compile the job again.",
        edge="edge",
        x="x",
        y="y",
    ),
    "verify.other-tool": entry(
        "Edge {edge} must be made by the tool of station {station}, but the program makes it with "
        "that of station {found}.",
        "Compile the job again.",
        edge="edge",
        station="count",
        found="count",
    ),
    "verify.short-lead": entry(
        "The contour of edge {edge} must have a lead-in of {length:.3f} mm, for which there is "
        "room, but the program enters it on a lead-in of {found:.3f} mm.",
        "Compile the job again.",
        edge="edge",
        length="number",
        found="number",
    ),
}
