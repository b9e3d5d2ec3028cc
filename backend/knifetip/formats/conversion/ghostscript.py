"""ghostscript: convert PostScript, EPS and old Illustrator files to PDF by Ghostscript.

Ghostscript is a separate program with a licence of its own (AGPL).  Its device ``pdfwrite`` keeps
paths, dashes, line widths, spot colours and their names.  PostScript has no layers.

Files in the format of Illustrator 3 to 8 that other programs write name the procedure sets of
Illustrator and do not contain them.  ``illustrator.ps`` defines their operators, also those of
layers.  Files by Illustrator contain the procedure sets, which ignore the names of layers; the
prelude adds the layers to their operators when the file defines them, and changes no program text.

``pdfwrite`` leaves out what is beside the page, and writes no width for lines of the width 0, which
then have the width of the line before.  So an EPS file is converted on a page far larger than its
bounding box, which becomes the visible area, and lines of the width 0 get a width of 0.001.

``-dSAFER`` permits access to the files of the command line, to Ghostscript's own files, and to all
files in the folder of temporary files.  So that folder contains nothing else.
"""

from __future__ import annotations

import re
from pathlib import Path
from typing import Final

from knifetip.errors import NotADrawing
from knifetip.formats.conversion.converter import Converter, Fault

#: First bytes of an EPS file with a preview; positions of the PostScript and its length follow.
_BINARY: Final = b"\xc5\xd0\xd3\xc6"
_SOURCE: Final = "drawing.ps"
_PRELUDE: Final = "prelude.ps"
_RESULT: Final = "drawing.pdf"

_NUMBER: Final = rb"([-+]?(?:\d+\.?\d*|\.\d+))"
_BOUNDING_BOX: Final = re.compile(
    rb"^%%BoundingBox:[ \t]*" + rb"[ \t]+".join([_NUMBER] * 4), re.MULTILINE
)
_EPS: Final = re.compile(rb"%!PS-Adobe[^\r\n]*EPSF")
#: Comments of files in the format of Illustrator, and the size of the beginning with them (bytes).
_ILLUSTRATOR: Final = re.compile(rb"^%AI\d|Adobe Illustrator|procset Adobe_", re.MULTILINE)
_HEAD: Final = 1 << 16
#: Marks near the end of a complete file, and an operator that ends one without such marks; the size
#: of the end in which they are (bytes).
_END: Final = re.compile(rb"%%EOF|%%Trailer|%AI9_PrivateDataEnd")
_TAIL: Final = 4096
_LAST: Final = re.compile(rb"\bshowpage\b")
_LAST_WITHIN: Final = 200
#: Size of a page, and how far it begins to the left of and below the bounding box (points).
_PAGE: Final = 14_400
_MARGIN: Final = 1000
#: Distance between the bounding box, which has whole numbers, and the visible area (points).
_BLEED: Final = 1.0

#: Lines of the width 0 are drawn as thin as possible.
_THIN: Final = b"/setlinewidth { dup abs 0.001 lt { pop 0.001 } if setlinewidth } bind def\n"
#: Operators of Illustrator.
_OPERATORS: Final = Path(__file__).with_name("illustrator.ps")
_ERROR: Final = re.compile(r"Error: /(\w+) in ([^\r\n]*)")
_POSITION: Final = re.compile(r"Current file position is (\d+)")
#: Number of characters of an error that are stated.
_REASON: Final = 80


def _prepare(data: bytes) -> dict[str, bytes]:
    """Return the files that Ghostscript reads.

    Raises ``NotADrawing``: the end of the PostScript is missing.
    """
    program = _postscript(data)
    if not _END.search(program[-_TAIL:]) and not _LAST.search(program[-_LAST_WITHIN:]):
        raise NotADrawing("reading.truncated", format="PostScript")
    prelude = _THIN
    if _ILLUSTRATOR.search(program[:_HEAD]):
        prelude += _OPERATORS.read_bytes()
    return {_PRELUDE: prelude, _SOURCE: _large_page(program) + program}


def _postscript(data: bytes) -> bytes:
    """Return the PostScript of a file, which may have a preview before or after it."""
    if not data.startswith(_BINARY):
        return data
    start, size = (int.from_bytes(data[at : at + 4], "little") for at in (4, 8))
    if start + size > len(data):
        raise NotADrawing("reading.truncated", format="EPS")
    return data[start : start + size]


def _large_page(program: bytes) -> bytes:
    """Return PostScript that makes the page of an EPS or Illustrator file larger, else b"".

    The bounding box of the file remains the visible area.
    """
    if not _EPS.match(program) and not _ILLUSTRATOR.search(program[:_HEAD]):
        return b""
    # It may be at the end of the file; the one at the beginning then has no numbers.
    found = _BOUNDING_BOX.search(program)
    left, low, right, high = map(float, found.groups()) if found else (0.0, 0.0, 0.0, 0.0)
    x, y = round(left) - _MARGIN, round(low) - _MARGIN
    page = (
        f"%!PS-Adobe-3.0 EPSF-3.0\n%%BoundingBox: {x} {y} {x + _PAGE} {y + _PAGE}\n%%EndComments\n"
    )
    visible = ""
    if left < right and low < high:
        box = (left - x - _BLEED, low - y - _BLEED, right - x + _BLEED, high - y + _BLEED)
        visible = f"[ /CropBox [{' '.join(map(repr, box))}] /PAGE pdfmark\n"
    return (page + visible).encode()


def _explain(log: str, data: bytes) -> Fault:
    """Return the error that Ghostscript has printed, and its position in the file."""
    error, position = _ERROR.search(log), _POSITION.search(log)
    reason = f"{error[1]}: {error[2].strip('- ')}"[:_REASON] if error else ""
    is_memory = error is not None and error[1] == "VMerror"
    if position is None:
        return Fault(reason, is_memory=is_memory)
    program = _postscript(data)
    before = len(_large_page(program)) - data.find(program)
    return Fault(reason, max(0, int(position[1]) - before), is_memory)


def _list_losses(_log: str) -> tuple[str, ...]:
    """Return no losses: Ghostscript ends with an error if it cannot execute a file."""
    return ()


GHOSTSCRIPT: Final = Converter(
    title="Ghostscript",
    program="gs",
    variable="KNIFETIP_GHOSTSCRIPT",
    # Older versions permit access to files by default.
    least=(9, 54),
    source=_SOURCE,
    result=_RESULT,
    yields="pdf",
    arguments=(
        "-q",
        "-dSAFER",
        "-dBATCH",
        "-dNOPAUSE",
        "-P-",
        "-sDEVICE=pdfwrite",
        "-dEPSCrop",
        f"-dDEVICEWIDTHPOINTS={_PAGE}",
        f"-dDEVICEHEIGHTPOINTS={_PAGE}",
        "-dAutoRotatePages=/None",
        "-sColorConversionStrategy=LeaveColorUnchanged",
        # Without times and random numbers, the same file always gives the same result.
        "-dOmitInfoDate=true",
        "-dOmitID=true",
        "-dOmitXMP=true",
        f"-sOutputFile={_RESULT}",
        "-f",
        _PRELUDE,
        _SOURCE,
    ),
    prepare=_prepare,
    explain=_explain,
    list_losses=_list_losses,
)
