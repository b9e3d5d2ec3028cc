"""Small drawings for tests of classification, and functions that classify them."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from knifetip.classification.classify import classify
from knifetip.classification.shape.features import extract_shape_features
from knifetip.classification.shape.roles import Role
from knifetip.library import load
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.drawing import Annotation, Drawing
from tests.support.drawings import Header, Style, drawing

Line = tuple[float, float, float, float]


def box(x0: float, y0: float, x1: float, y1: float) -> list[Line]:
    """Return the four sides of a rectangle, counter-clockwise, as (x1, y1, x2, y2)."""
    return [(x0, y0, x1, y0), (x1, y0, x1, y1), (x1, y1, x0, y1), (x0, y1, x0, y0)]


#: 300 × 200 mm with two creases across.
BLANK = [*box(0, 0, 300, 200), (100, 0, 100, 200), (200, 0, 200, 200)]


def text(x: float, y: float, words: str = "A") -> Annotation:
    """Return a text annotation of 4 mm height at (x, y)."""
    return Annotation(words, x, y, 4.0, math.nan, "TEXT", "0")


def roles(
    lines: Sequence[Line],
    bulge: ArrayLike | None = None,
    texts: tuple[Annotation, ...] = (),
) -> list[Role]:
    """Return the role of each line, determined by shape only."""
    ends = np.array(lines, float).reshape(-1, 2, 2)
    bent = np.zeros(len(ends)) if bulge is None else np.array(bulge, float)
    return [Role(int(role)) for role in extract_shape_features(ends, bent, texts).role]


def side_by_side(
    styles: Sequence[Style],
    *,
    ends: ArrayLike | None = None,
    bulge: ArrayLike | None = None,
    true_colour: ArrayLike | None = None,
    kinds: Sequence[str] | None = None,
    unit: str = "mm",
) -> Drawing:
    """Return a drawing with one edge per style, by default 10 mm long and 10 mm apart.

    Parameters
    ----------
    ends : (n, 2, 2), optional
        Positions of the edges, in place of the default ones.
    bulge, true_colour, kinds : (n,), optional
        As in ``drawings.drawing``.
    unit
        Unit of the coordinates.
    """
    if ends is None:
        x = 20.0 * np.arange(len(styles))
        ends = np.stack([np.stack([x, 0 * x], 1), np.stack([x + 10.0, 0 * x], 1)], axis=1)
    return drawing(
        ends, styles, bulge=bulge, true_colour=true_colour, kinds=kinds, header=Header(unit)
    )


def drawing_of(*parts: tuple[Sequence[Line], Style]) -> Drawing:
    """Return a drawing (mm) of groups of lines; all lines of a group have one style."""
    lines = [line for part, _ in parts for line in part]
    styles = [style for part, style in parts for _ in part]
    return drawing(np.array(lines, float), styles)


def style(layer: str = "0", colour: int = 7, linetype: str = "CONTINUOUS") -> Style:
    """Return a style: layer, AutoCAD colour index and linetype."""
    return layer, colour, linetype


def classified(sheet: Drawing, profile: str = "default") -> Dieline:
    """Return the dieline of a drawing, classified with a profile of the library."""
    return classify(sheet, load.profile(profile), load.conventions())


def words(dieline: Dieline) -> list[str]:
    """Return the name of the line type of each edge."""
    return [LineType(kind).word for kind in dieline.line_type]
