"""program_queue: the program of the board, and those of its lines that wait for execution."""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass

from knifetip.gateway.mcx314.instructions import AXES, MOTIONS, Instruction, InstructionName
from knifetip.languages.mcx314 import figures
from knifetip.languages.mcx314.wiring import Wiring
from knifetip.simulators.mcx314.refusal import RequestRefused, parse_or_refuse

#: Program lines that the queue holds.
QUEUE = 128
#: Lines with which the board begins to move, unless the program has fewer.
PRIMED = 64


@dataclass(slots=True)
class BoardProgram:
    """The program that the board executes, and its progress."""

    number: int
    lines: int
    loaded: int = 0
    done: int = 0
    scaled: bool = False  #: its line ``PULSES`` was loaded


class ProgramQueue:
    """The program of a board and its queue; there is no program at first.

    Parameters
    ----------
    wiring
        How the machine is connected to the chip: a program must be made for it.
    """

    def __init__(self, wiring: Wiring) -> None:
        self.items: deque[tuple[int, Instruction]] = deque()  #: lines loaded and not begun
        self.program: BoardProgram | None = None
        self._wiring = wiring
        self._numbers = 0

    @property
    def free(self) -> int:
        """Number of free places for lines in the queue."""
        return QUEUE - len(self.items)

    @property
    def runs(self) -> bool:
        """Whether there is a program that has not ended."""
        return self.program is not None and self.program.done < self.program.lines

    @property
    def primed(self) -> bool:
        """Whether there are enough lines to begin to move."""
        program = self.program
        return program is None or program.loaded >= program.lines or len(self.items) >= PRIMED

    def begin(self, lines: int) -> int:
        """Begin a program of so many lines; return its number."""
        self._numbers += 1
        self.program = BoardProgram(self._numbers, lines)
        return self._numbers

    def complete(self, line: int) -> None:
        """Record that a line of the program is executed."""
        assert self.program is not None
        self.program.done = line

    def discard(self) -> None:
        """Discard the program."""
        self.items.clear()
        self.program = None

    def load(self, number: int, first: int, texts: list[str]) -> None:
        """Load lines of a program, from the line ``first`` on.

        Raises
        ------
        RequestRefused
            The program is not the present one, the lines are not the next ones or too many, or the
            board cannot execute one of them.
        """
        program = self.program
        if program is None or program.number != number:
            raise RequestRefused("program")
        if first != program.loaded + 1 or program.loaded + len(texts) > program.lines:
            raise RequestRefused("order", program.loaded + 1)
        if len(texts) > self.free:
            raise RequestRefused("full")
        for line, text in enumerate(texts, first):
            self._load_line(program, line, text)

    def _load_line(self, program: BoardProgram, number: int, text: str) -> None:
        instruction = parse_or_refuse(text, number)
        if number == 1 and (
            instruction.name is not InstructionName.FORMAT or instruction.number != figures.FORMAT
        ):
            raise RequestRefused("line", number, "format")
        if instruction.name is InstructionName.PULSES:
            stated = [instruction.words.get(letter) for letter in AXES]
            if stated != [float(f"{scale:.6f}") for scale in self._wiring.pulses]:
                raise RequestRefused("line", number, "pulses")
            program.scaled = True
        elif instruction.name not in (None, InstructionName.FORMAT):
            if not program.scaled:
                raise RequestRefused("line", number, "pulses")
            self._check_motion(number, instruction)
        if (instruction.name is InstructionName.END) != (number == program.lines):
            raise RequestRefused("line", number, "end")
        program.loaded = number
        self.items.append((number, instruction))

    def _check_motion(self, number: int, instruction: Instruction) -> None:
        """Refuse a motion that the chip cannot execute."""
        moved = sum(letter in instruction.words for letter in AXES)
        if instruction.name in MOTIONS and not 1 <= moved <= 3:
            raise RequestRefused("line", number, "axes")
        if any(abs(value) > figures.LARGEST for value in instruction.words.values()):
            raise RequestRefused("line", number, "range")
        if instruction.name not in MOTIONS or instruction.name is InstructionName.GO:
            return
        fastest = figures.FASTEST * self._wiring.multiple
        if not self._wiring.multiple <= instruction.words.get("V", 0.0) <= fastest:
            raise RequestRefused("line", number, "speed")
        if not any(instruction.ways):
            raise RequestRefused("line", number, "axes")
