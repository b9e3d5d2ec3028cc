"""An interpreter of RS274/NGC as LinuxCNC and grblHAL execute it, with what happens at the table.

    execute(text, machine, tooled) -> Run: motions of the joints, and switchings of outputs

Nothing is known at the start: no mode, no position, no output.  A word that this interpreter does
not support stops it.  It shares no code with the verifier.

Two rules of the controllers matter beside the words.  grblHAL switches M64 and M65 as soon as it
reads them, while moves that it has read before are still running; a dwell waits for them.
LinuxCNC overlaps two moves unless a dwell is between them.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, field

import numpy as np

from knifetip.geometry.columns import F64
from knifetip.model.machine import Carriage, Machine

_TOKEN = re.compile(r"([A-Z])([+-]?(?:\d+\.?\d*|\.\d+))")
_COMMENT = re.compile(r"\([^)]*\)|;.*")
#: Modes in which these programs run, by the word that states each.
MODES = {
    "G17": "plane",
    "G21": "units",
    "G90": "distance",
    "G91.1": "centres",
    "G93": "feed",
    "G94": "feed",
    "G40": "radius",
    "G49": "length",
    "G43": "length",
    "G54": "system",
    "G92.1": "shift",
}
_ALONE = {"G0", "G1", "G2", "G3", "G4", "G64", "M2", "M30", "M3", "M5", "M6", "M64", "M65", *MODES}


class NotExecuted(Exception):
    """A controller would stop at a line, or the interpreter does not support it."""


@dataclass(frozen=True)
class Motion:
    """One move of the joints, with the state of the machine during it."""

    line: int
    code: int  #: 0 rapid, 1 line, 2 arc clockwise, 3 arc counter-clockwise
    #: joints X Y Z in mm, C in degrees, of the carriage of the station; NaN: unknown
    start: tuple[float, ...]
    end: tuple[float, ...]
    axes_start: dict[str, float]  #: joints of all axes of the machine, by their letters
    axes_end: dict[str, float]
    centre: tuple[float, float]
    station: int  #: index of the station whose offset the numbers have, -1 for none
    outputs: frozenset[int]  #: outputs that are on
    unknown: frozenset[str]  #: outputs, spindle and modes that no line has stated
    spindle: float  #: speed, 0 if it does not turn
    seconds: float  #: duration at the feed, NaN for a rapid
    stops_before: bool  #: the head is at rest between the move before and this move
    waited: float  #: dwell since the last switching of an output or the spindle (s)
    offset: dict[str, float]  #: part of the joints that the tool table adds to the numbers
    blending: float  #: greatest deviation by G64 (mm), 0 for grblHAL
    given: frozenset[str]  #: axes that have had a word since the last tool change


@dataclass(frozen=True)
class Switching:
    """A line that switches an output (0 and more) or the spindle (-1)."""

    line: int
    output: int
    on: bool
    heights: dict[str, float]  #: joints of all axes, NaN if unknown
    station: int
    moving: bool  #: the moves before may still be running
    lowered: frozenset[int]  #: outputs that are on after it
    unknown: frozenset[str]


@dataclass
class Run:
    """What a program makes the machine do."""

    motions: list[Motion] = field(default_factory=list)
    switchings: list[Switching] = field(default_factory=list)
    left: str = ""  #: what is on or unknown at the end
    ended: bool = False


@dataclass
class _State:
    joints: dict[str, float]
    offset: dict[str, float] = field(default_factory=dict)
    blending: float = math.inf
    modes: set[str] = field(default_factory=set)
    feed_mode: str = ""
    feed: float = math.nan
    speed: float = math.nan
    spindle: float = math.nan
    called: int = -1
    given: set[str] = field(default_factory=set)
    loaded: int = -1
    on: set[int] = field(default_factory=set)
    stated: set[int] = field(default_factory=set)
    last_lowered: int = -1
    stopped: bool = True
    waited: float = math.inf
    motion: str = ""


def execute(text: bytes, machine: Machine, *, tooled: bool) -> Run:
    """Return what a program does on a machine.

    With ``tooled`` the controller is LinuxCNC, which has a tool table; otherwise it is grblHAL.

    Raises
    ------
    NotExecuted
        A line is wrong, or has a word that is not supported.
    """
    run, state = Run(), _State(dict.fromkeys(machine.axes, math.nan))
    for number, line in enumerate(text.decode("latin-1").split("\n"), 1):
        words = _words(line, number)
        if words:
            if run.ended:
                raise NotExecuted(f"line {number} after the end")
            _block(words, number, state, machine, run, tooled)
    used = _outputs(machine)
    left = {f"output {one}" for one in used if one in state.on or one not in state.stated}
    if state.spindle != 0.0:
        left.add("spindle")
    if any(state.offset.values()):
        left.add("tool offset")
    run.left = ", ".join(sorted(left))
    return run


def _words(line: str, number: int) -> list[tuple[str, float]]:
    plain = _COMMENT.sub("", line).replace(" ", "").replace("\t", "").rstrip("\r").upper()
    words, at = [], 0
    while at < len(plain):
        token = _TOKEN.match(plain, at)
        if not token:
            raise NotExecuted(f"line {number}: cannot read {plain[at : at + 10]!r}")
        words.append((token[1], float(token[2])))
        at = token.end()
    return [word for place, word in enumerate(words) if word[0] != "N" or place]


def _outputs(machine: Machine) -> set[int]:
    pistons = {held.output for held in machine.stations if held.output >= 0}
    airs = {getattr(held.tool, "air", -1) for held in machine.stations}
    return pistons | {air for air in airs if air >= 0}


def _block(
    words: list[tuple[str, float]],
    number: int,
    state: _State,
    machine: Machine,
    run: Run,
    tooled: bool,
) -> None:
    codes = [f"{letter}{value + 0.0:g}" for letter, value in words if letter in "GM"]
    values = {letter: value for letter, value in words if letter not in "GM"}
    if len(values) + len(codes) != len(words):
        raise NotExecuted(f"line {number}: a letter twice")
    if strange := set(codes) - _ALONE:
        raise NotExecuted(f"line {number}: {sorted(strange)} not supported")
    if strange := set(values) - {*machine.axes, *"IJFPQST"}:
        raise NotExecuted(f"line {number}: {sorted(strange)} not supported")
    for code in codes:
        if MODES.get(code) == "feed":
            state.feed_mode, state.feed = code, math.nan
    if "F" in values:
        state.feed = values["F"]
    state.speed = values.get("S", state.speed)
    if "T" in values:
        numbers = [held.number for held in machine.stations]
        if not tooled or values["T"] not in numbers:
            raise NotExecuted(f"line {number}: no tool T{values['T']:g}")
        state.called = numbers.index(int(values["T"]))
    if "M6" in codes:
        if not tooled or state.called < 0:
            raise NotExecuted(f"line {number}: M6 without a tool")
        state.loaded = state.called
        state.given.clear()
    _switch(codes, values, number, state, machine, run, tooled)
    if "G4" in codes:
        if not values.get("P", -1.0) >= 0.0:
            raise NotExecuted(f"line {number}: G4 without P")
        state.stopped = True
        state.waited += values["P"]
    for code in codes:
        if code in MODES:
            state.modes.add(MODES[code])
    if "G43" in codes:
        if not tooled or state.loaded < 0:
            raise NotExecuted(f"line {number}: G43 without a tool")
        held = machine.stations[state.loaded]
        letters = machine.carriage_of(held).letters
        datum = (held.x, held.y, held.z, held.c)
        state.offset = dict(zip(letters, datum, strict=True))
    if "G49" in codes:
        state.offset = {}
    if "G64" in codes:
        limit = values.get("P", 0.0)
        if not tooled:
            raise NotExecuted(f"line {number}: G64 without a tool table")
        state.blending = max(limit, values.get("Q", limit)) if limit > 0.0 else math.inf
        state.modes.add("path")
    _move(codes, values, number, state, machine, run, tooled)
    if {"M2", "M30"} & set(codes):
        run.ended = True


def _switch(
    codes: list[str],
    values: dict[str, float],
    number: int,
    state: _State,
    machine: Machine,
    run: Run,
    tooled: bool,
) -> None:
    for code in codes:
        if code not in ("M3", "M5", "M64", "M65"):
            continue
        on = code in ("M3", "M64")
        output = -1
        if code in ("M64", "M65"):
            output = int(values.get("P", -9))
            if output not in _outputs(machine) or values["P"] != output:
                raise NotExecuted(f"line {number}: output {values.get('P')} is not used")
            (state.on.add if on else state.on.discard)(output)
            state.stated.add(output)
            if on:
                pistons = [held.output for held in machine.stations]
                state.last_lowered = (
                    pistons.index(output) if output in pistons else (state.last_lowered)
                )
        else:
            if on and not state.speed > 0.0:
                raise NotExecuted(f"line {number}: M3 without S")
            state.spindle = state.speed if on else 0.0
        state.waited = 0.0
        if tooled:
            # LinuxCNC finishes the moves before it switches.
            state.stopped = True
        run.switchings.append(
            Switching(
                number,
                output,
                on,
                dict(state.joints),
                _working(state, machine, tooled),
                not tooled and not state.stopped,
                frozenset(state.on),
                _unknown(state, machine, tooled),
            )
        )


def _working(state: _State, machine: Machine, tooled: bool) -> int:
    """Return the index of the station that works, -1 for none."""
    if tooled:
        return state.loaded
    down = [k for k, held in enumerate(machine.stations) if held.output in state.on]
    if len(down) == 1:
        return down[0]
    return state.last_lowered if down else -1


def _unknown(state: _State, machine: Machine, tooled: bool) -> frozenset[str]:
    missing = {f"output {one}" for one in _outputs(machine) - state.stated}
    missing |= set(MODES.values()) - state.modes
    if tooled:
        missing |= {"path"} - state.modes
    if math.isnan(state.spindle):
        missing.add("spindle")
    return frozenset(missing)


def _move(
    codes: list[str],
    values: dict[str, float],
    number: int,
    state: _State,
    machine: Machine,
    run: Run,
    tooled: bool,
) -> None:
    for word in codes:
        if word in ("G0", "G1", "G2", "G3"):
            state.motion = word
    axes = [letter for letter in machine.axes if letter in values]
    if not axes:
        if {"I", "J"} & values.keys():
            raise NotExecuted(f"line {number}: a centre without an arc")
        return
    if not state.motion:
        raise NotExecuted(f"line {number}: an axis without a motion")
    code = int(state.motion[1])
    state.given.update(axes)
    before = dict(state.joints)
    for letter in axes:
        state.joints[letter] = values[letter] + state.offset.get(letter, 0.0)
    station = _working(state, machine, tooled)
    carriage = machine.carriages[machine.stations[station].carriage - 1 if station >= 0 else 0]
    start, end = (
        tuple(joints[letter] for letter in carriage.letters) for joints in (before, state.joints)
    )
    if code >= 2 and not carriage.is_first:
        raise NotExecuted(f"line {number}: an arc of a further carriage")
    centre = (math.nan, math.nan)
    if code >= 2:
        if not {"I", "J"} & values.keys() or not {"X", "Y"} & values.keys():
            raise NotExecuted(f"line {number}: an arc without centre or end")
        centre = (start[0] + values.get("I", 0.0), start[1] + values.get("J", 0.0))
        radii = [math.dist(at[:2], centre) for at in (start, end)]
        if not abs(radii[0] - radii[1]) < 0.005 or not min(radii) > 1e-4:
            raise NotExecuted(f"line {number}: the radius differs from {radii[0]} to {radii[1]}")
    elif {"I", "J"} & values.keys():
        raise NotExecuted(f"line {number}: a centre without an arc")
    run.motions.append(
        Motion(
            number,
            code,
            start,
            end,
            before,
            dict(state.joints),
            centre,
            station,
            frozenset(state.on),
            _unknown(state, machine, tooled),
            0.0 if math.isnan(state.spindle) else state.spindle,
            _seconds(code, start, end, centre, state, carriage, number, "F" in values, tooled),
            state.stopped,
            state.waited,
            dict(state.offset),
            state.blending if tooled else 0.0,
            frozenset(state.given),
        )
    )
    state.stopped = False


def _seconds(
    code: int,
    start: tuple[float, ...],
    end: tuple[float, ...],
    centre: tuple[float, float],
    state: _State,
    carriage: Carriage,
    number: int,
    stated: bool,
    tooled: bool,
) -> float:
    """Return the duration of a move at its feed, NaN for a rapid.

    In G94 LinuxCNC applies the feed to X, Y and Z alone if they move; grblHAL to all axes alike.
    """
    if code == 0:
        return math.nan
    if not state.feed > 0.0 or (state.feed_mode == "G93" and not stated):
        raise NotExecuted(f"line {number}: no feed")
    if state.feed_mode == "G93":
        return 60.0 / state.feed
    rise, turn = end[2] - start[2], abs(end[3] - start[3])
    flat = math.dist(start[:2], end[:2])
    if code >= 2:
        flat = abs(arc_sweep(code, start, end, centre)) * math.dist(start[:2], centre)
    if tooled and not carriage.is_first:
        moves = [
            abs(after - before)
            for letter, before, after in zip(carriage.letters, start, end, strict=True)
            if letter in "XYZ"
        ]
        flat, rise = math.hypot(*moves), 0.0
    length = math.hypot(flat, rise) if tooled else math.hypot(flat, rise, turn)
    least = turn / carriage.axes[3].velocity
    return max(60.0 * (length or turn) / state.feed, least)


def arc_sweep(
    code: int, start: tuple[float, ...], end: tuple[float, ...], centre: tuple[float, float]
) -> float:
    """Return the angle of an arc in radians, counter-clockwise positive."""
    first = math.atan2(start[1] - centre[1], start[0] - centre[0])
    last = math.atan2(end[1] - centre[1], end[0] - centre[0])
    turn = (last - first) % math.tau if code == 3 else (first - last) % math.tau
    if math.dist(start[:2], end[:2]) < 5e-5:
        turn = math.tau
    return turn if code == 3 else -turn


def sample(motion: Motion) -> F64:
    """Return poses X Y Z C along a move, (n, 4), whose chords are within 0.0005 mm of the path."""
    start, end = np.array(motion.start), np.array(motion.end)
    pieces = 1 + int(min(720.0, abs(end[3] - start[3]) / 2.0 if abs(end[3] - start[3]) > 20 else 0))
    if motion.code < 2:
        line: F64 = start + (end - start) * np.linspace(0.0, 1.0, pieces + 1)[:, None]
        return line
    sweep = arc_sweep(motion.code, motion.start, motion.end, motion.centre)
    middle = np.array(motion.centre)
    radius, last = np.hypot(*(start[:2] - middle)), np.hypot(*(end[:2] - middle))
    pieces = max(pieces, 2, int(abs(sweep) / math.sqrt(8.0 * 5e-4 / max(radius, 1e-3))) + 1)
    fraction = np.linspace(0.0, 1.0, pieces + 1)
    angle = math.atan2(start[1] - middle[1], start[0] - middle[0]) + sweep * fraction
    size = radius + (last - radius) * fraction
    poses: F64 = start + (end - start) * fraction[:, None]
    poses[:, 0] = middle[0] + size * np.cos(angle)
    poses[:, 1] = middle[1] + size * np.sin(angle)
    return poses
