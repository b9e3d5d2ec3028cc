"""HTTP server on a separate port, from which Prometheus reads metrics without a key."""

from __future__ import annotations

import re
from contextlib import ExitStack
from typing import TYPE_CHECKING, Final

from knifetip.errors import StoreError

if TYPE_CHECKING:
    from prometheus_client import CollectorRegistry

_ADDRESS: Final = re.compile(r"(?:\[([0-9a-fA-F:.]+)\]|([^:\[\]/]+)):([0-9]{1,5})")


def serve_metrics(address: str, registry: CollectorRegistry) -> ExitStack:
    """Serve the metrics of a registry at an address, in a thread.

    Parameters
    ----------
    address
        HOST:PORT, with an IPv6 address as [HOST]:PORT; empty for no port.
    registry
        The metrics.

    Returns
    -------
    ExitStack
        Its method ``close`` stops the thread and closes the port.

    Raises
    ------
    StoreError
        The address has another form, or the port is in use.
    """
    running = ExitStack()
    if not address:
        return running
    match = _ADDRESS.fullmatch(address)
    if match is None or int(match[3]) > 65535:
        raise StoreError("server.bad-metrics-address", address=address)
    host, port = match[1] or match[2], int(match[3])
    from prometheus_client import start_http_server  # slow to import

    try:
        server, thread = start_http_server(port, host, registry)
    except OSError as reason:
        raise StoreError(
            "server.address-in-use", host=host, port=port, reason=reason.strerror or reason
        ) from reason
    running.callback(thread.join)
    running.callback(server.server_close)
    running.callback(server.shutdown)
    return running
