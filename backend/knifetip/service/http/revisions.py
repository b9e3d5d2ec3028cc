"""ETag, If-Match and If-None-Match of drawings (RFC 9110, section 13).

The ETag of a drawing is its revision.  If the profile of the drawing has been changed or deleted
since the classification, the ETag also contains that state, because it changes the response
although the drawing has not changed.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated

from fastapi import Header
from pydantic.json_schema import SkipJsonSchema

from knifetip.errors import StaleRevision
from knifetip.service.database.tables import Drawing

IfMatch = Annotated[
    str | SkipJsonSchema[None],  # a header is never null
    Header(
        alias="If-Match",
        max_length=200,
        description="ETag of the revision on which the change is based; 412 if it is not the "
        "newest. Without it the change applies to the newest.",
    ),
]


def etag(revision: int, profile_state: str = "current") -> str:
    """Return the ETag of a drawing; see ``revision_tag``."""
    return f'"{revision_tag(revision, profile_state)}"'


def revision_tag(revision: int, profile_state: str) -> str:
    """Return the ETag of a drawing without quotation marks.

    Parameters
    ----------
    revision
        Revision of the drawing.
    profile_state
        "current", or "changed" or "deleted" if the profile was changed or deleted since the drawing
        was classified.
    """
    return f"{revision}" if profile_state == "current" else f"{revision}-{profile_state}"


def check_match(match: str | None, row: Drawing) -> None:
    """Raise StaleRevision if an If-Match header does not contain the revision of the drawing.

    Parameters
    ----------
    match
        The header.  There is no error if it is ``*``, or None (the request has no such header).
    row
        The drawing.
    """
    if match is None or "*" in tags(match):
        return
    revisions = [tag.partition("-")[0] for tag in tags(match)]
    if str(row.version) not in revisions:
        raise StaleRevision(row.id, row.version, ", ".join(revisions)[:40])


def check_revision(revision: int | None, row: Drawing) -> None:
    """Raise StaleRevision if a request for a job does not name the newest revision of the drawing.

    Parameters
    ----------
    revision
        Revision in the request, or None if the request names no revision; then there is no error.
    row
        The drawing.
    """
    if revision is not None and revision != row.version:
        raise StaleRevision(row.id, row.version, str(revision))


def is_known(tag: str, none_match: str | None) -> bool:
    """Return whether an If-None-Match header contains an ETag or is ``*``.

    Parameters
    ----------
    tag
        The ETag.
    none_match
        The header, or None if the request has no such header; the result is then False.
    """
    known = list(tags(none_match or ""))
    return "*" in known or tag.strip('"') in known


def tags(header: str) -> Iterator[str]:
    """Yield the ETags in a header, without quotation marks."""
    for word in header.split(","):
        # A compressing proxy marks ETags as weak; the revision is the same.
        yield word.strip().removeprefix("W/").strip('"')
