"""dry_programs: prepares the programs of dry runs from the program of the job that waits."""

from __future__ import annotations

import asyncio

from knifetip.contract.operations import Operation, OperationName
from knifetip.errors import ControllerError
from knifetip.gateway.dry_program import (
    check_dry_program,
    dry_program,
    frame_program,
    station_starts,
    work_box,
)
from knifetip.gateway.dry_run import DryProgram
from knifetip.gateway.interpreter import tool_offsets
from knifetip.gateway.job_run import Lease
from knifetip.gateway.job_server import JobServer
from knifetip.gateway.motion import Pose
from knifetip.model.machine import Machine


class DryPrograms:
    """Prepares programs that move above the board, and keeps the last program of a job.

    The preparation of a long program may take longer than an operation may wait.  The dry program
    is therefore kept, so that the same operation can begin at once when it is asked for again.

    Parameters
    ----------
    server
        Server with the programs of jobs.
    machine
        The machine.
    """

    def __init__(self, server: JobServer, machine: Machine) -> None:
        self._server = server
        self._machine = machine
        self._job: tuple[str, bytes] = ("", b"")  # SHA-256 and text of the last program
        self._dry: tuple[tuple[str, float, Pose] | None, DryProgram] = (None, DryProgram(b""))

    async def prepare(self, operation: Operation, claim: Lease, start: Pose) -> DryProgram:
        """Return the program of an operation.

        Parameters
        ----------
        operation
            The operation, ``dry_run`` or ``frame``.
        claim
            The job that waits.
        start
            Present pose of the axes.

        Raises
        ------
        KnifetipError
            The program of the job cannot be fetched, or cannot be run above the board.
        """
        if self._job[0] != claim.sha256:
            self._job = (claim.sha256, await self._server.program(claim))
        text = self._job[1]
        if operation.name is OperationName.FRAME:
            return await asyncio.to_thread(self._frame, operation, text, start)
        key = (claim.sha256, operation.share, start)
        if self._dry[0] != key:
            self._dry = (key, await asyncio.to_thread(self._make_dry, text, operation.share, start))
        return self._dry[1]

    def _make_dry(self, text: bytes, share: float, start: Pose) -> DryProgram:
        dry = dry_program(text, self._machine, share)
        check_dry_program(dry, text, self._machine, start, tool_offsets(self._machine))
        return DryProgram(dry, station_starts(text, self._machine))

    def _frame(self, operation: Operation, text: bytes, start: Pose) -> DryProgram:
        box = operation.box or work_box(text, self._machine, start, tool_offsets(self._machine))
        if box is None:
            raise ControllerError("dry-run.no-work")
        starts = station_starts(text, self._machine)
        station = starts[0][1] if starts else self._machine.stations[0]
        program = frame_program(box, station, self._machine, operation.share)
        return DryProgram(program, ((1, station),))
