"""Process that places shapes in a strip with sparrow, which cannot be stopped otherwise.

Reads one line of JSON, and writes a line for each better arrangement.  It ends when its standard
input is closed.  The parent process is ``nesting.engine``.
"""

from __future__ import annotations

import json
import os
import resource
import sys
import threading
import time
from datetime import timedelta
from typing import Any, Final

import spyrrow

#: Address space of the process (bytes).
_MEMORY: Final = 4 << 30
#: Seconds between two arrangements that are written.
_INTERVAL: Final = 0.1
#: Arrangements without collisions.
_USABLE: Final = (
    spyrrow.ReportType.ExplFeas,
    spyrrow.ReportType.CmprFeas,
    spyrrow.ReportType.Final,
)


def _exit_with_parent() -> None:
    sys.stdin.read()
    os._exit(0)


def _write(solution: Any) -> None:
    placed = [[one.id, one.rotation, *one.translation] for one in solution.placed_items]
    sys.stdout.write(json.dumps({"length": solution.width, "placed": placed}) + "\n")
    sys.stdout.flush()


def main() -> None:
    """Place the shapes of the line of JSON on standard input."""
    hard = resource.getrlimit(resource.RLIMIT_AS)[1]
    limit = _MEMORY if hard == resource.RLIM_INFINITY else min(_MEMORY, hard)
    resource.setrlimit(resource.RLIMIT_AS, (limit, hard))
    strip = json.loads(sys.stdin.readline())
    threading.Thread(target=_exit_with_parent, daemon=True).start()
    items = [
        spyrrow.Item(str(number), [(x, y) for x, y in shape], quantity, turns)
        for number, (shape, quantity, turns) in enumerate(strip["shapes"])
    ]
    instance = spyrrow.StripPackingInstance("strip", strip["height"], items)
    config = spyrrow.StripPackingConfig(
        early_termination=True,
        min_items_separation=strip["gap"],
        total_computation_time=1,
        num_workers=1,
        seed=strip["seed"],
    )
    config.exploration_time = timedelta(seconds=0.8 * strip["seconds"])
    config.compression_time = timedelta(seconds=0.2 * strip["seconds"])
    queue = spyrrow.ProgressQueue()
    solving = threading.Thread(target=instance.solve, args=(config, queue), daemon=True)
    solving.start()
    best = float("inf")
    while True:
        ended = not solving.is_alive()
        usable = [solution for kind, solution in queue.drain() if kind in _USABLE]
        better = min(usable, key=lambda solution: solution.width, default=None)
        if better is not None and better.width < best:
            best = better.width
            _write(better)
        if ended:
            return
        time.sleep(_INTERVAL)


if __name__ == "__main__":
    main()
