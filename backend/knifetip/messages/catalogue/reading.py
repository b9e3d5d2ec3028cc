"""reading: files that cannot be read as a drawing."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "reading.crashed": entry(
        "{name}: the file is damaged and cannot be read ({reason}).",
        "Export it again as DXF, CF2, SVG or PDF, from another program if necessary.",
        name="text",
        reason="text",
    ),
    "reading.damaged": entry(
        "The {format} is damaged and cannot be read ({reason}).",
        "Export it again, from another program if necessary.",
        reason="text",
        format="text",
    ),
    "reading.empty": entry(
        "The file is empty.",
        "Send the drawing as {formats:or}.",
        formats="texts",
    ),
    "reading.expands-too-far": entry(
        "The repeated parts of the {format} expand to more than {limit:,} elements.",
        "Export a single carton, with blocks and symbols expanded.",
        limit="count",
        format="text",
    ),
    "reading.nested-too-deep": entry(
        "Blocks, symbols or groups of the {format} are nested more than {limit} deep.",
        "Explode them in the program that drew the file, and export again.",
        limit="count",
        format="text",
    ),
    "reading.too-large": entry(
        "The file has {size:.1f} MB; the limit is {limit:.1f} MB.",
        "Export a single carton, without pictures.",
        size="number",
        limit="number",
    ),
    "reading.too-many-elements": entry(
        "The {format} has more than {limit:,} elements.",
        "Export a single carton.",
        limit="count",
        format="text",
    ),
    "reading.too-many-entities": entry(
        "The file has {count:,} entities; the limit is {limit:,}.",
        "Export a single carton.",
        count="count",
        limit="count",
    ),
    "reading.too-many-segments": entry(
        "The {format} has more than {limit:,} lines and curves.",
        "Export a single carton, without pictures made of lines.",
        limit="count",
        format="text",
    ),
    "reading.too-slow": entry(
        "The {format} takes longer than {seconds:g} s to read.",
        "Export a single carton, with curves as lines and arcs and without pictures.",
        seconds="number",
        format="text",
    ),
    "reading.unexpected": entry(
        "The {format} is damaged in an unexpected way and cannot be read ({reason}).",
        "Export it again, from another program if necessary.",
        format="text",
        reason="text",
    ),
    "reading.unknown-kind": entry(
        "The file is {what}, not a drawing that can be read.",
        "Send the drawing as {formats:or}.",
        what="text",
        formats="texts",
    ),
    "dxf.blocks-expand-too-far": entry(
        "The blocks of the drawing expand to {count} entities; the limit is {limit:,}.",
        "Export a single carton, or explode the blocks and delete the copies.",
        count="text",
        limit="count",
    ),
    "dxf.blocks-too-deep": entry(
        "Blocks are nested {depth} deep; the limit is {limit}.",
        "Explode the blocks in the CAD program and export again.",
        depth="count",
        limit="count",
    ),
    "dxf.cut-short": entry(
        "The file is cut short: it stops {where} in section {section}, after {count:# entity|# "
        "entities}, so lines may be missing.",
        "Send or export it again.",
        where="text",
        section="text",
        count="count",
    ),
    "dxf.no-section": entry(
        "The file is not a DXF: it has no section.",
        "Export the drawing as DXF (text or binary, any version).",
    ),
    "dxf.not-a-group-code": entry(
        "The file is not a DXF: line {line} is {text!r}, not a group code.",
        "Export the drawing as DXF (text or binary, any version).",
        line="count",
        text="text",
    ),
    "dxf.other-kind": entry(
        "The file is {kind}, not a DXF.",
        "Export the drawing as DXF (text or binary, any version).",
        kind="text",
    ),
    "dxf.too-large-unusual": entry(
        "The DXF has {size:.1f} MB and uses features that are read slowly; the limit for such a "
        "file is {limit:.1f} MB.",
        "Export a single carton, or save it as DXF R2000.",
        size="number",
        limit="number",
    ),
    "cf2.cut-short": entry(
        "The CF2 is cut short: it ends at line {line} inside {inside}, so lines may be missing.",
        "Send it again, or export it again as CF2.",
        line="count",
        inside="text",
    ),
    "cf2.decimal-commas": entry(
        "Line {line} of the CF2 has {fields} fields where {record} has {expected}: its decimals "
        "seem to use commas, which also separate the fields.",
        "Export it with a decimal point.",
        line="count",
        fields="count",
        record="text",
        expected="count",
    ),
    "cf2.empty": entry(
        "The CF2 draws nothing: it has neither a MAIN section nor a subroutine.",
        "Send it again, or export it again as CF2.",
    ),
    "svg.cut-short": entry(
        "The SVG is cut short: it ends at line {line}, after {count:# element|# elements}, so "
        "lines may be missing.",
        "Export it again, as plain SVG.",
        line="count",
        count="count",
    ),
    "svg.damaged-at": entry(
        "The SVG is damaged at line {line}, column {column}: {reason}.",
        "Export it again, as plain SVG.",
        line="count",
        column="count",
        reason="text",
    ),
    "svg.empty": entry("The SVG is empty.", "Export it again, as plain SVG."),
    "svg.external-entity": entry(
        "The SVG's DOCTYPE has an entity {name!r} that refers to another file, which is not "
        "loaded.",
        "Save it as plain SVG, without a DOCTYPE.",
        name="text",
    ),
    "svg.long-entity": entry(
        "The SVG's DOCTYPE has an entity {name!r} of {length:,} characters, which would expand "
        "the file too far.",
        "Save it as plain SVG, without a DOCTYPE.",
        name="text",
        length="count",
    ),
    "svg.markup-entity": entry(
        "The SVG's DOCTYPE has an entity {name!r} that contains markup.",
        "Save it as plain SVG, without a DOCTYPE.",
        name="text",
    ),
    "svg.nested-too-deep": entry(
        "Elements of the SVG are nested more than {limit} deep.",
        "Ungroup the drawing and export it again.",
        limit="count",
    ),
    "svg.other-xml": entry(
        "The file is XML with the outermost element {element}, not svg.",
        "Save it as plain SVG.",
        element="text",
    ),
    "svg.packed-cut-short": entry(
        "The packed SVG (.svgz) is cut short.",
        "Export it again, as plain SVG.",
    ),
    "svg.packed-damaged": entry(
        "The packed SVG (.svgz) is damaged: {reason}.",
        "Export it again, as plain SVG.",
        reason="text",
    ),
    "svg.too-many-rules": entry(
        "The SVG's style sheet has {count:,} rules; the limit is {limit:,}.",
        "Export it with the style in each element.",
        count="count",
        limit="count",
    ),
    "svg.unpacks-too-far": entry(
        "The packed SVG (.svgz) holds more than {limit:.1f} MB.",
        "Export a single carton, without pictures.",
        limit="number",
    ),
    "pdf.blank": entry(
        "There is no drawing on the first page of the PDF.",
        "Export the drawing as a page of its own.",
    ),
    "pdf.content-damaged": entry(
        "The content of the PDF's {where} {reason}, so lines may be missing.",
        "Export it again, or send the drawing as DXF.",
        where="text",
        reason="text",
    ),
    "pdf.cut-short": entry(
        "The PDF is cut short: its {bytes:,} bytes do not end with %%EOF, so lines may be missing.",
        "Send or export it again.",
        bytes="count",
    ),
    "pdf.encrypted": entry(
        "The PDF is encrypted.",
        "Save it without a password and without restrictions.",
    ),
    "pdf.expands-too-far": entry(
        "The page of the PDF and the forms that it repeats expand to more than {limit:.1f} MB of "
        "drawing.",
        "Export a single carton, with its symbols expanded.",
        limit="number",
    ),
    "pdf.form": entry(
        "The PDF is a form (XFA) and has no drawing on its page.",
        "Print it to a PDF, or send the drawing itself.",
    ),
    "pdf.illustrator-only": entry(
        "The Illustrator file was saved without PDF content, and there is no line on its page.",
        "Save it with 'Create PDF Compatible File', or as PDF.",
    ),
    "pdf.layers-too-deep": entry(
        "Layers of the PDF are nested more than {limit:,} deep.",
        "Export it again from the program that drew it.",
        limit="count",
    ),
    "pdf.no-header": entry(
        "The file is not a PDF: it does not begin with %PDF.",
        "Export it again, or send the drawing as DXF.",
    ),
    "pdf.no-page": entry("The PDF has no page.", "Export it again, or send the drawing as DXF."),
    "pdf.page-too-large": entry(
        "The page of the PDF reaches to {size:g} mm; the limit is {limit:g} mm.",
        "Export it in its true size.",
        size="number",
        limit="number",
    ),
    "pdf.part-missing": entry(
        "A part of the PDF's page is missing, so lines may be missing.",
        "Export it again, or send the drawing as DXF.",
    ),
    "pdf.stream-cut-short": entry(
        "A stream of the PDF is cut short, so lines may be missing.",
        "Send or export it again.",
    ),
    "pdf.stream-damaged": entry(
        "A stream of the PDF is damaged ({reason}), so lines may be missing.",
        "Export it again, or send the drawing as DXF.",
        reason="text",
    ),
    "pdf.stream-too-large": entry(
        "A stream of the PDF unpacks to more than {limit:.1f} MB.",
        "Export a single carton, without pictures.",
        limit="number",
    ),
    "pdf.too-many-states": entry(
        "The PDF saves more than {limit:,} graphics states at once.",
        "Export it again from the program that drew it.",
        limit="count",
    ),
}
