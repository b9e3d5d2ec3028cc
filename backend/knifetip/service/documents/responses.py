"""Large responses, most of them JSON: made once by a worker process, stored, and sent as bytes.

The JSON of a drawing with 100,000 edges has 30 MB.  A thread of the server that made it would hold
Python's global interpreter lock and delay all other requests.  Small JSON is made by the thread of
the request, which takes some milliseconds.
"""

from __future__ import annotations

import asyncio
import logging
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Annotated, Final, Generic, NamedTuple, TypeVar

from fastapi import Depends, Request, Response
from fastapi.concurrency import run_in_threadpool
from fastapi.responses import StreamingResponse
from sqlalchemy.exc import SQLAlchemyError

from knifetip.service.components import Service
from knifetip.service.database.tables import Drawing, Job
from knifetip.service.http.compression import accepts_gzip, unpack
from knifetip.service.http.revisions import is_known
from knifetip.service.limits.work_queue import Client

Row = TypeVar("Row", Drawing, Job)

#: Number of rows from which a worker process makes a document.
LARGE: Final = 2000

_log = logging.getLogger("knifetip.api")


@dataclass(frozen=True, slots=True)
class Document(Generic[Row]):
    """A kind of large response about drawings or jobs: its source, its version and its task."""

    kind: str
    #: returns the row with an id, with these large columns; raises NotFound
    read: Callable[..., Row]
    columns: tuple[str, ...]  #: large columns from which it is made
    version: Callable[[Row], str]  #: changes whenever the document changes; the ETag
    is_large: Callable[[Row], bool]
    task: Callable[..., bytes]  #: returns the JSON as gzip data
    arguments: Callable[[Row], tuple[object, ...]]  #: of the task, from the row with its columns
    calculates: bool = False  #: whether a worker process makes it even if it is small
    media: str = "application/json"  #: media type


class BuiltDocument(NamedTuple):
    """A document of one version of a drawing or a job."""

    version: str
    content: bytes  #: gzip


class Documents:
    """The documents of a server; simultaneous requests for a document share one computation."""

    def __init__(self, service: Service) -> None:
        self._service = service
        self._making: dict[tuple[str, str, str], asyncio.Task[BuiltDocument]] = {}

    async def get(self, client: str, row: Row, document: Document[Row]) -> BuiltDocument:
        """Return a stored document; a worker process makes it if it is not stored.

        Parameters
        ----------
        client
            Name of the client in the ``WorkQueue``.
        row
            The drawing or the job.
        document
            Kind of the document.
        """
        version = document.version(row)
        content = await run_in_threadpool(
            self._service.store.documents.find, row, document.kind, version
        )
        if content is not None:
            return BuiltDocument(version, content)
        key = (document.kind, row.id, version)
        making = self._making.get(key)
        if making is None:
            # It is made even if this client disconnects, because others may wait for it.
            call = self._service.work.run(partial(self._make, row.id, document), Client(client))
            making = self._making[key] = asyncio.ensure_future(call)
            making.add_done_callback(lambda _: self._making.pop(key, None))
        return await asyncio.shield(making)

    def _make(self, id: str, document: Document[Row]) -> BuiltDocument:
        """Make a document in a worker process, and store it if it is large."""
        row = document.read(id, *document.columns)
        version = document.version(row)
        content = self._service.run(document.task, *document.arguments(row))
        if document.is_large(row):
            try:
                self._service.store.documents.keep(row, document.kind, version, content)
            except SQLAlchemyError as error:
                # The document is made again for the next request.
                _log.warning("a document was not stored: %s", error)
        return BuiltDocument(version, content)


def _make_here(id: str, document: Document[Row]) -> BuiltDocument:
    row = document.read(id, *document.columns)
    content = document.task(_no_progress, *document.arguments(row))
    return BuiltDocument(document.version(row), content)


def _no_progress(_stage: object, _fraction: float) -> None:
    pass


def _response(built: BuiltDocument, media: str, *, packed: bool) -> Response:
    headers = _headers(built.version, weak=packed)
    if packed:
        headers["Content-Encoding"] = "gzip"
        return Response(built.content, media_type=media, headers=headers)
    return StreamingResponse(unpack(built.content), media_type=media, headers=headers)


def _headers(version: str, *, weak: bool) -> dict[str, str]:
    """Return the headers of a version; the ETag of compressed data is weak (RFC 9110, 8.8.1)."""
    return {
        "ETag": f'{"W/" if weak else ""}"{version}"',
        "Cache-Control": "no-cache",
        "Vary": "Accept-Encoding",
    }


@dataclass(frozen=True, slots=True)
class Answer:
    """Sends a document as the response to one request."""

    documents: Documents
    request: Request

    async def send(self, id: str, document: Document[Row]) -> Response:
        """Return the response with a document; its status is 304 if the client has the document.

        Raises
        ------
        NotFound
            There is no drawing or job with this id.
        ServerBusy
            A worker process must make the document, and too many requests wait for one.
        """
        row = await run_in_threadpool(document.read, id)
        is_large = document.is_large(row)
        packed = is_large and accepts_gzip(self.request.headers)
        version = document.version(row)
        # Before the document is made.
        if is_known(f'"{version}"', self.request.headers.get("If-None-Match")):
            return Response(status_code=304, headers=_headers(version, weak=packed))
        if document.calculates or is_large:
            client = Client.from_request(self.request).name
            built = await self.documents.get(client, row, document)
        else:
            built = await run_in_threadpool(_make_here, id, document)
        return _response(built, document.media, packed=packed)


# A coroutine: FastAPI would run a plain function on a thread of the shared pool.
async def _answer(request: Request) -> Answer:
    return Answer(request.app.state.documents, request)


AnswerDep = Annotated[Answer, Depends(_answer)]
