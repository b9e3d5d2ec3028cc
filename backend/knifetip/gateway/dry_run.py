"""dry_run: a program that moves the head above the board, while a job waits for its operator.

The job keeps waiting, and nothing of the run counts as work: it is reported as the activity of the
machine, not as progress of the job.  The run stops, with the tool lifted and all outputs off, when
a person stops it, when the job is started or leaves the machine, and when the server is silent.
"""

from __future__ import annotations

from collections.abc import Callable
from contextlib import aclosing
from dataclasses import dataclass, replace

from knifetip.contract.station_report import Activity, ActivityState
from knifetip.errors import ControllerError, KnifetipError
from knifetip.gateway.controller import Controller, OverridingController, State
from knifetip.gateway.interpreter import tool_offsets
from knifetip.gateway.motion import Limits
from knifetip.gateway.stream import Progress, stream
from knifetip.messages import Message
from knifetip.model.machine import Machine, Station

#: Time between two progress reports (s).
_INTERVAL = 0.1


@dataclass(frozen=True, slots=True)
class DryProgram:
    """A program that switches nothing, with the stations whose paths it shows."""

    text: bytes
    #: number of the first line of each station's path, ascending, with the station
    stations: tuple[tuple[int, Station], ...] = ()

    def station_at(self, line: int) -> Station | None:
        """Return the station whose path the machine shows after ``line`` executed lines."""
        found = None
        for first, station in self.stations:
            if first > line + 1:
                break
            found = station
        return found


class _DryRunStopped(Exception):
    """Raised in a dry run that must stop."""


class DryRun:
    """A program above the board that the machine executes for a person.

    Parameters
    ----------
    kind
        Name of the operation that asked for it.
    job
        Id of the job that waits.
    program
        The program; it must switch nothing on and stay above the board.
    machine
        The machine.
    may_go_on
        Returns whether the job still waits at this machine.
    """

    def __init__(
        self,
        kind: str,
        job: str,
        program: DryProgram,
        machine: Machine,
        may_go_on: Callable[[], bool],
    ) -> None:
        self._program = program
        self._machine = machine
        self._may_go_on = may_go_on
        self._stopped = False
        self._held = False
        self._activity = Activity(kind, job, ActivityState.RUNNING)
        self._controller: Controller | None = None

    @property
    def activity(self) -> Activity:
        """State of the run."""
        return self._activity

    async def run(self, controller: Controller) -> None:
        """Bring the machine into its safe state, and execute the program.

        All errors of the machine end the run; they are part of its activity.
        """
        self._controller = controller
        try:
            # An output that a person has switched on must not stay on.
            await controller.stop()
            if isinstance(controller, OverridingController):
                await controller.override_feed(100)
            await self._stream(controller)
        except _DryRunStopped:
            self._end(ActivityState.STOPPED)
        except KnifetipError as error:
            self._end(ActivityState.FAILED, error.message)
        except OSError as error:
            self._end(ActivityState.FAILED, Message("gateway.system-error", reason=error))
        else:
            self._end(ActivityState.DONE)
        finally:
            self._controller = None

    async def hold(self) -> None:
        """Decelerate the machine to a stop from which ``resume`` can continue."""
        self._held = True
        await self._require_running().hold()

    async def resume(self) -> None:
        """Let the machine continue after a hold."""
        self._held = False
        await self._require_running().resume()

    async def stop(self) -> None:
        """End the run: the machine decelerates, and then comes into its safe state."""
        self._stopped = True
        if self._controller is not None:
            await self._controller.hold()

    def _require_running(self) -> Controller:
        if self._controller is None:
            raise ControllerError("dry-run.not-running")
        return self._controller

    async def _stream(self, controller: Controller) -> None:
        self._raise_if_stopped()
        updates = stream(
            self._program.text,
            controller,
            limits=Limits.from_machine(self._machine),
            tools=tool_offsets(self._machine),
            interval=_INTERVAL,
        )
        async with aclosing(updates) as progress_updates:
            async for progress in progress_updates:
                self._record(progress)
                if progress.executed < progress.lines:
                    self._raise_if_stopped()
                    if self._held and progress.state is State.RUN:
                        await controller.hold()

    @property
    def _must_stop(self) -> bool:
        return self._stopped or not self._may_go_on()

    def _raise_if_stopped(self) -> None:
        if self._must_stop:
            raise _DryRunStopped

    def _note(self, message: Message) -> None:
        """Add a message to the activity that is no failure."""
        self._activity = replace(self._activity, message=message)

    def _record(self, progress: Progress) -> None:
        station = self._program.station_at(progress.executed)
        position = None
        if progress.located:
            position = self._machine.sheet_pose(progress.position, station)
        self._activity = replace(
            self._activity,
            state=ActivityState.HELD if progress.held else ActivityState.RUNNING,
            line=progress.executed,
            progress=progress.executed / max(progress.lines, 1),
            seconds_left=progress.seconds_left,
            position=position,
            station=None if station is None else station.number,
        )

    def _end(self, state: ActivityState, message: Message | None = None) -> None:
        progress = 1.0 if state is ActivityState.DONE else self._activity.progress
        self._activity = replace(
            self._activity,
            state=state,
            progress=progress,
            seconds_left=None,
            message=message or self._activity.message,
        )
