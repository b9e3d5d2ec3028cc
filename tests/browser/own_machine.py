"""A machine with a gateway that the test plays over REST: nothing moves."""

from __future__ import annotations

import time
from typing import Any

import httpx

from knifetip.dxf.samples import samples
from tests.support.serving.server import confirm_job

DRAWING = "rigid-box-blank.dxf"
BOARD = "greyboard-2.0"
FINAL = ("done", "refused", "scrapped", "continued", "cancelled")


class OwnMachine:
    """A copy of the demonstration table on a server, and its gateway.

    Parameters
    ----------
    api
        Client of the server.
    name
        Name of the machine, which no other test uses.
    """

    def __init__(self, api: httpx.Client, name: str) -> None:
        self.api, self.name, self.title = api, name, name.capitalize()
        fields = api.get("/api/machines/demo-table/definition").json()["fields"]
        answer = api.put(f"/api/machines/{name}", json={**fields, "title": self.title})
        assert answer.status_code == 201, answer.text
        self.drawing = self.upload(DRAWING)

    def upload(self, name: str) -> str:
        """Upload a sample drawing under a name, and return its id."""
        files = {"file": (name, samples()[DRAWING])}
        return str(self.api.post("/api/drawings", files=files).json()["id"])

    def order(self, drawing: str = "", copies: int = 1, state: str = "queued") -> str:
        """Order a job, and return its id when it is queued."""
        order = {"drawing": drawing or self.drawing, "machine": self.name, "board": BOARD}
        answer = self.api.post("/api/jobs", json={**order, "copies": copies, "release": True})
        assert answer.status_code in (201, 202), answer.text
        id = str(answer.json()["id"])
        self.wait(id, state)
        return id

    def job(self, id: str) -> dict[str, Any]:
        found: dict[str, Any] = self.api.get(f"/api/jobs/{id}").json()
        return found

    def wait(self, id: str, state: str, seconds: float = 60.0) -> dict[str, Any]:
        """Wait until a job has a state, and return the job."""
        deadline = time.monotonic() + seconds
        while (job := self.job(id))["state"] != state:
            assert time.monotonic() < deadline, job
            assert job["state"] not in ("refused", "scrapped"), job
            time.sleep(0.05)
        return job

    def queue(self) -> list[str]:
        """Return the ids of the jobs in the queue, in the order in which they run."""
        entries = self.api.get(f"/api/machines/{self.name}/queue").json()["entries"]
        return [entry["job"]["id"] for entry in entries]

    def clear(self) -> None:
        """End all jobs of the machine."""
        for job in self.api.get("/api/jobs").json():
            if job["machine"] == self.name and job["state"] not in FINAL:
                self.wait_compiled(job["id"])
                for action in ("cancel", "scrap"):
                    self.api.post(f"/api/jobs/{job['id']}/{action}")

    def wait_compiled(self, id: str) -> None:
        """Wait until a job is no longer being compiled."""
        deadline = time.monotonic() + 60.0
        while self.job(id)["state"] in ("received", "compiling"):
            assert time.monotonic() < deadline, id
            time.sleep(0.05)

    def claim(self) -> dict[str, Any]:
        """Claim the next job of the machine."""
        body = {"gateway": "test", "machine": self.name, "wait": 5.0}
        claim: dict[str, Any] = self.api.post("/api/gateway/claim", json=body).json()
        return claim

    def report(self, claim: dict[str, Any], line: int, **more: object) -> None:
        """Report the progress of a claimed job."""
        body = {"job": claim["job"], "epoch": claim["epoch"], "line": line, **more}
        self.api.post("/api/gateway/heartbeat", json=body).raise_for_status()

    def finish(self, claim: dict[str, Any], outcome: str, line: int | None = None) -> None:
        """Report the end of a claimed job."""
        body = {"job": claim["job"], "epoch": claim["epoch"], "outcome": outcome}
        executed = claim["lines"] if line is None else line
        body |= {"line": executed, "line_at_most": executed}
        self.api.post("/api/gateway/finish", json=body).raise_for_status()

    def run(self, outcome: str = "done", line: int | None = None, copies: int = 1) -> str:
        """Order a job, start it and end it at a line; return its id."""
        id = self.order(copies=copies)
        claim = self.claim()
        assert claim["job"] == id
        confirm_job(self.api, id).raise_for_status()
        self.report(claim, line if line is not None else claim["lines"])
        self.finish(claim, outcome, line)
        return id
