"""Restores a drawing and its dieline from the stored reading of the drawing.

A *reading* contains all data that questions, planning and verification need, so a file is read and
classified only once: at upload, or when its unit or profile changes.  The dieline contains the
edges with their line types.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from knifetip.geometry.columns import U8
from knifetip.model.dieline import Dieline
from knifetip.model.drawing import Drawing
from knifetip.model.interpretation import NO_OVERRIDE, Interpretation
from knifetip.presentation.edges import restore_drawing


@dataclass(frozen=True, slots=True)
class StoredDrawing:
    """The file of a drawing, its stored edges, and the interpretation with which it was read."""

    content: bytes  #: the file
    edges: bytes  #: packed ``EdgeTable`` of the drawing
    interpretation: Interpretation  #: interpretation of the reading


def restore_or_read(
    stored: StoredDrawing, interpretation: Interpretation
) -> tuple[Drawing, Dieline]:
    """Return a drawing and its dieline (edges with line types) for an interpretation.

    They are restored from the stored edges if the stored interpretation has the same profile and an
    equal, known unit, and if no override was removed; otherwise the file is read again.  It is read
    again after the removal of an override because the line type under the override is not stored.

    Parameters
    ----------
    stored
        File, stored edges and stored interpretation of the drawing.
    interpretation
        Unit, profile and overrides of the returned drawing and dieline.

    Raises
    ------
    ReadError, ProfileError
        The file or the profile cannot be read.
    """
    changed = _new_overrides(stored.interpretation, interpretation)
    if changed is not None:
        try:
            drawing, dieline = restore_drawing(stored.edges)
        except KeyError:
            pass
        else:
            # The question about the unit needs evidence from the whole file.
            if drawing.unit:
                return drawing, _apply_new_overrides(dieline, changed)
    from knifetip import pipeline

    drawing = read_drawing(stored.content, interpretation.unit)
    return drawing, pipeline.interpret(drawing, interpretation)


# Changes of overrides or profile need the same drawing again: cache the last few.
@lru_cache(maxsize=4)
def read_drawing(content: bytes, unit: str) -> Drawing:
    """Return the drawing that a file contains; the last four drawings read are cached.

    Parameters
    ----------
    content
        The file.
    unit
        Unit that the user has set, "" for the unit of the file.
    """
    from knifetip import pipeline

    return pipeline.read(content, unit or None)


def _new_overrides(stored: Interpretation, interpretation: Interpretation) -> U8 | None:
    """Return the overrides that must still be applied to a stored drawing, (n,), or None.

    An override is the LineType that the user has set for an edge.  An edge that already has the
    right line type gets ``NO_OVERRIDE``.  Returns None if the file must be read again: if unit or
    profile differ, the numbers of overrides differ, or an override was removed.

    Parameters
    ----------
    stored, interpretation
        Interpretation of the stored drawing, and interpretation that is needed.
    """
    if (stored.unit, stored.profile, stored.rules) != (
        interpretation.unit,
        interpretation.profile,
        interpretation.rules,
    ):
        return None
    stored_overrides, overrides = (
        np.frombuffer(one.overrides, np.uint8) for one in (stored, interpretation)
    )
    changed = stored_overrides != overrides if len(stored_overrides) == len(overrides) else None
    if changed is None or (overrides[changed] == NO_OVERRIDE).any():
        return None
    return np.where(changed, overrides, NO_OVERRIDE).astype(np.uint8)


def _apply_new_overrides(dieline: Dieline, overrides: U8) -> Dieline:
    if (overrides == NO_OVERRIDE).all():
        return dieline
    from knifetip.classification.classify import apply_overrides

    return apply_overrides(dieline, overrides)
