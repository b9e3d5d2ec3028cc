"""site: serves the built page at / and, for its own routes, whatever is no file and no API."""

from __future__ import annotations

from pathlib import Path

from starlette.datastructures import Headers
from starlette.exceptions import HTTPException
from starlette.responses import FileResponse, HTMLResponse, Response
from starlette.staticfiles import NotModifiedResponse
from starlette.types import Receive, Scope, Send

#: The page loads nothing from elsewhere.  Its widgets set styles in the document itself.
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
it: see <a href="/api/openapi.json">/api/openapi.json</a>.</p>
"""
# Built files have their content's hash in the name, so they never change.
_FOREVER = "public, max-age=31536000, immutable"


class Site:
    """ASGI application over a folder."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder.resolve()

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer with a file, the page, or 404."""
        if scope["type"] != "http":
            return
        path: str = scope["path"]
        if path == "/api" or path.startswith("/api/"):
            raise HTTPException(404)
        if scope["method"] not in ("GET", "HEAD"):
            raise HTTPException(405, headers={"Allow": "GET, HEAD"})
        await self.answer(path, Headers(scope=scope))(scope, receive, send)

    def answer(self, path: str, headers: Headers) -> Response:
        """Return the file at a path, or the page, which has routes of its own."""
        file = self._file(path)
        if file is None and path.rsplit("/", 1)[-1].count("."):
            raise HTTPException(404)
        page = file is None or file.name == "index.html"
        file = file or self._file("/index.html")
        if file is None:
            return HTMLResponse(
                _UNBUILT,
                headers={"Cache-Control": "no-store", "Content-Security-Policy": PAGE_POLICY},
            )
        response = FileResponse(
            file,
            stat_result=file.stat(),
            headers={
                "Cache-Control": (
                    _FOREVER if path.startswith("/assets/") and not page else "no-cache"
                ),
                "Content-Security-Policy": PAGE_POLICY,
                "X-Frame-Options": "SAMEORIGIN",
            },
        )
        if response.headers["etag"] == headers.get("if-none-match"):
            return NotModifiedResponse(response.headers)
        return response

    def _file(self, path: str) -> Path | None:
        if "\0" in path:
            return None
        file = (self.folder / path.lstrip("/")).resolve()
        return file if file.is_relative_to(self.folder) and file.is_file() else None
