"""import_outcomes: messages about the import of entities, and why entities are omitted."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "import.added-by-hand": entry("the edge was added by hand"),
    "import.all-outside-page": entry(
        "the whole drawing lies outside the visible area of the page",
        "Move the drawing onto the page in the program that drew it, so that objects beside the "
        "page are left out.",
    ),
    "import.angles-not-numbers": entry(
        "the start or end angle of the arc is not a number",
    ),
    "import.annotations": entry(
        "{count:# note or form field|# notes and form fields} on the PDF page {count:is|are} "
        "not cut",
        count="count",
    ),
    "import.area-outline": entry(
        "the object is the outline of a filled area, which was imported because the drawing "
        "has no lines",
    ),
    "import.area-outline-on-page": entry(
        "the object is the outline of a filled area, which was imported because the page has "
        "no lines",
    ),
    "import.area-outline-round-lines": entry(
        "the object is the outline of a filled area; it was imported, because the lines on this "
        "area have no closed outline of their own",
    ),
    "import.array": entry(
        "the object inserts the block as a grid of copies ({columns} columns × {rows} rows)",
        columns="count",
        rows="count",
    ),
    "import.aspect-ratio": entry(
        "The size of the page ({size: }) does not have the proportions of its viewBox ({width:g} × "
        "{height:g}): the width gives the scale {across:.4g}, the height {down:.4g}. The drawing "
        "is read at the scale {used:.4g}, as browsers display it.",
        "Check the size of the drawing. If it is wrong, correct the page size in the program that "
        "drew it, and export the drawing again.",
        size="texts",
        width="number",
        height="number",
        across="number",
        down="number",
        used="number",
    ),
    "import.bad-operands": entry(
        "the path uses the PDF operator {operator!r} with a wrong number or type of values",
        operator="text",
    ),
    "import.bad-path-data": entry(
        "the path data of the object is invalid at character {character} ({text!r})",
        "Correct the object in the program that drew it, and export the drawing again.",
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
    "import.bad-primitive": entry(
        "the path of the object joins vertices that it does not have, or in an unknown way "
        "({kind!r} from {first} to {second})",
        "Correct the object in the program that drew it, and export the drawing again.",
        kind="text",
        first="count",
        second="count",
    ),
    "import.bad-radius": entry(
        "the radius of the object is {radius:g}, but must be greater than 0",
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
    "import.bad-value": entry(
        "the value {value!r} is not a length",
        value="text",
    ),
    "import.bad-window": entry(
        "the position or size of the nested drawing cannot be read: {reason}",
        reason="message",
    ),
    "import.block-external": entry(
        "the object inserts the block {block!r}, which is defined in another file",
        "Bind the external reference in the CAD program, and export the drawing again.",
        block="text",
    ),
    "import.block-in-itself": entry(
        "the block {block!r} inserts itself",
        block="text",
    ),
    "import.block-missing": entry(
        "the object inserts the block {block!r}, which is not defined in the file",
        "Add the definition of the block in the CAD program, and export the drawing again.",
        block="text",
    ),
    "import.bridge": entry(
        "the steel rule of the cutting die has 1 bridge (gap), {width:g} file units wide; the edge "
        "is cut without the gap",
        width="number",
    ),
    "import.bridges": entry(
        "the steel rule of the cutting die has {bridges:g} bridges (gaps), each {width:g} file "
        "units wide; the edge is cut without the gaps",
        bridges="number",
        width="number",
    ),
    "import.changed": entry(
        "{objects:# object is|# objects are} imported with a change: {reason}.",
        "The import report lists {objects:it|them}. {reason:hint}",
        objects="count",
        reason="message",
    ),
    "import.changed-on-layer": entry(
        "{objects:# object|# objects} on layer {layer!r} {objects:is|are} imported with a change: "
        "{reason}.",
        "The import report lists {objects:it|them}. {reason:hint}",
        objects="count",
        layer="text",
        reason="message",
    ),
    "import.check-drawing": entry(
        "Check the drawing: {reason}.",
        "{reason:hint}",
        reason="message",
    ),
    "import.clip-path": entry(
        "the object only limits the visible area of other objects (clipping path)",
    ),
    "import.clipped": entry(
        "only the part of the object that is visible inside its clip path or mask was imported",
        "Remove the clip path or mask and export the drawing again if the whole object must be "
        "cut.",
    ),
    "import.clipped-away": entry(
        "the object lies outside its clip path or mask, so it is not visible",
        "Remove the clip path or mask and export the drawing again if the object must be cut.",
    ),
    "import.contains-itself": entry(
        "the object contains a reference to itself",
    ),
    "import.conversion-doubtful": entry(
        "{program}, which converted the file, reported {count:# object or place|# objects or "
        "places} that it could not convert ({losses}). Objects of the drawing may be missing or "
        "wrong.",
        "Compare the drawing with the original. {what:hint}",
        program="text",
        count="count",
        losses="texts",
        what="message",
    ),
    "import.converted": entry(
        "the file was converted by {program}",
        program="text",
    ),
    "import.coordinate-not-a-number": entry("a coordinate of the object is not a number"),
    "import.curves-fitted": entry(
        "the curves of the object were converted to {pieces:# line or arc|# lines and arcs}, "
        "which deviate by at most {tolerance:.2g} file units from the curves",
        pieces="count",
        tolerance="number",
    ),
    "import.curves-fitted-relative": entry(
        "the curves of the object were converted to {pieces:# line or arc|# lines and arcs}, "
        "which deviate by at most {tolerance:.2g} file units from the curves (1/250,000 of the "
        "size of the drawing)",
        pieces="count",
        tolerance="number",
    ),
    "import.damaged": entry("the object is damaged: {reason}", reason="text"),
    "import.damaged-or-frame": entry(
        "the object is damaged, or is only the frame around a text",
    ),
    "import.dimension": entry(
        "the object is a dimension or a note, which is not cut",
    ),
    "import.drawn-twice": entry(
        "the object is drawn twice: it has the same shape and position as {same:, }",
        same="texts",
    ),
    "import.drawn-twice-often": entry(
        "the object is drawn several times: it has the same shape and position as {same:, } "
        "and {more} more {more:object|objects}",
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
        "the object is a polyline with {vertices:# vertex|# vertices}, but needs at least 2",
        vertices="count",
    ),
    "import.filled-area": entry(
        "the object is a filled area without an outline, so it is not cut",
    ),
    "import.filled-area-beside-strokes": entry(
        "the object is a filled area without an outline; the outline of a filled area is cut only "
        "if the drawing has no lines, or if the lines on the area have no closed outline of their "
        "own",
    ),
    "import.filled-area-on-page": entry(
        "the object is a filled area without an outline; the outlines of filled areas are cut only "
        "on pages that have no lines",
    ),
    "import.fit-points": entry(
        "the file states only the fit points of the curve, so the curve was drawn through these "
        "points",
    ),
    "import.font-shape": entry(
        "the object is a shape from a font file, which cannot be read",
        "Explode the object into lines in the CAD program, and export the drawing again.",
    ),
    "import.hatch": entry(
        "the object is a hatch (filled area), whose boundary is not read",
        "Draw the boundary as lines in the CAD program, and export the drawing again if it must "
        "be cut.",
    ),
    "import.height-not-a-number": entry("the height (z) of the object is not a number"),
    "import.height-too-far": entry(
        "the height (z) of the object is {height:g} file units, but the limit is {limit:g}",
        height="number",
        limit="number",
    ),
    "import.hidden": entry("the object is hidden"),
    "import.hidden-layer": entry(
        "the object is hidden, because the layer {layer} is switched off",
        "Switch the layer on and export the drawing again if the object must be cut.",
        layer="text",
    ),
    "import.image": entry(
        "the object is an image, which is not cut",
    ),
    "import.incomplete": entry(
        "the object is incomplete, because its {part} is missing",
        part="text",
    ),
    "import.interrupted-path": entry(
        "the path has neither a stroke nor a fill, because another object begins before the "
        "path ends",
    ),
    "import.invisible": entry("the object is marked as invisible"),
    "import.kept": entry(
        "the object was imported unchanged",
    ),
    "import.kept-changed": entry(
        "the object was imported; note: {notes:; }",
        notes="messages",
    ),
    "import.laid-flat": entry(
        "the object was moved from the height z = {height:g} file units to z = 0",
        height="number",
    ),
    "import.layer-frozen": entry(
        "the layer of the object is frozen",
        "Thaw the layer and export the drawing again if the object must be cut.",
    ),
    "import.layer-never-plotted": entry(
        "CAD programs never plot the layer of the object",
        "Move the object to another layer and export the drawing again if the object must be cut.",
    ),
    "import.layer-not-plotted": entry(
        "the layer of the object is set to be not plotted",
        "Set the layer to be plotted and export the drawing again if the object must be cut.",
    ),
    "import.layer-off": entry(
        "the layer of the object is switched off",
        "Switch the layer on and export the drawing again if the object must be cut.",
    ),
    "import.left-out": entry(
        "{objects:# object is|# objects are} not cut: {reason}.",
        "The import report lists {objects:it|them}. {reason:hint}",
        objects="count",
        reason="message",
    ),
    "import.left-out-further": entry(
        "{objects:# further object is|# further objects are} not cut.",
        "The import report gives the reason for each object.",
        objects="count",
    ),
    "import.left-out-on-layer": entry(
        "{objects:# object|# objects} on layer {layer!r} {objects:is|are} not cut: {reason}.",
        "The import report lists {objects:it|them}. {reason:hint}",
        objects="count",
        layer="text",
        reason="message",
    ),
    "import.light": entry(
        "the object is a light, which is not cut",
    ),
    "import.lightburn-shape": entry(
        "the object is a LightBurn shape of the type {kind}, which cannot be read",
        "In LightBurn, select the object, choose Edit > Convert to Path, and save the project "
        "again.",
        kind="text",
    ),
    "import.line-not-numbers": entry(
        "the values in line {line} of the file are not all numbers: {values:, }",
        line="count",
        values="texts",
    ),
    "import.lone-vertex": entry(
        "the object is a vertex that belongs to no polyline",
    ),
    "import.mesh": entry(
        "the object is a three-dimensional mesh, not a line in a plane",
    ),
    "import.missing-id": entry(
        "the object refers to another object by the id {id!r}, which does not exist in the file",
        id="text",
    ),
    "import.missing-subroutine": entry(
        "the object inserts the subroutine {name}, which is not in the file",
        name="text",
    ),
    "import.multiple-line": entry(
        "the object is a multiline (MLINE), which is not read",
        "Explode the multiline into lines in the CAD program, and export the drawing again.",
    ),
    "import.no-end-mark": entry(
        "the end mark {mark} of the file is missing, so objects may be missing",
        "Compare the drawing with the original, or export it again.",
        mark="text",
    ),
    "import.no-length": entry(
        "the length of the object is {length:g}, which is too short to be cut",
        length="number",
    ),
    "import.no-major-axis": entry("the major axis of the ellipse has a length of 0"),
    "import.no-paint": entry(
        "the object has neither a stroke nor a fill, so it is not visible",
    ),
    "import.no-parameter-range": entry(
        "the ellipse has no length, because its start parameter and its end parameter are both "
        "{parameter:g}",
        parameter="number",
    ),
    "import.no-pen": entry(
        "the object is drawn without a pen (pen 0), so it is not visible",
    ),
    "import.no-points": entry("the object has no points"),
    "import.no-scale": entry(
        "the object has no size, because it is scaled by {x:g} in X and {y:g} in Y",
        x="number",
        y="number",
    ),
    "import.no-size": entry(
        "the object has no size: its width is {width:g} and its height {height:g}",
        width="number",
        height="number",
    ),
    "import.no-stroke-width": entry(
        "the stroke of the object has a width of 0, so it is not visible",
        "Give the stroke a width and export the drawing again if the object must be cut.",
    ),
    "import.no-sweep": entry(
        "the arc has no length, because it starts and ends at the same angle, {degrees:g}°",
        degrees="number",
    ),
    "import.not-a-line": entry(
        "the object is of the type {kind}, which cannot be read",
        kind="text",
    ),
    "import.not-clipped": entry(
        "the file clips the object, but the complete object was imported",
        "Trim the object, or apply the clip path, in the program that drew the file. Then export "
        "the drawing again.",
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
        "the PDF page uses a form or image with the name {name!r}, which the PDF does not contain",
        name="text",
    ),
    "import.odd-points": entry(
        "the list of points of the object is incomplete: the last point has no y coordinate",
        "Correct the object in the program that drew it, and export the drawing again.",
    ),
    "import.on-layer": entry(
        "the object also lies on the layer {layer}",
        layer="text",
    ),
    "import.other-file": entry(
        "the object is in another file, {file!r}, which is not loaded",
        "Embed the object in the file and export again.",
        file="text",
    ),
    "import.other-language": entry(
        "the object is for readers of another language, so it is not visible",
    ),
    "import.other-pages": entry(
        "The file has {pages:# page|# pages}, but only page {page} is read.",
        "If the drawing is on another page, choose this page, or export it as a separate file.",
        pages="count",
        page="count",
    ),
    "import.other-pages-lines": entry(
        "The file has {others:# other page|# other pages} besides page {page}, and only page "
        "{page} is read. Page {most} has the most lines of the other pages ({lines:,}).",
        "If the drawing is on another page, choose this page, or export it as a separate file.",
        others="count",
        page="count",
        most="count",
        lines="count",
    ),
    "import.other-sheet": entry(
        "the object is on sheet {sheet} of the plot, but only the first sheet is read",
        "If the object must be cut, export its sheet as a separate file.",
        sheet="count",
    ),
    "import.outside-page": entry("the object lies outside the visible area of the page"),
    "import.page-ends-early": entry(
        "the path has neither a stroke nor a fill, because the page ends before the path ends",
    ),
    "import.paper-space-annotation": entry(
        "the object is an annotation or a viewport in a layout (paper space), not in the model",
    ),
    "import.paper-space": entry("the object is in a layout (paper space), not in the model"),
    "import.parameters-not-numbers": entry(
        "the start or end parameter of the ellipse is not a number"
    ),
    "import.partly-outside-page": entry(
        "a part of the object lies outside the visible area of the page",
    ),
    "import.picture-block": entry(
        "the block {block} with {entities:# object|# objects} is the graphic of a dimension or "
        "a hatch, which is not cut",
        block="text",
        entities="count",
    ),
    "import.pieces-drawn-twice": entry(
        "{pieces} of the {all} segments of the object {pieces:is|are} drawn twice: {pieces:it "
        "lies|they lie} exactly on {same:, }",
        pieces="count",
        all="count",
        same="texts",
    ),
    "import.pieces-drawn-twice-often": entry(
        "{pieces} of the {all} segments of the object {pieces:is|are} drawn several times: "
        "{pieces:it lies|they lie} exactly on {same:, } and {more} more {more:object|objects}",
        pieces="count",
        all="count",
        same="texts",
        more="count",
    ),
    "import.pieces-no-length": entry(
        "{pieces} of the {all} segments of the object {pieces:has|have} no length",
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
    "import.plotter-marks": entry(
        "the instruction draws symbols, ticks or characters of its own, which are not cut",
    ),
    "import.point": entry("the object is a point, which has no length"),
    "import.proxy": entry(
        "the object can be read only by the program that made it",
        "Explode the object into lines in that program and export again.",
    ),
    "import.region": entry(
        "the object is a region, which cannot be read",
        "Explode the region into lines in the CAD program, and export the drawing again.",
    ),
    "import.repeated": entry(
        "the drawing contains the object {times} times",
        times="count",
    ),
    "import.rules-not-read": entry(
        "the style sheet of the drawing has rules that are not supported: {rules:, }",
        rules="texts",
    ),
    "import.script": entry(
        "the object is a script, which is not executed",
    ),
    "import.shading": entry(
        "the object is a shading (colour gradient), which is not cut",
    ),
    "import.short-path-data": entry(
        "the path data of the object is incomplete: it ends inside a command",
        "Correct the object in the program that drew it, and export the drawing again.",
    ),
    "import.solid": entry(
        "the object is a solid or a face, not a line in a plane",
    ),
    "import.spot-colour": entry(
        "the object is drawn in the spot colour {colour}",
        colour="text",
    ),
    "import.subroutine-in-itself": entry(
        "the subroutine {name} inserts itself",
        name="text",
    ),
    "import.text": entry(
        "the object is a text, which is not cut",
    ),
    "import.text-unknown-letters": entry(
        "the object is a text, which is not cut; its wording cannot be shown, because its font "
        "does not state which characters it has",
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
        "a coordinate of the object is {coordinate:g} file units, but the limit is {limit:g}",
        coordinate="number",
        limit="number",
    ),
    "import.too-many-fit-points": entry(
        "the curve has {points:,} fit points, but the limit is {limit:,}",
        points="count",
        limit="count",
    ),
    "import.turned-page": entry(
        "the lines after this instruction are turned about the origin of the plotter, but some "
        "plotters turn the paper, so that these lines may be in another place",
        "Compare the drawing with the original, or export it as DXF, PDF or SVG.",
    ),
    "import.uncentred-arc": entry(
        "the centre of the arc is {first:g} file units away from the start of the arc, but "
        "{second:g} file units away from the end of the arc",
        first="number",
        second="number",
    ),
    "import.underlay": entry(
        "the object is an underlay (an inserted picture or PDF page), which is not cut",
    ),
    "import.uneven-height": entry(
        "the object is not parallel to the XY plane: its height z varies from {low:g} to "
        "{high:g} file units",
        low="number",
        high="number",
    ),
    "import.unknown-instruction": entry(
        "the object is an instruction that HPGL does not define",
        "Compare the drawing with the original, or export it as DXF, PDF or SVG.",
    ),
    "import.unknown-operator": entry(
        "the PDF page uses the operator {operator!r}, which is not supported",
        operator="text",
    ),
    "import.unknown-position": entry(
        "the object begins at a position that depends on the plotter, such as the end of a text",
        "Export the drawing as DXF, PDF or SVG if the object must be cut.",
    ),
    "import.unknown-record": entry(
        "the object is a CF2 record of a type that is not supported",
    ),
    "import.unsupported-element": entry(
        "the object is an SVG element of the type {kind}, which is not supported",
        kind="text",
    ),
    "import.unused-block": entry(
        "the file defines the block {block} with {entities:# object|# objects}, but the "
        "drawing does not use it",
        block="text",
        entities="count",
    ),
    "import.unused-subroutine": entry(
        "the file defines the subroutine {name} with {records:# record|# records}, but the "
        "drawing does not use it",
        name="text",
        records="count",
    ),
    "import.value-angle": entry(
        "the angle {degrees:g}° is not finite",
        degrees="number",
    ),
    "import.value-not-numbers": entry(
        "the value {value!r} is not a number",
        value="text",
    ),
    "import.value-not-transform": entry(
        "the value {value!r} is not a valid transform",
        value="text",
    ),
    "import.value-transform-numbers": entry(
        "the transform {name} has {count} values, which is a wrong number of values",
        name="text",
        count="count",
    ),
    "import.value-unit": entry(
        "the value {value!r} has an unknown unit of length",
        value="text",
    ),
    "import.viewport": entry(
        "the object is a viewport, which only displays a part of the drawing",
    ),
    "import.white-area": entry(
        "the object is a white area without an outline, so it is not cut",
    ),
    "import.white-line": entry(
        "the object is drawn in white on a white page, so it is not visible",
        "Give the object another colour and export the drawing again if it must be cut.",
    ),
    "import.wrong-field-count": entry(
        "line {line} of the file has {fields:# field|# fields}, which is the wrong number of "
        "fields for its record",
        line="count",
        fields="count",
    ),
}
