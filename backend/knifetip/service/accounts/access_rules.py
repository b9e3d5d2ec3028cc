"""Rules of access: accept or refuse a request by Host, Origin, sender address and key (ADR 21).

The checks are pure functions of the headers and addresses of one request (``RequestFacts``) and of
the settings (``AccessRules``).
"""

from __future__ import annotations

import hashlib
import hmac
import ipaddress
import re
from dataclasses import dataclass
from typing import TypeAlias

from knifetip.messages import Message
from knifetip.service.accounts import sign_in as signin
from knifetip.service.http.principal import (
    ANONYMOUS,
    EMBEDDED_GATEWAY,
    LOCAL,
    SERVER_KEY,
    Principal,
)

Authority: TypeAlias = tuple[str, int | None]

#: Paths that need no key: health probes of containers and load balancers use them.
OPEN_PATHS = ("/healthz", "/readyz")

#: Requests with which users sign in and out.
SESSION_REQUESTS = (("POST", "/api/session"), ("DELETE", "/api/session"))

_SAFE = ("GET", "HEAD", "OPTIONS")
# Content types that HTML forms can send to other sites, except multipart (used for uploads).
_FORMS = ("application/x-www-form-urlencoded", "text/plain")
_PORTS = {"http": 80, "https": 443}
_AUTHORITY = re.compile(r"(\[[0-9a-f:.]+\]|[a-z0-9._-]+)(?::([0-9]{1,5}))?", re.IGNORECASE)


@dataclass(frozen=True, slots=True)
class AccessRules:
    """Settings of the access control.

    They are the access key, the accepted Host names, and whether the server is bound to loopback
    addresses only.
    """

    key: str = ""  #: empty: only requests from this computer are served
    gateway_key: str = ""  #: key of the gateway in the process of the server; empty for none
    hosts: tuple[str, ...] = ()  #: additional NAME or NAME:PORT accepted in the Host header
    loopback_only: bool = False  #: the server is bound to loopback addresses only


@dataclass(frozen=True, slots=True)
class RequestFacts:
    """Method, path, headers and addresses of one request, on which the access checks depend."""

    method: str
    path: str
    scheme: str
    host: str | None  #: None if there is no Host header, or more than one
    peer: str | None  #: address of the sender; None if unknown
    server: tuple[str, int]  #: local address and port of the connection
    origins: tuple[str, ...] = ()
    fetch_site: str | None = None
    agent: str | None = None
    content_type: str = ""
    marked: bool = False  #: has an X-Knifetip header
    authorization: str | None = None
    session: str | None = None  #: value of the cookie of a session of the server's key
    user_session: str | None = None  #: value of the cookie of a session of a user


@dataclass(frozen=True, slots=True)
class Refusal:
    """HTTP status and error message of the response to a request that is refused."""

    status: int
    message: Message

    @property
    def wrong_key(self) -> bool:
        """Whether the request was refused because its key is wrong."""
        return self.message.code == "request.wrong-key"


@dataclass(frozen=True, slots=True)
class Proof:
    """Owner of the credentials of a request, and whether an administrator exists."""

    principal: Principal | None = None  #: owner of the API key or of the session in the request
    closed: bool = False  #: an administrator exists, so that requests of this computer need a key


#: Proof without credentials, on a server without an administrator.
NO_ACCOUNTS = Proof()


def find_access(
    rules: AccessRules, facts: RequestFacts, now: float, proof: Proof = NO_ACCOUNTS
) -> Principal | Refusal:
    """Return who sends a request, or the status and message with which it is refused.

    Parameters
    ----------
    rules
        Settings of the access control.
    facts
        Method, path, headers and addresses of the request.
    now
        Current time in seconds since 1970, with which the expiry of sign-in sessions is compared.
    proof
        Owner of the credentials of the request, and whether an administrator exists.
    """
    host = parse_authority(facts.host or "")
    # Probes need no key, and are answered without a query of the keys in the database.
    bearer = None if is_probe(facts) else bearer_key(facts.authorization)
    keyed = None if bearer is None else _owner_of_key(rules, bearer, proof)
    if bearer is not None and keyed is None and _is_served(rules, facts, host, proof):
        return Refusal(401, Message("request.wrong-key"))
    # A page of another site cannot make a browser send this header.
    if host is None or not (keyed or _is_listed(rules, facts, host)):
        return _wrong_host(facts)
    return (
        _foreign_page(facts, host)
        or _html_form(facts)
        or keyed
        or _without_key(rules, facts, host, now, proof)
    )


def _owner_of_key(rules: AccessRules, bearer: str, proof: Proof) -> Principal | None:
    """Return the owner of the key in the header of a request; None for a wrong key."""
    if rules.key and same_key(bearer, rules.key):
        return SERVER_KEY
    if rules.gateway_key and same_key(bearer, rules.gateway_key):
        return EMBEDDED_GATEWAY
    return proof.principal


def _is_served(
    rules: AccessRules, facts: RequestFacts, host: Authority | None, proof: Proof
) -> bool:
    """Return whether requests of the sender are accepted, or refused whatever they contain.

    Without a key and without an administrator, only requests of this computer are accepted.
    """
    return bool(rules.key) or proof.closed or (host is not None and _is_local(rules, facts, host))


def _is_local(rules: AccessRules, facts: RequestFacts, host: Authority) -> bool:
    """Return whether a request comes from this computer and is sent to a loopback address."""
    return is_loopback(facts.peer or "") and (rules.loopback_only or is_loopback(host[0]))


def _wrong_host(facts: RequestFacts) -> Refusal:
    if facts.host is None:
        return Refusal(400, Message("request.no-host"))
    return Refusal(421, Message("request.wrong-host", host=facts.host[:100]))


def _foreign_page(facts: RequestFacts, host: Authority) -> Refusal | None:
    """Return a refusal if a page of another origin may have sent the request, otherwise None.

    ``facts``: method, path, headers and addresses of the request.
    ``host``: name and port in the Host header of the request.
    """
    if facts.method in _SAFE:
        return None
    same = False
    for origin in facts.origins:
        scheme, separator, rest = origin.partition("://")
        named = parse_authority(rest) if separator else None
        same = (
            named is not None
            and scheme.lower() == facts.scheme
            and _with_port(named, scheme.lower()) == _with_port(host, facts.scheme)
        )
        if not same:
            return Refusal(403, Message("request.foreign-page", origin=origin[:100]))
    if facts.fetch_site not in (None, "same-origin", "none"):
        return Refusal(403, Message("request.foreign-origin"))
    if same or facts.marked or facts.authorization is not None:
        return None
    if facts.session is not None or facts.user_session is not None:
        # Browsers send cookies with requests of any page; SameSite does not separate ports.
        return Refusal(403, Message("request.not-marked"))
    # The User-Agent of all browsers starts like this; pages can change it only after a preflight.
    if not facts.agent or facts.agent.lower().startswith("mozilla/"):
        return Refusal(403, Message("request.not-marked"))
    return None


def _html_form(facts: RequestFacts) -> Refusal | None:
    """Return a refusal if a request to the API may come from an HTML form, otherwise None.

    Such requests have a content type that HTML forms use.  They are refused because a form on any
    web site can send a request to this server from the browser of a user.
    """
    kind = facts.content_type.partition(";")[0].strip().lower()
    if facts.method in _SAFE or not is_api(facts.path) or kind not in _FORMS:
        return None
    return Refusal(415, Message("request.html-form", media=kind))


def _without_key(
    rules: AccessRules, facts: RequestFacts, host: Authority, now: float, proof: Proof
) -> Principal | Refusal:
    """Return who sends a request that contains no key, or its refusal.

    Such a request is permitted if it is a health check, if it has a valid session, or if it comes
    from this computer, is sent to a loopback address, and no administrator exists.

    ``rules``: settings of the access control.
    ``facts``: method, path, headers and addresses of the request.
    ``host``: name and port in the Host header of the request.
    ``now``: current time in seconds since 1970, with which the expiry of the session is compared.
    ``proof``: owner of the session, and whether an administrator exists.
    """
    if is_probe(facts):
        return ANONYMOUS
    if proof.principal is not None:
        return proof.principal
    if rules.key and signin.is_session(facts.session or "", rules.key, now):
        return SERVER_KEY
    if not proof.closed:
        if _is_local(rules, facts, host):
            return LOCAL
        if not rules.key:
            return Refusal(403, Message("request.local-only"))
    if (facts.method, facts.path) in SESSION_REQUESTS:
        return ANONYMOUS
    return Refusal(401, Message("request.key-needed"))


def is_probe(facts: RequestFacts) -> bool:
    """Return whether a request is a health check or a readiness check."""
    return facts.path in OPEN_PATHS and facts.method in _SAFE


def _is_listed(rules: AccessRules, facts: RequestFacts, host: Authority) -> bool:
    """Return whether the Host header of a request names this server.

    The header must contain a loopback name, the local IP address of the connection, or an entry of
    ``rules.hosts``.  This prevents DNS rebinding: an attacker can make his own domain name refer to
    this server, but then the Host header contains this domain name, so the request is refused.

    ``rules``: settings of the access control.
    ``facts``: method, path, headers and addresses of the request.
    """
    name, _ = host
    address, port = facts.server
    own = is_loopback(name) or (_ip(name) is not None and _ip(name) == _ip(address))
    if own and _with_port(host, facts.scheme)[1] == port:
        return True
    for allowed in map(parse_authority, rules.hosts):
        if allowed is not None and allowed[0] == name:
            allowed_port = allowed[1]
            if allowed_port is None or allowed_port == _with_port(host, facts.scheme)[1]:
                return True
    return False


def parse_authority(text: str) -> Authority | None:
    """Return name and port of a text ``NAME[:PORT]``, or None if the text is malformed.

    The name is returned in lower case; the brackets around an IPv6 address are removed.  The port
    is None if the text contains no port.
    """
    match = _AUTHORITY.fullmatch(text)
    if match is None:
        return None
    name, port = match[1].lower(), match[2]
    if name.startswith("["):
        name = name[1:-1]
        if _ip(name) is None:
            return None
    return name, None if port is None else int(port)


def _with_port(host: Authority, scheme: str) -> tuple[str, int]:
    name, port = host
    return name, _PORTS.get(scheme, 80) if port is None else port


def _ip(text: str) -> ipaddress.IPv4Address | ipaddress.IPv6Address | None:
    try:
        address = ipaddress.ip_address(text)
    except ValueError:
        return None
    mapped = address.ipv4_mapped if isinstance(address, ipaddress.IPv6Address) else None
    return mapped or address


def is_loopback(name: str) -> bool:
    """Return whether a host name or an IP address is that of this computer (loopback)."""
    address = _ip(name)
    return name == "localhost" if address is None else address.is_loopback


def is_api(path: str) -> bool:
    """Return whether a path belongs to the REST API, and not to the files of the page."""
    return path == "/api" or path.startswith("/api/")


def same_key(request_key: str, key: str) -> bool:
    """Return whether the key of a request equals the server's key, compared in constant time."""
    digests = (
        hashlib.sha256(text.encode("utf-8", "replace")).digest() for text in (request_key, key)
    )
    return hmac.compare_digest(*digests)


def bearer_key(header: str | None) -> str | None:
    """Return the key in an Authorization header; None if it has none."""
    scheme, _, key = (header or "").partition(" ")
    return key.strip() if scheme.lower() == "bearer" else None
