"""machine_link: the one connection of a gateway to the controller of its machine.

Jobs and operations of a person share the connection.  ``in_use`` is locked while one of them uses
the machine, so that they never use it at the same time.
"""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable
from contextlib import suppress

from knifetip.errors import (
    ControllerAlarm,
    ControllerError,
    ControllerOccupied,
    KnifetipError,
)
from knifetip.gateway.controller import (
    ConfiguredController,
    Controller,
    SafeState,
    State,
    Status,
)
from knifetip.gateway.dry_run import DryRun
from knifetip.gateway.job_run import JobRun
from knifetip.gateway.operations import OperableController
from knifetip.messages import Message

#: Opens a controller.  The second argument: whether to stop a machine that is still moving.
Connect = Callable[[SafeState, bool], Awaitable[Controller]]


class MachineLink:
    """Connects to the controller of a machine, and connects again after a failure.

    Parameters
    ----------
    safe
        Safe state of the machine.
    connect
        Opens a controller.

    Attributes
    ----------
    in_use
        Locked while a job or an operation uses the controller.
    abandoned
        Whether the machine may still execute a job of this gateway; it is then stopped when the
        gateway connects.
    reached
        Whether the controller was reached since the start of the gateway.
    jogged
        Whether an operation of a person has moved the machine, which was not seen at rest since.
    run
        The job that the gateway has claimed; None if there is none.
    dry_run
        The last program above the board that a person has asked for; None if there was none.
    left_on
        Digital outputs that a job has left on, because the machine could not be brought into its
        safe state; until a person has freed the machine.
    refusal
        Why the gateway has no connection to the controller; None if it has one, or has not tried.
    on_change
        Called when the gateway has connected to the controller, or cannot for another reason than
        before.
    """

    def __init__(self, safe: SafeState, connect: Connect) -> None:
        self._safe = safe
        self._connect = connect
        self._controller: Controller | None = None
        self._connecting = asyncio.Lock()
        self.in_use = asyncio.Lock()
        self.abandoned = False
        self.reached = False
        self.jogged = False
        self.run: JobRun | None = None
        self.dry_run: DryRun | None = None
        self.left_on: frozenset[int] = frozenset()
        self._secured: Controller | None = None  # last controller that was without a fault
        self.refusal: Message | None = None
        self.on_change: Callable[[], None] = lambda: None

    @property
    def controller(self) -> Controller | None:
        """The controller, also after a failure; None if there is no connection."""
        return self._controller

    @property
    def outputs_known(self) -> bool:
        """Whether it is known which outputs of the connected machine are on.

        A controller that was locked when the gateway connected has not been brought into its safe
        state since, and reports no outputs: those of an earlier gateway may still be on.
        """
        controller = self._controller
        return controller is not None and (controller.fault is None or controller is self._secured)

    @property
    def runs_job(self) -> bool:
        """Whether a job is on the machine: confirmed, running, or held."""
        return self.run is not None and not self.run.waiting

    @property
    def is_between_copies(self) -> bool:
        """Whether a job waits for its next sheet, so that nothing of it is on the controller."""
        return self.run is not None and self.run.between_copies

    @property
    def runs_dry(self) -> bool:
        """Whether the machine executes a program above the board for a person."""
        return self.dry_run is not None and not self.dry_run.activity.state.is_over

    async def connected(self) -> Controller:
        """Return a connected controller of the machine that has no fault.

        A new connection is made if there is none, or if the present connection has a fault.  The
        connection to a controller that an alarm locks is kept, because a person at the machine may
        unlock it.

        Raises
        ------
        ControllerAlarm
            An alarm locks the controller.
        ControllerError
            The controller cannot be reached.
        """
        async with self._connecting:
            controller = self._controller
            if controller is not None and controller.fault is not None:
                if _is_locked(controller):
                    raise controller.fault
                await self.close()
            if self._controller is None:
                try:
                    self._controller = await self._connect(self._safe, self.abandoned)
                except ControllerError as refused:
                    before, self.refusal = self.refusal, refused.message
                    if self.refusal != before:
                        self.on_change()
                    raise
                self.abandoned, self.reached, self.refusal = False, True, None
                self.on_change()
            if self._controller.fault is not None:
                raise self._controller.fault
            self.record_secured()
            return self._controller

    def record_secured(self) -> None:
        """Record that the connected machine was brought into its safe state, if it has no fault."""
        if self._controller is not None and self._controller.fault is None:
            self._secured = self._controller

    async def renew(self) -> None:
        """Connect again if the present connection has a fault that is no alarm.

        Such a fault is a reset at the machine between two jobs, for example.

        Raises
        ------
        ControllerError
            The controller cannot be reached, or an alarm locks it now.
        """
        controller = self._controller
        if controller is not None and controller.fault is not None and not _is_locked(controller):
            await self.connected()

    async def status(self) -> Status:
        """Return the status of the connected controller, while no operation uses it.

        Raises
        ------
        ControllerError
            An alarm locks the controller, or the controller cannot be reached.
        """
        async with self.in_use:
            status = await (await self.connected()).status()
            self.left_on = frozenset()  # a controller without a fault was brought to safety
            if status.state is State.IDLE:
                self.jogged = False
            return status

    async def verify_settings(self) -> None:
        """Compare the settings of the connected controller with those of the machine file.

        Raises
        ------
        ControllerError
            A difference is dangerous, or the controller cannot be reached.
        """
        async with self.in_use:
            controller = await self.connected()
            if isinstance(controller, ConfiguredController):
                await controller.verify_settings()

    async def release(self) -> None:
        """Bring the connected machine into its safe state, unless it cannot be reached."""
        if self._controller is not None:
            with suppress(KnifetipError, OSError):
                await self._controller.stop()

    async def close(self) -> None:
        """Close the connection; nothing is sent to the machine."""
        controller, self._controller = self._controller, None
        if controller is not None:
            await controller.close()


def _is_locked(controller: Controller) -> bool:
    """Return whether an alarm locks a controller, or it is held, so that a person must free it."""
    if not isinstance(controller, OperableController):
        return False
    if isinstance(controller.fault, ControllerOccupied):
        status = controller.last_status
        return controller.connected and status is not None and status.state is not State.IDLE
    return isinstance(controller.fault, ControllerAlarm) and controller.alarm is not None
