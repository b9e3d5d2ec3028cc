"""Clocks of processes that can be stepped, with a C compiler."""

from __future__ import annotations

import shutil
import struct
import subprocess
from pathlib import Path
from typing import Final

_SOURCE: Final = Path(__file__).with_name("stepped_clock.c")


class Clocks:
    """Clocks of processes, in a folder with their offsets; the clock of the computer stays.

    Parameters
    ----------
    folder
        Folder that all processes can read.
    """

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._library = folder / "stepped_clock.so"
        compiler = shutil.which("cc")
        self.can_step = compiler is not None  #: whether there is a C compiler
        if compiler is not None:
            command = [compiler, "-shared", "-fPIC", "-O2", "-o", str(self._library), str(_SOURCE)]
            subprocess.run(command, check=True)

    def environment(self, name: str) -> dict[str, str]:
        """Return the environment variables with which a process has a clock of its own."""
        if not self.can_step:
            return {}
        file = self._folder / f"clock-{name}"
        if not file.exists():
            file.write_bytes(struct.pack("d", 0.0))
        return {"LD_PRELOAD": str(self._library), "STEPPED_CLOCK": str(file)}

    def step(self, name: str, seconds: float) -> None:
        """Set the clock of a process to the true time and some seconds."""
        # In place, because the process has mapped the file.
        with (self._folder / f"clock-{name}").open("r+b") as file:
            file.write(struct.pack("d", seconds))
