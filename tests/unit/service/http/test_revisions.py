"""The revision of a drawing: changes and orders refer to the revision that the client has seen."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Any

import httpx
import numpy as np
import pytest

from knifetip.model.dieline import LineType
from knifetip.model.interpretation import NO_OVERRIDE
from knifetip.service.database.tables import Drawing
from knifetip.service.http import revisions
from knifetip.service.processes import tasks
from tests.support.messages import stored
from tests.support.serving.server import (
    LocalClient,
    order_job,
    square,
    upload_drawing,
    wait_for_state,
)

pytestmark = pytest.mark.xdist_group("server")

CREASE = {"overrides": [{"type": "crease", "edges": [0]}]}
CUT = {"overrides": [{"type": "cut", "edges": [0]}]}


def assert_stale(answer: httpx.Response, revision: int) -> None:
    """Assert that a request was refused because the drawing has the newer ``revision``."""
    assert answer.status_code == 412, answer.text
    said = answer.json()
    assert said["type"] == "urn:knifetip:problem:stale-revision"
    assert said["revision"] == revision
    assert said["hint"]


def test_a_drawing_has_a_revision_that_counts_its_changes(client: httpx.Client) -> None:
    upload = client.post("/api/drawings", files={"file": ("a.dxf", square())})
    path = upload.headers["location"]
    assert upload.headers["etag"] == '"1"'
    assert upload.json()["revision"] == 1
    for path_of in (path, f"{path}/edges", f"{path}/edges?format=columns"):
        assert client.get(path_of).headers["etag"] == '"1"'
    changed = client.patch(f"{path}/edges", json=CREASE)
    assert changed.headers["etag"] == '"2"'
    assert changed.json()["revision"] == 2
    assert client.patch(path, json={"unit": "in"}).headers["etag"] == '"3"'
    assert client.get(path).json()["revision"] == 3
    listed = client.get("/api/drawings?limit=1").json()[0]
    assert (listed["id"], listed["revision"]) == (changed.json()["id"], 3)


@pytest.mark.parametrize("where", ["", "/edges", "/edges?format=columns"])
def test_an_unchanged_drawing_is_not_sent_again(client: httpx.Client, where: str) -> None:
    id = upload_drawing(client, square())["id"]
    path = f"/api/drawings/{id}{where}"
    tag = client.get(path).headers["etag"]
    for known in (tag, f'"9", {tag}', f"W/{tag}"):
        again = client.get(path, headers={"If-None-Match": known})
        assert (again.status_code, again.content) == (304, b"")
        assert again.headers["etag"] == tag
    client.patch(f"/api/drawings/{id}/edges", json=CREASE)
    fresh = client.get(path, headers={"If-None-Match": tag})
    assert fresh.status_code == 200
    assert fresh.headers["etag"] == '"2"'


def test_a_profile_that_changed_changes_the_answer_and_not_the_revision(
    client: httpx.Client,
) -> None:
    profile = 'title = "Mine"\n[[rule]]\ntype = "cut"\nlayer = ["CUT"]\n'
    toml = {"Content-Type": "application/toml"}
    kept = client.put("/api/profiles/etagged", content=profile, headers=toml)
    assert kept.status_code == 201, kept.text
    drawing = upload_drawing(client, square(), profile="etagged")
    path = f"/api/drawings/{drawing['id']}"
    tag = client.get(path).headers["etag"]
    other = {**toml, "If-Match": kept.headers["etag"]}
    client.put("/api/profiles/etagged", content=profile.replace("cut", "crease"), headers=other)
    again = client.get(path, headers={"If-None-Match": tag})
    assert again.status_code == 200
    assert again.json()["profile_state"] == "changed"
    assert again.json()["revision"] == drawing["revision"]
    match = {"If-Match": again.headers["etag"]}
    assert client.patch(f"{path}/edges", json=CREASE, headers=match).status_code == 200


@pytest.mark.parametrize(
    ("where", "change"), [("", {"unit": "in"}), ("/edges", CREASE)], ids=["drawing", "edges"]
)
def test_a_change_made_for_an_older_revision_is_refused(
    client: httpx.Client, where: str, change: dict[str, Any]
) -> None:
    id = upload_drawing(client, square())["id"]
    path = f"/api/drawings/{id}{where}"
    first = client.patch(path, json=change, headers={"If-Match": '"1"'})
    assert first.status_code == 200
    for old in ('"1"', "1", '"stale"', '"12"', "", '""', '"1", "7"'):
        assert_stale(client.patch(path, json=change, headers={"If-Match": old}), 2)
    assert client.get(f"/api/drawings/{id}").json()["revision"] == 2
    for now in (first.headers["etag"], "*", '"7", "4"', 'W/"5"'):
        assert client.patch(path, json=change, headers={"If-Match": now}).status_code == 200
    # A request without a revision applies to any revision.
    assert client.patch(path, json=change).json()["revision"] == 7


def test_an_order_of_an_older_revision_is_refused(client: httpx.Client) -> None:
    id = upload_drawing(client, square())["id"]
    client.patch(f"/api/drawings/{id}/edges", json=CREASE)
    jobs = len(client.get("/api/jobs?limit=500").json())
    order: dict[str, Any] = {"drawing": id, "board": "e-flute"}
    assert_stale(client.post("/api/jobs", json={**order, "revision": 1}), 2)
    assert_stale(client.post("/api/jobs", json={**order, "revision": 3}), 2)
    assert len(client.get("/api/jobs?limit=500").json()) == jobs
    assert client.post("/api/jobs", json={**order, "revision": 2}).status_code == 201
    assert client.post("/api/jobs", json=order).status_code == 201


@pytest.mark.parametrize("wrong", [0, -1, "x", 1.5, 2**40, [1]])
def test_invalid_revisions_are_refused(client: httpx.Client, wrong: object) -> None:
    id = upload_drawing(client, square())["id"]
    order: dict[str, Any] = {"drawing": id, "board": "e-flute", "revision": wrong}
    assert client.post("/api/jobs", json=order).status_code == 422


def change_to_inches(client: LocalClient, id: str) -> None:
    store = client.service.store
    row = store.drawings.get_with(id, "overrides")
    flipped = bytes([LineType.from_word("crease")]) + row.overrides[1:]
    store.drawings.change(id, row.version, stored("x"), overrides=flipped, unit_given="in")


def test_a_job_uses_the_ordered_revision_and_no_later_one(
    client: LocalClient, monkeypatch: pytest.MonkeyPatch
) -> None:
    id = upload_drawing(client, square())["id"]
    add = client.service.store.jobs.add
    between: list[int] = []

    def changed_meanwhile(drawing: Drawing, *arguments: Any) -> Any:
        change_to_inches(client, id)
        between.append(drawing.version)
        return add(drawing, *arguments)

    monkeypatch.setattr(client.service.store.jobs, "add", changed_meanwhile)
    job = order_job(client, id, revision=1)
    assert between == [1]
    row = client.service.store.jobs.get(job["id"])
    kept = np.frombuffer(client.service.store.jobs.column(job["id"], "overrides"), np.uint8)
    assert row.unit_given == ""
    assert (kept == NO_OVERRIDE).all()
    program = wait_for_state(client, job["id"], "ready")
    assert program["seconds"] > 0


def test_an_order_is_refused_if_its_revision_changes_while_questions_are_searched(
    client: LocalClient, monkeypatch: pytest.MonkeyPatch
) -> None:
    id = upload_drawing(client, square())["id"]
    run = client.service.pool.run
    searched: list[str] = []

    def changed_meanwhile(task: Callable[..., Any], *arguments: Any, **named: Any) -> Any:
        if task is tasks.open_questions:
            searched.append(id)
            change_to_inches(client, id)
        return run(task, *arguments, **named)

    monkeypatch.setattr(client.service.pool, "run", changed_meanwhile)
    # Line types of its own need a search for questions.
    table = {"machine": "demo-table", "board": "b-flute"}
    order = {**table, **CREASE, "drawing": id, "revision": 1}
    jobs = client.get("/api/jobs").json()
    answer = client.post("/api/jobs", json=order)
    assert (answer.status_code, searched) == (412, [id])
    assert client.get("/api/jobs").json() == jobs


def test_of_two_simultaneous_changes_both_are_made_or_one_is_refused(
    client: LocalClient, monkeypatch: pytest.MonkeyPatch
) -> None:
    id = upload_drawing(client, square())["id"]
    run = client.service.pool.run
    others = [3]

    def changed_meanwhile(task: Callable[..., Any], *arguments: Any, **named: Any) -> Any:
        found = run(task, *arguments, **named)
        if task is tasks.read and others[0]:
            others[0] -= 1
            store = client.service.store
            row = store.drawings.get_with(id, "overrides")
            mine = row.overrides[:1] + bytes([LineType.from_word("crease")]) + row.overrides[2:]
            store.drawings.change(id, row.version, stored("x"), overrides=mine)
        return found

    monkeypatch.setattr(client.service.pool, "run", changed_meanwhile)
    path = f"/api/drawings/{id}/edges"
    assert_stale(client.patch(path, json=CREASE, headers={"If-Match": '"1"'}), 2)
    others[0] = 2
    assert client.patch(path, json=CREASE).json()["revision"] == 5
    types = [edge["type"] for edge in client.get(path).json()["edges"]]
    assert types[:2] == ["crease", "crease"]
    others[0] = 3
    again = client.patch(path, json=CUT)
    assert again.status_code == 409
    assert "Try again" in again.json()["hint"]


def test_events_of_changes_have_the_revision(client: httpx.Client) -> None:
    id = upload_drawing(client, square())["id"]
    deadline = time.monotonic() + 60.0
    with client.stream("GET", "/api/events") as stream:
        lines = stream.iter_lines()
        next(lines)
        assert client.patch(f"/api/drawings/{id}/edges", json=CREASE).status_code == 200
        for line in lines:
            if f'"id":"{id}"' in line:
                assert '"revision":2' in line
                return
            assert time.monotonic() < deadline


@pytest.mark.parametrize(
    ("tag", "known", "expected"),
    [
        ('"1"', None, False),
        ('"1"', '"1"', True),
        ('"1"', '"11"', False),
        ('"1"', '"2","1"', True),
        ('"1"', "*", True),
        ('"1-changed"', '"1"', False),
        ('"1"', '"1-changed"', False),
    ],
)
def test_entity_tags_are_compared_completely(tag: str, known: str | None, expected: bool) -> None:
    assert revisions.is_known(tag, known) is expected
