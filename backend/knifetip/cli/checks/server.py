"""Checks of a running server: reachable, ready, of this version, and with a valid key."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from importlib.metadata import version
from typing import Any

from knifetip.cli.checks.check_result import CheckResult, ok, problem, warning
from knifetip.messages import Message

_PATIENCE = 10.0  # seconds


def check_server(url: str, headers: Mapping[str, str]) -> Iterator[CheckResult]:
    """Check the server with a URL, with the headers that contain its key."""
    import httpx  # slow to import

    try:
        with httpx.Client(base_url=url, headers=dict(headers), timeout=_PATIENCE) as client:
            health = client.get("/healthz")
            if not health.is_success:
                status = health.status_code
                yield problem("server", Message("doctor.server-unhealthy", url=url, status=status))
                return
            yield ok("server", Message("doctor.server", url=url))
            yield _check_version(_body(health).get("version"))
            yield _check_readiness(client.get("/readyz"))
            yield _check_key(client.get("/api/v1/service"), bool(headers))
    except (httpx.HTTPError, httpx.InvalidURL) as reason:
        yield problem("server", Message("doctor.server-unreachable", url=url, reason=str(reason)))


def _body(answer: Any) -> dict[str, Any]:
    try:
        body = answer.json()
    except ValueError:
        return {}
    return body if isinstance(body, dict) else {}


def _check_version(theirs: object) -> CheckResult:
    ours = version("knifetip")
    if theirs == ours:
        return ok("version", Message("doctor.version", version=ours))
    return warning("version", Message("doctor.version-differs", theirs=str(theirs), ours=ours))


def _check_readiness(answer: Any) -> CheckResult:
    if answer.is_success:
        return ok("readiness", Message("doctor.ready"))
    checks = _body(answer).get("checks")
    faults = checks if isinstance(checks, dict) else {}
    text = ", ".join(f"{name}: {fault}" for name, fault in faults.items() if fault != "ok")
    cause = text or str(answer.status_code)
    return problem("readiness", Message("doctor.not-ready", reason=cause))


def _check_key(answer: Any, given: bool) -> CheckResult:
    if answer.is_success:
        return ok("key", Message("doctor.key" if given else "doctor.key-unneeded"))
    if answer.status_code in (401, 403):
        return problem("key", Message("doctor.key-refused" if given else "doctor.key-required"))
    return problem("key", Message("doctor.key-unchecked", status=answer.status_code))
