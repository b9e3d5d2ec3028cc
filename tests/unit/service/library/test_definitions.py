"""REST of own machines, boards and tools: versions, conflicts, faults, TOML and JSON."""

from __future__ import annotations

import json
import threading
import tomllib
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import httpx
import pytest

from knifetip.languages.registry import language_names
from knifetip.library import load
from knifetip.library.definition import MAX_BYTES, Shelf
from tests.support.serving.server import order_job, square, upload_drawing, wait_for_state

pytestmark = pytest.mark.xdist_group("server")

TOML = {"Content-Type": "application/toml"}
MACHINE = load.library_text("machines", "demo-table")
BOARD = load.library_text("boards", "greyboard-2.0")
SHIPPED = {"machines": "demo-table", "boards": "e-flute", "tools": "static-knife"}


def save(
    client: httpx.Client, path: str, toml: str, match: str = "", **more: str
) -> httpx.Response:
    headers = TOML | ({"If-Match": match} if match else {})
    return client.put(f"/api/{path}", content=toml.encode(), headers=headers, params=more)


def faults(answer: httpx.Response) -> dict[str, str]:
    """Return the code of each fault in an answer by the path of its field."""
    assert answer.status_code == 422, answer.text
    body = answer.json()
    assert body["code"] == "library.invalid"
    assert body["hint"]
    return {one["arguments"]["path"]: one["code"] for one in body["arguments"]["faults"]}


@pytest.mark.parametrize("shelf", Shelf)
def test_a_copy_of_a_shipped_entry_is_created_changed_and_deleted(
    client: httpx.Client, shelf: Shelf
) -> None:
    toml = load.library_text(shelf, SHIPPED[shelf])
    path = f"{shelf.value}/copy"
    created = save(client, path, toml, by="Ada", note="first")
    assert (created.status_code, created.headers["etag"]) == (201, '"1"')
    assert client.get(f"/api/{path}/toml").text == toml
    shown = client.get(f"/api/{path}/definition")
    assert shown.json() == created.json()
    assert shown.headers["etag"] == '"1"'
    assert shown.json()["fields"] == tomllib.loads(toml)
    fields = {**shown.json()["fields"], "title": "Changed"}
    changed = client.put(f"/api/{path}", json=fields, headers={"If-Match": '"1"'})
    assert (changed.status_code, changed.headers["etag"]) == (200, '"2"')
    assert client.get(f"/api/{path}/definition?version=1").json() == shown.json()
    versions = client.get(f"/api/{path}/versions").json()
    assert [(row["version"], row["by"], row["note"]) for row in versions] == [
        (2, "", ""),
        (1, "Ada", "first"),
    ]
    listed = client.get("/api/library").json()
    assert {
        (row["shelf"], row["name"], row["version"]) for row in listed if not row["shipped"]
    } >= {(shelf.value, "copy", 2)}
    assert client.delete(f"/api/{path}", headers={"If-Match": '"1"'}).status_code == 412
    assert client.delete(f"/api/{path}", headers={"If-Match": '"2"'}).status_code == 204
    assert client.get(f"/api/{path}/definition").status_code == 404
    assert client.delete(f"/api/{path}").status_code == 404


def test_a_version_in_between_is_a_conflict(client: httpx.Client) -> None:
    assert save(client, "boards/conflict", BOARD).status_code == 201
    again = save(client, "boards/conflict", BOARD)
    assert (again.status_code, again.json()["code"]) == (409, "library.exists")
    assert save(client, "boards/conflict", BOARD, '"1"').status_code == 200
    stale = save(client, "boards/conflict", BOARD, '"1"')
    assert (stale.status_code, stale.json()["code"]) == (412, "library.stale")
    assert save(client, "boards/conflict", BOARD, "*").headers["etag"] == '"3"'
    assert save(client, "boards/none", BOARD, '"1"').status_code == 404
    bad = save(client, "boards/conflict", BOARD, "yesterday")
    assert (bad.status_code, bad.json()["code"]) == (422, "library.bad-if-match")


@pytest.mark.parametrize("shelf", Shelf)
def test_of_two_changes_of_one_version_one_is_refused_and_changes_nothing(
    client: httpx.Client, shelf: Shelf
) -> None:
    toml = load.library_text(shelf, SHIPPED[shelf])
    path = f"{shelf.value}/race"
    assert save(client, path, toml).status_code == 201
    start = threading.Barrier(4)

    def change(by: str) -> httpx.Response:
        start.wait()
        return save(client, path, toml, '"1"', by=by)

    with ThreadPoolExecutor(4) as pool:
        answers = dict(zip("abcd", pool.map(change, "abcd"), strict=True))
    won = [by for by, answer in answers.items() if answer.status_code == 200]
    lost = [answer for answer in answers.values() if answer.status_code != 200]
    assert len(won) == 1
    assert [(one.status_code, one.json()["code"]) for one in lost] == [(412, "library.stale")] * 3
    # The answer names the version that the client must load and compare.
    assert {one.json()["arguments"]["version"] for one in lost} == {2}
    versions = client.get(f"/api/{path}/versions").json()
    assert [(row["version"], row["by"]) for row in versions] == [(2, won[0]), (1, "")]


@pytest.mark.parametrize("match", ['W/"2"', "2"])
def test_a_proxy_may_have_weakened_the_version(client: httpx.Client, match: str) -> None:
    name = f"boards/weak-{len(match)}"
    save(client, name, BOARD)
    save(client, name, BOARD, '"1"')
    assert save(client, name, BOARD, match).headers["etag"] == '"3"'
    assert save(client, name, BOARD, match).status_code == 412
    assert client.delete(f"/api/{name}", headers={"If-Match": match}).status_code == 412
    assert client.get(f"/api/{name}/definition").json()["version"] == 3


@pytest.mark.parametrize("shelf", Shelf)
def test_shipped_entries_stay_as_they_are(client: httpx.Client, shelf: Shelf) -> None:
    name = SHIPPED[shelf]
    for answer in (
        save(client, f"{shelf.value}/{name}", load.library_text(shelf, name)),
        client.delete(f"/api/{shelf.value}/{name}"),
    ):
        assert (answer.status_code, answer.json()["code"]) == (409, "library.shipped")
    shown = client.get(f"/api/{shelf.value}/{name}/definition").json()
    assert (shown["shipped"], shown["version"]) == (True, 0)
    assert client.get(f"/api/{shelf.value}/{name}/versions").json() == []
    assert client.get(f"/api/{shelf.value}/{name}/toml").text == load.library_text(shelf, name)


def test_each_fault_names_its_field(client: httpx.Client) -> None:
    fields: dict[str, Any] = tomllib.loads(MACHINE)
    fields["width"] = -5
    fields["dialect"] = "fanuc"
    fields["station"][1]["tool"]["radius"] = "big"
    fields["station"][0]["datum"]["y"] = None
    fields["colour"] = "red"
    assert faults(client.put("/api/machines/faulty", json=fields)) == {
        "colour": "field.unknown",
        "width": "field.not-above",
        "dialect": "field.not-one-of",
        "station 1 → datum → y": "field.missing",
        "station 2 → tool → radius": "field.not-a-number",
    }
    assert client.get("/api/machines/faulty").status_code == 404
    thin = BOARD.replace("groove_depth = 1.3", "groove_depth = 2.5")
    assert faults(save(client, "boards/faulty", thin)) == {
        "groove_depth": "field.not-less-than-caliper"
    }


DEEP = 20_000
HUGE = "1" + "0" * 400


@pytest.mark.parametrize(
    ("content", "kind"),
    [
        (b"", "toml"),
        (b"title = ", "toml"),
        (b"\xff\xfe", "toml"),
        (b"a = " + b"[" * DEEP + b"]" * DEEP, "toml"),
        (b"a." * DEEP + b"a = 1", "toml"),
        (b"x" * (MAX_BYTES + 1), "toml"),
        (MACHINE.replace("1600.0", HUGE).encode(), "toml"),
        (MACHINE.replace("1600.0", "1e999").encode(), "toml"),
        (MACHINE.replace("1600.0", "1979-05-27").encode(), "toml"),
        (MACHINE.replace("number = 1", "number = 0x" + "f" * 9000).encode(), "toml"),
        (MACHINE.replace("number = 1", "number = 1" + "0" * 5000).encode(), "toml"),
        (b"", "json"),
        (b"null", "json"),
        (b"[1]", "json"),
        (b'{"a": [null]}', "json"),
        (b'{"a": ' + b"[" * DEEP + b"]" * DEEP + b"}", "json"),
        (b'{"a": ' * DEEP + b"1" + b"}" * DEEP, "json"),
        (b'{"width": ' + b"9" * 5000 + b"}", "json"),
        (b'{"width": NaN, "title": "\\ud800"}', "json"),
        (json.dumps({"title": "x", "station": {"a": 1}, "axes": []}).encode(), "json"),
    ],
)
def test_anything_else_is_refused_with_a_hint(
    client: httpx.Client, content: bytes, kind: str
) -> None:
    for shelf in Shelf:
        answer = client.put(
            f"/api/{shelf.value}/hostile",
            content=content,
            headers={"Content-Type": f"application/{kind}"},
        )
        assert answer.status_code == 422, answer.text
        assert answer.json()["hint"]


@pytest.mark.parametrize("name", ["Upper", "a.b", "x" * 65, "-a", "ä", "%20"])
def test_other_names_are_refused(client: httpx.Client, name: str) -> None:
    answer = save(client, f"machines/{name}", MACHINE)
    assert (answer.status_code, answer.json()["code"]) == (422, "library.bad-name")


def test_versions_out_of_range_are_refused(client: httpx.Client) -> None:
    save(client, "boards/ranges", BOARD)
    assert client.get("/api/boards/ranges/definition?version=2").status_code == 404
    assert client.get("/api/boards/ranges/toml?version=-1").status_code == 422
    assert client.get("/api/boards/e-flute/toml?version=1").status_code == 404


def test_schemas_describe_the_fields(client: httpx.Client) -> None:
    schema = client.get("/api/schemas/boards").json()
    assert schema["properties"]["groove_pass"]["description"].startswith("largest depth")
    machines = client.get("/api/schemas/machines").json()
    assert "StationTable" in machines["$defs"]
    assert machines["properties"]["dialect"]["enum"] == language_names()
    assert client.get("/api/schemas/profiles").status_code == 422


def test_a_job_is_compiled_for_the_version_with_which_it_was_ordered(client: httpx.Client) -> None:
    own = BOARD + "\nbridge_width = 0.5\nbridge_spacing = 60.0\n"
    save(client, "boards/own-grey", own)
    save(client, "machines/own-table", MACHINE)
    assert client.get("/api/boards/own-grey").json()["bridge_spacing"] == 60.0
    drawing = upload_drawing(client, square())["id"]
    job = order_job(client, drawing, machine="own-table", board="own-grey")
    assert (job["machine_version"], job["board_version"]) == (1, 1)
    save(client, "boards/own-grey", BOARD, '"1"')
    ready = wait_for_state(client, job["id"], "ready")
    assert (ready["board_version"], ready["waiting_for"]) == (1, "compile")
    assert ready["message"]["code"] == "waiting.outdated"
    program = client.get(f"/api/jobs/{job['id']}/program").text
    assert "machine own-table version 1" in program
    assert "board own-grey version 1" in program
    released = client.post(f"/api/jobs/{job['id']}/release")
    assert (released.status_code, released.json()["code"]) == (409, "job.outdated")
    assert client.delete("/api/boards/own-grey").json()["code"] == "library.in-use"
    assert client.post(f"/api/jobs/{job['id']}/recompile").status_code == 200
    again = wait_for_state(client, job["id"], "ready")
    assert (again["board_version"], again["waiting_for"]) == (2, "")
    bridged, plain = program, client.get(f"/api/jobs/{job['id']}/program").text
    assert "board own-grey version 2" in plain
    assert bridged.count("\n") > plain.count("\n"), "the bridges are not in the first program"
    client.post(f"/api/jobs/{job['id']}/cancel")
    assert client.delete("/api/boards/own-grey").status_code == 204


def test_a_queued_job_that_must_be_compiled_again_has_no_estimated_start(
    client: httpx.Client,
) -> None:
    """Its machine takes the jobs behind it first."""
    save(client, "boards/aging", BOARD)
    save(client, "machines/aging-table", MACHINE)
    drawing = upload_drawing(client, square())["id"]
    jobs = []
    for board in ("aging", "e-flute"):
        job = order_job(client, drawing, machine="aging-table", board=board)["id"]
        wait_for_state(client, job, "ready")
        assert client.post(f"/api/jobs/{job}/release").status_code == 200
        jobs.append(job)
    save(client, "boards/aging", BOARD + "\n", '"1"')
    rows = [client.get(f"/api/jobs/{job}").json() for job in jobs]
    assert [row["queue_position"] for row in rows] == [1, 2]
    assert [row["no_estimate"] for row in rows] == ["compile", "gateway"]
    assert [row["estimated_start"] for row in rows] == [None, None]
    queue = client.get("/api/machines/aging-table/queue").json()
    assert [entry["starts_in"] for entry in queue["entries"]] == [None, 0.0]
    for job in jobs:
        client.post(f"/api/jobs/{job}/cancel")


def test_a_gateway_with_an_older_definition_gets_no_job(client: httpx.Client) -> None:
    save(client, "machines/gated", MACHINE)
    claim = {"gateway": "g", "machine": "gated", "wait": 0.0, "machine_version": 1}
    assert client.post("/api/gateway/claim", json=claim).status_code == 204
    save(client, "machines/gated", MACHINE, '"1"')
    answer = client.post("/api/gateway/claim", json=claim)
    assert (answer.status_code, answer.json()["code"]) == (412, "gateway.outdated-machine")
    unversioned = {**claim, "machine_version": None}
    assert client.post("/api/gateway/claim", json=unversioned).status_code == 204
