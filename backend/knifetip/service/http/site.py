"""Static files of the built web page.

Scripts and styles are sent compressed, a third of their size.  They are compressed once and kept:
their names change with their content, so there are as many as the page has.
"""

from __future__ import annotations

import asyncio
import gzip
from pathlib import Path

from starlette.datastructures import Headers
from starlette.exceptions import HTTPException
from starlette.requests import Request
from starlette.responses import HTMLResponse, Response
from starlette.staticfiles import NotModifiedResponse, StaticFiles
from starlette.types import Scope

from knifetip.service.http.compression import accepts_gzip

#: The page loads nothing from other origins.  Its components set inline styles.
PAGE_POLICY = (
    "default-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; "
    "font-src 'self' data:; worker-src 'self' blob:; object-src 'none'; base-uri 'none'; "
    "form-action 'self'; frame-ancestors 'self'"
)
_UNBUILT = """<!doctype html>
<html lang="en"><meta charset="utf-8"><title>knifetip</title>
<body style="font: 16px/1.5 system-ui; max-width: 40rem; margin: 4rem auto; padding: 0 1rem">
<h1>knifetip</h1>
<p>The service is running, but its page has not been built.</p>
<p>In a clone of the repository, <code>make run</code> builds it. The REST interface works without
it: see <a href="/api/v1/openapi.json">/api/v1/openapi.json</a>.</p>
"""
_PAGE_HEADERS = {"Content-Security-Policy": PAGE_POLICY, "X-Frame-Options": "SAMEORIGIN"}
# Names of built files contain a hash of their content, so the files never change.
_FOREVER = "public, max-age=31536000, immutable"
#: Files that become smaller by compression; fonts are compressed already.
_COMPRESSED = {".js", ".css", ".svg"}


class Site(StaticFiles):
    """ASGI application that serves the folder of the built page.

    The page is one file: its routes are in the fragment of the URL, which the server does not get.
    Every other path without a file gets the status 404.
    """

    def __init__(self, folder: Path) -> None:
        super().__init__(directory=folder, html=True, check_dir=False)
        self._folder = folder
        self._index = folder / "index.html"
        self._compressed: dict[str, bytes] = {}  # contents of files of the folder assets

    async def description_page(self, request: Request) -> Response:
        """Return the page that describes the REST API; it is built with the web page."""
        return await self.get_response("docs.html", {**request.scope, "path": "/docs.html"})

    async def get_response(self, path: str, scope: Scope) -> Response:
        """Return a file of the built page; ``/`` is the page itself.

        If the page has not been built, the response is a page that explains how to build it.

        Raises
        ------
        HTTPException
            404 for a path of the API, and for a path without a file; 405 for methods other than GET
            and HEAD.
        """
        # ``path`` is normalized: "/api/../page" is then no path of the API.
        if (scope["path"] + "/").startswith("/api/") or "\0" in path:
            raise HTTPException(404)
        if scope["method"] not in ("GET", "HEAD"):
            raise HTTPException(405, headers={"Allow": "GET, HEAD"})
        if not self._index.is_file():
            return HTMLResponse(_UNBUILT, headers={"Cache-Control": "no-store", **_PAGE_HEADERS})
        if scope["path"].startswith("//"):
            raise HTTPException(404)  # normalized, it would be another path
        response = await super().get_response(path, scope)
        is_asset = path.startswith("assets/") and "." in path.rsplit("/", 1)[-1]
        response.headers["Cache-Control"] = _FOREVER if is_asset else "no-cache"
        if isinstance(response, NotModifiedResponse):
            return response
        response.headers.update(_PAGE_HEADERS)
        if is_asset and Path(path).suffix in _COMPRESSED:
            response.headers["Vary"] = "Accept-Encoding"
            if response.status_code == 200 and accepts_gzip(Headers(scope=scope)):
                return await self._gzip_response(path, response)
        return response

    async def _gzip_response(self, path: str, plain: Response) -> Response:
        """Return the response with a compressed file of the folder ``assets``.

        ``plain``: the response without compression, whose headers are kept.
        """
        content = self._compressed.get(path)
        if content is None:
            content = await asyncio.to_thread(_compress, self._folder / path)
            self._compressed[path] = content
        kept = {"content-type", "cache-control", "vary", *map(str.lower, _PAGE_HEADERS)}
        headers = {name: value for name, value in plain.headers.items() if name in kept}
        return Response(content, headers={**headers, "content-encoding": "gzip"})


def _compress(file: Path) -> bytes:
    return gzip.compress(file.read_bytes(), mtime=0)
