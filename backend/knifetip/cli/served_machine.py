"""served_machine: find the definition of a machine that is kept on a server."""

from __future__ import annotations

import time
from collections.abc import Mapping
from dataclasses import replace
from urllib.parse import quote

from knifetip.cli.terminal import print_stderr
from knifetip.errors import JobError, KnifetipError
from knifetip.library import load
from knifetip.messages import from_json
from knifetip.model.machine import Machine

#: Time before a machine is loaded again, and between two attempts (s).
_PAUSE = 2.0


def reload_machine(name: str, server: str, headers: Mapping[str, str]) -> Machine:
    """Return the newest version of a machine; wait until the server returns one.

    Parameters
    ----------
    name, server, headers
        As for ``find_machine``.
    """
    while True:
        time.sleep(_PAUSE)
        try:
            return find_machine(name, server, headers)
        except KnifetipError as error:
            print_stderr(str(error))


def find_machine(name: str, server: str, headers: Mapping[str, str]) -> Machine:
    """Return a machine from the library, from a TOML file, or from a server.

    Parameters
    ----------
    name
        Name of a machine of the library or of the server, or the path of a TOML file.
    server
        URL of the server that is asked for a name that the library does not have.
    headers
        Headers of the request, for example an access key.

    Raises
    ------
    LibraryError
        The TOML file or the definition on the server is invalid.
    JobError
        The server cannot be reached, or has no such machine.
    """
    if name.endswith(".toml") or name in load.names("machines"):
        return load.machine(name)
    import httpx  # imported here: slow, and other commands do not need it

    url = f"{server.rstrip('/')}/api/v1/machines/{quote(name, safe='')}/definition"
    try:
        answer = httpx.get(url, headers={"X-Knifetip": "gateway", **headers}, timeout=30.0)
        content = answer.json()
        if answer.is_success:
            machine = load.parse_machine(name, content["fields"])
            return replace(machine, version=int(content["version"]))
    except (httpx.HTTPError, httpx.InvalidURL) as reason:
        raise JobError("server.unreachable", server=server, reason=reason) from reason
    except (ValueError, KeyError, TypeError):
        content = None
    if isinstance(content, dict) and "detail" in content:
        raise JobError(from_json({"text": content["detail"], **content}))
    raise JobError("server.answered", url=url, status=answer.status_code)
