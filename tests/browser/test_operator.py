"""The name of the operator: asked once on a device, shown, changed, and sent."""

from __future__ import annotations

from collections.abc import Iterator

import httpx
import pytest
from playwright.sync_api import Page, expect

from tests.browser.conftest import Running
from tests.browser.own_machine import OwnMachine

pytestmark = [
    pytest.mark.browser,
    pytest.mark.xdist_group("drawings"),
    pytest.mark.timeout(600),
]


@pytest.fixture
def machine(server: Running) -> Iterator[OwnMachine]:
    headers = {"X-Knifetip": "page"}
    with httpx.Client(base_url=server.url, timeout=60.0, trust_env=False, headers=headers) as api:
        machine = OwnMachine(api, "operator-table")
        yield machine
        machine.clear()


def test_the_operator_is_asked_once_and_recorded(
    page: Page, server: Running, machine: OwnMachine
) -> None:
    job = machine.order()
    page.get_by_test_id("to-machines").click()
    form, shown = page.get_by_test_id("operator-form"), page.get_by_test_id("operator")
    expect(form).to_be_visible()
    form.get_by_test_id("operator-name").fill("  Ada  Lovelace ")
    form.get_by_test_id("operator-keep").click()
    expect(form).to_be_hidden()
    expect(shown).to_have_text("Ada Lovelace")

    # Not asked again on this device, also not on the station page.
    page.goto(f"{server.url}/#/station/{machine.name}")
    page.reload()
    expect(shown).to_have_text("Ada Lovelace")
    expect(form).to_be_hidden()
    shown.click()
    form.get_by_test_id("operator-name").fill("Ben")
    form.get_by_test_id("operator-keep").click()
    expect(shown).to_have_text("Ben")

    claim = machine.claim()
    checks = page.get_by_test_id("check")
    expect(checks.first).to_be_visible()
    for check in checks.all():
        check.click()
    with page.expect_response(lambda answer: answer.url.endswith("/confirm")) as confirmed:
        page.get_by_test_id("station-start").click()
    assert confirmed.value.ok

    events = machine.api.get(f"/api/jobs/{job}/events").json()
    assert "operator Ben" in [event["who"] for event in events]
    machine.report(claim, 1)
    machine.finish(claim, "done")
