"""Revisions of drawings as ETag, If-Match and If-None-Match (RFC 9110, section 13).

The ETag of a drawing is its revision.  If the profile has changed since the classification, the
ETag also contains that state, because it changes the response but not the drawing.
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
        description="ETag of the revision on which the change is based; 412 if it is not the "
        "newest. Without it the change applies to the newest.",
    ),
]
IfNoneMatch = Annotated[
    str | None,
    Header(
        alias="If-None-Match",
        max_length=1000,
        description="ETag of the client's copy; 304 if it is current",
    ),
]


def etag(revision: int, profile_state: str = "current") -> str:
    """Return the ETag of a drawing with a revision and a state of its profile ("changed" …)."""
    return f'"{revision}"' if profile_state == "current" else f'"{revision}-{profile_state}"'


def check_match(match: str | None, row: Drawing) -> None:
    """Raise StaleRevision if an If-Match header does not contain the revision of the drawing.

    There is no error if the header is ``*``, or missing (None).
    """
    if match is None or "*" in _tags(match):
        return
    named = [tag.partition("-")[0] for tag in _tags(match)]
    if str(row.version) not in named:
        raise StaleRevision(row.id, row.version, ", ".join(named)[:40])


def check_revision(revision: int | None, row: Drawing) -> None:
    """Raise StaleRevision if a job request names another revision than that of the drawing.

    There is no error if the request names no revision (None).
    """
    if revision is not None and revision != row.version:
        raise StaleRevision(row.id, row.version, str(revision))


def is_known(tag: str, none_match: str | None) -> bool:
    """Return whether an If-None-Match header contains the ETag ``tag``."""
    known = list(_tags(none_match or ""))
    return "*" in known or tag.strip('"') in known


def _tags(header: str) -> Iterator[str]:
    for word in header.split(","):
        # A compressing proxy marks ETags as weak; the revision is the same.
        yield word.strip().removeprefix("W/").strip('"')
