"""Headers, query parameters and path parameters that several routes have."""

from __future__ import annotations

from typing import Annotated, Literal

from fastapi import Header, Path, Query

from knifetip.fields import LISTED

IdempotencyKey = Annotated[
    str | None,
    Header(
        alias="Idempotency-Key",
        min_length=1,
        max_length=200,
        description="Text chosen by the client; repeating a request with the same key returns the "
        "first result instead of creating a second drawing or job",
    ),
]
DrawingId = Annotated[str, Path(description="Id of the drawing")]
JobId = Annotated[str, Path(description="Id of the job")]
MachineName = Annotated[str, Path(description="Name of the machine in the library")]
StationNumber = Annotated[int, Path(description="Number of the station in the machine")]
OperationId = Annotated[str, Path(description="Id of the operation")]
BoardName = Annotated[str, Path(description="Name of the board in the library")]
ProfileName = Annotated[str, Path(description="Name of the classification profile")]
DataFormat = Annotated[
    Literal["json", "columns"],
    LISTED,
    Query(
        description="Format of the response: `json`, or `columns` for arrays in one block of "
        "bytes: KTIP, the length of the header (uint32, little-endian), the header (JSON with "
        "name, dtype, shape and offset of each array), and the arrays"
    ),
]
