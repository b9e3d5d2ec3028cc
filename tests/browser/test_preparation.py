"""The banner that shows the progress of a server's preparation after installation."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import Page, Route, expect

from knifetip.service.http.models import ServiceOut

pytestmark = [
    pytest.mark.browser,
    pytest.mark.xdist_group("drawings"),
    pytest.mark.timeout(600),
]

PARTS = 240


@pytest.mark.long
def test_the_banner_shows_the_progress_and_disappears_when_the_server_is_prepared(
    page: Page, screenshots: Path
) -> None:
    compiled = 60
    answers: list[ServiceOut] = []

    def answer(route: Route) -> None:
        preparing = compiled < PARTS
        status = ServiceOut(
            version="test", preparing=preparing, parts_compiled=compiled, parts=PARTS
        )
        answers.append(status)
        route.fulfill(json=status.model_dump())

    banner = page.get_by_test_id("preparation")
    # The server of these tests has compiled all kernels.
    expect(page.get_by_test_id("work")).to_be_visible()
    expect(banner).to_be_hidden()

    page.route("**/api/v1/service", answer)
    page.reload()
    expect(banner).to_contain_text("First start of the server: 60 of 240 software modules")
    expect(banner.get_by_role("progressbar")).to_have_attribute("aria-valuenow", "25")
    page.screenshot(path=screenshots / "preparation.png")
    # It covers nothing: the page begins below it, on a phone too.
    for width, height in ((1440, 900), (1024, 768), (820, 1180), (390, 844)):
        page.set_viewport_size({"width": width, "height": height})
        box, below = banner.bounding_box(), page.get_by_test_id("work").bounding_box()
        assert box is not None
        assert below is not None
        assert box["y"] + box["height"] <= below["y"]

    compiled = 180
    expect(banner).to_contain_text("180 of 240 software modules")
    expect(banner.get_by_role("progressbar")).to_have_attribute("aria-valuenow", "75")
    # Files can be opened during the preparation.
    expect(page.get_by_test_id("choose-file")).to_be_enabled()

    compiled = PARTS
    expect(banner).to_be_hidden()
    # A prepared server remains prepared, so the page stops polling.
    asked = len(answers)
    page.wait_for_timeout(2500)
    assert len(answers) == asked
    assert not answers[-1].preparing
