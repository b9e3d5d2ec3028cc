"""Functions that convert between an ``Interpretation`` and the columns of a drawing or a job.

An interpretation contains the user's decisions about a drawing: unit, profile, overrides (line
types of single edges), corner types and sheet.
"""

from __future__ import annotations

from typing import Any

from knifetip.jobs.tables import Drawing, Job
from knifetip.model.corners import Corners
from knifetip.model.interpretation import Interpretation
from knifetip.model.sheet import Sheet


def interpretation_of(row: Drawing | Job, overrides: bytes) -> Interpretation:
    """Return the interpretation stored with a drawing or a job.

    Parameters
    ----------
    row
        The drawing or the job.
    overrides
        The column ``overrides`` of ``row``, which the caller has loaded separately.
    """
    corners, sheet = (row.corners, row.sheet) if isinstance(row, Job) else (None, None)
    return Interpretation(
        unit=row.unit_given,
        profile=row.profile,
        rules=row.rules,
        overrides=overrides,
        corners=None if corners is None else Corners.from_json(corners),
        sheet=None if sheet is None else Sheet.from_json(sheet),
    )


def drawing_columns(interpretation: Interpretation) -> dict[str, Any]:
    """Return the columns of a drawing that store an interpretation, by name of the column."""
    return {
        "unit_given": interpretation.unit,
        "profile": interpretation.profile,
        "rules": interpretation.rules,
        "overrides": interpretation.overrides,
    }


def job_columns(interpretation: Interpretation) -> dict[str, Any]:
    """Return the columns of a job that store an interpretation, by name of the column."""
    corners, sheet = interpretation.corners, interpretation.sheet
    return {
        **drawing_columns(interpretation),
        "corners": None if corners is None else corners.as_json(),
        "sheet": None if sheet is None else sheet.as_json(),
    }
