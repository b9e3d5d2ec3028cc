"""The FastAPI application; all errors are returned as application/problem+json (RFC 9457)."""

from __future__ import annotations

import asyncio
import logging
import re
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from functools import partial
from importlib.metadata import version
from typing import Literal

from fastapi import Depends, FastAPI, Request, Response
from fastapi.exceptions import RequestValidationError
from fastapi.responses import RedirectResponse
from fastapi.routing import APIRoute
from starlette.exceptions import HTTPException

from knifetip import errors, tracing
from knifetip.messages import Message
from knifetip.service.accounts import routes as accounts
from knifetip.service.accounts.access import Access, ProviderSignIn
from knifetip.service.accounts.access_rules import AccessRules
from knifetip.service.accounts.account_access import Accounts
from knifetip.service.cartons import routes as cartons
from knifetip.service.compiling.service import CompileService
from knifetip.service.components import Service, ServiceDep
from knifetip.service.content.objects import folder_of
from knifetip.service.database.write_probe import write_probe
from knifetip.service.description.openapi import Description
from knifetip.service.documents.responses import Documents
from knifetip.service.drawings import customer_answer_routes as customer_answers
from knifetip.service.drawings import routes as drawings
from knifetip.service.events import routes as events
from knifetip.service.folding import routes as folding
from knifetip.service.gateways import routes as gateway
from knifetip.service.handover import routes as handover
from knifetip.service.history import export as job_export
from knifetip.service.history import routes as history
from knifetip.service.history.retention import run_content_sweep, run_retention
from knifetip.service.http.api_version import ApiVersion
from knifetip.service.http.head_requests import HeadRequests
from knifetip.service.http.headers import SecurityHeaders
from knifetip.service.http.models import Health, ServiceOut
from knifetip.service.http.problems import TYPE_PREFIX, ProblemKind, problem
from knifetip.service.http.routing import (
    ScopedRouter,
    methods_at,
    public,
    requires,
    scoped_operations,
)
from knifetip.service.http.scopes import AccessScope
from knifetip.service.http.site import Site
from knifetip.service.layouts import routes as layouts
from knifetip.service.library import definition_routes as definitions
from knifetip.service.library import routes as library
from knifetip.service.limits.bodies import Limits
from knifetip.service.limits.clients import ClientLimiter, ClientLimits, Clients
from knifetip.service.limits.disk_space import OK, DiskSpaceGuard, Storage
from knifetip.service.limits.work_queue import ORDERS_AT_ONCE, ORDERS_WAITING, WorkQueue
from knifetip.service.machines import routes as machines
from knifetip.service.monitoring.fault_log import FaultLog
from knifetip.service.monitoring.readiness import Readiness
from knifetip.service.monitoring.request_log import RequestLog
from knifetip.service.monitoring.request_spans import RequestSpans
from knifetip.service.monitoring.routes import Metrics, RequestCounter, add_numbers, route_templates
from knifetip.service.monitoring.routes import router as metrics_router
from knifetip.service.nestings import routes as nestings
from knifetip.service.nestings.runner import NestingRunner
from knifetip.service.orders import command_routes as job_commands
from knifetip.service.orders import confirmation_routes as confirmation
from knifetip.service.orders import order_routes as orders
from knifetip.service.orders import registration_routes as registration
from knifetip.service.orders import rest_routes as rest
from knifetip.service.orders import routes as jobs
from knifetip.service.orders import section_routes as sections
from knifetip.service.processes.pool import ProcessPool, TaskCancelled, TaskFailed
from knifetip.service.processes.tasks import import_stages
from knifetip.service.processes.warm_up import WarmUp
from knifetip.service.profiles import routes as profiles
from knifetip.service.queues import routes as queues
from knifetip.service.refusals.control_characters import refuse_control_characters
from knifetip.service.refusals.error_status import answer_status
from knifetip.service.refusals.failures import DATABASE_ERRORS, failure_of
from knifetip.service.refusals.invalid_requests import invalid_request, with_line
from knifetip.service.refusals.known_fields import names_near, refuse_unknown
from knifetip.service.settings import Settings
from knifetip.service.stock import routes as stock
from knifetip.service.store import Store
from knifetip.service.testpieces import routes as testpieces
from knifetip.service.tools import routes as tools
from knifetip.service.webhooks import routes as webhooks
from knifetip.service.webhooks.sender import WebhookSender
from knifetip.service.xjdf import routes as xjdf

_log = logging.getLogger("knifetip.api")

_ROUTES = (
    drawings, customer_answers, cartons, layouts, nestings, stock, jobs, job_commands, orders,
    confirmation, registration, queues, rest, history, events, machines, tools, library,
    definitions, testpieces, profiles, webhooks, xjdf, gateway, accounts, folding, handover,
    sections,
)  # fmt: skip


def create_app(settings: Settings | None = None, rules: AccessRules | None = None) -> FastAPI:
    """Return a new FastAPI application of the server.

    When the application starts, it migrates the database and starts the worker processes.

    Parameters
    ----------
    settings
        Settings of the server; None for the default settings.
    rules
        Rules of access; None to serve this computer only, without a key.
    """
    chosen = settings or Settings()
    rules = rules or AccessRules()
    storage = Storage(chosen.url, chosen.free_bytes, folder_of(chosen.store))
    clients = Clients(
        ClientLimits(
            rate=chosen.max_rate,
            burst=chosen.max_burst,
            listeners=chosen.max_listeners,
            all_listeners=chosen.all_listeners,
        )
    )
    metrics = Metrics()
    access = Accounts()

    @asynccontextmanager
    async def lifespan(app: FastAPI) -> AsyncIterator[None]:
        store = Store(chosen.url, objects=chosen.store)
        pool = ProcessPool(chosen.processes, prepare=import_stages, spare=1)
        warm_up = WarmUp() if chosen.compiles else WarmUp(("drawings",))
        compiling = CompileService(
            store,
            pool,
            chosen.name,
            chosen.compiles,
            # One process is kept free for reading drawings, since a user waits for that.
            max(1, chosen.processes - 1),
            chosen.time_limit,
            warm_up=warm_up,
            observe=metrics.observe_stage,
            observe_compile=metrics.compiles.observe,
        )
        # One thread more than processes, so that none is idle while a request is parsed.
        work = WorkQueue(
            chosen.processes + 1, chosen.max_waiting, per_client=max(1, chosen.processes - 1)
        )
        # One thread commits while the others prepare; more would only wait for the database.
        placing = WorkQueue(ORDERS_AT_ONCE, ORDERS_WAITING, per_client=ORDERS_AT_ONCE - 1)
        service = Service(chosen, rules, store, pool, work, placing, warm_up)
        app.state.service = service
        app.state.documents = Documents(service)
        app.state.nestings = NestingRunner(store.nestings)
        app.state.readiness = Readiness(store, storage, compiling, service.threads)
        app.state.faults = FaultLog(partial(write_probe, store.database))
        app.state.stream = events.Stream(service)
        add_numbers(metrics, service, clients)
        await asyncio.to_thread(store.prepare)
        access.store = store
        await asyncio.to_thread(compiling.start)
        tasks = [
            asyncio.create_task(app.state.stream.run()),
            asyncio.create_task(run_retention(service)),
            asyncio.create_task(run_content_sweep(store.contents)),
            asyncio.create_task(WebhookSender(service).run()),
        ]
        service.ready = True
        app.state.readiness.damage.fault()  # begins the first check
        try:
            yield
        finally:
            service.ready = False
            await app.state.faults.close()
            service.stop()
            await asyncio.to_thread(app.state.nestings.stop)
            for task in tasks:
                task.cancel()
            await asyncio.gather(*tasks, return_exceptions=True)
            await asyncio.to_thread(compiling.stop)
            work.close()
            placing.close()
            service.threads.close()
            access.close()
            store.close()

    app = FastAPI(
        title="knifetip",
        version=version("knifetip"),
        description="Carton dielines in, compensated and verified machine programs out. Every "
        "resource with GET also answers HEAD, with the same headers and without a body.",
        lifespan=lifespan,
        # ``Description`` serves it with the paths of either prefix.
        openapi_url=None,
        # These pages load scripts from the internet, which a shop floor may not reach.
        docs_url=None,
        redoc_url=None,
        generate_unique_id_function=_operation_id,
        dependencies=[Depends(refuse_unknown), Depends(refuse_control_characters)],
        # Spans and logs of FastAPI contain queries, which may contain a key, and texts of errors.
        telemetry={"tracing": False, "metrics": False, "logs": False, "auto_configure": False},
    )
    for module in _ROUTES:
        app.include_router(module.router, prefix="/api")
    app.include_router(job_export.router, prefix="/api")
    app.include_router(_health_router)
    app.include_router(metrics_router)
    # Raises if a route declares no scope.
    description = Description(app, tuple(scoped_operations(app.routes)))
    app.add_route("/api/openapi.json", description.answer, include_in_schema=False)
    app.state.accounts = access
    site = Site(chosen.page)
    app.add_route("/api/docs", site.description_page, include_in_schema=False)
    app.add_route("/docs", _to_description, include_in_schema=False)
    app.router.default = site
    # The middleware added last is the outermost.
    app.add_middleware(HeadRequests)
    app.add_middleware(Limits, upload=chosen.upload_bytes, body=chosen.body_bytes)
    app.add_middleware(DiskSpaceGuard, storage=storage)
    app.add_middleware(ClientLimiter, clients=clients)
    app.add_middleware(
        Access,
        rules=rules,
        accounts=access,
        provider=_provider(chosen, access),
        clients=clients,
    )
    app.add_middleware(SecurityHeaders)
    templates = route_templates(app.routes)
    app.add_middleware(RequestCounter, metrics=metrics, templates=templates)
    app.add_middleware(ApiVersion)
    app.add_middleware(RequestLog)
    if tracing.is_on():
        app.add_middleware(RequestSpans, templates=templates)
    app.add_exception_handler(errors.KnifetipError, _knifetip_problem)
    app.add_exception_handler(RequestValidationError, _request_problem)
    app.add_exception_handler(HTTPException, _http_problem)
    # FastAPI sends the answer to an ``Exception`` and raises it again, for the log of the server.
    for expected in (TaskCancelled, TaskFailed, *DATABASE_ERRORS, OSError, Exception):
        app.add_exception_handler(expected, _failure_problem)

    app.state.metrics = metrics
    # The documented way to customise FastAPI's schema.
    app.openapi = description.describe_version  # type: ignore[method-assign]  # mypy permits no assignment to methods
    return app


def _provider(settings: Settings, accounts: Accounts) -> ProviderSignIn | None:
    found = settings.sign_in_provider()
    if found is None:
        return None
    from knifetip.service.accounts.oidc.sign_in import OidcSignIn  # authlib is optional

    return OidcSignIn(found, accounts.sign_in_at_provider)


_health_router = ScopedRouter(tags=["health"])


@_health_router.get("/healthz")
@public
async def _health() -> Health:
    """Report that the server process is running."""
    return Health(status="ok", version=version("knifetip"))


@_health_router.get("/readyz")
@public
async def _ready(request: Request, service: ServiceDep, response: Response) -> Health:
    """Report whether the server can process requests; the HTTP status is 503 if it cannot.

    The server writes a test row to its database and, with --store, a test object to its folder or
    bucket, and checks the free disk space.  The results are cached for some seconds.
    """
    readiness: Readiness = request.app.state.readiness
    checks = await readiness.checks()
    if not service.ready:
        checks["workers"] = "starting"
    faults = {check for check in checks.values() if check != OK}
    status: Literal["ok", "starting", "failing"] = "ok" if not faults else "failing"
    if faults == {"starting"}:
        status = "starting"
    response.status_code = 503 if faults else 200
    return Health(status=status, version=version("knifetip"), checks=checks)


@_health_router.get("/api/service")
@requires(AccessScope.VIEWER, AccessScope.GATEWAY)
async def _status(service: ServiceDep) -> ServiceOut:
    """Get the version of the server, and its progress in compiling functions to machine code.

    The functions are compiled once after an installation; uploads and jobs wait until all of them
    are compiled.
    """
    progress = service.warm_up.progress
    return ServiceOut(
        version=version("knifetip"),
        preparing=not progress.finished,
        parts_compiled=progress.compiled,
        parts=progress.total,
    )


async def _knifetip_problem(request: Request, error: Exception) -> Response:
    assert isinstance(error, errors.KnifetipError)
    status = answer_status(error, request.method)
    kind = type(error)
    word = re.sub(r"(?<!^)(?=[A-Z])", "-", kind.__name__).lower()
    return problem(
        status,
        error.message,
        kind=ProblemKind(TYPE_PREFIX + word, word.replace("-", " ").capitalize()),
        source=error.source,
        edges=error.edges,
        questions=error.questions if isinstance(error, errors.OpenQuestions) else (),
        revision=error.revision if isinstance(error, errors.StaleRevision) else None,
        headers={"Retry-After": str(error.seconds)}
        if isinstance(error, (errors.ServerBusy, errors.SignInSlowDown))
        else {},
    )


async def _request_problem(request: Request, error: Exception) -> Response:
    assert isinstance(error, RequestValidationError)
    is_form = "form" in request.headers.get("content-type", "").partition(";")[0]
    faults = [with_line(one, error.body) for one in error.errors()]
    message, source = invalid_request(faults, partial(names_near, request), is_form)
    return problem(
        422,
        message,
        kind=ProblemKind(f"{TYPE_PREFIX}request", "The request cannot be read"),
        source=source,
    )


async def _http_problem(request: Request, error: Exception) -> Response:
    assert isinstance(error, HTTPException)
    path = request.url.path[:200]
    headers = error.headers
    match error.status_code:
        case 404:
            message = Message("request.nothing-there", path=path)
        case 405:
            message = Message("request.wrong-method", method=request.method, path=path)
            if methods := methods_at(request.app.routes, request.scope["path"]):
                headers = {"Allow": ", ".join(methods)}
        case 400:
            # FastAPI and Starlette raise this for a body that they cannot parse.
            message = Message("request.body-unreadable")
        case status:
            message = Message("request.refused", status=status)
    return problem(error.status_code, message, headers=headers)


async def _to_description(_request: Request) -> Response:
    return RedirectResponse("/api/docs")


async def _failure_problem(request: Request, error: Exception) -> Response:
    failure = failure_of(error)
    if failure.message.code == "server.database-damaged":
        request.app.state.readiness.damage.report()
    where = f"{request.method} {request.url.path}"
    if failure.is_logged and failure.affects_all:
        request.app.state.faults.note(failure.message.code, error, where)
    elif failure.is_logged:
        _log.error("%s", where, exc_info=error)
    return problem(failure.status, failure.message)


def _operation_id(route: APIRoute) -> str:
    return route.name.strip("_")
