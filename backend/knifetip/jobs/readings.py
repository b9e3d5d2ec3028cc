"""The stored reading of a drawing, and the records that a compile restores from it.

    Drawing, Dieline, Report  ⇄  block of columns, one row per edge

A reading contains all data that questions, planning and verification need, so a file is read and
classified only once: at upload, or when its unit or profile changes.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from knifetip.geometry.columns import U8
from knifetip.jobs.columns import packed, unpacked
from knifetip.jobs.report import Report, said
from knifetip.messages import Message, from_json, render
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.drawing import KEPT, Drawing, ImportOutcome, ImportReport
from knifetip.model.interpretation import NO_OVERRIDE, Interpretation
from knifetip.model.words import Repeated


@dataclass(frozen=True, slots=True)
class StoredDrawing:
    """A file with its stored reading."""

    content: bytes  #: the file
    edges: bytes  #: reading, see ``edge_block``
    interpretation: Interpretation  #: interpretation of the reading


def edge_block(drawing: Drawing, dieline: Dieline, report: Report) -> bytes:
    """Return the reading of a drawing as a block of columns, see ``columns``."""
    return packed(
        {
            "ends": dieline.ends,
            "bulge": dieline.bulge,
            "line_type": dieline.line_type,
            "layer": drawing.layer,
            "colour": drawing.colour,
            "true_colour": drawing.true_colour,
            "linetype": drawing.linetype,
            "rule": dieline.rule,
            "confidence": dieline.confidence,
            "face": dieline.face,
            "part": dieline.part,
            "length": drawing.lengths,
            "outcome": report.outcome,
            "reason": report.reason,
        },
        {
            "handles": [said(handle) for handle in drawing.handles],
            "layers": [said(layer) for layer in drawing.layers],
            "linetypes": [said(name) for name in drawing.linetypes],
            "rules": [said(str(rule)) for rule in dieline.rules],
            "rule_messages": [rule.as_json() for rule in dieline.rules],
            "alternatives": [[kind.word for kind in one] for one in dieline.alternatives],
            "outcomes": [outcome.name.lower() for outcome in ImportOutcome],
            "reasons": [render(reason) for reason in report.reasons],
            "reason_messages": [reason.as_json() for reason in report.reasons],
            "types": [kind.word for kind in LineType],
            "unit": drawing.unit,
        },
    )


def unpacked_reading(edges: bytes) -> tuple[Drawing, Dieline]:
    """Return the drawing and the dieline of a reading.

    The import report of the drawing has one row per edge; entities without edges and texts are not
    stored with the edges.

    Raises
    ------
    KeyError
        The reading was stored by an older version and lacks a column.
    """
    columns, meta = unpacked(edges)
    count = len(columns["bulge"])
    row = np.arange(count, dtype=np.int32)
    layers = tuple(meta["layers"])
    import_report = ImportReport(
        handle=meta["handles"],
        kind=Repeated(("",), np.zeros(count, np.int32)),
        layer=Repeated(layers, columns["layer"]),
        outcome=np.full(count, ImportOutcome.KEPT, np.uint8),
        reason=Repeated((KEPT,), np.zeros(count, np.int32)),
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
        import_report=import_report,
        unit=meta["unit"],
        evidence=Message("unit.not-given"),
    )
    dieline = Dieline(
        columns["ends"],
        columns["bulge"],
        columns["line_type"],
        row,
        columns["rule"],
        columns["confidence"],
        tuple(map(from_json, meta.get("rule_messages") or meta["rules"])),
        tuple(tuple(LineType.of(word) for word in words) for words in meta["alternatives"]),
        columns["face"],
        columns["part"],
    )
    return drawing, dieline


def interpreted(stored: StoredDrawing, wanted: Interpretation) -> tuple[Drawing, Dieline]:
    """Return drawing and dieline for an interpretation, from the reading or from the file.

    The reading is used if unit and profile are the same and no override was removed: the reading
    does not contain the line type under an override.

    Raises
    ------
    ReadError, ProfileError
        The file or the profile cannot be read.
    """
    changed = _new_overrides(stored.interpretation, wanted)
    if changed is not None:
        try:
            drawing, dieline = unpacked_reading(stored.edges)
        except KeyError:
            pass
        else:
            # The question about the unit needs evidence from the whole file.
            if drawing.unit:
                return drawing, _overridden(dieline, changed)
    from knifetip import pipeline

    drawing = read_drawing(stored.content, wanted.unit)
    return drawing, pipeline.interpret(drawing, wanted)


# Changes of overrides or profile need the same drawing again: cache the last few.
@lru_cache(maxsize=4)
def read_drawing(content: bytes, unit: str) -> Drawing:
    """Read the drawing in a file; ``unit`` is the user's, "" for that of the file."""
    from knifetip import pipeline

    return pipeline.read(content, unit or None)


def _new_overrides(stored: Interpretation, wanted: Interpretation) -> U8 | None:
    """Return the overrides that a reading lacks, (n,); None if the reading cannot be used."""
    if (stored.unit, stored.profile, stored.rules) != (wanted.unit, wanted.profile, wanted.rules):
        return None
    before, after = (np.frombuffer(one.overrides, np.uint8) for one in (stored, wanted))
    changed = before != after if len(before) == len(after) else None
    if changed is None or (after[changed] == NO_OVERRIDE).any():
        return None
    return np.where(changed, after, NO_OVERRIDE).astype(np.uint8)


def _overridden(dieline: Dieline, overrides: U8) -> Dieline:
    if (overrides == NO_OVERRIDE).all():
        return dieline
    from knifetip.classification.classify import apply_overrides

    return apply_overrides(dieline, overrides)
