"""geometry: curves, edges and offsets that have no valid result."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "curve.bad-ellipse": entry(
        "The ellipse has no size, or no sweep that is a number.",
        "Draw it again.",
    ),
    "curve.bad-spline": entry(
        "The spline of degree {degree} with {points} control points and {knots} knots is damaged.",
        "Draw it again, or export it as lines and arcs.",
        degree="count",
        points="count",
        knots="count",
    ),
    "curve.bad-tolerance": entry(
        "A curve cannot be fitted within {tolerance} mm.",
        "Give a tolerance greater than 0.",
        tolerance="number",
    ),
    "curve.not-finite": entry(
        "The curve has points that are not numbers.",
        "Draw it again, as lines and arcs.",
    ),
    "curve.not-fitted": entry(
        "The curve cannot be approximated within {tolerance:g} mm.",
        "Draw it again, as lines and arcs.",
        tolerance="number",
    ),
    "curve.parameters": entry(
        "The curve's parameters do not increase.",
        "Draw it again, as lines and arcs.",
    ),
    "curve.too-many-pieces": entry(
        "The curve needs more than {limit:,} pieces to stay within {tolerance:g} mm.",
        "Increase the tolerance, or simplify the curve.",
        limit="count",
        tolerance="number",
    ),
    "curve.too-many-spans": entry(
        "The curve has {spans:,} spans; the limit is {limit:,}.",
        "Simplify it before exporting.",
        spans="count",
        limit="count",
    ),
    "edge.no-length": entry(
        "Edge {edges:, } has no length, so it has no direction.",
        "Delete it from the drawing, or increase the debris tolerance.",
        edges="texts",
    ),
    "edge.not-finite": entry(
        "Edge {edge} has a coordinate that is not a number.",
        "Draw it again.",
        edge="count",
    ),
    "edge.place": entry(" at edge {edge}", edge="count"),
    "edge.too-crowded": entry(
        "More than {limit:,} pairs of line ends lie within {distance} mm of each other.",
        "Delete what is drawn many times over.",
        limit="count",
        distance="number",
    ),
    "edge.too-far": entry(
        "Edge {edge} lies {distance:.3g} mm from the drawing's origin.",
        "Check the drawing's unit, or delete what was drawn there.",
        edge="count",
        distance="number",
    ),
    "edge.too-many-overlaps": entry(
        "{edges:,} edges overlap each other in more than {limit:,} places.",
        "Delete what was drawn many times over.",
        edges="count",
        limit="count",
    ),
    "segment.not-finite": entry(
        "Segment {segment} has a coordinate or a bulge that is not a number.",
        "Draw it again.",
        segment="count",
    ),
    "input.not-finite": entry(
        "{what} has a coordinate that is not a number.",
        "Draw it again.",
        what="text",
    ),
    "layer.not-finite": entry(
        "Layer {layer} has a coordinate that is not a number.",
        "Give finite lengths.",
        layer="text",
    ),
    "offset.bad-distance": entry(
        "The distance of an offset is not a number of 0 mm or more.",
        "Correct the tool.",
    ),
    "offset.bad-interference": entry(
        "{interference!r} is not a way to handle interference.",
        "Give 'trim' or 'refuse'.",
        interference="text",
    ),
    "offset.bad-side": entry("The side of a path is neither left nor right.", "Give +1 or -1."),
    "offset.dead-end": entry(
        "The offset of path {path} at {radius:g} mm cannot be closed: {depth:.4g} mm of it beside "
        "segment {segment} lead nowhere.",
        "Draw the contour without overlaps, or change the radius a little.",
        path="count",
        radius="number",
        depth="number",
        segment="count",
    ),
    "offset.interference": entry(
        "A tool of radius {radius:g} mm beside segment {segment} would cut {depth:.4g} mm into "
        "segment {other}.",
        "Choose a smaller tool, or allow it to leave uncut what it cannot reach.",
        radius="number",
        segment="count",
        depth="number",
        other="count",
    ),
    "offset.mixed-group": entry(
        "Path {path} has another radius or side than the group that it belongs to.",
        "Reverse it, or give it a group of its own.",
        path="count",
    ),
    "offset.self-contact": entry(
        "The offset of path {path} at {radius:g} mm cannot be closed: the contour touches itself "
        "at ({x:.4f}, {y:.4f}), in segments {one} and {two}.",
        "Trim the two segments to where they meet, or move one of them off the other.",
        path="count",
        radius="number",
        x="number",
        y="number",
        one="count",
        two="count",
    ),
}
