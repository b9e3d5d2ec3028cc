"""chip: simulates the registers of an MCX314 and the pulses of its interpolation.

A drive begins at the start speed and ramps towards the drive speed.  The next segment continues at
the speed at the end of the one before, and ramps towards its own drive speed.  The chip does not
look ahead, and automatic deceleration is not simulated: a drive that has no next segment ends at
the speed that it has.

What a real chip would do wrong without notice raises ``ChipRefused`` here, such as a segment that
is written too late, or a drive that ends faster than the start speed, where motors lose steps.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np

from knifetip.geometry.columns import F64, I64
from knifetip.languages.mcx314 import figures

_LINES = {figures.LINE_2: 2, figures.LINE_3: 3}
_ARCS = {figures.CLOCKWISE: -1, figures.COUNTER_CLOCKWISE: 1}
_BITS = {figures.BITS_2: 2, figures.BITS_3: 3}
#: A drive may end faster than the start speed by this share: rounding of rates.
_FASTER = 0.01


class ChipRefused(Exception):
    """Raised where a real chip would lose pulses or stop without notice."""


@dataclass(slots=True)
class _Drive:
    """The pulses of one segment: positions relative to its start, and times since its start."""

    axes: list[int]
    points: I64  #: (n, axes) pulses, after each step
    weights: F64  #: (n,) length of each step: more than 1 for diagonal steps at constant speed
    rate: float  #: drive speed (pulses/s)
    times: F64 = field(default_factory=lambda: np.zeros(0))  #: (n,) s, once it has begun
    last: float = 0.0  #: speed at its end (pulses/s), once it has begun


@dataclass(slots=True)
class _Axis:
    """Data registers of one axis."""

    speed: int = 0
    start: int = figures.FASTEST  #: start speed; ramps begin where the drive speed is greater
    acceleration: int = 1
    finish: int = 0
    centre: int = 0
    position: int = 0


@dataclass(slots=True)
class Chip:
    """A simulated MCX314."""

    multiple: int  #: pulses/s for each unit of the drive speed
    time: float = 0.0  #: s
    stops: int = 0  #: how often an interpolation has come to its end without a next segment
    _axes: list[_Axis] = field(default_factory=lambda: [_Axis() for _ in range(figures.AXES)])
    _registers: list[int] = field(default_factory=lambda: [0] * 8)
    _patterns: list[int] = field(default_factory=lambda: [0] * 8)
    _stack: list[list[int]] = field(default_factory=list)
    _bits: tuple[list[int], float] | None = None  # axes and rate of a bit pattern interpolation
    _writes_bits: bool = False
    _drive: _Drive | None = None
    _next: _Drive | None = None
    _begun: float = 0.0
    _origin: list[int] = field(default_factory=list)
    _has_next: bool = False  # data of the next segment was written while one is driven
    _late: bool = False

    # -- the bus ------------------------------------------------------------------------------

    def write(self, register: int, word: int) -> None:
        """Write a word to a register.

        Raises
        ------
        ChipRefused
            The word is a command that the chip cannot execute now.
        """
        if not 0 <= word <= 0xFFFF:
            raise ChipRefused(f"{word} is not a word of 16 bits")
        if self._writes_bits and figures.BITS_PLUS <= register < figures.BITS_PLUS + 6:
            self._patterns[register] = word
            return
        self._registers[register] = word
        if register == figures.WR0:
            self._command(word & 0x3F, [a for a in range(figures.AXES) if word >> (8 + a) & 1])

    def read(self, register: int) -> int:
        """Return the word in a register."""
        if register == figures.RR0:
            driving = self._drive is not None
            status = figures.DRIVING * driving
            status |= figures.NEXT * (driving and self._next is None and self._bits is None)
            return status | len(self._stack) << figures.STACK
        return self._registers[register]

    def position(self, axis: int) -> int:
        """Return the logical position of an axis (pulses)."""
        return self._axes[axis].position

    def lose(self, axis: int, pulses: int) -> None:
        """Add pulses to the position of an axis, as if its motor had lost steps."""
        self._axes[axis].position += pulses
        if self._drive is not None and axis in self._drive.axes:
            self._origin[self._drive.axes.index(axis)] += pulses

    @property
    def due(self) -> float | None:
        """Time until the present segment ends (s); None if the chip is at rest."""
        if self._drive is None:
            return None
        return self._begun + float(self._drive.times[-1]) - self.time

    def advance(self, seconds: float) -> None:
        """Let time pass and emit the pulses that are due."""
        end = self.time + seconds
        while self._drive is not None and self._begun + self._drive.times[-1] <= end:
            self._place(len(self._drive.times) - 1)
            self._begun += float(self._drive.times[-1])
            self._start_next()
        self.time = end
        if self._drive is not None:
            row = int(np.searchsorted(self._drive.times, end - self._begun, side="right")) - 1
            if row >= 0:
                self._place(row)

    # -- commands -----------------------------------------------------------------------------

    def _command(self, code: int, axes: list[int]) -> None:
        data = self._registers[figures.WR6] | self._registers[figures.WR7] << 16
        signed = data - (1 << 32) if data >> 31 else data
        if code in (figures.SET_SPEED, figures.SET_FINISH, figures.SET_CENTRE):
            self._set(code, axes, signed)
        elif code in (figures.SET_START, figures.SET_ACCELERATION):
            self._set_ramp(code, axes, signed)
        elif code == figures.SET_POSITION:
            for axis in axes:
                self._axes[axis].position = signed
        elif code == figures.GET_POSITION:
            value = self._axes[axes[0]].position & 0xFFFFFFFF
            self._registers[figures.RR6], self._registers[figures.RR7] = (
                value & 0xFFFF,
                value >> 16,
            )
        elif code in (figures.BITS_OPEN, figures.BITS_CLOSE):
            self._writes_bits = code == figures.BITS_OPEN
        elif code == figures.BITS_PUSH:
            self._push()
        elif code in _LINES or code in _ARCS or code in _BITS:
            self._interpolate(code)
        elif code == figures.CLEAR:
            self._late = self._has_next = False
        elif code == figures.STOP:
            self._drive = self._next = self._bits = None
            self._stack.clear()
            self._has_next = False
        else:
            raise ChipRefused(f"unknown command {code:#04x}")

    def _set(self, code: int, axes: list[int], value: int) -> None:
        if self._next is not None:
            raise ChipRefused("data of the next segment is overwritten")
        self._has_next = self._drive is not None
        for axis in axes:
            if code == figures.SET_SPEED:
                if not 1 <= value <= figures.FASTEST:
                    raise ChipRefused(f"drive speed {value}")
                self._axes[axis].speed = value
                continue
            if abs(value) > figures.LARGEST:
                raise ChipRefused(f"{value} pulses do not fit into 24 bits")
            if code == figures.SET_FINISH:
                self._axes[axis].finish = value
            else:
                self._axes[axis].centre = value

    def _set_ramp(self, code: int, axes: list[int], value: int) -> None:
        if self._drive is not None:
            raise ChipRefused("the ramp is changed during a drive")
        most = figures.FASTEST if code == figures.SET_START else figures.STEEPEST
        if not 1 <= value <= most:
            raise ChipRefused(f"ramp value {value}")
        for axis in axes:
            if code == figures.SET_START:
                self._axes[axis].start = value
            else:
                self._axes[axis].acceleration = value

    def _interpolate(self, code: int) -> None:
        if self._late:
            raise ChipRefused("the segment was written after the drive had ended")
        if self._next is not None or (self._drive is not None and self._bits is not None):
            raise ChipRefused("a next segment is written already")
        mode = self._registers[figures.WR5]
        count = _LINES.get(code) or _BITS.get(code) or 2
        axes = [mode >> 2 * place & 3 for place in range(count)]
        if len(set(axes)) != count:
            raise ChipRefused("an axis is named twice in WR5")
        rate = self._axes[axes[0]].speed * self.multiple
        if rate <= 0:
            raise ChipRefused("no drive speed")
        if code in _BITS:
            if self._drive is not None or not self._stack:
                raise ChipRefused("no bit pattern on the stack, or another drive is running")
            self._bits = (axes, float(rate))
            drive = self._pattern_drive()
        elif code in _LINES:
            points = _line([self._axes[axis].finish for axis in axes])
            drive = _Drive(axes, points, np.ones(len(points)), float(rate))
        else:
            finish = [self._axes[axis].finish for axis in axes]
            centre = [self._axes[axis].centre for axis in axes]
            constant = bool(mode & figures.CONSTANT_2)
            drive = _Drive(axes, *_arc(finish, centre, _ARCS[code], constant), float(rate))
        if len(drive.points) == 0:
            raise ChipRefused("a segment without pulses")
        self._has_next = False
        if self._drive is None:
            self._begin(drive, self.time)
        else:
            self._next = drive

    def _push(self) -> None:
        if len(self._stack) >= figures.DEPTH:
            raise ChipRefused("the stack of bit patterns is full")
        if self._late:
            raise ChipRefused("the bit pattern was written after the drive had ended")
        self._stack.append(self._patterns[figures.BITS_PLUS : figures.BITS_PLUS + 6])

    def _pattern_drive(self) -> _Drive:
        """Take a bit pattern from the stack and return its pulses."""
        assert self._bits is not None
        axes, rate = self._bits
        words = self._stack.pop(0)
        steps = np.zeros((figures.PATTERN, len(axes)), np.int64)
        for place in range(len(axes)):
            plus, minus = words[2 * place], words[2 * place + 1]
            for bit in range(figures.PATTERN):
                steps[bit, place] = (plus >> bit & 1) - (minus >> bit & 1)
        return _Drive(axes, np.cumsum(steps, axis=0), np.ones(figures.PATTERN), rate)

    # -- the drive ----------------------------------------------------------------------------

    def _begin(self, drive: _Drive, time: float, speed: float | None = None) -> None:
        """Begin a drive at a speed (pulses/s); None for the start speed of its main axis."""
        main = self._axes[drive.axes[0]]
        start = float(main.start * self.multiple)
        first = min(start, drive.rate) if speed is None else speed
        steepness = float(main.acceleration * self.multiple * figures.RAMP_UNIT)
        drive.times, drive.last = _ramp(drive.weights, first, drive.rate, steepness)
        self._drive, self._begun = drive, time
        self._origin = [self._axes[axis].position for axis in drive.axes]

    def _start_next(self) -> None:
        begun, ended = self._begun, self._drive
        assert ended is not None
        if self._bits is not None and self._stack:
            self._begin(self._pattern_drive(), begun, ended.last)
        elif self._next is not None:
            drive, self._next = self._next, None
            self._begin(drive, begun, ended.last)
        else:
            self._drive = self._bits = None
            self.stops += 1
            self._late = self._has_next
            slowest = self._axes[ended.axes[0]].start * self.multiple
            if ended.last > slowest * (1.0 + _FASTER):
                raise ChipRefused(f"the drive stops at {ended.last:.0f} pulses/s without a ramp")

    def _place(self, row: int) -> None:
        """Set the logical positions after a step of the present segment."""
        assert self._drive is not None
        for place, axis in enumerate(self._drive.axes):
            self._axes[axis].position = self._origin[place] + int(self._drive.points[row, place])


def _ramp(weights: F64, first: float, rate: float, steepness: float) -> tuple[F64, float]:
    """Return the time after each of n steps, (n,) s, and the speed after the last one.

    ``weights`` (n,): length of each step.
    ``first``, ``rate``: speed at the start, and drive speed that it ramps to (pulses/s).
    ``steepness``: acceleration and deceleration (pulses/s²).
    """
    change = 2.0 * steepness * np.cumsum(weights)
    if first <= rate:
        speed = np.sqrt(np.minimum(first * first + change, rate * rate))
    else:
        speed = np.sqrt(np.maximum(first * first - change, rate * rate))
    before = np.concatenate([[first], speed[:-1]])
    return np.cumsum(2.0 * weights / (before + speed)), float(speed[-1])


def _line(finish: list[int]) -> I64:
    """Return the steps of a line; the longest axis has a pulse in each step."""
    way = np.array(finish, np.int64)
    count = int(np.abs(way).max())
    step = np.arange(1, count + 1)[:, None]
    points: I64 = np.sign(way) * ((2 * step * np.abs(way) + count) // (2 * max(count, 1)))
    return points


def _arc(finish: list[int], centre: list[int], side: int, constant: bool) -> tuple[I64, F64]:
    """Return the steps of an arc and their lengths.

    Each step has a pulse of the axis along which the arc advances faster, and one of the other axis
    where that is nearer to the circle.

    ``finish``, ``centre``: end point and centre relative to the start (pulses).
    ``side``: 1 for counter-clockwise, -1 for clockwise.
    ``constant``: whether a diagonal step takes longer, so that the speed along the arc is constant.
    """
    x, y = -centre[0], -centre[1]
    ends = (finish[0] - centre[0], finish[1] - centre[1])
    square = x * x + y * y
    if square == 0 or abs(math.hypot(*ends) - math.sqrt(square)) > 1.0:
        raise ChipRefused("the finish point of the arc is not on its circle")
    angle = side * (math.atan2(ends[1], ends[0]) - math.atan2(y, x)) % math.tau
    whole = angle if angle > 1e-12 else math.tau
    turned, before = 0.0, math.atan2(y, x)
    points: list[tuple[int, int]] = []
    while True:
        tx, ty = -side * y, side * x
        if abs(tx) >= abs(ty):
            x += 1 if tx > 0 else -1
            y = min((y - 1, y, y + 1), key=lambda other: abs(x * x + other * other - square))
        else:
            y += 1 if ty > 0 else -1
            x = min((x - 1, x, x + 1), key=lambda other: abs(other * other + y * y - square))
        now = math.atan2(y, x)
        turned += side * math.remainder(now - before, math.tau)
        before = now
        near = max(abs(x - ends[0]), abs(y - ends[1])) <= 1
        if near and turned > whole - math.pi / 2.0:
            points.append((x + centre[0], y + centre[1]))
            if (x, y) != ends:
                points.append((finish[0], finish[1]))
            break
        if turned > whole + math.pi / 2.0:
            raise ChipRefused("the arc misses its finish point")
        points.append((x + centre[0], y + centre[1]))
    column = np.array(points, np.int64)
    steps = np.abs(np.diff(column, axis=0, prepend=0)).sum(axis=1)
    return column, np.where(steps == 2, math.sqrt(2.0) if constant else 1.0, 1.0)
