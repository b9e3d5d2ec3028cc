"""Models for classification profiles, previews and proposed rules."""

from __future__ import annotations

from typing import Annotated

from pydantic import BaseModel, Field, StrictInt, StrictStr

from knifetip.api.schemas.common import Count, LineTypeWord, Name, Strict
from knifetip.api.schemas.messages import MessageOut

Patterns = Annotated[list[str], Field(max_length=500)]
Colours = Annotated[
    list[StrictInt | StrictStr], Field(max_length=500, description='AutoCAD indices, or "#rrggbb"')
]


class RuleIn(Strict):
    """A rule of a profile: an edge that meets all conditions of the rule gets its line type.

    Conditions on names are shell patterns that ignore case; an empty list is no condition.
    """

    type: LineTypeWord
    layer: Patterns = Field(default=[], description="Patterns for the layer name")
    colour: Colours = Field(default=[])
    linetype: Patterns = Field(default=[], description="Patterns for the linetype")
    entity: Patterns = Field(
        default=[], description="Patterns for the kind of entity, such as LINE or ARC"
    )
    block: Patterns = Field(
        default=[], description="Patterns for the name of the block that contains the entity"
    )


class ProfileIn(Strict):
    """The profile of a customer; the first rule that matches an edge sets its line type."""

    title: Name
    extends: Name | None = Field(
        default=None, description="Profile of the library whose rules also apply"
    )
    overrules: bool = Field(
        default=True, description="Whether these rules come before those of the extended profile"
    )
    rules: list[RuleIn] = Field(max_length=500)
    version: Count | None = Field(
        default=None, description="Expected version; may also be sent as If-Match"
    )


class RuleOut(BaseModel):
    """One rule of a profile."""

    type: LineTypeWord
    conditions: MessageOut = Field(description="Conditions that an edge must fulfil")
    layer: list[str] = Field(default=[], description="Patterns for the layer name")
    colour: list[int | str] = Field(default=[], description="AutoCAD colour indices, or #rrggbb")
    linetype: list[str] = Field(default=[], description="Patterns for the linetype")
    entity: list[str] = Field(
        default=[], description="Patterns for the kind of entity, such as LINE or ARC"
    )
    block: list[str] = Field(
        default=[], description="Patterns for the name of the block that contains the entity"
    )
    inherited: bool = Field(
        default=False, description="Whether the rule comes from the extended profile"
    )


class ProfileOut(BaseModel):
    """A classification profile with its rules in order."""

    name: str
    title: str
    shipped: bool = Field(
        default=False, description="Part of knifetip's library; cannot be changed"
    )
    extends: str | None = Field(
        default=None, description="Profile of the library whose rules also apply; null for none"
    )
    overrules: bool = Field(
        default=False, description="Whether the own rules come before those of the extended profile"
    )
    version: int = Field(default=0, description="Increases with each change; 0 in the library")
    updated: float = Field(default=0.0, description="Time of the last change; 0 in the library")
    rules: list[RuleOut] = Field(description="Rules in the order in which they are tried")
    fault: str = Field(
        default="", description="Reason why the profile cannot be used any more; empty if it can"
    )


class ChangeOut(BaseModel):
    """Edges whose line type a profile would change, with their line types before and after."""

    before: LineTypeWord = Field(description="Present line type")
    after: LineTypeWord = Field(description="Line type that the profile would give")
    edges: list[int] = Field(description="Rows of the edges")


class PreviewRule(RuleOut):
    """A rule, with the number and total length of the edges that the rule matches."""

    edges: int = Field(description="Number of edges")
    length: float = Field(description="Total length of the edges (mm)")


class PreviewOut(BaseModel):
    """The effect that a profile would have on a drawing."""

    rules: list[PreviewRule] = Field(
        description="Rules of the profile, with the edges that they match"
    )
    open: int = Field(description="Number of edges that no rule matches")
    changes: list[ChangeOut] = Field(description="Edges whose line type would change")


class ProposalOut(BaseModel):
    """A proposed rule that gives edges the line types that the user set for them by hand."""

    rule: RuleOut
    explains: list[int] = Field(description="Corrected edges that the rule matches")
    sure: bool = Field(description="Whether the rule changes no edge with a decided line type")
    changes: list[ChangeOut] = Field(description="Other edges whose line type would change")
