"""Changes wake the subscribers that they concern."""

from __future__ import annotations

from collections.abc import Collection

from knifetip.service.database.change_notifier import ALL, RECEIVED, ChangeNotifier, machine_topic


def test_a_change_calls_the_subscribers_of_its_topic_and_of_all() -> None:
    changes, calls = ChangeNotifier(), []
    with (
        changes.subscribed(lambda: calls.append("all")),
        changes.subscribed(lambda: calls.append("table"), machine_topic("table")),
        changes.subscribed(lambda: calls.append("received"), RECEIVED),
    ):
        changes.notify([machine_topic("table")])
        assert calls == ["all", "table"]
        changes.notify([RECEIVED, machine_topic("other")])
        assert calls == ["all", "table", "all", "received"]
        changes.notify([ALL])
        assert calls[4:] == ["all", "table", "received"]
    changes.notify()
    assert len(calls) == 7


def test_only_own_changes_are_sent_to_other_processes() -> None:
    changes = ChangeNotifier()
    sent: list[Collection[str]] = []
    changes.send = sent.append
    changes.receive([RECEIVED])
    changes.notify([RECEIVED])
    assert sent == [[RECEIVED]]


def test_a_notified_process_queries_seldom() -> None:
    changes = ChangeNotifier()
    assert changes.poll(0.5) == 0.5
    changes.connected = True
    assert changes.poll(0.5) == 10.0
    assert changes.poll(60.0) == 60.0
