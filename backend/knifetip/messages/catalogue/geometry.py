"""geometry: messages about curves, edges and offsets that are invalid or cannot be computed."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "curve.bad-ellipse": entry(
        "An ellipse has an angle range that is not valid, or one of its values is not a number.",
        "Delete the ellipse and draw it again.",
    ),
    "curve.bad-spline": entry(
        "A spline is damaged: degree {degree}, {points} control points and {knots} knots do "
        "not match.",
        "Draw the spline again, or export it as lines and arcs.",
        degree="count",
        points="count",
        knots="count",
    ),
    "curve.bad-tolerance": entry(
        "The tolerance for converting curves is {tolerance} mm, which is not valid.",
        "Give a tolerance greater than 0.",
        tolerance="number",
    ),
    "curve.not-finite": entry(
        "A coordinate of a point of a curve is not a number.",
        "Draw the curve again, as lines and arcs.",
    ),
    "curve.not-fitted": entry(
        "A curve cannot be converted to lines and arcs that deviate from it by at most "
        "{tolerance:g} mm.",
        "Draw the curve again, as lines and arcs.",
        tolerance="number",
    ),
    "curve.too-many-pieces": entry(
        "More than {limit:,} lines and arcs are needed to convert a curve with a deviation of "
        "at most {tolerance:g} mm.",
        "Allow a larger deviation, or simplify the curve.",
        limit="count",
        tolerance="number",
    ),
    "curve.too-many-spans": entry(
        "A spline has {spans:,} spans (polynomial pieces), but the limit is {limit:,}.",
        "Simplify the spline in the CAD program before exporting.",
        spans="count",
        limit="count",
    ),
    "edge.no-length": entry(
        "These edges have a length of 0, so they have no direction: edge {edges:, }.",
        "Delete these edges from the drawing.",
        edges="edges",
    ),
    "edge.not-finite": entry(
        "Edge {edge} has a coordinate that is not a number.",
        "Draw the edge again.",
        edge="edge",
    ),
    "edge.place": entry(
        "The move belongs to edge {edge}.",
        edge="edge",
    ),
    "edge.too-crowded": entry(
        "More than {limit:,} pairs of end points of edges lie closer together than {distance} mm.",
        "Delete edges that are drawn many times on top of each other.",
        limit="count",
        distance="number",
    ),
    "edge.too-far": entry(
        "Edge {edge} lies {distance:.3g} mm away from the origin of the drawing, which is too "
        "far to be processed.",
        "Check the unit of the drawing, or delete the edge.",
        edge="edge",
        distance="number",
    ),
    "edge.too-many-overlaps": entry(
        "{edges:,} edges overlap each other at more than {limit:,} positions.",
        "Delete edges that are drawn many times on top of each other.",
        edges="count",
        limit="count",
    ),
    "segment.not-finite": entry(
        "Segment {segment} of the path has a coordinate, or a bulge (curvature of an arc), "
        "that is not a number.",
        "Draw this segment of the path again.",
        segment="count",
    ),
    "input.not-finite": entry(
        "{what} has a coordinate that is not a number.",
        "Draw the object again.",
        what="text",
    ),
    "layer.not-finite": entry(
        "A coordinate on the layer {layer} is not a number.",
        "Draw the edges of this layer again.",
        layer="text",
    ),
    "offset.bad-distance": entry(
        "The offset distance of a path (the radius of the tool) is negative or not a number.",
        "Correct the radius of the tool.",
    ),
    "offset.bad-interference": entry(
        "{interference!r} is not a valid method for the parts of a contour that the tool "
        "cannot reach.",
        "Choose 'trim' (leave these parts uncut) or 'refuse' (write no program).",
        interference="text",
    ),
    "offset.bad-side": entry(
        "The side of a path must be +1 (left) or -1 (right).",
        "Give +1 or -1 as the side.",
    ),
    "offset.cusp": entry(
        "The offset curve at a distance of {radius:g} mm from path {path} is not closed, "
        "because segments {one} and {two} of the contour cross {size:.4g} mm before the corner at "
        "({x:.4f}, {y:.4f}) mm where they meet.",
        "Trim the two segments at their crossing, so that the corner is there.",
        path="count",
        radius="number",
        size="number",
        x="number",
        y="number",
        one="count",
        two="count",
    ),
    "offset.dead-end": entry(
        "The offset curve at a distance of {radius:g} mm from path {path} is not closed. A "
        "piece of the curve beside segment {segment} of the path is {depth:.4g} mm long and "
        "does not connect to the rest of the curve.",
        "Draw the contour so that it does not overlap itself, or change the radius of the "
        "tool slightly.",
        path="count",
        radius="number",
        depth="number",
        segment="count",
    ),
    "offset.interference": entry(
        "A tool of {radius:g} mm radius that follows segment {segment} would cut {depth:.4g} "
        "mm into segment {other}.",
        "Choose a tool with a smaller radius, or accept uncut areas where the tool does not fit.",
        radius="number",
        segment="count",
        depth="number",
        other="count",
    ),
    "offset.mixed-group": entry(
        "Path {path} has a different tool radius, or another side of the tool, than the other "
        "paths that are offset together with it.",
        "Reverse the path, or offset it separately.",
        path="count",
    ),
    "offset.self-contact": entry(
        "The offset curve at a distance of {radius:g} mm from path {path} is not closed, "
        "because the contour touches itself at ({x:.4f}, {y:.4f}) mm in segments {one} and "
        "{two}.",
        "Trim the two segments at their intersection, or move one of the segments.",
        path="count",
        radius="number",
        x="number",
        y="number",
        one="count",
        two="count",
    ),
}
