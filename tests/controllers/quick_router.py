"""The router table with a spindle that starts soon, and that mills greyboard in one pass.

LinuxCNC runs in real time, so tests with it use this machine.
"""

from __future__ import annotations

import tomllib

from knifetip.library import load

NAME = "quick-router"


def _toml() -> str:
    text = load.library_text("machines", "router-table")
    for old, new in (("spin_up = 2.0", "spin_up = 0.2"), ("step = 3.0", "step = 4.0")):
        assert text.count(old) == 1
        text = text.replace(old, new)
    return text


TOML = _toml()
TABLE = load.parse_machine(NAME, tomllib.loads(TOML))
BOARD = load.board("greyboard-3.0")
#: Outputs that lower the stations.
WHEEL, ROUTER = 1, 3
