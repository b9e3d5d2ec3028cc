"""Models for the use of the tools of a machine."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import BaseModel, Field

from knifetip.service.http.message_models import MessageOut
from knifetip.service.http.models import JsonBody
from knifetip.service.http.times import Moment, OptionalMoment

By = Annotated[str, Field(max_length=100)]


class ToolUseOut(BaseModel):
    """The use of the tool in a station since the tool was changed."""

    station: int = Field(description="Number of the station")
    name: str = Field(description="Name of the station")
    kind: str = Field(description="Kind of the tool, such as knife or crease-wheel")
    used: float = Field(
        description="Length that the tool has worked in the board since its last change, with "
        "the job on the machine (m)"
    )
    life: float = Field(description="Length that the tool may work (m); 0 for no limit")
    share: float = Field(description="Used fraction of the life; 0 if the life has no limit")
    changed: OptionalMoment = Field(description="Time of the last change; null if none is recorded")
    changed_by: str = Field(description="Who changed the tool; empty if no change is recorded")
    warning: Literal["", "near", "over"] = Field(
        description="near: from 90 % of the life on. over: the life is used up, and the operator "
        "must confirm the tool before a job starts. Empty: no warning"
    )
    message: MessageOut | None = Field(description="Text of the warning; null if there is none")


class ToolChangeIn(JsonBody):
    """A person has put a new tool into a station."""

    by: By = Field(default="", description="Name of the person; empty if it is not known")


class ToolLifeIn(JsonBody):
    """The life of the tool in a station."""

    life: float = Field(
        ge=0.0, le=1e7, description="Length that the tool may work (m); 0 for no limit"
    )
    by: By = Field(default="", description="Name of the person; empty if it is not known")


class ToolEventOut(BaseModel):
    """A change of a tool, or of its life, by a person."""

    station: int = Field(description="Number of the station")
    kind: Literal["changed", "life"] = Field(
        description="changed: a new tool was put into the station. life: another life was set"
    )
    at: Moment = Field(description="Time of the change")
    who: str = Field(description="The person: operator, followed by the name if it is known")
    length: float = Field(
        description="Of a changed tool the length that it had worked; otherwise the new life (m)"
    )
