"""Exceptions: one class per cause, each with a message code, its arguments and a hint.

    KnifetipError
    ├── ReadError                 the file is not a usable drawing
    │   ├── NotADrawing           not a drawing file, empty, or damaged beyond repair
    │   ├── DrawingTooLarge       a limit on size, depth, entities or time is exceeded
    │   ├── UnitUnknown           the unit is neither in the file nor set by the user
    │   └── NoSuchUnit            the given name is not a unit of length
    ├── ProfileError              a classification profile cannot be read
    ├── LibraryError              no such machine, board, tool or profile, or its file is invalid
    ├── ImpossibleCarton          a carton style cannot have these dimensions
    ├── PieceRefused              a test piece cannot be made, or a measure is not plausible
    ├── GeometryError             a calculation has no valid result for a shape
    │   ├── ZeroLengthEdge        an edge of zero length, which has no direction
    │   └── DegenerateArc         an arc whose radius or sweep is zero or not a number
    ├── EditRefused               an edit of the lines of a drawing is not possible
    ├── PlanError                 the job cannot be made on this machine
    │   ├── OpenQuestions         the user must answer questions first
    │   ├── NoToolForLineType     no station of the machine makes this line type
    │   ├── FlankOutside          a V-groove whose flank would leave the board
    │   ├── NoRoomForBridges      a contour has no room for the bridges of the board
    │   └── TravelExceeded        a path exceeds the machine's travel
    ├── CompensationError         an edge cannot be compensated
    │   ├── CurvedGroove          a V-groove along an arc that cannot be cut
    │   ├── EdgeTooShort          an edge shorter than its tool
    │   └── GrooveTooDeep         a V-groove too deep for the board or its free ends
    ├── ProgramError              the emitted program is wrong
    │   └── ProgramUnreadable     a line that the verifier cannot parse
    ├── ControllerError           the controller or the connection to it failed
    │   ├── ConnectionLost        the connection to a controller is lost or cannot be made
    │   ├── ControllerAlarm       the controller reported an alarm
    │   ├── ControllerOccupied    the controller does something that is no job of this gateway
    │   ├── ControllerRejected    the controller reported an error for a line
    │   │   └── CheckRefused      … in the check run of a program, before anything is executed
    │   ├── ControllerReset       the controller was reset during a job
    │   ├── ControllerSilent      the controller does not answer
    │   ├── NoSuchController      no controller can ever be reached at the address
    │   └── OperationExpired      an operation of a person was not executed in time
    ├── RequestError              a valid request that cannot be applied
    │   └── UnsupportedMedia      a body of a content type that the operation does not read
    ├── AccessDenied              the sender of a request lacks the scope that it needs
    ├── SignInRefused             a wrong name or password
    ├── SignInSlowDown            too many sign-ins have failed
    ├── ServerBusy                too many requests are waiting for a process
    ├── SettingsError             a server cannot be started with these settings
    └── JobError                  the state of the job does not permit the action
        ├── NotFound              no stored object, such as a job, has the name
        ├── WrongState            the state of the object does not permit the change
        ├── StaleEpoch            a report on a job that the sender no longer owns
        ├── GatewayRefused        the server does not accept the key of a gateway
        ├── StoreError            the database cannot be used
        │   └── ContentLost           a stored file or program is missing or altered
        ├── KeyReused             an Idempotency-Key of another request
        ├── StaleVersion          the object was changed since the client read it
        │   └── StaleRevision         the drawing was changed since the client read it
        └── MachineBusy           another job is on the table of the machine

Every error that a user can cause is one of these.  The API sends code, arguments and text as
problem+json.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from itertools import islice
from typing import Final, SupportsInt

from knifetip.messages import Argument, Message, from_json, hint, render

#: Greatest number of edges of an error of a compile.
MOST_EDGES: Final = 1000
#: Greatest number of questions in the message of an error.
_SHOWN: Final = 5


class KnifetipError(Exception):
    """Base class of errors: a message with a hint, and references to the objects that it concerns.

    Parameters
    ----------
    code
        A message code, one of ``messages.codes.CODES``, or a complete ``Message``.
    source
        The objects that the error concerns, as text: handles of entities in the drawing, or the
        path of a field.
    at_edges
        Rows of the edges that the error concerns.
    arguments
        Values by name that are inserted into the text of the message code.

    Attributes
    ----------
    edges
        Rows of the edges that the error concerns, each once.  Stages of a compile raise errors with
        rows of their own input; ``pipeline`` replaces them by rows of the drawing.
    """

    def __init__(
        self,
        code: str | Message,
        /,
        *,
        source: Sequence[str] = (),
        at_edges: Iterable[SupportsInt] = (),
        **arguments: Argument,
    ) -> None:
        super().__init__(code)
        self.message = code if isinstance(code, Message) else Message(code, **arguments)
        self.source = tuple(source)
        self.edges = tuple(dict.fromkeys(int(row) for row in at_edges))

    def __reduce__(self) -> tuple[object, ...]:
        # Worker processes send errors to the server by pickle.
        return (_rebuild, (type(self), self.message, self.source, self.__dict__))

    @property
    def text(self) -> str:
        """The fault and its location, in English."""
        return render(self.message)

    @property
    def hint(self) -> str:
        """The action that solves the problem, in English; "" if there is none."""
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
    """Raised when a file is not a usable drawing."""


class NotADrawing(ReadError):
    """Raised when a file is not a drawing, is empty, or is damaged beyond repair."""


class DrawingTooLarge(ReadError):
    """Raised when a drawing exceeds a limit on size, nesting depth, number of entities or time."""


class UnitUnknown(ReadError):
    """Raised when the unit of a drawing is neither in the file nor set by the user."""


class NoSuchUnit(ReadError):
    """Raised when a given name is not a unit of length."""


class ProfileError(KnifetipError):
    """Raised when a classification profile cannot be read."""


class LibraryError(KnifetipError):
    """Raised when a machine, board, tool or profile does not exist or its file is invalid."""


class ImpossibleCarton(KnifetipError):
    """Raised when a carton style cannot have the dimensions; ``source`` names the parameter."""


class PieceRefused(KnifetipError):
    """Raised when a test piece cannot be made or a measure of it is not plausible.

    ``source`` names the measure.
    """


class GeometryError(KnifetipError):
    """Raised when a geometric calculation has no valid result for a shape, such as an arc."""


class ZeroLengthEdge(GeometryError):
    """Raised for edges of zero length, which have no direction."""

    def __init__(self, rows: Iterable[int]) -> None:
        listed = [int(row) for row in islice(rows, 10)]
        super().__init__("edge.no-length", edges=listed)


class DegenerateArc(GeometryError):
    """Raised for an arc whose radius or sweep is zero or not a number."""


class EditRefused(KnifetipError):
    """Raised when a user's edit of the geometry of a drawing is not possible."""


class PlanError(KnifetipError):
    """Raised when a job cannot be made on a machine."""


class OpenQuestions(PlanError):
    """Raised when the user must answer questions before a drawing can be compiled.

    Attributes
    ----------
    questions
        The questions that are not yet answered, as JSON data.
    """

    def __init__(self, questions: Sequence[dict[str, object]]) -> None:
        super().__init__(
            "drawing.open-questions",
            count=len(questions),
            questions=[from_json(question) for question in questions[:_SHOWN]],
        )
        self.questions = list(questions)


class NoToolForLineType(PlanError):
    """Raised when no station of the machine makes a line type."""


class FlankOutside(PlanError):
    """Raised when a V-groove is so close to a cut that its flank would leave the board."""


class NoRoomForBridges(PlanError):
    """Raised when a contour has no room for its bridges, the uncut lengths that hold the part.

    The board requires a number of bridges on the contour.
    """


class TravelExceeded(PlanError):
    """Raised when a path exceeds the travel of the machine."""


class CompensationError(KnifetipError):
    """Raised when tool compensation, or the calibration of a tool, is not possible.

    Tool compensation computes the head's path from the path of the tool's tip.
    """


class CurvedGroove(CompensationError):
    """Raised for a V-groove along an arc that cannot be cut.

    Either the board does not permit V-grooves along arcs, or the radius of the arc is too small.
    """


class EdgeTooShort(CompensationError):
    """Raised when an edge is too short, or its bend too tight, for the dimensions of its tool."""


class GrooveTooDeep(CompensationError):
    """Raised when a V-groove is as deep as the board is thick, or its blade would cut too far.

    The blade cuts too far if it passes the end of a groove inside a panel by more than the board
    permits.
    """


class ProgramError(KnifetipError):
    """Raised when a program that was written for a machine is wrong."""


class ProgramUnreadable(ProgramError):
    """Raised when the verifier cannot parse a program line."""


class ControllerError(KnifetipError):
    """Raised when a controller or the connection to it fails."""


class ControllerAlarm(ControllerError):
    """Raised when the controller reports an alarm."""


class ControllerOccupied(ControllerError):
    """Raised when a controller is held or busy, so that a person must free it first."""


class ControllerRejected(ControllerError):
    """Raised when the controller reports an error for a program line."""


class CheckRefused(ControllerRejected):
    """Raised when a controller refuses a program in its check run, before anything is executed."""


class ControllerReset(ControllerError):
    """Raised when the controller was reset during a job."""


class ConnectionLost(ControllerError):
    """Raised when the connection to a controller is lost or cannot be made."""


class ControllerSilent(ControllerError):
    """Raised when the controller does not answer."""


class NoSuchController(ControllerError):
    """Raised when no controller can ever be reached at an address, so trying again is useless.

    The address is invalid, or something else than a controller answers there.
    """


class OperationExpired(ControllerError):
    """An operation that a person requested at the machine was not executed in time."""


class RequestError(KnifetipError):
    """Raised when a valid request cannot be applied, such as an override that selects no edge."""


class UnsupportedMedia(RequestError):
    """The body of a request has another content type than those of its route."""


class AccessDenied(KnifetipError):
    """The sender of a request lacks the scope that the request needs."""


class SignInRefused(KnifetipError):
    """The name or the password of a sign-in is wrong."""


class SignInSlowDown(KnifetipError):
    """Too many sign-ins have failed; ``seconds`` is the time to wait (s)."""

    def __init__(self, seconds: int) -> None:
        super().__init__("sign-in.slow-down", seconds=seconds)
        self.seconds = seconds


class ServerBusy(KnifetipError):
    """Raised when too many requests wait for a process; no data of the request was stored.

    Attributes
    ----------
    seconds
        Time after which the client can try again (s).
    """

    def __init__(self, waiting: int, seconds: int) -> None:
        super().__init__("server.busy", waiting=waiting, seconds=seconds)
        self.seconds = seconds


class SettingsError(KnifetipError):
    """Raised when the server cannot start with the given settings."""


class JobError(KnifetipError):
    """Raised when the state of a job does not permit an action."""


class NotFound(JobError):
    """Raised when there is no job, drawing or other stored object with a given name."""


class WrongState(JobError):
    """Raised when the present state of a job or another stored object does not permit a change."""


class StaleEpoch(JobError):
    """Raised when a gateway or worker reports on a job that it no longer owns.

    The epoch is a number that increases with each new owner of a job.  The report contains an older
    number than the job.
    """


class GatewayRefused(JobError):
    """The server refuses the key of a gateway: missing, invalid, or without the scope gateway."""


class StoreError(JobError):
    """Raised when the database cannot be used, or when a server cannot start.

    A server cannot start, for example, if its network address is already in use.
    """


class ContentLost(StoreError):
    """Raised when a stored file, program or other large value is missing or altered."""


class KeyReused(JobError):
    """Raised when an Idempotency-Key was already used for another request."""


class StaleVersion(JobError):
    """Raised when a stored object has been changed since the client read it."""


class StaleRevision(StaleVersion):
    """Raised when a drawing has been changed since the client read it.

    Attributes
    ----------
    revision
        Current revision of the drawing.
    """

    def __init__(self, drawing: str, revision: int, named: str) -> None:
        super().__init__("drawing.stale", drawing=drawing, revision=revision, named=named)
        self.revision = revision


class MachineBusy(JobError):
    """Raised when another job is on the table of the machine."""
