"""Whole files: positions, sizes, colours, layers, the import report, files of other programs."""

from __future__ import annotations

import gzip
import math
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose

from knifetip import pipeline
from knifetip.dxf import read as dxf
from knifetip.geometry import arc
from knifetip.geometry.columns import F64
from knifetip.library import load
from knifetip.messages import Message
from knifetip.model.drawing import Drawing, ImportOutcome
from knifetip.svg.read import read
from tests.support.drawings import report_reasons
from tests.support.reading import assert_lengths_add_up
from tests.support.writers.svg_text import SVG, carton, svg


def reasons(drawing: Drawing) -> dict[str, str]:
    return dict(zip(drawing.import_report.handle, report_reasons(drawing), strict=True))


def only(text: str, **fields: str) -> Drawing:
    """Return the drawing of one element on a page of 100 by 100 mm."""
    return read(svg(text, **fields))


# ── Positions ────────────────────────────────────────────────────────────────────────────────────


def test_y_is_upwards_from_the_lower_edge_of_the_page() -> None:
    drawing = only('<line x1="10" y1="10" x2="30" y2="40"/>')
    assert drawing.ends.tolist() == [[[10, 90], [30, 60]]]
    assert drawing.unit == drawing.stated == "mm"
    assert drawing.evidence == Message(
        "unit.svg-size", size=['width="100mm"', 'height="100mm"'], width=100, height=100
    )


def test_groups_transform_their_content() -> None:
    drawing = only(
        '<g transform="translate(0,100) scale(1,-1)"><g transform="rotate(90)">'
        '<path transform="translate(5)" d="M0 0H10"/></g></g>'
    )
    # (0, 0) → translated (5, 0) → rotated (0, 5); the end lies 10 further.
    assert_allclose(drawing.ends, [[[0, 5], [0, 15]]], atol=1e-12)


@pytest.mark.parametrize("scale", [1.0, 0.1])
def test_an_edge_has_its_distance_from_the_curve_in_millimetres(scale: float) -> None:
    shape = '<path d="M10 50C10 90 80 90 80 50L10 50"/>'
    drawing = only(f'<g transform="scale({scale})">{shape}</g>')
    t = np.linspace(0.0, 1.0, 100_000)[:, None]
    r = 1.0 - t
    x, y = 10 * r**2 * (1 + 2 * t) + 80 * t**2 * (3 - 2 * t), 50 + 120 * r * t
    true = np.hstack([scale * x, 100.0 - scale * y])
    starts, ends = drawing.ends[:-1, 0], drawing.ends[:-1, 1]
    points = arc.points_along(starts, ends, drawing.bulge[:-1], 9).reshape(-1, 2)
    far = max(float(np.hypot(*(true - point).T).min()) for point in points)
    assert 0.98 * far <= drawing.fit_error.max() <= 0.0035
    # The last edge is a line of the file.
    assert drawing.fit_error[-1] == 0.0


def test_a_circle_is_two_exact_arcs() -> None:
    drawing = only('<circle cx="50" cy="40" r="7"/>')
    assert_allclose(drawing.bulge, [-1.0, -1.0], rtol=1e-15)
    assert_allclose(drawing.bounds, [43, 53, 57, 67])
    assert_allclose(drawing.lengths.sum(), 14 * math.pi)


def test_a_rounded_rectangle_is_four_lines_and_four_arcs() -> None:
    drawing = only('<rect x="10" y="20" width="40" height="30" rx="5"/>')
    assert np.count_nonzero(drawing.bulge) == 4
    assert_allclose(drawing.lengths.sum(), 2 * (30 + 20) + 10 * math.pi)
    assert_allclose(drawing.bounds, [10, 50, 50, 80])
    # The segments are in order: each begins at the end of the one before.
    assert (drawing.ends[:-1, 1] == drawing.ends[1:, 0]).all()


def test_corner_radii_are_at_most_half_the_side() -> None:
    drawing = only('<rect width="40" height="30" rx="90" ry="4"/>')
    assert_allclose(drawing.bounds, [0, 70, 40, 100], atol=1e-12)


def test_flags_determine_the_side_of_an_arc() -> None:
    # From (20, 50) to (40, 50) about (30, 50); y is downwards on the page.
    up = only('<path d="M20 50A10 10 0 0 1 40 50"/>')
    down = only('<path d="M20 50A10 10 0 0 0 40 50"/>')
    assert_allclose(up.bounds, [20, 50, 40, 60])
    assert_allclose(down.bounds, [20, 40, 40, 50])


def test_a_large_arc_is_two_rows() -> None:
    drawing = only('<path d="M20 50A10 10 0 1 1 30 60"/>')
    assert len(drawing) == 2
    assert_allclose(drawing.lengths.sum(), 15 * math.pi)
    assert_allclose(drawing.ends[[0, -1], [0, 1]], [[20, 50], [30, 40]])


def test_radii_that_are_too_small_are_increased() -> None:
    drawing = only('<path d="M20 50A1 1 0 0 1 40 50"/>')
    assert_allclose(drawing.lengths.sum(), 10 * math.pi)


def test_a_mirrored_arc_turns_the_other_way() -> None:
    plain = only('<path d="M20 50A10 10 0 0 1 30 60"/>')
    over = only(
        '<g transform="translate(100) scale(-1,1)"><path d="M20 50A10 10 0 0 1 30 60"/></g>'
    )
    assert_allclose(over.ends, plain.ends * [-1, 1] + [100, 0])
    assert_allclose(over.bulge, -plain.bulge)


def test_an_unevenly_scaled_circle_is_an_ellipse_within_a_hundredth() -> None:
    drawing = only('<circle transform="scale(3,1)" cx="15" cy="50" r="10"/>')
    points = arc.points_along(drawing.ends[:, 0], drawing.ends[:, 1], drawing.bulge, 50)
    x, y = (points.reshape(-1, 2) - [45, 50]).T
    # A point at distance e from the ellipse has a value that differs from 1 by about 2 e / 10.
    assert np.abs((x / 30) ** 2 + (y / 10) ** 2 - 1).max() < 2 * 0.0101 / 10
    assert "the curves of the object were converted to" in reasons(drawing)["#1"]


def test_a_straight_curve_becomes_a_line() -> None:
    drawing = only('<path d="M0 0C10 0 20 0 30 0"/>')
    assert drawing.ends.tolist() == [[[0, 100], [30, 100]]]
    assert drawing.bulge.tolist() == [0]


coordinates = st.integers(-200, 200).map(lambda value: value / 2)


@given(st.lists(st.tuples(coordinates, coordinates), min_size=4, max_size=4, unique=True))
def test_a_curve_is_approximated_within_a_hundredth(control: list[tuple[float, float]]) -> None:
    (ax, ay), (bx, by), (cx, cy), (dx, dy) = control
    drawing = only(f'<path d="M{ax} {ay}C{bx} {by} {cx} {cy} {dx} {dy}"/>')
    t = np.linspace(0, 1, 200)[:, None]
    points = np.array(control) * [1, -1] + [0, 100]
    true = sum(
        math.comb(3, k) * t**k * (1 - t) ** (3 - k) * point for k, point in enumerate(points)
    )
    off = np.full(len(true), np.inf)
    for (start, end), bulge in zip(drawing.ends, drawing.bulge, strict=True):
        many = np.broadcast_to(start, true.shape), np.broadcast_to(end, true.shape)
        near = arc.nearest_fraction(*many, np.full(len(true), bulge), true)
        at = arc.point_at(*many, np.full(len(true), bulge), near)
        off = np.minimum(off, np.hypot(*(at - true).T))
    assert off.max() <= 0.0101
    assert_allclose(drawing.ends[[0, -1], [0, 1]], points[[0, -1]], atol=1e-12)


@given(
    st.floats(1, 40), st.floats(1, 40), st.floats(-180, 180), st.booleans(), st.booleans(),
    coordinates, coordinates,
)  # fmt: skip
def test_an_elliptic_arc_lies_on_its_ellipse_between_its_ends(
    rx: float, ry: float, angle: float, large: bool, sweep: bool, x: float, y: float
) -> None:
    if math.hypot(x, y) < 0.5:
        return
    path = f"M50 50a{rx!r} {ry!r} {angle!r} {int(large)} {int(sweep)} {x!r} {y!r}"
    drawing = only(f'<path d="{path}"/>')
    assert_allclose(drawing.ends[0, 0], [50, 50], atol=1e-9)
    assert_allclose(drawing.ends[-1, 1], [50 + x, 50 - y], atol=1e-9)
    assert (drawing.ends[:-1, 1] == drawing.ends[1:, 0]).all()
    # Rotated and scaled, the ellipse becomes a circle of radius 1 through both ends.
    turn = np.exp(1j * math.radians(angle))
    points = arc.points_along(drawing.ends[:, 0], drawing.ends[:, 1], drawing.bulge, 9)
    z = (points.reshape(-1, 2) * [1, -1] + [0, 100]) @ [1, 1j] / turn
    w = z.real / rx + 1j * z.imag / ry
    start, end = w[0], w[-1]
    half = abs(end - start) / 2
    grown = max(half, 1.0)
    side = 1.0 if large == sweep else -1.0
    away = math.sqrt(max(grown**2 - half**2, 0.0))
    centre = (start + end) / 2 - side * 1j * (end - start) / (2 * half) * away
    assert np.abs(np.abs(w - centre) - grown).max() <= 0.012 / min(rx, ry) * grown + 1e-6
    if abs(half - 1.0) > 1e-3 and half < 1.0:
        swept = np.unwrap(np.angle((w - centre) / (start - centre)))[-1]
        assert (abs(swept) > math.pi) == large
        assert (swept > 0) == sweep


# ── Size ──────────────────────────────────────────────────────────────────────────────────────


@pytest.mark.parametrize(
    ("size", "box", "unit", "length"),
    [
        ('width="100mm"', "0 0 100 100", "mm", 10.0),
        ('width="10cm"', "0 0 100 100", "cm", 10.0),
        ('width="10in"', "0 0 720 720", "in", 10.0 * 25.4 / 72.0),
        ('width="720pt"', "0 0 720 720", "pt", 10.0 * 25.4 / 72.0),
        ('height="200mm"', "0 0 100 100", "mm", 20.0),
        ('width="100mm"', "", "mm", 10.0 * 25.4 / 96.0),
        # The viewBox is fitted into the smaller side, unless the aspect ratio is not preserved.
        ('width="100mm" height="50mm"', "0 0 100 100", "mm", 5.0),
        ('width="300mm" height="50mm" preserveAspectRatio="none"', "0 0 100 100", "mm", 30.0),
    ],
)
def test_the_page_determines_the_length_of_ten_units(
    size: str, box: str, unit: str, length: float
) -> None:
    drawing = only('<path d="M0 0h10"/>', size=size, box=box)
    assert drawing.unit == unit
    assert_allclose(drawing.lengths, [length])


@pytest.mark.parametrize("size", ["", 'width="100" height="80"', 'width="100px"', 'width="100%"'])
def test_pixels_and_numbers_without_a_unit_are_no_size(size: str) -> None:
    drawing = only('<path d="M0 0h10"/>', size=size)
    assert (drawing.unit, drawing.stated) == ("", "")
    assert "0.2646 mm" in str(drawing.evidence)
    assert "0.3528 mm" in str(drawing.evidence)
    assert drawing.lengths.tolist() == [10.0]


def test_question_for_a_page_without_a_size_offers_pixels_and_points() -> None:
    folds = "".join(f'<path d="M{x} 51V233"/>' for x in (171, 313, 455))
    data = svg(f'<rect x="31" y="31" width="587" height="217"/>{folds}', size="", box="0 0 650 280")
    drawing = pipeline.read(data)
    assert drawing.unit == ""
    (question,) = (
        one
        for one in pipeline.questions(drawing, pipeline.classify(drawing, load.profile("default")))
        if one.kind == "unit"
    )
    assert {"mm", "in", "pt", "px", "px-90"} <= set(question.choices)
    assert "155.3 × 57.4 mm" in question.text


def test_files_of_illustrator_are_in_points() -> None:
    data = svg('<path d="M0 0h72"/>', size="", box="0 0 650 280")
    drawing = read(b"<!-- Generator: Adobe Illustrator 27.0.0 -->" + data)
    assert (drawing.unit, drawing.stated) == ("pt", "pt")
    assert_allclose(drawing.lengths, [25.4])


def test_the_unit_of_the_user_has_priority() -> None:
    data = svg('<path d="M0 0h96"/>', size='width="500"')
    assert_allclose(read(data, "px").lengths, [25.4])
    assert_allclose(read(data, "pt").lengths, [96 * 25.4 / 72])
    assert_allclose(read(data, "mm").lengths, [96.0])
    assert (read(data, "px").evidence.code, read(data, "px").stated) == ("unit.given", "")


def test_a_packed_file_is_the_same_drawing() -> None:
    assert read(gzip.compress(carton())).ends.tolist() == read(carton()).ends.tolist()


# ── Style ─────────────────────────────────────────────────────────────────


@pytest.mark.parametrize(
    ("look", "true_colour", "index"),
    [
        ('stroke="red"', 0xFF0000, 1),
        ('stroke="#00F"', 0x0000FF, 5),
        ('style="stroke:rgb(0, 255, 0); fill: none"', 0x00FF00, 3),
        ('stroke="rgb(100%,0%,100%)"', 0xFF00FF, 6),
        ('stroke="#e02020"', 0xE02020, 1),
        ('stroke="#CD853F icc-color(x, 1)"', 0xCD853F, 2),
        ('stroke="currentColor" color="yellow"', 0xFFFF00, 2),
        ('stroke="url(#gone) cyan"', 0x00FFFF, 4),
        ('stroke="url(#gone)url(url(url("', 0x000000, 7),
        ('stroke="red" style="stroke:blue"', 0x0000FF, 5),
        ('stroke="no such colour"', 0x000000, 7),
        ("", 0x000000, 7),
    ],
)  # fmt: skip
def test_a_stroke_has_a_true_colour_and_the_nearest_index(
    look: str, true_colour: int, index: int
) -> None:
    drawing = only(f'<path {look} d="M0 0h10"/>')
    assert (drawing.true_colour.tolist(), drawing.colour.tolist()) == ([true_colour], [index])


def test_rules_of_a_style_sheet_apply_by_specificity() -> None:
    drawing = read(
        svg(
            "<defs><style><![CDATA[ /* colours of a company */ path{stroke:#111}",
            ".cut,.x{stroke:#222} path.cut{stroke:#333} #one{stroke:#444}",
            "@media print{.cut{stroke:#555}} line + path{stroke:#666}",
            ".loud{stroke:#777!important} ]]></style></defs>",
            '<path d="M0 0h1"/><path class="x" d="M0 0h2"/><path class="a cut" d="M0 0h3"/>',
            '<path id="one" class="cut" d="M0 0h4"/>',
            '<path class="cut" style="stroke:#888" d="M0 0h5"/>',
            '<path class="loud" style="stroke:#888" d="M0 0h6"/>',
            '<line class="cut" x2="7"/>',
        )
    )
    assert [f"{colour:06x}" for colour in drawing.true_colour] == [
        *("111111", "222222", "333333", "444444", "888888", "777777", "222222")
    ]
    assert (
        reasons(drawing)["style"] == "the style sheet of the drawing has rules that are not "
        "supported: @media print, line + path"
    )


def test_selectors_with_ancestors_and_attributes_apply() -> None:
    drawing = read(
        svg(
            "<style>#cuts path{stroke:#111} #cuts > path{stroke:#222}",
            "[data-x=fold]{stroke:#333}</style>",
            '<g id="cuts"><g><path d="M0 0h1"/></g><path d="M0 0h2"/></g>',
            '<path data-x="fold" d="M0 0h3"/><path d="M0 0h4" stroke="#444"/>',
        )
    )
    assert [f"{colour:06x}" for colour in drawing.true_colour] == [
        *("111111", "222222", "333333", "444444")
    ]


@pytest.mark.parametrize(
    ("dash", "linetype"),
    [("4 2", "dashed"), ("none", "Continuous"), ("0", "Continuous"), ("", "Continuous")],
)
def test_dashes_are_a_linetype(dash: str, linetype: str) -> None:
    drawing = only(f'<g style="stroke-dasharray:{dash}"><path d="M0 0h10"/></g>')
    assert drawing.linetypes == (linetype,)


@pytest.mark.parametrize(
    ("groups", "layer"),
    [
        ('<g inkscape:groupmode="layer" inkscape:label="Crease lines" id="layer1"><g id="x">',
         "Crease lines"),
        ('<g inkscape:groupmode="layer" id="Fold"><g>', "Fold"),
        ('<g id="layer-CUT"><g id="g123">', "CUT"),
        ('<g id="Dieline"><g id="Perf_1_">', "Perf"),
        ('<g id="Cut_x0020_line"><g>', "Cut line"),
        ('<g id="Layer_1"><g id="_Group_">', "0"),
        ("<g><g>", "0"),
    ],
)  # fmt: skip
def test_the_layer_is_the_name_that_a_user_gave(groups: str, layer: str) -> None:
    assert only(f'{groups}<path id="path42" d="M0 0h10"/></g></g>').layers == (layer,)


@pytest.mark.parametrize(
    ("names", "layer"),
    [
        ('id="crease-12"', "crease"),
        ('id="rect7" class="cls-1 glue"', "glue"),
        ('id="rect7" inkscape:label="Outline"', "Outline"),
    ],
)
def test_an_element_outside_groups_has_the_layer_of_its_own_name(names: str, layer: str) -> None:
    assert only(f'<path {names} d="M0 0h10"/>').layers == (layer,)


@pytest.mark.parametrize(
    ("groups", "names", "layer"),
    [
        # The nearest name with a meaning, of the element or of a group.
        ('<g id="template">', 'class="die-score" id="score-3"', "die-score"),
        ('<g id="template">', 'class="cls-1" id="score-3"', "score"),
        ('<g id="template">', 'id="front-3"', "template"),
        ('<g id="template" class="cls-2 fold-lines">', 'id="front-3"', "fold-lines"),
        ('<g id="CUT"><g id="left-panel">', 'id="front-3"', "CUT"),
        ('<g id="CUT"><g class="creases">', 'id="front-3"', "creases"),
        ('<g id="CUT">', 'class="crease"', "crease"),
        # One layer for one meaning.
        ('<g id="CUT">', 'class="trim"', "CUT"),
        ('<g id="CUT"><g id="slits">', 'id="cut-7"', "CUT"),
        # Data attributes.
        ('<g id="template">', 'data-type="perforation"', "perforation"),
        ('<g id="template">', 'data-crease="true"', "crease"),
        ('<g id="template">', 'data-crease="false"', "template"),
        ('<g id="template">', f'data-hint="Fold here{" please" * 6}"', "template"),
        # Classes come before ids; several meanings are kept, and mean none.
        ('<g id="template">', 'class="fold" id="cut-3"', "fold"),
        ('<g id="template">', 'class="cut fold"', "cut fold"),
        ('<g id="CUT">', 'class="border"', "CUT border"),
        ('<g id="dimensions">', 'class="cut"', "cut"),
        # The id of an element does not leave out its line, unlike the id of a group.
        ('<g id="box">', 'id="flap_engrave"', "box"),
        ('<g id="box"><g id="dimensions">', 'id="front"', "dimensions"),
        ('<g id="CUT"><g id="dimensions">', 'id="front"', "dimensions"),
        # The name of a marked layer has priority if it has a meaning.
        ('<g inkscape:groupmode="layer" inkscape:label="Cut">', 'class="fold"', "Cut"),
        ('<g inkscape:groupmode="layer" inkscape:label="Layer 1">', 'class="fold"', "fold"),
        ('<g inkscape:groupmode="layer" inkscape:label="Box"><g id="x">', 'id="front"', "Box"),
    ],
)
def test_the_layer_is_the_nearest_name_with_a_meaning(groups: str, names: str, layer: str) -> None:
    close = "</g>" * groups.count("<g")
    assert only(f'{groups}<path {names} d="M0 0h10"/>{close}').layers == (layer,)


# ── Import report ────────────────────────────────────────────────────────────────────────────────


def test_lengths_in_the_report_add_up() -> None:
    drawing = read(carton())
    assert_lengths_add_up(drawing)
    dropped = drawing.import_report.outcome == ImportOutcome.DROPPED
    assert [drawing.import_report.kind[row] for row in np.flatnonzero(dropped).tolist()] == ["text"]


def test_texts_are_kept_as_annotations() -> None:
    (words,) = read(carton()).annotations
    assert (words.text, words.x, words.y, words.height) == ("A carton", 20.0, 2.0, 4.0)
    assert words.kind == "text"
    assert math.isnan(words.measure)


def test_hidden_groups_are_dropped_with_their_content() -> None:
    drawing = read(
        svg(
            '<g style="display:none"><path id="a" d="M0 0h1"/></g>',
            '<g visibility="hidden"><path id="b" d="M0 0h2"/>',
            '<path id="c" visibility="visible" d="M0 0h3"/></g>',
            '<path id="d" stroke="none" d="M0 0h4"/><path id="e" stroke-opacity="0" d="M0 0h5"/>',
        )
    )
    assert drawing.lengths.tolist() == [3.0]
    reason = reasons(drawing)
    assert reason["a"] == reason["b"] == "the object is hidden"
    assert reason["d"] == "the object has neither a stroke nor a fill, so it is not visible"
    assert reason["e"] == "the object is completely transparent"


def test_fills_are_lines_only_in_drawings_without_strokes() -> None:
    area = '<path id="area" stroke="none" fill="#f00" d="M0 0h10v10z"/>'
    alone = only(area)
    assert len(alone) == 3
    assert alone.true_colour.tolist() == [0xFF0000] * 3
    assert reasons(alone)["area"] == (
        "the object was imported; note: the object is the outline of a filled area, which was "
        "imported because the drawing has no lines"
    )
    beside = only(area + '<path d="M0 0h1"/>')
    assert len(beside) == 1
    assert (
        reasons(beside)["area"]
        == "the object is a filled area without an outline; the outline of a filled area is cut "
        "only if the drawing has no lines, or if the lines on the area have no closed outline of "
        "their own"
    )


def test_damaged_elements_are_reported_and_the_others_are_read() -> None:
    drawing = read(
        svg(
            '<path id="a" d="M0 0h5 oops"/><rect id="b" width="-3" height="2"/>',
            '<line id="c" x1="1lightyear"/><polygon id="d" points=""/>',
            '<path id="e" transform="spin(3)" d="M0 0h5"/><path id="f" d="M1e9 0h5"/>',
            '<path id="g" d="M0 0h1e300h1e300"/><circle id="h" r="0"/><ellipse id="i" rx="3"/>',
            '<path id="n" stroke="#123" d="M0 0H5L"/>',
            '<image id="j" href="http://example.org/a.png"/><foreignObject id="k"/>',
            '<use id="l" href="other.svg#x"/><use id="m" href="#nobody"/>',
        )
    )
    reason = reasons(drawing)
    assert reason["a"] == "the path data of the object is invalid at character 8 ('oops')"
    assert reason["n"] == "the path data of the object is incomplete: it ends inside a command"
    assert reason["b"] == "the object has no size: its width is -3 and its height 2"
    assert reason["c"].startswith(
        "the attribute x1 of the object cannot be read: the value '1lightyear'"
    )
    assert reason["d"] == "the object has no points"
    assert reason["e"] == (
        "the attribute transform of the object cannot be read: "
        "the transform spin has 1 values, which is a wrong number of values"
    )
    assert reason["f"] == "the object lies outside the visible area of the page"
    assert reason["g"].startswith("a coordinate of the object is 2E300")
    assert reason["h"] == "the radius of the object is 0, but must be greater than 0"
    assert reason["j"] == "the object is an image, which is not cut"
    assert reason["k"] == "the content of the object is not SVG"
    assert reason["l"] == "the object is in another file, 'other.svg#x', which is not loaded"
    assert (
        reason["m"] == "the object refers to another object by the id 'nobody', "
        "which does not exist in the file"
    )
    assert_allclose(drawing.lengths.sum(), 6 * math.pi)


# ── use, symbol, svg ──────────────────────────────────────────────────────────────────────────


def test_use_copies_a_group_to_its_position() -> None:
    drawing = read(
        svg(
            '<defs><g id="hole"><path id="slit" d="M0 0h10"/></g></defs>',
            '<use id="one" href="#hole" x="20" y="30"/>',
            '<use id="two" xlink:href="#hole" transform="rotate(90)" stroke="red"/>',
        )
    )
    assert_allclose(drawing.ends, [[[20, 70], [30, 70]], [[0, 100], [0, 90]]], atol=1e-12)
    assert drawing.import_report.handle == ("one/slit", "two/slit")
    assert drawing.true_colour.tolist() == [0, 0xFF0000]


def test_a_symbol_is_fitted_into_the_window_of_its_use() -> None:
    drawing = read(
        svg(
            '<symbol id="s" viewBox="0 0 10 10"><path d="M0 0H10"/></symbol>',
            '<use href="#s" x="20" y="20" width="40" height="40"/>',
        )
    )
    assert_allclose(drawing.ends, [[[20, 80], [60, 80]]])


def test_a_nested_svg_has_its_own_window() -> None:
    drawing = only('<svg x="10" y="10" width="50%" viewBox="0 0 5 10"><path d="M0 0h5"/></svg>')
    assert_allclose(drawing.lengths, [50.0])


def test_use_that_contains_itself_is_dropped() -> None:
    drawing = read(
        svg(
            '<g id="a"><path d="M0 0h1"/><use id="u" href="#a"/></g>',
            '<defs><g id="b"><use id="v" href="#c"/></g>',
            '<g id="c"><use id="w" href="#b"/></g></defs>',
            '<use id="x" href="#b"/>',
        )
    )
    assert drawing.lengths.tolist() == [1.0]
    reason = reasons(drawing)
    assert reason["u"] == "the object contains a reference to itself"
    assert reason["x/v/w"] == "the object contains a reference to itself"


# ── Files of other programs ───────────────────────────────────────────────────────────────────


def off(one: Drawing, other: Drawing) -> np.ndarray:
    """Return the distance of each edge of a drawing from another, aligned at the lower left."""
    points = arc.points_along(one.ends[:, 0], one.ends[:, 1], one.bulge, 7).reshape(-1, 2)
    points = points - one.bounds[:2] + other.bounds[:2]
    start, end = other.ends[:, 0], other.ends[:, 1]
    farthest = []
    for point in points:
        many = np.broadcast_to(point, start.shape)
        share = arc.nearest_fraction(start, end, other.bulge, many)
        near = arc.point_at(start, end, other.bulge, share)
        farthest.append(np.hypot(*(near - many).T).min())
    found: F64 = np.array(farthest).reshape(len(one), -1).max(axis=1)
    return found


@pytest.mark.corpus
@pytest.mark.parametrize("name", ["mailer_200x150x60_t3", "mailer_120x80x40_all_layers"])
def test_a_mailer_is_equal_as_svg_and_as_dxf(name: str, corpus: Path) -> None:
    folder = corpus / "generated__kyholdings__diecut_generator"
    ours = read((folder / f"{name}.svg").read_bytes())
    twin = dxf.read((folder / f"{name}.dxf").read_bytes(), "mm")
    assert sorted(ours.layers) == sorted({twin.layers[row] for row in twin.layer})
    for layer in ours.layers:
        on_ours = ours.lengths[ours.layer == ours.layers.index(layer)].sum()
        on_twin = twin.lengths[twin.layer == twin.layers.index(layer)].sum()
        assert_allclose(on_ours, on_twin, rtol=1e-4)
    assert max(off(ours, twin).max(), off(twin, ours).max()) <= 0.01


@pytest.mark.corpus
def test_a_tuck_carton_is_equal_as_svg_and_as_dxf(corpus: Path) -> None:
    folder = corpus / "generated__eridur-de__mightyscape-inkpacking"
    ours = read((folder / "box_rwlf.svg").read_bytes())
    assert ours.unit == "mm"
    twin = dxf.read((folder / "box_rwlf.dxf").read_bytes(), "mm")
    assert off(twin, ours).max() <= 0.05
    # The program that wrote the DXF omitted the lines above the page.
    on_page = ours.ends[:, :, 1].max(axis=1) <= 500.0
    assert on_page.sum() == 39
    assert off(ours, twin)[on_page].max() <= 0.05


def test_a_prefix_for_svg_is_read_and_other_namespaces_are_omitted() -> None:
    drawing = read(
        b'<s:svg xmlns:s="http://www.w3.org/2000/svg" xmlns:x="urn:x" width="9mm" '
        b'viewBox="0 0 9 9">'
        b'<x:note><s:path d="M0 0h9" stroke="red"/></x:note><s:path d="M0 0h3" stroke="red"/>'
        b"</s:svg>"
    )
    assert drawing.lengths.tolist() == [3.0]


def test_a_file_without_lines_is_an_empty_drawing() -> None:
    drawing = read(f"<svg {SVG}/>".encode())
    assert len(drawing) == len(drawing.import_report) == 0
