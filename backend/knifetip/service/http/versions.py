"""Versions of profiles, machines, boards and tools as If-Match, and requests that contain TOML."""

from __future__ import annotations

import re
from typing import Annotated, Any, Final

from fastapi import Depends, Header, Request
from pydantic.json_schema import SkipJsonSchema

from knifetip.errors import RequestError
from knifetip.service.http.conditional import NOT_MODIFIED

TOML: Final = "application/toml"
#: OpenAPI responses of a route that sends TOML.
TOML_RESPONSE: Final[dict[int | str, dict[str, Any]]] = {
    200: {"content": {TOML: {"schema": {"type": "string"}}}},
    **NOT_MODIFIED,
}
_VERSION: Final = r'(?:W/)?"?(\d{1,9})"?'
VersionMatch = Annotated[
    str | SkipJsonSchema[None],  # a header is never null
    Header(
        alias="If-Match",
        max_length=40,
        # For the description only: the error of the routes contains a hint.
        json_schema_extra={"pattern": rf"^(\*|{_VERSION})$"},
        description="ETag of the version on which the change is based; * for any version",
    ),
]


async def _body(request: Request) -> bytes:
    return await request.body()


Body = Annotated[bytes, Depends(_body)]


def version_of(match: str | None) -> tuple[int | None, bool]:
    """Return the version in an If-Match header, and whether the header is ``*``.

    The version is None if the header is missing or ``*``, which matches any version.

    Raises
    ------
    RequestError
        The header is neither a version number nor ``*``.
    """
    if match is None:
        return None, False
    if match.strip() == "*":
        return None, True
    version = re.fullmatch(rf"\s*{_VERSION}\s*", match)
    if version is None:
        raise RequestError("library.bad-if-match", match=match)
    return int(version[1]), False
