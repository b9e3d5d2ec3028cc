"""Line widths of DXF entities: group 370, and the widths of polylines."""

from __future__ import annotations

import pytest

from knifetip.dxf.read import read
from tests.support.truth.readers import difference, fast_reader_accepts, read_by_both
from tests.support.writers.dxf_text import Tag, block, dxf, entity, insert, layer, line, tags

#: A layer with 0.7 mm, one whose width is the default of the program, and one without a width.
LAYERS = (
    layer("WIDE", 1) + tags((370, 70)),
    layer("DEFAULT", 2) + tags((370, -3)),
    layer("BARE", 3),
)
FLAP = block(
    "FLAP",
    line(0, 0, 9, 0, (370, -2)),
    line(0, 1, 9, 1, (370, 18)),
    line(0, 2, 9, 2),
    line(0, 3, 9, 3, (8, "WIDE")),
    line(0, 4, 9, 4, (370, -3)),
)


def widths(*entities: str, blocks: tuple[str, ...] = (), units: object = 4) -> list[int]:
    """Return the line width of each edge (1/100 mm), read equally by both readers."""
    data = dxf(*entities, blocks=blocks, layers=LAYERS, units=units, version="AC1015")
    fast, slow = read_by_both(data)
    assert difference(fast, slow) == ""
    return list(read(data).line_width.tolist())


def lwpolyline(*vertices: tuple[Tag, ...], whole: tuple[Tag, ...] = ()) -> str:
    """Return a polyline of 9 mm steps; each vertex has further tags."""
    points = [((10, 9 * at), (20, 0), *more) for at, more in enumerate(vertices)]
    return entity("LWPOLYLINE", (90, len(points)), (70, 0), *whole, *(t for p in points for t in p))


def polyline(*vertices: tuple[Tag, ...], whole: tuple[Tag, ...] = ()) -> str:
    rows = [entity("VERTEX", (10, 9 * at), (20, 0), *more) for at, more in enumerate(vertices)]
    return entity("POLYLINE", (66, 1), *whole) + "".join(rows) + entity("SEQEND")


def both(width: float) -> tuple[Tag, ...]:
    """Return the tags of a vertex with one width at the start and at the end."""
    return (40, width), (41, width)


@pytest.mark.parametrize(
    ("name", "given", "expected"),
    [
        ("WIDE", (), 70),
        ("WIDE", ((370, -1),), 70),
        ("WIDE", ((370, 50),), 50),
        ("WIDE", ((370, 0),), 0),
        ("WIDE", ((370, -3),), -1),
        ("WIDE", ((370, -2),), -1),
        ("WIDE", ((370, -9),), 70),
        ("wide", (), 70),
        ("DEFAULT", (), -1),
        ("DEFAULT", ((370, 13),), 13),
        ("BARE", (), -1),
        ("NOT LISTED", (), -1),
        ("BARE", ((370, 17),), 17),
        ("BARE", ((370, 99_999_999),), 1_000_000),
    ],
)
def test_an_entity_has_its_own_width_or_that_of_its_layer(
    name: str, given: tuple[Tag, ...], expected: int
) -> None:
    assert widths(line(0, 0, 9, 0, (8, name), *given)) == [expected]


def test_a_curve_has_a_width_too() -> None:
    ellipse = entity(
        "ELLIPSE", *((370, 50), (10, 0), (20, 0), (11, 9), (21, 0), (40, 0.5), (41, 0), (42, 3))
    )
    assert set(widths(ellipse)) == {50}


def test_a_drawing_without_widths_states_none() -> None:
    drawing = read(dxf(line(0, 0, 9, 0, (8, "CUT")), lwpolyline((), ())))
    assert drawing.line_width.tolist() == [-1, -1]


def test_a_width_in_an_unusual_place_is_read() -> None:
    text = tags(
        *((0, "LINE"), (100, "AcDbEntity"), (8, "0"), (100, "AcDbLine")),
        *((10, 0), (20, 0), (11, 9), (21, 0), (370, 35)),
    )
    assert widths(text, line(0, 5, 9, 5, (370, 18), (370, 50))) == [35, 50]


@pytest.mark.parametrize(
    ("given", "expected"),
    [
        (((8, "WIDE"),), [70, 18, 70, 70, -1]),
        (((8, "WIDE"), (370, 35)), [35, 18, 70, 70, -1]),
        (((8, "BARE"), (370, 35)), [35, 18, -1, 70, -1]),
        (((8, "BARE"),), [-1, 18, -1, 70, -1]),
        (((8, "WIDE"), (370, -2)), [-1, 18, 70, 70, -1]),
        # Unequal scales and arrays are expanded one by one.
        (((8, "WIDE"), (370, 35), (70, 2), (44, 50)), [35, 35, 18, 18, 70, 70, 70, 70, -1, -1]),
    ],
)
def test_contents_of_a_block_take_the_width_of_their_insert(
    given: tuple[Tag, ...], expected: list[int]
) -> None:
    assert widths(insert("FLAP", 0, 0, *given), blocks=(FLAP,)) == expected


def test_two_inserts_with_different_widths_give_their_contents_different_ones() -> None:
    found = widths(
        insert("FLAP", 0, 0, (8, "BARE"), (370, 35)),
        insert("FLAP", 0, 50, (8, "BARE"), (370, 50)),
        blocks=(FLAP,),
    )
    assert found == [35, 18, -1, 70, -1, 50, 18, -1, 70, -1]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        pytest.param(lwpolyline((), (), whole=((43, 0.5),)), 50, id="constant width"),
        pytest.param(lwpolyline((), (), whole=((370, 18), (43, 0.5))), 50, id="wider than 370"),
        pytest.param(lwpolyline((), (), whole=((370, 18), (43, 0.0))), 18, id="no width"),
        pytest.param(lwpolyline(both(0.3), both(0.3)), 30, id="at its vertices"),
        pytest.param(lwpolyline(both(0.3), both(0.3), whole=((43, 0.5),)), 30, id="both"),
        pytest.param(lwpolyline(both(0.0), both(0.0), whole=((43, 0.5),)), 50, id="0 at vertices"),
        pytest.param(lwpolyline(both(0.3), ()), -1, id="tapers"),
        pytest.param(lwpolyline(both(0.3), both(0.2)), -1, id="varies"),
        pytest.param(lwpolyline(((40, 3.0), (41, 0.0)), ()), -1, id="arrow"),
        pytest.param(lwpolyline((), (), whole=((43, -0.5),)), -1, id="negative"),
        pytest.param(lwpolyline((), (), whole=((40, 0.5), (41, 0.5))), -1, id="before vertices"),
        pytest.param(polyline((), (), whole=both(0.4)), 40, id="of the whole polyline"),
        pytest.param(polyline(both(0.2), both(0.2), whole=both(0.566929)), 20, id="pstoedit"),
        pytest.param(polyline(both(0.2), (), whole=both(0.2)), 20, id="partly its own"),
        pytest.param(polyline(both(0.2), (), whole=both(0.4)), -1, id="partly another"),
        pytest.param(polyline(((40, 0.2),), ((40, 0.2),)), -1, id="starts only"),
        pytest.param(
            polyline(((40, 0.2),), ((40, 0.2),), whole=((41, 0.2),)), 20, id="ends of the whole"
        ),
        pytest.param(polyline((), (), whole=((40, 0.4), (41, 0.3))), -1, id="tapers as a whole"),
    ],
)
def test_a_polyline_of_one_width_is_drawn_so_wide(text: str, expected: int) -> None:
    assert widths(text) == [expected]


def test_widths_of_polylines_have_the_unit_of_the_drawing_and_group_370_has_not() -> None:
    entities = (lwpolyline((), (), whole=((43, 0.02),)), line(0, 5, 9, 5, (370, 50)))
    assert widths(*entities, units=1) == [51, 50]
    assert widths(*entities, units=5) == [20, 50]
    assert widths(*entities, units=None) == [2, 50]
    assert read(dxf(*entities, units=None), "in").line_width.tolist() == [51, 50]


def test_an_insert_scales_the_widths_of_polylines() -> None:
    flap = block(
        "FLAP",
        lwpolyline((), (), whole=((43, 0.2),)),
        line(0, 1, 9, 1, (370, 18)),
        line(0, 2, 9, 2),
    )
    scales = [((41, x), (42, y)) for x, y in ((1.0, 1.0), (2.0, 2.0), (-1.0, 1.0), (2.0, 4.5))]
    places = (insert("FLAP", 0, 50 * at, *scale) for at, scale in enumerate(scales))
    found = widths(*places, blocks=(flap,))
    assert found == [20, 18, -1, 40, 18, -1, 20, 18, -1, 60, 18, -1]


def test_common_widths_are_read_by_the_fast_reader() -> None:
    data = dxf(
        line(0, -9, 9, -9, (370, 50)),
        lwpolyline(both(0.3), both(0.3)),
        insert("FLAP", 0, 9, (370, 35)),
        polyline((), both(0.3), whole=both(0.3)),
        blocks=(FLAP,),
        layers=LAYERS,
        version="AC1015",
    )
    assert fast_reader_accepts(data)
    assert read(data).line_width.tolist() == [50, 30, 35, 18, -1, 70, -1]


def test_an_edge_drawn_twice_has_the_width_of_the_first() -> None:
    assert widths(line(0, 0, 9, 0, (370, 50)), line(9, 0, 0, 0, (370, 18))) == [50]
