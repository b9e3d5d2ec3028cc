"""Tasks of the worker processes that make large answers, as gzip data.

In the server's own process they would hold Python's lock and block all other requests.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Mapping
from itertools import chain
from typing import Any, Final

from pydantic import TypeAdapter

from knifetip.model.stage import Progress
from knifetip.presentation.drawn_edges import pack_drawn_edges
from knifetip.presentation.edges import EdgeTable
from knifetip.presentation.import_report import unpack_rows, with_defaults
from knifetip.presentation.picture import svg_picture
from knifetip.service.drawings.models import DrawingOut, PageOut
from knifetip.service.http.compression import pack
from knifetip.service.processes import tasks

#: Maximum number of import report rows in the JSON of a drawing.
_MAX_ROWS: Final = 2000


def drawing(_progress: Progress, fields: Mapping[str, Any], rows: bytes) -> bytes:
    """Return the JSON of a drawing (schema ``DrawingOut``); see ``drawing_model``."""
    return pack([drawing_model(fields, rows).model_dump_json().encode()])


def drawing_model(fields: Mapping[str, Any], rows: bytes) -> DrawingOut:
    """Return the API model of a drawing.

    Parameters
    ----------
    fields
        Fields of the drawing; its import report has no rows.
    rows
        Packed rows of the import report.
    """
    report = {**fields["import_report"], "rows": unpack_rows(rows, _MAX_ROWS)}
    return DrawingOut.model_validate({**fields, "import_report": report})


def edges(_progress: Progress, block: bytes) -> bytes:
    """Return the JSON of the edges of a packed ``EdgeTable`` (schema ``EdgesOut``)."""
    return pack(EdgeTable.unpack(block).json_pieces())


def drawn_edges(_progress: Progress, block: bytes) -> bytes:
    """Return the columns that a picture of a packed ``EdgeTable`` needs."""
    return pack([pack_drawn_edges(block)])


def import_report(
    _progress: Progress, counts: Mapping[str, int], rows: bytes, outcome: str | None
) -> bytes:
    """Return the JSON of an import report (schema ``ImportReportOut``).

    Parameters
    ----------
    counts
        Number of entities by outcome.
    rows
        Packed rows of the import report.
    outcome
        Outcome of the rows to return; None for all rows.
    """
    wanted = (row for row in unpack_rows(rows) if outcome in (None, row["outcome"]))
    return pack(_with_rows(counts, map(with_defaults, wanted)))


def cleaning_json(progress: Progress, block: bytes) -> bytes:
    """Return the JSON of the cleaning report of a packed ``EdgeTable`` (schema ``CleaningOut``).

    Raises
    ------
    UnitUnknown
        The drawing has no unit, so lengths in mm are unknown.
    """
    report = tasks.cleaning_report(progress, block)
    rows = report.pop("rows")
    return pack(_with_rows(report, rows))


def blanks(progress: Progress, block: bytes) -> bytes:
    """Return the JSON of the blanks of a packed ``EdgeTable`` (schema ``BlanksOut``).

    Raises
    ------
    UnitUnknown
        The drawing has no unit, so areas in mm² are unknown.
    """
    return pack([_json(tasks.blanks(progress, block))])


def picture(_progress: Progress, block: bytes) -> bytes:
    """Return a small picture of the edges of a packed ``EdgeTable`` as SVG."""
    return pack([svg_picture(block).encode()])


def pages(progress: Progress, content: bytes) -> bytes:
    """Return the JSON of the pages of a file (a list of ``PageOut``).

    Raises
    ------
    DrawingTooLarge
        Reading all pages took too much processor time.
    NotADrawing
        The file cannot be read.
    """
    listed = [PageOut.model_validate(page) for page in tasks.list_pages(progress, content)]
    return pack([TypeAdapter(list[PageOut]).dump_json(listed)])


def _with_rows(fields: Mapping[str, Any], rows: Iterable[Mapping[str, Any]]) -> Iterator[bytes]:
    """Yield the JSON of an object with the field ``rows``, row by row."""
    head = _json({**fields, "rows": []})
    yield head[: -len(b"]}")]
    separated = chain.from_iterable((b",", _json(row)) for row in rows)
    next(separated, None)  # no comma before the first row
    yield from separated
    yield b"]}"


def _json(content: Mapping[str, Any]) -> bytes:
    return json.dumps(content, ensure_ascii=False, allow_nan=False, separators=(",", ":")).encode()
