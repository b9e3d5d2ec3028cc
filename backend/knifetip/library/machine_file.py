"""machine_file: the pydantic models of the TOML file of a machine and of its tools.

The models of tools are generated from the classes in ``knifetip.model.tool``, so a new kind of tool
needs no change here.
"""

from __future__ import annotations

import dataclasses
from functools import reduce
from itertools import pairwise
from operator import or_
from typing import Annotated, Any, Final, Literal, get_type_hints

from pydantic import (
    BeforeValidator,
    Field,
    ValidationInfo,
    create_model,
    field_validator,
    model_validator,
)

from knifetip.errors import LibraryError
from knifetip.fields import LISTED, PartTable, field_error
from knifetip.languages.registry import find_language, language_names
from knifetip.library.machine_table import MachineTable
from knifetip.model.machine import (
    NO_HEADING,
    Axis,
    Carriage,
    Gantry,
    Machine,
    Station,
    Zone,
    has_spindle,
)
from knifetip.model.machine_properties import CONTROLLER, STATIONS, TABLE, group
from knifetip.model.tool import KINDS, Kind, Tool
from knifetip.model.tool.base import NotNegative, Positive

#: Feed override with which every program begins (%).
_NOMINAL: Final = 100

AXES: Final = group("Axes and travel")


class AxisTable(PartTable):
    """The TOML table of one axis of a machine: travel, velocity and acceleration.

    The units are mm, mm/s and mm/s²; for the rotary axis, degrees replace millimetres.
    """

    low: float = Field(description="least joint position")
    high: float = Field(description="greatest joint position")
    velocity: Positive = Field(description="greatest velocity, per second")
    acceleration: Positive = Field(description="greatest acceleration, per second squared")

    @field_validator("high")
    @classmethod
    def _above_low(cls, value: float, info: ValidationInfo) -> float:
        low = info.data.get("low")
        if low is not None and value <= low:
            raise field_error("field.not-above-low", value=value, low=low)
        return value

    def axis(self) -> Axis:
        """Return the axis that the table describes."""
        return Axis(self.low, self.high, self.velocity, self.acceleration)


class HeadingAxis(AxisTable):
    """The TOML table of the axis that rotates the tools: its letter, travel, velocity and
    acceleration.
    """

    letter: Annotated[Literal["A", "B", "C"], LISTED] = Field(
        "C", description="letter of the axis in programs"
    )


class Axes(PartTable):
    """The TOML table of the four axes of a machine: X, Y, Z, and C, which rotates the tools.

    If the machine has several carriages, they are the axes of the first carriage.
    """

    x: AxisTable
    y: AxisTable
    z: AxisTable
    c: HeadingAxis | None = Field(
        None,
        description="heading of the tool head (degrees); without it, the machine turns no tool",
    )

    @property
    def letter(self) -> str:
        """Letter of the axis that rotates the tools; empty if there is none."""
        return self.c.letter if self.c else ""


class LetteredAxis(AxisTable):
    """The TOML table of an axis of a further carriage: its letter, travel, velocity and
    acceleration.
    """

    letter: Annotated[Literal["A", "B", "U", "V", "W"], LISTED] = Field(
        description="letter of the axis in programs; X, Y, Z and the letter of c belong to [axes]"
    )


class CarriageTable(PartTable):
    """The TOML table of a further carriage of the gantry, with its own axes.

    Y of all carriages has the same zero and the same direction.
    """

    park: float = Field(
        title="Parking position",
        description="position of y while another carriage is in use, at the carriage's own end of "
        "the gantry (mm)",
    )
    y: LetteredAxis
    z: LetteredAxis | None = Field(
        None, description="without it, the carriage shares the Z of the first carriage"
    )
    c: LetteredAxis = Field(description="heading of the tools of the carriage (degrees)")

    @field_validator("y")
    @classmethod
    def _reaches_park(cls, value: LetteredAxis, info: ValidationInfo) -> LetteredAxis:
        _check_park(info.data.get("park"), value)
        return value

    def record(self, first: Carriage) -> Carriage:
        """Return the carriage that the table describes; ``first`` is the first carriage."""
        z = self.z.axis() if self.z else first.axes[2]
        letter_z = self.z.letter if self.z else "Z"
        return Carriage(
            (first.axes[0], self.y.axis(), z, self.c.axis()),
            f"X{self.y.letter}{letter_z}{self.c.letter}",
            self.park,
        )


class GantryTable(PartTable):
    """The TOML table of a gantry with several carriages.  The first carriage has the axes of the
    table ``[axes]``.
    """

    min_distance: Positive = Field(
        title="Least distance of carriages",
        description="least distance along Y between the positions of two carriages (mm)",
    )
    park: float = Field(
        title="Parking position",
        description="position of y of the first carriage while another is in use (mm)",
    )
    carriage: list[CarriageTable] = Field(
        min_length=1, description="second and further carriages, in the order of their numbers"
    )

    @field_validator("carriage")
    @classmethod
    def _check_carriages(
        cls, value: list[CarriageTable], info: ValidationInfo
    ) -> list[CarriageTable]:
        letters = _letters(value)
        if len(set(letters)) != len(letters):
            raise field_error("field.repeated-letters", letters=letters)
        least, park = info.data.get("min_distance"), info.data.get("park")
        if least is not None and park is not None:
            parks = sorted([park, *(carriage.park for carriage in value)])
            distance = min(far - near for near, far in pairwise(parks))
            if distance < least:
                raise field_error("field.parks-too-near", distance=distance, least=least)
        return value

    @property
    def letters(self) -> list[str]:
        """Letters of the axes of the further carriages."""
        return _letters(self.carriage)


def _letters(carriages: list[CarriageTable]) -> list[str]:
    """Return the letters of the axes of further carriages."""
    axes = [axis for one in carriages for axis in (one.y, one.z, one.c) if axis]
    return [axis.letter for axis in axes]


def _check_park(park: float | None, y: AxisTable) -> None:
    """Raise an error if a parking position is outside the travel of its axis.

    ``park`` is None if the field ``park`` is invalid, which is another error.
    """
    if park is not None and not y.low <= park <= y.high:
        raise field_error("field.park-outside", park=park, low=y.low, high=y.high)


class Datum(PartTable):
    """The TOML table with the offset of a station from the reference position of the machine.

    The position of each axis of the machine is the programmed position plus this offset.
    """

    x: float = Field(description="mm")
    y: float = Field(description="mm")
    z: float = Field(description="mm")
    c: float = Field(description="mounting angle (degrees)")


class ToolTable(PartTable):
    """The TOML table of a tool: its kind and its dimensions."""

    @model_validator(mode="after")
    def _consistent(self) -> ToolTable:
        if fault := self.record().fault:
            raise field_error("field.inconsistent", fault=fault)
        return self

    def record(self) -> Tool:
        """Return the tool that the table describes."""
        fields = self.model_dump()
        return _CLASSES[fields.pop("kind")](**fields)


def _tool_table(kind: Kind) -> type[ToolTable]:
    """Return the pydantic model of the TOML table of one kind of tool.

    The model has the fields of the class of the tool in ``knifetip.model.tool``.
    """
    hints = get_type_hints(kind.tool, include_extras=True)
    fields: dict[str, Any] = {"kind": (Literal[kind.name], ...)}
    for one in dataclasses.fields(kind.tool):  # type: ignore[arg-type]  # all tools are dataclasses
        required = one.default is dataclasses.MISSING
        fields[one.name] = (hints[one.name], ... if required else one.default)
    return create_model(
        f"{kind.tool.__name__}Table", __base__=ToolTable, __doc__=kind.tool.__doc__, **fields
    )


_CLASSES: Final = {kind.name: kind.tool for kind in KINDS}
_AnyTool: Any = reduce(or_, map(_tool_table, KINDS))


def _check_kind(tool: Any) -> Any:
    """Return the table of a tool unchanged after checking the name of its kind.

    ``tool`` is the value in the TOML file.  Values without a field ``kind`` are not checked.

    Raises ``PydanticCustomError``: the field ``kind`` is not the name of a kind of tool.
    """
    if isinstance(tool, dict) and "kind" in tool and tool["kind"] not in list(_CLASSES):
        raise field_error(
            "field.unknown-kind",
            value=str(tool["kind"])[:80],
            known=[repr(kind) for kind in _CLASSES],
        )
    return tool


_CheckedTool: Any = Annotated[_AnyTool, Field(discriminator="kind"), BeforeValidator(_check_kind)]


class ToolFile(PartTable):
    """The fields of the TOML file of a tool, which can be copied into stations of machines."""

    title: str
    tool: _CheckedTool

    def record(self) -> Tool:
        """Return the tool that the file describes."""
        tool: Tool = self.tool.record()
        return tool


class StationTable(PartTable):
    """The TOML table of a station, a mount on the head of a machine that carries one tool."""

    number: int = Field(gt=0, lt=256, description="tool number in programs (T word)")
    name: str
    datum: Datum = Field(title="Offset of the station")
    output: int = Field(
        -1,
        description="digital output that lowers the station or switches its tool on; -1 for none",
    )
    carriage: int = Field(
        1, ge=1, description="number of the carriage that carries the station; 1 is the first"
    )
    envelope: NotNegative = Field(
        0.0,
        title="Radius of the holder",
        description="radius about the axis of the station of its holder at the height of the tip, "
        "for keep-out zones (mm); 0: the tool only",
    )
    life: NotNegative = Field(
        0.0,
        title="Tool life",
        description="length that the tool may work in the board before it is changed (m); 0: no "
        "limit",
    )
    spindle: Annotated[Literal["M3", "M4"], LISTED] = Field(
        "M3",
        description="word that switches the oscillation or the spindle of the tool on: M3 turns "
        "clockwise, M4 counter-clockwise",
    )
    spindle_speed: NotNegative = Field(
        0.0,
        le=1e6,
        description="S word with it, if the controller needs another than the speed of the tool; "
        "0: the speed of a cutter, the power of a laser, and 1 for an oscillating knife",
    )
    tool: _CheckedTool

    @model_validator(mode="after")
    def _check_spindle(self) -> StationTable:
        station = self.record()
        if self.spindle == "M3" and not self.spindle_speed:
            return self
        if not has_spindle(station.tool):
            raise field_error("field.no-spindle", station=self.number)
        # Under M4, grbl switches the beam off while the head is at rest, so nothing is pierced.
        if station.is_beam:
            raise field_error("field.spindle-of-beam", station=self.number)
        return self

    def record(self) -> Station:
        """Return the station that the table describes."""
        datum = self.datum.model_dump()
        return Station(
            self.number,
            self.name,
            self.tool.record(),
            **datum,
            output=self.output,
            carriage=self.carriage,
            envelope=self.envelope,
            life=self.life,
            spindle=self.spindle,
            spindle_speed=self.spindle_speed,
        )


class ZoneTable(PartTable):
    """The TOML table of a keep-out zone: a box on the table that no tool may touch.

    Such a zone is, for example, a clamp or a stop.  Positions are those on the sheet: of the tip of
    a station whose datum is 0, on a machine with square axes.
    """

    name: str = Field(min_length=1, max_length=80, description="name for messages")
    x: float = Field(description="position of the left edge (mm)")
    y: float = Field(description="position of the lower edge (mm)")
    width: Positive = Field(description="size along X (mm)")
    height: Positive = Field(description="size along Y (mm)")
    top: Positive = Field(description="height of the top of the zone above the mat (mm)")

    def record(self) -> Zone:
        """Return the zone that the table describes."""
        return Zone(**self.model_dump())


class MachineFile(MachineTable):  # type: ignore[misc, valid-type]  # made by pydantic
    """The fields of the TOML file of a flatbed sample-maker.

    Z = 0 is the top of the cutting mat, and Z is positive upwards.
    """

    origin: list[float] = Field(
        min_length=2,
        max_length=2,
        title="Place of the drawing",
        description="Default position of the lower left corner of a drawing (mm)",
        json_schema_extra={**TABLE, "itemTitles": ["Place in X", "Place in Y"]},
    )
    axes: Axes = Field(json_schema_extra=AXES)
    gantry: GantryTable | None = Field(
        None,
        title="Gantry with several carriages",
        description="Carriages, if the machine has more than one",
        json_schema_extra=AXES,
    )
    station: list[StationTable] = Field(json_schema_extra=STATIONS)
    zone: list[ZoneTable] = Field(
        [],
        max_length=50,
        description="Keep-out zones on the table",
        json_schema_extra=group("Keep-out zones"),
    )
    arcs: Annotated[Literal["arcs", "chords"], LISTED] = Field(
        "arcs",
        description="Whether programs may contain arcs (G2, G3). chords: the controller has none, "
        "or does not turn the tool in them",
        json_schema_extra=CONTROLLER,
    )
    feed_override: list[Annotated[int, Field(ge=10, le=200)]] = Field(
        [10, 200],
        min_length=2,
        max_length=2,
        description="Least and greatest feed override while a program runs (%), of a controller "
        "that has one; programs begin with 100",
        json_schema_extra={
            **CONTROLLER,
            "itemTitles": ["Least feed override", "Greatest feed override"],
        },
    )
    controller: dict[str, Any] = Field(
        {}, description="Settings of the controller's language", json_schema_extra=CONTROLLER
    )

    @field_validator("dialect")
    @classmethod
    def _check_language(cls, value: str) -> str:
        try:
            return find_language(value).name
        except LibraryError:
            raise field_error(
                "field.not-one-of", value=value[:80], known=language_names()
            ) from None

    @field_validator("feed_override")
    @classmethod
    def _around_nominal(cls, value: list[int]) -> list[int]:
        low, high = value
        if not low <= _NOMINAL <= high:
            raise field_error("field.override-range", low=low, high=high)
        return value

    @field_validator("gantry")
    @classmethod
    def _first_reaches_park(
        cls, value: GantryTable | None, info: ValidationInfo
    ) -> GantryTable | None:
        if value is not None and (angle := info.data.get("squareness", 90.0)) != 90.0:
            raise field_error("field.gantry-not-square", angle=angle)
        if value is not None and (axes := info.data.get("axes")) is not None:
            _check_park(value.park, axes.y)
            if axes.c is None:
                raise field_error("field.gantry-without-heading")
            letters = [axes.letter, *value.letters]
            if axes.letter in value.letters:
                raise field_error("field.repeated-letters", letters=letters)
        return value

    @field_validator("station")
    @classmethod
    def _check_stations(cls, value: list[StationTable], info: ValidationInfo) -> list[StationTable]:
        numbers = [station.number for station in value]
        if len(set(numbers)) != len(numbers):
            raise field_error("field.repeated-numbers", numbers=numbers)
        gantry, axes = info.data.get("gantry"), info.data.get("axes")
        count = 1 + len(gantry.carriage) if gantry else 1
        for station in value:
            if axes and not axes.c and station.record().tool.needs_heading:
                raise field_error("field.needs-heading", station=station.number)
            if "gantry" in info.data and station.carriage > count:
                raise field_error(
                    "field.no-such-carriage",
                    station=station.number,
                    carriage=station.carriage,
                    count=count,
                )
        return value

    @field_validator("turn_clearance")
    @classmethod
    def _below_clearance(cls, value: float, info: ValidationInfo) -> float:
        clearance = info.data.get("clearance")
        if clearance is not None and value > clearance:
            raise field_error("field.above-clearance", value=value, clearance=clearance)
        return value

    @field_validator("zone")
    @classmethod
    def _check_zones(cls, value: list[ZoneTable], info: ValidationInfo) -> list[ZoneTable]:
        travel_z, clearance = info.data.get("travel_z"), info.data.get("clearance")
        if travel_z is None or clearance is None:
            return value
        for zone in value:
            if zone.top + clearance > travel_z:
                raise field_error(
                    "field.zone-above-travel",
                    zone=zone.name,
                    top=zone.top,
                    clearance=clearance,
                    travel_z=travel_z,
                )
        return value

    def record(self, name: str) -> Machine:
        """Return the machine that the file describes, with the name ``name``.

        The settings of the machine's controller are not included.
        """
        fields = self.model_dump(
            exclude={"axes", "gantry", "station", "zone", "origin", "controller", "feed_override"}
        )
        tables = self.axes
        x, y, z = (axis.axis() for axis in (tables.x, tables.y, tables.z))
        c = tables.c.axis() if tables.c else NO_HEADING
        gantry = None
        if self.gantry:
            first = Carriage((x, y, z, c), f"XYZ{tables.letter}", self.gantry.park)
            further = (carriage.record(first) for carriage in self.gantry.carriage)
            gantry = Gantry((first, *further), self.gantry.min_distance)
        return Machine(
            name=name,
            **fields,
            x=x,
            y=y,
            z=z,
            c=c,
            stations=tuple(station.record() for station in self.station),
            origin=(self.origin[0], self.origin[1]),
            feed_override=(self.feed_override[0], self.feed_override[1]),
            gantry=gantry,
            zones=tuple(zone.record() for zone in self.zone),
            heading_letter=tables.letter,
        )
