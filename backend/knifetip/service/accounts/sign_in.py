"""Sign-in of browsers: by name and password, by a link with the server's key, or by entering it.

``GET /?key=KEY`` and ``POST /sign-in`` set a session cookie and then show the page.  A session of
the server's key is ``EXPIRY.SIGNATURE``, signed with the key: the server stores none of them, and a
new key invalidates them.  A session of a user is a random token, see ``session_store``.
"""

from __future__ import annotations

import hashlib
import hmac
import html
import re
from collections.abc import Sequence
from typing import Final, NamedTuple
from urllib.parse import parse_qs, urlencode

from fastapi import Response
from fastapi.responses import HTMLResponse
from starlette.requests import Request

from knifetip.service.accounts.pairing_store import DEVICE_LIFETIME
from knifetip.service.accounts.session_store import LIFETIME as USER_LIFETIME

PATH = "/sign-in"
PAIR_PATH = "/pair"
OIDC_PATH = "/sign-in/oidc"  #: begins a sign-in at the provider
LIFETIME = 30 * 24 * 3600  #: lifetime of a session (s)
_PORT: Final = re.compile(r":([0-9]{1,5})$")
_PORTS: Final = {"http": 80, "https": 443}
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
<main>
<h1>knifetip</h1>
<p role="alert" style="color: #b00020">{fault}</p>
{forms}
</main>
</html>
"""
_STYLE = "font: inherit; width: 100%; box-sizing: border-box; padding: 0.4rem"
_PASSWORD_FORM = """<form method="post" action="{path}">
<p><label for="name">Name</label><br>
<input id="name" name="name" autocomplete="username" autocapitalize="none" required autofocus
maxlength="64" style="{style}"></p>
<p><label for="password">Password</label><br>
<input id="password" name="password" type="password" autocomplete="current-password" required
style="{style}"></p>
<button style="font: inherit; padding: 0.4rem 1rem">Sign in</button>
</form>"""
_KEY_FORM = """<form method="post" action="{path}">
<p><label for="key">Key</label><br>
<input id="key" name="key" type="password" autocomplete="{complete}" required style="{style}"></p>
<button style="font: inherit; padding: 0.4rem 1rem">{button}</button>
</form>
<p>The key, or a link with it, is in the server's start log.</p>"""
_PROVIDER_LINK = """<p><a href="{path}">Sign in with {title}</a></p>"""
_PAIR_LINK = """<p><a href="{path}">Pair this device with a machine</a></p>"""
_PAIR_FORM = """<h2>Pair this device with a machine</h2>
<p>An administrator makes the code: under the machine, <em>Paired devices</em>. It is for one device
and for ten minutes.</p>
<form method="post" action="{path}">
<p><label for="code">Code</label><br>
<input id="code" name="code" autocomplete="off" autocapitalize="characters" spellcheck="false"
required autofocus maxlength="20" style="{style}; font-size: 1.6rem; letter-spacing: 0.1em"></p>
<p><label for="device">Name of this device</label><br>
<input id="device" name="device" autocomplete="off" maxlength="100"
placeholder="Tablet at the table" style="{style}"></p>
<button style="font: inherit; padding: 0.6rem 1.4rem">Pair</button>
</form>"""
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


async def given_fields(request: Request) -> dict[str, str] | None:
    """Return the fields of a sign-in request: ``key``, or ``name`` and ``password``.

    The result is None if the request is neither a sign-in form nor a URL with a key, and empty if
    the form is too long or contains none of these fields.
    """
    path = request.url.path
    if request.method == "GET" and path != "/api" and not path.startswith("/api/"):
        key = request.query_params.get("key")
        return None if key is None else {"key": key}
    if request.method != "POST" or path != PATH:
        return None
    # A password may begin or end with a space.
    return {
        name: text if name == "password" else text.strip()
        for name, text in (await _form(request, ("key", "name", "password"))).items()
    }


async def pairing_fields(request: Request) -> dict[str, str]:
    """Return the fields of a request to pair a device: ``code``, and ``device`` for its name."""
    return await _form(request, ("code", "device"))


async def _form(request: Request, names: Sequence[str]) -> dict[str, str]:
    """Return the fields of a form that have one of some names; none if it is too long."""
    body = b""
    async for block in request.stream():
        body += block
        if len(body) > _LONGEST:
            return {}
    fields = parse_qs(body.decode("ascii", "replace"))
    return {name: fields[name][0] for name in names if name in fields}


def wants_page(request: Request) -> bool:
    """Return whether a request accepts HTML in its response."""
    return "text/html" in request.headers.get("accept", "")


class Cookie(NamedTuple):
    """Name, value and lifetime of a session cookie."""

    name: str
    value: str
    lifetime: int  #: seconds


def key_cookie(key: str, now: float) -> Cookie:
    """Return the cookie of a session of the server's key that begins at ``now``."""
    return Cookie(cookie_name(key), new_session(key, now), LIFETIME)


def user_cookie(request: Request, token: str) -> Cookie:
    """Return the cookie of a session of a user."""
    return Cookie(session_cookie(request), token, int(USER_LIFETIME))


def device_cookie(request: Request, token: str) -> Cookie:
    """Return the cookie of a paired device."""
    return Cookie(session_cookie(request), token, int(DEVICE_LIFETIME))


def session_cookie(request: Request) -> str:
    """Return the name of the cookie of a user's session.

    It contains the port, because a browser sends the same cookies to all ports of a host.
    """
    port = _PORT.search(request.headers.get("host", ""))
    return f"knifetip-session-{port[1] if port else _PORTS.get(request.scope['scheme'], 80)}"


def set_cookie(request: Request, answer: Response, cookie: Cookie) -> None:
    """Add a session cookie to a response: not for scripts, nor for requests of other sites."""
    answer.set_cookie(
        cookie.name,
        cookie.value,
        max_age=cookie.lifetime,
        path="/",
        secure=request.url.scheme == "https",
        httponly=True,
        samesite="strict",
    )


def welcome(request: Request, cookie: Cookie, place: str = "") -> Response:
    """Return a page that sets the session cookie and then loads the same URL without the key.

    After a sign-in at a provider it loads the page of the server.

    Parameters
    ----------
    request
        The request.
    cookie
        The session cookie.
    place
        Fragment of the URL: the view that the page opens; "" for the first one.
    """
    # Not a redirect: after a link from another site a browser would follow it without the cookie.
    path, rest = "/", ""
    if request.method != "POST" and not request.url.path.startswith(OIDC_PATH):
        path = "/" + request.url.path.lstrip("/")
        rest = urlencode([pair for pair in request.query_params.multi_items() if pair[0] != "key"])
    url = (f"{path}?{rest}" if rest else path) + place
    refresh = _refresh(url)
    answer = HTMLResponse(
        f'<!doctype html><html lang="en"><meta charset="utf-8"><title>knifetip</title>{refresh}'
        f'<p><a href="{html.escape(url)}">Signed in</a></p></html>',
        headers=_HEADERS,
    )
    set_cookie(request, answer, cookie)
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


class SignInMethods(NamedTuple):
    """The methods with which a user can sign in to a server."""

    password: bool  #: by name and password
    key: bool  #: by the key with which the server was started
    provider: str = ""  #: name of the provider of OpenID Connect; empty for none


def sign_in_page(ways: SignInMethods, fault: str = "", *, again: str = "") -> Response:
    """Return the sign-in page as a response with status 401.

    Parameters
    ----------
    ways
        The forms of the page.
    fault
        Error message on the page; "" for none.
    again
        URL that the browser loads first, before it shows the form; "" for none.
    """
    forms = []
    if ways.provider:
        forms.append(_PROVIDER_LINK.format(path=OIDC_PATH, title=html.escape(ways.provider)))
    if ways.password:
        forms.append(_PASSWORD_FORM.format(path=PATH, style=_STYLE))
    if ways.key:
        button = "Sign in with the key" if ways.password else "Sign in"
        complete = "off" if ways.password else "current-password"
        form = _KEY_FORM.format(path=PATH, style=_STYLE, button=button, complete=complete)
        if ways.password:
            form = f"<details><summary>Use the key of the server</summary>{form}</details>"
        forms.append(form)
    forms.append(_PAIR_LINK.format(path=PAIR_PATH))
    refresh = _refresh(again) if again else ""
    body = _PAGE.format(fault=html.escape(fault), forms="\n".join(forms), refresh=refresh)
    return HTMLResponse(body, 401, headers=_HEADERS)


def pairing_page(fault: str = "") -> Response:
    """Return the page on which a device is paired with a machine.

    Parameters
    ----------
    fault
        Error message on the page; "" for none.
    """
    form = _PAIR_FORM.format(path=PAIR_PATH, style=_STYLE)
    body = _PAGE.format(fault=html.escape(fault), forms=form, refresh="")
    return HTMLResponse(body, 401 if fault else 200, headers=_HEADERS)


def _refresh(url: str) -> str:
    return f'<meta http-equiv="refresh" content="0; url={html.escape(url)}">'
