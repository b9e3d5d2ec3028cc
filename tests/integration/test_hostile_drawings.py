"""Valid drawings that overload the stages after reading.

Each is classified and cleaned within the time limit, whatever the arrangement of its edges.
"""

from __future__ import annotations

import time
from collections.abc import Callable

import numpy as np
import pytest

from knifetip import pipeline
from knifetip.errors import DrawingTooLarge
from knifetip.geometry.columns import F64
from knifetip.library import load
from knifetip.model.dieline import Dieline
from knifetip.model.drawing import Drawing
from tests.support.writers import dxf_text as text

#: Number of edges for which a quadratic algorithm takes minutes or exhausts the memory.
_MANY = 30_000
#: Limit of processor time; on an idle machine no drawing takes more than 5.
_SECONDS = 30.0


def lines(ends: F64, layer: str = "CUT") -> bytes:
    return text.dxf(*(text.line(*row, (8, layer)) for row in ends.tolist()))


def generator() -> np.random.Generator:
    return np.random.default_rng(4)


def fan(angle: F64, begin: float, x: F64 | float = 0.0, y: F64 | float = 0.0) -> F64:
    """Return lines in some directions, (n, 4), from radius ``begin`` to radius 300 mm about (x,
    y).
    """
    c, s = np.cos(angle), np.sin(angle)
    ends: F64 = np.stack([x + begin * c, y + begin * s, x + 300.0 * c, y + 300.0 * s], axis=1)
    return ends


def all_but_the_same() -> bytes:
    displacements = generator().uniform(-0.004, 0.004, (_MANY, 4))
    return lines(np.array([0.0, 0.0, 300.0, 200.0]) + displacements)


def crossing_in_one_point() -> bytes:
    return lines(fan(np.pi * np.arange(_MANY) / _MANY, -300.0))


def beginning_in_one_point() -> bytes:
    return lines(fan(2.0 * np.pi * np.arange(_MANY) / _MANY, 0.0))


def beginning_all_but_in_one_point() -> bytes:
    x, y = generator().uniform(-0.05, 0.05, (2, _MANY))
    return lines(fan(generator().uniform(0.0, 2.0 * np.pi, _MANY), 0.0, x, y))


def crossing_at_a_slant_of_a_degree() -> bytes:
    return lines(fan(np.radians(generator().uniform(-0.9, 0.9, _MANY)), -300.0))


def overlapping_on_one_line() -> bytes:
    begin, length = generator().uniform((0.0, 1.0), (900.0, 100.0), (_MANY, 2)).T
    zero = np.zeros(_MANY)
    return lines(np.stack([begin, zero, begin + length, zero], axis=1))


def each_a_little_longer_than_the_one_before() -> bytes:
    """Return a file of lines that each overlap hundreds of others, without common end points."""
    begin = np.linspace(0.0, 900.0, _MANY)
    zero = np.zeros(_MANY)
    return lines(np.stack([begin, zero, 1.0 + 1.11 * begin, zero], axis=1))


def a_star_of_one_contour() -> bytes:
    angle = 2.0 * np.pi * np.arange(_MANY + 1) / _MANY
    radius = np.where(np.arange(_MANY + 1) % 2, 300.0, 30.0)
    at = radius[:, None] * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    return lines(np.hstack([at[:-1], at[1:]]))


def circles_round_one_centre() -> bytes:
    radii = np.linspace(1.0, 300.0, _MANY // 2)
    return text.dxf(
        *(text.entity("CIRCLE", (8, "CUT"), (10, 300), (20, 300), (40, r)) for r in radii.tolist())
    )


def arcs_of_one_circle() -> bytes:
    begin = generator().uniform(0.0, 360.0, _MANY).tolist()
    place: list[text.Tag] = [(8, "CUT"), (10, 300), (20, 300), (40, 100)]
    return text.dxf(*(text.entity("ARC", *place, (50, a), (51, a + 40.0)) for a in begin))


def dashes_of_one_line() -> bytes:
    begin = 0.09 * np.arange(_MANY)
    zero = np.zeros(_MANY)
    return lines(np.stack([begin, zero, begin + 0.05, zero], axis=1), "0")


def nothing_but_specks() -> bytes:
    at = generator().uniform(0.0, 500.0, (_MANY, 2))
    return lines(np.hstack([at, at + generator().uniform(-0.01, 0.01, (_MANY, 2))]), "0")


def ten_thousand_kilometres_apart() -> bytes:
    at = generator().uniform(-9.9e6, 9.9e6, (_MANY, 2))
    return lines(np.hstack([at, at + generator().uniform(-50.0, 50.0, (_MANY, 2))]), "0")


def turns_of_nothing_and_of_everything() -> bytes:
    bulges = (1e-12, -1e-12, 1e12, -1e12, 1e-300, 1e300, 1.0 + 1e-10)
    arcs = []
    for row in range(_MANY // 10):
        arcs.append(text.entity("POLYLINE", (8, "CUT"), (66, 1), (70, 0)))
        for x, bulge in ((row, bulges[row % 7]), (row + 50, 0.0)):
            place: list[text.Tag] = [(8, "CUT"), (10, x), (20, row % 97)]
            arcs.append(text.entity("VERTEX", *place, (42, bulge)))
        arcs.append(text.entity("SEQEND"))
    return text.dxf(*arcs)


def layers_without_end() -> bytes:
    places = [(row % 200 * 10.0, row // 200 * 10.0) for row in range(20_000)]
    return text.dxf(
        *(text.line(x, y, x + 8, y, (8, f"LAYER {row}")) for row, (x, y) in enumerate(places))
    )


def layers_of_a_megabyte() -> bytes:
    names = [f"{row} " + "CUT CREASE " * 90_000 for row in range(3)]
    return text.dxf(*(text.line(0, row, 100, row, (8, name)) for row, name in enumerate(names)))


@pytest.fixture(scope="module", autouse=True)
def kernels() -> None:
    """Compile the kernels first, so that their compilation is not measured."""
    arc = text.entity("ARC", (8, "CUT"), (10, 5), (20, 5), (40, 100), (50, 0), (51, 40))
    for size in (0.01, 100.0):
        ends = np.round(generator().uniform(0.0, size, (200, 4)), 3).tolist()
        for layer in ("CUT", "0"):
            run_stages(text.dxf(*(text.line(*row, (8, layer)) for row in ends), arc))


DRAWINGS: dict[str, Callable[[], bytes]] = {
    made.__name__.replace("_", " "): made
    for made in (
        all_but_the_same, crossing_in_one_point, beginning_in_one_point,
        beginning_all_but_in_one_point, crossing_at_a_slant_of_a_degree, overlapping_on_one_line,
        a_star_of_one_contour, circles_round_one_centre, arcs_of_one_circle, dashes_of_one_line,
        nothing_but_specks, ten_thousand_kilometres_apart, turns_of_nothing_and_of_everything,
        layers_without_end, layers_of_a_megabyte,
    )
}  # fmt: skip


def run_stages(data: bytes) -> tuple[Drawing, Dieline]:
    """Read, classify and clean a drawing; check that edges and lengths are complete."""
    drawing = pipeline.read(data, "mm")
    line = pipeline.classify(drawing, load.profile("default"))
    assert len(line) == len(drawing)
    assert all(question.text for question in pipeline.questions(drawing, line))
    tidy = pipeline.clean(line)
    total = tidy.kept.sum() + tidy.merged.sum() + tidy.dropped.sum()
    assert total == pytest.approx(drawing.lengths.sum(), rel=1e-9)
    assert np.isfinite(tidy.dieline.ends).all()
    return drawing, line


#: The one that takes longest, several times as long as the next one.
LONGEST = "beginning all but in one point"


@pytest.mark.parametrize(
    "name",
    [pytest.param(name, marks=[pytest.mark.long] * (name == LONGEST)) for name in DRAWINGS],
)
def test_a_hostile_drawing_is_cleaned_within_the_time_limit(name: str) -> None:
    data = DRAWINGS[name]()
    start = time.process_time()
    run_stages(data)
    assert time.process_time() - start < _SECONDS


def test_lines_that_lie_on_hundreds_of_others_each_are_refused() -> None:
    data = each_a_little_longer_than_the_one_before()
    start = time.process_time()
    with pytest.raises(
        DrawingTooLarge, match="30,000 edges overlap each other at more than"
    ) as caught:
        run_stages(data)
    assert caught.value.hint
    assert time.process_time() - start < _SECONDS


def test_names_with_special_characters_are_plain_text() -> None:
    names = ["<script>alert(1)</script>", "\x01\x02\x7f", "'; DROP TABLE job; --", "\\U+0000"]
    names += ["\\U+D800", "a\u202eb", "%s%n{0}", "=cmd|' /C calc'!A0", "CUT" * 5000]
    data = text.dxf(*(text.line(0, row, 90, row, (8, name)) for row, name in enumerate(names)))
    drawing, _ = run_stages(data)
    assert len(drawing.layers) == len(names)
    assert drawing.layers[0] == "<script>alert(1)</script>"
