"""registration: lay a drawing on a printed sheet by its measured marks.

The edges are shifted, turned and scaled before anything is planned.  So tools keep their true
sizes, and travel, zones and the table are checked for the sheet as it lies.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TypeVar

import numpy as np

from knifetip.errors import PlanError, TravelExceeded
from knifetip.geometry.columns import F64
from knifetip.geometry.similarity import Similarity, is_mirrored
from knifetip.messages import Message
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.drawing import Drawing, extents
from knifetip.model.job_options import VerifiedOptions
from knifetip.model.machine import Machine
from knifetip.model.registration import LEAST_DISTANCE, SCALES, Registration

_Edges = TypeVar("_Edges", Drawing, Dieline)
_Options = TypeVar("_Options", bound=VerifiedOptions)


@dataclass(frozen=True, eq=False, slots=True)
class MarkFit:
    """The map from the drawing to the table, and how well it fits the n measured marks."""

    similarity: Similarity
    errors: F64  #: (n, 2) from the mark of the drawing, laid on the table, to the measured one (mm)

    @property
    def distances(self) -> F64:
        """Error of each mark, (n,) mm."""
        return np.hypot(self.errors[:, 0], self.errors[:, 1])

    @property
    def largest(self) -> float:
        """Greatest error of a mark (mm)."""
        return float(self.distances.max())


def fit_marks(registration: Registration) -> MarkFit | None:
    """Return the fit of measured marks, whatever its errors; None if none were measured."""
    similarity = registration.similarity
    if similarity is None:
        return None
    laid = similarity.apply(np.array(registration.marks))
    return MarkFit(similarity, np.array(registration.measured) - laid)


def checked_fit(registration: Registration) -> MarkFit | None:
    """Return the fit of measured marks if it can be used; None if none were measured.

    Raises
    ------
    PlanError
        Marks were measured at nearly the same place or mirrored, the scale is no possible one of a
        print, or the error of a mark is greater than the limit.
    """
    fit = fit_marks(registration)
    if fit is None:
        return None
    _check_distances(registration)
    drawn, measured = np.array(registration.marks), np.array(registration.measured)
    limit, worst = registration.limit, int(np.argmax(fit.distances))
    if is_mirrored(drawn, measured) and fit.largest > limit:
        raise PlanError("registration.mirrored")
    free = registration.model_copy(update={"scale": "fit"}).similarity
    scale = fit.similarity.scale if free is None else free.scale
    if not SCALES[0] <= scale <= SCALES[1]:
        raise PlanError("registration.scale", scale=scale, least=SCALES[0], most=SCALES[1])
    if fit.largest > limit:
        raise PlanError(
            "registration.error",
            mark=worst + 1,
            x=float(measured[worst, 0]),
            y=float(measured[worst, 1]),
            distance=fit.largest,
            limit=limit,
        )
    return fit


def _check_distances(registration: Registration) -> None:
    """Raise ``PlanError`` if two marks were measured at nearly the same place."""
    measured = np.array(registration.measured)
    for number in range(1, len(measured)):
        distances = np.hypot(*(measured[:number] - measured[number]).T)
        other = int(np.argmin(distances))
        if distances[other] < LEAST_DISTANCE * SCALES[0]:
            raise PlanError(
                "registration.close",
                mark=number + 1,
                other=other + 1,
                x=float(measured[number, 0]),
                y=float(measured[number, 1]),
                distance=float(distances[other]),
            )


def describe_registration(options: VerifiedOptions) -> Message | None:
    """Return how a printed sheet lies on the table; None for a sheet without marks."""
    registration = options.registration
    if registration is None:
        return None
    fit = fit_marks(registration)
    if fit is None:
        return Message("registration.not-measured", count=len(registration.marks))
    similarity = fit.similarity
    return Message(
        "registration.laid",
        count=len(registration.marks),
        x=similarity.x,
        y=similarity.y,
        turn=similarity.turn,
        scale=similarity.scale,
        error=fit.largest,
    )


def measured_similarity(options: VerifiedOptions) -> Similarity | None:
    """Return the map from the drawing to the table that the options of a job state.

    The result is None if the drawing is placed at the origin of the machine.  Raises PlanError as
    ``checked_fit`` does.
    """
    fit = None if options.registration is None else checked_fit(options.registration)
    return None if fit is None else fit.similarity


def lay_edges(edges: _Edges, similarity: Similarity | None) -> _Edges:
    """Return a drawing or a dieline as it lies on the table; unchanged if ``similarity`` is None.

    Arcs stay arcs with their bulges.
    """
    if similarity is None:
        return edges
    return replace(
        edges, ends=similarity.apply(edges.ends), fit_error=edges.fit_error * similarity.scale
    )


def lay_options(options: _Options, similarity: Similarity | None) -> _Options:
    """Return options whose places in the drawing are those on the table."""
    corners = getattr(options, "corners", None)
    if similarity is None or corners is None or not corners.at:
        return options
    places = similarity.apply(np.array([(corner.x, corner.y) for corner in corners.at]))
    at = tuple(
        corner.model_copy(update={"x": x, "y": y})
        for corner, (x, y) in zip(corners.at, places.tolist(), strict=True)
    )
    return options.model_copy(update={"corners": corners.model_copy(update={"at": at})})


def check_on_table(laid: Dieline, machine: Machine) -> None:
    """Raise ``TravelExceeded`` if edges that lie by measured marks extend past the table."""
    made = ~np.isin(laid.line_type, (LineType.IGNORED, LineType.UNCLASSIFIED))
    x, y, right, top = extents(laid.ends[made], laid.bulge[made]).tolist()
    if min(x, y) < 0.0 or right > machine.width or top > machine.height:
        raise TravelExceeded(
            "registration.off-table",
            x=x,
            y=y,
            right=right,
            top=top,
            machine=machine.title,
            width=machine.width,
            height=machine.height,
        )
