"""The pipeline: the stages that turn the bytes of a drawing into a verified program.

::

    bytes → Drawing → Dieline → Cleaned → Operations → Toolpaths → Toolpath → Program → Verdict
        read    classify    clean    plan     compensate   sequence  process    verify

The upper line has the data, and the lower line the stages between them.  Each stage is a function
of this module, for library users (``from knifetip import read``), the command line and jobs alike;
``compile`` runs all of them from ``clean`` on.  Callers refer to edges by their rows in the
drawing.  Planning and verification use the rows of the cleaned dieline; ``compile`` and ``verify``
map their results back to the drawing's rows.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TypeVar

import numpy as np

from knifetip.checked_cleaning import clean_checked
from knifetip.classification import classify as classification
from knifetip.classification.answers import follow_answers
from knifetip.classification.customer_answers import answer_from_drawings
from knifetip.classification.questions import list_questions
from knifetip.compensation.compensate import compensate
from knifetip.compensation.contour_starts import contour_starts
from knifetip.compensation.edge_feeds import with_edge_feeds
from knifetip.error_places import located_errors
from knifetip.errors import OpenQuestions, PlanError
from knifetip.formats import open_file
from knifetip.geometry.columns import F64, I32, U8
from knifetip.geometry.similarity import Similarity
from knifetip.languages.registry import with_language
from knifetip.library import custom_profiles, load
from knifetip.model.board import Board
from knifetip.model.chosen_work import ChosenWork, chosen_work, work_on_cleaned
from knifetip.model.cleaned import Cleaned
from knifetip.model.customer_answers import learned_from_text
from knifetip.model.cut_depths import with_depths
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.drawing import Drawing
from knifetip.model.earlier_work import EarlierWork
from knifetip.model.interpretation import Interpretation
from knifetip.model.job_options import JobOptions, VerifiedOptions
from knifetip.model.machine import Machine
from knifetip.model.operation import Operation
from knifetip.model.profile import LineRules
from knifetip.model.program import Program
from knifetip.model.question import Question
from knifetip.model.rest import Rest
from knifetip.model.stage import Progress, Stage, no_progress
from knifetip.model.toolpath import Toolpath
from knifetip.model.verdict import Verdict
from knifetip.planning.boundary import BoardOutline
from knifetip.planning.choice_checks import check_choices
from knifetip.planning.chosen_bridges import ChosenBridge, locate_bridges
from knifetip.planning.chosen_starts import ChosenStart, apply_starts, place_starts
from knifetip.planning.chosen_tools import all_cuts_chosen
from knifetip.planning.cutters import with_best_cutter
from knifetip.planning.nothing_to_make import check_has_work
from knifetip.planning.placement import placement
from knifetip.planning.plan import check_corners, plan
from knifetip.planning.questions import tool_questions
from knifetip.planning.registration import (
    check_on_table,
    lay_edges,
    lay_options,
    measured_similarity,
)
from knifetip.planning.sheet_outline import sheet_outline
from knifetip.post.emit import process
from knifetip.proof import PlacedJob, planned_notes, prove
from knifetip.sequencing.air_moves import with_full_retracts
from knifetip.sequencing.chosen_order import ChosenOrder, place_order
from knifetip.sequencing.contour_starts import choose_starts
from knifetip.sequencing.duration import duration, durations
from knifetip.sequencing.rest_path import keep_tracks
from knifetip.sequencing.sequence import sequence
from knifetip.sequencing.tracks import RestChoice, find_tracks, row_lines, select_rest
from knifetip.units.evidence import find_unit
from knifetip.units.likeliest_unit import choose_unit
from knifetip.units.question import unit_question

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


@dataclass(frozen=True, eq=False, slots=True)
class _CleanedChoices:
    """A user's choices for cleaned edges, at their position on the table."""

    starts: Sequence[ChosenStart]
    work: ChosenWork
    order: ChosenOrder | None
    bridges: Sequence[ChosenBridge]


def read(data: bytes, unit: str | None = None) -> Drawing:
    """Return the drawing in the bytes of a file of any import format.

    Parameters
    ----------
    data
        The file; its format is detected from its content.
    unit
        The unit of the drawing, whatever unit the file states: a key of ``model.unit.MILLIMETRES``.
        If it is None, the unit in the file is compared with the geometry.  It is replaced if
        another unit is far likelier.  If the evidence is not conclusive, ``Drawing.unit`` is empty.

    Raises
    ------
    ReadError
        The file is not a drawing, damaged, or too large.
    """
    # A file that another program must convert is converted once.
    file = open_file(data)
    drawing = file.read(unit or "")
    return drawing if unit else choose_unit(drawing, file.read)


def classify(drawing: Drawing, rules: LineRules, overrides: U8 | None = None) -> Dieline:
    """Return the edges of a drawing with their line types.

    Parameters
    ----------
    rules
        The classification profile.
    overrides : (n,)
        For each of the n edges the LineType that the user has set, or ``NO_OVERRIDE`` to keep the
        type from the classification.  None if the user has set no line type.  Open edges get the
        line types that follow from them.
    """
    dieline = classification.classify(drawing, rules, load.conventions())
    return _with_overrides(drawing, dieline, overrides)


def interpret(drawing: Drawing, interpretation: Interpretation) -> Dieline:
    """Return the edges of a drawing with the line types that a profile and the user give them.

    ``interpretation`` contains the name or content of the classification profile, what earlier
    drawings of the customer taught, and the line types that the user has set for single edges.
    """
    return apply_answers(drawing, classify(drawing, rules_of(interpretation)), interpretation)


def apply_answers(drawing: Drawing, dieline: Dieline, interpretation: Interpretation) -> Dieline:
    """Return a classified dieline with the answers of earlier drawings and those of the user.

    ``dieline`` contains the edges of ``drawing`` as ``classify`` returns them without overrides.
    """
    learned = learned_from_text(interpretation.learned)
    known = answer_from_drawings(drawing, dieline, learned)
    return _with_overrides(drawing, known, interpretation.override_column)


def _with_overrides(drawing: Drawing, dieline: Dieline, overrides: U8 | None) -> Dieline:
    """Return a dieline with the line types that the user gives, (n,), and what follows from them.

    ``overrides`` is None if the user has set no line type.
    """
    if overrides is None:
        return dieline
    answered = classification.apply_overrides(dieline, overrides)
    return follow_answers(drawing, dieline, answered, overrides)


def rules_of(interpretation: Interpretation) -> LineRules:
    """Return the rules of the classification profile that a user has chosen for a drawing.

    ``interpretation`` contains the TOML text of a customer's profile, or the name of a profile of
    the library.
    """
    if interpretation.rules:
        return custom_profiles.parse_text(interpretation.profile, interpretation.rules)
    return load.profile(interpretation.profile, files=False)


def questions(drawing: Drawing, dieline: Dieline, machine: Machine | None = None) -> list[Question]:
    """Return the questions about a drawing that the user must still answer.

    If a machine is given, these include questions about line types for which it has no tool.
    """
    unit = None if drawing.unit else unit_question(drawing, find_unit(drawing))
    open_questions = ([unit] if unit else []) + list_questions(drawing, dieline)
    return open_questions if machine is None else open_questions + tool_questions(dieline, machine)


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
        chosen = _CleanedChoices(starts, work_on_cleaned(work, cleaned), order, bridges)

    def attempt(machine: Machine) -> Compiled:
        # Cutters that the machine does not carry have no limits of the board yet.
        machine = machine.for_board(board).at_feed(options.feed_factor)
        with located_errors(drawing, cleaned, offset):
            toolpath = _toolpath(cleaned, offset, machine, board, options, chosen, progress)
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
    machine = machine.for_board(board).at_feed(options.feed_factor)
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
    machine = machine.for_board(board).at_feed(options.feed_factor)
    unlaid, dieline, options = dieline, *_lay(dieline, options)
    work = chosen_work(options, dieline)
    checked = clean_checked(with_depths(dieline, work, board.caliper))
    job = PlacedJob(checked, placement, machine, board, options, earlier, work, unlaid)
    return prove(job, text, tolerance)


def check_options(options: JobOptions, machine: Machine) -> None:
    """Raise ``PlanError`` if a machine cannot satisfy the user's options for a job."""
    check_corners(options.corners, machine)
    if options.lift == "least" and machine.turn_clearance == 0.0:
        raise PlanError("lift.not-stated", machine=machine.title)


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


def _toolpath(
    cleaned: Cleaned,
    offset: tuple[float, float],
    machine: Machine,
    board: Board,
    options: JobOptions,
    chosen: _CleanedChoices,
    progress: Progress,
) -> Toolpath:
    """Return the tool path for cleaned edges.

    The column ``source`` of the tool path contains for each move the index in the drawing of the
    edge that the move makes, or -1 if it makes none.

    ``offset``: shift (x, y) in mm that moves the drawing to its position on the machine's table.
    ``options``: the user's options for the job.
    ``chosen``: the user's choices for cleaned edges.
    ``progress``: called at the start of each stage with the completed fraction of the compile, 0 …
    1.
    Raises ``PlanError, CompensationError``: the drawing cannot be made on this machine, board and
    sheet.
    """
    check_options(options, machine)
    safety = machine.turn_clearance if options.lift == "least" else 0.0
    shifted = replace(cleaned.dieline, ends=cleaned.dieline.ends + np.array(offset))
    progress(Stage.PLAN, 0.05)
    outlines: list[BoardOutline | None] = [None]
    if options.sheet is not None:
        similarity = measured_similarity(options)
        turn = 0.0 if similarity is None else similarity.turn
        sheet = sheet_outline(options.sheet, shifted, machine, turn)
        # Only grooves run out past the edges of a sheet.
        if (shifted.line_type == LineType.V_GROOVE).any():
            outlines.append(sheet)
    found = []
    for outline in outlines:
        operations = plan(
            shifted,
            machine,
            board,
            options.corners,
            outline,
            offset,
            chosen.work,
            chosen.bridges,
        )
        operations = apply_starts(operations, chosen.starts, together=chosen.order is not None)
        progress(Stage.COMPENSATE, 0.2)
        toolpaths = [
            with_edge_feeds(compensate(_with_starts(operation, machine)), chosen.work)
            for operation in operations
        ]
        progress(Stage.SEQUENCE, 0.4)
        edges = None if outline is None else outline.edges
        found.append(sequence(toolpaths, machine, edges, safety, chosen.order))
    # Leaving the sheet takes time, too: it does not pay for each drawing.
    toolpath = min(found, key=lambda one: duration(one, machine)) if len(found) > 1 else found[0]
    source = cleaned.dieline.source[np.maximum(toolpath.source, 0)]
    return replace(toolpath, source=np.where(toolpath.source < 0, -1, source))


def _with_starts(operation: Operation, machine: Machine) -> Operation:
    """Return an operation whose closed paths begin where the air moves between the paths are short.

    If its tool has no choice, the operation is returned unchanged.
    """
    starts = contour_starts(operation)
    if starts is None:
        return operation
    return replace(
        operation, begin=choose_starts(starts, machine.station(operation.station), machine)
    )


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
