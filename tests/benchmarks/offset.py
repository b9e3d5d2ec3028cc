"""Compare the offset with its peers: batches of lines, batches with arcs, and one long contour.

Peers get the same contours, with eight chords per arc, and round corners with about as many chords
per quarter turn as shapely's default, sixteen.  Peers that are not installed are omitted.

CavalierContours on PyPI is built without optimisation and called once per contour.  Its C++ code,
built with -O3, is not available on PyPI; measured once, it took 145 ms for the batch of lines, for
which shapely took 295 ms, and 25 ms for the batch with arcs, for which shapely took 221 ms.  Its
time is therefore estimated as that of shapely divided by ``NATIVE``; the subjects state this.
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

#: Chords per quarter circle, and their largest distance from a circle of radius 1.
QUARTER = 16
CHORD_DISTANCE = 1.0 - np.cos(np.pi / QUARTER / 4.0)
#: Speed of CavalierContours, built with -O3, as a multiple of shapely's: lines, arcs.
NATIVE = (295.0 / 145.0, 221.0 / 25.0)
#: pyclipper and pyclipr use integer coordinates.
SCALE = 1e5


def _import_optional(name: str) -> ModuleType | None:
    try:
        return importlib.import_module(name)
    except ImportError:
        return None


def stars(count: int, corners: int, low: float, high: float, arcs: bool = False) -> Paths:
    """Return star-shaped contours with convex and concave corners.

    Parameters
    ----------
    low, high
        Smallest and largest distance of a corner from the centre (mm).
    arcs
        Make every second segment an arc.
    """
    random = np.random.default_rng(1)
    angle = np.arange(corners) * 2.0 * np.pi / corners
    radius = random.uniform(low, high, (count, corners))
    xy = np.stack([np.cos(angle) * radius, np.sin(angle) * radius], axis=-1)
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
    """Return functions that offset the contours outwards with other libraries, by library name."""
    rings = _flattened(paths)
    shapes = np.array([shapely.Polygon(ring) for ring in rings])
    peers: dict[str, Callable[[], object]] = {
        "shapely": lambda: shapely.buffer(shapes, distance, quad_segs=QUARTER)
    }
    if (clipper := _import_optional("pyclipper")) is not None:
        rounded = [(ring * SCALE).astype(np.int64).tolist() for ring in rings]

        def pyclipper() -> object:
            results = []
            for ring in rounded:
                offset = clipper.PyclipperOffset(2.0, CHORD_DISTANCE * distance * SCALE)
                offset.AddPath(ring, clipper.JT_ROUND, clipper.ET_CLOSEDPOLYGON)
                results.append(offset.Execute(distance * SCALE))
            return results

        peers["pyclipper"] = pyclipper
    if (clipper2 := _import_optional("pyclipr")) is not None:

        def pyclipr() -> object:
            results = []
            for ring in rings:
                offset = clipper2.ClipperOffset()
                offset.scaleFactor = int(SCALE)
                # The tolerance of pyclipr is in scaled units.
                offset.arcTolerance = CHORD_DISTANCE * distance * SCALE
                offset.addPath(ring, clipper2.JoinType.Round, clipper2.EndType.Polygon)
                results.append(offset.execute(distance))
            return results

        peers["pyclipr"] = pyclipr
    if (cavalier := _import_optional("cavaliercontours")) is not None:
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
    """Offset ten thousand contours of lines."""
    subject = f"10,000 contours of 20 lines, B (CavalierContours -O3: shapely / {NATIVE[0]:.1f})"
    return _bench(subject, stars(10_000, 20, 20.0, 40.0), 1.0, 5)


def offset_arcs() -> Bench:
    """Offset two thousand contours in which every second segment is an arc."""
    subject = f"2,000 contours of 24, 12 arcs, B (CavalierContours -O3: shapely / {NATIVE[1]:.1f})"
    return _bench(subject, stars(2_000, 24, 20.0, 40.0, arcs=True), 1.0, 5)


def offset_one() -> Bench:
    """Offset one contour with concave corners between segments too short for the tool."""
    return _bench("1 contour of 1,000 lines, notched, B", stars(1, 1_000, 400.0, 410.0), 3.0, 15)


def offset_million() -> Bench:
    """Offset one contour of a million segments."""
    paths = stars(1, 1_000_000, 400_000.0, 400_002.0)
    return "1 contour of 1,000,000 lines, B", 1_000_000, lambda: offset_paths(paths, 1.0, -1), {}, 1
