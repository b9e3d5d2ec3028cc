"""The same carton as DXF, CF2, SVG, PDF, HPGL and LightBurn has the same edges and line types."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose

from knifetip import pipeline
from knifetip.dxf.samples import samples
from knifetip.geometry import arc
from knifetip.library import load
from knifetip.model.drawing import Drawing
from tests.support.writers import cf2_text, hpgl_text, lightburn_text, pdf_text, svg_text

SAMPLES = samples()


def as_svg(drawing: Drawing, before: str = "", scale: float = 1.0) -> bytes:
    """Return a drawing as SVG with y downwards; coordinates are divided by ``scale``."""
    radius = arc.radius(drawing.ends[:, 0], drawing.ends[:, 1], drawing.bulge)
    parts = []
    for (a, b), bulge, r, layer in zip(
        (drawing.ends / scale).tolist(),
        drawing.bulge.tolist(),
        (radius / scale).tolist(),
        drawing.layer,
        strict=True,
    ):
        to = (
            f"L{b[0]!r} {b[1]!r}"
            if bulge == 0.0
            else f"A{r!r} {r!r} 0 0 {int(bulge > 0)} {b[0]!r} {b[1]!r}"
        )
        name = drawing.layers[layer]
        parts.append(f'<g id="{name}"><path d="M{a[0]!r} {a[1]!r}{to}"/></g>')
    return svg_text.svg(
        f'<g transform="{before} translate(0,1000) scale(1,-1) scale({scale!r})">',
        *parts,
        "</g>",
        size='width="1000mm" height="1000mm"',
        box="0 0 1000 1000",
    )


def as_cf2(drawing: Drawing) -> bytes:
    """Return a drawing as CF2 with line type 1 for layer CUT and 2 for all other layers."""
    middle = arc.centre(drawing.ends[:, 0], drawing.ends[:, 1], drawing.bulge)
    records = []
    for (a, b), bulge, centre, layer in zip(
        drawing.ends.tolist(), drawing.bulge.tolist(), middle.tolist(), drawing.layer, strict=True
    ):
        kind = 1 if drawing.layers[layer] == "CUT" else 2
        places = [*a, *b, *([] if bulge == 0.0 else [*centre, math.copysign(1.0, bulge)])]
        letter = "L" if bulge == 0.0 else "A"
        records.append(f"{letter},2,{kind},0,{','.join(map(repr, places))},0,0")
    return cf2_text.cf2("C,CARTON,0,0,0,1,1", subs=cf2_text.sub("CARTON", *records))


def as_pdf(drawing: Drawing) -> bytes:
    """Return a drawing as PDF with optional content as layers and eight curves per quarter
    circle.
    """
    middle = arc.centre(drawing.ends[:, 0], drawing.ends[:, 1], drawing.bulge)
    parts = []
    for (a, b), bulge, (x, y), layer in zip(
        drawing.ends.tolist(), drawing.bulge.tolist(), middle.tolist(), drawing.layer, strict=True
    ):
        to = f"{b[0]:.9f} {b[1]:.9f} l"
        if bulge != 0.0:
            radius, first = math.dist(a, (x, y)), math.atan2(a[1] - y, a[0] - x)
            to = pdf_text.ellipse_curves(x, y, radius, radius, first, 4.0 * math.atan(bulge))
        parts.append(f"/OC /L{layer} BDC {a[0]:.9f} {a[1]:.9f} m {to} S EMC")
    size = 1000.0 * pdf_text.MM, 1000.0 * pdf_text.MM
    scale = f"{pdf_text.MM!r} 0 0 {pdf_text.MM!r} 0 0 cm"
    return pdf_text.pdf(scale, *parts, size=size, layers=drawing.layers, flate=True)


def as_lightburn(drawing: Drawing) -> bytes:
    """Return a drawing as a LightBurn project, each arc as a part of an ellipse or curve."""
    middle = arc.centre(drawing.ends[:, 0], drawing.ends[:, 1], drawing.bulge)
    shapes = [lightburn_text.layer(number, name) for number, name in enumerate(drawing.layers)]
    for (a, b), bulge, (x, y), layer in zip(
        drawing.ends.tolist(),
        drawing.bulge.tolist(),
        middle.tolist(),
        drawing.layer.tolist(),
        strict=True,
    ):
        if bulge == 0.0:
            shapes.append(lightburn_text.polyline(a, b, layer=layer))
            continue
        # Eight Bézier curves with exact ends, whose control points lie on the tangents.
        radius, first = math.dist(a, (x, y)), math.atan2(a[1] - y, a[0] - x)
        step = 4.0 * math.atan(bulge) / 8.0
        handle = 4.0 / 3.0 * math.tan(step / 4.0) * radius
        vertices = []
        for k in range(9):
            angle = first + k * step
            u, v = (
                a
                if k == 0
                else b
                if k == 8
                else (
                    x + radius * math.cos(angle),
                    y + radius * math.sin(angle),
                )
            )
            right, up = -handle * math.sin(angle), handle * math.cos(angle)
            vertices.append(f"V{u} {v}c0x{u + right}c0y{v + up}c1x{u - right}c1y{v - up}")
        curves = "".join(f"B{k} {k + 1}" for k in range(8))
        shapes.append(lightburn_text.path("".join(vertices), curves, CutIndex=layer))
    return lightburn_text.project(*shapes)


def types(drawing: Drawing) -> list[int]:
    kinds: list[int] = pipeline.classify(drawing, load.profile("default")).line_type.tolist()
    return kinds


@pytest.mark.parametrize("name", SAMPLES)
def test_a_sample_is_the_same_as_svg(name: str) -> None:
    drawing = pipeline.read(SAMPLES[name])
    again = pipeline.read(as_svg(drawing))
    assert_allclose(again.ends, drawing.ends, atol=1e-9)
    assert_allclose(again.bulge, drawing.bulge, atol=1e-9)
    assert types(again) == types(drawing)


@pytest.mark.parametrize("name", ["tuck-end-carton.dxf", "corrugated-tray.dxf"])
def test_a_sample_is_the_same_as_cf2(name: str) -> None:
    drawing = pipeline.read(SAMPLES[name])
    again = pipeline.read(as_cf2(drawing))
    assert_allclose(again.ends, drawing.ends, atol=1e-9)
    assert_allclose(again.bulge, drawing.bulge, atol=1e-9)
    assert types(again) == types(drawing)


@pytest.mark.parametrize("name", SAMPLES)
def test_a_sample_is_the_same_as_pdf(name: str) -> None:
    drawing = pipeline.read(SAMPLES[name])
    again = pipeline.read(as_pdf(drawing))
    straight, same = drawing.bulge == 0.0, again.bulge == 0.0
    assert_allclose(again.ends[same], drawing.ends[straight], atol=1e-6)
    assert_allclose(again.bounds, drawing.bounds, atol=1e-3)
    for kind in range(8):
        mine, theirs = (one.lengths[np.array(types(one)) == kind].sum() for one in (again, drawing))
        assert_allclose(mine, theirs, atol=1e-3)


@pytest.mark.parametrize("name", SAMPLES)
def test_a_sample_is_the_same_as_a_lightburn_project(name: str) -> None:
    drawing = pipeline.read(SAMPLES[name])
    again = pipeline.read(as_lightburn(drawing))
    straight, same = drawing.bulge == 0.0, again.bulge == 0.0
    assert_allclose(again.ends[same], drawing.ends[straight], atol=1e-6)
    assert_allclose(again.bounds, drawing.bounds, atol=1e-3)
    for kind in range(8):
        mine, theirs = (one.lengths[np.array(types(one)) == kind].sum() for one in (again, drawing))
        assert_allclose(mine, theirs, atol=1e-3)


@pytest.mark.parametrize("name", SAMPLES)
def test_a_sample_is_the_same_as_hpgl(name: str) -> None:
    drawing = pipeline.read(SAMPLES[name])
    again = pipeline.read(hpgl_text.plot_of(drawing))
    assert_allclose(again.ends, drawing.ends, atol=1e-6)
    assert_allclose(again.bulge, drawing.bulge, atol=1e-6)
    assert [again.layers[one] for one in again.layer] == [f"pen {one + 1}" for one in drawing.layer]


@given(st.floats(-180.0, 180.0), st.booleans(), st.floats(0.05, 20.0))
def test_a_turned_or_mirrored_page_has_the_turned_or_mirrored_edges(
    turn: float, mirror: bool, scale: float
) -> None:
    drawing = pipeline.read(SAMPLES["tuck-end-carton.dxf"])
    before = f"translate(500,500) rotate({turn!r}) {'scale(-1,1)' if mirror else ''}"
    again = pipeline.read(as_svg(drawing, before, scale))
    angle = math.radians(turn)
    spin = np.array([[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]])
    on_page = drawing.ends * [1.0, -1.0] + [0.0, 1000.0]
    moved = on_page * [-1.0 if mirror else 1.0, 1.0] @ spin.T + 500.0
    assert_allclose(again.ends, moved * [1.0, -1.0] + [0.0, 1000.0], atol=1e-6)
    assert_allclose(again.bulge, drawing.bulge * (-1.0 if mirror else 1.0), atol=1e-6)
