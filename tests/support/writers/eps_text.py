"""Write EPS and PostScript files for tests."""

from __future__ import annotations

#: Points per millimetre.
MM = 72.0 / 25.4
#: Ink name and CMYK colour of spot colours, by the name of the procedure that sets them.
SPOTS = {"Cut": ("CutContour", "0 exch 0 0"), "Fold": ("Crease", "0 0 0")}


def eps(*lines: str, box: str = "0 0 640 300", head: str = "%!PS-Adobe-3.0 EPSF-3.0") -> bytes:
    """Return an EPS file; ``box`` is its bounding box in points."""
    comments = (head, f"%%BoundingBox: {box}", "%%EndComments")
    return "\n".join((*comments, *lines, "showpage", "%%EOF", "")).encode()


def spot(name: str) -> str:
    """Return the line that selects a spot colour, one of ``SPOTS``."""
    ink, cmyk = SPOTS[name]
    return f"[ /Separation ({ink}) /DeviceCMYK {{ {cmyk} }} ] setcolorspace 1 setcolor"


def carton() -> bytes:
    """Return the carton of ``svg_text`` in spot colours."""
    return eps(
        f"{MM!r} dup scale 0.25 setlinewidth",
        spot("Cut"),
        "10 90 moveto 210 90 lineto 210 30 lineto",
        "190 30 20 0 -90 arcn 10 10 lineto closepath stroke",
        "43 50 moveto 35 50 8 0 360 arc closepath stroke",
        "matrix currentmatrix 85 50 translate 12 6 scale",
        "1 0 moveto 0 0 1 0 360 arc closepath setmatrix stroke",
        spot("Fold"),
        "[4 2] 0 setdash",
        *(f"{x} 10 moveto {x} 90 lineto stroke" for x in (60, 110, 160)),
    )


def pages(*contents: str) -> bytes:
    """Return a PostScript file with one page for each of ``contents``."""
    parts = [
        f"%%Page: {number} {number}\n{one}\nshowpage"
        for number, one in enumerate(contents, start=1)
    ]
    return "\n".join(("%!PS-Adobe-3.0", *parts, "%%EOF", "")).encode()


def with_preview(program: bytes, preview: bytes = b"II*\x00preview") -> bytes:
    """Return an EPS file with a TIFF preview after the PostScript ``program``."""
    begin = 30
    after = begin + len(program)
    numbers = (begin, len(program), 0, 0, after, len(preview))
    head = b"\xc5\xd0\xd3\xc6" + b"".join(one.to_bytes(4, "little") for one in numbers)
    return head + b"\xff\xff" + program + preview


def illustrator(*layers: str, box: str = "0 0 640 300") -> bytes:
    """Return a file in the format of Illustrator that names its procedure sets only.

    Parameters
    ----------
    layers
        Blocks of lines, from ``layer``.
    box
        Bounding box in points.
    """
    begin = (
        "%!PS-Adobe-3.0",
        "%%Creator: Rhinoceros",
        f"%%BoundingBox: {box}",
        "%%DocumentNeededResources: procset Adobe_packedarray 2.0 0",
        "%%+ procset Adobe_IllustratorA_AI3 1.0 0",
        "%%EndComments",
        "%%BeginSetup",
        "Adobe_packedarray /initialize get exec",
        "%%EndSetup",
    )
    end = ("%%PageTrailer", "gsave annotatepage grestore showpage", "%%Trailer", "%%EOF", "")
    return "\n".join((*begin, *layers, *end)).encode()


def layer(name: str, *lines: str, visible: bool = True) -> str:
    """Return a layer of a file of ``illustrator``."""
    begin = (f"{int(visible)} 1 1 1 0 0 0 79 128 255 Lb", f"({name}) Ln", "0 A")
    return "\n".join(("%AI5_BeginLayer", *begin, *lines, "LB", "%AI5_EndLayer--"))
