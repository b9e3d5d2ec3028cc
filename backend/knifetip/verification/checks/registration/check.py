"""check: compare edges on the table with the drawing, laid by the measured marks of the sheet.

The program is verified against edges that the planner has laid on the table.  This check computes
from the marks where each edge belongs, and so finds a wrong turn, a map that was applied twice and
a wrong scale.
"""

from __future__ import annotations

import cmath
import math
from typing import Final

import numpy as np

from knifetip.messages import Message
from knifetip.model.dieline import Dieline
from knifetip.model.registration import SCALES, Registration
from knifetip.model.verdict import Finding, Severity
from knifetip.verification.expectation.measured_marks import MarkMap, as_complex, map_marks

#: Greatest distance of an end of an edge from where it belongs (mm).
_TOLERANCE: Final = 1e-5
#: Greatest difference of two bulges.
_BULGE: Final = 1e-12
_CHECK: Final = "registration"


def check_registration(
    registration: Registration | None,
    drawn: Dieline | None,
    laid: Dieline,
    placement: tuple[float, float],
) -> tuple[Finding, ...]:
    """Return faults of the position of a drawing on a printed sheet, and a note about it.

    Parameters
    ----------
    registration
        The marks; None if the sheet has none.
    drawn
        The edges in the drawing's coordinates; None if they were not laid by marks.
    laid
        The same edges as they lie on the table.
    placement : (x, y), mm
        Further shift to the position on the table, which must be 0 for measured marks.
    """
    if registration is None:
        return ()
    found = map_marks(registration)
    if found is None:
        message = Message("registration.not-measured", count=len(registration.marks))
        return (Finding(_CHECK, message, 0.0, severity=Severity.NOTE),)
    faults = [*_bad_fit(registration, found), *_displaced(found, drawn or laid, laid, placement)]
    return (*faults, Finding(_CHECK, _note(found), 0.0, severity=Severity.NOTE))


def _bad_fit(registration: Registration, found: MarkMap) -> list[Finding]:
    """Return faults of the fit of the marks."""
    findings, scale = [], abs(found.factor)
    worst = int(np.argmax(found.errors))
    distance = float(found.errors[worst])
    if not SCALES[0] <= scale <= SCALES[1]:
        message = Message("registration.scale", scale=scale, least=SCALES[0], most=SCALES[1])
        findings.append(Finding(_CHECK, message, abs(scale - 1.0)))
    if not distance <= registration.limit:
        x, y = registration.measured[worst]
        message = Message(
            "registration.error",
            mark=worst + 1,
            x=x,
            y=y,
            distance=distance,
            limit=registration.limit,
        )
        findings.append(Finding(_CHECK, message, distance))
    return findings


def _displaced(
    found: MarkMap, drawn: Dieline, laid: Dieline, placement: tuple[float, float]
) -> list[Finding]:
    """Return a fault for the edge that is farthest from where it belongs, if it is too far."""
    if len(drawn) != len(laid):
        return [Finding(_CHECK, Message("registration.other-edges"), 0.0)]
    apart = np.abs(as_complex(laid.ends + placement) - found.place(as_complex(drawn.ends)))
    distance = apart.max(axis=1, initial=0.0)
    distance[np.abs(laid.bulge - drawn.bulge) > _BULGE] = math.inf
    row = int(np.argmax(distance)) if len(distance) else 0
    if len(distance) == 0 or distance[row] <= _TOLERANCE:
        return []
    message = Message("registration.edge-elsewhere", edge=row, distance=float(distance[row]))
    return [Finding(_CHECK, message, float(distance[row]), edge=row)]


def _note(found: MarkMap) -> Message:
    return Message(
        "registration.laid",
        x=found.shift.real,
        y=found.shift.imag,
        turn=math.degrees(cmath.phase(found.factor)),
        scale=abs(found.factor),
        error=float(found.errors.max()),
        count=len(found.errors),
    )
