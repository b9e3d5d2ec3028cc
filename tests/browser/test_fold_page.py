"""The page of a folded drawing: slider, folds, faults and files."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

import httpx
import pytest
import trimesh
from playwright.sync_api import Page, expect

from tests.browser.accessibility import assert_accessible
from tests.support.writers import dxf_text as text

pytestmark = [
    pytest.mark.browser,
    pytest.mark.xdist_group("drawings"),
    pytest.mark.timeout(240),
]


@pytest.fixture
def api(page: Page) -> Iterator[httpx.Client]:
    url = re.sub(r"/(#.*)?$", "", page.url)
    with httpx.Client(base_url=url, timeout=60.0, trust_env=False) as client:
        yield client


@pytest.fixture
def drawing(api: httpx.Client) -> str:
    """A tray with two walls of 40 mm and a flap of 50 mm that reaches over 100 mm."""
    corners = [(0.0, -40.0), (120.0, -40.0), (120.0, 190.0), (0.0, 190.0)]
    sides = zip(corners, corners[1:] + corners[:1], strict=True)
    cuts = [text.line(*a, *b, (8, "CUT")) for a, b in sides]
    folds = [text.line(0.0, y, 120.0, y, (8, "CREASE")) for y in (0.0, 100.0, 140.0)]
    content = text.dxf(*cuts, *folds)
    answer = api.post("/api/drawings", files={"file": ("tray.dxf", content)})
    assert answer.status_code == 201, answer.text
    return str(answer.json()["id"])


def test_a_drawing_is_folded_from_its_page_by_keys_alone(page: Page, drawing: str) -> None:
    page.evaluate("(id) => { location.hash = `#/drawings/${id}/lines` }", drawing)
    page.get_by_test_id("open-fold").press("Enter")
    expect(page.get_by_test_id("fold-view")).to_be_visible(timeout=60_000)
    expect(page.get_by_text("No panel collides")).to_be_visible()
    folds = page.get_by_test_id("folds").get_by_role("textbox")
    expect(folds).to_have_count(3)
    slider = page.get_by_role("slider")
    slider.press("Home")
    expect(slider).to_have_attribute("aria-valuenow", "0")
    page.get_by_test_id("fold-view").press("ArrowLeft")
    assert_accessible(page)
    # The wall with the flap leans over the tray; its flap passes through the bottom.
    with page.expect_response(re.compile(r"/folding\?.*angle=")):
        for k in range(3):
            folds.nth(k).fill("-150")
    expect(page.get_by_test_id("fold-findings").get_by_role("button").first).to_be_visible()
    with page.expect_download() as saved:
        page.get_by_role("button", name="Save 3D model (glTF)").press("Enter")
    assert saved.value.suggested_filename == "tray.dxf.glb"
    with saved.value.path().open("rb") as file:
        model: Any = trimesh.load(file, file_type="glb")
    assert len(model.graph.nodes_geometry) > 3
    with page.expect_download() as saved:
        page.get_by_role("button", name="Save picture (PNG)").press("Enter")
    assert saved.value.path().read_bytes()[:8] == b"\x89PNG\r\n\x1a\n"
    page.get_by_role("link", name="Back to the drawing").press("Enter")
    expect(page.get_by_test_id("open-fold")).to_be_visible()
