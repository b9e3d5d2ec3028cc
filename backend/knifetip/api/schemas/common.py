"""common: what requests and answers of several routes say."""

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
    """A request: what it does not know, it refuses."""

    model_config = ConfigDict(extra="forbid", allow_inf_nan=False)


class QuestionOut(MessageOut):
    """Something that somebody must decide before anything is cut."""

    kind: Literal["unit", "line-type", "tool"]
    choices: list[str]
    edges: list[int]
    layer: str
    colour: int


class Problem(MessageOut):
    """An error as RFC 9457 has it, with the hint and the entities that it is about."""

    text_fields: ClassVar[tuple[str, ...]] = ("detail", "text")

    type: str = "about:blank"
    title: str
    status: int
    detail: str = Field(description="The text, under its name in RFC 9457")
    source: list[str] = Field(default=[])
    questions: list[QuestionOut] = Field(default=[])
    revision: int | None = Field(
        default=None, description="Of the drawing now, where the request named an older one"
    )


class Health(BaseModel):
    """Whether the service is alive and ready."""

    status: Literal["ok", "starting"]
    version: str
    checks: dict[str, str] = {}
