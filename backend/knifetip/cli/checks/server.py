"""Checks of a running server: reachable, ready, of this version, and with a valid key."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from importlib.metadata import version
from typing import Any

from knifetip.cli.checks.check_result import CheckResult, ok, problem, warning

_PATIENCE = 10.0  # seconds


def check_server(url: str, headers: Mapping[str, str]) -> Iterator[CheckResult]:
    """Check the server with a URL, with the headers that contain its key."""
    import httpx  # slow to import

    try:
        with httpx.Client(base_url=url, headers=dict(headers), timeout=_PATIENCE) as client:
            health = client.get("/healthz")
            if not health.is_success:
                text = f"{url} answers {health.status_code} at /healthz"
                yield problem("server", text, "Check the URL, and the proxy before the server.")
                return
            yield ok("server", f"{url} answers")
            yield _version(_body(health).get("version"))
            yield _ready(client.get("/readyz"))
            yield _key(client.get("/api/v1/service"), bool(headers))
    except (httpx.HTTPError, httpx.InvalidURL) as reason:
        advice = "Start the server with knifetip serve; check the URL and the network."
        yield problem("server", f"{url} cannot be reached: {reason}", advice)


def _body(answer: Any) -> dict[str, Any]:
    try:
        body = answer.json()
    except ValueError:
        return {}
    return body if isinstance(body, dict) else {}


def _version(theirs: object) -> CheckResult:
    ours = version("knifetip")
    if theirs == ours:
        return ok("version", f"{ours}, as here")
    text = f"the server has version {theirs}, this is {ours}"
    return warning("version", text, "Install the same version on all computers.")


def _ready(answer: Any) -> CheckResult:
    if answer.is_success:
        return ok("readiness", "the server is ready")
    checks = _body(answer).get("checks")
    faults = checks if isinstance(checks, dict) else {}
    text = ", ".join(f"{name}: {fault}" for name, fault in faults.items() if fault != "ok")
    advice = "Mend it at the server; run knifetip doctor there."
    return problem("readiness", f"the server is not ready: {text or answer.status_code}", advice)


def _key(answer: Any, given: bool) -> CheckResult:
    if answer.is_success:
        return ok("key", "the server accepts the key" if given else "no key is necessary here")
    if answer.status_code in (401, 403):
        text = "the server refuses the key" if given else "the server requires a key"
        create = "knifetip key create TITLE --scope viewer --file FILE"
        return problem("key", text, f"Create one at the server: {create}; give --key-file FILE.")
    return problem("key", f"the server answers {answer.status_code}", "Read the log of the server.")
