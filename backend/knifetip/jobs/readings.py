"""The stored reading of a drawing, from which a compile restores the drawing and its dieline.

A *reading* contains all data that questions, planning and verification need, so a file is read and
classified only once: at upload, or when its unit or profile changes.
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
    """The file of a drawing, with its stored edges and the interpretation used for them."""

    content: bytes  #: the file
    edges: bytes  #: packed ``EdgeTable`` of the drawing
    interpretation: Interpretation  #: interpretation of the reading


def restore_or_read(stored: StoredDrawing, wanted: Interpretation) -> tuple[Drawing, Dieline]:
    """Return the drawing and its dieline for an interpretation.

    They are restored from the stored edges if the stored interpretation has the same profile and an
    equal, known unit, and if no override was removed; otherwise the file is read again.  A removed
    override makes this necessary because the line type under an override is not stored.

    Parameters
    ----------
    stored
        File, stored edges and stored interpretation of the drawing.
    wanted
        Interpretation of the returned drawing.

    Raises
    ------
    ReadError, ProfileError
        The file or the profile cannot be read.
    """
    changed = _new_overrides(stored.interpretation, wanted)
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

    drawing = read_drawing(stored.content, wanted.unit)
    return drawing, pipeline.interpret(drawing, wanted)


# Changes of overrides or profile need the same drawing again: cache the last few.
@lru_cache(maxsize=4)
def read_drawing(content: bytes, unit: str) -> Drawing:
    """Return the drawing in a file.

    Parameters
    ----------
    unit
        Unit that the user has set, "" for the unit of the file.
    """
    from knifetip import pipeline

    return pipeline.read(content, unit or None)


def _new_overrides(stored: Interpretation, wanted: Interpretation) -> U8 | None:
    """Return the overrides to add to a stored drawing, (n,) with one per edge.

    Returns None if the stored drawing cannot be used for the wanted interpretation.

    Parameters
    ----------
    stored, wanted
        Interpretation of the stored drawing, and interpretation that is needed.
    """
    if (stored.unit, stored.profile, stored.rules) != (wanted.unit, wanted.profile, wanted.rules):
        return None
    before, after = (np.frombuffer(one.overrides, np.uint8) for one in (stored, wanted))
    changed = before != after if len(before) == len(after) else None
    if changed is None or (after[changed] == NO_OVERRIDE).any():
        return None
    return np.where(changed, after, NO_OVERRIDE).astype(np.uint8)


def _apply_new_overrides(dieline: Dieline, overrides: U8) -> Dieline:
    if (overrides == NO_OVERRIDE).all():
        return dieline
    from knifetip.classification.classify import apply_overrides

    return apply_overrides(dieline, overrides)
