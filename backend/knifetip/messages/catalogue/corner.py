"""corner: corner types, and the deflection of a cutter and its calibration."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "corner.at": entry(" at ({x:g}, {y:g})", x="number", y="number"),
    "corner.bad-interference": entry(
        "{interference!r} is not a way to handle places where the cutter does not fit.",
        "Choose trim or refuse.",
        interference="text",
    ),
    "corner.bad-k": entry(
        "The corner parameter k at the corner where edge {edge} begins is {k}.",
        "Give a k from 0 (as B) to 1 (as C).",
        edge="count",
        k="text",
    ),
    "corner.bad-k-at": entry(
        "The corner parameter k{where} is {k}; a D corner needs one between 0 and 1.",
        "Choose B instead of 0, and C instead of 1.",
        where="message?",
        k="text",
    ),
    "corner.bad-place": entry(
        "The corner at ({x}, {y}) has no valid position.",
        "Give X and Y in the drawing's millimetres.",
        x="text",
        y="text",
    ),
    "corner.bad-share": entry(
        "Corner {corner} is of type D with k = {k}.",
        "Give a k from 0 (as B) to 1 (as C).",
        corner="count",
        k="text",
    ),
    "corner.inside": entry(
        "The corner at ({x:g}, {y:g}) is an inside corner, which the cutter passes in one way "
        "only.",
        "Choose types for outside corners.",
        x="number",
        y="number",
    ),
    "corner.no-contour": entry(
        "No corner of a milled contour is within {within:g} mm of ({x:g}, {y:g}).",
        "This drawing has no contour that the cutter mills round corners.",
        within="number",
        x="number",
        y="number",
    ),
    "corner.no-cutter": entry(
        "Corner types were chosen, and {machine} has no rotating cutter.",
        "Leave the corner types out, or choose a machine that mills.",
        machine="text",
    ),
    "corner.not-found": entry(
        "No corner of a milled contour is within {within:g} mm of ({x:g}, {y:g}): the nearest is "
        "{distance:.2f} mm away.",
        "Give its X and Y in the drawing's millimetres: the nearest are {known:, }.",
        within="number",
        x="number",
        y="number",
        distance="number",
        known="texts",
    ),
    "corner.unknown-number": entry(
        "Corner {corner} has the type {type}, which does not exist.",
        "Give B, C or D.",
        corner="count",
        type="count",
    ),
    "corner.unknown-type": entry(
        "There is no corner type {type!r}.",
        "The types are B, C, D and auto.",
        type="text",
    ),
    "corner.unknown-type-at": entry(
        "There is no corner type {type!r}{where}.",
        "The types are B, C, D and auto.",
        type="text",
        where="message?",
    ),
    "deflection.arc-too-small": entry(
        "The cutter's centre follows an arc of {radius:.3f} mm radius near ({x:.2f}, {y:.2f}), "
        "and the tool gives way by {deflection:.3f} mm.",
        "Choose a smaller k or the B type, or measure the deflection again.",
        radius="number",
        x="number",
        y="number",
        deflection="number",
    ),
    "deflection.path-too-short": entry(
        "Near ({x:.2f}, {y:.2f}) the path of the cutter's centre is too short, or turns too "
        "sharply, to correct for the deflection.",
        "Join short edges there, or measure the deflection again.",
        x="number",
        y="number",
    ),
    "calibration.bad-points": entry(
        "The {count} measured points contain a value that is not a number, or there are none.",
        "Measure at least one point on a slanted part of the contour.",
        count="count",
    ),
    "calibration.choose-cutter": entry(
        "{machine} has {count:# cutter|# cutters}.",
        "Choose one: {cutters:, }.",
        machine="text",
        count="count",
        cutters="texts",
    ),
    "calibration.missing-column": entry(
        "{file}, line {line}: {columns} is missing.",
        "Its first line must be azimuth,dx,dy; then degrees and mm follow, for example "
        "45,-0.05,0.06.",
        file="text",
        line="count",
        columns="text",
    ),
    "calibration.not-a-number": entry(
        "{file}, line {line}: {reason}.",
        "Write numbers with a decimal point.",
        file="text",
        line="count",
        reason="text",
    ),
    "calibration.not-csv": entry(
        "{file} is not a CSV file: {reason}.",
        "Save it as CSV in UTF-8.",
        file="text",
        reason="text",
    ),
    "calibration.undetermined": entry(
        "The contour runs along {along} at every measured point, so {other} is not determined "
        "(the sum of squares is {weight:.4f}; {least} is needed).",
        "Measure one more point where the contour runs along {direction}, or at 45°.",
        along="text",
        other="text",
        weight="number",
        least="number",
        direction="text",
    ),
    "calibration.wrong-sign": entry(
        "By the measured points the tool is drawn into the board (δx {x:.3f}, δy {y:.3f} mm).",
        "Check the signs of ΔX and ΔY, and the side on which the tool runs.",
        x="number",
        y="number",
    ),
}
