"""Programs with one deliberate error are each refused; permitted differences are accepted.

The error is in the input of the program (a board, a tool, a datum, a rule); the verifier has the
correct input.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from knifetip.compensation import vgroove
from knifetip.model.board import Deflection
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.machine import Machine
from knifetip.model.operation import End, Operation
from tests.support.programs.engines import DEMO, ENGINES, Engine
from tests.support.shapes import BY_HAND, dieline, edges, with_dimensions
from tests.support.verdicts import has_faults

V, PASSES, CREASE, DOUBLE = (
    ENGINES[name] for name in ("V-groove", "V-groove in passes", "crease", "double crease")
)
KNIFE, TEARS, NICKS, DRAG, LED = (
    ENGINES[name] for name in ("knife", "partial cuts", "bridges", "drag knife", "knife with leads")
)
B, C, SOFT, AUTO = (ENGINES[name] for name in ENGINES if name.startswith("router"))
ROUTERS = [B, C, SOFT, AUTO]


def with_tool(machine: Machine, number: int, **dimensions: float) -> Machine:
    """Return the machine with other dimensions of the tool in a station."""
    return replace(
        machine,
        stations=tuple(
            replace(held, tool=with_dimensions(held.tool, **dimensions))
            if held.number == number
            else held
            for held in machine.stations
        ),
    )


def moved_datum(machine: Machine, number: int, **datum: float) -> Machine:
    """Return the machine with the datum of a station displaced."""
    return replace(
        machine,
        stations=tuple(
            replace(held, **{axis: getattr(held, axis) + by for axis, by in datum.items()})
            if held.number == number
            else held
            for held in machine.stations
        ),
    )


def board(engine: Engine, **asked: Any) -> Engine:
    return replace(engine, board=replace(engine.board, **asked))


def tool(engine: Engine, number: int, **dimensions: float) -> Engine:
    return replace(engine, machine=with_tool(engine.machine, number, **dimensions))


def datum(engine: Engine, number: int, **by: float) -> Engine:
    # Programs for controllers without a tool table contain the datum in their coordinates.
    return replace(engine, dialect="grblhal", machine=moved_datum(engine.machine, number, **by))


def with_edges(
    engine: Engine, kind: LineType, *lines: tuple[tuple[float, float], tuple[float, float]]
) -> Engine:
    """Return the engine with additional edges in its dieline."""
    more = dieline((kind, edges(*lines)))
    line = engine.line
    both = Dieline(
        np.concatenate([line.ends, more.ends]),
        np.concatenate([line.bulge, more.bulge]),
        np.concatenate([line.line_type, more.line_type]),
        np.arange(len(line) + len(more), dtype=np.int32),
        np.zeros(len(line) + len(more), np.int32),
        np.ones(len(line) + len(more)),
        (BY_HAND,),
    )
    return replace(engine, line=both)


def displaced(engine: Engine, x: float = 0.0, y: float = 0.0, turn: float = 0.0) -> Engine:
    """Return the engine with its dieline rotated (degrees) and displaced."""
    cos, sin = np.cos(np.radians(turn)), np.sin(np.radians(turn))
    ends = engine.line.ends @ np.array([[cos, sin], [-sin, cos]]) + (x, y)
    return replace(engine, line=replace(engine.line, ends=ends))


def mirrored(engine: Engine) -> Engine:
    line = engine.line
    ends = line.ends * (-1.0, 1.0) + (320.0, 0.0)
    return replace(engine, line=replace(line, ends=ends, bulge=-line.bulge))


ROUND_HOLE = (((50.0, 120.0), (58.0, 120.0)), ((58.0, 120.0), (58.0, 128.0)),
              ((58.0, 128.0), (50.0, 128.0)), ((50.0, 128.0), (50.0, 120.0)))  # fmt: skip

#: (error, engine of the verifier, engine of the program)
WRONG: list[tuple[str, Engine, Engine]] = [
    ("groove 0.05 too deep", V, board(V, groove_depth=1.35)),
    ("groove 0.05 too shallow", PASSES, board(PASSES, groove_depth=1.25)),
    ("groove in one pass", PASSES, board(PASSES, groove_pass=0.0)),
    ("V-cutter's tilt off by 0.5°", V, tool(V, 3, tilt=45.5)),
    ("V-cutter's d off by 0.05", V, tool(V, 3, back=6.05)),
    ("V-cutter's r off by 0.05", V, tool(V, 3, half_width=1.45)),
    ("V-cutter's datum off in X", V, datum(V, 3, x=0.05)),
    ("V-cutter's datum off in Z", V, datum(V, 3, z=-0.05)),
    ("V-cutter's datum off by 1° in C", V, datum(V, 3, c=1.0)),
    ("wheel pressed 0.05 too deep", CREASE, board(CREASE, crease_along=0.65, crease_across=0.7)),
    ("wheel pressed 0.05 too little", CREASE, board(CREASE, crease_along=0.55, crease_across=0.6)),
    ("grain turned by 90°", CREASE, board(CREASE, grain=0.0)),
    ("wheel of 14 for one of 15", CREASE, tool(CREASE, 2, radius=14.0)),
    ("ends 0.05 less clear", CREASE, board(CREASE, end_clearance=0.15)),
    ("wheel's datum off in Y", CREASE, datum(CREASE, 2, y=0.05)),
    ("wheel's datum off in Z", CREASE, datum(CREASE, 2, z=0.05)),
    ("double crease 0.05 too wide", DOUBLE, board(DOUBLE, double_crease=3.05)),
    ("single for double crease", DOUBLE, board(DOUBLE, double_crease=0.0)),
    ("double for single crease", CREASE, board(CREASE, double_crease=3.0)),
    ("blade at 12° for one at 10°", KNIFE, tool(KNIFE, 1, blade_angle=12.0)),
    ("0.05 less into the mat", KNIFE, replace(KNIFE, machine=replace(DEMO, into_mat=0.25))),
    ("0.05 more into the mat", KNIFE, replace(KNIFE, machine=replace(DEMO, into_mat=0.35))),
    # 0.06 mm tan 10° are 0.0106 mm along the line.
    ("board of 1.94 for one of 2.0", KNIFE, board(KNIFE, caliper=1.94)),
    ("knife's datum off in X", KNIFE, datum(KNIFE, 1, x=0.02)),
    ("knife's datum off by 1° in C", KNIFE, datum(KNIFE, 1, c=1.0)),
    ("half-cut 0.05 too deep", TEARS, board(TEARS, half_cut_depth=1.05)),
    ("half-cut nearly through", TEARS, board(TEARS, half_cut_depth=1.9)),
    ("perforation 0.05 longer", TEARS, board(TEARS, perforation=(3.05, 2.0))),
    ("perforation's gaps 0.2 wider", TEARS, board(TEARS, perforation=(3.0, 2.2))),
    ("trail of 3.9 for 4", DRAG, tool(DRAG, 1, trail=3.9)),
    ("trail of the knife to 0", DRAG, tool(DRAG, 1, trail=0.0)),
    ("no bridges", NICKS, board(NICKS, bridge_width=0.0)),
    ("bridges 0.05 too narrow", NICKS, board(NICKS, bridge_width=0.75)),
    ("bridges 0.05 too wide", NICKS, board(NICKS, bridge_width=0.85)),
    ("bridges too many", NICKS, board(NICKS, bridge_spacing=60.0)),
    ("bridges too few", NICKS, board(NICKS, bridge_spacing=250.0)),
    ("bridges that are not expected", KNIFE, board(KNIFE, bridge_width=0.8, bridge_spacing=150.0)),
    ("router's radius off by 0.02", B, tool(B, 4, radius=3.02)),
    ("router's radius off by -0.02", C, tool(C, 4, radius=2.98)),
    ("router in one pass", B, tool(B, 4, step=0.0)),
    ("router's datum off in X", C, datum(C, 4, x=0.02)),
    ("deflection left out", SOFT, board(SOFT, deflection=())),
    ("deflection of X for Y", SOFT, board(SOFT, deflection=(Deflection("Router", 0.05, 0.08),))),
    ("deflection that is none", B, board(B, deflection=(Deflection("Router", 0.08, 0.05),))),
    ("cut across the panel", V, with_edges(V, LineType.CUT, ((160, 110), (200, 130)))),
    ("crease for nothing", V, with_edges(V, LineType.CREASE, ((150, 110), (150, 130)))),
    ("groove for nothing", CREASE, with_edges(CREASE, LineType.V_GROOVE, ((150, 110), (150, 130)))),
    ("slit in the waste", KNIFE, with_edges(KNIFE, LineType.CUT, ((60, 120), (80, 120)))),
    ("slot milled across a part", B, with_edges(B, LineType.CUT, ((120, 145), (190, 120)))),
    ("hole milled far off in the waste", C, with_edges(C, LineType.CUT, *ROUND_HOLE)),
    *(
        (f"all {name}", engine, change(engine))
        for engine in (V, CREASE, KNIFE, NICKS, DRAG, LED, B, SOFT)
        for name, change in (
            ("moved by 0.02", lambda engine: displaced(engine, x=0.02)),
            ("turned by 0.05°", lambda engine: displaced(engine, turn=0.05)),
            ("mirrored", mirrored),
        )
        # A rectangle with two bridges is its own mirror image.
        if (engine.name, name) != ("bridges", "mirrored")
    ),
]  # fmt: skip


@pytest.mark.parametrize(
    ("right", "wrong"), [row[1:] for row in WRONG], ids=[f"{row[1]}: {row[0]}" for row in WRONG]
)
def test_a_program_from_one_wrong_input_is_refused(right: Engine, wrong: Engine) -> None:
    assert not has_faults(wrong.verdict_of(wrong.text)), wrong.verdict_of(wrong.text).findings[:2]
    assert has_faults(right.verdict_of(wrong.text))


# -- Errors in the rules of planning


def with_ends(old: End, new: End) -> Callable[[list[Operation]], list[Operation]]:
    """Return a function that replaces path ends of kind ``old`` by ``new`` in a list of
    operations.
    """

    def change(operations: list[Operation]) -> list[Operation]:
        return [
            replace(
                each,
                start=np.where(each.start == old, new, each.start),
                finish=np.where(each.finish == old, new, each.finish),
            )
            for each in operations
        ]

    return change


def fields(**new: Any) -> Callable[[list[Operation]], list[Operation]]:
    return lambda operations: [replace(each, **new) for each in operations]


def other_side(operations: list[Operation]) -> list[Operation]:
    return [replace(each, side=-each.side) for each in operations]


def without(kind: LineType) -> Callable[[list[Operation]], list[Operation]]:
    return lambda operations: [each for each in operations if each.line_type != kind]


@pytest.mark.parametrize(
    ("engine", "change"),
    [
        (V, fields(run_out=np.zeros((0, 2)))),
        (V, without(LineType.V_GROOVE)),
        (CREASE, with_ends(End.FREE, End.CONTINUED)),
        (CREASE, without(LineType.CREASE)),
        (KNIFE, with_ends(End.CLOSED, End.FREE)),
        (KNIFE, with_ends(End.FREE, End.MEETS)),
        (TEARS, with_ends(End.MEETS, End.FREE)),
        (TEARS, without(LineType.PERFORATION)),
        (NICKS, with_ends(End.BRIDGE, End.MEETS)),
        (B, other_side),
        (SOFT, other_side),
        (AUTO, lambda operations: operations[:-1]),
        (AUTO, lambda operations: operations[1:]),
    ],
    ids=lambda value: str(value) if isinstance(value, Engine) else "",
)
def test_a_program_planned_by_a_wrong_rule_is_refused(
    engine: Engine, change: Callable[..., Any]
) -> None:
    text = engine.program_bytes(change)
    assert text != engine.text
    assert has_faults(engine.verdict_of(text))


def test_a_v_cutter_that_plunges_straight_down_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    right = vgroove.sideways_move
    monkeypatch.setattr(vgroove, "sideways_move", lambda *args: 0.0 * right(*args))
    assert has_faults(V.verdict_of(V.program_bytes()))


# -- Errors in all words of one letter


def with_changed_words(text: bytes, letter: str, change: Callable[[float], float]) -> bytes:
    """Return the program with all numbers of a letter changed, including those in the header."""
    pattern = re.compile(rf"\b{letter}(-?[\d.]+)".encode())
    lines = [
        line
        if line.startswith(b"(")
        else pattern.sub(lambda found: f"{letter}{change(float(found[1])):.4f}".encode(), line)
        for line in text.splitlines()
    ]
    return b"\n".join(lines) + b"\n"


def test_only_a_wheel_works_the_same_from_both_sides() -> None:
    for engine in (V, PASSES, KNIFE, DRAG):
        assert has_faults(
            engine.verdict_of(with_changed_words(engine.text, "C", lambda c: c + 180.0))
        )
    # The knife that cuts the outline in the crease's program is turned too.
    lone = replace(CREASE, line=dieline((LineType.CREASE, edges(((120, 100), (120, 180))))))
    assert not has_faults(lone.verdict_of(with_changed_words(lone.text, "C", lambda c: c + 180.0)))
    assert has_faults(lone.verdict_of(with_changed_words(lone.text, "C", lambda c: c + 90.0)))


@pytest.mark.parametrize("engine", [V, CREASE, KNIFE, DRAG, NICKS, B, AUTO], ids=str)
def test_a_program_in_other_units_or_mirrored_by_its_words_is_refused(engine: Engine) -> None:
    for letter, change in (
        ("Z", lambda z: z / 25.4),
        ("Z", lambda z: -z),
        ("X", lambda x: 320.0 - x),
        ("C", lambda c: -c),
        ("F", lambda f: f / 60.0),
    ):
        mutant = with_changed_words(engine.text, letter, change)
        if mutant != engine.text and not (letter == "C" and engine in ROUTERS):
            assert has_faults(engine.verdict_of(mutant)), letter
    assert has_faults(engine.verdict_of(engine.text.replace(b"G21", b"G20")))
    assert has_faults(
        engine.verdict_of(engine.text.replace(b"G2 ", b"G5 ").replace(b"G1 ", b"G5 "))
    )


def test_a_router_may_have_any_heading() -> None:
    assert not has_faults(AUTO.verdict_of(with_changed_words(AUTO.text, "C", lambda c: c + 33.0)))


def test_a_hole_milled_beside_a_part_in_its_waste_is_harmless() -> None:
    # 5 mm of waste between its slot and the part; beyond 10.5 mm it would be stray work.
    hole = with_edges(C, LineType.CUT, ((92.0, 120.0), (92.0, 128.0)))
    assert not has_faults(C.verdict_of(hole.text))


def test_the_placement_that_a_program_states_must_be_the_job_s() -> None:
    head = b"(placement X0.0000 Y0.0000)\n"
    first, rest = KNIFE.text.split(b"\n", 1)
    assert not has_faults(KNIFE.verdict_of(first + b"\n" + head + rest))
    assert has_faults(KNIFE.verdict_of(first + b"\n" + head.replace(b"X0.0", b"X0.5") + rest))
