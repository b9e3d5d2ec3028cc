"""Models for machines, their stations and tools."""

from __future__ import annotations

from typing import Literal

from pydantic import BaseModel, Field

from knifetip.model.tool import Footprint


class ToolOut(BaseModel):
    """A tool with its dimensions in mm and degrees."""

    kind: str
    dimensions: dict[str, float | bool]
    footprint: Footprint = Field(
        description="Outline of the tool for drawing, and the position of its tip"
    )


class StationOut(BaseModel):
    """A station of the head; its joint position is the programmed position plus the datum."""

    number: int
    name: str
    datum: dict[str, float]
    output: int
    tool: ToolOut


class MachineOut(BaseModel):
    """A machine of the library with its current job."""

    name: str
    title: str
    width: float
    height: float
    dialect: str
    origin: tuple[float, float]
    travel_z: float
    into_mat: float
    offset_cuts: bool = Field(
        description="Whether cuts are offset from their edge, so that corner types can be chosen"
    )
    feed: Literal["manual", "automatic"] = Field(
        description="manual: every job and every copy waits until the operator confirms that the "
        "sheet is on the table"
    )
    axes: dict[str, dict[str, float]]
    stations: list[StationOut]
    gateway: Literal["connected", "absent"]
    job: str | None = Field(description="Job on the machine's table")


class StationTool(ToolOut):
    """A tool with the names of its machine and station."""

    machine: str
    station: int
    name: str
