"""board: simulates the ARM board of a machine with an MCX314, with its power, buttons and clock.

The board keeps loaded program lines in a queue (``program_queue``), plans their ramps
(``planner``), and feeds the chip through its registers (``feeder``, ``execution``).  ``receive``
processes bytes from the gateway and returns the answers (``board_link``, ``commands``);
docs/mcx314-link.md describes the protocol.  Time passes only in ``advance``.

If no request arrives while a program runs or is held, the board brings the machine
into the safe state by itself (``gateway_watchdog``): it stops, lifts Z and releases all outputs.
"""

from __future__ import annotations

from knifetip.errors import ControllerError
from knifetip.geometry.columns import F64
from knifetip.languages.mcx314.wiring import Wiring
from knifetip.model.machine import Machine
from knifetip.simulators.mcx314.board_link import BoardLink, LinkFaults
from knifetip.simulators.mcx314.chip import Chip, ChipRefused
from knifetip.simulators.mcx314.commands import Commands
from knifetip.simulators.mcx314.execution import MOMENT, BoardState, Execution
from knifetip.simulators.mcx314.gateway_watchdog import GatewayWatchdog
from knifetip.simulators.mcx314.outputs import joints_of
from knifetip.simulators.mcx314.parts import BoardParts
from knifetip.simulators.mcx314.program_queue import BoardProgram
from knifetip.simulators.mcx314.record import BoardRecord, SwitchedOutput
from knifetip.simulators.mcx314.refusal import RequestRefused


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
        self.boot = 0
        self._wiring = wiring
        self._record = BoardRecord(sample)
        self._switch_on(homed)

    # -- power, buttons and switches --------------------------------------------------------------

    def _switch_on(self, homed: bool) -> None:
        self.boot += 1
        self._parts = BoardParts.switched_on(
            self.machine, self._wiring, self.chip, self._record, homed=homed
        )
        self._execution = Execution(self._parts)
        self._watchdog = GatewayWatchdog(self._parts, self._execution)
        self._commands = Commands(self._parts, self._execution, self._watchdog, self.boot)
        self._link = BoardLink(self._execute, self._watchdog.record_request)

    def reset(self) -> None:
        """Interrupt the power: all outputs are released, and the position is unknown."""
        self._switch_on(homed=False)

    def press_stop(self) -> None:
        """Press the emergency stop button."""
        self._parts.interlock.pressed = True
        self.trip("emergency")

    def release_stop(self) -> None:
        """Release the emergency stop button."""
        self._parts.interlock.pressed = False

    def trip(self, alarm: str) -> None:
        """Stop at once because of an alarm, such as ``limit-X`` or ``drive-X``."""
        self._parts.feeder.stop()
        self._execution.discard()
        self._parts.outputs.oscillates = False
        self._parts.interlock.trip(alarm)

    # -- state ------------------------------------------------------------------------------------

    @property
    def time(self) -> float:
        """Simulated time (s)."""
        return self.chip.time

    def joints(self) -> tuple[int, int, int, int]:
        """Return the positions of the joints X, Y, Z and C (pulses)."""
        return joints_of(self.chip)

    @property
    def position(self) -> tuple[float, ...]:
        """Positions of the joints (mm, degrees)."""
        return tuple(
            pulses / scale for pulses, scale in zip(self.joints(), self._wiring.pulses, strict=True)
        )

    @property
    def state(self) -> BoardState:
        """State that the board reports."""
        return self._execution.state

    @property
    def program(self) -> BoardProgram | None:
        """The program that the board executes or has executed; None if it was discarded."""
        return self._parts.queue.program

    @property
    def outputs(self) -> set[int]:
        """Numbers of the outputs that are on."""
        return self._parts.outputs.on

    @property
    def oscillates(self) -> bool:
        """Whether the oscillation is on."""
        return self._parts.outputs.oscillates

    @property
    def switched(self) -> list[SwitchedOutput]:
        """All changes of outputs and of the oscillation."""
        return self._record.switched

    @property
    def starved(self) -> int:
        """Number of stops in a cut because the queue was empty."""
        return self._record.starved

    @property
    def refusals(self) -> list[str]:
        """Refusals of the chip."""
        return self._record.refusals

    def samples(self) -> F64:
        """Return the recorded time (s) and joints (mm, degrees), (n, 5)."""
        return self._record.samples()

    # -- time -------------------------------------------------------------------------------------

    def advance(self, seconds: float) -> None:
        """Let simulated time pass."""
        execution, record = self._execution, self._record
        end = self.chip.time + seconds
        try:
            while True:
                execution.work()
                if self.chip.time >= end:
                    return
                step = end - self.chip.time
                if (due := self.chip.due) is not None:
                    step = min(step, due + MOMENT)
                if execution.dwell > 0.0:
                    step = min(step, execution.dwell)
                if (left := record.until_due(self.time)) is not None:
                    step = min(step, max(left, MOMENT))
                before = self.chip.time
                self.chip.advance(step)
                execution.let_pass(self.chip.time - before)
                if record.is_due(self.time):
                    record.sample(self.time, self.position, moving=execution.busy)
        except ChipRefused as refused:
            self._break(refused)

    def watch(self, seconds: float) -> None:
        """Bring the machine into the safe state if the gateway is gone.

        ``seconds`` is the real time since the last call.
        """
        self._watchdog.watch(seconds)

    def _break(self, refused: ChipRefused) -> None:
        """Stop at once because the chip has refused a write of the board."""
        self.refusals.append(str(refused))
        self.trip("chip")

    # -- requests ---------------------------------------------------------------------------------

    @property
    def requests(self) -> int:
        """Number of valid requests that have arrived."""
        return self._link.requests

    @property
    def hangs_up(self) -> bool:
        """Whether the connection breaks now (an injected fault)."""
        return self._link.hangs_up(self.faults)

    def connect(self) -> None:
        """Forget the rest of an earlier connection."""
        self._link.connect()

    def receive(self, data: bytes) -> bytes:
        """Process received bytes and return the answers."""
        return self._link.receive(data, self.faults)

    def _execute(self, text: str) -> str:
        try:
            return self._commands.execute(text)
        except ChipRefused as refused:
            self._break(refused)
            raise RequestRefused("alarm") from None
