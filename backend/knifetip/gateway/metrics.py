"""Metrics of a gateway in the format of Prometheus."""

from __future__ import annotations

from typing import Final

from prometheus_client import CollectorRegistry, Counter, Histogram

#: Limits of the buckets of durations of runs (s).
_SECONDS: Final = (1.0, 5.0, 15.0, 30.0, 60.0, 120.0, 300.0, 600.0, 1800.0, 3600.0)


class RunMetrics:
    """The metrics of the runs of jobs on one machine."""

    def __init__(self, machine: str) -> None:
        self.registry = CollectorRegistry()
        self._machine = machine
        self._runs = Counter(
            "knifetip_gateway_runs",
            "Claimed jobs that ended, by the outcome that was reported to the server.",
            ("machine", "outcome"),
            registry=self.registry,
        )
        self._seconds = Histogram(
            "knifetip_gateway_run_seconds",
            "Time from the claim of a job to its end, with the wait for the operator.",
            ("machine",),
            buckets=_SECONDS,
            registry=self.registry,
        )
        self._seconds.labels(machine)  # a series from the start, so that a rate shows the first run

    def observe(self, outcome: str, seconds: float) -> None:
        """Count a run that has ended with an outcome after some seconds."""
        self._runs.labels(self._machine, outcome).inc()
        self._seconds.labels(self._machine).observe(seconds)
