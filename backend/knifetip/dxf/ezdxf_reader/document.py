"""document: load the bytes of a DXF file as an ezdxf document, repaired if necessary.

The file is loaded in several attempts until one succeeds: unchanged; repaired by ezdxf's recovery
mode; with subclass markers added; and without entities that have no geometry to cut.
"""

from __future__ import annotations

import io
import logging
import time
from collections.abc import Callable, Iterator
from contextlib import suppress

from ezdxf import recover
from ezdxf.document import Drawing as Document
from ezdxf.lldxf.tagger import binary_tags_loader

from knifetip.dxf.ezdxf_reader.place import refuse_after
from knifetip.dxf.ezdxf_reader.prescan import BINARY, Prescan
from knifetip.dxf.ezdxf_reader.rewrite import UNMARKED, as_text, lines_only, with_markers
from knifetip.errors import NotADrawing
from knifetip.formats.limits import Limits

# ezdxf logs every tag that it repairs; users read the import report instead.
logging.getLogger("ezdxf").addHandler(logging.NullHandler())


def load_document(data: bytes, counted: Prescan, limits: Limits) -> Document:
    """Return the ezdxf document of a DXF file, which is repaired if ezdxf cannot load it as it is.

    The file is loaded in several attempts, each of which repairs more of its content, until one
    succeeds.

    Parameters
    ----------
    data
        Content of the file.
    counted
        The entities and defects of the file as written; they determine which repairs are tried.
    limits
        Limits of size and reading time.

    Raises
    ------
    NotADrawing
        All attempts fail.
    DrawingTooLarge
        The attempts take longer than the limits allow.
    """
    reasons: list[str] = []
    deadline = time.monotonic() + limits.seconds
    for attempt in _attempts(data, counted):
        refuse_after(deadline, limits)
        try:
            return attempt()
        except Exception as error:
            reasons.append(describe_error(error))
    raise NotADrawing("reading.damaged", reason=reasons[-1], format="DXF")


def _attempts(data: bytes, counted: Prescan) -> Iterator[Callable[[], Document]]:
    """Yield functions that try to load the document of a DXF file.

    The functions are ordered from the least to the greatest change that they make to the content
    ``data`` before loading.  ``counted`` contains the entities and defects of the file as written.
    """
    if data.startswith(BINARY):
        yield lambda: Document.load(binary_tags_loader(data, errors="replace"))
        with suppress(Exception):
            tags = binary_tags_loader(data, errors="replace")
            yield from _ways_to_load_lines(as_text(tags, counted.encoding), counted)
    else:
        yield from _ways_to_load_text(data, counted)
        yield from _ways_to_load_lines(data, counted)


def _ways_to_load_lines(data: bytes, counted: Prescan) -> Iterator[Callable[[], Document]]:
    lines = lines_only(data)
    yield from _ways_to_load_text(lines, counted)
    yield lambda: _recover_document(with_markers(lines, every=True))


def _ways_to_load_text(data: bytes, counted: Prescan) -> Iterator[Callable[[], Document]]:
    if counted.markers and counted.variables.get("$ACADVER", "") <= UNMARKED:
        data = with_markers(data, every=True)
    yield lambda: _load_text(data, counted.encoding)
    yield lambda: _recover_document(data)
    if counted.unmarked:
        yield lambda: _load_text(with_markers(data), counted.encoding)
        yield lambda: _recover_document(with_markers(data))
    if counted.markers and "$ACADVER" not in counted.variables:
        # Without a version ezdxf reads the file as R12, which has no subclass markers.
        head = b"0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1015\n0\nENDSEC\n"
        yield lambda: _recover_document(head + data)


def _load_text(data: bytes, encoding: str) -> Document:
    with io.TextIOWrapper(io.BytesIO(data), encoding=encoding, errors="replace") as stream:
        return Document.read(stream)


def _recover_document(data: bytes) -> Document:
    document, _ = recover.read(io.BytesIO(data), errors="replace")
    return document


def describe_error(error: Exception) -> str:
    """Return the message of an ezdxf exception in one line of at most 200 characters."""
    text = str(error).removeprefix("DXFStructureError: ").strip().rstrip(".")
    return (text or type(error).__name__)[:200]
