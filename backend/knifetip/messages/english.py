"""english: the text of every message, and its hint where the user can do something.

Texts state what is wrong and where; hints state what to do.  ``render`` lists the formats.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

#: Units of length, as they are named in a sentence; no unit is that of the file.
UNITS: Final[Mapping[str, str]] = {
    "": "units of the file",
    "mm": "mm",
    "cm": "cm",
    "m": "metres",
    "in": "inches",
    "ft": "feet",
    "pt": "points",
    "px": "pixels",
}

TEXTS: Final[Mapping[str, str]] = {
    "stored.text": "{text}",
    # Questions
    "question.unit": "{reason} The drawing's size would be {sizes:, }.{evidence}",
    "question.unit-size": "{width:mm} × {height:mm} mm in {unit:unit}",
    "question.unit-evidence": " Strongest evidence for {unit:unit}: {evidence:; }.",
    "question.unit-doubtful": "The file states {stated:unit} as its unit, but the drawing could "
    "also be in {other:unit}.",
    "question.unit-contradicted": "The file states {stated:unit} as its unit, but the drawing "
    "does not look like it.",
    "question.unit-not-stated": "The file does not state its unit.",
    "question.unit-unreadable": "The file does not state a unit of length that is supported "
    "({evidence}).",
    "question.line-type": '{edges:# edge|# edges} on layer "{layer}", colour {colour}, linetype '
    "{linetype}, total length {length:,.1f} {unit:unit}, in a box of {width:,.1f} × {height:,.1f} "
    "{unit:unit} at ({x:,.1f}, {y:,.1f}): what {edges:is it|are they}?{guess}",
    "question.guess": " Most likely {type} ({percent} %): {reason}.",
    "question.shape": " Shape: {reason}.",
    "question.tool": "{machine} has no tool for {type} ({edges:# edge|# edges}). Which line type "
    "should they get?",
}

HINTS: Final[Mapping[str, str]] = {
    "stored.text": "{hint}",
}
