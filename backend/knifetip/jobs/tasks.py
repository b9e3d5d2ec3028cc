"""Tasks of the worker processes; arguments and results are bytes and JSON data.

read      bytes, Interpretation -> Reading                     data for the page
ask       StoredDrawing, Interpretation, machine -> questions  open questions before a compile
compile   … and a board -> CompileResult                       program, head path and verdict
cleaned   edges of a Reading -> JSON data                      cleaning report
"""

from __future__ import annotations

import hashlib
import json
import os
import zlib
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from knifetip.errors import UnitUnknown
from knifetip.geometry.columns import F64, U8
from knifetip.jobs.columns import packed
from knifetip.jobs.compile_result import CompileResult
from knifetip.jobs.import_report import listed
from knifetip.jobs.readings import (
    StoredDrawing,
    edge_block,
    interpreted,
    read_drawing,
    unpacked_reading,
)
from knifetip.jobs.report import reported, said, unit_of
from knifetip.library import load
from knifetip.messages import Message
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.drawing import Drawing, ImportOutcome
from knifetip.model.interpretation import NO_OVERRIDE, Interpretation
from knifetip.model.machine import Machine
from knifetip.model.stage import Progress, Stage
from knifetip.model.tool import kind_of
from knifetip.presentation.verdict import (
    EDGE_COLUMNS,
    findings_of,
    finite,
    finite_column,
    verdict_summary,
)
from knifetip.warming import Part, compile_module, missing_parts

if TYPE_CHECKING:
    from knifetip.pipeline import Compiled

#: Greatest number of findings in the reason of a refused job.
_SHOWN: Final = 3


@dataclass(frozen=True, slots=True)
class Reading:
    """A drawing as it is stored."""

    summary: dict[str, Any]
    edges: bytes  #: see ``columns``
    import_report: bytes  #: JSON, deflated
    overrides: bytes  #: (n,) ``NO_OVERRIDE`` or a LineType


def read(
    progress: Progress,
    content: bytes,
    interpretation: Interpretation,
    handles: Sequence[str] | None = None,
) -> Reading:
    """Read and classify a drawing for the store and the page.

    Parameters
    ----------
    interpretation
        Its overrides belong to an earlier reading of the same file, if there is one.
    handles : (n,)
        Handles of the edges of that earlier reading.  Overrides are carried over by row if the
        handles are the same, else by handle if all edges of the handle have the same override.
    """
    from knifetip import pipeline

    progress(Stage.READ, 0.0)
    drawing = read_drawing(content, interpretation.unit)
    overrides = np.full(len(drawing), NO_OVERRIDE, np.uint8)
    if handles is not None:
        before = np.frombuffer(interpretation.overrides, np.uint8)
        overrides = _carried(before, handles, [said(handle) for handle in drawing.handles])
    progress(Stage.CLASSIFY, 0.6)
    dieline = pipeline.interpret(drawing, replace(interpretation, overrides=overrides.tobytes()))
    report = reported(drawing, dieline)
    progress(Stage.STORE, 0.9)
    edges = edge_block(drawing, dieline, report)
    rows = listed(drawing)
    summary = _summary(drawing, dieline, overrides, report.summary)
    return Reading(summary, edges, zlib.compress(json.dumps(rows).encode(), 6), overrides.tobytes())


def _summary(
    drawing: Drawing, dieline: Dieline, overrides: U8, report: dict[str, Any]
) -> dict[str, Any]:
    """Return the data of a drawing that the page shows apart from its edges."""
    from knifetip import pipeline

    import_report = drawing.import_report
    low_x, low_y, high_x, high_y = (float(side) for side in drawing.bounds)
    return {
        "unit": drawing.unit,
        "evidence": said(str(drawing.evidence)),
        "evidence_message": drawing.evidence.as_json(),
        "unit_finding": unit_of(drawing),
        "segments": len(drawing),
        "bounds": [low_x, low_y, high_x, high_y],
        "width": high_x - low_x,
        "height": high_y - low_y,
        "counts": _counts(dieline.line_type, drawing.lengths),
        "layers": _layers(drawing, dieline, [said(layer) for layer in drawing.layers]),
        "questions": [question.as_json() for question in pipeline.questions(drawing, dieline)],
        "overrides": int((overrides != NO_OVERRIDE).sum()),
        "import_report": {
            outcome.name.lower(): int((import_report.outcome == outcome).sum())
            for outcome in ImportOutcome
        },
        "report": report,
    }


def _carried(before: U8, handles: Sequence[str], now: Sequence[str]) -> U8:
    """Return the overrides of an earlier reading for the edges of the present one."""
    if list(handles) == list(now):
        return before
    given: dict[str, set[int]] = {}
    for handle, override in zip(handles, before.tolist(), strict=True):
        given.setdefault(handle, set()).add(override)
    agreed = {handle: values.pop() for handle, values in given.items() if len(values) == 1}
    return np.array([agreed.get(handle, NO_OVERRIDE) for handle in now], np.uint8)


def _counts(line_type: U8, lengths: F64) -> list[dict[str, Any]]:
    edges = np.bincount(line_type, minlength=len(LineType))
    length = np.bincount(line_type, weights=lengths, minlength=len(LineType))
    return [
        {"type": kind.word, "edges": int(edges[kind]), "length": float(length[kind])}
        for kind in LineType
        if edges[kind]
    ]


def _layers(drawing: Drawing, dieline: Dieline, layers: Sequence[str]) -> list[dict[str, Any]]:
    pairs, pair = np.unique(
        np.stack([drawing.layer, drawing.colour], axis=1), axis=0, return_inverse=True
    )
    pair = pair.reshape(-1)
    edges = np.bincount(pair, minlength=len(pairs))
    length = np.bincount(pair, weights=drawing.lengths, minlength=len(pairs))
    kinds = np.zeros((len(pairs), len(LineType)), bool)
    kinds[pair, dieline.line_type] = True
    return [
        {
            "name": layers[layer],
            "colour": int(colour),
            "edges": int(edges[row]),
            "length": float(length[row]),
            "types": [kind.word for kind in LineType if kinds[row, kind]],
        }
        for row, (layer, colour) in enumerate(pairs)
    ]


def cleaned(progress: Progress, edges: bytes) -> dict[str, Any]:
    """Return the cleaning report for the edges of a Reading.

    Raises
    ------
    UnitUnknown
        The drawing has no unit, so lengths in mm are unknown.
    """
    from knifetip import pipeline

    progress(Stage.CLEAN, 0.0)
    drawing, dieline = unpacked_reading(edges)
    if not drawing.unit:
        raise UnitUnknown("drawing.unit-for-cleaning")
    return pipeline.clean(dieline).as_json(drawing.handles)


def ask(
    progress: Progress, stored: StoredDrawing, wanted: Interpretation, machine: str
) -> list[dict[str, Any]]:
    """Return the open questions about a drawing for a machine.

    Raises
    ------
    PlanError
        Corner types are set for a machine that does not mill.
    """
    from knifetip import pipeline
    from knifetip.planning.plan import check_corners

    progress(Stage.READ, 0.0)
    table = load.machine(machine)
    if wanted.corners is not None:
        check_corners(wanted.corners, table)
    drawing, dieline = interpreted(stored, wanted)
    return [question.as_json() for question in pipeline.questions(drawing, dieline, table)]


def compile(
    progress: Progress,
    stored: StoredDrawing,
    wanted: Interpretation,
    machine: str,
    board: str,
    notes: Sequence[str],
) -> CompileResult:
    """Compile a drawing for a board and a machine, and verify the program.

    Raises
    ------
    KnifetipError
        The drawing cannot be made; the message contains place and measure.
    """
    from knifetip import pipeline

    progress(Stage.READ, 0.0)
    drawing, dieline = interpreted(stored, wanted)
    if not drawing.unit:
        raise UnitUnknown("drawing.unit-unknown", evidence=drawing.evidence)
    table = load.machine(machine)
    made = pipeline.compile(
        drawing,
        dieline,
        table,
        load.board(board),
        corners=wanted.corners,
        notes=notes,
        progress=progress,
    )
    return _result(made, [said(handle) for handle in drawing.handles], table)


def _result(made: Compiled, handles: Sequence[str], table: Machine) -> CompileResult:
    """Return the result of a compile as it is stored.

    Parameters
    ----------
    handles : (n,)
        Handles of the drawing's edges.
    """
    verdict = made.verdict
    findings = findings_of(verdict, handles)
    summary = {
        **verdict_summary(verdict),
        "seconds": finite(made.seconds),
        "seconds_retracted": finite(made.seconds_retracted),
    }
    text = made.program.text
    message = None
    if not verdict.accepted:
        shown, more = verdict.findings[:_SHOWN], len(findings) - _SHOWN
        message = Message(
            "job.program-refused",
            findings=[finding.located for finding in shown],
            more=Message("finding.more", count=more) if more > 0 else None,
        )
    return CompileResult(
        accepted=bool(verdict.accepted),
        message=message,
        program=text,
        sha256=hashlib.sha256(text).hexdigest(),
        lines=len(made.program),
        toolpath=_toolpath(made, table),
        verdict=packed(
            {
                **{name: finite_column(getattr(verdict, name)) for name in EDGE_COLUMNS},
                "sample_edge": verdict.samples.edge,
                "sample_place": verdict.samples.place,
                "sample_deviation": finite_column(verdict.samples.deviation),
                "area_ends": verdict.areas.ends,
                "area_bulge": verdict.areas.bulge,
                "area_first": verdict.areas.first,
                "area_size": verdict.areas.area,
            },
            {"findings": findings, **summary},
        ),
        verdict_summary=summary,
        source=sorted({str(finding["handle"]) for finding in findings if finding["handle"]})[:200],
        tools=_tools(made, table),
    )


def missing_kernels(_progress: Progress, groups: Sequence[str]) -> list[Part]:
    """Return the kernels of some groups that must be compiled, module by module."""
    return missing_parts(*groups)


def compile_kernels(progress: Progress, module: str, niceness: int) -> None:
    """Compile the kernels of a module, in a process that yields the processor to others."""
    os.setpriority(os.PRIO_PROCESS, 0, max(niceness, os.getpriority(os.PRIO_PROCESS, 0)))
    for share in compile_module(module):
        progress(Stage.PREPARE, share)


def _tools(made: Compiled, machine: Machine) -> list[dict[str, Any]]:
    """Return the stations that a tool path uses, ordered by number."""
    used = set(np.unique(made.toolpath.tool).tolist())
    return [
        {"station": station.number, "name": station.name, "kind": kind_of(station.tool).name}
        for station in sorted(machine.stations, key=lambda one: one.number)
        if station.number in used
    ]


def _toolpath(made: Compiled, machine: Machine) -> bytes:
    path = made.toolpath
    rows = made.program.source
    # Last program line of each row: when it is executed, the row is complete.
    line = np.full(len(path), -1, np.int32)
    numbers = np.arange(1, len(rows) + 1, dtype=np.int32)
    moving = rows >= 0
    np.maximum.at(line, rows[moving], numbers[moving])
    return packed(
        {
            "pose": path.pose,
            "bulge": path.bulge,
            "motion": path.motion,
            "feed": path.feed,
            "source": path.source,
            "tool": path.tool,
            "line": line,
        },
        {
            "placement": [float(shift) for shift in made.placement],
            "dialect": made.program.dialect,
            "stations": [
                {
                    "number": station.number,
                    "name": station.name,
                    "kind": kind_of(station.tool).name,
                    "datum": {"x": station.x, "y": station.y, "z": station.z, "c": station.c},
                }
                for station in machine.stations
            ],
        },
    )
