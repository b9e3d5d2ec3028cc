"""An endpoint that receives webhooks, as the ERP of a shop would."""

from __future__ import annotations

import base64
import hashlib
import hmac
import http.server
import json
import ssl
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Any

from standardwebhooks import Webhook


@dataclass
class Call:
    """A request that the endpoint received."""

    path: str
    headers: dict[str, str]  #: names in lower case
    body: bytes

    @property
    def id(self) -> str:
        return self.headers["webhook-id"]

    @property
    def payload(self) -> dict[str, Any]:
        payload: dict[str, Any] = json.loads(self.body)
        return payload

    def verify(self, secret: str) -> None:
        """Fail unless the official library and the text of the specification both accept it."""
        Webhook(secret).verify(self.body, self.headers)
        # Standard Webhooks 1.0.0, "Signature scheme": HMAC-SHA256 of id.timestamp.payload.
        key = base64.b64decode(secret.removeprefix("whsec_"))
        text = f"{self.id}.{self.headers['webhook-timestamp']}.".encode() + self.body
        digest = base64.b64encode(hmac.digest(key, text, hashlib.sha256)).decode()
        assert f"v1,{digest}" in self.headers["webhook-signature"].split(" ")


@dataclass
class Receiver:
    """The calls that an endpoint received, and how it answers."""

    url: str = ""
    calls: list[Call] = field(default_factory=list)
    #: returns status and headers of the answer to a call
    answer: Callable[[Call], tuple[int, dict[str, str]]] = lambda _call: (204, {})
    body: bytes = b""  #: of each answer that is not 204

    def wait(self, condition: Callable[[list[Call]], bool], seconds: float = 120.0) -> list[Call]:
        """Wait until the calls meet a condition, and return them."""
        end = time.monotonic() + seconds
        while not condition(self.calls):
            assert time.monotonic() < end, [call.payload["type"] for call in self.calls]
            time.sleep(0.02)
        return list(self.calls)

    def types(self, subject: str) -> list[str]:
        """Return the types of the events of one job, in the order of their arrival."""
        return [
            call.payload["type"]
            for call in list(self.calls)
            if call.payload["data"].get("job", {}).get("id") == subject
        ]


@contextmanager
def run_receiver(port: int = 0, tls: ssl.SSLContext | None = None) -> Iterator[Receiver]:
    """Run an endpoint on loopback, with TLS if there is a context for it."""
    receiver = Receiver()

    class Handler(http.server.BaseHTTPRequestHandler):
        def do_POST(self) -> None:  # name of http.server
            body = self.rfile.read(int(self.headers["content-length"]))
            heads = {name.lower(): value for name, value in self.headers.items()}
            call = Call(self.path, heads, body)
            receiver.calls.append(call)
            status, headers = receiver.answer(call)
            self.send_response(status)
            for name, value in headers.items():
                self.send_header(name, value)
            if status != 204:
                self.send_header("Content-Length", str(len(receiver.body)))
            self.end_headers()
            if status != 204:
                self.wfile.write(receiver.body)

        def log_message(self, *_: object) -> None:
            pass

    server = http.server.ThreadingHTTPServer(("127.0.0.1", port), Handler)
    server.daemon_threads = True
    if tls is not None:
        # The handshake is made by the thread of the connection, with its first read.
        server.socket = tls.wrap_socket(
            server.socket, server_side=True, do_handshake_on_connect=False
        )
    receiver.url = f"http://127.0.0.1:{server.server_address[1]}/hooks?shop=1"
    thread = threading.Thread(target=server.serve_forever, args=(0.05,), daemon=True)
    thread.start()
    try:
        yield receiver
    finally:
        server.shutdown()
        server.server_close()
