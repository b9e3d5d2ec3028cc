"""interpreter: the effect of one line of G-code, in the dialect of grblHAL or of LinuxCNC.

For example ``b"G2 X10 Y0 I5 J0 C-90 F1200"`` becomes a ``Block`` with a ``Move``.  A line that the
controller refuses raises ``LineRefused`` with grbl's error number.

LinuxCNC adds the offset of the selected tool to the programmed positions (``T2 M6 G43``).  Programs
for grblHAL contain the offsets already.  In both cases the moves are those of the axes.

The simulated table executes the blocks.  For a real machine, the gateway checks whether the
reported positions are on the moves of the blocks.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Protocol

from knifetip.gateway.motion import Move, Pose
from knifetip.model.machine import Machine

#: End point and start point of an arc may differ in radius by this (mm), or a thousandth of it.
ROUND = 0.005
#: An arc that turns less than this is a full circle (radians), as in grbl.
FULL = 5e-7
#: grblHAL's limit for one line, without its newline.
LINE = 256

_COMMENT = re.compile(rb"\([^)]*\)?|;.*")
_WORD = re.compile(rb"([A-Z])([-+]?(?:\d+\.?\d*|\.\d+))")
_OUTPUT = re.compile(rb"M6[2-5](?![\d.])")
_AXES = {"X": 0, "Y": 1, "Z": 2, "C": 3, "A": 3, "B": 3}
#: Letters of the axis that rotates the tool; a line has at most one of them.
_HEADINGS = frozenset("ABC")

# Modal group of every command that is understood; a group may appear once in a line.
_GROUP: dict[tuple[str, float], str] = {
    **{("G", code): "dwell" for code in (4.0,)},
    **{("G", code): "shift" for code in (92.1,)},
    **{("G", code): "motion" for code in (0.0, 1.0, 2.0, 3.0, 80.0)},
    **{("G", code): "plane" for code in (17.0,)},
    **{("G", code): "unit" for code in (20.0, 21.0)},
    **{("G", code): "distance" for code in (90.0, 91.0)},
    **{("G", code): "arc" for code in (91.1,)},
    **{("G", code): "feed" for code in (93.0, 94.0)},
    **{("G", code): "compensation" for code in (40.0,)},
    **{("G", code): "length" for code in (49.0,)},
    **{("G", code): "offset" for code in (53.0, 54.0)},
    **{("M", code): "program" for code in (0.0, 2.0, 30.0)},
    **{("M", code): "spindle" for code in (3.0, 4.0, 5.0)},
    **{("M", code): "coolant" for code in (7.0, 8.0, 9.0)},
    **{("M", code): "output" for code in (62.0, 63.0, 64.0, 65.0)},
}

# The same with the commands that only LinuxCNC understands.
_LINUXCNC_GROUP: dict[tuple[str, float], str] = {
    **_GROUP,
    ("G", 43.0): "length",
    **{("G", code): "path" for code in (61.0, 61.1, 64.0)},
    ("M", 6.0): "change",
}

#: Letters of the words that are not commands.
_LETTERS = "XYZABCFIJKNPST"
#: No tool offset.
_NONE: Pose = (0.0, 0.0, 0.0, 0.0)


def tool_offsets(machine: Machine) -> dict[int, Pose]:
    """Return the offset that LinuxCNC's tool table contains for each station, by its number."""
    return {
        station.number: (station.x, station.y, station.z, station.c) for station in machine.stations
    }


class LineInterpreter(Protocol):
    """Interface of an interpreter of program lines in one controller language."""

    @property
    def position(self) -> Pose:
        """Position of the axes after the lines that were read."""
        ...

    def read(self, line: bytes) -> Block:
        """Return the effect of a program line; raises ``LineRefused``."""
        ...


class LineRefused(Exception):
    """Raised for a program line that a controller would answer with ``error:code``."""

    def __init__(self, code: int) -> None:
        super().__init__(f"error:{code}")
        self.code = code


@dataclass(frozen=True, slots=True)
class Block:
    """The effect of one program line; the fields are in the order of execution."""

    number: int = 0  #: value of the N word
    output: int = -1  #: digital output that it switches, -1 for none
    on: bool = False  #: whether the output is switched on
    oscillation: bool | None = None  #: M3, M4 and M5
    reverse: bool = False  #: M4
    dwell: float | None = None  #: G4 (s)
    move: Move | None = None
    pause: bool = False  #: M0
    end: bool = False  #: M2, M30
    in_machine_coordinates: bool = False  #: G53: the move is not in the coordinates of the program

    @property
    def waits(self) -> bool:
        """Whether the block is executed and answered only after all earlier moves have ended.

        M64 and M65 do not wait: grblHAL switches the output when it reads the line.
        """
        return self.dwell is not None or self.oscillation is not None or self.pause or self.end


EMPTY_BLOCK = Block()


def strip_comments(line: bytes) -> bytes:
    """Return a program line without comments and blanks, in capital letters."""
    return b"".join(_COMMENT.sub(b"", line).split()).upper()


def switches_output(line: bytes) -> bool:
    """Return whether a program line contains a command for a digital output (M62 … M65)."""
    return bool(_OUTPUT.search(strip_comments(line)))


class Interpreter:
    """Interprets the program lines of a controller one by one, and keeps its modal state.

    Parameters
    ----------
    position
        Present position of the axes.
    tools
        Offset of each tool, by its number; None for the dialect of grblHAL, which has no tool
        table.
    """

    def __init__(
        self,
        position: Pose = (0.0, 0.0, 0.0, 0.0),
        tools: Mapping[int, Pose] | None = None,
    ) -> None:
        self._tools = tools
        self._groups = _GROUP if tools is None else _LINUXCNC_GROUP
        self._letters = _LETTERS if tools is None else _LETTERS + "Q"
        self.reset(position)

    def reset(self, position: Pose) -> None:
        """Set the modal state that a controller has after power-up.

        Parameters
        ----------
        position
            Present position of the axes.
        """
        self.position = position
        self.feed = 0.0
        self._motion = 0.0
        self._inches = False
        self._relative = False
        self._inverse = False
        self._tool = 0
        self._offset = _NONE

    def read(self, line: bytes) -> Block:
        """Return the effect of a program line, and change the modal state accordingly.

        Raises
        ------
        LineRefused
            The controller would refuse the line; the modal state is not changed.
        """
        text = strip_comments(line)
        if not text or text == b"%":
            return EMPTY_BLOCK
        words, commands = _split(text, self._letters)
        groups = {}
        for command in commands:
            group = self._groups.get(command)
            if group is None:
                raise LineRefused(20)
            if group in groups:
                raise LineRefused(21)
            groups[group] = command[1]
        inches = groups["unit"] == 20.0 if "unit" in groups else self._inches
        relative = groups["distance"] == 91.0 if "distance" in groups else self._relative
        inverse = groups["feed"] == 93.0 if "feed" in groups else self._inverse
        motion = groups.get("motion", self._motion)
        scale = 25.4 if inches else 1.0
        number = int(words.pop("N", 0.0))
        words.pop("S", None)
        tool, offset = self._read_tool(words, groups)
        feed = words.pop("F", None)
        if feed is not None and feed < 0.0:
            raise LineRefused(4)
        if feed is not None and not inverse:
            feed *= scale
        output, on = _output(groups, words)
        dwell = _dwell(groups, words)
        if inverse != self._inverse and feed is None:
            modal_feed = 0.0  # G93 and G94 give a feed different meanings, so it is discarded
        else:
            modal_feed = self.feed if feed is None else feed
        move = None
        target = self._target(words, scale, offset, relative)
        if target is not None:
            if dwell is not None:
                raise LineRefused(24)
            if motion == 80.0:
                raise LineRefused(31)
            # G93 requires an F word on every line with a feed move.
            rate = (feed or 0.0) if inverse else modal_feed
            move = self._move(motion, target, words, scale, rate, inverse)
        elif groups.get("motion") in (2.0, 3.0):
            raise LineRefused(26)
        if words:
            raise LineRefused(36)
        self._inches, self._relative, self._inverse = inches, relative, inverse
        self._motion, self.feed = motion, modal_feed
        self._tool, self._offset = tool, offset
        if move is not None:
            self.position = move.end
        program = groups.get("program")
        if program in (2.0, 30.0):
            self._motion, self._relative, self._inverse = 1.0, False, False
        return Block(
            number=number,
            output=output,
            on=on,
            oscillation=groups["spindle"] != 5.0 if "spindle" in groups else None,
            reverse=groups.get("spindle") == 4.0,
            dwell=dwell,
            move=move,
            pause=program == 0.0,
            end=program in (2.0, 30.0),
            in_machine_coordinates=groups.get("offset") == 53.0,
        )

    def _read_tool(self, words: dict[str, float], groups: dict[str, float]) -> tuple[int, Pose]:
        """Return number and offset of the tool after a line for LinuxCNC.

        Removes the words of the tool and of the path tolerance from ``words``.

        ``groups``: number of the command in each modal group of the line.
        """
        if self._tools is None:
            return 0, _NONE
        tool = int(words.pop("T", self._tool))
        if groups.get("path") == 64.0:
            words.pop("P", None)
            words.pop("Q", None)
        if "length" not in groups:
            return tool, self._offset
        if groups["length"] == 49.0:
            return tool, _NONE
        if tool not in self._tools:
            raise LineRefused(36)
        return tool, self._tools[tool]

    def _target(
        self, words: dict[str, float], scale: float, offset: Pose, relative: bool
    ) -> Pose | None:
        """Return the pose at the end of a line, None if the line has no axis words.

        Removes the axis words from ``words``.

        ``words``: number in each word of the line, by letter.
        ``scale``: millimetres per length unit of the program: 1 or 25.4.
        ``offset``: offset of the tool, which is added to the axis words.
        ``relative``: whether the axis words are distances from the present position (G91).
        """
        named = [letter for letter in _AXES if letter in words]
        if not named:
            return None
        pose = list(self.position)
        for letter in named:
            axis = _AXES[letter]
            value = words.pop(letter) * (scale if axis < 3 else 1.0)
            pose[axis] = pose[axis] + value if relative else value + offset[axis]
        return pose[0], pose[1], pose[2], pose[3]

    def _move(
        self,
        motion: float,
        target: Pose,
        words: dict[str, float],
        scale: float,
        rate: float,
        inverse: bool,
    ) -> Move:
        start = self.position
        if motion == 0.0:
            return Move(start, target)
        if rate <= 0.0:
            raise LineRefused(22)
        minutes = 1.0 / rate if inverse else 0.0
        if motion == 1.0:
            return Move(start, target, rate=rate, minutes=minutes)
        if "I" not in words and "J" not in words:
            raise LineRefused(35)
        centre = (
            start[0] + words.pop("I", 0.0) * scale,
            start[1] + words.pop("J", 0.0) * scale,
        )
        first = math.hypot(start[0] - centre[0], start[1] - centre[1])
        last = math.hypot(target[0] - centre[0], target[1] - centre[1])
        if first == 0.0 or abs(first - last) > max(ROUND, 0.001 * first):
            raise LineRefused(33)
        turn = math.atan2(target[1] - centre[1], target[0] - centre[0]) - math.atan2(
            start[1] - centre[1], start[0] - centre[0]
        )
        sweep = turn % math.tau if motion == 3.0 else turn % math.tau - math.tau
        if abs(sweep) <= FULL:
            sweep = math.tau if motion == 3.0 else -math.tau
        elif abs(sweep) > math.tau - FULL:
            sweep = math.copysign(math.tau, sweep)
        return Move(start, target, centre=centre, sweep=sweep, rate=rate, minutes=minutes)


def _split(text: bytes, letters: str) -> tuple[dict[str, float], list[tuple[str, float]]]:
    """Split a program line into its words, and return the words in two groups.

    A word is a letter with a number, such as ``X10.5`` or ``G1``.

    ``text``: the line without comments and blanks, in capital letters.
    ``letters``: letters of the words that are not commands.
    Returns words: number in each word except G and M words, by letter; commands: letter and number
    of each G and M word, in the order of the line.
    Raises ``LineRefused``: the line is too long, or a word is invalid or occurs twice.
    """
    if len(text) > LINE:
        raise LineRefused(11)
    words: dict[str, float] = {}
    commands: list[tuple[str, float]] = []
    at = 0
    while at < len(text):
        match = _WORD.match(text, at)
        if match is None:
            raise LineRefused(2 if text[at : at + 1].isalpha() else 1)
        letter, value = match[1].decode(), float(match[2])
        at = match.end()
        if letter in "GM":
            commands.append((letter, value))
        elif letter in letters:
            if letter in words or (letter in _HEADINGS and not _HEADINGS.isdisjoint(words)):
                raise LineRefused(25)
            words[letter] = value
        else:
            raise LineRefused(20)
    return words, commands


def _output(groups: dict[str, float], words: dict[str, float]) -> tuple[int, bool]:
    if "output" not in groups:
        return -1, False
    if "P" not in words:
        raise LineRefused(28)
    return int(words.pop("P")), groups["output"] in (62.0, 64.0)


def _dwell(groups: dict[str, float], words: dict[str, float]) -> float | None:
    if "dwell" not in groups:
        return None
    if "P" not in words:
        raise LineRefused(28)
    return max(words.pop("P"), 0.0)
