"""Settings of the sign-in by OpenID Connect."""

from __future__ import annotations

import importlib.util
import ipaddress
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from types import MappingProxyType
from urllib.parse import urlsplit

from knifetip.errors import SettingsError
from knifetip.service.http.scopes import ROLES, AccessScope

#: Path to which the provider sends the browser back.
CALLBACK = "/sign-in/oidc/callback"


@dataclass(frozen=True, slots=True)
class OidcSettings:
    """The provider of a server, and the roles that its users get."""

    issuer: str  #: URL of the provider, exactly as in its tokens
    client_id: str  #: name of this server at the provider
    client_secret: str = field(default="", repr=False)  #: empty for a public client
    roles_claim: str = "roles"  #: claim of the ID token; ``a.b`` for the member b of the claim a
    #: role of each value of the claim; users without one of them cannot sign in
    roles: Mapping[str, AccessScope] = field(default_factory=lambda: MappingProxyType({}))
    title: str = "OpenID Connect"  #: name of the provider on the sign-in page
    #: URL of this server for browsers, without a path; empty for that of each request
    public_url: str = ""


def read_settings(
    issuer: str,
    client_id: str,
    *,
    secret_file: Path | None = None,
    roles_claim: str = "roles",
    roles: Sequence[str] = (),
    title: str = "",
    public_url: str = "",
) -> OidcSettings | None:
    """Return the settings of a provider from texts; None without an issuer.

    Parameters
    ----------
    issuer, client_id, roles_claim, title, public_url
        As in ``OidcSettings``.
    secret_file
        File that contains the secret of this server at the provider; None for a public client.
    roles
        Texts ``VALUE=ROLE``.

    Raises
    ------
    SettingsError
        A setting is missing or malformed, the file cannot be read, or authlib is not installed.
    """
    if not issuer:
        if client_id or secret_file or roles:
            raise SettingsError("oidc.no-issuer")
        return None
    if importlib.util.find_spec("authlib") is None:
        raise SettingsError("oidc.not-installed")
    for url in (issuer, public_url):
        if url and not _is_secure(url):
            raise SettingsError("oidc.bad-url", url=url[:200])
    if not client_id:
        raise SettingsError("oidc.no-client")
    return OidcSettings(
        issuer=issuer,
        client_id=client_id,
        client_secret=_secret(secret_file),
        roles_claim=roles_claim,
        roles=MappingProxyType(_roles(roles)),
        title=title or urlsplit(issuer).hostname or issuer,
        public_url=public_url.rstrip("/"),
    )


def _is_secure(url: str) -> bool:
    """Return whether a URL is one of HTTPS, or of this computer."""
    try:
        parts = urlsplit(url)
        host = parts.hostname or ""
    except ValueError:
        return False
    if parts.scheme == "https":
        return bool(host)
    return parts.scheme == "http" and (host == "localhost" or _is_loopback(host))


def _is_loopback(host: str) -> bool:
    try:
        return ipaddress.ip_address(host).is_loopback
    except ValueError:
        return False


def _secret(file: Path | None) -> str:
    if file is None:
        return ""
    try:
        return file.read_text("utf-8").strip()
    except (OSError, UnicodeDecodeError) as reason:
        raise SettingsError("settings.key-file", file=file, reason=reason) from reason


def _roles(pairs: Sequence[str]) -> dict[str, AccessScope]:
    found = {}
    for pair in pairs:
        value, separator, role = pair.rpartition("=")
        if not separator or not value or role not in ROLES:
            names = [one.value for one in ROLES]
            raise SettingsError("oidc.bad-role", pair=pair[:100], roles=names)
        found[value] = AccessScope(role)
    if not found:
        raise SettingsError("oidc.no-roles")
    return found
