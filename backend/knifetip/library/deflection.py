"""deflection: write the greatest deflection of a tool into the TOML text of a board's file."""

from __future__ import annotations

import re

from knifetip.library.toml_text import key_text, quote
from knifetip.model.board import Deflection


def deflection_toml(deflection: Deflection) -> str:
    """Return the TOML table with the greatest deflection of one tool in X and Y (mm).

    Examples
    --------
    >>> print(deflection_toml(Deflection("Router", 0.08, 0.05)), end="")
    [deflection.Router]
    x = 0.0800
    y = 0.0500
    """
    tool = key_text(deflection.tool)
    return f"[deflection.{tool}]\nx = {deflection.x:.4f}\ny = {deflection.y:.4f}\n"


def replace_deflection(text: str, deflection: Deflection) -> str:
    """Return the TOML text of a board with the deflection of one tool added or replaced.

    ``text`` is the TOML text of the board; ``deflection`` contains the name of the tool and its
    greatest deflection in X and Y (mm).
    """
    name = re.escape(deflection.tool)
    in_quotes = re.escape(quote(deflection.tool))
    head = re.compile(rf"\[\s*deflection\s*\.\s*(?:{name}|{in_quotes}|'{name}')\s*\]")
    kept_lines, in_table = [], False
    for line in text.splitlines():
        if line.lstrip().startswith("["):
            in_table = head.match(line.strip()) is not None
        if not in_table:
            kept_lines.append(line)
    return "\n".join(kept_lines).rstrip() + "\n\n" + deflection_toml(deflection)
