"""Compile random cartons, follow the hints of refusals, and check the accepted programs.

    python -m tests.cartons --count 1000 --seed 1 [--first 0] [--oracle 10] [--bodies]
        [--keep FOLDER]

Each job is a DXF file of one carton or a nested sheet (``styles``, ``features``, ``draft``) for a
random board and machine of the library.  A job fails if it ends without an accepted program, by an
internal error, or with a program in which ``oracle`` finds a fault.  Prints the failures, tables of
fates and codes, and a summary, also if it is interrupted; the exit status is 1 if any job failed.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from tests.cartons.campaign import Tally, run
from tests.cartons.oracle import check_tip_path
from tests.support.campaign import keep_file, until_interrupted


def main() -> int:
    """Run a campaign as the command line asks; return the exit status."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--first", type=int, default=0, help="number of the first job")
    parser.add_argument("--oracle", type=int, default=0, help="check the program of one in so many")
    parser.add_argument("--bodies", action="store_true", help="bends and lines side by side")
    parser.add_argument("--keep", type=Path, help="folder for the files of failures")
    options = parser.parse_args()
    tally = Tally()
    with until_interrupted():
        for job, outcome in run(
            options.count,
            options.seed,
            tally,
            first=options.first,
            check=check_tip_path,
            every=options.oracle,
            bodies=options.bodies,
        ):
            print(f"{outcome.fate.upper()} {job}: {outcome.followed} {outcome.text}", flush=True)
            keep_file(options.keep, f"{options.seed}-{job.number:05}.dxf", job.data)
    print(tally.table())
    return 1 if tally.failures else 0


if __name__ == "__main__":
    sys.exit(main())
