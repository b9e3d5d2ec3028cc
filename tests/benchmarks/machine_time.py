"""Machine times of twenty cartons beside a plain way of making them: ``python -m
tests.benchmarks.machine_time [--run]``.

The plain way makes the tracks in the order of the file, lifts the tool high between them, and cuts
curves as chords.  A carton of each standard style is made in two sizes on the demo table with
LinuxCNC.

Prints the stated time of each carton, and by what factor each of these three alone, and all of them
together, make it longer.  With ``--run``, a headless LinuxCNC runs the programs of both ways, and
the errors of the stated times are printed.
"""

from __future__ import annotations

import argparse
import asyncio
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from typing import Final

import numpy as np
from rich.console import Console
from rich.table import Table

from knifetip import pipeline
from knifetip.cartons.file import carton_dxf
from knifetip.cartons.registry import STYLES
from knifetip.languages.registry import with_language
from knifetip.library import load
from knifetip.model.board import Board
from knifetip.model.dieline import Dieline
from knifetip.model.drawing import Drawing
from knifetip.model.interpretation import Interpretation
from knifetip.model.job_options import JobOptions
from knifetip.model.machine import Machine
from tests.controllers.linuxcnc_time import moving_seconds, stated_seconds

#: Sizes of the cartons, as factors of the example of each style.
_SIZES: Final = (1.0, 0.6)
#: Height above the board to which the plain way lifts the tool (mm): half of 30 mm, which a common
#: program for routers proposes, as the demo table travels 20 mm above its bed.
_FULL_LIFT: Final = 15.0


@dataclass(frozen=True, eq=False)
class Job:
    """A carton, and the machine and options with which it is made."""

    name: str
    drawing: Drawing
    dieline: Dieline
    board: Board
    machine: Machine
    options: JobOptions = JobOptions()  # noqa: RUF009 - it is frozen

    def compiled(self) -> pipeline.Compiled:
        """Return the program, which must be accepted."""
        made = pipeline.compile(
            self.drawing, self.dieline, self.machine, self.board, options=self.options
        )
        faults = [f.text for f in made.verdict.findings if f.refuses]
        assert not faults, (self.name, faults)
        return made


def jobs() -> Iterator[Job]:
    """Yield the cartons."""
    for style in STYLES.values():
        for size in _SIZES:
            sides: dict[str, float] = {
                name: round(size * getattr(style.example, name), 1)
                for name in ("length", "width", "height")
                if name in type(style.example).model_fields
            }
            board = load.board(style.board)
            example = style.example.model_copy(update=sides)
            drawing = pipeline.read(carton_dxf(style.draw(example, board)))
            dieline = pipeline.interpret(drawing, Interpretation())
            name = f"{style.code} {size:g}"
            machine = with_language(load.machine("demo-table"), "linuxcnc")
            yield Job(name, drawing, dieline, board, machine)


def in_file_order(job: Job) -> Job:
    """Make the tracks of each operation in the order of the file."""
    path = job.compiled().toolpath
    made = path.source >= 0
    first = np.full(int(path.track.max()) + 1, len(job.dieline))
    np.minimum.at(first, path.track[made], path.source[made])
    tracks = np.arange(len(first))
    stage = np.searchsorted(path.stages, tracks, side="right")
    order = tuple(first[np.lexsort((first, stage))].tolist())
    return replace(job, options=job.options.model_copy(update={"work_order": order}))


def with_full_lifts(job: Job) -> Job:
    """Lift the tool high between tracks."""
    return replace(job, machine=replace(job.machine, clearance=_FULL_LIFT))


def in_chords(job: Job) -> Job:
    """Cut curves as chords."""
    return replace(job, machine=replace(job.machine, arcs="chords"))


#: What the plain way does, by its name in the table.
PLAIN: Final[dict[str, Callable[[Job], Job]]] = {
    "file order": in_file_order,
    "full lifts": with_full_lifts,
    "chords": in_chords,
}


def plain(job: Job) -> Job:
    """Make a carton the plain way."""
    for change in PLAIN.values():
        job = change(job)
    return job


def stated_table(cartons: list[Job]) -> Table:
    """Return the stated times, and the factors of the plain way."""
    table = Table("carton", "seconds", *PLAIN, "all")
    factors = []
    for job in cartons:
        seconds = job.compiled().seconds
        ways = [*PLAIN.values(), plain]
        factors.append([way(job).compiled().seconds / seconds for way in ways])
        table.add_row(job.name, f"{seconds:.1f}", *(f"{each:.2f}" for each in factors[-1]))
    table.add_row("mean", "", *(f"{each:.2f}" for each in np.mean(factors, axis=0)))
    return table


async def measured_table(cartons: list[Job]) -> Table:
    """Return the times on LinuxCNC and the errors of the stated ones, for both ways."""
    ways: dict[str, Callable[[Job], Job]] = {"knifetip": lambda job: job, "plain": plain}
    table = Table("carton", *(f"{name}, {what}" for name in ways for what in ("s", "error %")), "×")
    for job in cartons:
        cells, seconds = [], []
        for way in ways.values():
            changed = way(job)
            made = changed.compiled()
            seconds.append(await moving_seconds(made.program.text, changed.machine))
            stated = stated_seconds(made.toolpath, changed.machine)
            cells += [f"{seconds[-1]:.2f}", f"{100.0 * (stated / seconds[-1] - 1.0):+.1f}"]
        table.add_row(job.name, *cells, f"{seconds[1] / seconds[0]:.2f}")
    return table


def main() -> None:
    """Print the stated times, and those on LinuxCNC if they are asked for."""
    parser = argparse.ArgumentParser(description="Machine times beside a plain way.")
    parser.add_argument("--run", action="store_true", help="run the programs on LinuxCNC, too")
    wanted = parser.parse_args()
    console = Console(width=140)
    cartons = list(jobs())
    console.print(stated_table(cartons))
    if wanted.run:
        console.print(asyncio.run(measured_table(cartons)))


if __name__ == "__main__":
    main()
