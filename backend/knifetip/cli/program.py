"""knifetip program and verify: compile a drawing to a program, and verify a program."""

from __future__ import annotations

import hashlib
import re
from dataclasses import dataclass, replace
from enum import Enum
from pathlib import Path
from typing import Annotated, Any

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
from knifetip.cli.options import expand
from knifetip.cli.rest import RestOptions
from knifetip.cli.terminal import (
    QUESTIONS,
    REFUSED,
    json_bytes,
    print_how_to_leave_out,
    print_json,
    print_stderr,
    progress,
    read_bytes,
    report_questions,
    report_warnings,
    write_bytes,
)
from knifetip.errors import PlanError, ProgramUnreadable
from knifetip.languages.registry import with_language
from knifetip.library import load
from knifetip.model.board import Board
from knifetip.model.choices import Choices
from knifetip.model.corners import CornerAt, Corners
from knifetip.model.drawing import Drawing
from knifetip.model.machine import Machine
from knifetip.model.sheet import Sheet
from knifetip.model.verdict import Severity, Verdict
from knifetip.planning.plan import check_corners
from knifetip.presentation.import_warnings import import_warnings
from knifetip.presentation.verdict import verdict_json
from knifetip.verification.verify import read_placement

_NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d{1,2})?"
_CORNER = re.compile(
    rf"\s*(?P<x>{_NUMBER})\s*,\s*(?P<y>{_NUMBER})\s*=\s*(?P<type>\w+)\s*(?::\s*(?P<k>{_NUMBER})\s*)?",
    re.ASCII,
)
_SHEET = re.compile(rf"\s*({_NUMBER})\s*[xX×]\s*({_NUMBER})\s*(?::\s*({_NUMBER})\s*)?", re.ASCII)


class CornerType(Enum):
    """Shape of the path of a cutter round outer corners.

    B is an arc, C consists of lines with a stop, D of lines with an arc between them.  ``auto`` is
    the fastest shape for each corner.
    """

    AUTO = "auto"
    B = "B"
    C = "C"
    D = "D"


class Interference(Enum):
    """How to treat a contour into which a cutter does not fit.

    ``trim`` leaves the areas uncut that the cutter cannot reach; ``refuse`` compiles no program.
    """

    TRIM = "trim"
    REFUSE = "refuse"


class Lift(Enum):
    """Height of the tool above the board in turns.

    ``clearance`` is the clearance of the machine, ``least`` its turn clearance where that is
    faster.
    """

    CLEARANCE = "clearance"
    LEAST = "least"


def parse_corner(text: str) -> CornerAt:
    """Return the corner position and the corner type that an option describes.

    Parameters
    ----------
    text
        Value of the option ``--corner-at``: ``X,Y=TYPE`` or ``X,Y=TYPE:K``.  X and Y are in mm; K
        is the parameter of type D, between 0 (like type B) and 1 (like type C).

    Raises
    ------
    PlanError
        The text does not have one of these forms.
    """
    match = _CORNER.fullmatch(text)
    if match is None:
        raise PlanError("command.bad-corner", text=text)
    k = None if match["k"] is None else float(match["k"])
    return CornerAt(float(match["x"]), float(match["y"]), match["type"], k)


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


@dataclass(frozen=True, slots=True)
class CornerOptions:
    """Command-line options for the path of a cutter round outer corners of a contour."""

    corner: Annotated[
        CornerType | None,
        typer.Option(
            help="Path of the cutter at outer corners: B moves on an arc; C "
            "moves straight and stops "
            "at the corner; D moves straight with a small arc at the "
            "corner; auto takes the fastest "
            "of the three. Default: auto."
        ),
    ] = None
    k: Annotated[
        float | None,
        typer.Option(
            help="Shape of corners of type D, without a unit: 0 gives the "
            "path of type B, 1 the path of "
            "type C. Default: 0.5."
        ),
    ] = None
    interference: Annotated[
        Interference | None,
        typer.Option(
            help="What to do if a cutter cannot reach parts of a contour: leave these parts uncut "
            "(trim), or write no program (refuse). Default: trim."
        ),
    ] = None
    corner_at: Annotated[
        list[str] | None,
        typer.Option(
            metavar="X,Y=TYPE[:K]",
            help="Type (B, C, D or auto) of the corner at the position X,Y of "
            "the drawing, in mm; may be "
            "repeated. Default: the type in --corner.",
        ),
    ] = None

    def corners(self, machine: Machine) -> Corners | None:
        """Return the corner settings that the options describe; None if no option is given.

        Raises
        ------
        PlanError
            An option has an invalid value, or the machine has no cutter.
        """
        given = (self.corner, self.k, self.interference, self.corner_at or None)
        if all(each is None for each in given):
            return None
        corners = Corners(
            type=(self.corner or CornerType.AUTO).value,
            k=0.5 if self.k is None else self.k,
            interference=(self.interference or Interference.TRIM).value,
            at=tuple(parse_corner(text) for text in self.corner_at or []),
        )
        check_corners(corners, machine)
        return corners


def parse_sheet(text: str) -> Sheet | None:
    """Return the sheet that the option ``--sheet`` describes; None for an empty text.

    Parameters
    ----------
    text
        ``outline``, ``WIDTHxHEIGHT`` or ``WIDTHxHEIGHT:MARGIN``, in mm.

    Raises
    ------
    PlanError
        The text does not have one of these forms, or a size is 0 or negative.
    """
    if not text:
        return None
    if text == "outline":
        return Sheet()
    match = _SHEET.fullmatch(text)
    sheet = Sheet(*(float(each or 0.0) for each in match.groups())) if match else Sheet()
    if not (min(sheet.width, sheet.height) > 0.0 and sheet.margin >= 0.0):
        raise PlanError("sheet.bad-size", text=text)
    return sheet


@dataclass(frozen=True, slots=True)
class SheetOptions:
    """The command-line option that describes the sheet on the table."""

    sheet: Annotated[
        str,
        typer.Option(
            metavar="WxH[:MARGIN]",
            help="The sheet was cut to this size, in mm, and the drawing lies MARGIN from its left "
            "and lower edge; or outline: the sheet was cut to the outline of the drawing. Tools "
            "turn without a lift beside such a sheet. Default: a sheet of unknown size.",
        ),
    ] = ""

    def record(self) -> Sheet | None:
        """Return the sheet that the option describes; None if it is not given."""
        return parse_sheet(self.sheet)


def print_verdict(verdict: Verdict) -> None:
    """Print the measurements and the first findings of a verdict of the verifier."""
    word = "accepted" if verdict.accepted else "refused"
    print_stderr(
        f"{word}: deviation {verdict.deviation.max(initial=0.0):.4f} mm (tolerance "
        f"{verdict.tolerance:g}; path {verdict.path_deviation.max(initial=0.0):.4f}, rounding by "
        f"the controller {verdict.blending.max(initial=0.0):.4f}, curve fit "
        f"{verdict.fit_error.max(initial=0.0):.4f}), "
        f"overcut {verdict.overcut.max(initial=0.0):.3f} mm, "
        f"uncut {verdict.uncut.sum():.3f} mm, setback {verdict.setback.sum():.3f} mm, "
        f"{verdict.seconds:.1f} s at the programmed feeds",
        "green" if verdict.accepted else "red",
    )
    if len(verdict.areas):
        print_stderr(
            f"  the cutter does not reach {verdict.areas.area.sum():.2f} mm² in "
            f"{len(verdict.areas)} places, which remain uncut"
        )
    if verdict.unreached_distance.any():
        print_stderr(
            f"  the cutter does not reach {verdict.unreached.sum():.2f} mm of the edges; they are "
            f"up to {verdict.unreached_distance.max():.2f} mm from the cut"
        )
    if verdict.slit_length.any():
        print_stderr(
            f"  {verdict.slit_length.sum():.2f} mm of {(verdict.slit_length > 0.0).sum()} slits "
            "are milled as wide as the cutter"
        )
    for finding in verdict.findings[:20]:
        print_stderr(f"  {finding.text}")
        if finding.acceptance is not None:
            given = finding.acceptance
            print_stderr(f"    accepted by {given.by}: {given.reason}")
    if len(verdict.findings) > 20:
        print_stderr(f"  and {len(verdict.findings) - 20} more")
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
        print_stderr(f'  To accept: --accept {listed}:{code} --reason "..."')


def faulty_edges(verdict: Verdict) -> list[int]:
    """Return the rows of the edges because of whose faults no program is written, ascending."""
    faults = (finding for finding in verdict.findings if finding.severity is Severity.FAULT)
    return sorted({row for finding in faults for row in finding.all_edges})


def _parse_placement(text: str) -> tuple[float, float]:
    """Return x and y (mm) from the text "X,Y" of the option ``--placement``."""
    match = re.fullmatch(rf"\s*({_NUMBER})\s*,\s*({_NUMBER})\s*", text, re.ASCII)
    if match is None:
        raise typer.BadParameter(f"{text!r} is not of the form X,Y (mm).", param_hint="--placement")
    return float(match[1]), float(match[2])


def _refuse_questions(loaded: LoadedDrawing, machine: Machine) -> None:
    """Print the questions about a drawing that the user must answer first, and exit with code 2.

    Warnings about what import left out are printed in any case.

    Parameters
    ----------
    loaded
        The drawing.
    machine
        Machine for which the drawing is to be compiled.
    """
    report_warnings(import_warnings(loaded.drawing))
    open_questions = loaded.questions(machine)
    if open_questions:
        report_questions(open_questions)
        raise typer.Exit(QUESTIONS)


def program(
    file: DrawingFile,
    target: TargetOptions,
    output: Annotated[Path, typer.Option("-o", "--output", help="File to write the program to.")],
    reading: ReadingOptions,
    corner_options: CornerOptions,
    sheet_options: SheetOptions,
    exceptions: ExceptionOptions,
    rest: RestOptions,
    lift: Annotated[
        Lift,
        typer.Option(
            help="Height of the tool above the board in turns: the clearance of the machine, or "
            "the least lift, which leaves its turn_clearance where that is faster."
        ),
    ] = Lift.CLEARANCE,
    dialect: Annotated[
        str,
        typer.Option(
            help="Controller language of the program, such as linuxcnc, "
            "grblhal or hpgl. Default: the "
            "language in the machine file."
        ),
    ] = "",
    report: Annotated[
        Path | None,
        typer.Option(
            help="File to write a JSON report of the program to, with its "
            "measured deviations and times, and the verdict of "
            "the verifier. Default: no report."
        ),
    ] = None,
) -> None:
    """Compile a drawing to a verified machine program.

    The program is written only if the verifier accepts it.  With one of the options --from-track,
    --from-line and --station, it makes only some tracks of the program and counts all other tracks
    as made; the verifier then accepts it if both together make the drawing.  Exits with 1 if it is
    refused, and with 2 while questions about the drawing are open.
    """
    machine, board = target.load()
    choices = Choices(corner_options.corners(machine), sheet_options.record(), lift.value)
    corners, sheet = choices.corners, choices.sheet
    with progress(file.name) as report_progress:
        loaded = reading.load(file)
        _refuse_questions(loaded, machine)
        result = pipeline.compile(
            loaded.drawing,
            loaded.dieline,
            machine,
            board,
            choices=choices,
            dialect=dialect,
            progress=report_progress,
        )
        if rest.is_given:
            result = pipeline.compile_rest(
                loaded.drawing,
                loaded.dieline,
                with_language(machine, dialect),
                board,
                pipeline.rest_of(result, rest.choice()),
                choices=choices,
                progress=report_progress,
            )
    result = replace(result, verdict=exceptions.apply(result.verdict))
    if report is not None:
        data = {
            "drawing": report_json(file.name, loaded.drawing),
            "machine": machine.name,
            "board": board.name,
            "profile": reading.profile,
            "corners": None if corners is None else corners.as_json(),
            "sheet": None if sheet is None else sheet.as_json(),
            "lift": choices.lift,
            **_compiled_json(result, loaded.drawing),
        }
        write_bytes(report, json_bytes(data))
    print_verdict(result.verdict)
    if edges := faulty_edges(result.verdict):
        print_how_to_leave_out(edges)
    retracted = result.seconds_retracted
    if retracted > result.seconds:
        print_stderr(
            f"  {result.seconds:.1f} s on the machine, "
            f"{1.0 - result.seconds / retracted:.0%} less "
            f"than the {retracted:.1f} s with full retracts"
        )
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
    sheet_options: SheetOptions,
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
    verdict = pipeline.verify(
        text, loaded.dieline, placement, machine, board, sheet=sheet_options.record()
    )
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
        app.command()(expand(command))
