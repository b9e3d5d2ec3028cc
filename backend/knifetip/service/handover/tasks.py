"""Tasks of the worker processes that write exports and job tickets."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from knifetip.errors import KnifetipError
from knifetip.geometry import arc
from knifetip.geometry.columns import F64
from knifetip.handover.export import ExportFormat, export
from knifetip.handover.figures import drawing_figure, path_figure
from knifetip.handover.ticket.facts import StationUse, TicketFacts, TypeLength
from knifetip.model.dieline import LineType
from knifetip.model.figure import Figure
from knifetip.model.machine import Machine
from knifetip.model.stage import Progress
from knifetip.model.toolpath import Motion, Toolpath
from knifetip.presentation.toolpath import unpack_seconds, unpack_toolpath
from knifetip.sequencing.duration import durations


class JobData(NamedTuple):
    """Stored data of a job; each is None if the job is not compiled."""

    overrides: bytes  #: see ``Interpretation.overrides``
    toolpath: bytes | None
    tools: Sequence[dict[str, object]]  #: stations that the program uses: station, name and kind
    machine: Machine | None  #: None if it cannot be used any more


def export_drawing(_progress: Progress, edges: bytes, form: ExportFormat, width: int) -> bytes:
    """Return a stored drawing as a file; see ``handover.export.export``.

    Parameters
    ----------
    edges
        The packed ``EdgeTable`` of the drawing.
    """
    return export(drawing_figure(edges), form, width)


def export_path(
    _progress: Progress,
    toolpath: bytes,
    edges: bytes,
    machine: Machine,
    form: ExportFormat,
    width: int,
) -> bytes:
    """Return a stored tool path as a file; see ``path_figure`` and ``export``."""
    return export(path_figure(toolpath, edges, machine), form, width)


def write_ticket(
    _progress: Progress,
    facts: TicketFacts,
    edges: bytes,
    job: JobData,
    language: str,
    fonts: Sequence[str],
) -> bytes:
    """Return the job ticket of a job as PDF.

    Parameters
    ----------
    facts
        The facts without stations and lengths, which are added here.
    edges
        The packed ``EdgeTable`` of the drawing.
    job
        Stored data of the job.
    language
        Tag of the language.
    fonts
        Files of further fonts.
    """
    from knifetip.handover.ticket.document import write_ticket  # slow to import

    picture = drawing_figure(edges, job.overrides)
    complete = facts._replace(stations=_stations(job), lengths=_lengths(picture))
    return write_ticket(complete, picture, language, fonts)


def _lengths(picture: Figure) -> tuple[TypeLength, ...]:
    """Return the length of each line type of a drawing."""
    return tuple(
        TypeLength(
            LineType.from_word(layer.name).word,
            float(arc.length(layer.ends[:, 0], layer.ends[:, 1], layer.bulge).sum()),
        )
        for layer in picture.layers
    )


def _stations(job: JobData) -> tuple[StationUse, ...]:
    """Return the stations of a program with their tools, lengths and times."""
    from knifetip.handover.ticket.sentences import tool_message

    machine = job.machine
    held = {} if machine is None else {one.number: one.tool for one in machine.stations}
    toolpath = _toolpath(job)
    lengths = np.zeros(256) if toolpath is None else _worked_lengths(toolpath)
    seconds = None if toolpath is None else _seconds(job, toolpath)
    return tuple(
        StationUse(
            number,
            str(tool["name"]),
            str(tool["kind"]),
            tool_message(held[number]) if number in held else None,
            float(lengths[number]),
            None if seconds is None else float(seconds[number]),
        )
        for tool in job.tools
        for number in (int(str(tool["station"])),)
    )


def _toolpath(job: JobData) -> Toolpath | None:
    """Return the tool path of a job; None without one that this version can read."""
    try:
        return None if job.toolpath is None else unpack_toolpath(job.toolpath)[0]
    except KnifetipError:
        return None


def _worked_lengths(toolpath: Toolpath) -> F64:
    """Return the length in the board of each station (mm), by its number, (256,)."""
    worked = np.isin(toolpath.motion, (Motion.LEAD_IN, Motion.FEED, Motion.LEAD_OUT))
    lengths = arc.length(toolpath.pose[:-1, :2], toolpath.pose[1:, :2], toolpath.bulge)
    sums: F64 = np.bincount(toolpath.tool[worked], lengths[worked], minlength=256).astype(float)
    return sums


def _seconds(job: JobData, toolpath: Toolpath) -> F64 | None:
    """Return the machine time of each station (s), by its number, (256,).

    The times are those of the compile.  Those of a job that an older version compiled are computed
    here; None if its machine does not have all stations of the program any more.
    """
    times = None if job.toolpath is None else unpack_seconds(job.toolpath)
    if times is None:
        machine = job.machine
        held = set() if machine is None else {one.number for one in machine.stations}
        if machine is None or not set(np.unique(toolpath.tool).tolist()) <= held:
            return None
        times = durations(toolpath, machine)
    sums: F64 = np.bincount(toolpath.tool, times, minlength=256).astype(float)
    return sums
