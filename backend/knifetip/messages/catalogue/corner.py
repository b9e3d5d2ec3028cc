"""corner: messages about corner types, and about the deflection of a cutter and its calibration."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "corner.bad-k": entry(
        "The parameter k of the corner at the start of edge {edge} is {k}, but must be between "
        "0 and 1.",
        "Choose a k from 0 (the path of corner type B) to 1 (the path of corner type C).",
        edge="edge",
        k="text",
    ),
    "corner.bad-share": entry(
        "Corner {corner} in the list of corners (the first corner has number 0) has type D with "
        "the parameter k = {k}, which must be between 0 and 1.",
        "Choose a k from 0 (the path of corner type B) to 1 (the path of corner type C).",
        corner="count",
        k="text",
    ),
    "corner.inside": entry(
        "The corner at X {x:g} mm, Y {y:g} mm is an inside corner, but corner types apply only "
        "to outside corners.",
        "Remove the corner type of this corner from the request.",
        x="number",
        y="number",
    ),
    "corner.no-contour": entry(
        "No corner type can be set at X {x:g} mm, Y {y:g} mm (searched within {within:g} mm), "
        "because the drawing has no contour whose outside corners are milled.",
        "Remove the corner types from the request for this drawing.",
        within="number",
        x="number",
        y="number",
    ),
    "corner.no-cutter": entry(
        "Corner types were chosen, but {machine} has no rotating cutter.",
        "Remove the corner types from the request, or choose a machine with a rotating cutter.",
        machine="text",
    ),
    "corner.not-found": entry(
        "No corner of a milled contour lies within {within:g} mm of X {x:g} mm, Y {y:g} mm. "
        "The nearest corner is {distance:.2f} mm away.",
        "Give X and Y of a corner in mm, in the coordinates of the drawing. The nearest "
        "corners are {known:, }.",
        within="number",
        x="number",
        y="number",
        distance="number",
        known="texts",
    ),
    "corner.replaced": entry(
        "{count:# corner has|# corners have} type B instead of {type}, because the path of the "
        "cutter in type {type} would cross another path or come too near to another edge. "
        "X and Y on the sheet in mm ({count:one corner|the first corners}): {places:; }.",
        "Choose corner type B for {count:this corner|these corners}, or a cutter with a smaller "
        "diameter.",
        count="count",
        type="text",
        places="texts",
    ),
    "corner.unknown-number": entry(
        "Corner {corner} in the list of corners (the first corner has number 0) has the corner "
        "type {type}, which does not exist.",
        "Choose corner type B, C or D.",
        corner="count",
        type="count",
    ),
    "corner.unknown-type": entry(
        "The corner type {type!r} does not exist.",
        "Choose corner type B, C, D or auto.",
        type="text",
    ),
    "deflection.exceeds-radius": entry(
        "The deflection of {deflection:.3f} mm cannot be corrected, because it is not smaller than "
        "the cutter's radius of {radius:.3f} mm.",
        "Measure the deflection of the cutter again, or correct it in the board file.",
        radius="number",
        deflection="number",
    ),
    "calibration.bad-points": entry(
        "The {count:# measured point|# measured points} of the test cut cannot be used. At least "
        "one point is needed, and each value must be a finite number.",
        "Measure at least one point on a slanted part of the contour of the test cut.",
        count="count",
    ),
    "calibration.choose-cutter": entry(
        "{machine} has {count:# cutter|# cutters}, so the cutter to calibrate must be named.",
        "Choose one of {cutters:, }.",
        machine="text",
        count="count",
        cutters="texts",
    ),
    "calibration.missing-column": entry(
        "Line {line} of {file} has no value for {columns:or}.",
        "Write the heading azimuth,dx,dy on the first line. Write three numbers, in degrees, "
        "mm and mm, on each other line, for example 45,-0.05,0.06.",
        file="text",
        line="count",
        columns="texts",
    ),
    "calibration.not-a-number": entry(
        "Line {line} of {file} has a value that is not a number: {values:, }.",
        "Write three numbers with decimal points, for example 45,-0.05,0.06.",
        file="text",
        line="count",
        values="texts",
    ),
    "calibration.not-csv": entry(
        "{file} is not a CSV file: {reason}.",
        "Save the file as CSV in UTF-8.",
        file="text",
        reason="text",
    ),
    "calibration.undetermined": entry(
        "At every measured point the contour runs nearly along {along}, so the deflection "
        "of the cutter in {along} ({other}) cannot be determined. The sum of sin² of the angles "
        "between the contour and the {along} axis is {weight:.4f}, but must be at least {least}.",
        "Measure one more point where the contour runs along {direction}, or at 45°.",
        along="text",
        other="text",
        weight="number",
        least="number",
        direction="text",
    ),
    "calibration.wrong-sign": entry(
        "The measured points give a deflection of {x:.3f} mm in X and {y:.3f} mm in Y. A "
        "negative value means that the cutter moves towards the contour, although the board "
        "normally pushes it away from the contour, so a sign or the side is probably wrong.",
        "Check the signs of dx and dy, and check on which side of the contour the tool moves.",
        x="number",
        y="number",
    ),
}
