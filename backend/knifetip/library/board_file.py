"""board_file: a board's TOML."""

from __future__ import annotations

from typing import Final, Literal

from pydantic import Field, ValidationInfo, field_validator

from knifetip.library.files import Table
from knifetip.model.board import Board, Deflection
from knifetip.model.tool.base import NotNegative, Positive

#: More passes along one groove than this, or bridges nearer than this (mm), are a slip of the pen.
_MOST_PASSES: Final = 50
_LEAST_SPACING: Final = 10.0


class DeflectionTable(Table):
    """How far a tool gives way in this board."""

    x: NotNegative = Field(description="the most in X (mm)")
    y: NotNegative = Field(description="the most in Y (mm)")


class BoardFile(Table):
    """One material in one thickness."""

    title: str
    material: str = Field(description="greyboard, corrugated or folding boxboard")
    caliper: Positive = Field(description="thickness (mm)")
    grain: float = Field(description="azimuth of flute or grain on the sheet (degrees)")
    crease_along: Positive = Field(description="depth of a crease along flute or grain (mm)")
    crease_across: Positive = Field(description="depth of a crease across it (mm)")
    end_clearance: NotNegative = Field(description="a crease stops this far before its end (mm)")
    groove_depth: Positive = Field(description="of a V-groove below the top face (mm)")
    groove_overcut: NotNegative = Field(description="the most by which a groove overruns (mm)")
    half_cut_depth: Positive = Field(description="below the top face (mm)")
    perforation: list[Positive] = Field(
        min_length=2, max_length=2, description="length of cut and of gap (mm)"
    )
    short_crease: Literal["press", "refuse"] = Field(
        description="press it in place at the depth that fits, or refuse it"
    )
    bridge_width: NotNegative = Field(0.0, description="of a nick that holds the part (mm)")
    bridge_spacing: NotNegative = Field(0.0, description="the longest way between two (mm)")
    double_crease: NotNegative = Field(0.0, description="between its lines (mm); 0: single")
    groove_pass: NotNegative = Field(0.0, description="deepest pass of a groove (mm); 0: one")
    groove_curve: NotNegative = Field(0.0, description="how far chords may leave an arc (mm)")
    deflection: dict[str, DeflectionTable] = Field({}, description="by name of the station")

    @field_validator("crease_along", "crease_across", "groove_depth", "half_cut_depth")
    @classmethod
    def _within(cls, value: float, info: ValidationInfo) -> float:
        caliper = info.data.get("caliper")
        if caliper is not None and value >= caliper:
            raise ValueError(f"is {value}, and must be less than the caliper {caliper}")
        return value

    @field_validator("groove_pass")
    @classmethod
    def _few_passes(cls, value: float, info: ValidationInfo) -> float:
        if value and info.data.get("groove_depth", 0.0) / value > _MOST_PASSES:
            raise ValueError(f"is {value}, and would take more than {_MOST_PASSES} passes")
        return value

    @field_validator("bridge_spacing")
    @classmethod
    def _far_apart(cls, value: float) -> float:
        if 0.0 < value < _LEAST_SPACING:
            raise ValueError(f"is {value}, and must be {_LEAST_SPACING:g} or more, or 0")
        return value

    def record(self, name: str) -> Board:
        """Return the board."""
        given = self.model_dump(exclude={"perforation", "deflection"})
        cut, gap = self.perforation
        return Board(
            name=name,
            **given,
            perforation=(cut, gap),
            deflection=tuple(
                Deflection(tool, most.x, most.y) for tool, most in self.deflection.items()
            ),
        )
