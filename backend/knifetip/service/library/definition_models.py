"""Models for machines, boards and tools that users make, and for their versions."""

from __future__ import annotations

from typing import Any

from pydantic import BaseModel, ConfigDict, Field

from knifetip.library.definition import Shelf
from knifetip.service.http.times import OptionalMoment


class VersionOut(BaseModel):
    """A stored version of a machine, a board or a tool: its number, and who stored it when."""

    model_config = ConfigDict(from_attributes=True)

    version: int = Field(
        default=0,
        description="Number of the version; increases with each change; 0 for an entry of "
        "knifetip's library",
    )
    title: str = Field(description="Name for display")
    at: OptionalMoment = Field(
        default=None,
        description="Time at which the version was stored; null for an entry of knifetip's library",
    )
    by: str = Field(default="", description="Who stored the version; empty if it is not known")
    note: str = Field(default="", description="What was changed, and why; may be empty")


class EntryOut(VersionOut):
    """A machine, a board or a tool of a user or of knifetip's library, in one version."""

    shelf: Shelf = Field(description="Kind of the entry")
    name: str = Field(description="Name of the entry, to be used in requests")
    shipped: bool = Field(
        description="Whether the entry is part of knifetip's library; such an entry cannot be "
        "changed"
    )
    fault: str = Field(
        default="",
        description="Reason why the entry can no longer be used, in English; empty if it can be "
        "used",
    )


class DefinitionOut(EntryOut):
    """A machine, a board or a tool with all fields of its definition."""

    fields: dict[str, Any] = Field(
        description="Values by field name, as in the TOML files of knifetip's library and in the "
        "JSON that is sent to save the entry; `GET /api/schemas/{shelf}` describes them"
    )
