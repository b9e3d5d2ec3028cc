"""schema: generate the JSON Schema (draft 2020-12) of the TOML files of the library.

Editors and the forms of the page use the schema to complete and check the files.  The settings of
a machine's controller depend on its language: they are conditions of the schema (``if``, ``then``).
"""

from __future__ import annotations

import inspect
import re
from typing import Any, Final

from knifetip.fields import Table
from knifetip.languages.registry import find_language, language_names
from knifetip.library.board_file import BoardFile
from knifetip.library.machine_file import MachineFile, ToolFile
from knifetip.library.profile_file import ProfileFile
from knifetip.model.tool import KINDS, Tool

FILES: Final[dict[str, type[Table]]] = {
    "machine": MachineFile,
    "board": BoardFile,
    "tool": ToolFile,
    "profile": ProfileFile,
}

#: A field with its comment, on the same line or on the line before.
_SAME_LINE: Final = re.compile(r"^    (\w+): [^#\n]*#: (.+)$", re.MULTILINE)
_LINE_BEFORE: Final = re.compile(r"^    #: (.+)\n    (\w+): ", re.MULTILINE)


def json_schema(file: str) -> dict[str, Any]:
    """Return the JSON Schema of the kind of TOML file ``file``: a key of ``FILES``."""
    schema = FILES[file].model_json_schema()
    for kind in KINDS:
        table = schema.get("$defs", {}).get(f"{kind.tool.__name__}Table", {"properties": {}})
        for name, text in _comments(kind.tool).items():
            if name in table["properties"]:
                table["properties"][name]["description"] = text
    if file == "machine":
        _add_languages(schema)
    return {"$schema": "https://json-schema.org/draft/2020-12/schema"} | schema


def _add_languages(schema: dict[str, Any]) -> None:
    """Add the names of the controller languages, and the settings of each.

    Parameters
    ----------
    schema
        The schema of machines, which is changed in place.
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
                ref_template="#/$defs/{model}"
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
    return {name: text for text, name in _LINE_BEFORE.findall(source)} | same_line
