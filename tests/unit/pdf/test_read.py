"""Whole files: positions, sizes, spot colours, layers and the import report."""

from __future__ import annotations

import math
import zlib

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose

from knifetip import pipeline
from knifetip.geometry import arc
from knifetip.library import load
from knifetip.messages import Message
from knifetip.model.dieline import LineType
from knifetip.model.drawing import Drawing, ImportOutcome
from knifetip.pdf.read import read
from knifetip.svg.read import read as read_svg
from tests.support.drawings import report_reasons
from tests.support.reading import assert_lengths_add_up
from tests.support.writers import svg_text
from tests.support.writers.pdf_text import (
    MM,
    carton,
    ellipse_curves,
    objects,
    pdf,
    separation,
    stream,
)


def reasons(drawing: Drawing) -> dict[str, str]:
    return dict(zip(drawing.import_report.handle, report_reasons(drawing), strict=True))


def outcomes(drawing: Drawing) -> list[tuple[str, str]]:
    return list(zip(drawing.import_report.kind, report_reasons(drawing), strict=True))


# ── The same carton as SVG ────────────────────────────────────────────────────────────────────


def off(one: Drawing, other: Drawing) -> float:
    """Return the greatest distance between two drawings."""
    points = arc.points_along(one.ends[:, 0], one.ends[:, 1], one.bulge, 9).reshape(-1, 2)
    start, end = other.ends[:, 0], other.ends[:, 1]
    farthest = 0.0
    for point in points:
        many = np.broadcast_to(point, start.shape)
        share = arc.nearest_fraction(start, end, other.bulge, many)
        near = arc.point_at(start, end, other.bulge, share)
        farthest = max(farthest, float(np.hypot(*(near - many).T).min()))
    return farthest


@pytest.mark.parametrize("layered", [True, False])
@pytest.mark.parametrize("flate", [True, False])
def test_the_carton_equals_that_of_the_svg(layered: bool, flate: bool) -> None:
    # Without the ellipse, which both readers fit with different arcs within 0.01 mm.
    ellipse = b'<ellipse cx="85" cy="50" rx="12" ry="6"/>'
    as_svg = read_svg(svg_text.carton().replace(ellipse, b""))
    ours = read(carton(layered=layered, flate=flate))
    assert ours.layers == (("CUT", "CREASE") if layered else ("CutContour", "Crease"))
    assert ours.linetypes == as_svg.linetypes == ("Continuous", "dashed")
    assert_allclose(ours.bounds, as_svg.bounds, atol=1e-9)
    kept = np.zeros(len(ours), bool)
    kept[ours.entity != 2] = True
    plain = pick(ours, kept)
    assert max(off(plain, as_svg), off(as_svg, plain)) < 1e-3
    for name in (0, 1):
        mine, theirs = (one.lengths[one.layer == name].sum() for one in (plain, as_svg))
        assert_allclose(mine, theirs, atol=1e-3)
    assert ours.annotations[0].text == as_svg.annotations[0].text == "A carton"
    assert_allclose(ours.annotations[0].height, 4.0)
    assert_allclose((ours.annotations[0].x, ours.annotations[0].y), (20.0, 2.0))


def pick(drawing: Drawing, kept: np.ndarray) -> Drawing:
    """Return the drawing with the chosen edges only."""
    columns = (
        *("ends", "bulge", "entity", "layer", "colour", "true_colour", "linetype"),
        "line_width",
    )
    given = {name: getattr(drawing, name)[kept] for name in columns}
    rest = {
        name: getattr(drawing, name) for name in ("layers", "linetypes", "import_report", "unit")
    }
    return Drawing(**given, **rest, evidence=Message("unit.not-given"))


def test_its_ellipse_is_approximated_within_a_hundredth() -> None:
    drawing = read(carton())
    ellipse = drawing.entity == 2
    points = arc.points_along(
        drawing.ends[ellipse, 0], drawing.ends[ellipse, 1], drawing.bulge[ellipse], 20
    )
    x, y = ((points.reshape(-1, 2) - [85, 50]) / [12, 6]).T
    # A point at distance e from the ellipse has a radius that differs from 1 by at most
    # e / (smaller half axis).
    assert np.abs(np.hypot(x, y) - 1).max() <= 0.0101 / 6


@pytest.mark.parametrize("layered", [True, False])
def test_it_is_classified_without_a_question(layered: bool) -> None:
    drawing = pipeline.read(carton(layered=layered))
    dieline = pipeline.classify(drawing, load.profile("default"))
    assert pipeline.questions(drawing, dieline) == []
    lengths = {
        kind: drawing.lengths[dieline.line_type == kind].sum()
        for kind in (LineType.CUT, LineType.CREASE)
    }
    # PathBuilder, circle and ellipse; three creases of 80 mm.
    outline = 2 * 200 + 2 * 80 - 2 * 20 + 10 * math.pi
    assert_allclose(lengths[LineType.CUT], outline + 16 * math.pi + 58.13, atol=0.01)
    assert_allclose(lengths[LineType.CREASE], 240)


# ── Positions ────────────────────────────────────────────────────────────────────────────────────


def test_a_point_is_a_seventy_second_of_an_inch() -> None:
    drawing = read(pdf("0 0 m 72 36 l S"))
    assert_allclose(drawing.ends, [[[0.0, 0.0], [25.4, 12.7]]])
    assert (drawing.unit, drawing.stated) == ("pt", "pt")
    assert drawing.evidence.code == "unit.pdf"


def test_a_user_unit_makes_the_page_larger() -> None:
    drawing = read(pdf("0 0 m 72 36 l S", page="/UserUnit 10"))
    assert_allclose(drawing.ends, [[[0, 0], [254, 127]]])
    assert drawing.evidence == Message("unit.pdf-scaled", scale=10)


def test_the_unit_of_the_user_has_priority() -> None:
    drawing = read(pdf("0 0 m 72 36 l S"), "mm")
    assert_allclose(drawing.ends, [[[0, 0], [72, 36]]])
    assert (drawing.unit, drawing.evidence.code, drawing.stated) == ("mm", "unit.given", "pt")


@pytest.mark.parametrize(
    ("turn", "ends"),
    [
        # A page of 2 by 1 in, with a line of one inch to the right from its lower left corner.
        (0, [[0, 0], [1, 0]]),
        (90, [[0, 2], [0, 1]]),
        (180, [[2, 1], [1, 1]]),
        (270, [[1, 0], [1, 1]]),
        (-90, [[1, 0], [1, 1]]),
    ],
)
def test_a_page_is_rotated_clockwise(turn: int, ends: list[list[float]]) -> None:
    drawing = read(pdf("0 0 m 72 0 l S", size=(144.0, 72.0), page=f"/Rotate {turn}"))
    assert_allclose(drawing.ends / 25.4, [ends], atol=1e-12)


def test_lines_outside_the_crop_box_are_dropped() -> None:
    drawing = read(
        pdf(
            "20 20 m 30 30 l S 0 0 m 5 5 l S 15 15 m 1 0 l S",
            page="/CropBox [10 10 90 90]",
        )
    )
    assert_allclose(drawing.ends[0] * MM, [[10, 10], [20, 20]])
    assert outcomes(drawing) == [
        ("path", "the object was imported unchanged"),
        ("path", "the object lies outside the visible area of the page"),
        (
            "path",
            "the object was imported; note: a part of the object lies outside "
            "the visible area of the page",
        ),
    ]


def test_graphics_states_are_stacked_and_matrices_nested() -> None:
    drawing = read(
        pdf(
            "q 2 0 0 2 10 0 cm q 0 1 -1 0 0 0 cm 0 0 m 5 0 l S Q 0 0 m 5 0 l S Q 0 0 m 5 0 l S",
        )
    )
    # Rotated by 90°, then scaled by 2 and moved by 10.
    assert_allclose(
        drawing.ends * MM, [[[10, 0], [10, 10]], [[10, 0], [20, 0]], [[0, 0], [5, 0]]], atol=1e-12
    )


def test_a_rectangle_is_a_contour_of_four_lines() -> None:
    drawing = read(pdf("10 20 30 40 re S"))
    assert_allclose(drawing.bounds * MM, [10, 20, 40, 60])
    assert (drawing.ends[:-1, 1] == drawing.ends[1:, 0]).all()
    assert_allclose(drawing.ends[-1, 1], drawing.ends[0, 0])


def test_the_three_ways_to_write_a_curve() -> None:
    # The same curve with the first handle at the start, with the second at the end, with neither.
    by_v = read(pdf("0 0 m 30 40 60 0 v S"))
    by_y = read(pdf("0 0 m 30 40 60 0 y S"))
    by_c = read(pdf("0 0 m 0 0 30 40 60 0 c S"))
    assert_allclose(by_v.ends, by_c.ends)
    # At its middle: 3/8 of each handle and 1/8 of each end.
    assert_allclose(by_v.bounds[3] * MM, 40 * 4 / 9, atol=0.05)
    assert_allclose(by_y.bounds[3], by_v.bounds[3], atol=0.02)
    assert_allclose(by_v.lengths.sum(), by_y.lengths.sum(), rtol=1e-3)


@pytest.mark.parametrize(
    ("paints", "lines"), [("S", 2), ("s", 3), ("B", 2), ("b*", 3), ("f", 2), ("n", 0)]
)
def test_painting_operators_may_close_the_path(paints: str, lines: int) -> None:
    assert len(read(pdf(f"0 0 m 10 0 l 10 10 l {paints}"))) == lines


coordinates = st.integers(0, 200).map(lambda value: value / 2)


@given(st.lists(st.tuples(coordinates, coordinates), min_size=4, max_size=4, unique=True))
def test_a_curve_is_approximated_within_a_hundredth(control: list[tuple[float, float]]) -> None:
    (a, b), (c, d), (e, f), (x, y) = control
    drawing = read(pdf(f"{MM!r} 0 0 {MM!r} 0 0 cm {a} {b} m {c} {d} {e} {f} {x} {y} c S"))
    t = np.linspace(0, 1, 200)[:, None]
    true = sum(
        math.comb(3, k) * t**k * (1 - t) ** (3 - k) * np.array(point)
        for k, point in enumerate(control)
    )
    away = np.full(len(true), np.inf)
    for (start, end), bulge in zip(drawing.ends, drawing.bulge, strict=True):
        many = np.broadcast_to(start, true.shape), np.broadcast_to(end, true.shape)
        near = arc.nearest_fraction(*many, np.full(len(true), bulge), true)
        at = arc.point_at(*many, np.full(len(true), bulge), near)
        away = np.minimum(away, np.hypot(*(at - true).T))
    assert away.max() <= 0.0101


@given(st.floats(-180, 180), st.booleans(), st.floats(0.1, 10))
def test_rotating_or_mirroring_a_page_transforms_its_edges(
    turn: float, mirror: bool, size: float
) -> None:
    path = f"10 0 m {ellipse_curves(0, 0, 10, 10, 0, 2.0)} 30 40 l S"
    angle = math.radians(turn)
    spin = size * np.array(
        [[math.cos(angle), math.sin(angle)], [-math.sin(angle), math.cos(angle)]]
    )
    spin = spin * [[1], [-1]] if mirror else spin
    (a, b), (c, d) = spin.tolist()
    wide = (4000.0, 4000.0)
    plain = read(pdf(f"1 0 0 1 2000 2000 cm {path}", size=wide))
    turned = read(pdf(f"{a:.9f} {b:.9f} {c:.9f} {d:.9f} 2000 2000 cm {path}", size=wide))
    middle = 2000.0 / MM
    assert_allclose(
        turned.ends[-1], (plain.ends[-1] - middle) @ spin + middle, atol=1e-5 * max(1.0, size)
    )
    assert_allclose(turned.lengths.sum(), size * plain.lengths.sum(), rtol=1e-3)


# ── Style ─────────────────────────────────────────────────────────────────


@pytest.mark.parametrize(
    ("looks", "true_colour", "index"),
    [
        ("", 0x000000, 7),
        ("1 0 0 RG", 0xFF0000, 1),
        ("0.5 G", 0x808080, 7),
        ("0 1 0 0 K", 0xFF00FF, 6),
        ("1 0 0 0 K", 0x00FFFF, 4),
        ("/DeviceRGB CS 0 0 1 SC", 0x0000FF, 5),
        ("/Cut CS 1 SCN", 0xFF00FF, 6),
        ("/Cut CS 0.5 SCN", 0xFF80FF, 7),
        ("/Cut CS", 0xFF00FF, 6),
        ("/Icc CS 0 1 0 SCN", 0x00FF00, 3),
        ("/Table CS 1 SCN", 0xFF0000, 1),
        ("/Program CS 1 SCN", 0x0080FF, 4),
        ("/Strange CS 1 SCN", -1, 7),
        ("/Pattern CS /P0 SCN", -1, 7),
        ("/Gone CS 1 SCN", -1, 7),
        ("1 0 0 RG q 0 0 1 RG Q", 0xFF0000, 1),
        ("1 0 0 rg", 0x000000, 7),
    ],
)
def test_a_stroke_has_a_true_colour_and_the_nearest_index(
    looks: str, true_colour: int, index: int
) -> None:
    table = "/FunctionType 0 /Domain [0 1] /Range [0 1 0 1 0 1] /Size [2] /BitsPerSample 8"
    drawing = read(
        pdf(
            f"{looks} 0 0 m 10 0 l S",
            spaces="/Icc 6 0 R /Table 8 0 R /Program 10 0 R /Strange 12 0 R",
            more=[
                "[/ICCBased 7 0 R]",
                stream(b"", "/N 3"),
                "[/Separation /Red /DeviceRGB 9 0 R]",
                stream(b"\xff\xff\xff\xff\x00\x00", table),
                "[/Separation /Blue /DeviceRGB 11 0 R]",
                stream(b"{0 exch dup .5 mul exch}", "/FunctionType 4"),
                "[/Separation /Green /DeviceRGB 13 0 R]",
                stream(b"{dup 0.5 gt {1} {0} ifelse 1 1}", "/FunctionType 4"),
            ],
        )
    )
    assert (drawing.true_colour.tolist(), drawing.colour.tolist()) == ([true_colour], [index])


def test_a_spot_colour_is_the_layer_of_lines_without_one() -> None:
    drawing = read(
        pdf("/Cut CS 1 SCN 0 0 m 9 0 l S /Fold CS 1 SCN 0 5 m 9 5 l S 0 G 0 9 m 9 9 l S")
    )
    assert drawing.layers == ("CutContour", "Crease", "0")


@pytest.mark.parametrize(
    ("ink", "layer"),
    [("Thru-cut", "Thru-cut"), ("Kiss#20cut", "Kiss cut"), ("Dieline", "Dieline"), ("Black", "0")],
)
def test_the_name_of_an_ink_is_not_changed(ink: str, layer: str) -> None:
    spot = separation(ink, "0 0 0 1")
    drawing = read(pdf("/X CS 1 SCN 0 0 m 9 0 l S", spaces=f"/X {spot}"))
    assert drawing.layers == (layer,)


def test_the_only_used_ink_of_several_is_the_name() -> None:
    space = (
        "[/DeviceN [/Cyan /Perf] /DeviceCMYK <</FunctionType 2 /Domain [0 1] /C0 [0 0 0 0] "
        "/C1 [1 0 0 0] /N 1>>]"
    )
    file = pdf("/X CS 0 1 SCN 0 0 m 9 0 l S", spaces=f"/X {space}")
    assert read(file).layers == ("Perf",)


@pytest.mark.parametrize(
    ("names", "layers"),
    [
        # Layers that name a line type.
        (("CUT", "CREASE"), ("CUT", "CREASE")),
        # Layers that do not: the spot colour is the name.
        (("Dieline", "Dieline"), ("CutContour", "Crease")),
        (("Layer 1", "Ebene 2"), ("CutContour", "Crease")),
    ],
)
def test_the_layer_is_the_name_unless_it_is_vague(
    names: tuple[str, str], layers: tuple[str, str]
) -> None:
    drawing = read(
        pdf(
            "/OC /L0 BDC /Cut CS 1 SCN 0 0 m 9 0 l S EMC",
            "/OC /L1 BDC /Fold CS 1 SCN 0 5 m 9 5 l S EMC",
            layers=names,
        )
    )
    assert drawing.layers == layers


def test_several_spot_colours_on_one_layer_are_the_names() -> None:
    drawing = read(
        pdf(
            "/OC /L0 BDC /Cut CS 1 SCN 0 0 m 9 0 l S /Fold CS 1 SCN 0 5 m 9 5 l S EMC",
            layers=["Outside"],
        )
    )
    assert drawing.layers == ("CutContour", "Crease")
    assert (
        reasons(drawing)["#1"]
        == "the object was imported; note: the object also lies on the layer Outside"
    )


@pytest.mark.parametrize(
    ("dash", "linetype"),
    [
        ("[4 2] 0 d", "dashed"),
        ("[] 0 d", "Continuous"),
        ("[0] 0 d", "Continuous"),
        ("", "Continuous"),
    ],
)
def test_dashes_are_a_linetype(dash: str, linetype: str) -> None:
    assert read(pdf(f"{dash} 0 0 m 9 0 l S")).linetypes == (linetype,)


def test_graphics_state_dictionary_sets_dashes_and_opacity() -> None:
    drawing = read(
        pdf(
            "q /Dash gs 0 0 m 9 0 l S Q /Gone gs 0 5 m 9 5 l S",
            resources="/ExtGState <</Dash <</D [[3 1] 0]>> /Gone <</CA 0>>>>",
        )
    )
    assert drawing.linetypes == ("dashed",)
    assert reasons(drawing)["#2"] == "the object is completely transparent"


# ── Hidden layers ─────────────────────────────────────────────────────────────────

TWO = "/OC /L0 BDC 0 0 m 9 0 l S EMC /OC /L1 BDC 0 5 m 8 5 l S EMC"


@pytest.mark.parametrize(
    ("default", "shown"),
    [
        ("", [0, 1]),
        ("/OFF [6 0 R]", [1]),
        ("/BaseState /OFF /ON [6 0 R]", [0]),
        ("/BaseState /OFF", []),
    ],
)
def test_a_layer_that_is_off_is_hidden(default: str, shown: list[int]) -> None:
    drawing = read(pdf(TWO, layers=["Cut", "Perf"], default=default))
    assert [("Cut", "Perf").index(name) for name in drawing.layers] == shown
    for row in {0, 1} - set(shown):
        name = ("Cut", "Perf")[row]
        assert (
            report_reasons(drawing)[row]
            == f"the object is hidden, because the layer {name} is switched off"
        )
        assert drawing.import_report.layer[row] == name


@pytest.mark.parametrize(
    ("policy", "shown"),
    [("", True), ("/P /AllOn", False), ("/P /AnyOff", True), ("/P /AllOff", False)],
)
def test_the_policy_of_a_membership_determines_visibility(policy: str, shown: bool) -> None:
    drawing = read(
        pdf(
            "/OC /L2 BDC 0 0 m 9 0 l S EMC",
            layers=["Cut", "Perf"],
            default="/OFF [7 0 R]",
            properties="/L2 8 0 R ",
            more=[f"<</Type /OCMD /OCGs [6 0 R 7 0 R] {policy}>>"],
        )
    )
    assert len(drawing) == shown


def test_a_visible_layer_inside_a_hidden_one_is_hidden() -> None:
    drawing = read(
        pdf(
            "/OC /L0 BDC /OC /L1 BDC 0 0 m 9 0 l S EMC EMC 0 5 m 9 5 l S",
            layers=["Cut", "Perf"],
            default="/OFF [6 0 R]",
        )
    )
    assert report_reasons(drawing) == (
        "the object is hidden, because the layer Cut is switched off",
        "the object was imported unchanged",
    )


# ── Forms ─────────────────────────────────────────────────────────────────────────────────────


def form(content: str, entries: str = "") -> bytes:
    return stream(content.encode(), f"/Type /XObject /Subtype /Form {entries}")


def test_a_form_is_copied_to_its_position() -> None:
    drawing = read(
        pdf(
            "1 0 0 1 20 0 cm /Fm0 Do 1 0 0 1 20 0 cm /Cut CS 1 SCN /Fm0 Do",
            resources="/XObject <</Fm0 6 0 R>>",
            more=[form("0 0 m 5 0 l S", "/Matrix [2 0 0 2 0 10] /BBox [0 -1 99 99]")],
        )
    )
    assert_allclose(drawing.ends * MM, [[[20, 10], [30, 10]], [[40, 10], [50, 10]]])
    assert drawing.import_report.handle == ("Fm0/#1", "Fm0/#2")
    assert drawing.layers == ("0", "CutContour")


def test_a_form_has_its_own_resources_and_layer() -> None:
    inner = "/Resources <</ColorSpace <</Cut [/Separation /Perf /DeviceGray 9 0 R]>>>> /OC 6 0 R"
    drawing = read(
        pdf(
            "/Fm0 Do /Cut CS 1 SCN 0 0 m 5 0 l S",
            resources="/XObject <</Fm0 7 0 R>>",
            layers=["Layer 1"],
            more=[form("/Cut CS 1 SCN 0 9 m 5 9 l S", inner)],
        )
    )
    assert drawing.layers == ("Perf", "CutContour")


def test_the_box_of_a_form_clips_its_content() -> None:
    drawing = read(
        pdf(
            "/Fm0 Do",
            resources="/XObject <</Fm0 6 0 R>>",
            more=[form("0 0 m 5 0 l S 20 20 m 30 20 l S", "/BBox [0 0 10 10]")],
        )
    )
    assert [outcome for _, outcome in outcomes(drawing)] == [
        "the object was imported unchanged",
        "the object lies outside its clip path or mask, so it is not visible",
    ]


def test_a_form_that_contains_itself_is_dropped() -> None:
    drawing = read(
        pdf(
            "/A Do",
            resources="/XObject <</A 6 0 R /B 7 0 R>>",
            more=[form("0 0 m 5 0 l S /B Do"), form("/A Do 0 9 m 5 9 l S")],
        )
    )
    assert reasons(drawing)["A/B/#2"] == "the object contains a reference to itself"
    assert len(drawing) == 2


# ── Import report ────────────────────────────────────────────────────────────────────────────────


def test_lengths_in_the_report_add_up() -> None:
    drawing = read(carton())
    assert_lengths_add_up(drawing)
    dropped = drawing.import_report.outcome == ImportOutcome.DROPPED
    assert [drawing.import_report.kind[row] for row in np.flatnonzero(dropped).tolist()] == ["text"]


def test_every_object_has_a_row_and_dropped_ones_a_reason() -> None:
    drawing = read(
        pdf(
            "0 0 m 9 0 l S 0 0 9 9 re f 0 0 50 50 re W n 0 0 9 9 re n",
            "/Im0 Do /Gone Do BI /W 1 /H 1 /BPC 8 ID x EI /Sh0 sh 5 5 m S 5 5 l S 1 m 9 9 l S",
            "BT /F1 9 Tf (words) Tj ET 1 2 frobnicate /None CS 1 SCN 0 3 m 9 3 l S 1 1 m 2 2 l",
            resources="/XObject <</Im0 6 0 R>>",
            page="/Annots [1 0 R 2 0 R]",
            more=[stream(b"x", "/Subtype /Image")],
            spaces="/None [/Separation /None /DeviceGray 1 0 R]",
        )
    )
    assert outcomes(drawing) == [
        ("path", "the object was imported unchanged"),
        (
            "path",
            "the object is a filled area without an outline; "
            + "the outlines of filled areas are cut only on pages that have no lines",
        ),
        ("path", "the object only limits the visible area of other objects (clipping path)"),
        ("path", "the object has neither a stroke nor a fill, so it is not visible"),
        ("image", "the object is an image, which is not cut"),
        (
            "form",
            "the PDF page uses a form or image with the name 'Gone', "
            "which the PDF does not contain",
        ),
        ("image", "the object is an image, which is not cut"),
        ("shading", "the object is a shading (colour gradient), which is not cut"),
        ("path", "the path of the object is empty"),
        ("path", "a coordinate of the object is not a number"),
        ("path", "the path uses the PDF operator 'm' with a wrong number or type of values"),
        ("text", "the object is a text, which is not cut"),
        ("operator", "the PDF page uses the operator 'frobnicate', which is not supported"),
        ("path", "the object is completely transparent"),
        (
            "path",
            (
                "the path has neither a stroke nor a fill, because the page "
                "ends before the path ends"
            ),
        ),
        ("annotation", "2 notes and form fields on the PDF page are not cut"),
    ]


def test_fills_are_lines_only_on_pages_without_strokes() -> None:
    drawing = read(pdf("1 0 0 rg 0 0 9 9 re f"))
    assert len(drawing) == 4
    assert drawing.true_colour.tolist() == [0xFF0000] * 4
    assert reasons(drawing)["#1"] == (
        "the object was imported; note: the object is the outline of a filled area, which was "
        "imported because the page has no lines"
    )


def test_only_the_first_page_is_read_and_others_are_reported() -> None:
    page = "<</Type /Page /Parent 2 0 R /MediaBox [0 0 9 9] /Contents {} 0 R>>"
    drawing = read(
        objects(
            "<</Type /Catalog /Pages 2 0 R>>",
            "<</Type /Pages /Kids [3 0 R 4 0 R] /Count 2>>",
            page.format(5),
            page.format(6),
            stream(b"0 0 m 9 0 l S"),
            stream(b"0 0 m 7 0 l S"),
        )
    )
    assert_allclose(drawing.lengths * MM, [9])
    assert outcomes(drawing)[-1] == (
        "page",
        "The file has 1 other page besides page 1, and only page 1 is read. Page 2 "
        "has the most lines of the other pages (1).",
    )


def test_a_page_may_have_several_content_streams() -> None:
    drawing = read(
        objects(
            "<</Type /Catalog /Pages 2 0 R>>",
            "<</Type /Pages /Kids [3 0 R] /Count 1 /MediaBox [0 0 9 9]>>",
            "<</Type /Page /Parent 2 0 R /Contents [4 0 R 5 0 R]>>",
            stream(b"0 0 m 9"),
            stream(b"0 l S", flate=True),
        )
    )
    assert_allclose(drawing.lengths * MM, [9])


def test_texts_are_decoded_by_the_table_of_their_font() -> None:
    table = b"1 beginbfrange <0003> <0005> <0041> endbfrange 1 beginbfchar <0009> <00DF> endbfchar"
    drawing = read(
        pdf(
            "BT /F2 10 Tf 2 0 0 2 30 40 Tm [<0003> 5 <0004> -300 <0009>] TJ 0 -12 Td <0005> Tj ET",
            "BT /F3 10 Tf (abc) Tj ET",
            more=[
                "<</Type /Font /Subtype /Type0 /ToUnicode 7 0 R>>",
                stream(table),
                "<</Type /Font /Subtype /Type0>>",
            ],
            fonts="/F2 6 0 R /F3 8 0 R",
        )
    )
    (words,) = drawing.annotations
    assert words.text == "AB ß C"
    assert_allclose(np.array([words.x, words.y, words.height]) * MM, [30, 40, 20])
    assert outcomes(drawing)[1] == (
        "text",
        "the object is a text, which is not cut; its wording cannot be shown, because its font "
        "does not state which characters it has",
    )


def test_objects_may_be_packed_into_a_stream() -> None:
    """Read an object stream and a cross-reference stream, which PDF 1.5 introduced."""
    content = stream(b"0 0 m 72 0 l S", flate=True)
    packed = [
        "<</Type /Catalog /Pages 2 0 R>>",
        "<</Type /Pages /Kids [3 0 R] /Count 1>>",
        "<</Type /Page /Parent 2 0 R /MediaBox [0 0 99 99] /Contents 4 0 R>>",
    ]
    places = [sum(len(one) + 1 for one in packed[:k]) for k in range(3)]
    index = " ".join(f"{k + 1} {place}" for k, place in enumerate(places)) + " "
    body = (index + "\n".join(packed)).encode()
    file = bytearray(b"%PDF-1.5\n")
    at = {}
    for number, one in ((4, content), (5, stream(body, f"/Type /ObjStm /N 3 /First {len(index)}"))):
        at[number] = len(file)
        file += f"{number} 0 obj\n".encode() + one + b"\nendobj\n"
    at[6] = len(file)
    rows = [(0, 0, 255), *((2, 5, k) for k in range(3)), *((1, at[k], 0) for k in (4, 5, 6))]
    table = b"".join(
        kind.to_bytes(1, "big") + where.to_bytes(4, "big") + third.to_bytes(1, "big")
        for kind, where, third in rows
    )
    table = zlib.compress(table)
    file += (
        f"6 0 obj\n<</Type /XRef /Size 7 /W [1 4 1] /Root 1 0 R /Filter /FlateDecode "
        f"/Length {len(table)}>>\nstream\n"
    ).encode()
    file += table + f"\nendstream\nendobj\nstartxref\n{at[6]}\n%%EOF\n".encode()
    assert_allclose(read(bytes(file)).lengths, [25.4])
