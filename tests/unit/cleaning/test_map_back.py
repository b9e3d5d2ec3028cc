"""``map_to_drawn``: measures of cleaned edges are assigned to the drawn edges."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from knifetip.cleaning.clean import clean
from knifetip.cleaning.map_back import map_to_drawn
from knifetip.messages import Message
from knifetip.model.dieline import LineType
from knifetip.model.verdict import Finding, Samples, Verdict
from tests.support.shapes import dieline, edges

CUT, CREASE = LineType.CUT, LineType.CREASE
FAULT = Message("verify.unclassified")

#: One cut of 100 mm in two pieces, the second reversed and drawn twice; a crease that a cut of
#: 10 mm splits in two, 50 and 40 mm long; after cleaning the second one is row 5.
LINE = dieline(
    (CUT, edges(((0, 0), (30, 0)), ((100, 0), (30, 0)), ((30, 0), (100, 0)))),
    (CREASE, edges(((0, 50), (100, 50)))),
    (CUT, edges(((50, 50), (60, 50)))),
)


def verdict(count: int) -> Verdict:
    rows = np.arange(count)
    return Verdict(
        accepted=False,
        tolerance=0.01,
        deviation=(rows * 0.001).astype(np.float64),
        overcut=np.zeros(count),
        uncut=np.where(rows == 0, 10.0, np.where(rows == 5, 4.0, 0.0)),
        setback=np.zeros(count),
        findings=(Finding("uncut", FAULT, 4.0, edge=5), Finding("feed", FAULT, 1.0)),
        seconds=1.0,
        samples=Samples(
            np.array([0, 0, 0, 3, 5], np.int32),
            np.array([0.15, 0.65, 1.0, 0.5, 0.5]),
            np.array([0.1, 0.2, 0.3, 0.4, 0.5]),
        ),
    )


def test_lengths_are_divided_and_maxima_are_repeated() -> None:
    made = clean(LINE)
    assert made.dieline.source.tolist() == [0, 1, 2, 3, 4, 3]
    mapped = map_to_drawn(verdict(6), made, LINE)
    np.testing.assert_allclose(mapped.uncut, [3, 7, 0, 4, 0])
    np.testing.assert_allclose(mapped.deviation, [0, 0, 0, 0.005, 0.004])
    assert len(mapped.tidied) == len(LINE)


def test_a_finding_names_all_drawn_edges_of_its_cleaned_edge() -> None:
    made = clean(LINE)
    on_second = Finding(
        "uncut",
        Message("verify.stray-along", tool="knife", length=1.0, edge=5, type="crease"),
        4.0,
        edge=0,
    )
    mapped = map_to_drawn(replace(verdict(6), findings=(on_second,)), made, LINE)
    (finding,) = mapped.findings
    # Edge 1 was joined to edge 0, and edge 2 lies on both; the cleaned edge 5 is a piece of edge 3.
    assert (finding.edge, finding.edges) == (0, (0, 1, 2))
    assert finding.message.arguments["edge"] == 3


def test_a_merged_edge_is_as_far_from_the_curves_as_the_worst_of_its_parts() -> None:
    # The second piece is reversed; the first two are merged, and the third coincides with them.
    line = replace(LINE, fit_error=np.array([0.001, 0.003, 0.002, 0.0, 0.0]))
    np.testing.assert_allclose(clean(line).dieline.fit_error, [0.003, 0.003, 0.002, 0, 0, 0])


def test_findings_name_the_edge_that_was_drawn() -> None:
    mapped = map_to_drawn(verdict(6), clean(LINE), LINE)
    assert [finding.edge for finding in mapped.findings] == [3, -1]


def test_samples_have_their_position_on_the_drawn_edge() -> None:
    mapped = map_to_drawn(verdict(6), clean(LINE), LINE).samples
    # 15 of 100 mm is the middle of the first 30; 65 mm is the middle of the second piece; its left
    # is the other side, because it is reversed; 100 mm is its start.
    assert mapped.edge.tolist() == [0, 1, 1, 3, 3]
    np.testing.assert_allclose(mapped.place, [0.5, 0.0, 0.5, 0.25, 0.8])
    np.testing.assert_allclose(mapped.deviation, [0.1, -0.3, -0.2, 0.4, 0.5])


def test_a_verdict_on_a_clean_drawing_is_the_same() -> None:
    line = dieline((CUT, edges(((0, 0), (100, 0)), ((100, 0), (100, 100)))))
    original = replace(verdict(2), findings=(Finding("uncut", FAULT, 4.0, edge=1),))
    mapped = map_to_drawn(original, clean(line), line)
    np.testing.assert_array_equal(mapped.deviation, original.deviation)
    assert mapped.uncut.sum() == pytest.approx(original.uncut.sum())
    assert mapped.findings == original.findings
