"""Read and classify a whole sheet, compared with the readers of ezdxf and GDAL (pyogrio).

The sheets have 100,000 entities of DXF R2010, written by ezdxf.  One is random, on 6 layers: LINE,
ARC, CIRCLE, LWPOLYLINE, TEXT and INSERTs of 8 blocks; half of its ends meet no other edge, which
takes more time than any carton.  The other has cartons side by side, each with a text and a
register mark.  All readers read from a file.
"""

from __future__ import annotations

import atexit
import io
import math
import random
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import TypeAlias

import ezdxf
import numpy as np
from ezdxf.layouts import BaseLayout
from ezdxf.math import bulge_to_arc

from knifetip.classification.classify import classify
from knifetip.dxf.read import read
from knifetip.library import load
from knifetip.model.dieline import LineType
from tests.support.cartons.random_drawings import CARTONS

try:
    import pyogrio
except ImportError:
    pyogrio = None

Bench: TypeAlias = tuple[str, int, Callable[[], object], dict[str, Callable[[], object]], int]

ENTITIES = 100_000
_LAYERS = ("CUT", "CREASE", "PERF", "HALFCUT", "VGROOVE", "INFO")
_LAYER_OF = {
    LineType.CUT: "CUT",
    LineType.CREASE: "CREASE",
    LineType.PERFORATION: "PERF",
    LineType.HALF_CUT: "HALFCUT",
    LineType.V_GROOVE: "VGROOVE",
}


def _entity(space: BaseLayout, chance: random.Random, x: float, y: float) -> None:
    layer = {"layer": _LAYERS[chance.randrange(5)]}
    kind = chance.random()
    if kind < 0.55:
        end = (x + chance.uniform(1, 9), y + chance.uniform(1, 9))
        space.add_line((x, y), end, dxfattribs=layer)
    elif kind < 0.70:
        space.add_arc((x, y), chance.uniform(1, 4), chance.uniform(0, 90), 180, dxfattribs=layer)
    elif kind < 0.85:
        corners = [(x, y), (x + 8, y, 0, 0, 0.4), (x + 8, y + 5), (x, y + 5)]
        space.add_lwpolyline(corners, close=True, dxfattribs=layer)
    else:
        space.add_circle((x, y), chance.uniform(0.5, 4), dxfattribs=layer)


@cache
def random_sheet(entities: int = ENTITIES) -> bytes:
    """Return a DXF file with random entities."""
    chance = random.Random(4)
    document = ezdxf.new("R2010", units=4)
    for colour, name in enumerate(_LAYERS, start=1):
        document.layers.add(name, color=colour)
    for number in range(8):
        block = document.blocks.new(f"FLAP{number}")
        for _ in range(6):
            _entity(block, chance, chance.uniform(0, 10), chance.uniform(0, 10))
    space = document.modelspace()
    for number in range(entities):
        x, y = number % 316 * 10.0, number // 316 * 10.0
        kind = chance.random()
        if kind < 0.05:
            space.add_text(f"No. {number}", height=3, dxfattribs={"layer": "INFO"}).set_placement(
                (x, y)
            )
        elif kind < 0.15:
            space.add_blockref(
                f"FLAP{chance.randrange(8)}",
                (x, y),
                dxfattribs={"layer": "CUT", "rotation": chance.choice((0, 90, 33.5))},
            )
        else:
            _entity(space, chance, x, y)
    text = io.StringIO()
    document.write(text)
    return text.getvalue().encode()


@cache
def carton_sheet(entities: int = ENTITIES) -> bytes:
    """Return a DXF file with cartons side by side."""
    rng = np.random.default_rng(4)
    document = ezdxf.new("R2010", units=4)
    for colour, name in enumerate(_LAYERS, start=1):
        document.layers.add(name, color=colour)
    mark = document.blocks.new("REGISTER")
    for dx, dy in ((5, 0), (0, 5)):
        mark.add_line((-dx, -dy), (dx, dy), dxfattribs={"layer": "INFO"})
    mark.add_circle((0, 0), 3, dxfattribs={"layer": "INFO"})
    space = document.modelspace()
    x = y = row = 0.0
    while len(space) < entities:
        carton = CARTONS[int(rng.integers(len(CARTONS)))](rng)
        ends = carton.ends.reshape(-1, 2)
        low, high = ends.min(axis=0) - (x, y), ends.max(axis=0)
        for s in carton.strokes:
            start, end = (s.x0 - low[0], s.y0 - low[1]), (s.x1 - low[0], s.y1 - low[1])
            style = {"layer": _LAYER_OF[s.truth]}
            if s.bulge:
                centre, first, last, radius = bulge_to_arc(start, end, s.bulge)
                angles = math.degrees(first), math.degrees(last)
                space.add_arc(centre, radius, *angles, dxfattribs=style)
            else:
                space.add_line(start, end, dxfattribs=style)
        space.add_text(f"No. {len(space)}", height=8, dxfattribs={"layer": "INFO"}).set_placement(
            (x, y - 20.0)
        )
        space.add_blockref("REGISTER", (x - 15.0, y - 15.0), dxfattribs={"layer": "INFO"})
        width, height = high - low - (x, y)
        x, row = x + width + 40.0, max(row, height)
        if x > 60_000.0:
            x, y, row = 0.0, y + row + 60.0, 0.0
    text = io.StringIO()
    document.write(text)
    return text.getvalue().encode()


@cache
def _file(draw: Callable[[], bytes] = random_sheet) -> Path:
    folder = tempfile.mkdtemp()
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    path = Path(folder) / "sheet.dxf"
    path.write_bytes(draw())
    return path


def _peers(path: Path) -> dict[str, Callable[[], object]]:
    peers: dict[str, Callable[[], object]] = {"ezdxf.readfile": lambda: ezdxf.readfile(path)}
    if pyogrio is not None:
        peers["pyogrio.raw.read"] = lambda: pyogrio.raw.read(path)
    return peers


def read_sheet() -> Bench:
    """Read a DXF file with layers and blocks."""
    path = _file()
    size = path.stat().st_size / 2**20
    subject = f"DXF R2010, layers and blocks, {size:.0f} MB, {peak():.1f} × the file in memory"
    if pyogrio is None:
        subject += "; pyogrio is not installed"
    return subject, ENTITIES, lambda: read(path.read_bytes()), _peers(path), 5


def _classified(draw: Callable[[], bytes], subject: str) -> Bench:
    path = _file(draw)
    profile = load.profile("default")
    peers = {"ezdxf.readfile": _peers(path)["ezdxf.readfile"]}
    return (
        subject,
        ENTITIES,
        lambda: classify(read(path.read_bytes()), profile),
        peers,
        3,
    )


def classify_sheet() -> Bench:
    """Read and classify a DXF file with random entities."""
    return _classified(random_sheet, "the same sheet, read and classified")


def classify_nested() -> Bench:
    """Read and classify a DXF file of cartons."""
    return _classified(carton_sheet, "cartons side by side, read and classified")


#: Linux resets the peak of a process that writes 5 to its ``clear_refs``.
_PEAK = """
import sys
from pathlib import Path
from knifetip.dxf.read import read


def memory(what):
    for line in Path("/proc/self/status").read_text().splitlines():
        if line.startswith(what):
            return int(line.split()[1]) * 1024


read(Path(sys.argv[2]).read_bytes())
Path("/proc/self/clear_refs").write_text("5")
before = memory("VmRSS")
drawing = read(Path(sys.argv[1]).read_bytes())
print(memory("VmHWM") - before)
"""


def peak() -> float:
    """Return the peak memory of reading the sheet, as a multiple of the file's size."""
    path = _file()
    small = path.with_name("small.dxf")
    small.write_bytes(random_sheet(100))
    done = subprocess.run(
        [sys.executable, "-c", _PEAK, str(path), str(small)],
        check=True,
        capture_output=True,
        text=True,
    )
    return int(done.stdout) / path.stat().st_size
