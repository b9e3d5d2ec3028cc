"""classification: messages that give the reason for the line type of an edge."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "classification.around": entry("the edge encloses a complete carton"),
    "classification.arrow": entry(
        "the edge has an arrowhead, or is connected to a line with an arrowhead",
    ),
    "classification.as-its-style": entry("like all edges of this style"),
    "classification.bleed": entry(
        "the edge surrounds a blank at a constant distance, as a bleed line does",
    ),
    "classification.board-ends": entry(", where the board ends unless the outline is open"),
    "classification.closes-nothing": entry(" and does not close an outline"),
    "classification.contradicted": entry("{rule}; but {reason}", rule="message", reason="message"),
    "classification.convention": entry(
        'the colours fit the convention "{name}": the outline closes, and {folds} of {lines:# '
        "dividing line is a fold|# dividing lines are folds}",
        name="text",
        folds="count",
        lines="count",
    ),
    "classification.cuts-panel-off": entry("a cut there would separate a panel from its blank"),
    "classification.dashed": entry("they are dashed"),
    "classification.divider": entry("the edge divides two panels"),
    "classification.divides-panels": entry(", but edges of type {type} divide panels", type="text"),
    "classification.frame": entry("the edge frames the whole drawing"),
    "classification.free": entry("the edge lies inside a panel and touches no other edge"),
    "classification.hole": entry("the edge closes a hole in a panel"),
    "classification.inner": entry("the edge lies inside a hole or divides one"),
    "classification.layer-denies": entry(
        'but the name of its layer, "{layer}", suggests another line type',
        layer="text",
    ),
    "classification.layer-name": entry('the name of its layer contains "{word}"', word="text"),
    "classification.legend": entry(
        "the edge lies outside all blanks, beside the name of a line type, so it belongs to a "
        "legend",
    ),
    "classification.letter": entry("the edge lies in a row of small shapes, as letters do"),
    "classification.like-outline": entry("it has the style of the outline"),
    "classification.like-outline-not-folds": entry(
        "it has the style of the outline, and the folds have another style",
    ),
    "classification.linetype-name": entry(
        'the name of its linetype contains "{word}"',
        word="text",
    ),
    "classification.mark": entry("the edge closes a shape that is much smaller than the blank"),
    "classification.mirror-cut": entry("its mirror image in the drawing is cut"),
    "classification.mirror-folded": entry("its mirror image in the drawing is folded"),
    "classification.mixed": entry("{reason} (true for most of its length)", reason="message"),
    "classification.named": entry(
        "the name of its layer shows that the edge is not part of the carton, and the outlines "
        "close without it",
    ),
    "classification.no-rule": entry("no rule of the profile {profile} matches", profile="text"),
    "classification.no-rule-but-shape": entry(
        "no rule of the profile {profile} matches, but {shape}",
        profile="text",
        shape="message",
    ),
    "classification.none-closes": entry(
        ", as all edges of this style do, and none of them closes an outline",
    ),
    "classification.not-made": entry(", so no tool must process it"),
    "classification.on-cut": entry("{rule}; the edge lies on a cut", rule="message"),
    "classification.open": entry("the edge belongs to an outline that does not close"),
    "classification.other-style-closes": entry("edges of another style close most of this outline"),
    "classification.outline": entry("the edge closes the outline of a blank"),
    "classification.override": entry("set by the user"),
    "classification.paired": entry("some of them are parallel pairs"),
    "classification.panel-hangs": entry("a panel is connected only by it"),
    "classification.panels-hang": entry("most of them connect a panel to the rest of the blank"),
    "classification.role-against": entry("{role}{against}", role="message", against="message?"),
    "classification.rule": entry("profile {profile}: {rule}", profile="text", rule="message"),
    "classification.shape": entry("{parts:, }", parts="messages"),
    "classification.slit": entry("the edge begins at another edge and ends inside a panel"),
    "classification.slot": entry("the edge closes a slot or a round hole in a panel"),
    "classification.speck": entry(
        "the edge is short, lies outside all blanks and touches no other edge",
    ),
    "classification.stray": entry("the edge lies outside all blanks"),
    "classification.swapped": entry("the edges that this rule makes creases close the outline"),
    "classification.swapped-both": entry(
        "the edges that this rule makes creases close the outline, and the edges that it makes "
        "cuts divide the panels",
    ),
    "classification.swapped-like": entry(
        "{reason}; {convention}",
        reason="message",
        convention="message",
    ),
    "classification.table": entry(
        "the edge lies beside a text, as in a title block, a dimension or a label",
    ),
    "classification.unknown": entry("the shape of the drawing does not show what the edge is"),
    "classification.votes": entry("{votes:; }", votes="messages"),
    "classification.with-text": entry("{reason}; a text lies beside it", reason="message"),
}
