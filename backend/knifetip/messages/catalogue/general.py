"""general: messages for all areas of knifetip, such as stored texts and the positions of faults."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "stored.text": entry("{text}", "{hint}", text="text", hint="text"),
    "error.at-edge": entry(
        "{error} This concerns {count:edge|# edges:} {edges:, }. Edge {edge} is part of the "
        'object with the handle {handle} on the layer "{layer}". {more}',
        "{error:hint}",
        error="message",
        count="count",
        edges="edges",
        more="message?",
        edge="edge",
        handle="text",
        layer="text",
    ),
    "error.at-edges": entry(
        "Edges {edges: and }: {error}",
        "{error:hint}",
        edges="edges",
        error="message",
    ),
    "error.more-edges": entry(
        "{count:# more edge is|# more edges are} not listed here.",
        count="count",
    ),
    "error.in-file": entry(
        "File {name}: {error}",
        "{error:hint}",
        name="text",
        error="message",
    ),
    "finding.at-edge": entry("Edge {edge}: {fault}", "{fault:hint}", edge="edge", fault="message"),
    "finding.at-edge-and-line": entry(
        "Edge {edge}, program line {line}: {fault}",
        "{fault:hint}",
        edge="edge",
        line="count",
        fault="message",
    ),
    "finding.at-line": entry(
        "Program line {line}: {fault}",
        "{fault:hint}",
        line="count",
        fault="message",
    ),
    "finding.more": entry(
        "{count:# more finding is|# more findings are} not listed here.",
        count="count",
    ),
}
