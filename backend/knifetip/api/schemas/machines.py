"""machines: what is said of machines and their tools."""

from __future__ import annotations

from typing import Literal

from pydantic import BaseModel, Field

from knifetip.model.tool import Footprint


class ToolOut(BaseModel):
    """A tool with the dimensions that the engines use."""

    kind: str
    dimensions: dict[str, float | bool]
    footprint: Footprint = Field(description="what to draw of it, and where its tip lies")


class StationOut(BaseModel):
    """A station: joint position = programmed position + datum."""

    number: int
    name: str
    datum: dict[str, float]
    output: int
    tool: ToolOut


class MachineOut(BaseModel):
    """A machine of the library and what is on it now."""

    name: str
    title: str
    width: float
    height: float
    dialect: str
    origin: tuple[float, float]
    travel_z: float
    into_mat: float
    offset_cuts: bool = Field(
        description="cuts run beside their line, so that the types of corners can be chosen"
    )
    feed: Literal["manual", "automatic"] = Field(
        description="manual: every job and every copy waits until an operator has confirmed that "
        "its sheet lies on the table"
    )
    axes: dict[str, dict[str, float]]
    stations: list[StationOut]
    gateway: Literal["connected", "absent"]
    job: str | None


class StationTool(ToolOut):
    """A tool and where it is mounted."""

    machine: str
    station: int
    name: str
