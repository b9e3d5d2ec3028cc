"""Pages of lists, and the header ``Link`` to the next one."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeVar
from urllib.parse import urlencode

from fastapi import Request, Response

from knifetip.service.http.models import ListPage

T = TypeVar("T")


def set_next_page(
    request: Request, response: Response, cursor: int | str | None, limit: int
) -> None:
    """Set the header ``Link`` of a response to the URL of the next page of a list.

    Parameters
    ----------
    request
        Request for this page; the URL has its other parameters.
    response
        Response whose header is set.
    cursor
        Position of the next page in the list.  If it is None, there is no next page, and no header
        is set.
    limit
        Maximum number of items per page.
    """
    if cursor is None:
        return
    kept = [
        (name, value)
        for name, value in request.query_params.multi_items()
        if name not in ("cursor", "limit")
    ]
    query = urlencode([*kept, ("cursor", cursor), ("limit", limit)])
    response.headers["Link"] = f'<{request.url.path}?{query}>; rel="next"'


def page_of(
    request: Request, response: Response, rows: Sequence[T], wanted: ListPage
) -> Sequence[T]:
    """Return the wanted part of a list, and set the header ``Link`` to the next one.

    Parameters
    ----------
    request, response
        The request, and the response that gets the header.
    rows
        The whole list.
    wanted
        Begin and length of the part.
    """
    first = wanted.cursor or 0
    end = first + wanted.limit
    set_next_page(request, response, end if end < len(rows) else None, wanted.limit)
    return rows[first:end]
