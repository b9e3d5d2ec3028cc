"""field_tables: write the pages with the settings of the processes and the fields of machine files.

    python backend/field_tables.py    writes docs/settings.md and docs/machine-files.md

Both are made from the declarations of the fields, so a new one needs no line there; a test compares
the pages with the declarations.
"""

from __future__ import annotations

from collections.abc import Iterator
from enum import Enum
from pathlib import Path
from typing import Any

from knifetip.library.schema import json_schema
from knifetip.model.tool import KINDS
from knifetip.service.settings import PREFIX, FileOnly, FormerName, Settings, WorkerSettings

DOCS = Path(__file__).resolve().parent / "docs"

_SETTINGS = """# Settings

`make tables` writes this page from `knifetip/service/settings.py`; a test compares them.

A setting is an option of the command line (`--max-rate 50`), a variable of the environment
(`KNIFETIP_MAX_RATE=50`) or a line of a TOML file (`max_rate = 50`) that `--settings FILE` or
`KNIFETIP_SETTINGS` names. The command line precedes the environment, which precedes the file.
Variables with several values have spaces between them. Server and workers may have the same file;
each reads its own settings and skips those of the other. Settings with * are no options of the
command line, so that `--help` stays short.
"""

_MACHINES = """# Files of machines, boards and tools

`make tables` writes this page from the declarations of the fields; a test compares them.
`knifetip schema machine` prints the JSON Schema, from which the page makes its forms. Fields
without a default are required.
"""


def settings_page() -> str:
    """Return the page of the settings of the server and of the workers."""
    return "\n".join(
        [
            _SETTINGS,
            "## `knifetip serve`\n",
            *_setting_rows(Settings, Settings.model_fields.keys()),
            "\n## `knifetip worker`\n",
            "The worker has these settings of the server: "
            + ", ".join(f"`{name}`" for name in WorkerSettings.model_fields if name in _SHARED)
            + ". Its own:\n",
            *_setting_rows(WorkerSettings, WorkerSettings.model_fields.keys() - _SHARED),
            "",
        ]
    )


_SHARED = (Settings.model_fields.keys() & WorkerSettings.model_fields.keys()) - {"processes"}


def _setting_rows(kind: Any, names: Any) -> Iterator[str]:
    yield "| setting | variable | default | limits | meaning |"
    yield "|---|---|---|---|---|"
    for name, field in kind.model_fields.items():
        if name not in names:
            continue
        former = [one.name for one in field.metadata if isinstance(one, FormerName)]
        mark = "*" if any(isinstance(one, FileOnly) for one in field.metadata) else ""
        variables = ", ".join(f"`{PREFIX}{one.upper()}`" for one in (name, *former))
        default = field.default.value if isinstance(field.default, Enum) else field.default
        shown = "" if default in (None, "", ()) or isinstance(default, Path) else f"`{default}`"
        shown = shown.lower() if isinstance(default, bool) else shown
        limits = {
            key: getattr(one, key)
            for one in field.metadata
            for key in ("ge", "gt", "le")
            if hasattr(one, key)
        }
        least = limits.get("ge", limits.get("gt"))
        between = "" if least is None else f"{least} to {limits['le']}"
        yield f"| `{name}`{mark} | {variables} | {shown} | {between} | {field.description} |"


def machine_page() -> str:
    """Return the page of the fields of machine, board and tool files."""
    machine, board = json_schema("machine"), json_schema("board")
    kinds = {f"{kind.tool.__name__}Table": kind.name for kind in KINDS}
    lines = [_MACHINES]
    for title, schema in (("Machine", machine), ("Board", board)):
        lines += [f"## {title}\n", *_field_rows(schema), ""]
        for name, table in schema["$defs"].items():
            if "properties" in table:
                shown = f"Tool: {kinds[name]}" if name in kinds else _table_title(name)
                lines += [f"### {shown}\n", *_field_rows(table), ""]
    return "\n".join(lines)


def _table_title(name: str) -> str:
    return f"Table {name.removesuffix('Table').lower()}"


def _field_rows(table: dict[str, Any]) -> Iterator[str]:
    yield "| key | title | value | default | meaning |"
    yield "|---|---|---|---|---|"
    for name, field in table["properties"].items():
        default = field.get("default")
        shown = "" if default in (None, "", [], {}) else f"`{default}`"
        text = str(field.get("description", "")).split("\n")[0]
        yield f"| `{name}` | {field.get('title', '')} | {_value(field)} | {shown} | {text} |"


def _value(field: dict[str, Any]) -> str:
    """Return which values a field may have, in few words."""
    if "const" in field:
        return f"`{field['const']}`"
    if "enum" in field:
        return ", ".join(f"`{one}`" for one in field["enum"])
    if "$ref" in field:
        return "table"
    if "oneOf" in field:
        return "name or table" if "discriminator" not in field else "table of a tool"
    limits = [
        f"{sign} {field[key]:g}"
        for key, sign in (
            ("minimum", "≥"),
            ("exclusiveMinimum", ">"),
            ("maximum", "≤"),
            ("exclusiveMaximum", "<"),
        )
        if key in field
    ]
    kind = {"string": "text", "object": "table", "array": "list", "boolean": "true, false"}
    return " ".join(
        [kind.get(field.get("type", ""), field.get("type", "")), ", ".join(limits)]
    ).strip()


def pages() -> dict[Path, str]:
    """Return the text of each page by its path."""
    return {DOCS / "settings.md": settings_page(), DOCS / "machine-files.md": machine_page()}


if __name__ == "__main__":
    for path, text in pages().items():
        path.write_text(text, encoding="utf-8")
