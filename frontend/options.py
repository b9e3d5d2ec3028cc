"""options: writes what the page shows without a form or a line of its own, from the declarations.

knifetip.model.job_options -> src/api/options.gen.ts          options.py
knifetip.model.edge_figures, program_figures, program_facts -> src/api/figures.gen.ts
titles and descriptions of all -> src/language/declared.gen.ts

Options whose value is a number, a choice or a switch are fields of the order form; choices for some
edges (``EdgeChoice``) are fields of the selected edges.  Figures of a verdict are lines with a title
of the catalogue of messages.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any, get_args

from knifetip.messages import Message, render
from knifetip.model.edge_choice import EdgeChoice, LineTypeChoice
from knifetip.model.edge_figures import EDGE_FIGURES
from knifetip.model.job_options import JobOptions
from knifetip.model.program_facts import ProgramFacts
from knifetip.model.program_figures import PROGRAM_FIGURES

#: Options with a plain value and a form of their own: only some machines have the least lift.
OWN_FORM = ("lift",)
SRC = Path(__file__).resolve().parent / "src"
HEADER = "/** Options of a job with plain values, and options of edges. Written by frontend/options.py: do not edit. */\n"
TEXTS_HEADER = "/** English texts of options and facts, from their declarations. Written by frontend/options.py: do not edit. */\n"
FIGURES_HEADER = "/** Figures of a verdict and facts of a program that are lines with a title. Written by frontend/options.py: do not edit. */\n"


def _field(schema: dict[str, Any]) -> dict[str, Any] | None:
    """Return kind, limits and default of an option; None if its value is not plain."""
    default = {"default": schema.get("default")}
    if "enum" in schema:
        return {"kind": "choice", "choices": schema["enum"], **default}
    if schema.get("type") == "boolean":
        return {"kind": "switch", **default}
    if schema.get("type") == "string":
        return {"kind": "text", "maxLength": schema["maxLength"], **default}
    if schema.get("type") in ("number", "integer"):
        return {
            "kind": "number",
            "min": schema.get("minimum", schema.get("exclusiveMinimum")),
            "max": schema["maximum"],
            **default,
        }
    return None


def _plain() -> dict[str, Any]:
    """Return the options with a plain value, by name."""
    properties = JobOptions.model_json_schema()["properties"]
    fields = {
        name: _field(schema)
        for name, schema in properties.items()
        if name not in OWN_FORM
    }
    return {name: field for name, field in fields.items() if field is not None}


def _of_edges() -> dict[str, Any]:
    """Return the line types and the fields of each option of edges, by name."""
    result = {}
    for name, kind in _kinds_of_edges():
        properties = kind.model_json_schema()["properties"]
        result[name] = {
            "types": kind.types,
            "byType": issubclass(kind, LineTypeChoice),
            "ofCutters": kind.of_cutters,
            "help": "help" in _schema_of(name),
            "fields": {
                key: _field_of_edges(properties[key]) for key in _fields_of(kind)
            },
        }
    return result


def _schema_of(name: str) -> dict[str, Any]:
    """Return the schema of an option."""
    found: dict[str, Any] = JobOptions.model_json_schema()["properties"][name]
    return found


def _kinds_of_edges() -> Iterator[tuple[str, type[EdgeChoice]]]:
    """Yield each option of edges with the class of its choices."""
    for name, option in JobOptions.model_fields.items():
        for kind in get_args(option.annotation):
            choice = isinstance(kind, type) and issubclass(kind, EdgeChoice)
            if choice and not kind.own_form:
                yield name, kind


def _fields_of(kind: type[EdgeChoice]) -> list[str]:
    """Return the names of the fields that are chosen."""
    return [
        name for name in kind.model_fields if name not in LineTypeChoice.model_fields
    ]


def _given(schema: dict[str, Any]) -> dict[str, Any]:
    """Return the schema of a field that may be null, if it is given."""
    return next(
        (one for one in schema.get("anyOf", ()) if one.get("type") != "null"), {}
    )


def _field_of_edges(schema: dict[str, Any]) -> dict[str, Any]:
    """Return kind, limits, default and unit of a field of an option of edges."""
    given = _given(schema)
    field = _field({**given, **schema})
    assert field is not None, schema
    whole = (
        {"whole": given.get("type") == "integer"} if field["kind"] == "number" else {}
    )
    return {**field, **whole, "unit": schema.get("unit", "")}


def _texts() -> dict[str, str]:
    """Return the English texts of the options and of their fields and choices, by identifier."""
    found: dict[str, str] = {}
    properties = JobOptions.model_json_schema()["properties"]
    for name in _plain():
        found |= _texts_of(f"option.{name}", properties[name])
        found[f"option.{name}.description"] = _icu(properties[name]["description"])
    for name, kind in _kinds_of_edges():
        found[f"edgeOption.{name}"] = _icu(properties[name]["title"])
        if "help" in properties[name]:
            found[f"edgeOption.{name}.help"] = _icu(properties[name]["help"])
        own = kind.model_json_schema()["properties"]
        for key in _fields_of(kind):
            found |= _texts_of(f"edgeOption.{name}.{key}", own[key])
    for name, fact in ProgramFacts.model_json_schema()["properties"].items():
        found |= _texts_of(f"fact.{name}", fact)
    return found


def _texts_of(identifier: str, schema: dict[str, Any]) -> dict[str, str]:
    """Return the texts of a field: its title, and its choices, which are words."""
    choices = {
        f"{identifier}.{choice}": _icu(choice.replace("-", " ").capitalize())
        for choice in schema.get("enum", ())
    }
    return {identifier: _icu(schema["title"]), **choices}


def _icu(text: str) -> str:
    """Return a text in ICU MessageFormat."""
    return re.sub(r"[{}]+", lambda found: f"'{found[0]}'", text.replace("'", "''"))


def options() -> str:
    """Return the TypeScript source of the options."""
    plain, of_edges = (json.dumps(found, indent=2) for found in (_plain(), _of_edges()))
    return (
        f"{HEADER}\nexport const OPTIONS = {plain} as const;\n"
        f"\nexport const EDGE_OPTIONS = {of_edges} as const;\n"
    )


def texts() -> str:
    """Return the TypeScript source of the English texts of what the backend declares."""
    return f"{TEXTS_HEADER}\nexport const DECLARED_TEXTS = {json.dumps(_texts(), indent=2)} as const;\n"


def figures() -> str:
    """Return the TypeScript source of the figures of a verdict that the page lists by themselves."""
    of_program = {
        name: {"title": _title(one.title), "unit": one.unit}
        for name, one in PROGRAM_FIGURES.items()
    }
    of_edges = {
        name: {"title": _title(one.title)}
        for name, one in EDGE_FIGURES.items()
        if one.title
    }
    listed, edges, facts = (
        json.dumps(found, indent=2) for found in (of_program, of_edges, _facts())
    )
    return (
        f"{FIGURES_HEADER}\nexport const PROGRAM_FIGURES = {listed} as const;\n"
        f"\nexport const EDGE_FIGURES = {edges} as const;\n"
        f"\nexport const PROGRAM_FACTS = {facts} as const;\n"
    )


def _facts() -> dict[str, Any]:
    """Return the units of the facts about a program, and whether lists have them, by name."""
    properties = ProgramFacts.model_json_schema()["properties"]
    return {
        name: {"unit": schema["unit"], "listed": schema.get("listed", False)}
        for name, schema in properties.items()
    }


def _title(code: str) -> dict[str, Any]:
    """Return the message of a title, with its text in English."""
    message = Message(code)
    return {**message.as_json(), "text": render(message)}


def sources() -> dict[str, str]:
    """Return the sources of all generated files by their paths in ``src``."""
    return {
        "api/options.gen.ts": options(),
        "api/figures.gen.ts": figures(),
        "language/declared.gen.ts": texts(),
    }


if __name__ == "__main__":
    for name, source in sources().items():
        target = SRC / name
        if not target.is_file() or target.read_text(encoding="utf-8") != source:
            target.write_text(source, encoding="utf-8")
