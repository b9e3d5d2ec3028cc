"""read: a DXF, ASCII or binary, of any version, as a Drawing.

    bytes -> Drawing: segments in mm, and a ledger row for every entity of the file

ezdxf reads the file; where it cannot, its ``recover`` mends what it can.  What ezdxf leaves out is
still in the ledger, because the entities are counted before (``census``).

    bytes -> census -> ezdxf document -> expand (INSERTs) -> place (columns) -> Drawing
"""

from __future__ import annotations

import io
import logging
from collections import Counter
from collections.abc import Callable
from typing import Final

import numpy as np
from ezdxf import recover
from ezdxf.document import Drawing as Document
from ezdxf.lldxf.tagger import binary_tags_loader

from knifetip.dxf.census import BINARY, Census, census
from knifetip.dxf.expand import Sheet, expand
from knifetip.dxf.limits import Limits
from knifetip.dxf.place import Columns, columns
from knifetip.dxf.units import factor, stated
from knifetip.errors import DrawingTooLarge, KnifetipError, NotADrawing
from knifetip.geometry import arc
from knifetip.geometry.columns import F64, I64, Bool
from knifetip.geometry.tolerance import POINT
from knifetip.model.drawing import Drawing, Fate, Ledger

__all__ = ["Limits", "read"]

# ezdxf tells of every tag that it mends; the ledger tells the user what matters.
logging.getLogger("ezdxf").addHandler(logging.NullHandler())

#: Files that are often taken for a DXF: their first bytes, and what they are.
_STRANGERS: Final = (
    (b"\x89PNG", "a PNG picture"),
    (b"\xff\xd8\xff", "a JPEG picture"),
    (b"GIF8", "a GIF picture"),
    (b"%PDF", "a PDF"),
    (b"%!PS", "a PostScript file"),
    (b"PK\x03\x04", "a ZIP archive"),
    (b"\x1f\x8b", "a gzip archive"),
    (b"AC10", "a DWG drawing"),
    (b"<", "an XML, SVG or HTML file"),
    (b"$BOF", "a CF2 file"),
)

_EXPORT: Final = "Export the drawing as DXF (ASCII or binary, any version)."
_AGAIN: Final = "Export it again, or open it in a CAD program, audit it and save it as DXF R2000."


def read(data: bytes, unit: str | None = None, *, limits: Limits = Limits()) -> Drawing:  # noqa: B008
    """Return the drawing that a DXF holds.

    Parameters
    ----------
    data
        The file, ASCII or binary.
    unit
        "mm", "cm", "m", "in" or "ft": stands above what the file says.

    Returns
    -------
    Drawing
        In mm; in file units with ``unit`` empty where neither the file nor the caller says one.

    Raises
    ------
    NotADrawing
        Empty, not a DXF, cut short, or damaged past repair.
    DrawingTooLarge
        A limit is exceeded.
    UnitUnknown
        ``unit`` is no unit.
    """
    given = factor(unit) if unit else 0.0
    if len(data) > limits.bytes:
        raise DrawingTooLarge(
            f"The file has {len(data) / 2**20:.1f} MB; the limit is {limits.bytes / 2**20:.1f} MB.",
            "Export a single carton, without pictures.",
        )
    data = _stripped(data)
    try:
        with np.errstate(all="ignore"):
            return _read(data, unit or "", given, limits)
    except KnifetipError:
        raise
    except Exception as error:
        # ezdxf makes no promise on hostile bytes, and a user's file must never end in a traceback.
        raise NotADrawing(
            f"The DXF is damaged past repair: {type(error).__name__}: {_short(error)}.", _AGAIN
        ) from error


def _read(data: bytes, unit: str, given: float, limits: Limits) -> Drawing:
    counted = census(data)
    _check(data, counted, limits)
    if unit:
        scale, evidence = given, "given"
    else:
        unit, evidence = stated(counted.variables)
        scale = factor(unit) if unit else 0.0
    sheet = expand(_document(data, counted), counted, limits)
    return _drawing(sheet, columns(sheet, scale, limits), scale, unit, evidence)


def _stripped(data: bytes) -> bytes:
    """Return the bytes without byte order mark and leading blank lines; UTF-16 as UTF-8."""
    if data[:2] in (b"\xff\xfe", b"\xfe\xff"):
        data = data.decode("utf-16", "replace").encode("utf-8")
    return data.removeprefix(b"\xef\xbb\xbf").lstrip()


def _check(data: bytes, counted: Census, limits: Limits) -> None:
    """Refuse what is no DXF, has too much in it, or stops in the middle."""
    if not data:
        raise NotADrawing("The file is empty.", _EXPORT)
    for start, what in _STRANGERS:
        if data.startswith(start):
            raise NotADrawing(f"The file is {what}, not a DXF.", _EXPORT)
    if not counted.sections:
        if counted.broken:
            line = data.split(b"\n")[counted.broken - 1][:40].decode("ascii", "replace").strip()
            raise NotADrawing(
                f"The file is not a DXF: line {counted.broken} is {line!r}, not a group code.",
                _EXPORT,
            )
        raise NotADrawing("The file is not a DXF: it has no section.", _EXPORT)
    if counted.size > limits.entities:
        raise DrawingTooLarge(
            f"The file has {counted.size:,} entities; the limit is {limits.entities:,}.",
            "Export a single carton.",
        )
    unfinished = not counted.ended and "ENTITIES" not in counted.sections
    if counted.open_section in ("ENTITIES", "BLOCKS") or unfinished:
        where = f"at line {counted.broken}" if counted.broken else "without its end mark (EOF)"
        section = counted.open_section or "file"
        raise NotADrawing(
            f"The file is cut short: it stops {where} in section {section}, after "
            f"{counted.size:,} entities, so lines may be missing.",
            "Send or export it again.",
        )


def _document(data: bytes, counted: Census) -> Document:
    """Return what ezdxf makes of the bytes: read as they are, else mended."""
    attempts: list[Callable[[], Document]]
    if data.startswith(BINARY):
        attempts = [lambda: Document.load(binary_tags_loader(data, errors="replace"))]
    else:
        attempts = [lambda: _plain(data, counted.encoding), lambda: _recovered(data)]
        if counted.markers and "$ACADVER" not in counted.variables:
            # Without a version ezdxf takes the file for R12, which its entities contradict.
            head = b"0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1015\n0\nENDSEC\n"
            attempts.append(lambda: _recovered(head + data))
    reasons: list[str] = []
    for attempt in attempts:
        try:
            return attempt()
        except Exception as error:
            reasons.append(_short(error))
    raise NotADrawing(f"The DXF is damaged past repair: {reasons[-1]}.", _AGAIN)


def _plain(data: bytes, encoding: str) -> Document:
    with io.TextIOWrapper(io.BytesIO(data), encoding=encoding, errors="replace") as stream:
        return Document.read(stream)


def _recovered(data: bytes) -> Document:
    document, _ = recover.read(io.BytesIO(data), errors="replace")
    return document


def _short(error: Exception) -> str:
    text = str(error).removeprefix("DXFStructureError: ").strip().rstrip(".")
    return (text or type(error).__name__)[:200]


def _drawing(sheet: Sheet, found: Columns, scale: float, unit: str, evidence: str) -> Drawing:
    """Put columns and ledger together: without specks, each line once."""
    point = POINT / scale if scale else POINT / 1000.0
    length = arc.length(found.ends[:, 0], found.ends[:, 1], found.bulge)
    speck = ~(length >= point)
    layers, linetypes, attributes = _attributes(sheet)
    of_segment = attributes[found.style] if len(found.style) else np.zeros((0, 5), dtype=np.int64)
    first = np.arange(len(found.row))
    solid = np.flatnonzero(~speck)
    first[solid] = solid[
        _survivors(found.ends[solid], found.bulge[solid], of_segment[solid], point)
    ]
    twice = first != np.arange(len(first))
    keep = ~(speck | twice)
    fate, reason = _fates(sheet, found, length, speck, twice, first)
    kept_length = np.zeros(len(sheet.handle))
    np.add.at(kept_length, found.row[keep], length[keep])
    size = scale or 1.0
    return Drawing(
        ends=found.ends[keep] * size,
        bulge=found.bulge[keep],
        entity=found.row[keep],
        layer=of_segment[keep, 0],
        colour=of_segment[keep, 2],
        true_colour=of_segment[keep, 3],
        linetype=of_segment[keep, 4],
        layers=layers,
        linetypes=linetypes,
        ledger=Ledger(
            tuple(sheet.handle),
            tuple(sheet.kind),
            tuple(sheet.layer),
            np.array(fate, dtype=np.uint8),
            tuple(reason),
            kept_length * size,
        ),
        unit=unit,
        evidence=evidence,
    )


def _attributes(sheet: Sheet) -> tuple[tuple[str, ...], tuple[str, ...], I64]:
    """Return layer names, linetype names, and (placed, 5): layer, layer regardless of case,
    colour, true colour, linetype of each placed shape."""
    layers: dict[str, int] = {}
    folded: dict[str, int] = {}
    linetypes: dict[str, int] = {}
    rows = np.zeros((len(sheet.placed), 5), dtype=np.int64)
    for number, placed in enumerate(sheet.placed):
        style = placed.style
        rows[number] = (
            layers.setdefault(style.layer, len(layers)),
            folded.setdefault(style.layer.lower(), len(folded)),
            style.colour,
            style.true_colour,
            linetypes.setdefault(style.linetype, len(linetypes)),
        )
    return tuple(layers), tuple(linetypes), rows


def _survivors(ends: F64, bulge: F64, attributes: I64, point: float) -> I64:
    """Return for each segment the first one that is the same line, in either direction."""
    grid = np.round(ends / point).astype(np.int64)
    round_ = np.round(bulge * 1e9).astype(np.int64)
    a, b = grid[:, 0], grid[:, 1]
    back = (a[:, 0] > b[:, 0]) | ((a[:, 0] == b[:, 0]) & (a[:, 1] > b[:, 1]))
    low = np.where(back[:, None], b, a)
    high = np.where(back[:, None], a, b)
    turn = np.where(back, -round_, round_)
    key = np.column_stack([low, high, turn, attributes[:, 1:]])
    # lexsort is stable: within a group of equals the file's order stays.
    order = np.lexsort(key.T)
    alike = np.concatenate([[False], (key[order][1:] == key[order][:-1]).all(axis=1)])
    head = np.maximum.accumulate(np.where(alike, 0, np.arange(len(order))))
    first = np.empty(len(order), dtype=np.int64)
    first[order] = order[head]
    return first


def _fates(
    sheet: Sheet, found: Columns, length: F64, speck: Bool, twice: Bool, first: I64
) -> tuple[list[int], list[str]]:
    """Return fate and reason of each row of the ledger."""
    rows = len(sheet.handle)
    total = np.bincount(found.row, minlength=rows)
    specks = np.bincount(found.row[speck], minlength=rows)
    doubles = np.bincount(found.row[twice], minlength=rows)
    longest = np.zeros(rows)
    np.maximum.at(longest, found.row, length)
    survivors: dict[int, Counter[int]] = {}
    for row, survivor in zip(
        found.row[twice].tolist(), found.row[first[twice]].tolist(), strict=True
    ):
        survivors.setdefault(row, Counter())[survivor] += 1
    fate: list[int] = []
    reason: list[str] = []
    for row in range(rows):
        notes = list(sheet.notes[row])
        if sheet.dropped[row]:
            fate.append(Fate.DROPPED)
            reason.append(sheet.dropped[row])
            continue
        if total[row] and specks[row] == total[row]:
            fate.append(Fate.DROPPED)
            reason.append(f"it has no length: {longest[row]:g}")
            continue
        if specks[row]:
            notes.append(f"{specks[row]} of {total[row]} pieces have no length")
        if doubles[row]:
            same = survivors[row]
            names = [
                "itself" if other == row else sheet.handle[other] for other, _ in same.most_common()
            ]
            listed = ", ".join(names[:5]) + (f" and {len(names) - 5} more" if names[5:] else "")
            if doubles[row] + specks[row] == total[row]:
                fate.append(Fate.MERGED)
                reason.append(f"it is drawn twice: the same as {listed}")
                continue
            notes.append(f"{doubles[row]} of {total[row]} pieces are drawn twice, with {listed}")
        fate.append(Fate.KEPT)
        reason.append("kept" + (": " + "; ".join(notes) if notes else ""))
    return fate, reason
