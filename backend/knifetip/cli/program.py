"""knifetip program and verify: from a drawing to the machine's program, and back to the drawing."""

from __future__ import annotations

import hashlib
import re
from enum import Enum
from pathlib import Path
from typing import Annotated, Any

import numpy as np
import typer

from knifetip import pipeline
from knifetip.cli.drawing import (
    DrawingFile,
    Json,
    Layers,
    Profile,
    Unit,
    described,
    ledger,
    load_drawing,
)
from knifetip.cli.terminal import (
    QUESTIONS,
    REFUSED,
    dumped,
    print_stderr,
    progress,
    read_bytes,
    report_questions,
    show,
    write_bytes,
)
from knifetip.errors import PlanError, ProgramUnreadable
from knifetip.library import load
from knifetip.messages import with_text
from knifetip.model.corners import CornerAt, Corners
from knifetip.model.drawing import Drawing
from knifetip.model.verdict import Unreached, Verdict
from knifetip.planning.plan import check_corners
from knifetip.presentation.verdict import EDGE_COLUMNS, findings_of, finite_column, verdict_summary
from knifetip.verification.verify import read_placement

_NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d{1,2})?"
_CHOICE = re.compile(
    rf"\s*(?P<x>{_NUMBER})\s*,\s*(?P<y>{_NUMBER})\s*=\s*(?P<type>\w+)\s*(?::\s*(?P<k>{_NUMBER})\s*)?",
    re.ASCII,
)


class CornerType(Enum):
    """How a cutter goes round corners: the machine's choice, or a type of the radius paper."""

    AUTO = "auto"
    B = "B"
    C = "C"
    D = "D"


class Interference(Enum):
    """What is done where a cutter does not fit: it leaves that uncut, or the job is refused."""

    TRIM = "trim"
    REFUSE = "refuse"


def choice(text: str) -> CornerAt:
    """Return the choice for one corner, as the command line writes it: ``X,Y=C`` or ``X,Y=D:0.3``.

    Raises
    ------
    PlanError
        It is written otherwise.
    """
    found = _CHOICE.fullmatch(text)
    if found is None:
        raise PlanError("command.bad-corner", text=text)
    k = None if found["k"] is None else float(found["k"])
    return CornerAt(float(found["x"]), float(found["y"]), found["type"], k)


MachineName = Annotated[str, typer.Option(help="Machine of the library, or a TOML file.")]
BoardName = Annotated[str, typer.Option(help="Board of the library, or a TOML file.")]


def judged(verdict: Verdict, drawing: Drawing) -> dict[str, Any]:
    """Return a verdict as plain data, its findings with the handles of their edges."""
    handles = drawing.handles
    columns = {name: finite_column(getattr(verdict, name)) for name in EDGE_COLUMNS}
    return {
        **verdict_summary(verdict),
        "areas": unreached(verdict.areas),
        "findings": [with_text(finding) for finding in findings_of(verdict, handles)],
        "edges": [
            {"handle": handle, **{name: float(column[row]) for name, column in columns.items()}}
            for row, handle in enumerate(handles)
        ],
    }


def unreached(areas: Unreached) -> list[dict[str, Any]]:
    """Return what no cutter gets to as plain data: mm², and outlines of [start, end, bulge]."""
    ends, bulge = areas.ends.tolist(), areas.bulge.tolist()
    return [
        {
            "area": float(areas.area[row]),
            "outline": [
                [*ends[at], bulge[at]] for at in range(areas.first[row], areas.first[row + 1])
            ],
        }
        for row in range(len(areas))
    ]


def tell(verdict: Verdict) -> None:
    """Print a verdict: its figures, and what is wrong."""
    word = "accepted" if verdict.accepted else "refused"
    print_stderr(
        f"{word}: deviation {verdict.deviation.max(initial=0.0):.4f} mm "
        f"(tolerance {verdict.tolerance:g}), overcut {verdict.overcut.max(initial=0.0):.3f} mm, "
        f"uncut {verdict.uncut.sum():.3f} mm, {verdict.seconds:.1f} s",
        "green" if verdict.accepted else "red",
    )
    if len(verdict.areas):
        print_stderr(
            f"  the cutter does not get to {verdict.areas.area.sum():.2f} mm² in "
            f"{len(verdict.areas)} places, which stay uncut"
        )
    for finding in verdict.findings[:20]:
        print_stderr(f"  {finding.text}")
    if len(verdict.findings) > 20:
        print_stderr(f"  and {len(verdict.findings) - 20} more")


def _placement(text: str) -> tuple[float, float]:
    """Return the placement of "X,Y" (mm)."""
    found = re.fullmatch(rf"\s*({_NUMBER})\s*,\s*({_NUMBER})\s*", text, re.ASCII)
    if found is None:
        raise typer.BadParameter(f"{text!r} is not X,Y in mm.", param_hint="--placement")
    return float(found[1]), float(found[2])


def register(app: typer.Typer) -> None:
    """Add the commands of this module."""

    @app.command()
    def program(
        file: DrawingFile,
        machine: MachineName,
        board: BoardName,
        output: Annotated[Path, typer.Option("-o", "--output", help="Where the program goes.")],
        profile: Profile = "default",
        layer: Layers = None,
        unit: Unit = None,
        dialect: Annotated[
            str, typer.Option(help="Another controller language than the machine's own.")
        ] = "",
        corner: Annotated[
            CornerType | None, typer.Option(help="How a cutter goes round corners.")
        ] = None,
        k: Annotated[
            float | None, typer.Option(help="Knob of D corners: near 0 as B, near 1 as C.")
        ] = None,
        interference: Annotated[
            Interference | None, typer.Option(help="Where a cutter does not fit.")
        ] = None,
        corner_at: Annotated[
            list[str] | None,
            typer.Option(
                metavar="X,Y=TYPE[:K]", help="One corner, in the drawing's mm; repeatable."
            ),
        ] = None,
        report: Annotated[Path | None, typer.Option(help="Write the verdict as JSON.")] = None,
    ) -> None:
        """Write the program that makes a drawing, once the judge has accepted it."""
        table, sheet = load.machine(machine), load.board(board)
        choices = None
        if not (corner is None and k is None and interference is None and not corner_at):
            choices = Corners(
                type=(corner or CornerType.AUTO).value,
                k=0.5 if k is None else k,
                interference=(interference or Interference.TRIM).value,
                at=tuple(choice(text) for text in corner_at or []),
            )
            check_corners(choices, table)
        with progress(file.name) as told:
            drawn = load_drawing(file, unit, profile, layer)
            asked = drawn.questions(table)
            if asked:
                report_questions(asked)
                raise typer.Exit(QUESTIONS)
            result = pipeline.compile(
                drawn.drawing,
                drawn.dieline,
                table,
                sheet,
                corners=choices,
                dialect=dialect,
                progress=told,
            )
        text = result.program.text
        if report is not None:
            data = {
                "drawing": described(file.name, drawn.drawing),
                "machine": table.name,
                "board": sheet.name,
                "profile": profile,
                "placement": list(result.placement),
                "corners": None if choices is None else choices.as_json(),
                "seconds": result.seconds,
                "seconds_retracted": result.seconds_retracted,
                "program": {
                    "dialect": result.program.dialect,
                    "lines": len(result.program),
                    "sha256": hashlib.sha256(text).hexdigest(),
                },
                "verdict": judged(result.verdict, drawn.drawing),
                "samples": {
                    name: np.round(getattr(result.verdict.samples, name), 6).tolist()
                    for name in ("edge", "place", "deviation")
                },
                "ledger": ledger(drawn.drawing),
            }
            write_bytes(report, dumped(data))
        tell(result.verdict)
        full = result.seconds_retracted
        if full > result.seconds:
            print_stderr(
                f"  {result.seconds:.1f} s on the machine, {1.0 - result.seconds / full:.0%} less "
                f"than the {full:.1f} s with full retracts"
            )
        if not result.verdict.accepted:
            raise typer.Exit(REFUSED)
        write_bytes(output, text)

    @app.command()
    def verify(
        program: Annotated[Path, typer.Argument(metavar="PROGRAM", help="The program to judge.")],
        drawing: Annotated[Path, typer.Option(help="The drawing that it should make.")],
        machine: MachineName,
        board: BoardName,
        profile: Profile = "default",
        layer: Layers = None,
        unit: Unit = None,
        placed: Annotated[
            str,
            typer.Option(
                "--placement",
                metavar="X,Y",
                help="Where the program places the drawing (mm), if it does not state it.",
            ),
        ] = "",
        json: Json = False,
    ) -> None:
        """Judge whether a program cuts what was drawn."""
        table, sheet = load.machine(machine), load.board(board)
        drawn = load_drawing(drawing, unit, profile, layer)
        asked = drawn.questions(table)
        if asked:
            report_questions(asked)
            raise typer.Exit(QUESTIONS)
        text = read_bytes(program)
        where = _placement(placed) if placed else read_placement(text, table)
        if where is None:
            raise ProgramUnreadable("program.no-placement", program=program.name)
        verdict = pipeline.verify(text, drawn.dieline, where, table, sheet)
        if json:
            show(judged(verdict, drawn.drawing))
        else:
            tell(verdict)
        if not verdict.accepted:
            raise typer.Exit(REFUSED)
