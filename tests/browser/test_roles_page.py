"""Each control of the page is enabled for the roles that the server permits its request."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Final, NamedTuple

import pytest
from playwright.sync_api import Browser, Locator, Page, Response, expect

from knifetip.service.database.key_limits import KeyLimits
from knifetip.service.http.routing import scoped_operations
from knifetip.service.http.scopes import ROLES, AccessScope, scopes_of_role
from tests.browser.own_machine import OwnMachine
from tests.browser.shop import Shop, add_users, open_shop, signed_in
from tests.support.examples import is_quick
from tests.support.serving.server import square, upload_drawing
from tests.support.writers import dxf_text as text

pytestmark = [
    pytest.mark.browser,
    pytest.mark.xdist_group("accounts"),
    pytest.mark.timeout(600),
]

MACHINE: Final = "cutting-room"
BOARD: Final = "own-board"
#: Lines on a layer whose name has no meaning.
INNER: Final = (
    text.line(20.0, 40.0, 80.0, 40.0, (8, "INNER"), (62, 1)),
    text.line(20.0, 60.0, 80.0, 60.0, (8, "INNER"), (62, 1)),
)
#: Sizes of the screenshots, which no test compares: one in `make test`.
SIZES: Final = ((1440, 900), (390, 844))[: 1 if is_quick() else 2]


class Workplace(NamedTuple):
    """A shop with something to do on every page, and the roles that its requests need."""

    shop: Shop
    open_question: str  #: drawing with an edge whose line type is not known
    needed: dict[tuple[str, str], tuple[AccessScope, ...]]
    gateway_key: str
    lease: dict[str, object]  #: job and epoch of the claimed job; empty before the first claim

    def claim(self) -> None:
        """Claim the job of the machine, or renew the claim: the job then waits for a person."""
        for path, body in (
            ("heartbeat", {**self.lease, "line": 0, "waiting": True}),
            ("claim", {"gateway": "test", "machine": MACHINE, "wait": 20.0}),
        ):
            if path == "heartbeat" and not self.lease:
                continue
            answer = self.shop.client.post(
                f"/api/gateway/{path}",
                json=body,
                headers={"Authorization": f"Bearer {self.gateway_key}"},
            )
            if answer.status_code == 200:
                break
        answer.raise_for_status()
        if path == "claim":
            self.lease.update({name: answer.json()[name] for name in ("job", "epoch")})

    def permits(self, role: AccessScope, request: str) -> bool:
        """Return whether the server permits a request, ``METHOD /path``, to a role."""
        method, path = request.split()
        return not scopes_of_role(role).isdisjoint(self.needed[method, f"/api{path}"])


@pytest.fixture(scope="module")
def workplace(built: None, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Workplace]:
    with open_shop(tmp_path_factory.mktemp("roles")) as shop:
        client = shop.client
        OwnMachine(client, MACHINE).order()
        fields = client.get("/api/boards/e-flute/definition").json()["fields"]
        board = client.put(f"/api/boards/{BOARD}", json={**fields, "title": "Own board"})
        assert board.status_code == 201, board.text
        drawing = upload_drawing(client, square(extra=INNER))
        assert drawing["questions"], drawing
        add_users(shop)
        operations = scoped_operations(client.app.routes)
        needed = {(one.method, one.path): one.needed for one in operations}
        limits = KeyLimits(machines=frozenset({MACHINE}))
        _, secret = shop.store.keys.add("gateway", [AccessScope.GATEWAY], limits=limits)
        yield Workplace(shop, drawing["id"], needed, secret, {})


class View(NamedTuple):
    """A view of the page with the request that each of its controls sends."""

    name: str
    open: Callable[[Page, Workplace], None]
    controls: dict[str, str]


def go(page: Page, address: str) -> None:
    # Without a reload the page would keep its panels and its selection.
    page.goto(f"{page.url.partition('#')[0]}#/{address}")
    page.reload()


def open_drawing(page: Page, workplace: Workplace) -> None:
    go(page, f"drawings/{workplace.open_question}/lines")
    # The length is shown as soon as the edges are loaded, which can then be selected.
    expect(page.get_by_test_id("question")).to_contain_text("120")
    page.keyboard.press("Control+a")
    expect(page.get_by_test_id("selection")).to_be_visible()
    page.get_by_text("Unit of length in the file").click()


def open_job(page: Page, workplace: Workplace) -> None:
    go(page, f"drawings/{workplace.shop.drawing}/jobs/{workplace.shop.job}")
    expect(page.get_by_test_id("send")).to_be_visible()


def open_sheet(page: Page, workplace: Workplace) -> None:
    go(page, f"drawings/{workplace.shop.drawing}/sheet")
    expect(page.get_by_test_id("copies")).to_be_visible()


def open_process(page: Page, workplace: Workplace) -> None:
    go(page, f"drawings/{workplace.shop.drawing}/process")
    expect(page.get_by_test_id("option-feed_factor")).to_be_visible()


def open_drawings(page: Page, workplace: Workplace) -> None:
    go(page, "")
    expect(page.get_by_test_id("choose-file").first).to_be_visible()


def open_library(page: Page, workplace: Workplace) -> None:
    go(page, "library")
    page.get_by_test_id(f"entry-{BOARD}").click()
    expect(page.get_by_test_id("copy-definition")).to_be_visible()


def open_webhooks(page: Page, workplace: Workplace) -> None:
    go(page, "webhooks")
    expect(page.get_by_role("heading", name="Webhooks")).to_be_visible()


def open_tools(page: Page, workplace: Workplace) -> None:
    go(page, "")
    page.get_by_test_id("history-button").click()
    page.get_by_test_id("history").get_by_text("Tools", exact=True).click()
    expect(page.get_by_test_id("tool").first).to_be_visible()


def open_station(page: Page, workplace: Workplace) -> None:
    workplace.claim()
    go(page, f"station/{MACHINE}")
    expect(page.get_by_test_id("check").first).to_be_visible()


EDGES: Final = "PATCH /drawings/{id}/edges"
CHANGE: Final = "PATCH /drawings/{id}"
#: Controls by test id or, with a preceding "button ", by their names.
VIEWS: Final = (
    View(
        "drawings",
        open_drawings,
        {"choose-file": "POST /drawings", "button Delete": "DELETE /drawings/{id}"},
    ),
    View(
        "drawing",
        open_drawing,
        {
            "type-crease": EDGES,
            "type-none": EDGES,
            "answer-cut": EDGES,
            "button Set the line type of layer INNER": EDGES,
            "unit-in": CHANGE,
            "profile-select": CHANGE,
            "edit-profile": "PUT /profiles/{name}",
        },
    ),
    View(
        "sheet",
        open_sheet,
        {"copies": "POST /jobs", "machine-select": "POST /jobs", "board-select": "POST /jobs"},
    ),
    View("process", open_process, {"option-feed_factor": "POST /jobs"}),
    View(
        "job",
        open_job,
        {"send": "POST /jobs/{id}/release", "cancel": "POST /jobs/{id}/cancel"},
    ),
    View(
        "library",
        open_library,
        {
            "copy-definition": "PUT /boards/{name}",
            "button Delete": "DELETE /boards/{name}",
            "button Import board from a TOML file": "PUT /boards/{name}",
        },
    ),
    View("webhooks", open_webhooks, {"button Add": "POST /webhooks"}),
    View(
        "tools",
        open_tools,
        {
            "tool-changed": "POST /machines/{name}/tools/{station}/changed",
            "tool-life": "PUT /machines/{name}/tools/{station}/life",
        },
    ),
    View(
        "station",
        open_station,
        {"check": "POST /jobs/{id}/confirm"},
    ),
)


def control(page: Page, name: str) -> Locator:
    kind, _, label = name.partition(" ")
    if kind == "button":
        return page.get_by_role("button", name=label).first
    found = page.get_by_test_id(name).first
    # The state of a check is that of the field inside its label.
    return found.locator("input") if name == "check" else found


def refused(page: Page) -> list[str]:
    """Return a list to which the requests of a page that the server refuses are added."""
    found: list[str] = []

    def note(answer: Response) -> None:
        if answer.status == 403:
            found.append(f"{answer.request.method} {answer.url}")

    page.on("response", note)
    return found


#: Roles of `make test`: one with some of the controls.
QUICK_ROLES: Final = (AccessScope.OPERATOR,)


@pytest.mark.parametrize(
    "role",
    [pytest.param(role, marks=() if role in QUICK_ROLES else pytest.mark.long) for role in ROLES],
)
def test_a_role_has_the_controls_that_the_server_permits(
    browser: Browser, workplace: Workplace, screenshots: Path, role: AccessScope
) -> None:
    with signed_in(browser, workplace.shop, role.value) as page:
        answers = refused(page)
        for view in VIEWS:
            view.open(page, workplace)
            for name, request in view.controls.items():
                permitted = workplace.permits(role, request)
                expect(control(page, name), f"{view.name}: {name}").to_be_enabled(enabled=permitted)
            all_permitted = all(workplace.permits(role, one) for one in view.controls.values())
            reasons = page.get_by_test_id("role-reason").filter(visible=True)
            if not all_permitted:
                expect(reasons.first, view.name).to_be_visible()
            elif role == AccessScope.ADMIN:
                expect(reasons, view.name).to_have_count(0)
            for width, height in SIZES if role == AccessScope.VIEWER else ():
                page.set_viewport_size({"width": width, "height": height})
                page.screenshot(path=screenshots / f"{view.name}-{role}-{width}.png")
            page.set_viewport_size({"width": 1440, "height": 900})
        # Keys choose a line type without a control.
        open_drawing(page, workplace)
        if not workplace.permits(role, EDGES):
            page.keyboard.press("1")
            page.keyboard.press("0")
            expect(page.get_by_test_id("question")).to_be_visible()
        assert answers == []


#: Views of `make test` in which a viewer presses everything.
QUICK_VIEWS: Final = ("station",)
#: Presses the enabled controls from one on, until there are no more or one has left the view;
#: returns the number of the next one, and whether there may be more. The bar with the other views,
#: which all views have, is pressed if asked.
PRESS: Final = """async ([at, bar]) => {
  const address = location.hash;
  for (; ; at++) {
    const found = [...document.querySelectorAll("button, [role=button], [role=menuitem], summary")]
      .filter((one) => !one.matches(":disabled, [data-disabled], [data-testid=sign-out]"))
      // Another language loads the page again.
      .filter((one) => !one.matches("[data-testid^=language-]"))
      .filter((one) => !one.matches("[data-testid=drawing-row], [data-testid=queue-row]"))
      .filter((one) => bar || !one.closest("[role=toolbar]"));
    if (at >= found.length) return [at, false];
    found[at].click();
    await new Promise((resolve) => setTimeout(resolve, 20));
    document.body.dispatchEvent(new KeyboardEvent("keydown", {key: "Escape", bubbles: true}));
    if (location.hash !== address) return [at + 1, true];
  }
}"""


# The view is opened again after each control that leaves it.
@pytest.mark.parametrize(
    "view",
    [
        pytest.param(view, marks=() if view.name in QUICK_VIEWS else pytest.mark.long, id=view.name)
        for view in VIEWS
    ],
)
def test_nothing_that_a_viewer_can_press_is_refused(
    browser: Browser, workplace: Workplace, view: View
) -> None:
    with signed_in(browser, workplace.shop, "viewer") as page:
        answers, at, more = refused(page), 0, True
        while more:
            view.open(page, workplace)
            at, more = page.evaluate(PRESS, [at, view is VIEWS[0]])
        assert at > 0
        assert answers == []
