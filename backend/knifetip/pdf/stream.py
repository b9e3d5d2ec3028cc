"""stream: one content stream, operator by operator.

    operators, State, what is around -> rows and lines in Drawn

Of the graphics state, what says where lines are and what they are drawn with is followed.

Source: ISO 32000-1, chapters 8 and 9.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, Final, NamedTuple

from pypdf.generic import DictionaryObject, IndirectObject, StreamObject

from knifetip.errors import DrawingTooLarge
from knifetip.geometry.affine import Matrix, chained
from knifetip.model.drawing import Inscription
from knifetip.pdf.colours import BLACK, CMYK, GRAY, PATTERN, RGB, Paint, Space
from knifetip.pdf.content import Name, operations
from knifetip.pdf.document import Box, File, number
from knifetip.pdf.drawn import Drawn, Look, Mark
from knifetip.pdf.layers import Layers
from knifetip.pdf.outline import BUILDS
from knifetip.pdf.resources import Named
from knifetip.pdf.text import OPERATORS, Words

#: What paints a path: whether it closes it first, strokes it, fills it.
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
#: Operators that change nothing of where a line is or what it is.
_PASSED: Final = frozenset(
    (*("w", "J", "j", "M", "ri", "i", "MP", "DP", "BX", "EX"), *("Tc", "Tw", "Tz", "Tr", "Ts"))
)
_DEVICE: Final = {"g": GRAY, "rg": RGB, "k": CMYK}
#: States that are kept at once, and marks; drawing programs keep below 100.
_KEPT: Final = 100_000
#: Unknown operators that get a row.
_STRANGE: Final = 20
_NOWHERE: Final[Matrix] = (math.nan, math.nan, math.nan, math.nan, math.nan, math.nan)
#: A picture fills the square of its own coordinates.
_PICTURE: Final = ((0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0))
_NOTHING: Final[Box] = (math.inf, math.inf, -math.inf, -math.inf)


class State(NamedTuple):
    """The graphics state, as far as it says where lines are and what they are drawn with."""

    matrix: Matrix
    clip: Box
    stroke: Paint = BLACK
    fill: Paint = BLACK
    stroke_space: Space = GRAY
    fill_space: Space = GRAY
    stroke_seen: bool = True
    fill_seen: bool = True
    dashed: bool = False


class Around(NamedTuple):
    """What a content stream has from those around it."""

    path: str  #: names of the forms around, each with a slash behind it
    inside: tuple[object, ...]  #: which forms they are: what a form may not repeat
    mark: Mark
    resources: DictionaryObject


@dataclass(frozen=True, slots=True)
class Here:
    """What all content streams of a page share."""

    file: File
    drawn: Drawn
    layers: Layers
    named: Named
    strange: set[str]  #: operators that nobody knows
    form: Callable[[StreamObject, State, Around], None]  #: follows a form


class Stream:
    """One content stream while it is followed."""

    def __init__(self, here: Here, state: State, around: Around) -> None:
        self._here = here
        self._state = state
        self._around = around
        self._stack: list[State] = []
        self._marks: list[Mark] = [around.mark]
        self._words = Words()
        self._clips = False

    def follow(self, data: bytes) -> None:
        outline = self._here.drawn.outline
        for operator, given in operations(data):
            if operator in BUILDS:
                outline.add(operator, given)
            elif operator in _PAINTS:
                self._painted(*_PAINTS[operator])
            elif (does := _DOES.get(operator)) is not None:
                does(self, operator, given)
            elif operator not in _PASSED:
                self._unknown(operator)
        if outline.begun:
            self._left("the page ends before it is drawn")

    def _row(self, kind: str, why: str, points: Sequence[Any] = ()) -> int:
        """Enter something into the ledger; ``points`` say where it is that is left out."""
        mark, drawn = self._marks[-1], self._here.drawn
        why = f"it is hidden: the layer {mark.hidden} is switched off" if mark.hidden else why
        row = drawn.row(self._around.path, kind, mark, why)
        if points:
            drawn.sheet.set_location(row, boxed(self._state.matrix, points))
        return row

    def _left(self, why: str) -> None:
        outline = self._here.drawn.outline
        self._row("path", why, [] if outline.wrong else outline.ends().tolist())
        outline.drop()

    def _painted(self, closes: bool, strokes: bool, fills: bool) -> None:
        """Keep a path, or enter into the ledger why it is left out."""
        self._here.file.in_time()
        outline, state = self._here.drawn.outline, self._state
        if closes:
            outline.add("h", [])
        clips, self._clips = self._clips, False
        if not (outline.begun or strokes or fills or clips):
            return
        if outline.wrong:
            self._left(f"its numbers for {outline.wrong!r} cannot be read")
            return
        stroked = strokes and state.stroke_seen and state.stroke.drawn
        filled = fills and state.fill_seen and state.fill.drawn
        why = ""
        if not strokes and not fills:
            why = "it only bounds what is shown of others" if clips else "it is not drawn"
        elif not stroked and not filled:
            why = "nothing of it is seen"
        elif not outline.size:
            why = "its path is empty"
        if clips:
            around = boxed(state.matrix, outline.ends().tolist())
            self._state = state._replace(clip=within(state.clip, around))
        mark = self._marks[-1]
        if why or mark.hidden:
            self._left(why)
            return
        row = self._row("path", "")
        look = Look(
            mark.layer,
            state.stroke if stroked else state.fill,
            state.dashed and stroked,
        )
        self._here.drawn.line(row, state.matrix, state.clip, look, area=not stroked)

    def _clip(self, _operator: str, _given: list[Any]) -> None:
        self._clips = True

    def _unknown(self, operator: str) -> None:
        strange = self._here.strange
        if operator not in strange and len(strange) < _STRANGE:
            strange.add(operator)
            self._row("operator", f"{operator[:20]!r} is no operator that is known")

    # ── The graphics state ────────────────────────────────────────────────────────────────────

    def _saved(self, _operator: str, _given: list[Any]) -> None:
        self._stack.append(self._state)
        if len(self._stack) > _KEPT:
            raise DrawingTooLarge("pdf.too-many-states", limit=_KEPT)

    def _restored(self, _operator: str, _given: list[Any]) -> None:
        if self._stack:
            self._state = self._stack.pop()

    def _moved(self, _operator: str, given: list[Any]) -> None:
        numbers = tuple(one for one in given if isinstance(one, float))
        # Where the matrix cannot be read, nobody knows where what follows is.
        inner = numbers if len(numbers) == 6 == len(given) else _NOWHERE
        self._state = self._state._replace(matrix=chained(self._state.matrix, inner))

    def _dashed(self, _operator: str, given: list[Any]) -> None:
        dashes = given[0] if given and isinstance(given[0], list) else []
        dashed = any(isinstance(one, float) and one > 0.0 for one in dashes)
        self._state = self._state._replace(dashed=dashed)

    def _looked(self, _operator: str, given: list[Any]) -> None:
        """Take over what a dictionary of the graphics state says."""
        file = self._here.file
        name = given[-1] if given else ""
        node = file.seen(self._here.named.resource(self._around.resources, "/ExtGState", str(name)))
        if (alpha := file.entry(node, "/CA")) is not None:
            self._state = self._state._replace(stroke_seen=not number(alpha) <= 0.0)
        if (alpha := file.entry(node, "/ca")) is not None:
            self._state = self._state._replace(fill_seen=not number(alpha) <= 0.0)
        if dash := file.array(node, "/D"):
            dashes = [number(file.seen(one)) for one in file.seen(dash[0]) or []]
            self._dashed("d", [dashes])

    # ── Colours ───────────────────────────────────────────────────────────────────────────────

    def _in_space(self, operator: str, given: list[Any]) -> None:
        where = self._here.named.space(self._around.resources, str(given[-1]) if given else "")
        full = where.kind in ("Separation", "DeviceN")
        found = self._here.named.paint(where, (1.0,) * where.components) if full else BLACK
        self._coloured(operator.isupper(), where, found)

    def _mixed(self, operator: str, given: list[Any]) -> None:
        strokes = operator.isupper()
        where = self._state.stroke_space if strokes else self._state.fill_space
        if given and isinstance(given[-1], Name):
            self._coloured(strokes, where, PATTERN)
            return
        numbers = tuple(one for one in given if isinstance(one, float))
        self._coloured(strokes, where, self._here.named.paint(where, numbers))

    def _device(self, operator: str, given: list[Any]) -> None:
        where = _DEVICE[operator.lower()]
        numbers = tuple(one for one in given if isinstance(one, float))
        self._coloured(operator.isupper(), where, self._here.named.paint(where, numbers))

    def _coloured(self, strokes: bool, where: Space, found: Paint) -> None:
        self._state = (
            self._state._replace(stroke_space=where, stroke=found)
            if strokes
            else self._state._replace(fill_space=where, fill=found)
        )

    # ── Layers ────────────────────────────────────────────────────────────────────────────────

    def _marked(self, operator: str, given: list[Any]) -> None:
        mark = self._marks[-1]
        if operator == "BDC" and len(given) == 2 and given[0] == "OC":
            name = str(given[1])
            mark = self._on(
                mark, self._here.named.resource(self._around.resources, "/Properties", name)
            )
        self._marks.append(mark)
        if len(self._marks) > _KEPT:
            raise DrawingTooLarge("pdf.layers-too-deep", limit=_KEPT)

    def _on(self, mark: Mark, given: object) -> Mark:
        """Return what lies on a layer that lies on another."""
        if given is None:
            return mark
        layer = self._here.layers.layer(given)
        name = layer.name or mark.layer
        return Mark(name, mark.hidden or ("" if layer.shown else name or "without a name"))

    def _unmarked(self, _operator: str, _given: list[Any]) -> None:
        if len(self._marks) > 1:
            self._marks.pop()

    # ── Forms, pictures, texts ────────────────────────────────────────────────────────────────

    def _placed(self, _operator: str, given: list[Any]) -> None:
        """Draw a form where it stands; of a picture, say that it is not cut."""
        here, around = self._here, self._around
        here.file.in_time()
        name = str(given[-1]) if given else ""
        raw = here.named.resource(around.resources, "/XObject", name)
        node = here.file.seen(raw)
        if here.drawn.outline.begun:
            self._left("something else begins before it is drawn")
        mark = self._marks[-1]
        if isinstance(node, DictionaryObject) and "/OC" in node:
            mark = self._on(mark, node.raw_get("/OC"))
        self._marks.append(mark)
        kind = here.file.entry(node, "/Subtype")
        if kind == "/Image":
            self._row("image", "a picture is not cut", _PICTURE)
        elif kind != "/Form" or not isinstance(node, StreamObject):
            why = f"there is nothing with the name {name[:40]!r} that can be drawn"
            self._row("form", why, _PICTURE[:1])
        else:
            key = (raw.idnum, raw.generation) if isinstance(raw, IndirectObject) else id(node)
            if key in around.inside:
                self._row("form", "it contains itself")
            elif len(around.inside) >= here.file.limits.insert_depth:
                raise DrawingTooLarge(
                    "reading.nested-too-deep", limit=here.file.limits.insert_depth, format="PDF"
                )
            else:
                inner = Around(
                    f"{around.path}{name}/", (*around.inside, key), mark, around.resources
                )
                here.form(node, self._state, inner)
        self._marks.pop()

    def _pictured(self, _operator: str, _given: list[Any]) -> None:
        self._row("image", "a picture is not cut", _PICTURE)

    def _shaded(self, _operator: str, _given: list[Any]) -> None:
        row = self._row("shading", "an area of colour is not cut")
        self._here.drawn.sheet.set_location(row, self._state.clip)

    def _text(self, operator: str, _given: list[Any]) -> None:
        if operator == "BT":
            self._words.begin()
            return
        if self._words.silent:
            return
        said = self._words.said(self._state.matrix)
        if said is None:
            why = "text is not cut, and its letters are not known"
            self._row("text", why, self._words.begins)
            return
        row = self._row("text", "text is not cut", self._words.begins)
        mark = self._marks[-1]
        if not mark.hidden:
            layer = self._here.drawn.sheet.layer[row]
            self._here.drawn.inscriptions.append(Inscription(*said, math.nan, "text", layer))

    def _said(self, operator: str, given: list[Any]) -> None:
        self._words.operate(operator, given)

    def _font(self, _operator: str, given: list[Any]) -> None:
        if len(given) == 2 and isinstance(given[1], float):
            self._words.font = self._here.named.font(self._around.resources, str(given[0]))
            self._words.size = given[1]


_DOES: Final[dict[str, Callable[[Stream, str, list[Any]], None]]] = {
    "q": Stream._saved,
    "Q": Stream._restored,
    "cm": Stream._moved,
    "d": Stream._dashed,
    "gs": Stream._looked,
    "W": Stream._clip,
    "W*": Stream._clip,
    **dict.fromkeys(("CS", "cs"), Stream._in_space),
    **dict.fromkeys(("SC", "SCN", "sc", "scn"), Stream._mixed),
    **dict.fromkeys(("G", "g", "RG", "rg", "K", "k"), Stream._device),
    **dict.fromkeys(("BMC", "BDC"), Stream._marked),
    "EMC": Stream._unmarked,
    "Do": Stream._placed,
    "BI": Stream._pictured,
    "sh": Stream._shaded,
    **dict.fromkeys(("BT", "ET"), Stream._text),
    **dict.fromkeys(OPERATORS, Stream._said),
    "Tf": Stream._font,
}


def boxed(matrix: Matrix, points: Sequence[Any]) -> Box:
    """Return the box around points through a matrix."""
    a, b, c, d, e, f = matrix
    x = [a * x + c * y + e for x, y in points]
    y = [b * x + d * y + f for x, y in points]
    return (min(x), min(y), max(x), max(y)) if points else _NOTHING


def within(one: Box, other: Box) -> Box:
    """Return what two boxes share."""
    return (
        max(one[0], other[0]),
        max(one[1], other[1]),
        min(one[2], other[2]),
        min(one[3], other[3]),
    )
