"""Models that several routes use in requests and responses."""

from __future__ import annotations

from typing import Annotated, Any, ClassVar, Literal

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field

from knifetip.fields import LISTED
from knifetip.service.http.message_models import MessageOut

LineTypeWord = Annotated[
    Literal[
        "unclassified", "cut", "crease", "v-groove", "perforation", "half-cut", "ignored", "combi"
    ],
    LISTED,
]
Name = Annotated[str, Field(min_length=1, max_length=200)]


def _whole(value: Any) -> Any:
    return int(value) if isinstance(value, float) and value.is_integer() else value


#: Last annotation of an integer in a JSON body: like in JSON Schema, 5.0 is one.  Limits come
#: before it, or pydantic would not describe them.
WHOLE = BeforeValidator(_whole)
Count = Annotated[int, Field(ge=0, le=2**31 - 1), WHOLE]
Copies = Annotated[int, Field(ge=1, le=1000), WHOLE]
Priority = Annotated[int, Field(ge=-100, le=100), WHOLE]
#: X, Y, Z (mm) and C (degrees).  JSON has no tuples, so a list is accepted.
Pose = Annotated[tuple[float, float, float, float], Field(strict=False)]


class PageQuery(BaseModel):
    """Query parameters that select a page of a list."""

    cursor: Annotated[int, Field(ge=0, le=2**31 - 1)] | None = Field(
        default=None,
        description="Position in the list where the page begins, from the Link header of the "
        "previous page",
    )
    limit: int = Field(default=100, ge=1, le=500, description="Maximum number of items in the list")


class ListPage(BaseModel):
    """Query parameters that select a part of a list that is short as a rule."""

    model_config = ConfigDict(extra="forbid")

    cursor: Annotated[int, Field(ge=0, le=2**31 - 1)] | None = Field(
        default=None,
        description="Position in the list where the page begins, from the Link header of the "
        "previous page",
    )
    limit: int = Field(
        default=1000, ge=1, le=1000, description="Maximum number of items in the list"
    )


class Parameters(BaseModel):
    """Base class of query parameters; unknown ones are refused."""

    model_config = ConfigDict(extra="forbid", allow_inf_nan=False)


class JsonBody(Parameters):
    """Base class of JSON bodies; types are not converted, and unknown fields are refused."""

    model_config = ConfigDict(strict=True)


class FollowingEdgesOut(MessageOut):
    """Edges of one style that the answer to a question decides besides those it asks about."""

    edges: list[int] = Field(description="Rows of the edges, counted from 0")
    layer: str = Field(description="Name of the layer of the edges")
    colour: int = Field(description="AutoCAD colour index of the edges, 1 … 255")
    line_types: dict[str, str] = Field(
        description="Line type that the edges get, by the answer; with another answer they become "
        "a question of their own. If several questions name the same edges, all of them need the "
        "same answer"
    )


class QuestionOut(MessageOut):
    """A question that the user must answer before the drawing can be compiled."""

    kind: Literal["unit", "line-type", "tool"] = Field(
        description="Decision that is missing. unit: the unit of the drawing. line-type: the line "
        "type of edges. tool: another line type for edges for whose line type the "
        "machine has no tool"
    )
    choices: list[str] = Field(
        description="Possible answers: units for `unit`, line types for the other kinds"
    )
    edges: list[int] = Field(
        description="Rows of the edges that the question concerns, counted from 0; empty if it "
        "concerns the whole drawing"
    )
    layer: str = Field(
        description="Name of the layer of these edges; empty if the question concerns no single "
        "layer"
    )
    colour: int = Field(
        description="AutoCAD colour index of these edges, 1 … 255; 0 if the question concerns no "
        "single colour"
    )
    follows: list[FollowingEdgesOut] = Field(
        default_factory=list, description="Other edges whose line types the answer decides"
    )


class Problem(MessageOut):
    """An error in the format of RFC 9457, with a hint and the entities that the error concerns."""

    text_fields: ClassVar[tuple[str, ...]] = ("detail", "text")

    type: str = Field(
        default="about:blank",
        description="Type of the error: `urn:knifetip:problem:` and its class, such as "
        "`wrong-state`, `not-found`, `key-reused` or `request` (the request cannot be read); "
        "`about:blank` for an error that `status` describes. `code` identifies the error",
    )
    title: str = Field(description="Name of the type of error in English")
    status: int = Field(description="HTTP status of the response")
    detail: str = Field(description="Same text as `text`, under the name that RFC 9457 prescribes")
    source: list[str] = Field(
        default=[],
        description="Entity handles or names of request fields that the error concerns; empty if "
        "there are none",
    )
    edges: list[int] = Field(
        default=[],
        description="Rows of the edges of the drawing that the error concerns, at most 1000; they "
        "may be parts of one entity. Empty if there are none",
    )
    questions: list[QuestionOut] = Field(
        default=[],
        description="Questions that must be answered before the job can be created; empty for "
        "other errors",
    )
    revision: int | None = Field(
        default=None,
        description="Current revision of the drawing, if the request named an older one; else null",
    )


class ServiceOut(BaseModel):
    """Version of the server, and its progress in compiling functions to machine code.

    The functions are compiled once after an installation.
    """

    version: str = Field(description="Version of knifetip on the server, such as 1.2.0")
    preparing: bool = Field(
        description="Whether the server still compiles functions after an installation; uploads "
        "and jobs that need these functions wait meanwhile"
    )
    parts_compiled: int = Field(
        description="Number of groups of functions compiled since the server started"
    )
    parts: int = Field(
        description="Number of groups of functions that had to be compiled when the server started"
    )


class Health(BaseModel):
    """State of the server: whether it runs and can process requests."""

    status: Literal["ok", "starting", "failing"] = Field(
        description="ok if the server can process requests; starting if it cannot yet; failing if "
        "a component has a fault, see `checks`"
    )
    version: str = Field(description="Version of knifetip on the server, such as 1.2.0")
    checks: dict[str, str] = Field(
        default={},
        description="`ok` or the fault, by component: `database` (a write), `schema` (its tables), "
        "`disk` (free space), `contents` (the folder or bucket) and `workers` (the processes that "
        "read and compile); empty if nothing was checked",
    )
