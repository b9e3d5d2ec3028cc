"""Addresses to which the server may send requests: webhooks must not reach its own network.

A URL of a webhook is chosen by a person with the scope admin, and its name may resolve to any
address at any time.  The server therefore resolves the name itself before each request, checks
every address, and connects to the checked address.
"""

from __future__ import annotations

import asyncio
import errno
import ipaddress
import os
import socket
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from typing import Final, TypeAlias
from urllib.parse import urlsplit

from knifetip.errors import RequestError
from knifetip.messages import Message

Address: TypeAlias = ipaddress.IPv4Address | ipaddress.IPv6Address

#: Addresses of metadata services of clouds that are not link-local.
_METADATA: Final = frozenset(
    ipaddress.ip_address(text)
    for text in (
        *("100.100.100.200", "192.0.0.192", "168.63.129.16"),
        *("fd00:ec2::254", "fd20:ce::254", "fd00:42::42"),
    )
)
#: IPv6 networks whose addresses end in an IPv4 address (NAT64, and IPv4-compatible).
_EMBEDDED: Final = tuple(map(ipaddress.IPv6Network, ("64:ff9b::/96", "::/96")))
_PORTS: Final = {"http": 80, "https": 443}
#: A name server that does not answer blocks a thread for up to a minute.  Such threads must not be
#: those of the event loop, for which event streams wait, too.
_RESOLVERS: Final = ThreadPoolExecutor(8, "resolve")
_MOST_ADDRESSES = 4  # addresses of one name to which a connection is tried


def check_url(url: str, *, private: bool) -> str:
    """Return the URL of a webhook unchanged if it is usable.

    Parameters
    ----------
    url
        The URL.  A name in it is not resolved here.
    private
        Whether loopback and private addresses are permitted.

    Raises
    ------
    RequestError
        It is not an http or https URL with a host, contains a user name or characters that no URL
        has, or its address is not permitted.
    """
    reason = _fault(url)
    if reason:
        raise RequestError("webhook.bad-url", reason=reason, source=("url",))
    host = urlsplit(url).hostname or ""
    try:
        address = ipaddress.ip_address(host)
    except ValueError:
        return url
    if not is_permitted(address, private=private):
        raise RequestError("webhook.forbidden-address", address=str(address), source=("url",))
    return url


def _fault(url: str) -> str:
    """Return what is wrong with a URL; "" for nothing."""
    if not url.isascii() or any(not "!" <= letter <= "~" for letter in url):
        return "it contains a character that must be percent-encoded"
    try:
        parts = urlsplit(url)
        port = parts.port
    except ValueError:
        return "its host or its port is not valid"
    if parts.scheme not in _PORTS:
        return "it does not begin with http:// or https://"
    if not parts.hostname:
        return "it names no host"
    if parts.username is not None or parts.password is not None:
        return "it contains a user name or a password"
    if port == 0:
        return "it names port 0"
    # A name of the internet has labels of 1 to 63 characters, and 253 together.
    labels = parts.hostname.removesuffix(".").split(".")
    if len(parts.hostname) > 253 or not all(1 <= len(label) <= 63 for label in labels):
        return "its host has an empty or a too long label"
    return ""


def is_permitted(address: Address, *, private: bool) -> bool:
    """Return whether a webhook may be sent to an address.

    Link-local, multicast, reserved and unspecified addresses and metadata services never are.

    Parameters
    ----------
    address
        The address.
    private
        Whether loopback and private addresses are permitted.
    """
    address = _embedded_ipv4(address)
    if address in _METADATA or address.is_link_local:
        return False
    if address.is_loopback:
        return private
    if address.is_multicast or address.is_reserved or address.is_unspecified:
        return False
    return private or address.is_global


def _embedded_ipv4(address: Address) -> Address:
    """Return the IPv4 address that an IPv6 address contains, otherwise the address itself."""
    if isinstance(address, ipaddress.IPv4Address) or address.is_loopback or address.is_unspecified:
        return address
    if address.ipv4_mapped is not None:
        return address.ipv4_mapped
    if address.sixtofour is not None:
        return address.sixtofour
    if any(address in network for network in _EMBEDDED):
        return ipaddress.IPv4Address(int(address) & 0xFFFF_FFFF)
    return address


async def resolve(url: str, *, private: bool) -> tuple[str, ...]:
    """Return the addresses of the host of a URL, as texts, in the order in which to try them.

    All of them are permitted, including those beyond the number that is returned.

    Raises
    ------
    OSError
        The name cannot be resolved.
    RequestError
        One of its addresses is not permitted.
    """
    parts = urlsplit(url)
    port = parts.port or _PORTS[parts.scheme]
    look_up = partial(socket.getaddrinfo, parts.hostname, port, type=socket.SOCK_STREAM)
    found = await asyncio.get_running_loop().run_in_executor(_RESOLVERS, look_up)
    addresses = tuple(dict.fromkeys(str(info[4][0]) for info in found))
    if not addresses:
        raise OSError(errno.EADDRNOTAVAIL, os.strerror(errno.EADDRNOTAVAIL))
    for text in addresses:
        if not is_permitted(ipaddress.ip_address(text.partition("%")[0]), private=private):
            raise RequestError(Message("webhook.forbidden-address", address=text))
    return addresses[:_MOST_ADDRESSES]
