"""Tasks of the worker processes; their arguments and results are bytes and JSON data.

The tasks read a drawing, find the open questions before a compile, compile a job, report the
cleaning of a drawing, and compile functions to machine code with numba.
"""

from __future__ import annotations

import hashlib
import os
from collections.abc import Sequence
from contextlib import nullcontext
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from knifetip.edits import with_types_of_added
from knifetip.errors import KnifetipError, UnitUnknown
from knifetip.formats.cpu_limit import limit_cpu
from knifetip.geometry.columns import U8
from knifetip.library.definition import Definition, board_of, machine_of
from knifetip.messages import finite, printable
from knifetip.model.acceptance import Exceptions, with_ordered_exceptions
from knifetip.model.cleaned import Cleaned
from knifetip.model.customer_answers import use_json
from knifetip.model.dieline import Dieline
from knifetip.model.drawing import Drawing
from knifetip.model.earlier_work import EarlierWork
from knifetip.model.interpretation import NO_OVERRIDE, Interpretation
from knifetip.model.machine import Machine
from knifetip.model.program_facts import ProgramFacts
from knifetip.model.rest import Rest
from knifetip.model.stage import Progress, Stage
from knifetip.presentation.drawing import classified_json
from knifetip.presentation.drawn_edges import MANY_EDGES, pack_drawn_edges
from knifetip.presentation.edges import EdgeTable, restore_drawing
from knifetip.presentation.import_report import import_report_rows, pack_rows
from knifetip.presentation.outcomes import edge_outcomes
from knifetip.presentation.pages import page_json
from knifetip.presentation.toolpath import (
    pack_toolpath,
    program_lines,
    unpack_toolpath,
    used_stations,
)
from knifetip.presentation.verdict import (
    findings_json,
    pack_verdict,
    refusal,
    refused_edges,
    refused_handles,
    verdict_summary,
)
from knifetip.service.http.compression import pack
from knifetip.service.processes.compile_result import CompileResult
from knifetip.service.processes.kernel_groups import (
    Part,
    compile_module,
    is_compiled,
    missing_parts,
)
from knifetip.service.processes.layout_tasks import check_sheet
from knifetip.service.processes.readings import (
    Reading,
    StoredDrawing,
    carry_over,
    read_drawing,
    restore_or_read,
)
from knifetip.service.processes.rest_record import StoredRest
from knifetip.service.tools.worked_lengths import lengths_until, pack_lengths

if TYPE_CHECKING:
    from knifetip.pipeline import Compiled


def import_stages() -> None:
    """Import the modules of all stages, so that the first task of a process does not wait for it.

    It takes seconds.
    """
    from knifetip import pipeline  # noqa: F401  # imported for the other tasks

    missing_parts()


def read(
    progress: Progress,
    content: bytes,
    interpretation: Interpretation,
    handles: Sequence[str] | None = None,
) -> Reading:
    """Read and classify a drawing; return it in the form in which it is stored.

    Parameters
    ----------
    progress
        Called with stage and completed fraction.
    content
        File of the drawing.
    interpretation
        Unit, profile and overrides (line types that the user has set).  The overrides belong to the
        n edges that were found when the same file was read before.
    handles : (n,)
        Handles of the n earlier edges.  If the edges found now have the same handles, they get the
        same overrides.  Otherwise an edge gets an override only if all earlier edges with its
        handle had this override.  None if the file was not read before; the overrides are then
        ignored.

    Raises
    ------
    DrawingTooLarge
        The drawing exceeds a limit, or its reading used ``cpu_limit.READING`` seconds of processor
        time.
    """
    # A new installation compiles the functions of the readers in its first reading.
    limit = limit_cpu() if is_compiled("drawings") else nullcontext()
    with limit:
        return _read(progress, content, interpretation, handles)


#: Most pages of a file that are shown.
MOST_PAGES = 24


def list_pages(progress: Progress, content: bytes) -> list[dict[str, Any]]:
    """Return number, size, number of edges and picture of each page of a file, as JSON data.

    The list is empty for a file of a format without pages, and has at most ``MOST_PAGES`` pages.

    Parameters
    ----------
    progress
        Called with stage and completed fraction.
    content
        The file.

    Raises
    ------
    DrawingTooLarge
        Reading all pages used ``cpu_limit.READING`` seconds of processor time.
    NotADrawing
        The file cannot be read.
    """
    from knifetip.formats import read_each_page

    progress(Stage.READ, 0.0)
    limit = limit_cpu() if is_compiled("drawings") else nullcontext()
    with limit:
        return [
            page_json(number, page)
            for number, page in enumerate(read_each_page(content, MOST_PAGES), start=1)
        ]


def _read(
    progress: Progress,
    content: bytes,
    interpretation: Interpretation,
    handles: Sequence[str] | None,
) -> Reading:
    from knifetip import pipeline
    from knifetip.classification.customer_answers import collect_uses
    from knifetip.presentation.learned import learned_json

    progress(Stage.READ, 0.0)
    drawing = read_drawing(content, interpretation.unit, interpretation.edits)
    overrides = np.full(len(drawing), NO_OVERRIDE, np.uint8)
    if handles is not None:
        before = np.frombuffer(interpretation.overrides, np.uint8)
        found = [printable(handle) for handle in drawing.handles]
        overrides = carry_over(before, handles, found)
        overrides = with_types_of_added(overrides, interpretation.edits, found, handles)
    progress(Stage.CLASSIFY, 0.6)
    interpretation = replace(interpretation, overrides=overrides.tobytes())
    classified = pipeline.classify(drawing, pipeline.rules_of(interpretation))
    dieline = pipeline.apply_answers(drawing, classified, interpretation)
    outcomes = edge_outcomes(drawing, dieline, _clean_or_none(drawing, dieline))
    progress(Stage.STORE, 0.9)
    questions = pipeline.questions(drawing, dieline)
    edges = EdgeTable.from_drawing(drawing, dieline, outcomes).pack()
    return Reading(
        {
            **classified_json(drawing, dieline, outcomes, questions, overrides),
            "learned": learned_json(drawing, dieline, interpretation.learned),
        },
        edges,
        pack_rows(import_report_rows(drawing)),
        overrides.tobytes(),
        [use_json(use) for use in collect_uses(drawing, classified, overrides)],
        pack([pack_drawn_edges(edges)]) if len(drawing) >= MANY_EDGES else b"",
    )


def _clean_or_none(drawing: Drawing, dieline: Dieline) -> Cleaned | None:
    """Return the result of cleaning a drawing; None if it cannot be cleaned.

    A drawing that cannot be cleaned is stored, so that its user sees it.  The report on its
    cleaning and its compile are refused with the reason.
    """
    from knifetip import pipeline

    # The limits of cleaning are lengths in mm.
    if not drawing.unit:
        return None
    try:
        return pipeline.clean(dieline)
    except KnifetipError:
        return None


def cleaning_report(progress: Progress, edges: bytes) -> dict[str, Any]:
    """Return a report on the edges that cleaning changes in a drawing, as JSON data.

    Parameters
    ----------
    progress
        Called with stage and completed fraction.
    edges
        Field ``edges`` of the ``Reading`` of the drawing.

    Raises
    ------
    UnitUnknown
        The drawing has no unit, so lengths in mm are unknown.
    """
    drawing, cleaned = _clean_stored(progress, edges)
    return cleaned.as_json(drawing.handles)


def blanks(progress: Progress, edges: bytes) -> dict[str, Any]:
    """Return the blanks of a drawing, as JSON data; see ``presentation.blanks``.

    Parameters
    ----------
    progress
        Called with stage and completed fraction.
    edges
        Field ``edges`` of the ``Reading`` of the drawing.

    Raises
    ------
    UnitUnknown
        The drawing has no unit, so areas in mm² are unknown.
    """
    from knifetip.layout.blanks import find_blanks
    from knifetip.presentation.blanks import blanks_as_json

    _, cleaned = _clean_stored(progress, edges)
    return blanks_as_json(find_blanks(cleaned.dieline))


def _clean_stored(progress: Progress, edges: bytes) -> tuple[Drawing, Cleaned]:
    """Return a stored drawing and its cleaned dieline; raise ``UnitUnknown`` without a unit."""
    from knifetip import pipeline

    progress(Stage.CLEAN, 0.0)
    drawing, dieline = restore_drawing(edges)
    if not drawing.unit:
        raise UnitUnknown("drawing.unit-for-cleaning")
    return drawing, pipeline.clean(dieline)


def open_questions(
    progress: Progress, stored: StoredDrawing, interpretation: Interpretation, machine: Definition
) -> list[dict[str, Any]]:
    """Return the questions that the user must answer before a job can be compiled, as JSON data.

    Parameters
    ----------
    progress
        Called with stage and completed fraction.
    stored
        The stored drawing.
    interpretation
        Interpretation with which the drawing is to be compiled.
    machine
        Definition of the machine.

    Raises
    ------
    PlanError
        Corner types are set for a machine that does not mill, or the least lift for a machine
        without one.
    """
    from knifetip import pipeline

    progress(Stage.READ, 0.0)
    target = machine_of(machine)
    pipeline.check_options(interpretation.options, target)
    drawing, dieline = restore_or_read(stored, interpretation)
    return [question.as_json() for question in pipeline.questions(drawing, dieline, target)]


def compile(
    progress: Progress,
    stored: StoredDrawing,
    interpretation: Interpretation,
    machine: Definition,
    board: Definition,
    notes: Sequence[str],
    exceptions: Exceptions | None = None,
    rest: StoredRest | None = None,
) -> CompileResult:
    """Compile a drawing for a board and a machine, verify the program, and return the result.

    Parameters
    ----------
    progress
        Called with stage and completed fraction.
    stored
        The stored drawing.
    interpretation
        Interpretation with which the drawing is compiled.
    machine, board
        Definitions of the machine and the board.
    notes
        Comment lines for the beginning of the program.
    exceptions
        Shortfalls that the order accepts; None for none.
    rest
        The work that remains on a sheet that other jobs began; None to make the whole drawing.

    Raises
    ------
    KnifetipError
        The drawing cannot be made; the message contains position and measured value.
    """
    from knifetip import pipeline

    progress(Stage.READ, 0.0)
    drawing, dieline = restore_or_read(stored, interpretation)
    if not drawing.unit:
        raise UnitUnknown("drawing.unit-unknown", evidence=drawing.evidence)
    if stored.is_layout:
        check_sheet(stored.content, dieline)
    target = machine_of(machine)
    job = (drawing, dieline, target, board_of(board))
    options = interpretation.options
    if rest is None:
        compiled = pipeline.compile(*job, options=options, notes=notes, progress=progress)
    else:
        compiled = pipeline.compile_rest(
            *job, _restore_rest(rest), options=options, notes=notes, progress=progress
        )
    if exceptions is not None:
        verdict = with_ordered_exceptions(compiled.verdict, exceptions)
        compiled = replace(compiled, verdict=verdict)
    handles = [printable(handle) for handle in drawing.handles]
    return _result(compiled, handles, target, dieline.line_type)


def _restore_rest(stored: StoredRest) -> Rest:
    """Return the work that remains on a sheet from the stored data of the jobs that began it."""
    toolpath, _ = unpack_toolpath(stored.toolpath)
    tracks = [np.arange(first, last + 1) for first, last in stored.tracks]
    earlier = [EarlierWork(*work) for work in stored.made]
    return Rest(toolpath, np.concatenate(tracks), earlier)


def _result(
    compiled: Compiled, handles: Sequence[str], target: Machine, line_type: U8
) -> CompileResult:
    """Convert the result of a compile to the form in which it is stored, and return it.

    ``handles`` (n,): handles of the n edges of the drawing.
    ``target``: the machine for which the program was made.
    ``line_type`` (n,): line types of the edges.
    """
    verdict = compiled.verdict
    findings = findings_json(verdict, handles)
    summary = {
        **verdict_summary(verdict),
        "seconds": finite(compiled.seconds),
        "seconds_retracted": finite(compiled.seconds_retracted),
    }
    text = compiled.program.text
    lengths = pack_lengths(compiled.toolpath, program_lines(compiled), line_type)
    facts = ProgramFacts(
        program_bytes=len(text), worked_length=sum(lengths_until(lengths).values())
    )
    return CompileResult(
        accepted=bool(verdict.accepted),
        message=refusal(verdict.findings),
        program=text,
        sha256=hashlib.sha256(text).hexdigest(),
        lines=len(compiled.program),
        toolpath=pack_toolpath(compiled, target),
        verdict=pack_verdict(verdict, findings, summary),
        verdict_summary=summary,
        source=refused_handles(findings),
        edges=refused_edges(findings),
        tools=used_stations(compiled, target),
        lengths=lengths,
        facts=facts.model_dump(mode="json"),
    )


def missing_kernels(_progress: Progress, groups: Sequence[str]) -> list[Part]:
    """Return the modules in which kernels lack machine code, with the number of these kernels.

    Kernels are functions that numba compiles to machine code.  The machine code is stored on disk.

    Parameters
    ----------
    groups
        Names of the groups of modules to search, from ``kernel_groups.GROUPS``.
    """
    return missing_parts(*groups)


def compile_kernels(progress: Progress, module: str, niceness: int) -> None:
    """Compile the kernels (functions that numba compiles) of a module, at low priority.

    Parameters
    ----------
    progress
        Called with the stage ``PREPARE`` and the fraction of the kernels that are compiled.
    module
        Name of the module.
    niceness
        Niceness to which this process is set (see the command ``nice``); a greater niceness that
        the process already has is kept.
    """
    os.setpriority(os.PRIO_PROCESS, 0, max(niceness, os.getpriority(os.PRIO_PROCESS, 0)))
    for fraction in compile_module(module):
        progress(Stage.PREPARE, fraction)
