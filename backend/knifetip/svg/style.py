"""style: compute how an element is drawn, from attributes, style sheet and inherited values.

tinycss2 parses style sheets and declarations, cssselect2 matches selectors.  Only properties that
decide whether and how a line is drawn are used.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Final, NamedTuple, TypeAlias

import cssselect2
import tinycss2
from cssselect2 import parser as selectors

from knifetip.drawing_builder.colours import VISIBLE
from knifetip.svg.colours import parse_paint
from knifetip.svg.document import Node
from knifetip.svg.lengths import to_pixels


class Appearance(NamedTuple):
    """How an element is drawn: colours, dashes, visibility, clip path and font size.

    The children of the element inherit these properties, except those of its clip path and window.
    """

    stroke: int | None = None  #: 0xRRGGBB, ``UNKNOWN_COLOUR``, None for none
    fill: int | None = 0
    colour: int | None = 0  #: value of ``currentColor``
    dashed: bool = False
    visible: bool = True  #: ``visibility``; a child may override it
    shown: bool = True  #: ``display``; a child cannot override it
    font_size: float = 16.0  #: pixels
    stroke_opacity: float = 1.0
    fill_opacity: float = 1.0
    opacity: float = 1.0  #: product of the element and the elements that contain it
    stroke_width: float = 1.0  #: user units, or per cent
    is_percent: bool = False  #: whether the stroke width is in per cent of the window
    clip_even_odd: bool = False  #: whether ``clip-rule`` is evenodd
    clip_path: str = ""  #: value of ``clip-path``, empty for none; not inherited
    mask: str = ""  #: value of ``mask``, empty for none; not inherited
    overflow: str = ""  #: value of ``overflow``; not inherited
    background: int | None = None  #: background colour, None for none; not inherited
    #: whether no matrix scales the stroke (``vector-effect: non-scaling-stroke``); not inherited
    fixed_stroke: bool = False

    @property
    def drawn_stroke(self) -> int | None:
        """The colour of the stroke; None if the stroke is not visible."""
        is_seen = self.stroke_opacity * self.opacity >= VISIBLE and self.stroke_width > 0.0
        return self.stroke if is_seen else None

    @property
    def drawn_fill(self) -> int | None:
        """The colour of the fill; None if the fill is not visible."""
        return self.fill if self.fill_opacity * self.opacity >= VISIBLE else None


#: Initial values: a black area without an outline.
INITIAL: Final = Appearance()

_PROPERTIES: Final[tuple[str, ...]] = (
    "color",
    "stroke",
    "stroke-dasharray",
    "stroke-opacity",
    "stroke-width",
    "fill",
    "fill-opacity",
    "opacity",
    "display",
    "visibility",
    "font-size",
    "clip-path",
    "clip-rule",
    "mask",
    "overflow",
    "vector-effect",
    "background",
    "background-color",
)

#: Property, value, and whether it is marked as important.
Declaration: TypeAlias = tuple[str, str, bool]
#: Selectors that depend on the element alone.
_OWN: Final = (
    selectors.LocalNameSelector,
    selectors.IDSelector,
    selectors.ClassSelector,
    selectors.AttributeSelector,
)
#: Supported combinators, which depend on the ancestors of an element.  Other combinators depend on
#: its siblings; time and memory to match them grow with the square of the number of siblings.
_COMBINATORS: Final = (" ", ">")


class StyleSheet:
    """The supported rules of all style sheets of an SVG document.

    A rule is supported if its selector depends only on the element and its ancestors.
    """

    def __init__(self, text: str) -> None:
        self.unsupported: list[str] = []  #: selectors and at-rules that are not applied
        self.count = 0  #: number of selectors that are applied
        self.ids: set[str] = set()  #: ids that selectors name
        #: Whether every selector depends on tag, id and classes of the element alone.
        self.simple = True
        self._matcher = cssselect2.Matcher()
        for rule in tinycss2.parse_stylesheet(text, skip_comments=True, skip_whitespace=True):
            if rule.type == "at-rule":
                prelude = tinycss2.serialize(rule.prelude).strip()
                self.unsupported.append(f"@{rule.at_keyword} {prelude}".strip())
            elif rule.type == "qualified-rule":
                declared = _declarations(tinycss2.parse_blocks_contents(rule.content))
                for prelude in _comma_separated(rule.prelude):
                    self._add(prelude, declared)
            else:
                self.unsupported.append(rule.message)

    def _add(self, prelude: list[tinycss2.ast.Node], declared: tuple[Declaration, ...]) -> None:
        try:
            parsed = list(selectors.parse(prelude))
            compiled = cssselect2.compile_selector_list(prelude)
        except cssselect2.SelectorError:
            parsed, compiled = [], []
        if not parsed or not all(_is_supported(one.parsed_tree) for one in parsed):
            self.unsupported.append(tinycss2.serialize(prelude).strip())
            return
        for selector in compiled:
            self.count += 1
            self._matcher.add_selector(selector, declared)
            self.ids |= {selector.id} - {None}
        self.simple &= all(_is_simple(one.parsed_tree) for one in parsed)

    def matching_declarations(self, element: cssselect2.ElementWrapper) -> list[Declaration]:
        """Return the declarations that apply to an element, in ascending order of priority.

        A declaration is a property and its value, such as ``stroke: red``.
        """
        return [
            declaration
            for _, _, pseudo, declared in self._matcher.match(element)
            if pseudo is None
            for declaration in declared
        ]


def _comma_separated(tokens: list[tinycss2.ast.Node]) -> Iterator[list[tinycss2.ast.Node]]:
    part: list[tinycss2.ast.Node] = []
    for token in tokens:
        if token == ",":
            yield part
            part = []
        else:
            part.append(token)
    yield part


def _is_supported(tree: object) -> bool:
    """Return whether a selector is supported: it depends only on an element and its ancestors.

    ``tree`` is the selector as parsed by cssselect2.
    """
    if isinstance(tree, selectors.CombinedSelector):
        return (
            tree.combinator in _COMBINATORS
            and _is_supported(tree.left)
            and _is_supported(tree.right)
        )
    return isinstance(tree, selectors.CompoundSelector) and all(
        isinstance(one, _OWN) for one in tree.simple_selectors
    )


def _is_simple(tree: object) -> bool:
    return isinstance(tree, selectors.CompoundSelector) and not any(
        isinstance(one, selectors.AttributeSelector) for one in tree.simple_selectors
    )


def parse_style_attribute(text: str) -> tuple[Declaration, ...]:
    """Return the supported declarations of a style attribute such as ``stroke:red; fill:none``."""
    return _declarations(tinycss2.parse_blocks_contents(text))


def _declarations(content: list[tinycss2.ast.Node]) -> tuple[Declaration, ...]:
    return tuple(
        (one.lower_name, tinycss2.serialize(one.value).strip(), one.important)
        for one in content
        if one.type == "declaration" and one.lower_name in _PROPERTIES
    )


class Cascade:
    """Computes the appearance of the elements of one document, and caches the results."""

    def __init__(self, sheet: StyleSheet, root: Node) -> None:
        self._sheet = sheet
        self._elements: dict[Node, cssselect2.ElementWrapper] = {}
        if not sheet.simple:
            self._elements = {
                one.etree_element: one
                for one in cssselect2.ElementWrapper.from_xml_root(root).iter_subtree()
            }
        self._known: dict[tuple[object, ...], Appearance] = {}
        self._inline: dict[str, tuple[Declaration, ...]] = {}

    def appearance(self, node: Node, inherited: Appearance) -> Appearance:
        """Return the appearance of an element; its parent has the appearance ``inherited``."""
        if not self._sheet.simple:
            return self._compute(node, inherited)
        attributes = node.attributes
        identity = attributes.get("id", "")
        key = (
            inherited,
            node.tag if self._sheet.count else "",
            identity if identity in self._sheet.ids else "",
            attributes.get("class"),
            attributes.get("style"),
            *map(attributes.get, _PROPERTIES),
        )
        cached = self._known.get(key)
        if cached is None:
            cached = self._known[key] = self._compute(node, inherited)
        return cached

    def _compute(self, node: Node, inherited: Appearance) -> Appearance:
        attributes = node.attributes
        values = {name: attributes[name] for name in _PROPERTIES if name in attributes}
        text = attributes.get("style", "")
        inline = self._inline.get(text)
        if inline is None:
            inline = self._inline[text] = parse_style_attribute(text)
        declared = [*self._matching(node), *inline]
        for wanted in (False, True):
            values |= {name: value for name, value, important in declared if important == wanted}
        return _appearance(values, inherited)

    def _matching(self, node: Node) -> list[Declaration]:
        if self._sheet.count == 0:
            return []
        element = self._elements.get(node)
        if element is None:
            element = cssselect2.ElementWrapper.from_xml_root(node)
        return self._sheet.matching_declarations(element)


def _appearance(values: dict[str, str], inherited: Appearance) -> Appearance:
    colour = _computed_paint(values.get("color"), inherited.colour, inherited.colour)
    stroke = _computed_paint(values.get("stroke"), inherited.stroke, colour)
    fill = _computed_paint(values.get("fill"), inherited.fill, colour)
    dashed = inherited.dashed
    if (dash := values.get("stroke-dasharray", "inherit")) != "inherit":
        # "none" and lists of zeros are continuous lines.
        dashed = any(digit in "123456789" for digit in dash)
    visible = inherited.visible
    if (word := values.get("visibility", "inherit").lower()) != "inherit":
        visible = word not in ("hidden", "collapse")
    font_size = inherited.font_size
    if (size := values.get("font-size")) is not None:
        try:
            font_size = to_pixels(size, inherited.font_size, inherited.font_size)
        except ValueError:
            font_size = inherited.font_size
    even_odd = inherited.clip_even_odd
    if (word := values.get("clip-rule", "inherit").strip().lower()) != "inherit":
        even_odd = word == "evenodd"
    shown = inherited.shown and values.get("display", "").lower() != "none"
    stroke_width, is_percent = _stroke_width(values.get("stroke-width"), inherited, font_size)
    return Appearance(
        stroke,
        fill,
        colour,
        dashed,
        visible,
        shown,
        font_size,
        stroke_opacity=_opacity(values.get("stroke-opacity"), inherited.stroke_opacity),
        fill_opacity=_opacity(values.get("fill-opacity"), inherited.fill_opacity),
        opacity=inherited.opacity * _opacity(values.get("opacity"), 1.0),
        stroke_width=stroke_width,
        is_percent=is_percent,
        clip_even_odd=even_odd,
        clip_path=_reference(values.get("clip-path")),
        mask=_reference(values.get("mask")),
        overflow=values.get("overflow", "").strip().lower(),
        background=_computed_paint(
            values.get("background-color", values.get("background")), None, colour
        ),
        fixed_stroke="non-scaling-stroke" in values.get("vector-effect", "").lower().split(),
    )


def _computed_paint(value: str | None, inherited: int | None, current: int | None) -> int | None:
    if value is None or value.strip().lower() == "inherit":
        return inherited
    try:
        return parse_paint(value, current)
    except ValueError:
        return inherited


def _reference(value: str | None) -> str:
    """Return the value of ``clip-path`` or ``mask``, empty if it is "none"."""
    text = (value or "").strip()
    return "" if text.lower() in ("none", "initial", "unset") else text


def _opacity(value: str | None, inherited: float) -> float:
    """Return an opacity, 0 … 1, from its value, such as "0.5" or "50%"."""
    text = (value or "").strip()
    try:
        share = float(text.rstrip("%")) / (100.0 if text.endswith("%") else 1.0)
    except ValueError:
        return inherited
    return min(max(share, 0.0), 1.0) if math.isfinite(share) else inherited


def _stroke_width(value: str | None, inherited: Appearance, font_size: float) -> tuple[float, bool]:
    """Return a stroke width (user units, or per cent), and whether it is in per cent.

    ``value`` is the value of ``stroke-width``, None if it is not given.
    """
    before = inherited.stroke_width, inherited.is_percent
    if value is None:
        return before
    try:
        # A percentage refers to the window of the element that is drawn.
        width = to_pixels(value, 100.0, font_size)
    except ValueError:
        return before
    return (width, value.rstrip().endswith("%")) if width >= 0.0 else before
