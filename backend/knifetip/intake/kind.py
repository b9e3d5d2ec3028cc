"""kind: what a file is, by its content and never by its name.

    bytes -> "dxf", "cf2", "svg" or "pdf", or NotADrawing: what it is instead, and what to send

Only the beginning is looked at.  What is nothing that is known goes to the reader of DXF, which
says where it stops being one.
"""

from __future__ import annotations

import re
import zlib
from typing import Final

from knifetip.errors import NotADrawing

#: How much of the beginning is looked at, and how far a root element may be from it.
_HEAD: Final = 4096
_ROOT_WITHIN: Final = 1 << 18

_SEND: Final = "Send the drawing as DXF (text or binary, any version), CF2, SVG or PDF."

#: First bytes of files that people send instead, and what they are.
_STRANGERS: Final = (
    (b"\x89PNG", "a PNG picture"),
    (b"\xff\xd8\xff", "a JPEG picture"),
    (b"GIF8", "a GIF picture"),
    (b"BM", "a BMP picture"),
    (b"II*\x00", "a TIFF picture"),
    (b"MM\x00*", "a TIFF picture"),
    (b"RIFF", "a picture or a film (RIFF)"),
    (b"%!PS", "a PostScript or an Illustrator file"),
    (b"\xc5\xd0\xd3\xc6", "an EPS file"),
    (b"PK\x03\x04", "a ZIP archive (or an Office or a 3MF file, which are such)"),
    (b"Rar!", "a RAR archive"),
    (b"7z\xbc\xaf", "a 7z archive"),
    (b"AC10", "a DWG drawing"),
    (b"AC1.", "an old DWG drawing"),
    (b"\xd0\xcf\x11\xe0", "an old Office file, or a CAD file that is built like one"),
    (b"ISO-10303-21", "a STEP file"),
    (b"solid ", "an STL model"),
    (b"{", "a JSON file"),
)

_XML: Final = re.compile(rb"<(?![?!])\s*([^\s>/]+)")
_ASIDE: Final = re.compile(rb"<!--.*?-->|<\?.*?\?>|<!DOCTYPE[^\[>]*(?:\[.*?\]\s*)?>", re.DOTALL)
#: The first words of a CF2 whose $BOF got lost; no line of a DXF can be one of them.
_CF2: Final = re.compile(
    rb"\s*(?:\$BOF\b|V2\s*[\r\n]+\s*ORDER\b|ORDER\s*[\r\n]|MAIN\s*,|SUB\s*,|"
    rb"[LA]\s*,\s*[\d.]+\s*,\s*\d+\s*,\s*\d+\s*,\s*[-+\d.])",
    re.IGNORECASE,
)
_GZIP: Final = b"\x1f\x8b"


def kind_of(data: bytes) -> str:
    """Return which reader a file is for: "dxf", "cf2", "svg" or "pdf".

    Raises
    ------
    NotADrawing
        It is something else that is known, or empty.
    """
    head = data[:_HEAD]
    if head[:2] in (b"\xff\xfe", b"\xfe\xff"):
        head = data[: 4 * _HEAD].decode("utf-16", "ignore").encode()
    head = head.removeprefix(b"\xef\xbb\xbf").lstrip(b" \t\r\n\x00")
    if not head:
        raise NotADrawing("The file is empty.", _SEND)
    if head.startswith(_GZIP):
        return _packed(data)
    if head.startswith(b"<"):
        return _marked_up(data)
    if head.startswith(b"%PDF"):
        return "pdf"
    if _CF2.match(head):
        return "cf2"
    for start, what in _STRANGERS:
        if head.startswith(start):
            raise NotADrawing(f"The file is {what}, not a drawing that can be read.", _SEND)
    return "dxf"


def _packed(data: bytes) -> str:
    """Look into a gzip: an SVG may be packed (.svgz), nothing else."""
    try:
        inside = zlib.decompressobj(31).decompress(data, _HEAD)
    except zlib.error:
        inside = b""
    if not inside.removeprefix(b"\xef\xbb\xbf").lstrip().startswith(b"<"):
        raise NotADrawing("The file is a gzip archive, not a drawing that can be read.", _SEND)
    return "svg"


def _marked_up(data: bytes) -> str:
    """Return "svg" if the outermost element of an XML is."""
    begin = data[:_ROOT_WITHIN]
    if begin[:2] in (b"\xff\xfe", b"\xfe\xff"):
        begin = begin.decode("utf-16", "ignore").encode()
    found = _XML.search(_ASIDE.sub(b"", begin))
    if found is None:
        # No element so far: the reader of SVG says where it stops.
        return "svg"
    root = found[1].decode("utf-8", "replace")
    if root.rpartition(":")[2].lower() == "svg":
        return "svg"
    what = "an HTML page" if root.lower() in ("html", "body") else f"XML of the kind {root[:40]!r}"
    raise NotADrawing(f"The file is {what}, not a drawing that can be read.", _SEND)
