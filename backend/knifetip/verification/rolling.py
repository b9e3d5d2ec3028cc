"""Rolling: creases against what the wheel's contact, the board and crossing cuts ask.

Trial of a wheel -> deviation, overcut, uncut and setback of every crease
"""

from __future__ import annotations

import numpy as np

from knifetip.messages import Message
from knifetip.model.dieline import LineType
from knifetip.model.tool import CreaseWheel
from knifetip.verification.astray import judge_astray
from knifetip.verification.findings import MOST
from knifetip.verification.folds import at_places, doubled, joined, parted, rolled_gaps
from knifetip.verification.intent import WORKED, creases
from knifetip.verification.tools import Trade
from knifetip.verification.trial import Trial


class Rolling(Trial):
    """The work of a creasing wheel."""

    def judge(self) -> None:
        wheel = self.tool(CreaseWheel)
        if wheel is None:
            self.uncut(self.matched(), np.arange(len(self.edges)))
            return
        around = self.bench.edges.of(*WORKED[Trade.CREASE])
        pair = self.bench.board.double_crease
        between = rolled_gaps(
            self.edges, self.bench.edges.of(LineType.CUT), self.curve, 0.5 * pair + self.tolerance
        )
        single, places = parted(joined(self.edges, between), self.bench.edges.of(LineType.CUT))
        around, _ = parted(joined(around, between), self.bench.edges.of(LineType.CUT))
        parts = at_places(single, places)
        many = 2 if pair > 0.0 else 1
        if pair > 0.0:
            single, around, parts = doubled(single, pair), doubled(around, pair), np.tile(parts, 2)
        self.laid(single)
        asked = creases(self.edges, self.bench.board, wheel, around, parts)
        self.low, self.high, self.depth = asked.low, asked.high, asked.depth
        for edge in np.flatnonzero(asked.refused)[:MOST]:
            self.finding("uncut", edge, Message("verify.crease-too-short"), self.size[edge])
        rows = self.matched()
        self.placed(rows)
        judge_astray(self, rows, self.curve[:, 5])
        planned = np.maximum(self.high - self.low, 0.0)
        np.add.at(self.figures.setback, self.edges.row, (self.size - planned) / many)
        self.uncut(rows, np.arange(len(self.edges)))
        depth = np.maximum(self.bench.board.caliper - self.z, 0.0)
        contact = np.sqrt(np.maximum(depth * (2.0 * wheel.radius - depth), 0.0))
        self.headed(rows, contact, 180.0)
