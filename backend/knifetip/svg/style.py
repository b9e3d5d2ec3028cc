"""style: what an element is drawn with, from attributes, style rules and those around it.

    Node, rules of its <style>, look of its parent -> Look

Read are the properties that say whether and how a line is drawn.  Of style sheets the simple
selectors are read: a tag, a class, an id, and any of them together (``path.cut``).  What asks for
the place of an element among others (``g > path``) is not, and is said so.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import Final, NamedTuple

from knifetip.svg.colours import paint
from knifetip.svg.document import Node
from knifetip.svg.lengths import pixels


class Look(NamedTuple):
    """What an element is drawn with; all of it comes down from the element around."""

    stroke: int | None  #: 0xRRGGBB, ``UNTOLD``, None for none
    fill: int | None
    colour: int | None  #: what ``currentColor`` means
    dashed: bool
    visible: bool  #: ``visibility``: an element inside may be visible again
    shown: bool  #: ``display``: nothing inside is shown
    letter: float  #: height of the letters (pixels)


#: What is drawn where nobody says anything: a black area without an outline.
SILENT: Final = Look(None, 0, 0, False, True, True, 16.0)

_PROPERTIES: Final[tuple[str, ...]] = (
    "color",
    "stroke",
    "stroke-dasharray",
    "stroke-opacity",
    "fill",
    "fill-opacity",
    "display",
    "visibility",
    "font-size",
)


class Rule(NamedTuple):
    """A rule of a style sheet, for one selector."""

    tag: str  #: empty for any
    ids: frozenset[str]
    classes: frozenset[str]
    weight: tuple[int, int, int, int]  #: ids, classes, tags, place in the sheet
    declared: tuple[tuple[str, str, bool], ...]  #: property, value, whether it is important


_COMMENT: Final = re.compile(r"/\*.*?(?:\*/|$)|<!--|-->", re.DOTALL)
_SIMPLE: Final = re.compile(r"(\*|[A-Za-z][\w-]*)?((?:[.#][\w-]+)*)")
_BRACE: Final = re.compile(r"[{};]")


def sheet(text: str) -> tuple[list[Rule], list[str]]:
    """Return the rules of a style sheet, and the selectors and at-rules that are not read."""
    rules: list[Rule] = []
    unread: list[str] = []
    text = _COMMENT.sub(" ", text)
    at = 0
    while (brace := _BRACE.search(text, at)) is not None:
        head = text[at : brace.start()].strip()
        if brace[0] != "{":
            if head:
                unread.append(head)
            at = brace.end()
            continue
        if head.startswith("@"):
            unread.append(head)
            at = _closing(text, brace.end())
            continue
        last = text.find("}", brace.end())
        last = len(text) if last < 0 else last
        declared = declarations(text[brace.end() : last])
        for selector in head.split(","):
            found = _SIMPLE.fullmatch(selector.strip())
            if found is None or not found[0]:
                unread.append(selector.strip())
                continue
            tag = "" if found[1] in (None, "*") else found[1]
            parts = re.findall(r"([.#])([\w-]+)", found[2])
            ids = frozenset(name for sign, name in parts if sign == "#")
            classes = frozenset(name for sign, name in parts if sign == ".")
            weight = (len(ids), len(classes), int(bool(tag)), len(rules))
            rules.append(Rule(tag, ids, classes, weight, declared))
        at = last + 1
    return rules, unread


def _closing(text: str, at: int) -> int:
    """Return where the braces that were opened before ``at`` are closed."""
    deep = 1
    for brace in re.finditer(r"[{}]", text[at:]):
        deep += 1 if brace[0] == "{" else -1
        if deep == 0:
            return at + brace.end()
    return len(text)


def declarations(text: str) -> tuple[tuple[str, str, bool], ...]:
    """Return the properties that are read, of ``stroke:red; fill:none``."""
    found = []
    for part in text.split(";"):
        name, _, value = part.partition(":")
        name = name.strip().lower()
        if name in _PROPERTIES:
            value, mark, _ = value.partition("!")
            found.append((name, value.strip(), bool(mark)))
    return tuple(found)


class Cascade:
    """The style sheet of one file, and the looks that were met in it."""

    def __init__(self, rules: Iterable[Rule]) -> None:
        self._by_tag: dict[str, list[Rule]] = {}
        self._by_class: dict[str, list[Rule]] = {}
        self._by_id: dict[str, list[Rule]] = {}
        for rule in rules:
            if rule.ids:
                self._by_id.setdefault(min(rule.ids), []).append(rule)
            elif rule.classes:
                self._by_class.setdefault(min(rule.classes), []).append(rule)
            else:
                self._by_tag.setdefault(rule.tag, []).append(rule)
        self._known: dict[tuple[object, ...], Look] = {}
        self._inline: dict[str, tuple[tuple[str, str, bool], ...]] = {}

    def look(self, node: Node, around: Look) -> Look:
        """Return what an element is drawn with."""
        given = node.attributes
        own = given.get("id", "")
        key = (
            around,
            node.tag if self._by_tag or self._by_class or self._by_id else "",
            own if own in self._by_id else "",
            given.get("class"),
            given.get("style"),
            *map(given.get, _PROPERTIES),
        )
        found = self._known.get(key)
        if found is None:
            found = self._known[key] = self._made(node, around)
        return found

    def _made(self, node: Node, around: Look) -> Look:
        given = node.attributes
        values = {name: given[name] for name in _PROPERTIES if name in given}
        classes = frozenset(given.get("class", "").split())
        own = given.get("id", "")
        candidates = [*self._by_tag.get("", ()), *self._by_tag.get(node.tag, ())]
        candidates += self._by_id.get(own, ())
        for name in classes:
            candidates += self._by_class.get(name, ())
        met = [
            rule
            for rule in candidates
            if rule.tag in ("", node.tag) and rule.classes <= classes and rule.ids <= {own}
        ]
        met.sort(key=lambda rule: rule.weight)
        text = given.get("style", "")
        inline = self._inline.get(text)
        if inline is None:
            inline = self._inline[text] = declarations(text)
        said = [one for rule in met for one in rule.declared] + list(inline)
        for wanted in (False, True):
            values |= {name: value for name, value, important in said if important == wanted}
        return _looking(values, around)


def _looking(values: dict[str, str], around: Look) -> Look:
    colour = _painted(values.get("color"), around.colour, around.colour)
    stroke = _painted(values.get("stroke"), around.stroke, colour)
    fill = _painted(values.get("fill"), around.fill, colour)
    if _nothing(values.get("stroke-opacity")):
        stroke = None
    if _nothing(values.get("fill-opacity")):
        fill = None
    dashed = around.dashed
    if (dash := values.get("stroke-dasharray", "inherit")) != "inherit":
        # 0 in all places, or none: a line without gaps.
        dashed = any(digit in "123456789" for digit in dash)
    visible = around.visible
    if (word := values.get("visibility", "inherit").lower()) != "inherit":
        visible = word not in ("hidden", "collapse")
    letter = around.letter
    if (size := values.get("font-size")) is not None:
        try:
            whole = around.letter
            letter = pixels(size, whole, whole)
        except ValueError:
            letter = around.letter
    shown = around.shown and values.get("display", "").lower() != "none"
    return Look(stroke, fill, colour, dashed, visible, shown, letter)


def _painted(value: str | None, around: int | None, current: int | None) -> int | None:
    if value is None or value.strip().lower() == "inherit":
        return around
    try:
        return paint(value, current)
    except ValueError:
        return around


def _nothing(opacity: str | None) -> bool:
    if opacity is None:
        return False
    try:
        return float(opacity.strip().rstrip("%")) <= 0.0
    except ValueError:
        return False
