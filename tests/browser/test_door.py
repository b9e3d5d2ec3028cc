"""Two tabs with one drawing, a busy server, and sign-in from a browser on another machine."""

from __future__ import annotations

import re
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path
from typing import Any

import httpx
import pytest
from playwright.sync_api import Browser, FilePayload, Page, Route, expect

from tests.browser.steps import choose_board, go_to
from tests.support.writers import dxf_text as text

pytestmark = [pytest.mark.browser, pytest.mark.xdist_group("browser"), pytest.mark.timeout(600)]

CORNERS = ((0.0, 0.0), (400.0, 0.0), (400.0, 300.0), (0.0, 300.0), (0.0, 0.0))
FOLDS = tuple(text.line(x, 0.0, x, 300.0, (8, "CREASE")) for x in (100.0, 200.0, 300.0))
CARTON = text.dxf(*(text.line(*a, *b, (8, "CUT")) for a, b in pairwise(CORNERS)), *FOLDS)
ALL_FOLDS = [{"type": "perforation", "layer": "CREASE"}]
ONE_FOLD = [{"type": "half-cut", "edges": [4]}]


def rest_client(url: str) -> httpx.Client:
    return httpx.Client(base_url=url, timeout=60.0, trust_env=False)


@pytest.fixture
def api(page: Page) -> Iterator[httpx.Client]:
    with rest_client(re.sub(r"/(#.*)?$", "", page.url)) as client:
        yield client


@pytest.fixture
def drawing(api: httpx.Client) -> str:
    """Return the id of an uploaded drawing."""
    answer = api.post("/api/drawings", files={"file": ("folds.dxf", CARTON)})
    assert answer.status_code == 201, answer.text
    return str(answer.json()["id"])


def open_drawing(page: Page, drawing: str) -> None:
    page.evaluate("(id) => { location.hash = `#/drawings/${id}/lines` }", drawing)
    expect(page.get_by_role("heading", name="folds.dxf")).to_be_visible(timeout=60_000)
    expect(page.get_by_test_id("legend-crease")).to_be_visible()


def select_board(page: Page) -> None:
    choose_board(page, "Corrugated, E-flute 1.6 mm")


def test_a_tab_shows_changes_of_another_tab_without_a_reload(
    page: Page, drawing: str, api: httpx.Client, screenshots: Path
) -> None:
    other = page.context.new_page()
    other.goto(page.url)
    open_drawing(page, drawing)
    open_drawing(other, drawing)
    api.patch(f"/api/drawings/{drawing}/edges", json={"overrides": ALL_FOLDS}).raise_for_status()
    for tab in (page, other):
        expect(tab.get_by_test_id("legend-perforation")).to_be_visible(timeout=60_000)
        expect(tab.get_by_test_id("legend-crease")).to_be_hidden()
        notice = tab.get_by_test_id("report").filter(has_text="The drawing was changed elsewhere")
        expect(notice).to_contain_text("3 edges now have another line type")
    page.screenshot(path=screenshots / "changed-elsewhere.png")
    # A change made in one tab is announced in the other tab only.
    page.get_by_test_id("report").get_by_label("Close this message").click()
    page.keyboard.press("Control+a")
    page.get_by_test_id("type-half-cut").click()
    for tab in (page, other):
        expect(tab.get_by_test_id("legend-half-cut")).to_be_visible()
        expect(tab.get_by_test_id("legend-cut")).to_be_hidden()
    expect(page.get_by_test_id("report")).to_have_count(0)
    other.close()


@pytest.mark.long
def test_an_order_of_an_outdated_drawing_is_refused(
    page: Page, drawing: str, api: httpx.Client
) -> None:
    open_drawing(page, drawing)
    select_board(page)
    sent: list[Any] = []

    def late(route: Route) -> None:
        if route.request.method == "POST":
            sent.append(route.request.post_data_json)
            if len(sent) == 1:
                change = {"overrides": ONE_FOLD}
                api.patch(f"/api/drawings/{drawing}/edges", json=change).raise_for_status()
        route.continue_()

    page.route("**/api/v1/jobs", late)
    jobs = len(api.get("/api/jobs?limit=500").json())
    page.get_by_test_id("compile").click()
    report = page.get_by_test_id("report")
    expect(report).to_contain_text("Your change was not saved: the drawing was changed elsewhere")
    expect(report).to_contain_text("1 edge now has another line type")
    go_to(page, "lines")
    expect(page.get_by_test_id("legend-half-cut")).to_be_visible()
    assert len(api.get("/api/jobs?limit=500").json()) == jobs
    page.get_by_test_id("compile").click()
    expect(page.get_by_test_id("verdict")).to_be_visible(timeout=120_000)
    assert [order["revision"] for order in sent] == [1, 2]


def test_a_file_that_a_busy_server_refuses_is_sent_again(page: Page) -> None:
    refused = 0

    def busy(route: Route) -> None:
        nonlocal refused
        if route.request.method == "POST" and refused < 2:
            refused += 1
            route.fulfill(
                status=503,
                headers={"Retry-After": "1", "Content-Type": "application/problem+json"},
                body='{"title": "Busy", "status": 503, "detail": "16 requests wait."}',
            )
        else:
            route.continue_()

    page.route("**/api/v1/drawings", busy)
    page.get_by_test_id("file-input").set_input_files(
        FilePayload(name="folds.dxf", mimeType="image/vnd.dxf", buffer=CARTON)
    )
    expect(page.get_by_role("heading", name="folds.dxf")).to_be_visible(timeout=60_000)
    assert refused == 2
    assert page.get_by_test_id("report").count() == 0


def own_address() -> str:
    """Return an address of this machine other than loopback; skip the test if there is none."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as asked:
        try:
            # No packet is sent: connecting a UDP socket only selects the local address.
            asked.connect(("192.0.2.1", 9))
            address = str(asked.getsockname()[0])
        except OSError:
            address = "127.0.0.1"
    if address.startswith("127."):
        pytest.skip("this machine has no address but loopback ones")
    return address


def test_another_machine_signs_in_by_link_or_by_key_and_then_works(
    browser: Browser, built: None, tmp_path: Path
) -> None:
    address = own_address()
    with socket.socket() as free:
        free.bind((address, 0))
        port = free.getsockname()[1]
    command = [sys.executable, "-m", "knifetip.cli", "serve", "--host", address]
    command += ["--port", str(port), "--key-file", str(tmp_path / "key"), "--no-samples"]
    command += ["--database", f"sqlite:///{tmp_path}/a.sqlite"]
    with (tmp_path / "log").open("wb") as log:
        process = subprocess.Popen(command, cwd=tmp_path, stdout=log, stderr=log)
    try:
        base = f"http://{address}:{port}"
        wait_until_ready(base, process, tmp_path / "log")
        key = (tmp_path / "key").read_text().strip()
        start_log = (tmp_path / "log").read_text().replace("\n", "")
        assert key not in start_log
        assert str(tmp_path / "key") in start_log
        with rest_client(base) as stranger:
            assert stranger.get("/api/jobs").status_code == 401
            # The gateway of the server needs no key: it uses the loopback address.
            deadline = time.monotonic() + 120.0
            headers = {"Authorization": f"Bearer {key}"}
            while (
                stranger.get("/api/machines/demo-table", headers=headers).json()["gateway"]
                != "connected"
            ):
                assert time.monotonic() < deadline
                time.sleep(0.1)
        for way in ("link", "form"):
            context = browser.new_context()
            page = context.new_page()
            page.set_default_timeout(90_000)
            page.goto(f"{base}/?key={key}" if way == "link" else base)
            if way == "form":
                # The browser reloads once more, because a link on another site may have led here.
                page.wait_for_url("**again=1")
                page.get_by_label("Key").fill(key)
                page.get_by_role("button", name="Sign in").click()
            # The page replaces the file input when the list of work has arrived.
            welcome = page.get_by_role("heading", name="Drop a dieline file here")
            expect(welcome.or_(page.get_by_role("table"))).to_be_visible()
            page.get_by_test_id("file-input").set_input_files(
                FilePayload(name="folds.dxf", mimeType="image/vnd.dxf", buffer=CARTON)
            )
            expect(page.get_by_role("heading", name="folds.dxf")).to_be_visible(timeout=60_000)
            assert key not in page.url
            assert key not in str(context.cookies())
            # After a link on another site the cookie is not sent at first, and then it is.
            page.goto("data:text/html,<a href='" + base + "/'>knifetip</a>")
            page.get_by_role("link").click()
            expect(page.get_by_test_id("file-input")).to_be_attached()
            context.close()
    finally:
        process.send_signal(signal.SIGINT)
        try:
            process.wait(20)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()


def wait_until_ready(base: str, process: subprocess.Popen[bytes], log: Path) -> None:
    deadline = time.monotonic() + 60.0
    while time.monotonic() < deadline and process.poll() is None:
        try:
            if httpx.get(f"{base}/readyz", trust_env=False).status_code == 200:
                return
        except httpx.HTTPError:
            pass
        time.sleep(0.2)
    pytest.fail(log.read_text())
