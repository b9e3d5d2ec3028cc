"""How long does a gateway at one server wait for a job that another server queues?

    python -m tests.benchmarks.wakes [--rounds 20]

Two servers on one PostgreSQL, in one run with notifications and without them (queries at
intervals).  A round begins when a job is queued through one server, at a random moment while a
gateway waits at the other, and ends with the answer to the gateway.
"""

from __future__ import annotations

import argparse
import random
import statistics
import time
from concurrent.futures import ThreadPoolExecutor

from knifetip.service.settings import Settings
from knifetip.service.store import Store
from tests.support.job_states import RESULT, compiling
from tests.support.serving.postgresql import create_database, installed_binaries, run_server
from tests.support.serving.server import LocalClient
from tests.support.serving.server import run_server as run_http_server

_CLAIM = {"machine": "demo-table", "gateway": "gateway", "wait": 20}


def measure(store: Store, client: LocalClient, rounds: int, threads: ThreadPoolExecutor) -> float:
    """Return the median time from queueing a job through ``store`` to the claim by ``client`` (s).

    The time includes that of storing the result of the compile, which queues the job.
    """
    took = []
    for _ in range(rounds):
        answer = threads.submit(client.post, "/api/gateway/claim", json=_CLAIM)
        time.sleep(0.3 + 2.0 * random.random())
        job = compiling(store, machine="demo-table", release=True)
        began = time.perf_counter()
        store.compiles.save_result(job.id, job.epoch, RESULT)
        claim = answer.result()
        took.append(time.perf_counter() - began)
        assert claim.status_code == 200, claim.text
        body = claim.json()
        store.gateways.finish(body["job"], body["epoch"], "done")
    print(f"median {statistics.median(took):.3f} s, greatest {max(took):.3f} s", flush=True)
    return statistics.median(took)


def main() -> None:
    """Measure with notifications and without them."""
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--rounds", type=int, default=20)
    rounds = options.parse_args().rounds
    binaries = installed_binaries()
    assert binaries is not None, "PostgreSQL is not installed"
    with run_server(binaries) as server, ThreadPoolExecutor(1) as threads:
        url = create_database(server, "shop")
        settings = [Settings(database=url, compiles=False, name=name) for name in ("a", "b")]
        with run_http_server(settings[0]) as here, run_http_server(settings[1]) as there:
            print("notifications: ", end="")
            measure(here.service.store, there, rounds, threads)
            for client in (here, there):
                client.service.store.changes.send = None
                client.service.store.changes.connected = False
            print("intervals: ", end="")
            measure(here.service.store, there, rounds, threads)


if __name__ == "__main__":
    main()
