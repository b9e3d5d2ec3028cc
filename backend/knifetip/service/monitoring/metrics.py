"""Metrics of compiles and of the database in the format of Prometheus, of servers and workers."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import Final

import sqlalchemy.exc
from prometheus_client import CollectorRegistry, Histogram
from prometheus_client.core import CounterMetricFamily, GaugeMetricFamily, Metric
from prometheus_client.registry import Collector

from knifetip.model.stage import Stage
from knifetip.service.compiling.service import CompileService
from knifetip.service.database.engine import Database
from knifetip.service.monitoring.measures import DatabaseMeasures, measure

#: Limits of the buckets of durations.
SECONDS: Final = (0.005, 0.01, 0.025, 0.05, 0.1, 0.25, 0.5, 1.0, 2.5, 5.0, 10.0, 30.0, 60.0, 120.0)
_MACHINES: Final = 100  # machines with a label of their own


class CompileMetrics:
    """The metrics of compiles of one process."""

    def __init__(self) -> None:
        self.registry = CollectorRegistry()
        self.stages = Histogram(
            "knifetip_compile_stage_seconds",
            "Duration of the stages of compiles in this process.",
            ("stage",),
            buckets=SECONDS,
            registry=self.registry,
        )
        self.compiles = Histogram(
            "knifetip_compile_seconds",
            "Duration of compiles in this process, also of those that were refused or answered.",
            buckets=SECONDS,
            registry=self.registry,
        )

    def observe_stage(self, stage: Stage, seconds: float) -> None:
        """Count a stage of a compile that has ended."""
        self.stages.labels(stage.value).observe(seconds)


def add_worker(metrics: CompileMetrics, service: CompileService) -> None:
    """Add the numbers of a worker and of its database to its metrics."""

    def process() -> dict[str, tuple[str, float]]:
        return {
            "processes": ("Greatest number of worker processes.", service.pool.size),
            "processes_busy": ("Worker processes that execute a task.", service.pool.busy),
        }

    add_database(metrics.registry, service.store.database, process)


def add_database(
    registry: CollectorRegistry,
    database: Database,
    process: Callable[[], dict[str, tuple[str, float]]],
) -> None:
    """Add the numbers of a database and of a process to a registry; see ``MeasuresCollector``."""
    registry.register(MeasuresCollector(lambda: measure(database, _MACHINES), process))


class MeasuresCollector(Collector):
    """Collector that reads numbers when the metrics are requested.

    Parameters
    ----------
    database
        Returns the numbers of the database.
    process
        Returns the numbers of this process by name of the metric.
    """

    def __init__(
        self,
        database: Callable[[], DatabaseMeasures],
        process: Callable[[], dict[str, tuple[str, float]]],
    ) -> None:
        self._database = database
        self._process = process

    def describe(self) -> Iterable[Metric]:
        """Return nothing: the database must not be queried when the collector is registered."""
        return ()

    def collect(self) -> Iterator[Metric]:
        """Yield the numbers of the process, and those of the database if it is available."""
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
