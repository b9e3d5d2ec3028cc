"""The equidistant beside its peers: batches of lines, batches with arcs, and one long contour.

Peers are given the same contours, arcs as eight chords, and round their corners with about as many
chords to a quarter as shapely's default of sixteen.  Those that are not installed are left out.

The CavalierContours that PyPI has is built without optimisation and called once a contour.  Its C++
built with -O3 cannot be installed from there; measured once beside shapely in one run, it took
145 ms against 295 on the batch of lines and 25 against 221 on that with arcs.  So three times its
speed is ``NATIVE`` times three that of shapely here, which the subjects state.
"""

from __future__ import annotations

import importlib
from collections.abc import Callable
from types import ModuleType
from typing import TypeAlias

import numpy as np
import shapely

from knifetip.geometry import arc
from knifetip.geometry.columns import F64
from knifetip.geometry.path import Paths
from knifetip.offset.offset_paths import offset_paths

Bench: TypeAlias = tuple[str, int, Callable[[], object], dict[str, Callable[[], object]], int]

#: Chords to a quarter of a circle, and how far those of radius 1 stand off it.
QUARTER = 16
STANDS_OFF = 1.0 - np.cos(np.pi / QUARTER / 4.0)
#: How many times as fast as shapely CavalierContours was, built with -O3: lines, arcs.
NATIVE = (295.0 / 145.0, 221.0 / 25.0)
#: pyclipper and pyclipr count in whole numbers.
SCALE = 1e5


def _peer(name: str) -> ModuleType | None:
    try:
        return importlib.import_module(name)
    except ImportError:
        return None


def stars(count: int, corners: int, low: float, high: float, arcs: bool = False) -> Paths:
    """Return star-shaped contours with convex and concave corners, every second segment an arc."""
    random = np.random.default_rng(1)
    angle = np.arange(corners) * 2.0 * np.pi / corners
    away = random.uniform(low, high, (count, corners))
    xy = np.stack([np.cos(angle) * away, np.sin(angle) * away], axis=-1)
    bulge = np.zeros((count, corners))
    if arcs:
        bulge[:, ::2] = random.uniform(-0.3, 0.3, (count, (corners + 1) // 2))
    return Paths(
        xy.reshape(-1, 2),
        np.roll(xy, -1, axis=1).reshape(-1, 2),
        bulge.reshape(-1),
        (np.arange(count + 1) * corners).astype(np.int32),
    )


def _flattened(paths: Paths) -> list[F64]:
    points = arc.points_along(paths.start, paths.end, paths.bulge, 9)
    rows = [points[i, :-1] if paths.bulge[i] else points[i, :1] for i in range(len(paths.bulge))]
    return [
        np.concatenate(rows[a:b]) for a, b in zip(paths.first[:-1], paths.first[1:], strict=True)
    ]


def _peers(paths: Paths, distance: float) -> dict[str, Callable[[], object]]:
    """Return what offsets the same contours outwards."""
    rings = _flattened(paths)
    shapes = np.array([shapely.Polygon(ring) for ring in rings])
    peers: dict[str, Callable[[], object]] = {
        "shapely": lambda: shapely.buffer(shapes, distance, quad_segs=QUARTER)
    }
    if (clipper := _peer("pyclipper")) is not None:
        whole = [(ring * SCALE).astype(np.int64).tolist() for ring in rings]

        def pyclipper() -> object:
            made = []
            for ring in whole:
                offset = clipper.PyclipperOffset(2.0, STANDS_OFF * distance * SCALE)
                offset.AddPath(ring, clipper.JT_ROUND, clipper.ET_CLOSEDPOLYGON)
                made.append(offset.Execute(distance * SCALE))
            return made

        peers["pyclipper"] = pyclipper
    if (clipper2 := _peer("pyclipr")) is not None:

        def pyclipr() -> object:
            made = []
            for ring in rings:
                offset = clipper2.ClipperOffset()
                offset.scaleFactor = int(SCALE)
                # Its tolerance is in scaled units.
                offset.arcTolerance = STANDS_OFF * distance * SCALE
                offset.addPath(ring, clipper2.JoinType.Round, clipper2.EndType.Polygon)
                made.append(offset.execute(distance))
            return made

        peers["pyclipr"] = pyclipr
    if (cavalier := _peer("cavaliercontours")) is not None:
        columns = [
            (paths.start[a:b, 0].copy(), paths.start[a:b, 1].copy(), paths.bulge[a:b].copy())
            for a, b in zip(paths.first[:-1], paths.first[1:], strict=True)
        ]

        def cavaliercontours() -> object:
            return [
                cavalier.Polyline(np.stack(column), is_closed=True).parallel_offset(-distance, 0)
                for column in columns
            ]

        peers["cavaliercontours-python"] = cavaliercontours
    return peers


def _bench(subject: str, paths: Paths, distance: float, runs: int) -> Bench:
    return (
        subject,
        len(paths.bulge),
        lambda: offset_paths(paths, distance, -1),
        _peers(paths, distance),
        runs,
    )


def offset_lines() -> Bench:
    """Ten thousand contours of lines."""
    subject = f"10,000 contours of 20 lines, B (CavalierContours -O3: shapely / {NATIVE[0]:.1f})"
    return _bench(subject, stars(10_000, 20, 20.0, 40.0), 1.0, 5)


def offset_arcs() -> Bench:
    """Two thousand contours of which every second segment is an arc."""
    subject = f"2,000 contours of 24, 12 arcs, B (CavalierContours -O3: shapely / {NATIVE[1]:.1f})"
    return _bench(subject, stars(2_000, 24, 20.0, 40.0, arcs=True), 1.0, 5)


def offset_one() -> Bench:
    """One contour whose concave corners are real: neighbours too short for the tool."""
    return _bench("1 contour of 1,000 lines, notched, B", stars(1, 1_000, 400.0, 410.0), 3.0, 15)


def offset_million() -> Bench:
    """One contour of a million segments."""
    paths = stars(1, 1_000_000, 400_000.0, 400_002.0)
    return "1 contour of 1,000,000 lines, B", 1_000_000, lambda: offset_paths(paths, 1.0, -1), {}, 1
