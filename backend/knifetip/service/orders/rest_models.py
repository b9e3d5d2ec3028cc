"""Models for the tracks of a program, and for jobs that make the rest of a sheet."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import BaseModel, Field, model_validator

from knifetip.fields import LISTED, field_error
from knifetip.service.http.models import WHOLE, Copies, JsonBody

_Number = Annotated[int, Field(ge=1, le=2**31 - 1), WHOLE]


class RestIn(JsonBody):
    """The part of a program that a new job makes.

    Without a track, a line or a station, the new job makes all tracks that the machine has not
    reported as executed.  A track that was begun is made again from its start.
    """

    from_track: _Number | None = Field(
        default=None, description="Number of the first track; null if `from_line` states the place"
    )
    from_line: _Number | None = Field(
        default=None,
        description="Program line; the new job begins with the track in which this line is",
    )
    station: Annotated[int, Field(ge=0, le=255), WHOLE] | None = Field(
        default=None,
        description="Make only the tracks of the station with this number, all of them or those "
        "from the given place on; null for all stations",
    )
    whole: bool = Field(
        default=False,
        description="Make the whole program again, on a new sheet; excludes the fields above",
    )
    remaining: bool = Field(
        default=False,
        description="Make the copies that remain of a batch which was stopped (`remaining_copies` "
        "of the job), on new sheets; excludes all other fields but `release`. Also for a job that "
        "made the rest of a sheet of the batch",
    )
    made: bool | Annotated[list[_Number], Field(max_length=100_000)] = Field(
        default=False,
        description="What the operator has found on the sheet. A list: the numbers of all tracks "
        "that are complete; the new job makes all others. It is required if the machine may have "
        "executed more than it reported (`stopped_at.certain` is false), and excludes a track, a "
        "line or a station. true: all tracks that are left out are complete. false: tracks that "
        "the machine has not reported as executed must not be left out",
    )
    uncut: bool = Field(
        default=False,
        description="Whether the operator has found that the tracks which are made again have not "
        "cut through the board, for example with a blunt knife. If false, a program that works on "
        "a piece which their executed lines have cut out is refused",
    )
    copies: Copies = Field(
        default=1, description="Number of sheets to make; 1 unless `whole` is set"
    )
    release: bool = Field(
        default=False, description="Whether to queue the job as soon as its program is accepted"
    )

    @model_validator(mode="after")
    def _one_choice(self) -> RestIn:
        places = (self.from_track, self.from_line, self.station)
        given = sum(place is not None for place in places)
        both = self.from_track is not None and self.from_line is not None
        stated = not isinstance(self.made, bool)
        others = given or self.whole or stated or self.made or self.copies > 1
        if (
            both
            or (self.whole and (given or stated))
            or (stated and given)
            or (self.copies > 1 and not self.whole)
            or (self.remaining and others)
        ):
            raise field_error("field.rest-choice")
        return self


class TrackOut(BaseModel):
    """A track of a program: a path of one tool between two lifts."""

    number: int = Field(description="Number of the track, from 1, in the order of the program")
    station: int = Field(description="Number of the station")
    stage: int = Field(
        description="Number of the operation, from 1: the work of one tool on lines of one type, "
        "and cuts inside a contour before those around them. A chosen order (`work_order`) cannot "
        "change the order of the operations. 0 if it is not known: in programs of older versions "
        "and for the rest of a sheet"
    )
    first_line: int = Field(description="First program line of the track, from 1")
    last_line: int = Field(description="Last program line of the track")
    edges: list[int] = Field(description="Rows of the edges that it makes, counted from 0")
    start: tuple[float, float] = Field(
        description="X, Y of the head axis at the start, on the sheet (mm)"
    )
    end: tuple[float, float] = Field(description="X, Y of the head axis at the end (mm)")
    state: Annotated[Literal["cut", "begun", "uncut", "unknown"], LISTED] = Field(
        description="cut: the machine executed all its lines. begun: it executed some of them. "
        "uncut: it executed none. unknown: nobody observed whether the machine made the track; the "
        "operator must state it to continue the sheet"
    )
