"""Start the shop of docker-compose.yml, and run a job in it while parts of it are restarted.

    python tests/container/shop.py [--keep]

Starts all services of the profile ``shop`` in a project of its own, waits until they are healthy,
and orders a job over REST.  A worker is killed while it compiles, and the API server is restarted
while the machine runs.  The job must be done in the end, having been cut once.  Prints the seconds
of each step, the last lines of the logs and the sizes of the images; exits with 1 if a step fails.
Uses the standard library only.
"""

from __future__ import annotations

import argparse
import json
import os
import secrets
import shutil
import socket
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))

from tests.container.run_job import CONFIRMED_BY_HAND, ENDS, Service, drawing  # noqa: E402  # after the path

PARTS = ("postgres", "api", "worker-1", "worker-2", "table", "gateway")
_PAUSE = 0.2  # seconds between two polls


def compose_command() -> list[str] | None:
    """Return the words with which Compose is called; None if it is not installed."""
    if shutil.which("docker") and _succeeds("docker", "compose", "version"):
        return ["docker", "compose"]
    return ["docker-compose"] if shutil.which("docker-compose") else None


def _succeeds(*words: str) -> bool:
    return subprocess.run(words, capture_output=True, check=False).returncode == 0


def engine_runs() -> bool:
    """Return whether a container engine answers."""
    return shutil.which("docker") is not None and _succeeds("docker", "info")


def has_image(name: str) -> bool:
    """Return whether the engine has an image."""
    return _succeeds("docker", "image", "inspect", name)


class Shop:
    """The services of the profile ``shop``, in a Compose project with its own port and secrets."""

    def __init__(self, compose: Sequence[str], folder: Path, speed: float) -> None:
        self.folder = folder
        self.key = secrets.token_urlsafe(24)
        _write_secret(folder / "server_key", self.key)
        _write_secret(folder / "database_password", secrets.token_urlsafe(24))
        port = _free_port()
        self.project = f"knifetip-shop-{os.getpid()}"
        self.environment = {
            **os.environ,
            "KNIFETIP_PORT": str(port),
            "KNIFETIP_SECRETS": str(folder),
            "KNIFETIP_SPEED": str(speed),
        }
        self._compose = [*compose, "--project-name", self.project, "--profile", "shop"]
        self.service = Service(f"http://127.0.0.1:{port}", self.key)

    def run(self, *words: str) -> str:
        """Run a command of Compose and return its output."""
        done = subprocess.run(
            [*self._compose, *words],
            cwd=ROOT,
            env=self.environment,
            capture_output=True,
            text=True,
            check=False,
        )
        if done.returncode != 0:
            raise RuntimeError(f"{' '.join(words)}: {done.stdout}{done.stderr}")
        return done.stdout

    def container(self, part: str) -> Any:
        """Return the engine's description of the container of a service."""
        found = self.run("ps", "--quiet", part).split()
        if not found:
            return {}
        words = ["docker", "inspect", found[0]]
        return json.loads(subprocess.run(words, capture_output=True, check=True).stdout)[0]

    def is_healthy(self, part: str) -> bool:
        """Return whether a service runs and its health check succeeds."""
        state = self.container(part).get("State", {})
        return bool(state.get("Health", {}).get("Status") == "healthy")

    def remove(self) -> None:
        """Remove the containers, the networks and the volumes of the project."""
        self.run("down", "--volumes", "--timeout", "5")


def _write_secret(file: Path, text: str) -> None:
    file.write_text(text + "\n")
    # A container reads the file as a user of its own; the folder keeps others out.
    file.chmod(0o444)


def _free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return int(probe.getsockname()[1])


def wait_until(reached: Callable[[], Any], seconds: float, what: str) -> Any:
    """Return the first true result of a function; raise an error when the time is up."""
    deadline = time.monotonic() + seconds
    while time.monotonic() < deadline:
        try:
            if found := reached():
                return found
        except OSError:
            pass  # the server is being restarted
        time.sleep(_PAUSE)
    raise RuntimeError(f"{what}: not within {seconds:.0f} s")


def run_job_through_restarts(shop: Shop, report: Callable[[str], None]) -> Any:
    """Run a job while a worker is killed and the API server is restarted; return the job."""
    service = shop.service
    uploaded = service.upload("square.dxf", drawing())
    job = service.order(uploaded["id"])["id"]

    def look() -> Any:
        return service.call(f"/api/jobs/{job}")

    def confirmed(*states: str) -> Any:
        found = look()
        if found.get("waiting_for") in CONFIRMED_BY_HAND:
            service.confirm(job)
        return found if found["state"] in states else None

    report(f"job {job} ordered")
    for worker in ("worker-1", "worker-2"):
        shop.run("kill", worker)
    shop.run("up", "--detach", "--no-recreate", "worker-2")
    report("both workers killed, worker-2 started again")
    wait_until(lambda: confirmed("running", *ENDS), 240, "the job runs")
    report("the machine runs")
    shop.run("restart", "api")
    report("API restarted")
    shop.run("up", "--detach", "--no-recreate", "worker-1")
    ended = wait_until(lambda: confirmed(*ENDS), 240, "the job ends")
    report(f"job {job} {ended['state']}")
    return ended


def start(shop: Shop, report: Callable[[str], None]) -> None:
    """Start all services and wait until they are healthy."""
    shop.run("up", "--detach", "--no-build")
    report("containers started")
    for part in PARTS:
        wait_until(partial(shop.is_healthy, part), 180, f"{part} is healthy")
    report("all parts healthy")


def describe(shop: Shop) -> str:
    """Return the last lines of the logs and the sizes of the images."""
    images = subprocess.run(
        ["docker", "images", "--format", "{{.Repository}}:{{.Tag}} {{.Size}}"],
        capture_output=True,
        text=True,
        check=True,
    ).stdout
    sizes = [line for line in images.splitlines() if line.split(":")[0] in ("knifetip", "postgres")]
    return shop.run("logs", "--no-color", "--tail", "4") + "\n".join(sizes)


def main() -> int:
    """Start the shop and run a job in it; return the exit code."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n")[0])
    parser.add_argument("--keep", action="store_true", help="leave the containers running")
    parser.add_argument("--speed", type=float, default=0.5, help="speed of the simulated table")
    arguments = parser.parse_args()
    compose = compose_command()
    if compose is None or not engine_runs():
        print("No container engine with Compose runs here.", file=sys.stderr)
        return 1
    began = time.monotonic()

    def report(step: str) -> None:
        print(f"{time.monotonic() - began:7.2f} s  {step}", flush=True)

    folder = Path(tempfile.mkdtemp(prefix="knifetip-shop-"))
    shop = Shop(compose, folder, arguments.speed)
    try:
        start(shop, report)
        ended = run_job_through_restarts(shop, report)
        print(describe(shop))
        return 0 if (ended["state"], ended["copies_done"]) == ("done", 1) else 1
    except (RuntimeError, OSError) as reason:
        print(reason, file=sys.stderr)
        print(shop.run("logs", "--no-color", "--tail", "30"), file=sys.stderr)
        return 1
    finally:
        if arguments.keep:
            print(f"docker compose --project-name {shop.project} --profile shop down --volumes")
        else:
            shop.remove()
            shutil.rmtree(folder)


if __name__ == "__main__":
    sys.exit(main())
