"""drawing: messages about drawings on the server, questions to the user, and changed line types."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "drawing.all-ignored": entry(
        "There is nothing to make: {count:the only edge|all # edges} of the drawing "
        "{count:is|are} ignored.",
        "Give the edges that shall be made the line type cut, crease or another one.",
        count="count",
    ),
    "drawing.answer-taken-back": entry(
        "An answer that was learned from earlier drawings of {customer} is no longer used.",
        customer="text",
    ),
    "drawing.answer-used": entry(
        "An answer that was learned from earlier drawings of {customer} is used again.",
        customer="text",
    ),
    "drawing.changing": entry(
        "Another request is changing drawing {drawing} at the same time.",
        "Try again in a moment.",
        drawing="text",
    ),
    "drawing.deleted": entry(
        "The drawing was deleted.",
    ),
    "drawing.details-changed": entry(
        "The details of the order were changed.",
    ),
    "drawing.edited": entry(
        "The drawing has {count:# edit of its lines|# edits of its lines}.",
        count="count",
    ),
    "drawing.empty": entry(
        "There is nothing to make: the file contains no objects.",
        "Export the drawing again, with the lines of the carton in model space.",
    ),
    "drawing.in-use": entry(
        "Drawing {drawing} cannot be deleted, because job {job} was made from it.",
        "Keep the drawing. Only drawings from which no job was made can be deleted.",
        job="text",
        drawing="text",
    ),
    "drawing.fits-turned": entry(
        "The drawing measures {width:.1f} × {height:.1f} mm, but the table of {machine} "
        "measures only {room_x:.0f} × {room_y:.0f} mm. Turned by 90°, the drawing fits.",
        "Turn the drawing by 90° and import it again.",
        width="number",
        height="number",
        machine="text",
        room_x="number",
        room_y="number",
    ),
    "drawing.larger-than-table": entry(
        "The drawing measures {width:.1f} × {height:.1f} mm, but the table of {machine} "
        "measures only {room_x:.0f} × {room_y:.0f} mm.",
        "Check the unit of the drawing, choose a larger machine, or divide the drawing.",
        width="number",
        height="number",
        machine="text",
        room_x="number",
        room_y="number",
    ),
    "drawing.no-customer": entry(
        "Drawing {drawing} has no customer, so answers from earlier drawings of a customer cannot "
        "be used for it.",
        "Set the customer of the drawing first.",
        drawing="text",
    ),
    "drawing.no-lines": entry(
        "There is nothing to make: the file contains no lines that a tool can follow. "
        "{count:The only object was|All # objects were} left out: {reasons:; }.",
        "Draw the carton with lines, arcs or curves in model space, parallel to the XY plane, and "
        "import it again.",
        count="count",
        reasons="messages",
    ),
    "drawing.no-lines-reason": entry(
        "{reason} ({count:# object|# objects})",
        count="count",
        reason="message",
    ),
    "drawing.of-another": entry(
        "The drawing {drawing} was uploaded by another user and is not shared.",
        "Ask its owner or an operator to share it with all designers, or upload the file again.",
        drawing="text",
    ),
    "drawing.open-questions": entry(
        "{count:# question|# questions} about the drawing must be answered first: {questions: }",
        "Answer the questions on the page of the drawing. Edges without an answer are not cut.",
        count="count",
        questions="messages",
    ),
    "drawing.read": entry(
        "The drawing was imported from the file {name}.",
        name="text",
    ),
    "drawing.reinterpreted": entry(
        "The drawing was imported again with the unit {unit:unit} and the profile {profile}.",
        unit="text",
        profile="text",
    ),
    "drawing.stale": entry(
        "Drawing {drawing} was changed after you loaded it. The request is for revision "
        "{named}, but the drawing is at revision {revision}.",
        "Load the drawing again, check it, and repeat the request.",
        drawing="text",
        revision="count",
        named="text",
    ),
    "drawing.types-set": entry(
        "{count:# edge was|# edges were} given a line type.",
        count="count",
    ),
    "drawing.unit-for-cleaning": entry(
        "The drawing has no unit, so the lengths of its short edges and gaps cannot be "
        "compared with the limits of cleaning, which are in mm.",
        "Set the unit of the drawing on the page, or with PATCH /api/drawings/ID.",
    ),
    "drawing.unit-unknown": entry(
        "The unit of the drawing is not known ({evidence}).",
        "Set the unit of the drawing on the page, with --unit, or with PATCH /api/drawings/ID.",
        evidence="message",
    ),
    "drawing.unknown": entry(
        "Drawing {drawing} does not exist. It may have been deleted.",
        "Go back to the list of drawings and open another drawing.",
        drawing="text",
    ),
    "drawing.upload-too-large": entry(
        "The file {name} is larger than {limit} MB.",
        "Send a smaller file, for example without pictures.",
        name="text",
        limit="count",
    ),
    "edit.end-elsewhere": entry(
        "Edit {number} moves an end of edge {edge}, but this end is now at {x:mm}, {y:mm} mm.",
        "Load the drawing again, and repeat the edit.",
        number="count",
        edge="count",
        x="number",
        y="number",
    ),
    "edit.no-length": entry(
        "After edit {number} an edge would have no length.",
        "Choose two different points.",
        number="count",
    ),
    "edit.no-such-edge": entry(
        "Edit {number} moves an end of edge {edge}, but the drawing has only "
        "{count:# edge|# edges}.",
        "Choose an edge number that exists. The first edge has number 0.",
        number="count",
        edge="count",
        count="count",
    ),
    "edit.no-unit": entry(
        "The drawing cannot be edited, because its unit is not known.",
        "Choose the unit of the drawing first.",
    ),
    "edit.unit-changed": entry(
        "The unit of a drawing with edits cannot be changed, because the edits are in mm.",
        "Undo the edits, change the unit, and make the edits again.",
    ),
    "question.default-width": entry("lines of the default width"),
    "question.follows": entry(
        'The answer also decides {edges:# edge|# edges} on layer "{layer}" (colour {colour}, line '
        "style {linetype}): {type} if {questions:the answer is|all # answers about this rule are} "
        "{answer}, and {other_type} if {questions:it is|they are} {other_answer}.",
        edges="count",
        layer="text",
        colour="text",
        linetype="text",
        questions="count",
        answer="text",
        type="text",
        other_answer="text",
        other_type="text",
    ),
    "question.guess": entry(
        "The most likely line type is {type} ({percent} %): {reason}.",
        type="text",
        percent="count",
        reason="message",
    ),
    "question.line-type": entry(
        '{edges:# edge|# edges} on layer "{layer}" (colour {colour}, line style {linetype}) '
        "{edges:has|have} no line type: total length {length:,.1f} {unit:unit}, extent "
        "{width:,.1f} × {height:,.1f} {unit:unit}, lower left corner at X {x:,.1f}, Y {y:,.1f}. "
        "Which line type should {edges:this edge|these edges} get? {guess}",
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
    "question.line-type-by-width": entry(
        '{edges:# edge|# edges} on layer "{layer}" (colour {colour}, line style {linetype}, '
        "{lines}) {edges:has|have} no line type: total length {length:,.1f} {unit:unit}, extent "
        "{width:,.1f} × {height:,.1f} {unit:unit}, lower left corner at X {x:,.1f}, Y {y:,.1f}. "
        "Which line type should {edges:this edge|these edges} get? {guess}",
        edges="count",
        layer="text",
        colour="text",
        linetype="text",
        lines="message",
        length="number",
        width="number",
        height="number",
        x="number",
        y="number",
        unit="text",
        guess="message?",
    ),
    "question.line-width": entry("lines {width:g} mm wide", width="number"),
    "question.line-width-without-unit": entry("lines {width:g} wide", width="number"),
    "question.shape": entry(
        "The drawing shows: {reason}.",
        reason="message",
    ),
    "question.thinnest-lines": entry("thinnest lines"),
    "question.tool": entry(
        "{machine} has no tool for {edges:# edge|# edges} of the line type {type}. Which other "
        "line type should {edges:this edge|these edges} get?",
        edges="count",
        type="text",
        machine="text",
    ),
    "question.tool-for-folds": entry(
        "{machine} has no tool for {edges:# edge|# edges} of the line type {type}. Its knife can "
        "make {edges:it|them} as {edges:a perforation|perforations}, with the cuts and gaps of the "
        "board, or as {edges:a half-cut|half-cuts}. Which other line type should "
        "{edges:this edge|these edges} get?",
        edges="count",
        type="text",
        machine="text",
    ),
    "question.unit": entry(
        "{reason} In which unit is the drawing? Its possible sizes are: {sizes:, }. {evidence}",
        reason="message",
        sizes="messages",
        evidence="message?",
    ),
    "question.unit-contradicted": entry(
        "The file states the unit {stated:unit}, but the size of the drawing does not match "
        "this unit.",
        stated="text",
    ),
    "question.unit-doubtful": entry(
        "The file states the unit {stated:unit}, but the drawing could also be in {other:unit}.",
        stated="text",
        other="text",
    ),
    "question.unit-evidence": entry(
        "The strongest evidence for {unit:unit} is: {evidence:; }.",
        unit="text",
        evidence="messages",
    ),
    "question.unit-not-stated": entry("The file does not state the unit of the drawing."),
    "question.unit-size": entry(
        "{width:mm} × {height:mm} mm if the unit is {unit:unit}",
        unit="text",
        width="number",
        height="number",
    ),
    "question.unit-unreadable": entry(
        "The unit of the drawing is not known: {evidence}.",
        "Choose the unit of the drawing.",
        evidence="message",
    ),
    "override.ambiguous": entry(
        "The request changes the line type of edges, but does not select these edges in "
        "exactly one way.",
        "Give edges (edge numbers), or handles, or a layer and/or a colour.",
    ),
    "override.no-edges-there": entry(
        "The drawing has no edge {place: and }.",
        "Choose a layer and colour that GET /api/drawings/ID/edges lists.",
        place="messages",
    ),
    "override.no-such-edge": entry(
        "Edge {edge} does not exist. The drawing has {count:# edge|# edges}.",
        "Choose an edge number that exists. The first edge has number 0.",
        count="count",
        edge="text",
    ),
    "override.no-such-handle": entry(
        "No edge of the drawing has the handle {handle!r}.",
        "Choose a handle that GET /api/drawings/ID/edges lists.",
        handle="text",
    ),
    "override.of-colour": entry(
        "with colour {colour}",
        colour="text",
    ),
    "override.on-layer": entry("on layer {layer!r}", layer="text"),
}
