"""unit: messages about the evidence for the unit of length of a drawing, and warnings about it."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "unit.cf2-inches": entry(
        "the CF2 file states inches (record UI)",
    ),
    "unit.cf2-millimetres": entry(
        "the CF2 file states millimetres (record UM)",
    ),
    "unit.cf2-none": entry(
        "the CF2 file states no unit: it has neither a UM nor a UI record",
    ),
    "unit.cf2-scale-applied": entry(
        "the coordinates in the CF2 file were multiplied by the factors in the record "
        "SCALE,{x:g},{y:g}, so that the drawing has the size in the records LL and UR",
        x="number",
        y="number",
    ),
    "unit.cf2-scale-invalid": entry(
        "the factors in the record SCALE,{x:g},{y:g} of the CF2 file are invalid, so the "
        "record was ignored",
        x="number",
        y="number",
    ),
    "unit.cf2-scale-not-applied": entry(
        "the record SCALE,{x:g},{y:g} of the CF2 file was ignored, because the coordinates "
        "already have the size in the records LL and UR",
        x="number",
        y="number",
    ),
    "unit.cf2-scale-undecided": entry(
        "the record SCALE,{x:g},{y:g} of the CF2 file was ignored, because the records LL and "
        "UR do not show whether the coordinates are already scaled",
        x="number",
        y="number",
    ),
    "unit.cf2-scaled": entry("{unit}; {scale}", unit="message", scale="message"),
    "unit.corner-loops": entry(
        "if the unit is {unit:unit}, the outlines have small loops of {length:mm} mm at {count} "
        "corners, as programs for laser cutters draw them",
        unit="text",
        count="count",
        length="number",
    ),
    "unit.dimensions-larger": entry(
        "Dimensions in the drawing have different scales: {count:# dimension is|# dimensions "
        "are} drawn {factor:.3g} times larger than the other {others:dimension|# dimensions}.",
        "Check which dimensions belong to the carton, and delete details that are drawn at "
        "another scale.",
        count="count",
        others="count",
        factor="number",
    ),
    "unit.dimensions-smaller": entry(
        "Dimensions in the drawing have different scales: {count:# dimension is|# dimensions "
        "are} drawn {factor:.3g} times smaller than the other {others:dimension|# dimensions}.",
        "Check which dimensions belong to the carton, and delete details that are drawn at "
        "another scale.",
        count="count",
        others="count",
        factor="number",
    ),
    "unit.drawn-in-imperial": entry(
        "inches (stored as numbers in {unit:unit})",
        unit="text",
    ),
    "unit.drawn-in-inches": entry(
        "inches",
    ),
    "unit.drawn-in-metric": entry(
        "millimetres (stored as numbers in {unit:unit})",
        unit="text",
    ),
    "unit.drawn-in-millimetres": entry("millimetres"),
    "unit.given": entry(
        "the user set the unit of the drawing",
    ),
    "unit.header": entry(
        "the header of the DXF file states the unit of the drawing ($INSUNITS = {value})",
        value="count",
    ),
    "unit.header-decimal-inches": entry(
        "the header of the DXF file displays lengths in feet and decimal inches ($LUNITS = 3)",
    ),
    "unit.header-factor": entry(
        "the header of the DXF file multiplies the displayed dimensions by {factor:g} ({variable})",
        variable="text",
        factor="number",
    ),
    "unit.header-fractions": entry(
        "the header of the DXF file displays lengths in feet and fractions of inches ($LUNITS = 4)",
    ),
    "unit.header-imperial": entry(
        "the header of the DXF file sets imperial units ($MEASUREMENT = 0)",
    ),
    "unit.header-metric": entry(
        "the header of the DXF file sets metric units ($MEASUREMENT = 1)",
    ),
    "unit.header-missing": entry(
        "the DXF file states no unit ($INSUNITS is missing)",
    ),
    "unit.header-not-a-number": entry(
        "the header of the DXF file states no valid unit: $INSUNITS = {value!r} is not a number",
        value="text",
    ),
    "unit.header-undefined": entry(
        "the header of the DXF file states no valid unit: $INSUNITS = {value} is not defined",
        value="count",
    ),
    "unit.header-unitless": entry(
        "the header of the DXF file states that the drawing has no unit ($INSUNITS = 0)",
    ),
    "unit.header-unsupported": entry(
        "the header of the DXF file states a unit that is not supported: {name:unit} "
        "($INSUNITS = {value})",
        value="count",
        name="text",
    ),
    "unit.imprecise": entry(
        "if the unit is {unit:unit}, the lengths of the edges are too imprecise to show "
        "whether they are multiples of a round number",
        unit="text",
    ),
    "unit.inconclusive": entry(
        "{stated}, and the geometry of the drawing does not give enough evidence for {unit:unit}",
        stated="message",
        unit="text",
    ),
    "unit.lightburn": entry(
        "LightBurn projects state all lengths in millimetres",
    ),
    "unit.multiples": entry(
        "if the unit is {unit:unit}, {count} of {all} different edge lengths ({percent:.0f} % "
        "of the total length) {count:is a multiple|are multiples} of {grid}",
        unit="text",
        count="count",
        all="count",
        percent="number",
        grid="text",
    ),
    "unit.no-number-matches": entry(
        "if the unit is {unit:unit}, no edge has a length that matches {all:the number|one of "
        "the # numbers} in the texts of the drawing",
        unit="text",
        all="count",
    ),
    "unit.not-given": entry(
        "the unit of the drawing is not known",
    ),
    "unit.of-layout": entry(
        "a layout is in millimetres",
    ),
    "unit.number": entry("{text}", text="text"),
    "unit.number-in": entry("{text} ({unit:unit})", text="text", unit="text"),
    "unit.numbers-match": entry(
        "if the unit is {unit:unit}, {count} of {all} numbers in the texts of the drawing "
        "{count:equals|equal} the length of an edge: {numbers:, }",
        unit="text",
        count="count",
        all="count",
        numbers="messages",
    ),
    "unit.numbers-match-often": entry(
        "if the unit is {unit:unit}, {count} of {all} numbers in the texts of the drawing "
        "equal the length of an edge, for example {numbers:, }",
        unit="text",
        count="count",
        all="count",
        numbers="messages",
    ),
    "unit.overruled": entry(
        "{stated}, but the unit of the drawing is more likely {unit:unit}, because {reason}",
        stated="message",
        unit="text",
        reason="message",
    ),
    "unit.page-in-pixels": entry(
        "the file states the size of its page without a unit, as files in pixels or points do",
    ),
    "unit.paper-size": entry(
        "if the unit is {unit:unit}, the drawing has exactly the size of a sheet of paper "
        "({sheet})",
        unit="text",
        sheet="text",
    ),
    "unit.part-drawn-twice": entry(
        "The drawing contains the same part at two sizes, one of them {factor:.3g} times "
        "larger than the other. One of the two parts is a detail, or was inserted with a wrong "
        "unit.",
        "Delete the part with the wrong size, or set the line type of its edges to ignored.",
        factor="number",
    ),
    "unit.parts-differ": entry(
        "Parts of the drawing have different units: one part is drawn in {one}, another part in "
        "{other}.",
        "Scale one of the parts in the CAD program and export the drawing again.",
        one="message",
        other="message",
    ),
    "unit.pdf": entry(
        "the PDF states its coordinates in points (1/72 inch)",
    ),
    "unit.pdf-scaled": entry(
        "the PDF states its coordinates in units of {scale:g} points (UserUnit); one point is "
        "1/72 inch",
        scale="number",
    ),
    "unit.plotter": entry(
        "the plotter file (HPGL) states its coordinates in units of 1/40 mm, or states their scale",
    ),
    "unit.plotter-page": entry(
        "the plotter file (HPGL) states the scale of its coordinates relative to the paper of the "
        "plotter (SC without IP), and the size of the paper is not known",
    ),
    "unit.read-against-evidence": entry(
        "The unit of the drawing is most likely {best:unit} ({best_width:mm} × "
        "{best_height:mm} mm), but the drawing was imported with the unit {unit:unit} "
        "({width:mm} × {height:mm} mm).",
        "Check the size of the drawing, and choose another unit if the size is wrong.",
        best="text",
        best_width="number",
        best_height="number",
        unit="text",
        width="number",
        height="number",
    ),
    "unit.read-against-header": entry(
        "The file states the unit {stated:unit} ({stated_width:mm} × {stated_height:mm} mm), "
        "but the drawing was imported with the unit {unit:unit} ({width:mm} × {height:mm} mm).",
        "Check the size of the drawing, and choose another unit if the size is wrong.",
        stated="text",
        stated_width="number",
        stated_height="number",
        unit="text",
        width="number",
        height="number",
    ),
    "unit.scale-mentioned": entry(
        "A text in the drawing mentions the scale {scales:, }, so the drawing may not have its "
        "true size.",
        "Check the size of the drawing.",
        scales="texts",
    ),
    "unit.share-stated": entry(
        "the file states the unit {stated:unit}, and knifetip assumes that {percent:.3g} % of "
        "the files that state this unit are drawn in {unit:unit}",
        stated="text",
        unit="text",
        percent="number",
    ),
    "unit.share-unstated": entry(
        "the file states no unit, and knifetip assumes that {percent:.3g} % of the files "
        "without a stated unit are drawn in {unit:unit}",
        unit="text",
        percent="number",
    ),
    "unit.shortest-edges": entry(
        "if the unit is {unit:unit}, the shortest edges of the drawing are {length:mm} mm long",
        unit="text",
        length="number",
    ),
    "unit.size-unusual": entry(
        "if the unit is {unit:unit}, the drawing measures {width:mm} × {height:mm} mm, which "
        "is an unusual size for a carton",
        unit="text",
        width="number",
        height="number",
    ),
    "unit.size-usual": entry(
        "if the unit is {unit:unit}, the drawing measures {width:mm} × {height:mm} mm, which "
        "is a usual size for a carton",
        unit="text",
        width="number",
        height="number",
    ),
    "unit.svg-no-size": entry(
        "the SVG file has no width and no height, and {pixel}",
        pixel="message",
    ),
    "unit.svg-no-unit": entry(
        "the SVG file states its size without a unit of length ({size: }), and {pixel}",
        size="texts",
        pixel="message",
    ),
    "unit.svg-pixel": entry(
        "one coordinate unit is 1/96 inch (0.2646 mm) in a browser, but 1/72 inch (0.3528 mm) in "
        "Illustrator, and 1/90 inch (0.2822 mm) in old versions of Inkscape",
    ),
    "unit.svg-size": entry(
        "the SVG file states its size ({size: }) for a viewBox of {width:g} × {height:g} "
        "coordinate units",
        size="texts",
        width="number",
        height="number",
    ),
    "unit.svg-size-in-pixels": entry(
        "the SVG file states its size ({size: }) and has no viewBox, so coordinates are in "
        "{pixel:unit}",
        size="texts",
        pixel="text",
    ),
    "unit.svg-writer": entry(
        "the program that wrote the SVG file uses {pixel:unit} as the unit",
        pixel="text",
    ),
    "unit.text-states": entry(
        "a text in the drawing states the unit: “{text}”",
        text="text",
    ),
    "unit.unsupported": entry(
        "{unit!r} is not a supported unit of length.",
        "Choose one of {known:or}.",
        unit="text",
        known="texts",
    ),
    "unit.writer": entry(
        "the file was written by {writer}, which writes lengths in mm",
        writer="text",
    ),
}
