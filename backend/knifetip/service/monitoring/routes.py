"""Metrics of a server in the format of Prometheus (ADR 84).

Each server has a registry of its own and reports its own numbers; those of the database are equal
on all servers.  Labels are bounded: routes by their template, never by the path of a request.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable
from typing import Final

from fastapi import Request, Response
from fastapi.routing import APIRoute, iter_route_contexts
from prometheus_client import Counter, Histogram, generate_latest
from starlette.routing import BaseRoute
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from knifetip.service.components import Service, ServiceDep
from knifetip.service.http.principal import PrincipalDep, demand_all_customers
from knifetip.service.http.routing import ScopedRouter, requires
from knifetip.service.http.scopes import AccessScope
from knifetip.service.limits.clients import Clients
from knifetip.service.monitoring.metrics import SECONDS, CompileMetrics, add_database

#: Methods that are counted and traced by name.
METHODS: Final = frozenset({"GET", "HEAD", "POST", "PUT", "PATCH", "DELETE", "OPTIONS"})
_CONTENT: Final = "text/plain; version=0.0.4; charset=utf-8"

router = ScopedRouter(tags=["health"])


class Metrics(CompileMetrics):
    """The metrics of one server."""

    def __init__(self) -> None:
        super().__init__()
        self.requests = Counter(
            "knifetip_requests",
            "Requests by template of the route and status.",
            ("method", "route", "status"),
            registry=self.registry,
        )
        self.seconds = Histogram(
            "knifetip_request_seconds",
            "Duration of requests, without streams of events and waiting claims.",
            ("method", "route"),
            buckets=SECONDS,
            registry=self.registry,
        )


class RequestCounter:
    """ASGI middleware that counts requests and measures their time."""

    def __init__(
        self, app: ASGIApp, metrics: Metrics, templates: Callable[[object], str | None]
    ) -> None:
        self.app = app
        self._metrics = metrics
        self._templates = templates

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Forward a request and count it."""
        if scope["type"] != "http":
            await self.app(scope, receive, send)
            return
        status = 499  # the client has disconnected before the answer
        begun = time.monotonic()

        async def send_counted(event: Message) -> None:
            nonlocal status
            if event["type"] == "http.response.start":
                status = event["status"]
            await send(event)

        try:
            await self.app(scope, receive, send_counted)
        finally:
            template = self._templates(scope.get("endpoint"))
            method = scope["method"] if scope["method"] in METHODS else "other"
            route = template or "other"
            self._metrics.requests.labels(method, route, str(status)).inc()
            if route not in ("/api/events", "/api/gateway/claim"):
                self._metrics.seconds.labels(method, route).observe(time.monotonic() - begun)


def route_templates(routes: Iterable[BaseRoute]) -> Callable[[object], str | None]:
    """Return a function that returns the template of the path of an endpoint, or None."""
    found: dict[object, str] = {}
    for context in iter_route_contexts(list(routes)):
        route = context.original_route
        if isinstance(route, APIRoute):
            found[route.endpoint] = context.path or ""
    return found.get


def add_numbers(metrics: Metrics, service: Service, clients: Clients) -> None:
    """Add the numbers of a server and of its database to its metrics."""

    def process_numbers() -> dict[str, tuple[str, float]]:
        size, busy = service.pool.size, service.pool.busy
        return {
            "event_listeners": ("Open streams of events.", clients.listeners.total()),
            "processes": ("Greatest number of worker processes.", size),
            "processes_busy": ("Worker processes that execute a task.", busy),
            "processes_started_total": (
                "Worker processes started so far.",
                service.pool.processes_started,
            ),
            "work_waiting": ("Requests that wait for a worker process.", service.work.waiting),
            "orders_waiting": ("Orders that wait to be stored.", service.orders.waiting),
            "leases_expired_total": (
                "Jobs that this process took back from silent workers and gateways.",
                service.store.leases.taken_back,
            ),
        }

    add_database(metrics.registry, service.store.database, process_numbers)


@router.get("/metrics", include_in_schema=False)
@requires(AccessScope.VIEWER)
async def get_metrics(request: Request, service: ServiceDep, principal: PrincipalDep) -> Response:
    """Get the metrics of this server in the text format of Prometheus."""
    demand_all_customers(principal)
    metrics: Metrics = request.app.state.metrics
    # The threads of the shared pool may all be occupied by uploads.
    text = await service.threads.reports(generate_latest, metrics.registry)
    return Response(text, media_type=_CONTENT)
