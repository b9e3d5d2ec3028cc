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
    Error,
    Page,
    Playwright,
    ViewportSize,
    expect,
    sync_playwright,
)

from tests.browser.windows import open_window

ROOT = Path(__file__).resolve().parents[2]
SCREENSHOTS = ROOT / "build" / "screenshots"
NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")
#: WebGL without a graphics card. The rest of the page is composed by the CPU directly: SwiftShader
#: would take ten times as long for it, most of the time of these tests.
SOFTWARE_GL = (
    *("--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"),
    "--disable-gpu-compositing",
)
#: Switched off are the suggestions below the address field, which take 0.6 s of CPU time for each
#: page although none is shown, and what Playwright switches off: this list replaces its own.
FEATURES_OFF = "--disable-features=" + ",".join(
    (
        *("WebUIOmniboxPopup", "WebUIOmniboxAimPopup", "AimEnabled", "LensOverlay"),
        *("AvoidUnnecessaryBeforeUnloadCheckSync", "AvoidCorsURLLoaderRestartOnRedirect"),
        *("DestroyProfileOnBrowserClose", "ThirdPartyStoragePartitioning", "PaintHolding"),
        *("HttpsUpgrades", "HttpsFirstBalancedModeAutoEnable", "MediaRouter", "OptimizationHints"),
        *("NetworkTimeServiceQuerying", "PreconnectToSearch"),
    )
)
SIZE = ViewportSize(width=1440, height=900)
#: Speed of the simulated table as a multiple of a real one.
SPEED = 4.0


class Running(NamedTuple):
    """A running server with its URL and its log."""

    url: str
    log: Path


def find_chromium() -> str:
    """Return the path of a Chromium; empty if there is none."""
    return os.environ.get("KNIFETIP_CHROMIUM") or next(filter(None, map(shutil.which, NAMES)), "")


def start_browser(playwright: Playwright, chromium: str) -> Browser:
    """Start a browser with software rendering."""
    # Chromium's sandbox does not work for root, who runs the tests in most containers.
    sandbox = ["--no-sandbox"] if hasattr(os, "geteuid") and os.geteuid() == 0 else []
    return playwright.chromium.launch(
        executable_path=chromium, args=[*sandbox, *SOFTWARE_GL, FEATURES_OFF]
    )


@pytest.fixture(scope="session")
def chromium() -> str:
    """Return the path of a Chromium; skip the test if there is none."""
    named = find_chromium()
    if not named:
        pytest.skip("there is no Chromium here (install it, or set KNIFETIP_CHROMIUM)")
    return named


# Playwright keeps an event loop running, which must end before async tests of other folders.
@pytest.fixture(scope="package")
def browser(chromium: str) -> Iterator[Browser]:
    """Start a browser with software rendering."""
    with sync_playwright() as playwright:
        started = start_browser(playwright, chromium)
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


@pytest.fixture(scope="package")
def window(browser: Browser) -> Iterator[BrowserContext]:
    """Open the window of all tests that need none of their own."""
    # The colours that tests look for are those of the dark scheme.
    context = open_window(browser, viewport=SIZE, color_scheme="dark")
    yield context
    context.close()


@pytest.fixture
def tab(window: BrowserContext, server: Running) -> Iterator[Page]:
    """Return an empty page without anything that another test has stored or set.

    Tests use one page after the other: a new one takes 1 s of CPU time, half of it for a process
    that compiles the page's scripts anew.
    """
    opened = window.pages[0] if window.pages else window.new_page()
    window.clear_cookies()
    session = window.new_cdp_session(opened)
    session.send(
        "Storage.clearDataForOrigin", {"origin": server.url, "storageTypes": "local_storage"}
    )
    session.detach()
    yield opened
    for other in window.pages[1:]:
        other.close()
    opened.unroute_all(behavior="ignoreErrors")
    opened.goto("about:blank")
    opened.set_viewport_size(SIZE)


@pytest.fixture
def page(tab: Page, server: Running) -> Iterator[Page]:
    """Open the page, as in a new window; fail if it writes an error to the console."""
    tab.set_default_timeout(90_000)
    expect.set_options(timeout=90_000)
    errors: list[str] = []

    def record_message(message: ConsoleMessage) -> None:
        # A response with status 4xx is no error of the page; the tests check how the page shows it.
        if message.type == "error" and "Failed to load resource" not in message.text:
            errors.append(message.text)

    def record_error(error: Error) -> None:
        errors.append(str(error))

    tab.on("console", record_message)
    tab.on("pageerror", record_error)
    tab.goto(server.url)
    yield tab
    tab.remove_listener("console", record_message)
    tab.remove_listener("pageerror", record_error)
    assert errors == []


@pytest.fixture(scope="session")
def screenshots() -> Path:
    """Return the folder for screenshots."""
    SCREENSHOTS.mkdir(parents=True, exist_ok=True)
    return SCREENSHOTS
