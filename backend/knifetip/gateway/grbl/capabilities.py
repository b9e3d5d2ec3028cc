"""capabilities: axes, outputs and buffers of a controller, read from its answer to ``$I``.

A program names the axis that rotates the tool as the file of the machine does: C, A or B.  If the
controller names this axis differently, for example A in a 4-axis grblHAL, the letter is replaced in
each line that is sent.  The program itself is not changed, and the replacement can be reversed
exactly.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass

from knifetip.gateway.interpreter import strip_comments, switches_output
from knifetip.messages import Message

_OPTIONS = re.compile(r"\[OPT:[^,\]]*,(\d+),(\d+)")
#: Option D of grbl 1.1: the pin for the direction of the spindle switches the spindle on.
_ONE_DIRECTION = re.compile(r"\[OPT:[A-Z0-9*+]*D")
_REVERSE = re.compile(rb"M0*4(?![\d.])")
_AXES = re.compile(r"\[AXS:\d+:([A-Z]+)")
_OUTPUTS = re.compile(r"\[AUX IO:\d+,(\d+)")
_GRBL_1_1 = re.compile(r"\[VER:1\.1")

_COMMENT_OR_TEXT = re.compile(rb"(\([^)]*\)?|;.*)|[^(;]+", re.DOTALL)
_OUTPUT_NUMBER = re.compile(rb"P0*(\d+)")

#: Letter of the heading in operations of a person at the machine, and by default in programs.
HEADING = "C"
#: Axes that are not the rotary axis.
_LINEAR = "XYZ"
#: Usual order of the axes in status reports; FluidNC has no other.
_ORDER = "XYZABC"
_FLUIDNC = "FluidNC"
_GRBLHAL = "[FIRMWARE:grblHAL"
#: With this number of axes and without a statement, the last one may be A or C.
_A_OR_C = 4


@dataclass(frozen=True, slots=True)
class Capabilities:
    """Properties of a controller that decide whether it can execute a program, and how."""

    axes: str = ""  #: letters of the axes in the order of status reports; empty if unknown
    outputs: int | None = None  #: number of digital outputs; None if unknown
    blocks: int | None = None  #: blocks of the planner; None if unknown
    buffer: int | None = None  #: size of the receive buffer (bytes); None if unknown
    grblhal: bool = False  #: the firmware is grblHAL
    reverses: bool = True  #: the spindle turns in both directions (M4)
    program_letter: str = HEADING  #: letter of the axis that rotates the tool, in programs

    @classmethod
    def read(
        cls, lines: Iterable[str], reported: int, program_letter: str = HEADING
    ) -> Capabilities:
        """Return the capabilities that a controller states in its answer to ``$I``.

        Parameters
        ----------
        lines
            The lines of the answer, without ``ok``.
        reported
            Number of axes in status reports.
        program_letter
            Letter of the axis that rotates the tool, in programs.
        """
        text = "\n".join(lines)
        options, axes, outputs = (pattern.search(text) for pattern in (_OPTIONS, _AXES, _OUTPUTS))
        # grbl 1.1 itself states neither firmware nor axes nor outputs: it has only X, Y and Z.
        plain = bool(_GRBL_1_1.search(text)) and "[FIRMWARE:" not in text
        letters = axes[1] if axes else ""
        if not letters and (reported != _A_OR_C or _FLUIDNC in text):
            letters = _ORDER[:reported]
        return cls(
            axes=letters,
            outputs=int(outputs[1]) if outputs else 0 if plain and letters == _LINEAR else None,
            blocks=int(options[1]) if options else None,
            buffer=int(options[2]) if options else None,
            grblhal=_GRBLHAL in text,
            reverses=_ONE_DIRECTION.search(text) is None,
            program_letter=program_letter,
        )

    @property
    def rotary_letter(self) -> str:
        """Letter of the axis that rotates the tool; empty if the controller has no such axis.

        It is the letter of programs if there is such an axis, else the only axis besides X, Y and
        Z.  If there are several, it is A or B where programs have C, which may be because the file
        of the machine does not state a letter; a letter that it states is not replaced then.
        """
        if not self.axes or self.program_letter in self.axes:
            return self.program_letter
        others = [letter for letter in self.axes if letter not in _LINEAR]
        if len(others) == 1:
            return others[0]
        known = [letter for letter in "AB" if letter in others]
        return known[0] if known and self.program_letter == HEADING else ""

    @property
    def rotary_axis(self) -> int:
        """Index of the axis that rotates the tool in status reports; 3 if it is unknown."""
        letter = self.rotary_letter
        return self.axes.index(letter) if letter and letter in self.axes else 3

    def obstacle(self, line: bytes) -> Message | None:
        """Return a message if the controller cannot execute a program line, else None.

        Only axes, outputs and M4 are checked; the controller itself checks the rest.
        """
        if not self.reverses and _REVERSE.search(strip_comments(line)):
            return Message("grbl.no-reverse")
        if self.outputs is not None and switches_output(line):
            number = _OUTPUT_NUMBER.search(strip_comments(line))
            if number is not None and int(number[1]) >= self.outputs:
                return Message("grbl.no-output", output=int(number[1]), count=self.outputs)
        letter = self.rotary_letter
        if letter == self.program_letter:
            return None
        words = strip_comments(line)
        if not letter and self.program_letter.encode() in words:
            return Message("grbl.no-rotary-axis", axes=list(self.axes))
        if letter and letter.encode() in words:
            return Message("grbl.axis-letter-used", letter=letter)
        return None

    def to_wire(self, line: bytes) -> bytes:
        """Return a program line with the controller's letter of the rotary axis."""
        return _replace_letter(line, self.program_letter, self.rotary_letter)

    def operation_to_wire(self, line: bytes) -> bytes:
        """Return a line of an operation, whose heading is C, with the controller's letter."""
        return _replace_letter(line, HEADING, self.rotary_letter)

    def from_wire(self, line: bytes) -> bytes:
        """Return the program line that ``to_wire`` has changed to ``line``."""
        return _replace_letter(line, self.rotary_letter, self.program_letter)


def _replace_letter(line: bytes, old: str, new: str) -> bytes:
    """Return a program line with a letter replaced outside comments, in both cases."""
    if old == new or not old or not new:
        return line
    table = bytes.maketrans((old + old.lower()).encode(), (new + new.lower()).encode())
    return _COMMENT_OR_TEXT.sub(lambda part: part[0] if part[1] else part[0].translate(table), line)
