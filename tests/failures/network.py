"""A network of its own for each gateway, whose way to the server can be cut (Linux, root only)."""

from __future__ import annotations

import os
import shutil
import subprocess
from dataclasses import dataclass


def can_cut() -> bool:
    """Return whether this process may make network namespaces."""
    return os.geteuid() == 0 and shutil.which("ip") is not None and _make("kt-probe", remove=True)


def _make(name: str, *, remove: bool) -> bool:
    made = subprocess.run(["ip", "netns", "add", name], capture_output=True, check=False)
    if made.returncode == 0 and remove:
        subprocess.run(["ip", "netns", "delete", name], check=True)
    return made.returncode == 0


def _ip(*words: object) -> None:
    subprocess.run(["ip", *map(str, words)], check=True, capture_output=True)


@dataclass(frozen=True)
class Network:
    """A namespace with two cables: one to the server, one to the controller.

    Without permission for namespaces there is one network for all, and nothing is cut.
    """

    name: str  #: of the namespace; "" for none
    server: str = "127.0.0.1"  #: address of the server as the gateway sees it
    controller: str = "127.0.0.1"  #: address of the controller

    @classmethod
    def make(cls, number: int) -> Network:
        """Make a namespace; ``number`` identifies it in one campaign (0 … 60)."""
        tag = f"{os.getpid() % 100_000}{number}"
        name = f"kt{tag}"
        _ip("netns", "add", name)
        addresses = []
        for cable in range(2):
            near, far = f"kt{tag}a{cable}", f"kt{tag}b{cable}"
            # Campaigns at the same time have different addresses.
            net = f"10.{160 + os.getpid() % 90}.{4 * number + cable}"
            _ip("link", "add", near, "type", "veth", "peer", "name", far)
            _ip("link", "set", far, "netns", name)
            _ip("address", "add", f"{net}.1/30", "dev", near)
            _ip("link", "set", near, "up")
            _ip("-n", name, "address", "add", f"{net}.2/30", "dev", far)
            _ip("-n", name, "link", "set", far, "up")
            addresses.append(f"{net}.1")
        _ip("-n", name, "link", "set", "lo", "up")
        return cls(name, *addresses)

    @property
    def inside(self) -> list[str]:
        """The beginning of the command of a process inside the network."""
        return ["ip", "netns", "exec", self.name] if self.name else []

    def cut(self) -> None:
        """Pull the cable to the server: packets vanish, and no connection is reset."""
        _ip("link", "set", f"{self.name}a0", "down")

    def mend(self) -> None:
        """Plug the cable in again."""
        _ip("link", "set", f"{self.name}a0", "up")

    def delete(self) -> None:
        """Delete the namespace and its cables."""
        if self.name:
            _ip("netns", "delete", self.name)
