"""transport: byte connections to controllers, found by the scheme of an address.

An address is a URL such as ``tcp://192.168.1.20:23`` or ``serial:///dev/ttyUSB0?baud=115200``;
``192.168.1.20:23`` stands for ``tcp://192.168.1.20:23``.  A transport does not interpret the bytes.

Each module of the package ``transports`` is a kind of transport, and its name is the scheme.  Other
packages register transports as entry points of the group ``knifetip.transports``, named by scheme.
"""

from __future__ import annotations

import importlib
import math
import pkgutil
from collections.abc import Awaitable, Callable
from functools import cache
from importlib.metadata import entry_points
from typing import Protocol, TypeAlias, runtime_checkable
from urllib.parse import SplitResult, urlsplit

from knifetip.errors import NoSuchController

#: Group of the entry points of transports.
GROUP = "knifetip.transports"
#: Package whose modules are transports.
_PACKAGE = "knifetip.gateway.transports"


class Transport(Protocol):
    """An open connection to a controller."""

    @property
    def address(self) -> str:
        """Address of the controller, for messages."""
        ...

    async def read(self) -> bytes:
        """Wait for bytes and return them; return ``b""`` if the connection is closed."""
        ...

    async def write(self, data: bytes) -> None:
        """Send bytes after those of earlier calls; return when the operating system has them.

        Raises
        ------
        ControllerError
            The connection is lost.
        """
        ...

    async def close(self) -> None:
        """Close the connection; has no effect if it is closed already."""
        ...


@runtime_checkable
class PacedTransport(Protocol):
    """A transport that states its speed, such as a serial port; others have no attribute for it."""

    byte_rate: float  #: bytes per second in each direction


def byte_rate(transport: Transport) -> float:
    """Return the bytes per second of a transport; infinite if it does not state them."""
    return transport.byte_rate if isinstance(transport, PacedTransport) else math.inf


#: Function that opens a connection to the address in a URL.  It raises ``NoSuchController`` if the
#: URL is not an address, and ``ControllerError`` if the connection cannot be opened.
Opener: TypeAlias = Callable[[SplitResult], Awaitable[Transport]]


async def connect(address: str) -> Transport:
    """Return an open connection to the controller at an address.

    Raises
    ------
    NoSuchController
        The address is invalid.
    ControllerError
        The connection cannot be opened.
    """
    try:
        url = urlsplit(address if "//" in address else f"tcp://{address}")
    except ValueError:
        url = SplitResult("", "", "", "", "")
    opener = find_opener(url.scheme)
    if opener is None:
        raise NoSuchController("controller.bad-address", address=address, schemes=schemes())
    return await opener(url)


def is_from_web_server(line: str) -> bool:
    """Return whether a received line is an answer of a web server to a request it cannot read."""
    return line.lower().startswith(("http/", "<!doctype", "<html"))


def schemes() -> list[str]:
    """Return the schemes of all transports, of this package and of entry points."""
    return sorted({*_built_in_schemes(), *entry_points(group=GROUP).names})


def find_opener(scheme: str) -> Opener | None:
    """Return the function that opens connections to addresses of a scheme; None if unknown."""
    if scheme in _built_in_schemes():
        opener: Opener = importlib.import_module(f"{_PACKAGE}.{scheme}").open_transport
        return opener
    candidates = tuple(entry_points(group=GROUP, name=scheme))
    return candidates[0].load() if candidates else None


@cache
def _built_in_schemes() -> frozenset[str]:
    package = importlib.import_module(_PACKAGE)
    return frozenset(module.name for module in pkgutil.iter_modules(package.__path__))
