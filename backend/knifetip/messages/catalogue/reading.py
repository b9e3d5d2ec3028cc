"""reading: messages about files that cannot be read as a drawing, and names of kinds of files."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

_PICTURE: Final = (
    "A picture has no lines that can be cut. In the program that drew it, export the drawing as "
    "DXF, SVG or PDF."
)
_POSTSCRIPT: Final = (
    "In Illustrator, open the file and choose File > Save As > PDF. In other programs, export the "
    "drawing as PDF, SVG or DXF."
)
_SOLID: Final = "In the CAD program, make a flat drawing of the carton, and export it as DXF."
_ARTIOSCAD: Final = "In ArtiosCAD, choose File > Outputs, and CFF2 or DXF as the type."
_DWG: Final = (
    "In AutoCAD or another CAD program, choose File > Save As, and DXF (such as DXF 2013) as the "
    "type."
)

MESSAGES: Final[Entries] = {
    "conversion.failed": entry(
        "The file is {what}. {program}, which converts such files, stopped with the error "
        "{reason!r}.",
        "{what:hint}",
        what="message",
        program="text",
        reason="text",
    ),
    "conversion.failed-at": entry(
        "The file is {what}. {program}, which converts such files, stopped at byte {position:,} of "
        "the file with the error {reason!r}.",
        "{what:hint}",
        what="message",
        program="text",
        reason="text",
        position="count",
    ),
    "conversion.no-program": entry(
        "The file is {what}, which knifetip reads only if the program {program} is installed.",
        "{what:hint} Or ask the administrator of knifetip to install {program} (command "
        "{command}). Files that need no other program are {formats:or}.",
        what="message",
        program="text",
        command="text",
        formats="texts",
    ),
    "conversion.no-result": entry(
        "The file is {what}. {program}, which converts such files, found no drawing in it.",
        "{what:hint}",
        what="message",
        program="text",
    ),
    "conversion.result-unreadable": entry(
        "The file is {what}. {program} has converted it, but the result cannot be read: {error}",
        "{what:hint}",
        what="message",
        program="text",
        error="message",
    ),
    "conversion.too-large": entry(
        "The file is {what}. Its conversion by {program} makes files of more than {limit:.0f} MB.",
        "Export a single carton, without pictures. {what:hint}",
        what="message",
        program="text",
        limit="number",
    ),
    "conversion.too-slow": entry(
        "The file is {what}. Its conversion by {program} takes longer than {seconds:g} s.",
        "Export a single carton, without pictures. {what:hint}",
        what="message",
        program="text",
        seconds="number",
    ),
    "conversion.too-much-memory": entry(
        "The file is {what}. Its conversion by {program} needs more than {limit:.0f} MB of memory.",
        "Export a single carton, without pictures. {what:hint}",
        what="message",
        program="text",
        limit="number",
    ),
    "reading.crashed": entry(
        "The file {name} cannot be read, probably because it is damaged (error {incident}).",
        "Export the drawing again as DXF, CF2, SVG or PDF, if necessary from another program. The "
        "log of the server contains the cause under this number.",
        name="text",
        incident="text",
    ),
    "reading.cut-short": entry(
        "The {format} file is incomplete: it ends at line {line}, after {count:# element|# "
        "elements}. Objects of the drawing may be missing.",
        "Send the complete file, or export the drawing again.",
        line="count",
        count="count",
        format="text",
    ),
    "reading.damaged": entry(
        "The {format} file cannot be read, because it is damaged ({reason}).",
        "Export the drawing again, if necessary from another program.",
        reason="text",
        format="text",
    ),
    "reading.damaged-at": entry(
        "The {format} file is damaged at line {line}, column {column}: {reason}.",
        "Export the drawing again, if necessary from another program.",
        line="count",
        column="count",
        reason="text",
        format="text",
    ),
    "reading.empty": entry(
        "The file is empty.",
        "Export the drawing again and send it as {formats:or}. A DXF file may be text or binary, "
        "of any version.",
        formats="texts",
    ),
    "reading.expands-too-far": entry(
        "The repeated parts of the {format} file expand to more than {limit:,} elements.",
        "Export a drawing with a single carton, without repeated parts that the carton does not "
        "need.",
        limit="count",
        format="text",
    ),
    "reading.no-pages": entry(
        "A {format} file has no pages.",
        "Only a PDF or a PostScript file has pages to choose from.",
        format="text",
    ),
    "reading.nested-too-deep": entry(
        "Blocks, symbols or groups of the {format} file are nested more than {limit} levels deep.",
        "Explode the blocks, symbols or groups in the program that drew the file, and export "
        "again.",
        limit="count",
        format="text",
    ),
    "reading.too-large": entry(
        "The file is {size:.1f} MB large, but the limit is {limit:.1f} MB.",
        "Export a single carton, without pictures.",
        size="number",
        limit="number",
    ),
    "reading.too-many-elements": entry(
        "The {format} file has more than {limit:,} elements.",
        "Export a drawing with a single carton.",
        limit="count",
        format="text",
    ),
    "reading.too-many-entities": entry(
        "The file has {count:,} entities (drawn objects), but the limit is {limit:,}.",
        "Export a drawing with a single carton.",
        count="count",
        limit="count",
    ),
    "reading.too-many-segments": entry(
        "The {format} file has more than {limit:,} lines and curves.",
        "Export a single carton, without pictures made of lines.",
        limit="count",
        format="text",
    ),
    "reading.too-slow": entry(
        "Reading the {format} file takes longer than {seconds:g} s.",
        "Export a single carton without pictures, and convert curves to lines and arcs.",
        seconds="number",
        format="text",
    ),
    "reading.truncated": entry(
        "The {format} file is incomplete, so it cannot be read.",
        "Send the complete file, or export the drawing again.",
        format="text",
    ),
    "reading.unexpected": entry(
        "The {format} file cannot be read, probably because it is damaged. The reader stopped "
        "with the error {reason}.",
        "Export the drawing again, if necessary from another program. If this happens again, "
        "report the error with the file.",
        format="text",
        reason="text",
    ),
    "reading.unknown-kind": entry(
        "The file is {what}, not a drawing of a supported type.",
        "Send the drawing as {formats:or}. A DXF file may be text or binary, of any version. "
        "{what:hint}",
        what="message",
        formats="texts",
    ),
    "file.3mf": entry("a 3MF model", _SOLID),
    "file.7z": entry("a 7z archive"),
    "file.affinity": entry(
        "an Affinity document",
        "In Affinity, choose File > Export, and SVG or PDF as the type.",
    ),
    "file.ard": entry("an ArtiosCAD design (ARD)", _ARTIOSCAD),
    "file.binary": entry(
        "a binary file of an unknown format",
        "In the program that drew it, export the drawing as DXF. In ArtiosCAD (.ard), choose File "
        "> Outputs, and DXF or CFF2 as the type.",
    ),
    "file.bmp": entry("a BMP picture", _PICTURE),
    "file.cdr": entry(
        "a CorelDRAW drawing (CDR)",
        "In CorelDRAW, choose File > Export, and SVG or DXF as the type.",
    ),
    "file.compound-file": entry(
        "an old Office file, or a CAD file in the same container format",
        "In the program that drew it, export the drawing as DXF.",
    ),
    "file.ddes": entry(
        "a DDES file (DDES2 or DDES3, ANSI IT8.6)",
        _ARTIOSCAD + " In another CAD program, export the drawing as CF2 or DXF.",
    ),
    "file.dmpl": entry(
        "a plotter file in the language DM/PL",
        "In the program that drew it, choose a plotter with HPGL, or export the drawing as DXF, "
        "PDF or SVG.",
    ),
    "file.dwf": entry(
        "a DWF drawing, which is only for display",
        "In the CAD program that wrote it, save the drawing as DXF.",
    ),
    "file.dwg": entry("a DWG drawing", _DWG),
    "file.eps": entry("an EPS file", _POSTSCRIPT),
    "file.gcode": entry(
        "a program for a machine (G-code)",
        "Send the drawing from which the program was made.",
    ),
    "file.gif": entry("a GIF picture", _PICTURE),
    "file.gzip": entry("a gzip archive"),
    "file.html": entry("an HTML page"),
    "file.iges": entry("an IGES file", _SOLID),
    "file.illustrator": entry(
        "an old Illustrator file without PDF content",
        "In Illustrator, choose File > Save As with the option 'Create PDF Compatible File', or "
        "export the drawing as PDF, SVG or DXF.",
    ),
    "file.indesign": entry(
        "an InDesign document",
        "In InDesign, choose File > Export, and Adobe PDF (Print) as the type.",
    ),
    "file.jpeg": entry("a JPEG picture", _PICTURE),
    "file.json": entry("a JSON file"),
    "file.metafile": entry(
        "a Windows metafile (EMF or WMF)",
        "In the program that drew it, export the drawing as SVG, PDF or DXF.",
    ),
    "file.office": entry(
        "an Office document",
        "Send the drawing in it as a separate file. A drawing that was made in the Office program "
        "can be saved as PDF.",
    ),
    "file.old-dwg": entry("an old DWG drawing", _DWG),
    "file.photoshop": entry("a Photoshop picture", _PICTURE),
    "file.png": entry("a PNG picture", _PICTURE),
    "file.postscript": entry("a PostScript file", _POSTSCRIPT),
    "file.printer": entry(
        "a file for a printer (PCL or PJL)",
        "In the program that drew it, export the drawing as DXF, PDF or SVG instead of printing it "
        "to a file.",
    ),
    "file.rar": entry("a RAR archive"),
    "file.rhino": entry(
        "a Rhino model",
        "In Rhino, select the flat curves, and choose File > Export Selected, and DXF as the type.",
    ),
    "file.riff": entry(
        "a picture or a video (RIFF)",
        _PICTURE,
    ),
    "file.silhouette": entry(
        "a project of Silhouette Studio",
        "In Silhouette Studio Business Edition, choose File > Save As, and SVG or PDF as the type.",
    ),
    "file.sketchup": entry(
        "a SketchUp model",
        "In SketchUp, choose File > Export > 2D Graphic, and DXF or PDF as the type.",
    ),
    "file.step": entry(
        "a STEP file",
        _SOLID,
    ),
    "file.stl": entry(
        "an STL model",
        _SOLID,
    ),
    "file.tiff": entry("a TIFF picture", _PICTURE),
    "file.xps": entry(
        "an XPS document",
        "In the program that drew it, export the drawing as PDF, SVG or DXF, or print it to a PDF.",
    ),
    "file.xml": entry(
        "an XML file of the type {element!r}",
        element="text",
    ),
    "file.zip": entry(
        "a ZIP archive",
        "Unpack the archive, and send the drawing in it.",
    ),
    "dxf.at-line": entry(
        "at line {line} of the file",
        line="count",
    ),
    "dxf.blocks-expand-too-far": entry(
        "The blocks of the DXF file expand to {count} entities (drawn objects), but the limit "
        "is {limit:,}.",
        "Export a drawing with a single carton, or explode the blocks and delete the copies that "
        "are not needed.",
        count="text",
        limit="count",
    ),
    "dxf.blocks-too-deep": entry(
        "The blocks of the DXF file are nested {depth} levels deep, but the limit is {limit} "
        "levels.",
        "Explode the blocks in the CAD program and export again.",
        depth="count",
        limit="count",
    ),
    "dxf.coordinate-alone": entry(
        "The DXF file is damaged at line {line}: the coordinate with group code {code} of an "
        "object of the type {kind} belongs to a point, of which the other coordinate is missing.",
        "Export the drawing again.",
        line="count",
        code="count",
        kind="text",
    ),
    "dxf.cut-short": entry(
        "The DXF file is incomplete: it ends {where} in the section {section}, after {count:# "
        "entity (drawn object)|# entities (drawn objects)}. Objects of the drawing may be "
        "missing.",
        "Send the complete file, or export the drawing again.",
        where="message",
        section="text",
        count="count",
    ),
    "dxf.no-section": entry(
        "The file is not a DXF file, because it has no section.",
        "Export the drawing as DXF (text or binary, any version).",
    ),
    "dxf.not-a-group-code": entry(
        "The file is not a DXF file, because line {line} is {text!r} instead of a group code "
        "(a whole number).",
        "Export the drawing as DXF (text or binary, any version).",
        line="count",
        text="text",
    ),
    "dxf.not-a-number": entry(
        "The DXF file is damaged at line {line}: the value {text!r} of group code {code} of an "
        "object of the type {kind} is not a number.",
        "Export the drawing again, with a point as the decimal separator of numbers.",
        line="count",
        code="count",
        kind="text",
        text="text",
    ),
    "dxf.other-kind": entry(
        "The file has the format {kind}, not DXF.",
        "Export the drawing as DXF (text or binary, any version).",
        kind="text",
    ),
    "dxf.too-large-unusual": entry(
        "The DXF file has {size:.1f} MB and uses features that take long to read. The limit "
        "for such files is {limit:.1f} MB.",
        "Export a drawing with a single carton, or save it as DXF R2000.",
        size="number",
        limit="number",
    ),
    "dxf.without-end-mark": entry(
        "without the end marker EOF",
    ),
    "cf2.cut-short": entry(
        "The CF2 file is incomplete: it ends at line {line} inside {inside}. Objects of the "
        "drawing may be missing.",
        "Send the complete file, or export the drawing again as CF2.",
        line="count",
        inside="message",
    ),
    "cf2.decimal-commas": entry(
        "Line {line} of the CF2 file has {fields} fields instead of {expected} for the record "
        "{record}. The file seems to use decimal commas, but in CF2 files commas separate the "
        "fields.",
        "Export the drawing again with decimal points.",
        line="count",
        fields="count",
        record="text",
        expected="count",
    ),
    "cf2.empty": entry(
        "The CF2 file contains no drawing: it has neither a MAIN section nor a subroutine.",
        "Send the complete file, or export the drawing again as CF2.",
    ),
    "cf2.main": entry("the MAIN section"),
    "cf2.section": entry(
        "the section {name}",
        name="text",
    ),
    "cf2.subroutine": entry("the subroutine {name}", name="text"),
    "lightburn.doctype": entry(
        "The LightBurn project has a DOCTYPE, which LightBurn does not write.",
        "Save the project again in LightBurn.",
    ),
    "lightburn.empty": entry(
        "The LightBurn project contains no shape.",
        "Send the complete file, or save the project again in LightBurn.",
    ),
    "plt.bad-number": entry(
        "The plotter file (HPGL) is damaged at byte {position:,}: the values of the instruction "
        "{name} are not all numbers ({text!r}).",
        "Export the drawing again as HPGL, with a point as the decimal separator of numbers.",
        position="count",
        name="text",
        text="text",
    ),
    "plt.bad-polyline": entry(
        "The plotter file (HPGL) is damaged at byte {position:,}: the encoded polyline (PE) cannot "
        "be decoded.",
        "Export the drawing again as HPGL. If the file was sent as text, send it as binary data.",
        position="count",
    ),
    "plt.bad-scale": entry(
        "The plotter file (HPGL) is damaged at byte {position:,}: the instruction {name} states a "
        "scale of 0, or a type of scale that HPGL does not define.",
        "Export the drawing again as HPGL.",
        position="count",
        name="text",
    ),
    "plt.cut-short": entry(
        "The plotter file (HPGL) is incomplete: the instruction {name} at byte {position:,} has no "
        "end. Objects of the drawing may be missing.",
        "Send the complete file, or export the drawing again as HPGL.",
        position="count",
        name="text",
    ),
    "plt.damaged": entry(
        "The plotter file (HPGL) is damaged at byte {position:,}: {text!r} is not an instruction.",
        "Export the drawing again as HPGL. If the file was sent as text, send it as binary data.",
        position="count",
        text="text",
    ),
    "plt.empty": entry(
        "The plotter file (HPGL) contains no drawing: none of its instructions draws a line.",
        "Send the complete file, or export the drawing again as HPGL.",
    ),
    "plt.several-scales": entry(
        "The plotter file (HPGL) draws lines at several scales, and at least one of them depends "
        "on the plotter and its paper (SC without IP).",
        "Export the drawing again as HPGL in plotter units of 1/40 mm, or send it as DXF.",
    ),
    "plt.wrong-count": entry(
        "The plotter file (HPGL) is damaged at byte {position:,}: the instruction {name} has "
        "{count:# value|# values} instead of {expected:or}.",
        "Export the drawing again as HPGL.",
        position="count",
        name="text",
        count="count",
        expected="texts",
    ),
    "plt.x-without-y": entry(
        "The plotter file (HPGL) is damaged at byte {position:,}: the instruction {name} has "
        "{count:# value|# values}, so the last point has no y coordinate.",
        "Export the drawing again as HPGL.",
        position="count",
        name="text",
        count="count",
    ),
    "svg.empty": entry(
        "The SVG file contains no element.",
        "Export the drawing again as plain SVG.",
    ),
    "svg.external-entity": entry(
        "The DOCTYPE of the SVG has an entity {name!r} that refers to another file, which is "
        "not loaded.",
        "Save the drawing as plain SVG, without a DOCTYPE.",
        name="text",
    ),
    "svg.long-entity": entry(
        "The DOCTYPE of the SVG has an entity {name!r} of {length:,} characters, which is too "
        "long.",
        "Save the drawing as plain SVG, without a DOCTYPE.",
        name="text",
        length="count",
    ),
    "svg.markup-entity": entry(
        "The DOCTYPE of the SVG has an entity {name!r} that contains markup, which is not "
        "supported.",
        "Save the drawing as plain SVG, without a DOCTYPE.",
        name="text",
    ),
    "svg.other-xml": entry(
        "The file is an XML file, but not SVG: its outermost element is {element} instead of svg.",
        "Save the drawing as plain SVG.",
        element="text",
    ),
    "svg.packed-cut-short": entry(
        "The compressed SVG file (.svgz) is incomplete.",
        "Send the complete file, or export the drawing again as plain SVG.",
    ),
    "svg.packed-damaged": entry(
        "The compressed SVG file (.svgz) is damaged: {reason}.",
        "Export the drawing again as plain SVG.",
        reason="text",
    ),
    "svg.too-many-rules": entry(
        "The style sheet of the SVG file has {count:,} rules, but the limit is {limit:,}.",
        "Export the drawing with style attributes in each element instead of a style sheet.",
        count="count",
        limit="count",
    ),
    "svg.unpacks-too-far": entry(
        "The compressed SVG file (.svgz) is larger than {limit:.1f} MB when unpacked.",
        "Export a drawing with a single carton, without pictures.",
        limit="number",
    ),
    "pdf.blank": entry(
        "The page of the PDF contains no drawing.",
        "Export the drawing again, as the first page of the PDF.",
    ),
    "pdf.content-damaged": entry(
        "The content of {where} of the PDF is damaged: {reason}. Objects of the drawing may "
        "be missing.",
        "Export the drawing again, or send it as DXF.",
        where="message",
        reason="message",
    ),
    "pdf.cut-short": entry(
        "The PDF file is incomplete: its {bytes:,} bytes do not end with %%EOF. Objects of the "
        "drawing may be missing.",
        "Send the complete file, or export the drawing again.",
        bytes="count",
    ),
    "pdf.encrypted": entry(
        "The PDF is encrypted, so it cannot be read.",
        "Save the PDF without a password and without restrictions, then send it again.",
    ),
    "pdf.expands-too-far": entry(
        "The page of the PDF and its repeated forms expand to more than {limit:.1f} MB.",
        "Export a drawing with a single carton, without symbols that the carton does not need.",
        limit="number",
    ),
    "pdf.form": entry(
        "The PDF is a dynamic form (XFA), whose page contains no drawing.",
        "Print the drawing to a PDF, or send it as DXF.",
    ),
    "pdf.form-named": entry(
        "the form {name}",
        name="text",
    ),
    "pdf.illustrator-only": entry(
        "The Illustrator file was saved without PDF content, so its page contains no drawing.",
        "Save the file with the option 'Create PDF Compatible File', or as PDF.",
    ),
    "pdf.layers-too-deep": entry(
        "The layers of the PDF are nested more than {limit:,} levels deep.",
        "Export the drawing again with fewer nested layers.",
        limit="count",
    ),
    "pdf.nested-arrays": entry(
        "arrays are nested too deeply",
    ),
    "pdf.no-header": entry(
        "The file is not a PDF: it does not begin with %PDF.",
        "Export the drawing again, or send it as DXF.",
    ),
    "pdf.no-such-page": entry(
        "The PDF has {pages:# page|# pages}, but no page {page}.",
        "Choose one of its pages.",
        pages="count",
        page="count",
    ),
    "pdf.no-page": entry("The PDF has no page.", "Export the drawing again, or send it as DXF."),
    "pdf.open-array": entry(
        "an array has no closing bracket",
    ),
    "pdf.open-image": entry(
        "an embedded image is incomplete",
    ),
    "pdf.open-text": entry(
        "a text string has no closing parenthesis",
    ),
    "pdf.page": entry("the page"),
    "pdf.page-too-large": entry(
        "A side of the PDF page is {size:g} mm away from the origin of the page coordinates, but "
        "the limit is {limit:g} mm.",
        "Export the drawing in its true size.",
        size="number",
        limit="number",
    ),
    "pdf.part-missing": entry(
        "A part of the content of the PDF page is missing in the file. Objects of the drawing "
        "may be missing.",
        "Export the drawing again, or send it as DXF.",
    ),
    "pdf.stream-cut-short": entry(
        "A data stream of the PDF is incomplete. Objects of the drawing may be missing.",
        "Send the complete file, or export the drawing again.",
    ),
    "pdf.stream-damaged": entry(
        "A data stream of the PDF is damaged ({reason}). Objects of the drawing may be missing.",
        "Export the drawing again, or send it as DXF.",
        reason="text",
    ),
    "pdf.stream-too-large": entry(
        "A data stream of the PDF is larger than {limit:.1f} MB when unpacked.",
        "Export a single carton, without pictures.",
        limit="number",
    ),
    "pdf.too-many-states": entry(
        "The PDF saves more than {limit:,} graphics states (operator q) without restoring them.",
        "Export the drawing again from the program that drew it.",
        limit="count",
    ),
}
