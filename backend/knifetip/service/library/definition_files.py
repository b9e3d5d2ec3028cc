"""The JSON Schemas of the files of machines, boards and tools, as components of the description."""

from __future__ import annotations

from typing import Any, Final

from knifetip.library.definition import Shelf
from knifetip.library.schema import json_schema

_COMPONENTS: Final = "#/components/schemas/"
_DEFINITIONS: Final = "#/$defs/"
#: The answer with a JSON Schema.
JSON_SCHEMA: Final[dict[str, Any]] = {
    "content": {
        "application/json": {
            "schema": {
                "type": "object",
                "title": "JsonSchema",
                "description": "JSON Schema (draft 2020-12)",
                "required": ["$schema", "type", "properties"],
                "properties": {
                    "$schema": {"type": "string", "description": "URI of the draft"},
                    "title": {"type": "string", "description": "Name of the schema"},
                    "description": {"type": "string", "description": "What it describes"},
                    "type": {"const": "object", "description": "Always `object`"},
                    "properties": {"type": "object", "description": "Schemas of the fields"},
                },
            }
        }
    }
}


def definition_ref(shelf: Shelf) -> str:
    """Return the reference to the schema of the files of a kind, in the OpenAPI description."""
    return _COMPONENTS + _name(shelf)


def _name(shelf: Shelf) -> str:
    return f"{shelf.word.capitalize()}Definition"


def add_definition_files(schemas: dict[str, Any]) -> None:
    """Add the schemas of the files of machines, boards and tools to the components.

    Parameters
    ----------
    schemas
        Schemas of the description by name, which are changed.
    """
    for shelf in Shelf:
        own = json_schema(shelf.word)
        own.pop("$schema", None)
        parts = own.pop("$defs", {})
        for name, schema in {"": own, **parts}.items():
            moved = _with_moved_references(schema, _COMPONENTS + _name(shelf))
            for field, described in moved.get("properties", {}).items():
                described.setdefault("description", f"The field `{field}` of the TOML file")
            schemas[_name(shelf) + name] = moved


def _with_moved_references(part: Any, place: str) -> Any:
    """Return a part of a schema whose references point to components."""
    if isinstance(part, dict):
        return {name: _with_moved_references(value, place) for name, value in part.items()}
    if isinstance(part, list):
        return [_with_moved_references(value, place) for value in part]
    if isinstance(part, str) and part.startswith(_DEFINITIONS):
        return place + part.removeprefix(_DEFINITIONS)
    return part
