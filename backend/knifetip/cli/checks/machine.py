"""Checks of the computer beside a machine: serial ports, the machine's file, the controller."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from urllib.parse import urlsplit

from knifetip.cli.checks.check_result import CheckResult, ok, problem
from knifetip.errors import KnifetipError
from knifetip.messages import Message


def check_ports(
    ports: Callable[[], list[str]] | None = None,
    may_open: Callable[[str], bool] | None = None,
) -> Iterator[CheckResult]:
    """Check that this user may open the serial ports of this computer.

    Parameters
    ----------
    ports
        Returns the names of the ports; None for those of the system.
    may_open
        Returns whether the user may open a port; None for the check of the system.
    """
    from knifetip.gateway.transports.serial import port_names

    names = (ports or port_names)()
    if not names:
        yield ok("serial ports", Message("doctor.ports-none"))
    for name in names:
        if (may_open or _may_open)(name):
            yield ok("serial ports", Message("doctor.port", port=name))
        else:
            yield problem("serial ports", Message("doctor.port-refused", port=name))


def _may_open(name: str) -> bool:
    return os.name == "nt" or os.access(name, os.R_OK | os.W_OK)


def check_machine(
    name: str, controller: str, ports: Callable[[], list[str]] | None = None
) -> Iterator[CheckResult]:
    """Check the definition of a machine and the address of its controller.

    Parameters
    ----------
    name
        Name of a machine of the library, or path of its TOML file.
    controller
        Address of the controller; empty if none is given.  Nothing is sent to it.
    ports
        Returns the names of the serial ports; None for those of the system.
    """
    from knifetip.gateway.hot_folder import find_driver
    from knifetip.gateway.transports.serial import port_names
    from knifetip.library import load

    try:
        machine = load.machine(name)
    except KnifetipError as reason:
        yield problem("machine", reason.message)
        return
    count = len(machine.stations)
    yield ok("machine", Message("doctor.machine", name=name, title=machine.title, count=count))
    if not controller:
        return
    try:
        find_driver(machine, controller)
    except KnifetipError as reason:
        yield problem("controller", reason.message)
        return
    parts = urlsplit(controller)
    port = parts.netloc + parts.path
    if parts.scheme == "serial" and port not in (ports or port_names)():
        yield problem("controller", Message("doctor.port-missing", port=port))
    else:
        message = Message("doctor.controller", address=controller, language=machine.dialect)
        yield ok("controller", message)
