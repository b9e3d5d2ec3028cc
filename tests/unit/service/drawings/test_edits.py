"""Edits of the geometry over REST: they give revisions, and jobs are made with them."""

from __future__ import annotations

from typing import Any

import httpx
import pytest

from tests.support.serving.server import order_job, square, upload_drawing, wait_for_state

pytestmark = pytest.mark.xdist_group("server")

LINE = {"kind": "line", "start": [10, 50], "end": [90, 50], "type": "crease"}
CIRCLE = {"kind": "circle", "centre": [50, 20], "radius": 5, "type": "cut"}


def edit(client: httpx.Client, id: str, *edits: dict[str, Any]) -> httpx.Response:
    return client.patch(f"/api/drawings/{id}", json={"edits": list(edits)})


def types(client: httpx.Client, id: str) -> list[str]:
    return [edge["type"] for edge in client.get(f"/api/drawings/{id}/edges").json()["edges"]]


def test_edits_give_a_revision_and_are_undone_by_the_list_before(client: httpx.Client) -> None:
    id = upload_drawing(client, square())["id"]
    edited = edit(client, id, LINE, CIRCLE).json()
    assert (edited["revision"], edited["segments"], len(edited["edits"])) == (2, 7, 2)
    assert types(client, id) == ["cut"] * 4 + ["crease", "cut", "cut"]
    assert edited["questions"] == []
    rows = client.get(f"/api/drawings/{id}/import-report").json()["rows"]
    assert rows[-1]["reason"]["code"] == "import.added-by-hand"

    undone = edit(client, id, LINE).json()
    assert (undone["revision"], undone["segments"]) == (3, 5)
    assert types(client, id)[4:] == ["crease"]


def test_line_types_set_by_hand_survive_an_edit(client: httpx.Client) -> None:
    id = upload_drawing(client, square())["id"]
    override = {"overrides": [{"type": "perforation", "edges": [1]}]}
    assert client.patch(f"/api/drawings/{id}/edges", json=override).status_code == 200
    edit(client, id, LINE)
    retyped = {"overrides": [{"type": "half-cut", "edges": [4]}]}
    assert client.patch(f"/api/drawings/{id}/edges", json=retyped).status_code == 200
    edit(client, id, LINE, CIRCLE)
    assert types(client, id) == ["cut", "perforation", "cut", "cut", "half-cut", "cut", "cut"]


def test_a_job_makes_the_edited_lines(client: httpx.Client) -> None:
    id = upload_drawing(client, square())["id"]
    edit(client, id, LINE)
    job = order_job(client, id, machine="demo-table")["id"]
    made = wait_for_state(client, job, "ready")
    assert made["verdict"]["accepted"]
    assert [tool["kind"] for tool in made["tools"]] == ["knife", "crease-wheel"]
    lengths = {
        row["type"]: row["length"] for row in client.get(f"/api/drawings/{id}").json()["counts"]
    }
    assert lengths == {"cut": 400.0, "crease": 80.0}


def test_edits_that_are_not_possible_are_refused_and_change_nothing(client: httpx.Client) -> None:
    id = upload_drawing(client, square())["id"]
    nothing = {"kind": "line", "start": [1, 1], "end": [1, 1], "type": "cut"}
    refused = edit(client, id, nothing)
    assert refused.status_code == 422
    assert "no length" in refused.json()["detail"]
    assert client.get(f"/api/drawings/{id}").json()["revision"] == 1
    assert edit(client, id, {"kind": "line", "start": [1], "end": [2, 2]}).status_code == 422
    assert edit(client, id, *[LINE] * 501).status_code == 422


def test_the_unit_of_an_edited_drawing_stays(client: httpx.Client) -> None:
    id = upload_drawing(client, square())["id"]
    edit(client, id, LINE)
    refused = client.patch(f"/api/drawings/{id}", json={"unit": "in"})
    assert refused.status_code == 409
    assert client.patch(f"/api/drawings/{id}", json={"unit": "in", "edits": []}).status_code == 200
