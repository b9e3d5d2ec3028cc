"""cleaning: messages about the edges that cleaning changed, merged or dropped."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "cleaning.as-drawn": entry(
        "the edge is unchanged",
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
        "the edge was part of a curve made of short lines, which was replaced by one line or arc",
    ),
    "cleaning.fitted-edge": entry(
        "the edge was part of a curve made of short lines, which was replaced, together with "
        "edge {edge}, by one line or arc (deviation up to {distance:.2g} mm)",
        edge="count",
        distance="number",
    ),
    "cleaning.ignored": entry(
        "the edge has the line type ignored, so it is displayed but not processed",
    ),
    "cleaning.joined": entry("the edge was merged into another edge on the same line"),
    "cleaning.joined-edge": entry(
        "the edge was merged into edge {edge}, which lies on the same line",
        edge="count",
    ),
    "cleaning.kept": entry(
        "kept",
    ),
    "cleaning.kept-changed": entry(
        "kept: {changes:; }",
        changes="messages",
    ),
    "cleaning.length-on-others": entry(
        "{length:.4g} mm of the length of the edge lie on other edges and were merged with them",
        length="number",
    ),
    "cleaning.longer": entry("other edges on the same line were merged into this edge"),
    "cleaning.moved": entry("one end of the edge was moved to meet another edge"),
    "cleaning.no-work": entry(
        "the edge is unchanged, because no tool processes it",
    ),
    "cleaning.on-edge": entry(
        "the edge was merged into edge {edge}, on which it lies",
        edge="count",
    ),
    "cleaning.part-dropped": entry(
        "a part of the edge, {length:.2g} mm long, was dropped because it is too short to process",
        length="number",
    ),
    "cleaning.shortened": entry("a part of the edge lies on other edges and was merged with them"),
    "cleaning.speck": entry("the edge is too short to process and connects no other edges"),
    "cleaning.twice": entry(
        "the edge was removed, because it lies completely on other edges",
    ),
    "cleaning.unclassified": entry("the edge has no line type yet"),
}
