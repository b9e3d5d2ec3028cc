"""Sign-in of browsers, by a link with the key or by entering the key in a form.

``GET /?key=KEY`` and ``POST /sign-in`` with ``key=KEY`` set a session cookie and then show the
page. A session is ``EXPIRY.SIGNATURE``, signed with the key.  The server stores no sessions; a new
key invalidates all sessions.
"""

from __future__ import annotations

import hashlib
import hmac
import html
from urllib.parse import parse_qs, urlencode

from fastapi import Response
from fastapi.responses import HTMLResponse
from starlette.requests import Request

PATH = "/sign-in"
LIFETIME = 30 * 24 * 3600  #: lifetime of a session (s)
_LONGEST = 4096  # longest form (bytes)
_HEADERS = {
    "Cache-Control": "no-store",
    "Referrer-Policy": "same-origin",
    "Content-Security-Policy": (
        "default-src 'none'; style-src 'unsafe-inline'; form-action 'self'; base-uri 'none'; "
        "frame-ancestors 'none'"
    ),
}
_PAGE = """<!doctype html>
<html lang="en"><meta charset="utf-8"><title>knifetip: sign in</title>
<meta name="viewport" content="width=device-width, initial-scale=1">{refresh}
<body style="font: 16px/1.5 system-ui; max-width: 24rem; margin: 4rem auto; padding: 0 1rem">
<h1>knifetip</h1>
<form method="post" action="{path}">
<p><label for="key">Key</label><br>
<input id="key" name="key" type="password" autocomplete="current-password" required autofocus
style="font: inherit; width: 100%; box-sizing: border-box; padding: 0.4rem"></p>
<p role="alert">{fault}</p>
<button style="font: inherit; padding: 0.4rem 1rem">Sign in</button>
</form>
<p>The key, or a link with it, is in the server's start log.</p>
</html>
"""
_AGAIN = "again"  # query parameter of the second attempt


def cookie_name(key: str) -> str:
    """Return the name of the session cookie of a server with the key ``key``.

    The name depends on the key, because a browser sends the same cookies to all ports of a host.
    With one name, servers on different ports would overwrite each other's cookies.
    """
    return f"knifetip-{hashlib.sha256(b'cookie ' + key.encode()).hexdigest()[:8]}"


def new_session(key: str, now: float) -> str:
    """Return the value of the session cookie for a session that begins at ``now``.

    ``now`` is in seconds since 1970.
    """
    expiry = str(int(now) + LIFETIME)
    return f"{expiry}.{_signature(key, expiry)}"


def is_session(cookie: str, key: str, now: float) -> bool:
    """Return whether a session cookie is signed with the key and has not expired.

    Parameters
    ----------
    cookie
        Value of the cookie; "" if the request has none.
    key
        Access key of the server.
    now
        Current time in seconds since 1970.
    """
    expiry, _, signature = cookie.partition(".")
    if not (expiry.isascii() and expiry.isdecimal() and len(expiry) < 16):
        return False
    expected = _signature(key, expiry).encode()
    right = hmac.compare_digest(signature.encode("utf-8", "replace"), expected)
    return right and int(expiry) > now


def _signature(key: str, expiry: str) -> str:
    return hmac.new(key.encode(), f"session {expiry}".encode(), hashlib.sha256).hexdigest()


async def given_key(request: Request) -> str | None:
    """Return the key in the URL or in the sign-in form of a request.

    The result is None if the request is neither a sign-in form nor a URL with a key, and "" if the
    form is too long or contains no key.
    """
    path = request.url.path
    if request.method == "GET" and path != "/api" and not path.startswith("/api/"):
        return request.query_params.get("key")
    if request.method != "POST" or path != PATH:
        return None
    body = b""
    async for block in request.stream():
        body += block
        if len(body) > _LONGEST:
            return ""
    fields = parse_qs(body.decode("ascii", "replace"))
    return fields.get("key", [""])[0].strip()


def wants_page(request: Request) -> bool:
    """Return whether a request accepts HTML in its response."""
    return "text/html" in request.headers.get("accept", "")


def welcome(request: Request, key: str, now: float) -> Response:
    """Return a page that sets the session cookie and then loads the same URL without the key.

    ``now`` is the current time in seconds since 1970.
    """
    # Not a redirect: after a link from another site a browser would follow it without the cookie.
    path = "/" if request.method == "POST" else "/" + request.url.path.lstrip("/")
    rest = urlencode([pair for pair in request.query_params.multi_items() if pair[0] != "key"])
    url = f"{path}?{rest}" if rest else path
    refresh = _refresh(url)
    answer = HTMLResponse(
        f'<!doctype html><html lang="en"><meta charset="utf-8"><title>knifetip</title>{refresh}'
        f'<p><a href="{html.escape(url)}">Signed in</a></p></html>',
        headers=_HEADERS,
    )
    answer.set_cookie(
        cookie_name(key),
        new_session(key, now),
        max_age=LIFETIME,
        path="/",
        secure=request.url.scheme == "https",
        httponly=True,
        samesite="strict",
    )
    return answer


def retry_url(request: Request) -> str:
    """Return a URL with which a browser can repeat a refused request for the page.

    If a user follows a link from another web site, the browser omits the session cookie, and the
    request is refused.  If the sign-in page in the response then loads the returned URL, the
    browser sends the cookie.  The result is "" if the refused request already had such a URL.
    """
    # A different URL: a reload of the same one would still count as a request of the other site.
    if _AGAIN in request.query_params:
        return ""
    path = "/" + request.url.path.lstrip("/")
    return f"{path}?{urlencode([*request.query_params.multi_items(), (_AGAIN, '1')])}"


def sign_in_page(fault: str = "", *, again: str = "") -> Response:
    """Return the sign-in page as a response with status 401.

    Parameters
    ----------
    fault
        Error message on the page; "" for none.
    again
        URL that the browser loads first, before it shows the form; "" for none.
    """
    refresh = _refresh(again) if again else ""
    body = _PAGE.format(path=PATH, fault=html.escape(fault), refresh=refresh)
    return HTMLResponse(body, 401, headers=_HEADERS)


def _refresh(url: str) -> str:
    return f'<meta http-equiv="refresh" content="0; url={html.escape(url)}">'
