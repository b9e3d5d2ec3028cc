"""expand: every element that is drawn, with what ``use`` repeats, where it stands.

    root, page -> ReportWriter: a ledger row each; Drawn: path data, matrix and style of each line

What ``use`` stands for is counted before it is followed: ten lines can stand for a billion.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import dataclass, field
from typing import Final, NamedTuple

from knifetip.drawing_builder.colours import UNKNOWN_COLOUR, nearest_index
from knifetip.drawing_builder.columns import Style
from knifetip.drawing_builder.report import ReportWriter
from knifetip.errors import DrawingTooLarge
from knifetip.formats.limits import Limits
from knifetip.geometry.affine import Matrix, chained
from knifetip.model.drawing import Inscription
from knifetip.svg import layers, shapes
from knifetip.svg.document import Node
from knifetip.svg.lengths import pixels
from knifetip.svg.page import Page, fitted, view
from knifetip.svg.style import SILENT, Cascade, Look, StyleSheet
from knifetip.svg.transform import matrix

#: Elements that only hold others.
_GROUPS: Final = frozenset(("svg", "g", "a", "switch"))
#: Elements that are drawn where something refers to them, or never.
_UNSEEN: Final = frozenset(
    (
        "defs",
        "symbol",
        "clipPath",
        "mask",
        "marker",
        "pattern",
        "linearGradient",
        "radialGradient",
        "filter",
        "style",
        "title",
        "desc",
        "metadata",
        "font",
        "font-face",
        "cursor",
        "view",
        "color-profile",
        "animate",
        "animateTransform",
        "animateMotion",
        "set",
        "solidcolor",
        "hatch",
        "mesh",
        "meshgradient",
    )
)
_TEXT: Final = "text is not cut"
_PICTURE: Final = "a picture is not cut"
_REASONS: Final = {
    "text": _TEXT,
    "flowRoot": _TEXT,
    "image": _PICTURE,
    "video": _PICTURE,
    "foreignObject": "what is inside is no SVG",
    "script": "a script is not run",
}
_HIDDEN: Final = "it is hidden"
#: Rules of a style sheet; more are an attack.
_RULES: Final = 2000


class Unseen(NamedTuple):
    """What gives no line, and would be here."""

    row: int  #: of the ledger
    data: str  #: path data
    matrix: Matrix


@dataclass(slots=True)
class Drawn:
    """n lines as elements, in the order of the file."""

    data: list[str] = field(default_factory=list)  #: path data
    matrix: list[Matrix] = field(default_factory=list)  #: from its coordinates to file units
    row: list[int] = field(default_factory=list)  #: of the ledger
    style: list[int] = field(default_factory=list)  #: which of ``styles``
    styles: list[Style] = field(default_factory=list)
    unseen: list[Unseen] = field(default_factory=list)
    inscriptions: list[Inscription] = field(default_factory=list)  #: in file units


class _Here(NamedTuple):
    """What an element has from those around it."""

    look: Look
    matrix: Matrix
    layer: layers.Layer
    path: str  #: handles of the ``use`` elements around, each with a slash behind it
    inside: tuple[Node, ...]  #: elements with an id around it: what it may not repeat
    uses: int  #: how many ``use`` elements are around it
    left_out: str  #: why nothing inside is drawn, empty if it is
    window: shapes.Window


def expand(root: Node, page: Page, limits: Limits) -> tuple[ReportWriter, Drawn]:
    """Return the ledger's rows and the lines of a document.

    Raises
    ------
    DrawingTooLarge
        ``use`` elements are nested deeper, or stand for more, than the limits allow.
    """
    walk = _Walk(root, page, limits)
    walk.all()
    walk.areas()
    return walk.sheet, walk.drawn


class _Walk:
    def __init__(self, root: Node, page: Page, limits: Limits) -> None:
        self.sheet = ReportWriter()
        self.drawn = Drawn()
        self._root = root
        self._limits = limits
        self._until = time.monotonic() + limits.seconds
        self._named: dict[str, Node] = {}
        self._handles: set[str] = set()
        self._numbers: dict[Style, int] = {}
        self._stroked = False
        self._areas: list[int] = []
        texts: list[str] = []
        uses = False
        for node in _every(root):
            if (identity := node.attributes.get("id")) is not None:
                self._named.setdefault(identity, node)
            uses |= node.tag == "use"
            if node.tag == "style":
                texts.append(_words(node))
        if uses:
            self._count()
        sheet = StyleSheet("\n".join(texts))
        if sheet.count > _RULES:
            raise DrawingTooLarge("svg.too-many-rules", count=sheet.count, limit=_RULES)
        self._cascade = Cascade(sheet, root)
        if sheet.unsupported:
            listed = ", ".join(selector[:40] for selector in sheet.unsupported[:5])
            self.sheet.row("style", "style", layers.NAMELESS, f"rules that are not read: {listed}")
        box = view(root)
        wide, high = box[2:] if box else (0.0, 0.0)
        self._start = _Here(SILENT, page.matrix, layers.NOWHERE, "", (), 0, "", _window(wide, high))

    def _count(self) -> None:
        """Refuse what stands for more elements than the limit, before anything is expanded."""
        total = 0
        stack: list[tuple[Node, tuple[Node, ...], int]] = [(self._root, (), 0)]
        while stack:
            node, inside, uses = stack.pop()
            total += 1
            if total > self._limits.expanded:
                raise DrawingTooLarge(
                    "reading.expands-too-far", limit=self._limits.expanded, format="SVG"
                )
            if node.tag == "use":
                target = self._target(node)
                if target is not None and target not in inside:
                    if uses >= self._limits.insert_depth:
                        raise DrawingTooLarge(
                            "reading.nested-too-deep", limit=self._limits.insert_depth, format="SVG"
                        )
                    stack.append((target, (*inside, target), uses + 1))
                continue
            if "id" in node.attributes:
                inside = (*inside, node)
            if node.tag not in _UNSEEN or uses:
                stack += [(child, inside, uses) for child in node.children if child.tag]

    def _target(self, node: Node) -> Node | None:
        href = _href(node)
        return self._named.get(href[1:]) if href.startswith("#") else None

    def all(self) -> None:
        """Visit every element in the order of the file."""
        stack = [(self._root, self._start)]
        while stack:
            node, here = stack.pop()
            if time.monotonic() > self._until:
                raise DrawingTooLarge(
                    "reading.too-slow", seconds=self._limits.seconds, format="SVG"
                )
            inner = self._visited(node, here)
            if inner is not None:
                stack += [(child, inner) for child in reversed(_children(node)) if child.tag]
            elif node.tag == "use" and (found := self._used(node, here)) is not None:
                stack.append(found)

    def _visited(self, node: Node, here: _Here) -> _Here | None:
        """Enter an element into the ledger; return what those inside have, None if none are."""
        if node.tag in _UNSEEN or node.tag == "use":
            return None
        here = self._within(node, here)
        if node.tag in _GROUPS:
            outermost = node is self._root
            inner = here if outermost else here._replace(layer=layers.around(node, here.layer))
            return inner if outermost or node.tag != "svg" else self._windowed(node, node, inner)
        handle = here.path + self._handle(node)
        layer = layers.own(node, here.layer)
        if node.tag == "text":
            self._inscribed(node, here, layer)
        if node.tag not in shapes.READ:
            why = _REASONS.get(node.tag, f"{node.tag} is not a kind of line that is read")
            row = self.sheet.row(handle, node.tag, layer, why)
            self._unseen(row, shapes.frame, node, here)
            return None
        why = here.left_out or ("" if here.look.visible else _HIDDEN)
        look = here.look
        if not why and look.stroke is None and look.fill is None:
            why = "it has neither a stroke nor a fill: nothing of it is seen"
        data = ""
        if not why:
            try:
                data = shapes.data(node, here.window)
            except shapes.Undrawable as reason:
                why = str(reason)
        row = self.sheet.row(handle, node.tag, layer, why)
        if why:
            self._unseen(row, shapes.data, node, here)
        else:
            self._line(row, data, layer, here)
        return None

    def _unseen(
        self, row: int, shape: Callable[[Node, shapes.Window], str], node: Node, here: _Here
    ) -> None:
        """Keep where something would be that gives no line."""
        with suppress(shapes.Undrawable):
            self.drawn.unseen.append(Unseen(row, shape(node, here.window), here.matrix))

    def _within(self, node: Node, here: _Here) -> _Here:
        """Return what is around an element, with its own look and transform."""
        look = self._cascade.look(node, here.look)
        left_out = here.left_out or ("" if look.shown else _HIDDEN)
        outer = here.matrix
        if (text := node.attributes.get("transform")) is not None:
            try:
                outer = chained(outer, matrix(text))
            except ValueError as reason:
                left_out = left_out or f"its transform cannot be read: {reason}"
        inside = (*here.inside, node) if "id" in node.attributes else here.inside
        return here._replace(look=look, matrix=outer, left_out=left_out, inside=inside)

    def _windowed(self, node: Node, sizes: Node, here: _Here) -> _Here:
        """Return what is inside an svg or a symbol, whose window ``sizes`` may say."""
        try:
            x, y = (
                0.0 if sizes is not node else pixels(node.attributes.get(name, "0"), whole)
                for name, whole in (("x", here.window[0]), ("y", here.window[1]))
            )
            wide, high = (
                pixels(sizes.attributes.get(name, node.attributes.get(name, "100%")), whole)
                for name, whole in (("width", here.window[0]), ("height", here.window[1]))
            )
        except ValueError as reason:
            return here._replace(left_out=here.left_out or f"its window cannot be read: {reason}")
        inner = chained(here.matrix, (1.0, 0.0, 0.0, 1.0, x, y))
        box = view(node)
        if box is None:
            return here._replace(matrix=inner, window=_window(wide, high))
        inner = chained(inner, fitted(box, wide or None, high or None, node))
        return here._replace(matrix=inner, window=_window(box[2], box[3]))

    def _used(self, node: Node, here: _Here) -> tuple[Node, _Here] | None:
        """Return what a ``use`` element repeats, or enter into the ledger why it does not."""
        handle = self._handle(node)
        here = self._within(node, here)
        layer = layers.own(node, here.layer)
        href = _href(node)
        target = self._target(node)
        why = here.left_out
        if not why and target is None:
            why = (
                f"there is nothing with the id {href[1:41]!r}"
                if href.startswith("#")
                else f"it refers to another file, {href[:60]!r}, and nothing is fetched"
            )
        if not why and target in here.inside:
            why = "it contains itself"
        try:
            x, y = (
                pixels(node.attributes.get(name, "0"), whole)
                for name, whole in (("x", here.window[0]), ("y", here.window[1]))
            )
        except ValueError as reason:
            why = why or f"its place cannot be read: {reason}"
        if why or target is None:
            row = self.sheet.row(here.path + handle, "use", layer, why)
            self._unseen(row, shapes.corner, node, here)
            return None
        here = here._replace(
            matrix=chained(here.matrix, (1.0, 0.0, 0.0, 1.0, x, y)),
            layer=layers.around(node, here.layer),
            path=f"{here.path}{handle}/",
            uses=here.uses + 1,
        )
        if target.tag in ("symbol", "svg"):
            here = self._within(target, here)
            here = self._windowed(target, node, here)
            group = Node("g", {})
            group.children = target.children
            return group, here
        return target, here

    def _handle(self, node: Node) -> str:
        """Return the id of an element where it is the only one of that id, else its number."""
        identity = node.attributes.get("id", "")
        if identity and self._named.get(identity) is node:
            return identity
        return f"#{len(self.sheet.handle) + 1}"

    def _line(self, row: int, data: str, layer: str, here: _Here) -> None:
        look = here.look
        drawn = look.stroke if look.stroke is not None else look.fill
        colour = UNKNOWN_COLOUR if drawn is None else drawn
        if look.stroke is None:
            self._areas.append(len(self.drawn.row))
        else:
            self._stroked = True
        style = Style(
            layer,
            nearest_index(colour),
            colour if colour >= 0 else -1,
            "dashed" if look.dashed and look.stroke is not None else "Continuous",
        )
        number = self._numbers.get(style)
        if number is None:
            number = self._numbers[style] = len(self.drawn.styles)
            self.drawn.styles.append(style)
        self.drawn.data.append(data)
        self.drawn.matrix.append(here.matrix)
        self.drawn.row.append(row)
        self.drawn.style.append(number)

    def areas(self) -> None:
        """Decide on filled areas without a stroke: lines only where the drawing has no others."""
        for number in self._areas:
            row = self.drawn.row[number]
            if self._stroked:
                self.sheet.dropped[row] = "a filled area without a stroke; others have one"
            else:
                self.sheet.notes.setdefault(row, []).append(
                    "outline of a filled area: nothing in the drawing has a stroke"
                )
        if self._stroked and self._areas:
            gone = set(self._areas)
            self.drawn.unseen += [
                Unseen(self.drawn.row[one], self.drawn.data[one], self.drawn.matrix[one])
                for one in self._areas
            ]
            kept = [number for number in range(len(self.drawn.row)) if number not in gone]
            for name in ("data", "matrix", "row", "style"):
                column = getattr(self.drawn, name)
                column[:] = [column[number] for number in kept]

    def _inscribed(self, node: Node, here: _Here, layer: str) -> None:
        if here.left_out or not here.look.visible:
            return
        words = " ".join(_words(node).split())
        first = next((one for one in (node, *node.children) if "x" in one.attributes), node)
        try:
            x, y = (
                pixels(_first(first.attributes.get(name, "0")), whole)
                for name, whole in (("x", here.window[0]), ("y", here.window[1]))
            )
        except ValueError:
            x = y = 0.0
        a, b, c, d, e, f = here.matrix
        look = self._cascade.look(first, here.look) if first is not node else here.look
        place = a * x + c * y + e, b * x + d * y + f
        height = look.letter * math.sqrt(abs(a * d - b * c))
        if words and all(math.isfinite(value) for value in (*place, height)):
            self.drawn.inscriptions.append(
                Inscription(words, *place, height, math.nan, node.tag, layer)
            )


def _window(wide: float, high: float) -> shapes.Window:
    return wide, high, math.sqrt((wide * wide + high * high) / 2.0)


def _every(root: Node) -> Iterator[Node]:
    stack = [root]
    while stack:
        node = stack.pop()
        yield node
        stack += [child for child in reversed(node.children) if child.tag]


def _children(node: Node) -> list[Node]:
    """Return what of an element is drawn: of a ``switch`` the first that asks for nothing."""
    if node.tag != "switch":
        return node.children
    return [
        child
        for child in node.children
        if child.tag and "requiredExtensions" not in child.attributes
    ][:1]


def _words(node: Node) -> str:
    parts = []
    stack = [node]
    while stack:
        one = stack.pop()
        parts.append(one.text)
        stack += reversed(one.children)
    return "".join(parts)


def _href(node: Node) -> str:
    given = node.attributes
    return next((value for key, value in given.items() if key == "href"), None) or next(
        (value for key, value in given.items() if key.endswith(":href")), ""
    )


def _first(text: str) -> str:
    """Return the first of a list of lengths: a text may place each of its letters."""
    parts = text.replace(",", " ").split()
    return parts[0] if parts else "0"
