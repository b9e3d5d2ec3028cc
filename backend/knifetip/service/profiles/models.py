"""Models for classification profiles, previews and proposed rules."""

from __future__ import annotations

from typing import Annotated

from pydantic import BaseModel, Field

from knifetip.service.http.message_models import MessageOut
from knifetip.service.http.models import WHOLE, Count, JsonBody, LineTypeWord, Name
from knifetip.service.http.times import OptionalMoment

Patterns = Annotated[list[str], Field(max_length=500)]
Colours = Annotated[
    list[Annotated[int, WHOLE] | str],
    Field(max_length=500, description='AutoCAD indices, or "#rrggbb"'),
]


class RuleIn(JsonBody):
    """A rule of a profile in a request: conditions on an edge, and a line type.

    Edges that meet all conditions get the line type.  Conditions on names are lists of shell
    patterns that ignore case; an empty list is met by any name.
    """

    type: LineTypeWord = Field(description="Line type for the edges that the rule matches")
    layer: Patterns = Field(
        default=[], description="Patterns for the name of the layer; empty for any layer"
    )
    colour: Colours = Field(
        default=[],
        description='AutoCAD colour indices (integers) or colours "#rrggbb"; empty for any colour',
    )
    linetype: Patterns = Field(
        default=[], description="Patterns for the linetype, such as DASHED; empty for any linetype"
    )
    entity: Patterns = Field(
        default=[],
        description="Patterns for the type of the entity in the file, such as LINE or ARC; empty "
        "for any type",
    )
    block: Patterns = Field(
        default=[],
        description="Patterns for the name of the block that contains the entity; empty for any "
        "entity",
    )


class ProfileIn(JsonBody):
    """A classification profile of a customer, as a request contains it."""

    title: Name = Field(description="Name of the profile for display")
    extends: Name | None = Field(
        default=None,
        description="Name of the library profile whose rules also apply; null for none",
    )
    overrules: bool = Field(
        default=True,
        description="Whether the rules of this profile come before those of the extended profile; "
        "without effect if `extends` is null",
    )
    rules: list[RuleIn] = Field(
        max_length=500,
        description="Rules in the order in which they are tried; the first that matches an edge "
        "sets its line type",
    )
    version: Count | None = Field(
        default=None,
        description="Version of the profile on which the change is based; may also be sent as "
        "If-Match. Null for a new profile",
    )


class RuleOut(BaseModel):
    """A rule of a profile in a response: conditions on an edge, and a line type.

    Edges that meet all conditions get the line type.
    """

    type: LineTypeWord = Field(description="Line type for the edges that the rule matches")
    conditions: MessageOut = Field(description="Conditions that an edge must fulfil, as a message")
    layer: list[str] = Field(
        default=[], description="Patterns for the name of the layer; empty for any layer"
    )
    colour: list[int | str] = Field(
        default=[],
        description='AutoCAD colour indices (integers) or colours "#rrggbb"; empty for any colour',
    )
    linetype: list[str] = Field(
        default=[], description="Patterns for the linetype, such as DASHED; empty for any linetype"
    )
    entity: list[str] = Field(
        default=[],
        description="Patterns for the type of the entity in the file, such as LINE or ARC; empty "
        "for any type",
    )
    block: list[str] = Field(
        default=[],
        description="Patterns for the name of the block that contains the entity; empty for any "
        "entity",
    )
    inherited: bool = Field(
        default=False, description="Whether the rule comes from the extended profile"
    )


class ProfileOut(BaseModel):
    """A classification profile with its rules in order."""

    name: str = Field(description="Name of the profile, to be used in requests")
    title: str = Field(description="Name of the profile for display")
    shipped: bool = Field(
        default=False,
        description="Whether the profile is part of knifetip's library; such a profile cannot be "
        "changed",
    )
    extends: str | None = Field(
        default=None,
        description="Name of the library profile whose rules also apply; null for none",
    )
    overrules: bool = Field(
        default=False, description="Whether the own rules come before those of the extended profile"
    )
    version: int = Field(
        default=0,
        description="Version of the profile; increases with each change; 0 for a library profile",
    )
    updated: OptionalMoment = Field(
        default=None, description="Time of the last change; null for a library profile"
    )
    rules: list[RuleOut] = Field(description="Rules in the order in which they are tried")
    fault: str = Field(
        default="",
        description="Reason why the profile can no longer be used, in English; empty if it can be "
        "used",
    )


class ChangeOut(BaseModel):
    """Edges whose line type a profile would change, with their line types before and after."""

    before: LineTypeWord = Field(description="Present line type of the edges")
    after: LineTypeWord = Field(description="Line type that the profile would give the edges")
    edges: list[int] = Field(description="Rows of the edges in the drawing, counted from 0")


class PreviewRule(RuleOut):
    """A rule, with the number and total length of the edges that the rule matches."""

    edges: int = Field(description="Number of edges that the rule matches")
    length: float = Field(description="Total length of the edges that the rule matches (mm)")


class PreviewOut(BaseModel):
    """The effect that a profile would have on a drawing."""

    rules: list[PreviewRule] = Field(
        description="Rules of the profile, with the edges that they match"
    )
    open: int = Field(description="Number of edges that no rule matches")
    changes: list[ChangeOut] = Field(
        description="Edges whose line type would change, in groups by line type before and after"
    )


class ProposalOut(BaseModel):
    """A proposed rule that gives edges the line types that the user set for them by hand."""

    rule: RuleOut = Field(description="Proposed rule")
    explains: list[int] = Field(
        description="Rows of the edges that the user corrected and that the rule matches"
    )
    sure: bool = Field(
        description="Whether the rule would change no edge that already has a line type"
    )
    changes: list[ChangeOut] = Field(
        description="Edges that the user did not correct and whose line type the rule would change"
    )
