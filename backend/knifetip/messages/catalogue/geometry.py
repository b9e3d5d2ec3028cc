"""geometry: messages about curves, edges and offsets that are invalid or cannot be computed."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "curve.bad-ellipse": entry(
        "An ellipse has no size, or its start or end angle is not a number.",
        "Draw the ellipse again.",
    ),
    "curve.bad-spline": entry(
        "A spline of degree {degree} with {points} control points and {knots} knots is damaged.",
        "Draw the spline again, or export it as lines and arcs.",
        degree="count",
        points="count",
        knots="count",
    ),
    "curve.bad-tolerance": entry(
        "Curves cannot be converted with a tolerance of {tolerance} mm.",
        "Give a tolerance greater than 0.",
        tolerance="number",
    ),
    "curve.not-finite": entry(
        "A point of a curve is not a number.",
        "Draw the curve again, as lines and arcs.",
    ),
    "curve.not-fitted": entry(
        "A curve cannot be converted to lines and arcs within {tolerance:g} mm.",
        "Draw the curve again, as lines and arcs.",
        tolerance="number",
    ),
    "curve.parameters": entry(
        "The parameters of a curve do not increase.",
        "Draw the curve again, as lines and arcs.",
    ),
    "curve.too-many-pieces": entry(
        "A curve needs more than {limit:,} lines and arcs to stay within {tolerance:g} mm.",
        "Increase the tolerance, or simplify the curve.",
        limit="count",
        tolerance="number",
    ),
    "curve.too-many-spans": entry(
        "A spline has {spans:,} spans; the limit is {limit:,}.",
        "Simplify the curve before exporting.",
        spans="count",
        limit="count",
    ),
    "edge.no-length": entry(
        "Edge {edges:, } has no length, so its direction is not defined.",
        "Delete the edge from the drawing.",
        edges="texts",
    ),
    "edge.not-finite": entry(
        "Edge {edge} has a coordinate that is not a number.",
        "Draw the edge again.",
        edge="count",
    ),
    "edge.place": entry(" at edge {edge}", edge="count"),
    "edge.too-crowded": entry(
        "More than {limit:,} pairs of line ends lie closer together than {distance} mm.",
        "Delete edges that are drawn many times on top of each other.",
        limit="count",
        distance="number",
    ),
    "edge.too-far": entry(
        "Edge {edge} lies {distance:.3g} mm from the origin of the drawing.",
        "Check the unit of the drawing, or delete the edge.",
        edge="count",
        distance="number",
    ),
    "edge.too-many-overlaps": entry(
        "{edges:,} edges overlap each other in more than {limit:,} places.",
        "Delete edges that are drawn many times on top of each other.",
        edges="count",
        limit="count",
    ),
    "segment.not-finite": entry(
        "Segment {segment} of the path has a coordinate or a bulge that is not a number.",
        "Draw the segment again.",
        segment="count",
    ),
    "input.not-finite": entry(
        "{what} has a coordinate that is not a number.",
        "Draw it again.",
        what="text",
    ),
    "layer.not-finite": entry(
        "A coordinate on the layer {layer} is not a number.",
        "Draw the edges of this layer again.",
        layer="text",
    ),
    "offset.bad-distance": entry(
        "The offset distance is not a number of 0 mm or more.",
        "Correct the radius of the tool.",
    ),
    "offset.bad-interference": entry(
        "{interference!r} is not a method for places where the tool does not fit.",
        "Choose 'trim' or 'refuse'.",
        interference="text",
    ),
    "offset.bad-side": entry(
        "The side of a path must be +1 (left) or -1 (right).",
        "Give +1 or -1.",
    ),
    "offset.dead-end": entry(
        "The offset of path {path} by {radius:g} mm does not close: {depth:.4g} mm of it beside "
        "segment {segment} have no continuation.",
        "Draw the contour without overlaps, or change the radius a little.",
        path="count",
        radius="number",
        depth="number",
        segment="count",
    ),
    "offset.interference": entry(
        "A tool of radius {radius:g} mm beside segment {segment} would cut {depth:.4g} mm into "
        "segment {other}.",
        "Choose a smaller tool, or accept uncut remains where the tool does not fit.",
        radius="number",
        segment="count",
        depth="number",
        other="count",
    ),
    "offset.mixed-group": entry(
        "Path {path} has another radius or side than the other paths of its group.",
        "Reverse the path, or put it into a group of its own.",
        path="count",
    ),
    "offset.self-contact": entry(
        "The offset of path {path} by {radius:g} mm does not close: the contour touches itself at "
        "({x:.4f}, {y:.4f}), in segments {one} and {two}.",
        "Trim the two segments where they meet, or move one of them away.",
        path="count",
        radius="number",
        x="number",
        y="number",
        one="count",
        two="count",
    ),
}
