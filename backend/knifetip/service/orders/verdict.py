"""API model of a stored verdict of the verifier, and the task of a worker process that sends it."""

from __future__ import annotations

from knifetip.model.edge_figures import EDGE_FIGURES
from knifetip.model.stage import Progress
from knifetip.presentation.columns import unpack_columns
from knifetip.presentation.verdict import areas_json, unpack_areas
from knifetip.service.http.compression import pack
from knifetip.service.orders.verdict_models import VerdictOut, VerdictSummary


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
        f"edge_{name}": columns[name].tolist() if name in columns else [] for name in EDGE_FIGURES
    }
    summary = {name: meta[name] for name in VerdictSummary.model_fields if name in meta}
    result: VerdictOut = VerdictOut.model_validate(
        {
            **summary,
            **figures,
            "findings": meta["findings"],
            "areas": areas_json(unpack_areas(columns)),
        }
    )
    return result


def verdict(_progress: Progress, block: bytes) -> bytes:
    """Return the JSON of a stored verdict (schema ``VerdictOut``)."""
    return pack([verdict_out(block).model_dump_json().encode()])
