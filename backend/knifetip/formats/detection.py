"""Detect the format of a file by its first bytes; the file name is not used."""

from __future__ import annotations

import re
import zlib
from dataclasses import dataclass
from typing import Final

from knifetip.messages import Message

#: Number of bytes that are examined, and the range in which an XML root element must begin.
_HEAD: Final = 4096
_ROOT_WITHIN: Final = 1 << 18

#: First bytes of other file formats, and the codes of their names.
_FOREIGN: Final = (
    (b"\x89PNG", "file.png"),
    (b"\xff\xd8\xff", "file.jpeg"),
    (b"GIF8", "file.gif"),
    (b"BM", "file.bmp"),
    (b"II*\x00", "file.tiff"),
    (b"MM\x00*", "file.tiff"),
    (b"RIFF", "file.riff"),
    (b"\xc5\xd0\xd3\xc6", "file.eps"),
    (b"Rar!", "file.rar"),
    (b"7z\xbc\xaf", "file.7z"),
    (b"AC10", "file.dwg"),
    (b"AC1.", "file.old-dwg"),
    (b"\xd0\xcf\x11\xe0", "file.compound-file"),
    (b"ISO-10303-21", "file.step"),
    (b"solid ", "file.stl"),
    (b"{", "file.json"),
    (b"8BPS", "file.photoshop"),
    (b"3D Geometry File Format", "file.rhino"),
    (b"\xffKA", "file.affinity"),  # without the null byte before it
    (b"\x06\x06\xed\xf5\xd8\x1d\x46\xe5", "file.indesign"),
    (b"\xd7\xcd\xc6\x9a", "file.metafile"),
    (b"(DWF V", "file.dwf"),
    (b"silhouette05", "file.silhouette"),
    ("\u0effSketchUp".encode(), "file.sketchup"),
)

#: Other file formats by patterns at their beginning; the first one that matches names the format.
_FOREIGN_PATTERNS: Final = (
    (re.compile(rb"RIFF.{4}C(?:DR|MX)", re.DOTALL), "file.cdr"),
    (re.compile(rb"PK\x03\x04.{26}mimetypeapplication/x-vnd\.corel", re.DOTALL), "file.cdr"),
    (re.compile(rb"%!PS-Adobe[^\r\n]*EPSF"), "file.eps"),
    (re.compile(rb"%!PS.*?%%Creator: *Adobe Illustrator", re.DOTALL), "file.illustrator"),
    (re.compile(rb"%!PS"), "file.postscript"),
    (re.compile(rb"\x1b[E%]"), "file.printer"),
    (re.compile(rb"DDES\s*\d?\s*[\r\n]", re.IGNORECASE), "file.ddes"),
    (re.compile(rb";\s*:"), "file.dmpl"),
    (re.compile(rb"\x01\x00\x00\x00.{36} EMF", re.DOTALL), "file.metafile"),
    (re.compile(rb".{72}S {0,6}0{0,6}1[\r\n]"), "file.iges"),
    # Comments and a program number may precede the first instruction of a machine.
    (re.compile(rb"(?:[%\s]|[;(][^\r\n]*[\r\n]|[O:]\d+\s)*(?:N\d+ *)?G\d{1,2}\b"), "file.gcode"),
    # A binary file; the name of the program alone may be a comment in a DXF.
    (
        re.compile(rb"(?!AutoCAD Binary DXF)(?=[^\x00]*\x00).*?ArtiosCAD", re.DOTALL),
        "file.ard",
    ),
)

_ZIP: Final = b"PK\x03\x04"
#: Kinds of ZIP archives by a part of the names in them, which are at the beginning and at the end.
_ZIPPED: Final = (
    (b"content/riffData.cdr", "file.cdr"),
    (b".fdseq", "file.xps"),
    (b"dwf/documents/", "file.dwf"),
    (b"3D/3dmodel.model", "file.3mf"),
    (b"word/document.xml", "file.office"),
    (b"ppt/presentation.xml", "file.office"),
    (b"xl/workbook.xml", "file.office"),
)
_ZIP_END: Final = 1 << 16

#: The root element of an XML file, and what may precede it.
_ROOT: Final = re.compile(rb"<(?![?!])\s*([^\s>/]+)")
_PROLOG: Final = re.compile(rb"<!--.*?-->|<\?.*?\?>|<!DOCTYPE[^\[>]*(?:\[.*?\]\s*)?>", re.DOTALL)
#: A CF2 may lack its $BOF line; a DXF never begins with one of the other keywords.
_CF2: Final = re.compile(
    rb"\s*(?:\$BOF\b|V2\s*[\r\n]+\s*ORDER\b|ORDER\s*[\r\n]|MAIN\s*,|SUB\s*,|"
    rb"[LA]\s*,\s*[\d.]+\s*,\s*\d+\s*,\s*\d+\s*,\s*[-+\d.])",
    re.IGNORECASE,
)
#: The first instructions of a plot, perhaps after a command to the interface of the plotter.  Text
#: may begin with the letters of one instruction, but not with those of three.
_PLOT: Final = re.compile(
    rb"\x1b\.|[;:\s]*(?:(?:IN|DF|BP|PG)\s*[;\d]|(?:SP|PU|PA|PD|PR|LT|RO|PS|IP)\s*[-\d., ]*;|"
    rb'CO\s*"|(?:(?:IN|DF|SP|PU|PA|PD|PR|LT|VS|FS|SC|IP|RO)[-\d.,\s]*){3})',
    re.IGNORECASE,
)
#: Commands of printers that begin a plot.
_PRINTED: Final = re.compile(rb"\x1b(?:%-12345X|E|%-?\d*[AB])")
_PRINTED_PLOT: Final = re.compile(rb"\x1b%-?\d*B|ENTER\s+LANGUAGE\s*=\s*HPGL", re.IGNORECASE)
#: Other file formats by the root element of their XML.
_FOREIGN_ROOTS: Final = {
    "html": "file.html",
    "body": "file.html",
}
#: Text in UTF-16 without a byte order mark.
_WIDE_TEXT: Final = re.compile(rb"(?:[\t\r\n -~]\x00){8}|(?:\x00[\t\r\n -~]){8}")
#: DWG from release 11 on.  Coordinates of older versions are not always converted correctly.
_DWG: Final = re.compile(rb"AC10(?:09|[1-9]\d)")
#: Kinds of files that are programs in PostScript.
_POSTSCRIPT: Final = frozenset({"file.eps", "file.illustrator", "file.postscript"})
_BINARY_DXF: Final = b"AutoCAD Binary DXF"
_GZIP: Final = b"\x1f\x8b"
_BYTE_ORDER_MARK: Final = b"\xef\xbb\xbf"


@dataclass(frozen=True, slots=True)
class Beginning:
    """A file and its first bytes, which are normalised so that the format can be detected."""

    head: bytes  #: without byte order mark and leading blanks; UTF-16 as UTF-8; b"" if empty
    data: bytes  #: the whole file

    @classmethod
    def from_bytes(cls, data: bytes) -> Beginning:
        """Return the beginning of a file, normalised for the detection of its format.

        ``data`` is the content of the file.
        """
        head = data[:_HEAD]
        if head[:2] in (b"\xff\xfe", b"\xfe\xff"):
            head = data[: 4 * _HEAD].decode("utf-16", "ignore").encode()
        return cls(head.removeprefix(_BYTE_ORDER_MARK).lstrip(b" \t\r\n\x00"), data)


def is_svg(file: Beginning) -> bool:
    """Return whether a file is an SVG file, which may be compressed with gzip (.svgz)."""
    if file.head.startswith(_GZIP):
        return _unpack_beginning(file.data).startswith(b"<")
    if not file.head.startswith(b"<"):
        return False
    root = _root_element(file.data)
    # The SVG reader reports the error of a file that has no element.
    return not root or root.rpartition(":")[2].lower() == "svg"


def is_pdf(file: Beginning) -> bool:
    """Return whether a file is a PDF file."""
    return file.head.startswith(b"%PDF")


def is_cf2(file: Beginning) -> bool:
    """Return whether a file is a CF2 file."""
    return _CF2.match(file.head) is not None


def is_plot(file: Beginning) -> bool:
    """Return whether a file is a plotter file (HPGL), which may contain commands of a printer."""
    if _PRINTED.match(file.head):
        return _PRINTED_PLOT.search(file.data[:_ROOT_WITHIN]) is not None
    return _PLOT.match(file.head) is not None


def is_lightburn(file: Beginning) -> bool:
    """Return whether a file is a project of LightBurn."""
    return file.head.startswith(b"<") and _root_element(file.data).lower() == "lightburnproject"


def is_postscript(file: Beginning) -> bool:
    """Return whether a file is a program in PostScript: EPS, or an Illustrator file without PDF."""
    kind = foreign_kind(file)
    return kind is not None and kind.code in _POSTSCRIPT


def is_dwg(file: Beginning) -> bool:
    """Return whether a file is a DWG drawing of release 11 or newer."""
    return _DWG.match(file.head) is not None


def foreign_kind(file: Beginning) -> Message | None:
    """Return a message that names a format that no reader reads, such as PNG.

    A file of such a format can be imported only if another program converts it.

    The result is None if the format is unknown.
    """
    if file.head.startswith(_GZIP):
        return Message("file.gzip")
    if file.head.startswith(b"<"):
        root = _root_element(file.data)
        code = _FOREIGN_ROOTS.get(root.lower())
        return Message(code) if code else Message("file.xml", element=root[:40])
    for pattern, code in _FOREIGN_PATTERNS:
        if pattern.match(file.head):
            return Message(code)
    if file.head.startswith(_ZIP):
        names = file.head + file.data[-_ZIP_END:]
        return Message(next((code for part, code in _ZIPPED if part in names), "file.zip"))
    for start, code in _FOREIGN:
        if file.head.startswith(start):
            return Message(code)
    # Text files have no null bytes but at their end, except those of UTF-16 without a byte order
    # mark.
    is_text = b"\x00" not in file.head.rstrip(b"\x00") or _WIDE_TEXT.match(file.head)
    is_dxf = file.head.startswith(_BINARY_DXF)
    return None if is_text or is_dxf else Message("file.binary")


def _unpack_beginning(data: bytes) -> bytes:
    """Return the first 4 KB of the decompressed content of a gzip file; b"" if it is damaged."""
    try:
        content = zlib.decompressobj(31).decompress(data, _HEAD)
    except zlib.error:
        return b""
    return content.removeprefix(_BYTE_ORDER_MARK).lstrip()


def _root_element(data: bytes) -> str:
    """Return the name of an XML file's root element; "" if there is none in the first 256 KB."""
    begin = data[:_ROOT_WITHIN]
    if begin[:2] in (b"\xff\xfe", b"\xfe\xff"):
        begin = begin.decode("utf-16", "ignore").encode()
    match = _ROOT.search(_PROLOG.sub(b"", begin))
    return "" if match is None else match[1].decode("utf-8", "replace")
