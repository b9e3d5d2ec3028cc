"""Cleaning does not depend on the order of lines in a file."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from knifetip import pipeline
from knifetip.cleaning.clean import clean
from knifetip.geometry import arc
from knifetip.library import load
from knifetip.model.dieline import Dieline, LineType
from tests.support.cartons import random_drawings

WORKED = [kind for kind in LineType if kind not in (LineType.UNCLASSIFIED, LineType.IGNORED)]


def shuffled(dieline: Dieline, seed: int) -> Dieline:
    order = np.random.default_rng(seed).permutation(len(dieline))
    columns = ("ends", "bulge", "line_type", "rule", "confidence", "face", "part")
    return replace(dieline, **{name: getattr(dieline, name)[order] for name in columns})


def worked(dieline: Dieline) -> dict[LineType, tuple[int, float]]:
    """Return the number and the total length (mm) of the cleaned edges of each line type."""
    made = clean(dieline).dieline
    lengths = arc.length(made.ends[:, 0], made.ends[:, 1], made.bulge)
    return {
        kind: (int(rows.sum()), float(lengths[rows].sum()))
        for kind in WORKED
        for rows in (made.line_type == kind,)
    }


@pytest.mark.parametrize("seed", range(60))
def test_a_shuffled_drawing_is_cleaned_with_the_same_result(seed: int) -> None:
    dieline = pipeline.classify(random_drawings.random_drawing(seed)[0], load.profile("default"))
    unclear = dieline.line_type == LineType.UNCLASSIFIED
    dieline = replace(dieline, line_type=np.where(unclear, LineType.CUT, dieline.line_type))
    expected = worked(dieline)
    assert sum(edges for edges, _ in expected.values()) > 0
    for other in range(2):
        found = worked(shuffled(dieline, other))
        for kind, (edges, length) in expected.items():
            # Of two coincident lines the first is kept; they differ slightly.
            assert found[kind][0] == edges
            assert found[kind][1] == pytest.approx(length, abs=0.01)
