"""Names with an effect where they are shown, in the library, in users and in refused requests."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from urllib.parse import quote

import httpx
import pytest

from knifetip.library.definition import Shelf
from knifetip.messages.characters import TextKind, control_character
from knifetip.service.settings import Settings
from tests.support.hostile_names import HOSTILE_NAMES, acting
from tests.support.serving.server import run_server

SHIPPED = {"machines": "demo-table", "boards": "e-flute", "tools": "static-knife"}
#: Names that act on nothing but a page, which shows them as text.
VISIBLE = [name for name in HOSTILE_NAMES.values() if not acting(name) and "\ud800" not in name]
LONG = 10_000 * "W"


@pytest.fixture
def shop(database_url: str, tmp_path: Path) -> Iterator[httpx.Client]:
    with run_server(Settings(database=database_url, compiles=False, page=tmp_path)) as client:
        yield client


def put(client: httpx.Client, path: str, body: object, **query: str) -> httpx.Response:
    # Escapes, since UTF-8 has no lone surrogates.
    headers = {"Content-Type": "application/json"}
    return client.put(f"/api/{path}", content=json.dumps(body), headers=headers, params=query)


def texts(value: object) -> Iterator[str]:
    if isinstance(value, str):
        yield value
    elif isinstance(value, dict):
        for key, one in value.items():
            yield key
            yield from texts(one)
    elif isinstance(value, list):
        for one in value:
            yield from texts(one)


def assert_harmless(answer: httpx.Response) -> None:
    assert answer.status_code == 200, answer.text
    for text in texts(answer.json()):
        assert acting(text, permitted="\n\t") == set(), text


def test_names_in_the_library_are_stored_as_text_or_refused(shop: httpx.Client) -> None:
    fields: dict[str, dict[str, Any]] = {
        shelf: shop.get(f"/api/{shelf}/{name}/definition").json()["fields"]
        for shelf, name in SHIPPED.items()
    }
    stations = fields["machines"]["station"]
    for at, name in enumerate([*HOSTILE_NAMES.values(), LONG]):
        changed = {
            **{f"{shelf}/title-{at}": {**fields[shelf], "title": name} for shelf in Shelf},
            f"machines/station-{at}": {
                **fields["machines"],
                "station": [{**stations[0], "name": name}, *stations[1:]],
            },
            f"machines/zone-{at}": {
                **fields["machines"],
                "zone": [{"name": name, "x": 1, "y": 1, "width": 5, "height": 5, "top": 5}],
            },
            f"boards/tool-{at}": {**fields["boards"], "deflection": {name: {"x": 0.1, "y": 0.1}}},
            f"machines/unknown-{at}": {**fields["machines"], name: 1},
            f"profiles/title-{at}": {"title": name, "extends": None, "rules": []},
        }
        for path, body in changed.items():
            answer = put(shop, path, body)
            visible = name in VISIBLE and not path.startswith("machines/unknown")
            # A lone surrogate of a title becomes a question mark.
            stored = (201,) if visible else (201, 422) if "\ud800" in name else (422,)
            assert answer.status_code in stored, (path, answer.text)
        if "\ud800" not in name:
            noted = put(shop, f"boards/note-{at}", fields["boards"], by=name[:100], note=name[:200])
            refused = control_character(name[:100], TextKind.LINE)
            assert noted.status_code == (422 if refused else 201), noted.text
            if not refused:
                assert_harmless(shop.get(f"/api/boards/note-{at}/versions"))
    for path in ("library", "machines", "boards", "tools", "profiles"):
        assert_harmless(shop.get(f"/api/{path}"))


def test_names_in_refused_requests_are_harmless_in_the_audit_log(shop: httpx.Client) -> None:
    user = {"password": "four words of text", "role": "viewer"}
    for name in [*HOSTILE_NAMES.values(), LONG[:200]]:
        body = json.dumps({**user, "name": name})
        headers = {"Content-Type": "application/json"}
        assert shop.post("/api/users", content=body, headers=headers).status_code == 422
        part = quote(name.encode("utf-8", "replace").decode(), safe="")
        for path in ("boards", "profiles", "users"):
            method = "PATCH" if path == "users" else "DELETE"
            answer = shop.request(method, f"/api/{path}/{part}", json={})
            assert answer.status_code in (404, 422), answer.text
    assert_harmless(shop.get("/api/audit", params={"limit": 200}))


def test_a_download_has_the_name_of_its_entry_only(shop: httpx.Client) -> None:
    fields = shop.get("/api/boards/e-flute/definition").json()["fields"]
    for at, name in enumerate(VISIBLE):
        assert put(shop, f"boards/own-{at}", {**fields, "title": name}).status_code == 201
        answer = shop.get(f"/api/boards/own-{at}/toml")
        assert f'filename="own-{at}.toml"' in answer.headers["content-disposition"]
        assert answer.headers["x-content-type-options"] == "nosniff"
        assert answer.headers["content-type"].startswith("application/toml")
