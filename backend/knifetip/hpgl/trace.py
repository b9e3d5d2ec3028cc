"""trace: execute the instructions of a plotter file and collect the lines that the pens draw.

``trace`` returns a ``Plot``.  Each instruction that draws has a row in the import report, and so
has each instruction that is not read although it draws or although its meaning is not known.

Sources: PCL 5 Printer Language Technical Reference Manual (HP 5961-0509), chapters 19 to 23; HP
7475A Interfacing and Programming Manual (HP 07475-90001).
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from itertools import accumulate
from typing import Final

from knifetip.drawing_builder.clip import UNCLIPPED
from knifetip.drawing_builder.report import ReportWriter
from knifetip.drawing_builder.shape_paths import ShapePaths
from knifetip.errors import DrawingTooLarge, NotADrawing
from knifetip.formats.limits import Limits
from knifetip.hpgl.coordinates import Coordinates, transform, transform_back, window
from knifetip.hpgl.encoded_polyline import decode
from knifetip.hpgl.instructions import Instruction, count_is_wrong, parse_instructions
from knifetip.hpgl.pens import Pens
from knifetip.hpgl.polygon import Polygon
from knifetip.hpgl.shapes import PlottedShape, Point
from knifetip.messages import Message
from knifetip.model.drawing import Annotation

#: Instructions between two checks of the time limit.
_BLOCK: Final = 4096
#: Names of instructions in the import report.
_NAMES: Final = {
    "PD": "PD (pen down)",
    "PA": "PA (plot absolute)",
    "PR": "PR (plot relative)",
    "AA": "AA (arc)",
    "AR": "AR (arc)",
    "AT": "AT (arc)",
    "RT": "RT (arc)",
    "CI": "CI (circle)",
    "EA": "EA (rectangle)",
    "ER": "ER (rectangle)",
    "EW": "EW (wedge)",
    "EP": "EP (polygon)",
    "RA": "RA (filled rectangle)",
    "RR": "RR (filled rectangle)",
    "WG": "WG (filled wedge)",
    "FP": "FP (filled polygon)",
    "BZ": "BZ (curve)",
    "BR": "BR (curve)",
    "PE": "PE (encoded polyline)",
    "LB": "LB (label)",
    "BL": "BL (buffered label)",
    "PB": "PB (buffered label)",
}
#: Instructions that change nothing that is read: force, speed, fonts, fills, output to a computer.
_WITHOUT_LINES: Final = (
    "AC AD AP AS BF BP CA CC CF CM CO CS CT CV DC DI DL DP DR DS DV EC EN ES FI FN FS FT GC GM IM "
    "IV KY LA LM LO MC MG MT NP NR OA OC OD OE OF OG OH OI OK OL OO OP OS OT OW PS QL RF RP RQ SA "
    "SB SD SL SR SS ST SV TD TL TR UF UL VA VN VS WD WM"
)
_IGNORED: Final = frozenset(_WITHOUT_LINES.split())
#: Instructions after which a new sheet is in the plotter.
_NEW_SHEET: Final = frozenset(("PG", "AF", "AH", "FR"))
#: Millimetres in one unit of SI.
_LABEL_UNIT: Final = 10.0


class Plot:
    """The lines of a plotter file, with their import report and their texts.

    Parameters
    ----------
    limits
        Limits of the numbers of instructions and segments.
    """

    def __init__(self, limits: Limits) -> None:
        self.report = ReportWriter()
        self.paths = ShapePaths(limits, "HPGL")
        self.annotations: list[Annotation] = []
        self.stated_scale = True  #: whether the file states the length of a unit


def trace(data: bytes, limits: Limits) -> Plot:
    """Return the lines that a plotter draws, in mm, or in user units without a stated length.

    Parameters
    ----------
    data
        Content of the file.
    limits
        Limits of the numbers of instructions and segments, and of the time.

    Raises
    ------
    NotADrawing
        The file is damaged or contains no drawing, or its lines are drawn at several scales that
        depend on the plotter.
    DrawingTooLarge
        A limit is exceeded.
    """
    plotter = _Plotter(limits)
    deadline = time.monotonic() + limits.seconds
    last: Instruction | None = None
    for number, one in enumerate(parse_instructions(data, limits), 1):
        if number > limits.expanded:
            raise DrawingTooLarge("reading.too-many-elements", limit=limits.expanded, format="HPGL")
        if number % _BLOCK == 0 and time.monotonic() > deadline:
            raise DrawingTooLarge("reading.too-slow", format="HPGL", seconds=limits.seconds)
        plotter.execute(number, one)
        last = one
    report = plotter.plot.report
    if not report.handle:
        raise NotADrawing("plt.empty")
    if last is not None and not last.ended and last.values and last.name in _MOVES:
        report.row("end", last.name, "", Message("import.no-end-mark", mark=";"))
    return plotter.plot


class _Plotter:
    """A plotter that executes instructions; ``plot`` contains what it has drawn."""

    def __init__(self, limits: Limits) -> None:
        self.plot = Plot(limits)
        self._limits = limits
        self._pens = Pens()
        self._style = self._pens.style
        self._coordinates = Coordinates()
        self._matrix = self._coordinates.matrix()
        self._clip = UNCLIPPED
        self._at: Point = (0.0, 0.0)  # in the units of coordinates
        self._is_lost = False  # whether the position depends on the font of a label
        self._is_down = False
        self._is_relative = False
        self._polygon = Polygon()
        self._sheet = 1
        self._label_height = 0.0
        self._label = b""  # text of BL
        #: Coordinates of the lines with a scale that depends on the plotter, and whether there are
        #: other lines.
        self._unstated: Coordinates | None = None
        self._has_stated = False
        self._number = 0

    def execute(self, number: int, instruction: Instruction) -> None:
        """Execute an instruction; ``number`` is its number in the file, from 1."""
        self._number = number
        action = _ACTIONS.get(instruction.name)
        if action is not None:
            action(self, instruction)
        elif instruction.name in _NEW_SHEET:
            # Some programs begin a new sheet before the first line.
            self._sheet += bool(self.plot.report.handle)
        elif Pens.handles(instruction.name):
            self._pens.change(instruction)
            self._style = self._pens.style
        elif instruction.name not in _IGNORED:
            self._row(instruction, Message("import.unknown-instruction"))

    # ── State ────────────────────────────────────────────────────────────────────────────────

    def initialise(self, instruction: Instruction) -> None:
        """Execute IN or DF."""
        self._pens.reset()
        self._style = self._pens.style
        self._is_relative = False
        self._clip = UNCLIPPED
        self._label_height = 0.0
        self._polygon = Polygon()
        if instruction.name == "IN":
            self._is_down = False
            self._change_coordinates(Coordinates())
        else:
            kept = self._coordinates
            self._change_coordinates(Coordinates(kept.first, kept.second, (), kept.quarters))

    def change_coordinates(self, instruction: Instruction) -> None:
        """Execute IP, IR, RO or SC."""
        changed = self._coordinates.change(instruction)
        if changed.quarters != self._coordinates.quarters and self._has_lines:
            self._row(instruction, Message("import.turned-page"))
        self._change_coordinates(changed)

    def _change_coordinates(self, changed: Coordinates) -> None:
        """Change the coordinate system; the pen stays where it is."""
        if changed == self._coordinates:
            return
        matrix = changed.matrix()
        if changed.stated_scale and self._coordinates.stated_scale:
            self._at = transform_back(matrix, transform(self._matrix, self._at))
        else:
            self._is_lost = True
        self._coordinates, self._matrix = changed, matrix

    def set_window(self, instruction: Instruction) -> None:
        """Execute IW."""
        self._clip = window(instruction, self._matrix)

    # ── Lines ────────────────────────────────────────────────────────────────────────────────

    def move(self, instruction: Instruction) -> None:
        """Execute PU, PD, PA or PR."""
        if instruction.name in ("PU", "PD"):
            self._is_down = instruction.name == "PD"
        else:
            self._is_relative = instruction.name == "PR"
        if instruction.values:
            if len(instruction.values) % 2:
                raise NotADrawing(
                    "plt.x-without-y",
                    position=instruction.position,
                    name=instruction.name,
                    count=len(instruction.values),
                )
            self._draw(instruction, self._absolute(instruction.values))

    def _absolute(self, values: list[float]) -> list[float]:
        """Return x and y of points that an instruction contains, one after the other."""
        if not self._is_relative:
            return values
        x, y = self._at
        points = [0.0] * len(values)
        points[::2] = list(accumulate(values[::2], initial=x))[1:]
        points[1::2] = list(accumulate(values[1::2], initial=y))[1:]
        return points

    def _draw(self, instruction: Instruction, points: list[float]) -> None:
        """Move the pen to points, whose x and y are one after the other."""
        if self._polygon.starts:
            # The first point after PM1 begins a part of the polygon.
            self._polygon.begin((points[0], points[1]))
            self._at, points = (points[0], points[1]), points[2:]
        if not points:
            return
        if self._is_down:
            self._emit(instruction, PlottedShape(polylines=[[*self._at, *points]]))
        self._at = points[-2], points[-1]
        self._is_lost = self._is_lost and self._is_relative

    def draw_encoded(self, instruction: Instruction) -> None:
        """Execute PE; each pen that it selects has a row in the report."""
        shape = PlottedShape()
        line: list[float] = []
        for point in decode(instruction.text, instruction.position, self._limits):
            if point.pen is not None:
                if line:
                    shape.polylines.append(line)
                    line = []
                self._emit(instruction, shape)
                shape = PlottedShape()
                self._pens.selected = abs(point.pen)
                self._style = self._pens.style
            x, y = self._at
            to = (point.x, point.y) if point.absolute else (x + point.x, y + point.y)
            if point.absolute and not point.down:
                self._is_lost = False
            if self._polygon.starts:
                self._polygon.begin(to)
            elif point.down:
                line += to if line else (x, y, *to)
            elif line:
                shape.polylines.append(line)
                line = []
            self._at, self._is_down = to, point.down
        if line:
            shape.polylines.append(line)
        self._emit(instruction, shape)

    def draw_arc(self, instruction: Instruction) -> None:
        """Execute AA or AR."""
        if len(instruction.values) not in (3, 4):
            raise count_is_wrong(instruction, 3, 4)
        x, y, degrees = instruction.values[:3]
        centre = (x, y) if instruction.name == "AA" else (self._at[0] + x, self._at[1] + y)
        shape = PlottedShape()
        end = shape.add_arc(centre, self._at, degrees)
        self._emit(instruction, shape if self._is_down else PlottedShape())
        self._at = end

    def draw_arc_through(self, instruction: Instruction) -> None:
        """Execute AT or RT."""
        if len(instruction.values) not in (4, 5):
            raise count_is_wrong(instruction, 4, 5)
        x, y = self._at if instruction.name == "RT" else (0.0, 0.0)
        inner = x + instruction.values[0], y + instruction.values[1]
        end = x + instruction.values[2], y + instruction.values[3]
        shape = PlottedShape()
        shape.add_arc_through(self._at, inner, end)
        self._emit(instruction, shape if self._is_down else PlottedShape())
        self._at = end

    def draw_curves(self, instruction: Instruction) -> None:
        """Execute BZ or BR."""
        if not instruction.values or len(instruction.values) % 6:
            raise count_is_wrong(instruction, 6, 12, 18)
        shape = PlottedShape()
        for k in range(0, len(instruction.values), 6):
            x, y = self._at if instruction.name == "BR" else (0.0, 0.0)
            a, b, c, d, e, f = instruction.values[k : k + 6]
            end = x + e, y + f
            shape.curves.append((*self._at, *end, x + a, y + b, x + c, y + d))
            self._at = end
        self._emit(instruction, shape if self._is_down else PlottedShape())

    def draw_circle(self, instruction: Instruction) -> None:
        """Execute CI."""
        if len(instruction.values) not in (1, 2):
            raise count_is_wrong(instruction, 1, 2)
        shape = PlottedShape()
        x, y = self._at
        shape.add_arc(self._at, (x + abs(instruction.values[0]), y), 360.0)
        self._emit(instruction, shape)

    def draw_rectangle(self, instruction: Instruction) -> None:
        """Execute EA, ER, RA or RR."""
        if len(instruction.values) != 2:
            raise count_is_wrong(instruction, 2)
        x, y = self._at if instruction.name in ("ER", "RR") else (0.0, 0.0)
        shape = PlottedShape()
        shape.add_rectangle(self._at, (x + instruction.values[0], y + instruction.values[1]))
        self._polygon_drawn(instruction, shape)

    def draw_wedge(self, instruction: Instruction) -> None:
        """Execute EW or WG."""
        if len(instruction.values) not in (3, 4):
            raise count_is_wrong(instruction, 3, 4)
        shape = PlottedShape()
        shape.add_wedge(self._at, *instruction.values[:3])
        self._polygon_drawn(instruction, shape)

    def _polygon_drawn(self, instruction: Instruction, shape: PlottedShape) -> None:
        """Draw a shape that replaces the polygon, with its edges or filled."""
        self._polygon = Polygon()
        self._polygon.is_lost = self._is_lost
        self._polygon.shape.add(shape)
        self._draw_polygon(instruction)

    def set_polygon_mode(self, instruction: Instruction) -> None:
        """Execute PM."""
        mode = instruction.values[0] if instruction.values else 0.0
        if mode == 0.0:
            self._polygon = Polygon()
            self._polygon.open_at(self._at, is_lost=self._is_lost)
        elif self._polygon.is_open:
            self._at = self._polygon.close_part(self._at)
            if mode == 1.0:
                self._polygon.starts = True
            else:
                # Plotters differ in where the pen is after the last point of a polygon.
                self._polygon.is_open = False
                self._is_lost = True

    def draw_polygon(self, instruction: Instruction) -> None:
        """Execute EP or FP."""
        self._draw_polygon(instruction)

    def _draw_polygon(self, instruction: Instruction) -> None:
        if instruction.name in _FILLS:
            self._row(instruction, Message("import.filled-area"))
        else:
            self._emit(instruction, self._polygon.shape, is_lost=self._polygon.is_lost)

    def _emit(
        self, instruction: Instruction, shape: PlottedShape, *, is_lost: bool | None = None
    ) -> None:
        """Add a shape to the plot, or to the polygon in polygon mode.

        ``is_lost``: whether its position depends on the plotter; None if that of the pen counts.
        """
        if not (shape.polylines or shape.arcs or shape.curves):
            return
        if self._polygon.is_open:
            self._polygon.shape.add(shape)
            return
        lost = self._is_lost if is_lost is None else is_lost
        dropped: Message | None = None
        if self._sheet > 1:
            dropped = Message("import.other-sheet", sheet=self._sheet)
        elif self._pens.selected == 0:
            dropped = Message("import.no-pen")
        elif lost:
            dropped = Message("import.unknown-position")
        row = self._row(instruction, dropped)
        if dropped is None:
            self._check_scale()
            self.plot.paths.add(row, self._style, self._matrix, shape, self._clip)
        elif not lost:
            self._set_location(row, shape)

    def _set_location(self, row: int, shape: PlottedShape) -> None:
        """Record where a shape is that is left out: the box of the ends of its lines and arcs."""
        points = [
            end for line in shape.polylines for end in zip(line[::2], line[1::2], strict=True)
        ]
        for numbers in (*shape.arcs, *shape.curves):
            points += [(numbers[0], numbers[1]), (numbers[2], numbers[3])]
        across, up = zip(*(transform(self._matrix, point) for point in points), strict=True)
        self.plot.report.set_location(row, (min(across), min(up), max(across), max(up)))

    @property
    def _has_lines(self) -> bool:
        """Whether a line was drawn."""
        return self._has_stated or self._unstated is not None

    def _check_scale(self) -> None:
        """Raise NotADrawing if lines have several scales, one of which depends on the plotter."""
        if self._coordinates.stated_scale:
            self._has_stated = True
        elif self._unstated is None:
            self._unstated = self._coordinates
        mixed = self._unstated is not None and (
            self._has_stated or self._unstated != self._coordinates
        )
        if mixed:
            raise NotADrawing("plt.several-scales")
        self.plot.stated_scale = self._has_stated

    # ── Texts and instructions that are not read ─────────────────────────────────────────────

    def draw_label(self, instruction: Instruction) -> None:
        """Execute LB or PB."""
        content = instruction.text if instruction.name == "LB" else self._label
        if not content:
            return
        row = self._row(instruction, Message("import.text"))
        if not self._is_lost:
            x, y = transform(self._matrix, self._at)
            self.plot.report.set_location(row, (x, y, x, y))
            if math.isfinite(x) and math.isfinite(y):
                text = content.decode("latin-1").strip()
                height = self._label_height
                layer = self._pens.layer
                self.plot.annotations.append(Annotation(text, x, y, height, math.nan, "LB", layer))
        self._is_lost = True

    def keep_label(self, instruction: Instruction) -> None:
        """Execute BL."""
        self._label = instruction.text

    def set_label_size(self, instruction: Instruction) -> None:
        """Execute SI."""
        self._label_height = (
            abs(instruction.values[1]) * _LABEL_UNIT if len(instruction.values) == 2 else 0.0
        )

    def move_by_characters(self, _one: Instruction) -> None:
        """Execute CP."""
        self._is_lost = True

    def mark(self, instruction: Instruction) -> None:
        """Execute an instruction that draws marks, which are not read: SM, UC, XT or YT."""
        if instruction.name != "SM" or instruction.text:
            self._row(instruction, Message("import.plotter-marks"))

    def _row(self, instruction: Instruction, dropped: Message | None = None) -> int:
        """Add a row to the import report, and return its index."""
        report = self.plot.report
        if len(report.handle) >= self._limits.entities:
            raise DrawingTooLarge(
                "reading.too-many-elements", limit=self._limits.entities, format="HPGL"
            )
        handle = f"#{self._number}"
        if report.handle and report.handle[-1].partition(".")[0] == handle:
            # PE draws with several pens.
            handle = f"{handle}.{len(report.handle)}"
        return report.row(
            handle, _NAMES.get(instruction.name, instruction.name), self._pens.layer, dropped
        )


_Action = Callable[[_Plotter, Instruction], None]
#: Instructions that move the pen or draw from its position.
_MOVES: Final = frozenset(("PU", "PD", "PA", "PR", "AA", "AR", "AT", "RT", "BZ", "BR", "CI"))
_FILLS: Final = frozenset(("RA", "RR", "WG", "FP"))
_ACTIONS: Final[dict[str, _Action]] = {
    **dict.fromkeys(("IN", "DF"), _Plotter.initialise),
    **dict.fromkeys(("IP", "IR", "RO", "SC"), _Plotter.change_coordinates),
    "IW": _Plotter.set_window,
    **dict.fromkeys(("PU", "PD", "PA", "PR"), _Plotter.move),
    "PE": _Plotter.draw_encoded,
    **dict.fromkeys(("AA", "AR"), _Plotter.draw_arc),
    **dict.fromkeys(("AT", "RT"), _Plotter.draw_arc_through),
    **dict.fromkeys(("BZ", "BR"), _Plotter.draw_curves),
    "CI": _Plotter.draw_circle,
    **dict.fromkeys(("EA", "ER", "RA", "RR"), _Plotter.draw_rectangle),
    **dict.fromkeys(("EW", "WG"), _Plotter.draw_wedge),
    "PM": _Plotter.set_polygon_mode,
    **dict.fromkeys(("EP", "FP"), _Plotter.draw_polygon),
    **dict.fromkeys(("LB", "PB"), _Plotter.draw_label),
    "BL": _Plotter.keep_label,
    "SI": _Plotter.set_label_size,
    "CP": _Plotter.move_by_characters,
    **dict.fromkeys(("SM", "UC", "XT", "YT"), _Plotter.mark),
}
