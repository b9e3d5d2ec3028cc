"""Models for machines, their stations and tools."""

from __future__ import annotations

from typing import Literal

from pydantic import BaseModel, Field

from knifetip.model.tool import Footprint


class ToolOut(BaseModel):
    """A tool with its dimensions in mm and degrees."""

    kind: str = Field(description="Kind of the tool, such as knife or crease-wheel")
    dimensions: dict[str, float | bool] = Field(description="Dimensions by name")
    footprint: Footprint = Field(
        description="Outline of the tool for drawing, and the position of its tip"
    )


class StationOut(BaseModel):
    """A tool station on the head of a machine.

    With this station, the joint position of the machine is the programmed position plus the datum.
    """

    number: int = Field(description="Number in the T word of programs")
    name: str
    datum: dict[str, float] = Field(
        description="Offset of the tool by axis: x, y, z (mm) and c (degrees)"
    )
    output: int = Field(
        description="Digital output of the piston that lowers the station; -1 for none"
    )
    tool: ToolOut


class MachineOut(BaseModel):
    """A machine of the library with its current job."""

    name: str
    title: str
    width: float = Field(description="Width of the table along X (mm)")
    height: float = Field(description="Height of the table along Y (mm)")
    dialect: str = Field(description="Name of the controller language")
    origin: tuple[float, float] = Field(
        description="Position of the lower left corner of a drawing on the table (mm)"
    )
    travel_z: float = Field(description="Height of the tip above the mat in air moves (mm)")
    into_mat: float = Field(description="Depth of a through cut in the mat (mm)")
    offset_cuts: bool = Field(
        description="Whether cuts are offset from their edge, so that corner types can be chosen"
    )
    feed: Literal["manual", "automatic"] = Field(
        description="manual: every job and every copy waits until the operator confirms that the "
        "sheet is on the table"
    )
    axes: dict[str, dict[str, float]] = Field(
        description="Travel, velocity and acceleration by axis (mm or degrees, s)"
    )
    stations: list[StationOut]
    gateway: Literal["connected", "absent"] = Field(
        description="Whether a gateway for the machine is connected"
    )
    job: str | None = Field(description="Job on the machine's table")


class StationTool(ToolOut):
    """A tool with the names of its machine and station."""

    machine: str = Field(description="Name of the machine")
    station: int = Field(description="Number of the station")
    name: str = Field(description="Name of the station")
