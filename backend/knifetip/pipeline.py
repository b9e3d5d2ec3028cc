"""The pipeline: the stages that turn the bytes of a drawing into a verified program.

::

    bytes → Drawing → Dieline → Cleaned → Operations → Toolpaths → Toolpath → Program → Verdict
        read    classify    clean    plan     compensate   sequence  process    verify

The upper line has the data, and the lower line the stages between them.  Each stage is a function
of this module, for library users (``from knifetip import read``), the command line and jobs alike;
``compile`` runs all of them from ``clean`` on.  ``line_types`` has the first two, and ``toolpaths``
those from ``plan`` to ``sequence``.

Callers refer to edges by their rows in the drawing.  Planning and verification use the rows of the
cleaned dieline; ``compile`` and ``verify`` map their results back to the drawing's rows.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TypeVar

from knifetip.checked_cleaning import clean_checked
from knifetip.compensation.compensate import compensate
from knifetip.error_places import located_errors
from knifetip.errors import OpenQuestions
from knifetip.geometry.columns import F64, I32
from knifetip.geometry.similarity import Similarity
from knifetip.languages.registry import with_language
from knifetip.library import load
from knifetip.line_types import apply_answers, classify, interpret, questions, read, rules_of
from knifetip.model.board import Board
from knifetip.model.chosen_work import chosen_work, work_on_cleaned
from knifetip.model.cleaned import Cleaned
from knifetip.model.cut_depths import with_depths
from knifetip.model.dieline import Dieline
from knifetip.model.drawing import Drawing
from knifetip.model.earlier_work import EarlierWork
from knifetip.model.job_options import JobOptions, VerifiedOptions
from knifetip.model.machine import Machine
from knifetip.model.program import Program
from knifetip.model.rest import Rest
from knifetip.model.stage import Progress, Stage, no_progress
from knifetip.model.toolpath import Toolpath
from knifetip.model.verdict import Verdict
from knifetip.planning.choice_checks import check_choices
from knifetip.planning.chosen_bridges import locate_bridges
from knifetip.planning.chosen_starts import place_starts
from knifetip.planning.chosen_tools import all_cuts_chosen
from knifetip.planning.cutters import with_best_cutter
from knifetip.planning.nothing_to_make import check_has_work
from knifetip.planning.placement import placement
from knifetip.planning.plan import plan
from knifetip.planning.registration import (
    check_on_table,
    lay_edges,
    lay_options,
    measured_similarity,
)
from knifetip.post.emit import process
from knifetip.proof import PlacedJob, planned_notes, prove
from knifetip.sequencing.air_moves import with_full_retracts
from knifetip.sequencing.chosen_order import place_order
from knifetip.sequencing.duration import duration, durations
from knifetip.sequencing.rest_path import keep_tracks
from knifetip.sequencing.sequence import sequence
from knifetip.sequencing.tracks import RestChoice, find_tracks, row_lines, select_rest
from knifetip.toolpaths import CleanedChoices, check_options, find_toolpath

__all__ = [
    "TOLERANCE",
    "Compiled",
    "apply_answers",
    "check_options",
    "classify",
    "clean",
    "compensate",
    "compile",
    "compile_rest",
    "interpret",
    "plan",
    "process",
    "questions",
    "read",
    "rest_of",
    "rules_of",
    "sequence",
    "verify",
]

#: Maximum distance of the tool's tip from the drawn line (mm).
TOLERANCE = 0.01

_DEFAULT_OPTIONS = JobOptions()
Options = TypeVar("Options", bound=VerifiedOptions)


@dataclass(frozen=True, eq=False, slots=True)
class Compiled:
    """Tool path, program and verdict of a drawing that was compiled for one machine and board."""

    toolpath: Toolpath
    program: Program
    verdict: Verdict
    placement: tuple[float, float]  #: offset of the drawing on the sheet (mm)
    seconds: float  #: estimated machine time with accelerations (s)
    seconds_retracted: float  #: machine time if the tool retracted fully for every turn (s)
    row_seconds: F64  #: (r,) s, share of each row of the tool path in ``seconds``
    #: (n,) for each edge of the drawing the edge that has its rows in the tool path: itself, or
    #: another one with which it is made; -1 if it is not made
    made_as: I32
    #: the map from the drawing to the table, if marks were measured
    similarity: Similarity | None = None


def clean(dieline: Dieline) -> Cleaned:
    """Return the dieline without duplicates, overlaps, gaps and specks.

    It is cleaned as far as the verifier confirms that nothing is lost.

    Raises
    ------
    GeometryError, DrawingTooLarge
        See ``cleaning.clean.clean``.
    """
    return clean_checked(dieline).cleaned


def compile(
    drawing: Drawing,
    dieline: Dieline,
    machine: Machine,
    board: Board,
    *,
    options: JobOptions = _DEFAULT_OPTIONS,
    dialect: str = "",
    notes: Sequence[str] = (),
    progress: Progress = no_progress,
) -> Compiled:
    """Compile a dieline to a program for a machine and a board, and verify it.

    Of several router bits, the thickest one that leaves nothing uncut makes the cuts.

    Parameters
    ----------
    drawing, dieline
        The drawing, and its edges with their line types.
    machine, board
        The machine that runs the program, and the material.
    options
        The user's options for the job.
    dialect
        Name of a controller language; "" for the machine's own.
    notes
        Comments that are added to the head of the program.
    progress
        Called at the start of each stage with the completed fraction of the compile, 0 … 1.

    Raises
    ------
    OpenQuestions
        The user must still choose the unit, a line type or a tool.
    PlanError, CompensationError
        The drawing cannot be made on this machine and board.
    """
    machine = with_language(machine, dialect).for_board(board)
    check_has_work(drawing, dieline)
    open_questions = questions(drawing, dieline, machine)
    if open_questions:
        raise OpenQuestions([question.as_json() for question in open_questions])
    progress(Stage.CLEAN, 0.02)
    unlaid, dieline, options = dieline, *_lay(dieline, options)
    with located_errors(drawing):
        work = chosen_work(options, dieline)
        dieline = with_depths(dieline, work, board.caliper)
        check_choices(work, dieline, machine, board)
    checked = clean_checked(dieline)
    cleaned = checked.cleaned
    offset = _place(cleaned.dieline, machine, options)
    with located_errors(drawing):
        starts = place_starts(options.contour_starts, dieline, cleaned, offset)
        order = place_order(options.work_order, dieline, cleaned)
        bridges = locate_bridges(options.bridges, dieline, cleaned, offset)
        chosen = CleanedChoices(starts, work_on_cleaned(work, cleaned), order, bridges)

    def attempt(machine: Machine) -> Compiled:
        # Cutters that the machine does not carry have no limits of the board yet.
        check_options(options, machine)
        machine = _for_job(machine, board, options)
        with located_errors(drawing, cleaned, offset):
            toolpath = find_toolpath(cleaned, offset, machine, board, options, chosen, progress)
        job = PlacedJob(checked, offset, machine, board, options, chosen=work, unlaid=unlaid)
        with located_errors(drawing):
            return _write_and_verify(job, toolpath, notes, progress)

    compiled, found = with_best_cutter(
        attempt, machine, load.cutters, fixed=all_cuts_chosen(work, dieline)
    )
    verdict = compiled.verdict
    findings = (*verdict.findings, *planned_notes(found))
    return replace(compiled, verdict=replace(verdict, findings=findings))


def compile_rest(
    drawing: Drawing,
    dieline: Dieline,
    machine: Machine,
    board: Board,
    rest: Rest,
    *,
    options: JobOptions = _DEFAULT_OPTIONS,
    notes: Sequence[str] = (),
    progress: Progress = no_progress,
) -> Compiled:
    """Compile a program that makes the rest of a sheet on which earlier programs did some work.

    The program makes tracks (paths between two lifts) of the toolpath of an earlier program, in
    their order.  Its verdict is that on the whole sheet: it is refused unless the earlier work and
    the program together make all edges, each once.

    Parameters
    ----------
    drawing, dieline, machine, board, options
        The inputs from which the earlier program was compiled.
    rest
        The tracks that the program makes, and the earlier work.
    notes
        Comments that are added to the head of the program.
    progress
        Called at the start of each stage with the completed fraction of the compile, 0 … 1.

    Raises
    ------
    PlanError
        No track is selected.
    TravelExceeded
        An air move to a track would leave the limits of an axis.
    """
    progress(Stage.CLEAN, 0.02)
    machine = _for_job(machine, board, options)
    unlaid, dieline, options = dieline, *_lay(dieline, options)
    work = chosen_work(options, dieline)
    checked = clean_checked(with_depths(dieline, work, board.caliper))
    offset = _place(checked.cleaned.dieline, machine, options)
    progress(Stage.SEQUENCE, 0.4)
    with located_errors(drawing):
        toolpath = keep_tracks(rest.toolpath, rest.tracks, machine, board.caliper)
        job = PlacedJob(checked, offset, machine, board, options, rest.earlier, work, unlaid)
        return _write_and_verify(job, toolpath, notes, progress)


def rest_of(compiled: Compiled, choice: RestChoice, executed: int = 0) -> Rest:
    """Return the rest of a compiled program, for ``compile_rest``.

    Parameters
    ----------
    compiled
        The program of which a part was executed.
    choice
        The user's choice of the tracks that remain to be made.
    executed
        Number of program lines that were executed.

    Raises
    ------
    PlanError
        There is no such track, no track remains, or a track that was not executed is left out
        although the choice does not state that it is made.
    """
    program, toolpath = compiled.program, compiled.toolpath
    tracks = find_tracks(toolpath, row_lines(program, len(toolpath)))
    selected = select_rest(tracks, executed, choice)
    work = EarlierWork(program.text, selected.made_lines, selected.repeated_lines)
    return Rest(toolpath, selected.tracks, (work,))


def verify(
    text: bytes,
    dieline: Dieline,
    placement: tuple[float, float],
    machine: Machine,
    board: Board,
    *,
    options: VerifiedOptions = _DEFAULT_OPTIONS,
    tolerance: float = TOLERANCE,
    earlier: Sequence[EarlierWork] = (),
) -> Verdict:
    """Verify a program against the drawn edges.

    Parameters
    ----------
    text
        The program, made by knifetip or by another system.
    dieline
        The edges of the drawing, before cleaning.
    placement : mm
        Shift (x, y) that moves the drawing to its position on the machine's table.
    options
        The options for which the program was compiled.
    tolerance : mm
        Maximum distance of the tool's tip from the drawn line.
    earlier
        Programs that did a part of the work on the same sheet, in the order of their execution.

    Raises
    ------
    ProgramUnreadable
        The program is not of type bytes or is too large, or the machine's file lacks an entry that
        is needed to read the program.
    ProgramError
        The tolerance is not a positive, finite number.
    GeometryError
        A coordinate of the dieline is not finite or too far from the origin, or the placement is
        not finite.
    DrawingTooLarge
        Too many edges overlap.
    """
    machine = _for_job(machine, board, options)
    unlaid, dieline, options = dieline, *_lay(dieline, options)
    work = chosen_work(options, dieline)
    checked = clean_checked(with_depths(dieline, work, board.caliper))
    job = PlacedJob(checked, placement, machine, board, options, earlier, work, unlaid)
    return prove(job, text, tolerance)


def _for_job(machine: Machine, board: Board, options: VerifiedOptions) -> Machine:
    """Return the machine with the limits of a board, and with feeds and heights of a job."""
    return machine.for_board(board).at_feed(options.feed_factor).over_warp(options.warp)


def _lay(dieline: Dieline, options: Options) -> tuple[Dieline, Options]:
    """Return edges and options as they lie on the table by the measured marks of a sheet.

    They are unchanged if no marks were measured.  Raises PlanError if the marks fit too badly.
    """
    similarity = measured_similarity(options)
    return lay_edges(dieline, similarity), lay_options(options, similarity)


def _place(dieline: Dieline, machine: Machine, options: VerifiedOptions) -> tuple[float, float]:
    """Return the shift (x, y) in mm that moves edges to their position on the machine's table.

    It is 0 for edges that lie there by measured marks.  Raises TravelExceeded if they extend past
    the table.
    """
    if measured_similarity(options) is None:
        return placement(dieline, machine, options.sheet)
    check_on_table(dieline, machine)
    return 0.0, 0.0


def _write_and_verify(
    job: PlacedJob, toolpath: Toolpath, notes: Sequence[str], progress: Progress
) -> Compiled:
    """Return the program of a toolpath, with its verdict and its machine time.

    ``notes`` are comments that are added to the head of the program.
    """
    progress(Stage.PROCESS, 0.5)
    machine, board = job.machine, job.board
    head = (
        f"machine {machine.name}",
        f"board {board.name} caliper {board.caliper:g}",
        f"placement X{job.offset[0]:.4f} Y{job.offset[1]:.4f}",
        *job.options.head_notes,
        *notes,
    )
    program = process(toolpath, machine, tolerance=TOLERANCE, notes=head)
    progress(Stage.VERIFY, 0.7)
    verdict = prove(job, program.text, TOLERANCE, toolpath.notes)
    progress(Stage.DONE, 1.0)
    full = duration(with_full_retracts(toolpath, machine), machine)
    times = durations(toolpath, machine)
    return Compiled(
        toolpath,
        program,
        verdict,
        job.offset,
        float(times.sum()),
        full,
        times,
        job.checked.cleaned.made_as,
        measured_similarity(job.options),
    )
