"""writers: programs whose DXF files are in mm, recognised by a comment or by their header.

Sources, by program:

- pstoedit: the output of ``-f dxf:-mm`` for two drawings of known size, one of them by boxes.py,
  which passes this option.  The header has five variables; its extent is a page of 3000 pt,
  converted to mm.
- Inkscape, "Desktop Cutting Plotter": the extension multiplied all coordinates by 25.4/90, the
  length of its pixels in mm, while it wrote the comment.  Later versions write no comment but the
  unit that they use, in a header of three variables.
- knifetip: cartons of standard styles and test pieces (``samples.write``), which may be as small as
  drawings in cm.
- OpenSCAD: lengths have no unit, but its SVG export states them as mm.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from typing import Final

from knifetip.messages import Message
from knifetip.model.unit import UnitHint

#: Number of bytes in which a program writes its name in a comment.
_HEAD: Final = 512
#: Comment of our own files.
OWN_COMMENT: Final = "DXF by knifetip, lengths in mm"
#: Comments before the first section, the name of the program, and the kind of the hint.
_COMMENTS: Final = (
    (re.compile(rb"\A\s*999[ \t]*\r?\nDXF created by Inkscape\b"), "Inkscape", "written in mm"),
    (re.compile(rb"\A\s*999[ \t]*\r?\nDXF from OpenSCAD\b"), "OpenSCAD", "modelled in mm"),
    (re.compile(rb"\A\s*999[ \t]*\r?\nDXF by knifetip\b"), "knifetip", "written in mm"),
)
#: Variables in the header of a file by pstoedit, and its extent: 3000 pt (mm), in 6 digits.
_PSTOEDIT: Final = frozenset({"$ACADVER", "$FILLMODE", "$SPLFRAME", "$EXTMIN", "$EXTMAX"})
_PSTOEDIT_PAGE: Final = 3000.0 * 25.4 / 72.0
_PSTOEDIT_DIGITS: Final = 0.005
#: Header of a file by Inkscape that states mm.
_INKSCAPE: Final = {"$INSUNITS": "4", "$ACADVER": "AC1014", "$HANDSEED": "FFFF"}


def writer_hints(data: bytes, variables: Mapping[str, str]) -> tuple[UnitHint, ...]:
    """Return evidence for mm from the program that wrote a DXF file.

    Parameters
    ----------
    data
        Content of the file, in whose first bytes programs write a comment.
    variables
        First values of the header variables by name.
    """
    for comment, name, kind in _COMMENTS:
        if comment.match(data[:_HEAD]):
            return (UnitHint(kind, Message("unit.writer", writer=name)),)
    if variables == _INKSCAPE:
        return (UnitHint("written in mm", Message("unit.writer", writer="Inkscape")),)
    if variables.keys() == _PSTOEDIT and _is_page_in_mm(variables["$EXTMAX"]):
        return (UnitHint("written in mm", Message("unit.writer", writer="pstoedit")),)
    return ()


def _is_page_in_mm(extent: str) -> bool:
    """Return whether a value of the header is the page of pstoedit, converted to mm."""
    try:
        return math.isclose(float(extent), _PSTOEDIT_PAGE, abs_tol=_PSTOEDIT_DIGITS, rel_tol=0.0)
    except ValueError:
        return False
