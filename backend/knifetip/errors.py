"""Exceptions: one class per cause, each with a message code, its arguments and a hint.

    KnifetipError
    ├── ReadError                 the file is not a usable drawing
    │   ├── NotADrawing           not a drawing file, empty, or damaged beyond repair
    │   ├── DrawingTooLarge       a limit on size, depth, entities or time is exceeded
    │   ├── UnitUnknown           the unit is neither in the file nor set by the user
    │   └── NoSuchUnit            the given name is not a unit of length
    ├── ProfileError              a classification profile cannot be read
    ├── LibraryError              no such machine, board, tool or profile, or its file is invalid
    ├── GeometryError             a shape without a valid result
    │   ├── ZeroLengthEdge        an edge too short to have an azimuth
    │   └── DegenerateArc         an arc whose radius or sweep is zero or not a number
    ├── PlanError                 the job cannot be made on this machine
    │   ├── OpenQuestions         the user must decide the unit or line types first
    │   ├── NoToolForLineType     no station of the machine makes this line type
    │   ├── FlankOutside          a V-groove so close to a cut that its flank leaves the board
    │   ├── NoRoomForBridges      a contour has no room for the bridges of the board
    │   └── TravelExceeded        a path exceeds the machine's travel
    ├── CompensationError         an edge cannot be compensated
    │   ├── CurvedGroove          a V-groove along an arc
    │   ├── EdgeTooShort          an edge shorter than its tool
    │   └── GrooveTooDeep         a V-groove deeper than the board, or a blade too wide for it
    ├── ProgramError              the emitted program is wrong
    │   ├── ProgramUnreadable     a line that the verifier cannot parse
    │   └── ProgramRefused        the verdict is outside tolerance
    ├── ControllerError           the controller or the connection to it failed
    │   ├── ControllerAlarm       the controller reported an alarm
    │   ├── ControllerRejected    the controller reported an error for a line
    │   ├── ControllerReset       the controller was reset during a job
    │   └── ControllerSilent      the controller does not answer
    ├── RequestError              a valid request that refers to nothing
    ├── ServerBusy                too many requests are waiting for a process
    ├── SettingsError             a server cannot be started with these settings
    └── JobError                  the job is not in a state that allows this
        ├── NoSuchJob             no job, drawing or other stored object with this name
        ├── WrongState            this transition is not allowed from here
        ├── StaleEpoch            a gateway that no longer owns the job
        ├── StoreError            the database cannot be used
        ├── KeyReused             an Idempotency-Key was used for another request
        ├── StaleVersion          the object was changed since the client read it
        │   └── StaleRevision         the drawing was changed since the client read it
        └── MachineBusy           another job is on this machine's table

Every error that a user can cause is one of these.  The API sends code, arguments and text as
problem+json.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from itertools import islice
from typing import Final

from knifetip.messages import Argument, Message, from_json, hint, render

#: Greatest number of questions in the message of an error.
_SHOWN: Final = 5


class KnifetipError(Exception):
    """Base class: a message with its hint, and the entities that it concerns.

    Parameters
    ----------
    code
        One of ``messages.codes.CODES``, or a complete message.
    source
        Handles of the entities, or rows of the edges, that the error concerns.
    arguments
        Arguments of the code, by name.
    """

    def __init__(
        self, code: str | Message, /, *, source: Sequence[str] = (), **arguments: Argument
    ) -> None:
        super().__init__(code)
        self.message = code if isinstance(code, Message) else Message(code, **arguments)
        self.source = tuple(source)

    def __reduce__(self) -> tuple[object, ...]:
        # Worker processes send errors to the server by pickle.
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
    """The file is not a usable drawing."""


class NotADrawing(ReadError):
    """Not a drawing file, empty, or damaged beyond repair."""


class DrawingTooLarge(ReadError):
    """A limit on size, depth, number of entities or time is exceeded."""


class UnitUnknown(ReadError):
    """The unit is neither in the file nor set by the user."""


class NoSuchUnit(ReadError):
    """The given name is not a unit of length."""


class ProfileError(KnifetipError):
    """A classification profile cannot be read."""


class LibraryError(KnifetipError):
    """There is no such machine, board, tool or profile, or its file is invalid."""


class GeometryError(KnifetipError):
    """A shape for which there is no valid result."""


class ZeroLengthEdge(GeometryError):
    """An edge of zero length, which has no direction."""

    def __init__(self, rows: Iterable[int]) -> None:
        listed = [str(row) for row in islice(rows, 10)]
        super().__init__("edge.no-length", edges=listed, source=listed)


class DegenerateArc(GeometryError):
    """An arc whose radius or sweep is zero or not a number."""


class PlanError(KnifetipError):
    """The job cannot be made on this machine."""


class OpenQuestions(PlanError):
    """The user must decide the unit or line types before the drawing can be compiled.

    Attributes
    ----------
    questions
        The open questions as JSON data.
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
    """A V-groove is so close to a cut that its flank would leave the board."""


class NoRoomForBridges(PlanError):
    """A contour has no room for the bridges that the board requires."""


class TravelExceeded(PlanError):
    """A path exceeds the travel of the machine."""


class CompensationError(KnifetipError):
    """An edge cannot be compensated for its tool."""


class CurvedGroove(CompensationError):
    """A V-groove along an arc, which a straight blade cannot follow."""


class EdgeTooShort(CompensationError):
    """An edge is shorter than its tool."""


class GrooveTooDeep(CompensationError):
    """A V-groove deeper than the board."""


class ProgramError(KnifetipError):
    """The emitted program is wrong."""


class ProgramUnreadable(ProgramError):
    """A line that the verifier cannot parse."""


class ProgramRefused(ProgramError):
    """The verdict is outside tolerance."""


class ControllerError(KnifetipError):
    """The controller or the connection to it failed."""


class ControllerAlarm(ControllerError):
    """The controller reported an alarm."""


class ControllerRejected(ControllerError):
    """The controller reported an error for a line of the program."""


class ControllerReset(ControllerError):
    """The controller was reset during a job."""


class ControllerSilent(ControllerError):
    """The controller does not answer."""


class RequestError(KnifetipError):
    """A valid request that refers to nothing, such as an edge that does not exist."""


class ServerBusy(KnifetipError):
    """Too many requests are waiting for a process; nothing of this one was stored.

    Attributes
    ----------
    seconds
        Time after which the client can try again.
    """

    def __init__(self, waiting: int, seconds: int) -> None:
        super().__init__("server.busy", waiting=waiting, seconds=seconds)
        self.seconds = seconds


class SettingsError(KnifetipError):
    """The server cannot start with these settings."""


class JobError(KnifetipError):
    """The state of the job does not permit the action."""


class NoSuchJob(JobError):
    """There is no job, drawing or other stored object with this name."""


class WrongState(JobError):
    """The transition is not permitted from the present state of the job."""


class StaleEpoch(JobError):
    """The gateway or worker no longer owns the job."""


class StoreError(JobError):
    """The database cannot be used."""


class KeyReused(JobError):
    """The Idempotency-Key was used for another request."""


class StaleVersion(JobError):
    """The object was changed since the client read it."""


class StaleRevision(StaleVersion):
    """The drawing was changed since the client read it.

    Attributes
    ----------
    revision
        Current revision of the drawing.
    """

    def __init__(self, drawing: str, revision: int, named: str) -> None:
        super().__init__("drawing.stale", drawing=drawing, revision=revision, named=named)
        self.revision = revision


class MachineBusy(JobError):
    """Another job is on the table of this machine."""
