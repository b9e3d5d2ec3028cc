"""Options of a job: what a user may choose besides the drawing, the machine and the board.

Each option is declared once, as a field with its type, limits, default and description.  From the
field come the fields of the REST API, the stored column, the command-line option and the field of
the page (see the how-to page "Add an option of an order").
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated, Literal

from pydantic import Field

from knifetip.fields import LISTED, Table
from knifetip.model.corners import Corners
from knifetip.model.edge_choice import Choices, EdgeChoice, EdgeRow, LineTypeChoice
from knifetip.model.registration import Registration
from knifetip.model.sheet import Sheet


class ContourStart(EdgeChoice):
    """Where the closed cuts with some edges begin, and in which direction they run."""

    types = ("cut", "half-cut")

    at: float | None = Field(
        default=None,
        ge=0.0,
        le=1.0,
        title="Cut begins here",
        description="Point of the edge at which its closed cut begins, as a fraction of the length "
        "of the edge: 0 for its start as drawn, 1 for its end; null for the planner's choice",
        json_schema_extra={"unit": "fraction"},
    )
    direction: Annotated[Literal["free", "forward", "reverse"], LISTED] = Field(
        default="free",
        title="Direction",
        description="Direction of the closed cut along the edge. forward: from the start of the "
        "edge as drawn to its end. reverse: from its end to its start. free: the planner's choice",
        json_schema_extra={"unit": "direction"},
    )


class CutDepth(LineTypeChoice):
    """In how many passes some cuts and half-cuts are made, and how deep."""

    types = ("cut", "half-cut")
    passes: int | None = Field(
        default=None,
        ge=1,
        le=10,
        title="Passes",
        description="Number of passes, all of the same increment; null for as many as the tool "
        "needs",
    )
    depth: float | None = Field(
        default=None,
        gt=0.0,
        le=100.0,
        title="Depth from top",
        description="Depth of the last pass below the top face of the board (mm), up to the depth "
        "of a cut into the underlay. A cut that is not deeper than the board is thick is a "
        "half-cut, and parts are not separated there; null for the depth of the line type",
        json_schema_extra={"unit": "mm"},
    )


class CreaseDepth(LineTypeChoice):
    """How deep the wheel presses some creases."""

    types = ("crease", "combi")
    depth: float = Field(
        gt=0.0,
        le=100.0,
        title="Depth of the crease",
        description="Depth of the crease below the top face of the board (mm), less than the "
        "board is thick, instead of the depth of the board along or across the grain",
        json_schema_extra={"unit": "mm"},
    )


class EdgeTool(LineTypeChoice):
    """The tool that makes some edges."""

    station: int | None = Field(
        default=None,
        ge=1,
        le=255,
        title="Tool",
        description="Number of the station of the machine whose tool makes the edges: a tool of "
        "the same kind as the one that makes this line type otherwise. For combi lines it is the "
        "crease wheel or the knife. Null for the planner's choice",
        json_schema_extra={"unit": "station"},
    )


class EdgeCorner(LineTypeChoice):
    """How a cutter or laser goes round the corners at the ends of some edges."""

    of_cutters = True
    types = ("cut",)

    type: Annotated[Literal["usual", "auto", "B", "C", "D"], LISTED] = Field(
        default="usual",
        title="Corner type",
        description="Type of the outer corners at which the tool arrives along the edges. B: an "
        "arc. C: straight lines with a stop at each bend. D: a line, an arc and a line. auto: the "
        "fastest type. usual: the type of the job",
        json_schema_extra={"unit": "corner"},
    )
    k: float | None = Field(
        default=None,
        ge=0.01,
        le=0.99,
        title="Parameter k of type D",
        description="Parameter k of these corners where they have type D, without a unit: near 0 "
        "is like type B, near 1 like type C; null for the `k` of the job",
    )


class ContourLead(LineTypeChoice):
    """How a cutter or laser comes to the contours of some edges, and leaves them."""

    of_cutters = True
    types = ("cut",)

    length: float | None = Field(
        default=None,
        gt=0.0,
        le=50.0,
        title="Length of the lead-in",
        description="Length of the straight lead-in (mm), greater than the radius of the tool; "
        "null for that of the tool",
        json_schema_extra={"unit": "mm"},
    )
    approach: float | None = Field(
        default=None,
        ge=-90.0,
        le=90.0,
        title="Angle to the contour",
        description="Angle of the lead-in to the contour (degrees). 90: perpendicular to it, from "
        "the waste. 0: along its line. Negative: round a corner on an arc, such as -90; where no "
        "corner has room for it, perpendicular. Null for that of the tool",
        json_schema_extra={"unit": "°"},
    )


class EdgeFeed(LineTypeChoice):
    """The feed with which some edges are cut."""

    types = ("cut", "half-cut", "perforation")
    factor: float = Field(
        default=1.0,
        ge=0.1,
        le=1.0,
        title="Feed factor",
        description="Factor of the feed of the tool along the edges, 0.1 to 1, besides the feed "
        "factor of the job: less than 1 where the board tears",
    )


class BridgeAt(EdgeChoice):
    """A bridge (nick) at a place of an edge, which holds the part until it is broken out."""

    own_form = True
    types = ("cut",)

    at: float = Field(
        default=0.5,
        ge=0.0,
        le=1.0,
        title="Middle",
        description="Middle of the bridge, as a fraction of the length of the edge: 0 for its "
        "start as drawn, 1 for its end",
        json_schema_extra={"unit": "fraction"},
    )
    width: float = Field(
        default=0.5,
        ge=0.1,
        le=20.0,
        title="Width",
        description="Width of the bridge in the top face (mm)",
        json_schema_extra={"unit": "mm"},
    )


class VerifiedOptions(Table):
    """The options that determine what the verifier expects of a program."""

    sheet: Sheet | None = Field(
        default=None,
        description="Sheet that was cut to size before the job; the operator must load this "
        "sheet. Null if the sheet may be larger than the drawing",
    )
    registration: Registration | None = Field(
        default=None,
        description="Marks of a printed sheet, by which the job follows the print: they are "
        "measured on the table before the start. Null for a sheet without marks",
    )
    feed_factor: float = Field(
        default=1.0,
        ge=0.1,
        le=1.0,
        title="Feed factor",
        description="Factor of the feeds of all tools in the board, 0.1 to 1: less than 1 for "
        "board that tears or for a worn tool. A laser at a lower feed cuts deeper",
    )
    warp: float = Field(
        default=0.0,
        ge=0.0,
        le=50.0,
        title="Warp of the board (mm)",
        description="Height by which warped board may rise from the mat (mm): above the board, "
        "tools plunge, turn and travel higher by it. 0 for board that lies flat",
    )
    contour_starts: Choices[ContourStart] = Field(
        default=(),
        title="Start and direction",
        description="Starts and directions of closed cuts; empty for the planner's choice. Of "
        "several for one edge the last counts",
    )
    cut_depths: Choices[CutDepth] = Field(
        default=(),
        title="Passes and depth",
        description="Passes and depths of cuts and half-cuts; empty for those of tool and board. "
        "Of several for one edge the last counts, and one for the edge before one for its line "
        "type",
    )
    crease_depths: Choices[CreaseDepth] = Field(
        default=(),
        title="Depth of creases",
        description="Depths of creases; empty for those of the board. Of several for one edge the "
        "last counts, and one for the edge before one for its line type",
    )
    edge_tools: Choices[EdgeTool] = Field(
        default=(),
        title="Tool of edges",
        description="Stations whose tools make edges; empty for the planner's choice. Of several "
        "for one edge the last counts, and one for the edge before one for its line type. A "
        "cutter or laser that is chosen for one edge of a contour makes the whole contour, and "
        "creases that continue each other have one wheel",
        json_schema_extra={
            "help": "Creases that continue each other need the same wheel. A cutter or laser makes "
            "the whole contour of an edge."
        },
    )
    contour_leads: Choices[ContourLead] = Field(
        default=(),
        title="Lead-in of contours",
        description="Lead-ins of contours that a cutter or laser makes; empty for those of the "
        "tool. The lead-out is alike. A choice for one edge is for its whole contour. A lead-in "
        "without room is halved or left out, as that of the tool is. Of several choices for one "
        "edge the last counts, and one for the edge before one for its line type",
        json_schema_extra={
            "help": "For cutters and lasers, for the whole contour of an edge. Without room for "
            "it, the lead-in is halved or left out."
        },
    )
    edge_feeds: Choices[EdgeFeed] = Field(
        default=(),
        title="Feed of edges",
        description="Feed factors of cuts, half-cuts and perforations; empty for the feeds of the "
        "tools. Of several for one edge the last counts, and one for the edge before one for its "
        "line type",
    )
    bridges: Choices[BridgeAt] = Field(
        default=(),
        title="Bridges",
        description="Bridges on outlines of parts, one for each edge and entry; an outline with "
        "such a bridge has no others. Empty for the bridges of the board",
    )
    work_order: tuple[EdgeRow, ...] = Field(
        default=(),
        strict=False,  # JSON has lists
        max_length=5000,
        title="Order of the work",
        description="Rows of edges in the drawing, counted from 0, in the order in which the "
        "tracks along them are begun; empty for the shortest way. Tracks without such an edge come "
        "where the way is short. The order of the operations stays: creases, V-grooves, half-cuts, "
        "perforations, cuts; one tool after the other; and what lies inside a contour before the "
        "contour. An order that contradicts this is refused",
    )

    @property
    def head_notes(self) -> tuple[str, ...]:
        """Comments about the options at the head of a program."""
        return (
            *([self.sheet.note] if self.sheet else []),
            *([self.registration.note] if self.registration else []),
            *([f"feed factor {self.feed_factor:g}"] if self.feed_factor != 1.0 else []),
            *([f"warp {self.warp:g}"] if self.warp else []),
        )


class JobOptions(VerifiedOptions):
    """All options of a job."""

    corners: Corners | None = Field(
        default=None,
        description="Corner types, for routers and lasers only; null for the fastest types",
    )
    edge_corners: Choices[EdgeCorner] = Field(
        default=(),
        title="Corners of edges",
        description="Corner types by edge, for routers and lasers only; empty for those of "
        "`corners`. A corner has the type of the edge along which the tool arrives; the tool has "
        "the waste on its left, so it runs clockwise round a part. Corners in `corners.at` have "
        "the types there. Of several choices for one edge the last counts, and one for the edge "
        "before one for its line type",
        json_schema_extra={
            "help": "A corner has the type of the edge along which the tool arrives: it runs "
            "clockwise round parts and anticlockwise in holes. A type for a single corner counts "
            "more."
        },
    )
    lift: Annotated[Literal["clearance", "least"], LISTED] = Field(
        default="clearance",
        description="Height of the tool above the board in turns. clearance: the clearance of the "
        "machine. least: the `turn_clearance` of the machine where that is faster; only for board "
        "that lies flat",
    )
    program_note: str = Field(
        default="",
        max_length=60,
        title="Note in the program",
        description="Comment at the head of the program, for a person at the controller, such as "
        "the side of the board that lies up. Letters that controllers do not take become spaces; "
        "empty for none",
    )

    def with_measured(self, places: Sequence[tuple[float, float]]) -> JobOptions:
        """Return the options with marks that were measured at some places (mm).

        Without places, the sheet lies at the origin of the machine.  Options of a sheet without
        marks are returned unchanged.
        """
        if self.registration is None:
            return self
        registration = self.registration.model_copy(update={"measured": tuple(places)})
        return self.model_copy(update={"registration": registration})

    @property
    def head_notes(self) -> tuple[str, ...]:
        """Comments about the options at the head of a program."""
        return (*super().head_notes, *([self.program_note] if self.program_note else []))
