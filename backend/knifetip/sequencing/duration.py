"""duration: estimate the time that the machine takes for each row of a toolpath.

A row is one move.  Its time depends on the controller (``timing``).  Also included are the dwells
after a piston or the oscillation of a tool is switched, and the times in which a laser pierces.

As in grblHAL, the length of a move is computed from all four axes, with mm and degrees added alike.
The speed is limited for each axis separately, so the time of a move does not depend on this
convention.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from knifetip.geometry.chords import DEVIATION, chord_counts, split_moves
from knifetip.geometry.columns import F64, I64, Bool
from knifetip.languages.registry import find_language
from knifetip.model.axis_path import axis_path
from knifetip.model.held_heading import hold_heading
from knifetip.model.machine import Machine
from knifetip.model.toolpath import Motion, Toolpath
from knifetip.sequencing.moves import measure_moves
from knifetip.sequencing.timing import Timing


def duration(toolpath: Toolpath, machine: Machine) -> float:
    """Return the time that the machine takes for a toolpath (s)."""
    return float(durations(toolpath, machine).sum())


def durations(toolpath: Toolpath, machine: Machine) -> F64:
    """Return the time of each of the n rows of a toolpath, (n,) s; a row is one move.

    The time of a station change is added to the first row of the new station, and the time of a
    halt to the row before the halt.

    Parameters
    ----------
    toolpath : Toolpath
        One chain of moves, as ``sequence`` returns it.
    machine : Machine
        The function uses the velocities and accelerations of its axes, its settling time, the
        piercing times of its tools and its controller language.

    Notes
    -----
    Let Δᵢ be the travel of axis i in a row, vᵢ and aᵢ the greatest velocity and acceleration of the
    axis, L the length of the row with L² = ΣΔᵢ², and t its time at the programmed feed.  The
    velocity v and the acceleration a along the row are limited to::

        v = min(L / t, vᵢ L / Δᵢ)      a = min aᵢ L / Δᵢ

    On an arc of radius R, Δx and Δy are both the length of the arc, which counts once in L, and
    v² ≤ a R limits the centripetal acceleration.

    The times agree within 2 % with those of the simulated table, and within 1 % with those of
    LinuxCNC on a quiet computer (ADR 0111).
    """
    if len(toolpath) == 0:
        return np.zeros(0)
    path, row = axis_path(hold_heading(toolpath, machine), machine)
    if machine.arcs == "chords":
        path, chord_row = _in_chords(path)
        row = row[chord_row]
    times = _move_times(path, machine)
    if len(path) == len(toolpath):
        return times
    result = np.zeros(len(toolpath))
    np.add.at(result, row, times)
    return result


def _in_chords(toolpath: Toolpath) -> tuple[Toolpath, I64]:
    """Return a toolpath with chords instead of arcs, and the row of each of its moves, (m,)."""
    start, end = toolpath.pose[:-1, :2], toolpath.pose[1:, :2]
    pieces = chord_counts(start, end, toolpath.bulge, DEVIATION)
    pose, row = split_moves(toolpath.pose, toolpath.bulge, pieces)
    straight = replace(toolpath, bulge=np.zeros(len(toolpath)))
    return straight.with_moves(row, pose), row


def _move_times(toolpath: Toolpath, machine: Machine) -> F64:
    """Return the time of each of the n moves of a toolpath, (n,) s; see ``durations``."""
    changed = np.ones(len(toolpath), np.bool_)
    changed[1:] = toolpath.tool[1:] != toolpath.tool[:-1]
    switched, pierced = _beam_switching(toolpath, machine)
    timing: Timing = find_language(machine.dialect).load_part("timing")
    times = timing(measure_moves(toolpath, machine), changed | switched, toolpath, machine)
    times[changed] += _settling_times(machine)[toolpath.tool[changed]]
    times += pierced
    return times


def _settling_times(machine: Machine) -> F64:
    """Return the dwell after each station of a machine is switched on, by number, (256,) s."""
    dwell = np.zeros(256)
    for station in machine.stations:
        dwell[station.number] = station.tool.settle(machine.settle)
    return dwell


def _beam_switching(toolpath: Toolpath, machine: Machine) -> tuple[Bool, F64]:
    """Return the mask of the rows at whose start a laser beam is switched, and the piercing times.

    Both arrays have one entry per row of the toolpath, (n,).  The piercing time (s) is the time for
    which the laser rests at the start of a cut; it is 0 for a row that does not start with
    switching the beam on.
    """
    beams = np.zeros(256, np.bool_)
    pierce = np.zeros(256)
    for station in machine.stations:
        beams[station.number] = station.is_beam
        pierce[station.number] = station.tool.pierce_time
    beam_on = beams[toolpath.tool] & (toolpath.motion != Motion.RAPID)
    before = np.concatenate([[False], beam_on[:-1]])
    return beam_on != before, np.where(beam_on & ~before, pierce[toolpath.tool], 0.0)
