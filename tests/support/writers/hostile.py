"""Malicious files of every format: those that must be refused, and those that must be read.

Each is a function that makes the file when it is needed, because some are very large.
"""

from __future__ import annotations

import gzip
import struct
from collections.abc import Callable, Mapping
from itertools import pairwise

from tests.support.writers import cf2_text as cf2
from tests.support.writers import dxf_text as dxf
from tests.support.writers import lightburn_text as lbrn
from tests.support.writers import svg_text as svg

Maker = Callable[[], bytes]

_LINE = dxf.line(0, 0, 10, 10)
_MEGABYTE = 1 << 20


def binary(text: bytes) -> bytes:
    """Convert a text DXF of R12 to binary DXF: group codes of one byte, doubles, 16-bit integers,
    texts.
    """
    data = b"AutoCAD Binary DXF\r\n\x1a\x00"
    lines = text.decode().split("\n")
    for code, value in zip(map(int, lines[:-1:2]), lines[1::2], strict=True):
        data += bytes([code])
        if 10 <= code <= 59:
            data += struct.pack("<d", float(value))
        elif 60 <= code <= 79:
            data += struct.pack("<h", int(value))
        else:
            data += value.encode() + b"\0"
    return data


def nested_inserts() -> bytes:
    rows = [dxf.insert(f"B{n + 1}") * 10 for n in range(9)]
    blocks = [dxf.block(f"B{n}", row) for n, row in enumerate(rows)] + [dxf.block("B9", _LINE)]
    return dxf.dxf(dxf.insert("B0"), blocks=tuple(blocks))


def array_of_a_million() -> bytes:
    grid = dxf.insert("A", 0, 0, (70, 1001), (71, 1001), (44, 1.0), (45, 1.0))
    return dxf.dxf(grid, blocks=(dxf.block("A", _LINE),))


def cyclic_blocks() -> bytes:
    blocks = (dxf.block("A", dxf.insert("B")), dxf.block("B", dxf.insert("A"), _LINE))
    return dxf.dxf(dxf.insert("A"), _LINE, blocks=blocks)


def not_numbers() -> bytes:
    bad = [dxf.line(value, 0, 5, 5) for value in ("nan", "inf", "1e308", "-1e308")]
    return dxf.dxf(*bad, _LINE)


def absurd_knots() -> bytes:
    knots: list[dxf.Tag] = [(40, knot) for knot in (-1e308, 0, 0, "nan", 1, 1, 1, 1e308)]
    control: list[dxf.Tag] = []
    for n in range(4):
        control += [(10, n), (20, n * n), (30, 0)]
    head: list[dxf.Tag] = [(100, "AcDbEntity"), (8, "0"), (100, "AcDbSpline")]
    head += [(70, 8), (71, 3), (72, 8), (73, 4)]
    return dxf.dxf(dxf.entity("SPLINE", *head, *knots, *control), _LINE, version="AC1015")


def entity_bomb() -> bytes:
    lines = ['<!ENTITY a "ha">']
    for before, name in pairwise("abcdefghij"):
        lines.append(f'<!ENTITY {name} "' + f"&{before};" * 10 + '">')
    return f"<!DOCTYPE svg [{''.join(lines)}]><svg {svg.SVG}><text>&j;</text></svg>".encode()


def external_entity(url: str = "file:///etc/passwd") -> bytes:
    declared = f'<!DOCTYPE svg [<!ENTITY a SYSTEM "{url}">]>'
    return f"{declared}<svg {svg.SVG}><text>&a;</text></svg>".encode()


def external_references(url: str = "http://192.0.2.1/") -> bytes:
    """Return an SVG file with a line and all kinds of references to other files."""
    return (
        f'<?xml-stylesheet href="{url}a.css"?><!DOCTYPE svg PUBLIC "x" "{url}x.dtd">'.encode()
        + (
            svg.svg(
                f"<style>@import url({url}b.css); path {{marker: url({url}m.svg#m)}}</style>",
                f'<use href="{url}a.svg#a"/><use xlink:href="{url}b.svg#b"/>',
                f'<image href="{url}a.png" width="9" height="9"/>',
                f'<path d="M0 0h50" fill="url({url}p.svg#p)" clip-path="url({url}c.svg#c)"/>',
                f'<foreignObject><iframe src="{url}"/></foreignObject><script href="{url}x.js"/>',
            )
        )
    )


def use_bomb() -> bytes:
    groups = ['<g id="g0"><path d="M0 0h1"/></g>']
    for k in range(1, 12):
        groups.append(f'<g id="g{k}">' + f'<use href="#g{k - 1}"/>' * 10 + "</g>")
    return svg.svg("<defs>", *groups, "</defs>", '<use href="#g11"/>')


def call_bomb() -> bytes:
    subs = [cf2.sub(f"S{k}", *[f"C,S{k + 1},0,0,0,1,1"] * 10) for k in range(12)]
    subs.append(cf2.sub("S12", cf2.line(0, 0, 1, 0)))
    return cf2.cf2("C,S0,0,0,0,1,1", subs="\r\n".join(subs))


def call_tower() -> bytes:
    subs = [cf2.sub(f"S{k}", f"C,S{k + 1},0,0,0,1,1") for k in range(5000)]
    return cf2.cf2("C,S0,0,0,0,1,1", subs="\r\n".join(subs))


def cyclic_calls() -> bytes:
    subs = cf2.sub("A", "C,B,0,0,0,1,1") + "\r\n" + cf2.sub("B", "C,A,0,0,0,1,1")
    return cf2.cf2("C,A,0,0,0,1,1", cf2.line(0, 0, 10, 0), subs=subs)


def _filled(head: bytes, piece: bytes, tail: bytes) -> bytes:
    """Return ``head``, ``piece`` repeated up to 60 MB (less than the size limit), and ``tail``."""
    return head + piece * (60 * _MEGABYTE // len(piece)) + tail


#: Status and a word of the response, and the function that makes the file.
REFUSED: Mapping[str, tuple[int, str, Maker]] = {
    "dxf: nested INSERTs": (413, "2,111,111,110 entities", nested_inserts),
    "dxf: INSERT array": (413, "1,002,001 entities", array_of_a_million),
    "dxf: cut short": (422, "DXF file is incomplete", lambda: nested_inserts()[:-500]),
    "dxf: in EBCDIC": (422, "not a DXF", lambda: dxf.dxf(_LINE).decode().encode("cp500")),
    "dxf: in UTF-16, no mark": (422, "a DXF", lambda: dxf.dxf(_LINE).decode().encode("utf-16-le")),
    "dxf: not numbers": (422, "not a number", not_numbers),
    "dxf: absurd knots": (422, "not a number", absurd_knots),
    "dxf: 60 MB of entities": (413, "24.0 MB", lambda: _filled(b"", b"0\nPOINT\n", b"")),
    "dxf: 60 MB of one word": (413, "24.0 MB", lambda: _filled(b"0\nSECT", b"9", b"\n")),
    "dxf: 60 MB of nothing": (422, "empty", lambda: _filled(b"", b" \n", b"")),
    "dxf: a program": (
        422,
        "a binary file",
        lambda: b"\x7fELF\x02\x01\x01" + bytes(range(256)) * 99,
    ),
    "binary dxf: nested INSERTs": (413, "entities", lambda: binary(nested_inserts())),
    "binary dxf: INSERT array": (413, "entities", lambda: binary(array_of_a_million())),
    "binary dxf: cut short": (
        422,
        "DXF file is incomplete",
        lambda: binary(nested_inserts())[:-300],
    ),
    "svg: entity bomb": (422, "contains markup", entity_bomb),
    "svg: external entity": (422, "is not loaded", external_entity),
    "svg: use bomb": (413, "expand to more than 1,000,000 elements", use_bomb),
    "svg: nested": (413, "nested more than 256", lambda: svg.svg("<g>" * 99_999 + "</g>" * 99_999)),
    "svg: packed bomb": (413, "is larger", lambda: gzip.compress(b"<svg>" + bytes(300_000_000))),
    "svg: cut short": (422, "SVG file is incomplete", lambda: svg.carton()[:-20]),
    "svg: 60 MB of elements": (413, "elements", lambda: svg.svg("<g/>" * 15_000_000)),
    "cf2: calls": (413, "expand to more than", call_bomb),
    "cf2: tower": (413, "nested more than 16 levels deep", call_tower),
    "cf2: cut short": (422, "CF2 file is incomplete", lambda: cf2.carton()[:200]),
    "cf2: 60 MB of records": (413, "elements", lambda: cf2.cf2(*["L,2,1,0,0,0,1,1"] * 3_700_000)),
    "plt: cut short": (422, "has no end", lambda: b"IN;SP1;PU0,0;PD40,0;LBno end"),
    "plt: not numbers": (422, "byte 14", lambda: b"IN;SP1;PU0,0;PD40,,0;"),
    "plt: 60 MB of points": (413, "lines and curves", lambda: b"IN;SP1;PD" + b"1," * 30_000_000),
    "lightburn: external entity": (
        422,
        "has a DOCTYPE",
        lambda: b'<!DOCTYPE a [<!ENTITY b SYSTEM "/etc/passwd">]><LightBurnProject>&b;</a>',
    ),
    "lightburn: cut short": (422, "LightBurn file is incomplete", lambda: lbrn.carton()[:-20]),
    "cf2: decimal commas": (422, "commas", lambda: cf2.cf2(*["L,2,1,0,5,1,6,1,5,7,1,7,0,0"] * 9)),
}

#: Text in the import report, number of edges, and the function that makes the file.
READ: Mapping[str, tuple[str, int, Maker]] = {
    "dxf: cyclic blocks": ("inserts itself", 1, cyclic_blocks),
    "dxf: in UTF-16": ("imported unchanged", 1, lambda: dxf.dxf(_LINE).decode().encode("utf-16")),
    "binary dxf: cyclic blocks": ("inserts itself", 1, lambda: binary(cyclic_blocks())),
    "binary dxf: not numbers": ("not a number", 1, lambda: binary(not_numbers())),
    "svg: external references": ("another file", 1, external_references),
    "svg: not numbers": (
        "the limit is 10,000,000",
        1,
        lambda: svg.svg('<path d="M0 0H1e308"/><circle r="1e999"/><path d="M0 0h9"/>'),
    ),
    "plt: too far": (
        "the limit is 10,000,000",
        1,
        lambda: b"IN;SP1;PU0,0;PD99999999999,0;PU0,0;PD40,0;",
    ),
    "lightburn: not numbers": (
        "cannot be read",
        1,
        lambda: lbrn.project(lbrn.shape("Rect", W="nan", H=1), lbrn.polyline((0, 0), (9, 0))),
    ),
    "cf2: cyclic calls": ("inserts itself", 1, cyclic_calls),
    "cf2: not numbers": (
        "not a number",
        1,
        lambda: cf2.cf2("L,2,1,0,nan,0,1,1,0,0", cf2.line(0, 0, 1e308, 0), cf2.line(0, 0, 9, 0)),
    ),
}
