"""profiles: what is said of customers’ profiles."""

from __future__ import annotations

from typing import Annotated

from pydantic import BaseModel, Field, StrictInt, StrictStr

from knifetip.api.schemas.common import Count, LineTypeWord, Name, Strict

Patterns = Annotated[list[str], Field(max_length=500)]
Colours = Annotated[
    list[StrictInt | StrictStr], Field(max_length=500, description='AutoCAD indices, or "#rrggbb"')
]


class RuleIn(Strict):
    """One rule: an edge that meets every condition has the type.

    Patterns are shell globs, compared without regard to case; an empty list is no condition.
    """

    type: LineTypeWord
    layer: Patterns = Field(default=[])
    colour: Colours = Field(default=[])
    linetype: Patterns = Field(default=[])
    entity: Patterns = Field(default=[])
    block: Patterns = Field(default=[])


class ProfileIn(Strict):
    """A customer's profile: the first rule that an edge meets decides."""

    title: Name
    extends: Name | None = Field(default=None, description="A shipped profile, whose rules are met")
    overrules: bool = Field(default=True, description="These rules before those that it extends")
    rules: list[RuleIn] = Field(max_length=500)
    version: Count | None = Field(default=None, description="That was looked at; or send If-Match")


class RuleOut(BaseModel):
    """One rule of a profile."""

    type: LineTypeWord
    words: str
    layer: list[str] = []
    colour: list[int | str] = []
    linetype: list[str] = []
    entity: list[str] = []
    block: list[str] = []
    inherited: bool = Field(default=False, description="From the profile that this one extends")


class ProfileOut(BaseModel):
    """A classification profile."""

    name: str
    title: str
    shipped: bool = Field(default=False, description="With knifetip: read it, do not change it")
    extends: str | None = None
    overrules: bool = False
    version: int = Field(default=0, description="Counts the changes; 0 of those that are shipped")
    updated: float = 0.0
    rules: list[RuleOut]
    fault: str = Field(default="", description="Why it cannot be used any more")


class ChangeOut(BaseModel):
    """Edges that would be something else."""

    before: LineTypeWord
    after: LineTypeWord
    edges: list[int]


class PreviewRule(RuleOut):
    """One rule, and what it takes of a drawing."""

    edges: int
    length: float


class PreviewOut(BaseModel):
    """What a profile would do to a drawing."""

    rules: list[PreviewRule]
    open: int = Field(description="Edges that no rule takes")
    changes: list[ChangeOut]


class ProposalOut(BaseModel):
    """A rule that would have said what somebody corrected."""

    rule: RuleOut
    explains: list[int] = Field(description="Corrected edges that it covers")
    sure: bool = Field(description="It changes no edge that was decided")
    changes: list[ChangeOut] = Field(description="What else would become something else")
