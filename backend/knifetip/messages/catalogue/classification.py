"""classification: messages that give the reason for the line type of an edge."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "classification.across": entry(
        "the edge meets other lines inside the blank, and one of them must be a slit if the blank "
        "folds into a box; the edge is perpendicular to the longest of these lines, so it may be a "
        "fold",
    ),
    "classification.along": entry(
        "the edge meets other lines inside the blank, and one of them must be a slit if the blank "
        "folds into a box; the edge is parallel to the longest of these lines, so it may be a fold",
    ),
    "classification.around": entry("the edge encloses a complete carton"),
    "classification.arrow": entry(
        "the edge has an arrowhead, or is connected to a line with an arrowhead",
    ),
    "classification.as-its-style": entry(
        "the edge is treated like all edges with the same layer, colour and line style",
    ),
    "classification.beside-gap": entry(
        "{reason}; this assumes that a straight line is missing in the outline beside the edge, "
        "because as drawn the blank falls apart there",
        reason="message",
    ),
    "classification.bleed": entry(
        "the edge surrounds a blank at a constant distance, as a bleed line does",
    ),
    "classification.board-ends": entry(
        "such an edge should be cut",
    ),
    "classification.closes-nothing": entry(
        "the edge is part of no closed outline",
    ),
    "classification.contradicted": entry(
        "{rule}, but {reason}",
        rule="message",
        reason="message",
    ),
    "classification.convention": entry(
        'the colours fit the colour convention "{name}": with this convention the cut lines form '
        "a closed outline, and {folds} of {lines:# line|# lines} inside the outline are folds",
        name="text",
        folds="count",
        lines="count",
    ),
    "classification.corners": entry(
        "at both ends, the edge continues round a corner into one other line, which a fold does "
        "not do",
    ),
    "classification.cuts-panel-off": entry(
        "a cut at the position of the edge would separate a panel from its blank",
    ),
    "classification.dashed": entry(
        "the edges with this layer, colour and line style are drawn dashed",
    ),
    "classification.dimension": entry(
        "the edge belongs to a dimension: a text beside the line states its length",
    ),
    "classification.divider": entry("the edge divides two panels"),
    "classification.divides-panels": entry(
        "an edge of type {type} should divide two panels",
        type="text",
    ),
    "classification.fold-end": entry(
        "the edge lies between the outline and a fold of the same two panels, as a slit that locks "
        "a flap does",
    ),
    "classification.follows": entry(
        "the answer for other edges decides this line type: they have the same colour and line "
        "style, or show whether the profile swaps cut and crease",
    ),
    "classification.frame": entry("the edge frames the whole drawing"),
    "classification.free": entry("the edge lies inside a panel and touches no other edge"),
    "classification.hole": entry("the edge closes a hole in a panel"),
    "classification.inner": entry(
        "the edge lies inside a hole or divides a hole into parts",
    ),
    "classification.labelled": entry(
        "the edge belongs to a closed shape with a text in or beside it, which may be a label or "
        "a small part",
    ),
    "classification.layer-denies": entry(
        'the name of the layer of the edge, "{layer}", suggests another line type',
        layer="text",
    ),
    "classification.layer-name": entry(
        'the name of the layer of the edge contains "{word}"',
        word="text",
    ),
    "classification.layer-name-against": entry(
        'but the name of the layer of the edge contains "{word}"',
        word="text",
    ),
    "classification.learned": entry(
        "learned from drawings of the same customer: edges with this layer, colour and line style "
        "have this line type in {drawings}",
        drawings="texts",
    ),
    "classification.learned-guess": entry(
        "edges with this layer, colour and line style have this line type in {drawings} of the "
        "same customer",
        drawings="texts",
    ),
    "classification.legend": entry(
        "the edge lies outside all blanks, beside the name of a line type, so it belongs to a "
        "legend",
    ),
    "classification.letter": entry(
        "the edge lies in a row of small shapes, as the outlines of letters do",
    ),
    "classification.like-outline": entry(
        "the edge has the layer, colour and line style of the outline",
    ),
    "classification.like-outline-not-folds": entry(
        "the edge has the layer, colour and line style of the outline, which differ from "
        "those of the folds",
    ),
    "classification.linetype-name": entry(
        'the name of the line style of the edge contains "{word}"',
        word="text",
    ),
    "classification.linetype-name-against": entry(
        'but the name of the line style of the edge contains "{word}"',
        word="text",
    ),
    "classification.mark": entry(
        "the edge belongs to a closed shape that is much smaller than the blank",
    ),
    "classification.measured": entry(
        "a text beside the edge states its length, so the edge may be a dimension line",
    ),
    "classification.mirror-cut": entry(
        "the drawing contains a mirror image of the edge, and this mirror image is a cut",
    ),
    "classification.mirror-folded": entry(
        "the drawing contains a mirror image of the edge, and this mirror image is a fold",
    ),
    "classification.mixed": entry(
        "{reason} (this is true for most of the length of the edge)",
        reason="message",
    ),
    "classification.must-be-processed": entry(
        "such an edge should not be ignored",
    ),
    "classification.named": entry(
        "the name of the layer marks the edge as not being part of the carton, and the "
        "outlines close without the edge",
    ),
    "classification.no-rule": entry(
        "no rule of the profile {profile} matches the edge",
        profile="text",
    ),
    "classification.no-rule-but-shape": entry(
        "no rule of the profile {profile} matches the edge, but {shape}",
        profile="text",
        shape="message",
    ),
    "classification.none-closes": entry(
        "almost all edges with the same layer, colour and line style divide panels",
    ),
    "classification.not-made": entry(
        "such an edge should be ignored",
    ),
    "classification.oblique": entry(
        "the edge meets other lines inside the blank, and one of them must be a slit if the blank "
        "folds into a box; the edge is neither parallel nor perpendicular to the longest of these "
        "lines, so it may be a fold",
    ),
    "classification.on-cut": entry(
        "{rule}, and the edge lies on top of a cut",
        rule="message",
    ),
    "classification.only-fold-style": entry(
        "this is the only colour and line style whose edges do nothing but divide panels",
    ),
    "classification.open": entry("the edge belongs to an outline that does not close"),
    "classification.open-flap": entry(
        "at each end of the edge begins a line whose other end meets nothing, and both lines are "
        "equally long, so they may be the sides of a flap that is not closed",
    ),
    "classification.other-style-closes": entry(
        "most of the outline of the blank consists of edges with another layer, colour or "
        "line style",
    ),
    "classification.outline": entry("the edge closes the outline of a blank"),
    "classification.override": entry(
        "the user set the line type of the edge",
    ),
    "classification.own-width": entry(
        "the line width of the edge distinguishes it from other edges with the same layer, colour "
        "and line style",
    ),
    "classification.paired": entry(
        "some edges with this layer, colour and line style form pairs of parallel lines",
    ),
    "classification.panel-hangs": entry(
        "only this edge connects a panel to the rest of the blank",
    ),
    "classification.panels-hang": entry(
        "most edges with this layer, colour and line style are each the only connection between "
        "a panel and the rest of the blank",
    ),
    "classification.part-of-outline": entry(
        'the name of the layer "{layer}" means the line type {type}, and most of the outline lies '
        "on layers whose names mean cuts",
        layer="text",
        type="text",
    ),
    "classification.part-of-side": entry(
        "the side of one of the panels continues beyond the edge, as it does beside a slit",
    ),
    "classification.ring-fold": entry(
        "the edge meets lines inside the blank that are probably slits, so it is probably a fold "
        "between them",
    ),
    "classification.ring-slit": entry(
        "the edge ends inside the blank where three folds meet, or is parallel to such an edge; if "
        "it were a fold too, four folds would meet there, which does not make a box",
    ),
    "classification.role-against": entry("{role}; {against}", role="message", against="message"),
    "classification.rule": entry("profile {profile}: {rule}", profile="text", rule="message"),
    "classification.shape": entry("{parts:, }", parts="messages"),
    "classification.shared": entry(
        "the edge lies where equal parts of the drawing touch, so it may be a common cut of blanks",
    ),
    "classification.slit": entry(
        "the edge is a slit: it begins at another edge and ends inside a panel",
    ),
    "classification.slot": entry("the edge closes a slot or a round hole in a panel"),
    "classification.slot-side": entry(
        "the edge is a side of a slot at a fold",
    ),
    "classification.speck": entry(
        "the edge is short, lies outside all blanks and touches no other edge",
    ),
    "classification.stray": entry(
        "the edge lies outside all blanks of the drawing",
    ),
    "classification.swapped": entry(
        "this rule turns edges of the closed outline into creases, so cut and crease may be "
        "swapped; the answer also decides the edges that the profile cuts",
    ),
    "classification.swapped-both": entry(
        "this rule turns edges of the closed outline into creases and edges between panels "
        "into cuts, so cut and crease may be swapped; the answer also decides the edges that the "
        "profile cuts",
    ),
    "classification.swapped-like": entry(
        "{reason}; {convention}",
        reason="message",
        convention="message",
    ),
    "classification.table": entry(
        "the edge belongs to boxes with texts, as in a title block",
    ),
    "classification.through": entry(
        "the edge continues through points inside the blank where other lines end; a slit would "
        "end there, so the edge is probably a fold",
    ),
    "classification.unknown": entry(
        "the geometry of the drawing does not show which line type the edge has",
    ),
    "classification.votes": entry("{votes:; }", votes="messages"),
    "classification.without-tabs": entry(
        "the walls of the box have no glue tabs, as in rigid boxes, which are folded at V-grooves",
    ),
    "classification.with-text": entry(
        "{reason}, and a text lies beside the edge",
        reason="message",
    ),
}
