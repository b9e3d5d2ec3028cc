"""Large answers are made by a worker process, stored, and sent as bytes."""

from __future__ import annotations

import gzip
import json
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from typing import Any

import pytest
from pydantic import BaseModel

from knifetip.model.interpretation import Interpretation
from knifetip.presentation.columns import unpack_columns
from knifetip.presentation.drawn_edges import pack_drawn_edges
from knifetip.service.database.tables import Drawing
from knifetip.service.drawings import document_tasks, first_picture
from knifetip.service.drawings import models as schemas
from knifetip.service.drawings import report_models as reports
from knifetip.service.orders.verdict_models import VerdictOut
from knifetip.service.processes import tasks
from tests.support.serving.server import (
    LocalClient,
    order_job,
    square,
    upload_drawing,
    wait_for_state,
)
from tests.support.writers import dxf_text as text
from tests.support.writers.pdf_text import pages

pytestmark = pytest.mark.xdist_group("server")

PATHS: dict[str, type[BaseModel]] = {
    "": schemas.DrawingOut,
    "/edges": schemas.EdgesOut,
    "/import-report": reports.ImportReportOut,
    "/import-report?outcome=dropped": reports.ImportReportOut,
    "/cleaning": reports.CleaningOut,
    "/blanks": reports.BlanksOut,
}
_NOTE = text.entity("TEXT", (8, "NOTES"), (10, 12), (20, 34), (40, 5), (1, "Größe"))
_CREASE = {"overrides": [{"type": "crease", "edges": [1]}]}
#: Twice the same line, and a text.
CONTENT = square(extra=(text.line(0.0, 0.0, 100.0, 0.0, (8, "CUT")), _NOTE))


@pytest.fixture
def tasks_of_workers(
    client: LocalClient, monkeypatch: pytest.MonkeyPatch
) -> list[Callable[..., Any]]:
    """The tasks that worker processes executed; every drawing counts as large."""
    monkeypatch.setattr("knifetip.service.drawings.documents.LARGE", 1)
    executed: list[Callable[..., Any]] = []
    run = client.service.pool.run

    def noted(task: Callable[..., Any], *arguments: object, **named: Any) -> Any:
        executed.append(task)
        return run(task, *arguments, **named)

    monkeypatch.setattr(client.service.pool, "run", noted)
    return executed


def strip(tag: str) -> str:
    return tag.removeprefix("W/")


@pytest.mark.parametrize("path", [*PATHS, "/picture", "/pages"])
def test_a_large_answer_is_made_once_and_then_sent_from_the_store(
    client: LocalClient, path: str, tasks_of_workers: list[Callable[..., Any]]
) -> None:
    url = f"/api/drawings/{upload_drawing(client, CONTENT)['id']}{path}"
    tasks_of_workers.clear()
    first = client.get(url)
    assert first.status_code == 200
    assert len(tasks_of_workers) == 1
    assert [client.get(url).content for _ in range(2)] == [first.content] * 2
    assert len(tasks_of_workers) == 1, "a stored answer is not made again"


@pytest.mark.parametrize("path", [*PATHS, "/picture", "/pages"])
def test_a_stored_answer_is_compressed_for_clients_that_accept_it(
    client: LocalClient, path: str, tasks_of_workers: list[Callable[..., Any]]
) -> None:
    url = f"/api/drawings/{upload_drawing(client, CONTENT)['id']}{path}"
    with client.stream("GET", url, headers={"Accept-Encoding": "gzip"}) as packed:
        content = b"".join(packed.iter_raw())
    plain = client.get(url, headers={"Accept-Encoding": "identity"})
    assert (packed.headers["content-encoding"], packed.headers["etag"][:2]) == ("gzip", "W/")
    assert "content-encoding" not in plain.headers
    assert strip(packed.headers["etag"]) == plain.headers["etag"]
    assert packed.headers["vary"] == "Accept-Encoding"
    # The texts of JSON answers are in the language of the request.
    is_json = plain.headers["content-type"] == "application/json"
    assert plain.headers["vary"] == "Accept-Encoding" + ", Accept-Language" * is_json
    assert gzip.decompress(content) == plain.content
    assert len(tasks_of_workers) == 2, "the reading and the answer"


@pytest.mark.parametrize("path", [*PATHS, "/picture"])
def test_an_unchanged_answer_is_not_sent_again(
    client: LocalClient, path: str, tasks_of_workers: list[Callable[..., Any]]
) -> None:
    id = upload_drawing(client, CONTENT)["id"]
    url = f"/api/drawings/{id}{path}"
    tag = client.get(url).headers["etag"]
    made = len(tasks_of_workers)
    for known in (tag, strip(tag), f'"other", {tag}'):
        same = client.get(url, headers={"If-None-Match": known})
        assert (same.status_code, same.content, strip(same.headers["etag"])) == (
            304,
            b"",
            strip(tag),
        )
    assert len(tasks_of_workers) == made
    client.patch(
        f"/api/drawings/{id}/edges", json={"overrides": [{"type": "crease", "edges": [1]}]}
    )
    changed = client.get(url, headers={"If-None-Match": tag})
    assert changed.status_code == 200
    assert strip(changed.headers["etag"]) != strip(tag)


def test_the_pages_of_a_file_are_made_once_also_if_its_drawing_changes(
    client: LocalClient, tasks_of_workers: list[Callable[..., Any]]
) -> None:
    id = upload_drawing(client, pages("0 0 m 90 0 l S", "0 0 m 0 20 l S"), unit="mm")["id"]
    url = f"/api/drawings/{id}/pages"
    first = client.get(url)
    assert [page["edges"] for page in first.json()] == [1, 1]
    client.patch(f"/api/drawings/{id}", json={"unit": "in"})
    tasks_of_workers.clear()
    assert client.get(url).json() == first.json()
    same = client.get(url, headers={"If-None-Match": first.headers["etag"]})
    assert same.status_code == 304
    assert tasks_of_workers == []


@pytest.mark.parametrize("path", PATHS)
def test_large_and_small_answers_are_equal_and_follow_the_schema(
    client: LocalClient, path: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    url = f"/api/drawings/{upload_drawing(client, CONTENT)['id']}{path}"
    small = client.get(url)
    monkeypatch.setattr("knifetip.service.drawings.documents.LARGE", 1)
    assert client.get(url).content == small.content
    model = PATHS[path]
    assert json.loads(model.model_validate_json(small.content).model_dump_json()) == small.json()


def test_a_changed_drawing_has_another_answer_and_one_stored_document(
    client: LocalClient, tasks_of_workers: list[Callable[..., Any]]
) -> None:
    id = upload_drawing(client, CONTENT)["id"]
    url = f"/api/drawings/{id}/edges"
    before = client.get(url).json()["edges"]
    client.patch(url, json=_CREASE)
    after = client.get(url).json()["edges"]
    assert ([one["type"] for one in before], [one["type"] for one in after]) == (
        ["cut"] * 4,
        ["cut", "crease", "cut", "cut"],
    )
    row = client.service.store.drawings.get(id)
    find = client.service.store.documents.find
    assert find(row, "edges", "1") is None
    assert find(row, "edges", "2") is not None


def test_the_verdict_on_a_long_program_is_made_once(
    client: LocalClient,
    tasks_of_workers: list[Callable[..., Any]],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    job = order_job(client, upload_drawing(client, square())["id"])["id"]
    url = f"/api/jobs/{job}/verdict"
    early = client.get(url)
    wait_for_state(client, job, "ready", "refused")
    small = client.get(url)
    made = len(tasks_of_workers)
    monkeypatch.setattr("knifetip.service.orders.verdict_document.LARGE", 1)
    large = [client.get(url) for _ in range(2)]
    assert [one.content for one in large] == [small.content] * 2
    assert len(tasks_of_workers) == made + 1
    known = {"If-None-Match": large[0].headers["etag"]}
    assert client.get(url, headers=known).status_code == 304
    assert VerdictOut.model_validate(small.json()).edge_deviation
    assert early.status_code in (200, 409)


def test_requests_for_the_same_answer_wait_for_one_worker(
    client: LocalClient, tasks_of_workers: list[Callable[..., Any]], monkeypatch: pytest.MonkeyPatch
) -> None:
    id = upload_drawing(client, CONTENT)["id"]
    tasks_of_workers.clear()
    arrived = 0
    find = client.service.store.documents.find
    make = client.app.state.documents._make

    def counted(row: Drawing, kind: str, version: str) -> bytes | None:
        nonlocal arrived
        found = find(row, kind, version)
        arrived += 1
        return found

    def late(*arguments: Any) -> Any:
        while arrived < 4:  # all have found nothing
            pass
        return make(*arguments)

    monkeypatch.setattr(client.service.store.documents, "find", counted)
    monkeypatch.setattr(client.app.state.documents, "_make", late)
    with ThreadPoolExecutor(4) as threads:
        answers = list(
            threads.map(lambda _: client.get(f"/api/drawings/{id}/edges").json(), range(4))
        )
    assert answers == [answers[0]] * 4
    assert len(tasks_of_workers) == 1


def nothing(*_: object) -> None:
    """Ignore progress."""


def test_what_a_first_picture_needs_is_made_while_many_edges_are_read(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    assert tasks.read(nothing, CONTENT, Interpretation(), None).drawn_edges == b""
    monkeypatch.setattr(tasks, "MANY_EDGES", 4)
    reading = tasks.read(nothing, CONTENT, Interpretation(), None)
    assert gzip.decompress(reading.drawn_edges) == pack_drawn_edges(reading.edges)


def test_the_first_picture_of_many_edges_is_stored_with_each_revision_of_the_drawing(
    client: LocalClient,
    tasks_of_workers: list[Callable[..., Any]],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr("knifetip.service.drawings.routes.MANY_EDGES", 4)
    run = client.service.pool.run

    # As if the worker process had read many edges.
    def run_as_many(task: Callable[..., Any], *arguments: Any, **named: Any) -> Any:
        result = run(task, *arguments, **named)
        if task is not tasks.read:
            return result
        return replace(result, drawn_edges=document_tasks.drawn_edges(nothing, result.edges))

    monkeypatch.setattr(client.service.pool, "run", run_as_many)
    id = upload_drawing(client, CONTENT)["id"]
    url = f"/api/drawings/{id}/edges?format=drawn"
    tasks_of_workers.clear()
    first = client.get(url)
    assert unpack_columns(first.content)[0]["line_type"].tolist() == [1] * 4
    client.patch(f"/api/drawings/{id}/edges", json=_CREASE).raise_for_status()
    assert unpack_columns(client.get(url).content)[0]["line_type"][1] == 2
    assert document_tasks.drawn_edges not in tasks_of_workers
    # Without the stored document, for example after a restore, it is made for the request.
    row = client.service.store.drawings.get(id)
    client.service.store.documents.keep(row, first_picture.KIND, "other", b"")
    assert unpack_columns(client.get(url).content)[0]["line_type"][1] == 2
    assert document_tasks.drawn_edges in tasks_of_workers


def test_a_deleted_drawing_leaves_no_document(
    client: LocalClient, tasks_of_workers: list[Callable[..., Any]]
) -> None:
    id = upload_drawing(client, CONTENT)["id"]
    client.get(f"/api/drawings/{id}/edges")
    row = client.service.store.drawings.get(id)
    assert client.service.store.documents.find(row, "edges", "1")
    client.delete(f"/api/drawings/{id}").raise_for_status()
    assert client.service.store.documents.find(row, "edges", "1") is None
    client.service.store.documents.keep(row, "edges", "1", b"late")
    assert client.service.store.documents.find(row, "edges", "1") is None


def test_a_document_of_another_version_of_knifetip_is_made_again(
    client: LocalClient,
    tasks_of_workers: list[Callable[..., Any]],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    url = f"/api/drawings/{upload_drawing(client, CONTENT)['id']}/edges"
    client.get(url)
    made = len(tasks_of_workers)
    monkeypatch.setattr("knifetip.service.documents.store._PROGRAM", "99.0")
    client.get(url)
    assert len(tasks_of_workers) == made + 1
