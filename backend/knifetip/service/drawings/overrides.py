"""Apply overrides, which set line types of edges selected by row, handle, layer or colour."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from knifetip.errors import RequestError
from knifetip.messages import Message
from knifetip.model.dieline import LineType
from knifetip.model.interpretation import NO_OVERRIDE
from knifetip.presentation.columns import unpack_columns
from knifetip.service.drawings.models import Override


def merge_overrides(block: bytes, before: bytes, overrides: Sequence[Override]) -> bytes:
    """Return the overrides of the n edges of a drawing after a request has changed them.

    An override is a line type that the user has set for one edge.

    Parameters
    ----------
    block
        ``EdgeTable`` of the drawing, packed into bytes.
    before
        Present overrides, n bytes: for each edge a LineType, or ``NO_OVERRIDE``.
    overrides
        Changes in the request, applied in order; later ones replace earlier ones.

    Returns
    -------
    bytes
        New overrides, n bytes as in ``before``.

    Raises
    ------
    RequestError
        A change selects no edge or an edge that does not exist, or it does not select edges in
        exactly one way (by row, by handle, or by layer and colour).
    """
    columns, meta = unpack_columns(block)
    after = np.frombuffer(before, np.uint8).copy()
    rows_of: dict[str, list[int]] = {}
    if any(override.handles is not None for override in overrides):
        for row, handle in enumerate(meta["handles"]):
            rows_of.setdefault(handle, []).append(row)
    for override in overrides:
        value = NO_OVERRIDE if override.type is None else LineType.from_word(override.type)
        after[_select_edges(override, columns, meta["layers"], rows_of, len(after))] = value
    return after.tobytes()


def _select_edges(
    override: Override,
    columns: dict[str, Any],
    layers: list[str],
    rows_of: dict[str, list[int]],
    count: int,
) -> list[int]:
    """Return the rows of the edges that an override selects.

    A row is the index of an edge in the ``EdgeTable`` of the drawing.

    ``override``: override in a request; it selects edges by row, by handle, or by layer and colour.
    ``columns``, ``layers``: columns of the ``EdgeTable``, and the layer names to which its column
    ``layer`` refers.
    ``rows_of``: rows of the edges of each entity, by the handle of the entity (its identifier in
    the file).
    Raises ``RequestError``: the override selects no edge or an edge that does not exist, or it does
    not select edges in exactly one of the three ways.
    """
    by_layer = override.layer is not None or override.colour is not None
    if (override.edges is not None) + (override.handles is not None) + by_layer != 1:
        raise RequestError("override.ambiguous")
    if override.edges is not None:
        if wrong := [str(row) for row in override.edges if not 0 <= row < count]:
            raise RequestError(
                "override.no-such-edge", count=count, edge=wrong[0][:20], source=wrong[:20]
            )
        return override.edges
    if override.handles is not None:
        if wrong := [handle for handle in override.handles if handle not in rows_of]:
            raise RequestError("override.no-such-handle", handle=wrong[0][:40], source=wrong[:20])
        return [row for handle in override.handles for row in rows_of[handle]]
    chosen = np.ones(count, bool)
    selection = []
    if override.layer is not None:
        same = [index for index, name in enumerate(layers) if name == override.layer]
        chosen &= np.isin(columns["layer"], same)
        selection.append(Message("override.on-layer", layer=override.layer[:80]))
    if override.colour is not None:
        colour = override.colour if 0 <= override.colour < 1000 else -1
        chosen &= columns["colour"] == colour
        selection.append(Message("override.of-colour", colour=str(override.colour)[:20]))
    if not chosen.any():
        raise RequestError("override.no-edges-there", place=selection)
    return np.flatnonzero(chosen).tolist()
