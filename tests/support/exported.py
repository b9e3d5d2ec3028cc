"""Drawings as they are stored, for tests of exports."""

from __future__ import annotations

from knifetip import pipeline
from knifetip.model.interpretation import Interpretation
from knifetip.presentation.edges import EdgeTable
from knifetip.presentation.outcomes import edge_outcomes


def stored_edges(data: bytes, unit: str | None = None) -> bytes:
    """Return the packed ``EdgeTable`` of the drawing in a file."""
    drawing = pipeline.read(data, unit)
    dieline = pipeline.interpret(drawing, Interpretation())
    return EdgeTable.from_drawing(drawing, dieline, edge_outcomes(drawing, dieline, None)).pack()
