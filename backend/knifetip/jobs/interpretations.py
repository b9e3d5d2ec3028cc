"""Functions that convert between an ``Interpretation`` and the columns of a drawing or a job.

An interpretation contains the user's decisions about a drawing: unit, profile, overrides (line
types of single edges), and choices for a job (corner types, sheet and height of turns).
"""

from __future__ import annotations

from typing import Any

from knifetip.jobs.tables import Drawing, Job
from knifetip.model.choices import Choices
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
    return Interpretation(
        unit=row.unit_given,
        profile=row.profile,
        rules=row.rules,
        overrides=overrides,
        choices=_choices_of(row) if isinstance(row, Job) else Choices(),
    )


def _choices_of(row: Job) -> Choices:
    """Return the choices stored with a job."""
    return Choices(
        None if row.corners is None else Corners.from_json(row.corners),
        None if row.sheet is None else Sheet.from_json(row.sheet),
        row.lift,
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
    corners, sheet = interpretation.choices.corners, interpretation.choices.sheet
    return {
        **drawing_columns(interpretation),
        "corners": None if corners is None else corners.as_json(),
        "sheet": None if sheet is None else sheet.as_json(),
        "lift": interpretation.choices.lift,
    }
