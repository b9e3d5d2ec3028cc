"""proof: prove that a program makes a drawing, from the bytes of the program to the drawn edges.

The program is verified against the cleaned edges, and the cleaned edges against the drawn ones.
Only both proofs together show that the program makes the drawing.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

from knifetip.checked_cleaning import CheckedCleaning
from knifetip.cleaning.map_back import map_to_drawn
from knifetip.messages import Message
from knifetip.model.board import Board
from knifetip.model.chosen_work import ChosenWork, work_on_cleaned
from knifetip.model.dieline import Dieline
from knifetip.model.earlier_work import EarlierWork
from knifetip.model.job_options import VerifiedOptions
from knifetip.model.machine import Machine
from knifetip.model.verdict import Finding, Severity, Verdict
from knifetip.verification.checks.lines.replaced_lines import note_replaced
from knifetip.verification.checks.registration.check import check_registration
from knifetip.verification.expectation.chosen_bridges import expected_bridges
from knifetip.verification.expectation.chosen_order import expected_order
from knifetip.verification.expectation.chosen_starts import expected_starts
from knifetip.verification.verify import JobDetails, verify


@dataclass(frozen=True, eq=False, slots=True)
class PlacedJob:
    """The edges of a job at their position on the table, with machine, board and options."""

    checked: CheckedCleaning  #: the drawn and the cleaned edges
    offset: tuple[float, float]  #: of the drawing on the machine's table (mm)
    machine: Machine  #: its tools have the feeds of the job
    board: Board
    options: VerifiedOptions = field(default_factory=VerifiedOptions)
    earlier: Sequence[EarlierWork] = ()  #: work that is done on the sheet
    chosen: ChosenWork = field(default_factory=dict)  #: choices for the drawn edges
    #: the edges in the drawing's coordinates, if the drawn ones lie by measured marks
    unlaid: Dieline | None = None


def prove(
    job: PlacedJob, text: bytes, tolerance: float, planned: Sequence[Message] = ()
) -> Verdict:
    """Return the verdict on a program for the drawn edges of a job.

    The program is accepted only if it makes all cleaned edges and these match the drawn edges.
    What cleaning left out becomes notes.

    Parameters
    ----------
    job
        The edges, with machine, board and options.
    text
        The program, made by knifetip or by another system.
    tolerance : mm
        Maximum distance of the tool's tip from the drawn line.
    planned
        What planning states about the program; it becomes notes.

    Raises
    ------
    ProgramUnreadable, ProgramError, GeometryError
        See ``verification.verify.verify``.
    """
    drawn, cleaned, lost = job.checked.drawn, job.checked.cleaned, job.checked.faults
    details = JobDetails(
        job.earlier,
        expected_starts(job.options.contour_starts, drawn, cleaned, job.offset),
        work_on_cleaned(job.chosen, cleaned),
        expected_order(job.options.work_order, cleaned),
        expected_bridges(job.options.bridges, drawn, cleaned, job.offset),
        job.options.registration,
    )
    verdict = verify(
        text,
        cleaned.dieline,
        job.offset,
        job.machine,
        job.board,
        sheet=job.options.sheet,
        tolerance=tolerance,
        job=details,
    )
    mapped = map_to_drawn(verdict, cleaned, drawn)
    registered = check_registration(job.options.registration, job.unlaid, drawn, job.offset)
    notes = (*note_replaced(drawn, cleaned), *planned_notes(cleaned.notes), *planned_notes(planned))
    return replace(
        mapped,
        accepted=mapped.accepted and not lost and not any(one.refuses for one in registered),
        findings=(*lost, *registered, *mapped.findings, *notes),
    )


def planned_notes(messages: Sequence[Message]) -> tuple[Finding, ...]:
    """Return findings of severity note with the given messages."""
    return tuple(Finding("planned", each, 0.0, severity=Severity.NOTE) for each in messages)
