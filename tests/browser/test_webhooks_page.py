"""Webhooks on the page: add one, see its secret once, send a test, delete it."""

from __future__ import annotations

import pytest
from playwright.sync_api import Page, expect

from tests.browser.conftest import Running
from tests.support.serving.webhook_receiver import run_receiver

pytestmark = [pytest.mark.browser, pytest.mark.xdist_group("browser"), pytest.mark.timeout(120)]


def test_a_webhook_is_added_tested_and_deleted(page: Page, server: Running) -> None:
    page.goto(f"{server.url}/#/webhooks")
    with run_receiver() as receiver:
        page.get_by_test_id("webhook-url").fill(receiver.url)
        page.get_by_test_id("webhook-add").click()
        secret = page.get_by_test_id("webhook-secret").inner_text()
        row = page.get_by_test_id("webhook-row")
        row.get_by_test_id("webhook-test").click()
        expect(row.get_by_test_id("webhook-state")).to_contain_text("delivered")
        call = next(one for one in receiver.calls if one.payload["type"] == "webhook.test")
        call.verify(secret)
        page.reload()
        expect(row).to_have_count(1)
        expect(page.get_by_test_id("webhook-secret")).to_have_count(0)
        row.get_by_role("button", name="Delete").click()
        page.get_by_test_id("confirm-yes").click()
        expect(row).to_have_count(0)
