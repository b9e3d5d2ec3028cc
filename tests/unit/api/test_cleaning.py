"""GET /api/drawings/{id}/cleaning: the outcome of each edge."""

from __future__ import annotations

import httpx
import pytest

from tests.support.serving.server import square, upload_drawing
from tests.support.writers import dxf_text as text

pytestmark = pytest.mark.xdist_group("server")


def test_a_side_drawn_twice_is_reported_with_its_lengths(client: httpx.Client) -> None:
    half = text.line(100.0, 0.0, 50.0, 0.0, (8, "CUT"))
    id = upload_drawing(client, square(extra=(half,)))["id"]
    body = client.get(f"/api/drawings/{id}/cleaning").json()
    assert body["lengths"] == {
        "drawn": 450.0,
        "kept": 400.0,
        "merged": 50.0,
        "dropped": 0.0,
        "added": 0.0,
        "worked": 400.0,
        "no_work": 0.0,
    }
    assert body["edges"] == {"kept": 4, "merged": 1, "dropped": 0}
    (row,) = body["rows"]
    assert (row["reason"], row["outcome"], row["merged"]) == ("twice", "merged", 50.0)
    assert row["text"] == f"the edge lies on edge {row['into']} and was merged into it"


def test_cleaning_without_a_unit_is_refused(client: httpx.Client) -> None:
    id = upload_drawing(client, square(units=None, side=4.0))["id"]
    answer = client.get(f"/api/drawings/{id}/cleaning")
    assert answer.status_code == 422
    assert "unit" in answer.json()["detail"]
