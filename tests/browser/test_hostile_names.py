"""Names with markup and control characters are shown as text by the page, and do nothing."""

from __future__ import annotations

from pathlib import Path

import httpx
import pytest
from playwright.sync_api import Page, expect

from tests.browser.conftest import Running
from tests.support.hostile_names import HOSTILE_NAMES, acting
from tests.support.serving.server import square

pytestmark = [pytest.mark.browser, pytest.mark.xdist_group("browser"), pytest.mark.timeout(240)]

#: Layers may not contain line breaks, which end them in a DXF file.
LAYERS = [name for name in HOSTILE_NAMES.values() if name.isprintable()]


def test_hostile_names_of_drawings_and_layers_are_text(
    page: Page, server: Running, screenshots: Path
) -> None:
    shown = []
    with httpx.Client(base_url=server.url, trust_env=False, timeout=60.0) as client:
        for position, name in enumerate(HOSTILE_NAMES.values()):
            layer = LAYERS[position % len(LAYERS)].replace("<\\script>", "</script>")
            sent = name.encode("utf-8", "replace").decode()
            answer = client.post("/api/drawings", files={"file": (sent, square(layer))})
            assert answer.status_code == 201, answer.text
            shown.append((answer.json()["id"], answer.json()["name"]))
    page.on("dialog", lambda dialog: pytest.fail(f"a dialog opened: {dialog.message}"))
    for id, name in (shown[0], shown[1], shown[2], shown[5], shown[9], shown[13]):
        page.goto(f"{server.url}/#/drawings/{id}")
        expect(page.get_by_text(name, exact=False).first).to_be_attached()
        text = page.evaluate("document.body.innerText")
        assert acting(text, permitted="\n\t") == set()
        assert acting(page.title()) == set()
        assert page.evaluate("window.hacked") is None
        assert page.locator("img[src=x]").count() == 0
    page.screenshot(path=screenshots / "hostile-names.png")
