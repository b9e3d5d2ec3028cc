"""revisions: the revision of a drawing as ETag, If-Match and If-None-Match (RFC 9110, section 13).

A drawing's revision counts its changes.  Its ETag is the revision, and says besides where the
profile has changed since: that changes the answer and not the drawing.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated

from fastapi import Header

from knifetip.errors import StaleRevision
from knifetip.jobs.tables import Drawing

IfMatch = Annotated[
    str | None,
    Header(
        alias="If-Match",
        max_length=200,
        description="ETag of the revision that the change was made for; 412 if it is not the "
        "newest. Without it the change applies to whatever there is.",
    ),
]
IfNoneMatch = Annotated[
    str | None,
    Header(
        alias="If-None-Match",
        max_length=1000,
        description="ETag of what the client has already; 304 if that is still so",
    ),
]


def etag(revision: int, profile_state: str = "current") -> str:
    """Return the ETag of a drawing."""
    return f'"{revision}"' if profile_state == "current" else f'"{revision}-{profile_state}"'


def check_match(match: str | None, row: Drawing) -> None:
    """Raise StaleRevision where an If-Match names no ETag of the drawing as it is now."""
    if match is None or "*" in _tags(match):
        return
    named = [tag.partition("-")[0] for tag in _tags(match)]
    if str(row.version) not in named:
        raise StaleRevision(row.id, row.version, ", ".join(named)[:40])


def check_revision(revision: int | None, row: Drawing) -> None:
    """Raise StaleRevision where an order names another revision than the drawing's."""
    if revision is not None and revision != row.version:
        raise StaleRevision(row.id, row.version, str(revision))


def is_known(tag: str, none_match: str | None) -> bool:
    """Return whether an If-None-Match names this ETag."""
    known = list(_tags(none_match or ""))
    return "*" in known or tag.strip('"') in known


def _tags(header: str) -> Iterator[str]:
    for word in header.split(","):
        # A proxy that compresses makes a strong ETag weak; it is the same revision still.
        yield word.strip().removeprefix("W/").strip('"')
