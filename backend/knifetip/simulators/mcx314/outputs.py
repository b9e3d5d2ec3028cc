"""outputs: the outputs of the board and the oscillation of the knife, and each of their changes."""

from __future__ import annotations

from knifetip.languages.mcx314 import figures
from knifetip.simulators.mcx314.chip import Chip
from knifetip.simulators.mcx314.feeder import Feeder
from knifetip.simulators.mcx314.record import BoardRecord, SwitchedOutput

#: Number of the oscillation among the outputs.
OSCILLATION = -1


def joints_of(chip: Chip) -> tuple[int, int, int, int]:
    """Return the positions of the joints X, Y, Z and C (pulses)."""
    x, y, z, c = (chip.position(axis) for axis in range(figures.AXES))
    return x, y, z, c


class Outputs:
    """The outputs of a board, all off.

    Parameters
    ----------
    chip, feeder
        State where and when outputs are switched.
    record
        Keeps the changes.
    """

    def __init__(self, chip: Chip, feeder: Feeder, record: BoardRecord) -> None:
        self.on: set[int] = set()  #: numbers of the outputs that are on
        self.oscillates = False
        self._chip = chip
        self._feeder = feeder
        self._record = record

    def switch(self, output: int, on: bool) -> None:
        """Switch an output or the oscillation on or off."""
        if output < 0:
            self.oscillates = on
        elif on:
            self.on.add(output)
        else:
            self.on.discard(output)
        self._record.switched.append(
            SwitchedOutput(self._chip.time, output, on, joints_of(self._chip), self._feeder.driving)
        )
