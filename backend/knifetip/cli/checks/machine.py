"""Checks of the computer beside a machine: serial ports, the machine's file, the controller."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from urllib.parse import urlsplit

from knifetip.cli.checks.check_result import CheckResult, ok, problem
from knifetip.errors import KnifetipError


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
        yield ok("serial ports", "this computer has none")
    for name in names:
        if (may_open or _may_open)(name):
            yield ok("serial ports", f"{name} may be opened")
        else:
            advice = "Add the user to the group of the port: sudo usermod -aG dialout USER"
            yield problem("serial ports", f"this user may not open {name}", advice)


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
        yield problem("machine", reason.text, reason.hint)
        return
    yield ok("machine", f"{name}: {machine.title}, {len(machine.stations)} stations")
    if not controller:
        return
    try:
        find_driver(machine, controller)
    except KnifetipError as reason:
        yield problem("controller", reason.text, reason.hint)
        return
    parts = urlsplit(controller)
    port = parts.netloc + parts.path
    if parts.scheme == "serial" and port not in (ports or port_names)():
        advice = "Connect the controller, switch it on, or name another port."
        yield problem("controller", f"there is no serial port {port}", advice)
    else:
        yield ok("controller", f"{controller} is an address for {machine.dialect}")
