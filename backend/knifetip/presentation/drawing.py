"""A drawing as JSON data; REST, the command line and the store use the same definition."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from knifetip.geometry.columns import F64, U8
from knifetip.messages import printable
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.drawing import Drawing
from knifetip.model.interpretation import NO_OVERRIDE
from knifetip.model.question import Question
from knifetip.presentation.import_report import outcome_counts
from knifetip.presentation.import_warnings import import_warnings
from knifetip.presentation.outcomes import EdgeOutcomes


def drawing_json(drawing: Drawing) -> dict[str, Any]:
    """Return unit, total edge length, bounding box and edge count of a drawing as JSON data.

    The data also contain the evidence for the unit, and the numbers of entities that import kept,
    merged and dropped, and the warnings: contradictions about the unit, and what was left out.
    """
    min_x, min_y, max_x, max_y = (float(coordinate) for coordinate in drawing.bounds)
    finding = _unit_finding(drawing)
    return {
        "unit": drawing.unit or None,
        "evidence": printable(str(drawing.evidence)),
        "evidence_message": drawing.evidence.as_json(),
        "unit_finding": finding,
        "warnings": [
            *finding["warnings"],
            *(warning.as_json() for warning in import_warnings(drawing)),
        ],
        "segments": len(drawing),
        "length": float(drawing.lengths.sum()),
        "bounds": [min_x, min_y, max_x, max_y],
        "width": max_x - min_x,
        "height": max_y - min_y,
        "import_report": outcome_counts(drawing),
    }


def classified_json(
    drawing: Drawing,
    dieline: Dieline,
    outcomes: EdgeOutcomes,
    questions: Sequence[Question],
    overrides: U8,
) -> dict[str, Any]:
    """Return the data of a drawing for the page: drawing, classification and cleaning, as JSON.

    The data contain the fields of ``drawing_json`` (such as unit and bounding box), the number of
    edges by line type, the layers, the open questions, the number of overrides, and the outcomes.

    Parameters
    ----------
    drawing, dieline
        The drawing, and its edges with their line types.
    outcomes
        Outcome (kept, merged or dropped) and reason of each of n edges, with a summary.
    questions
        The open questions, which the user must answer.
    overrides : (n,)
        For each edge ``NO_OVERRIDE`` or the LineType that the user set.
    """
    data = drawing_json(drawing)
    return {
        **data,
        "warnings": [*data["warnings"], *(warning.as_json() for warning in outcomes.warnings)],
        "counts": _line_type_counts(dieline.line_type, drawing.lengths),
        "layers": _layers(drawing, dieline),
        "questions": [question.as_json() for question in questions],
        "overrides": int((overrides != NO_OVERRIDE).sum()),
        "report": outcomes.summary,
    }


def _unit_finding(drawing: Drawing) -> dict[str, Any]:
    """Return the evidence for the unit of a drawing as JSON data.

    The data contain the unit in the file, all units ranked by likelihood, and the observations.
    """
    from knifetip.units.evidence import find_unit

    finding = find_unit(drawing)
    return {
        "stated": drawing.stated,
        "ranking": list(finding.ranking),
        "warnings": [warning.as_json() for warning in finding.warnings],
        "evidence": [
            {"unit": one.unit, **one.message.as_json(), "weight": float(one.weight)}
            for one in finding.evidence
        ],
    }


def _line_type_counts(line_type: U8, lengths: F64) -> list[dict[str, Any]]:
    """Return the number and the total length (mm) of the edges of each line type that occurs.

    ``line_type``, ``lengths`` (n,): LineType and length (mm) of each edge.
    """
    edges = np.bincount(line_type, minlength=len(LineType))
    length = np.bincount(line_type, weights=lengths, minlength=len(LineType))
    return [
        {"type": kind.word, "edges": int(edges[kind]), "length": float(length[kind])}
        for kind in LineType
        if edges[kind]
    ]


def _layers(drawing: Drawing, dieline: Dieline) -> list[dict[str, Any]]:
    """Return one item for each pair of layer and colour that occurs in a drawing, as JSON data.

    An item contains the name of the layer, the colour, and the number, the total length (mm) and
    the line types of the edges with this layer and colour.
    """
    pairs, pair = np.unique(
        np.stack([drawing.layer, drawing.colour], axis=1), axis=0, return_inverse=True
    )
    pair = pair.reshape(-1)
    edges = np.bincount(pair, minlength=len(pairs))
    length = np.bincount(pair, weights=drawing.lengths, minlength=len(pairs))
    occurs = np.zeros((len(pairs), len(LineType)), bool)
    occurs[pair, dieline.line_type] = True
    names = [printable(layer) for layer in drawing.layers]
    return [
        {
            "name": names[layer],
            "colour": int(colour),
            "edges": int(edges[row]),
            "length": float(length[row]),
            "types": [kind.word for kind in LineType if occurs[row, kind]],
        }
        for row, (layer, colour) in enumerate(pairs)
    ]
