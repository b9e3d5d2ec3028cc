"""Objects that the author of a DXF file does not see are left out, with a reason."""

from __future__ import annotations

import pytest

from knifetip.errors import KnifetipError
from knifetip.model.drawing import Drawing, ImportOutcome
from tests.support.truth.readers import difference, fast_reader_accepts, read_by_both
from tests.support.writers.dxf_text import block, dxf, entity, insert, layer, line, tags

OFF = "import.layer-off"
FROZEN = "import.layer-frozen"
NOT_PLOTTED = "import.layer-not-plotted"
NEVER_PLOTTED = "import.layer-never-plotted"

LAYERS = (
    layer("OFF", -3),
    layer("ICE", 4, flags=1),
    layer("BOTH", -4, flags=1),
    layer("DRAFT", 5) + tags((290, 0)),
    layer("CUT", 1),
)


def lines(*layers: str) -> str:
    """Return one line on each layer; the length of line i is i + 1."""
    return "".join(line(0, 0, i + 1, 0, (8, name)) for i, name in enumerate(layers))


def read(*entities: str, blocks: tuple[str, ...] = (), more: tuple[str, ...] = ()) -> Drawing:
    """Return the drawing, after a check that both readers return the same."""
    data = dxf(*entities, blocks=blocks, layers=(*LAYERS, *more), version="AC1015")
    assert fast_reader_accepts(data)
    fast, slow = read_by_both(data)
    assert difference(fast, slow) == ""
    assert not isinstance(fast, KnifetipError)
    return fast


def lengths(drawing: Drawing) -> list[float]:
    return sorted(round(length, 6) for length in drawing.lengths.tolist())


def dropped(drawing: Drawing) -> dict[str, tuple[str, str]]:
    """Return layer and reason code of each dropped entity by its handle."""
    report = drawing.import_report
    rows = zip(report.handle, report.layer, report.reason, report.outcome.tolist(), strict=True)
    return {
        handle: (name, reason.code)
        for handle, name, reason, outcome in rows
        if outcome == ImportOutcome.DROPPED
    }


def test_objects_on_layers_that_are_off_frozen_or_not_plotted_are_left_out() -> None:
    drawing = read(lines("CUT", "OFF", "ICE", "DRAFT", "BOTH", "0", "NOWHERE"))
    assert lengths(drawing) == [1.0, 6.0, 7.0]
    assert dropped(drawing) == {
        "#2": ("OFF", OFF),
        "#3": ("ICE", FROZEN),
        "#4": ("DRAFT", NOT_PLOTTED),
        "#5": ("BOTH", FROZEN),
    }


def test_layer_names_are_compared_without_regard_to_case() -> None:
    assert dropped(read(lines("off", "CUT"))) == {"#1": ("off", OFF)}


@pytest.mark.parametrize("more", [(), (layer("DEFPOINTS", 7),)])
def test_the_layer_of_definition_points_is_never_plotted(more: tuple[str, ...]) -> None:
    drawing = read(lines("CUT", "Defpoints"), more=more)
    assert dropped(drawing) == {"#2": ("Defpoints", NEVER_PLOTTED)}


def test_a_drawing_of_which_all_is_hidden_has_no_edges() -> None:
    drawing = read(lines("OFF", "ICE"))
    assert len(drawing) == 0
    assert len(dropped(drawing)) == 2


def test_polylines_circles_and_curves_on_hidden_layers_are_left_out() -> None:
    drawing = read(
        line(0, 0, 1, 0),
        entity("CIRCLE", (8, "OFF"), (10, 0), (20, 0), (40, 5)),
        entity("LWPOLYLINE", (8, "ICE"), (90, 2), (70, 0), (10, 0), (20, 0), (10, 3), (20, 4)),
        entity("LWPOLYLINE", (8, "ICE"), (90, 1), (70, 0), (10, 0), (20, 0)),
        entity("ELLIPSE", (8, "OFF"), (10, 0), (20, 0), (11, 5), (21, 0), (40, 0.5)),
    )
    assert lengths(drawing) == [1.0]
    assert [code for _, code in dropped(drawing).values()] == [OFF, FROZEN, FROZEN, OFF]


def test_the_location_of_a_hidden_object_is_recorded() -> None:
    drawing = read(line(10, 20, 30, 25, (8, "OFF")), line(0, 0, 1, 0))
    boxes = drawing.import_report.location_boxes
    assert boxes.rows.tolist() == [0]
    assert boxes.box.tolist() == [[10.0, 20.0, 30.0, 25.0]]


#: Lines of length 1 on layer 0, 2 on CUT, 3 on OFF, 4 on ICE and 5 on DRAFT.
PART = block("PART", lines("0", "CUT", "OFF", "ICE", "DRAFT"))


@pytest.mark.parametrize(
    ("insert_layer", "seen", "reason_on_layer_0"),
    [
        ("CUT", [1.0, 2.0], None),
        ("OFF", [2.0], ("OFF", OFF)),
        ("DRAFT", [2.0], ("DRAFT", NOT_PLOTTED)),
        ("Defpoints", [2.0], ("Defpoints", NEVER_PLOTTED)),
    ],
)
def test_a_layer_that_is_off_or_not_plotted_hides_only_what_lies_on_it(
    insert_layer: str, seen: list[float], reason_on_layer_0: tuple[str, str] | None
) -> None:
    drawing = read(insert("PART", 0, 0, (8, insert_layer)), blocks=(PART,))
    assert lengths(drawing) == seen
    hidden = {"#1/#3": ("OFF", OFF), "#1/#4": ("ICE", FROZEN), "#1/#5": ("DRAFT", NOT_PLOTTED)}
    if reason_on_layer_0:
        hidden["#1/#1"] = reason_on_layer_0
    assert dropped(drawing) == hidden


def test_a_frozen_layer_hides_the_whole_insert() -> None:
    drawing = read(line(0, 0, 9, 0), insert("PART", 0, 0, (8, "ICE")), blocks=(PART,))
    assert lengths(drawing) == [9.0]
    # The block is not reported as unused.
    assert dropped(drawing) == {"#2": ("ICE", FROZEN)}


def test_inserts_of_one_block_on_different_layers_show_different_objects() -> None:
    drawing = read(
        *(insert("PART", 10 * i, 0, (8, name)) for i, name in enumerate(("CUT", "OFF", "CUT"))),
        line(0, 5, 7, 5),
        blocks=(PART,),
    )
    assert lengths(drawing) == [1.0, 1.0, 2.0, 2.0, 2.0, 7.0]
    assert {round(x, 6) for x in drawing.ends[:, 0, 0].tolist()} == {0.0, 10.0, 20.0}


def test_the_content_of_nested_blocks_is_hidden_by_each_insert() -> None:
    outer = block(
        "OUTER",
        insert("PART", 0, 0, (8, "0")),  # takes the layer of the outer INSERT
        insert("PART", 0, 10, (8, "OFF")),
        insert("PART", 0, 20, (8, "ICE")),
    )
    drawing = read(insert("OUTER", 0, 0, (8, "CUT")), blocks=(PART, outer))
    assert lengths(drawing) == [1.0, 2.0, 2.0]
    on_off = read(insert("OUTER", 0, 0, (8, "OFF")), blocks=(PART, outer))
    assert lengths(on_off) == [2.0, 2.0]
    assert dropped(on_off)["#1/#1/#1"] == ("OFF", OFF)
    on_ice = read(insert("OUTER", 0, 0, (8, "ICE")), line(0, 0, 9, 0), blocks=(PART, outer))
    assert lengths(on_ice) == [9.0]
    assert dropped(on_ice) == {"#1": ("ICE", FROZEN)}


def test_an_object_on_layer_0_of_a_block_is_seen_although_layer_0_is_off() -> None:
    drawing = read(
        insert("PART", 0, 5, (8, "CUT")), lines("0", "CUT"), blocks=(PART,), more=(layer("0", -7),)
    )
    assert lengths(drawing) == [1.0, 2.0, 2.0]
    assert dropped(drawing)["#2"] == ("0", OFF)


def test_an_invisible_object_is_left_out_and_its_block_is_not_called_unused() -> None:
    drawing = read(insert("PART", 0, 0, (60, 1)), line(0, 0, 9, 0), blocks=(PART,))
    assert lengths(drawing) == [9.0]
    assert dropped(drawing) == {"#1": ("0", "import.invisible")}


def test_texts_on_hidden_layers_keep_their_own_reason() -> None:
    text = entity("TEXT", (8, "OFF"), (10, 0), (20, 0), (40, 5), (1, "Rev. B"))
    assert dropped(read(line(0, 0, 1, 0), text)) == {"#2": ("OFF", "import.text")}
