"""Edits move ends of edges and add edges; the edges of the file keep their rows."""

from __future__ import annotations

import ezdxf.math
import numpy as np
import pytest

from knifetip import pipeline
from knifetip.edits import LAYER, apply_edits, with_types_of_added
from knifetip.errors import EditRefused
from knifetip.model.dieline import LineType
from knifetip.model.drawing import Drawing
from knifetip.model.edit import AddedCircle, AddedLine, Edit, MovedEnd, edits_from_json, edits_json
from knifetip.model.interpretation import NO_OVERRIDE
from tests.support.serving.server import square

LINE = AddedLine(kind="line", start=(10.0, 50.0), end=(90.0, 50.0), type="crease")
CIRCLE = AddedCircle(kind="circle", centre=(50.0, 20.0), radius=5.0, type="cut")


def read(side: float = 100.0, units: int | None = 4) -> Drawing:
    return pipeline.read(square(side=side, units=units))


def moved(drawing: Drawing, edge: int, x: float, y: float) -> MovedEnd:
    before = tuple(drawing.ends[edge, 0].tolist())
    return MovedEnd(kind="move-end", edge=edge, end="start", before=before, to=(x, y))


def test_added_edges_follow_the_edges_of_the_file() -> None:
    drawing = read()
    edited = apply_edits(drawing, (LINE, CIRCLE))
    assert len(edited) == len(drawing) + 3
    assert (edited.ends[: len(drawing)] == drawing.ends).all()
    assert edited.handles[:4] == drawing.handles
    assert edited.ends[4].tolist() == [[10.0, 50.0], [90.0, 50.0]]
    assert edited.lengths[4] == 80.0
    assert {edited.layers[row] for row in edited.layer[4:]} == {LAYER}
    for row in (5, 6):
        start, end = (ezdxf.math.Vec2(point) for point in edited.ends[row].tolist())
        centre, _, _, radius = ezdxf.math.bulge_to_arc(start, end, float(edited.bulge[row]))
        assert (centre.x, centre.y, radius) == pytest.approx((50.0, 20.0, 5.0))


def test_a_moved_end_changes_one_edge_only() -> None:
    drawing = read()
    edited = apply_edits(drawing, (moved(drawing, 2, 30.0, 40.0),))
    assert edited.ends[2, 0].tolist() == [30.0, 40.0]
    changed = (edited.ends != drawing.ends).any(axis=2)
    assert np.argwhere(changed).tolist() == [[2, 0]]
    assert (drawing.ends == read().ends).all()


def test_an_edge_that_an_edit_has_added_can_be_moved() -> None:
    end = MovedEnd(kind="move-end", edge=4, end="end", before=(90.0, 50.0), to=(80.0, 50.0))
    assert apply_edits(read(), (LINE, end)).ends[4].tolist() == [[10.0, 50.0], [80.0, 50.0]]


@pytest.mark.parametrize(
    ("edits", "code"),
    [
        (
            (MovedEnd(kind="move-end", edge=4, end="start", before=(0, 0), to=(1, 1)),),
            "no-such-edge",
        ),
        (
            (MovedEnd(kind="move-end", edge=0, end="end", before=(7, 7), to=(1, 1)),),
            "end-elsewhere",
        ),
        ((AddedLine(kind="line", start=(1, 1), end=(1, 1), type="cut"),), "no-length"),
        (
            (LINE, MovedEnd(kind="move-end", edge=4, end="end", before=(90, 50), to=(10, 50))),
            "no-length",
        ),
    ],
)
def test_an_edit_that_is_not_possible_is_refused(edits: tuple[Edit, ...], code: str) -> None:
    with pytest.raises(EditRefused) as refused:
        apply_edits(read(), edits)
    assert refused.value.message.code == f"edit.{code}"


def test_a_drawing_without_a_unit_cannot_be_edited() -> None:
    with pytest.raises(EditRefused) as refused:
        apply_edits(read(units=None, side=4.0), (LINE,))
    assert refused.value.message.code == "edit.no-unit"


def test_new_edges_have_the_line_types_of_their_edits() -> None:
    drawing = read()
    edited = apply_edits(drawing, (LINE, CIRCLE))
    none = np.full(7, NO_OVERRIDE, np.uint8)
    types = with_types_of_added(none, (LINE, CIRCLE), edited.handles, drawing.handles)
    assert types.tolist() == [NO_OVERRIDE] * 4 + [LineType.CREASE] + [LineType.CUT] * 2
    # The user has changed the line since; the circle is new.
    changed = none.copy()
    changed[4] = LineType.HALF_CUT
    types = with_types_of_added(changed, (LINE, CIRCLE), edited.handles, edited.handles[:5])
    assert types[4:].tolist() == [LineType.HALF_CUT, LineType.CUT, LineType.CUT]


def test_edits_are_stored_as_json() -> None:
    edits = (LINE, CIRCLE, moved(read(), 0, 1.0, 2.0))
    assert edits_from_json(edits_json(edits)) == edits
