"""Kill processes, cut networks and step clocks of a running shop, then check its jobs."""

from __future__ import annotations

import logging
import time
from collections import Counter
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path
from random import Random
from subprocess import SubprocessError
from typing import Final

from knifetip.contract.job import State
from knifetip.service.store import Store
from tests.failures.operator import Operator, upload_drawings
from tests.failures.shop import SERVERS, WORKERS, Shop
from tests.failures.violations import JobRecord, Violations, check_jobs

_log = logging.getLogger(__name__)

_HOUR: Final = 3600.0
#: A table whose gateway works must be safe after this time without a line (s).
_SAFE_WITHIN: Final = 30.0
KILL: Final = "kill"


@dataclass
class Findings:
    """Faults and findings of a campaign."""

    faults: Counter[str] = field(default_factory=Counter)
    jobs: int = 0
    runs: int = 0  #: runs on the tables in which a tool was in the board
    again: int = 0  #: decisions to make an interrupted job again
    seconds: float = 0.0
    answers: Counter[str] = field(default_factory=Counter)  #: to the operator's requests
    violations: Violations = field(default_factory=Violations)

    def __str__(self) -> str:
        done = ", ".join(f"{count} × {name}" for name, count in sorted(self.faults.items()))
        kills = sum(count for name, count in self.faults.items() if name.startswith(KILL))
        return (
            f"{kills} kills ({done}) in {self.seconds:.0f} s; {self.jobs} jobs, {self.runs} runs "
            f"with a tool in the board, {self.again} made again; {self.violations}; answers to the "
            f"operator: {dict(self.answers)}"
        )


class Campaign:
    """Faults of a running shop.

    Parameters
    ----------
    shop
        The shop, which works.
    seed
        Seed of the random numbers.
    """

    def __init__(self, shop: Shop, seed: int) -> None:
        self._shop = shop
        self._random = Random(seed)
        self.findings = Findings()
        self._low_since = dict.fromkeys(shop.gateways, 0.0)

    def draw(self, kills: int) -> list[str]:
        """Return random names of faults with so many kills among them."""
        weights = {name: weight for name, (weight, _) in self._faults().items()}
        drawn: list[str] = []
        while sum(name.startswith(KILL) for name in drawn) < kills:
            drawn += self._random.choices([*weights], [*weights.values()])
        return drawn

    def run(
        self, faults: Sequence[str], pause: tuple[float, float], settle: float = 240.0
    ) -> Findings:
        """Cause faults; then wait until all jobs end, and check them.

        Parameters
        ----------
        faults
            Names of faults, as ``draw`` returns them.
        pause
            Shortest and longest time between two faults (s).
        settle
            Time in which all jobs must end afterwards (s).
        """
        with self._shop.client(SERVERS[0]) as client:
            # More than the shop can make meanwhile: a shop without work could not be harmed.
            drawings = upload_drawings(client, 3 * len(faults) + 2 * len(self._shop.tables))
        began = time.monotonic()
        operator = Operator(self._shop, drawings)
        operator.start()
        functions = {name: function for name, (_, function) in self._faults().items()}
        try:
            for name in faults:
                self._watch(self._random.uniform(*pause))
                functions[name]()
                self.findings.faults[name] += 1
                _log.info("%s: %d jobs", name, len(operator.accepted))
                assert operator.failure is None, operator.failure
            operator.orders = False
            self._settle(operator, settle)
        finally:
            operator.close()
            self.findings.seconds = time.monotonic() - began
            self.findings.answers = operator.answers
        self._examine(operator)
        return self.findings

    def _faults(self) -> dict[str, tuple[int, Callable[[], None]]]:
        """Return weight and function of each fault by its name."""
        shop = self._shop
        found: dict[str, tuple[int, Callable[[], None]]] = {
            f"{KILL} server": (6, lambda: self._kill(self._random.choice(SERVERS))),
            f"{KILL} worker": (4, lambda: self._kill(self._random.choice(WORKERS))),
            f"{KILL} gateway": (6, lambda: self._kill(self._random.choice(shop.gateways))),
            f"{KILL} database": (3, self._kill_database),
        }
        if shop.cuts:
            found["cut network"] = (3, self._cut)
        if shop.clocks.can_step:
            found["step clock"] = (3, self._step)
        return found

    def _kill(self, name: str) -> None:
        self._shop.kill(name)
        self._watch(self._random.choice((0.0, 0.0, self._random.uniform(0.0, 3.0))))
        self._shop.start(name)
        # A shop whose processes never work could not be harmed.
        if name in SERVERS and self._random.random() < 0.5:
            self._shop.wait_until_ready()

    def _kill_database(self) -> None:
        cluster = self._shop.cluster
        if self._random.random() < 0.5:
            cluster.stop()
        else:
            cluster.kill()
        self._watch(self._random.uniform(0.0, 3.0))
        end = time.monotonic() + 60.0
        running = False
        while not running:
            try:
                cluster.start()
                running = True
            except SubprocessError:  # processes of the killed server are still ending
                assert time.monotonic() < end
                time.sleep(0.5)

    def _cut(self) -> None:
        network = self._random.choice(self._shop.networks)
        network.cut()
        # Shorter and longer than a lease.
        self._watch(self._random.choice((1.0, 4.0, 14.0)))
        network.mend()

    def _step(self) -> None:
        name = self._random.choice(("database", *SERVERS, *WORKERS, *self._shop.gateways))
        self._shop.clocks.step(name, self._random.choice((-_HOUR, 0.0, _HOUR)))

    def _watch(self, seconds: float) -> None:
        """Wait; revive processes, and note tables that stay unsafe while their gateways live."""
        end = time.monotonic() + seconds
        while True:
            self._shop.revive()
            now = time.monotonic()
            for gateway, table in zip(self._shop.gateways, self._shop.tables, strict=True):
                working = table.table.state in ("Run", "Jog", "Check") or table.is_safe
                if working or gateway not in self._shop.processes:
                    self._low_since[gateway] = now
                elif now - self._low_since[gateway] > _SAFE_WITHIN:
                    self.findings.violations.heads_down.append(f"{gateway} {table.table.position}")
                    self._low_since[gateway] = now
            if now >= end:
                return
            time.sleep(min(0.1, end - now))

    def _settle(self, operator: Operator, seconds: float) -> None:
        """Wait until no job is active."""
        end = time.monotonic() + seconds
        store = Store(self._shop.database)
        try:
            while time.monotonic() < end and operator.failure is None:
                self._watch(0.5)
                with suppress(Exception):  # the database may still be starting
                    states = [store.jobs.get(job).state for job in operator.accepted]
                    if all(state == State.DONE for state in states):
                        return
        finally:
            store.close()

    def _examine(self, operator: Operator) -> None:
        """Compare the database with the records of the tables."""
        store = Store(self._shop.database)
        stored = {
            row.id: JobRecord(
                row.id,
                row.state,
                Counter(one.message.code for one in store.events.of_job(row.id) if one.message),
                store.jobs.column(row.id, "program") if row.lines else b"",
            )
            for row in store.jobs.search(limit=100_000)
        }
        store.close()
        runs = [run for table in self._shop.tables for run in table.table.runs]
        found = self.findings
        found.jobs, found.runs = len(operator.accepted), sum(run.has_cut for run in runs)
        found.again = sum(job.decisions for job in stored.values())
        check_jobs(operator.accepted, stored, runs, found.violations)
        for gateway, table in zip(self._shop.gateways, self._shop.tables, strict=True):
            if not table.wait_until_safe(10.0):
                found.violations.heads_down.append(f"{gateway} {table.table.position} at the end")


def keep_logs(shop: Shop, folder: Path) -> None:
    """Copy the logs of a shop to a folder."""
    folder.mkdir(parents=True, exist_ok=True)
    for log in shop.folder.glob("*.log"):
        (folder / log.name).write_bytes(log.read_bytes())
