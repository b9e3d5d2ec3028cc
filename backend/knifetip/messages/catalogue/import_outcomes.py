"""import_outcomes: messages about the import of the entities of a file, and why one is dropped."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "import.angles-not-numbers": entry("the angles of the arc are not numbers"),
    "import.annotations": entry(
        "{count:# note or form field|# notes and form fields} on the page {count:is|are} not cut",
        count="count",
    ),
    "import.area-outline": entry(
        "the object is the outline of a filled area, which is used because the drawing has no "
        "lines",
    ),
    "import.area-outline-on-page": entry(
        "the object is the outline of a filled area, which is used because the page has no lines",
    ),
    "import.array": entry(
        "the object is a grid of copies ({columns} columns × {rows} rows)",
        columns="count",
        rows="count",
    ),
    "import.bad-operands": entry(
        "the PDF operator {operator!r} has invalid operands",
        operator="text",
    ),
    "import.bad-path-data": entry(
        "the path data of the object is invalid at character {character} ({text!r}), so only "
        "the path before this character was imported, as in a browser",
        character="count",
        text="text",
    ),
    "import.bad-place": entry(
        "the position of the object cannot be read: {reason}",
        reason="message",
    ),
    "import.bad-points": entry(
        "the points of the object cannot be read: {points!r}",
        points="text",
    ),
    "import.bad-radius": entry(
        "the radius is {radius:g}, but must be greater than 0",
        radius="number",
    ),
    "import.bad-size": entry(
        "the attribute {name} of the object cannot be read: {reason}",
        name="text",
        reason="message",
    ),
    "import.bad-transform": entry(
        "the attribute transform of the object cannot be read: {reason}",
        reason="message",
    ),
    "import.bad-value": entry("{value!r} is not a length", value="text"),
    "import.bad-window": entry(
        "the position or size of the nested drawing cannot be read: {reason}",
        reason="message",
    ),
    "import.block-external": entry(
        "the block {block!r} is in another file",
        "Bind the external reference in the CAD program and export again.",
        block="text",
    ),
    "import.block-in-itself": entry("the block {block!r} contains itself", block="text"),
    "import.block-missing": entry(
        "the block {block!r} is not in the file",
        "Insert the block in the CAD program and export again.",
        block="text",
    ),
    "import.bridge": entry(
        "the steel rule of the die has 1 bridge, {width:g} wide (in units of the file)",
        width="number",
    ),
    "import.bridges": entry(
        "the steel rule of the die has {bridges:g} bridges, each {width:g} wide (in units of "
        "the file)",
        bridges="number",
        width="number",
    ),
    "import.clip-path": entry(
        "the object is only a clipping path",
    ),
    "import.contains-itself": entry("the object contains itself"),
    "import.coordinate-not-a-number": entry("a coordinate of the object is not a number"),
    "import.curves-fitted": entry(
        "the curves of the object were converted to {pieces:# line or arc|# lines and arcs}, "
        "which deviate by at most {tolerance:.2g} file units",
        pieces="count",
        tolerance="number",
    ),
    "import.curves-fitted-relative": entry(
        "the curves of the object were converted to {pieces:# line or arc|# lines and arcs}, "
        "which deviate by at most {tolerance:.2g} file units (1/250,000 of the size of the "
        "drawing)",
        pieces="count",
        tolerance="number",
    ),
    "import.damaged": entry("the object is damaged: {reason}", reason="text"),
    "import.damaged-or-frame": entry(
        "the object is damaged, or is only the frame around a text",
    ),
    "import.dimension": entry("dimensions and notes are not cut"),
    "import.drawn-twice": entry(
        "the object is drawn twice, because it lies exactly on {same:, }",
        same="texts",
    ),
    "import.drawn-twice-often": entry(
        "the object is drawn several times, because it lies exactly on {same:, } and {more} "
        "more {more:object|objects}",
        same="texts",
        more="count",
    ),
    "import.empty-path": entry("the path of the object is empty"),
    "import.end-mark": entry(
        "the object (SEQEND) only marks the end of a list of vertices or attributes",
    ),
    "import.endless-line": entry("the object is a construction line of infinite length"),
    "import.extrusion-not-a-number": entry("the extrusion direction of the object is not a number"),
    "import.few-vertices": entry(
        "the polyline has {vertices:# vertex|# vertices}, but needs at least 2",
        vertices="count",
    ),
    "import.filled-area": entry("the object is a filled area without a line"),
    "import.filled-area-beside-strokes": entry(
        "the object is a filled area without a line, and the drawing has lines",
    ),
    "import.filled-area-on-page": entry(
        "the object is a filled area without a line, and the page has lines",
    ),
    "import.fit-points": entry(
        "the curve was computed from its fit points",
    ),
    "import.font-shape": entry(
        "the object is a shape from a font file, which cannot be read",
        "Explode the shape into lines in the CAD program and export again.",
    ),
    "import.height-not-a-number": entry("the height (z) of the object is not a number"),
    "import.height-too-far": entry(
        "the height (z) of the object is {height:g}; the limit is {limit:g}",
        height="number",
        limit="number",
    ),
    "import.hidden": entry("the object is hidden"),
    "import.hidden-layer": entry(
        "the object is hidden, because the layer {layer} is switched off",
        "Switch the layer on and export again if the object must be cut.",
        layer="text",
    ),
    "import.image": entry("images are not cut"),
    "import.incomplete": entry(
        "the object is incomplete, because its {part} is missing",
        part="text",
    ),
    "import.interrupted-path": entry(
        "the path is neither stroked nor filled, because another object begins before the path "
        "is finished",
    ),
    "import.invisible": entry("the object is marked as invisible"),
    "import.kept": entry(
        "kept",
    ),
    "import.kept-changed": entry(
        "kept: {notes:; }",
        notes="messages",
    ),
    "import.laid-flat": entry(
        "the object was moved from the height z = {height:g} to z = 0",
        height="number",
    ),
    "import.layer-frozen": entry(
        "the layer of the object is frozen",
        "Thaw the layer and export again if the object must be cut.",
    ),
    "import.layer-not-plotted": entry(
        "the layer of the object is not plotted",
        "Set the layer to be plotted and export again if the object must be cut.",
    ),
    "import.layer-off": entry(
        "the layer of the object is switched off",
        "Switch the layer on and export again if the object must be cut.",
    ),
    "import.light": entry("lights are not cut"),
    "import.line-not-numbers": entry(
        "the values of line {line} are not all numbers: {values:, }",
        line="count",
        values="texts",
    ),
    "import.lone-vertex": entry("the vertex does not belong to a polyline"),
    "import.mesh": entry(
        "the object is a three-dimensional mesh, not a line in a plane",
    ),
    "import.missing-id": entry(
        "the object refers to an object with the id {id!r}, which does not exist",
        id="text",
    ),
    "import.missing-subroutine": entry("the subroutine {name} does not exist", name="text"),
    "import.multiple-line": entry(
        "multilines cannot be read",
        "Explode the multiline into lines in the CAD program and export again.",
    ),
    "import.no-length": entry("the object has no length ({length:g})", length="number"),
    "import.no-major-axis": entry("the major axis of the ellipse has a length of 0"),
    "import.no-paint": entry(
        "the object has neither a stroke nor a fill, so it is not visible",
    ),
    "import.no-parameter-range": entry(
        "the object has no length: it starts and ends at parameter {parameter:g}",
        parameter="number",
    ),
    "import.no-points": entry("the object has no points"),
    "import.no-scale": entry(
        "the object is scaled by {x:g} × {y:g}, so its size is 0",
        x="number",
        y="number",
    ),
    "import.no-size": entry(
        "the object has no size: its width is {width:g} and its height {height:g}",
        width="number",
        height="number",
    ),
    "import.no-sweep": entry(
        "the arc has no length: it starts and ends at {degrees:g}°",
        degrees="number",
    ),
    "import.not-a-line": entry("objects of type {kind} cannot be read", kind="text"),
    "import.not-clipped": entry(
        "the object is clipped in the file, but it is imported completely",
    ),
    "import.not-flat": entry(
        "the object is not parallel to the XY plane",
    ),
    "import.not-numbers": entry(
        "the coordinates of the object are not all numbers: {values:, }",
        values="texts",
    ),
    "import.not-svg": entry("the content of the object is not SVG"),
    "import.not-visible": entry("the object is completely transparent"),
    "import.nothing-named": entry(
        "the PDF has no form or image with the name {name!r}",
        name="text",
    ),
    "import.on-layer": entry(
        "the object lies on the layer {layer}",
        layer="text",
    ),
    "import.other-file": entry(
        "the object is in another file, {file!r}, which is not loaded",
        "Embed the object in the file and export again.",
        file="text",
    ),
    "import.other-pages": entry(
        "only the first of {pages:# page|# pages} is read",
        "Export each page as a separate file.",
        pages="count",
    ),
    "import.outside-page": entry("the object lies outside the visible area of the page"),
    "import.page-ends-early": entry(
        "the path is neither stroked nor filled, because the page ends before the path is finished",
    ),
    "import.paper-space": entry("the object is in a layout (paper space), not in the model"),
    "import.parameters-not-numbers": entry("the parameters of the object are not numbers"),
    "import.partly-outside-page": entry(
        "a part of the object lies outside the visible area of the page",
    ),
    "import.picture": entry("pictures are not cut"),
    "import.picture-block": entry(
        "the block {block} with {entities:# object|# objects} is the graphic of a dimension or "
        "a hatch, which is not cut",
        block="text",
        entities="count",
    ),
    "import.pieces-drawn-twice": entry(
        "{pieces} of {all} segments {pieces:lies|lie} exactly on {same:, }, so {pieces:it "
        "is|they are} drawn twice",
        pieces="count",
        all="count",
        same="texts",
    ),
    "import.pieces-drawn-twice-often": entry(
        "{pieces} of {all} segments {pieces:lies|lie} exactly on {same:, } and {more} more "
        "{more:object|objects}, so {pieces:it is|they are} drawn several times",
        pieces="count",
        all="count",
        same="texts",
        more="count",
    ),
    "import.pieces-no-length": entry(
        "{pieces} of {all} segments {pieces:has|have} no length",
        pieces="count",
        all="count",
    ),
    "import.place-not-a-number": entry("the position of the object is not a number"),
    "import.placement-not-a-number": entry(
        "the position, scale or rotation of the object is not a number",
    ),
    "import.places-block": entry(
        "the object inserts the block {block}",
        block="text",
    ),
    "import.places-subroutine": entry(
        "the object inserts the subroutine {name}",
        name="text",
    ),
    "import.point": entry("the object is a point, which has no length"),
    "import.proxy": entry(
        "only the program that made this object can read it",
        "Explode the object into lines in that program and export again.",
    ),
    "import.region": entry(
        "regions cannot be read",
        "Explode the region into lines in the CAD program and export again.",
    ),
    "import.repeated": entry(
        "the object is drawn {times} times",
        times="count",
    ),
    "import.rules-not-read": entry(
        "the style sheet has rules that are not supported: {rules:, }",
        rules="texts",
    ),
    "import.script": entry("scripts are not executed"),
    "import.shading": entry(
        "shadings (colour gradients) are not cut",
    ),
    "import.short-path-data": entry(
        "the path data of the object ends inside a command, so only the commands before it "
        "were imported, as in a browser",
    ),
    "import.solid": entry(
        "the object is a solid or a face, not a line in a plane",
    ),
    "import.spot-colour": entry(
        "the object is drawn in the spot colour {colour}",
        colour="text",
    ),
    "import.subroutine-in-itself": entry("the subroutine {name} contains itself", name="text"),
    "import.text": entry("texts are not cut"),
    "import.text-unknown-letters": entry(
        "texts are not cut, and the characters of this text cannot be read",
    ),
    "import.tilted": entry(
        "the object is not parallel to the XY plane: its plane is tilted by {degrees:g}°",
        degrees="number",
    ),
    "import.tilted-axis": entry(
        "the object is not parallel to the XY plane: its major axis rises by {rise:g} file units",
        rise="number",
    ),
    "import.too-far": entry(
        "a coordinate of the object is {coordinate:g}, but the limit is {limit:g}",
        coordinate="number",
        limit="number",
    ),
    "import.too-many-fit-points": entry(
        "the curve has {points:,} fit points; the limit is {limit:,}",
        points="count",
        limit="count",
    ),
    "import.uncentred-arc": entry(
        "the centre of the arc is {first:g} away from its start, but {second:g} away from its end",
        first="number",
        second="number",
    ),
    "import.underlay": entry("underlays (inserted pictures and PDF pages) are not cut"),
    "import.uneven-height": entry(
        "the object is not parallel to the XY plane: its height z varies from {low:g} to {high:g}",
        low="number",
        high="number",
    ),
    "import.unknown-operator": entry(
        "the PDF operator {operator!r} is not supported",
        operator="text",
    ),
    "import.unknown-record": entry(
        "CF2 records of this type are not supported",
    ),
    "import.unsupported-element": entry("elements of type {kind} are not supported", kind="text"),
    "import.unused-block": entry(
        "the block {block} with {entities:# object|# objects} is not used in the drawing",
        block="text",
        entities="count",
    ),
    "import.unused-subroutine": entry(
        "the subroutine {name} with {records:# record|# records} is not used in the drawing",
        name="text",
        records="count",
    ),
    "import.value-angle": entry(
        "the angle {degrees:g}° is not finite",
        degrees="number",
    ),
    "import.value-not-numbers": entry("{value!r} is not a number", value="text"),
    "import.value-not-transform": entry(
        "{value!r} is not a valid transform",
        value="text",
    ),
    "import.value-transform-numbers": entry(
        "the transform {name} has a wrong number of values ({count})",
        name="text",
        count="count",
    ),
    "import.value-unit": entry("{value!r} has an unknown unit of length", value="text"),
    "import.viewport": entry(
        "the object is a viewport, which only displays a part of the drawing",
    ),
    "import.wrong-field-count": entry(
        "line {line} of the file has {fields:# field|# fields}, which is the wrong number of "
        "fields for its record",
        line="count",
        fields="count",
    ),
}
