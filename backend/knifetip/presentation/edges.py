"""Edges of a classified drawing: as arrays with one row per edge, and as JSON data.

The arrays contain all data that questions, planning and verification need, so a drawing can be
restored from them without reading its file again.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from typing import Any, Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from knifetip.messages import Message, from_json, printable, render
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.drawing import KEPT, NO_LINE_WIDTH, Drawing, ImportOutcome, ImportReport
from knifetip.model.words import RepeatedValues
from knifetip.presentation.columns import pack_columns, unpack_columns
from knifetip.presentation.outcomes import EdgeOutcomes

#: Number of edges that are encoded as JSON at a time.
_BATCH: Final = 1000


class EdgeTable(NamedTuple):
    """Arrays with one row per edge of a drawing, with metadata.

    The metadata contain the lists of names to which indices in the arrays refer, such as the
    layers.
    """

    columns: Mapping[str, NDArray[Any]]  #: each has one row per edge
    meta: Mapping[str, Any]  #: handles (n,), layers, linetypes, rules, outcomes, reasons, types

    @classmethod
    def from_drawing(cls, drawing: Drawing, dieline: Dieline, outcomes: EdgeOutcomes) -> EdgeTable:
        """Return the table of the edges of a drawing, with their line types and outcomes.

        Parameters
        ----------
        drawing, dieline
            The drawing, and its edges with their line types.
        outcomes
            Whether each edge was kept, merged or dropped, with the reason.
        """
        return cls(
            {
                "ends": dieline.ends,
                "bulge": dieline.bulge,
                "line_type": dieline.line_type,
                "layer": drawing.layer,
                "colour": drawing.colour,
                "true_colour": drawing.true_colour,
                "linetype": drawing.linetype,
                "line_width": drawing.line_width,
                "rule": dieline.rule,
                "confidence": dieline.confidence,
                "face": dieline.face,
                "part": dieline.part,
                "fit_error": drawing.fit_error,
                "length": drawing.lengths,
                "outcome": outcomes.outcome,
                "reason": outcomes.reason,
            },
            {
                "handles": [printable(handle) for handle in drawing.handles],
                "layers": [printable(layer) for layer in drawing.layers],
                "linetypes": [printable(name) for name in drawing.linetypes],
                "rules": [printable(str(rule)) for rule in dieline.rules],
                "rule_messages": [rule.as_json() for rule in dieline.rules],
                "alternatives": [[kind.word for kind in one] for one in dieline.alternatives],
                "outcomes": [outcome.name.lower() for outcome in ImportOutcome],
                "reasons": [render(reason) for reason in outcomes.reasons],
                "reason_messages": [reason.as_json() for reason in outcomes.reasons],
                "types": [kind.word for kind in LineType],
                "unit": drawing.unit,
            },
        )

    @classmethod
    def unpack(cls, block: bytes) -> EdgeTable:
        """Return the table that ``pack`` wrote to a block of bytes.

        Tables that older versions stored have no outcomes, and all their edges count as kept, or no
        line widths.
        """
        columns, meta = unpack_columns(block)
        missing = np.zeros(len(columns["ends"]), np.int32)
        no_width = missing + NO_LINE_WIDTH
        return cls(
            {"outcome": missing, "reason": missing, "line_width": no_width, **columns},
            {"outcomes": ["kept"], "reasons": [""], "alternatives": [], **meta},
        )

    def pack(self) -> bytes:
        """Return the table as one block of bytes, in the layout of ``presentation.columns``."""
        return pack_columns(self.columns, self.meta)

    def rows(self, first: int = 0, last: int | None = None) -> list[dict[str, Any]]:
        """Return the edges in rows ``first`` to ``last - 1`` as JSON data (schema ``EdgeOut``).

        If ``last`` is None, all edges from ``first`` on are returned.
        """
        values = {name: column[first:last].tolist() for name, column in self.columns.items()}
        meta = self.meta
        alternatives = meta["alternatives"]
        rows = []
        for index, (start, end) in enumerate(values["ends"]):
            rule = values["rule"][index]
            rows.append(
                {
                    "row": first + index,
                    "handle": meta["handles"][first + index],
                    "layer": meta["layers"][values["layer"][index]],
                    "colour": values["colour"][index],
                    "linetype": meta["linetypes"][values["linetype"][index]],
                    "line_width": millimetres(values["line_width"][index]),
                    "type": meta["types"][values["line_type"][index]],
                    "rule": meta["rules"][rule] if rule >= 0 else "",
                    "confidence": values["confidence"][index],
                    "alternatives": alternatives[rule] if alternatives and rule >= 0 else [],
                    "outcome": meta["outcomes"][values["outcome"][index]],
                    "reason": meta["reasons"][values["reason"][index]],
                    "length": values["length"][index],
                    "start": start,
                    "end": end,
                    "bulge": values["bulge"][index],
                }
            )
        return rows

    def json_pieces(self) -> Iterator[bytes]:
        """Yield the JSON text of all edges (schema ``EdgesOut``) in pieces.

        Other threads can run between two pieces.
        """
        yield b'{"edges":['
        for first in range(0, len(self.columns["ends"]), _BATCH):
            rows = self.rows(first, first + _BATCH)
            text = json.dumps(rows, ensure_ascii=False, allow_nan=False, separators=(",", ":"))
            yield (("," if first else "") + text[1:-1]).encode()
        yield b"]}"


def millimetres(line_width: int) -> float | None:
    """Return a line width (1/100 mm) in mm, None for ``NO_LINE_WIDTH``."""
    return None if line_width == NO_LINE_WIDTH else line_width / 100.0


def stored_handles(block: bytes) -> list[str]:
    """Return the handle of each of the n edges of a packed EdgeTable, a list of n strings."""
    return list(unpack_columns(block)[1]["handles"])


def restore_drawing(block: bytes) -> tuple[Drawing, Dieline]:
    """Return the drawing and the dieline that a packed EdgeTable describes.

    The import report of the drawing has one row per edge.  The drawing has no annotations, and its
    report has no rows for entities without edges, because the table contains neither.  The column
    ``fit_error`` is infinite if a version that did not measure it stored the table, and the line
    widths are ``NO_LINE_WIDTH`` if a version that did not read them did.

    Raises
    ------
    KeyError
        The block was stored by an older version and lacks a column.
    """
    columns, meta = unpack_columns(block)
    count = len(columns["bulge"])
    row = np.arange(count, dtype=np.int32)
    fit_error = columns.get("fit_error", np.full(count, np.inf))
    layers = tuple(meta["layers"])
    report = ImportReport(
        handle=meta["handles"],
        kind=RepeatedValues(("",), np.zeros(count, np.int32)),
        layer=RepeatedValues(layers, columns["layer"]),
        outcome=np.full(count, ImportOutcome.KEPT, np.uint8),
        reason=RepeatedValues((KEPT,), np.zeros(count, np.int32)),
        length=columns["length"],
    )
    drawing = Drawing(
        ends=columns["ends"],
        bulge=columns["bulge"],
        entity=row,
        layer=columns["layer"],
        colour=columns["colour"],
        true_colour=columns["true_colour"],
        linetype=columns["linetype"],
        layers=layers,
        linetypes=tuple(meta["linetypes"]),
        import_report=report,
        unit=meta["unit"],
        evidence=Message("unit.not-given"),
        fit_error=fit_error,
        line_width=columns.get("line_width", np.full(count, NO_LINE_WIDTH, np.int32)),
    )
    dieline = Dieline(
        columns["ends"],
        columns["bulge"],
        columns["line_type"],
        row,
        columns["rule"],
        columns["confidence"],
        tuple(map(from_json, meta.get("rule_messages") or meta["rules"])),
        tuple(tuple(LineType.from_word(word) for word in words) for words in meta["alternatives"]),
        columns["face"],
        columns["part"],
        fit_error,
    )
    return drawing, dieline
