"""A machine, a board, a dieline and its programs, written by hand.

All dimensions that the verifier needs are literals in this module, so that its tests do not depend
on the stages that it verifies.  Sheet coordinates are drawing coordinates plus (20, 20).

    board 2.0 mm, into the mat 0.3 mm, knife slanted by 10°:
        lead of the top face   2.3 tan 10° = 0.4056      overrun    2.0 tan 10° = 0.3527
        half-cut, 1.0 deep     1.0 tan 10° = 0.1763
    wheel R 15, crease 0.6 deep:  s = √(0.6 · 29.4) = 4.2, with 0.2 clearance 4.4 from a free end
    V-cutter d = 6, r = 1.5, 45°:  heading east the head is 1.5 east and 6 south of its tip
"""

from __future__ import annotations

import math

import numpy as np

from knifetip.model.board import Board
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.machine import Axis, Machine, Station
from knifetip.model.tool import CreaseWheel, Knife, VCutter
from tests.support.shapes import BY_HAND

PLACEMENT = (20.0, 20.0)

MACHINE = Machine(
    name="hand-table",
    title="Table written by hand",
    width=800.0,
    height=600.0,
    x=Axis(-100.0, 900.0, 1500.0, 8000.0),
    y=Axis(-10.0, 650.0, 1500.0, 8000.0),
    z=Axis(-10.0, 60.0, 500.0, 5000.0),
    c=Axis(-1080.0, 1080.0, 3600.0, 36000.0),
    stations=(
        Station(1, "Knife", Knife(10.0, 2.5, 15.0, 24000.0, 6000.0, True), 0.0, 0.0, 0.0, 0.0, 0),
        Station(2, "Wheel", CreaseWheel(15.0, 0.7, 30000.0, 6000.0), 60.0, 0.0, -1.5, 0.0, 1),
        Station(3, "V-cutter", VCutter(6.0, 1.5, 45.0, 12000.0, 3000.0), -60.0, 5.0, 0.0, 90.0, 2),
    ),
    dialect="grblhal",
    origin=PLACEMENT,
    travel_z=20.0,
    clearance=2.0,
    into_mat=0.3,
    settle=0.15,
)

BOARD = Board(
    name="hand-board",
    title="Board written by hand",
    material="greyboard",
    caliper=2.0,
    grain=90.0,
    crease_along=0.6,
    crease_across=0.8,
    end_clearance=0.2,
    groove_depth=1.3,
    groove_overcut=3.0,
    half_cut_depth=1.0,
    perforation=(3.0, 2.0),
    short_crease="press",
)

#: Bulge of a quarter turn to the left: tan(90° / 4).
QUARTER = math.sqrt(2.0) - 1.0


def dieline(*edges: tuple[LineType, float, float, float, float, float]) -> Dieline:
    """Return a dieline of edges (line type, x1, y1, x2, y2, bulge)."""
    rows = len(edges)
    return Dieline(
        ends=np.array([edge[1:5] for edge in edges], np.float64).reshape(rows, 2, 2),
        bulge=np.array([edge[5] for edge in edges], np.float64),
        line_type=np.array([edge[0] for edge in edges], np.uint8),
        source=np.arange(rows, dtype=np.int32),
        rule=np.zeros(rows, np.int32),
        confidence=np.ones(rows),
        rules=(BY_HAND,),
    )


CUT, CREASE = LineType.CUT, LineType.CREASE

#: A rounded blank of 100 × 60, two slits (one to the outline), a crease, a V-groove, a half-cut.
DIELINE = dieline(
    (CUT, 10.0, 0.0, 90.0, 0.0, 0.0),
    (CUT, 90.0, 0.0, 100.0, 10.0, QUARTER),
    (CUT, 100.0, 10.0, 100.0, 50.0, 0.0),
    (CUT, 100.0, 50.0, 90.0, 60.0, QUARTER),
    (CUT, 90.0, 60.0, 10.0, 60.0, 0.0),
    (CUT, 10.0, 60.0, 0.0, 50.0, QUARTER),
    (CUT, 0.0, 50.0, 0.0, 10.0, 0.0),
    (CUT, 0.0, 10.0, 10.0, 0.0, QUARTER),
    (CUT, 20.0, 15.0, 40.0, 15.0, 0.0),  # 8: both ends inside the blank
    (CUT, 50.0, 50.0, 50.0, 60.0, 0.0),  # 9: ends on the outline
    (CREASE, 70.0, 10.0, 70.0, 50.0, 0.0),  # 10: along the grain, 0.6 deep
    (LineType.V_GROOVE, 20.0, 30.0, 60.0, 30.0, 0.0),  # 11
    (LineType.HALF_CUT, 20.0, 40.0, 60.0, 40.0, 0.0),  # 12
    (LineType.IGNORED, 0.0, 70.0, 50.0, 70.0, 0.0),  # 13
)
CONTOUR, SLIT, RUN_OUT, FOLD, GROOVE, HALF = range(8), 8, 9, 10, 11, 12

LINUXCNC = b"""\
(machine hand-table)
(board hand-board caliper 2)
(placement X20.0000 Y20.0000)
G21 G90 G91.1 G17 G40 G49 G94 G54 G92.1
G64 P0.0050 Q0.0050
G0 Z20.0000
M65 P0
M65 P1
M65 P2
M5
(station 2 Wheel)
T2 M6 G43
M64 P1
G4 P0.15
G0 X90.0000 Y34.4000 Z20.0000 C90.0000
G0 Z4.0000
G1 Z1.4000 F6000
G1 Y65.6000 F30000
G1 Z4.0000 F6000
G0 Z20.0000
(station 3 V-cutter)
M65 P1
T3 M6 G43
M64 P2
G4 P0.15
G0 X41.5000 Y40.7000 Z20.0000 C0.0000
G0 Z4.0000
G1 Y44.0000 Z0.7000 F3000
G1 X81.5000 F12000
G1 Y40.7000 Z4.0000 F3000
G0 X78.5000 Y59.3000 C180.0000
G1 Y56.0000 Z0.7000
G1 X38.5000 F12000
G1 Y59.3000 Z4.0000 F3000
G0 Z20.0000
(station 1 Knife)
M65 P2
T1 M6 G43
M64 P0
M3 S1
G4 P0.15
G0 X40.0000 Y60.0000 Z20.0000 C0.0000
G0 Z4.0000
G1 Z1.0000 F6000
G1 X79.8237 F24000
G1 Z4.0000 F6000
G0 X40.0000 Y35.0000
G1 Z-0.3000
G1 X59.5944 F24000
G1 Z4.0000 F6000
G0 X70.0000 Y70.0000 C90.0000
G1 Z-0.3000
G1 Y80.3527 F24000
G1 Z4.0000 F6000
G0 X70.0000 Y20.0000 C0.0000
G1 Z-0.3000
G1 X110.0000 F24000
G4 P0
G3 X120.0000 Y30.0000 C90.0000 I0.0000 J10.0000
G4 P0
G1 Y70.0000
G4 P0
G3 X110.0000 Y80.0000 C180.0000 I-10.0000 J0.0000
G4 P0
G1 X30.0000
G4 P0
G3 X20.0000 Y70.0000 C270.0000 I0.0000 J-10.0000
G4 P0
G1 Y30.0000
G4 P0
G3 X30.0000 Y20.0000 C360.0000 I10.0000 J0.0000
G4 P0
G1 X70.0000
G1 X70.3527
G1 Z4.0000 F6000
G0 Z20.0000
M65 P0
M5
G49
M2
"""

#: The same job with station datums in the coordinates and inverse-time feeds (G93) for arcs.
GRBLHAL = b"""\
(placement X20.0000 Y20.0000)
G21 G90 G91.1 G17 G40 G49 G94 G54 G92.1
G0 Z20.0000
G4 P0
M65 P0
M65 P1
M65 P2
M5
M64 P1
G4 P0.15
G0 X150.0000 Y34.4000 Z18.5000 C90.0000
G0 Z2.5000
G1 Z-0.1000 F6000
G1 Y65.6000 F30000
G1 Z2.5000 F6000
G0 Z18.5000
G4 P0
M65 P1
M64 P2
G4 P0.15
G0 X-18.5000 Y45.7000 Z20.0000 C90.0000
G0 Z4.0000
G1 Y49.0000 Z0.7000 F3000
G1 X21.5000 F12000
G1 Y45.7000 Z4.0000 F3000
G0 X18.5000 Y64.3000 C270.0000
G1 Y61.0000 Z0.7000
G1 X-21.5000 F12000
G1 Y64.3000 Z4.0000 F3000
G0 Z20.0000
G4 P0
M65 P2
M64 P0
M3 S1
G4 P0.15
G0 X40.0000 Y60.0000 Z20.0000 C0.0000
G0 Z4.0000
G1 Z1.0000 F6000
G1 X79.8237 F24000
G1 Z4.0000 F6000
G0 X40.0000 Y35.0000
G1 Z-0.3000
G1 X59.5944 F24000
G1 Z4.0000 F6000
G0 X70.0000 Y70.0000 C90.0000
G1 Z-0.3000
G1 Y80.3527 F24000
G1 Z4.0000 F6000
G0 X70.0000 Y20.0000 C0.0000
G1 Z-0.3000
G1 X110.0000 F24000
G93 G3 X120.0000 Y30.0000 C90.0000 I0.0000 J10.0000 F1527.887
G94 G1 Y70.0000 F24000
G93 G3 X110.0000 Y80.0000 C180.0000 I-10.0000 J0.0000 F1527.887
G94 G1 X30.0000 F24000
G93 G3 X20.0000 Y70.0000 C270.0000 I0.0000 J-10.0000 F1527.887
G94 G1 Y30.0000 F24000
G93 G3 X30.0000 Y20.0000 C360.0000 I10.0000 J0.0000 F1527.887
G94 G1 X70.0000 F24000
G1 X70.3527
G1 Z4.0000 F6000
G0 Z20.0000
G4 P0
M65 P0
M5
G49
M30
"""


def changed(text: bytes, old: str, new: str) -> bytes:
    """Return the program with ``old``, which must occur exactly once, replaced by ``new``."""
    assert text.count(old.encode()) == 1, f"{old!r} occurs {text.count(old.encode())} times"
    return text.replace(old.encode(), new.encode())


def knife_program(*lines: str) -> bytes:
    """Return a program with these lines for the knife, with a header and an end."""
    return _program(1, "M64 P0\nM3 S1\nG4 P0.15", "M65 P0\nM5", lines)


def wheel_program(*lines: str) -> bytes:
    """Return a program with these lines for the crease wheel, with a header and an end."""
    return _program(2, "M64 P1\nG4 P0.15", "M65 P1", lines)


def cutter_program(*lines: str) -> bytes:
    """Return a program with these lines for the V-cutter, with a header and an end."""
    return _program(3, "M64 P2\nG4 P0.15", "M65 P2", lines)


def _program(number: int, down: str, up: str, lines: tuple[str, ...]) -> bytes:
    head = "G21 G90 G91.1 G17 G40 G49 G94 G54 G92.1\nG64 P0.0050 Q0.0050\nG0 Z20.0000"
    off = "M65 P0\nM65 P1\nM65 P2\nM5"
    body = "\n".join(lines)
    return f"{head}\n{off}\nT{number} M6 G43\n{down}\n{body}\nG0 Z20.0000\n{up}\nG49\nM2\n".encode()
