"""Job ticket and exports on the page: what the links of a drawing and of a job download."""

from __future__ import annotations

import httpx
import pytest
from playwright.sync_api import Page, expect

from tests.browser.conftest import Running
from tests.browser.own_machine import OwnMachine

pytestmark = [
    pytest.mark.browser,
    pytest.mark.xdist_group("drawings"),
    pytest.mark.timeout(120),
]


def test_a_job_has_a_ticket_and_its_drawing_and_path_are_exported(
    page: Page, server: Running
) -> None:
    headers = {"X-Knifetip": "page"}
    with httpx.Client(base_url=server.url, timeout=60.0, trust_env=False, headers=headers) as api:
        machine = OwnMachine(api, "handover-table")
        drawing = machine.upload("handed-over.dxf")
        job = machine.order(drawing)
        page.goto(f"{server.url}/#/drawings/{drawing}/jobs/{job}")
        ticket = page.get_by_test_id("ticket")
        expect(ticket).to_have_text("Job ticket")
        answer = api.get(ticket.get_attribute("href") or "")
        assert answer.headers["Content-Type"] == "application/pdf"
        for menu, step in (("export-path", "check"), ("export-drawing", "lines")):
            page.goto(f"{server.url}/#/drawings/{drawing}/{step}/jobs/{job}")
            page.get_by_test_id(menu).click()
            item = page.get_by_test_id(f"{menu}-dxf")
            expect(item).to_be_visible()
            answer = api.get(item.get_attribute("href") or "")
            assert answer.headers["Content-Type"] == "image/vnd.dxf"
            page.keyboard.press("Escape")
