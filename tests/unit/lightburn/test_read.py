"""LightBurn: shapes, groups, packed paths, layers, damaged and hostile files."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose

from knifetip.errors import DrawingTooLarge, NotADrawing
from knifetip.formats.limits import Limits
from knifetip.geometry import arc
from knifetip.geometry.tolerance import CURVE
from knifetip.lightburn.read import read
from knifetip.model.drawing import Drawing
from tests.support.drawings import report_reasons
from tests.support.reading import read_or_refused
from tests.support.writers.lightburn_text import (
    carton,
    group,
    layer,
    path,
    polyline,
    project,
    shape,
)

KAPPA = 4 / 3 * (math.sqrt(2) - 1)
LINE = polyline((0, 0), (10, 0))
QUARTER = f"V10 0c0x10c0y{10 * KAPPA}c1x1V0 10c0x1c1x{10 * KAPPA}c1y10"


def shapes(*elements: str, mirror: str = 'MirrorX="False" MirrorY="False"') -> Drawing:
    return read(project(*elements, mirror=mirror))


def reasons(*elements: str) -> list[str]:
    return list(report_reasons(shapes(*elements)))


# ── Shapes ────────────────────────────────────────────────────────────────────────────────────


def test_a_rectangle_is_about_its_centre_in_millimetres() -> None:
    drawing = shapes(shape("Rect", matrix="1 0 0 1 55 60", W=10, H=20, Cr=0))
    assert_allclose(drawing.bounds, [50, 50, 60, 70])
    assert len(drawing) == 4
    assert (drawing.unit, drawing.stated, drawing.evidence.code) == ("mm", "mm", "unit.lightburn")
    assert list(drawing.import_report.kind) == ["Rect"]
    assert list(drawing.import_report.handle) == ["#1"]


@pytest.mark.parametrize(
    ("corner", "length", "area"),
    [
        (2, 2 * (6 + 16) + 4 * math.pi, 200 - (16 - 4 * math.pi)),
        (-2, 2 * (6 + 16) + 4 * math.pi, 200 - 4 * math.pi),
        (99, 2 * 10 + 10 * math.pi, 100 + 25 * math.pi),
    ],
)
def test_the_corners_of_a_rectangle_can_be_round(corner: float, length: float, area: float) -> None:
    drawing = shapes(shape("Rect", W=10, H=20, Cr=corner))
    assert_allclose(drawing.bounds, [-5, -10, 5, 10], atol=1e-9)
    assert_allclose(drawing.lengths.sum(), length)
    # The area under the chords, and that between each arc and its chord.
    (ax, ay), (bx, by) = drawing.ends[:, 0].T, drawing.ends[:, 1].T
    half = 2.0 * np.arctan(drawing.bulge)
    radius = arc.radius(drawing.ends[:, 0], drawing.ends[:, 1], drawing.bulge)
    radius = np.where(half == 0.0, 0.0, radius)
    beside = radius**2 * (half - np.sin(half) * np.cos(half))
    assert_allclose((ax * by - ay * bx).sum() / 2 + beside.sum(), area)
    assert set(report_reasons(drawing)) == {"the object was imported unchanged"}


def test_an_ellipse_with_equal_radii_is_a_circle() -> None:
    drawing = shapes(shape("Ellipse", matrix="1 0 0 1 5 6", Rx=4, Ry=4))
    assert_allclose(drawing.lengths.sum(), 8 * math.pi)
    assert_allclose(drawing.bounds, [1, 2, 9, 10], atol=1e-9)
    assert len(drawing) == 2


def test_an_ellipse_is_fitted() -> None:
    drawing = shapes(shape("Ellipse", Rx=20, Ry=10))
    assert_allclose(drawing.bounds, [-20, -10, 20, 10], atol=CURVE)
    assert 0.0 < drawing.fit_error.max() <= CURVE


def test_groups_transform_their_shapes() -> None:
    inner = group(LINE, matrix="0 1 -1 0 5 0")
    drawing = shapes(group(inner, shape("Ellipse", Rx=1, Ry=1), matrix="2 0 0 2 100 50"))
    assert drawing.ends[0].tolist() == [[110, 50], [110, 70]]
    assert list(drawing.import_report.handle) == ["#3", "#4"]
    assert_allclose(drawing.lengths[1:].sum(), 4 * math.pi)


@pytest.mark.parametrize(
    ("mirror", "expected"),
    [
        ("", [[1, 2], [3, 2]]),
        ('MirrorX="True" MirrorY="False"', [[-1, 2], [-3, 2]]),
        ('MirrorX="False" MirrorY="True"', [[1, -2], [3, -2]]),
        ('MirrorX="True" MirrorY="True"', [[-1, -2], [-3, -2]]),
    ],
)
def test_the_axes_point_as_the_machine_of_the_project_has_them(
    mirror: str, expected: list[list[int]]
) -> None:
    assert shapes(polyline((1, 2), (3, 2)), mirror=mirror).ends[0].tolist() == expected


# ── Paths ─────────────────────────────────────────────────────────────────────────────────────


@pytest.mark.parametrize(
    ("primitives", "length"),
    [("LineClosed", 24), ("LineOpen", 18), ("L0 1L1 2", 18), (" L 2 1 L 1 0 ", 18), ("", 0)],
)
def test_lines_join_the_vertices_of_a_path(primitives: str, length: float) -> None:
    drawing = shapes(path("V0 0c0x1c1x1V8 0c0x1c1x1SV8 1e1", primitives), LINE)
    assert_allclose(drawing.lengths.sum(), length + 10 + (math.hypot(8, 10) - 6) * (length == 24))


def test_a_curve_leaves_towards_c0_and_arrives_from_c1() -> None:
    drawing = shapes(path(QUARTER, "B0 1"))
    assert drawing.ends[0, 0].tolist() == [10, 0]
    assert drawing.ends[-1, 1].tolist() == [0, 10]
    assert_allclose(drawing.lengths.sum(), 5 * math.pi, atol=0.01)


def test_a_curve_without_control_points_is_a_line() -> None:
    drawing = shapes(path("V0 0c0x1c1x1V10 10c0x1c1x1", "B0 1"))
    assert drawing.ends.tolist() == [[[0, 0], [10, 10]]]


def test_a_control_point_on_the_x_axis_has_no_y() -> None:
    packed = shapes(path("V0 10c0x5c1x1V10 10c0x1c1x5", "B0 1"))
    full = shapes(path("V0 10c0x5c0y0c1x1V10 10c0x1c1x5c1y0", "B0 1"))
    assert packed.ends.tolist() == full.ends.tolist()
    assert_allclose(packed.bounds[1], 2.5, atol=CURVE)


def test_shapes_share_vertices_and_primitives() -> None:
    first = path("V0 0V4 0V4 3", "LineClosed", VertID=5, PrimID=2)
    moved = shape("Path", matrix="1 0 0 1 10 0", VertID=5, PrimID=2)
    other = shape("Path", "<VertList>V0 0V0 7</VertList>", VertID=6, PrimID=2)
    drawing = shapes(first, moved, other)
    assert drawing.import_report.length.tolist() == [12, 12, 7]
    assert drawing.ends[3].tolist() == [[10, 0], [14, 0]]


def test_the_elements_of_an_old_project_are_the_same_path() -> None:
    inside = (
        f'<V vx="10" vy="0" c0x="10" c0y="{10 * KAPPA}"/>'
        f'<V vx="0" vy="10" c1x="{10 * KAPPA}" c1y="10"/><V vx="0" vy="0"/>'
        '<P T="B" p0="0" p1="1"/><P T="L" p0="1" p1="2"/><P T="L" p0="2" p1="0"/>'
    )
    old = shapes(shape("Path", inside))
    new = shapes(path(f"{QUARTER}V0 0", "B0 1L1 2L2 0"))
    assert len(old) > 3
    assert sorted(old.ends.tolist()) == sorted(new.ends.tolist())


# ── Layers ────────────────────────────────────────────────────────────────────────────────────


def test_a_layer_has_the_name_and_colour_of_its_setting() -> None:
    drawing = shapes(
        layer(2, "Outline"),
        layer(1, perforate=1),
        layer(0, perforate=0),
        *(polyline((0, k), (9, k), layer=k) for k in (0, 1, 2, 29, 77)),
    )
    assert [drawing.layers[one] for one in drawing.layer] == ["C00", "C01", "Outline", "C29", "77"]
    assert [drawing.linetypes[one] for one in drawing.linetype] == [
        "Continuous",
        "perforated",
        *["Continuous"] * 3,
    ]
    assert drawing.true_colour.tolist() == [0, 0x0000FF, 0xFF0000, 0xFFDB66, -1]
    assert drawing.colour.tolist()[:3] == [7, 5, 1]


@pytest.mark.parametrize(
    ("setting", "index", "words"),
    [
        (layer(3, "Notes", hide=1), 3, "the layer of the object is switched off"),
        (layer(3, "Notes", doOutput=0), 3, "set to be not plotted"),
        ("", 30, "set to be not plotted"),
        ('<CutSetting type="Tool"><index Value="31"/></CutSetting>', 31, "set to be not plotted"),
    ],
)
def test_a_layer_without_output_is_left_out(setting: str, index: int, words: str) -> None:
    found = reasons(setting, polyline((0, 0), (5, 0), layer=index), LINE)
    assert words in found[0]
    assert found[1] == "the object was imported unchanged"


def test_filled_shapes_are_left_out_beside_lines_only() -> None:
    filled = shape("Rect", W=5, H=5, CutIndex=1)
    setting = layer(1, kind="Scan")
    assert "filled area" in reasons(setting, filled, LINE)[0]
    alone = shapes(setting, filled)
    assert len(alone) == 4
    assert "outline of a filled area" in report_reasons(alone)[0]
    assert len(shapes(layer(1, kind="Scan+Cut"), filled, LINE)) == 5


# ── What is not read ──────────────────────────────────────────────────────────────────────────


def test_texts_and_pictures_are_left_out() -> None:
    outline = (
        '<BackupPath Type="Path" CutIndex="0"><XForm>1 0 0 1 99 99</XForm>'
        "<VertList>V0 0V1 1</VertList><PrimList>L0 1</PrimList></BackupPath>"
    )
    drawing = shapes(
        shape("Text", outline, "1 0 0 1 20 30", Str="Lid 50", H=7, CutIndex=0),
        shape("Bitmap", W=10, H=10, Data="iVBORw0KGgo="),
        LINE,
    )
    assert len(drawing) == 1
    assert list(report_reasons(drawing)) == [
        "the object is a text, which is not cut",
        "the object is an image, which is not cut",
        "the object was imported unchanged",
    ]
    (words,) = drawing.annotations
    assert (words.text, words.x, words.y, words.height) == ("Lid 50", 20, 30, 7)


@pytest.mark.parametrize(
    ("damaged", "words"),
    [
        (shape("Polygon", N=6, Rx=5, Ry=5), "a LightBurn shape of the type Polygon"),
        (shape("Rect", W="wide", H=5), "the attribute W of the object cannot be read"),
        (shape("Rect", W=5), "because its H is missing"),
        (shape("Rect", W="1e999", H=5), "the attribute W"),
        (shape("Ellipse", Rx=0, Ry=5), "the radius of the object is 0"),
        (shape("Rect", matrix="1 0 0 1 5", W=5, H=5), "the position of the object cannot be read"),
        (group(shape("Rect", W=5, H=5), matrix="1 0 0 1 x 5"), "the position of the object"),
        (shape("Path", VertID=9, PrimID=9), "by the id '9'"),
        (path("V0 0V1 1", "L0 2"), "joins vertices that it does not have"),
        (path("V0 0V1 1", "L0 1X"), "invalid at character 5 ('X')"),
        (path("V0 0V1,1", "L0 1"), "invalid at character 5 ('V1,1')"),
        (path("V0 0V1 nan", "L0 1"), "invalid at character 5"),
        (path("V0 0V1e400 1", "L0 1"), "a coordinate of the object is not a number"),
        (shape("Path", '<V vx="0" vy="0"/><P T="Q" p0="0" p1="0"/>'), "in an unknown way ('Q'"),
        (shape("Path", '<V vx="0" vy="0"/><P T="L" p0="0" p1="-1"/>'), "the attribute p1"),
        (shape("Path"), "the path of the object is empty"),
    ],
)
def test_a_damaged_shape_is_left_out_and_the_others_are_read(damaged: str, words: str) -> None:
    found = reasons(damaged, LINE)
    assert words in found[0]
    assert found[-1] == "the object was imported unchanged"


@pytest.mark.parametrize(
    ("data", "words"),
    [
        (carton()[:-30], "The LightBurn file is incomplete"),
        (carton().replace(b"<XForm>", b"<XForm"), "The LightBurn file is damaged at line "),
        (carton().replace(b"UTF-8", b"UTF-X"), "unknown encoding: UTF-X"),
        (carton().replace(b"UTF-8", b"utf-7"), "multi-byte encodings are not supported"),
        (project(layer(1)), "contains no shape"),
        (
            b'<!DOCTYPE a [<!ENTITY b SYSTEM "file:///etc/passwd">]><LightBurnProject/>',
            "has a DOCTYPE",
        ),
    ],
)
def test_a_damaged_file_is_refused(data: bytes, words: str) -> None:
    with pytest.raises(NotADrawing, match=words) as caught:
        read(data)
    assert caught.value.hint


@pytest.mark.parametrize(
    ("data", "limits"),
    [
        (project(*[LINE] * 9), Limits(entities=20)),
        (project(*[LINE] * 9), Limits(segments=8)),
        (project(path("V0 0" * 30, "LineClosed")), Limits(segments=20)),
        (project(path("V0 0V1 1", "L0 1" * 30)), Limits(segments=20)),
        (project("<g>" * 300 + "</g>" * 300), Limits()),
        (carton(), Limits(bytes=100)),
    ],
)
def test_a_limit_is_an_error(data: bytes, limits: Limits) -> None:
    with pytest.raises(DrawingTooLarge):
        read(data, limits=limits)


def test_copies_of_a_shared_path_count() -> None:
    first = path("V0 0" * 50, "LineClosed", VertID=1, PrimID=1)
    copy = shape("Path", VertID=1, PrimID=1)
    with pytest.raises(DrawingTooLarge):
        read(project(first, *[copy] * 9), limits=Limits(segments=200))


@given(
    st.lists(st.sampled_from(["V", "c0x", "c1y", "S", "1", "-2.5", "e9", " ", ".", "9" * 40])),
    st.lists(st.sampled_from(["L", "B", "0", "1", " ", "LineClosed", "9" * 12])),
)
def test_any_path_is_read_or_refused(vertices: list[str], primitives: list[str]) -> None:
    data = project(path("".join(vertices), "".join(primitives)), LINE)
    assert read_or_refused(read, data) is not None


@given(st.data())
def test_any_change_of_a_file_is_read_or_refused(data: st.DataObject) -> None:
    whole = bytearray(carton())
    for _ in range(data.draw(st.integers(1, 4))):
        at = data.draw(st.integers(0, len(whole) - 1))
        whole[at : at + data.draw(st.integers(0, 9))] = data.draw(st.binary(max_size=4))
    read_or_refused(read, bytes(whole))
