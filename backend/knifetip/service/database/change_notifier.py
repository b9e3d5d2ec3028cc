"""Notifies threads and coroutines of changes of jobs, drawings and machines.

    with changes.subscribed(event.set, RECEIVED): event.wait(changes.poll(1.0))

A change has topics, so that it wakes only the subscribers that it concerns: ``machine_topic`` for
the queue of a machine, ``RECEIVED`` for jobs that wait for a compile, and ``ALL`` for all
subscribers.

Changes that other processes make on the same database arrive only while a ``ProcessLink``
is connected to PostgreSQL.  Otherwise, and in case a notification is lost, subscribers
query the database at intervals.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Collection, Iterator
from contextlib import contextmanager
from typing import Final

ALL: Final = "*"  #: topic of a change that concerns all subscribers
WEBHOOK: Final = "webhook"  #: topic of a delivery of a webhook that is due
RECEIVED: Final = "received"  #: topic of a change of a job that waits for a compile

#: Seconds between two queries of a process to which all other processes send their changes.
_NET: Final = 10.0


def machine_topic(machine: str) -> str:
    """Return the topic of changes of the jobs of a machine."""
    return f"machine {machine}"


class ChangeNotifier:
    """The functions that are called after each transaction that changed a job or a drawing."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._callbacks: list[tuple[Callable[[], object], frozenset[str]]] = []
        #: passes the topics of a change on to other processes; None if they are not notified
        self.send: Callable[[Collection[str]], object] | None = None
        self.connected = False  #: whether changes of other processes arrive

    def poll(self, seconds: float) -> float:
        """Return the time between two queries for changes of other processes (s).

        Parameters
        ----------
        seconds
            The time if notifications of other processes do not arrive.
        """
        return max(seconds, _NET) if self.connected else seconds

    @contextmanager
    def subscribed(self, callback: Callable[[], object], *topics: str) -> Iterator[None]:
        """Return a context in which ``callback()`` is called after each change with some topics.

        The callback is called on the thread that made the change, or that was notified of it.

        Parameters
        ----------
        callback
            Function that returns immediately and raises nothing.
        *topics
            Topics of the changes; none for all changes.
        """
        entry = callback, frozenset(topics)
        with self._lock:
            self._callbacks.append(entry)
        try:
            yield
        finally:
            with self._lock:
                self._callbacks.remove(entry)

    def notify(self, topics: Collection[str] = (ALL,)) -> None:
        """Call the callbacks for a change that this process made, and notify other processes."""
        self.receive(topics)
        if self.send is not None:
            self.send(topics)

    def receive(self, topics: Collection[str]) -> None:
        """Call the callbacks for a change of any process."""
        with self._lock:
            entries = list(self._callbacks)
        for callback, wanted in entries:
            if not wanted or ALL in topics or not wanted.isdisjoint(topics):
                callback()
