"""Who gets in: the addresses of a server without an administrator, and the key of a gateway."""

from __future__ import annotations

import sys
import time
from collections.abc import Iterator
from pathlib import Path

import httpx
import pytest

from knifetip.service.http.scopes import AccessScope
from knifetip.service.store import Store
from tests.support.serving.commands import running, served

PASSWORD = "four words of text"
LOOPBACK = "0100007F"  # 127.0.0.1 in /proc/net/tcp


@pytest.fixture
def store(tmp_path: Path) -> Iterator[Store]:
    opened = Store(f"sqlite:///{tmp_path}/a.sqlite")
    opened.migrate()
    yield opened
    opened.close()


def listening(url: str) -> set[str]:
    """Return the addresses, as in /proc/net/tcp, on which a port is listening."""
    port = f"{int(url.rpartition(':')[2]):04X}"
    rows = [row.split() for row in Path("/proc/net/tcp").read_text().splitlines()[1:]]
    local = [row[1].split(":") for row in rows if row[3] == "0A"]
    return {address for address, number in local if number == port}


@pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")
def test_without_an_administrator_a_server_listens_on_loopback_only(
    store: Store, tmp_path: Path
) -> None:
    database = f"sqlite:///{tmp_path}/a.sqlite"
    with served(database, "--host", "0.0.0.0") as (server, url):
        server.said("ERROR: not listening on 0.0.0.0")
        server.said("knifetip user add NAME --role admin")
        server.said("--key-file PATH")
        assert listening(url) == {LOOPBACK}
        assert httpx.get(f"{url}/api/jobs", trust_env=False).status_code == 200
    with served(database, "--host", "0.0.0.0", "--key-file", tmp_path / "key") as (_, url):
        assert listening(url) == {"00000000"}
    store.users.add("anna", PASSWORD, AccessScope.ADMIN)
    with served(database, "--host", "0.0.0.0") as (server, url):
        assert listening(url) == {"00000000"}
        assert httpx.get(f"{url}/api/jobs", trust_env=False).status_code == 401
        assert not [line for line in server.lines if "ERROR" in line]


def test_a_gateway_works_with_its_key_file_only(store: Store, tmp_path: Path) -> None:
    store.users.add("anna", PASSWORD, AccessScope.ADMIN)
    right, wrong = tmp_path / "gateway", tmp_path / "erp"
    right.write_text(store.keys.add("table", [AccessScope.GATEWAY])[1])
    wrong.write_text(store.keys.add("ERP", [AccessScope.ADMIN])[1])
    with (
        served(f"sqlite:///{tmp_path}/a.sqlite") as (_, url),
        running("simulator", "--port", 0) as table,
    ):
        address = table.said(r"127\.0\.0\.1:\d+")
        words = ("gateway", "--server", url, "--controller", address, "--journal", tmp_path / "j")
        with running(*words, "--key-file", wrong) as refused:
            # The gateway goes on asking: an administrator can still correct the scopes.
            refused.said(r"scope \W*gateway\b")
        assert not store.machines.connected_machines(60.0)
        with running(*words, "--key-file", right):
            deadline = time.monotonic() + 120.0
            while not store.machines.connected_machines(60.0):
                assert time.monotonic() < deadline
                time.sleep(0.05)
