"""Metrics of a server in the format of Prometheus (ADR 84).

Each server has a registry of its own and reports its own numbers; those of the database are equal
on all servers.  Labels are bounded: routes by their template, never by the path of a request.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Iterator
from typing import Final

import sqlalchemy.exc
from fastapi import Request, Response
from fastapi.routing import APIRoute, iter_route_contexts
from prometheus_client import CollectorRegistry, Counter, Histogram, generate_latest
from prometheus_client.core import CounterMetricFamily, GaugeMetricFamily, Metric
from prometheus_client.registry import Collector
from starlette.routing import BaseRoute
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from knifetip.api.client_limits import Clients
from knifetip.api.routing import ScopedRouter, requires
from knifetip.api.service import Service, ServiceDep
from knifetip.jobs.accounts.scopes import AccessScope
from knifetip.jobs.measures import Measures, measure
from knifetip.model.stage import Stage

_MACHINES: Final = 100  # machines with a label of their own
_METHODS: Final = frozenset({"GET", "HEAD", "POST", "PUT", "PATCH", "DELETE", "OPTIONS"})
_CONTENT: Final = "text/plain; version=0.0.4; charset=utf-8"
_SECONDS: Final = (0.005, 0.01, 0.025, 0.05, 0.1, 0.25, 0.5, 1.0, 2.5, 5.0, 10.0, 30.0, 60.0, 120.0)

router = ScopedRouter(tags=["health"])


class Metrics:
    """The metrics of one server."""

    def __init__(self) -> None:
        self.registry = CollectorRegistry()
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
            buckets=_SECONDS,
            registry=self.registry,
        )
        self.stages = Histogram(
            "knifetip_compile_stage_seconds",
            "Duration of the stages of compiles in this process.",
            ("stage",),
            buckets=_SECONDS,
            registry=self.registry,
        )

    def observe_stage(self, stage: Stage, seconds: float) -> None:
        """Count a stage of a compile that has ended."""
        self.stages.labels(stage.value).observe(seconds)


class Numbers(Collector):
    """Numbers that are read when the metrics are requested.

    Parameters
    ----------
    database
        Returns the numbers of the database.
    process
        Returns the numbers of this process by name of the metric.
    """

    def __init__(
        self, database: Callable[[], Measures], process: Callable[[], dict[str, tuple[str, float]]]
    ) -> None:
        self._database = database
        self._process = process

    def describe(self) -> Iterable[Metric]:
        """Return nothing: the database must not be queried when the collector is registered."""
        return ()

    def collect(self) -> Iterator[Metric]:
        """Yield the present numbers; only whether it is available if the database is not."""
        for name, (text, value) in self._process().items():
            kind = CounterMetricFamily if name.endswith("_total") else GaugeMetricFamily
            yield kind(f"knifetip_{name}", text, value=value)
        try:
            found = self._database()
        except sqlalchemy.exc.SQLAlchemyError:
            yield _available(0)
            return
        yield _available(1)
        jobs = GaugeMetricFamily(
            "knifetip_jobs", "Jobs that have not ended.", labels=("machine", "state")
        )
        for (machine, state), count in found.jobs.items():
            jobs.add_metric((machine, state), count)
        yield jobs
        silent = GaugeMetricFamily(
            "knifetip_gateway_silent_seconds",
            "Seconds since the last request of a gateway of the machine.",
            labels=("machine",),
        )
        for machine, seconds in found.silent.items():
            silent.add_metric((machine,), seconds)
        yield silent
        yield GaugeMetricFamily(
            "knifetip_webhook_deliveries_pending",
            "Webhook deliveries that wait or are tried again.",
            value=found.deliveries,
        )


def _available(value: int) -> Metric:
    return GaugeMetricFamily(
        "knifetip_database_available", "1 if the database answers.", value=value
    )


class CountRequests:
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
            method = scope["method"] if scope["method"] in _METHODS else "other"
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

    def process() -> dict[str, tuple[str, float]]:
        size, busy = service.pool.size, service.pool.busy
        return {
            "event_listeners": ("Open streams of events.", clients.listeners.total()),
            "processes": ("Greatest number of worker processes.", size),
            "processes_busy": ("Worker processes that execute a task.", busy),
            "work_waiting": ("Requests that wait for a worker process.", service.work.waiting),
            "orders_waiting": ("Orders that wait to be stored.", service.orders.waiting),
            "leases_expired_total": (
                "Jobs that this process took back from silent workers and gateways.",
                service.store.leases.taken_back,
            ),
        }

    database = service.store.database
    metrics.registry.register(Numbers(lambda: measure(database, _MACHINES), process))


@router.get("/metrics", include_in_schema=False)
@requires(AccessScope.VIEWER)
async def get_metrics(request: Request, service: ServiceDep) -> Response:
    """Get the metrics of this server in the text format of Prometheus."""
    metrics: Metrics = request.app.state.metrics
    # The threads of the shared pool may all be occupied by uploads.
    text = await service.threads.reports(generate_latest, metrics.registry)
    return Response(text, media_type=_CONTENT)
