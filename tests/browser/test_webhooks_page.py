"""Webhooks on the page: from the address of a new one to the attempts of each delivery."""

from __future__ import annotations

import json
from collections.abc import Iterator

import pytest
from playwright.sync_api import Locator, Page, expect
from standardwebhooks import WebhookVerificationError

from tests.browser.conftest import Running
from tests.support.serving.webhook_receiver import Receiver, run_receiver

pytestmark = [
    pytest.mark.browser,
    pytest.mark.xdist_group("browser"),
    pytest.mark.timeout(600),
]

HOSTILE = "<img src=x onerror=alert(1)>\x1b[31m\u202e".encode()


@pytest.fixture
def receiver() -> Iterator[Receiver]:
    with run_receiver() as found:
        yield found


@pytest.fixture
def row(page: Page, server: Running, receiver: Receiver) -> Iterator[Locator]:
    """Add a webhook on the page; delete it after the test."""
    page.goto(f"{server.url}/#/webhooks")
    page.get_by_test_id("webhook-url").fill(receiver.url)
    page.get_by_test_id("webhook-description").fill("ERP")
    page.get_by_test_id("webhook-events").fill("finished")
    page.get_by_role("option", name="Job finished").click()
    page.keyboard.press("Escape")
    page.get_by_test_id("webhook-save").click()
    found = page.get_by_test_id("webhook-row")
    expect(found).to_contain_text("Job finished")
    yield found
    found.get_by_role("button", name="Delete", exact=True).click()
    page.get_by_test_id("confirm-yes").click()
    expect(found).to_have_count(0)


def test_a_test_event_shows_its_result(page: Page, row: Locator, receiver: Receiver) -> None:
    secret = page.get_by_test_id("webhook-secret").inner_text()
    row.get_by_test_id("webhook-test").click()
    result = row.get_by_test_id("webhook-test-result")
    expect(result).to_contain_text("Delivered: Status 204")
    (call,) = receiver.calls
    call.verify(secret)
    page.reload()
    expect(row).to_have_count(1)
    expect(page.get_by_test_id("webhook-secret")).to_have_count(0)
    receiver.answer = lambda _call: (500, {"Content-Type": "text/html"})
    receiver.body = HOSTILE + b"z" * 5000
    row.get_by_test_id("webhook-test").click()
    expect(result).to_contain_text("Status 500")
    expect(result).to_contain_text("<img src=x onerror=alert(1)>")
    assert page.locator("img[src=x]").count() == 0
    assert len(result.inner_text()) < 400


def test_a_webhook_is_edited(page: Page, row: Locator, receiver: Receiver) -> None:
    with run_receiver() as other:
        row.get_by_test_id("webhook-edit").click()
        row.get_by_test_id("webhook-url").fill("ftp://erp.example")
        row.get_by_test_id("webhook-save").click()
        expect(page.get_by_role("alert")).to_contain_text("not valid")
        # What was typed is not lost.
        row.get_by_test_id("webhook-url").fill(other.url)
        row.get_by_test_id("webhook-description").fill("Second ERP")
        row.get_by_test_id("webhook-save").click()
        expect(row).to_contain_text("Second ERP")
        expect(page.get_by_role("alert")).to_have_count(0)
        row.get_by_test_id("webhook-test").click()
        other.wait(lambda calls: len(calls) == 1)
    assert receiver.calls == []
    row.get_by_test_id("webhook-switch").click()
    expect(row).to_contain_text("Switched off")
    expect(row.get_by_test_id("webhook-test")).to_be_disabled()


def test_deliveries_are_listed_and_sent_again(page: Page, row: Locator, receiver: Receiver) -> None:
    receiver.answer = lambda _call: (410, {})
    receiver.body = b"closed for the holidays"
    row.get_by_test_id("webhook-test").click()
    expect(row).to_contain_text("Switched off")
    receiver.answer = lambda _call: (200, {})
    receiver.body = b"welcome back"
    row.get_by_test_id("webhook-deliveries").click()
    delivery = row.get_by_test_id("delivery")
    expect(delivery).to_have_attribute("data-state", "dead")
    delivery.get_by_role("button").first.click()
    attempts = delivery.get_by_test_id("attempt")
    expect(attempts).to_contain_text(["Status 410"])
    expect(attempts).to_contain_text(["closed for the holidays"])
    expect(row.get_by_test_id("replay-all")).to_be_disabled()
    row.get_by_test_id("webhook-switch").click()
    row.get_by_test_id("replay-all").click()
    expect(delivery).to_have_attribute("data-state", "delivered")
    expect(attempts).to_contain_text(["Status 410", "welcome back"])
    delivery.get_by_test_id("replay").click()
    expect(attempts).to_have_count(3)
    assert len({call.id for call in receiver.calls}) == 1
    shown = json.loads(delivery.get_by_test_id("payload").inner_text())
    assert shown == receiver.calls[0].payload


def test_the_secret_is_replaced_with_an_overlap(
    page: Page, row: Locator, receiver: Receiver
) -> None:
    former = page.get_by_test_id("webhook-secret").inner_text()
    page.get_by_role("button", name="Done").click()
    row.get_by_test_id("webhook-rotate").click()
    page.get_by_test_id("webhook-rotate-yes").click()
    present = row.get_by_test_id("webhook-secret").inner_text()
    expect(row).to_contain_text("Also signed with the old secret until")
    row.get_by_test_id("webhook-test").click()
    (call,) = receiver.wait(lambda calls: len(calls) == 1)
    call.verify(former)
    call.verify(present)
    row.get_by_test_id("webhook-rotate").click()
    page.get_by_role("combobox", name="Also sign with the old secret").click()
    page.get_by_role("option", name="0 hours").click()
    page.get_by_test_id("webhook-rotate-yes").click()
    expect(row).not_to_contain_text("signed with the old secret")
    last = row.get_by_test_id("webhook-secret").inner_text()
    row.get_by_test_id("webhook-test").click()
    (_, call) = receiver.wait(lambda calls: len(calls) == 2)
    call.verify(last)
    with pytest.raises(WebhookVerificationError):
        call.verify(present)
