"""Benchmark of nesting: board use beside rectangles in columns and beside plain sparrow.

    python -m tests.benchmarks.nesting [SECONDS]           the tables of backend/docs/nesting.md
    python -m tests.benchmarks.nesting [SECONDS] --holes   the second of them, of parts with holes

Plain sparrow gets the same outlines, time, seed and gap, and one strip without end that is as high
as the sheet; its use is that of the strip up to its last blank.  It knows no holes.
"""

from __future__ import annotations

import argparse
import os
from collections.abc import Iterator, Sequence
from dataclasses import replace
from datetime import timedelta
from functools import cache
from pathlib import Path
from typing import NamedTuple

import spyrrow

from knifetip import pipeline
from knifetip.dxf.samples import samples
from knifetip.layout.blanks import find_blanks
from knifetip.library import load
from knifetip.nesting.arrangement import Board
from knifetip.nesting.parts import Part, make_part
from knifetip.nesting.problem import Problem
from knifetip.nesting.search import nest
from knifetip.nesting.shapes import shape_of
from tests.support.writers import dxf_text as text

ROOT = Path(__file__).resolve().parents[2]
CORPUS = Path(os.environ.get("KNIFETIP_CORPUS", ROOT.parent / "shared" / "corpus"))
GAP = 5.0
MARGIN = 10.0
GRAIN = (0.0, 180.0)
QUARTERS = (0.0, 90.0, 180.0, 270.0)
CUT = (8, "CUT")
TUCK, TRAY, RIGID = "tuck-end-carton.dxf", "corrugated-tray.dxf", "rigid-box-blank.dxf"


def polygon(*corners: tuple[float, float]) -> str:
    """Return the cuts round a polygon."""
    return "".join(
        text.line(*one, *other, CUT)
        for one, other in zip(corners, (*corners[1:], corners[0]), strict=True)
    )


def box(left: float, bottom: float, right: float, top: float) -> str:
    """Return the cuts round a rectangle."""
    return polygon((left, bottom), (right, bottom), (right, top), (left, top))


def disc(radius: float) -> str:
    """Return the cut round a disc about the origin."""
    return text.entity("CIRCLE", CUT, (10, 0), (20, 0), (40, radius))


FRAME, RING, TWIN, TAG, ANGLE = "frame", "ring", "frame of two windows", "tag", "angle"
#: Large parts with holes, and small parts for them.
SHAPES = {
    FRAME: text.dxf(box(0, 0, 500, 360), box(40, 40, 460, 320)),
    RING: text.dxf(disc(220), disc(175)),
    TWIN: text.dxf(box(0, 0, 620, 300), box(30, 30, 295, 270), box(325, 30, 590, 270)),
    TAG: text.dxf(box(0, 0, 120, 80)),
    ANGLE: text.dxf(polygon((0, 0), (150, 0), (150, 50), (50, 50), (50, 150), (0, 150))),
}


class Case(NamedTuple):
    """Drawings with their numbers, the sheet (mm), and the permitted turns (°)."""

    drawings: Sequence[tuple[str, int]]
    sheet: tuple[float, float]
    turns: tuple[float, ...]


CASES = (
    Case(((TUCK, 6),), (1200.0, 800.0), GRAIN),
    Case(((TUCK, 10),), (1600.0, 1200.0), QUARTERS),
    Case(((TRAY, 4),), (1600.0, 1200.0), QUARTERS),
    Case(((RIGID, 6),), (1600.0, 1200.0), GRAIN),
    Case(((TUCK, 4), (TRAY, 2)), (1600.0, 1200.0), QUARTERS),
    Case(((TUCK, 3), (TRAY, 1), (RIGID, 2)), (1600.0, 1200.0), GRAIN),
    Case((("mailer_120x80x40_all_layers.dxf", 8),), (1200.0, 800.0), GRAIN),
    Case((("PaperBox_100x40x140.dxf", 8),), (1200.0, 800.0), QUARTERS),
    Case((("mailer_120x80x40_all_layers.dxf", 4), (TUCK, 4)), (1200.0, 800.0), QUARTERS),
    Case((("PaperBox_100x40x140.dxf", 6), (TUCK, 3)), (1200.0, 800.0), GRAIN),
)
#: Layouts of large parts with holes, and of small parts that fit into them.
WITH_HOLES = (
    Case(((FRAME, 3), (TAG, 24)), (1200.0, 800.0), GRAIN),
    Case(((FRAME, 2), (ANGLE, 12)), (1200.0, 800.0), QUARTERS),
    Case(((RING, 3), (TAG, 15)), (1200.0, 800.0), QUARTERS),
    Case(((TWIN, 3), (ANGLE, 6), (TAG, 12)), (1200.0, 800.0), QUARTERS),
    Case(((FRAME, 1), (RING, 1), (TAG, 10), (ANGLE, 4)), (1200.0, 800.0), QUARTERS),
)


@cache
def drawing(name: str) -> bytes | None:
    """Return a shape, a sample or a file of the corpus; None without the corpus."""
    if (own := SHAPES.get(name) or samples().get(name)) is not None:
        return own
    found = next(CORPUS.rglob(name), None)
    return None if found is None else found.read_bytes()


def parts_of(case: Case) -> list[Part] | None:
    """Return the parts of a case, None if a drawing is missing."""
    parts = []
    for name, quantity in case.drawings:
        if (data := drawing(name)) is None:
            return None
        dieline = pipeline.classify(pipeline.read(data), load.profile("default"))
        blanks = find_blanks(pipeline.clean(dieline).dieline)
        parts.append(make_part(dieline, blanks, case.turns, quantity=quantity))
    return parts


def plain_use(parts: Sequence[Part], height: float, seconds: float) -> float:
    """Return the use of a strip by sparrow alone (%)."""
    items = [
        spyrrow.Item(str(number), *shape_of(part, part.quantity))
        for number, part in enumerate(parts)
    ]
    config = spyrrow.StripPackingConfig(
        min_items_separation=GAP, total_computation_time=1, num_workers=1, seed=0
    )
    config.exploration_time = timedelta(seconds=0.8 * seconds)
    config.compression_time = timedelta(seconds=0.2 * seconds)
    found = spyrrow.StripPackingInstance("plain", height - 2.0 * MARGIN + 2.0 * GAP, items).solve(
        config
    )
    length = found.width - 2.0 * GAP + 2.0 * MARGIN
    return float(100.0 * sum(one.area.area * one.quantity for one in parts) / (length * height))


def rows(cases: Sequence[Case], seconds: float, *, holes: bool) -> Iterator[str]:
    """Yield the rows of a table; those of parts with ``holes`` have two columns more."""
    for case in cases:
        parts = parts_of(case)
        if parts is None:
            continue
        width, height = case.sheet
        window = (MARGIN, MARGIN, width - MARGIN, height - MARGIN)
        problem = Problem(parts, [Board(width, height, window, None)], GAP, seconds)
        found = nest(problem, lambda _: None)
        names = ", ".join(f"{count} × {Path(name).stem}" for name, count in case.drawings)
        turns = "0, 180°" if case.turns == GRAIN else "0 … 270°"
        plain = plain_use(parts, height, seconds)
        figures = [f"{found.columns_use:.1f}", f"{found.use:.1f}", f"{plain:.1f}"]
        if holes:
            empty = nest(replace(problem, in_holes=False), lambda _: None)
            figures[1:1] = [f"{len(empty.arrangement.sheets)}", f"{empty.use:.1f}"]
            figures.append(str(found.in_holes))
        sheets = len(found.arrangement.sheets)
        columns = [names, f"{width:g} × {height:g}", turns, str(sheets), *figures]
        yield f"| {' | '.join(columns)} |"


HEAD = ("drawings", "sheet (mm)", "turns", "sheets", "rectangles", "knifetip", "plain sparrow")
HOLES_HEAD = (*HEAD[:5], "sheets, holes empty", "holes empty", *HEAD[5:], "in holes")


def print_table(head: Sequence[str], cases: Sequence[Case], seconds: float) -> None:
    """Print a table, row by row."""
    print(f"| {' | '.join(head)} |")
    print("|---" * len(head) + "|")
    for row in rows(cases, seconds, holes=head is HOLES_HEAD):
        print(row, flush=True)


def main() -> None:
    """Print the tables."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("seconds", type=float, nargs="?", default=20.0)
    parser.add_argument("--holes", action="store_true")
    chosen = parser.parse_args()
    if not chosen.holes:
        print_table(HEAD, CASES, chosen.seconds)
        print()
    print_table(HOLES_HEAD, WITH_HOLES, chosen.seconds)


if __name__ == "__main__":
    main()
