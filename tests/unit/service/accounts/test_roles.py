"""Every operation of the API × every sender: which are refused, and with which status."""

from __future__ import annotations

import re
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import httpx
import pytest

from knifetip.service.accounts import access
from knifetip.service.http.routing import ScopedOperation, scoped_operations
from knifetip.service.http.scopes import AccessScope
from knifetip.service.settings import Settings
from tests.support.serving.server import (
    LocalClient,
    order_job,
    run_server,
    square,
    upload_drawing,
)

pytestmark = pytest.mark.xdist_group("roles")

#: Least role that may send each request, copied manually from the decision about accounts.
LEAST = {
    "viewer": """
        list_drawings get_drawing get_edges get_picture get_import_report get_cleaning get_file
        export_drawing list_pages get_blanks list_layouts get_layout list_cartons get_carton_picture
        list_test_pieces get_test_piece_picture
        list_stock_sheets list_jobs list_orders get_job get_job_events get_verdict get_toolpath
        get_earlier_exceptions export_toolpath get_section get_ticket export_job get_folding
        get_folding_file get_nesting get_registration
        get_confirmation get_queue get_tracks list_history get_statistics get_events
        list_machines get_machine get_station get_operation list_machine_tools list_tool_events
        list_formats list_boards get_board list_tools list_library get_schema
        list_machine_versions list_board_versions list_tool_versions
        list_customer_answers list_profiles export_profile get_profile change_own_password
        get_program get_machine_definition export_machine get_board_definition export_board
        get_tool_definition export_tool get_me status get_job_status_as_xjmf get_job_as_xjdf
        get_metrics
    """,
    "designer": """
        upload_drawing choose_page change_drawing delete_drawing override_edges order_job
        add_layout draw_carton_as_drawing change_layout delete_layout accept_shortfalls
        begin_nesting stop_nesting delete_nesting
        add_stock_sheets change_stock_sheets delete_stock_sheets
        draw_test_piece evaluate_test_piece
        recompile_job cancel_job calibrate keep_profile delete_profile preview_profile
        learn_from_corrections use_customer_answer order_by_xjdf answer_xjmf place_order_with_file
        place_orders
    """,
    "operator": """
        release_job recheck_job confirm_job hold_job resume_job confirm_end finish_job requeue_job
        scrap_job move_job change_job transfer_job continue_job ask_for_operation record_tool_change
        set_tool_life state_hands_clear withdraw_hands_clear renew_jog
        fit_registration register_job
    """,
    "admin": """
        save_machine delete_machine save_board delete_board save_tool delete_tool
        add_webhook list_webhooks get_webhook change_webhook delete_webhook rotate_webhook_secret
        test_webhook list_webhook_deliveries get_webhook_delivery replay_dead_letters
        replay_webhook_delivery
        list_users create_user change_user list_keys create_key rotate_key_secret revoke_key
        list_audit create_pairing_code list_devices
    """,
    "nobody": "claim get_gateway_program heartbeat finish report_station",
    "everybody": "sign_in sign_out health ready",
}
#: What programs at a machine may do.
GATEWAY = {
    *("claim", "get_gateway_program", "heartbeat", "finish", "report_station"),
    *("get_machine_definition", "export_machine", "get_board_definition", "export_board"),
    *("get_tool_definition", "export_tool", "get_me", "status"),
}
#: What only people with the role and keys with the scope ``station`` may do.
AT_MACHINE = {
    *("confirm_job", "resume_job", "confirm_end", "fit_registration", "register_job"),
    *("ask_for_operation", "state_hands_clear", "withdraw_hands_clear", "renew_jog"),
}
#: What a key with the scope ``station`` may do beside that.
STOPPING = {"hold_job", "cancel_job"}
LEAST_OF = {name: least for least, names in LEAST.items() for name in names.split()}
#: Role whose requests a key with another scope may send, and what it may send beyond these.
ROLE_OF_SCOPE = {"station": "viewer", "read": "viewer", "order": "viewer", "webhooks": "everybody"}
BEYOND = {
    "order": """
        upload_drawing choose_page change_drawing delete_drawing override_edges order_job
        add_layout draw_carton_as_drawing change_layout delete_layout accept_shortfalls
        begin_nesting stop_nesting delete_nesting
        add_stock_sheets change_stock_sheets delete_stock_sheets
        release_job recompile_job cancel_job change_job place_order_with_file place_orders
        order_by_xjdf answer_xjmf
    """,
    "webhooks": """
        add_webhook list_webhooks get_webhook change_webhook delete_webhook rotate_webhook_secret
        test_webhook list_webhook_deliveries get_webhook_delivery replay_dead_letters
        replay_webhook_delivery get_me
    """,
}
RANK = ["everybody", "viewer", "designer", "operator", "admin", "nobody"]
#: Statuses of the access control; others show that a request has passed it.
REFUSALS = {401, 403}
PASSWORD = "four words of text"


def expected(sender: str, operation: str) -> int | None:
    """Return the status with which an operation is refused; None if it is not."""
    least = LEAST_OF[operation]
    if sender in ("expired key", "revoked key"):
        # A wrong key is refused everywhere but by probes, which read none.
        return None if operation in ("health", "ready") else 401
    if least == "everybody":
        return None
    if sender in ("none", "disabled user"):
        return 401
    if sender == "gateway":
        return None if operation in GATEWAY else 403
    if sender.endswith(" key") and operation in AT_MACHINE:
        return None if sender == "station key" else 403
    if sender == "station key" and operation in STOPPING:
        return None
    name = sender.split()[0]
    role = ROLE_OF_SCOPE.get(name, name)
    if operation in BEYOND.get(name, "").split():
        return None
    return None if RANK.index(role) >= RANK.index(least) else 403


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[LocalClient]:
    folder = tmp_path_factory.mktemp("roles")
    settings = Settings(database=f"sqlite:///{folder}/a.sqlite", compiles=False, page=folder)
    patch = pytest.MonkeyPatch()
    patch.setattr(access, "WRONG_KEY_DELAY", 0.0)
    with run_server(settings) as client:
        yield client
    patch.undo()


@pytest.fixture(scope="module")
def values(server: LocalClient) -> dict[str, Any]:
    """Return ids of a drawing, a job, and names of other objects that exist."""
    drawing = upload_drawing(server, square())["id"]
    job = order_job(server, drawing, machine="demo-table")["id"]
    return {"drawings": drawing, "jobs": job}


@pytest.fixture(scope="module")
def senders(server: LocalClient, values: dict[str, Any]) -> Iterator[dict[str, httpx.Client]]:
    """Return a client for each sender; the roles both with a session and with a key."""
    assert values
    store = server.service.store
    clients = {"none": client_of(server)}
    store.users.add("boss", PASSWORD, AccessScope.ADMIN)
    for role in ("viewer", "designer", "operator", "admin"):
        store.users.add(role, PASSWORD, AccessScope(role))
        clients[f"{role} session"] = client_of(server)
        sent = {"name": role, "password": PASSWORD}
        assert clients[f"{role} session"].post("/api/session", json=sent).status_code == 200
    for scope in AccessScope:
        name = "gateway" if scope == "gateway" else f"{scope} key"
        clients[name] = client_of(server, store.keys.add(name, [scope])[1])
    expired, secret = store.keys.add("expired", [*AccessScope], store.database.clock() + 1e6)
    with store.database.writing() as session:
        expired.expires = store.database.clock() - 1.0
        session.merge(expired)
    clients["expired key"] = client_of(server, secret)
    revoked, secret = store.keys.add("revoked", [*AccessScope])
    store.keys.revoke(revoked.id)
    clients["revoked key"] = client_of(server, secret)
    store.users.add("former", PASSWORD, AccessScope.ADMIN)
    clients["disabled user"] = client_of(server)
    sent = {"name": "former", "password": PASSWORD}
    assert clients["disabled user"].post("/api/session", json=sent).status_code == 200
    store.users.change("former", active=False)
    store.users.add("spare", PASSWORD, AccessScope.VIEWER)
    # The server detects within a second that another program has made an administrator.
    deadline = time.monotonic() + 120.0
    while clients["none"].get("/api/jobs").status_code != 401:
        assert time.monotonic() < deadline
        time.sleep(0.05)
    yield clients
    for client in clients.values():
        client.close()


def client_of(server: LocalClient, key: str = "") -> httpx.Client:
    headers = {"X-Knifetip": "test", **({"Authorization": f"Bearer {key}"} if key else {})}
    return httpx.Client(base_url=server.base_url, trust_env=False, timeout=30.0, headers=headers)


def path_of(operation: ScopedOperation, values: dict[str, Any]) -> str:
    """Return the path of an operation with ids and names of objects that exist."""
    group = operation.path.split("/")[2] if operation.path.startswith("/api/") else ""
    names = {"machines": "demo-table", "boards": "e-flute", "profiles": "default", "users": "spare"}
    given = {
        "id": values["jobs"] if "gateway" in operation.path else values.get(group, "none"),
        "name": names.get(group, "none"),
        "code": "fefco-0427",
        "station": "1",
        "page": "1",
        "kind": "machines",
        "delivery": "none",
    }
    return re.sub(r"\{(\w+)\}", lambda part: given[part[1]], operation.path)


def status_of(client: httpx.Client, method: str, path: str) -> int:
    """Return the status of a response; its body may have no end."""
    # Invalid bodies: what is permitted is then refused by other checks and changes nothing.
    body = None if method in ("GET", "DELETE") else {"none": True}
    with client.stream(method, path, json=body) as answer:
        return answer.status_code


def operations(server: LocalClient) -> list[ScopedOperation]:
    return list(scoped_operations(server.app.routes))


def test_each_operation_has_a_row(server: LocalClient) -> None:
    names = [operation.name for operation in operations(server)]
    assert len(names) == len(set(names))
    assert set(names) == set(LEAST_OF)


def test_each_operation_refuses_each_sender_without_its_scope(
    server: LocalClient, senders: dict[str, httpx.Client], values: dict[str, Any]
) -> None:
    wrong = []
    checked = 0
    for sender, client in senders.items():
        for operation in operations(server):
            # These would end the session or the life of what the other requests use.
            if (
                operation.name in ("sign_out", "delete_drawing")
                and expected(sender, operation.name) is None
            ):
                continue
            path = path_of(operation, values)
            found = status_of(client, operation.method, path)
            should = expected(sender, operation.name)
            # 401 of a sign-in without a password would be 422 here: the body is invalid.
            right = found == should if should else found not in REFUSALS and found < 500
            checked += 1
            if not right:
                wrong.append((sender, operation.method, path, found, should))
    assert wrong == []
    assert checked > 1000


def test_the_expectation_can_fail(server: LocalClient, senders: dict[str, httpx.Client]) -> None:
    assert status_of(senders["viewer key"], "GET", "/api/users") == 403
    assert status_of(senders["admin key"], "GET", "/api/users") == 200
    assert status_of(senders["admin key"], "POST", "/api/gateway/claim") == 403
    assert status_of(senders["gateway"], "POST", "/api/gateway/claim") == 422
    assert expected("viewer key", "list_users") == 403
    assert expected("admin session", "claim") == 403
    assert expected("gateway", "list_jobs") == 403


def test_nothing_but_the_probes_is_served_without_a_principal(
    server: LocalClient, senders: dict[str, httpx.Client]
) -> None:
    for path in ("/", "/api/openapi.json", "/api/v1/openapi.json", "/api/nothing", "/assets/x.js"):
        assert status_of(senders["none"], "GET", path) == 401, path
    for path in ("/healthz", "/readyz"):
        assert status_of(senders["none"], "GET", path) in (200, 503)


def test_secrets_are_not_in_the_log(
    server: LocalClient,
    senders: dict[str, httpx.Client],
    caplog: pytest.LogCaptureFixture,
    capfd: pytest.CaptureFixture[str],
    tmp_path: Path,
) -> None:
    secret, password = "kt_abcdefghij_" + "S3cret" * 8, "Pa55word-never-logged"
    with caplog.at_level("DEBUG"), client_of(server, secret) as keyed, client_of(server) as client:
        for path in ("/api/jobs", "/", f"/?key={secret}", "/api/none", "/api/gateway/claim"):
            keyed.get(path)
            keyed.post(path, content=b"{")
            client.get(path, headers={"Accept": "text/html"})
        client.post("/api/session", json={"name": "boss", "password": password})
        client.post("/api/session", content=f'{{"password": "{password}"')
        client.post("/sign-in", data={"name": password, "password": password})
        client.post("/sign-in", data={"key": secret})
        client.cookies.set(f"knifetip-session-{server.base_url.port}", secret)
        client.get("/api/jobs")
        admin = senders["admin key"]
        admin.post("/api/users", json={"name": "new", "password": password, "role": "none"})
        answer = admin.post("/api/users", json={"name": "x" * 99, "password": password})
        made = admin.post("/api/keys", json={"title": "t", "scopes": ["viewer"]}).json()["secret"]
    out, err = capfd.readouterr()
    # The HTTP client of this test logs the URLs that it sends; the server must not.
    own = [one.getMessage() for one in caplog.records if one.name.split(".")[0] == "knifetip"]
    logged = out + err + "\n".join(own)
    assert answer.status_code == 422
    for hidden in (secret, password, made):
        assert hidden not in logged
        assert hidden not in answer.text
    entries = admin.get("/api/audit?limit=500").text
    for hidden in (secret, password, made):
        assert hidden not in entries
