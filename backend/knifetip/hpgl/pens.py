"""pens: the selected pen of a plot, its line type, and the widths and colours of all pens.

A user puts pens of any colour into a plotter, so the file states no colour of a pen unless it
contains the instruction PC of HP-GL/2.  The pen number is the layer of a line.  The line type is
the linetype of a line: "dashed 2" for pattern 2 of the plotter.

Source: PCL 5 Printer Language Technical Reference Manual (HP 5961-0509), chapters 19 and 22: SP,
PW, WU, LT, PC and CR.
"""

from __future__ import annotations

from typing import Final

from knifetip.drawing_builder.colours import UNKNOWN_COLOUR, nearest_index
from knifetip.drawing_builder.columns import Style
from knifetip.drawing_builder.line_widths import GREATEST
from knifetip.hpgl.instructions import Instruction, count_is_wrong
from knifetip.model.drawing import NO_LINE_WIDTH

#: Linetype of lines without a dash pattern.
SOLID: Final = "Continuous"
#: LT with this value restores the line type before the last LT without values.
_RESTORE: Final = 99.0
#: Values of black and white in PC: red, green and blue of each.
_RANGE: Final = (0.0, 255.0, 0.0, 255.0, 0.0, 255.0)
_INSTRUCTIONS: Final = ("SP", "LT", "PW", "WU", "PC", "CR")


class Pens:
    """State of the pens after some of the instructions of a plot."""

    def __init__(self) -> None:
        self.selected: int | None = None  #: None before a pen is selected, 0 for no pen
        self._linetype = self._former = SOLID
        self._width: dict[int, float] = {}  # mm by pen
        self._every_width = -1.0
        self._is_width_relative = False
        self._colours: dict[int, int] = {}
        self._range = _RANGE

    @staticmethod
    def handles(name: str) -> bool:
        """Return whether an instruction, given by its name, changes the state of the pens."""
        return name in _INSTRUCTIONS

    @property
    def layer(self) -> str:
        """Name of the layer of the selected pen."""
        return "no pen" if self.selected is None else f"pen {self.selected}"

    @property
    def style(self) -> Style:
        """Style of the lines that the selected pen draws."""
        pen = self.selected or 0
        colour = self._colours.get(pen, UNKNOWN_COLOUR)
        width = self._width.get(pen, self._every_width)
        whole = NO_LINE_WIDTH if width < 0.0 else min(round(width * 100.0), GREATEST)
        return Style(self.layer, nearest_index(colour), colour, self._linetype, whole)

    def reset(self) -> None:
        """Set everything but the selected pen to the default, as IN and DF do."""
        selected = self.selected
        self.__init__()  # type: ignore[misc]  # has no subclasses
        self.selected = selected

    def change(self, instruction: Instruction) -> None:
        """Change the state as an instruction does that ``handles`` accepts.

        Raises
        ------
        NotADrawing
            The instruction has a wrong number of values.
        """
        values = instruction.values
        if instruction.name == "SP":
            if len(values) > 1:
                raise count_is_wrong(instruction, 0, 1)
            self.selected = int(abs(values[0])) if values else 0
        elif instruction.name == "LT":
            self._change_linetype(values)
        elif instruction.name == "PW":
            if len(values) > 2:
                raise count_is_wrong(instruction, 0, 1, 2)
            width = abs(values[0]) if values and not self._is_width_relative else -1.0
            if len(values) == 2:
                self._width[int(abs(values[1]))] = width
            else:
                self._width.clear()
                self._every_width = width
        elif instruction.name == "WU":
            self._is_width_relative = bool(values) and values[0] == 1.0
            self._width.clear()
            self._every_width = -1.0
        elif instruction.name == "CR":
            if len(values) not in (0, 6):
                raise count_is_wrong(instruction, 0, 6)
            self._range = (*values,) if values else _RANGE  # type: ignore[assignment]  # six values
        else:
            self._change_colour(instruction)

    def _change_linetype(self, values: list[float]) -> None:
        if not values:
            self._former, self._linetype = self._linetype, SOLID
        elif values[0] == _RESTORE:
            self._linetype = self._former
        else:
            self._linetype = f"dashed {abs(values[0]):g}"

    def _change_colour(self, instruction: Instruction) -> None:
        values = instruction.values
        if len(values) not in (0, 1, 4):
            raise count_is_wrong(instruction, 0, 1, 4)
        if not values:
            self._colours.clear()
            return
        pen = int(abs(values[0]))
        self._colours.pop(pen, None)
        if len(values) == 1:
            return
        colour = 0
        for part, black, white in zip(values[1:], self._range[::2], self._range[1::2], strict=True):
            share = (part - black) / (white - black) if white != black else 0.0
            colour = colour << 8 | round(255.0 * min(max(share, 0.0), 1.0))
        self._colours[pen] = colour
