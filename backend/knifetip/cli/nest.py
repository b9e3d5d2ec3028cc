"""knifetip nest: place drawings on as few sheets as possible."""

from __future__ import annotations

import json
import re
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any

import typer

from knifetip import pipeline
from knifetip.cli.drawing import ReadingOptions
from knifetip.cli.options import expand
from knifetip.cli.terminal import (
    QUESTIONS,
    in_words,
    print_line,
    print_stderr,
    report_questions,
    write_bytes,
)
from knifetip.errors import RequestError
from knifetip.layout.blanks import find_blanks
from knifetip.layout.compose import Source, compose
from knifetip.messages import Message
from knifetip.model.layout import Layout, LayoutSheet
from knifetip.model.nesting import LeftOver, Margins, NestingJob, NestingPart
from knifetip.nesting.job import layouts_of, problem_of
from knifetip.nesting.parts import make_part
from knifetip.nesting.search import Found, nest

_SIZE = re.compile(r"(\d+(?:\.\d+)?)x(\d+(?:\.\d+)?)(?:x(\d+))?")


@dataclass(frozen=True, slots=True)
class SheetOptions:
    """Command-line options: the sheets, and what is kept free on them."""

    sheet: Annotated[str, typer.Option(metavar="WxH", help="Size of the sheet (mm).")]
    left_over: Annotated[
        list[str] | None,
        typer.Option(
            metavar="WxH[xN]", help="N sheets of another size that are used first; repeatable."
        ),
    ] = None
    margin: Annotated[
        float, typer.Option(min=0.0, max=1000.0, help="Margin at each edge of a sheet (mm).")
    ] = 0.0
    gap: Annotated[
        float, typer.Option(min=0.0, max=1000.0, help="Least distance between two blanks (mm).")
    ] = 0.0
    grain: Annotated[
        str, typer.Option(help="Axis of the grain of the sheet: x or y. Default: none.")
    ] = ""
    holes: Annotated[bool, typer.Option(help="Place small drawings in holes of large ones.")] = True

    def job(self, parts: list[NestingPart], seconds: float, seed: int) -> NestingJob:
        """Return the job that places parts on these sheets.

        Raises
        ------
        RequestError
            A size cannot be read.
        """
        width, height, _ = _size(self.sheet)
        margin = dict.fromkeys(("left", "right", "below", "above"), self.margin)
        return NestingJob(
            sheet=LayoutSheet(
                width=width,
                height=height,
                grain=None if self.grain not in ("x", "y") else self.grain,  # type: ignore[arg-type]  # narrowed by the test
            ),
            left_overs=tuple(
                LeftOver(width=width, height=height, count=count)
                for width, height, count in map(_size, self.left_over or ())
            ),
            margins=Margins(**margin),
            gap=self.gap,
            in_holes=self.holes,
            parts=tuple(parts),
            seconds=seconds,
            seed=seed,
        )


def _size(text: str) -> tuple[float, float, int]:
    found = _SIZE.fullmatch(text)
    if found is None or not (0.0 < float(found[1]) <= 1e4 and 0.0 < float(found[2]) <= 1e4):
        raise RequestError("nesting.sheet-size", text=text)
    count = int(found[3] or 1)
    if not 1 <= count <= 100:
        raise RequestError("nesting.sheet-size", text=text)
    return float(found[1]), float(found[2]), count


def _nest(
    files: Annotated[
        list[Path], typer.Argument(metavar="FILE…", help="Drawings that are placed together.")
    ],
    sheets: SheetOptions,
    reading: ReadingOptions,
    output: Annotated[
        Path,
        typer.Option(
            "-o",
            "--output",
            help="FILE.json for layouts as the server stores them, FILE.dxf for a drawing of each "
            "sheet. Further sheets are written to FILE-2, FILE-3 and so on.",
        ),
    ],
    count: Annotated[int, typer.Option(min=1, max=2000, help="Number of copies of each file.")] = 1,
    turn_step: Annotated[
        float | None,
        typer.Option(
            min=1.0,
            max=360.0,
            help="Step of permitted turns (°): 180 keeps the grain. Default: 180 on a sheet with a "
            "grain, otherwise 90.",
        ),
    ] = None,
    seconds: Annotated[
        float, typer.Option(min=1.0, max=600.0, help="Time of the search (s).")
    ] = 20.0,
    seed: Annotated[int, typer.Option(min=0, help="Seed of the search.")] = 0,
) -> None:
    """Place drawings on as few sheets as possible, by true shapes.

    Ctrl-C stops the search and keeps the best arrangement so far.  Exits with 2 if questions about
    a drawing are open.
    """
    if output.suffix not in (".json", ".dxf"):
        raise RequestError("nesting.output", file=output)
    sources = [_source(file, reading) for file in files]
    names = [str(file)[-40:] for file in files]
    wanted = [NestingPart(drawing=name, quantity=count, turn_step=turn_step) for name in names]
    job = sheets.job(wanted, seconds, seed)
    keep_grain = job.sheet.grain is not None
    parts = [
        make_part(
            source.dieline,
            find_blanks(pipeline.clean(source.dieline).dieline),
            one.turns(keep_grain=keep_grain),
            quantity=one.quantity,
        )
        for source, one in zip(sources, wanted, strict=True)
    ]
    found: list[Found] = []

    def report(better: Found) -> None:
        found.append(better)
        print_stderr(f"{better.seconds:7.1f} s  {better.use:6.2f} %")

    try:
        best = nest(problem_of(job, parts), report)
    except KeyboardInterrupt:
        if not found:
            raise
        best = found[-1]
    layouts = layouts_of(best.arrangement, job, [0] * len(names))
    for number, layout in enumerate(layouts, 1):
        ending = "" if number == 1 else f"-{number}"
        file = output.with_name(f"{output.stem}{ending}{output.suffix}")
        content = _json(layout) if output.suffix == ".json" else _dxf(layout, names, sources)
        write_bytes(file, content)
    print_line(
        in_words(
            Message(
                "nesting.result",
                file=output,
                sheets=len(layouts),
                use=best.use,
                rectangles=best.columns_use,
                in_holes=best.in_holes,
            )
        )
    )


def _source(file: Path, reading: ReadingOptions) -> Source:
    loaded = reading.load(file)
    if open_questions := loaded.questions():
        report_questions(open_questions)
        raise typer.Exit(QUESTIONS)
    return Source(loaded.drawing, loaded.dieline)


def _json(layout: Layout) -> bytes:
    data: dict[str, Any] = layout.model_dump(mode="json")
    return json.dumps(data, indent=2).encode() + b"\n"


def _dxf(layout: Layout, names: list[str], sources: list[Source]) -> bytes:
    from knifetip.dxf.layout_file import write_lines  # imports ezdxf, which is slow

    index = {name: number for number, name in enumerate(names)}
    sheet = compose(layout, sources, [index[placed.drawing] for placed in layout.placed])
    return write_lines(sheet.dieline)


def register(app: typer.Typer) -> None:
    """Add the command ``nest`` to a Typer application."""
    app.command("nest")(expand(_nest))
