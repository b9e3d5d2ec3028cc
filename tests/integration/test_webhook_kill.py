"""The server is killed while it sends a webhook, and nothing is lost."""

from __future__ import annotations

import sqlite3
import threading
from pathlib import Path

import pytest

from tests.support.serving.server import Running, square, upload_drawing
from tests.support.serving.webhook_receiver import Call, run_receiver

pytestmark = pytest.mark.xdist_group("kill")


def test_killed_between_sending_and_storing_it_sends_again(tmp_path: Path) -> None:
    database = tmp_path / "shop.sqlite"
    killed = threading.Event()
    with run_receiver() as receiver:
        first = Running(database, processes=1, simulator=False)
        added = first.client.post("/api/webhooks", json={"url": receiver.url}).json()

        def answer_late(_call: Call) -> tuple[int, dict[str, str]]:
            killed.wait(30.0)
            return 204, {}

        receiver.answer = answer_late
        drawing = upload_drawing(first.client, square())["id"]
        receiver.wait(lambda calls: len(calls) == 1)
        first.kill()
        killed.set()
        # The lease of the killed sender, which a test does not wait for.
        with sqlite3.connect(database) as connection:
            leased = connection.execute("UPDATE webhook_delivery SET lease = 0 WHERE lease > 0")
            assert leased.rowcount == 1
        connection.close()
        with Running(database, processes=1, simulator=False):
            lost, again, *_ = receiver.wait(lambda calls: len(calls) >= 2)
        assert again.id == lost.id
        assert again.body == lost.body
        assert again.payload["data"]["drawing"]["id"] == drawing
        again.verify(added["secret"])
