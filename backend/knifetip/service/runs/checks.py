"""What a person checks at the machine before it starts a job or its next copy.

Each check has an id that does not change, and a text.  A start that leaves one out is refused
(``OperatorStore.confirm``).  A machine that feeds its sheets itself states some of the checks
(``FEED_CHECKS``); the others are those of the person.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass
from typing import Final

from sqlalchemy.orm import Session

from knifetip.contract.job import LEASED, Confirmation
from knifetip.errors import LibraryError, RequestError, WrongState
from knifetip.messages import Message
from knifetip.model.machine import Machine
from knifetip.planning.registration import describe_registration
from knifetip.service.database.engine import short
from knifetip.service.database.tables import Job
from knifetip.service.library.store import LibraryStore
from knifetip.service.runs.unfinished_sheet import unfinished_sheet

#: Checks that the automatic feed of a machine states for each sheet, by their ids.
FEED_CHECKS: Final = {
    "sheet": Message("check.fed-sheet"),
    "table-clear": Message("check.fed-table"),
}
#: Greatest number of unknown ids that an error names.
_SHOWN: Final = 5


@dataclass(frozen=True, slots=True)
class Check:
    """One item that a person checks at the machine."""

    id: str  #: stable word, such as ``board`` or ``station-1``
    text: Message
    station: int | None = None  #: number of the station whose tool is checked; None for others

    @property
    def named(self) -> Message:
        """The id and the text as one message."""
        return Message("check.named", id=self.id, text=self.text)


class CheckList:
    """The checks of jobs.

    Parameters
    ----------
    library
        Repository of machines and boards, for the texts.
    """

    def __init__(self, library: LibraryStore) -> None:
        self._library = library

    def checks_of(self, session: Session, row: Job) -> list[Check]:
        """Return what a person checks before the next start of a job, in the order of the work."""
        machine = self._machine(row)
        left = unfinished_sheet(session, row)
        checks = [Check("board", self._board(row)), Check("sheet", _sheet_message(row, machine))]
        if (marks := _marks_check(row)) is not None:
            checks.append(marks)
        if left:
            checks.append(Check("unfinished-sheet", Message("check.unfinished-sheet", job=left)))
        for tool in row.tools:
            number = int(tool["station"])
            text = Message("check.station", station=number, tool=tool["name"])
            checks.append(Check(f"station-{number}", text, number))
        following = row.confirmation == Confirmation.SHEET
        table = Message("check.table-next" if following else "check.table")
        checks.append(Check("table-clear", table))
        if machine is not None and machine.setup_note:
            checks.append(Check("setup", Message("check.setup", note=machine.setup_note)))
        checks.append(Check("hands-clear", Message("check.hands")))
        if _feeds(row, machine) and row.rest is None and not left:
            return [check for check in checks if check.id not in FEED_CHECKS]
        return checks

    def require(self, session: Session, row: Job, checked: Collection[str]) -> list[Check]:
        """Return the checks of a job, all of which a person has made.

        Parameters
        ----------
        session
            Session with a transaction.
        row
            The job.
        checked
            Ids of the checks that the person has made.

        Raises
        ------
        RequestError
            ``checked`` contains an id that is none of the checks of the job.
        WrongState
            A check of the job is missing.
        """
        checks = self.checks_of(session, row)
        known = [check.id for check in checks]
        unknown = sorted(set(checked) - set(known))
        if unknown:
            raise RequestError(
                "job.unknown-checks",
                source=["checked"],
                job=row.id,
                unknown=[short(id) for id in unknown[:_SHOWN]],
                known=known,
            )
        missing = [check.named for check in checks if check.id not in checked]
        if missing:
            raise WrongState("job.not-checked", job=row.id, missing=missing)
        return checks

    def _machine(self, row: Job) -> Machine | None:
        """Return the machine of a job; None if the library has none that can be used."""
        try:
            return self._library.machine(row.machine)
        except LibraryError:
            return None

    def _board(self, row: Job) -> Message:
        try:
            board = self._library.board(row.board, row.board_version)
        except LibraryError:
            return Message("check.board", board=row.board, caliper=None)
        caliper = Message("check.caliper", caliper=board.caliper)
        return Message("check.board", board=board.title or row.board, caliper=caliper)


def event_of_feed() -> Message:
    """Return the event which records what the feed of a machine states about a sheet."""
    stated = [Message("check.named", id=id, text=text) for id, text in FEED_CHECKS.items()]
    return Message("job.stated-by-feed", checks=stated)


def events_of_checks(row: Job, checks: Sequence[Check]) -> list[Message]:
    """Return the events which record what a person has checked, and what the feed states."""
    events = [Message("job.checked", checks=[check.named for check in checks])]
    if row.feeds and FEED_CHECKS.keys().isdisjoint(check.id for check in checks):
        events.append(event_of_feed())
    return events


def _feeds(row: Job, machine: Machine | None) -> bool:
    """Return whether the machine of a job feeds the sheet of its next start itself."""
    if row.state in LEASED or row.confirmation != Confirmation.NONE:
        return row.feeds
    return machine is not None and machine.feed == "automatic"


def _marks_check(row: Job) -> Check | None:
    """Return the check of the marks of a job; None for a sheet without marks.

    Its id depends on whether they were measured: a person who states that the sheet lies as
    measured has not stated that it lies at the stops.
    """
    registration, stated = row.options.registration, describe_registration(row.options)
    if registration is None or stated is None or row.rest is not None:
        return None
    if registration.measured:
        return Check("sheet-measured", Message("check.sheet-measured", stated=stated))
    return Check("sheet-at-stops", Message("check.sheet-at-stops", stated=stated))


def _sheet_message(row: Job, machine: Machine | None) -> Message:
    """Return the text about the sheet of a job and its place on the table."""
    if row.rest is not None:
        return Message("check.begun-sheet", job=row.resumes)
    sheet = row.options.sheet
    if machine is None:
        place = None
    elif sheet is not None and sheet.size is not None:
        x, y = sheet.corner(machine.origin)
        place = Message("check.sheet-place", x=x, y=y)
    else:
        x, y = machine.origin
        place = Message("check.drawing-place", x=x, y=y)
    if row.options.registration is not None and row.options.registration.measured:
        place = None  # the sheet lies by its marks
    if sheet is None:
        return Message("check.sheet-larger", place=place)
    if sheet.size is None:
        return Message("check.sheet-outline", place=place)
    return Message("check.sheet-size", width=sheet.size[0], height=sheet.size[1], place=place)
