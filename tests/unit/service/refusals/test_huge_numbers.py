"""Whole numbers that no column of a database holds are refused, not an internal error."""

from __future__ import annotations

import tomllib
from typing import Any

import httpx
import pytest

from tests.support.serving.server import square

pytestmark = pytest.mark.xdist_group("server")

HUGE = 10**30

REPORT = {"gateway": "g", "machine": "demo-table", "connected": True}
RULE = {"type": "cut", "colour": [HUGE]}


@pytest.mark.parametrize(
    ("method", "path", "body"),
    [
        ("POST", "/api/gateway/station", {**REPORT, "override": HUGE}),
        ("POST", "/api/gateway/station", {**REPORT, "spindle": HUGE}),
        ("POST", "/api/gateway/station", {**REPORT, "outputs": [HUGE]}),
        ("POST", "/api/jobs/x/confirm", {"checked": [], "changed": [HUGE]}),
        ("PUT", f"/api/machines/demo-table/tools/{HUGE}/life", {"life": 1.0}),
        ("POST", f"/api/machines/demo-table/tools/{HUGE}/changed", {}),
        ("PUT", "/api/profiles/huge", {"title": "Huge", "rules": [RULE]}),
        ("GET", f"/api/jobs?limit={HUGE}", None),
        ("GET", f"/api/drawings?limit={HUGE}", None),
    ],
)
def test_a_huge_number_is_refused(
    client: httpx.Client, method: str, path: str, body: dict[str, Any] | None
) -> None:
    answer = client.request(method, path, json=body)
    assert 400 <= answer.status_code < 500, answer.text


@pytest.mark.parametrize("override", [{"colour": HUGE}, {"edges": [HUGE]}])
def test_edges_are_not_selected_by_a_huge_number(
    client: httpx.Client, override: dict[str, Any]
) -> None:
    files = {"file": ("square.dxf", square())}
    drawing = client.post("/api/drawings", files=files, data={"unit": "mm"}).json()["id"]
    body = {"overrides": [{**override, "type": "cut"}]}
    answer = client.patch(f"/api/drawings/{drawing}/edges", json=body)
    assert answer.status_code < 500, answer.text


@pytest.mark.parametrize("name", ["output", "carriage"])
def test_a_machine_file_with_a_huge_number_is_refused(client: httpx.Client, name: str) -> None:
    toml = client.get("/api/machines/demo-table/toml").text
    machine = tomllib.loads(toml)
    machine["station"][0][name] = HUGE
    answer = client.put("/api/machines/huge", json=machine)
    assert 400 <= answer.status_code < 500, answer.text
