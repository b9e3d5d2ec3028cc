"""The JSON Schema of TOML files."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any, cast

import click
import pytest
from click.testing import CliRunner

from knifetip.cartons.registry import STYLES
from knifetip.cli.main import app
from knifetip.languages.registry import language_names
from knifetip.library.load import library_text
from knifetip.library.schema import FILES, json_schema
from knifetip.library.toml_text import read_toml
from knifetip.model.tool import KINDS
from knifetip.testpieces.registry import WIZARDS


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
    *known, own = hpgl["properties"]["device"]["oneOf"]
    assert shipped["device"] in [one["const"] for one in known]
    tables = schema["$defs"]
    assert own["$ref"] == "#/$defs/DeviceTable"
    assert hpgl["properties"]["pen"]["items"] == {"$ref": "#/$defs/PenTable"}
    for pen in shipped["pen"]:
        assert pen.keys() <= tables["PenTable"]["properties"].keys()
    for table in ("DeviceTable", "PenTable"):
        for field in tables[table]["properties"].values():
            assert field["description"]


def _texts(schema: dict[str, Any]) -> Iterator[str]:
    """Yield titles, help and groups of the fields of a schema, as the page shows them."""
    tables = [schema, *schema["$defs"].values()] if "$defs" in schema else [schema]
    tables += [one["then"]["properties"]["controller"] for one in schema.get("allOf", ())]
    for table in tables:
        for field in table.get("properties", {}).values():
            yield from (field[key] for key in ("title", "description", "group") if key in field)
            yield from field.get("itemTitles", ())


def test_the_page_has_a_german_text_for_each_title_and_help() -> None:
    page = Path(__file__).parents[3] / "frontend/src/language/schemaTexts.de.ts"
    known = {
        quoted.replace('\\"', '"') or bare
        for quoted, bare in re.findall(
            r'^  (?:"((?:[^"\\]|\\.)*)"|(\w+)):', page.read_text("utf-8"), re.M
        )
    }
    shown = {text for file in ("machine", "board", "tool") for text in _texts(json_schema(file))}
    assert len(shown) > 200
    for style in STYLES.values():
        shown |= {*_texts(style.parameters.model_json_schema())}
    for wizard in WIZARDS.values():
        shown |= {*_texts(wizard.measures.model_json_schema())}
    assert sorted(shown - known) == []


def test_titles_are_for_people_and_no_value_is_null() -> None:
    schema = json_schema("machine")
    assert schema["properties"]["travel_z"]["title"] == "Travel height"
    assert schema["properties"]["gantry"]["$ref"] == "#/$defs/GantryTable"
    assert (
        schema["$defs"]["StationTable"]["properties"]["spindle_speed"]["title"] == "Spindle speed"
    )
    assert '"null"' not in json.dumps(schema)
    # A comment on several lines is one text.
    swivel = schema["$defs"]["KnifeTable"]["properties"]["swivel"]["description"]
    assert swivel.startswith("swivel angle: at corners")
    assert swivel.endswith("its swivel depth (degrees)")
