"""machine_properties: the plain properties of a machine, each declared once (ADR 132).

From a field with its title, description, limits and default come the attribute of the record
``Machine``, which the engines use, the key of the TOML file, the field of the REST API, the field
of the page's form, and the row of the page ``machine-files.md``.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Any, Final, Literal

from annotated_types import Le
from pydantic import Field

from knifetip.fields import LISTED
from knifetip.model.tool.base import NotNegative, Positive


def group(title: str) -> dict[str, Any]:
    """Return the keyword of a JSON Schema that names the group of a field in the page's form."""
    return {"group": title}


TABLE: Final = group("Machine and table")
HEIGHTS: Final = group("Heights and waiting times")
STATIONS: Final = group("Stations, tools and outputs")
CONTROLLER: Final = group("Controller")


@dataclass(frozen=True, slots=True, kw_only=True)
class MachineProperties:
    """The properties of a machine that are one value each.

    It is a record without pydantic; ``library.machine_table`` makes the table of the TOML file.
    """

    title: Annotated[
        str, Field(description="Name of the machine for display", json_schema_extra=TABLE)
    ]
    width: Annotated[
        Positive, Field(description="Width of the table, along X (mm)", json_schema_extra=TABLE)
    ]
    height: Annotated[
        Positive, Field(description="Height of the table, along Y (mm)", json_schema_extra=TABLE)
    ]
    dialect: Annotated[
        str,
        Field(
            title="Controller language",
            description="Name of the controller language in machine files",
            json_schema_extra=TABLE,
        ),
    ]
    feed: Annotated[
        Literal["manual", "automatic"],
        LISTED,
        Field(
            title="Loading of sheets",
            description="How sheets reach the table. manual: every job and every copy waits until "
            "the operator confirms that the sheet is on the table. automatic: the machine starts "
            "without confirmation",
            json_schema_extra=TABLE,
        ),
    ] = "manual"
    max_caliper: Annotated[
        NotNegative,
        Field(
            title="Thickest board",
            description="Greatest thickness of a board that the machine takes (mm); 0: no limit",
            json_schema_extra=TABLE,
        ),
    ] = 0.0
    squareness: Annotated[
        float,
        Field(
            ge=89.0,
            le=91.0,
            title="Angle between X and Y",
            description="Angle γ from the axis X to the axis Y as the machine is built (degrees); "
            "below 90, Y leans to the right. Programs correct it: x = X + Y cos γ and "
            "y = Y sin γ on the sheet, if the axes are at X and Y without offsets",
            json_schema_extra=TABLE,
        ),
    ] = 90.0
    setup_note: Annotated[
        str,
        Field(
            max_length=300,
            title="Preparation of the machine",
            description="What the operator does at the machine before each start, such as opening "
            "the vacuum zones; it is one of the checks before the start. Empty for none",
            json_schema_extra=TABLE,
        ),
    ] = ""
    travel_z: Annotated[
        Positive,
        Field(
            title="Travel height",
            description="Height of the tip above the mat in air moves (mm)",
            json_schema_extra=HEIGHTS,
        ),
    ]
    clearance: Annotated[
        Positive,
        Field(
            description="Height of the tip above the board where plunging begins (mm)",
            json_schema_extra=HEIGHTS,
        ),
    ]
    turn_clearance: Annotated[
        NotNegative,
        Field(
            title="Clearance in turns",
            description="Least distance of a tool from the board in turns, for jobs with the least "
            "lift (mm); 0: such jobs are refused",
            json_schema_extra=HEIGHTS,
        ),
    ] = 0.0
    into_mat: Annotated[
        NotNegative,
        Field(
            title="Depth in the mat",
            description="Depth of a through cut in the mat (mm)",
            json_schema_extra=HEIGHTS,
        ),
    ]
    creasing_base: Annotated[
        Literal["rigid", "soft"],
        LISTED,
        Field(
            title="Creasing base",
            description="Surface on which the wheels press. rigid: the cutting mat, which counts "
            "as rigid. soft: a mat of felt or rubber, which yields",
            json_schema_extra=HEIGHTS,
        ),
    ] = "rigid"
    base_yield: Annotated[
        NotNegative,
        Le(10),
        Field(
            title="Yield of a soft base",
            description="Depth by which a soft creasing base yields under a wheel (mm); a rigid "
            "base does not yield",
            json_schema_extra=HEIGHTS,
        ),
    ] = 0.0
    settle: Annotated[
        NotNegative,
        Field(
            title="Waiting time of outputs",
            description="Waiting time after an output is switched (s)",
            json_schema_extra=HEIGHTS,
        ),
    ]
    output_count: Annotated[
        int,
        Field(
            title="Number of outputs",
            ge=0,
            le=256,
            description="Number of digital outputs of the controller, for example num_dio of "
            "LinuxCNC's motmod; 0: not stated (LinuxCNC: 4)",
            json_schema_extra=STATIONS,
        ),
    ] = 0
    program_memory: Annotated[
        int,
        Field(
            title="Memory for programs",
            ge=0,
            le=10**12,
            description="Greatest size of a program that the controller takes (bytes), for one "
            "that stores the whole program before it begins; 0: no limit",
            json_schema_extra=CONTROLLER,
        ),
    ] = 0
