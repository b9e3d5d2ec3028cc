"""knifetip program and verify: from a drawing to the machine's program, and back to the drawing."""

from __future__ import annotations

import hashlib
from pathlib import Path
from typing import Annotated, Any

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
    ask,
    dumped,
    progress,
    read_bytes,
    show,
    stderr,
    write_bytes,
)
from knifetip.errors import ProgramUnreadable
from knifetip.library import load
from knifetip.model.drawing import Drawing
from knifetip.model.verdict import Verdict

MachineName = Annotated[str, typer.Option(help="Machine of the library, or a TOML file.")]
BoardName = Annotated[str, typer.Option(help="Board of the library, or a TOML file.")]


def judged(verdict: Verdict, drawing: Drawing) -> dict[str, Any]:
    """Return a verdict as plain data, its findings with the handles of their edges."""
    handles = drawing.handles
    return {
        "accepted": verdict.accepted,
        "tolerance": verdict.tolerance,
        "deviation": float(verdict.deviation.max(initial=0.0)),
        "overcut": float(verdict.overcut.max(initial=0.0)),
        "uncut": float(verdict.uncut.sum()),
        "setback": float(verdict.setback.sum()),
        "seconds": verdict.seconds,
        "findings": [
            {
                "kind": finding.kind,
                "text": finding.text,
                "measure": finding.measure,
                "edge": finding.edge,
                "handle": handles[finding.edge] if finding.edge >= 0 else "",
                "line": finding.line,
            }
            for finding in verdict.findings
        ],
        "edges": [
            {
                "handle": handle,
                "deviation": float(verdict.deviation[row]),
                "overcut": float(verdict.overcut[row]),
                "uncut": float(verdict.uncut[row]),
                "setback": float(verdict.setback[row]),
            }
            for row, handle in enumerate(handles)
        ],
    }


def tell(verdict: Verdict) -> None:
    """Print a verdict: its figures, and what is wrong."""
    word = "accepted" if verdict.accepted else "refused"
    stderr.print(
        f"{word}: deviation {verdict.deviation.max(initial=0.0):.4f} mm "
        f"(tolerance {verdict.tolerance:g}), overcut {verdict.overcut.max(initial=0.0):.3f} mm, "
        f"uncut {verdict.uncut.sum():.3f} mm, {verdict.seconds:.1f} s",
        markup=False,
        style="bold green" if verdict.accepted else "bold red",
    )
    for finding in verdict.findings[:20]:
        stderr.print(f"  {finding.text}", markup=False)
    if len(verdict.findings) > 20:
        stderr.print(f"  and {len(verdict.findings) - 20} more", markup=False)


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
            str | None, typer.Option(help="linuxcnc or grblhal; else the machine's own.")
        ] = None,
        report: Annotated[Path | None, typer.Option(help="Write the verdict as JSON.")] = None,
    ) -> None:
        """Write the program that makes a drawing, once the judge has accepted it."""
        table, sheet = load.machine(machine), load.board(board)
        with progress(file.name) as told:
            drawn = load_drawing(file, unit, profile, layer)
            asked = drawn.questions(table)
            if asked:
                ask(asked)
                raise typer.Exit(QUESTIONS)
            result = pipeline.compiled(
                drawn.drawing, drawn.dieline, table, sheet, dialect=dialect, progress=told
            )
        text = result.program.text
        if report is not None:
            data = {
                "drawing": described(file.name, drawn.drawing),
                "machine": table.name,
                "board": sheet.name,
                "profile": profile,
                "placement": list(result.placement),
                "program": {
                    "dialect": result.program.dialect,
                    "lines": len(result.program),
                    "sha256": hashlib.sha256(text).hexdigest(),
                },
                "verdict": judged(result.verdict, drawn.drawing),
                "ledger": ledger(drawn.drawing),
            }
            write_bytes(report, dumped(data))
        tell(result.verdict)
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
        json: Json = False,
    ) -> None:
        """Judge whether a program cuts what was drawn."""
        table, sheet = load.machine(machine), load.board(board)
        drawn = load_drawing(drawing, unit, profile, layer)
        asked = drawn.questions(table)
        if asked:
            ask(asked)
            raise typer.Exit(QUESTIONS)
        text = read_bytes(program)
        where = pipeline.placement_of(text)
        if where is None:
            raise ProgramUnreadable(
                f"{program.name} does not say where on the sheet it places the drawing.",
                "Its header needs a comment like (placement X20.0000 Y20.0000).",
            )
        verdict = pipeline.verify(text, drawn.dieline, where, table, sheet)
        if json:
            show(judged(verdict, drawn.drawing))
        else:
            tell(verdict)
        if not verdict.accepted:
            raise typer.Exit(REFUSED)
