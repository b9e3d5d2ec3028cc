"""Restores a drawing and its dieline from the data that were stored when the file was read.

The stored data contain everything that questions to the user, planning and verification need.  A
file is therefore read and classified only once: at upload, or when its unit or profile changes.
The dieline contains the edges with their line types.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any

import numpy as np

from knifetip.edits import apply_edits
from knifetip.geometry.columns import U8
from knifetip.messages import printable
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.drawing import Drawing
from knifetip.model.edit import Edits
from knifetip.model.interpretation import NO_OVERRIDE, Interpretation
from knifetip.presentation.edges import restore_drawing, stored_handles


@dataclass(frozen=True, slots=True)
class Reading:
    """Result of reading and classifying a drawing, in the form in which it is stored."""

    summary: dict[str, Any]
    edges: bytes  #: packed ``EdgeTable``
    import_report: bytes  #: JSON, deflated
    overrides: bytes  #: (n,) ``NO_OVERRIDE`` or a LineType
    uses: list[dict[str, Any]]  #: what the drawing teaches, see ``customer_answers.use_json``
    drawn_edges: bytes = b""  #: what a first picture of many edges needs, gzip; empty of fewer


@dataclass(frozen=True, slots=True)
class StoredDrawing:
    """A stored drawing: its file, its edges, and the interpretation used to read the file."""

    content: bytes  #: the file
    edges: bytes  #: packed ``EdgeTable`` of the drawing
    interpretation: Interpretation  #: interpretation of the reading
    is_layout: bool = False  #: whether the file is a ``LayoutArchive``


def restore_or_read(
    stored: StoredDrawing, interpretation: Interpretation
) -> tuple[Drawing, Dieline]:
    """Return a drawing and its dieline (edges with line types) for an interpretation.

    Both are restored from the stored edges if these conditions are met: the unit is known, the
    stored interpretation has the same unit, profile, learned answers and edits, no override was
    removed, the edges were stored with their distances from the curves of the file, and, if there
    are new overrides, no line type followed from earlier ones or may follow from both.  Otherwise
    the file is read again.  An override is a line type that the user has set for an edge; the line
    type that the edge had before is not stored.

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
            if drawing.unit and np.isfinite(drawing.fit_error).all():
                overrides = np.frombuffer(interpretation.overrides, np.uint8)
                if (answered := _apply_new(drawing, dieline, changed, overrides)) is not None:
                    return drawing, answered
    from knifetip import pipeline

    drawing = read_drawing(stored.content, interpretation.unit, interpretation.edits)
    overrides = np.frombuffer(interpretation.overrides, np.uint8)
    if len(overrides) not in (0, len(drawing)):
        # An older version divided the curves of the file into other edges.
        handles = [printable(handle) for handle in drawing.handles]
        carried = carry_over(overrides, stored_handles(stored.edges), handles)
        interpretation = replace(interpretation, overrides=carried.tobytes())
    return drawing, pipeline.interpret(drawing, interpretation)


def carry_over(before: U8, handles: Sequence[str], new_handles: Sequence[str]) -> U8:
    """Return overrides for m edges from the overrides of n edges of the same file, shape (m,).

    An override is the line type that the user has set for an edge, or ``NO_OVERRIDE``.  The n edges
    were found when the file was read before, the m edges now.  Where a handle has as many edges as
    before, they keep their overrides.  Otherwise a new edge gets the override that all earlier
    edges with its handle have in common, or ``NO_OVERRIDE`` if there is none.

    Parameters
    ----------
    before : (n,)
        Overrides of the earlier edges.
    handles : (n,)
        Handles of the earlier edges.
    new_handles : (m,)
        Handles of the new edges.
    """
    if list(handles) == list(new_handles):
        return before
    overrides_of: dict[str, list[int]] = {}
    for handle, override in zip(handles, before.tolist(), strict=True):
        overrides_of.setdefault(handle, []).append(override)
    counts = Counter(new_handles)
    for handle, found in overrides_of.items():
        if len(found) != counts[handle]:
            agreed = found[0] if len(set(found)) == 1 else NO_OVERRIDE
            overrides_of[handle] = [agreed] * counts[handle]
    kept = {handle: iter(found) for handle, found in overrides_of.items()}
    return np.array(
        [next(kept.get(handle, iter(())), NO_OVERRIDE) for handle in new_handles], np.uint8
    )


# Changes of overrides or profile need the same drawing again: cache the last few.
@lru_cache(maxsize=4)
def read_drawing(content: bytes, unit: str, edits: Edits = ()) -> Drawing:
    """Return the drawing that a file contains, as edited; the last four of them are cached.

    Parameters
    ----------
    content
        The file.
    unit
        Unit that the user has set, "" for the unit of the file.
    edits
        Changes of the geometry that the user has made.

    Raises
    ------
    ReadError
        The file cannot be read.
    EditRefused
        An edit is not possible.
    """
    from knifetip import pipeline

    if edits:
        return apply_edits(read_drawing(content, unit), edits)
    return pipeline.read(content, unit or None)


def _new_overrides(stored: Interpretation, interpretation: Interpretation) -> U8 | None:
    """Return the overrides that must still be applied to the n edges of a stored drawing, (n,).

    An override is the LineType that the user has set for an edge.  The result is ``NO_OVERRIDE``
    for an edge whose override is the same in both interpretations.  The result is None if the file
    must be read again: the unit, the profile or what earlier drawings taught differs, the
    interpretations have different numbers of edges, or an override was removed.
    """
    if any(
        getattr(stored, name) != getattr(interpretation, name)
        for name in ("unit", "profile", "rules", "learned", "edits")
    ):
        return None
    stored_overrides, overrides = (
        np.frombuffer(one.overrides, np.uint8) for one in (stored, interpretation)
    )
    changed = stored_overrides != overrides if len(stored_overrides) == len(overrides) else None
    if changed is None or (overrides[changed] == NO_OVERRIDE).any():
        return None
    return np.where(changed, overrides, NO_OVERRIDE).astype(np.uint8)


def _apply_new(drawing: Drawing, dieline: Dieline, changed: U8, overrides: U8) -> Dieline | None:
    """Return a stored dieline with new overrides; None if the drawing must be classified again.

    What followed from the earlier overrides may not follow from the new ones.  ``changed`` (n,) are
    the new overrides, and ``overrides`` (n,) are all of them.
    """
    if (changed == NO_OVERRIDE).all():
        return dieline
    from knifetip.classification.answers import FOLLOWS, follow_answers
    from knifetip.classification.classify import apply_overrides

    if FOLLOWS in dieline.rules:
        return None
    # What the drawing suggested for the edges of earlier overrides is not stored.
    is_open = (dieline.line_type == LineType.UNCLASSIFIED) & (changed == NO_OVERRIDE)
    if is_open.any() and ((overrides != NO_OVERRIDE) & (changed == NO_OVERRIDE)).any():
        return None
    return follow_answers(drawing, dieline, apply_overrides(dieline, changed), overrides)
