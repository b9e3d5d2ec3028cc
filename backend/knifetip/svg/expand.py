"""expand: list all drawable elements of an SVG, with the copies that ``use`` elements make.

Each shape, text or image, and each ``use`` element that copies nothing, gets a row of the import
report.  Each drawn shape also gets its path data, matrix and style in ``DrawnPaths``.  The copies
are counted before any copy is made: ten nested ``use`` elements can make a billion copies.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import replace
from typing import Final, NamedTuple

from knifetip.drawing_builder.clip import UNBOUNDED, UNCLIPPED, Clip
from knifetip.drawing_builder.report import ReportWriter
from knifetip.errors import DrawingTooLarge
from knifetip.formats.invalid_content import InvalidContent
from knifetip.formats.limits import Limits
from knifetip.geometry.affine import Matrix, compose
from knifetip.messages import Message
from knifetip.svg import layers, shapes
from knifetip.svg.clip_paths import ClipPaths, window_region
from knifetip.svg.document import Node
from knifetip.svg.drawn_paths import DrawnPaths, OmittedShape
from knifetip.svg.lengths import to_pixels
from knifetip.svg.page import Page, view_box, view_box_matrix
from knifetip.svg.references import href
from knifetip.svg.style import INITIAL, Appearance, Cascade, StyleSheet
from knifetip.svg.texts import text_annotation, text_content
from knifetip.svg.transform import parse_transform

#: Elements that only contain other elements.
_GROUPS: Final = frozenset(("svg", "g", "a", "switch"))
#: Elements that are drawn only by reference, or never.
_NOT_DRAWN: Final = frozenset(
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
_TEXT: Final = Message("import.text")
_IMAGE: Final = Message("import.image")
_REASONS: Final = {
    "text": _TEXT,
    "flowRoot": _TEXT,
    "image": _IMAGE,
    "video": _IMAGE,
    "foreignObject": Message("import.not-svg"),
    "script": Message("import.script"),
}
_HIDDEN: Final = Message("import.hidden")
_OTHER_LANGUAGE: Final = Message("import.other-language")
_LANGUAGE: Final = "en"
#: Values of ``overflow`` with which a window does not clip its content.
_SHOWN_OVERFLOW: Final = ("visible", "auto")
#: Largest number of rules in a style sheet.
_RULES: Final = 2000


class _Context(NamedTuple):
    """The properties that an element inherits from the elements that contain it."""

    appearance: Appearance
    matrix: Matrix
    layer: layers.Layer
    path: str  #: handles of the containing ``use`` elements, each followed by a slash
    ancestors: tuple[Node, ...]  #: containing elements with an id; a ``use`` must not copy them
    uses: int  #: number of containing ``use`` elements
    left_out: Message | None  #: reason why the content is not drawn, None if it is drawn
    window: shapes.Window
    clip: Clip


def expand(root: Node, page: Page, limits: Limits) -> tuple[ReportWriter, DrawnPaths]:
    """Return the import report and the drawn paths of an SVG document.

    Parameters
    ----------
    root
        Root element of the document.
    page
        Unit and matrix of the page.
    limits
        Limits of the depth and number of copies, and of the time.

    Raises
    ------
    DrawingTooLarge
        The depth of ``use`` elements, the number of their copies, the number of style rules or the
        time exceeds the limits.
    """
    expansion = _Expansion(root, page, limits)
    expansion.visit_all()
    return expansion.report, expansion.drawn


class _Expansion:
    """Visits the elements of an SVG document; collects the drawn paths and the import report."""

    def __init__(self, root: Node, page: Page, limits: Limits) -> None:
        self.report = ReportWriter()
        self.drawn = DrawnPaths()
        self._root = root
        self._limits = limits
        self._until = time.monotonic() + limits.seconds
        self._named: dict[str, Node] = {}
        texts: list[str] = []
        uses = False
        for node in _all_nodes(root):
            if (identity := node.attributes.get("id")) is not None:
                self._named.setdefault(identity, node)
            uses |= node.tag == "use"
            if node.tag == "style":
                texts.append(text_content(node))
        if uses:
            self._check_size()
        style_sheet = StyleSheet("\n".join(texts))
        if style_sheet.count > _RULES:
            raise DrawingTooLarge("svg.too-many-rules", count=style_sheet.count, limit=_RULES)
        self._cascade = Cascade(style_sheet, root)
        if style_sheet.unsupported:
            rules = [selector[:40] for selector in style_sheet.unsupported[:5]]
            reason = Message("import.rules-not-read", rules=rules)
            self.report.row("style", "style", layers.UNNAMED, reason)
        appearance = self._cascade.appearance(root, INITIAL)
        self.drawn.page_colour = appearance.background
        if appearance.overflow == "visible":
            page = replace(page, visible=UNBOUNDED)
        self.drawn.page = page.visible
        for warning in page.warnings:
            self.report.row("svg", "svg", layers.UNNAMED, warning)
        self._clip_paths = ClipPaths(self._named, self._cascade, limits)
        self._start = _Context(
            INITIAL,
            page.matrix,
            layers.NO_LAYER,
            "",
            (),
            0,
            None,
            _window(*_root_size(root)),
            UNCLIPPED,
        )

    def _check_size(self) -> None:
        """Raise DrawingTooLarge if the depth or number of copies by ``use`` elements is too large.

        The copies are counted before any copy is made.
        """
        total = 0
        stack: list[tuple[Node, tuple[Node, ...], int]] = [(self._root, (), 0)]
        while stack:
            node, containing, uses = stack.pop()
            total += 1
            if total > self._limits.expanded:
                raise DrawingTooLarge(
                    "reading.expands-too-far", limit=self._limits.expanded, format="SVG"
                )
            if node.tag == "use":
                target = self._target(node)
                if target is not None and target not in containing:
                    if uses >= self._limits.insert_depth:
                        raise DrawingTooLarge(
                            "reading.nested-too-deep", limit=self._limits.insert_depth, format="SVG"
                        )
                    stack.append((target, (*containing, target), uses + 1))
                continue
            if "id" in node.attributes:
                containing = (*containing, node)
            if node.tag not in _NOT_DRAWN or uses:
                stack += [(child, containing, uses) for child in node.children if child.tag]

    def _target(self, node: Node) -> Node | None:
        """Return the element that a ``use`` element copies.

        None is returned if no element of the document has the id that the ``use`` element names.
        """
        link = href(node)
        return self._named.get(link[1:]) if link.startswith("#") else None

    def visit_all(self) -> None:
        """Visit all elements of the document and fill the import report and the drawn paths.

        Every drawable element gets a row of the report; only drawn shapes are added to the paths.
        """
        stack = [(self._root, self._start)]
        while stack:
            node, context = stack.pop()
            if time.monotonic() > self._until:
                raise DrawingTooLarge(
                    "reading.too-slow", seconds=self._limits.seconds, format="SVG"
                )
            inner = self._visit(node, context)
            if inner is not None:
                children = [child for child in _children(node) if child.tag]
                contexts = self._contexts(node, children, inner)
                stack += reversed(list(zip(children, contexts, strict=True)))
            elif node.tag == "use" and (use_target := self._follow_use(node, context)) is not None:
                stack.append(use_target)

    def _contexts(self, node: Node, children: list[Node], inner: _Context) -> list[_Context]:
        """Return the properties that each child of a group inherits.

        Only the first child of a ``switch`` element that is for the reader is drawn.
        """
        if node.tag != "switch":
            return [inner] * len(children)
        hidden = inner._replace(left_out=inner.left_out or _OTHER_LANGUAGE)
        chosen = next((child for child in children if _is_for_reader(child)), None)
        return [inner if child is chosen else hidden for child in children]

    def _visit(self, node: Node, context: _Context) -> _Context | None:
        """Return the properties that the children of a group inherit; None for all other elements.

        An element that is not a group is added to the import report, unless it is a ``use`` element
        or an element that is never drawn.  ``context`` is the set of properties that ``node``
        inherits.
        """
        if node.tag in _NOT_DRAWN or node.tag == "use":
            return None
        context = self._context_of(node, context)
        if node.tag in _GROUPS:
            outermost = node is self._root
            inner = (
                context
                if outermost
                else context._replace(layer=layers.layer_of_group(node, context.layer))
            )
            return (
                inner if outermost or node.tag != "svg" else self._enter_window(node, node, inner)
            )
        handle = context.path + self._handle(node)
        layer = layers.layer_of_element(node, context.layer)
        if node.tag == "text":
            self._add_text(node, layer, context)
        if node.tag not in shapes.SHAPES:
            cause = _REASONS.get(node.tag)
            cause = cause or Message("import.unsupported-element", kind=node.tag)
            row = self.report.row(handle, node.tag, layer, cause)
            self._omit(row, shapes.frame_path_data, node, context)
            return None
        omit_reason = context.left_out or (None if context.appearance.visible else _HIDDEN)
        appearance = context.appearance
        omit_reason = omit_reason or _invisible(appearance)
        data = ""
        if not omit_reason:
            try:
                data = shapes.shape_path_data(node, context.window)
            except shapes.Undrawable as reason:
                omit_reason = reason.message
        row = self.report.row(handle, node.tag, layer, omit_reason)
        if omit_reason:
            self._omit(row, shapes.shape_path_data, node, context)
        else:
            self.drawn.add(
                row, data, layer, context.matrix, appearance, context.clip, context.window[2]
            )
        return None

    def _omit(
        self, row: int, shape: Callable[[Node, shapes.Window], str], node: Node, context: _Context
    ) -> None:
        """Store the path of an element that gives no edge.

        The bounding box of the path becomes the location of the element in the import report.

        ``row``: row of the element in the import report.
        ``shape``: function that returns the path data of the element.  If it fails, nothing is
        stored.
        """
        with suppress(shapes.Undrawable):
            self.drawn.omitted.append(
                OmittedShape(row, shape(node, context.window), context.matrix)
            )

    def _context_of(self, node: Node, context: _Context) -> _Context:
        """Return the properties that apply to the element ``node``.

        ``context`` contains the properties that the element inherits.  Where an attribute of the
        element specifies a property, such as the stroke, the specified value replaces the inherited
        value.  A ``transform`` attribute is combined with the inherited matrix.
        """
        appearance = self._cascade.appearance(node, context.appearance)
        left_out = context.left_out or (None if appearance.shown else _HIDDEN)
        if not left_out and not _is_for_reader(node):
            left_out = _OTHER_LANGUAGE
        outer = context.matrix
        if (text := node.attributes.get("transform")) is not None:
            try:
                outer = compose(outer, parse_transform(text))
            except InvalidContent as invalid:
                left_out = left_out or Message("import.bad-transform", reason=invalid.message)
        ancestors = (*context.ancestors, node) if "id" in node.attributes else context.ancestors
        clip = self._clip_paths.clip(context.clip, appearance, outer, context.window)
        return context._replace(
            appearance=appearance, matrix=outer, left_out=left_out, ancestors=ancestors, clip=clip
        )

    def _enter_window(self, node: Node, sizes: Node, context: _Context) -> _Context:
        """Return the properties that the children of an ``svg`` or ``symbol`` element inherit.

        The matrix in these properties maps the coordinates of the children to file units.

        ``node``: the ``svg`` or ``symbol`` element.
        ``sizes``: the element whose attributes ``width`` and ``height`` are used: ``node``, or the
        ``use`` element that copies ``node``.
        ``context``: properties that apply to ``node``.
        """
        try:
            x, y = (
                0.0 if sizes is not node else to_pixels(node.attributes.get(name, "0"), full_length)
                for name, full_length in (("x", context.window[0]), ("y", context.window[1]))
            )
            wide, high = (
                to_pixels(
                    sizes.attributes.get(name, node.attributes.get(name, "100%")), full_length
                )
                for name, full_length in (
                    ("width", context.window[0]),
                    ("height", context.window[1]),
                )
            )
        except InvalidContent as invalid:
            return context._replace(
                left_out=context.left_out or Message("import.bad-window", reason=invalid.message)
            )
        inner = compose(context.matrix, (1.0, 0.0, 0.0, 1.0, x, y))
        if context.appearance.overflow not in _SHOWN_OVERFLOW and wide > 0.0 and high > 0.0:
            clip = context.clip.intersect(window_region(wide, high, inner))
            context = context._replace(clip=clip)
        box = view_box(node)
        if box is None:
            return context._replace(matrix=inner, window=_window(wide, high))
        inner = compose(inner, view_box_matrix(box, wide or None, high or None, node))
        return context._replace(matrix=inner, window=_window(box[2], box[3]))

    def _follow_use(self, node: Node, context: _Context) -> tuple[Node, _Context] | None:
        """Return the element that a ``use`` element copies, and the properties of the copy.

        None is returned if the element cannot be copied; the reason is then added to the import
        report.

        ``node``: the ``use`` element.
        ``context``: properties that the ``use`` element inherits.
        """
        handle = self._handle(node)
        context = self._context_of(node, context)
        layer = layers.layer_of_element(node, context.layer)
        link = href(node)
        target = self._target(node)
        reason = context.left_out
        if not reason and target is None:
            reason = (
                Message("import.missing-id", id=link[1:41])
                if link.startswith("#")
                else Message("import.other-file", file=link[:60])
            )
        if not reason and target in context.ancestors:
            reason = Message("import.contains-itself")
        try:
            x, y = (
                to_pixels(node.attributes.get(name, "0"), full_length)
                for name, full_length in (("x", context.window[0]), ("y", context.window[1]))
            )
        except InvalidContent as invalid:
            reason = reason or Message("import.bad-place", reason=invalid.message)
        if reason or target is None:
            row = self.report.row(context.path + handle, "use", layer, reason)
            self._omit(row, shapes.point_path_data, node, context)
            return None
        context = context._replace(
            matrix=compose(context.matrix, (1.0, 0.0, 0.0, 1.0, x, y)),
            layer=layers.layer_of_group(node, context.layer),
            path=f"{context.path}{handle}/",
            uses=context.uses + 1,
        )
        if target.tag in ("symbol", "svg"):
            context = self._context_of(target, context)
            context = self._enter_window(target, node, context)
            group = Node("g", {})
            group.children = target.children
            return group, context
        return target, context

    def _add_text(self, node: Node, layer: str, context: _Context) -> None:
        """Add a text element to the annotations if it is visible and not empty."""
        if context.left_out or not context.appearance.visible:
            return
        annotation = text_annotation(
            node, layer, context.matrix, context.window, context.appearance, self._cascade
        )
        if annotation is not None:
            self.drawn.annotations.append(annotation)

    def _handle(self, node: Node) -> str:
        """Return the handle of an element in the import report: the id of the element.

        If the element has no id, or an earlier element has the same id, the handle is "#" and the
        number of the next row of the report.
        """
        identity = node.attributes.get("id", "")
        if identity and self._named.get(identity) is node:
            return identity
        return f"#{len(self.report.handle) + 1}"


def _invisible(appearance: Appearance) -> Message | None:
    """Return the reason why an element with this appearance is not visible, None if it is."""
    if appearance.drawn_stroke is not None or appearance.drawn_fill is not None:
        return None
    if appearance.stroke is None and appearance.fill is None:
        return Message("import.no-paint")
    if appearance.stroke is not None and appearance.stroke_width <= 0.0:
        return Message("import.no-stroke-width")
    return Message("import.not-visible")


def _root_size(root: Node) -> tuple[float, float]:
    """Return width and height of the window of the root element, 0 where the file has none."""
    if (box := view_box(root)) is not None:
        return box[2:]
    size = []
    for name in ("width", "height"):
        try:
            size.append(to_pixels(root.attributes.get(name, "0")))
        except InvalidContent:
            size.append(0.0)
    return size[0], size[1]


def _window(wide: float, high: float) -> shapes.Window:
    """Return three lengths to which percentages in the attributes of SVG elements refer.

    ``wide`` and ``high`` are the width and the height of the window that contains the elements.
    Percentages in x direction refer to the first length, the width.  Percentages in y direction
    refer to the second length, the height.  All other percentages, such as radii, refer to the
    third length, the diagonal of the window divided by √2.
    """
    return wide, high, math.sqrt((wide * wide + high * high) / 2.0)


def _all_nodes(root: Node) -> Iterator[Node]:
    """Yield an element and all elements inside it, in the order of the file, without texts."""
    stack = [root]
    while stack:
        node = stack.pop()
        yield node
        stack += [child for child in reversed(node.children) if child.tag]


def _children(node: Node) -> list[Node]:
    """Return the children of an element that are to be visited, including texts between them.

    Of the children of a ``switch`` element, those that require an extension are left out.
    """
    if node.tag != "switch":
        return node.children
    return [
        child
        for child in node.children
        if child.tag and "requiredExtensions" not in child.attributes
    ]


def _is_for_reader(node: Node) -> bool:
    """Return whether an element is drawn for a reader of English.

    The attribute ``systemLanguage`` lists the languages of an element, such as "de, en-GB".
    """
    languages = node.get("systemLanguage")
    return languages is None or any(
        one.strip().lower().partition("-")[0] == _LANGUAGE for one in languages.split(",")
    )
