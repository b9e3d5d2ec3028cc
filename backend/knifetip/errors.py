"""Every way that knifetip says no: one class to a cause, each with place, measure and hint.

    KnifetipError
    ├── ReadError                 the bytes are not a drawing that can be used
    │   ├── NotADrawing           not a DXF at all, empty, or damaged past repair
    │   ├── DrawingTooLarge       a limit on size, depth, entities or time was met
    │   ├── UnitUnknown           the file does not say its unit and nobody else did
    │   └── NoSuchUnit            no unit of length has the name that was given
    ├── ProfileError              a classification profile cannot be read
    ├── LibraryError              no such machine, board, tool or profile, or its file is wrong
    ├── GeometryError             a shape that has no answer
    │   ├── ZeroLengthEdge        an edge too short to have an azimuth
    │   └── DegenerateArc         an arc that is no arc
    ├── PlanError                 the job cannot be made on this machine
    │   ├── OpenQuestions         edges or units that somebody must decide first
    │   ├── NoToolForLineType     no station of the machine makes this line type
    │   ├── FlankOutside          a V-groove so near a cut that its flank leaves the board
    │   ├── NoRoomForBridges      a contour has no places for the bridges that the board asks for
    │   └── TravelExceeded        a head would leave the machine's travel
    ├── CompensationError         an engine refuses an edge
    │   ├── CurvedGroove          a V-groove along an arc
    │   ├── EdgeTooShort          shorter than the tool that should work it
    │   └── GrooveTooDeep         a V-groove deeper than the board, or a blade too wide for it
    ├── ProgramError              the emitted program is wrong
    │   ├── ProgramUnreadable     a line that the verifier cannot parse
    │   └── ProgramRefused        the verdict is outside tolerance
    ├── ControllerError           the controller, or the line to it, failed
    │   ├── ControllerAlarm       it answered alarm
    │   ├── ControllerRejected    it answered error to a line
    │   ├── ControllerReset       it was reset in the middle of a job
    │   └── ControllerSilent      it stopped answering
    ├── RequestError              a request that can be read, but is about nothing
    ├── ServerBusy                too many requests wait for a process already
    ├── SettingsError             a server cannot be started with these settings
    └── JobError                  the job is not in a state that allows this
        ├── NoSuchJob             no job, drawing or other thing of this name
        ├── WrongState            this transition is not allowed from here
        ├── StaleEpoch            a gateway that no longer owns the job
        ├── StoreError            the database cannot be used
        ├── KeyReused             an Idempotency-Key that came with another request before
        ├── StaleVersion          somebody else changed it since it was looked at
        │   └── StaleRevision         a drawing was changed since the request was made for it
        └── MachineBusy           another job is on this machine's table

Everything that a user can cause is one of these.  The API sends code, arguments and text as
problem+json.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from itertools import islice
from typing import Final

from knifetip.messages import Argument, Message, from_json, hint, render

#: The most questions that an error quotes.
_SHOWN: Final = 5


class KnifetipError(Exception):
    """What is wrong and where, what to do about it, and which edges it concerns.

    Parameters
    ----------
    code
        One of ``messages.codes.CODES``; a message that is already made is taken as it is.
    source
        Handles of the entities, or rows of the edges, that it concerns.
    arguments
        Those of the code, by name.
    """

    def __init__(
        self, code: str | Message, /, *, source: Sequence[str] = (), **arguments: Argument
    ) -> None:
        super().__init__(code)
        self.message = code if isinstance(code, Message) else Message(code, **arguments)
        self.source = tuple(source)

    def __reduce__(self) -> tuple[object, ...]:
        # Errors cross from the compile process to the server.
        return (_rebuild, (type(self), self.message, self.source, self.__dict__))

    @property
    def text(self) -> str:
        """What is wrong and where, in English."""
        return render(self.message)

    @property
    def hint(self) -> str:
        """What the user can do, in English."""
        return hint(self.message)

    def __str__(self) -> str:
        return f"{self.text} {self.hint}".strip()


def _rebuild(
    kind: type[KnifetipError],
    message: Message,
    source: tuple[str, ...],
    attributes: Mapping[str, object],
) -> KnifetipError:
    error = kind.__new__(kind)
    KnifetipError.__init__(error, message, source=source)
    error.__dict__.update(attributes)
    return error


class ReadError(KnifetipError):
    """The bytes are not a drawing that can be used."""


class NotADrawing(ReadError):
    """Not a DXF at all, empty, or damaged past repair."""


class DrawingTooLarge(ReadError):
    """A limit on size, depth, number of entities or time was met."""


class UnitUnknown(ReadError):
    """The file does not say its unit, and nobody else did."""


class NoSuchUnit(ReadError):
    """No unit of length has the name that was given."""


class ProfileError(KnifetipError):
    """A classification profile cannot be read."""


class LibraryError(KnifetipError):
    """There is no such machine, board, tool or profile, or its file is wrong."""


class GeometryError(KnifetipError):
    """A shape that has no answer."""


class ZeroLengthEdge(GeometryError):
    """An edge too short to have an azimuth."""

    def __init__(self, rows: Iterable[int]) -> None:
        listed = [str(row) for row in islice(rows, 10)]
        super().__init__("edge.no-length", edges=listed, source=listed)


class DegenerateArc(GeometryError):
    """An arc whose radius or sweep is zero or not a number."""


class PlanError(KnifetipError):
    """The job cannot be made on this machine."""


class OpenQuestions(PlanError):
    """Edges or units that somebody must decide before anything is cut.

    ``questions`` are the questions themselves, ready for JSON.
    """

    def __init__(self, questions: Sequence[dict[str, object]]) -> None:
        super().__init__(
            "drawing.open-questions",
            count=len(questions),
            questions=[from_json(question) for question in questions[:_SHOWN]],
        )
        self.questions = list(questions)


class NoToolForLineType(PlanError):
    """No station of the machine makes this line type."""


class FlankOutside(PlanError):
    """A V-groove runs so near a cut that its flank would leave the board."""


class NoRoomForBridges(PlanError):
    """A contour has no places for the bridges that the board asks for."""


class TravelExceeded(PlanError):
    """A head would leave the travel of the machine."""


class CompensationError(KnifetipError):
    """An engine refuses an edge."""


class CurvedGroove(CompensationError):
    """A V-groove along an arc, which a straight blade cannot follow."""


class EdgeTooShort(CompensationError):
    """An edge shorter than the tool that should work it."""


class GrooveTooDeep(CompensationError):
    """A V-groove deeper than the board."""


class ProgramError(KnifetipError):
    """The emitted program is wrong."""


class ProgramUnreadable(ProgramError):
    """A line that the verifier cannot parse."""


class ProgramRefused(ProgramError):
    """The verdict is outside tolerance."""


class ControllerError(KnifetipError):
    """The controller, or the line to it, failed."""


class ControllerAlarm(ControllerError):
    """The controller answered with an alarm."""


class ControllerRejected(ControllerError):
    """The controller answered with an error to a line of the program."""


class ControllerReset(ControllerError):
    """The controller was reset in the middle of a job."""


class ControllerSilent(ControllerError):
    """The controller stopped answering."""


class RequestError(KnifetipError):
    """A request that can be read, but is about nothing."""


class ServerBusy(KnifetipError):
    """Too many requests wait for a process already; nothing of this one was kept.

    ``seconds`` is after how long to try again.
    """

    def __init__(self, waiting: int, seconds: int) -> None:
        super().__init__("server.busy", waiting=waiting, seconds=seconds)
        self.seconds = seconds


class SettingsError(KnifetipError):
    """A server cannot be started with these settings."""


class JobError(KnifetipError):
    """The job is not in a state that allows this."""


class NoSuchJob(JobError):
    """No job, drawing or other stored thing of this name."""


class WrongState(JobError):
    """This transition is not allowed from the state that the job is in."""


class StaleEpoch(JobError):
    """A gateway that no longer owns the job."""


class StoreError(JobError):
    """The database cannot be used."""


class KeyReused(JobError):
    """An Idempotency-Key that came with another request before."""


class StaleVersion(JobError):
    """Somebody else changed it since it was looked at."""


class StaleRevision(StaleVersion):
    """The drawing was changed since it was looked at.

    ``revision`` is the drawing's now.
    """

    def __init__(self, drawing: str, revision: int, named: str) -> None:
        super().__init__("drawing.stale", drawing=drawing, revision=revision, named=named)
        self.revision = revision


class MachineBusy(JobError):
    """Another job is on the table of this machine."""
