"""board: simulates the ARM board of a machine with an MCX314: queue, outputs, links and faults.

The board keeps loaded program lines in a queue, plans their ramps (``planner``), and feeds the chip
through its registers (``feeder``).  ``receive`` processes bytes from the gateway and returns the
answers; docs/mcx314-link.md describes the protocol.  Time passes only in ``advance``.

If nothing is heard from the gateway while a program runs or is held, the board brings the machine
into the safe state by itself: it stops, lifts Z and releases all outputs.
"""

from __future__ import annotations

from array import array
from collections import OrderedDict, deque
from dataclasses import dataclass, field
from enum import StrEnum

import numpy as np

from knifetip.errors import ControllerError
from knifetip.gateway.mcx314.chip import Chip, ChipRefused
from knifetip.gateway.mcx314.feeder import Feeder, rate_of_arc
from knifetip.gateway.mcx314.frames import Splitter, pack, unpack
from knifetip.gateway.mcx314.instructions import AXES, MOTIONS, BadLine, Instruction, Name, parse
from knifetip.gateway.mcx314.planner import Planner, Stretch
from knifetip.geometry.columns import F64
from knifetip.languages.mcx314 import figures
from knifetip.languages.mcx314.wiring import Wiring
from knifetip.model.machine import Machine

#: Version of the protocol.
PROTOCOL = 1
#: Program lines that the queue holds.
QUEUE = 128
#: Lines with which the board begins to move, unless the program has fewer.
PRIMED = 64
#: Answers that are kept, in case that a request is repeated.
KEPT = 64
#: Samples that a trace keeps at most.
SAMPLES = 500_000
#: A shorter time is none (s).
_MOMENT = 1e-9
#: Rate of homing and of the lift after a lost connection, as a fraction of the axis's greatest.
_SLOW = 0.2


class BoardState(StrEnum):
    """States that the board reports."""

    IDLE = "IDLE"
    RUN = "RUN"
    HOLD = "HOLD"
    JOG = "JOG"
    HOME = "HOME"
    ALARM = "ALARM"


class Refused(Exception):
    """Raised for a request that the board refuses; the first argument is the code."""


@dataclass(frozen=True, slots=True)
class LinkFaults:
    """Faults that the simulated board injects: numbers of valid requests, from 1."""

    drop_answers: frozenset[int] = frozenset()  #: executed, but not answered
    damage_answers: frozenset[int] = frozenset()  #: a byte of the answer is changed
    ignore: frozenset[int] = frozenset()  #: lost on their way to the board
    hang_up: int = 0  #: the connection breaks before this request is executed
    silent_from: int = 0  #: no request from this one on is executed or answered


@dataclass(frozen=True, slots=True)
class Switched:
    """One change of an output or of the oscillation (-1)."""

    time: float
    output: int
    on: bool
    position: tuple[int, ...]  #: joints (pulses)
    moving: bool


@dataclass(slots=True)
class _Program:
    number: int
    lines: int
    loaded: int = 0
    done: int = 0
    scaled: bool = False


@dataclass(slots=True)
class _Guard:
    """What the board does when the gateway is gone."""

    patience: float = 0.0  #: s; 0 for nothing
    lift: int = 0  #: least Z in work coordinates (pulses)
    outputs: tuple[int, ...] = ()


@dataclass(slots=True)
class _TimedBus:
    """The bus between board and chip, on which each write takes time."""

    chip: Chip
    seconds: float

    def write(self, register: int, word: int) -> None:
        self.chip.advance(self.seconds)
        self.chip.write(register, word)

    def read(self, register: int) -> int:
        return self.chip.read(register)


@dataclass(slots=True)
class _Trace:
    interval: float
    values: array[float] = field(default_factory=lambda: array("d"))


class Board:
    """A simulated board with its chip and its machine.

    Parameters
    ----------
    machine
        The machine; its controller settings are those of an MCX314.
    faults
        Faults of the link.
    sample
        Simulated seconds between two records of the position; 0 for none.
    homed
        Whether the axes are homed when the board is switched on.

    Raises
    ------
    ControllerError
        The file of the machine does not describe an MCX314.
    """

    def __init__(
        self,
        machine: Machine,
        *,
        faults: LinkFaults | None = None,
        sample: float = 0.0,
        homed: bool = True,
    ) -> None:
        wiring = machine.controller
        if not isinstance(wiring, Wiring):
            raise ControllerError("mcx314.no-wiring", machine=machine.title)
        self.machine = machine
        self.faults = faults or LinkFaults()
        self.chip = Chip(wiring.multiple)
        self.switched: list[Switched] = []
        self.starved = 0  #: stops in a cut because the queue was empty
        self.refusals: list[str] = []  #: what the chip has refused
        self.boot = 0
        self._wiring = wiring
        self._planner = Planner(wiring)
        self._trace = _Trace(sample) if sample > 0.0 else None
        self._sampled = 0.0
        self._reset(homed)

    # -- power, buttons and switches --------------------------------------------------------------

    def _reset(self, homed: bool) -> None:
        self.boot += 1
        self.outputs: set[int] = set()
        self.oscillates = False
        self._bus = _TimedBus(self.chip, self._wiring.refill / 40.0)
        self._feeder = Feeder(self._bus, self._wiring)
        self._feeder.stop()
        self._feeder.set_up()
        self._alarm = "" if homed else "unhomed"
        self._homed = homed
        self._pressed = False
        self._zero = [0, 0, 0, 0]
        self._items: deque[tuple[int, Instruction]] = deque()
        self._stretches: deque[Stretch] = deque()  # not completely written
        self._step = 0  # steps of the first of them that are written
        self._planned = [0, 0, 0, 0]  # joints at the end of the last stretch
        self._program: _Program | None = None
        self._numbers = 0
        self._guard = _Guard()
        self._silence = 0.0  # real time since the last request (s)
        self._lost = False
        self._holding = self._discarding = False
        self._purpose = BoardState.IDLE
        self._dwell = 0.0
        self._after: deque[str] = deque()  # steps of a recovery
        self._splitter = Splitter()
        self._answers: OrderedDict[int, str] = OrderedDict()
        self.requests = 0
        if homed:
            for axis, place in enumerate((0.0, 0.0, self.machine.travel_z, 0.0)):
                self._feeder.set_position(axis, round(place * self._wiring.pulses[axis]))
        self._planned = list(self.joints())

    def reset(self) -> None:
        """Interrupt the power: all outputs are released, and the position is unknown."""
        self._reset(homed=False)

    def press_stop(self) -> None:
        """Press the emergency stop button."""
        self._pressed = True
        self.trip("emergency")

    def release_stop(self) -> None:
        """Release the emergency stop button."""
        self._pressed = False

    def trip(self, alarm: str) -> None:
        """Stop at once because of an alarm, such as ``limit-X`` or ``drive-X``."""
        self._feeder.stop()
        self._discard()
        self.oscillates = False
        self._alarm = alarm
        self._homed = False

    # -- state ------------------------------------------------------------------------------------

    @property
    def time(self) -> float:
        """Simulated time (s)."""
        return self.chip.time

    def joints(self) -> tuple[int, int, int, int]:
        """Return the positions of the joints X, Y, Z and C (pulses)."""
        x, y, z, c = (self.chip.position(axis) for axis in range(figures.AXES))
        return x, y, z, c

    @property
    def position(self) -> tuple[float, ...]:
        """Positions of the joints (mm, degrees)."""
        return tuple(
            pulses / scale for pulses, scale in zip(self.joints(), self._wiring.pulses, strict=True)
        )

    def samples(self) -> F64:
        """Return the recorded time (s) and joints (mm, degrees), (n, 5)."""
        values = self._trace.values if self._trace is not None else array("d")
        return np.array(values, dtype=np.float64).reshape(-1, 5)

    @property
    def state(self) -> BoardState:
        """State that the board reports."""
        if self._alarm:
            return BoardState.ALARM
        if self._holding:
            return BoardState.HOLD
        if self._purpose is not BoardState.IDLE:
            return self._purpose
        return BoardState.RUN if self._program_runs() else BoardState.IDLE

    def _program_runs(self) -> bool:
        return self._program is not None and self._program.done < self._program.lines

    @property
    def _busy(self) -> bool:
        return bool(self._feeder.driving or self._stretches or self._dwell > 0.0)

    # -- time -------------------------------------------------------------------------------------

    def advance(self, seconds: float) -> None:
        """Let simulated time pass."""
        end = self.chip.time + seconds
        try:
            while True:
                self._work()
                if self.chip.time >= end:
                    return
                step = end - self.chip.time
                if (due := self.chip.due) is not None:
                    step = min(step, due + _MOMENT)
                if self._dwell > 0.0:
                    step = min(step, self._dwell)
                if self._trace is not None:
                    step = min(step, max(self._sampled + self._trace.interval - self.time, _MOMENT))
                before = self.chip.time
                self.chip.advance(step)
                if not self._holding and self._dwell > 0.0:
                    left = self._dwell - (self.chip.time - before)
                    self._dwell = left if left > _MOMENT else 0.0
                self._sample()
        except ChipRefused as refused:
            self.refusals.append(str(refused))
            self.trip("chip")

    def _sample(self) -> None:
        trace = self._trace
        if trace is None or self.time < self._sampled + trace.interval - 1e-12:
            return
        self._sampled = self.time
        if self._busy and len(trace.values) < 5 * SAMPLES:
            trace.values.extend((self.time, *self.position))

    def watch(self, seconds: float) -> None:
        """Bring the machine into the safe state if the gateway is gone.

        ``seconds`` is the real time since the last call.
        """
        self._silence += seconds
        patience = self._guard.patience
        working = self._program_runs() or self._holding
        if patience > 0.0 and working and not self._alarm and self._silence > patience:
            self._abort()
            self._lost = True
            self._after.extend(("lift", "release"))

    def _work(self) -> None:
        """Complete what has ended, and write what is next."""
        for piece in self._feeder.completed():
            if piece.completes and self._program is not None and piece.stretch.line:
                self._program.done = piece.stretch.line
        if self._alarm:
            return
        if not self._feeder.driving:
            self._begin_next()
        self._load_stretches()
        if self._feeder.driving and self._feeder.can_write():
            self._continue()

    def _begin_next(self) -> None:
        """Begin the next instruction, with the machine at rest."""
        if self._discarding:
            self._discard()
        if self._purpose is not BoardState.IDLE and not self._stretches:
            if self._purpose is BoardState.HOME:
                self._finish_homing()
            self._purpose = BoardState.IDLE
        if self._after and not self._stretches:
            self._recover(self._after.popleft())
        if self._holding or self._dwell > 0.0:
            return
        while not self._stretches and self._items and self._dwell <= 0.0:
            if not self._primed():
                return
            line, instruction = self._items[0]
            if instruction.name in MOTIONS:
                if not self._load_stretch():
                    return
                self._load_stretches()
                break
            self._items.popleft()
            self._act(instruction)
            assert self._program is not None
            self._program.done = line
        if self._stretches:
            stretch = self._stretches[0]
            if self._step == 0 and stretch.joined and self._feeder.last is None and stretch.line:
                self.starved += 1
            self._write(self._planner.rest(stretch))

    def _primed(self) -> bool:
        program = self._program
        return program is None or program.loaded >= program.lines or len(self._items) >= PRIMED

    def _continue(self) -> None:
        """Write the piece after the one that the chip drives, unless it shall stop."""
        last = self._feeder.last
        if last is None:
            return
        stopping = self._holding or self._discarding
        if stopping and last.end <= self._planner.rest(last.stretch) + 1e-6:
            return
        if not self._stretches:
            return
        stretch = self._stretches[0]
        if self._step == 0 and not self._planner.joins(last.stretch, stretch):
            return
        self._write(last.end)

    def _write(self, speed: float) -> None:
        """Write the next piece of the first stretch; the chip has a rate at its start."""
        stretch = self._stretches[0]
        ahead = list(self._stretches)[1:]
        stopping = self._holding or self._discarding
        piece = self._planner.piece(stretch, self._step, speed, ahead, stopping=stopping)
        self._feeder.write(piece)
        self._step = piece.last
        if piece.completes:
            self._stretches.popleft()
            self._step = 0

    def _load_stretches(self) -> None:
        """Take all motions of the queue that can follow without a stop."""
        while self._load_stretch():
            pass

    def _load_stretch(self) -> bool:
        """Take the next motion of the queue to the stretches; return whether there is one.

        Instructions that do not move wait until the machine is at rest.
        """
        if not self._items or self._discarding or self._purpose is not BoardState.IDLE:
            return False
        line, instruction = self._items[0]
        if instruction.name not in MOTIONS:
            return False
        if self._stretches and not instruction.joined:
            return False
        self._items.popleft()
        stretch = self._stretch(line, instruction)
        if stretch is None:
            assert self._program is not None
            if not self._stretches and not self._feeder.driving:
                self._program.done = line
            return True
        self._stretches.append(stretch)
        self._planned = [a + b for a, b in zip(stretch.start, stretch.way, strict=True)]
        return True

    def _stretch(self, line: int, instruction: Instruction) -> Stretch | None:
        """Return the stretch of a motion; None if the axes are there already."""
        start = (self._planned[0], self._planned[1], self._planned[2], self._planned[3])
        speed = instruction.words.get("V", 0.0)
        if instruction.name is Name.GO:
            return self._rapid(line, instruction, start)
        if instruction.name is Name.LINE:
            return Stretch(line, start, instruction.ways, speed, instruction.joined)
        centre = instruction.pulses("I"), instruction.pulses("J")
        side = 1 if instruction.name is Name.COUNTER_CLOCKWISE else -1
        return Stretch(
            line,
            start,
            instruction.ways,
            rate_of_arc(speed),
            instruction.joined,
            side,
            centre,
        )

    def _rapid(
        self, line: int, instruction: Instruction, start: tuple[int, int, int, int]
    ) -> Stretch | None:
        way = [0, 0, 0, 0]
        for axis, letter in enumerate(AXES):
            if letter in instruction.words:
                way[axis] = instruction.pulses(letter) + self._zero[axis] - start[axis]
        if not any(way):
            return None
        seconds = max(abs(pulses) / self._fastest(axis) for axis, pulses in enumerate(way))
        rate = instruction.words.get("V", max(map(abs, way)) / seconds)
        limit = max(map(abs, way)) / seconds
        x, y, z, c = way
        return Stretch(line, start, (x, y, z, c), min(rate, limit), joined=False)

    def _fastest(self, axis: int) -> float:
        """Return the greatest rate of an axis (pulses/s)."""
        limits = (self.machine.x, self.machine.y, self.machine.z, self.machine.c)
        return limits[axis].velocity * self._wiring.pulses[axis]

    def _act(self, instruction: Instruction) -> None:
        """Execute an instruction that does not move, with the machine at rest."""
        match instruction.name:
            case Name.OUT:
                self._switch(instruction.output, instruction.on)
            case Name.OSC:
                self._switch(-1, instruction.on)
            case Name.DWELL:
                self._dwell = instruction.number / 1e3
            case _:
                pass

    def _switch(self, output: int, on: bool) -> None:
        if output < 0:
            self.oscillates = on
        elif on:
            self.outputs.add(output)
        else:
            self.outputs.discard(output)
        event = Switched(self.time, output, on, self.joints(), self._feeder.driving)
        self.switched.append(event)

    def _discard(self) -> None:
        """Discard the program and what is left of a move; the machine is at rest."""
        self._items.clear()
        self._stretches.clear()
        self._step = 0
        self._dwell = 0.0
        self._holding = self._discarding = False
        self._program = None
        self._purpose = BoardState.IDLE
        self._planned = list(self.joints())

    def _abort(self) -> None:
        self._discarding = True
        self._holding = False
        self._after.clear()

    def _recover(self, step: str) -> None:
        """Do a step of bringing the machine into the safe state without the gateway."""
        if step == "lift":
            target = self._guard.lift + self._zero[2]
            if self.joints()[2] < target:
                self._move_to({2: target}, _SLOW, BoardState.JOG)
            return
        self._switch(-1, False)
        for output in self._guard.outputs:
            self._switch(output, False)

    def _move_to(self, joints: dict[int, int], share: float, purpose: BoardState) -> None:
        """Begin to move axes to joint positions at a share of their greatest rates."""
        start = self.joints()
        way = [0, 0, 0, 0]
        for axis, target in joints.items():
            way[axis] = target - start[axis]
        if not any(way):
            return
        seconds = max(abs(pulses) / self._fastest(axis) for axis, pulses in enumerate(way))
        rate = max(map(abs, way)) / seconds * share
        x, y, z, c = way
        self._stretches.append(Stretch(0, start, (x, y, z, c), rate, joined=False))
        self._purpose = purpose

    def _finish_homing(self) -> None:
        self._homed = True
        self._zero = [0, 0, 0, 0]

    # -- requests ---------------------------------------------------------------------------------

    @property
    def hangs_up(self) -> bool:
        """Whether the connection breaks now (an injected fault)."""
        return 0 < self.faults.hang_up <= self.requests

    def connect(self) -> None:
        """Forget the rest of an earlier connection."""
        self._splitter = Splitter()
        self._answers.clear()

    def receive(self, data: bytes) -> bytes:
        """Process received bytes and return the answers."""
        answers = b""
        for line in self._splitter.feed(data):
            request = unpack(line)
            if request is None:
                continue
            self.requests += 1
            answers += self._answer(*request)
        return answers

    def _answer(self, tag: int, text: str) -> bytes:
        faults, number = self.faults, self.requests
        if self.hangs_up or number in faults.ignore or 0 < faults.silent_from <= number:
            return b""
        self._silence = 0.0
        if (answer := self._answers.get(tag)) is None:
            try:
                answer = " ".join(filter(None, ["OK", self._execute(text)]))
            except Refused as refused:
                answer = f"ERR {' '.join(map(str, refused.args))}"
            except ChipRefused as broken:
                self.refusals.append(str(broken))
                self.trip("chip")
                answer = "ERR alarm"
            self._answers[tag] = answer
            if len(self._answers) > KEPT:
                self._answers.popitem(last=False)
        packed = pack(tag, answer)
        if number in faults.damage_answers:
            packed = packed.replace(b"O", b"Q", 1).replace(b"E", b"F", 1)
        return b"" if number in faults.drop_answers else packed

    def _execute(self, text: str) -> str:
        command, _, rest = text.partition(" ")
        match command:
            case "HELLO":
                return self._hello()
            case "STATUS":
                return self._status()
            case "GUARD":
                self._set_guard(rest)
            case "BEGIN":
                return self._begin(rest)
            case "LOAD":
                return self._load(rest)
            case "HOLD":
                if self._program_runs():
                    self._holding = True
            case "RESUME":
                self._holding = False
            case "ABORT":
                self._abort()
                self._work()
            case "OUT" | "OSC":
                self._require_rest()
                self._act(_parsed(text))
            case "MOVE" | "HOME" | "ZERO":
                self._operate(command, rest)
            case "UNLOCK":
                self._unlock()
            case _:
                raise Refused("unknown")
        return ""

    def _hello(self) -> str:
        pulses = " ".join(
            f"{letter}={scale:g}" for letter, scale in zip(AXES, self._wiring.pulses, strict=True)
        )
        return f"MCX314 PROTOCOL={PROTOCOL} BOOT={self.boot} {pulses} QUEUE={QUEUE}"

    def _status(self) -> str:
        program = self._program
        current = self._feeder.current
        line = 0
        if program is not None:
            line = program.done
            if current is not None and current.stretch.line:
                line = current.stretch.line
            elif line < program.lines and program.loaded > line:
                line += 1
        axes = " ".join(
            f"{letter}={self._feeder.position(axis) - self._zero[axis]}"
            for axis, letter in enumerate(AXES)
        )
        fields = {
            "STATE": self.state,
            "PROGRAM": program.number if program else 0,
            "LINE": line,
            "DONE": program.done if program else 0,
            "STILL": int(not self._feeder.driving),
            "OUT": ",".join(map(str, sorted(self.outputs))) or "-",
            "OSC": int(self.oscillates),
            "FREE": QUEUE - len(self._items),
            "BOOT": self.boot,
            "LOST": int(self._lost),
            "ALARM": self._alarm or "-",
        }
        return f"{axes} " + " ".join(f"{key}={value}" for key, value in fields.items())

    def _set_guard(self, rest: str) -> None:
        """``GUARD lift milliseconds outputs``: what to do when the gateway is gone."""
        try:
            lift, patience, outputs = rest.split(" ")
            numbers = [int(number) for number in outputs.split(",") if number != "-"]
            self._guard = _Guard(int(patience) / 1e3, int(lift), tuple(numbers))
        except ValueError:
            raise Refused("syntax") from None

    def _begin(self, rest: str) -> str:
        """``BEGIN lines``: a new program; return its number."""
        self._require_rest()
        if self.state is not BoardState.IDLE:
            raise Refused("busy", self.state)
        if not rest.isdecimal() or not int(rest):
            raise Refused("syntax")
        self._numbers += 1
        self._lost = False
        self._planned = list(self.joints())
        self._program = _Program(self._numbers, int(rest))
        return f"PROGRAM={self._numbers}"

    def _load(self, rest: str) -> str:
        """``LOAD program first instruction|instruction|…``: lines of the running program."""
        words = rest.split(" ", 2)
        program = self._program
        if len(words) != 3 or not (words[0].isdecimal() and words[1].isdecimal()):
            raise Refused("syntax")
        if self._alarm:
            raise Refused("alarm", self._alarm)
        if program is None or program.number != int(words[0]) or self._discarding:
            raise Refused("program")
        first, texts = int(words[1]), words[2].split("|")
        if first != program.loaded + 1 or program.loaded + len(texts) > program.lines:
            raise Refused("order", program.loaded + 1)
        if len(self._items) + len(texts) > QUEUE:
            raise Refused("full")
        for number, text in enumerate(texts, first):
            self._load_line(program, number, text)
        return f"FREE={QUEUE - len(self._items)}"

    def _load_line(self, program: _Program, number: int, text: str) -> None:
        instruction = _parsed(text, number)
        if number == 1 and (
            instruction.name is not Name.FORMAT or instruction.number != figures.FORMAT
        ):
            raise Refused("line", number, "format")
        if instruction.name is Name.PULSES:
            stated = [instruction.words.get(letter) for letter in AXES]
            if stated != [float(f"{scale:.6f}") for scale in self._wiring.pulses]:
                raise Refused("line", number, "pulses")
            program.scaled = True
        elif instruction.name not in (None, Name.FORMAT):
            if not program.scaled:
                raise Refused("line", number, "pulses")
            self._check_motion(number, instruction)
        if (instruction.name is Name.END) != (number == program.lines):
            raise Refused("line", number, "end")
        program.loaded = number
        self._items.append((number, instruction))

    def _check_motion(self, number: int, instruction: Instruction) -> None:
        """Refuse a motion that the chip cannot execute."""
        moved = sum(letter in instruction.words for letter in AXES)
        if instruction.name in MOTIONS and not 1 <= moved <= 3:
            raise Refused("line", number, "axes")
        if any(abs(value) > figures.LARGEST for value in instruction.words.values()):
            raise Refused("line", number, "range")
        if instruction.name not in MOTIONS or instruction.name is Name.GO:
            return
        fastest = figures.FASTEST * self._wiring.multiple
        if not self._wiring.multiple <= instruction.words.get("V", 0.0) <= fastest:
            raise Refused("line", number, "speed")
        if not any(instruction.ways):
            raise Refused("line", number, "axes")

    def _require_rest(self) -> None:
        if self._busy or self._after:
            raise Refused("moving")

    def _operate(self, command: str, rest: str) -> None:
        """Begin to move or home, or set the work zero, for a person at the machine."""
        if command == "HOME":
            if self._pressed:
                raise Refused("alarm", "emergency")
            self._alarm = ""
        if self._alarm:
            raise Refused("alarm", self._alarm)
        self._require_rest()
        if self.state is not BoardState.IDLE:
            raise Refused("busy", self.state)
        if command == "HOME":
            # Up first, then the other axes to their switches at zero.
            top = round(self.machine.travel_z * self._wiring.pulses[2])
            self._home(top)
        elif command == "ZERO":
            if not rest or not set(rest) <= set(AXES):
                raise Refused("syntax")
            for letter in rest:
                self._zero[AXES.index(letter)] = self.joints()[AXES.index(letter)]
        else:
            instruction = _parsed(f"GO {rest}")
            start = self.joints()
            stretch = self._rapid(0, instruction, start)
            if stretch is not None:
                self._stretches.append(stretch)
                self._purpose = BoardState.JOG

    def _home(self, top: int) -> None:
        """Simulate homing: lift Z, then move the other axes to zero."""
        start = self.joints()
        rate = self._fastest(2) * _SLOW
        self._purpose = BoardState.HOME
        up = (0, 0, top - start[2], 0)
        if any(up):
            self._stretches.append(Stretch(0, start, up, rate, joined=False))
        lifted = (start[0], start[1], top, start[3])
        back = (-start[0], -start[1], 0, -start[3])
        if any(back):
            self._stretches.append(Stretch(0, lifted, back, rate, joined=False))

    def _unlock(self) -> None:
        if self._pressed:
            raise Refused("alarm", "emergency")
        if self._alarm:
            self._alarm = "" if self._homed else "unhomed"


def _parsed(text: str, number: int = 0) -> Instruction:
    try:
        return parse(text)
    except BadLine:
        raise Refused("line", number, "syntax") from None
