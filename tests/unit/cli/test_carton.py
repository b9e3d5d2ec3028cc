"""knifetip carton: styles as subcommands, whose files are read back without a question."""

from __future__ import annotations

import json
from pathlib import Path

import ezdxf
import pytest

from knifetip import pipeline
from knifetip.cartons.registry import STYLES
from knifetip.model.dieline import LineType
from knifetip.model.interpretation import Interpretation
from tests.support.command import Command

SIZE = ("--length", "200", "--width", "150", "--depth", "60")


@pytest.mark.parametrize("code", STYLES)
def test_a_carton_is_read_back_with_its_line_types_and_no_question(
    knifetip: Command, tmp_path: Path, code: str
) -> None:
    style, path = STYLES[code], tmp_path / "carton.dxf"
    exit_code, out, err = knifetip("carton", code, *SIZE, "--board", style.board, "-o", path)
    assert (exit_code, out.strip()) == (0, str(path)), err
    layers = {entity.dxf.layer for entity in ezdxf.readfile(path).modelspace()}
    folds = {"V-GROOVE"} if code == "rigid-box" else {"CREASE"}
    assert layers == {"CUT", *folds}
    drawing = pipeline.read(path.read_bytes())
    dieline = pipeline.interpret(drawing, Interpretation())
    assert drawing.unit == "mm"
    assert pipeline.questions(drawing, dieline) == []
    expected = {"CUT": LineType.CUT, "CREASE": LineType.CREASE, "V-GROOVE": LineType.V_GROOVE}
    read = [expected[drawing.layers[layer]] for layer in drawing.layer]
    assert dieline.line_type.tolist() == read


def test_the_same_carton_gives_the_same_file(knifetip: Command, tmp_path: Path) -> None:
    files = [tmp_path / name for name in ("a.dxf", "b.dxf")]
    for path in files:
        assert knifetip("carton", "fefco-0427", *SIZE, "--board", "b-flute", "-o", path)[0] == 0
    assert files[0].read_bytes() == files[1].read_bytes()


def test_the_list_has_all_styles(knifetip: Command) -> None:
    code, out, _ = knifetip("carton", "--list")
    assert code == 0
    for style in STYLES.values():
        assert f"{style.code:16} {style.name}" in out.splitlines()
    listed = json.loads(knifetip("carton", "--list", "--json")[1])
    assert [one["code"] for one in listed] == list(STYLES)
    assert (
        "lids"
        in next(one for one in listed if one["code"] == "ecma-a20.20")["parameters"]["properties"]
    )


def test_options_are_the_fields_of_the_style(knifetip: Command, tmp_path: Path) -> None:
    path = tmp_path / "a.dxf"
    words = ("--length", "70", "--width", "40", "--depth", "120", "--board", "fbb-0.4", "-o", path)
    heights = []
    for lids in ("reverse", "straight"):
        assert knifetip("carton", "ecma-a20.20", *words, "--lids", lids)[0] == 0
        drawing = pipeline.read(path.read_bytes())
        heights.append(drawing.ends[:, 0].tolist())
    assert heights[0] != heights[1]
    assert knifetip("carton", "ecma-a20.20", *words, "--lids", "sideways")[0] == 2
    assert knifetip("carton", "fefco-0427", *SIZE, "-o", path)[0] == 2
    assert knifetip("carton", "fefco-9999", *SIZE)[0] == 2


def test_an_impossible_carton_is_refused_and_nothing_is_written(
    knifetip: Command, tmp_path: Path
) -> None:
    path = tmp_path / "a.dxf"
    words = ("--length", "200", "--width", "150", "--depth", "9", "--board", "b-flute")
    code, _, err = knifetip("carton", "fefco-0427", *words, "-o", path)
    assert code == 3
    assert "depth 9 is too small" in err
    assert "at least 24 mm" in err
    assert not path.exists()
