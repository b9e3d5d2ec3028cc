"""API model of a stored verdict of the verifier; the worker processes build it too."""

from __future__ import annotations

from knifetip.api.schemas.verdicts import VerdictOut, VerdictSummary
from knifetip.model.verdict import EDGE_COLUMNS
from knifetip.presentation.columns import unpack_columns
from knifetip.presentation.verdict import areas_json, unpack_areas


def verdict_out(block: bytes) -> VerdictOut:
    """Return the API model of a stored verdict of the verifier.

    A column that the stored verdict does not have becomes an empty list; verdicts stored by older
    versions have fewer columns.

    Parameters
    ----------
    block
        The stored verdict: columns of measurements, and findings, packed into bytes.
    """
    columns, meta = unpack_columns(block)
    figures = {
        f"edge_{name}": columns[name].tolist() if name in columns else [] for name in EDGE_COLUMNS
    }
    summary = {name: meta[name] for name in VerdictSummary.model_fields if name in meta}
    return VerdictOut.model_validate(
        {
            **summary,
            **figures,
            "findings": meta["findings"],
            "areas": areas_json(unpack_areas(columns)),
        }
    )
