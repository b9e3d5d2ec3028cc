"""Change a refused job in the way that the hint of the refusal recommends."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING, Final

import numpy as np

from knifetip.library import load
from knifetip.model.dieline import LineType
from knifetip.model.tool import Knife
from knifetip.topology.noding import split_at_crossings

if TYPE_CHECKING:
    from tests.cartons.trial import Attempt, Refusal


#: What is done where planner and verifier disagree: a failure, although a job comes of it.
LEFT_OUT: Final = "left out"


def follow(refusal: Refusal, attempt: Attempt) -> tuple[str, Attempt] | None:
    """Follow the hint of a refusal: return a description of the change, and the changed job.

    Returns None if the change cannot be made automatically.
    """
    action = _ACTIONS.get(refusal.code)
    changed = None if action is None else action(refusal, attempt)
    if changed is None and refusal.code.startswith("verify."):
        # The hint of every refused program: leave the edge out and make it by hand.
        changed = _left_out(refusal, attempt)
    return changed


def _left_out(refusal: Refusal, attempt: Attempt) -> tuple[str, Attempt] | None:
    """Leave out the edges with faults, which the tools should be able to make."""
    changed = _ignored(refusal, attempt)
    return None if changed is None else (LEFT_OUT, changed[1])


def _other_tool(refusal: Refusal, attempt: Attempt) -> tuple[str, Attempt]:
    """Give edges that the machine cannot make the line type that comes next."""
    kinds = {LineType.V_GROOVE: LineType.CREASE, LineType.PERFORATION: LineType.CUT}
    rows = list(refusal.edges)
    kind = LineType(int(attempt.line_type[rows[0]]))
    chosen = kinds.get(kind, LineType.IGNORED)
    return f"{kind.word} becomes {chosen.word}", _typed(attempt, rows, chosen)


def _perforation(refusal: Refusal, attempt: Attempt) -> tuple[str, Attempt]:
    """Make folds as perforations with the knife."""
    return "perforation", _typed(attempt, list(refusal.edges), LineType.PERFORATION)


def _typed(attempt: Attempt, rows: list[int], kind: LineType) -> Attempt:
    line_type = attempt.line_type.copy()
    line_type[rows] = kind
    return replace(attempt, line_type=line_type)


def _ignored(refusal: Refusal, attempt: Attempt) -> tuple[str, Attempt] | None:
    """Set the line type of the edges to ignored."""
    rows = [row for row in refusal.edges if row >= 0]
    return ("ignored", _typed(attempt, rows, LineType.IGNORED)) if rows else None


def _as_crease(refusal: Refusal, attempt: Attempt) -> tuple[str, Attempt] | None:
    rows = [row for row in refusal.edges if row >= 0]
    return ("crease instead", _typed(attempt, rows, LineType.CREASE)) if rows else None


def _knife(refusal: Refusal, attempt: Attempt) -> tuple[str, Attempt] | None:
    """Choose a machine with a knife."""
    if attempt.machine.name == "demo-table":
        return None
    machine = load.machine("demo-table")
    options = attempt.options.model_copy(update={"corners": None})
    return "knife", replace(attempt, machine=machine, dialect=machine.dialect, options=options)


def _thinner_cutter(refusal: Refusal, attempt: Attempt) -> tuple[str, Attempt] | None:
    """Choose a machine with a thinner cutter."""
    if attempt.machine.name != "router-table":
        return None
    machine = load.machine("laser-table")
    return "laser", replace(attempt, machine=machine, dialect=machine.dialect)


def _shallower(refusal: Refusal, attempt: Attempt) -> tuple[str, Attempt] | None:
    """Choose a board with a shallower groove."""
    boards = ("greyboard-2.0", "greyboard-1.5", "e-flute", "fbb-0.4")
    for name in boards:
        board = load.board(name)
        if board.groove_depth < attempt.board.groove_depth:
            return f"board {name}", replace(attempt, board=board)
    return None


def _larger_machine(refusal: Refusal, attempt: Attempt) -> tuple[str, Attempt] | None:
    """Choose a larger machine."""
    is_small = attempt.machine.width < load.machine("demo-table").width
    return _knife(refusal, attempt) if is_small else None


def _turned(refusal: Refusal, attempt: Attempt) -> tuple[str, Attempt]:
    """Turn the drawing by 90°."""
    x, y = attempt.drawing.ends[..., 0], attempt.drawing.ends[..., 1]
    turned = replace(attempt.drawing, ends=np.stack([-y, x], axis=-1))
    return "turned", replace(attempt, drawing=turned)


def _divided(refusal: Refusal, attempt: Attempt) -> tuple[str, Attempt] | None:
    """Divide the cuts of the drawing at their crossings."""
    drawing, cut = attempt.drawing, attempt.line_type == LineType.CUT
    ends, bulge, row = split_at_crossings(drawing.ends[cut], drawing.bulge[cut])
    if len(row) == int(cut.sum()):
        return None
    source = np.concatenate([np.flatnonzero(~cut), np.flatnonzero(cut)[row]])
    columns = {
        name: getattr(drawing, name)[source]
        for name in (
            *("entity", "layer", "colour", "true_colour", "linetype"),
            *("line_width", "fit_error"),
        )
    }
    divided = replace(
        drawing,
        ends=np.concatenate([drawing.ends[~cut], ends]),
        bulge=np.concatenate([drawing.bulge[~cut], bulge]),
        **columns,
    )
    return "divided", replace(attempt, drawing=divided, line_type=attempt.line_type[source])


def _divided_or_knife(refusal: Refusal, attempt: Attempt) -> tuple[str, Attempt] | None:
    """Divide the cuts, or choose a knife where a cutter makes them."""
    changed = _divided(refusal, attempt)
    if changed is None and not any(
        isinstance(station.tool, Knife) for station in attempt.machine.stations
    ):
        changed = _knife(refusal, attempt)
    return changed


def _whole_sheet(refusal: Refusal, attempt: Attempt) -> tuple[str, Attempt] | None:
    """State no sheet."""
    if attempt.options.sheet is None:
        return None
    return "no sheet", replace(attempt, options=attempt.options.model_copy(update={"sheet": None}))


_ACTIONS: Final[dict[str, Callable[[Refusal, Attempt], tuple[str, Attempt] | None]]] = {
    "question.tool": _other_tool,
    "question.tool-for-folds": _perforation,
    "cut.too-short": _ignored,
    "cutter.does-not-fit": _thinner_cutter,
    "groove.along-edge": _as_crease,
    "groove.curved": _as_crease,
    "groove.runs-out": _as_crease,
    "groove.through-cut": _shallower,
    "groove.too-short": _ignored,
    "hpgl.press": _knife,
    "milling.contours-cross": _knife,
    "milling.drawn-twice": _ignored,
    "milling.shared-edge": _knife,
    "drawing.fits-turned": _turned,
    "drawing.larger-than-table": _larger_machine,
    "sheet.without-outline": _whole_sheet,
    "verify.cuts-part": _thinner_cutter,
    "verify.inside-part": _thinner_cutter,
    "verify.loose-piece": _divided_or_knife,
}
