"""Files of a folder that are complete, found by polling, so that network shares work as well."""

from __future__ import annotations

import os
import stat
from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path
from typing import Final, NamedTuple

from knifetip.cli.hot_folder.beside import drawing_beside, find_beside
from knifetip.formats.registry import FORMATS

#: Suffix of the file with the fields of an order: ``tray.dxf.json`` for ``tray.dxf``.
SIDECAR: Final = ".json"

#: Suffixes of orders in XJDF, alone and in a package with their drawing.
XJDF_DOCUMENT: Final = ".xjdf"
XJDF: Final = (XJDF_DOCUMENT, ".xjdf.zip")

_SUFFIXES: Final = (*XJDF, *(suffix for one in FORMATS for suffix in one.extensions))


class Stamp(NamedTuple):
    """Size and time of the last change of a file, which show whether it is still being written."""

    size: int  #: bytes
    mtime: int  #: ns


class Arrivals:
    """The complete drawings in a folder.

    A drawing is complete when it and its sidecar have kept size and time for ``settle`` seconds
    and can be opened.  An empty file is never complete.

    Parameters
    ----------
    folder
        The folder; its subfolders are not searched.
    settle
        Time for which a file must not change (s).
    clock
        Returns seconds; for durations only.
    patience
        Time for which a complete order in XJDF waits for the drawing that it names (s).
    """

    def __init__(
        self, folder: Path, settle: float, clock: Callable[[], float], patience: float = 0.0
    ) -> None:
        self._folder = folder
        self._settle = settle
        self._clock = clock
        self._patience = patience
        self._named: dict[str, tuple[Stamp, str]] = {}  # drawings that orders name
        self._seen: dict[str, tuple[tuple[Stamp, Stamp | None], float]] = {}

    def complete(self) -> list[str]:
        """Return the names of the complete drawings, those that came first before the others.

        Raises
        ------
        OSError
            The folder cannot be read, as when a network share is away.
        """
        now = self._clock()
        found = dict(self._drawings())
        named = self._drawings_of_orders({name: stamps[0] for name, stamps in found.items()})
        for drawing in named.values():
            path = find_beside(self._folder, drawing)
            if path is not None and (stamp := _stamp(path)) is not None:
                found[drawing] = stamp, None
        self._seen = {
            name: seen
            if (seen := self._seen.get(name)) is not None and seen[0] == stamps
            else (stamps, now)
            for name, stamps in found.items()
        }
        settled = [
            name
            for name, (stamps, since) in sorted(self._seen.items(), key=lambda one: one[1][1])
            if stamps[0].size > 0 and now - since >= self._settle and self._is_readable(name)
        ]
        ordered = set(named.values())
        return [
            name
            for name in settled
            if name not in ordered
            and (
                named.get(name) in (None, *settled)
                or now - self._seen[name][1] >= self._settle + self._patience
            )
        ]

    def _drawings_of_orders(self, stamps: dict[str, Stamp]) -> dict[str, str]:
        """Return the drawings that orders in XJDF name, by the names of the orders."""
        known = self._named
        self._named = {}
        for name, stamp in stamps.items():
            if not name.lower().endswith(XJDF_DOCUMENT):
                continue
            if name in known and known[name][0] == stamp:
                self._named[name] = known[name]
                continue
            with suppress(OSError):
                self._named[name] = stamp, drawing_beside((self._folder / name).read_bytes())
        return {name: drawing for name, (_, drawing) in self._named.items() if drawing}

    @property
    def is_waiting(self) -> bool:
        """Whether the last poll found a drawing, complete or not."""
        return bool(self._seen)

    def _drawings(self) -> Iterator[tuple[str, tuple[Stamp, Stamp | None]]]:
        for name in os.listdir(self._folder):
            if name.startswith((".", "~")) or not name.lower().endswith(_SUFFIXES):
                continue
            stamp = _stamp(self._folder / name)
            if stamp is not None:
                yield name, (stamp, _stamp(self._folder / (name + SIDECAR)))

    def _is_readable(self, name: str) -> bool:
        """Return whether a file can be opened; one that another program has locked cannot."""
        try:
            with (self._folder / name).open("rb") as file:
                file.read(1)
        except OSError:
            return False
        return True


def _stamp(path: Path) -> Stamp | None:
    """Return size and time of a regular file; None for links, folders and missing files."""
    try:
        found = path.lstat()
    except OSError:
        return None
    return Stamp(found.st_size, found.st_mtime_ns) if stat.S_ISREG(found.st_mode) else None
