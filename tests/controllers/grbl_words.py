"""Check programs as strictly as grbl 1.1 and grblHAL do, with an interpreter written for the tests.

It supports only what the tests need, and raises an AssertionError with the line for everything to
which a controller would respond with ``error:``.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field

import numpy as np

LINE = 80
MOTION = {"G0", "G1", "G2", "G3"}
OTHER = {"G21", "G90", "G91.1", "G17", "G40", "G49", "G94", "G93", "G54", "G92.1", "G4"}
STOPS = {"M3", "M5", "M64", "M65", "M30"}
AXES = "XYZC"


@dataclass
class Line:
    """The effect of one program line on the controller."""

    number: int
    motion: str = ""
    start: np.ndarray = field(default_factory=lambda: np.zeros(4))
    end: np.ndarray = field(default_factory=lambda: np.zeros(4))
    centre: np.ndarray | None = None
    feed: float = 0.0
    inverse: bool = False
    outputs: frozenset[int] = frozenset()
    oscillates: bool = False


def read_grbl(program: bytes) -> list[Line]:
    """Return the interpreted lines of a program; raise an AssertionError if grbl would refuse
    one.
    """
    assert program.endswith(b"\n")
    position = np.zeros(4)
    feed, inverse, oscillates, ended = 0.0, False, False, False
    outputs: set[int] = set()
    read = []
    for number, raw in enumerate(program.decode("ascii").split("\n")[:-1], 1):
        here = f"line {number}: {raw!r}"
        assert len(raw) <= LINE, here
        assert not set(raw) & set("!~?"), f"{here} would act on the controller at once"
        assert not ended, f"{here} is after the end"
        line = Line(number, start=position.copy(), end=position.copy())
        read.append(line)
        if raw.startswith("("):
            assert re.fullmatch(r"\([^()]*\)", raw), here
            continue
        found = re.findall(r"([A-Z])(-?\d+(?:\.\d+)?)", raw)
        assert " ".join(letter + value for letter, value in found) == raw, here
        commands = [letter + value for letter, value in found if letter in "GM"]
        values = {letter: float(value) for letter, value in found if letter not in "GM"}
        assert len(values) == sum(letter not in "GM" for letter, _ in found), here
        assert set(commands) <= MOTION | OTHER | STOPS, here
        motion = [command for command in commands if command in MOTION]
        assert len(motion) <= 1, here
        assert not ({"G93", "G94"} <= set(commands)), here
        if {"G93", "G94"} & set(commands):
            if inverse != ("G93" in commands):
                feed = 0.0
            inverse = "G93" in commands
        if "F" in values:
            feed = values.pop("F")
            assert feed > 0, here
        elif inverse and motion and motion != ["G0"]:
            raise AssertionError(f"{here} has no F, which G93 requires in every line")
        if "M64" in commands or "M65" in commands:
            assert len(commands) == 1, here
            (outputs.add if "M64" in commands else outputs.discard)(int(values.pop("P")))
        if "G4" in commands:
            assert values.pop("P") >= 0, here
        if "M3" in commands:
            assert values.pop("S") > 0, here
            oscillates = True
        oscillates = oscillates and "M5" not in commands
        ended = "M30" in commands
        offsets = [values.pop(letter) for letter in "IJ" if letter in values]
        assert set(values) <= set(AXES), here
        assert bool(values) == bool(motion), here
        if motion:
            line.motion = motion[0]
            for letter, value in values.items():
                assert abs(value) < 1e5, here
                line.end[AXES.index(letter)] = value
            position = line.end.copy()
            assert line.motion == "G0" or feed > 0, f"{here} has no feed"
        if line.motion in ("G2", "G3"):
            assert len(offsets) == 2, here
            assert {"X", "Y"} <= set(values), here
            _check_arc(line, np.array(offsets, np.float32), here)
        else:
            assert not offsets, here
        line.feed, line.inverse = feed, inverse
        line.outputs, line.oscillates = frozenset(outputs), oscillates
    assert ended, "the program does not end"
    return read


def _check_arc(line: Line, offset: np.ndarray, here: str) -> None:
    line.centre = line.start[:2] + offset
    # In single precision, like the controller: error 33.
    far = np.float32(line.end[:2] - line.start[:2]) - offset
    radius, other = np.hypot(*offset), np.hypot(*far)
    assert radius > 0, here
    assert abs(radius - other) <= 0.005, f"{here}: radii {radius} and {other}"
