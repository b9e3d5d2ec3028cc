"""driver: streams programs to controllers with the protocol of grbl 1.1, such as grblHAL.

The controller parses the program in check mode before anything moves.  Every failure raises one of
five errors, so that a failure never makes a call wait for ever: ``ControllerRejected``,
``ControllerAlarm``, ``ControllerReset`` (an unexpected banner), ``ControllerSilent`` (no answer, or
a lost ``ok``) and ``ControllerError`` (a lost connection, or a surplus ``ok``).  After each of
these errors ``Grbl.stop`` brings the machine into its safe state (``recovery``).

If the controller sends two ``ok`` for one line, the driver counts too many free bytes in the
receive buffer.  The driver detects this in one of three ways: an answer arrives although no line is
unanswered, a status report shows more bytes in the buffer than the unanswered lines have, or, at
the latest, ``Grbl.settle`` finds a surplus answer.
"""

from __future__ import annotations

import asyncio
import re
from collections.abc import Awaitable, Callable, Iterable
from contextlib import suppress

from knifetip.errors import (
    CheckRefused,
    ControllerAlarm,
    ControllerError,
    ControllerOccupied,
    ControllerRejected,
    ControllerSilent,
    ProgramError,
)
from knifetip.gateway.controller import SafeState, State, Status
from knifetip.gateway.grbl import answers, recovery, settings
from knifetip.gateway.grbl.capabilities import Capabilities
from knifetip.gateway.grbl.connection import GrblConnection
from knifetip.gateway.grbl.operating import GrblOperations
from knifetip.gateway.grbl.polling import Polling
from knifetip.gateway.grbl.receive_buffer import PendingLine
from knifetip.gateway.interpreter import switches_output
from knifetip.gateway.presupposed import PresupposedSettings
from knifetip.gateway.transport import Transport, connect
from knifetip.messages import Message
from knifetip.model.machine import Machine

#: Time between two status requests while the machine comes to rest (s).
_REST_INTERVAL = 0.01
#: Longest time to wait for the first status report (s).
_FIRST_REPORT = 2.0

_REALTIME = re.compile(rb"[^\x20-\x7e\t\r]|[?!~]")


class Grbl(GrblOperations):
    """A controller with grbl's protocol; the methods are those of ``Controller`` and ``Operable``.

    Parameters
    ----------
    transport
        Open transport.
    safe
        Safe state into which ``open`` and ``stop`` bring the machine.  If None, they only hold the
        machine and reset the controller.
    reconnect
        Function that opens a new transport after the connection was lost; None to give up.
    silence
        Seconds after which the controller counts as silent if no status report arrives, or if a
        line has no answer although the machine is idle.
    poll
        Longest time between two status requests while the machine moves (s); None to choose it by
        firmware and connection (see ``polling``).  While the machine is idle and no line is
        unanswered, status requests are sent at intervals of ``silence / 5`` if that is longer.
    """

    #: Reports are exact to a step: 0.06 mm were measured on grblHAL with 20 steps per millimetre.
    accuracy: float = 0.2
    #: The steps of up to 9 moves are prepared in advance: grblHAL has 10 segments (grbl 1.1 has 6),
    #: which are used by at most one move less.
    ahead: int = 9

    def __init__(
        self,
        transport: Transport,
        *,
        safe: SafeState | None = None,
        reconnect: Callable[[], Awaitable[Transport]] | None = None,
        silence: float = 5.0,
        poll: float | None = None,
    ) -> None:
        self._chooses_polling = poll is None
        polling = Polling() if poll is None else Polling.every(poll)
        super().__init__(GrblConnection(transport, reconnect, silence, polling), safe)
        self._silence = silence
        self._capabilities = Capabilities()

    @property
    def capacity(self) -> int | None:
        """Number of blocks (moves) that the planner of the controller can hold; None if unknown."""
        return self._capabilities.blocks

    @property
    def acknowledged(self) -> int:
        """Number of program lines that the controller has answered since it was opened."""
        return self._connection.acknowledged

    @property
    def last_alarm(self) -> int:
        """Code of the alarm that locks the controller.

        The code is 0 if there is no alarm, or if the code of the alarm was not received.
        """
        return self._connection.last_alarm

    @property
    def polling(self) -> Polling:
        """Intervals between two status requests while the machine moves."""
        return self._connection.polling

    # -- opening and closing ----------------------------------------------------------------------

    async def open(self, *, stop_motion: bool = False) -> None:
        """Take control of the controller, and bring the machine into its safe state.

        The controller is reset, which is harmless at rest; then Z is raised and all outputs are
        switched off, because a reset does not change them.  Afterwards the machine is at rest and
        the buffers of the controller are empty.  If an alarm locks the controller, nothing moves,
        and an error is raised; then a person at the machine can call ``unlock`` or ``home``.

        Parameters
        ----------
        stop_motion
            Whether to stop a machine that moves or is held, because it executes a program of this
            gateway.  If False, such a machine is left as it is, and an error is raised.

        Raises
        ------
        ControllerError
            The controller is busy, in alarm, does not answer, or refuses to raise Z or to switch an
            output off.
        """
        connection = self._connection
        connection.start()
        try:
            status = await connection.report(min(self._silence, _FIRST_REPORT))
        except ControllerSilent:
            # After a critical alarm grbl answers nothing until it is reset.
            status = None
        is_safe = False
        if status and status.state not in (State.IDLE, State.CHECK, State.ALARM):
            if not (stop_motion and status.state in (State.RUN, State.HOLD)):
                raise ControllerOccupied(
                    "controller.busy", name=self.name, state=status.state.value
                )
            await self.stop()
            is_safe = True
        else:
            await connection.reset()
        status = await self.status()
        if status.state is State.ALARM:
            raise connection.fail(ControllerAlarm("controller.locked-by-alarm", name=self.name))
        await self._read_settings()
        if not is_safe:
            await recovery.secure(connection, self._safe, self._silence)

    async def _read_settings(self) -> None:
        """Request the options of the controller, and check its settings."""
        await self._read_capabilities()
        await self.verify_settings()

    async def _read_presupposed(self, machine: Machine) -> PresupposedSettings:
        """Read the settings (``$$``)."""
        connection = self._connection
        found = settings.read(await connection.command(b"$$"))
        if self._capabilities.grblhal and len(self._capabilities.axes) > len("XYZ"):
            with suppress(ControllerRejected):  # a build without rotary axes
                number = b"$%d" % settings.ROTARY_AXES
                found |= settings.read(await connection.command(number))
        connection.hard_limits = settings.has_hard_limits(found)
        return PresupposedSettings(settings.requirements(machine, self._capabilities, found), found)

    async def _read_capabilities(self) -> None:
        """Request axes, outputs and buffers of the controller (``$I``).

        Raises ``ControllerError``: the controller has fewer outputs than the machine.
        """
        connection = self._connection
        lines = await connection.command(b"$I")
        letter = self._safe.heading_letter if self._safe else "C"
        self._capabilities = found = Capabilities.read(lines, connection.axes, letter)
        connection.rotary = found.rotary_axis
        connection.buffer.set_size(found.buffer)
        if self._chooses_polling:
            connection.polling = Polling.for_controller(
                grblhal=found.grblhal, byte_rate=connection.byte_rate
            )
        last = max(self._safe.outputs, default=-1) if self._safe else -1
        if found.outputs is not None and found.outputs <= last:
            raise connection.fail(
                ControllerError(
                    "controller.too-few-outputs", name=self.name, count=found.outputs, output=last
                )
            )

    async def find_web_server(self) -> None:
        """Raise ``NoSuchController`` if a web server is at the address, not a controller."""
        await self._connection.find_web_server()

    async def close(self) -> None:
        """Close the connection; the controller still executes the lines in its buffer."""
        await self._connection.close()

    # -- programs ---------------------------------------------------------------------------------

    async def check(self, lines: Iterable[bytes]) -> None:
        """Let the controller parse a program without motion (``$C``).

        Lines that switch outputs are omitted, because check mode may execute them.

        Raises
        ------
        ControllerRejected
            The controller refuses a line, or has not the axis or the output that a line requires;
            nothing has moved.
        CheckRefused
            A move exceeds the travel; nothing has moved, but an alarm locks the controller.
        ControllerError
            A setting of the controller is dangerous for programs of the machine.
        """
        connection = self._connection
        await self.verify_settings()  # a person may have changed them since the last program
        self._forget_switches()  # every program begins by switching everything off
        await connection.command(b"$C")
        connection.checking = True
        connection.refusals.clear()
        try:
            for number, line in enumerate(lines, 1):
                if connection.refusals:
                    break
                if obstacle := self._capabilities.obstacle(line):
                    connection.refusals.append(self._unable(line, number, obstacle))
                elif not switches_output(line):
                    await self.send(line, number)
            await self.drain()
            # The controller resets itself when it leaves check mode.
            await connection.reset_by(b"$C", "controller.check-end-not-confirmed")
            # It may still discard what arrives until it answers.
            await connection.report()
        except ControllerAlarm as alarm:
            if alarm.message.arguments.get("code") != answers.SOFT_LIMIT:
                raise
            raise CheckRefused(alarm.message) from alarm  # the alarm remains the fault
        finally:
            connection.checking = False
        if connection.refusals:
            raise connection.refusals[0]

    def _unable(self, line: bytes, number: int, obstacle: Message) -> ControllerRejected:
        """Return the error for a program line that the controller cannot execute."""
        text = PendingLine(line, number).excerpt
        return ControllerRejected(
            "controller.unable", name=self.name, line=number, text=text, obstacle=obstacle
        )

    async def send(self, line: bytes, number: int) -> None:
        """Send a program line as soon as the receive buffer of the controller has room for it.

        The letter of the rotary axis is replaced by that of the controller.

        Parameters
        ----------
        line
            Text of the program line, without newline.
        number
            Number of the program line, from 1, for error messages.

        Raises
        ------
        ProgramError
            The line contains realtime commands, or is longer than the buffer.
        ControllerError
            The first failure of the controller, if it has failed.
        """
        if found := _REALTIME.search(line):
            raise ProgramError("program.control-byte", line=number, byte=found[0].hex())
        connection, pending = (
            self._connection,
            PendingLine(self._capabilities.to_wire(line), number),
        )
        if pending.size > connection.buffer.capacity:
            raise ProgramError(
                "program.line-too-long-to-send",
                line=number,
                length=len(line),
                name=self.name,
                limit=connection.buffer.capacity - 1,
            )
        if not connection.checking:
            connection.buffer.reserve(pending)
        await connection.send_line(pending)

    async def drain(self) -> None:
        """Wait until the controller has answered every line that was sent."""
        await self._connection.drain()

    async def settle(self) -> Status:
        """Wait until the machine is at rest and every program line is answered.

        Returns
        -------
        Status
            Last status report.

        Raises
        ------
        ControllerError
            The controller has failed, or has sent an answer that belongs to no line.
        """
        await self.drain()
        idle = 0
        # Two reports: the planner may have accepted a move without having started it.
        while idle < 2:
            status = await self.status()
            idle = idle + 1 if status.state is State.IDLE else 0
            if not idle:
                await asyncio.sleep(_REST_INTERVAL)
        # $G sends a line before its ok.  After a doubled ok the last line has been answered too
        # early, so that the ok of that line arrives here, without the line of $G.
        if not any(line.startswith("[GC:") for line in await self._connection.command(b"$G")):
            raise self._connection.fail(self._connection.surplus_answer())
        self._connection.buffer.release_reserve()
        return status

    async def status(self) -> Status:
        """Request a status report (``?``) and return it.

        Raises
        ------
        ControllerError
            The controller has failed before, or does not answer now; the missing answer is recorded
            as its fault.
        """
        try:
            return await self._connection.report()
        except ControllerSilent as silent:
            raise self._connection.fail(silent) from None

    async def hold(self) -> None:
        """Decelerate to a stop from which ``resume`` can continue (feed hold, ``!``)."""
        await self._connection.realtime(b"!")

    async def resume(self) -> None:
        """Let the machine continue after a hold (cycle start, ``~``)."""
        await self._connection.realtime(b"~")

    async def _make_safe(self) -> Status:
        return await recovery.make_safe(self._connection, self._safe, self._silence)


async def dial(
    address: str,
    safe: SafeState | None = None,
    *,
    stop_motion: bool = False,
    silence: float = 5.0,
    poll: float | None = None,
) -> Grbl:
    """Connect to a grbl controller, take control of it and bring its machine into the safe state.

    A controller that an alarm locks is returned with this alarm as its ``fault``: a person at the
    machine can then call ``unlock`` or ``home``.  So is one that is held or busy, which ``release``
    brings to rest.

    Parameters
    ----------
    address
        Address of the controller (see ``transport``).
    safe
        Safe state of the machine; if None, the tool is not raised and no output is switched off.
    stop_motion
        Whether to stop a machine that moves or is held, because it executes a program of this
        gateway.  If False, such a machine is left as it is, and an error is raised.
    silence
        Seconds after which the controller counts as silent.
    poll
        Longest time between two status requests while the machine moves (s); None to choose it by
        firmware and connection.

    Raises
    ------
    NoSuchController
        The address is invalid, or a web server answers there.
    ControllerError
        The controller does not answer.
    """
    controller = Grbl(
        await connect(address),
        safe=safe,
        reconnect=lambda: connect(address),
        silence=silence,
        poll=poll,
    )
    try:
        await controller.open(stop_motion=stop_motion)
    except (ControllerAlarm, ControllerOccupied) as locked:
        controller.lock(locked)
    except BaseException as failed:
        try:
            if isinstance(failed, ControllerError):
                await controller.find_web_server()
        finally:
            await controller.close()
        raise
    return controller
