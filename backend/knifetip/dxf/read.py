"""read: a DXF, ASCII or binary, of any version, as a Drawing.

    bytes -> Drawing: segments in mm, and a ledger row for every entity of the file

ezdxf reads the file; where it cannot, its ``recover`` mends what it can.  What ezdxf leaves out is
still in the ledger, because the entities are counted before (``census``).

    bytes -> census -> ezdxf document -> expand (INSERTs) -> place (columns) -> Drawing
"""

from __future__ import annotations

import io
import logging
import re
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from typing import Final

import numpy as np
from ezdxf import recover
from ezdxf.document import Drawing as Document
from ezdxf.lldxf.tagger import binary_tags_loader

from knifetip.drawing_builder.assemble import KnownUnit, assemble
from knifetip.dxf.census import BINARY, Census, census
from knifetip.dxf.expand import expand
from knifetip.dxf.place import columns, refuse_after, styled
from knifetip.dxf.plain import PlainReader
from knifetip.dxf.rewrite import UNMARKED, as_text, lines_only, with_markers
from knifetip.dxf.tables import NotPlainError
from knifetip.dxf.units import hints, stated
from knifetip.errors import DrawingTooLarge, KnifetipError, NotADrawing
from knifetip.formats import format_of
from knifetip.formats.limits import Limits
from knifetip.messages import Message
from knifetip.model.drawing import Drawing
from knifetip.model.unit import factor

__all__ = ["Limits", "read"]

# ezdxf tells of every tag that it mends; the ledger tells the user what matters.
logging.getLogger("ezdxf").addHandler(logging.NullHandler())

#: How a DXF begins.
_CODE: Final = re.compile(rb" *\d")


def read(data: bytes, unit: str | None = None, *, limits: Limits = Limits()) -> Drawing:
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
    NoSuchUnit
        ``unit`` is no unit.
    """
    given = factor(unit) if unit else 0.0
    limits.admit(len(data))
    data = _stripped(data)
    try:
        with np.errstate(all="ignore"):
            found = quickly(data, unit or "", given, limits)
            if found is None:
                found = by_ezdxf(data, unit or "", given, limits)
            return found
    except KnifetipError:
        raise
    except Exception as error:
        # ezdxf makes no promise on hostile bytes, and a user's file must never end in a traceback.
        reason = f"{type(error).__name__}: {_short(error)}"
        raise NotADrawing("reading.damaged", format="DXF", reason=reason) from error


def quickly(data: bytes, unit: str, given: float, limits: Limits) -> Drawing | None:
    """Read by our own reader; None where it does not promise what ezdxf would say."""
    try:
        reader = PlainReader(data, limits)
        known = _known(unit, given, reader.tables.variables)
        found = reader.read(known.scale)
    except NotPlainError:
        return None
    # What it was read from takes more memory than the drawing.
    del reader
    return assemble(found.sheet, found.columns, found.styles, found.inscriptions, known)


def by_ezdxf(data: bytes, unit: str, given: float, limits: Limits) -> Drawing:
    """Read by way of ezdxf, or say why not."""
    if (kind := format_of(data)).name != "dxf":
        raise NotADrawing("dxf.other-kind", kind=kind.title)
    if len(data) > limits.slow_bytes:
        raise DrawingTooLarge(
            "dxf.too-large-unusual", size=len(data) / 2**20, limit=limits.slow_bytes / 2**20
        )
    counted = census(data)
    _check(data, counted, limits)
    known = _known(unit, given, counted.variables)
    sheet, shapes = expand(_document(data, counted, limits), counted, limits)
    found = columns(sheet, shapes, known.scale, limits)
    found, styles = styled(found, [shape.style for shape in shapes])
    return assemble(sheet, found, styles, counted.inscriptions, known)


def _known(unit: str, given: float, variables: Mapping[str, str]) -> KnownUnit:
    """Return the unit that the caller gives, else the one that the file states."""
    written, evidence = stated(variables)
    if unit:
        return KnownUnit(given, unit, Message("unit.given"), written, hints(variables))
    scale = factor(written) if written else 0.0
    return KnownUnit(scale, written, evidence, written, hints(variables))


def _stripped(data: bytes) -> bytes:
    """Return the bytes without byte order mark and leading blank lines; UTF-16 as UTF-8."""
    if data[:2] in (b"\xff\xfe", b"\xfe\xff"):
        data = data.decode("utf-16", "replace").encode("utf-8")
    # Most files begin with a group code, blanks before it or not: no need to copy them.
    return data if _CODE.match(data) else data.removeprefix(b"\xef\xbb\xbf").lstrip()


def _check(data: bytes, counted: Census, limits: Limits) -> None:
    """Refuse what is no DXF, has too much in it, or stops in the middle."""
    if not counted.sections:
        if counted.broken:
            line = data.split(b"\n")[counted.broken - 1][:40].decode("ascii", "replace").strip()
            raise NotADrawing("dxf.not-a-group-code", line=counted.broken, text=line)
        raise NotADrawing("dxf.no-section")
    if counted.size > limits.entities:
        raise DrawingTooLarge(
            "reading.too-many-entities", count=counted.size, limit=limits.entities
        )
    unfinished = not counted.ended and "ENTITIES" not in counted.sections
    if counted.open_section in ("ENTITIES", "BLOCKS") or unfinished:
        where = f"at line {counted.broken}" if counted.broken else "without its end mark (EOF)"
        section = counted.open_section or "file"
        raise NotADrawing("dxf.cut-short", where=where, section=section, count=counted.size)


def _document(data: bytes, counted: Census, limits: Limits) -> Document:
    """Return what ezdxf makes of the bytes: read as they are, else mended, else only the lines."""
    reasons: list[str] = []
    until = time.monotonic() + limits.seconds
    for attempt in _attempts(data, counted):
        refuse_after(until, limits)
        try:
            return attempt()
        except Exception as error:
            reasons.append(_short(error))
    raise NotADrawing("reading.damaged", reason=reasons[-1], format="DXF")


def _attempts(data: bytes, counted: Census) -> Iterator[Callable[[], Document]]:
    """Yield ways to read the bytes, the gentlest first."""
    if data.startswith(BINARY):
        yield lambda: Document.load(binary_tags_loader(data, errors="replace"))
        with suppress(Exception):
            tags = binary_tags_loader(data, errors="replace")
            yield from _of_lines(as_text(tags, counted.encoding), counted)
    else:
        yield from _of_text(data, counted)
        yield from _of_lines(data, counted)


def _of_lines(data: bytes, counted: Census) -> Iterator[Callable[[], Document]]:
    lines = lines_only(data)
    yield from _of_text(lines, counted)
    yield lambda: _recovered(with_markers(lines, every=True))


def _of_text(data: bytes, counted: Census) -> Iterator[Callable[[], Document]]:
    if counted.markers and counted.variables.get("$ACADVER", "") <= UNMARKED:
        data = with_markers(data, every=True)
    yield lambda: _plain(data, counted.encoding)
    yield lambda: _recovered(data)
    if counted.unmarked:
        yield lambda: _plain(with_markers(data), counted.encoding)
        yield lambda: _recovered(with_markers(data))
    if counted.markers and "$ACADVER" not in counted.variables:
        # Without a version ezdxf takes the file for R12, which its entities contradict.
        head = b"0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1015\n0\nENDSEC\n"
        yield lambda: _recovered(head + data)


def _plain(data: bytes, encoding: str) -> Document:
    with io.TextIOWrapper(io.BytesIO(data), encoding=encoding, errors="replace") as stream:
        return Document.read(stream)


def _recovered(data: bytes) -> Document:
    document, _ = recover.read(io.BytesIO(data), errors="replace")
    return document


def _short(error: Exception) -> str:
    text = str(error).removeprefix("DXFStructureError: ").strip().rstrip(".")
    return (text or type(error).__name__)[:200]
