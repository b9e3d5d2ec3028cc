"""A server with a user of each role, and their sessions in a browser."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import NamedTuple

from playwright.sync_api import Browser, Page, expect

from knifetip.service.http.scopes import ROLES
from knifetip.service.settings import Settings
from knifetip.service.store import Store
from tests.browser.windows import open_window
from tests.support.serving.server import (
    LocalClient,
    order_job,
    run_server,
    square,
    upload_drawing,
    wait_for_state,
)

PASSWORD = "four words of text"


class Shop(NamedTuple):
    """A server with a user of each role, who has the name of the role, and a compiled job."""

    client: LocalClient
    drawing: str
    job: str

    @property
    def store(self) -> Store:
        return self.client.service.store


@contextmanager
def open_shop(folder: Path) -> Iterator[Shop]:
    """Run the server of a shop with a database in a folder."""
    with run_server(Settings(database=f"sqlite:///{folder}/shop.sqlite")) as client:
        drawing = upload_drawing(client, square())["id"]
        job = order_job(client, drawing, machine="demo-table")["id"]
        wait_for_state(client, job, "ready", seconds=200.0)
        yield Shop(client, drawing, job)


def add_users(shop: Shop) -> None:
    """Add the users; from then on every request needs a session or a key."""
    for role in ROLES:
        shop.store.users.add(role.value, PASSWORD, role)
    shop.client.app.state.accounts.clear_cache()


@contextmanager
def signed_in(browser: Browser, shop: Shop, name: str, password: str = PASSWORD) -> Iterator[Page]:
    """Open the page in a window of its own as a user."""
    context = open_window(browser, viewport={"width": 1440, "height": 900})
    page = context.new_page()
    page.set_default_timeout(90_000)
    expect.set_options(timeout=90_000)
    page.goto(str(shop.client.base_url))
    page.get_by_label("Name").fill(name)
    page.get_by_label("Password").fill(password)
    page.get_by_role("button", name="Sign in").click()
    expect(page.get_by_test_id("account")).to_be_visible()
    yield page
    context.close()
