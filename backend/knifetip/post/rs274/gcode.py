"""gcode: the lines of a run of moves, all at once.

    Toolpath, rows of one station  ->  bytes, one line to a move, and the row of each line

A line is a row of characters in a matrix, each word a block of its columns, with 0 where nothing
is printed; leaving out the zeros makes the text.  Positions are rounded as positions, so errors
never add up, and an arc's centre is computed from its rounded ends: what is printed is an arc.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final

import numpy as np

from knifetip.errors import ProgramError
from knifetip.geometry import arc
from knifetip.geometry.columns import F64, I32, I64, U8, Bool
from knifetip.geometry.tolerance import BULGE
from knifetip.model.machine import Machine
from knifetip.model.toolpath import Motion, Toolpath
from knifetip.post.chords import split
from knifetip.post.digits import Characters, digits
from knifetip.post.rs274.controller import Dialect

#: An arc that stands off its chord by less than this is printed as a line (mm).
FLAT: Final = 0.0005
#: An arc smaller than this is printed as a line: LinuxCNC refuses radii up to 0.00127 mm (mm).
SMALL: Final = 0.002
#: The chords that stand for an arc too large for the controller stay within this of it (mm).
CHORD: Final = 0.001
#: No controller turns a move shorter than this into steps (minutes).
SHORTEST: Final = 1e-4 / 60.0
#: Decimals of a feed, of which the last are printed only where they are needed.
FEED_DECIMALS: Final = 9
#: Ends a line and, where the next move must wait for its end, says so: a dwell of nothing.
HALT: Final = b"\nG4 P0\n"
#: Longest comment; with its parentheses it stays below the 70 bytes that every buffer takes.
COMMENT: Final = 66
#: Lines that are composed together, which bounds the memory.
BATCH: Final = 1 << 15


@dataclass(frozen=True, eq=False, slots=True)
class _Moves:
    """n moves between n + 1 poses, arcs within what the controller can follow."""

    pose: F64  #: (n + 1, 4) mm and degrees, datum added where the numbers need it
    bulge: F64  #: (n,)
    motion: U8  #: (n,) Motion
    feed: F64  #: (n,) mm/min; degrees/min for a SWIVEL
    row: I32  #: (n,) row in Toolpath


@dataclass(frozen=True, eq=False, slots=True)
class _Words:
    """What each of n lines says, in units of the last place that is printed."""

    code: U8  #: (n,) 0 … 3, the number behind G
    inverse: Bool  #: (n,) the line goes by G93
    leaves: Bool  #: (n,) the line goes back to G94
    axes: I64  #: (n, 4) X Y Z C
    says: Bool  #: (n, 4) which of them are printed
    centre: I64  #: (n, 2) I J, printed where code is 2 or 3
    feed: I64  #: (n,)
    says_feed: Bool  #: (n,)
    halts: Bool  #: (n,) the move must end before the next one begins
    row: I32  #: (n,)


def comment(text: str) -> str:
    """Return a text as a comment that no controller obeys; nothing where nothing is left of it.

    A comma makes LinuxCNC obey a comment: ``(PY,…)`` runs Python, ``(LOGOPEN,…)`` writes files.
    grbl obeys ``!``, ``~`` and ``?`` wherever they stand.
    """
    clean = " ".join(re.sub(r"[^ -~]|[(),;!~?%$]", " ", text).split())[:COMMENT].rstrip()
    return f"({clean})" if clean else ""


def plain(value: float) -> str:
    """Return a number with 4 decimals, zero without a sign."""
    # Adding zero turns -0.0 into 0.0.
    return f"{round(value, 4) + 0.0:.4f}"


def dwell(seconds: float) -> str:
    """Return the line that waits."""
    return f"G4 P{plain(seconds)}".rstrip("0").rstrip(".")


def lines(
    toolpath: Toolpath,
    first: int,
    last: int,
    datum: F64,
    machine: Machine,
    dialect: Dialect,
    blending: float,
) -> tuple[bytes, I32]:
    """Return the text of the rows ``first … last - 1``, all of one station, and each line's row.

    The first line says all its axes, whatever the controller remembers: where a tool table gives
    another datum, an axis that is left unsaid stays where the *joint* is, which is elsewhere.
    A move that rounds to nothing gets no line; an arc too large for the controller gets several.

    Parameters
    ----------
    datum : (4,) float64, mm and degrees
        Added to the numbers; zeros where the controller's tool table does it.
    machine : Machine
        How fast its axes are.
    blending : float, mm
        How far the controller may leave the path where one move goes over into the next.

    Raises
    ------
    ProgramError
        A swivel that does not turn, or a line longer than the controller can read.
    """
    moves = _followable(toolpath, first, last, datum, dialect)
    words = _worded(moves, machine, dialect, blending)
    texts = [_text(words, slice(at, at + BATCH), dialect) for at in range(0, len(words.row), BATCH)]
    row = np.insert(words.row, np.flatnonzero(words.halts) + 1, np.int32(-1))
    if words.inverse[-1]:
        texts.append(b"G94\n")
        row = np.append(row, np.int32(-1))
    return b"".join(texts), row


def _followable(toolpath: Toolpath, first: int, last: int, datum: F64, dialect: Dialect) -> _Moves:
    """Return the moves with flat and tiny arcs as lines, too large ones as chords."""
    pose = toolpath.pose[first : last + 1] + datum
    bulge = np.array(toolpath.bulge[first:last])
    start, end = pose[:-1, :2], pose[1:, :2]
    bow = np.abs(bulge) * np.hypot(*(end - start).T) / 2.0
    radius = arc.radius(start, end, bulge)
    large = radius > dialect.radius
    straight = large | (bow < FLAT) | (radius < SMALL)
    # A piece of an arc bows by the square of its share.
    pieces = np.where(large, np.ceil(np.sqrt(bow / CHORD)), 1.0).astype(np.int64).clip(1)
    pose, rows = split(pose, bulge, pieces)
    bulge[straight] = 0.0
    picked = rows + first
    return _Moves(
        pose=pose,
        bulge=bulge[rows],
        motion=toolpath.motion[picked],
        feed=toolpath.feed[picked],
        row=picked.astype(np.int32),
    )


def _worded(moves: _Moves, machine: Machine, dialect: Dialect, blending: float) -> _Words:
    """Return what the lines say; moves that round to nothing are left out."""
    scale = 10.0**dialect.decimals
    units = np.rint(moves.pose * scale).astype(np.int64)
    says = units[1:] != units[:-1]
    says[0] = True
    printed = says.any(axis=1)
    turns = units[1:, 3] != units[:-1, 3]

    pose = units / scale
    start, end = pose[:-1, :2], pose[1:, :2]
    round_ = (np.abs(moves.bulge) >= BULGE) & (units[1:, :2] != units[:-1, :2]).any(axis=1)
    bulge = np.where(round_, moves.bulge, 0.0)
    centre = np.zeros((len(bulge), 2), np.int64)
    middle = arc.centre(start[round_], end[round_], bulge[round_])
    centre[round_] = np.rint((middle - start[round_]) * scale).astype(np.int64)
    says[round_] |= (True, True, False, True)

    rapid = moves.motion == Motion.RAPID
    swivel = moves.motion == Motion.SWIVEL
    # A move of one unit may be only the rounding of a turn that is too small to print.
    moved = (np.abs(np.diff(units[:, :3], axis=0)) > 1).any(axis=1)
    if (still := swivel & moved & ~turns).any():
        row = moves.row[np.argmax(still)]
        raise ProgramError("toolpath.swivel-without-turn", row=row)
    inverse = ~rapid & turns & (~round_ | swivel | dialect.inverse_arcs)
    degrees = np.abs(pose[1:, 3] - pose[:-1, 3])
    travel = np.hypot(arc.length(start, end, bulge), pose[1:, 2] - pose[:-1, 2])
    asked = np.where(rapid, 1.0, moves.feed)
    minutes = np.where(swivel, degrees, travel) / asked
    minutes = np.maximum(minutes, degrees / (60.0 * machine.c.velocity))
    minutes = np.maximum(minutes, SHORTEST)
    feed = np.where(inverse, 1.0 / minutes, moves.feed)

    keep = np.flatnonzero(printed)
    inverse, rapid = inverse[keep], rapid[keep]
    counts = _feed_units(feed[keep])
    if dialect.blending:
        turn = np.radians(pose[1:, 3] - pose[:-1, 3])[keep]
        halts = _halts(turn, travel[keep], minutes[keep], rapid, machine, blending)
    else:
        halts = np.zeros(len(keep), np.bool_)
    return _Words(
        code=np.where(rapid, 0, np.where(round_, 2 + (moves.bulge > 0), 1)[keep]).astype(np.uint8),
        inverse=inverse,
        leaves=~inverse & np.concatenate([[False], inverse[:-1]]),
        axes=units[1:][keep],
        says=says[keep],
        centre=centre[keep],
        feed=counts,
        says_feed=_spoken(counts, inverse, rapid),
        halts=halts,
        row=moves.row[keep],
    )


def _halts(
    turn: F64, travel: F64, minutes: F64, rapid: Bool, machine: Machine, blending: float
) -> Bool:
    """Return the moves that must end before the next begins, or LinuxCNC would leave the path.

    Where C begins or ends to turn, its planner overlaps the two moves for as long as the slower
    axis needs to change its speed, and does not ask P: where the moves bend differently it cuts
    across.  With t the time of the change, the tip then leaves the path by up to::

        Δκ (v t)² / 2        t = max(v / a, v Δκ / α)        κ = turn of C per mm

    On LinuxCNC 2.9 with the acceleration of the demo table, arcs of 5 … 200 mm into lines
    at 100 … 400 mm/s ran 0.003 … 3.5 mm beside, and 0.0004 mm where each had to end.

    Parameters
    ----------
    turn : (n,) float64, radians
    travel : (n,) float64, mm
        Both along each move.
    minutes : (n,) float64
        What each move takes; of no meaning for rapids.
    """
    alone = (travel == 0.0) & (turn != 0.0)
    bend = np.divide(turn, travel, out=np.zeros_like(turn), where=travel > 0.0)
    speed = travel / (60.0 * minutes)
    change = np.abs(np.diff(bend))
    fastest = np.maximum(speed[1:], speed[:-1])
    thrust = min(machine.x.acceleration, machine.y.acceleration)
    twist = np.radians(machine.c.acceleration)
    time = np.maximum(fastest / thrust, fastest * change / twist)
    aside = change * (fastest * time) ** 2 / 2.0
    # In the air nothing is cut; but a tool goes down only after it has turned.
    air = rapid[1:] | rapid[:-1]
    both = rapid[1:] & rapid[:-1]
    result = np.zeros(len(turn), np.bool_)
    result[:-1] = np.where(alone[1:] != alone[:-1], ~both, ~air & (aside > blending))
    return result


def _feed_units(feed: F64) -> I64:
    """Return feeds to six figures, in units of FEED_DECIMALS."""
    safe = np.maximum(feed, 1e-3)
    decimals = np.clip(5.0 - np.floor(np.log10(safe)), 0.0, FEED_DECIMALS)
    whole = np.rint(safe * 10.0**decimals).astype(np.int64)
    units: I64 = whole * 10 ** (FEED_DECIMALS - decimals).astype(np.int64)
    return units


def _spoken(feed: I64, inverse: Bool, rapid: Bool) -> Bool:
    """Return which lines say their feed.

    G93 forgets it after every line, and so does the way back to G94.
    """
    working = np.flatnonzero(~rapid)
    heard = np.where(inverse, -1, feed)[working]
    speaks = np.ones(len(working), np.bool_)
    speaks[1:] = inverse[working[1:]] | (heard[1:] != heard[:-1])
    says = np.zeros(len(feed), np.bool_)
    says[working] = speaks
    return says


def _text(words: _Words, rows: slice, dialect: Dialect) -> bytes:
    code = words.code[rows]
    curved = code >= 2
    blocks = [
        _prefix(words.inverse[rows], words.leaves[rows]),
        np.full((len(code), 1), ord("G"), np.uint8),
        (code + np.uint8(ord("0")))[:, None],
    ]
    axes, says, centre = words.axes[rows], words.says[rows], words.centre[rows]
    for column, letter in enumerate(f"XYZ{dialect.rotary}"):
        blocks.extend(_word(letter, axes[:, column], says[:, column], dialect.decimals))
    for column, letter in enumerate("IJ"):
        blocks.extend(_word(letter, centre[:, column], curved, dialect.decimals))
    blocks.extend(_word("F", words.feed[rows], words.says_feed[rows], FEED_DECIMALS, brief=True))
    lengths = sum(np.count_nonzero(block, axis=1) for block in blocks)
    halt = np.frombuffer(HALT, np.uint8) * words.halts[rows][:, None]
    halt[:, 0] = ord("\n")
    characters = np.hstack([*blocks, halt])
    shown = characters != 0
    if (long := lengths > dialect.line_limit).any():
        at = int(np.argmax(long))
        line = characters[at][shown[at]].tobytes().decode().rstrip()
        raise ProgramError(
            "program.line-too-long",
            row=words.row[rows][at],
            length=lengths[at],
            line=line[:60],
            dialect=dialect.name,
            limit=dialect.line_limit,
        )
    text: bytes = characters[shown].tobytes()
    return text


def _prefix(inverse: Bool, leaves: Bool) -> Characters:
    spoken = np.frombuffer(b"\0\0\0\0G93 G94 ", np.uint8).reshape(3, 4)
    return spoken[inverse + 2 * leaves]


def _word(
    letter: str, values: I64, where: Bool, decimals: int, *, brief: bool = False
) -> Iterator[Characters]:
    """Yield the columns of one word: a space, its letter and its number."""
    if not where.any():
        return
    head = np.frombuffer(f" {letter}".encode(), np.uint8)
    yield head * where[:, None]
    yield digits(np.where(where, values, 0), decimals, brief=brief) * where[:, None]
