"""Write PDF files for tests."""

from __future__ import annotations

import math
import zlib
from collections.abc import Iterable

#: Points per millimetre.
MM = 72.0 / 25.4
#: Ink name and CMYK colour of spot colours, by their names in the page's resources.
SPOTS = {"Cut": ("CutContour", "0 1 0 0"), "Fold": ("Crease", "1 0 0 0")}


def stream(data: bytes, entries: str = "", *, flate: bool = False) -> bytes:
    """Return a stream object with further dictionary entries; ``flate`` compresses the data."""
    if flate:
        data, entries = zlib.compress(data), f"{entries} /Filter /FlateDecode"
    return f"<<{entries} /Length {len(data)}>>\nstream\n".encode() + data + b"\nendstream"


def separation(ink: str, cmyk: str) -> str:
    """Return the colour space of a spot colour; ``cmyk`` is its alternate colour."""
    return (
        f"[/Separation /{ink} /DeviceCMYK "
        f"<</FunctionType 2 /Domain [0 1] /C0 [0 0 0 0] /C1 [{cmyk}] /N 1>>]"
    )


def objects(*contents: bytes | str, trailer: str = "", head: str = "%PDF-1.7") -> bytes:
    """Return a file with objects numbered 1, 2, 3, …; object 1 is the catalogue."""
    out = bytearray(head.encode() + b"\n%\xe2\xe3\xcf\xd3\n")
    places = []
    for number, one in enumerate(contents, 1):
        places.append(len(out))
        body = one.encode() if isinstance(one, str) else one
        out += f"{number} 0 obj\n".encode() + body + b"\nendobj\n"
    begin = len(out)
    out += f"xref\n0 {len(contents) + 1}\n0000000000 65535 f \n".encode()
    out += b"".join(f"{place:010} 00000 n \n".encode() for place in places)
    out += f"trailer\n<</Size {len(contents) + 1} /Root 1 0 R {trailer}>>\n".encode()
    return bytes(out + f"startxref\n{begin}\n%%EOF\n".encode())


def pages(*contents: bytes | str) -> bytes:
    """Return a file with one page of 99 × 99 points for each content stream."""
    page = "<</Type /Page /Parent 2 0 R /MediaBox [0 0 99 99] /Contents {} 0 R>>"
    count = len(contents)
    kids = " ".join(f"{3 + k} 0 R" for k in range(count))
    return objects(
        "<</Type /Catalog /Pages 2 0 R>>",
        f"<</Type /Pages /Kids [{kids}] /Count {count}>>",
        *(page.format(3 + count + k) for k in range(count)),
        *(stream(one.encode() if isinstance(one, str) else one) for one in contents),
    )


def pdf(
    *content: str | bytes,
    size: tuple[float, float] = (100.0 * MM, 100.0 * MM),
    page: str = "",
    root: str = "",
    resources: str = "",
    spaces: str = "",
    properties: str = "",
    fonts: str = "",
    layers: Iterable[str] = (),
    default: str = "",
    more: Iterable[bytes | str] = (),
    flate: bool = False,
    trailer: str = "",
) -> bytes:
    """Return a file of one page with some content streams joined.

    Parameters
    ----------
    size
        Width and height of the page in points.
    page, root, trailer
        Further entries of the page, the catalogue and the trailer.
    resources, spaces, properties, fonts
        Further entries of the resources, and of their colour spaces, properties and fonts.
    layers
        Names of layers, which are objects 6, 7, 8, … and /L0, /L1, /L2, … in the content.
    default
        Entries of the default configuration of the layers.
    more
        Further objects, after the layers.
    flate
        Compress the content.
    """
    names = list(layers)
    groups = " ".join(f"{6 + k} 0 R" for k in range(len(names)))
    properties += " ".join(f"/L{k} {6 + k} 0 R" for k in range(len(names)))
    spaces += " ".join(f"/{key} {separation(*spot)}" for key, spot in SPOTS.items())
    optional = f"/OCProperties <</OCGs [{groups}] /D <<{default}>>>>" if names else ""
    data = b"\n".join(one.encode() if isinstance(one, str) else one for one in content)
    return objects(
        f"<</Type /Catalog /Pages 2 0 R {optional} {root}>>",
        "<</Type /Pages /Kids [3 0 R] /Count 1>>",
        f"<</Type /Page /Parent 2 0 R /MediaBox [0 0 {size[0]!r} {size[1]!r}] /Contents 4 0 R "
        f"/Resources <</ColorSpace <<{spaces}>> /Properties <<{properties}>> "
        f"/Font <</F1 5 0 R {fonts}>> {resources}>> {page}>>",
        stream(data, flate=flate),
        "<</Type /Font /Subtype /Type1 /BaseFont /Helvetica /Encoding /WinAnsiEncoding>>",
        *(f"<</Type /OCG /Name ({name})>>" for name in names),
        *more,
        trailer=trailer,
    )


def ellipse_curves(
    x: float, y: float, across: float, down: float, first: float, turn: float
) -> str:
    """Return path operators for an elliptic arc about (x, y), with eight curves per quarter turn.

    ``across`` and ``down`` are the half axes; ``first`` is the start angle and ``turn`` the sweep
    (radians).
    """
    count = max(1, round(abs(turn) / (math.pi / 16.0)))
    step = turn / count
    reach = 4.0 / 3.0 * math.tan(step / 4.0)
    curves = []
    for k in range(count):
        a, b = first + k * step, first + (k + 1) * step
        points = (
            (math.cos(a) - reach * math.sin(a), math.sin(a) + reach * math.cos(a)),
            (math.cos(b) + reach * math.sin(b), math.sin(b) - reach * math.cos(b)),
            (math.cos(b), math.sin(b)),
        )
        curves.append(
            " ".join(f"{x + across * u:.9f} {y + down * v:.9f}" for u, v in points) + " c"
        )
    return " ".join(curves)


def carton(*, layered: bool = True, flate: bool = False) -> bytes:
    """Return the carton of ``svg_text`` in spot colours, by default on layers."""
    around = (
        f"10 90 m 210 90 l 210 30 l {ellipse_curves(190, 30, 20, 20, 0, -math.pi / 2)} 10 10 l s"
    )
    holes = "".join(
        f"{x + across} 50 m {ellipse_curves(x, 50, across, high, 0, math.tau)} s\n"
        for x, across, high in ((35, 8, 8), (85, 12, 6))
    )
    folds = "".join(f"{x} 10 m {x} 90 l S\n" for x in (60, 110, 160))
    begin, end = ("/OC /L{} BDC", "EMC") if layered else ("", "")
    return pdf(
        f"q {MM!r} 0 0 {MM!r} 0 0 cm 0.25 w",
        begin.format(0),
        f"/Cut CS 1 SCN {around}\n{holes}",
        end,
        begin.format(1),
        f"/Fold CS 1 SCN q [4 2] 0 d {folds} Q",
        end,
        "BT /F1 4 Tf 20 2 Td (A ) Tj (carton) Tj ET",
        "Q",
        size=(220.0 * MM, 100.0 * MM),
        layers=("CUT", "CREASE") if layered else (),
        flate=flate,
    )
