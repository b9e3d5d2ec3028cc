"""Examples of requests and answers in the REST description, made from the schemas.

A value is taken from the schema (its default or its first permitted value), or from the tables
below by the name of the field.  The tests validate every example against its schema.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Final

from knifetip.messages import Message, with_text

EXAMPLE_ID: Final = "5p256sc8xs7q"
EXAMPLE_TIME: Final = "2030-01-02T03:04:05.123Z"
_ID: Final = EXAMPLE_ID
_TIME: Final = EXAMPLE_TIME
_HASH: Final = "9f86d081884c7d659a2feaa0c55ad015a3bf4f1b2b0b822cd15d6c15b0f00a08"
_TOML: Final = 'title = "Demo table"\n'
_TEXTS: Final[Mapping[str, str]] = {
    "id": _ID, "job": _ID, "drawing": _ID, "machine": "demo-table", "board": "e-flute",
    "profile": "default", "external_id": "PO-4711", "customer": "Carton Works",
    "notes": "Two samples for the customer", "sha256": _HASH, "program_sha256": _HASH,
    "by": "Ada", "who": "Ada", "principal": "Ada", "reason": "The customer accepts it",
    "title": "ERP", "name": "tray.dxf", "drawing_name": "tray.dxf", "layer": "CUT",
    "handle": "2A", "url": "https://erp.example/hooks/knifetip", "version": "1.2.0",
    "kind": "LINE", "linetype": "CONTINUOUS", "zone": "Europe/Berlin", "toml": _TOML,
    "content": "MAo=", "password": "four words are long", "current": "four words are long",
    "new": "five words are even longer", "why": "The job was released.", "peer": "192.0.2.7",
    "description": "Orders of the ERP",
}  # fmt: skip
_NAMES: Final[Mapping[str, str]] = {
    "machines": "demo-table", "boards": "e-flute", "tools": "v-cutter-45", "profiles": "default",
    "users": "ada",
}  # fmt: skip
_BODIES: Final[Mapping[str, Any]] = {
    "JobIn": {
        "drawing": _ID, "machine": "demo-table", "board": "e-flute", "copies": 2,
        "external_id": "PO-4711", "due": _TIME,
    },
    "OrderIn": {
        "drawing": _ID, "machine": "demo-table", "board": "e-flute", "external_id": "PO-4711",
    },
    "EdgesPatch": {"overrides": [{"type": "crease", "edges": [0, 1]}]},
    "DrawingPatch": {"external_id": "PO-4711", "notes": "Two samples"},
    "JobPatch": {"external_id": "PO-4711", "priority": 10},
    "ConfirmIn": {
        "checked": ["board", "sheet", "station-1", "table-clear", "hands-clear"],
        "by": "Ada",
    },
    "UserIn": {"name": "ada", "password": "four words are long", "role": "operator"},
    "MoveIn": {"next": _ID, "by": "Ada"},
    "KeyIn": {"title": "ERP", "scopes": ["designer"]},
}  # fmt: skip


class Examples:
    """Makes examples from the schemas of a description.

    Parameters
    ----------
    schemas
        Schemas by name.
    """

    def __init__(self, schemas: Mapping[str, Mapping[str, Any]]) -> None:
        self._schemas = schemas

    def request_body(self, schema: Mapping[str, Any]) -> Any:
        """Return an example of the body of a request, with its required fields."""
        name = schema.get("$ref", "").rpartition("/")[2]
        return _BODIES[name] if name in _BODIES else self._value(schema, "", whole=False)

    def of_answer(self, schema: Mapping[str, Any]) -> Any:
        """Return an example of an answer, with all fields."""
        return self._value(schema, "", whole=True)

    def _value(self, schema: Mapping[str, Any], name: str, *, whole: bool) -> Any:
        referred = schema.get("$ref", "").rpartition("/")[2]
        if referred in _BODIES and not whole:
            return _BODIES[referred]
        if referred:
            return self._value(self._schemas[referred], name, whole=whole)
        if "const" in schema:
            return schema["const"]
        if schema.get("enum"):
            return schema["enum"][0]
        for key in ("anyOf", "oneOf"):
            if key in schema:
                return self._value(schema[key][0], name, whole=whole)
        kind = schema.get("type")
        if isinstance(kind, list):
            kind = kind[0]
        match kind:
            case "object":
                return self._object(schema, whole=whole)
            case "array":
                return self._array(schema, name, whole=whole)
            case "string":
                return _text(schema, name)
            case "integer" | "number":
                return _number(schema, kind)
            case "boolean":
                return bool(schema.get("default", True))
            case "null":
                return None
            case _:
                return {}

    def _object(self, schema: Mapping[str, Any], *, whole: bool) -> dict[str, Any]:
        properties = schema.get("properties", {})
        chosen = properties if whole else schema.get("required", ())
        made = {one: self._value(properties[one], one, whole=whole) for one in chosen}
        if {"code", "arguments", "text", "hint"} <= set(properties):
            message = with_text(Message("job.unknown", job=_ID))
            made |= {key: message[key] for key in ("code", "arguments", "text", "hint")}
        return made

    def _array(self, schema: Mapping[str, Any], name: str, *, whole: bool) -> list[Any]:
        if "prefixItems" in schema:
            return [self._value(one, name, whole=whole) for one in schema["prefixItems"]]
        count = max(1, schema.get("minItems", 1))
        return [self._value(schema.get("items", {}), name, whole=whole)] * count


def _text(schema: Mapping[str, Any], name: str) -> str:
    if schema.get("format") == "date-time":
        return _TIME
    text = schema.get("default") or _TEXTS.get(name) or "text"
    return str(text)[: schema.get("maxLength", 1000)]


def _number(schema: Mapping[str, Any], kind: str) -> float:
    least = schema.get("minimum", schema.get("exclusiveMinimum", 0))
    if isinstance(schema.get("default"), int | float):
        number: float = schema["default"]
        return number
    if kind == "integer":
        return int(max(least, 1))
    most = schema.get("maximum", schema.get("exclusiveMaximum", least + 25))
    return float(least + (most - least) / 2) if most < least + 25 else float(least + 12.5)


def sample_arguments(kinds: Mapping[str, str]) -> dict[str, Any]:
    """Return arguments of a message for an example.

    Parameters
    ----------
    kinds
        Types of the arguments by name, from ``messages.codes``.
    """
    inner = Message("job.unknown", job=_ID)
    samples: dict[str, Any] = {
        "count": 3,
        "number": 12.5,
        "edge": 12,
        "edges": [12, 13],
        "x": 120.0,
        "y": 80.0,
        "texts": ["demo-table"],
        "message": inner,
        "message?": inner,
        "messages": [inner],
    }
    return {
        name: _TEXTS.get(name, "text") if kind == "text" else samples[kind]
        for name, kind in kinds.items()
    }


def name_in(path: str) -> str | None:
    """Return a name for an example of a path with ``{name}``, None if it has none."""
    return next((name for kind, name in _NAMES.items() if f"/{kind}/{{name}}" in path), None)
