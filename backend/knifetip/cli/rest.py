"""Options that choose the part of a program that remains to be made on a sheet."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from typing import Annotated, Any

import typer

from knifetip.sequencing.tracks import RestChoice

#: Most tracks in a range: more than any program has.
_MOST_TRACKS = 1_000_000


@dataclass(frozen=True, slots=True)
class RestOptions:
    """Command-line options that choose the tracks of a program that remain to be made."""

    from_track: Annotated[
        int | None,
        typer.Option(
            min=1,
            help="Make the tracks from this number on, counted from 1; a track is a path of one "
            "tool between two lifts. Default: from the first track.",
        ),
    ] = None
    from_line: Annotated[
        int | None,
        typer.Option(
            min=1,
            help="Make the tracks from the one in which this line of the whole program is. "
            "Default: from the first track.",
        ),
    ] = None
    station: Annotated[
        int | None,
        typer.Option(min=0, help="Make only the tracks of this station. Default: all stations."),
    ] = None

    uncut: Annotated[
        bool,
        typer.Option(
            "--uncut",
            help="The tracks that are made again have not cut through the board. Without it, a "
            "rest that works on a piece which they have cut out is refused.",
        ),
    ] = False

    @property
    def is_given(self) -> bool:
        """Whether any of the options is given."""
        places = (self.from_track, self.from_line, self.station)
        return any(value is not None for value in places)

    def choice(self) -> RestChoice:
        """Return the choice of tracks; all other tracks count as made.

        Raises
        ------
        BadParameter
            Both a track and a line are given.
        """
        if self.from_track is not None and self.from_line is not None:
            raise typer.BadParameter("give either a track or a line", param_hint="--from-line")
        return RestChoice(
            self.from_track, self.from_line, self.station, made=True, uncut=self.uncut
        )

    def body(self) -> dict[str, Any]:
        """Return the options as fields of a request to the server."""
        return {name: value for name, value in asdict(self).items() if value is not None}


@dataclass(frozen=True, slots=True)
class NewJobOptions:
    """Command-line options for the job that makes the rest of a sheet."""

    made: Annotated[
        bool,
        typer.Option(
            "--made",
            help="All tracks that are left out are complete on the sheet, also those that the "
            "machine has not reported as executed.",
        ),
    ] = False
    made_tracks: Annotated[
        str,
        typer.Option(
            metavar="NUMBERS",
            help="Numbers of all tracks that are complete on the sheet, such as 1-4,7; the new "
            "job makes all others. Required if the machine may have executed more than it "
            "reported (state unknown of knifetip job tracks); 'none' if no track is complete.",
        ),
    ] = ""
    whole: Annotated[
        bool, typer.Option("--whole", help="Make the whole program again, on a new sheet.")
    ] = False
    copies: Annotated[
        int, typer.Option(min=1, max=1000, help="Number of sheets to make, with --whole.")
    ] = 1
    remaining: Annotated[
        bool,
        typer.Option(
            "--remaining",
            help="Make the copies that remain of a stopped batch, on new sheets; without the "
            "other choices.",
        ),
    ] = False
    release: Annotated[
        bool, typer.Option("--release", help="Queue the new job when its program is accepted.")
    ] = False

    def body(self) -> dict[str, Any]:
        """Return the options as fields of a request to the server."""
        fields = asdict(self)
        if numbers := fields.pop("made_tracks"):
            fields["made"] = track_numbers(numbers)
        return fields


def track_numbers(text: str) -> list[int]:
    """Return the numbers in a text such as ``1-4,7``; none in ``none``.

    Raises
    ------
    BadParameter
        The text is no list of numbers.
    """
    if text == "none":
        return []
    found: list[int] = []
    for part in text.split(","):
        first, _, last = part.strip().partition("-")
        if not (first.isdecimal() and (last or first).isdecimal()):
            raise typer.BadParameter(
                f"{part!r} is no number of a track", param_hint="--made-tracks"
            )
        if int(last or first) - int(first) >= _MOST_TRACKS:
            raise typer.BadParameter("too many tracks", param_hint="--made-tracks")
        found.extend(range(int(first), int(last or first) + 1))
    return found
