"""GET /api/drawings/{id}/folding and folding.glb."""

from __future__ import annotations

from typing import Any

import httpx
import pytest

from tests.support.serving.server import square, upload_drawing
from tests.support.writers import dxf_text as text

pytestmark = pytest.mark.xdist_group("server")


@pytest.fixture
def drawing(client: httpx.Client) -> str:
    """A square of 100 mm with a crease at x = 60."""
    fold = text.line(60.0, 0.0, 60.0, 100.0, (8, "CREASE"))
    id: str = upload_drawing(client, square(extra=(fold,)))["id"]
    return id


def get(client: httpx.Client, id: str, **query: Any) -> httpx.Response:
    return client.get(f"/api/drawings/{id}/folding", params={"board": "c-flute", **query})


def test_two_panels_fold_by_90_degrees_away_from_the_outside(
    client: httpx.Client, drawing: str
) -> None:
    body = get(client, drawing).json()
    assert (body["caliper"], body["fraction"], body["findings"]) == (4.0, 1.0, [])
    assert [panel["area"] for panel in body["panels"]] == pytest.approx([6000.0, 4000.0], abs=0.5)
    (fold,) = body["folds"]
    assert (fold["type"], fold["angle"], fold["closes"]) == ("crease", -90.0, False)
    assert [end[0] for end in fold["axis"]] == [60.0, 60.0]
    assert [end[2] for end in fold["axis"]] == [2.0, 2.0]
    turned = body["panels"][fold["child"] - 1]["transform"]
    # The point (100, 0) of the middle face hangs 40 mm below the fold.
    x, y, z = (row[0] * 100.0 + row[2] * 2.0 + row[3] for row in turned[:3])
    assert (x, y, z) == pytest.approx((60.0, 0.0, -38.0), abs=1e-6)


def test_angles_and_fractions_of_the_request_count(client: httpx.Client, drawing: str) -> None:
    body = get(client, drawing, angle="1:60", fraction=0.0).json()
    assert body["folds"][0]["angle"] == 60.0
    assert body["panels"][1]["transform"][0] == [1.0, 0.0, 0.0, 0.0]
    first, second = get(client, drawing), get(client, drawing, side_up="inside")
    assert first.headers["ETag"] != second.headers["ETag"]
    again = client.get(
        f"/api/drawings/{drawing}/folding",
        params={"board": "c-flute"},
        headers={"If-None-Match": first.headers["ETag"]},
    )
    assert again.status_code == 304


@pytest.mark.parametrize(
    ("query", "status", "code"),
    [
        ({"board": "no-such-board"}, 404, "library.unknown"),
        ({"angle": "1:181"}, 422, "folding.angle-invalid"),
        ({"angle": "1:nan"}, 422, "folding.angle-invalid"),
        ({"angle": "one"}, 422, "folding.angle-invalid"),
        ({"angle": "9:10"}, 422, "folding.no-such-fold"),
        ({"fraction": 1.5}, 422, None),
        ({"opening": 0}, 422, None),
    ],
)
def test_bad_requests_are_refused(
    client: httpx.Client, drawing: str, query: dict[str, Any], status: int, code: str | None
) -> None:
    answer = get(client, drawing, **query)
    assert answer.status_code == status
    assert code is None or answer.json()["code"] == code


def test_a_drawing_without_a_unit_is_refused(client: httpx.Client) -> None:
    id = upload_drawing(client, square(units=None, side=4.0))["id"]
    assert get(client, id).status_code == 422


def test_the_glb_file_has_its_media_type_and_a_name(client: httpx.Client, drawing: str) -> None:
    answer = client.get(f"/api/drawings/{drawing}/folding.glb", params={"board": "e-flute"})
    assert answer.status_code == 200
    assert answer.headers["Content-Type"] == "model/gltf-binary"
    assert answer.headers["Content-Disposition"] == f'attachment; filename="{drawing}.glb"'
    assert answer.content[:4] == b"glTF"
    assert int.from_bytes(answer.content[8:12], "little") == len(answer.content)
