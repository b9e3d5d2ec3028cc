"""interpretations: the interpretation of a drawing in the columns of a row of the store."""

from __future__ import annotations

from typing import Any

from knifetip.jobs.tables import Drawing, Job
from knifetip.model.corners import Corners
from knifetip.model.interpretation import Interpretation


def interpretation_of(row: Drawing | Job, overrides: bytes) -> Interpretation:
    """Return the interpretation by which a drawing was read, or is to be compiled for a job.

    Parameters
    ----------
    overrides
        The row's column of that name, which is only loaded on request.
    """
    corners = row.corners if isinstance(row, Job) else None
    return Interpretation(
        unit=row.unit_given,
        profile=row.profile,
        rules=row.rules,
        overrides=overrides,
        corners=None if corners is None else Corners.from_json(corners),
    )


def drawing_columns(interpretation: Interpretation) -> dict[str, Any]:
    """Return the columns of a drawing's row that hold its interpretation."""
    return {
        "unit_given": interpretation.unit,
        "profile": interpretation.profile,
        "rules": interpretation.rules,
        "overrides": interpretation.overrides,
    }


def job_columns(interpretation: Interpretation) -> dict[str, Any]:
    """Return the columns of a job's row that hold the interpretation of its drawing."""
    corners = interpretation.corners
    return {
        **drawing_columns(interpretation),
        "corners": None if corners is None else corners.as_json(),
    }
