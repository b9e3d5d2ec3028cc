"""A session of PostgreSQL that reserves the name of a process and exchanges notifications.

Other processes are notified after the commit, by a statement of its own: a transaction with NOTIFY
holds a lock of the whole database until its commit is on disk, which would serialize commits.
Changes that are made while a notification is sent share the next one.  A notification that is lost
with its process or its connection is replaced by the periodic queries of the waiting processes.
"""

from __future__ import annotations

import logging
import selectors
import socket
import threading
import time
from collections.abc import Collection
from contextlib import suppress
from typing import Final

import psycopg

from knifetip.errors import StoreError
from knifetip.service.database.change_notifier import ALL, ChangeNotifier

_CHANNEL: Final = "knifetip"
_NAMES: Final = 0x6B6E_6972  # class of PostgreSQL's advisory locks of names
_LARGEST: Final = 7000  # bytes of a notification; PostgreSQL permits 7,999
_PATIENCE: Final = 3.0  # seconds in which the session of a process that was killed must end
_RETRY: Final = 0.25
_AGAIN: Final = (0.2, 5.0)  # least and greatest pause before the next connection (s)
_CHECK: Final = 10.0  # seconds without a notification after which the connection is checked
# The server detects within 20 s that the computer of a process is gone, and frees the name.
_KEEPALIVE: Final = (("idle", 5), ("interval", 5), ("count", 3))

_log = logging.getLogger("knifetip.jobs")


class NameTakenError(Exception):
    """Another running process has the name."""


class PostgresLink:
    """A thread with a session of PostgreSQL; it connects again when its connection is lost.

    Parameters
    ----------
    url
        URL of the database, with the name of its driver.
    changes
        Notifier of this process.
    name
        Name of this process.
    """

    def __init__(self, url: str, changes: ChangeNotifier, name: str) -> None:
        self._url = url.replace("postgresql+psycopg://", "postgresql://", 1)
        self._changes = changes
        self._name = name
        self._lock = threading.Lock()
        self._topics: set[str] = set()
        self._wake_reader, self._wake_writer = socket.socketpair()
        self._wake_reader.setblocking(False)
        self._wake_writer.setblocking(False)
        self._stopping = threading.Event()
        self._thread = threading.Thread(target=self._run, name="notifications", daemon=True)
        self._connection: psycopg.Connection | None = None

    @classmethod
    def try_name(cls, url: str, changes: ChangeNotifier, name: str) -> PostgresLink | None:
        """Return a connected link with a name, None if a running process has it.

        Raises
        ------
        StoreError
            The server cannot be reached.
        """
        link = cls(url, changes, name)
        deadline = time.monotonic() + _PATIENCE
        while True:
            try:
                link._connection = link._connect()
                break
            except NameTakenError:
                # The server detects the end of a killed process after a moment.
                if time.monotonic() >= deadline:
                    link._close_sockets()
                    return None
                time.sleep(_RETRY)
            except psycopg.Error as reason:
                link._close_sockets()
                raise StoreError("database.unreachable", reason=str(reason).strip()) from reason
        changes.send = link.send
        link._thread.start()
        return link

    @property
    def name(self) -> str:
        """Name of this process."""
        return self._name

    def send(self, topics: Collection[str]) -> None:
        """Notify the other processes of a change; returns at once."""
        with self._lock:
            self._topics.update(topics)
        self._wake()

    def close(self) -> None:
        """Send pending notifications, close the session, and release the name."""
        self._changes.send = None
        self._stopping.set()
        self._wake()
        self._thread.join()
        self._close_sockets()

    def _close_sockets(self) -> None:
        self._wake_reader.close()
        self._wake_writer.close()

    def _wake(self) -> None:
        with suppress(OSError):  # it is woken already, or closed
            self._wake_writer.send(b"\0")

    def _connect(self) -> psycopg.Connection:
        connection = psycopg.connect(
            self._url,
            autocommit=True,
            connect_timeout=10,
            tcp_user_timeout=15_000,
            application_name=f"knifetip {self._name}"[:63],
        )
        try:
            for setting, value in _KEEPALIVE:
                connection.execute(f"SET tcp_keepalives_{setting} = {value}")
            self._take_name(connection)
            connection.add_notify_handler(self._receive)
            connection.execute(f"LISTEN {_CHANNEL}")
        except BaseException:
            connection.close()
            raise
        return connection

    def _take_name(self, connection: psycopg.Connection) -> None:
        taken = connection.execute(
            "SELECT pg_try_advisory_lock(%s, hashtext(%s))", (_NAMES, self._name)
        ).fetchone()
        if taken is None or not taken[0]:
            raise NameTakenError

    def _receive(self, notification: psycopg.Notify) -> None:
        if self._connection is None or notification.pid != self._connection.info.backend_pid:
            self._changes.receive(notification.payload.split("\n"))

    def _run(self) -> None:
        pause = _AGAIN[0]
        while True:
            try:
                if self._connection is None:
                    self._connection = self._connect()
                    _log.info("connected to the other processes again")
                pause = _AGAIN[0]
                self._changes.connected = True
                # Changes made while there was no connection were not received.
                self._changes.receive((ALL,))
                self._exchange(self._connection)
            except NameTakenError:
                _log.error("another process has the name %s; give each its own --name", self._name)
            except (psycopg.Error, OSError) as reason:
                if not self._stopping.is_set():
                    _log.warning("no notifications of other processes: %s", str(reason).strip())
            finally:
                self._changes.connected = False
                if self._connection is not None:
                    with suppress(psycopg.Error):  # the connection may be lost
                        self._connection.close()
                    self._connection = None
            if self._stopping.wait(pause):
                return
            pause = min(2.0 * pause, _AGAIN[1])

    def _exchange(self, connection: psycopg.Connection) -> None:
        """Send and receive notifications until this object is closed or the connection is lost."""
        with selectors.DefaultSelector() as selector:
            selector.register(connection.fileno(), selectors.EVENT_READ)
            selector.register(self._wake_reader, selectors.EVENT_READ)
            while True:
                ready = {key.fd for key, _ in selector.select(_CHECK)}
                if self._wake_reader.fileno() in ready:
                    with suppress(BlockingIOError):  # read already
                        self._wake_reader.recv(4096)
                self._send(connection)
                if self._stopping.is_set():
                    # The server ends a session only some time after its connection is closed.
                    connection.execute("SELECT pg_advisory_unlock_all()")
                    return
                if not ready:
                    connection.execute("SELECT 1")
                elif connection.fileno() in ready:
                    self._read(connection)

    def _send(self, connection: psycopg.Connection) -> None:
        with self._lock:
            topics, self._topics = self._topics, set()
        if topics:
            text = "\n".join(sorted(topics))
            payload = text if len(text.encode()) <= _LARGEST else ALL
            try:
                connection.execute("SELECT pg_notify(%s, %s)", (_CHANNEL, payload))
            except psycopg.Error:
                # They are sent by the next connection.
                with self._lock:
                    self._topics |= topics
                raise

    def _read(self, connection: psycopg.Connection) -> None:
        """Receive the notifications that have arrived."""
        connection.pgconn.consume_input()
        while (arrived := connection.pgconn.notifies()) is not None:
            notification = psycopg.Notify(
                arrived.relname.decode(), arrived.extra.decode(), arrived.be_pid
            )
            self._receive(notification)
