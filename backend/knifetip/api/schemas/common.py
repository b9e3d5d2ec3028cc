"""Models that several routes use in requests and responses."""

from __future__ import annotations

from typing import Annotated, ClassVar, Literal

from pydantic import BaseModel, ConfigDict, Field

from knifetip.api.schemas.messages import MessageOut

LineTypeWord = Literal[
    "unclassified", "cut", "crease", "v-groove", "perforation", "half-cut", "ignored", "combi"
]
Name = Annotated[str, Field(min_length=1, max_length=200)]
Count = Annotated[int, Field(ge=0, le=2**31 - 1)]


class Strict(BaseModel):
    """Base class of request models; unknown fields are refused."""

    model_config = ConfigDict(extra="forbid", allow_inf_nan=False)


class QuestionOut(MessageOut):
    """A question that the user must answer before the drawing can be compiled."""

    kind: Literal["unit", "line-type", "tool"] = Field(
        description="Decision that the question concerns"
    )
    choices: list[str] = Field(description="Possible answers")
    edges: list[int] = Field(description="Rows of the edges that the question concerns")
    layer: str = Field(description="Layer that the question concerns; empty for none")
    colour: int = Field(description="AutoCAD colour index that the question concerns; 0 for none")


class Problem(MessageOut):
    """An error in the format of RFC 9457, with a hint and the entities that the error concerns."""

    text_fields: ClassVar[tuple[str, ...]] = ("detail", "text")

    type: str = "about:blank"
    title: str = Field(description="Name of the type of error")
    status: int = Field(description="HTTP status")
    detail: str = Field(description="Same value as `text`, under the name that RFC 9457 gives it")
    source: list[str] = Field(
        default=[], description="Entity handles or request fields that the error concerns"
    )
    questions: list[QuestionOut] = Field(default=[])
    revision: int | None = Field(
        default=None, description="Current revision, if the request named an older one"
    )


class ServiceOut(BaseModel):
    """Version of the server, and progress of compiling its kernels after an installation."""

    version: str
    preparing: bool = Field(
        description="Uploads and jobs may have to wait until the parts that they need are compiled"
    )
    parts_compiled: int = Field(description="Parts compiled since the server started")
    parts: int = Field(description="Parts that had to be compiled when the server started")


class Health(BaseModel):
    """State of the server: whether it runs and can process requests."""

    status: Literal["ok", "starting"] = Field(description="ok if all checks are ok")
    version: str
    checks: dict[str, str] = Field(
        default={}, description="State of the database and of the worker processes: ok or the fault"
    )
