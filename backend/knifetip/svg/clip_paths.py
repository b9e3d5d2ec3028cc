"""clip_paths: the visible areas that ``clip-path``, ``mask`` and ``overflow`` give to elements.

A clip path is the union of its shapes.  A mask is read as a clip path if all its shapes are filled
with white; other masks show parts of an object with less opacity, and are not applied.

Source: CSS Masking Module Level 1.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Final

import numpy as np

from knifetip.drawing_builder.clip import Clip, Region, union
from knifetip.drawing_builder.filled_region import filled_region
from knifetip.drawing_builder.white_lines import is_white
from knifetip.formats.invalid_content import InvalidContent
from knifetip.formats.limits import Limits
from knifetip.geometry.affine import Matrix, compose
from knifetip.svg import shapes
from knifetip.svg.document import Node
from knifetip.svg.lengths import to_pixels
from knifetip.svg.path_data import scan_paths
from knifetip.svg.references import href
from knifetip.svg.style import INITIAL, Appearance, Cascade
from knifetip.svg.transform import parse_transform

_URL: Final = re.compile(r"""url\(\s*(['"]?)#([^'")]+)\1\s*\)""")
#: Elements in clip paths and masks that draw nothing.
_SILENT: Final = frozenset(("title", "desc", "metadata", "style", "defs", "script"))
#: Largest number of clip paths that clip each other.
_DEPTH: Final = 8
_BLACK: Final = 0


class _UnsupportedError(Exception):
    """Raised for a clip path or mask that cannot be converted to regions."""


class ClipPaths:
    """Converts the clip paths and masks of a document to regions, and caches the regions."""

    def __init__(self, named: Mapping[str, Node], cascade: Cascade, limits: Limits) -> None:
        self._named = named
        self._cascade = cascade
        self._edges_left = limits.segments
        self._known: dict[tuple[Node, Matrix], tuple[Region, ...] | None] = {}

    def clip(
        self, clip: Clip, appearance: Appearance, matrix: Matrix, window: shapes.Window
    ) -> Clip:
        """Return the part of a clip that the clip path and the mask of an element show.

        Parameters
        ----------
        clip
            Clip that the element inherits.
        appearance
            Appearance of the element, with the references to clip path and mask.
        matrix
            Matrix from the coordinates of the element to file units.
        window
            Lengths to which percentages in the clip path refer.
        """
        return self._clip(clip, appearance, matrix, window, 0)

    def _clip(
        self,
        clip: Clip,
        appearance: Appearance,
        matrix: Matrix,
        window: shapes.Window,
        depth: int,
    ) -> Clip:
        for reference, tag in ((appearance.clip_path, "clipPath"), (appearance.mask, "mask")):
            if not reference:
                continue
            url = _URL.match(reference)
            if url is None or depth == _DEPTH:
                clip = clip._replace(incomplete=True)
                continue
            node = self._named.get(url[2])
            if node is None or node.tag != tag:
                # Browsers ignore a reference to a clip path that does not exist.
                continue
            regions = self._regions(node, matrix, window)
            if regions is None:
                clip = clip._replace(incomplete=True)
                continue
            for region in regions:
                clip = clip.intersect(region)
            own = self._cascade.appearance(node, INITIAL)
            clip = self._clip(clip, own, matrix, window, depth + 1)
        return clip

    def _regions(
        self, node: Node, matrix: Matrix, window: shapes.Window
    ) -> tuple[Region, ...] | None:
        """Return the regions whose intersection a clip path or mask shows.

        None is returned if they cannot be computed.
        """
        key = node, matrix
        if key not in self._known:
            try:
                self._known[key] = self._convert(node, matrix, window)
            except (_UnsupportedError, InvalidContent, shapes.Undrawable):
                self._known[key] = None
        return self._known[key]

    def _convert(self, node: Node, matrix: Matrix, window: shapes.Window) -> tuple[Region, ...]:
        is_mask = node.tag == "mask"
        units = "maskContentUnits" if is_mask else "clipPathUnits"
        if node.attributes.get(units, "userSpaceOnUse") != "userSpaceOnUse":
            # The region depends on the size of each object.
            raise _UnsupportedError
        outer = _with_own_transform(node, matrix)
        parts: list[Region] = []
        stack = [(node, self._cascade.appearance(node, INITIAL), outer, 0)]
        while stack:
            one, appearance, inner, uses = stack.pop()
            if one.tag in shapes.SHAPES:
                if not is_mask or _is_white_area(appearance, is_first=not parts):
                    parts.append(self._shape(one, appearance, inner, window))
                continue
            for child in reversed(_copied_nodes(one, self._named, uses)):
                if child.tag in _SILENT or not child.tag:
                    continue
                if child.tag not in shapes.SHAPES and child.tag not in ("g", "use"):
                    raise _UnsupportedError
                look = self._cascade.appearance(child, appearance)
                if look.clip_path or look.mask:
                    raise _UnsupportedError
                placed = _with_own_transform(child, inner)
                if child.tag == "use":
                    x, y = (
                        to_pixels(child.attributes.get(name, "0"), length)
                        for name, length in zip(("x", "y"), window, strict=False)
                    )
                    placed = compose(placed, (1.0, 0.0, 0.0, 1.0, x, y))
                if look.shown and (look.visible or child.tag not in shapes.SHAPES):
                    stack.append((child, look, placed, uses + (child.tag == "use")))
        region = union(parts)
        frame = _mask_frame(node, window) if is_mask else ""
        return (region, self._outline(frame, outer, even_odd=False)) if frame else (region,)

    def _shape(
        self, node: Node, appearance: Appearance, matrix: Matrix, window: shapes.Window
    ) -> Region:
        try:
            data = shapes.shape_path_data(node, window)
        except shapes.Undrawable:
            return Region()
        return self._outline(data, matrix, even_odd=appearance.clip_even_odd)

    def _outline(self, data: str, matrix: Matrix, *, even_odd: bool) -> Region:
        """Return the region inside a path; the total number of edges of all regions is limited."""
        table = scan_paths([data], self._edges_left)
        if table is None or table.wrong[0] >= 0:
            raise _UnsupportedError
        region = filled_region(table, matrix, even_odd=even_odd)
        self._edges_left -= len(region.edges)
        if self._edges_left < 0 or not np.isfinite(region.edges).all():
            raise _UnsupportedError
        return region


def _copied_nodes(node: Node, named: Mapping[str, Node], uses: int) -> list[Node]:
    """Return the children of a group, or the element that a ``use`` element copies."""
    if node.tag != "use":
        return node.children
    target = named.get(href(node).removeprefix("#"))
    if target is None or uses > _DEPTH:
        raise _UnsupportedError
    return [target]


def _with_own_transform(node: Node, matrix: Matrix) -> Matrix:
    text = node.attributes.get("transform")
    return matrix if text is None else compose(matrix, parse_transform(text))


def _is_white_area(appearance: Appearance, *, is_first: bool) -> bool:
    """Return whether a shape of a mask shows what lies inside it.

    A black shape below all others shows nothing.  Other shapes are not supported.
    """
    stroke, fill = appearance.drawn_stroke, appearance.drawn_fill
    opaque = appearance.fill_opacity * appearance.opacity > 0.98
    if fill is not None and is_white(fill) and opaque and (stroke is None or is_white(stroke)):
        return True
    if stroke in (None, _BLACK) and (fill is None or (fill == _BLACK and is_first)):
        return False
    raise _UnsupportedError


def _mask_frame(node: Node, window: shapes.Window) -> str:
    """Return the path data of the rectangle outside of which a mask shows nothing.

    The result is empty if the rectangle depends on the size of the object, which it then contains.
    """
    attributes = node.attributes
    if attributes.get("maskUnits") != "userSpaceOnUse":
        return ""
    x, y, wide, high = (
        to_pixels(attributes.get(name, default), length)
        for name, default, length in (
            ("x", "-10%", window[0]),
            ("y", "-10%", window[1]),
            ("width", "120%", window[0]),
            ("height", "120%", window[1]),
        )
    )
    return f"M{x!r} {y!r}h{wide!r}v{high!r}h{-wide!r}z"


def window_region(width: float, height: float, matrix: Matrix) -> Region:
    """Return the region of a window with its upper left corner at (0, 0).

    ``matrix`` maps the coordinates of the window to file units.
    """
    table = scan_paths([f"M0 0h{width!r}v{height!r}h{-width!r}z"], 8)
    return Region() if table is None else filled_region(table, matrix, even_odd=False)
