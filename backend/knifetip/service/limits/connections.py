"""Limits of connections: time for heads and bodies, and number per client (ADR 84).

uvicorn limits neither, and closes idle connections while clients still use them.  A client that
opens connections and sends nothing, or a byte now and then, would occupy file descriptors until no
gateway can connect.  This module closes such connections.  If too many are open, the one that has
been idle longest is closed for a new one, so that a gateway can connect even if a program at the
same address occupies all places.
"""

from __future__ import annotations

import asyncio
import socket
import struct
import sys
import time
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any, ClassVar

import h11
from uvicorn.protocols.http.h11_impl import STATUS_PHRASES, H11Protocol

from knifetip.messages import Message
from knifetip.service.http.api_version import route_path
from knifetip.service.http.principal import is_refused
from knifetip.service.http.problems import PROBLEM, problem
from knifetip.service.limits.clients import network_of

if sys.platform != "win32":  # which has no such limit
    import resource

_GATEWAY = "/api/gateway/"


@dataclass(frozen=True, slots=True)
class ConnectionLimits:
    """Limits of the connections to a server."""

    head: float = 15.0  #: seconds in which the head of a request must arrive
    body: float = 30.0  #: seconds in which ``body_bytes`` of a request body must arrive
    body_bytes: int = 16384  #: least bytes of a body in each period of ``body`` seconds
    answer: float = 60.0  #: seconds after which a client that reads no answer is disconnected
    #: seconds after which a connection without a request is closed.  It is longer than the time for
    #: which clients keep one (5 s of httpx, 60 s of nginx): a request that is sent while the server
    #: closes its connection gets no answer, and the client cannot find out whether it was executed.
    idle: float = 75.0
    per_client: int = 256  #: connections of one address, without requests of gateways under way
    total: int = 2048  #: connections of all addresses


class LimitedProtocol(H11Protocol):
    """HTTP connection with limits; ``limited_protocol`` makes a class with its own limits."""

    limits: ClassVar[ConnectionLimits] = ConnectionLimits()

    def __init__(self, *arguments: Any, **named: Any) -> None:
        super().__init__(*arguments, **named)
        self.timeout_keep_alive = self.limits.idle  # type: ignore[assignment]  # any number of s
        self._timer: asyncio.TimerHandle | None = None
        self._waits_for: object = None  # state of h11 for which the timer runs
        self._answer_timer: asyncio.TimerHandle | None = None
        self._received = 0  # bytes since the timer was set
        self._sender = ""  # address of the client, or its network of IPv6
        self._last_active = time.monotonic()

    # override: the signature is that of uvicorn, which is narrower than that of asyncio.
    def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
        """Accept a connection; close an idle one, or refuse this one, if there are too many."""
        super().connection_made(transport)
        self._sender = network_of(self.client[0]) if self.client else ""
        if not self._make_room():
            self._refuse(503, Message("limit.too-many-connections"), {"Retry-After": "5"})
            return
        self._await_head()

    def data_received(self, data: bytes) -> None:
        """Process received bytes, and watch that the rest of the request arrives in time."""
        self._last_active = time.monotonic()
        self._received += len(data)
        super().data_received(data)
        self._watch()

    def on_response_complete(self) -> None:
        """Begin the next request, part of whose head may have arrived already."""
        self._last_active = time.monotonic()
        super().on_response_complete()
        self._watch()

    def connection_lost(self, exc: Exception | None) -> None:
        """End the timers of a connection."""
        self._stop_timer()
        self.resume_writing()
        super().connection_lost(exc)

    def pause_writing(self) -> None:
        """Disconnect a client that reads nothing for too long while the answer waits."""
        super().pause_writing()
        self._answer_timer = self.loop.call_later(self.limits.answer, self._reset)

    def resume_writing(self) -> None:
        """Continue to send the answer."""
        if self._answer_timer is not None:
            self._answer_timer.cancel()
            self._answer_timer = None
        super().resume_writing()

    @property
    def is_idle(self) -> bool:
        """Whether all requests received on this connection have been answered."""
        return self.cycle is None or self.cycle.response_complete

    @property
    def is_counted(self) -> bool:
        """Whether the connection counts for its address: all but gateways' requests under way."""
        if self.is_idle or not route_path(self.scope["path"]).startswith(_GATEWAY):
            return True
        return is_refused(self.scope)  # the answer to a wrong key is delayed

    def _make_room(self) -> bool:
        """Close an idle connection for this one if needed; return False if there is none."""
        others = [one for one in self.connections if isinstance(one, LimitedProtocol)]
        others = [one for one in others if one is not self and not one.transport.is_closing()]
        own = [one for one in others if one._sender == self._sender != "" and one.is_counted]
        if len(own) >= self.limits.per_client:
            return _close_idle(own)
        if len(others) >= self.limits.total:
            return _close_idle(others)
        return True

    def _watch(self) -> None:
        """Set the timer for what the client must send next, unless it runs already."""
        if self.transport.is_closing():
            self._stop_timer()
            return
        state = self.conn.their_state
        if state == h11.IDLE and self.conn.trailing_data[0] and self._waits_for != h11.IDLE:
            self._await_head()
        elif state == h11.SEND_BODY and self._waits_for != h11.SEND_BODY:
            self._await_body()
        elif state not in (h11.IDLE, h11.SEND_BODY):
            self._stop_timer()

    def _await_head(self) -> None:
        self._stop_timer()
        self._waits_for = h11.IDLE
        self._timer = self.loop.call_later(self.limits.head, self._end_slow)

    def _await_body(self) -> None:
        self._stop_timer()
        self._received = 0
        self._waits_for = h11.SEND_BODY
        self._timer = self.loop.call_later(self.limits.body, self._check_body)

    def _check_body(self) -> None:
        # While reading is paused, the client waits for the server and not the reverse.
        if self._received >= self.limits.body_bytes or self.flow.read_paused:
            self._await_body()
        else:
            self._end_slow()

    def _stop_timer(self) -> None:
        if self._timer is not None:
            self._timer.cancel()
        self._timer, self._waits_for = None, None

    def _end_slow(self) -> None:
        self._stop_timer()
        self._refuse(408, Message("limit.too-slow"), {})

    def _reset(self) -> None:
        # Without this option the system would keep the unread bytes and the socket for minutes.
        connection = self.transport.get_extra_info("socket")
        if connection is not None:
            connection.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
        self.transport.abort()

    def _refuse(self, status: int, message: Message, more: dict[str, str]) -> None:
        """Send an error if the answer has not begun, and close the connection."""
        if self.transport.is_closing():
            return
        if self.conn.our_state in (h11.IDLE, h11.SEND_RESPONSE):
            body = bytes(problem(status, message).body)
            headers = {**more, "Content-Type": PROBLEM, "Content-Length": str(len(body))}
            fields = [(name.encode(), value.encode()) for name, value in headers.items()]
            head = h11.Response(
                status_code=status,
                headers=[*fields, (b"Connection", b"close")],
                reason=STATUS_PHRASES[status],
            )
            for event in (head, h11.Data(data=body), h11.EndOfMessage()):
                self.transport.write(self.conn.send(event) or b"")
        if self.cycle is not None and not self.cycle.response_complete:
            self.cycle.disconnected = True
            self.cycle.message_event.set()
        self.transport.close()


def limited_protocol(limits: ConnectionLimits) -> type[LimitedProtocol]:
    """Return a class of uvicorn's HTTP connections with the given limits."""
    return type("LimitedProtocol", (LimitedProtocol,), {"limits": limits})


def _close_idle(connections: Iterable[LimitedProtocol]) -> bool:
    """Close the connection that has been idle longest; return False if none is idle.

    Connections that have never sent a request come first: a gateway's connection between two
    heartbeats is idle too.
    """
    idle = [one for one in connections if one.is_idle]
    if not idle:
        return False
    oldest = min(idle, key=lambda one: (one.cycle is not None, one._last_active))
    oldest.transport.close()
    return True


def raise_file_limit(files: int) -> None:
    """Raise the limit of open files and sockets of this process as far as the system permits."""
    if sys.platform != "win32":
        soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
        wanted = files if hard == resource.RLIM_INFINITY else min(files, hard)
        if soft != resource.RLIM_INFINITY and soft < wanted:
            resource.setrlimit(resource.RLIMIT_NOFILE, (wanted, hard))
