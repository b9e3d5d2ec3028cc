"""engine: place shapes in a strip of given height, with sparrow in a process of its own.

Sparrow (spyrrow) is a heuristic for strip packing: it makes the strip shorter until its time is
over.  It cannot be stopped, and ends its process if a shape is not usable; therefore it has a
process, which is killed when its arrangements are not needed any more.
"""

from __future__ import annotations

import json
import queue
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Generator, Iterator, Sequence
from dataclasses import dataclass
from typing import Final, NamedTuple

#: Seconds between two calls of ``stopped``.
_INTERVAL: Final = 0.1
#: Seconds that the engine gets beyond its time to start and to end.
_GRACE: Final = 3.0


class Shape(NamedTuple):
    """A shape that is placed: a polygon without holes."""

    corners: list[tuple[float, float]]  #: mm
    quantity: int
    turns: tuple[float, ...]  #: permitted turns about the origin (°)


@dataclass(frozen=True, slots=True)
class Strip:
    """A strip along X in which shapes are placed."""

    height: float  #: along Y (mm)
    gap: float  #: between two shapes (mm); shapes may touch the edges of the strip
    shapes: Sequence[Shape]
    seconds: float  #: time of the search
    seed: int


class PlacedShape(NamedTuple):
    """Place of a shape: it is turned about the origin, then moved."""

    shape: int  #: index into ``Strip.shapes``
    turn: float  #: °
    x: float  #: mm
    y: float  #: mm


class StripFilling(NamedTuple):
    """All shapes of a strip at their places."""

    length: float  #: of the strip along X (mm)
    placed: list[PlacedShape]


def fill_strip(strip: Strip, stopped: Callable[[], bool]) -> Generator[StripFilling]:
    """Yield arrangements of all shapes, each shorter than the one before.

    Nothing is yielded if the engine finds none, or fails.  The process of the engine ends with the
    iterator.

    Parameters
    ----------
    strip
        The strip and the shapes.
    stopped
        Called several times per second; returns True to end the search.
    """
    # The engine keeps the gap to the edges of the strip, too.
    sent = {
        "height": strip.height + 2.0 * strip.gap,
        "gap": strip.gap or None,
        "shapes": strip.shapes,
        "seconds": strip.seconds,
        "seed": strip.seed,
    }
    command = [sys.executable, "-m", "knifetip.nesting.engine_process"]
    with subprocess.Popen(
        command,
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
    ) as process:
        lines: queue.SimpleQueue[str] = queue.SimpleQueue()
        reader = threading.Thread(target=_read, args=(process, lines), daemon=True)
        try:
            _send(process, json.dumps(sent))
            reader.start()
            for line in _lines(lines, strip.seconds + _GRACE, stopped):
                yield _filling(line, strip.gap)
        finally:
            process.kill()
            if reader.ident is not None:
                reader.join()


def _send(process: subprocess.Popen[str], text: str) -> None:
    assert process.stdin is not None
    try:
        process.stdin.write(text + "\n")
        process.stdin.flush()
    except BrokenPipeError:
        return  # it ended at its start: there is nothing to read


def _read(process: subprocess.Popen[str], lines: queue.SimpleQueue[str]) -> None:
    assert process.stdout is not None
    for line in process.stdout:
        lines.put(line)
    lines.put("")


def _lines(
    lines: queue.SimpleQueue[str], seconds: float, stopped: Callable[[], bool]
) -> Iterator[str]:
    """Yield complete lines until the process ends, its time is over, or it is stopped."""
    end = time.monotonic() + seconds
    while time.monotonic() < end and not stopped():
        try:
            line = lines.get(timeout=_INTERVAL)
        except queue.Empty:
            continue
        if not line.endswith("\n"):
            return
        yield line


def _filling(line: str, gap: float) -> StripFilling:
    found = json.loads(line)
    placed = [
        PlacedShape(int(id), float(turn), float(x) - gap, float(y) - gap)
        for id, turn, x, y in found["placed"]
    ]
    return StripFilling(found["length"] - 2.0 * gap, placed)
