"""Models for machines, their stations and tools."""

from __future__ import annotations

from typing import Literal

from pydantic import BaseModel, ConfigDict, Field

from knifetip.library.machine_table import MachineTable
from knifetip.model.edge_choice import MadeType


class FootprintOut(BaseModel):
    """Data to draw a tool on the board: the shape of its mark, and the position of its tip.

    Some fields refer to C, which is the direction in which the tool points.
    """

    model_config = ConfigDict(from_attributes=True)

    shape: Literal["line", "disc", "groove", "wheel"] = Field(
        description="line: a mark without width. disc: a disc about the tip. groove: a flank that "
        "widens with the depth. wheel: the rim of a wheel"
    )
    radius: float = Field(description="Radius of the disc or wheel (mm); 0 for other shapes")
    width: float = Field(description="Width of the wheel's rim (mm); 0 for other shapes")
    slope: float = Field(
        description="Width of a groove's flank per depth (mm per mm); 0 for other shapes"
    )
    blade: float = Field(
        description="Length of the cutting edge, from the tip forward along C (mm); 0 for none"
    )
    left: float = Field(
        description="Distance of the tip from the head's axis, to the left of C (mm)"
    )
    behind: float = Field(
        description="Distance of the tip from the head's axis, backwards along C (mm)"
    )
    any_height: bool = Field(
        description="Whether the mark is the same at every height of the tip, as with a laser"
    )


class ToolOut(BaseModel):
    """A tool with its dimensions in mm and degrees."""

    kind: str = Field(description="Kind of the tool, such as knife or crease-wheel")
    dimensions: dict[str, float | bool] = Field(
        description="Dimensions by name (mm; degrees for angles), or true and false for properties"
    )
    footprint: FootprintOut = Field(
        description="Shape of the tool's mark on the board and position of its tip, for drawing "
        "the tool"
    )


class CarriageOut(BaseModel):
    """A carriage on the gantry of a machine, which carries stations along Y."""

    number: int = Field(description="Number of the carriage, from 1")
    letters: str = Field(
        description="Letters of its axes in programs: X, Y, Z and C, or for example X, V, Z and A "
        "as XVZA"
    )
    park: float = Field(description="Position of its Y while another carriage is in use (mm)")


class ZoneOut(BaseModel):
    """A keep-out zone: a box on the table, such as a clamp, that no tool may touch."""

    model_config = ConfigDict(from_attributes=True)

    name: str = Field(description="Name of the zone")
    x: float = Field(description="Position of the left edge on the table (mm)")
    y: float = Field(description="Position of the lower edge on the table (mm)")
    width: float = Field(description="Size along X (mm)")
    height: float = Field(description="Size along Y (mm)")
    top: float = Field(description="Height of the top of the zone above the mat (mm)")


class ToolStationOut(BaseModel):
    """A tool station on the head of a machine.

    While the station is in use, its datum (the offset of its tool) is added to the programmed
    position of each axis.
    """

    number: int = Field(description="Number of the station in the T words of programs")
    name: str = Field(description="Name of the station, such as the tool's name on the machine")
    carriage: int = Field(description="Number of the carriage that carries the station")
    datum: dict[str, float] = Field(
        description="Offset of the tool by axis: x, y, z (mm) and c (degrees)"
    )
    output: int = Field(
        description="Digital output of the piston that lowers the station; -1 for none"
    )
    envelope: float = Field(
        description="Radius of the holder about the axis of the station, for keep-out zones (mm); "
        "0: the tool only"
    )
    life: float = Field(
        description="Length that the tool may work in the board according to the file of the "
        "machine (m); 0 for no limit"
    )
    spindle: Literal["M3", "M4", ""] = Field(
        description="Word that switches the oscillation or the spindle of the tool on; empty if it "
        "has none"
    )
    spindle_speed: int = Field(description="S word with it; 0 if there is none")
    tool: ToolOut = Field(description="Tool in the station")
    line_types: list[MadeType] = Field(
        description="Line types for whose edges the station may be chosen: its tool is of the kind "
        "that makes them, or a part of a combi line, on this machine"
    )


class MachineOut(MachineTable):  # type: ignore[misc, valid-type]  # made by pydantic
    """A machine of a user or of knifetip's library, with its current job."""

    # The answer is built by the server; unlike a file, it has all properties.
    model_config = ConfigDict(
        strict=False,
        extra="ignore",
        frozen=False,
        json_schema_serialization_defaults_required=True,
    )

    name: str = Field(description="Name of the machine, to be used in requests")
    version: int = Field(
        description="Version of a user's machine; 0 for a machine of knifetip's library"
    )
    language: str = Field(description="Name of the controller language for display")
    origin: tuple[float, float] = Field(
        description="Position of the lower left corner of a drawing on the table (mm)"
    )
    offset_cuts: bool = Field(
        description="Whether cuts are offset from their edge, so that corner types can be chosen"
    )
    feed_override: tuple[int, int] = Field(
        description="Least and greatest feed override while a program runs (%), if the controller "
        "has one"
    )
    axes: dict[str, dict[str, float]] = Field(
        description="Limits of the axes x, y, z and c, and of those of further carriages, such as "
        "v and a: `low` and `high` are the lowest and highest joint position (mm or degrees), "
        "`velocity` (mm/s or degrees/s) and `acceleration` (mm/s² or degrees/s²) are maxima"
    )
    carriages: list[CarriageOut] = Field(description="Carriages of the machine, usually one")
    min_distance: float | None = Field(
        description="Least distance of two carriages along Y (mm); null for one carriage"
    )
    zones: list[ZoneOut] = Field(description="Keep-out zones on the table; empty if there are none")
    stations: list[ToolStationOut] = Field(description="Tool stations on the head of the machine")
    gateway: Literal["connected", "absent"] = Field(
        description="Whether a gateway for the machine is connected"
    )
    job: str | None = Field(
        description="Id of the job whose board is on the machine's table; null if there is none"
    )


class StationTool(ToolOut):
    """A tool with the names of its machine and station."""

    machine: str = Field(description="Name of the machine")
    station: int = Field(description="Number of the station")
    name: str = Field(description="Name of the station")
