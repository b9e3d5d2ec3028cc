"""Settings and components of a server, and helper functions for several routes."""

from __future__ import annotations

import hashlib
import re
import threading
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Annotated, Any, TypeVar
from urllib.parse import urlencode

from fastapi import Depends, Request, Response

from knifetip import tracing
from knifetip.api.access_rules import AccessRules
from knifetip.api.answered_questions import AnsweredQuestions
from knifetip.api.client_limits import ClientLimits
from knifetip.api.oidc.settings import OidcSettings
from knifetip.api.queue import WAITING, WorkQueue
from knifetip.api.schemas.common import ListPage
from knifetip.api.threads import GatewayThreads
from knifetip.errors import LibraryError, WrongState
from knifetip.jobs.accounts.acting import acting_limits
from knifetip.jobs.changes import ALL
from knifetip.jobs.compile_service import LIMIT
from knifetip.jobs.process_pool import ProcessPool
from knifetip.jobs.reported_stages import reported_stages
from knifetip.jobs.store import Store
from knifetip.jobs.warm_up import WarmUp
from knifetip.library import load
from knifetip.model.stage import Stage

MEGABYTE = 1 << 20
T = TypeVar("T")


@dataclass(frozen=True, slots=True)
class Settings:
    """Settings of a server."""

    database: str = "sqlite:///knifetip.sqlite"
    store: str = ""  #: folder or bucket for large values, see ``open_objects``; "" for none
    compiles: bool = True  #: False if compile workers run in other processes
    name: str = ""  #: unique name of this process, the same after a restart; "" for a default
    processes: int = 2  #: processes that read and compile
    waiting: int = WAITING  #: maximum number of requests that wait for a process
    limit: float = LIMIT  #: time limit of reading or compiling (s)
    upload: int = 64 * MEGABYTE  #: maximum size of a drawing (bytes)
    body: int = 16 * MEGABYTE  #: maximum size of other requests (bytes)
    keep_history: int = 0  #: days for which ended jobs are kept; 0 for no limit
    keep_drawings: int = 0  #: days for which drawings without jobs are kept; 0 for no limit
    archive: Path | None = None  #: folder for a zip file of what is deleted; None for none
    webhook_private: bool = True  #: webhooks may be sent to loopback and private addresses
    page: Path = Path(__file__).parent / "page"  #: folder of the built page
    least_free: int = 256 * MEGABYTE  #: bytes that must remain free on the disk of the database
    access: AccessRules = field(default_factory=AccessRules)  #: access rules
    oidc: OidcSettings | None = None  #: provider at which users can sign in
    clients: ClientLimits = field(default_factory=ClientLimits)  #: limits of each client


@dataclass(slots=True)
class Service:
    """Components of one server, such as its store and its worker processes, for its routes."""

    settings: Settings
    store: Store
    pool: ProcessPool
    work: WorkQueue
    orders: WorkQueue  #: of orders, which need no worker process
    warm_up: WarmUp
    answered: AnsweredQuestions = field(default_factory=AnsweredQuestions)
    threads: GatewayThreads = field(default_factory=GatewayThreads)
    stopping: threading.Event = field(default_factory=threading.Event)
    ready: bool = False

    def stop(self) -> None:
        """End the event streams and the waiting claims of gateways, because the server stops."""
        self.stopping.set()
        self.store.changes.receive((ALL,))

    def run(self, task: Callable[..., T], *arguments: object) -> T:
        """Run ``task`` with the given arguments in a worker process, wait, and return its result.

        The task runs to its end even if the client of the request has gone.

        Raises
        ------
        KnifetipError
            The task raised this error, the task exceeded its time limit or memory limit, or the
            worker process died.
        TaskCancelled
            The server was stopped.
        TaskFailed
            The task raised an exception that is not a KnifetipError.
        """
        self.warm_up.wait("drawings")
        with tracing.span(f"task {task.__name__}"), reported_stages() as stages:

            def watch(stage: Stage, _fraction: float) -> bool:
                stages.enter(stage)
                return True

            return self.pool.run(task, *arguments, limit=self.settings.limit, watch=watch)


# A coroutine: FastAPI would run a plain function on a thread of the shared pool.
async def _service(request: Request) -> Service:
    service: Service = request.app.state.service
    return service


ServiceDep = Annotated[Service, Depends(_service)]
BINARY: dict[str, Any] = {
    "content": {"application/octet-stream": {"schema": {"type": "string", "format": "binary"}}}
}


def fingerprint(*parts: str | bytes) -> str:
    """Return a SHA-256 hash of the contents of a request, in hexadecimal digits.

    The contents are the positional arguments, texts or bytes.  The hash shows whether two requests
    with the same Idempotency-Key are equal.
    """
    digest = hashlib.sha256()
    for part in parts:
        block = part.encode("utf-8", "replace") if isinstance(part, str) else part
        digest.update(len(block).to_bytes(8, "big") + block)
    return digest.hexdigest()


def check_library_name(shelf: str, name: str) -> str:
    """Return ``name`` unchanged if the library has an entry with this name.

    Parameters
    ----------
    shelf
        Kind of the entry: "machines", "boards" or "profiles".
    name
        Name of the entry; the path of a file is not accepted as a name.

    Raises
    ------
    LibraryError
        The library has no entry of this kind with this name.
    """
    known = load.names(shelf)
    if name not in known:
        raise LibraryError(
            "library.unknown", shelf=shelf.removesuffix("s"), name=name[:80], known=known
        )
    return name


def customer_rules(service: Service, name: str) -> str:
    """Return the TOML text of a customer's profile, or "" for a profile of the library.

    Parameters
    ----------
    service
        The server.
    name
        Name of the profile.

    Raises
    ------
    LibraryError
        There is no profile with this name.
    """
    row = service.store.profiles.get(name)
    if row is not None:
        return row.text
    known = load.names("profiles")
    if name not in known:
        if not acting_limits().customer:
            known = [*(row.name for row in service.store.profiles.all()), *known]
        raise LibraryError("library.unknown", name=name[:80], known=known[:40], shelf="profile")
    return ""


def require_customer_profile(service: Service, name: str) -> None:
    """Raise WrongState if the profile ``name`` belongs to the library and so cannot be changed."""
    if name in load.names("profiles") and service.store.profiles.get(name) is None:
        raise WrongState("profile.shipped", name=name)


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


def bytes_response(content: bytes, tag: str, media: str, attachment: str = "") -> Response:
    """Return a response with bytes and their ETag, for a route that declares ``NOT_MODIFIED``.

    Parameters
    ----------
    content
        The bytes.
    tag
        ETag without quotation marks.
    media
        Media type.
    attachment
        Name under which a browser saves the bytes; "" to let the browser show them.
    """
    headers = {"ETag": f'"{tag}"', "Cache-Control": "no-cache"}
    if attachment:
        headers["Content-Disposition"] = f'attachment; filename="{file_name(attachment)}"'
    return Response(content, media_type=media, headers=headers)


def file_name(name: str) -> str:
    """Return a portable file name made from a name.

    It consists of letters (A to Z), digits, dots, dashes and underscores.  One dash replaces each
    sequence of other characters.  Dots and dashes at both ends are removed, and only the last 100
    characters are kept.  The result is "knifetip" if nothing is left.
    """
    plain = re.sub(r"[^A-Za-z0-9._-]+", "-", name).strip("-.")
    return plain[-100:] or "knifetip"
