"""drawing: drawings on the server, questions about them, and overrides of line types."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "drawing.changing": entry(
        "Drawing {drawing} is being changed by others at the same time.",
        "Try again in a moment.",
        drawing="text",
    ),
    "drawing.deleted": entry(
        "Deleted.",
    ),
    "drawing.in-use": entry(
        "Job {job} was made from drawing {drawing}, which is kept as its record.",
        "Only drawings without jobs can be deleted.",
        job="text",
        drawing="text",
    ),
    "drawing.larger-than-table": entry(
        "The drawing is {width:.1f} × {height:.1f} mm, and {machine} has room for {room_x:.0f} × "
        "{room_y:.0f} mm.",
        "Check the unit of the drawing, turn it, or choose a larger machine.",
        width="number",
        height="number",
        machine="text",
        room_x="number",
        room_y="number",
    ),
    "drawing.open-questions": entry(
        "{count:# question|# questions} must be answered first: {questions: }",
        "Answer them on the drawing; nothing is cut by default.",
        count="count",
        questions="messages",
    ),
    "drawing.read": entry(
        "Read from {name}.",
        name="text",
    ),
    "drawing.reinterpreted": entry(
        "Unit: {unit:unit}, profile: {profile}.",
        unit="text",
        profile="text",
    ),
    "drawing.stale": entry(
        "Drawing {drawing} is at revision {revision}, and the request names {named}.",
        "Look at the drawing again; if the change is still wanted, repeat the request.",
        drawing="text",
        revision="count",
        named="text",
    ),
    "drawing.types-set": entry(
        "{count:# line type was|# line types were} set.",
        count="count",
    ),
    "drawing.unit-for-cleaning": entry(
        "The drawing does not state its unit, so the size of specks and gaps is not known.",
        "Set it with PATCH /api/drawings/ID, or on the page.",
    ),
    "drawing.unit-unknown": entry(
        "The drawing does not state its unit ({evidence}).",
        "Set it with PATCH /api/drawings/ID, or on the page.",
        evidence="message",
    ),
    "drawing.unknown": entry(
        "There is no drawing {drawing}.",
        "GET /api/drawings lists them.",
        drawing="text",
    ),
    "drawing.upload-too-large": entry(
        "{name} is larger than {limit} MB.",
        "Send a smaller drawing.",
        name="text",
        limit="count",
    ),
    "question.guess": entry(
        " Most likely {type} ({percent} %): {reason}.",
        type="text",
        percent="count",
        reason="message",
    ),
    "question.line-type": entry(
        '{edges:# edge|# edges} on layer "{layer}", colour {colour}, linetype {linetype}, total '
        "length {length:,.1f} {unit:unit}, in a box of {width:,.1f} × {height:,.1f} {unit:unit} "
        "at ({x:,.1f}, {y:,.1f}): what {edges:is it|are they}?{guess}",
        edges="count",
        layer="text",
        colour="text",
        linetype="text",
        length="number",
        width="number",
        height="number",
        x="number",
        y="number",
        unit="text",
        guess="message?",
    ),
    "question.shape": entry(" By its {reason}.", reason="message"),
    "question.tool": entry(
        "{machine} has no tool for {type} ({edges:# edge|# edges}). Which line type should they "
        "get?",
        edges="count",
        type="text",
        machine="text",
    ),
    "question.unit": entry(
        "{reason} The drawing's size would be {sizes:, }.{evidence}",
        reason="message",
        sizes="messages",
        evidence="message?",
    ),
    "question.unit-contradicted": entry(
        "The file states {stated:unit} as its unit, but the drawing does not look like it.",
        stated="text",
    ),
    "question.unit-doubtful": entry(
        "The file states {stated:unit} as its unit, but the drawing could also be in {other:unit}.",
        stated="text",
        other="text",
    ),
    "question.unit-evidence": entry(
        " Strongest evidence for {unit:unit}: {evidence:; }.",
        unit="text",
        evidence="messages",
    ),
    "question.unit-not-stated": entry("The file does not state its unit."),
    "question.unit-size": entry(
        "{width:mm} × {height:mm} mm in {unit:unit}",
        unit="text",
        width="number",
        height="number",
    ),
    "question.unit-unreadable": entry(
        "The file does not state a unit of length that is supported ({evidence}).",
        evidence="message",
    ),
    "override.ambiguous": entry(
        "An override must name its edges in exactly one way.",
        "Give edges, or handles, or layer and colour.",
    ),
    "override.no-edges-there": entry(
        "There is no edge {place: and }.",
        "GET …/edges lists layers and colours.",
        place="messages",
    ),
    "override.no-such-edge": entry(
        "The drawing has {count:# edge|# edges}; there is no edge {edge}.",
        "Edges are numbered from 0.",
        count="count",
        edge="text",
    ),
    "override.no-such-handle": entry(
        "No edge has the handle {handle!r}.",
        "GET …/edges lists the handles.",
        handle="text",
    ),
    "override.of-colour": entry("of colour {colour}", colour="text"),
    "override.on-layer": entry("on layer {layer!r}", layer="text"),
}
