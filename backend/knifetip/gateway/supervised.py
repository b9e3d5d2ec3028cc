"""supervised: the state of a controller that a driver supervises by status reports.

A connection records the first failure of the controller and its last report.  The driver returns
them to the rest of the gateway, with the outputs that a person has switched on, and brings the
machine into its safe state.  This is the same for controllers that receive lines and for those that
run whole programs.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import Generic, Protocol, TypeVar

from knifetip.errors import ControllerAlarm, ControllerError, ControllerOccupied
from knifetip.gateway.controller import Observer, SafeState, Status
from knifetip.gateway.presupposed import PresupposedSettings, compare
from knifetip.messages import Message
from knifetip.model.machine import Machine


class SupervisedConnection(Protocol):
    """Interface of a connection that records failures and status reports."""

    fault: ControllerError | None
    observer: Observer | None
    recovering: bool  #: the machine is being brought into its safe state
    status: Status | None  #: last report
    sent: int  #: program lines sent since ``open``

    @property
    def name(self) -> str:
        """Address of the controller, for messages."""
        ...

    @property
    def connected(self) -> bool:
        """Whether the connection is open."""
        ...

    def fail(self, error: ControllerError) -> ControllerError:
        """Record an error as the fault, unless there is a fault already; return the fault."""
        ...


ConnectionT = TypeVar("ConnectionT", bound=SupervisedConnection)


class SupervisedController(ABC, Generic[ConnectionT]):
    """The methods of ``Controller`` and ``Operable`` that need no command of the controller.

    Parameters
    ----------
    connection
        Connection to the controller.
    safe
        Safe state into which ``stop`` brings the machine.  If None, it only ends the running
        program.
    """

    def __init__(self, connection: ConnectionT, safe: SafeState | None) -> None:
        self._connection = connection
        self._safe = safe
        self._switched_on: frozenset[int] = frozenset()
        self._spinning = 0
        self._notices: tuple[Message, ...] = ()

    @property
    def notices(self) -> tuple[Message, ...]:
        """Harmless differences between the settings and what the programs presuppose."""
        return self._notices

    async def verify_settings(self) -> None:
        """Read the settings, and compare them with what the programs of the machine presuppose.

        Without a machine nothing is read.

        Raises
        ------
        ControllerError
            A difference is dangerous; it is recorded as the fault of the controller.
        """
        if self._safe is None or self._safe.machine is None:
            return
        settings = await self._read_presupposed(self._safe.machine)
        try:
            differences = compare(self.name, settings.required, settings.found)
        except ControllerError as dangerous:
            raise self._connection.fail(dangerous) from None
        self._notices = (*settings.notices, *differences)

    async def _read_presupposed(self, machine: Machine) -> PresupposedSettings:
        """Read the settings; a controller whose settings cannot be read has none."""
        del machine
        return PresupposedSettings()

    @property
    def name(self) -> str:
        """Address of the controller, for messages."""
        return self._connection.name

    @property
    def fault(self) -> ControllerError | None:
        """First failure since the machine was last in its safe state; None if there is none.

        Every method except ``stop``, ``open`` and ``close`` raises this failure.
        """
        return self._connection.fault

    @property
    def sent(self) -> int:
        """Number of program lines that were sent to the controller since ``open``."""
        return self._connection.sent

    @property
    def observer(self) -> Observer | None:
        """Object that compares each status report with the program; None if no program runs."""
        return self._connection.observer

    @observer.setter
    def observer(self, observer: Observer | None) -> None:
        self._connection.observer = observer

    @property
    def connected(self) -> bool:
        """Whether the connection to the controller is open."""
        return self._connection.connected

    @property
    def last_status(self) -> Status | None:
        """Last status report, also after a failure; None if there is none since connecting."""
        return self._connection.status

    @property
    def spinning(self) -> int:
        """Number of the station whose spindle ``spin`` has switched on; 0 for none."""
        return self._spinning

    @property
    def switched_on(self) -> frozenset[int]:
        """Numbers of the digital outputs that ``switch`` has switched on."""
        return self._switched_on

    def _record_switch(self, output: int, on: bool) -> None:
        """Record that an output has been switched on or off."""
        self._switched_on = self._switched_on | {output} if on else self._switched_on - {output}

    def _forget_switches(self) -> None:
        """Record that all outputs and the spindle have been switched off."""
        self._switched_on, self._spinning = frozenset(), 0

    def lock(self, reason: ControllerAlarm | ControllerOccupied) -> None:
        """Record why the controller takes no program, until ``unlock``, ``home`` or ``release``."""
        self._connection.fail(reason)

    async def stop(self) -> Status:
        """Discard the rest of the program and bring the machine into its safe state.

        Clears earlier failures; reconnects if the connection is lost.

        Returns
        -------
        Status
            Status of the machine at rest, after Z was raised to its safe height.

        Raises
        ------
        ControllerError
            An alarm locks the machine, the controller refuses to raise Z or to switch an output
            off, or the controller cannot be reached.
        """
        connection = self._connection
        connection.recovering = True
        done = False
        try:
            status = await self._make_safe()
            done = True
            self._forget_switches()
        except ControllerError as unsafe:
            connection.fault = None  # the present fault matters more than the first one
            raise connection.fail(unsafe) from None
        finally:
            connection.recovering = False
            if not done:
                connection.fail(ControllerError("controller.not-recovered", name=self.name))
        return status

    @abstractmethod
    async def _make_safe(self) -> Status:
        """Clear the fault, discard the program, and bring the machine into its safe state."""
