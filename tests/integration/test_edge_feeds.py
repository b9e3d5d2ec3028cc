"""Feeds that the user has chosen for edges: programs, their verdicts, and wrong feeds."""

from __future__ import annotations

import re

import numpy as np
import pytest

from knifetip import pipeline
from knifetip.library import load
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.job_options import EdgeFeed, JobOptions
from knifetip.model.toolpath import Motion
from knifetip.pipeline import Compiled
from tests.support.drawings import drawing
from tests.support.shapes import closed, dieline, edges

#: A blank (edges 0 to 3) and a perforation (4).
LINE = dieline(
    (LineType.CUT, closed((100, 100), (300, 100), (300, 250), (100, 250))),
    (LineType.PERFORATION, edges(((120, 180), (280, 180)))),
)
BLANK = dieline((LineType.CUT, closed((100, 100), (300, 100), (300, 250), (100, 250))))
SLOW = EdgeFeed(edges=(1,), factor=0.5)


def compiled(machine: str, board: str, *feeds: EdgeFeed, line: Dieline = BLANK) -> Compiled:
    drawn = drawing(line.ends, [("CUT", 7, "CONTINUOUS")] * len(line), bulge=line.bulge)
    options = JobOptions(edge_feeds=feeds)
    return pipeline.compile(drawn, line, load.machine(machine), load.board(board), options=options)


def refused(
    made: Compiled, machine: str, board: str, *feeds: EdgeFeed, text: bytes = b""
) -> set[tuple[str, int]]:
    """Return the codes and edges of the findings that refuse a program."""
    found = pipeline.verify(
        text or made.program.text,
        BLANK,
        made.placement,
        load.machine(machine),
        load.board(board),
        options=JobOptions(edge_feeds=feeds),
    )
    return {(one.message.code, one.edge) for one in found.findings if one.refuses}


TARGETS = [
    ("demo-table", "fbb-0.4"),
    ("router-table", "greyboard-3.0"),
    ("laser-table", "fbb-0.4"),
]


@pytest.mark.parametrize(("machine", "board"), TARGETS)
def test_only_the_chosen_edge_is_slower(machine: str, board: str) -> None:
    usual, slow = compiled(machine, board), compiled(machine, board, SLOW)
    assert slow.verdict.accepted
    for made, factor in ((usual, 1.0), (slow, 0.5)):
        path = made.toolpath
        along = (path.motion == Motion.FEED) & (path.source >= 0)
        straight = along & (np.hypot(*np.diff(path.pose[:, :2], axis=0).T) > 50.0)
        feed = path.feed[straight]
        chosen = path.source[straight] == 1
        assert chosen.any()
        np.testing.assert_allclose(feed[chosen], factor * feed[~chosen].max())
        assert len(set(feed[~chosen])) == 1


@pytest.mark.parametrize(("machine", "board"), TARGETS)
def test_a_program_that_is_faster_on_the_edge_is_refused(machine: str, board: str) -> None:
    usual, slow = compiled(machine, board), compiled(machine, board, SLOW)
    assert refused(usual, machine, board, SLOW) == {("verify.wrong-feed", 1)}
    assert refused(slow, machine, board, SLOW) == set()
    # Without the choice no move may be slower than its tool.
    assert {code for code, _ in refused(slow, machine, board)} <= {
        "verify.wrong-feed",
        "verify.wrong-time",
    }
    assert refused(slow, machine, board)


def test_a_feed_that_is_neither_full_nor_chosen_is_refused() -> None:
    target = ("router-table", "greyboard-3.0")
    slow = compiled(*target, SLOW)
    half = min(float(word) for word in re.findall(rb" F([\d.]+)", slow.program.text))
    other = slow.program.text.replace(b" F%g" % half, b" F%g" % (0.9 * half))
    assert other != slow.program.text
    assert {code for code, _ in refused(slow, *target, SLOW, text=other)} == {"verify.wrong-feed"}


def test_perforations_are_slower_by_their_line_type() -> None:
    slow = EdgeFeed(line_type="perforation", factor=0.25)
    made = compiled("demo-table", "fbb-0.4", slow, line=LINE)
    assert made.verdict.accepted
    path = made.toolpath
    along = path.motion == Motion.FEED
    assert path.feed[along & (path.source == 4)].max() < 0.3 * path.feed[along].max()
