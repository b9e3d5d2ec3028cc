"""/api/stock-sheets: sheets in stock, which are listed by board, counted and used up."""

from __future__ import annotations

from typing import Any

import httpx
import pytest

from knifetip.service.stock import store

pytestmark = pytest.mark.xdist_group("server")

STOCK = "/api/stock-sheets"


def add(client: httpx.Client, width: float, height: float, **fields: Any) -> dict[str, Any]:
    answer = client.post(STOCK, json={"width": width, "height": height, **fields})
    assert answer.status_code == 201, answer.text
    found: dict[str, Any] = answer.json()
    assert answer.headers["Location"] == f"{STOCK}/{found['id']}"
    return found


@pytest.fixture(autouse=True)
def _no_stock(client: httpx.Client) -> None:
    """Begin without stock: tests share a server."""
    for row in client.get(STOCK).json():
        client.delete(f"{STOCK}/{row['id']}")


def sizes(client: httpx.Client, **query: str) -> list[tuple[float, float, int | None]]:
    rows = client.get(STOCK, params=query).json()
    return [(row["width"], row["height"], row["count"]) for row in rows]


def test_sheets_are_listed_smallest_first_for_a_board(client: httpx.Client) -> None:
    add(client, 1200, 800, board="e-flute", count=None, grain="x")
    rest = add(client, 400, 300, note="left over from job 7")
    add(client, 500, 300, board="greyboard-2.0", count=3)
    assert (rest["board"], rest["grain"], rest["count"]) == ("", None, 1)
    assert rest["note"] == "left over from job 7"
    assert sizes(client) == [(400, 300, 1), (500, 300, 3), (1200, 800, None)]
    assert sizes(client, board="e-flute") == [(400, 300, 1), (1200, 800, None)]
    page = client.get(STOCK, params={"limit": 2})
    assert len(page.json()) == 2
    assert 'rel="next"' in page.headers["Link"]


def test_sheets_are_used_up(client: httpx.Client) -> None:
    address = f"{STOCK}/{add(client, 500, 300, count=2)['id']}"
    assert client.patch(address, json={"count": 1}).json()["count"] == 1
    assert client.patch(address, json={"count": 0}).status_code == 422
    assert client.delete(address).status_code == 204
    for answer in (client.delete(address), client.patch(address, json={"count": 1})):
        assert (answer.status_code, answer.json()["code"]) == (404, "stock.unknown")


def test_a_full_stock_takes_no_more(client: httpx.Client, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(store, "MOST_SIZES", 1)
    add(client, 500, 300)
    answer = client.post(STOCK, json={"width": 400, "height": 300})
    assert (answer.status_code, answer.json()["code"]) == (409, "stock.too-many")
