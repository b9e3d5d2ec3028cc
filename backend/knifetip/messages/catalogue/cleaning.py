"""cleaning: messages about the edges that cleaning changed, merged or dropped."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "cleaning.as-drawn": entry(
        "the edge is used as it was drawn",
    ),
    "cleaning.dropped-off-panel": entry(
        "the edge was dropped, because it belongs to a fold and lies outside all panels",
    ),
    "cleaning.dropped-speck": entry(
        "the edge was dropped, because it is only {length:.4g} mm long and connects no other edges",
        length="number",
    ),
    "cleaning.end-moved": entry(
        "one end of the edge was moved by {distance:.2g} mm to meet another edge",
        distance="number",
    ),
    "cleaning.fitted": entry(
        "the edge was part of a curve made of short lines; one line or arc replaces this curve",
    ),
    "cleaning.fitted-edge": entry(
        "the edge and edge {edge} were parts of a curve made of short lines; one line or arc, "
        "which deviates by at most {distance:.2g} mm from this curve, replaces them",
        edge="edge",
        distance="number",
    ),
    "cleaning.folds-on-cuts": entry(
        "{count:# edge|# edges} of the line type {type} {count:lies|lie} on cuts and "
        "{count:is|are} not made along {length:,.1f} mm: the cuts are made instead.",
        "If the board should stay connected there, set the line type of the cuts to {type}. "
        "Otherwise nothing needs to be done.",
        count="count",
        type="text",
        length="number",
    ),
    "cleaning.folds-trimmed": entry(
        "Creases or V-grooves in {count} edges were shortened: {length:.2f} mm of them lie outside "
        "all panels and are not made.",
        "If a panel should be there, close its outline. Otherwise nothing needs to be done.",
        count="count",
        length="number",
    ),
    "cleaning.ignored": entry(
        "the edge has the line type ignored, so it is displayed but not processed",
    ),
    "cleaning.joined": entry(
        "the edge and another edge on the same line were merged into one edge",
    ),
    "cleaning.joined-edge": entry(
        "the edge was merged into edge {edge}, which lies on the same line",
        edge="edge",
    ),
    "cleaning.kept": entry(
        "the edge is used as it was drawn, without a change",
    ),
    "cleaning.kept-changed": entry(
        "the edge was kept, with these changes: {changes:; }",
        changes="messages",
    ),
    "cleaning.length-on-others": entry(
        "a part of the edge, {length:.4g} mm long, lies on other edges, so it is made only once, "
        "with them",
        length="number",
    ),
    "cleaning.longer": entry(
        "other edges on the same line were merged into the edge, so it became longer",
    ),
    "cleaning.loop": entry(
        "the edge was dropped, because it belongs to a loop of at most 0.3 mm at a corner of an "
        "outline, which no tool can follow; the outline is complete without it",
    ),
    "cleaning.moved": entry("one end of the edge was moved to meet another edge"),
    "cleaning.near": entry(
        "the edge was drawn twice: it lies close beside another edge and was merged into it",
    ),
    "cleaning.near-edge": entry(
        "the edge was drawn twice: it lies {distance:.2g} mm beside edge {edge} and was merged "
        "into it",
        edge="edge",
        distance="number",
    ),
    "cleaning.no-work": entry(
        "the edge is unchanged, because no tool processes an edge of its line type",
    ),
    "cleaning.off-panel": entry(
        "a part of the fold lies outside all panels and was dropped",
    ),
    "cleaning.on-edge": entry(
        "the edge lies on edge {edge} and was merged into it",
        edge="edge",
    ),
    "cleaning.part-dropped": entry(
        "a part of the edge, {length:.2g} mm long, was dropped because it is too short to process",
        length="number",
    ),
    "cleaning.part-off-panel": entry(
        "a part of the fold, {length:.4g} mm long, was dropped because it lies outside all panels",
        length="number",
    ),
    "cleaning.shortened": entry(
        "a part of the edge lies on other edges, so it is made only once, with them"
    ),
    "cleaning.speck": entry(
        "the edge was dropped, because it is too short to process and connects no other edges"
    ),
    "cleaning.twice": entry(
        "the edge was removed, because it lies completely on other edges",
    ),
    "cleaning.unclassified": entry(
        "the edge has no line type yet, so it is displayed but not processed",
    ),
}
