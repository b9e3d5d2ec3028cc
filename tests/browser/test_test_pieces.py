"""Measuring with a test piece: from a copied machine to its new version, and back."""

from __future__ import annotations

import httpx
import pytest
from playwright.sync_api import Page, expect

from tests.browser.accessibility import assert_accessible
from tests.browser.conftest import Running

pytestmark = [pytest.mark.browser, pytest.mark.xdist_group("browser"), pytest.mark.timeout(600)]


def test_the_depth_of_a_knife_is_measured_saved_and_undone(page: Page, server: Running) -> None:
    headers = {"X-Knifetip": "page"}
    with httpx.Client(base_url=server.url, headers=headers, timeout=60.0, trust_env=False) as api:
        toml = api.get("/api/machines/demo-table/toml").text
        saved = api.put(
            "/api/machines/measured-table",
            content=toml.replace("Demo table", "Measured table"),
            headers={"Content-Type": "application/toml"},
        )
        assert saved.status_code == 201, saved.text
    page.goto(f"{server.url}/#/library/machines/measured-table")
    page.get_by_test_id("measure").click()
    expect(page.get_by_test_id("piece-picture")).to_be_visible(timeout=60_000)
    page.get_by_test_id("measure-first_through").fill("1")
    page.get_by_test_id("piece-compute").click()
    expect(page.get_by_text("Even the first cut goes through")).to_be_visible()
    page.get_by_test_id("measure-first_through").fill("12")
    page.get_by_test_id("piece-compute").click()
    expect(page.get_by_test_id("figure-offset-z")).to_be_visible()
    assert_accessible(page)
    page.get_by_test_id("piece-save").click()
    expect(page.get_by_test_id("piece-saved")).to_contain_text("as version 2")
    expect(page.get_by_text("measured-table · version 2")).to_be_visible()
    page.get_by_test_id("compare-1").click()
    expect(page.get_by_test_id("differences")).to_contain_text("station 1 → datum → z")
    page.get_by_test_id("restore").click()
    expect(page.get_by_text("measured-table · version 3")).to_be_visible()
    page.get_by_test_id("piece-order").click()
    expect(page.get_by_role("heading", name="knife-depth measured-table")).to_be_visible(
        timeout=60_000
    )
    expect(page.get_by_test_id("compile")).to_be_enabled(timeout=60_000)
