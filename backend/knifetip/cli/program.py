"""knifetip program and verify: compile a drawing to a program, and verify a program."""

from __future__ import annotations

import hashlib
import re
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Annotated, Any, Final

import numpy as np
import typer

from knifetip import pipeline
from knifetip.cli.drawing import (
    DrawingFile,
    Json,
    LoadedDrawing,
    ReadingOptions,
    report_json,
)
from knifetip.cli.exceptions import ExceptionOptions
from knifetip.cli.job_options import NUMBER, SYNTAX
from knifetip.cli.options import expand
from knifetip.cli.rest import RestOptions
from knifetip.cli.terminal import (
    QUESTIONS,
    REFUSED,
    json_bytes,
    print_how_to_leave_out,
    print_json,
    print_message,
    progress,
    read_bytes,
    report_questions,
    report_warnings,
    write_bytes,
)
from knifetip.errors import ProgramUnreadable
from knifetip.languages.registry import with_language
from knifetip.library import load
from knifetip.messages import Message
from knifetip.model.board import Board
from knifetip.model.drawing import Drawing
from knifetip.model.job_options import JobOptions, VerifiedOptions
from knifetip.model.machine import Machine
from knifetip.model.program_figures import PROGRAM_FIGURES, Unit
from knifetip.model.verdict import Severity, Verdict
from knifetip.presentation.verdict import verdict_json
from knifetip.verification.verify import read_placement

#: Codes of the lines of figures, by unit.
_FIGURE_LINES: Final[Mapping[Unit, str]] = {
    "mm": "figure.in-mm",
    "s": "figure.in-seconds",
    "": "figure.number",
}


@dataclass(frozen=True, slots=True)
class TargetOptions:
    """Command-line options that name the machine and the board for a program."""

    machine: Annotated[
        str, typer.Option(help="Name of a machine of the library, or its TOML file.")
    ]
    board: Annotated[str, typer.Option(help="Name of a board of the library, or its TOML file.")]

    def load(self) -> tuple[Machine, Board]:
        """Return the machine and the board that the options name."""
        return load.machine(self.machine), load.board(self.board)


def print_verdict(verdict: Verdict) -> None:
    """Print the measurements and the first findings of a verdict of the verifier."""
    word = Message("output.word-accepted" if verdict.accepted else "output.word-refused")
    figures = Message(
        "output.verdict",
        word=word,
        deviation=verdict.deviation.max(initial=0.0),
        tolerance=verdict.tolerance,
        path=verdict.path_deviation.max(initial=0.0),
        blending=verdict.blending.max(initial=0.0),
        fit=verdict.fit_error.max(initial=0.0),
        overcut=verdict.overcut.max(initial=0.0),
        uncut=verdict.uncut.sum(),
        setback=verdict.setback.sum(),
        seconds=verdict.seconds,
    )
    print_message(figures, "green" if verdict.accepted else "red")
    if len(verdict.areas):
        area, count = verdict.areas.area.sum(), len(verdict.areas)
        print_message(Message("output.unreached-areas", area=area, count=count), indent=2)
    if verdict.unreached_distance.any():
        length, distance = verdict.unreached.sum(), verdict.unreached_distance.max()
        unreached = Message("output.unreached-edges", length=length, distance=distance)
        print_message(unreached, indent=2)
    if verdict.slit_length.any():
        length, count = verdict.slit_length.sum(), (verdict.slit_length > 0.0).sum()
        print_message(Message("output.wide-slits", length=length, count=count), indent=2)
    for name, figure in PROGRAM_FIGURES.items():
        if value := getattr(verdict.program, name):
            title = Message(figure.title)
            print_message(Message(_FIGURE_LINES[figure.unit], title=title, value=value), indent=2)
    for finding in verdict.findings[:20]:
        print_message(finding.located_message, indent=2)
        if finding.acceptance is not None:
            given = finding.acceptance
            accepted = Message("output.accepted-by", by=given.by, reason=given.reason)
            print_message(accepted, indent=4)
    if len(verdict.findings) > 20:
        print_message(Message("output.more", count=len(verdict.findings) - 20), indent=2)
    _print_how_to_accept(verdict)


def _print_how_to_accept(verdict: Verdict) -> None:
    """Print the options that accept the shortfalls of a program, if it has no faults."""
    open_findings = [finding for finding in verdict.findings if finding.refuses]
    if any(finding.severity is Severity.FAULT for finding in open_findings):
        return
    edges: dict[str, list[int]] = {}
    for finding in open_findings:
        edges.setdefault(finding.message.code, []).append(finding.edge)
    for code, rows in edges.items():
        listed = ",".join(str(row) for row in dict.fromkeys(rows))
        print_message(Message("output.to-accept", edges=listed, code=code), indent=2)


def faulty_edges(verdict: Verdict) -> list[int]:
    """Return the rows of the edges because of whose faults no program is written, ascending."""
    faults = (finding for finding in verdict.findings if finding.severity is Severity.FAULT)
    return sorted({row for finding in faults for row in finding.all_edges})


def _parse_placement(text: str) -> tuple[float, float]:
    """Return x and y (mm) from the text "X,Y" of the option ``--placement``."""
    match = re.fullmatch(rf"\s*({NUMBER})\s*,\s*({NUMBER})\s*", text, re.ASCII)
    if match is None:
        raise typer.BadParameter(f"{text!r} is not of the form X,Y (mm).", param_hint="--placement")
    return float(match[1]), float(match[2])


def _refuse_questions(loaded: LoadedDrawing, machine: Machine) -> None:
    """Print the questions about a drawing that the user must answer first, and exit with code 2.

    Warnings about what import left out are printed in any case.
    """
    report_warnings(loaded.warnings())
    open_questions = loaded.questions(machine)
    if open_questions:
        report_questions(open_questions)
        raise typer.Exit(QUESTIONS)


@dataclass(frozen=True, slots=True)
class ProgramOptions:
    """Command-line options for the language of a program and for its report."""

    dialect: Annotated[
        str,
        typer.Option(
            help="Controller language of the program, such as linuxcnc, "
            "grblhal or hpgl. Default: the "
            "language in the machine file."
        ),
    ] = ""
    report: Annotated[
        Path | None,
        typer.Option(
            help="File to write a JSON report of the program to, with its "
            "measured deviations and times, and the verdict of "
            "the verifier. Default: no report."
        ),
    ] = None


def program(
    file: DrawingFile,
    target: TargetOptions,
    output: Annotated[Path, typer.Option("-o", "--output", help="File to write the program to.")],
    reading: ReadingOptions,
    options: JobOptions,
    exceptions: ExceptionOptions,
    rest: RestOptions,
    wanted: ProgramOptions,
) -> None:
    """Compile a drawing to a verified machine program.

    The program is written only if the verifier accepts it.  With one of the options --from-track,
    --from-line and --station, it makes only some tracks of the program and counts all other tracks
    as made; the verifier then accepts it if both together make the drawing.  Exits with 1 if it is
    refused, and with 2 while questions about the drawing are open.
    """
    machine, board = target.load()
    pipeline.check_options(options, machine)
    with progress(file.name) as report_progress:
        loaded = reading.load(file)
        _refuse_questions(loaded, machine)
        result = pipeline.compile(
            loaded.drawing,
            loaded.dieline,
            machine,
            board,
            options=options,
            dialect=wanted.dialect,
            progress=report_progress,
        )
        if rest.is_given:
            result = pipeline.compile_rest(
                loaded.drawing,
                loaded.dieline,
                with_language(machine, wanted.dialect),
                board,
                pipeline.rest_of(result, rest.choice()),
                options=options,
                progress=report_progress,
            )
    result = replace(result, verdict=exceptions.apply(result.verdict))
    if wanted.report is not None:
        data = {
            "drawing": report_json(file.name, loaded.drawing),
            "machine": machine.name,
            "board": board.name,
            "profile": reading.profile,
            **options.model_dump(mode="json"),
            **_compiled_json(result, loaded.drawing),
        }
        write_bytes(wanted.report, json_bytes(data))
    print_verdict(result.verdict)
    if edges := faulty_edges(result.verdict):
        print_how_to_leave_out(edges)
    retracted = result.seconds_retracted
    if retracted > result.seconds:
        percent = 100.0 * (1.0 - result.seconds / retracted)
        saved = {"seconds": result.seconds, "percent": percent, "retracted": retracted}
        print_message(Message("output.time-saved", **saved), indent=2)
    if not result.verdict.accepted:
        raise typer.Exit(REFUSED)
    write_bytes(output, result.program.text)


def _compiled_json(result: pipeline.Compiled, drawing: Drawing) -> dict[str, Any]:
    """Return the measurements of a compiled program and the verifier's verdict as JSON data."""
    return {
        "placement": list(result.placement),
        "seconds": result.seconds,
        "seconds_retracted": result.seconds_retracted,
        "program": {
            "dialect": result.program.dialect,
            "lines": len(result.program),
            "sha256": hashlib.sha256(result.program.text).hexdigest(),
        },
        "verdict": verdict_json(result.verdict, drawing.handles),
        "samples": {
            name: np.round(getattr(result.verdict.samples, name), 6).tolist()
            for name in ("edge", "place", "deviation")
        },
    }


def verify(
    program: Annotated[
        Path, typer.Argument(metavar="PROGRAM", help="File with the machine program to verify.")
    ],
    drawing: Annotated[Path, typer.Option(help="Drawing with which the program is compared.")],
    target: TargetOptions,
    reading: ReadingOptions,
    options: VerifiedOptions,
    exceptions: ExceptionOptions,
    placement_option: Annotated[
        str,
        typer.Option(
            "--placement",
            metavar="X,Y",
            help="Position of the origin of the drawing on the sheet, in mm; "
            "required if the program does not "
            "contain it.",
        ),
    ] = "",
    json: Json = False,
) -> None:
    """Verify that a program cuts and creases what a drawing shows.

    Exits with 1 if the program is refused.
    """
    machine, board = target.load()
    loaded = reading.load(drawing)
    _refuse_questions(loaded, machine)
    text = read_bytes(program)
    placement = (
        _parse_placement(placement_option) if placement_option else read_placement(text, machine)
    )
    if placement is None:
        raise ProgramUnreadable("program.no-placement", program=program.name)
    verdict = pipeline.verify(text, loaded.dieline, placement, machine, board, options=options)
    verdict = exceptions.apply(verdict)
    if json:
        print_json(verdict_json(verdict, loaded.drawing.handles))
    else:
        print_verdict(verdict)
    if not verdict.accepted:
        raise typer.Exit(REFUSED)


def register(app: typer.Typer) -> None:
    """Add the commands ``program`` and ``verify`` to a Typer application."""
    for command in (program, verify):
        app.command()(expand(command, SYNTAX))
