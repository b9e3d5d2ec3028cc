"""parts: the objects of which a running board consists; several other modules share them."""

from __future__ import annotations

from dataclasses import dataclass

from knifetip.languages.mcx314.wiring import Wiring
from knifetip.model.machine import Machine
from knifetip.simulators.mcx314.chip import Chip
from knifetip.simulators.mcx314.feeder import Feeder
from knifetip.simulators.mcx314.interlock import Interlock
from knifetip.simulators.mcx314.outputs import Outputs
from knifetip.simulators.mcx314.program_queue import ProgramQueue
from knifetip.simulators.mcx314.record import BoardRecord
from knifetip.simulators.mcx314.stretches import StretchBuilder


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


@dataclass(frozen=True, slots=True)
class BoardParts:
    """The parts of a board."""

    wiring: Wiring  #: how the machine is connected to the chip
    chip: Chip
    feeder: Feeder  #: writes to the chip
    queue: ProgramQueue
    stretches: StretchBuilder
    outputs: Outputs
    interlock: Interlock
    record: BoardRecord  #: outlasts an interruption of the power, as the chip does

    @classmethod
    def switched_on(
        cls, machine: Machine, wiring: Wiring, chip: Chip, record: BoardRecord, *, homed: bool
    ) -> BoardParts:
        """Return the parts of a board that was just switched on; everything is off and at rest."""
        feeder = Feeder(_TimedBus(chip, wiring.refill / 40.0), wiring)
        feeder.stop()
        feeder.set_up()
        if homed:
            for axis, place in enumerate((0.0, 0.0, machine.travel_z, 0.0)):
                feeder.set_position(axis, round(place * wiring.pulses[axis]))
        return cls(
            wiring,
            chip,
            feeder,
            ProgramQueue(wiring),
            StretchBuilder(machine, wiring),
            Outputs(chip, feeder, record),
            Interlock(homed),
            record,
        )
