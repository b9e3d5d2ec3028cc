"""The benchmarks: each function returns a subject, its size n, the work, the peers and the runs."""

from __future__ import annotations

import io
import itertools
import math
from collections.abc import Callable
from functools import cache
from typing import TypeAlias

import ezdxf
import numpy as np

from knifetip import pipeline
from knifetip.classification.classify import classify
from knifetip.cleaning.clean import clean
from knifetip.compensation.compensate import compensate
from knifetip.dxf.read import read
from knifetip.library import load
from knifetip.model.dieline import Dieline, LineType
from knifetip.planning.plan import plan
from knifetip.post.emit import process
from knifetip.sequencing.nearest import nearest_neighbour
from knifetip.verification.verify import verify
from tests.benchmarks.offset import offset_arcs, offset_lines, offset_million, offset_one
from tests.benchmarks.reading import classify_nested, classify_sheet, read_sheet
from tests.benchmarks.turning import order_shortest
from tests.support.shapes import BY_HAND

Bench: TypeAlias = tuple[str, int, Callable[[], object], dict[str, Callable[[], object]], int]

MACHINE = load.machine("demo-table")
BOARD = load.board("greyboard-2.0")


@cache
def _drawing_bytes(count: int) -> bytes:
    """Return a DXF file of small panels with four cuts and one crease each, on two layers."""
    document = ezdxf.new("R2010", units=4)
    document.layers.add("CUT", color=1)
    document.layers.add("CREASE", color=3)
    space = document.modelspace()
    for panel in range(count // 5):
        x, y = panel % 100 * 12.0, panel // 100 * 12.0
        corners = [(x, y), (x + 10, y), (x + 10, y + 10), (x, y + 10), (x, y)]
        for start, end in itertools.pairwise(corners):
            space.add_line(start, end, dxfattribs={"layer": "CUT"})
        space.add_line((x + 5, y), (x + 5, y + 10), dxfattribs={"layer": "CREASE"})
    text = io.StringIO()
    document.write(text)
    return text.getvalue().encode()


def _edges(kind: LineType, count: int) -> Dieline:
    """Return edges of 40 mm at all azimuths that do not touch each other, all of one line type."""
    angle = np.arange(count) * 2.399963
    start = np.column_stack([np.arange(count) % 1000 * 100.0, np.arange(count) // 1000 * 100.0])
    end = start + 40.0 * np.column_stack([np.cos(angle), np.sin(angle)])
    rows = np.arange(count)
    return Dieline(
        np.stack([start, end], axis=1),
        np.zeros(count),
        np.full(count, kind),
        rows.astype(np.int32),
        np.zeros(count, np.int32),
        np.ones(count),
        (BY_HAND,),
    )


def _engine(kind: LineType, count: int) -> Callable[[], object]:
    operation = plan(_edges(kind, count), MACHINE, BOARD)[0]
    return lambda: compensate(operation)


def read_lines() -> Bench:
    """Read a DXF file of lines on two layers."""
    data = _drawing_bytes(10_000)
    text = data.decode()
    return (
        "DXF R2010, LINE on 2 layers",
        10_000,
        lambda: read(data),
        {"ezdxf.read": lambda: ezdxf.read(io.StringIO(text))},
        3,
    )


def classify_layers() -> Bench:
    """Classify a drawing with the default profile."""
    drawing = read(_drawing_bytes(10_000))
    rules = load.profile("default")
    return "2 layers, default profile", len(drawing), lambda: classify(drawing, rules), {}, 15


def vgroove_edges() -> Bench:
    """Compensate V-grooves at every azimuth."""
    return "V-cutter, 2 passes", 100_000, _engine(LineType.V_GROOVE, 100_000), {}, 7


def crease_edges() -> Bench:
    """Compensate creases at every azimuth."""
    return "wheel, set back at both ends", 100_000, _engine(LineType.CREASE, 100_000), {}, 7


def knife_edges() -> Bench:
    """Compensate open cuts at every azimuth."""
    return "knife, free ends", 100_000, _engine(LineType.CUT, 100_000), {}, 7


def clean_sheet() -> Bench:
    """Clean a sheet without flaws."""
    return "20,000 panels, nothing to repair", 100_000, _cleaned(0.0, False), {}, 7


def clean_damaged() -> Bench:
    """Clean a sheet on which half of the edges have a duplicate that covers a part of them."""
    return "laps on every edge", 100_000, _cleaned(0.0, True), {}, 7


def clean_gapped() -> Bench:
    """Clean a sheet with all ends displaced by up to 0.008 mm."""
    return "a gap at every corner", 100_000, _cleaned(0.008, False), {}, 7


def _cleaned(noise: float, lapped: bool) -> Callable[[], object]:
    count = 50_000 if lapped else 100_000
    panel = np.array(
        [
            ((0, 0), (10, 0)),
            ((10, 0), (10, 10)),
            ((10, 10), (0, 10)),
            ((0, 10), (0, 0)),
            ((5, 0), (5, 10)),
        ],
        float,
    )
    number = np.arange(count // 5)
    corner = np.column_stack([number % 200 * 12.0, number // 200 * 12.0])
    ends = (corner[:, None, None] + panel).reshape(-1, 2, 2)
    kind = np.tile([LineType.CUT] * 4 + [LineType.CREASE], count // 5)
    if lapped:
        ends = np.concatenate([ends, 0.7 * ends + 0.3 * ends[:, ::-1]])
        kind = np.tile(kind, 2)
    ends = ends + np.random.default_rng(1).uniform(-noise, noise, ends.shape)
    rows = np.arange(len(ends), dtype=np.int32)
    zeros = np.zeros(len(ends))
    line = Dieline(ends, zeros, kind, rows, np.zeros_like(rows), zeros + 1.0, (BY_HAND,))
    return lambda: clean(line)


def plan_sheet() -> Bench:
    """Chain and plan a sheet of panels."""
    drawing = read(_drawing_bytes(10_000))
    dieline = classify(drawing, load.profile("default"))
    return "2,000 panels", len(dieline), lambda: plan(dieline, MACHINE, BOARD), {}, 7


def order_nearest() -> Bench:
    """Order tracks by nearest neighbour."""
    random = np.random.default_rng(1)
    start, end = random.uniform(0, 1000, (2, 10_000, 2))

    def exhaustive() -> object:
        left, here = np.ones(len(start), bool), np.zeros(2)
        order = []
        for _ in range(len(start)):
            distance = np.where(left, np.hypot(*(start - here).T), np.inf)
            order.append(int(distance.argmin()))
            left[order[-1]] = False
            here = end[order[-1]]
        return order

    return (
        "random tracks",
        10_000,
        lambda: nearest_neighbour(start, end, np.zeros(2)),
        {"NumPy, exhaustive": exhaustive},
        3,
    )


def _compiled() -> tuple[pipeline.Compiled, Dieline]:
    drawing = read(_drawing_bytes(10_000))
    dieline = classify(drawing, load.profile("default"))
    return pipeline.compile(drawing, dieline, MACHINE, BOARD), dieline


def process_lines() -> Bench:
    """Write the program of a toolpath."""
    made, _ = _compiled()
    return (
        "toolpath rows to grblHAL",
        len(made.toolpath),
        lambda: process(made.toolpath, MACHINE, "grblhal"),
        {},
        7,
    )


def verify_program() -> Bench:
    """Verify a program against its drawing."""
    made, dieline = _compiled()
    return (
        "program lines",
        len(made.program),
        lambda: verify(made.program.text, dieline, made.placement, MACHINE, BOARD),
        {},
        3,
    )


def compile_sheet() -> Bench:
    """Compile a classified drawing to a verified program."""
    drawing = read(_drawing_bytes(10_000))
    dieline = classify(drawing, load.profile("default"))
    return (
        "2,000 panels, plan to verify",
        len(dieline),
        lambda: pipeline.compile(drawing, dieline, MACHINE, BOARD),
        {},
        3,
    )


@cache
def _sheet_bytes(count: int) -> bytes:
    """Return a DXF file of ``count`` lines: panels with four cuts, two creases and two slits.

    The panels fill a sheet of 1500 × 1100 mm.
    """
    document = ezdxf.new("R2010", units=4)
    document.layers.add("CUT", color=1)
    document.layers.add("CREASE", color=3)
    space = document.modelspace()
    panels = count // 8
    columns = math.ceil(math.sqrt(panels * 15 / 11))
    wide, high = 1500.0 / columns, 1100.0 / math.ceil(panels / columns)
    for panel in range(panels):
        x, y = panel % columns * wide, panel // columns * high
        right, top = x + 0.85 * wide, y + 0.85 * high
        corners = [(x, y), (right, y), (right, top), (x, top), (x, y)]
        for start, end in itertools.pairwise(corners):
            space.add_line(start, end, dxfattribs={"layer": "CUT"})
        for share in (0.2, 0.65):
            at = x + share * wide
            space.add_line((at, y), (at, top), dxfattribs={"layer": "CREASE"})
            level = y + share * high
            ends = (x + 0.3 * wide, level), (x + 0.55 * wide, level)
            space.add_line(*ends, dxfattribs={"layer": "CUT"})
    text = io.StringIO()
    document.write(text)
    return text.getvalue().encode()


def _bytes_to_program(count: int, runs: int) -> Bench:
    data, rules = _sheet_bytes(count), load.profile("default")
    text = data.decode()
    board = load.board("fbb-0.4")

    def work() -> object:
        drawing = pipeline.read(data, "mm")
        result = pipeline.compile(drawing, pipeline.classify(drawing, rules), MACHINE, board)
        assert result.verdict.accepted
        return result

    return (
        "bytes to verified program",
        count,
        work,
        {"ezdxf.read": lambda: ezdxf.read(io.StringIO(text))},
        runs,
    )


def bytes_to_program_500() -> Bench:
    """Make a verified program from the bytes of a small drawing."""
    return _bytes_to_program(500, 15)


def bytes_to_program_10_000() -> Bench:
    """Make a verified program from the bytes of a sheet."""
    return _bytes_to_program(10_000, 3)


def bytes_to_program_100_000() -> Bench:
    """Make a verified program from the bytes of a large sheet."""
    return _bytes_to_program(100_000, 1)


BENCHES: tuple[Callable[[], Bench], ...] = (
    read_lines,
    read_sheet,
    classify_sheet,
    classify_nested,
    classify_layers,
    clean_sheet,
    clean_damaged,
    clean_gapped,
    plan_sheet,
    vgroove_edges,
    crease_edges,
    knife_edges,
    order_nearest,
    order_shortest,
    process_lines,
    verify_program,
    compile_sheet,
    bytes_to_program_500,
    bytes_to_program_10_000,
    bytes_to_program_100_000,
    offset_lines,
    offset_arcs,
    offset_one,
    offset_million,
)
