"""GET /api/drawings/{id}/blanks: areas and outlines of the blanks of a drawing."""

from __future__ import annotations

import httpx
import pytest

from tests.support.serving.server import square, upload_drawing
from tests.support.writers import dxf_text as text

pytestmark = pytest.mark.xdist_group("server")


def test_the_blank_of_a_square_with_a_hole_has_its_area_and_corners(client: httpx.Client) -> None:
    corners = [(40.0, 40.0), (60.0, 40.0), (60.0, 50.0), (40.0, 50.0)]
    hole = [
        text.line(*one, *other, (8, "CUT"))
        for one, other in zip(corners, corners[1:] + corners[:1], strict=True)
    ]
    id = upload_drawing(client, square(extra=tuple(hole)))["id"]
    body = client.get(f"/api/drawings/{id}/blanks").json()
    assert body["area"] == 9800.0
    (blank,) = body["blanks"]
    assert (blank["area"], blank["bounds"]) == (9800.0, [0.0, 0.0, 100.0, 100.0])
    assert sorted(blank["outline"]) == [[0.0, 0.0], [0.0, 100.0], [100.0, 0.0], [100.0, 100.0]]
    assert signed_area(blank["outline"]) == 10000.0
    assert [signed_area(hole) for hole in blank["holes"]] == [-200.0]


def signed_area(corners: list[list[float]]) -> float:
    following = corners[1:] + corners[:1]
    return sum(x0 * y1 - x1 * y0 for (x0, y0), (x1, y1) in zip(corners, following, strict=True)) / 2


def test_an_edge_that_becomes_a_crease_leaves_no_blank(client: httpx.Client) -> None:
    id = upload_drawing(client, square())["id"]
    assert len(client.get(f"/api/drawings/{id}/blanks").json()["blanks"]) == 1
    patch = {"overrides": [{"type": "crease", "edges": [1]}]}
    assert client.patch(f"/api/drawings/{id}/edges", json=patch).status_code == 200
    assert client.get(f"/api/drawings/{id}/blanks").json() == {"area": 0.0, "blanks": []}


def test_areas_without_a_unit_are_refused(client: httpx.Client) -> None:
    id = upload_drawing(client, square(units=None, side=4.0))["id"]
    answer = client.get(f"/api/drawings/{id}/blanks")
    assert answer.status_code == 422
    assert "unit" in answer.json()["detail"]
