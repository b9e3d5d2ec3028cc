"""An interpreter of programs for an MCX314 as its board executes them.

It follows the description of the format (docs/mcx314-programs.md) and shares no code with the
verifier, the emitter or the simulated board.  Nothing is known at the start but the pulses of the
machine.
"""

from __future__ import annotations

import math

from knifetip.languages.mcx314.wiring import Wiring
from knifetip.model.machine import Machine
from tests.attack.controller import Motion, NotExecuted, Run, Switching

_LETTERS = "XYZC"
_RANGE = 2**23


def drive(text: bytes, machine: Machine) -> Run:
    """Return what a program does on a machine.

    Raises
    ------
    NotExecuted
        A line is wrong.
    """
    wiring = machine.controller
    assert isinstance(wiring, Wiring)
    return _Machine(machine, wiring).run(text.decode("latin-1"))


class _Machine:
    def __init__(self, machine: Machine, wiring: Wiring) -> None:
        self.machine = machine
        self.wiring = wiring
        self.result = Run()
        self.at: dict[str, float] = dict.fromkeys(_LETTERS, math.nan)  # pulses
        self.on: list[int] = []  # in the order in which they were switched on
        self.known: set[int] = set()
        self.oscillation: bool | None = None
        self.waited = math.inf
        self.before = -1.0  # duration of the segment in the line before (s)

    def run(self, program: str) -> Run:
        lines = program.split("\n")
        if lines.pop() or lines[:1] != ["MCX314 1"]:
            raise NotExecuted("not a program for an MCX314, or cut off")
        work = [(n, line) for n, line in enumerate(lines[1:], 2) if line[:1] != ";"]
        for n, line in enumerate(lines, 1):
            if any(not " " <= sign <= "~" for sign in line):
                raise NotExecuted(f"line {n}: not text")
        if not work or work[0][1] != self._pulses() or work[-1][1] != "END":
            raise NotExecuted("no pulses of this machine, or no end")
        for n, line in work[1:-1]:
            self._line(n, line)
        self.result.ended = True
        left = {f"output {one}" for one in self.machine.outputs if one not in self.known}
        left |= {f"output {one}" for one in self.on}
        if self.oscillation is not False:
            left.add("spindle")
        self.result.left = ", ".join(sorted(left))
        return self.result

    def _pulses(self) -> str:
        scales = zip(_LETTERS, self.wiring.pulses, strict=True)
        return "PULSES " + " ".join(f"{letter}{scale:g}" for letter, scale in scales)

    def _line(self, n: int, line: str) -> None:
        name, *words = line.split(" ")
        duration = -1.0
        if name in ("GO", "LINE", "CW", "CCW"):
            duration = self._move(n, name, words)
        elif name == "DWELL" and len(words) == 1:
            milliseconds = _number(n, words[0], least=1)
            if milliseconds > 60_000:
                raise NotExecuted(f"line {n}: a dwell of {milliseconds} ms")
            self.waited += milliseconds / 1e3
        elif name == "OSC" and words in (["ON"], ["OFF"]):
            self.oscillation = words == ["ON"]
            self._switched(n, -1, self.oscillation)
        elif name == "OUT" and len(words) == 2 and words[1] in ("ON", "OFF"):
            output = _number(n, words[0], least=0)
            if output not in self.machine.outputs:
                raise NotExecuted(f"line {n}: no output {output}")
            if output in self.on:
                self.on.remove(output)
            if words[1] == "ON":
                self.on.append(output)
            self.known.add(output)
            self._switched(n, output, words[1] == "ON")
        else:
            raise NotExecuted(f"line {n}: {line[:20]!r}")
        self.before = duration

    def _move(self, n: int, name: str, words: list[str]) -> float:
        """Make a motion; return its duration, or -1 for an air move."""
        joins = words[-1:] == ["JOIN"]
        words = words[:-1] if joins else words
        order = "XYZC" if name == "GO" else "XYZCV" if name == "LINE" else "XYIJV"
        letters = [word[:1] for word in words]
        if sorted(letters, key=order.find) != letters or len(set(letters)) != len(letters):
            raise NotExecuted(f"line {n}: words {words}")
        if set(letters) - set(order) or (joins and (name == "GO" or self.before < 0.0)):
            raise NotExecuted(f"line {n}: words {words}")
        least = 1 if name == "LINE" else 0
        values = {word[0]: _number(n, word[1:], least if word[0] != "V" else 1) for word in words}
        if any(abs(value) >= _RANGE for value in values.values()):
            raise NotExecuted(f"line {n}: more than 24 bits")
        if joins and self.before < self.wiring.refill * (1.0 - 1e-6):
            raise NotExecuted(f"line {n}: joins a segment of {self.before:g} s")
        moved = [letter for letter in _LETTERS if letter in values]
        before, code, seconds, centre = dict(self.at), 0, math.nan, (math.nan, math.nan)
        if name == "GO":
            self.at.update((letter, float(values[letter])) for letter in moved)
        else:
            for letter in moved:
                self.at[letter] += values[letter]
            if any(math.isnan(self.at[letter]) for letter in moved):
                raise NotExecuted(f"line {n}: from an unknown position")
            code, seconds, centre = self._segment(n, name, values, before)
        if not 1 <= len(moved) <= 3:
            raise NotExecuted(f"line {n}: moves {moved}")
        self._add(n, code, before, seconds, centre, stops=not joins)
        return -1.0 if name == "GO" else seconds

    def _segment(
        self, n: int, name: str, values: dict[str, int], before: dict[str, float]
    ) -> tuple[int, float, tuple[float, float]]:
        speed = values.get("V", 0)
        if not self.wiring.multiple <= speed <= 8000 * self.wiring.multiple:
            raise NotExecuted(f"line {n}: speed {speed}")
        if name == "LINE":
            return 1, max(abs(values.get(letter, 0)) for letter in _LETTERS) / speed, (0.0, 0.0)
        if len(values) != 5:
            raise NotExecuted(f"line {n}: an arc without its words")
        i, j, x, y = (values[letter] for letter in "IJXY")
        first, last = math.hypot(i, j), math.dist((x, y), (i, j))
        if first < 1.0 or abs(first - last) > 1.0 or (x, y) == (0, 0):
            raise NotExecuted(f"line {n}: no arc")
        turn = math.atan2(y - j, x - i) - math.atan2(-j, -i)
        turn = turn % math.tau if name == "CCW" else -turn % math.tau
        scale = self.wiring.pulses[0]
        centre = (before["X"] + i) / scale, (before["Y"] + j) / scale
        return 3 if name == "CCW" else 2, first * turn / speed, centre

    def _joints(self, at: dict[str, float]) -> dict[str, float]:
        scales = dict(zip(_LETTERS, self.wiring.pulses, strict=True))
        return {letter: pulses / scales[letter] for letter, pulses in at.items()}

    def _station(self) -> int:
        pistons = [held.output for held in self.machine.stations]
        return pistons.index(self.on[-1]) if self.on else -1

    def _unknown(self) -> frozenset[str]:
        missing = {f"output {one}" for one in set(self.machine.outputs) - self.known}
        return frozenset(missing | ({"spindle"} if self.oscillation is None else set()))

    def _add(
        self,
        n: int,
        code: int,
        before: dict[str, float],
        seconds: float,
        centre: tuple[float, float],
        stops: bool,
    ) -> None:
        start, end = self._joints(before), self._joints(self.at)
        self.result.motions.append(
            Motion(
                n,
                code,
                tuple(start[letter] for letter in _LETTERS),
                tuple(end[letter] for letter in _LETTERS),
                start,
                end,
                centre,
                self._station(),
                frozenset(self.on),
                self._unknown(),
                1.0 if self.oscillation else 0.0,
                seconds,
                stops,
                self.waited,
                {},
                0.0,
                frozenset(),
            )
        )

    def _switched(self, n: int, output: int, on: bool) -> None:
        self.waited = 0.0
        self.result.switchings.append(
            Switching(
                n,
                output,
                on,
                self._joints(self.at),
                self._station(),
                False,
                frozenset(self.on),
                self._unknown(),
            )
        )


def _number(n: int, word: str, least: int) -> int:
    """Return a whole number without leading zeros, of at least ``least`` in size."""
    digits = word.removeprefix("-")
    plain = digits.isdecimal() and digits.isascii() and str(int(digits)) == digits
    if not plain or abs(int(word)) < least or word == "-0":
        raise NotExecuted(f"line {n}: number {word[:12]!r}")
    return int(word)
