"""tasks: what the crew's processes do, with bytes in and bytes and plain data out.

read      DXF bytes, unit, profile -> Reading     what the page shows of a drawing
ask       … and a machine -> questions            what must be decided before it is compiled
compile   … and a board -> Result                 program, head path and verdict
cleaned   edges of a Reading -> plain data        what cleaning makes of each edge
"""

from __future__ import annotations

import hashlib
import json
import zlib
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np

from knifetip.errors import UnitUnknown
from knifetip.geometry.columns import F64, U8
from knifetip.jobs.columns import packed, unpacked
from knifetip.jobs.ledger import listed
from knifetip.jobs.report import reported, said, unit_of
from knifetip.jobs.store import Result
from knifetip.library import load, own
from knifetip.model.corners import CornerAt, Corners
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.drawing import Drawing, Fate
from knifetip.model.machine import Machine
from knifetip.model.profile import LineRules
from knifetip.model.stage import Progress, Stage
from knifetip.model.tool import kind_of

if TYPE_CHECKING:
    from knifetip.pipeline import Compiled

NONE = 255  #: no override
#: Columns of a verdict with a row to every edge.
EDGE_COLUMNS = (
    "deviation",
    "overcut",
    "uncut",
    "setback",
    "width",
    "web",
    "flank",
    "unreached",
    "bottom_uncut",
    "top_overcut",
    "tidied",
)
_FAR = 1e9  # stands for a measure that is infinite or not a number, which JSON cannot say


@dataclass(frozen=True, slots=True)
class Reading:
    """A drawing as the store keeps it."""

    summary: dict[str, Any]
    edges: bytes  #: see ``columns``
    ledger: bytes  #: JSON, deflated
    overrides: bytes  #: (n,) NONE or a LineType


@dataclass(frozen=True, slots=True)
class Carried:
    """Overrides that were given to an earlier reading of the same file."""

    overrides: bytes  #: (n,) NONE or a LineType
    handles: Sequence[str]  #: (n,)


# The same drawing is read again for each override and each order: keep the last few.
@lru_cache(maxsize=4)
def drawing_of(content: bytes, unit: str) -> Drawing:
    """Return the drawing in a file; ``unit`` as the user gave it, empty for the file's own."""
    from knifetip import pipeline

    return pipeline.read(content, unit or None)


def rules_of(profile: str, rules: str) -> LineRules:
    """Return a profile: of the library, or, where there is a text, a customer's own."""
    return own.parsed(profile, rules) if rules else load.profile(profile, files=False)


def read(
    progress: Progress,
    content: bytes,
    unit: str,
    profile: str,
    carried: Carried | None = None,
    rules: str = "",
) -> Reading:
    """Return what the page shows of a drawing.

    Parameters
    ----------
    unit
        As the user gave it; empty for what the file says.
    carried
        Overrides to keep: row by row where the reading has the same rows, and else by handle
        where all rows of the handle agreed.
    rules
        TOML of the profile, where it is a customer's own.
    """
    from knifetip import pipeline

    progress(Stage.READ, 0.0)
    drawing = drawing_of(content, unit)
    handles = [said(handle) for handle in drawing.handles]
    overrides = np.full(len(drawing), NONE, np.uint8)
    if carried is not None:
        overrides = _carry(carried, handles)
    progress(Stage.CLASSIFY, 0.6)
    dieline = pipeline.classify(drawing, rules_of(profile, rules), overrides)
    questions = pipeline.questions(drawing, dieline)
    report = reported(drawing, dieline)
    progress(Stage.STORE, 0.9)
    layers = [said(layer) for layer in drawing.layers]
    edges = packed(
        {
            "ends": dieline.ends,
            "bulge": dieline.bulge,
            "line_type": dieline.line_type,
            "layer": drawing.layer,
            "colour": drawing.colour,
            "linetype": drawing.linetype,
            "rule": dieline.rule,
            "confidence": dieline.confidence,
            "length": drawing.lengths,
            "fate": report.fate,
            "reason": report.reason,
        },
        {
            "handles": handles,
            "layers": layers,
            "linetypes": [said(name) for name in drawing.linetypes],
            "rules": [said(rule) for rule in dieline.rules],
            "alternatives": [[kind.word for kind in one] for one in dieline.alternatives],
            "fates": [fate.name.lower() for fate in Fate],
            "reasons": [said(reason) for reason in report.reasons],
            "types": [kind.word for kind in LineType],
            "unit": drawing.unit,
        },
    )
    ledger = drawing.ledger
    rows = listed(drawing)
    low_x, low_y, high_x, high_y = (float(side) for side in drawing.bounds)
    summary = {
        "unit": drawing.unit,
        "evidence": said(drawing.evidence),
        "unit_finding": unit_of(drawing),
        "segments": len(drawing),
        "bounds": [low_x, low_y, high_x, high_y],
        "width": high_x - low_x,
        "height": high_y - low_y,
        "counts": _counts(dieline.line_type, drawing.lengths),
        "layers": _layers(drawing, dieline, layers),
        "questions": [question.as_json() for question in questions],
        "overrides": int((overrides != NONE).sum()),
        "ledger": {fate.name.lower(): int((ledger.fate == fate).sum()) for fate in Fate},
        "report": report.summary,
    }
    return Reading(summary, edges, zlib.compress(json.dumps(rows).encode(), 6), overrides.tobytes())


def _carry(carried: Carried, handles: Sequence[str]) -> U8:
    before = np.frombuffer(carried.overrides, np.uint8)
    if list(carried.handles) == list(handles):
        return before
    said: dict[str, set[int]] = {}
    for handle, override in zip(carried.handles, before.tolist(), strict=True):
        said.setdefault(handle, set()).add(override)
    agreed = {handle: values.pop() for handle, values in said.items() if len(values) == 1}
    return np.array([agreed.get(handle, NONE) for handle in handles], np.uint8)


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
    """Return what cleaning makes of a drawing's edges, as its Reading holds them.

    Raises
    ------
    UnitUnknown
        Specks and gaps are measured in millimetres, and nobody has said what the numbers are.
    """
    from knifetip import pipeline

    progress(Stage.CLEAN, 0.0)
    columns, meta = unpacked(edges)
    if not meta["unit"]:
        raise UnitUnknown(
            "The drawing does not say its unit, so nobody knows how long a speck is.",
            "Set it with PATCH /api/drawings/{id}, or on the page.",
        )
    count = len(columns["bulge"])
    line = Dieline(
        columns["ends"],
        columns["bulge"],
        columns["line_type"],
        np.arange(count, dtype=np.int32),
        columns["rule"],
        columns["confidence"],
        tuple(meta["rules"]),
    )
    return pipeline.clean(line).as_json(meta["handles"])


def ask(
    progress: Progress,
    content: bytes,
    unit: str,
    profile: str,
    overrides: bytes,
    machine: str,
    corners: dict[str, Any] | None = None,
    rules: str = "",
) -> list[dict[str, Any]]:
    """Return what must be decided before the drawing can be made on this machine.

    Raises
    ------
    PlanError
        Types of corners were chosen for a machine that does not mill.
    """
    from knifetip import pipeline
    from knifetip.planning.plan import check_corners

    progress(Stage.READ, 0.0)
    if corners is not None:
        check_corners(corners_of(corners), load.machine(machine))
    drawing = drawing_of(content, unit)
    dieline = pipeline.classify(
        drawing, rules_of(profile, rules), np.frombuffer(overrides, np.uint8)
    )
    questions = pipeline.questions(drawing, dieline, load.machine(machine))
    return [question.as_json() for question in questions]


def compile(
    progress: Progress,
    content: bytes,
    unit: str,
    profile: str,
    overrides: bytes,
    machine: str,
    board: str,
    notes: Sequence[str],
    corners: dict[str, Any] | None = None,
    rules: str = "",
) -> Result:
    """Return the program of a drawing on a board and a machine, with its verdict.

    Parameters
    ----------
    corners
        How a cutter goes round corners, as the store keeps it; None leaves it to the machine.

    Raises
    ------
    KnifetipError
        It cannot be made; the reason names the place and the measure.
    """
    from knifetip import pipeline

    progress(Stage.READ, 0.0)
    drawing = drawing_of(content, unit)
    if not drawing.unit:
        raise UnitUnknown(
            f"The drawing does not say its unit ({drawing.evidence}).",
            "Set it with PATCH /api/drawings/{id}, or on the page.",
        )
    dieline = pipeline.classify(
        drawing, rules_of(profile, rules), np.frombuffer(overrides, np.uint8)
    )
    table = load.machine(machine)
    made = pipeline.compile(
        drawing,
        dieline,
        table,
        load.board(board),
        corners=None if corners is None else corners_of(corners),
        notes=notes,
        progress=progress,
    )
    verdict = made.verdict
    handles = [said(handle) for handle in drawing.handles]
    findings = [
        {
            "kind": finding.kind,
            "text": said(finding.text),
            "measure": _finite(finding.measure),
            "edge": finding.edge,
            "handle": handles[finding.edge] if 0 <= finding.edge < len(handles) else "",
            "line": finding.line,
        }
        for finding in verdict.findings
    ]
    judged = {
        "accepted": bool(verdict.accepted),
        "tolerance": verdict.tolerance,
        "deviation": _greatest(verdict.deviation),
        "overcut": _greatest(verdict.overcut),
        "uncut": _greatest(verdict.uncut),
        "unreached": float(verdict.areas.area.sum()),
        "unreached_places": len(verdict.areas),
        "seconds": _finite(made.seconds),
        "seconds_retracted": _finite(made.seconds_retracted),
    }
    text = made.program.text
    reason = ""
    if not verdict.accepted:
        told = " ".join(str(finding["text"]) for finding in findings[:3])
        more = f" And {len(findings) - 3} more." if len(findings) > 3 else ""
        reason = f"The program does not cut what was drawn: {told}{more}"
    return Result(
        accepted=bool(verdict.accepted),
        reason=reason,
        program=text,
        sha256=hashlib.sha256(text).hexdigest(),
        lines=len(made.program),
        toolpath=_toolpath(made, table),
        verdict=packed(
            {
                **{name: _clipped(getattr(verdict, name)) for name in EDGE_COLUMNS},
                "sample_edge": verdict.samples.edge,
                "sample_place": verdict.samples.place,
                "sample_deviation": _clipped(verdict.samples.deviation),
                "area_ends": verdict.areas.ends,
                "area_bulge": verdict.areas.bulge,
                "area_first": verdict.areas.first,
                "area_size": verdict.areas.area,
            },
            {"findings": findings, **judged},
        ),
        judged=judged,
        source=sorted({str(finding["handle"]) for finding in findings if finding["handle"]})[:200],
        tools=_tools(made, table),
    )


def corners_of(plain: dict[str, Any]) -> Corners:
    """Return the choices for corners that an order holds as plain data."""
    return Corners(
        plain["type"],
        plain["k"],
        plain["interference"],
        tuple(CornerAt(one["x"], one["y"], one["type"], one["k"]) for one in plain["at"]),
    )


def rehearse(_progress: Progress) -> None:
    """Go once through everything: kernels become machine code, which is kept on disk."""
    from knifetip.warming import warm

    warm()


def _tools(made: Compiled, machine: Machine) -> list[dict[str, Any]]:
    """Return the stations that a tool path uses, in the order of their numbers."""
    used = set(np.unique(made.toolpath.tool).tolist())
    return [
        {"station": station.number, "name": station.name, "kind": kind_of(station.tool).name}
        for station in sorted(machine.stations, key=lambda one: one.number)
        if station.number in used
    ]


def _toolpath(made: Compiled, machine: Machine) -> bytes:
    path = made.toolpath
    rows = made.program.source
    # The last line that a row became: when the machine has executed it, the row is behind it.
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


def _finite(measure: float) -> float:
    return float(np.nan_to_num(measure, nan=_FAR, posinf=_FAR, neginf=-_FAR))


def _clipped(measures: F64) -> F64:
    clipped: F64 = np.nan_to_num(measures, nan=_FAR, posinf=_FAR, neginf=-_FAR)
    return clipped


def _greatest(measures: F64) -> float:
    return _finite(float(measures.max())) if len(measures) else 0.0
