"""Run all benchmarks and their peers once (``make bench``).

Prints a table and writes build/bench.json: a list of {bench, subject, n, seconds, peers}.
Times are medians without the first run; compare only times of the same run.
"""

from __future__ import annotations

import gc
import json
import statistics
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from rich.console import Console
from rich.table import Table

from tests.benchmarks import workloads

Timed = Callable[[], object]


def median(work: Timed, runs: int) -> float:
    """Return the median time of some runs in seconds, after one run that is not measured."""
    work()
    # Do not measure the collection of garbage that earlier benchmarks have left.
    gc.collect()
    times = []
    for _ in range(runs):
        begin = time.perf_counter()
        work()
        times.append(time.perf_counter() - begin)
    return statistics.median(times)


def main() -> None:
    """Measure all benchmarks; print a table and write build/bench.json."""
    rows: list[dict[str, Any]] = []
    console = Console(width=140)
    for bench in workloads.BENCHES:
        subject, n, work, peers, runs = bench()
        rows.append(
            {
                "bench": bench.__name__,
                "subject": subject,
                "n": n,
                "seconds": median(work, runs),
                "peers": {name: median(peer, runs) for name, peer in peers.items()},
            }
        )
        console.print(f"{rows[-1]['bench']}: {rows[-1]['seconds']:.4f} s", highlight=False)
    table = Table("bench", "subject", "n", "seconds", "n per second", "peers")
    for row in rows:
        table.add_row(
            row["bench"],
            row["subject"],
            f"{row['n']:,}",
            f"{row['seconds']:.4f}",
            f"{row['n'] / row['seconds']:,.0f}",
            ", ".join(
                f"{name} {seconds:.4f} s ({seconds / row['seconds']:.1f} ×)"
                for name, seconds in row["peers"].items()
            ),
        )
    console.print(table)
    out = Path("build/bench.json")
    out.parent.mkdir(exist_ok=True)
    out.write_text(json.dumps(rows, indent=2) + "\n")


if __name__ == "__main__":
    main()
