"""map_back: convert a verdict on the cleaned edges to a verdict on the drawn edges.

A maximum along a cleaned edge, such as its deviation, applies to every drawn edge that the cleaned
edge replaces.  A length on a cleaned edge, such as its uncut length, is divided among the drawn
edges that it replaces, in proportion to their lengths, so that sums are preserved.  A drawn edge
that only overlaps another drawn edge gets length 0.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any, Final

import numpy as np

from knifetip.geometry import arc
from knifetip.geometry.columns import Bool
from knifetip.model.cleaned import Cleaned
from knifetip.model.dieline import Dieline
from knifetip.model.edge_figures import EDGE_FIGURES, Share
from knifetip.model.verdict import Finding, Samples, Verdict

_WORST: Final = [name for name, one in EDGE_FIGURES.items() if one.share is Share.WORST]
_LENGTHS: Final = [name for name, one in EDGE_FIGURES.items() if one.share is Share.LENGTH]


class DrawnRows:
    """The drawn edges that cleaned edges replace.

    A cleaned edge replaces each drawn edge of which it contains a part.  It also replaces one that
    lies on it, and on no other for a greater length: both are the same line, and a user who leaves
    out only one of them still has the other.
    """

    def __init__(self, cleaned: Cleaned) -> None:
        parts = cleaned.stretches
        own = (parts.cleaned >= 0) & (
            ~parts.by_other_edge | (cleaned.cleaned_row[parts.row] == parts.cleaned)
        )
        row, target = parts.row[own], parts.cleaned[own]
        order = np.lexsort((row, target))
        self._row, self._target = row[order], target[order]
        self._shown = cleaned.dieline.source

    def first(self, cleaned: int) -> int:
        """Return the row of the drawn edge for which a cleaned edge is shown."""
        return int(self._shown[cleaned])

    def replaced_by(self, cleaned: int) -> tuple[int, ...]:
        """Return the rows of the drawn edges that a cleaned edge replaces, each once.

        The first is that for which it is shown; the others ascend.
        """
        low, high = np.searchsorted(self._target, (cleaned, cleaned + 1))
        return tuple(dict.fromkeys((self.first(cleaned), *self._row[low:high].tolist())))


def map_to_drawn(verdict: Verdict, cleaned: Cleaned, drawn: Dieline) -> Verdict:
    """Return the verdict on the drawn edges, converted from a verdict on the cleaned edges.

    A verdict contains the verifier's measurements of a program for each edge.  ``cleaned`` contains
    the cleaned edges, and which drawn edges each of them replaces.
    """
    count = len(drawn)
    parts = cleaned.stretches
    live = parts.cleaned >= 0
    row, target = parts.row[live], parts.cleaned[live]
    columns: dict[str, Any] = {}
    for name in _WORST:
        columns[name] = worst = np.zeros(count)
        if (measured := getattr(verdict, name)).any():
            np.maximum.at(worst, row, measured[target])
    own = live & ~parts.by_other_edge
    length = arc.length(drawn.ends[:, 0], drawn.ends[:, 1], drawn.bulge)
    size = ((parts.end - parts.begin) * length[parts.row])[own]
    whole = np.bincount(parts.cleaned[own], size, len(cleaned.dieline))
    fraction = size / whole[parts.cleaned[own]]
    for name in _LENGTHS:
        columns[name] = np.zeros(count)
        if (measured := getattr(verdict, name)).any():
            part = fraction * measured[parts.cleaned[own]]
            columns[name] = np.bincount(parts.row[own], part, count).astype(np.float64)
    drawn_rows = DrawnRows(cleaned)
    return replace(
        verdict,
        **columns,
        tidied=np.maximum(cleaned.off, cleaned.moved),
        samples=_samples(verdict.samples, cleaned, drawn, own),
        findings=tuple(_on_drawn(finding, drawn_rows) for finding in verdict.findings),
    )


def _on_drawn(finding: Finding, drawn_rows: DrawnRows) -> Finding:
    """Return a finding on a cleaned edge with the drawn edges that this edge replaces."""
    message = finding.message.located(
        lambda cleaned: drawn_rows.first(cleaned) if cleaned >= 0 else cleaned
    )
    if finding.edge < 0:
        return replace(finding, message=message)
    edges = drawn_rows.replaced_by(finding.edge)
    others = edges if len(edges) > 1 else ()
    return replace(finding, message=message, edge=edges[0], edges=others)


def _samples(samples: Samples, cleaned: Cleaned, drawn: Dieline, is_owned: Bool) -> Samples:
    """Return the samples of a verdict with positions on drawn edges instead of cleaned edges.

    A sample is the deviation of the tip at a position of an edge.  ``is_owned`` has one entry per
    stretch, which is a part of a drawn edge.  It marks the stretches that belong to a cleaned edge
    and do not overlap another edge.
    """
    parts = cleaned.stretches
    if len(samples.edge) == 0 or not cleaned.changed.any():
        return samples
    row, target = parts.row[is_owned], parts.cleaned[is_owned]
    start, end, bulge = drawn.ends[row, 0], drawn.ends[row, 1], drawn.bulge[row]
    on = cleaned.dieline.ends[target]
    to = cleaned.dieline.bulge[target]
    first, last = (
        arc.nearest_fraction(
            on[:, 0], on[:, 1], to, arc.point_at(start, end, bulge, fraction[is_owned])
        )
        for fraction in (parts.begin, parts.end)
    )
    low, high = np.minimum(first, last), np.maximum(first, last)
    order = np.lexsort((low, target))
    # The integer part of the key is the cleaned edge.
    key = target[order] + 0.5 * low[order]
    at = np.searchsorted(key, samples.edge + 0.5 * np.clip(samples.place, 0.0, 1.0), "right") - 1
    # A sample just before the first part of its edge, by rounding, belongs to that part.
    before = target[order][np.maximum(at, 0)] != samples.edge
    part = order[np.clip(np.where(before, at + 1, at), 0, len(order) - 1)]
    span = np.where(high > low, high - low, 1.0)[part]
    fraction = np.clip((samples.place - low[part]) / span, 0.0, 1.0)
    back = (last < first)[part]
    fraction = np.where(back, 1.0 - fraction, fraction)
    begin, finish = parts.begin[is_owned][part], parts.end[is_owned][part]
    place = np.clip(begin + fraction * (finish - begin), 0.0, 1.0)
    edge = row[part]
    deviation = np.where(back, -samples.deviation, samples.deviation)
    tidy = np.lexsort((place, edge))
    return Samples(edge[tidy], place[tidy], deviation[tidy])
