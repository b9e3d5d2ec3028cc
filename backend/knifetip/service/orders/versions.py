"""ETag and If-Match of jobs (RFC 9110, section 13).

The ETag of a job is ``VERSION.HASH``.  The version changes with what ``PATCH`` changes, the hash
with everything in the answer, such as the progress.  ``If-Match`` compares the versions only:
progress of a job does not make a change of its due time outdated.
"""

from __future__ import annotations

import hashlib
import json
from typing import Annotated, Final

from fastapi import Header
from pydantic.json_schema import SkipJsonSchema

from knifetip.errors import StaleVersion
from knifetip.service.database.tables import Job
from knifetip.service.http.revisions import tags

JobMatch = Annotated[
    str | SkipJsonSchema[None],  # a header is never null
    Header(
        alias="If-Match",
        max_length=200,
        description="ETag of the job on which the change is based; 412 if priority, copies, hold "
        "or details of the order were changed since. Progress of the job is no change",
    ),
]
_CHANGEABLE: Final = (
    *("priority", "copies", "on_hold", "machine"),
    *("external_id", "customer", "due", "notes", "extra"),
)


def job_version(row: Job) -> str:
    """Return the version of what a request can change in a job, as the start of its ETag."""
    values = [getattr(row, name) for name in _CHANGEABLE]
    text = json.dumps(values, sort_keys=True, default=str)
    return hashlib.sha256(text.encode()).hexdigest()[:16]


def check_job_match(match: str | None, row: Job) -> None:
    """Raise ``StaleVersion`` if an If-Match header has another version of a job.

    Parameters
    ----------
    match
        The header.  There is no error if it is ``*``, or None (the request has no such header).
    row
        The job.
    """
    if match is None or "*" in tags(match):
        return
    if job_version(row) not in [tag.partition(".")[0] for tag in tags(match)]:
        raise StaleVersion("job.changed", job=row.id)
