"""schema: generate the JSON Schema (draft 2020-12) of the TOML files of the library.

Editors and the forms of the page use the schema to complete and check the files.  The settings of
a machine's controller depend on its language: they are conditions of the schema (``if``, ``then``).
"""

from __future__ import annotations

import inspect
import re
from typing import Any, Final

from pydantic.json_schema import GenerateJsonSchema, JsonSchemaValue
from pydantic_core import core_schema

from knifetip.fields import Table
from knifetip.languages.registry import find_language, language_names
from knifetip.library.board_file import BoardFile
from knifetip.library.machine_file import MachineFile, ToolFile
from knifetip.library.profile_file import ProfileFile
from knifetip.model.tool import KINDS, Kind, Tool

FILES: Final[dict[str, type[Table]]] = {
    "machine": MachineFile,
    "board": BoardFile,
    "tool": ToolFile,
    "profile": ProfileFile,
}

#: A field with its comment, on the same line or on the lines before.
_SAME_LINE: Final = re.compile(r"^    (\w+): [^#\n]*#: (.+)$", re.MULTILINE)
_LINES_BEFORE: Final = re.compile(r"((?:^    #: .+\n)+)    (\w+): ", re.MULTILINE)


def json_schema(file: str) -> dict[str, Any]:
    """Return the JSON Schema of the kind of TOML file ``file``: a key of ``FILES``."""
    schema = FILES[file].model_json_schema(schema_generator=_FormSchema)
    for kind in KINDS:
        table = schema.get("$defs", {}).get(f"{kind.tool.__name__}Table")
        if table is not None:
            _describe(table, kind)
    if file == "machine":
        _add_languages(schema)
    return {"$schema": "https://json-schema.org/draft/2020-12/schema"} | schema


class _FormSchema(GenerateJsonSchema):
    """Schema with titles for people, and without null, which TOML does not have."""

    def get_title_from_name(self, name: str) -> str:
        """Return the title of a field that declares none."""
        return name.replace("_", " ").capitalize()

    def field_title_should_be_set(self, schema: Any) -> bool:  # noqa: ARG002  # as the base class
        """Return whether a field has a title: each one, also if it is a table."""
        return True

    def nullable_schema(self, schema: core_schema.NullableSchema) -> JsonSchemaValue:
        """Return the schema of a value that may be left out."""
        return self.generate_inner(schema["schema"])

    def default_schema(self, schema: core_schema.WithDefaultSchema) -> JsonSchemaValue:
        """Return a schema with its default, unless it is None."""
        if schema.get("default", ...) is None:
            return self.generate_inner(schema["schema"])
        return super().default_schema(schema)

    def model_schema(self, schema: core_schema.ModelSchema) -> JsonSchemaValue:
        """Return the schema of a table, whose title is that of its field."""
        found = super().model_schema(schema)
        found.pop("title", None)
        return found


def _describe(table: dict[str, Any], kind: Kind) -> None:
    """Add the title of a kind of tool to its schema, and descriptions to its fields."""
    table["title"] = kind.name
    for name, text in _comments(kind.tool).items():
        if name in table["properties"]:
            table["properties"][name]["description"] = text
    if "feed" in table["properties"]:
        table["properties"]["feed"]["title"] = "Feed rate"


def _add_languages(schema: dict[str, Any]) -> None:
    """Add the names of the controller languages, and the settings of each.

    ``schema``: the schema of machines, which is changed in place.
    """
    names = language_names()
    schema["properties"]["dialect"]["enum"] = names
    conditions = []
    for name in names:
        language = find_language(name)
        settings: dict[str, Any] = {"maxProperties": 0}
        if language.settings:
            settings = {}
        if language.settings_table:
            settings = language.load_part("settings_table").model_json_schema(
                schema_generator=_FormSchema
            )
            tables = settings.pop("$defs", {})
            assert tables.keys().isdisjoint(schema["$defs"]), sorted(tables)
            schema["$defs"] |= tables
        conditions.append(
            {
                "if": {"properties": {"dialect": {"const": name}}},
                "then": {"properties": {"controller": settings}},
            }
        )
    schema["allOf"] = conditions


def _comments(tool: type[Tool]) -> dict[str, str]:
    """Return the ``#:`` comment of each field of a class of tools, by the name of the field.

    The comments are taken from the source code of the class.
    """
    source = inspect.getsource(tool)
    same_line = dict(_SAME_LINE.findall(source))
    lines_before = {
        name: " ".join(line.strip().removeprefix("#: ") for line in lines.splitlines())
        for lines, name in _LINES_BEFORE.findall(source)
    }
    return lines_before | same_line
