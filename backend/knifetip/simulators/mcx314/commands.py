"""commands: execute the requests of the gateway with the parts of the board."""

from __future__ import annotations

from knifetip.gateway.mcx314.instructions import AXES
from knifetip.simulators.mcx314.execution import Execution
from knifetip.simulators.mcx314.gateway_watchdog import GatewayWatchdog, Guard
from knifetip.simulators.mcx314.parts import BoardParts
from knifetip.simulators.mcx314.program_queue import QUEUE
from knifetip.simulators.mcx314.refusal import RequestRefused, parse_or_refuse

#: Version of the protocol.
PROTOCOL = 1


class Commands:
    """Executes the requests of docs/mcx314-link.md.

    Parameters
    ----------
    parts, execution, watchdog
        The parts of the board, its execution, and its guard.
    boot
        How often the board was switched on.
    """

    def __init__(
        self, parts: BoardParts, execution: Execution, watchdog: GatewayWatchdog, boot: int
    ) -> None:
        self._parts = parts
        self._execution = execution
        self._watchdog = watchdog
        self._boot = boot

    def execute(self, text: str) -> str:
        """Execute a request; return what its answer states.

        Raises
        ------
        RequestRefused
            The board refuses the request.
        ChipRefused
            The chip refuses a write of the board.
        """
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
                self._execution.hold()
            case "RESUME":
                self._execution.holding = False
            case "ABORT":
                self._execution.abort()
                self._execution.work()
            case "OUT" | "OSC":
                self._execution.require_rest()
                self._execution.act(parse_or_refuse(text))
            case "MOVE" | "HOME" | "ZERO":
                self._operate(command, rest)
            case "UNLOCK":
                self._parts.interlock.unlock()
            case _:
                raise RequestRefused("unknown")
        return ""

    def _hello(self) -> str:
        pulses = " ".join(
            f"{letter}={scale:g}"
            for letter, scale in zip(AXES, self._parts.wiring.pulses, strict=True)
        )
        return f"MCX314 PROTOCOL={PROTOCOL} BOOT={self._boot} {pulses} QUEUE={QUEUE}"

    def _status(self) -> str:
        program = self._parts.queue.program
        current = self._parts.feeder.current
        line = 0
        if program is not None:
            line = program.done
            if current is not None and current.stretch.line:
                line = current.stretch.line
            elif line < program.lines and program.loaded > line:
                line += 1
        axes = " ".join(
            f"{letter}={self._parts.feeder.position(axis) - self._parts.stretches.zero[axis]}"
            for axis, letter in enumerate(AXES)
        )
        fields = {
            "STATE": self._execution.state,
            "PROGRAM": program.number if program else 0,
            "LINE": line,
            "DONE": program.done if program else 0,
            "STILL": int(not self._parts.feeder.driving),
            "OUT": ",".join(map(str, sorted(self._parts.outputs.on))) or "-",
            "OSC": int(self._parts.outputs.oscillates),
            "FREE": self._parts.queue.free,
            "BOOT": self._boot,
            "LOST": int(self._watchdog.given_up),
            "ALARM": self._parts.interlock.alarm or "-",
        }
        return f"{axes} " + " ".join(f"{key}={value}" for key, value in fields.items())

    def _set_guard(self, rest: str) -> None:
        """``GUARD lift milliseconds outputs``: the safe state when the gateway is gone."""
        try:
            lift, time_limit, outputs = rest.split(" ")
            numbers = [int(number) for number in outputs.split(",") if number != "-"]
            self._watchdog.guard = Guard(int(time_limit) / 1e3, int(lift), tuple(numbers))
        except ValueError:
            raise RequestRefused("syntax") from None

    def _begin(self, rest: str) -> str:
        """``BEGIN lines``: a new program; return its number."""
        self._execution.require_idle()
        if not rest.isdecimal() or not int(rest):
            raise RequestRefused("syntax")
        self._watchdog.given_up = False
        return f"PROGRAM={self._execution.begin(int(rest))}"

    def _load(self, rest: str) -> str:
        """``LOAD program first instruction|instruction|…``: lines of the running program."""
        words = rest.split(" ", 2)
        if len(words) != 3 or not (words[0].isdecimal() and words[1].isdecimal()):
            raise RequestRefused("syntax")
        self._parts.interlock.require_clear()
        if self._execution.discarding:
            raise RequestRefused("program")
        self._parts.queue.load(int(words[0]), int(words[1]), words[2].split("|"))
        return f"FREE={self._parts.queue.free}"

    def _operate(self, command: str, rest: str) -> None:
        """Begin to move or home, or set the work zero, for a person at the machine."""
        if command == "HOME":
            self._parts.interlock.begin_homing()
        self._parts.interlock.require_clear()
        self._execution.require_idle()
        if command == "HOME":
            self._execution.home()
        elif command == "ZERO":
            if not rest or not set(rest) <= set(AXES):
                raise RequestRefused("syntax")
            joints = self._execution.joints()
            for letter in rest:
                axis = AXES.index(letter)
                self._parts.stretches.zero[axis] = joints[axis]
        else:
            self._execution.jog(parse_or_refuse(f"GO {rest}"))
