"""Requests to a path with a version are served as those to its alias."""

from __future__ import annotations

import httpx
import pytest

from tests.support.serving.server import square, upload_drawing

pytestmark = pytest.mark.xdist_group("server")


def test_every_route_is_described_under_its_version_and_its_alias(client: httpx.Client) -> None:
    alias = client.get("/api/openapi.json").json()
    versioned = client.get("/api/v1/openapi.json").json()
    routes = [path.removeprefix("/api/") for path in alias["paths"] if path.startswith("/api/")]
    assert len(routes) > 40
    assert [f"/api/v1/{route}" for route in routes] == [
        path for path in versioned["paths"] if path.startswith("/api")
    ]
    assert versioned["components"] == alias["components"]


def test_the_urls_of_an_answer_have_the_prefix_of_the_request(client: httpx.Client) -> None:
    for prefix in ("/api", "/api/v1"):
        ids = [upload_drawing(client, square(side=side))["id"] for side in (101.0, 102.0)]
        first = client.get(f"{prefix}/drawings", params={"limit": 1})
        assert first.json()[0]["id"] == ids[1]
        link = first.headers["link"]
        assert link.startswith(f"<{prefix}/drawings?cursor=")
        assert client.get(link[1 : link.index(">")]).json()[0]["id"] == ids[0]
        made = client.post(f"{prefix}/drawings", files={"file": ("a.dxf", square())})
        assert made.headers["location"] == f"{prefix}/drawings/{made.json()['id']}"
        assert client.get(made.headers["location"]).status_code == 200


@pytest.mark.parametrize(
    ("path", "status"),
    [
        ("/api/v1", 404),
        ("/api/v1/", 404),
        ("/api/v1/nothing", 404),
        ("/api/v2/jobs", 404),
        ("/api/v1jobs", 404),
        ("/api/v1/v1/jobs", 404),
        ("/api/v1/jobs/%2e%2e", 404),
    ],
)
def test_no_other_prefix_is_served(client: httpx.Client, path: str, status: int) -> None:
    answer = client.get(path)
    assert answer.status_code == status
    assert answer.headers["content-type"] == "application/problem+json"


def test_access_control_applies_to_paths_with_a_version(client: httpx.Client) -> None:
    foreign = {"Origin": "https://else.where"}
    assert client.post("/api/v1/jobs", json={}, headers=foreign).status_code == 403
    form = {"Content-Type": "text/plain"}
    assert client.post("/api/v1/jobs", content="{}", headers=form).status_code == 415
