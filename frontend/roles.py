"""roles: writes which role the page's user needs for each request, from the routes of the API.

knifetip.api -> src/api/roles.gen.ts          roles.py

The page disables what the server would refuse, by the same declarations (ADR 83).
"""

from __future__ import annotations

import json
from pathlib import Path

from knifetip.api.api_version import versioned_path
from knifetip.api.app import create_app
from knifetip.api.routing import scoped_operations
from knifetip.jobs.accounts.scopes import ROLES

TARGET = Path(__file__).resolve().parent / "src" / "api" / "roles.gen.ts"
HEADER = (
    "/** Least role for each request. Written by frontend/roles.py: do not edit. */\n"
)


def roles() -> str:
    """Return the TypeScript source of the roles of all requests that need one."""
    needed = {
        f"{one.method} {versioned_path(one.path)}": next(
            role.value for role in ROLES if role in one.needed
        )
        for one in scoped_operations(create_app().routes)
        if not set(one.needed).isdisjoint(ROLES)
    }
    table = json.dumps(dict(sorted(needed.items())), indent=2)
    return f"{HEADER}\nexport const ROLE_FOR = {table} as const;\n"


if __name__ == "__main__":
    TARGET.write_text(roles(), encoding="utf-8")
