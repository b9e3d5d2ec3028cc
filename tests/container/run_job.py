"""Run one job on a running service, from a drawing to the finished job.

    python tests/container/run_job.py http://localhost:8080 [--key KEY]

Waits until the service is ready, uploads a drawing, orders a job on the simulated table, releases
it and waits until it is done. Prints the seconds of each step; exits with 1 if a step fails. Uses
the standard library only, because only the container image may be installed.
"""

from __future__ import annotations

import argparse
import json
import sys
import time
import urllib.error
import urllib.request
import uuid
from typing import Any

BOUNDARY = uuid.uuid4().hex
#: A square of 60 mm (cuts) with a crease through its middle.
LINES = (
    *(("CUT", 0, 0, 60, 0), ("CUT", 60, 0, 60, 60), ("CUT", 60, 60, 0, 60), ("CUT", 0, 60, 0, 0)),
    ("CREASE", 30, 0, 30, 60),
)
ENDS = {"done", "refused", "interrupted", "scrapped", "cancelled"}
#: Field ``waiting_for`` of a job that waits for the operator's confirmation of the sheet.
CONFIRMED_BY_HAND = {"confirmation", "sheet"}


class Service:
    """A REST client of one server."""

    def __init__(self, url: str, key: str) -> None:
        self.url = url
        self.headers = {"Authorization": f"Bearer {key}"} if key else {}
        # A proxy set in the environment cannot reach a container on this machine.
        self.opener = urllib.request.build_opener(urllib.request.ProxyHandler({}))

    def call(self, path: str, body: bytes | None = None, kind: str = "application/json") -> Any:
        """Send a request (POST if there is a body) and return the JSON of the response."""
        headers = {**self.headers, **({} if body is None else {"Content-Type": kind})}
        request = urllib.request.Request(self.url + path, body, headers)
        with self.opener.open(request, timeout=120) as answer:
            return json.load(answer)

    def wait_until_ready(self, seconds: float) -> None:
        """Return when /readyz responds with 200; raise the last failure after ``seconds``."""
        deadline = time.monotonic() + seconds
        while not self.is_ready(time.monotonic() > deadline):
            time.sleep(0.1)

    def is_ready(self, last: bool) -> bool:
        """Return whether /readyz responds with 200; if ``last``, raise the failure instead."""
        try:
            self.call("/readyz")
        except OSError:
            if last:
                raise
            return False
        return True

    def upload(self, name: str, content: bytes) -> Any:
        """Upload a drawing; return the JSON of the response."""
        head = (
            f"--{BOUNDARY}\r\nContent-Disposition: form-data; "
            f'name="file"; filename="{name}"\r\n\r\n'
        )
        body = head.encode() + content + f"\r\n--{BOUNDARY}--\r\n".encode()
        return self.call("/api/drawings", body, f"multipart/form-data; boundary={BOUNDARY}")

    def order(self, drawing: str) -> Any:
        """Order a job for a drawing's id and release it; return the JSON of the response."""
        job = {"drawing": drawing, "machine": "demo-table", "board": "e-flute", "release": True}
        return self.call("/api/jobs", json.dumps(job).encode())

    def wait_for_end(self, job: str, seconds: float) -> Any:
        """Confirm the job when it waits for it; return the job when it has ended or time is up."""
        deadline = time.monotonic() + seconds
        while True:
            found = self.call(f"/api/jobs/{job}")
            if found["state"] in ENDS or time.monotonic() > deadline:
                return found
            if found.get("waiting_for") in CONFIRMED_BY_HAND:
                self.confirm(job)
            time.sleep(0.2)

    def confirm(self, job: str) -> None:
        """Confirm a job with all its checks."""
        checks = self.call(f"/api/jobs/{job}/confirmation")["checks"]
        body = json.dumps({"checked": [check["id"] for check in checks]}).encode()
        self.call(f"/api/jobs/{job}/confirm", body)


def drawing() -> bytes:
    """Return ``LINES`` as a DXF file in millimetres."""
    tags = ["0 SECTION 2 HEADER 9 $ACADVER 1 AC1015 9 $INSUNITS 70 4 0 ENDSEC 0 SECTION 2 ENTITIES"]
    for layer, x0, y0, x1, y1 in LINES:
        tags.append(f"0 LINE 8 {layer} 10 {x0} 20 {y0} 11 {x1} 21 {y1}")
    return "\n".join(" ".join((*tags, "0 ENDSEC 0 EOF")).split(" ")).encode() + b"\n"


def run(service: Service) -> bool:
    """Run a job; print the duration of each step; return whether the job is done."""
    began = time.monotonic()

    def report(step: str) -> None:
        print(f"{time.monotonic() - began:7.2f} s  {step}", flush=True)

    service.wait_until_ready(120)
    report("ready")
    uploaded = service.upload("square.dxf", drawing())
    report(f"drawing {uploaded['id']} read")
    job = service.order(uploaded["id"])
    report(f"job {job['id']} ordered")
    ended = service.wait_for_end(job["id"], 300)
    report(f"job {job['id']} {ended['state']}")
    if ended["state"] != "done":
        print(json.dumps(ended, indent=2), file=sys.stderr)
    return bool(ended["state"] == "done")


def main() -> int:
    """Run a job on the service given on the command line; return the exit code."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n")[0])
    parser.add_argument("url")
    parser.add_argument("--key", default="")
    arguments = parser.parse_args()
    try:
        return 0 if run(Service(arguments.url.rstrip("/"), arguments.key)) else 1
    except urllib.error.HTTPError as refused:
        print(f"{refused.url}: {refused.code} {refused.read().decode()}", file=sys.stderr)
    except OSError as reason:
        print(f"{arguments.url}: {reason}", file=sys.stderr)
    return 1


if __name__ == "__main__":
    sys.exit(main())
