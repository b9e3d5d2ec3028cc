"""The JSON Schema of TOML files."""

from __future__ import annotations

import json
from typing import cast

import click
import pytest
from click.testing import CliRunner

from knifetip.cli.main import app
from knifetip.languages.registry import language_names
from knifetip.library.load import library_text
from knifetip.library.schema import FILES, json_schema
from knifetip.library.toml_text import read_toml
from knifetip.model.tool import KINDS


@pytest.mark.parametrize("file", FILES)
def test_the_command_prints_the_schema_of_each_file(file: str) -> None:
    shown = CliRunner().invoke(cast(click.Command, app), ["schema", file])
    assert json.loads(shown.stdout) == json_schema(file)
    assert json_schema(file)["additionalProperties"] is False


def test_fields_of_tools_have_limits_and_descriptions() -> None:
    tables = json_schema("machine")["$defs"]
    for kind in KINDS:
        fields = tables[f"{kind.tool.__name__}Table"]["properties"]
        assert fields.pop("kind")["const"] == kind.name
        assert list(fields) == list(kind.tool.__slots__)
    laser = tables["LaserTable"]
    assert laser["properties"]["kerf"]["description"] == (
        "width of the cut (mm); half of it is the radius r"
    )
    assert laser["properties"]["kerf"]["exclusiveMinimum"] == 0
    assert laser["required"] == ["kind", "kerf", "feed", "power", "pierce"]
    assert tables["KnifeTable"]["properties"]["blade_angle"]["description"].startswith("slant")


def test_a_condition_is_one_pattern_or_a_list() -> None:
    layer = json_schema("profile")["$defs"]["RuleTable"]["properties"]["layer"]
    assert [one["type"] for one in layer["anyOf"]] == ["string", "array"]


def test_the_settings_of_a_controller_depend_on_its_language() -> None:
    schema = json_schema("machine")
    settings = {
        condition["if"]["properties"]["dialect"]["const"]: condition["then"]["properties"]
        for condition in schema["allOf"]
    }
    assert list(settings) == schema["properties"]["dialect"]["enum"] == language_names()
    assert settings["grblhal"]["controller"] == {"maxProperties": 0}
    hpgl = settings["hpgl"]["controller"]
    shipped = read_toml(library_text("machines", "flat-cutter-hpgl"))["controller"]
    assert shipped.keys() <= hpgl["properties"].keys()
    known, own = hpgl["properties"]["device"]["anyOf"]
    assert shipped["device"] in known["enum"]
    tables = schema["$defs"]
    assert own == {"$ref": "#/$defs/DeviceTable"}
    assert hpgl["properties"]["pen"]["items"] == {"$ref": "#/$defs/PenTable"}
    for pen in shipped["pen"]:
        assert pen.keys() <= tables["PenTable"]["properties"].keys()
    for table in ("DeviceTable", "PenTable"):
        for field in tables[table]["properties"].values():
            assert field["description"]
