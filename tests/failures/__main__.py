"""Run a campaign of failures against a shop on PostgreSQL.

    python -m tests.failures [--kills 200] [--tables 2] [--seed 1] [--pause 1 4] [--logs DIR]

Kills servers, workers, gateways and the database, cuts the network between gateways and servers
(as root, in network namespaces) and steps clocks by an hour (with a C compiler), while an operator
works at simulated tables.  Exits with 1 if a job was lost, cut twice, started without the operator,
stuck, or done without being executed, or if a head stayed down.
"""

from __future__ import annotations

import argparse
import logging
import signal
import sys
from pathlib import Path

from tests.failures.campaign import Campaign, keep_logs
from tests.failures.shop import Shop


def main() -> int:
    """Run a campaign and print its findings."""
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--kills", type=int, default=200)
    options.add_argument("--tables", type=int, default=2)
    options.add_argument("--seed", type=int, default=1)
    options.add_argument("--speed", type=float, default=4.0)
    options.add_argument("--pause", type=float, nargs=2, default=(1.0, 4.0))
    options.add_argument("--logs", type=Path, default=None)
    given = options.parse_args()
    logging.basicConfig(level=logging.INFO, format="%(asctime)s %(message)s")
    logging.getLogger("httpx").setLevel(logging.WARNING)
    # The end of the shop also ends its processes.
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))
    with Shop(given.tables, given.speed) as shop:
        print(
            f"cuts of the network: {shop.cuts}, steps of clocks: {shop.clocks.can_step}", flush=True
        )
        campaign = Campaign(shop, given.seed)
        try:
            found = campaign.run(campaign.draw(given.kills), tuple(given.pause))
        finally:
            print(campaign.findings, flush=True)
            if given.logs is not None:
                keep_logs(shop, given.logs)
    for name, rows in found.violations.cases.items():
        for row in rows:
            print(f"{name}: {row}")
    return 1 if found.violations else 0


if __name__ == "__main__":
    sys.exit(main())
