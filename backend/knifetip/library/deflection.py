"""deflection: how far a tool gives way, as a board's TOML keeps it.

Deflection -> the lines of its table; the text of a board -> the same with that table in it
"""

from __future__ import annotations

import json
import re

from knifetip.model.board import Deflection


def table(deflection: Deflection) -> str:
    """Return the lines of a deflection in a board's file.

    Examples
    --------
    >>> print(table(Deflection("Router", 0.08, 0.05)), end="")
    [deflection.Router]
    x = 0.0800
    y = 0.0500
    """
    return f"[deflection.{_key(deflection.tool)}]\nx = {deflection.x:.4f}\ny = {deflection.y:.4f}\n"


def stored(text: str, deflection: Deflection) -> str:
    """Return the text of a board's file with this deflection, in place of an earlier one."""
    name = re.escape(deflection.tool)
    quoted = re.escape(json.dumps(deflection.tool, ensure_ascii=False))
    head = re.compile(rf"\[\s*deflection\s*\.\s*(?:{name}|{quoted}|'{name}')\s*\]")
    kept, inside = [], False
    for line in text.splitlines():
        if line.lstrip().startswith("["):
            inside = head.match(line.strip()) is not None
        if not inside:
            kept.append(line)
    return "\n".join(kept).rstrip() + "\n\n" + table(deflection)


def _key(name: str) -> str:
    return name if re.fullmatch(r"[A-Za-z0-9_-]+", name) else json.dumps(name, ensure_ascii=False)
