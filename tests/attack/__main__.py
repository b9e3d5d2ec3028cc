"""Attack the verifier: count the mutants of correct programs that it accepts despite damage.

    python -m tests.attack --mutants 5000 --seed 1 [--only NAME] [--keep FOLDER]

Each mutant is a program of one of the ``subjects`` with one or two random changes (``mutation``).
Damage is measured without the verifier (``damage``), by the tests' own ``controller`` and
``plotter``; if rs274 is installed, LinuxCNC's interpreter must agree with ``controller`` on
accepted mutants.
Prints the escapes, a table of all subjects, and the rate, also if it is interrupted; the exit
status is 1 if any escaped.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from tests.attack.campaign import Tally, run
from tests.attack.rests import rests
from tests.attack.subjects import subjects
from tests.support.campaign import keep_file, until_interrupted


def main() -> int:
    """Run an attack as the command line asks; return the exit status."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--mutants", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", default="", help="attack only subjects whose names contain this")
    parser.add_argument("--keep", type=Path, help="folder for the programs that escaped")
    options = parser.parse_args()
    chosen = [subject for subject in (*subjects(), *rests()) if options.only in subject.name]
    tally = Tally()
    with until_interrupted():
        for escape in run(chosen, options.mutants, options.seed, tally):
            print(f"ESCAPE {escape}", flush=True)
            keep_file(options.keep, f"{escape.number:06}.txt", escape.text)
    print(tally.table())
    return 1 if tally.escapes else 0


if __name__ == "__main__":
    sys.exit(main())
