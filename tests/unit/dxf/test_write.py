"""write: what ezdxf, by itself, finds in the bytes."""

from __future__ import annotations

import io
from typing import Any

import ezdxf
import numpy as np
import pytest
from ezdxf import path as vector_path

from knifetip.dxf.samples.write import Layer, write_dxf
from knifetip.errors import GeometryError
from knifetip.geometry.path import Paths, path_through

CUT = Layer("CUT", 1)
FOLD = Layer("FALZ ü 刀", 5, "DASHED")


def entities(data: bytes) -> list[Any]:
    return list(ezdxf.read(io.StringIO(data.decode("utf-8"))).modelspace())


def one(start: tuple[float, float], end: tuple[float, float], bulge: float = 0.0) -> Paths:
    return path_through(np.array([start, end], np.float64), np.array([bulge]))


def test_the_file_is_r2010_in_millimetres_and_states_its_size() -> None:
    data = write_dxf(
        [(CUT, one((10.0, 0.0), (0.0, 0.0), -1.0)), (FOLD, one((0.0, 0.0), (7.0, 20.0)))]
    )
    document = ezdxf.read(io.StringIO(data.decode("utf-8")))
    assert document.dxfversion == "AC1024"
    assert document.header["$INSUNITS"] == 4
    # The half circle hangs 5 mm below its chord.
    assert tuple(document.header["$EXTMIN"]) == (0.0, -5.0, 0.0)
    assert tuple(document.header["$EXTMAX"]) == (10.0, 20.0, 0.0)
    assert document.audit().errors == []


def test_a_drawing_whose_corner_is_the_origin_states_this_extent() -> None:
    data = write_dxf([(CUT, one((0.0, 0.0), (30.0, 40.0)))])
    document = ezdxf.read(io.StringIO(data.decode("utf-8")))
    assert tuple(document.header["$EXTMIN"]) == (0.0, 0.0, 0.0)
    assert tuple(document.header["$EXTMAX"]) == (30.0, 40.0, 0.0)


def test_layers_keep_their_name_colour_and_linetype() -> None:
    data = write_dxf([(CUT, one((0, 0), (1, 0))), (FOLD, one((0, 1), (1, 1)))])
    document = ezdxf.read(io.StringIO(data.decode("utf-8")))
    layers = {layer.dxf.name: (layer.dxf.color, layer.dxf.linetype) for layer in document.layers}
    assert layers["CUT"] == (1, "Continuous")
    assert layers["FALZ ü 刀"] == (5, "DASHED")
    line = list(document.modelspace())[1]
    assert (line.dxf.layer, line.dxf.color) == ("FALZ ü 刀", 256)
    dashes = document.linetypes.get("DASHED")
    assert [tag.value for tag in dashes.pattern_tags.tags if tag.code == 49] == [6.0, -3.0]


def test_one_straight_segment_is_a_line() -> None:
    (line,) = entities(write_dxf([(CUT, one((1.0, 2.0), (3.0, -4.0)))]))
    assert line.dxftype() == "LINE"
    assert tuple(line.dxf.start) == (1.0, 2.0, 0.0)
    assert tuple(line.dxf.end) == (3.0, -4.0, 0.0)


@pytest.mark.parametrize(
    ("start", "end", "bulge", "angles"),
    [
        # A quarter turn to the left about the origin, from east to north.
        ((5.0, 0.0), (0.0, 5.0), np.tan(np.pi / 8), (0.0, 90.0)),
        # The same arc, travelled the other way.
        ((0.0, 5.0), (5.0, 0.0), -np.tan(np.pi / 8), (0.0, 90.0)),
        # Half a turn through the south.
        ((-5.0, 0.0), (5.0, 0.0), 1.0, (180.0, 0.0)),
    ],
)
def test_one_round_segment_is_a_counter_clockwise_arc(
    start: tuple[float, float], end: tuple[float, float], bulge: float, angles: tuple[float, float]
) -> None:
    (arc,) = entities(write_dxf([(CUT, one(start, end, bulge))]))
    assert arc.dxftype() == "ARC"
    assert arc.dxf.center.isclose((0.0, 0.0))
    assert arc.dxf.radius == pytest.approx(5.0, abs=1e-9)
    assert (arc.dxf.start_angle, arc.dxf.end_angle) == pytest.approx(angles, abs=1e-9)


def test_more_segments_are_a_polyline_with_bulges() -> None:
    xy = np.array([[0.0, 0.0], [10.0, 0.0], [10.0, 6.0]])
    (chain,) = entities(write_dxf([(CUT, path_through(xy, np.array([0.0, 1.0])))]))
    assert chain.dxftype() == "LWPOLYLINE"
    assert not chain.closed
    assert list(chain.get_points("xyb")) == [(0.0, 0.0, 0.0), (10.0, 0.0, 1.0), (10.0, 6.0, 0.0)]
    # Half a turn to the left of north-going travel bulges to the east.
    assert max(vertex.x for vertex in vector_path.make_path(chain).flattening(0.01)) == (
        pytest.approx(13.0, abs=0.01)
    )


def test_a_path_that_ends_where_it_began_is_closed_without_a_second_vertex() -> None:
    xy = np.array([[0.0, 0.0], [10.0, 0.0], [0.0, 6.0], [0.0, 0.0]])
    (chain,) = entities(write_dxf([(CUT, path_through(xy, np.array([0.0, 0.0, 0.5])))]))
    assert chain.closed
    assert list(chain.get_points("xyb")) == [(0.0, 0.0, 0.0), (10.0, 0.0, 0.0), (0.0, 6.0, 0.5)]


def test_the_same_paths_give_the_same_bytes_and_leave_no_trace_in_ezdxf() -> None:
    sheet = [(CUT, one((0.0, 0.0), (1.0, 0.0))), (CUT, one((0.0, 1.0), (1.0, 0.0), 0.3))]
    first = write_dxf(sheet)
    ezdxf.new()  # what other documents do in between does not matter
    assert write_dxf(sheet) == first
    assert not ezdxf.options.write_fixed_meta_data_for_testing


def test_no_paths_are_an_empty_drawing() -> None:
    assert entities(write_dxf([])) == []


@pytest.mark.parametrize("bad", [np.nan, np.inf])
def test_a_coordinate_that_is_not_finite_is_refused(bad: float) -> None:
    with pytest.raises(GeometryError, match="A coordinate on the layer CUT is not a number"):
        write_dxf([(CUT, one((0.0, 0.0), (bad, 1.0)))])
