"""All answers have the security headers: of every route, errors, downloads and the page."""

from __future__ import annotations

import re
from collections.abc import Iterator

import httpx
import pytest
from fastapi import FastAPI

from knifetip.service.http.headers import DEFAULTS
from knifetip.service.http.routing import scoped_operations
from tests.support.serving.server import LocalClient, order_job, square, upload_drawing

pytestmark = pytest.mark.xdist_group("server")


def check(answer: httpx.Response) -> None:
    """Check the headers that keep a browser from framing, sniffing or executing an answer."""
    shown = f"{answer.request.method} {answer.request.url} {answer.status_code}"
    headers = answer.headers
    assert headers["X-Content-Type-Options"] == "nosniff", shown
    assert headers["X-Frame-Options"] in ("DENY", "SAMEORIGIN"), shown
    policy = headers["Content-Security-Policy"]
    assert "default-src 'none'" in policy or "default-src 'self'" in policy, shown
    assert "frame-ancestors" in policy, shown
    assert "unsafe-eval" not in policy, shown
    assert "script-src *" not in policy, shown
    assert headers["Referrer-Policy"] in ("same-origin", "no-referrer"), shown
    assert headers["X-Request-ID"], shown
    disposition = headers.get("Content-Disposition")
    if disposition is not None:
        # A ticket is shown by the browser, to be printed.
        kind = "inline" if headers["Content-Type"] == "application/pdf" else "attachment"
        assert re.fullmatch(kind + r'; filename="[A-Za-z0-9._-]+"', disposition), shown


def operations(app: FastAPI) -> Iterator[tuple[str, str]]:
    for operation in scoped_operations(app.routes):
        if operation.path != "/api/events":  # has no end
            yield operation.method, operation.path


def test_every_route_answers_with_the_security_headers(client: LocalClient) -> None:
    drawing = upload_drawing(client, square())["id"]
    job = order_job(client, drawing)["id"]
    found = 0
    for method, path in operations(client.app):
        if method == "DELETE" or path.startswith("/api/gateway"):
            continue  # they would change what the other routes answer
        owner = job if path.startswith("/api/jobs") else drawing
        url = re.sub(r"\{[^}]+\}", "none", path.replace("{id}", owner))
        check(client.request(method, url))
        found += 1
    assert found > 50


def test_errors_and_the_page_have_the_security_headers(client: LocalClient) -> None:
    for answer in (
        client.get("/"),
        client.get("/jobs"),
        client.get("/assets/main-4f2a.js"),
        client.get("/assets/none.js"),
        client.get("/api/none"),
        client.delete("/api/jobs"),
        client.request("BREW", "/api/jobs"),
        client.get("/api/jobs", headers={"Host": "evil.example"}),
        client.post("/api/jobs", content=b"{", headers={"Content-Type": "application/json"}),
        client.post("/api/jobs", content=b"a=b", headers={"Content-Type": "text/plain"}),
        client.get("/api/openapi.json"),
        client.get("/api/v1/openapi.json"),
        client.get("/docs"),
        client.get("/api/docs"),
        client.get("/metrics"),
        client.get("/healthz"),
        client.get("/readyz"),
    ):
        check(answer)


def test_the_defaults_forbid_everything() -> None:
    assert DEFAULTS["Content-Security-Policy"].startswith("default-src 'none'")
