"""Functions that convert between an ``Interpretation`` and the columns of a drawing or a job.

An interpretation contains the user's decisions about a drawing: unit, profile, overrides (line
types of single edges), edits of the geometry, and options of a job (corner types, sheet and height
of turns).
"""

from __future__ import annotations

from typing import Any

from knifetip.model.edit import edits_from_json, edits_json
from knifetip.model.interpretation import Interpretation
from knifetip.model.job_options import JobOptions
from knifetip.service.database.tables import Drawing, Job


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
        learned=row.learned,
        edits=edits_from_json(row.edits),
        options=row.options if isinstance(row, Job) else JobOptions(),
    )


def drawing_columns(interpretation: Interpretation) -> dict[str, Any]:
    """Return the columns of a drawing that store an interpretation, by name of the column."""
    return {
        "unit_given": interpretation.unit,
        "profile": interpretation.profile,
        "rules": interpretation.rules,
        "overrides": interpretation.overrides,
        "learned": interpretation.learned,
        "edits": edits_json(interpretation.edits),
    }


def job_columns(interpretation: Interpretation) -> dict[str, Any]:
    """Return the columns of a job that store an interpretation, by name of the column."""
    return {
        **drawing_columns(interpretation),
        "stored_options": interpretation.options.model_dump(mode="json"),
    }
