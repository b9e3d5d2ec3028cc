"""A stream of events ends with the session or the key of its client."""

from __future__ import annotations

import queue
import threading
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path

import httpx

from knifetip.service.accounts import session_store
from knifetip.service.database.account_tables import ApiKey, BrowserSession
from knifetip.service.http.scopes import AccessScope
from knifetip.service.settings import Settings
from knifetip.service.store import Store
from tests.support.serving.server import LocalClient, run_server, square, upload_drawing

PASSWORD = "four words of text"
#: A stream is open for two seconds at most, on a machine that has nothing else to do.
SOON = 60.0


class Listener(threading.Thread):
    """A client that listens to the stream of events until it ends."""

    def __init__(self, client: httpx.Client) -> None:
        super().__init__()
        self._client = client
        self._lines: queue.Queue[str] = queue.Queue()

    def run(self) -> None:
        with self._client.stream("GET", "/api/events", timeout=120.0) as answer:
            for line in answer.iter_lines():
                self._lines.put(line)

    def ends(self) -> bool:
        """Return whether the stream ends soon, as a whole response does."""
        self.join(SOON)
        return not self.is_alive()

    def receives(self, text: str) -> bool:
        """Return whether a line of the stream contains a text soon."""
        try:
            while text not in self._lines.get(timeout=SOON):
                pass
        except queue.Empty:
            return False
        return True


class Visitors:
    """Clients of a server, each with a session or a key of its own."""

    def __init__(self, server: LocalClient, stack: ExitStack) -> None:
        self.server = server
        self.listeners: list[Listener] = []
        self._stack = stack

    def with_key(self, secret: str = "") -> httpx.Client:
        headers = {"X-Knifetip": "test"}
        if secret:
            headers["Authorization"] = f"Bearer {secret}"
        client = httpx.Client(
            base_url=self.server.base_url, trust_env=False, timeout=30.0, headers=headers
        )
        return self._stack.enter_context(client)

    def signed_in(self, name: str) -> httpx.Client:
        client = self.with_key()
        answer = client.post("/api/session", json={"name": name, "password": PASSWORD})
        assert answer.status_code == 200, answer.text
        return client

    def listen(self, client: httpx.Client) -> Listener:
        listener = Listener(client)
        self.listeners.append(listener)
        listener.start()
        assert listener.receives("connected")
        return listener


@contextmanager
def visited(database: str, folder: Path) -> Iterator[Visitors]:
    settings = Settings(database=database, compiles=False, page=folder)
    with ExitStack() as stack:
        server = stack.enter_context(run_server(settings))
        visitors = Visitors(server, stack)
        yield visitors
        server.service.stop()
        assert all(listener.ends() for listener in visitors.listeners)


@contextmanager
def only_session(store: Store) -> Iterator[BrowserSession]:
    """Return the only session, to be read or changed."""
    with store.sessions._db.writing() as session:
        yield session.query(BrowserSession).one()


def test_changes_at_another_server_end_the_streams_of_their_accounts_only(
    database_url: str, tmp_path: Path
) -> None:
    other = Store(database_url)
    other.migrate()
    people = ("disabled", "demoted", "renewed", "kept")
    for name in ("anna", *people):
        other.users.add(name, PASSWORD, AccessScope.ADMIN)
    keys = [other.keys.add(f"key {number}", [AccessScope.VIEWER]) for number in range(3)]
    with visited(database_url, tmp_path) as visitors:
        users = [visitors.listen(visitors.signed_in(name)) for name in people]
        programs = [visitors.listen(visitors.with_key(secret)) for _, secret in keys]
        other.users.change("disabled", active=False)
        other.users.change("demoted", role=AccessScope.VIEWER)
        other.users.change("renewed", password="another long text")
        other.keys.revoke(keys[0][0].id)
        with other.keys._db.writing() as session:
            expired = session.get(ApiKey, keys[1][0].id)
            assert expired is not None
            expired.expires = expired.created
        assert [one.ends() for one in (*users[:-1], *programs[:-1])] == [True] * 5
        drawing = upload_drawing(visitors.signed_in("kept"), square())["id"]
        assert users[-1].receives(drawing)
        assert programs[-1].receives(drawing)
    other.close()


def test_a_sign_out_ends_the_streams_of_its_session_only(tmp_path: Path) -> None:
    with visited(f"sqlite:///{tmp_path}/a.sqlite", tmp_path) as visitors:
        # There was no administrator: then this computer may listen without a session.
        local = visitors.listen(visitors.with_key())
        visitors.server.service.store.users.add("anna", PASSWORD, AccessScope.ADMIN)
        assert local.ends()
        desk, tablet = visitors.signed_in("anna"), visitors.signed_in("anna")
        ended, kept = visitors.listen(desk), visitors.listen(tablet)
        assert desk.delete("/api/session").status_code == 204
        assert ended.ends()
        assert kept.receives(upload_drawing(tablet, square())["id"])


def test_a_waiting_claim_gets_no_job_after_its_key_was_revoked(tmp_path: Path) -> None:
    with visited(f"sqlite:///{tmp_path}/a.sqlite", tmp_path) as visitors:
        store = visitors.server.service.store
        row, secret = store.keys.add("table", [AccessScope.GATEWAY])
        gateway = visitors.with_key(secret)
        claim = {"gateway": "g", "machine": "demo-table", "wait": 60.0}
        answers: list[int] = []
        thread = threading.Thread(
            target=lambda: answers.append(
                gateway.post("/api/gateway/claim", json=claim).status_code
            )
        )
        thread.start()
        while not store.machines.connected_machines(60.0):
            time.sleep(0.02)
        store.keys.revoke(row.id)
        thread.join(SOON)
        assert answers == [204]
        assert gateway.post("/api/gateway/claim", json=claim).status_code == 401


def test_a_session_ends_although_its_page_listens(tmp_path: Path) -> None:
    with visited(f"sqlite:///{tmp_path}/a.sqlite", tmp_path) as visitors:
        store = visitors.server.service.store
        store.users.add("anna", PASSWORD, AccessScope.ADMIN)
        listener = visitors.listen(visitors.signed_in("anna"))
        with only_session(store) as session:
            session.seen -= session_store.IDLE / 2
            before = session.seen
        time.sleep(2.5)  # some checks of the session
        with only_session(store) as session:
            assert session.seen == before
            session.seen -= session_store.IDLE
        assert listener.ends()
