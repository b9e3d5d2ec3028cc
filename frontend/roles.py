"""roles: writes which scopes each request needs, from the routes of the API.

knifetip.service -> src/api/roles.gen.ts          roles.py

The page disables what the server would refuse, by the same declarations (ADR 83, 103).
"""

from __future__ import annotations

import json
from pathlib import Path

from knifetip.server.app import create_app
from knifetip.service.http.api_version import versioned_path
from knifetip.service.http.routing import scoped_operations
from knifetip.service.http.scopes import least_role

TARGET = Path(__file__).resolve().parent / "src" / "api" / "roles.gen.ts"
HEADER = "/** Scopes of which each request needs one. Written by frontend/roles.py: do not edit. */\n"


def roles() -> str:
    """Return the TypeScript source of the scopes of all requests that a person may send."""
    lines = []
    for one in sorted(
        scoped_operations(create_app().routes), key=lambda one: (one.method, one.path)
    ):
        if any(least_role(scope) for scope in one.needed):
            scopes = ", ".join(json.dumps(scope.value) for scope in one.needed)
            lines.append(f'  "{one.method} {versioned_path(one.path)}": [{scopes}],')
    table = "\n".join(lines)
    return f"{HEADER}\nexport const SCOPES_FOR = {{\n{table}\n}} as const;\n"


if __name__ == "__main__":
    TARGET.write_text(roles(), encoding="utf-8")
