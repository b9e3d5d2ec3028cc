"""job_run: the state of a claimed job while the gateway runs it."""

from __future__ import annotations

import asyncio
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from knifetip.gateway.motion import Pose
from knifetip.gateway.time_left import TimeLeft
from knifetip.messages import Message, with_text

#: Commands with which a held machine goes on.
_GOES_ON = ("resume", "end")


@dataclass(frozen=True, slots=True)
class Lease:
    """The server's answer to a claim: the job, its program, its number of copies and its lease.

    The lease is a time in seconds.  The gateway loses the job if it sends no heartbeat for this
    time.
    """

    job: str
    epoch: int
    lease: float
    program: str
    sha256: str
    copies: int
    confirm: bool  #: the operator must confirm before anything is sent to the machine
    traceparent: str = ""  #: context of the trace of the order; "" for none
    seconds: float = 0.0  #: stated duration of a copy (s); 0 if it is not stated

    @classmethod
    def from_answer(cls, answer: Mapping[str, Any]) -> Lease:
        return cls(
            str(answer["job"]),
            int(answer["epoch"]),
            float(answer["lease"]),
            str(answer["program"]),
            str(answer["sha256"]),
            int(answer.get("copies", 1)),
            bool(answer.get("confirm", False)),
            str(answer.get("traceparent", "")),
            float(answer.get("seconds", 0.0)),
        )


class JobWithdrawn(Exception):
    """Raised when the server has assigned the job to another gateway, or has ended the job."""


class JobCancelled(Exception):
    """Raised when the operator has cancelled the job."""


class JobReturned(Exception):
    """Raised when a gateway returns a job to the queue, because the machine cannot start it."""

    def __init__(self, cause: Message) -> None:
        super().__init__(cause)
        self.cause = cause


class JobRun:
    """State of a claimed job: its progress for the heartbeats, and the server's commands for it."""

    def __init__(self, claim: Lease, now: float) -> None:
        self.claim = claim
        self.line = 0
        self.copies_done = 0
        self.copy_running = False  #: a copy is running, of which ``line`` lines are executed
        #: most lines of it that the machine may have executed after it stopped; None if not known
        self.line_at_most: int | None = None
        self.waiting = (
            claim.confirm
        )  #: the operator has not confirmed yet; nothing is sent to the machine
        self.begins = False  #: the heartbeats announce that the program begins
        self.begin_stored = False  #: the server has answered one of these heartbeats
        self.begun = False  #: a line of the program may have been executed
        self.held = False
        self.between_copies = False  #: waits for the next sheet; the controller holds nothing
        self.position: Pose | None = None
        self.output = -1  #: output that is on, which lowers the station in use; -1 for none
        self.station: int | None = None  #: number of the station in use; None for none
        self.time_left = TimeLeft(claim.seconds)
        self.seconds_left = self.time_left.expected  #: of the present copy, or of the next one
        self.requested = ""  #: hold, resume, end or ""
        #: increases whenever an earlier request to go on no longer counts: see ``begin_phase``
        self.phase = 0
        self.awaits_end = False  #: a person must confirm the end of the program
        self.cancelled = False
        self.stale = False
        self.lease_end = now + claim.lease  #: end of the lease on the local clock
        self.answered = asyncio.Event()

    @property
    def is_waiting(self) -> bool:
        """Whether the job waits for its operator, and the gateway still owns it."""
        return self.waiting and not self.stale and not self.cancelled

    def heartbeat(self) -> dict[str, object]:
        return {
            "job": self.claim.job,
            "epoch": self.claim.epoch,
            "line": self.line,
            "copies_done": self.copies_done,
            "held": self.held,
            "waiting": self.waiting,
            "position": self.position,
            "seconds_left": self.seconds_left,
            "phase": self.phase,
            "awaits_end": self.awaits_end,
            "begun": self.begins,
        }

    def begin_phase(self) -> None:
        """Ignore requests to resume, and to end the program, that were made until now.

        This method is called when the machine continues after a hold, and when the gateway itself
        begins to wait for the operator.  A request that the server repeats because it was not
        reached in between does not count for the next hold.
        """
        self.phase += 1
        if self.requested in _GOES_ON:
            self.requested = ""

    def apply_answer(self, command: str, *, held: bool, phase: int, begun: bool = False) -> None:
        """Store the command with which the server answered a heartbeat.

        Parameters
        ----------
        command
            ``start`` (the operator has confirmed the job), ``cancel``, ``hold``, ``resume`` or
            ``end`` (a person has seen the end of the program).  ``wait`` (the job is not confirmed
            yet) and ``continue`` change nothing.
        held
            Whether the heartbeat reported that the machine is held; if False, ``resume`` and
            ``end`` are ignored.
        phase
            Phase that the heartbeat reported; ``resume`` and ``end`` are ignored in any other one.
        begun
            Whether the heartbeat announced that the program begins.
        """
        self.begin_stored = self.begin_stored or begun
        if command == "cancel":
            self.cancelled = True
        elif command == "start":
            self.waiting = False
        elif command == "hold" or (command in _GOES_ON and held and phase == self.phase):
            self.requested = command
        self.answered.set()

    def raise_if_withdrawn(self) -> None:
        """Raise ``JobWithdrawn`` or ``JobCancelled`` if the job was withdrawn or cancelled."""
        if self.stale:
            raise JobWithdrawn
        if self.cancelled:
            raise JobCancelled


@dataclass(frozen=True, slots=True)
class JobEnd:
    """The end of a job as it is reported to the server: outcome, cause and progress."""

    job: str
    epoch: int
    outcome: str
    cause: Message | None
    line: int  #: executed lines of the running copy; 0 between two copies
    copies_done: int  #: under this lease
    position: Pose | None = None  #: on the sheet, where the machine stopped; None if not known
    station: int | None = None  #: number of the station in use where the machine stopped
    line_at_most: int | None = None  #: most lines that may have been executed; None if not known

    @classmethod
    def from_run(cls, run: JobRun, outcome: str, cause: Message | None) -> JobEnd:
        line = run.line if run.copy_running or outcome == "done" else 0
        stopped = run.copy_running and outcome != "done"
        return cls(
            run.claim.job,
            run.claim.epoch,
            outcome,
            cause,
            line,
            run.copies_done,
            run.position if stopped else None,
            run.station if stopped else None,
            run.line_at_most if stopped else line,
        )

    def report(self) -> dict[str, object]:
        """Return the JSON body of the request that reports the end of the job to the server."""
        return {
            "job": self.job,
            "epoch": self.epoch,
            "outcome": self.outcome,
            "why": "" if self.cause is None else with_text(self.cause),
            "line": self.line,
            "line_at_most": self.line_at_most,
            "copies_done": self.copies_done,
            "position": self.position,
            "station": self.station,
        }
