"""The page of cartons: from the start page to a proven job of a FEFCO 0427 in six clicks."""

from __future__ import annotations

import re

import httpx
import pytest
from playwright.sync_api import Page, expect

pytestmark = [
    pytest.mark.browser,
    pytest.mark.xdist_group("drawings"),
    pytest.mark.timeout(600),
]

#: Time of a compile on a busy computer (ms).
COMPILE = 120_000


def test_a_0427_is_ordered_by_its_dimensions_in_six_clicks(page: Page) -> None:
    page.get_by_test_id("to-cartons").click()
    page.get_by_test_id("style-fefco-0427").click()
    picture = page.get_by_test_id("carton-picture")
    expect(picture).to_be_visible(timeout=60_000)
    before = picture.get_attribute("src")
    length = page.locator("[data-path=length]")
    length.click()
    for value in ("230", "170", "55"):
        page.keyboard.press("ControlOrMeta+a")
        page.keyboard.type(value)
        page.keyboard.press("Tab")
    expect(picture).not_to_have_attribute("src", before or "", timeout=60_000)
    page.get_by_test_id("carton-draw").click()
    name = "fefco-0427 230x170x55 e-flute.dxf"
    expect(page.get_by_role("heading", name=name)).to_be_visible(timeout=60_000)
    page.get_by_test_id("compile").click()
    page.get_by_test_id("send").click(timeout=COMPILE)
    expect(page.get_by_test_id("job-state")).to_have_text(re.compile("Waiting for operator|Queued"))
    address, _, place = page.url.partition("#")
    # The table is left to other tests.
    job = place.rpartition("/")[2]
    headers = {"X-Knifetip": "page"}
    answer = httpx.post(f"{address}api/jobs/{job}/cancel", json={}, headers=headers, timeout=60.0)
    assert answer.status_code == 200, answer.text


def test_a_dimension_that_the_style_cannot_have_is_refused_at_its_field(page: Page) -> None:
    page.evaluate("location.hash = '#/cartons/fefco-0427'")
    depth = page.locator("[data-path=depth]")
    depth.fill("9")
    expect(page.get_by_text("depth 9 is too small")).to_be_visible(timeout=60_000)
    expect(depth).to_have_attribute("aria-invalid", "true")
    expect(page.get_by_test_id("carton-draw")).to_be_disabled()
    depth.fill("60")
    expect(page.get_by_test_id("carton-draw")).to_be_enabled()


def test_an_address_of_no_style_says_so(page: Page) -> None:
    page.evaluate("location.hash = '#/cartons/fefco-9999'")
    expect(page.get_by_text("There is no style fefco-9999.")).to_be_visible(timeout=60_000)
