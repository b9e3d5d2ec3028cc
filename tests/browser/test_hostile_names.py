"""Names with markup and control characters are shown as text by the page, and do nothing."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path

import httpx
import pytest
from playwright.sync_api import Dialog, Page, expect

from tests.browser.conftest import Running
from tests.support.hostile_names import HOSTILE_NAMES, acting
from tests.support.serving.server import square

pytestmark = [pytest.mark.browser, pytest.mark.xdist_group("browser"), pytest.mark.timeout(600)]

#: Layers may not contain line breaks, which end them in a DXF file.
LAYERS = [name for name in HOSTILE_NAMES.values() if name.isprintable()]


@pytest.fixture
def page(page: Page) -> Iterator[Page]:
    """Open the page, and fail if it opens a dialog."""
    opened: list[str] = []

    def record(dialog: Dialog) -> None:
        opened.append(dialog.message)
        dialog.dismiss()

    page.on("dialog", record)
    yield page
    page.remove_listener("dialog", record)
    assert opened == []


def test_hostile_names_of_drawings_and_layers_are_text(
    page: Page, server: Running, screenshots: Path
) -> None:
    shown = []
    with httpx.Client(base_url=server.url, trust_env=False, timeout=60.0) as client:
        for position, name in enumerate(HOSTILE_NAMES.values()):
            layer = LAYERS[position % len(LAYERS)].replace("<\\script>", "</script>")
            sent = name.encode("utf-8", "replace").decode()
            answer = client.post("/api/drawings", files={"file": (sent, square(layer))})
            if answer.status_code == 422:
                assert "control character" in answer.json()["text"]
                continue
            assert answer.status_code == 201, answer.text
            shown.append((answer.json()["id"], answer.json()["name"]))
    assert len(shown) > 8
    for id, name in (*shown[:3], *shown[3::2]):
        page.goto(f"{server.url}/#/drawings/{id}")
        expect(page.get_by_text(name, exact=False).first).to_be_attached()
        text = page.evaluate("document.body.innerText")
        assert acting(text, permitted="\n\t") == set()
        assert acting(page.title()) == set()
        assert page.evaluate("window.hacked") is None
        assert page.locator("img[src=x]").count() == 0
    page.screenshot(path=screenshots / "hostile-names.png")


@pytest.mark.long
def test_hostile_names_in_the_library_are_text(
    page: Page, server: Running, screenshots: Path
) -> None:
    names = [name for name in HOSTILE_NAMES.values() if name.isprintable()]
    headers = {"X-Knifetip": "test"}
    with httpx.Client(
        base_url=server.url, trust_env=False, timeout=60.0, headers=headers
    ) as client:
        shipped = {
            shelf: client.get(f"/api/{shelf}/{name}/definition").json()["fields"]
            for shelf, name in (("machines", "demo-table"), ("boards", "e-flute"))
        }
        stations = shipped["machines"]["station"]
        drawing = client.post("/api/drawings", files={"file": ("plain.dxf", square())}).json()["id"]
        for position, name in enumerate([*names, 200 * "W"]):
            body: Mapping[str, object]
            for path, body in (
                (
                    f"machines/hostile-{position}",
                    {
                        **shipped["machines"],
                        "title": name,
                        "station": [{**stations[0], "name": name}, *stations[1:]],
                    },
                ),
                (f"boards/hostile-{position}", {**shipped["boards"], "title": name}),
                (f"profiles/hostile-{position}", {"title": name, "extends": None, "rules": []}),
            ):
                answer = client.put(f"/api/{path}", json=body)
                assert answer.status_code == 201, answer.text
    for width in (1440, 390):
        page.set_viewport_size({"width": width, "height": 900})
        page.goto(f"{server.url}/#/library")
        page.get_by_test_id("entry-hostile-0").first.click()
        expect(page.get_by_test_id("copy-definition")).to_be_visible()
        assert_text_only(page, screenshots / f"hostile-library-{width}.png")
        page.goto(f"{server.url}/#/station/hostile-{len(names)}")
        expect(page.get_by_test_id("station-page")).to_be_visible()
        assert_text_only(page, screenshots / f"hostile-station-{width}.png")
    page.set_viewport_size({"width": 1440, "height": 900})
    for step, choice in (
        ("sheet", "machine-select"),
        ("sheet", "board-select"),
        ("lines", "profile-select"),
    ):
        page.goto(f"{server.url}/#/drawings/{drawing}/{step}")
        page.get_by_test_id(choice).click()
        expect(page.get_by_role("option", name=names[0], exact=True)).to_be_attached()
        page.get_by_role("option", name=200 * "W", exact=True).click()
    assert_text_only(page, screenshots / "hostile-selects.png")


def assert_text_only(page: Page, picture: Path) -> None:
    page.screenshot(path=picture)
    assert page.evaluate("window.hacked") is None
    assert page.locator("img[src=x]").count() == 0
    # Nothing is wider than the window because of a long name.
    assert page.evaluate("document.documentElement.scrollWidth <= window.innerWidth")
    too_wide = page.locator("nav button, h1").evaluate_all(
        "all => all.filter((one) => one.scrollWidth > one.clientWidth + 1 &&"
        " getComputedStyle(one).overflow === 'visible').map((one) => one.textContent)"
    )
    assert too_wide == []
