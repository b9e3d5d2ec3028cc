"""The damage by a mutant: what its tips do to the board unlike those of the correct program.

A tip's path is compared as a set of points with depth and heading (``effects.BLADE``: 1° counts as
0.01 mm), station by station.  The order counts only where it does damage: work on a part after its
outline is cut.  A router or a laser is compared by the board that it leaves, because its path may
differ in the waste.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, Final

import numpy as np
import shapely
import shapely.ops

from knifetip.geometry.columns import F64
from knifetip.model.dieline import LineType
from knifetip.model.machine import Machine
from knifetip.model.tool import Cutter, Knife, Laser
from tests.attack.controller import NotExecuted, Run, execute
from tests.attack.effects import BLADE, TOLERANCE, Contact, Effect, effect
from tests.attack.plotter import plot
from tests.attack.segments import drive
from tests.attack.subjects import Subject
from tests.controllers.linuxcnc_rs274 import RS274, TipTool, read_program
from tests.support.programs.line_mutation import chords

#: Distance from the outline within which work after it still belongs to it (mm).
_MARGIN: Final = 0.5
#: By how much a language rounds points to its units (mm).
_ROUNDING: Final = {"hpgl": 0.0177, "mcx314": 0.0036}
#: Spacing of the points at which a router's work is compared (mm).
_GRID: Final = 2.0


@dataclass
class Oracle:
    """Measures the damage of mutants of one subject."""

    subject: Subject

    @cached_property
    def machine(self) -> Machine:
        """The machine with the feeds that the board permits."""
        return self.subject.machine.for_board(self.subject.board)

    @property
    def tooled(self) -> bool:
        """Whether the controller has a tool table (LinuxCNC)."""
        return self.subject.language == "linuxcnc"

    @property
    def plots(self) -> bool:
        """Whether the controller is a plotter, which sets depths and headings itself."""
        return self.subject.language == "hpgl"

    def run_of(self, text: bytes) -> Run:
        """Return what a program for another controller than a plotter makes the machine do."""
        if self.subject.language == "mcx314":
            return drive(text, self.machine)
        return execute(text, self.machine, tooled=self.tooled)

    def effect_of(self, text: bytes) -> Effect:
        """Return what a program does to the board; raises NotExecuted."""
        machine = self.machine
        if self.plots:
            return plot(text, machine)
        return effect(self.run_of(text), machine, self.subject.board, tooled=self.tooled)

    @cached_property
    def _before(self) -> list[Contact]:
        """The contacts that earlier programs have made, also those that are made again."""
        before: list[Contact] = []
        for work in self.subject.earlier:
            start = 1 + max((each.track for each in before), default=0)
            before += [
                replace(each, track=start + each.track)
                for each in self.effect_of(work.text).contacts
                if any(low <= each.line <= high for low, high in work.lines + work.repeated)
            ]
        return before

    def _whole(self, run: Effect) -> Effect:
        """Return what a program does after the earlier ones, as the effect of one program."""
        start = 1 + max((each.track for each in self._before), default=-1)
        own = [replace(each, track=start + each.track) for each in run.contacts]
        return replace(run, contacts=[*self._before, *own])

    @property
    def _tolerance(self) -> float:
        """Greatest distance from the path of the correct program (mm).

        At an end, the tip may be off by the tolerance beside the line and along it.  Both paths
        may be rounded to units.
        """
        return math.sqrt(2.0) * TOLERANCE + 2.0 * _ROUNDING.get(self.subject.language, 0.0)

    @cached_property
    def base(self) -> Effect:
        """The effect of the correct program, which has no danger."""
        base = self.effect_of(self.subject.text)
        dangers = base.dangers + base.rounded
        assert not dangers, (self.subject.name, dangers[:5])
        assert base.contacts, self.subject.name
        return base

    @cached_property
    def _milling(self) -> dict[int, float]:
        """Radius of the cutter of each station that carries a router or a laser."""
        if self.plots:
            return {}
        return {
            index: tool.radius if isinstance(tool, Cutter) else 0.5 * tool.kerf
            for index, held in enumerate(self.machine.stations)
            for tool in [held.tool]
            if isinstance(tool, Cutter | Laser)
        }

    def damage(self, text: bytes) -> str:
        """Return the damage that a program does, "" if none."""
        try:
            mutant = self.effect_of(text)
        except NotExecuted as fault:
            return f"not executed: {fault}"
        if RS274 and self.tooled:
            run, machine = self.run_of(text), self.machine
            if difference := interpreter_difference(run, text, machine):
                return difference
        if mutant.dangers:
            return mutant.dangers[0]
        for corner, station, tip in mutant.rounded:
            if not self._in_waste(tip, self._milling.get(station, 0.0)):
                return corner
        if reason := self._misplaced(mutant):
            return reason
        return self._released_early(mutant)

    def _misplaced(self, mutant: Effect) -> str:
        for station in {each.station for each in (*self.base.contacts, *mutant.contacts)}:
            old, new = (
                [each for each in found.contacts if each.station == station]
                for found in (self.base, mutant)
            )
            if station in self._milling:
                if reason := self._mills_otherwise(old, new, self._milling[station]):
                    return reason
                continue
            cut = old + self._passes_back(old)
            for kind, own, others in (("is off by", new, cut), ("leaves out", old, new)):
                far, where = _farthest(own, others)
                if kind == "leaves out" and self._in_waste(where):
                    # A lead that is shorter or missing in the waste does no damage.
                    continue
                if far > self._tolerance + 1e-6:
                    x, y, z = where[:3]
                    return f"station {station} {kind} {far:.4f} mm at ({x:.3f}, {y:.3f}, {z:.3f})"
        return ""

    def _passes_back(self, contacts: list[Contact]) -> list[Contact]:
        """Return the passes with a knife reversed that stay within the slits of straight cuts.

        They cut nothing more.  Where the leading edge is slanted, the slit in the top face begins
        that much later than the slit in the bottom face, and the reversed blade is as much behind
        its tip.
        """
        back: list[Contact] = []
        if self.plots:
            return back
        for each in contacts:
            tool = self.machine.stations[each.station].tool
            if not isinstance(tool, Knife) or tool.trail:
                continue
            points = each.points[[0, -1]]
            ahead = points[0, 3:] / BLADE
            shift = 2.0 * tool.lead(self.subject.board.caliper)
            straight = (np.abs(np.diff(each.points[:, 2:], axis=0)) < 1e-9).all()
            if straight and (points[1] - points[0])[:2] @ ahead > shift:
                points[0, :2] += shift * ahead
                points[:, 3:] *= -1.0
                back.append(replace(each, points=points))
        return back

    # --- routers and lasers ------------------------------------------------------------------

    @cached_property
    def _edge_points(self) -> F64:
        return np.vstack(self._cut_chords)

    @cached_property
    def _cut_chords(self) -> list[F64]:
        line = self.subject.dieline
        shift = np.array(self.subject.placement)
        return [
            shift + chords(line.ends[row, 0], line.ends[row, 1], float(line.bulge[row]))
            for row in np.flatnonzero(line.line_type == LineType.CUT)
        ]

    @cached_property
    def _faces(self) -> list[Any]:
        union = shapely.union_all([shapely.linestrings(path) for path in self._cut_chords])
        return list(shapely.ops.polygonize(shapely.set_precision(union, 1e-6)))

    @cached_property
    def _inner_points(self) -> F64:
        """Points of the parts: of all faces, without those inside a hole."""
        edges = self._edge_points
        x, y = (
            np.arange(low, high, _GRID)
            for low, high in zip(edges.min(axis=0), edges.max(axis=0), strict=True)
        )
        grid: F64 = np.stack(np.meshgrid(x + 0.7, y + 0.3), axis=-1).reshape(-1, 2)
        rings = [shapely.Polygon(face.exterior) for face in self._faces]
        spots = shapely.points(grid)
        inside = sum(shapely.contains(ring, spots).astype(int) for ring in rings)
        points: F64 = grid[inside % 2 == 1]
        return points

    def _mills_otherwise(self, old: list[Contact], new: list[Contact], radius: float) -> str:
        if [each.points.tobytes() for each in old] == [each.points.tobytes() for each in new]:
            return ""
        places = np.vstack([self._edge_points, self._inner_points])
        shallow = [_distances(places, contacts, math.inf) for contacts in (old, new)]
        nearer = np.where(shallow[1] < radius + 0.05, shallow[0] - shallow[1], 0.0)
        low = min(each.points[:, 2].min() for each in old) + TOLERANCE
        through = [
            np.minimum(_distances(self._edge_points, contacts, low), radius + 0.5)
            for contacts in (old, new)
        ]
        moved = np.abs(through[1] - through[0])
        if nearer.max() > TOLERANCE:
            x, y = places[int(nearer.argmax())]
            return f"mills {nearer.max():.4f} mm nearer at ({x:.2f}, {y:.2f})"
        if moved.max() > TOLERANCE:
            x, y = self._edge_points[int(moved.argmax())]
            return f"mills otherwise by {moved.max():.4f} mm at ({x:.2f}, {y:.2f})"
        return ""

    def _in_waste(self, where: F64, radius: float = 0.0) -> bool:
        """Return whether a tool of a radius (mm) is outside all parts, away from every cut."""
        spot = shapely.Point(where[0], where[1])
        return bool(shapely.union_all(self._faces).distance(spot) > radius + _MARGIN)

    # --- order -------------------------------------------------------------------------------

    @cached_property
    def _parts(self) -> list[tuple[Any, list[F64]]]:
        """Each part without its holes, with points along each contour that releases it."""
        rings = [shapely.Polygon(face.exterior) for face in self._faces]
        union = shapely.union_all(self._faces)
        outer = [shapely.Polygon(each.exterior) for each in getattr(union, "geoms", [union])]
        parts = [(piece, [_points_along(piece)]) for piece in outer]
        for ring in rings:
            around = [other for other in rings if other.buffer(1e-3).contains(ring)]
            # A ring in an even number of others, with itself, is a hole.
            if len(around) % 2:
                parts.append((ring, [_points_along(other) for other in around]))
        return parts

    def _released_early(self, mutant: Effect) -> str:
        keys = [[each.points.tobytes() for each in run.contacts] for run in (self.base, mutant)]
        if keys[0] == keys[1]:
            return ""
        whole = self._whole(mutant)
        for part, contours in self._parts:
            done = [self._completion(points, whole) for points in contours]
            released = min((track for track in done if track >= 0), default=math.inf)
            for contact in whole.contacts[len(self._before) :]:
                reach = self._milling.get(contact.station, 0.0)
                way = shapely.linestrings(_way(contact))
                if contact.track > released and part.buffer(-_MARGIN - reach).intersects(way):
                    return f"line {contact.line} works on a part after its outline"
        return ""

    def _completion(self, points: F64, run: Effect) -> int:
        """Return the track that completes a contour as far as the correct program cuts it."""
        wanted = self._cut_at(points, self._whole(self.base)) >= 0
        tracks = self._cut_at(points, run)[wanted]
        return -1 if not len(tracks) or (tracks < 0).any() else int(tracks.max())

    def _cut_at(self, points: F64, run: Effect) -> Any:
        """Return the first track that cuts through the board at each point, -1 for none."""
        first = np.full(len(points), -1)
        for contact in run.contacts:
            if contact.points[:, 2].max() > 1e-3 and contact.station not in self._milling:
                continue
            if self.plots and contact.station != 1:
                continue
            reach = self._milling.get(contact.station, 0.0) + 0.3
            near = (first < 0) & (
                shapely.distance(shapely.linestrings(_way(contact)), shapely.points(points)) < reach
            )
            first[near] = contact.track
        return first


def _points_along(piece: Any) -> F64:
    ring = piece.exterior
    steps = np.arange(0.25, ring.length, 1.0)
    points: F64 = shapely.get_coordinates(shapely.line_interpolate_point(ring, steps))
    return points


def _way(contact: Contact) -> F64:
    way = contact.points[:, :2]
    return way if len(way) > 1 else np.vstack([way, way])


def _distances(places: F64, contacts: list[Contact], low: float) -> F64:
    """Return the distance of each place to the paths that are nowhere above ``low``, (n,) mm."""
    ways = [_way(each) for each in contacts if each.points[:, 2].max() <= low]
    result = np.full(len(places), 1e3)
    if not ways:
        return result
    pieces = np.concatenate([np.stack([way[:-1], way[1:]], axis=1) for way in ways])
    tree = shapely.STRtree(shapely.linestrings(pieces))
    found, far = tree.query_nearest(shapely.points(places), return_distance=True, all_matches=False)
    result[found[0]] = far
    return result


def _farthest(own: list[Contact], others: list[Contact]) -> tuple[float, F64]:
    """Return the greatest distance of the points of some paths from other paths, and where (mm)."""
    known = {each.points.tobytes() for each in others}
    fresh = [each for each in own if each.points.tobytes() not in known]
    worst, where = 0.0, np.zeros(5)
    if not fresh:
        return worst, where
    if not others:
        return math.inf, fresh[0].points[0]
    start = np.vstack([each.points[:-1] for each in others])
    step = np.vstack([np.diff(each.points, axis=0) for each in others])
    # A path without travel acts at its lowest point.
    flat = np.array([1.0, 1.0, 0.0, 1.0, 1.0])
    size = ((step * flat) ** 2).sum(axis=1)
    upright = size < 1e-18
    start[upright] += np.where(step[upright, 2:3] < 0.0, step[upright], 0.0)
    step[upright], size[upright] = 0.0, 1.0
    for contact in fresh:
        for one, other in zip(contact.points[:-1], contact.points[1:], strict=True):
            pieces = 2 + min(200, int(np.hypot(*(other - one)[:2]) / 0.5))
            points = one + (other - one) * np.linspace(0.0, 1.0, pieces)[:, None]
            to = points[:, None] - start
            along = np.clip((to * flat * step).sum(axis=2) / size, 0.0, 1.0)
            to -= along[..., None] * step
            # Above a deeper path there is nothing left to cut.
            to[..., 2] = np.minimum(to[..., 2], 0.0)
            far = np.linalg.norm(to, axis=2).min(axis=1)
            if far.max() > worst:
                worst, where = float(far.max()), points[int(far.argmax())]
    return worst, where


def interpreter_difference(run: Run, text: bytes, machine: Machine) -> str:
    """Return where LinuxCNC's interpreter moves otherwise than ``execute``, "" if nowhere."""
    # rs274 reads the offsets of the tool table as inches.
    tools = {
        held.number: TipTool("", 0.0, datum=(held.x / 25.4, held.y / 25.4, held.z / 25.4, held.c))
        for held in machine.stations
    }
    reading = read_program(text, tools)
    if not reading.accepted:
        return f"rs274 refuses it: {reading.stderr[-200:]!r}"
    if len(run.motions) != len(reading.moves):
        return f"rs274 makes {len(reading.moves)} moves instead of {len(run.motions)}"
    if machine.gantry:
        return ""
    for motion, other in zip(run.motions, reading.moves.end, strict=True):
        for letter, value in zip("XYZC", other, strict=True):
            own = motion.axes_end[letter] - motion.offset.get(letter, 0.0)
            # Without a machine, rs274 forgets the positions at a tool change.
            if letter in motion.given and abs(own - value) > 2e-4:
                return f"line {motion.line}: rs274 moves {letter} to {value:g}, not {own:g}"
    return ""
