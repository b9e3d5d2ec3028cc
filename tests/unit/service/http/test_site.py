from __future__ import annotations

import asyncio
from pathlib import Path

import httpx
import pytest

from knifetip.service.http.site import Site

pytestmark = pytest.mark.xdist_group("server")


@pytest.mark.parametrize("path", ["/", "/index.html"])
def test_the_page_is_served_at_its_own_routes_and_revalidated(
    client: httpx.Client, path: str
) -> None:
    answer = client.get(path)
    assert "the built page" in answer.text
    assert answer.headers["cache-control"] == "no-cache"
    assert "script-src" not in answer.headers["content-security-policy"]
    assert answer.headers["content-security-policy"].startswith("default-src 'self';")
    assert answer.headers["x-frame-options"] == "SAMEORIGIN"
    again = client.get(path, headers={"If-None-Match": answer.headers["etag"]})
    assert again.status_code == 304
    # Otherwise the browser would use it in place of the page's own file, and load nothing.
    assert "content-security-policy" not in again.headers


def test_built_files_are_cached_for_ever(client: httpx.Client) -> None:
    answer = client.get("/assets/main-4f2a.js")
    assert answer.text == "export const knife = 1\n"
    assert "immutable" in answer.headers["cache-control"]
    assert answer.headers["content-type"].startswith("text/javascript")


@pytest.mark.parametrize(
    ("accepted", "encoding"),
    [
        ("gzip, deflate, br", "gzip"),
        ("br;q=1.0, gzip;q=0.8", "gzip"),
        ("*", "gzip"),
        ("br", None),
        ("", None),
        ("gzip;q=0", None),
        ("gzip;q=0.0, br", None),
        ("x-gzip", None),
    ],
)
def test_scripts_are_compressed_for_clients_that_accept_it(
    client: httpx.Client, accepted: str, encoding: str | None
) -> None:
    answer = client.get("/assets/main-4f2a.js", headers={"Accept-Encoding": accepted})
    assert answer.headers.get("content-encoding") == encoding
    assert answer.text == "export const knife = 1\n"
    assert answer.headers["vary"] == "Accept-Encoding"
    assert "immutable" in answer.headers["cache-control"]
    assert answer.headers["content-type"].startswith("text/javascript")
    assert answer.headers["content-security-policy"].startswith("default-src 'self';")


def test_a_part_of_a_script_is_not_compressed(client: httpx.Client) -> None:
    headers = {"Accept-Encoding": "gzip", "Range": "bytes=0-5"}
    answer = client.get("/assets/main-4f2a.js", headers=headers)
    assert (answer.status_code, answer.content) == (206, b"export")


@pytest.mark.parametrize(
    "path",
    [
        *("/assets/gone.js", "/%2e%2e/secret.txt", "/..%2fsecret.txt", "/assets/%00.js"),
        # The routes of the page are fragments: these are no pages.
        *("/jobs/abc", "/static/x", "//etc/passwd", "//index.html", "/station/demo-table"),
    ],
)
def test_nothing_beside_the_page_is_served(client: httpx.Client, path: str) -> None:
    # A whole URL: of a path, the client removes the first slash.
    answer = client.get(str(client.base_url).rstrip("/") + path)
    assert answer.status_code == 404
    assert "not for you" not in answer.text


def test_without_a_built_page_the_response_explains_how_to_build_it(tmp_path: Path) -> None:
    scope = {"type": "http", "method": "GET", "path": "/", "headers": []}
    answer = asyncio.run(Site(tmp_path / "page").get_response(".", scope))
    assert answer.status_code == 200
    assert b"make run" in answer.body


@pytest.mark.parametrize("path", ["/docs", "/api/docs", "/api/v1/docs"])
def test_the_description_of_the_api_is_a_page_of_this_server(
    client: httpx.Client, path: str
) -> None:
    answer = client.get(path, follow_redirects=True)
    assert answer.status_code == 200
    assert "the description" in answer.text
    assert answer.headers["content-security-policy"].startswith("default-src 'self';")
