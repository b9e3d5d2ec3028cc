"""dry_program: programs that move the head above the board and switch nothing on.

``dry_program`` is made from the program of a job.  It has the same lines: X, Y and C move as in the
program, at a share of its feeds.  All moves of Z are replaced by one lift at the start, and all
lines that switch outputs or the spindle are left empty.  Rapids become feed moves, so that they are
slow, too.

The rules are by permission: a line with any other word is refused.  ``check_dry_program`` then
reads both programs with the interpreter of the gateway, and compares their moves.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping
from itertools import zip_longest

from knifetip.contract.operations import LEAST_SHARE
from knifetip.errors import ControllerError
from knifetip.gateway.interpreter import (
    Block,
    Interpreter,
    LineRefused,
    strip_comments,
    tool_offsets,
)
from knifetip.gateway.motion import Move, Pose
from knifetip.gateway.program_blocks import lines_of
from knifetip.model.machine import Machine, Station

#: Modes of a program of this module; see ``post.rs274.program.HEADER``.
HEADER = b"G21 G90 G91.1 G17 G40 G49 G94 G54 G92.1"
#: Largest difference between the moves of a program and of its dry program (mm or degrees).
_ROUNDING = 1e-6

_WORD = re.compile(rb"([A-Z])([-+]?(?:\d+\.?\d*|\.\d+))")
_LINE = re.compile(rb"(?:[A-Z][-+]?(?:\d+\.?\d*|\.\d+))*")
#: Words that a line without motion may have, besides those in ``_SWITCHES``.
_MODES = frozenset(
    (b"G", code)
    for code in (21.0, 90.0, 91.1, 17.0, 40.0, 49.0, 94.0, 93.0, 54.0, 92.1, 64.0, 43.0, 4.0)
) | {(b"M", 6.0), (b"M", 2.0), (b"M", 30.0)}
#: M words that switch the spindle, coolant and outputs.
_SWITCHES = frozenset({3.0, 4.0, 5.0, 7.0, 8.0, 9.0, 62.0, 63.0, 64.0, 65.0})
_MOTIONS = frozenset({0.0, 1.0, 2.0, 3.0})


def dry_height(machine: Machine) -> float:
    """Return the height of Z in dry programs, as a position of the axis (mm).

    The tip of every station is then at travel height or above, also if its piston is lowered.  If
    the travel of Z ends below this height, the result is the upper limit of Z.
    """
    highest = max((station.z for station in machine.stations), default=0.0)
    return min(machine.travel_z + max(highest, 0.0), machine.z.high)


def dry_program(text: bytes, machine: Machine, share: float) -> bytes:
    """Return the dry program of a program, with one line for each of its lines.

    Parameters
    ----------
    text
        The program of a job.
    machine
        The machine, for its travel height and its velocities.
    share
        Share of the feeds, ``LEAST_SHARE`` to 1.  The share of a rapid is that of the velocities
        of its axes.

    Raises
    ------
    ControllerError
        A line has a word that no dry program can contain, or the program does not begin with a
        lift.
    """
    writer = _DryWriter(machine, share)
    lines = [writer.write(line, number) for number, line in enumerate(lines_of(text), 1)]
    return b"".join(line + b"\n" for line in lines)


class _DryWriter:
    """Writes the lines of a dry program one after another, and keeps their modal state."""

    def __init__(self, machine: Machine, share: float) -> None:
        self._share = min(max(share, LEAST_SHARE), 1.0)
        self._height = dry_height(machine)
        self._heading = machine.heading_letter.encode()
        self._velocity = {
            b"X": machine.x.velocity,
            b"Y": machine.y.velocity,
            self._heading: machine.c.velocity,
        }
        self._lifted = False
        self._motion = -1.0
        self._feed = 0.0
        self._inverse = False

    def write(self, line: bytes, number: int) -> bytes:
        """Return the dry line of a program line; ``number`` is its number, for errors."""
        text = strip_comments(line)
        if _LINE.fullmatch(text) is None:
            raise _refusal(line, number)
        found = [(word[1], float(word[2])) for word in _WORD.finditer(text)]
        commands = {word for word in found if word[0] in (b"G", b"M")}
        numbers = {letter: value for letter, value in found if letter not in (b"G", b"M")}
        switched = any(letter == b"M" and code in _SWITCHES for letter, code in commands)
        if switched:
            if len(commands) > 1 or not numbers.keys() <= {b"P", b"S"}:
                raise _refusal(line, number)
            return b""
        moves = not numbers.keys().isdisjoint({*self._velocity, b"Z", b"I", b"J"})
        motions = {code for letter, code in commands if letter == b"G" and code in _MOTIONS}
        if moves or motions:
            return self._move(line, number, commands, numbers)
        if not commands <= _MODES or not numbers.keys() <= {b"P", b"Q", b"T", b"F"}:
            raise _refusal(line, number)
        self._read_modes(commands, numbers)
        if (b"G", 4.0) in commands:
            # Only that the machine comes to rest matters here: nothing is switched.
            if len(found) != 2:
                raise _refusal(line, number)
            return b"G4 P0"
        return _without_feed(text)

    def _read_modes(
        self, commands: set[tuple[bytes, float]], numbers: Mapping[bytes, float]
    ) -> None:
        if (b"G", 93.0) in commands:
            self._inverse = True
        elif (b"G", 94.0) in commands:
            self._inverse = False
        self._feed = numbers.get(b"F", self._feed)

    def _move(
        self,
        line: bytes,
        number: int,
        commands: set[tuple[bytes, float]],
        numbers: dict[bytes, float],
    ) -> bytes:
        allowed = {(b"G", code) for code in (*_MOTIONS, 93.0, 94.0)}
        words = {*self._velocity, b"Z", b"I", b"J", b"F"}
        if not commands <= allowed or not numbers.keys() <= words:
            raise _refusal(line, number)
        self._read_modes(commands, numbers)
        self._motion = next((code for _, code in commands if code in _MOTIONS), self._motion)
        if not self._lifted:
            # Every program begins with a lift straight up, because a tool may be in the board.
            if self._motion != 0.0 or numbers.keys() != {b"Z"}:
                raise _refusal(line, number)
            self._lifted = True
            return b"G0 Z%.4f" % self._height
        axes = [letter for letter in self._velocity if letter in numbers]
        if not axes:
            return b""
        targets = [
            b"%s%.4f" % (letter, numbers[letter])
            for letter in (*axes, b"I", b"J")
            if letter in numbers
        ]
        if self._motion == 0.0:
            fastest = 60.0 * min(self._velocity[letter] for letter in axes)
            parts = [b"G94 G1", *targets, _feed_word(self._share * fastest)]
        elif self._motion > 0.0 and self._feed > 0.0:
            mode = b"G93" if self._inverse else b"G94"
            feed = _feed_word(self._share * self._feed)
            parts = [b"%s G%d" % (mode, self._motion), *targets, feed]
        else:
            raise _refusal(line, number)
        return b" ".join(parts)


def _feed_word(feed: float) -> bytes:
    return (b"F%.6f" % feed).rstrip(b"0").rstrip(b".")


def _without_feed(text: bytes) -> bytes:
    """Return a line without its F word: every move of a dry program has its own."""
    return b" ".join(word[0] for word in _WORD.finditer(text) if word[1] != b"F")


def _refusal(line: bytes, number: int) -> ControllerError:
    return ControllerError(
        "dry-run.unknown-line", line=number, text=line[:80].decode("ascii", "replace")
    )


def check_dry_program(
    dry: bytes,
    program: bytes,
    machine: Machine,
    start: Pose,
    tools: Mapping[int, Pose] | None = None,
) -> None:
    """Compare a dry program with the program of the job, as the interpreter reads them.

    The dry program may switch nothing on, may not move below ``dry_height`` after its lift, and
    must move X, Y and C along the path of the program.

    Parameters
    ----------
    dry, program
        The dry program and the program.
    machine
        The machine.
    start
        Pose of the axes before the first line.
    tools
        Offset of each tool, by its number (see ``Interpreter``).

    Raises
    ------
    ControllerError
        The dry program breaks a rule.
    """
    height = dry_height(machine)
    lifted = False
    blocks = zip_longest(_read(dry, start, tools), _read(program, start, tools))
    for number, (new, old) in enumerate(blocks, 1):
        if new is None or old is None:
            raise ControllerError("dry-run.other-path", line=number)
        if new.output >= 0 or new.oscillation:
            raise ControllerError("dry-run.switches", line=number)
        if new.move is not None:
            low, _ = new.move.bounds()
            if lifted and low[2] < height - _ROUNDING:
                raise ControllerError("dry-run.too-low", line=number, z=low[2], height=height)
            if not lifted:
                if not _lifts(new.move, height):
                    raise ControllerError("dry-run.no-lift", line=number, height=height)
                lifted = True
        if not _same_path(new.move, old.move):
            raise ControllerError("dry-run.other-path", line=number)


def _read(text: bytes, start: Pose, tools: Mapping[int, Pose] | None) -> Iterator[Block]:
    interpreter = Interpreter(start, tools)
    for number, line in enumerate(lines_of(text), 1):
        try:
            yield interpreter.read(line)
        except LineRefused:
            raise _refusal(line, number) from None


def _lifts(move: Move, height: float) -> bool:
    """Return whether a move is a lift straight up to a height."""
    flat = _flat(move.start) == _flat(move.end)
    return flat and abs(move.end[2] - height) <= _ROUNDING


def _flat(pose: Pose) -> tuple[float, float, float]:
    return pose[0], pose[1], pose[3]


def _same_path(new: Move | None, old: Move | None) -> bool:
    """Return whether two moves move X, Y and C along the same path."""
    if new is None or old is None:
        return all(one is None or _flat(one.start) == _flat(one.end) for one in (new, old))
    pairs = [*zip(_flat(new.start), _flat(old.start), strict=True)]
    pairs += zip(_flat(new.end), _flat(old.end), strict=True)
    if (new.centre is None) != (old.centre is None):
        return False
    if new.centre is not None and old.centre is not None:
        pairs += zip(new.centre, old.centre, strict=True)
        pairs.append((new.sweep, old.sweep))
    return all(abs(one - other) <= _ROUNDING for one, other in pairs)


def station_starts(program: bytes, machine: Machine) -> tuple[tuple[int, Station], ...]:
    """Return the number of the line after which each station of a program moves, ascending.

    A station without an output is in use from the first line, if it is the only one.
    """
    by_output = {station.output: station for station in machine.stations if station.output >= 0}
    fixed = [station for station in machine.stations if station.output < 0]
    found = [(1, fixed[0])] if len(fixed) == 1 else []
    tools = tool_offsets(machine)
    for number, block in enumerate(_read(program, (0.0, 0.0, 0.0, 0.0), tools), 1):
        if block.on and block.output in by_output:
            found.append((number, by_output[block.output]))
    return tuple(found)


Box = tuple[float, float, float, float]


def work_box(
    program: bytes, machine: Machine, start: Pose, tools: Mapping[int, Pose] | None = None
) -> Box | None:
    """Return the bounding box of the work of a program on the table: x0, y0, x1, y1 (mm).

    The work are all feed moves of a station whose tip is below the travel height.  The positions
    are those of the station's axis; None if the program does no work.

    Parameters
    ----------
    program, machine, start, tools
        As for ``check_dry_program``.
    """
    by_output = {station.output: station for station in machine.stations if station.output >= 0}
    fixed = [station for station in machine.stations if station.output < 0]
    station = fixed[0] if len(fixed) == 1 else None
    x0, y0, x1, y1 = math.inf, math.inf, -math.inf, -math.inf
    for block in _read(program, start, tools):
        if block.output in by_output and block.on:
            station = by_output[block.output]
        if block.move is None or station is None or math.isinf(block.move.rate):
            continue
        low, high = block.move.bounds()
        if low[2] - station.z < machine.travel_z - _ROUNDING:
            x0, y0 = min(x0, low[0] - station.x), min(y0, low[1] - station.y)
            x1, y1 = max(x1, high[0] - station.x), max(y1, high[1] - station.y)
    return (x0, y0, x1, y1) if x0 <= x1 else None


def frame_program(box: Box, station: Station, machine: Machine, share: float) -> bytes:
    """Return a program that moves a station round a box at the height of dry programs.

    Parameters
    ----------
    box
        The box on the table: x0, y0, x1, y1 (mm).
    station
        Station whose axis moves along the box.
    machine
        The machine.
    share
        Share of the velocities of X and Y.
    """
    x0, y0, x1, y1 = box
    corners = [(x0, y0), (x1, y0), (x1, y1), (x0, y1), (x0, y0)]
    return travel_program([(x + station.x, y + station.y) for x, y in corners], machine, share)


def travel_program(
    points: list[tuple[float, float]], machine: Machine, share: float, c: float | None = None
) -> bytes:
    """Return a program that lifts Z and moves the axes X and Y through some positions.

    Parameters
    ----------
    points
        Positions of X and Y (mm).
    machine
        The machine.
    share
        Share of the velocities of X and Y.
    c
        Position of C at the first point (degrees); None to leave C as it is.

    Raises
    ------
    ControllerError
        A position is outside the travel of the machine.
    """
    for x, y in points:
        for letter, value, axis in (("X", x, machine.x), ("Y", y, machine.y)):
            if not axis.low <= value <= axis.high:
                raise ControllerError(
                    "operation.beyond-travel",
                    axis=letter,
                    target=value,
                    low=axis.low,
                    high=axis.high,
                )
    feed = 60.0 * min(max(share, LEAST_SHARE), 1.0) * min(machine.x.velocity, machine.y.velocity)
    lines = [HEADER, b"G0 Z%.4f" % dry_height(machine)]
    for index, (x, y) in enumerate(points):
        turn = b" C%.4f" % c if c is not None and not index else b""
        lines.append(b"G94 G1 X%.4f Y%.4f%s %s" % (x, y, turn, _feed_word(feed)))
    return b"".join(line + b"\n" for line in [*lines, b"M2"])
