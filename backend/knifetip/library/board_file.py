"""board_file: the pydantic model of the TOML file of a board."""

from __future__ import annotations

from typing import Annotated, Final, Literal, TypeAlias

from annotated_types import Gt, Le
from pydantic import Field, ValidationInfo, field_validator

from knifetip.fields import LISTED, PartTable, Table, field_error
from knifetip.model.board import Board, Deflection, ToolLimits
from knifetip.model.machine_properties import group
from knifetip.model.tool import KINDS
from knifetip.model.tool.base import NotNegative, Positive

#: Largest number of passes along one groove, and least spacing of bridges (mm).  Values beyond them
#: are refused, because they are probably typing errors.
_MOST_PASSES: Final = 50
_LEAST_SPACING: Final = 10.0

#: An angle by which a board can fold (degrees).
FoldAngle: TypeAlias = Annotated[float, Gt(0), Le(180)]


# Groups of the page's form, in their order.
_BOARD: Final = group("Board")
_CREASES: Final = group("Creases")
_BENDS: Final = group("Bends of cuts")
_LIMITS: Final = group("Limits of tools")
_GROOVES: Final = group("V-grooves")
_HALF_CUTS: Final = group("Half-cuts and perforations")
_BRIDGES: Final = group("Bridges")
_DEFLECTION: Final = group("Deflection of cutters")


class DeflectionTable(PartTable):
    """The TOML table with the deflection of one tool in the board, in X and Y (mm).

    The deflection is the greatest distance by which the cutting force pushes the tool off its path.
    """

    x: NotNegative = Field(description="greatest deflection in X (mm)")
    y: NotNegative = Field(description="greatest deflection in Y (mm)")


class LimitsTable(PartTable):
    """The TOML table with limits for the tools of one kind in the board."""

    feed: NotNegative = Field(
        0.0, title="Feed rate", description="greatest feed (mm/min); 0: no limit"
    )
    step: NotNegative = Field(
        0.0, description="greatest depth of one pass of a cutter or a knife (mm); 0: no limit"
    )
    slow_radius: NotNegative = Field(
        0.0,
        description="radius of a curve below which the feed of a knife is lower in proportion to "
        "the radius (mm); 0: nowhere",
    )
    blade: Annotated[Literal["", "fixed", "oscillating"], LISTED] = Field(
        "",
        description="kind of knife that suits the board: a fixed or an oscillating blade; empty: "
        "any",
    )


class BoardFile(Table):
    """The fields of the TOML file of a board: one material in one thickness."""

    title: str = Field(json_schema_extra=_BOARD)
    material: str = Field(
        json_schema_extra=_BOARD,
        description="corrugated, folding boxboard, solid board, greyboard or foam board",
    )
    caliper: Positive = Field(json_schema_extra=_BOARD, description="thickness (mm)")
    grain: float = Field(
        title="Direction of flute or grain",
        json_schema_extra=_BOARD,
        description="direction of flute or grain on the sheet (degrees)",
    )
    crease_base: Annotated[Literal["", "rigid", "soft"], LISTED] = Field(
        "",
        title="Creasing base",
        json_schema_extra=_CREASES,
        description="creasing base for which the depths of creases are given; only on a soft one "
        "may they exceed the thickness; empty: any",
    )
    crease_along: Positive = Field(
        json_schema_extra=_CREASES, description="depth of a crease along flute or grain (mm)"
    )
    crease_across: Positive = Field(
        json_schema_extra=_CREASES, description="depth of a crease across flute or grain (mm)"
    )
    end_clearance: NotNegative = Field(
        json_schema_extra=_CREASES,
        description="distance between the end of a crease and the end of its line (mm)",
    )
    groove_depth: Positive = Field(
        json_schema_extra=_GROOVES, description="depth of a V-groove below the top face (mm)"
    )
    groove_overcut: NotNegative = Field(
        json_schema_extra=_GROOVES, description="largest overcut of a V-groove (mm)"
    )
    half_cut_depth: Positive = Field(
        title="Half-cut depth",
        json_schema_extra=_HALF_CUTS,
        description="depth of a half-cut below the top face (mm)",
    )
    perforation: list[Positive] = Field(
        min_length=2,
        max_length=2,
        json_schema_extra={**_HALF_CUTS, "itemTitles": ["Length of cuts", "Length of gaps"]},
        description="length of cuts and of gaps (mm)",
    )
    short_crease: Annotated[Literal["press", "refuse"], LISTED] = Field(
        title="Creases shorter than the wheel",
        json_schema_extra=_CREASES,
        description="whether a crease too short for the wheel is pressed at a smaller depth, "
        "or refused",
    )
    bridge_width: NotNegative = Field(
        0.0, json_schema_extra=_BRIDGES, description="width of a bridge that holds the part (mm)"
    )
    bridge_spacing: NotNegative = Field(
        0.0, json_schema_extra=_BRIDGES, description="largest distance between two bridges (mm)"
    )
    double_crease: NotNegative = Field(
        0.0,
        json_schema_extra=_CREASES,
        description="distance between the two lines of a double crease (mm); 0: single",
    )
    groove_pass: NotNegative = Field(
        0.0,
        title="Depth of one groove pass",
        json_schema_extra=_GROOVES,
        description="largest depth of one pass of a groove (mm); 0: one pass",
    )
    groove_curve: NotNegative = Field(
        0.0,
        title="Tolerance of curved grooves",
        json_schema_extra=_GROOVES,
        description="largest distance between an arc and its chords in a groove (mm)",
    )
    groove_shift: NotNegative = Field(
        0.3,
        title="Shift of grooves beside cuts",
        json_schema_extra=_GROOVES,
        description="largest shift of a V-groove away from a cut beside it (mm); 0: none",
    )
    fold_angle: FoldAngle = Field(
        90.0,
        json_schema_extra=_GROOVES,
        description="angle by which the board must fold at a V-groove (degrees)",
    )
    crease_tolerance: Positive = Field(
        0.25,
        title="Tolerance of bent creases",
        json_schema_extra=_CREASES,
        description="largest distance at which the wheel may press beside a bent crease (mm)",
    )
    cut_tolerance: Positive = Field(
        0.1,
        title="Tolerance of bent cuts",
        json_schema_extra=_BENDS,
        description="largest distance between a bent cut in the top face and its line (mm)",
    )
    least_radius: NotNegative = Field(
        0.0,
        title="Least radius of a bend",
        json_schema_extra=_BENDS,
        description="smallest radius of a bend that a knife cuts (mm); 0: no limit",
    )
    deflection: dict[str, DeflectionTable] = Field(
        {},
        json_schema_extra={**_DEFLECTION, "propertyNames": {"title": "Name of the station"}},
        description="deflection of each tool, by the name of its station",
    )
    limits: dict[str, LimitsTable] = Field(
        {},
        json_schema_extra={
            **_LIMITS,
            "propertyNames": {"title": "Kind of tool", "enum": [kind.name for kind in KINDS]},
        },
        description="limits of each kind of tool, such as knife or cutter, in the board",
    )

    @field_validator("crease_along", "crease_across", "groove_depth", "half_cut_depth")
    @classmethod
    def _below_caliper(cls, value: float, info: ValidationInfo) -> float:
        caliper = info.data.get("caliper")
        is_crease = info.field_name in ("crease_along", "crease_across")
        if is_crease and info.data.get("crease_base") == "soft":
            return value
        if caliper is not None and value >= caliper:
            raise field_error("field.not-less-than-caliper", value=value, caliper=caliper)
        return value

    @field_validator("groove_pass")
    @classmethod
    def _limit_passes(cls, value: float, info: ValidationInfo) -> float:
        if value and info.data.get("groove_depth", 0.0) / value > _MOST_PASSES:
            raise field_error("field.too-many-passes", value=value, most=_MOST_PASSES)
        return value

    @field_validator("bridge_spacing")
    @classmethod
    def _check_spacing(cls, value: float) -> float:
        if 0.0 < value < _LEAST_SPACING:
            raise field_error("field.spacing", value=value, least=_LEAST_SPACING)
        return value

    @field_validator("limits")
    @classmethod
    def _check_kinds(cls, value: dict[str, LimitsTable]) -> dict[str, LimitsTable]:
        words = [kind.name for kind in KINDS]
        for word in value:
            if word not in words:
                raise field_error("field.not-one-of", value=word, known=words)
        return value

    def record(self, name: str) -> Board:
        """Return the board that the file describes, with the name ``name``."""
        fields = self.model_dump(exclude={"perforation", "deflection", "limits"})
        cut, gap = self.perforation
        return Board(
            name=name,
            **fields,
            perforation=(cut, gap),
            deflection=tuple(
                Deflection(tool, most.x, most.y) for tool, most in self.deflection.items()
            ),
            limits=tuple(
                ToolLimits(kind, most.feed, most.step, most.slow_radius, most.blade)
                for kind, most in self.limits.items()
            ),
        )
