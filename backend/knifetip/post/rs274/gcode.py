"""gcode: format the moves of one station as lines of G-code.

The words of all lines are computed at once, and then written line by line (``line_text``).
Positions are rounded, not distances, so that errors do not accumulate.  The centre of an arc is
computed from its rounded ends, so the output is a valid arc.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Final

import numpy as np

from knifetip.errors import ProgramError
from knifetip.geometry import arc
from knifetip.geometry.chords import DEVIATION, chord_counts, split_moves
from knifetip.geometry.columns import F64, I32, I64, U8, Bool
from knifetip.geometry.tolerance import BULGE
from knifetip.model.machine import Carriage
from knifetip.model.toolpath import Toolpath
from knifetip.post.rs274.controller import Dialect
from knifetip.post.rs274.line_columns import (
    LineColumns,
    TimeRules,
    compute_lines,
    round_poses,
    swivel_without_turn,
)
from knifetip.post.rs274.line_text import MAX_BYTES, LineFormat, LineWords, write_lines

#: An arc with a smaller sagitta is written as a line (mm).
MIN_SAGITTA: Final = 0.0005
#: An arc with a smaller radius is written as a line: LinuxCNC refuses radii up to 0.00127 mm (mm).
MIN_RADIUS: Final = 0.002
#: Greatest deviation of the chords of an arc that is too large for the controller (mm).
CHORD_DEVIATION: Final = 0.001
#: Greatest number of decimals of a feed; zeros at the end are left out.
FEED_DECIMALS: Final = 9
_TENS: Final = 10 ** np.arange(FEED_DECIMALS + 1)
#: End of a line after which the machine must come to rest; the dwell of zero seconds waits for it.
EXACT_STOP: Final = b"\nG4 P0\n"
#: Greatest length of a comment; with parentheses it is below the 70 bytes of every buffer.
MAX_COMMENT: Final = 66
#: Number of lines that are formatted together; it bounds the memory.
BATCH: Final = 1 << 15


@dataclass(frozen=True, eq=False, slots=True)
class _Moves:
    """n moves between n + 1 poses.

    Arcs that the controller could not follow have been replaced by chords or lines.
    """

    pose: F64  #: (n + 1, 4) mm and degrees, including the datum if the numbers need it
    bulge: F64  #: (n,)
    motion: U8  #: (n,) Motion of each move
    feed: F64  #: (n,) mm/min; degrees/min for a SWIVEL
    row: I32  #: (n,) row of each move in the Toolpath


def format_comment(text: str) -> str:
    """Return a text as a G-code comment that no controller executes; "" if no characters remain.

    Characters that a controller could execute are replaced by spaces.  LinuxCNC executes comments
    with a comma: ``(PY,…)`` runs Python, ``(LOGOPEN,…)`` writes files.  grbl executes ``!``, ``~``
    and ``?`` everywhere, also within comments.
    """
    clean = " ".join(re.sub(r"[^ -~]|[(),;!~?%$]", " ", text).split())[:MAX_COMMENT].rstrip()
    return f"({clean})" if clean else ""


def format_number(value: float) -> str:
    """Return a number as text with 4 decimals; zero has no sign."""
    # Adding zero turns -0.0 into 0.0.
    return f"{round(value, 4) + 0.0:.4f}"


def dwell_line(seconds: float) -> str:
    """Return the program line that makes the machine dwell, without a newline."""
    return f"G4 P{format_number(seconds)}".rstrip("0").rstrip(".")


def format_lines(
    toolpath: Toolpath,
    first: int,
    last: int,
    datum: F64,
    carriage: Carriage,
    dialect: Dialect,
    blending: float,
    *,
    chords: bool = False,
) -> tuple[bytes, I32]:
    """Return the program text of rows ``first … last - 1`` of a toolpath, and the toolpath row of
    each program line.

    All rows belong to one station.  The first line has words for all axes, even for an axis whose
    position does not change: the station change has replaced the datum, so the axis must move to
    reach the same position with the new datum.  The words have the letters of the axes of the
    carriage.  Controllers make arcs only in X and Y, so the arcs of a further carriage become
    chords.  LinuxCNC reads a feed (G94) as the feed along X, Y and Z only, so the feed lines of a
    further carriage are timed (G93).  A move that rounds to zero length and turn gets no
    line; an arc too large for the controller gets several lines.  Lines that belong to no row have
    row -1.

    Parameters
    ----------
    datum : (4,) float64, mm and degrees
        Added to the X, Y, Z and C of the program; zeros if the controller's tool table adds it.
    carriage : Carriage
        Carriage of the station, with the letters, velocities and accelerations of its axes.
    dialect : Dialect
        Dialect of RS274/NGC that the controller reads.
    blending : float, mm
        Greatest deviation that the controller may make between two moves.
    chords : bool
        Whether all arcs become chords, because the controller cannot follow arcs.

    Raises
    ------
    ProgramError
        A row with the motion "swivel" moves without a turn of C, or a line is longer than the
        controller can read.
    """
    largest = dialect.radius if carriage.is_first and not chords else 0.0
    deviation = DEVIATION if chords else CHORD_DEVIATION
    moves = _convert_arcs(toolpath, first, last, datum, largest, deviation)
    words, rows = _compose_words(moves, carriage, dialect, blending)
    texts = _render_lines(words, rows, carriage.letters, dialect)
    row = np.insert(rows, np.flatnonzero(words.exact_stop) + 1, np.int32(-1))
    if words.inverse[-1]:
        texts.append(b"G94\n")
        row = np.append(row, np.int32(-1))
    return b"".join(texts), row


def _convert_arcs(
    toolpath: Toolpath, first: int, last: int, datum: F64, largest: float, deviation: float
) -> _Moves:
    """Return the moves of rows ``first … last - 1`` of a toolpath, with arcs that the controller
    can follow.

    Flat and tiny arcs become lines.  Arcs whose radius is larger than ``largest`` (mm) become
    chords, which deviate from the arc by at most ``deviation`` (mm).  ``datum``, (4,), is added to
    the X, Y, Z and C of all poses (mm and degrees).
    """
    pose = toolpath.pose[first : last + 1] + datum
    bulge = np.array(toolpath.bulge[first:last])
    curved = np.flatnonzero(bulge)
    start, end = pose[curved, :2], pose[curved + 1, :2]
    bow = np.abs(bulge[curved]) * np.hypot(*(end - start).T) / 2.0
    radius = arc.radius(start, end, bulge[curved])
    large = radius > largest
    straight = curved[large | (bow < MIN_SAGITTA) | (radius < MIN_RADIUS)]
    pieces = np.ones(len(bulge), np.int64)
    arcs = curved[large]
    pieces[arcs] = chord_counts(pose[arcs, :2], pose[arcs + 1, :2], bulge[arcs], deviation)
    pose, rows = split_moves(pose, bulge, pieces)
    bulge[straight] = 0.0
    picked = rows + first
    return _Moves(
        pose=pose,
        bulge=bulge[rows],
        motion=toolpath.motion[picked],
        feed=toolpath.feed[picked],
        row=picked.astype(np.int32),
    )


def _compose_words(
    moves: _Moves, carriage: Carriage, dialect: Dialect, blending: float
) -> tuple[LineWords, I32]:
    """Return the G-code words of the program lines for n moves, and the toolpath row of each line.

    A move other than the first gets no line if its length and its turn are both 0 after rounding.
    ``blending`` is the greatest deviation that the controller may make between two moves (mm).
    """
    scale = 10.0**dialect.decimals
    units = round_poses(moves.pose, scale)
    unturned = swivel_without_turn(units, moves.motion)
    if unturned >= 0:
        raise ProgramError("toolpath.swivel-without-turn", row=moves.row[unturned])
    arcs = np.flatnonzero(np.abs(moves.bulge) >= BULGE)
    arcs = arcs[(units[arcs + 1, :2] != units[arcs, :2]).any(axis=1)]
    start, end, arc_bulge = units[arcs, :2] / scale, units[arcs + 1, :2] / scale, moves.bulge[arcs]
    bulge = np.zeros(len(moves.bulge))
    bulge[arcs] = arc_bulge
    rules = TimeRules(
        scale,
        60.0 * carriage.axes[3].velocity,
        arcs=dialect.inverse_arcs,
        always=not carriage.is_first,
    )
    lengths = arc.length(start, end, arc_bulge)
    lines: LineColumns = compute_lines(units, bulge, lengths, moves.motion, moves.feed, rules)
    centre = np.zeros((len(lines.row), 2), np.int64)
    offset = arc.centre(start, end, arc_bulge) - start
    centre[np.searchsorted(lines.row, arcs)] = np.rint(offset * scale).astype(np.int64)
    counts = _feed_units(lines.feed)
    if dialect.blending:
        exact_stop = _exact_stops(lines, carriage, blending)
    else:
        exact_stop = np.zeros(len(lines.row), np.bool_)
    words = LineWords(
        code=lines.code,
        inverse=lines.inverse,
        ends_inverse=~lines.inverse & np.concatenate([[False], lines.inverse[:-1]]),
        axes=lines.axes,
        emit=lines.emit & (np.arange(4) < len(carriage.letters)),
        centre=centre,
        feed=counts,
        emit_feed=_feed_words(counts, lines.inverse, lines.rapid),
        exact_stop=exact_stop,
    )
    return words, moves.row[lines.row]


def _exact_stops(lines: LineColumns, carriage: Carriage, blending: float) -> Bool:
    """Return the mask of the n moves that must end at rest because LinuxCNC would leave the path,
    (n,).

    If C starts or stops turning between two moves, LinuxCNC's planner overlaps the moves for the
    time that the slower axis needs to change its speed, whatever the P of G64 is.  If the moves
    have different curvature, LinuxCNC cuts the corner between them.  With v the greater speed of
    the two moves, a and α the accelerations of X, Y and of C, κ the turn of C per mm, Δκ its change
    between the moves, and t the time of the change, the tip leaves the path by up to::

        Δκ (v t)² / 2        t = max(v / a, v Δκ / α)

    Measured on LinuxCNC 2.9 with the acceleration of the demo table, arcs of 5 … 200 mm followed by
    lines at 100 … 400 mm/s: 0.003 … 3.5 mm without stops, 0.0004 mm with them.

    ``lines``: the n moves.
    ``carriage``: contains the accelerations of the axes.
    ``blending`` float, mm: greatest deviation that is permitted without a stop.
    """
    turn, travel = np.radians(lines.turn), lines.travel
    in_place = (travel == 0.0) & (turn != 0.0)
    bend = np.divide(turn, travel, out=np.zeros_like(turn), where=travel > 0.0)
    speed = travel / (60.0 * lines.minutes)
    change = np.abs(np.diff(bend))
    fastest = np.maximum(speed[1:], speed[:-1])
    x, y, _, c = (axis.acceleration for axis in carriage.axes)
    thrust, twist = min(x, y), np.radians(c)
    time = np.maximum(fastest / thrust, fastest * change / twist)
    deviation = change * (fastest * time) ** 2 / 2.0
    # Above the board deviations do not matter, but a tool must be turned before it plunges.
    rapid = lines.rapid
    air = rapid[1:] | rapid[:-1]
    both = rapid[1:] & rapid[:-1]
    result = np.zeros(len(turn), np.bool_)
    result[:-1] = np.where(in_place[1:] != in_place[:-1], ~both, ~air & (deviation > blending))
    return result


def _feed_units(feed: F64) -> I64:
    """Return n feeds, (n,), as integers in units of the last decimal place of the F word.

    ``feed`` are the feeds in the unit of the program.  They are rounded to six significant digits.
    """
    # Neighbouring lines often have the same feed.
    new = np.ones(len(feed), np.bool_)
    new[1:] = feed[1:] != feed[:-1]
    safe = np.maximum(feed[new], 1e-3)
    decimals = np.clip(5.0 - np.floor(np.log10(safe)), 0.0, FEED_DECIMALS).astype(np.int64)
    digits = np.rint(safe * _TENS[decimals]).astype(np.int64)
    units = digits * _TENS[FEED_DECIMALS - decimals]
    result: I64 = units[np.cumsum(new) - 1]
    return result


def _feed_words(feed: I64, inverse: Bool, rapid: Bool) -> Bool:
    """Return the mask of the n program lines that need an F word, (n,).

    A rapid needs none; all other lines are called feed lines here.  In G93 (inverse time) each feed
    line needs an F word.  In G94 a feed line needs one if it is the first feed line, if its feed
    differs from the feed of the previous feed line, or if the previous feed line was in G93.

    ``feed`` (n,): feed of each line, in units of its last decimal place.
    ``inverse``, ``rapid`` (n,): masks of the lines in G93 and of the rapids.
    """
    working = np.flatnonzero(~rapid)
    modal_feed = np.where(inverse, -1, feed)[working]
    changed = np.ones(len(working), np.bool_)
    changed[1:] = inverse[working[1:]] | (modal_feed[1:] != modal_feed[:-1])
    emit = np.zeros(len(feed), np.bool_)
    emit[working] = changed
    return emit


def _render_lines(words: LineWords, rows: I32, letters: str, dialect: Dialect) -> list[bytes]:
    """Return the text of program lines, in parts of at most ``BATCH`` lines.

    ``rows`` are the toolpath rows of the lines, and ``letters`` the letters of the words of the
    four axes.

    Raises ``ProgramError``: a line is longer than the controller can read.
    """
    form = LineFormat(
        np.frombuffer(letters.ljust(4).encode(), np.uint8),
        dialect.decimals,
        FEED_DECIMALS,
        np.frombuffer(EXACT_STOP, np.uint8),
        dialect.line_limit,
    )
    out = np.empty(min(len(rows), BATCH) * MAX_BYTES, np.uint8)
    texts = []
    for first in range(0, len(rows), BATCH):
        used, long, begin = write_lines(words, form, first, min(first + BATCH, len(rows)), out)
        if long >= 0:
            line = out[begin:used].tobytes().decode()
            raise ProgramError(
                "program.line-too-long",
                row=rows[long],
                length=used - begin,
                line=line[:60],
                dialect=dialect.name,
                limit=dialect.line_limit,
            )
        texts.append(out[:used].tobytes())
    return texts
