"""Routes for printed sheets: marks are measured at the machine, and the job is compiled anew."""

from __future__ import annotations

import numpy as np

from knifetip.errors import NotFound, PlanError, RequestError, WrongState
from knifetip.geometry.similarity import Similarity
from knifetip.messages import Message
from knifetip.model.job_options import JobOptions
from knifetip.model.registration import Registration
from knifetip.planning.registration import MarkFit, checked_fit, fit_marks
from knifetip.presentation.columns import unpack_columns
from knifetip.service.components import Service, ServiceDep
from knifetip.service.database.tables import Job
from knifetip.service.http.parameters import CommandKey, JobId
from knifetip.service.http.routing import ScopedRouter, requires
from knifetip.service.http.scopes import AccessScope
from knifetip.service.orders.job_answers import job_out
from knifetip.service.orders.models import JobOut
from knifetip.service.orders.registration_models import MeasuredMarksIn, RegistrationOut

router = ScopedRouter(prefix="/jobs", tags=["jobs"])

#: Decimals of a measured position (mm), as many as programs have.
_DECIMALS = 4


@router.get("/{id}/registration")
@requires(AccessScope.VIEWER)
def get_registration(service: ServiceDep, id: JobId) -> RegistrationOut:
    """Get the marks of the printed sheet of a job, and how the sheet lies by the measured ones."""
    row = service.store.jobs.get(id)
    return _registration_out(service, row, _registration_of(row.options, id))


@router.post("/{id}/registration/fit")
@requires(AccessScope.STATION)
def fit_registration(service: ServiceDep, id: JobId, marks: MeasuredMarksIn) -> RegistrationOut:
    """Fit measured marks without changing the job: shift, turn, scale and error of each mark.

    Errors that are too large are in the answer, with its `refusal`.
    """
    row = service.store.jobs.get(id)
    options = _measured_options(service, row, marks)
    return _registration_out(service, row, _registration_of(options, id))


@router.post("/{id}/registration")
@requires(AccessScope.STATION)
def register_job(service: ServiceDep, id: JobId, marks: MeasuredMarksIn, key: CommandKey) -> JobOut:
    """Compile a job again for its printed sheet as it lies on the table, by its measured marks.

    The drawing is shifted, turned and, if the order does not say otherwise, scaled; the new program
    is verified like every other one. The job then returns to its machine before those that wait,
    and the operator confirms that the sheet was not moved. The status is 409 if the job does not
    wait at its machine for the operator, and 422 if the marks do not fit.
    """
    row = service.store.jobs.get(id)
    options = _measured_options(service, row, marks)
    fit = checked_fit(_registration_of(options, id))
    return job_out(
        service.store,
        service.store.programs.register(id, options, _event(fit), marks.by, key),
    )


def _event(fit: MarkFit | None) -> Message:
    """Return the event about measured marks; None for a measurement that is forgotten."""
    if fit is None:
        return Message("registration.forgotten")
    return Message(
        "registration.measured",
        count=len(fit.errors),
        turn=fit.similarity.turn,
        scale=fit.similarity.scale,
        error=fit.largest,
    )


def _registration_of(options: JobOptions, id: str) -> Registration:
    """Return the registration of a job; raise ``WrongState`` if its sheet has no marks."""
    if options.registration is None:
        raise WrongState("registration.no-marks", job=id)
    return options.registration


def _measured_options(service: Service, row: Job, marks: MeasuredMarksIn) -> JobOptions:
    """Return the options of a job with measured marks.

    Raises
    ------
    WrongState
        The sheet of the job has no marks.
    RequestError
        The number of positions is not that of the marks.
    NotFound
        The machine has no such station.
    """
    registration = _registration_of(row.options, row.id)
    given = len(marks.positions)
    if given not in (0, len(registration.marks)):
        count = len(registration.marks)
        raise RequestError(
            "registration.count", source=["positions"], given=given, job=row.id, count=count
        )
    x, y = marks.offset
    machine = service.store.library.machine(row.machine)
    if marks.station is not None:
        found = [one for one in machine.stations if one.number == marks.station]
        if not found:
            raise NotFound("registration.no-station", machine=machine.title, station=marks.station)
        x, y = x + found[0].x, y + found[0].y
    # Marks are fitted on the sheet: axes that are not square would look like an error of the print.
    places = [machine.to_sheet(u - x, v - y) for u, v in marks.positions]
    return row.options.with_measured(
        [(round(u, _DECIMALS), round(v, _DECIMALS)) for u, v in places]
    )


def _registration_out(service: Service, row: Job, registration: Registration) -> RegistrationOut:
    """Return marks with their fit for clients."""
    refusal, fit = None, None
    try:
        fit = fit_marks(registration)
        checked_fit(registration)
    except PlanError as error:
        refusal = error.message
    marks = np.array(registration.marks)
    places = _expected(service, row).apply(marks)
    similarity = None if fit is None else fit.similarity
    return RegistrationOut.model_validate(
        {
            "marks": [
                {
                    "x": mark[0],
                    "y": mark[1],
                    "expected": places[number].tolist(),
                    "measured": registration.measured[number] if registration.measured else None,
                    "error": None if fit is None else fit.errors[number].tolist(),
                }
                for number, mark in enumerate(registration.marks)
            ],
            "shift": None if similarity is None else (similarity.x, similarity.y),
            "turn": None if similarity is None else similarity.turn,
            "scale": None if similarity is None else similarity.scale,
            "largest_error": None if fit is None else fit.largest,
            "limit": registration.limit,
            "refusal": refusal,
        }
    )


def _expected(service: Service, row: Job) -> Similarity:
    """Return the map from the drawing to the table in the program of a job.

    Without a program, the origin of the drawing is at that of the table.
    """
    if row.toolpath_address is None:
        return Similarity(1.0, 0.0, 0.0, 0.0)
    meta = unpack_columns(service.store.jobs.column(row.id, "toolpath"))[1]
    if (similarity := meta.get("similarity")) is not None:
        return Similarity(*similarity)
    x, y = meta["placement"]
    return Similarity(1.0, 0.0, x, y)
