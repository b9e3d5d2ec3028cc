"""Each kind of entity, read from its own file, compared with geometry computed by hand."""

from __future__ import annotations

import io
import math
from collections.abc import Callable, Sequence
from typing import Any

import ezdxf
import numpy as np
import pytest
from ezdxf import disassemble, path
from numpy.testing import assert_allclose, assert_array_equal

from knifetip.dxf.read import read
from knifetip.geometry import arc
from knifetip.geometry.columns import F64
from knifetip.model.drawing import Drawing, ImportOutcome
from tests.support.drawings import report_reasons
from tests.support.writers.dxf_text import Tag, block, dxf, entity, insert, line, tags

DOWN = ((210, 0.0), (220, 0.0), (230, -1.0))


def rows(drawing: Drawing) -> F64:
    """Return x1, y1, x2, y2 and bulge of each segment, (n, 5)."""
    return np.column_stack([drawing.ends.reshape(-1, 4), drawing.bulge])


def only(drawing: Drawing, outcome: ImportOutcome = ImportOutcome.KEPT) -> str:
    """Return the reason in the only row of the import report; its outcome must be ``outcome``."""
    assert len(drawing.import_report) == 1
    assert drawing.import_report.outcome[0] == outcome
    return report_reasons(drawing)[0]


def polyline(vertices: Sequence[Sequence[Any]], *head: Tag, flags: int = 0) -> str:
    text = entity("POLYLINE", (66, 1), (70, flags), (10, 0), (20, 0), (30, 0), *head)
    for vertex in vertices:
        x, y, *more = vertex
        text += entity("VERTEX", (10, x), (20, y), (30, 0), *more)
    return text + tags((0, "SEQEND"))


def lwpolyline(vertices: Sequence[tuple[float, float, float]], *head: Tag, flags: int = 0) -> str:
    body = []
    for x, y, bulge in vertices:
        body += [(10, x), (20, y), (42, bulge)]
    count = (90, len(vertices))
    return tags(
        (0, "LWPOLYLINE"),
        (5, "2F4"),
        (100, "AcDbEntity"),
        (8, "0"),
        (100, "AcDbPolyline"),
        count,
        (70, flags),
        *head,
        *body,
    )


def spline(
    degree: int,
    knots: list[int],
    control: Sequence[tuple[float, float, float]],
    *head: Tag,
    weights: Sequence[float] = (),
) -> str:
    body = [(40, knot) for knot in knots] + [(41, weight) for weight in weights]
    for x, y, z in control:
        body += [(10, x), (20, y), (30, z)]
    return tags(
        (0, "SPLINE"),
        (5, "2F4"),
        (100, "AcDbEntity"),
        (8, "0"),
        (100, "AcDbSpline"),
        *head,
        (70, 8),
        (71, degree),
        (72, len(knots)),
        (73, len(control)),
        *body,
    )


def test_line_is_one_row_from_start_to_end() -> None:
    drawing = read(dxf(line(1, 2, 4, 6)))
    assert_array_equal(rows(drawing), [[1, 2, 4, 6, 0]])
    assert only(drawing) == "the object was imported unchanged"
    assert drawing.import_report.length[0] == 5.0


def test_line_above_the_sheet_is_flattened_with_a_note() -> None:
    drawing = read(dxf(entity("LINE", (10, 0), (20, 0), (30, 7), (11, 5), (21, 0), (31, 7))))
    assert_array_equal(rows(drawing), [[0, 0, 5, 0, 0]])
    assert (
        only(drawing) == "the object was imported; note: the object was moved from the height "
        "z = 7 file units to z = 0"
    )


def test_line_that_rises_is_dropped_with_its_heights() -> None:
    drawing = read(dxf(entity("LINE", (10, 0), (20, 0), (30, 0), (11, 5), (21, 0), (31, 7))))
    assert len(drawing) == 0
    assert (
        only(drawing, ImportOutcome.DROPPED)
        == "the object is not parallel to the XY plane: its height z varies from 0 to 7 file units"
    )


def test_line_without_its_second_end_is_dropped() -> None:
    drawing = read(dxf(entity("LINE", (10, 0), (20, 0))))
    assert (
        only(drawing, ImportOutcome.DROPPED)
        == "the object is incomplete, because its second end is missing"
    )


def test_line_ignores_its_extrusion() -> None:
    assert_array_equal(rows(read(dxf(line(1, 2, 4, 6, *DOWN)))), [[1, 2, 4, 6, 0]])


def test_quarter_arc_is_one_row_to_the_left() -> None:
    drawing = read(dxf(entity("ARC", (10, 5), (20, 0), (40, 10), (50, 0), (51, 90))))
    assert_allclose(rows(drawing), [[15, 0, 5, 10, math.tan(math.pi / 8)]], atol=1e-12)


def test_arc_over_zero_degrees_goes_on_counter_clockwise() -> None:
    drawing = read(dxf(entity("ARC", (10, 0), (20, 0), (40, 10), (50, 315), (51, 45))))
    root = 10.0 * math.sqrt(0.5)
    assert_allclose(rows(drawing), [[root, -root, root, root, math.tan(math.pi / 8)]], atol=1e-12)


def test_arc_of_270_degrees_is_two_rows_on_one_circle() -> None:
    drawing = read(dxf(entity("ARC", (10, 0), (20, 0), (40, 10), (50, 0), (51, 270))))
    assert len(drawing) == 2
    assert_allclose(
        arc.centre(drawing.ends[:, 0], drawing.ends[:, 1], drawing.bulge), 0, atol=1e-12
    )
    assert_allclose(drawing.lengths.sum(), 15.0 * math.pi)
    assert_array_equal(drawing.ends[0, 1], drawing.ends[1, 0])


def test_mirrored_arc_lies_left_of_the_axis_and_turns_right() -> None:
    drawing = read(dxf(entity("ARC", (10, 5), (20, 0), (40, 10), (50, 0), (51, 90), *DOWN)))
    assert_allclose(rows(drawing), [[-15, 0, -5, 10, -math.tan(math.pi / 8)]], atol=1e-12)


def test_arc_in_a_tilted_plane_is_dropped_with_its_tilt() -> None:
    tilted = ((210, 1.0), (220, 0.0), (230, 1.0))
    drawing = read(dxf(entity("ARC", (10, 5), (20, 0), (40, 10), (50, 0), (51, 90), *tilted)))
    assert (
        only(drawing, ImportOutcome.DROPPED)
        == "the object is not parallel to the XY plane: its plane is tilted by 45°"
    )


@pytest.mark.parametrize("radius", [0, -3])
def test_arc_without_radius_is_dropped_with_the_measure(radius: int) -> None:
    drawing = read(dxf(entity("CIRCLE", (10, 0), (20, 0), (40, radius))))
    assert (
        only(drawing, ImportOutcome.DROPPED)
        == f"the radius of the object is {radius}, but must be greater than 0"
    )


def test_circle_is_two_half_turns() -> None:
    drawing = read(dxf(entity("CIRCLE", (10, 1), (20, 2), (40, 3))))
    assert_allclose(rows(drawing), [[4, 2, -2, 2, 1], [-2, 2, 4, 2, 1]], atol=1e-15)
    assert (np.abs(drawing.bulge) <= 1.0).all()


def test_circle_at_minus_z_with_height_is_mirrored_and_laid_flat() -> None:
    drawing = read(dxf(entity("CIRCLE", (10, 5), (20, 0), (30, 2), (40, 1), *DOWN)))
    assert_allclose(drawing.bounds, [-6, -1, -4, 1], atol=1e-12)
    assert (
        only(drawing) == "the object was imported; note: the object was moved from the height "
        "z = 2 file units to z = 0"
    )


def test_lwpolyline_keeps_bulges_and_closes() -> None:
    text = lwpolyline([(0, 0, 0), (10, 0, 1), (10, 10, 0), (0, 10, 0)], flags=1)
    drawing = read(dxf(text, version="AC1015"))
    assert_array_equal(
        rows(drawing), [[0, 0, 10, 0, 0], [10, 0, 10, 10, 1], [10, 10, 0, 10, 0], [0, 10, 0, 0, 0]]
    )
    assert drawing.handles == ["2F4"] * 4


def test_open_lwpolyline_does_not_use_its_last_bulge() -> None:
    drawing = read(dxf(lwpolyline([(0, 0, 0), (10, 0, 1)]), version="AC1015"))
    assert_array_equal(rows(drawing), [[0, 0, 10, 0, 0]])


def test_bulge_of_more_than_half_a_turn_becomes_two_rows() -> None:
    # Three quarters of a circle of radius 10 around the origin, from east to south.
    text = lwpolyline([(10, 0, math.tan(math.radians(67.5))), (0, -10, 0)])
    drawing = read(dxf(text, version="AC1015"))
    root = math.sqrt(50.0)
    eighth = math.tan(math.radians(33.75))
    assert_allclose(
        rows(drawing), [[10, 0, -root, root, eighth], [-root, root, 0, -10, eighth]], atol=1e-12
    )


def test_mirrored_lwpolyline_turns_its_bulges() -> None:
    drawing = read(dxf(lwpolyline([(1, 0, 1), (5, 0, 0)], (38, 4.0), *DOWN), version="AC1015"))
    assert_array_equal(rows(drawing), [[-1, 0, -5, 0, -1]])
    assert (
        only(drawing) == "the object was imported; note: the object was moved from the height "
        "z = 4 file units to z = 0"
    )


def test_coincident_vertices_give_no_row_and_are_counted() -> None:
    text = lwpolyline([(0, 0, 0), (0, 0, 0), (10, 0, 0)])
    drawing = read(dxf(text, version="AC1015"))
    assert_array_equal(rows(drawing), [[0, 0, 10, 0, 0]])
    assert (
        only(drawing)
        == "the object was imported; note: 1 of the 2 segments of the object has no length"
    )


def test_polyline_of_one_vertex_is_dropped() -> None:
    assert only(read(dxf(polyline([(1, 1)]))), ImportOutcome.DROPPED).startswith(
        "the object is a polyline with 1 vertex"
    )


def test_old_polyline_keeps_bulges_and_closes() -> None:
    drawing = read(dxf(polyline([(0, 0), (10, 0, (42, 1)), (10, 10)], flags=1)))
    assert_array_equal(rows(drawing), [[0, 0, 10, 0, 0], [10, 0, 10, 10, 1], [10, 10, 0, 0, 0]])
    assert only(drawing) == "the object was imported unchanged"


def test_control_frame_of_a_smoothed_polyline_is_not_drawn() -> None:
    vertices = [(0, 0, (70, 8)), (5, 50, (70, 16)), (5, 5, (70, 8)), (10, 0, (70, 8))]
    drawing = read(dxf(polyline(vertices, flags=4)))
    assert_array_equal(rows(drawing), [[0, 0, 5, 5, 0], [5, 5, 10, 0, 0]])


def test_3d_polyline_on_one_height_is_laid_flat() -> None:
    flat = [(0, 0, (30, 3), (70, 32)), (5, 0, (30, 3), (70, 32))]
    text = polyline(flat, flags=8).replace("30\n0\n30\n3", "30\n3")
    drawing = read(dxf(text))
    assert_array_equal(rows(drawing), [[0, 0, 5, 0, 0]])
    assert (
        only(drawing) == "the object was imported; note: the object was moved from the height "
        "z = 3 file units to z = 0"
    )


def test_ellipse_is_fitted_within_the_tolerance_with_a_note() -> None:
    text = entity("ELLIPSE", (10, 0), (20, 0), (11, 50), (21, 0), (31, 0), (40, 0.5))
    drawing = read(dxf(text + "41\n0\n42\n6.283185307179586\n"))
    walk = np.concatenate(
        [
            arc.point_at(
                drawing.ends[:, 0], drawing.ends[:, 1], drawing.bulge, np.full(len(drawing), f)
            )
            for f in np.linspace(0.0, 1.0, 21)
        ]
    )
    # To first order the distance of a point from the curve f = 0 is |f| / |∇f|.
    x, y = walk.T
    gradient = np.hypot(2.0 * x / 50.0**2, 2.0 * y / 25.0**2)
    far = float((np.abs(x**2 / 50.0**2 + y**2 / 25.0**2 - 1.0) / gradient).max())
    assert far <= 0.0035
    assert 0.95 * far <= drawing.fit_error.max() <= 0.0035
    fitted = (
        f"the curves of the object were converted to {len(drawing)} "
        "lines and arcs, which deviate by at most 0.0035 file units from the curves"
    )
    assert only(drawing) == f"the object was imported; note: {fitted}"


def test_half_ellipse_at_minus_z_runs_the_other_way() -> None:
    head = ((10, 0), (20, 0), (11, 50), (21, 0), (31, 0), (40, 0.5), (41, 0), (42, math.pi))
    up, down = read(dxf(entity("ELLIPSE", *head))), read(dxf(entity("ELLIPSE", *head, *DOWN)))
    assert_allclose(up.bounds, [-50, 0, 50, 25], atol=0.011)
    assert_allclose(down.bounds, [-50, -25, 50, 0], atol=0.011)


def test_cubic_spline_ends_where_its_control_points_end() -> None:
    control = [(0, 0, 0), (0, 50, 0), (100, 50, 0), (100, 0, 0)]
    drawing = read(dxf(spline(3, [0, 0, 0, 0, 1, 1, 1, 1], control), version="AC1015"))
    assert_array_equal(drawing.ends[0, 0], [0, 0])
    assert_allclose(drawing.ends[-1, 1], [100, 0], atol=1e-12)
    # The top of this Bézier is at t = 1/2: y = 3/4 · 50.
    assert_allclose(drawing.bounds, [0, 0, 100, 37.5], atol=0.011)


def test_spline_through_fit_points_passes_them() -> None:
    points = [(0, 0), (30, 20), (60, 0)]
    body = []
    for x, y in points:
        body += [(11, x), (21, y), (31, 0)]
    text = tags(
        (0, "SPLINE"), (5, "2F4"), (100, "AcDbEntity"), (8, "0"), (100, "AcDbSpline"),
        (70, 8), (71, 3), (74, 3), *body,
    )  # fmt: skip
    drawing = read(dxf(text, version="AC1015"))
    assert only(drawing).startswith(
        "the object was imported; note: the file states only the fit points "
        "of the curve, so the curve was drawn through these points; the curves of the object were"
    )
    joints = drawing.ends.reshape(-1, 2)
    for x, y in points:
        assert np.hypot(*(joints - (x, y)).T).min() < 0.5


def test_spline_in_space_is_dropped() -> None:
    control = [(0, 0, 0), (0, 50, 0), (100, 50, 9), (100, 0, 0)]
    drawing = read(dxf(spline(3, [0, 0, 0, 0, 1, 1, 1, 1], control), version="AC1015"))
    assert (
        only(drawing, ImportOutcome.DROPPED)
        == "the object is not parallel to the XY plane: its height z varies from 0 to 9 file units"
    )


def test_spline_with_too_few_knots_is_dropped() -> None:
    control = [(0, 0, 0), (0, 50, 0), (100, 50, 0), (100, 0, 0)]
    drawing = read(dxf(spline(3, [0, 0, 1], control), version="AC1015"))
    assert only(drawing, ImportOutcome.DROPPED).startswith("the object is damaged")


@pytest.mark.parametrize("bad", ["1e999", "-1e999", "1e308", "-1e308"])
@pytest.mark.parametrize(
    "make",
    [
        lambda bad: line(0, 0, bad, 5),
        lambda bad: entity("CIRCLE", (10, 0), (20, bad), (40, 3)),
        lambda bad: entity("CIRCLE", (10, 0), (20, 0), (40, bad)),
        lambda bad: entity("ARC", (10, 0), (20, 0), (40, 3), (50, bad), (51, 10)),
        lambda bad: polyline([(0, 0), (bad, 1), (2, 2)]),
        lambda bad: polyline([(0, 0, (42, bad)), (1, 1)]),
        lambda bad: entity("ELLIPSE", (10, 0), (20, 0), (11, bad), (21, 0), (31, 0), (40, 0.5)),
        lambda bad: entity("ELLIPSE", (10, 0), (20, 0), (11, 5), (21, 0), (31, 0), (40, bad)),
        lambda bad: entity("LINE", (10, 0), (20, 0), (30, bad), (11, 5), (21, 5), (31, bad)),
    ],
    ids=["end", "centre", "radius", "angle", "vertex", "bulge", "axis", "ratio", "height"],
)
def test_too_large_numbers_drop_only_their_entity(make: Callable[..., Any], bad: str) -> None:
    drawing = read(dxf(make(bad), line(0, 0, 10, 0)))
    assert drawing.import_report.outcome[-1] == ImportOutcome.KEPT
    assert np.isfinite(drawing.ends).all()
    assert np.abs(drawing.ends).max() <= 1e7
    if not (bad in ("1e308", "-1e308") and "50\n" in make(bad)):
        # An angle of 1e308° is finite and therefore valid.
        assert drawing.import_report.outcome[0] == ImportOutcome.DROPPED
        assert len(drawing) == 1


def test_coordinates_beyond_ten_kilometres_are_dropped_with_the_measure() -> None:
    drawing = read(dxf(line(0, 0, 2e7, 0), line(0, 0, 10, 0)))
    assert report_reasons(drawing) == (
        "a coordinate of the object is 20,000,000 file units, but the limit is 10,000,000",
        "the object was imported unchanged",
    )


@pytest.mark.parametrize(
    ("kind", "reason"),
    [
        ("TEXT", "the object is a text, which is not cut"),
        ("POINT", "the object is a point, which has no length"),
        ("3DFACE", "the object is a solid or a face, not a line in a plane"),
        ("SOLID", "the object is a filled area without an outline, so it is not cut"),
        ("XLINE", "the object is a construction line of infinite length"),
        ("DIMENSION", "the object is a dimension or a note, which is not cut"),
        ("NONSENSE", "the object is of the type NONSENSE, which cannot be read"),
    ],
)
def test_entities_without_lines_are_dropped_with_the_reason(kind: str, reason: str) -> None:
    text = entity(kind, (10, 1), (20, 1), (11, 5), (21, 0), (12, 3), (22, 3), (13, 0), (23, 0))
    drawing = read(dxf(text, line(0, 0, 1, 0)))
    assert drawing.import_report.kind == (kind, "LINE")
    assert report_reasons(drawing) == (reason, "the object was imported unchanged")


def test_the_position_of_every_kind_equals_that_of_ezdxf() -> None:
    document = ezdxf.new("R2010")
    space = document.modelspace()
    block = document.blocks.new("PART", base_point=(3, 4))
    block.add_line((0, 0), (30, 5))
    block.add_arc((10, 10), 8, 20, 300)
    block.add_circle((40, 10), 5)
    block.add_lwpolyline([(0, 0, 0.7), (10, 0, -0.3), (10, 12, 0)], format="xyb", close=True)
    block.add_ellipse((20, 30), (12, 5), 0.4, 0.5, 5.0)
    block.add_open_spline([(0, 0), (10, 20), (30, 5), (45, 30)])
    block.add_arc((10, 10), 8, 20, 300).dxf.extrusion = (0, 0, -1)
    outer = document.blocks.new("OUTER", base_point=(1, 2))
    outer.add_blockref("PART", (50, 60), {"rotation": 33, "xscale": -1})
    outer.add_blockref("PART", (0, 0), {"xscale": 2, "yscale": 0.5, "rotation": 10})
    space.add_blockref("OUTER", (100, 200), {"rotation": -70, "xscale": 1.5, "yscale": 1.5})
    mirrored = space.add_blockref("PART", (10, 20), {"rotation": 40, "xscale": 2, "yscale": 2})
    mirrored.dxf.extrusion = (0, 0, -1)
    space.add_blockref(
        "PART",
        (300, 0),
        {
            "rotation": 30,
            "xscale": 2,
            "yscale": 2,
            "column_count": 3,
            "row_count": 2,
            "column_spacing": 150,
            "row_spacing": 170,
        },
    )
    document.units = 4
    stream = io.StringIO()
    document.write(stream)
    drawing = read(stream.getvalue().encode())
    assert set(drawing.import_report.outcome) == {ImportOutcome.KEPT}
    length, low, high = 0.0, np.full(2, np.inf), np.full(2, -np.inf)
    for piece in disassemble.recursive_decompose(space):
        points = np.array([(p.x, p.y) for p in path.make_path(piece).flattening(2e-4, 64)])
        length += float(np.hypot(*np.diff(points, axis=0).T).sum())
        low, high = np.minimum(low, points.min(axis=0)), np.maximum(high, points.max(axis=0))
    assert_allclose(drawing.lengths.sum(), length, rtol=2e-4)
    assert_allclose(drawing.bounds, [*low, *high], atol=0.02)


def test_turned_block_in_an_unevenly_scaled_one_is_sheared() -> None:
    # ezdxf cannot represent this; by hand: rotate by 30°, then scale y by 3.
    inner = block("INNER", line(0, 0, 10, 0), entity("CIRCLE", (10, 0), (20, 0), (40, 5)))
    outer = block("OUTER", insert("INNER", 0, 0, (50, 30)))
    drawing = read(dxf(insert("OUTER", 100, 200, (42, 3)), blocks=(inner, outer)))
    assert drawing.import_report.kind == ("INSERT", "INSERT", "LINE", "CIRCLE")
    tip = [100.0 + 10.0 * math.cos(math.radians(30)), 200.0 + 30.0 * math.sin(math.radians(30))]
    assert_allclose(drawing.ends[0], np.array([(100, 200), tip], float), atol=1e-12)
    # The circle becomes an ellipse with half axes 5 and 15, independent of the rotation.
    round_ = drawing.import_report.kind.index("CIRCLE")
    ring = drawing.ends[drawing.entity == round_]
    assert_allclose(ring.min(axis=(0, 1)), [95, 185], atol=0.011)
    assert_allclose(ring.max(axis=(0, 1)), [105, 215], atol=0.011)
