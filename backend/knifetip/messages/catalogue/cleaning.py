"""cleaning: what cleaning did with each edge."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "cleaning.as-drawn": entry(""),
    "cleaning.dropped-speck": entry(
        "dropped: {length:.4g} mm long and connects nothing",
        length="number",
    ),
    "cleaning.end-moved": entry(
        "an end moved by {distance:.2g} mm to meet another",
        distance="number",
    ),
    "cleaning.fitted": entry("it is a part of a flattened curve that became one line or arc"),
    "cleaning.fitted-edge": entry(
        "merged: a flattened curve, one with edge {edge} within {distance:.2g} mm",
        edge="count",
        distance="number",
    ),
    "cleaning.ignored": entry("ignored: shown, and kept out of the tool path"),
    "cleaning.joined": entry("it was merged into a collinear edge"),
    "cleaning.joined-edge": entry("merged into the collinear edge {edge}", edge="count"),
    "cleaning.kept": entry("kept"),
    "cleaning.kept-changed": entry("kept: {changes:; }", changes="messages"),
    "cleaning.length-on-others": entry("{length:.4g} mm of it lie on other edges", length="number"),
    "cleaning.longer": entry("collinear edges were merged into it"),
    "cleaning.moved": entry("an end was moved to meet another edge"),
    "cleaning.no-work": entry("left as it is: no work"),
    "cleaning.on-edge": entry("merged: it lies on edge {edge}", edge="count"),
    "cleaning.part-dropped": entry("a speck of {length:.2g} mm dropped", length="number"),
    "cleaning.shortened": entry("a part of it lies on other edges"),
    "cleaning.speck": entry("it is a speck that connects nothing"),
    "cleaning.twice": entry("it lies on other edges"),
    "cleaning.unclassified": entry("not decided yet"),
}
