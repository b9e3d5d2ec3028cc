"""A real server, a simulated table and a real browser for tests of the page."""

from __future__ import annotations

import fcntl
import os
import shutil
import signal
import socket
import subprocess
import sys
import time
import urllib.error
import urllib.request
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import pytest
from playwright.sync_api import (
    Browser,
    BrowserContext,
    ConsoleMessage,
    Page,
    expect,
    sync_playwright,
)

ROOT = Path(__file__).resolve().parents[2]
SCREENSHOTS = ROOT / "build" / "screenshots"
NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")
#: WebGL without a graphics card. The rest of the page is composed by the CPU directly: SwiftShader
#: would take ten times as long for it, most of the time of these tests.
SOFTWARE_GL = (
    *("--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"),
    "--disable-gpu-compositing",
)
#: Continuous motion is drawn ten times a second: without a graphics card a frame takes 10 ms. The
#: first frame after a pause is drawn at once.
FEW_FRAMES = """(() => {
  const request = window.requestAnimationFrame.bind(window), waiting = new Set();
  let last = 0;
  window.requestAnimationFrame = (draw) => {
    const run = (now) => {
      if (!waiting.delete(id)) return;
      last = now;
      draw(now);
    };
    const id = setTimeout(() => request(run), Math.max(0, last + 100 - performance.now()));
    waiting.add(id);
    return id;
  };
  window.cancelAnimationFrame = (id) => waiting.delete(id) && clearTimeout(id);
})();"""
#: Speed of the simulated table as a multiple of a real one.
SPEED = 4.0


class Running(NamedTuple):
    """A running server with its URL and its log."""

    url: str
    log: Path


@pytest.fixture(scope="session")
def chromium() -> str:
    """Return the path of a Chromium; skip the test if there is none."""
    named = os.environ.get("KNIFETIP_CHROMIUM") or next(filter(None, map(shutil.which, NAMES)), "")
    if not named:
        pytest.skip("there is no Chromium here (install it, or set KNIFETIP_CHROMIUM)")
    return named


# Playwright keeps an event loop running, which must end before async tests of other modules.
@pytest.fixture(scope="module")
def browser(chromium: str) -> Iterator[Browser]:
    """Start a browser with software rendering."""
    with sync_playwright() as playwright:
        # Chromium's sandbox does not work for root, who runs the tests in most containers.
        sandbox = ["--no-sandbox"] if hasattr(os, "geteuid") and os.geteuid() == 0 else []
        started = playwright.chromium.launch(
            executable_path=chromium, args=[*sandbox, *SOFTWARE_GL]
        )
        yield started
        started.close()


@pytest.fixture(scope="session")
def built() -> None:
    """Build the page from the sources, in one worker at a time."""
    (ROOT / "build").mkdir(exist_ok=True)
    with (ROOT / "build" / "page.lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        made = subprocess.run(
            [sys.executable, str(ROOT / "frontend" / "build.py")],
            capture_output=True,
            text=True,
            check=False,
        )
    assert made.returncode == 0, made.stdout + made.stderr


@pytest.fixture(scope="session")
def server(built: None, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Running]:
    """Run the whole service on a free port, with a database of its own."""
    folder = tmp_path_factory.mktemp("served")
    with socket.socket() as door:
        door.bind(("127.0.0.1", 0))
        port = door.getsockname()[1]
    # Otherwise each process compiles changed kernels by itself while a test waits.
    subprocess.run([sys.executable, "-m", "knifetip.service.processes.warm_up"], check=True)
    running = Running(f"http://127.0.0.1:{port}", folder / "server.log")
    command = [sys.executable, "-m", "knifetip.cli", "serve", "--host", "127.0.0.1"]
    command += ["--port", str(port), "--speed", str(SPEED)]
    command += ["--database", f"sqlite:///{folder / 'browser.sqlite'}"]
    with running.log.open("wb") as log:
        process = subprocess.Popen(command, cwd=folder, stdout=log, stderr=log)
        try:
            _wait(running, process)
            yield running
        finally:
            process.send_signal(signal.SIGINT)
            try:
                process.wait(20)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()


def _wait(running: Running, process: subprocess.Popen[bytes]) -> None:
    deadline = time.monotonic() + 60.0
    while time.monotonic() < deadline and process.poll() is None:
        try:
            with urllib.request.urlopen(f"{running.url}/readyz", timeout=2) as answer:
                if answer.status == 200:
                    return
        except (urllib.error.URLError, TimeoutError, ConnectionError):
            pass
        time.sleep(0.2)
    pytest.fail(f"the server did not become ready:\n{running.log.read_text()}")


@pytest.fixture(scope="module")
def window(browser: Browser) -> Iterator[BrowserContext]:
    """Open a window whose pages share what the browser has loaded and compiled.

    In a window of its own, each page takes 1 s of CPU time more to open.
    """
    # The colours that tests look for are those of the dark scheme.
    context = browser.new_context(viewport={"width": 1440, "height": 900}, color_scheme="dark")
    context.add_init_script(FEW_FRAMES)
    yield context
    context.close()


@pytest.fixture
def page(window: BrowserContext, server: Running) -> Iterator[Page]:
    """Open the page, as in a new window; fail if it writes an error to the console."""
    window.clear_cookies()
    opened_page = window.new_page()
    opened_page.set_default_timeout(90_000)
    expect.set_options(timeout=90_000)
    errors: list[str] = []

    def record_error(message: ConsoleMessage) -> None:
        # A response with status 4xx is no error of the page; the tests check how the page shows it.
        if message.type == "error" and "Failed to load resource" not in message.text:
            errors.append(message.text)

    opened_page.on("console", record_error)
    opened_page.on("pageerror", lambda error: errors.append(str(error)))
    # Nothing that the page of another test has stored remains.
    opened_page.goto(f"{server.url}/favicon.svg")
    opened_page.evaluate("() => localStorage.clear()")
    opened_page.goto(server.url)
    yield opened_page
    for one in window.pages:
        one.close()
    assert errors == []


@pytest.fixture(scope="session")
def screenshots() -> Path:
    """Return the folder for screenshots."""
    SCREENSHOTS.mkdir(parents=True, exist_ok=True)
    return SCREENSHOTS
