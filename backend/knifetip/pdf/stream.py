"""stream: interpret the operators of a content stream, and add its paths and texts to the page.

A content stream is the sequence of drawing commands of a PDF page or form.  Only the part of the
graphics state that determines position and style of lines is tracked.

Source: ISO 32000-1, chapters 8 and 9.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, Final, NamedTuple

from pypdf.generic import DictionaryObject, IndirectObject, StreamObject

from knifetip.drawing_builder.clip import UNCLIPPED, Box, Clip, Region, intersect
from knifetip.drawing_builder.colours import UNKNOWN_COLOUR, VISIBLE
from knifetip.drawing_builder.filled_region import filled_region
from knifetip.errors import DrawingTooLarge
from knifetip.geometry.affine import Matrix, compose
from knifetip.messages import Message
from knifetip.model.drawing import Annotation
from knifetip.pdf.colours import BLACK, CMYK, GRAY, PATTERN, RGB, ColourSpace, Paint
from knifetip.pdf.content import Name, parse_operations
from knifetip.pdf.document import PdfFile, number
from knifetip.pdf.layers import Layers
from knifetip.pdf.page_lines import LayerMark, LineStyle, PageLines
from knifetip.pdf.path_builder import BUILDERS
from knifetip.pdf.resources import Resources
from knifetip.pdf.text import OPERATORS, TextObject

#: Operators that paint a path: whether they close it first, stroke it, fill it.
_PAINTS: Final = {
    "S": (False, True, False),
    "s": (True, True, False),
    "f": (False, False, True),
    "F": (False, False, True),
    "f*": (False, False, True),
    "B": (False, True, True),
    "B*": (False, True, True),
    "b": (True, True, True),
    "b*": (True, True, True),
    "n": (False, False, False),
}
#: Operators that do not change the position or style of lines.
_IGNORED: Final = frozenset(
    (*("J", "j", "M", "ri", "i", "MP", "DP", "BX", "EX"), *("Tc", "Tw", "Tz", "Tr", "Ts"))
)
_DEVICE: Final = {"g": GRAY, "rg": RGB, "k": CMYK}
#: Deepest stack of graphics states and of layers; drawing programs stay below 100.
_MAX_STACK: Final = 100_000
#: Largest number of unknown operators in the import report.
_MAX_UNKNOWN: Final = 20
_INVALID: Final[Matrix] = (math.nan, math.nan, math.nan, math.nan, math.nan, math.nan)
#: A clip path that ends this close to the border of the page shows the whole page (points).
_BORDER: Final = 0.05
#: The corners of an image, in its own coordinates.
_UNIT_SQUARE: Final = ((0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0))


class State(NamedTuple):
    """The part of the graphics state that determines position and style of lines."""

    matrix: Matrix
    clip: Clip = UNCLIPPED
    stroke: Paint = BLACK
    fill: Paint = BLACK
    stroke_space: ColourSpace = GRAY
    fill_space: ColourSpace = GRAY
    stroke_seen: bool = True
    fill_seen: bool = True
    dashed: bool = False
    masked: bool = False  #: whether a soft mask hides parts of objects
    transparent: bool = False  #: whether a transparent group contains the objects
    line_width: float = 1.0  #: in coordinates of the matrix, 0 for the thinnest line


class StreamContext(NamedTuple):
    """The properties that a content stream inherits from the streams that contain it."""

    path: str  #: names of the containing forms, each followed by a slash
    containing_forms: tuple[
        object, ...
    ]  #: ids of the containing forms, which must not be copied again
    mark: LayerMark
    resources: DictionaryObject


@dataclass(slots=True)
class PageContext:
    """The objects that are common to all content streams of a page."""

    file: PdfFile
    drawn: PageLines
    layers: Layers
    resources: Resources
    visible: Box  #: visible area of the displayed page
    unknown: set[str]  #: unknown operators
    form: Callable[[StreamObject, State, StreamContext], None]  #: interprets a form
    clip_edges: int = 0  #: number of edges of all clip paths
    operators: int = 0  #: number of operators of the streams that were interpreted

    def clip(self, clip: Clip, region: Region) -> Clip:
        """Return the part of a clip in a region; a region that shows the whole page is ignored."""
        low_x, low_y, high_x, high_y = region.box
        left, bottom, right, top = self.visible
        if (
            region.is_rectangle
            and low_x <= left + _BORDER
            and low_y <= bottom + _BORDER
            and high_x >= right - _BORDER
            and high_y >= top - _BORDER
        ):
            return clip
        # The edges of all regions are limited, because a file may repeat a clip path in each form.
        self.clip_edges += len(region.edges)
        if self.clip_edges > self.file.limits.segments:
            return clip.intersect_box(region.box)._replace(incomplete=True)
        return clip.intersect(region)


class Stream:
    """Interprets one content stream: the sequence of drawing commands of a PDF page or form."""

    def __init__(self, page: PageContext, state: State, context: StreamContext) -> None:
        self._page = page
        self._state = state
        # Many files set the line width before each path, so it is kept beside the state, which is
        # a tuple and copied for each change.  ``_state.line_width`` is the initial width.
        self._line_width = state.line_width
        self._context = context
        self._stack: list[tuple[State, float]] = []
        self._marks: list[LayerMark] = [context.mark]
        self._text_object = TextObject()
        self._clip_rule = ""  # the operator W or W* that makes the current path a clip path

    def interpret(self, data: bytes) -> None:
        """Interpret all operators of the content stream ``data``.

        Raises
        ------
        DrawingTooLarge
            The content streams of the page have too many operators.
        """
        page, path = self._page, self._page.drawn.path
        limit = page.file.limits.operators
        for operator, operands in parse_operations(data):
            page.operators += 1
            if page.operators > limit:
                raise DrawingTooLarge("reading.too-many-elements", limit=limit, format="PDF")
            if operator in BUILDERS:
                path.add(operator, operands)
            elif operator in _PAINTS:
                self._paint_path(*_PAINTS[operator])
            elif (handler := _HANDLERS.get(operator)) is not None:
                handler(self, operator, operands)
            elif operator not in _IGNORED:
                self._unknown(operator)
        if path.started:
            self._drop_path(Message("import.page-ends-early"))

    def _row(self, kind: str, reason: Message | None, points: Sequence[Any] = ()) -> int:
        """Add a row for an object to the import report and return the index of the row.

        ``kind``: type of the object, for example "path" or "image".
        ``reason``: reason why the object is dropped, None if it is kept.  If the object is on a
        hidden layer, the hidden layer is the reason instead.
        ``points``: positions (x, y) whose bounding box is the location of the object, before the
        current transformation matrix is applied.  If empty, no location is reported.
        """
        mark, lines = self._marks[-1], self._page.drawn
        reason = Message("import.hidden-layer", layer=mark.hidden) if mark.hidden else reason
        row = lines.row(self._context.path, kind, mark, reason)
        if points:
            lines.report.set_location(row, transformed_box(self._state.matrix, points))
        return row

    def _drop_path(self, reason: Message | None) -> None:
        """Drop the current path and add a row for it to the import report.

        ``reason`` is the reason for dropping the path.  It may be None if the path is on a hidden
        layer; the hidden layer is then the reason.
        """
        path = self._page.drawn.path
        self._row("path", reason, [] if path.wrong else path.ends().tolist())
        path.drop()

    def _paint_path(self, closes: bool, strokes: bool, fills: bool) -> None:
        """End the current path: add it to the page if it is visible, else drop it with a reason.

        If the path is a clipping path, it also limits the visible area of later paths.

        ``closes``, ``strokes``, ``fills``: whether the operator that ends the path closes, strokes
        or fills it.
        """
        self._page.file.check_time()
        path = self._page.drawn.path
        if closes:
            path.add("h", [])
        clips, self._clip_rule = self._clip_rule, ""
        if not (path.started or strokes or fills or clips):
            return
        state = self._state
        if path.wrong:
            self._drop_path(Message("import.bad-operands", operator=path.wrong))
            return
        stroked = strokes and state.stroke_seen and state.stroke.drawn and not state.transparent
        filled = fills and state.fill_seen and state.fill.drawn and not state.transparent
        reason: Message | None = None
        if not strokes and not fills:
            reason = Message("import.clip-path" if clips else "import.no-paint")
        elif not stroked and not filled:
            reason = Message("import.not-visible")
        elif not path.size:
            reason = Message("import.empty-path")
        if clips:
            self._state = state._replace(clip=self._clip_to_path(even_odd=clips == "W*"))
        mark = self._marks[-1]
        if reason or mark.hidden:
            self._drop_path(reason)
            return
        row = self._row("path", None)
        style = LineStyle(
            mark.layer,
            state.stroke if stroked else state.fill,
            state.dashed and stroked,
        )
        self._page.drawn.line(
            row,
            state.matrix,
            state.clip._replace(incomplete=True) if state.masked else state.clip,
            style,
            _colour(state.stroke) if stroked else None,
            _colour(state.fill) if filled else None,
            self._line_width if stroked else -1.0,
        )

    def _clip(self, operator: str, _operands: list[Any]) -> None:
        self._clip_rule = operator

    def _clip_to_path(self, *, even_odd: bool) -> Clip:
        """Return the part of the visible area that lies inside the current path.

        A clip path that shows the whole page is ignored: objects that cross the border of the page
        are kept.  ``even_odd`` is the rule by which the path is filled.
        """
        path, state = self._page.drawn.path, self._state
        region = filled_region(path.table(), state.matrix, even_odd=even_odd)
        return self._page.clip(state.clip, region)

    def _unknown(self, operator: str) -> None:
        unknown = self._page.unknown
        if operator not in unknown and len(unknown) < _MAX_UNKNOWN:
            unknown.add(operator)
            self._row("operator", Message("import.unknown-operator", operator=operator[:20]))

    # ── The graphics state ────────────────────────────────────────────────────────────────────

    def _save(self, _operator: str, _operands: list[Any]) -> None:
        self._stack.append((self._state, self._line_width))
        if len(self._stack) > _MAX_STACK:
            raise DrawingTooLarge("pdf.too-many-states", limit=_MAX_STACK)

    def _restore(self, _operator: str, _operands: list[Any]) -> None:
        if self._stack:
            self._state, self._line_width = self._stack.pop()

    def _concatenate(self, _operator: str, operands: list[Any]) -> None:
        numbers = tuple(one for one in operands if isinstance(one, float))
        # After an invalid matrix the position of all that follows is unknown.
        inner = numbers if len(numbers) == 6 == len(operands) else _INVALID
        self._state = self._state._replace(matrix=compose(self._state.matrix, inner))

    def _set_line_width(self, _operator: str, operands: list[Any]) -> None:
        width = operands[-1] if operands else None
        if isinstance(width, float) and width >= 0.0:
            self._line_width = width

    def _set_dash(self, _operator: str, operands: list[Any]) -> None:
        dashes = operands[0] if operands and isinstance(operands[0], list) else []
        dashed = any(isinstance(one, float) and one > 0.0 for one in dashes)
        self._state = self._state._replace(dashed=dashed)

    def _set_state(self, _operator: str, operands: list[Any]) -> None:
        """Apply opacity, mask, line width and dashes of a graphics state dictionary.

        ``operands`` contains the name of the dictionary.
        """
        file = self._page.file
        name = operands[-1] if operands else ""
        node = file.resolve(
            self._page.resources.find(self._context.resources, "/ExtGState", str(name))
        )
        if (alpha := file.entry(node, "/CA")) is not None:
            self._state = self._state._replace(stroke_seen=not number(alpha) < VISIBLE)
        if (alpha := file.entry(node, "/ca")) is not None:
            self._state = self._state._replace(fill_seen=not number(alpha) < VISIBLE)
        if (mask := file.entry(node, "/SMask")) is not None:
            self._state = self._state._replace(masked=isinstance(mask, DictionaryObject))
        if (width := file.entry(node, "/LW")) is not None:
            self._set_line_width("w", [number(width)])
        if dash := file.array(node, "/D"):
            dashes = [number(file.resolve(one)) for one in file.resolve(dash[0]) or []]
            self._set_dash("d", [dashes])

    # ── Colours ───────────────────────────────────────────────────────────────────────────────

    def _set_space(self, operator: str, operands: list[Any]) -> None:
        space = self._page.resources.space(
            self._context.resources, str(operands[-1]) if operands else ""
        )
        full = space.kind in ("Separation", "DeviceN")
        paint = self._page.resources.paint(space, (1.0,) * space.components) if full else BLACK
        self._set_colour(operator.isupper(), space, paint)

    def _set_components(self, operator: str, operands: list[Any]) -> None:
        strokes = operator.isupper()
        space = self._state.stroke_space if strokes else self._state.fill_space
        if operands and isinstance(operands[-1], Name):
            self._set_colour(strokes, space, PATTERN)
            return
        numbers = tuple(one for one in operands if isinstance(one, float))
        self._set_colour(strokes, space, self._page.resources.paint(space, numbers))

    def _set_device_colour(self, operator: str, operands: list[Any]) -> None:
        space = _DEVICE[operator.lower()]
        numbers = tuple(one for one in operands if isinstance(one, float))
        self._set_colour(operator.isupper(), space, self._page.resources.paint(space, numbers))

    def _set_colour(self, strokes: bool, space: ColourSpace, paint: Paint) -> None:
        self._state = (
            self._state._replace(stroke_space=space, stroke=paint)
            if strokes
            else self._state._replace(fill_space=space, fill=paint)
        )

    # ── Layers ────────────────────────────────────────────────────────────────────────────────

    def _begin_marked(self, operator: str, operands: list[Any]) -> None:
        mark = self._marks[-1]
        if operator == "BDC" and len(operands) == 2 and operands[0] == "OC":
            name = str(operands[1])
            mark = self._nested_mark(
                mark, self._page.resources.find(self._context.resources, "/Properties", name)
            )
        self._marks.append(mark)
        if len(self._marks) > _MAX_STACK:
            raise DrawingTooLarge("pdf.layers-too-deep", limit=_MAX_STACK)

    def _nested_mark(self, mark: LayerMark, definition: object) -> LayerMark:
        """Return the layer mark of objects on a layer that is nested in another layer.

        The objects are hidden if one of the two layers is hidden.

        ``definition``: PDF object that defines the inner layer, None for no inner layer.
        """
        if definition is None:
            return mark
        layer = self._page.layers.layer(definition)
        name = layer.name or mark.layer
        return LayerMark(name, mark.hidden or ("" if layer.visible else name or "without a name"))

    def _end_marked(self, _operator: str, _operands: list[Any]) -> None:
        if len(self._marks) > 1:
            self._marks.pop()

    # ── Forms, images, texts ────────────────────────────────────────────────────────────────

    def _draw_object(self, _operator: str, operands: list[Any]) -> None:
        """Interpret the form or image that the operator ``Do`` draws.

        An image is added to the import report as dropped, because it is not cut.  ``operands``
        contains the name of the form or image.
        """
        page, context = self._page, self._context
        page.file.check_time()
        name = str(operands[-1]) if operands else ""
        raw = page.resources.find(context.resources, "/XObject", name)
        node = page.file.resolve(raw)
        if page.drawn.path.started:
            self._drop_path(Message("import.interrupted-path"))
        mark = self._marks[-1]
        if isinstance(node, DictionaryObject) and "/OC" in node:
            mark = self._nested_mark(mark, node.raw_get("/OC"))
        self._marks.append(mark)
        kind = page.file.entry(node, "/Subtype")
        if kind == "/Image":
            self._row("image", Message("import.image"), _UNIT_SQUARE)
        elif kind != "/Form" or not isinstance(node, StreamObject):
            reason = Message("import.nothing-named", name=name[:40])
            self._row("form", reason, _UNIT_SQUARE[:1])
        else:
            key = (raw.idnum, raw.generation) if isinstance(raw, IndirectObject) else id(node)
            if key in context.containing_forms:
                self._row("form", Message("import.contains-itself"))
            elif len(context.containing_forms) >= page.file.limits.insert_depth:
                raise DrawingTooLarge(
                    "reading.nested-too-deep", limit=page.file.limits.insert_depth, format="PDF"
                )
            else:
                inner = StreamContext(
                    f"{context.path}{name}/",
                    (*context.containing_forms, key),
                    mark,
                    context.resources,
                )
                page.form(node, self._inner_state(node), inner)
        self._marks.pop()

    def _inner_state(self, form: StreamObject) -> State:
        """Return the graphics state at the start of a form.

        The opacity of fills applies to a transparency group as a whole, not to its content.
        """
        state = self._state._replace(line_width=self._line_width)
        if self._page.file.entry(form, "/Group") is None:
            return state
        return state._replace(
            transparent=state.transparent or not state.fill_seen, fill_seen=True, stroke_seen=True
        )

    def _inline_image(self, _operator: str, _operands: list[Any]) -> None:
        self._row("image", Message("import.image"), _UNIT_SQUARE)

    def _shade(self, _operator: str, _operands: list[Any]) -> None:
        row = self._row("shading", Message("import.shading"))
        box = intersect(self._state.clip.box, self._page.visible)
        self._page.drawn.report.set_location(row, box)

    def _text(self, operator: str, _operands: list[Any]) -> None:
        if operator == "BT":
            self._text_object.begin()
            return
        if self._text_object.empty:
            return
        placed = self._text_object.placed_text(self._state.matrix)
        if placed is None:
            reason = Message("import.text-unknown-letters")
            self._row("text", reason, self._text_object.begins)
            return
        row = self._row("text", Message("import.text"), self._text_object.begins)
        mark = self._marks[-1]
        if not mark.hidden:
            layer = self._page.drawn.report.layer[row]
            self._page.drawn.annotations.append(Annotation(*placed, math.nan, "text", layer))

    def _operate_text(self, operator: str, operands: list[Any]) -> None:
        self._text_object.operate(operator, operands)

    def _font(self, _operator: str, operands: list[Any]) -> None:
        if len(operands) == 2 and isinstance(operands[1], float):
            self._text_object.font = self._page.resources.font(
                self._context.resources, str(operands[0])
            )
            self._text_object.size = operands[1]


_HANDLERS: Final[dict[str, Callable[[Stream, str, list[Any]], None]]] = {
    "q": Stream._save,
    "Q": Stream._restore,
    "cm": Stream._concatenate,
    "w": Stream._set_line_width,
    "d": Stream._set_dash,
    "gs": Stream._set_state,
    "W": Stream._clip,
    "W*": Stream._clip,
    **dict.fromkeys(("CS", "cs"), Stream._set_space),
    **dict.fromkeys(("SC", "SCN", "sc", "scn"), Stream._set_components),
    **dict.fromkeys(("G", "g", "RG", "rg", "K", "k"), Stream._set_device_colour),
    **dict.fromkeys(("BMC", "BDC"), Stream._begin_marked),
    "EMC": Stream._end_marked,
    "Do": Stream._draw_object,
    "BI": Stream._inline_image,
    "sh": Stream._shade,
    **dict.fromkeys(("BT", "ET"), Stream._text),
    **dict.fromkeys(OPERATORS, Stream._operate_text),
    "Tf": Stream._font,
}


def _colour(paint: Paint) -> int:
    """Return the colour of a paint; an ink has no colour that can be compared with the page."""
    return UNKNOWN_COLOUR if paint.spot else paint.colour


def transformed_box(matrix: Matrix, points: Sequence[Any]) -> Box:
    """Return min x, min y, max x and max y of points after a transformation by ``matrix``."""
    a, b, c, d, e, f = matrix
    x = [a * x + c * y + e for x, y in points]
    y = [b * x + d * y + f for x, y in points]
    return min(x), min(y), max(x), max(y)
