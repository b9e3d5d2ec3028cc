"""served_machine: find the definition of a machine that is kept on a server."""

from __future__ import annotations

import json
import time
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from typing import Any
from urllib.parse import quote

from knifetip.cli.terminal import print_message
from knifetip.errors import GatewayRefused, JobError, KnifetipError
from knifetip.library import load
from knifetip.messages import Message, from_json
from knifetip.model.machine import Machine


class ServerSilent(JobError):
    """The server of a gateway does not answer, or cannot answer at present."""


#: Time before a machine is loaded again, and between two attempts (s).
_PAUSE = 2.0


def reload_machine(name: str, server: str, headers: Mapping[str, str], kept: Path) -> Machine:
    """Return the newest version of a machine; wait until the server returns one.

    Parameters
    ----------
    name, server, headers, kept
        As for ``start_machine``.

    Raises
    ------
    GatewayRefused
        The server refuses the key.
    """
    while True:
        time.sleep(_PAUSE)
        try:
            return _newest(name, server, headers, kept)
        except GatewayRefused:
            raise
        except KnifetipError as error:
            print_message(error.message)


def start_machine(name: str, server: str, headers: Mapping[str, str], kept: Path) -> Machine:
    """Return the definition of the machine for a gateway that starts.

    If the server does not answer, or refuses the gateway, the definition that was loaded last is
    read from ``kept``.  The gateway can then bring the machine into its safe state at once, for
    example after a power failure during a cut.  The version may be outdated, but the server
    assigns jobs for the newest version only.

    Parameters
    ----------
    name, server, headers
        As for ``find_machine``.
    kept
        File that stores the definition which was last loaded from the server.

    Raises
    ------
    LibraryError, JobError
        As for ``find_machine``, if no definition is kept.
    """
    try:
        return _newest(name, server, headers, kept)
    except (ServerSilent, GatewayRefused) as error:
        found = _read_kept(name, kept)
        if found is None:
            raise
        print_message(error.message)
        print_message(Message("output.used-version", version=found.version))
        return found


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
    ServerSilent
        The server cannot be reached, or cannot answer at present.
    JobError
        The server has no such machine.
    GatewayRefused
        The server refuses the key.
    """
    if _is_local(name):
        return load.machine(name)
    return _machine(name, _fetch(name, server, headers))


def _is_local(name: str) -> bool:
    return name.endswith(".toml") or name in load.names("machines")


def _newest(name: str, server: str, headers: Mapping[str, str], kept: Path) -> Machine:
    """Return a machine as ``find_machine`` does, and keep its definition if it is on the server."""
    if _is_local(name):
        return load.machine(name)
    content = _fetch(name, server, headers)
    machine = _machine(name, content)
    with suppress(OSError):  # a full disk must not keep the gateway from its machine
        kept.parent.mkdir(parents=True, exist_ok=True)
        new = kept.with_name(f"{kept.name}.new")
        new.write_text(json.dumps({"machine": name, **content}), "utf-8")
        new.replace(kept)
    return machine


def _read_kept(name: str, kept: Path) -> Machine | None:
    """Return the machine in a file; None if the file is missing, damaged or of another machine."""
    try:
        content = json.loads(kept.read_text("utf-8"))
        return _machine(name, content) if content["machine"] == name else None
    except (OSError, ValueError, KeyError, TypeError, KnifetipError):
        return None


def _machine(name: str, content: Mapping[str, Any]) -> Machine:
    machine = load.parse_machine(name, content["fields"])
    return replace(machine, version=int(content["version"]))


def _fetch(name: str, server: str, headers: Mapping[str, str]) -> Mapping[str, Any]:
    """Return the JSON of the definition of a machine on a server."""
    import httpx  # imported here: slow, and other commands do not need it

    url = f"{server.rstrip('/')}/api/v1/machines/{quote(name, safe='')}/definition"
    try:
        answer = httpx.get(url, headers={"X-Knifetip": "gateway", **headers}, timeout=30.0)
        content = answer.json()
    except (httpx.HTTPError, httpx.InvalidURL) as reason:
        raise ServerSilent("server.unreachable", server=server, reason=reason) from reason
    except ValueError:
        content = None
    is_object = isinstance(content, dict)
    if answer.is_success and is_object and {"fields", "version"} <= content.keys():
        found: Mapping[str, Any] = content
        return found
    if answer.status_code in (401, 403):
        said = content.get("detail") if is_object else None
        raise GatewayRefused(
            "gateway.access-refused", server=server, reason=said or str(answer.status_code)
        )
    kind = ServerSilent if answer.is_server_error else JobError
    if is_object and "detail" in content:
        raise kind(from_json({"text": content["detail"], **content}))
    raise kind("server.answered", url=url, status=answer.status_code)
