"""Headers, query parameters and path parameters that several routes have."""

from __future__ import annotations

from typing import Annotated, Any, Final, Literal

from fastapi import Depends, Header, Path, Query, Request
from pydantic import JsonValue
from pydantic.json_schema import SkipJsonSchema

from knifetip.fields import LISTED
from knifetip.library.definition import NAME_PATTERN
from knifetip.service.database.request_key import RequestKey, fingerprint

IDEMPOTENCY_KEY: Final = "Idempotency-Key"
LONGEST_KEY: Final = 200
IdempotencyKey = Annotated[
    str | SkipJsonSchema[None],  # a header is never null
    Header(
        alias=IDEMPOTENCY_KEY,
        min_length=1,
        max_length=LONGEST_KEY,
        description="Text chosen by the client, such as a UUID. A request that is repeated with "
        "the same key has no further effect and gets the drawing or the job of the first; with "
        "the same key and another content it is refused with 422. Each user and each API key has "
        "keys of its own",
    ),
]
#: The header of a request whose answer is kept: see ``repeated_requests``.
KEPT_ANSWER: Final[dict[str, Any]] = {
    "name": IDEMPOTENCY_KEY,
    "in": "header",
    "required": False,
    "description": "Text chosen by the client, such as a UUID. A request that is repeated with the "
    "same key is not executed again; it gets the answer of the first, with the header "
    "`Idempotency-Replayed`. With another content it is refused with 422. The status is 409 if "
    "the first answer had a secret, which is not kept, or if its outcome is not known. Answers "
    "are kept for seven days",
    "schema": {"type": "string", "minLength": 1, "maxLength": LONGEST_KEY},
}


async def _command_key(request: Request, key: IdempotencyKey = None) -> RequestKey | None:
    """Return the key of a command, with a hash of its path and its body."""
    if key is None:
        return None
    return RequestKey(key, fingerprint(request.method, request.url.path, await request.body()))


CommandKey = Annotated[RequestKey | None, Depends(_command_key)]
DrawingId = Annotated[str, Path(description="Id of the drawing")]
JobId = Annotated[str, Path(description="Id of the job")]
MachineName = Annotated[str, Path(description="Name of the machine in the library")]
StationNumber = Annotated[int, Path(description="Number of the station in the machine")]
OperationId = Annotated[str, Path(description="Id of the operation")]
BoardName = Annotated[str, Path(description="Name of the board in the library")]
ProfileName = Annotated[str, Path(description="Name of the classification profile")]
#: Pattern of the name of a new entry, for the OpenAPI description only: the routes check names
#: themselves, so that their errors contain a hint.
NAME_SCHEMA: Final[dict[str, JsonValue]] = {"pattern": f"^{NAME_PATTERN}$"}
NewProfileName = Annotated[
    str, Path(description="Name of the classification profile", json_schema_extra=NAME_SCHEMA)
]
_COLUMNS: Final = (
    "`columns` for arrays in one block of bytes: KTIP, the length of the header (uint32, "
    "little-endian), the header (JSON with name, dtype, shape and offset of each array), and the "
    "arrays"
)
DataFormat = Annotated[
    Literal["json", "columns"],
    LISTED,
    Query(description=f"Format of the response: `json`, or {_COLUMNS}"),
]
EdgesFormat = Annotated[
    Literal["json", "columns", "drawn"],
    LISTED,
    Query(
        description=f"Format of the response: `json`; {_COLUMNS}; or `drawn` for arrays as well, "
        "of which a drawing with many edges has only those that a picture needs: ends and bulges "
        "in single precision about the point `origin`, line types and outcomes"
    ),
]
