"""Warnings about what import left out."""

from __future__ import annotations

import io
import sys
from pathlib import Path

import ezdxf
import pytest
from ezdxf.xclip import XClip

from knifetip import pipeline
from knifetip.cli import main
from knifetip.messages import hint
from knifetip.presentation.drawing import drawing_json
from knifetip.presentation.import_warnings import import_warnings
from tests.support.writers import dxf_text as text
from tests.support.writers.svg_text import svg

SIDE = text.line(0.0, 0.0, 100.0, 0.0, (8, "CUT"))


def warnings(*entities: str) -> list[str]:
    return [str(one) for one in import_warnings(pipeline.read(text.dxf(SIDE, *entities)))]


def hidden(layer: str, at: float) -> str:
    return text.line(0.0, at, 100.0, at, (8, layer), (60, 1))


def test_a_drawing_of_which_nothing_was_left_out_has_no_warning() -> None:
    assert warnings() == []


def test_texts_are_left_out_without_a_warning() -> None:
    assert warnings(text.entity("TEXT", (8, "N"), (10, 0), (20, 0), (40, 5), (1, "Rev. B"))) == []


def test_objects_of_one_layer_and_reason_are_one_warning_and_the_most_come_first() -> None:
    assert warnings(hidden("A", 1.0), hidden("B", 2.0), hidden("B", 3.0)) == [
        "2 objects on layer 'B' are not cut: the object is marked as invisible.",
        "1 object on layer 'A' is not cut: the object is marked as invisible.",
    ]


def test_more_than_eight_warnings_are_counted() -> None:
    many = warnings(*(hidden(f"L{number}", float(number)) for number in range(1, 11)))
    assert len(many) == 9
    assert many[-1] == "2 further objects are not cut."


def test_the_data_of_a_drawing_have_the_warnings_with_their_hints() -> None:
    drawing = pipeline.read(text.dxf(SIDE, hidden("A", 1.0)))
    (one,) = import_warnings(drawing)
    assert hint(one).startswith("The import report lists it.")
    assert one.as_json() in drawing_json(drawing)["warnings"]


def test_entities_that_were_changed_have_a_warning_of_their_own() -> None:
    line = '<path id="Cut" d="M50 50H150"/>'
    (one,) = import_warnings(pipeline.read(svg(line)))
    assert str(one) == (
        "1 object on layer 'Cut' is imported with a change: a part of the object lies outside the "
        "visible area of the page."
    )


@pytest.mark.parametrize("command", ["read", "classify"])
def test_the_command_line_prints_the_warnings(
    command: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capfd: pytest.CaptureFixture[str],
) -> None:
    file = tmp_path / "hidden.dxf"
    file.write_bytes(text.dxf(SIDE, hidden("A", 1.0)))
    monkeypatch.setattr(sys, "argv", ["knifetip", command, str(file)])
    with pytest.raises(SystemExit):
        main()
    printed = capfd.readouterr()
    assert "1 object on layer 'A' is not cut" in printed.out + printed.err


LOST = {
    "hatch": (text.entity("HATCH", (10, 0), (20, 0)), "hatch"),
    "multiline": (text.entity("MLINE", (10, 0), (20, 0)), "MLINE"),
    "solid": (text.entity("SOLID", (10, 0), (20, 0)), "filled area"),
    "radius": (text.entity("CIRCLE", (10, 0), (20, 0), (40, -3)), "radius of the object is -3"),
    "no radius": (text.entity("ARC", (10, 0), (20, 0), (50, 0), (51, 90)), "radius is missing"),
    "block": (text.insert("LID"), "block 'LID'"),
    "height": (
        text.entity("LINE", (10, 0), (20, 0), (30, 0), (11, 5), (21, 5), (31, 9)),
        "not parallel to the XY plane",
    ),
    "layout": (text.line(0, 0, 5, 5, (67, 1)), "in a layout (paper space)"),
    "region": (text.entity("REGION", (70, 1)), "region"),
}


@pytest.mark.parametrize(("entity", "words"), LOST.values(), ids=list(LOST))
def test_geometry_that_cannot_be_read_is_warned_about(entity: str, words: str) -> None:
    (warning,) = warnings(entity)
    assert words in warning


@pytest.mark.parametrize(
    "entity",
    [
        text.entity("TEXT", (67, 1), (10, 0), (20, 0), (40, 5), (1, "Scale 1:2")),
        text.entity("VIEWPORT", (67, 1), (10, 0), (20, 0), (40, 5), (41, 5)),
        text.entity("POINT", (10, 0), (20, 0)),
        text.line(1, 1, 1, 1),
    ],
)
def test_what_is_never_cut_is_left_out_without_a_warning(entity: str) -> None:
    assert warnings(entity) == []


@pytest.mark.parametrize(
    ("layer", "hint_words"),
    [
        (text.layer("OLD", -1), "Switch the layer on"),
        (text.layer("OLD", 1, flags=1), "Thaw the layer"),
    ],
)
def test_the_hint_tells_how_a_hidden_layer_is_cut(layer: str, hint_words: str) -> None:
    data = text.dxf(SIDE, text.line(0, 9, 50, 9, (8, "OLD")), layers=(layer,))
    (warning,) = import_warnings(pipeline.read(data))
    assert "on layer 'OLD'" in str(warning)
    assert hint_words in hint(warning)


def test_everything_that_was_left_out_of_a_drawing_without_edges_is_warned_about() -> None:
    label = text.entity("TEXT", (8, "N"), (10, 0), (20, 0), (40, 5), (1, "Rev. B"))
    data = text.dxf(label, blocks=(text.block("PART", SIDE),))
    label_warning, block_warning = import_warnings(pipeline.read(data))
    assert "the object is a text" in str(label_warning)
    assert "the drawing does not use it" in str(block_warning)


def test_a_missing_end_mark_is_the_first_warning() -> None:
    data = text.dxf(SIDE, hidden("A", 1.0)).replace(b"0\nEOF\n", b"")
    first, second = import_warnings(pipeline.read(data))
    assert str(first) == (
        "Check the drawing: the end mark EOF of the file is missing, so objects may be missing."
    )
    assert hint(first).startswith("Compare the drawing")
    assert "on layer 'A'" in str(second)


def test_a_clipped_block_is_to_be_checked() -> None:
    document = ezdxf.new("R2010")
    block = document.blocks.new("PART")
    block.add_line((0, 0), (100, 0))
    insert = document.modelspace().add_blockref("PART", (0, 0))
    XClip(insert).set_block_clipping_path([(0, -5), (50, 5)])
    stream = io.StringIO()
    document.write(stream)
    (warning,) = import_warnings(pipeline.read(stream.getvalue().encode()))
    assert str(warning) == (
        "1 object on layer '0' is imported with a change: the file clips the object, but the "
        "complete object was imported."
    )
    assert "Trim the object" in hint(warning)
