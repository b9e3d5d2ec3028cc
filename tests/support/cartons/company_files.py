"""Write a random carton (``Plan``) as a DXF or SVG file in the conventions of a company
(``companies``).

``truth`` finds the line type of each edge of the file by comparing positions.
"""

from __future__ import annotations

import math

import numpy as np

from knifetip.geometry import arc
from knifetip.geometry.columns import F64, U8
from knifetip.model.drawing import Drawing
from tests.support.cartons.companies import SOLID, Company, Style
from tests.support.cartons.kinds import KINDS
from tests.support.cartons.plan import Plan, Stroke
from tests.support.cartons.surroundings import FLAWS, SURROUNDINGS
from tests.support.writers import dxf_text, svg_text


def _dxf(company: Company, plan: Plan, strokes: list[Stroke]) -> bytes:
    k = company.scale
    out = []
    for s in strokes:
        layer, colour, linetype = company.style(s)
        tags: list[tuple[int, object]] = [(8, layer), (6, linetype)]
        if isinstance(colour, str):
            tags.append((420, int(colour[1:], 16)))
        else:
            tags.append((62, colour))
        if not s.bulge:
            out.append(dxf_text.line(s.x0 * k, s.y0 * k, s.x1 * k, s.y1 * k, *tags))
            continue
        ends = np.array([[[s.x0, s.y0], [s.x1, s.y1]]]) * k
        cx, cy, radius = _circle(ends[0], s.bulge)
        one, two = ends[0] if s.bulge > 0 else ends[0][::-1]
        begin = math.degrees(math.atan2(one[1] - cy, one[0] - cx))
        end = math.degrees(math.atan2(two[1] - cy, two[0] - cx))
        out.append(
            dxf_text.entity("ARC", *tags, (10, cx), (20, cy), (40, radius), (50, begin), (51, end))
        )
    for text, x, y, height, part in plan.texts:
        layer, colour, _ = company.styles.get(part) or company.styles["dimension"]
        shown = colour if isinstance(colour, int) else 7
        tags = [(8, layer), (62, shown), (10, x * k), (20, y * k), (40, height * k), (1, text)]
        out.append(dxf_text.entity("TEXT", *tags))
    names = dict.fromkeys(style[0] for style in company.styles.values())
    layers = tuple(dxf_text.layer(name) for name in names)
    version = "AC1018" if any(isinstance(s[1], str) for s in company.styles.values()) else "AC1009"
    return dxf_text.dxf(*out, layers=layers, units=company.header, version=version)


def _circle(ends: F64, bulge: float) -> tuple[float, float, float]:
    up = (1.0 - bulge * bulge) / (4.0 * bulge)
    (ax, ay), (bx, by) = ends.tolist()
    cx, cy = 0.5 * (ax + bx) - up * (by - ay), 0.5 * (ay + by) + up * (bx - ax)
    return cx, cy, math.hypot(ax - cx, ay - cy)


def _d(stroke: Stroke, k: float, x0: float, y1: float) -> str:
    ax, ay = (stroke.x0 - x0) * k, (y1 - stroke.y0) * k
    bx, by = (stroke.x1 - x0) * k, (y1 - stroke.y1) * k
    if not stroke.bulge:
        return f"M{ax:.4f} {ay:.4f}L{bx:.4f} {by:.4f}"
    ends = np.array([[stroke.x0, stroke.y0], [stroke.x1, stroke.y1]]) * k
    radius = _circle(ends, stroke.bulge)[2]
    way = int(stroke.bulge < 0)
    return f"M{ax:.4f} {ay:.4f}A{radius:.5f} {radius:.5f} 0 0 {way} {bx:.4f} {by:.4f}"


def _svg(company: Company, plan: Plan, strokes: list[Stroke]) -> bytes:
    x0, y0, x1, y1 = Plan(strokes).bounds
    k = company.scale
    groups: dict[Style, list[Stroke]] = {}
    for s in strokes:
        groups.setdefault(company.style(s), []).append(s)
    inside, rules = [], []
    for number, ((layer, colour, linetype), mine) in enumerate(groups.items()):
        paths = "".join(f'<path d="{_d(s, k, x0, y1)}" class="st{number}"/>' for s in mine)
        dash = ";stroke-dasharray:6 3" if linetype != SOLID else ""
        rules.append(f".st{number}{{fill:none;stroke:{colour};stroke-width:0.5{dash}}}")
        if company.format == "inkscape":
            inside.append(
                f'<g inkscape:groupmode="layer" inkscape:label="{layer}" id="layer{number}">'
                f"{paths}</g>"
            )
        elif layer:
            spelled = layer.replace(" ", "_x20_")
            inside.append(f'<g id="{spelled}" data-name="{layer}">{paths}</g>')
        else:
            inside.append(f"<g>{paths}</g>")
    words = "".join(
        f'<text x="{(x - x0) * k:.2f}" y="{(y1 - y) * k:.2f}" font-size="{h * k}">{text}</text>'
        for text, x, y, h, _ in plan.texts
    )
    wide, high = (x1 - x0) * k, (y1 - y0) * k
    size = f'width="{x1 - x0:.4f}mm" height="{y1 - y0:.4f}mm"'
    if company.format == "svg px":
        size = ""
    return svg_text.svg(
        f"<style>{''.join(rules)}</style>", *inside, words, size=size, box=f"0 0 {wide} {high}"
    )


def company_file(company: Company, seed: int) -> tuple[bytes, list[Stroke], str]:
    """Return the bytes of a file with a random carton, drawn in the conventions of a company.

    Returns
    -------
    data : bytes
    strokes : list of Stroke
        The lines and arcs of the file in random order, each with its line type.
    kind : str
        The name of the function in ``kinds`` that drew the carton.
    """
    rng = np.random.default_rng(seed)
    make = KINDS[seed % len(KINDS)]
    plan = make(rng)
    for what in SURROUNDINGS:
        if what in company.surroundings:
            SURROUNDINGS[what](plan)
    strokes = company.drawable(plan)
    for what in FLAWS:
        if what in company.flaws:
            strokes = FLAWS[what](strokes, rng)
    strokes = [strokes[row] for row in rng.permutation(len(strokes)).tolist()]
    write = _dxf if company.format == "dxf" else _svg
    return write(company, plan, strokes), strokes, make.__name__


def truth(drawing: Drawing, strokes: list[Stroke]) -> tuple[U8, list[str]]:
    """Return the LineType, (n,), and the part name of each edge of a drawing.

    Both are those of the stroke from which the edge was drawn, which is found by its position.
    """
    ends = np.array([((s.x0, s.y0), (s.x1, s.y1)) for s in strokes])
    bulge = np.array([s.bulge for s in strokes])
    low, high = _extent(ends, bulge)
    here_low, here_high = _extent(drawing.ends, drawing.bulge)
    scale = float((here_high - here_low).max() / (high - low).max())
    start, end = drawing.ends[:, 0], drawing.ends[:, 1]
    found = np.full(len(drawing), -1)
    least = np.full(len(drawing), np.inf)
    along = [
        (arc.point_at(start, end, drawing.bulge, np.full(len(drawing), share)) - here_low) / scale
        + low
        for share in (0.25, 0.5, 0.75)
    ]
    long = drawing.lengths / scale
    size = arc.length(ends[:, 0], ends[:, 1], bulge)
    for row, (line, bend) in enumerate(zip(ends, bulge, strict=True)):
        a, b = (np.repeat(one[None], len(drawing), 0) for one in line)
        bent = np.full(len(drawing), bend)
        away = np.zeros(len(drawing))
        for points in along:
            share = arc.nearest_fraction(a, b, bent, points)
            away = np.maximum(away, np.hypot(*(points - arc.point_at(a, b, bent, share)).T))
        # Among coincident strokes, the one with the length of the edge is taken.
        away += 1e-3 * np.minimum(np.abs(long - float(size[row])), 10.0)
        nearer = away < least - 1e-9
        found[nearer], least[nearer] = row, away[nearer]
    assert least.max(initial=0.0) < 0.3, f"an edge lies {least.max():.3f} mm from every line"
    kinds = np.array([strokes[row].truth for row in found], np.uint8)
    return kinds, [strokes[row].part for row in found]


def _extent(ends: F64, bulge: F64) -> tuple[F64, F64]:
    boxes = arc.bounding_boxes(ends[:, 0], ends[:, 1], bulge)
    return boxes[:, :2].min(axis=0), boxes[:, 2:].max(axis=0)
