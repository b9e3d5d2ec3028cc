"""Rights of programs: scopes, own jobs, limits to customers and machines, keys of gateways."""

from __future__ import annotations

import json
import time
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack
from typing import Any

import httpx
import pytest
import sqlalchemy as sa

from knifetip.contract.job import State
from knifetip.service.database.key_limits import KeyLimits
from knifetip.service.database.tables import Drawing, Job
from knifetip.service.http.scopes import AccessScope
from knifetip.service.settings import Settings
from tests.support.serving.server import (
    LocalClient,
    order_job,
    run_server,
    square,
    upload_drawing,
)

pytestmark = pytest.mark.xdist_group("key-rights")

PASSWORD = "four words of text"
ADMIN, DESIGNER, ORDER, STATION, WEBHOOKS, GATEWAY = (
    AccessScope(word) for word in ("admin", "designer", "order", "station", "webhooks", "gateway")
)
HOOK = {"url": "http://127.0.0.1:9/hook", "event_types": ["job.received"]}


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[LocalClient]:
    folder = tmp_path_factory.mktemp("rights")
    settings = Settings(database=f"sqlite:///{folder}/a.sqlite", compiles=False, page=folder)
    with run_server(settings) as client:
        client.service.store.users.add("boss", PASSWORD, ADMIN)
        yield client


@pytest.fixture
def clients() -> Iterator[ExitStack]:
    with ExitStack() as stack:
        yield stack


class Keys:
    """Makes clients with keys of the server."""

    def __init__(self, server: LocalClient, stack: ExitStack) -> None:
        self.server, self._stack = server, stack

    def __call__(
        self, *scopes: AccessScope, customer: str = "", machines: tuple[str, ...] = ()
    ) -> httpx.Client:
        limits = KeyLimits(customer, frozenset(machines))
        _, secret = self.server.service.store.keys.add("program", scopes, limits=limits)
        headers = {"Authorization": f"Bearer {secret}"}
        client = httpx.Client(
            base_url=self.server.base_url, trust_env=False, timeout=60.0, headers=headers
        )
        return self._stack.enter_context(client)


@pytest.fixture
def keys(server: LocalClient, clients: ExitStack) -> Keys:
    return Keys(server, clients)


def queue(server: LocalClient, job: str) -> None:
    """Put a job into the queue of its machine without compiling it."""
    with server.service.store.database.writing() as session:
        session.execute(
            sa.update(Job)
            .where(Job.id == job)
            .values(state=State.QUEUED.value, program_sha256="0" * 64, lines=1)
        )


def refusals(client: httpx.Client, *requests: tuple[str, str, Any]) -> list[int]:
    """Return the statuses of requests: method, path and JSON body."""
    return [client.request(method, path, json=body).status_code for method, path, body in requests]


def test_a_key_of_another_customer_sees_neither_ticket_nor_export(keys: Keys) -> None:
    shop = keys(DESIGNER)
    drawing = upload_drawing(shop, square(), customer="acme")["id"]
    job = order_job(shop, drawing, machine="demo-table", customer="acme")["id"]
    other, own = (
        keys(AccessScope.VIEWER, customer="other"),
        keys(AccessScope.VIEWER, customer="acme"),
    )
    requests = (
        ("GET", f"/api/jobs/{job}/ticket.pdf", None),
        ("GET", f"/api/drawings/{drawing}/export?format=svg", None),
        ("GET", f"/api/jobs/{job}/toolpath/export?format=svg", None),
    )
    assert refusals(other, *requests) == [404, 404, 404]
    # 409: the job is not compiled.
    assert refusals(own, *requests) == [200, 200, 409]


def test_a_key_that_orders_commands_its_own_jobs_and_no_machine(keys: Keys) -> None:
    erp, shop = keys(ORDER), keys(AccessScope.OPERATOR)
    drawing = upload_drawing(erp, square())["id"]
    own = order_job(erp, drawing, machine="demo-table", release=True)["id"]
    other = order_job(shop, drawing, machine="demo-table")["id"]
    changed = erp.patch(f"/api/jobs/{own}", json={"notes": "urgent", "priority": 3})
    assert (changed.status_code, changed.json()["priority"]) == (200, 3)
    assert erp.patch(f"/api/drawings/{drawing}", json={"notes": "x"}).status_code == 200
    # 409: the job is not compiled, so the state refuses what the scope permits.
    assert erp.post(f"/api/jobs/{own}/release").status_code == 409
    assert refusals(
        erp,
        ("PATCH", f"/api/jobs/{other}", {"notes": "x"}),
        ("POST", f"/api/jobs/{other}/release", None),
        ("POST", f"/api/jobs/{other}/cancel", None),
        ("POST", f"/api/jobs/{other}/exceptions", {"exceptions": [], "reason": "r"}),
        ("POST", f"/api/jobs/{own}/confirm", {}),
        ("POST", f"/api/jobs/{own}/resume", {}),
        ("POST", f"/api/jobs/{own}/hold", None),
        ("POST", "/api/machines/demo-table/operations", {"operation": "home"}),
        ("GET", "/api/webhooks", None),
        ("DELETE", "/api/profiles/acme", None),
    ) == [403, 403, 403, 422, 403, 403, 403, 403, 403, 403]
    queue(keys.server, own)
    assert erp.post(f"/api/jobs/{own}/cancel").json()["state"] == "cancelled"
    assert shop.post(f"/api/jobs/{other}/cancel").status_code == 200


def test_a_rotated_key_keeps_its_jobs(keys: Keys, server: LocalClient) -> None:
    store = server.service.store
    row, before = store.keys.add("ERP", [ORDER])
    admin = keys(ADMIN)
    erp = keys(ORDER)
    erp.headers["Authorization"] = f"Bearer {before}"
    job = order_job(erp, upload_drawing(erp, square())["id"], machine="demo-table")["id"]
    answer = admin.post(f"/api/keys/{row.id}/rotate-secret")
    assert answer.status_code == 200
    assert answer.headers["Cache-Control"] == "no-store"
    assert erp.get("/api/me").status_code == 401
    erp.headers["Authorization"] = f"Bearer {answer.json()['secret']}"
    assert erp.post(f"/api/jobs/{job}/cancel").status_code == 200
    store.keys.revoke(row.id)
    assert admin.post(f"/api/keys/{row.id}/rotate-secret").json()["code"] == "key.revoked"


def test_a_key_for_a_customer_sees_and_orders_for_this_customer_only(
    keys: Keys, server: LocalClient
) -> None:
    acme, shop = keys(ORDER, WEBHOOKS, customer="ACME"), keys(ADMIN)
    theirs = upload_drawing(shop, square(), customer="Bolt")["id"]
    foreign = order_job(shop, theirs, machine="demo-table", customer="Bolt")["id"]
    drawing = upload_drawing(acme, square())
    assert drawing["customer"] == "ACME"
    own = order_job(acme, drawing["id"], machine="demo-table")
    assert own["customer"] == "ACME"
    assert {job["id"] for job in acme.get("/api/jobs").json()} == {own["id"]}
    assert {one["id"] for one in acme.get("/api/drawings").json()} == {drawing["id"]}
    assert acme.get("/api/history").json() == []
    paths = ["", "/events", "/program", "/verdict", "/toolpath", "/tracks", "/confirmation"]
    paths += ["/earlier-exceptions", "/xjdf", "/xjmf", "/export"]
    unknown = shop.get("/api/jobs/none").json()
    for path in paths:
        answer = acme.get(f"/api/jobs/{foreign}{path}")
        assert answer.status_code == 404, path
    found = acme.get(f"/api/jobs/{foreign}").json()
    assert found["code"] == unknown["code"]
    for path in ("", "/edges", "/picture", "/import-report", "/cleaning", "/blanks", "/file"):
        assert acme.get(f"/api/drawings/{theirs}{path}").status_code == 404, path
    refused = refusals(
        acme,
        ("PATCH", f"/api/jobs/{foreign}", {"notes": "x"}),
        ("POST", f"/api/jobs/{foreign}/cancel", None),
        ("POST", f"/api/jobs/{foreign}/release", None),
        ("PATCH", f"/api/drawings/{theirs}", {"notes": "x"}),
        ("DELETE", f"/api/drawings/{theirs}", None),
        ("POST", "/api/jobs", {"drawing": theirs, "board": "e-flute"}),
        ("POST", "/api/jobs", {"drawing": drawing["id"], "board": "e-flute", "customer": "Bolt"}),
        ("PATCH", f"/api/jobs/{own['id']}", {"customer": "Bolt"}),
        ("PATCH", f"/api/drawings/{drawing['id']}", {"customer": None}),
        ("GET", "/api/statistics", None),
        ("GET", "/metrics", None),
    )
    assert refused == [404] * 6 + [403] * 5
    queue(server, foreign)
    queue(server, own["id"])
    places = acme.get("/api/machines/demo-table/queue").json()["entries"]
    assert [entry["job"]["id"] for entry in places] == [own["id"]]
    assert not any("Bolt" in one["name"] for one in acme.get("/api/profiles").json())
    for job in (foreign, own["id"]):
        assert shop.post(f"/api/jobs/{job}/cancel").status_code == 200


def test_the_events_and_webhooks_of_a_limited_key_are_those_of_its_customer(
    keys: Keys, server: LocalClient
) -> None:
    acme, shop = keys(ORDER, WEBHOOKS, customer="ACME"), keys(ADMIN)
    hook = acme.post("/api/webhooks", json=HOOK).json()["id"]
    newest = server.service.store.events.last_id()
    theirs = upload_drawing(shop, square(), customer="Bolt")["id"]
    order_job(shop, theirs, machine="demo-table", customer="Bolt")
    drawing = upload_drawing(acme, square())["id"]
    own = order_job(acme, drawing, machine="demo-table")["id"]
    subjects = []
    with acme.stream("GET", f"/api/events?after={newest}") as stream:
        for line in stream.iter_lines():
            if line.startswith("data: {") and '"id"' in line:
                subjects.append(json.loads(line.removeprefix("data: "))["id"])
            if own in subjects:
                break
    assert set(subjects) == {drawing, own}
    sent = acme.get(f"/api/webhooks/{hook}/deliveries").json()
    assert [one["subject"] for one in sent] == [own]


def test_a_key_manages_its_own_webhooks_only(keys: Keys) -> None:
    first, second, admin = keys(WEBHOOKS), keys(WEBHOOKS), keys(ADMIN)
    own = first.post("/api/webhooks", json=HOOK).json()["id"]
    assert [one["id"] for one in first.get("/api/webhooks").json()] == [own]
    assert second.get("/api/webhooks").json() == []
    for method, path in (
        ("GET", ""),
        ("DELETE", ""),
        ("GET", "/deliveries"),
        ("POST", "/rotate-secret"),
        ("POST", "/test"),
        ("POST", "/replay"),
    ):
        assert second.request(method, f"/api/webhooks/{own}{path}").status_code == 404, path
    assert second.patch(f"/api/webhooks/{own}", json={"active": False}).status_code == 404
    assert own in [one["id"] for one in admin.get("/api/webhooks").json()]
    assert first.delete(f"/api/webhooks/{own}").status_code == 204


def test_a_key_for_a_machine_knows_no_other(keys: Keys) -> None:
    erp, shop = keys(ORDER, STATION, machines=("demo-table",)), keys(ADMIN)
    drawing = upload_drawing(erp, square())["id"]
    names = [one["name"] for one in shop.get("/api/machines").json()]
    other = next(name for name in names if name != "demo-table")
    assert [one["name"] for one in erp.get("/api/machines").json()] == ["demo-table"]
    assert {one["machine"] for one in erp.get("/api/tools").json()} == {"demo-table"}
    order = {"drawing": drawing, "board": "e-flute", "machine": other}
    refused = erp.post("/api/jobs", json=order)
    assert (refused.status_code, refused.json()["code"]) == (403, "key.other-machine")
    job = shop.post("/api/jobs", json=order).json()["id"]
    assert erp.get(f"/api/jobs/{job}").status_code == 404
    for path in ("", "/queue", "/station", "/tools", "/definition"):
        assert erp.get(f"/api/machines/{other}{path}").status_code == 404, path
    body = {"operation": "home"}
    assert erp.post(f"/api/machines/{other}/operations", json=body).status_code in (403, 404)


def test_the_key_of_a_gateway_is_bound_to_its_machine_and_reads_what_it_claimed(
    keys: Keys, server: LocalClient
) -> None:
    shop, table, other = keys(ADMIN), keys(GATEWAY), keys(GATEWAY, machines=("router-table",))
    claim = {"gateway": "g", "machine": "demo-table", "wait": 0}
    assert table.post("/api/gateway/claim", json=claim).status_code == 204
    assert table.get("/api/me").json()["machines"] == ["demo-table"]
    elsewhere = {**claim, "machine": "router-table"}
    for key, body in ((table, elsewhere), (other, claim)):
        answer = key.post("/api/gateway/claim", json=body)
        assert (answer.status_code, answer.json()["code"]) == (403, "key.other-machine")
    drawing = upload_drawing(shop, square())["id"]
    job = order_job(shop, drawing, machine="demo-table")["id"]
    queue(server, job)
    claimed = table.post("/api/gateway/claim", json=claim).json()
    assert claimed["job"] == job
    program = f"/api/gateway/program/{job}"
    # 409: this job has no program; the key may read it.
    assert table.get(program).status_code == 409
    assert other.get(program).status_code == 404
    again = keys(GATEWAY, machines=("demo-table",))
    assert again.get(program).json()["code"] == "gateway.not-claimed"
    assert table.get(f"/api/jobs/{job}/program").status_code == 403
    beat = {"job": job, "epoch": claimed["epoch"], "line": 0, "copies_done": 0, "held": True}
    assert other.post("/api/gateway/heartbeat", json=beat).status_code == 404
    assert shop.post(f"/api/jobs/{job}/cancel").status_code == 200


def test_the_first_claim_of_an_unbound_key_waits_for_a_job(keys: Keys, server: LocalClient) -> None:
    shop, table = keys(ADMIN), keys(GATEWAY)
    drawing = upload_drawing(shop, square())["id"]
    job = order_job(shop, drawing, machine="v-groove-table")["id"]
    claim = {"gateway": "g", "machine": "v-groove-table", "wait": 30}
    with ThreadPoolExecutor(1) as threads:
        answer = threads.submit(table.post, "/api/gateway/claim", json=claim)
        wait_until(lambda: table.get("/api/me").json()["machines"] == ["v-groove-table"])
        queue(server, job)
        claimed = answer.result(60.0)
    assert (claimed.status_code, claimed.json()["job"]) == (200, job)


def test_a_waiting_claim_of_a_revoked_key_gets_no_job(keys: Keys, server: LocalClient) -> None:
    shop, table = keys(ADMIN), keys(GATEWAY)
    claim = {"gateway": "g", "machine": "router-table", "wait": 30}
    drawing = upload_drawing(shop, square())["id"]
    job = order_job(shop, drawing, machine="router-table")["id"]
    with ThreadPoolExecutor(1) as threads:
        answer = threads.submit(table.post, "/api/gateway/claim", json=claim)
        wait_until(lambda: table.get("/api/me").json()["machines"] == ["router-table"])
        shop.delete(f"/api/keys/{id_of(table)}").raise_for_status()
        queue(server, job)
        assert answer.result(60.0).status_code == 204


def id_of(client: httpx.Client) -> str:
    """Return the id of the key of a client."""
    return client.headers["Authorization"].split("_")[1]


def wait_until(is_true: Callable[[], bool]) -> None:
    deadline = time.monotonic() + 120.0
    while not is_true():
        assert time.monotonic() < deadline
        time.sleep(0.02)


def test_a_designer_does_not_change_the_drawing_of_another_unless_it_is_shared(
    keys: Keys, server: LocalClient
) -> None:
    anna, carl, shop = keys(DESIGNER), keys(DESIGNER), keys(AccessScope.OPERATOR)
    drawing = upload_drawing(anna, square())
    assert drawing["owner"] == anna.get("/api/me").json()["account"] != ""
    path = f"/api/drawings/{drawing['id']}"
    override = {"overrides": [{"type": "crease", "edges": [0]}]}
    requests = (
        ("PATCH", path, {"unit": "in"}),
        ("PATCH", path, {"shared": True}),
        ("PATCH", f"{path}/edges", override),
        ("DELETE", path, None),
    )
    assert refusals(carl, *requests) == [403] * 4
    assert carl.patch(path, json={"unit": "in"}).json()["code"] == "drawing.of-another"
    assert carl.get(path).status_code == 200
    assert anna.patch(path, json={"shared": True}).json()["shared"] is True
    assert refusals(carl, *requests[:3]) == [200] * 3
    assert anna.patch(path, json={"shared": False}).json()["shared"] is False
    assert carl.delete(path).status_code == 403
    assert shop.delete(path).status_code == 204
    # A drawing of the time before there were accounts has no owner and stays open.
    open_one = upload_drawing(anna, square())["id"]
    with server.service.store.database.writing() as session:
        session.execute(sa.update(Drawing).where(Drawing.id == open_one).values(owner=""))
    assert carl.patch(f"/api/drawings/{open_one}", json={"notes": "x"}).status_code == 200


def test_limits_that_a_scope_cannot_have_are_refused(keys: Keys) -> None:
    admin = keys(ADMIN)
    for body, place in (
        ({"scopes": ["operator"], "customer": "ACME"}, "customer"),
        ({"scopes": ["gateway"], "customer": "ACME"}, "customer"),
        ({"scopes": ["order", "admin"], "machines": ["demo-table"]}, "machines"),
    ):
        answer = admin.post("/api/keys", json={"title": "t", **body})
        assert (answer.status_code, answer.json()["source"]) == (422, [place])
    unknown = admin.post(
        "/api/keys", json={"title": "t", "scopes": ["order"], "machines": ["none"]}
    )
    assert unknown.status_code == 404
    made = admin.post(
        "/api/keys",
        json={"title": "t", "scopes": ["order"], "customer": "A", "machines": ["demo-table"]},
    ).json()
    assert (made["customer"], made["machines"], made["any_machine"]) == ("A", ["demo-table"], False)
