"""``clean`` with drawings by other authors: results of each file, and lengths that add up.

All edges are classified by colour as one of two line types, so that all of them are cleaned.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from knifetip.cleaning.clean import clean
from knifetip.dxf.read import read
from knifetip.errors import KnifetipError
from knifetip.geometry import arc
from knifetip.model.cleaned import Cleaned, CleaningReason
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.drawing import Drawing, ImportOutcome
from knifetip.verification.checks.cleaning.check import check_cleaning
from tests.support.shapes import BY_HAND

pytestmark = pytest.mark.corpus


def all_work(drawing: Drawing) -> Dieline:
    kinds = np.where(drawing.colour % 2 == 0, LineType.CUT, LineType.CREASE)
    count = len(drawing)
    rows = np.arange(count)
    zeros = np.zeros(count)
    return Dieline(
        drawing.ends,
        drawing.bulge,
        kinds,
        rows.astype(np.int32),
        np.zeros(len(rows), np.int32),
        zeros + 1.0,
        (BY_HAND,),
    )


def figures(made: Cleaned) -> tuple[int, int, int]:
    return (
        made.count(ImportOutcome.KEPT),
        made.count(ImportOutcome.MERGED),
        made.count(ImportOutcome.DROPPED),
    )


@pytest.mark.parametrize(
    ("name", "expected", "merged", "dropped"),
    [
        # Four cuts of 40 mm that lie on cuts of 50 mm.
        ("Obrary__Parametric-Papercraft/Interchange-Files/cube.dxf", (70, 4, 0), 160.0, 0.0),
        # Two cuts of 1 mm that lie on creases of 152 mm.
        ("generated__kyholdings__diecut_generator/mailer_200x150x60_t3.dxf", (88, 2, 0), 2.0, 0.0),
        # A sheet without flaws.
        ("generated__bikinon__RSC-FEFCO-02xx/f0201_B_400x300x250.dxf", (56, 0, 0), 0.0, 0.0),
        # Corners of 0.05 mm in segments of a few micrometres, loops at them, coincident sides.
        ("generated__florianfesti__boxes/PaperBox_100x40x140.dxf", (278, 256, 115), 60.11, 2.647),
        # Coasts in steps of a few hundredths; every border between two states is drawn twice.
        ("mozman__ezdxf/examples/edgeminer/5_us_states.dxf", (2165, 2469, 20), 10.28, 0.2543),
    ],
)
def test_numbers_of_kept_merged_and_dropped_edges(
    corpus: Path, name: str, expected: tuple[int, int, int], merged: float, dropped: float
) -> None:
    made = clean(all_work(read((corpus / name).read_bytes(), "mm")))
    assert figures(made) == expected
    assert made.merged.sum() == pytest.approx(merged, abs=0.01)
    assert made.dropped.sum() == pytest.approx(dropped, abs=0.001)


def test_the_lengths_add_up_and_the_verifier_agrees_on_every_drawing(corpus: Path) -> None:
    files = [path for path in sorted(corpus.rglob("*")) if path.suffix.lower() == ".dxf"]
    count = 0
    for path in files:
        try:
            drawing = read(path.read_bytes(), "mm")
        except KnifetipError:
            continue
        line = all_work(drawing)
        made = clean(line)
        length = drawing.lengths
        slack = 1e-9 * length.max(initial=1.0) + 1e-6
        assert np.abs(made.kept + made.merged + made.dropped - length).max(initial=0) < slack, path
        after = made.dieline
        at_work = after.line_type != LineType.IGNORED
        worked = arc.length(after.ends[:, 0], after.ends[:, 1], after.bulge)[at_work].sum()
        assert made.lengths["worked"] == pytest.approx(worked, rel=1e-9), path
        assert check_cleaning(line, made) == [], path
        assert not (made.reason == CleaningReason.NO_WORK).any()
        count += 1
        # Edges that may not be moved a second time are free again in a new drawing.
        if (made.reason == CleaningReason.NEAR).any():
            continue
        again = clean(after)
        np.testing.assert_array_equal(again.dieline.ends, after.ends, err_msg=str(path))
        np.testing.assert_array_equal(again.dieline.line_type, after.line_type, err_msg=str(path))
    assert count > 70
