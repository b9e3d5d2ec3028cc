"""GET /api/drawings/{id}/cleaning: the outcome of each edge."""

from __future__ import annotations

from itertools import pairwise
from typing import get_args

import httpx
import pytest

from knifetip.model.cleaned import CleaningReason
from knifetip.service.drawings.report_models import CleaningRow
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


def test_a_loop_at_a_corner_is_reported_by_its_reason(client: httpx.Client) -> None:
    curl = [(0.0, 0.0), (0.0, -0.1), (-0.1, -0.1), (-0.1, -0.01), (-0.02, -0.01), (0.0, 0.0)]
    lines = tuple(text.line(*one, *other, (8, "CUT")) for one, other in pairwise(curl))
    id = upload_drawing(client, square(extra=lines))["id"]
    # Lengths of a tenth make the unit doubtful in so small a drawing.
    assert client.patch(f"/api/drawings/{id}", json={"unit": "mm"}).status_code == 200
    body = client.get(f"/api/drawings/{id}/cleaning").json()
    assert [row["reason"] for row in body["rows"]] == ["loop"] * 5
    assert body["lengths"]["worked"] == 400.0


def test_the_schema_names_every_reason() -> None:
    unchanged = {CleaningReason.AS_DRAWN, CleaningReason.NO_WORK}
    words = {reason.name.lower() for reason in CleaningReason if reason not in unchanged}
    assert set(get_args(CleaningRow.model_fields["reason"].annotation)) == words


def test_cleaning_without_a_unit_is_refused(client: httpx.Client) -> None:
    id = upload_drawing(client, square(units=None, side=4.0))["id"]
    answer = client.get(f"/api/drawings/{id}/cleaning")
    assert answer.status_code == 422
    assert "unit" in answer.json()["detail"]
