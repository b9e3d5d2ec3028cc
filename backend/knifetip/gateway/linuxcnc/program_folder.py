"""program_folder: the folder through which LinuxCNC gets program files.

LinuxCNC opens a program as a file.  The gateway therefore writes the file into a folder that both
can read: any folder if they run on the same computer, else a shared one.
"""

from __future__ import annotations

import shutil
import tempfile
from contextlib import suppress
from pathlib import Path

from knifetip.errors import ControllerError
from knifetip.gateway.linuxcnc.address import LinuxcncAddress


class ProgramFolder:
    """A folder that contains the present program of a LinuxCNC, and no other file of this gateway.

    Parameters
    ----------
    address
        Address of the LinuxCNC, with the path of the folder on both computers.
    """

    def __init__(self, address: LinuxcncAddress) -> None:
        self._address = address
        self._temporary: Path | None = None
        self._file: Path | None = None

    def write(self, text: bytes) -> str:
        """Write a program file in place of the last one; return its path for LinuxCNC.

        Raises
        ------
        ControllerError
            The file cannot be written.
        """
        try:
            folder = self._folder()
            with tempfile.NamedTemporaryFile(
                dir=folder, prefix="knifetip-", suffix=".ngc", delete=False
            ) as file:
                file.write(text)
            path = Path(file.name)
            path.chmod(0o644)
        except OSError as error:
            raise ControllerError(
                "linuxcnc.folder-not-writable",
                folder=self._address.programs or tempfile.gettempdir(),
                reason=error.strerror or error,
            ) from error
        self._remove_file()
        self._file = path
        return f"{self._address.remote or folder}/{path.name}"

    def remove(self) -> None:
        """Remove the program file, and the folder if it is a temporary one."""
        self._remove_file()
        if self._temporary is not None:
            shutil.rmtree(self._temporary, ignore_errors=True)
            self._temporary = None

    def _folder(self) -> Path:
        if self._address.programs:
            return Path(self._address.programs).absolute()
        if self._temporary is None:
            self._temporary = Path(tempfile.mkdtemp(prefix="knifetip-"))
            # LinuxCNC usually runs as another user.
            self._temporary.chmod(0o755)
        return self._temporary

    def _remove_file(self) -> None:
        if self._file is not None:
            with suppress(OSError):
                self._file.unlink()
            self._file = None
