"""A person and an ERP system at a shop that fails: orders, confirmations and decisions."""

from __future__ import annotations

import itertools
import threading
import uuid
from collections import Counter
from typing import Any, Final

import httpx

from tests.failures.shop import SERVERS, Shop
from tests.support.serving.server import square
from tests.support.writers import dxf_text as text

_ACTIVE: Final = ("received", "compiling", "ready", "queued", "running", "held", "interrupted")
_LOOK: Final = 0.3  # seconds between two polls


class Operator(threading.Thread):
    """Keeps tables busy: orders jobs, confirms each sheet, and makes interrupted jobs again.

    Each request is repeated until it is answered, each time at the other server.

    Parameters
    ----------
    shop
        The shop.
    drawings
        Ids of the drawings of which one job each is ordered, with their SHA-256.
    waiting
        Number of jobs of each table that have not ended.
    """

    def __init__(self, shop: Shop, drawings: dict[str, str], waiting: int = 2) -> None:
        super().__init__(daemon=True, name="operator")
        self._waiting = waiting
        self._clients = [shop.client(server) for server in SERVERS]
        self._turns = itertools.cycle(self._clients)
        self._machines = shop.machines
        self._drawings = drawings
        self._left = iter(drawings)
        #: key and drawing of the order of each machine that has no answer yet
        self._unanswered: dict[str, tuple[str, str]] = {}
        self.accepted: dict[str, str] = {}  #: SHA-256 of the drawing of each accepted job
        self.orders = True  #: whether more jobs are ordered
        self.answers: Counter[str] = Counter()  #: HTTP status or error of each request
        self.failure: BaseException | None = None  #: why the thread ended early
        self._end = threading.Event()

    def run(self) -> None:
        """Poll the shop until ``close`` is called."""
        try:
            while not self._end.wait(_LOOK):
                self._look()
        except BaseException as failure:
            self.failure = failure
            raise

    def close(self) -> None:
        """End the thread."""
        self._end.set()
        self.join(30.0)
        for client in self._clients:
            client.close()

    def _send(self, method: str, path: str, **content: Any) -> httpx.Response | None:
        """Send a request once, to one of the servers; return None if it is not answered."""
        try:
            answer = next(self._turns).request(method, path, **content)
        except httpx.HTTPError as error:
            self.answers[type(error).__name__] += 1
            return None
        self.answers[str(answer.status_code)] += 1
        return answer if answer.status_code < 500 else None

    def _look(self) -> None:
        query = [("state", state) for state in _ACTIVE]
        answer = self._send("GET", "/api/jobs", params=[*query, ("limit", "100")])
        if answer is None:
            return
        jobs = answer.raise_for_status().json()
        for job in jobs:
            self._attend(job)
        if not self.orders:
            return
        for machine in self._machines:
            if sum(job["machine"] == machine for job in jobs) < self._waiting:
                self._order(machine)

    def _attend(self, job: dict[str, Any]) -> None:
        path = f"/api/jobs/{job['id']}"
        if job["waiting_for"] in ("confirmation", "sheet"):
            self._confirm(path)
        elif job["state"] == "interrupted":
            self._send("POST", f"{path}/requeue")
        elif job["state"] == "held":
            self._send("POST", f"{path}/resume", json={"hands_clear": True})

    def _confirm(self, path: str) -> None:
        """Confirm a job with all its checks."""
        asked = self._send("GET", f"{path}/confirmation")
        if asked is not None and asked.is_success:
            checked = [check["id"] for check in asked.json()["checks"]]
            self._send("POST", f"{path}/confirm", json={"checked": checked, "by": "Mia"})

    def _order(self, machine: str) -> None:
        """Order a job; an order without an answer is repeated with its key."""
        if machine not in self._unanswered:
            drawing = next(self._left, None)
            if drawing is None:
                return
            self._unanswered[machine] = uuid.uuid4().hex, drawing
        key, drawing = self._unanswered[machine]
        order = {"drawing": drawing, "machine": machine, "board": "e-flute", "release": True}
        answer = self._send("POST", "/api/jobs", headers={"Idempotency-Key": key}, json=order)
        if answer is None or answer.status_code == 429:
            return
        assert answer.status_code == 201, answer.text[:500]
        del self._unanswered[machine]
        self.accepted[answer.json()["id"]] = self._drawings[drawing]


def upload_drawings(client: httpx.Client, count: int) -> dict[str, str]:
    """Upload different drawings; return their ids with their SHA-256."""
    found = {}
    for number in range(count):
        files = {"file": ("s.dxf", _slits(60.0 + number))}
        answer = client.post("/api/drawings", files=files, data={"unit": "mm"}, timeout=120.0)
        assert answer.status_code == 201, answer.text[:500]
        found[answer.json()["id"]] = answer.json()["sha256"]
    return found


def _slits(side: float) -> bytes:
    """Return a drawing of a square with ten slits, which is another one for each side (mm)."""
    slits = [
        text.line(10.0, 10.0 + 4.0 * row, side - 10.0, 10.0 + 4.0 * row, (8, "CUT"))
        for row in range(10)
    ]
    return square(side=side, extra=tuple(slits))
