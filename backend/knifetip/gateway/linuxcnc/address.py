"""address: the address of a LinuxCNC with its options.

    HOST:PORT
    linuxcnc://HOST:PORT/?programs=/mnt/programs&remote=/home/cnc/programs&joints=5

The port is 5007 if it is left out.
"""

from __future__ import annotations

from dataclasses import dataclass
from urllib.parse import SplitResult, parse_qsl, urlsplit

from knifetip.errors import NoSuchController

#: Port of linuxcncrsh.
PORT = 5007
#: Options of an address with their default values.
_DEFAULTS = {
    "programs": "",
    "remote": "",
    "joints": "4",
    "ini": "",
    "password": "EMC",
    "enable": "EMCTOO",
}


@dataclass(frozen=True, slots=True)
class LinuxcncAddress:
    """The address of a LinuxCNC: host and port of linuxcncrsh, and options."""

    host: str
    port: int
    programs: str  #: folder for program files on this computer; "" for a temporary folder
    remote: str  #: path of this folder on the computer of LinuxCNC; "" if it is the same
    joints: int  #: number of joints that must be homed
    ini: str  #: INI file of LinuxCNC, or a copy of it, on this computer; "" for that of LinuxCNC
    password: str  #: password with which linuxcncrsh accepts a connection (--connectpw)
    enable: str  #: password with which linuxcncrsh accepts commands (--enablepw)

    @property
    def name(self) -> str:
        """Host and port, for messages."""
        host = f"[{self.host}]" if ":" in self.host else self.host
        return f"{host}:{self.port}"

    @classmethod
    def parse(cls, address: str) -> LinuxcncAddress:
        """Parse an address.

        Raises
        ------
        NoSuchController
            The text is not the address of a LinuxCNC, or an option is unknown or invalid.
        """
        try:
            url = urlsplit(address if "//" in address else f"linuxcnc://{address}")
            host, port = url.hostname, url.port or PORT
            options = _DEFAULTS | dict(parse_qsl(url.query, strict_parsing=bool(url.query)))
            joints = int(options["joints"])
        except ValueError:
            url, host, port, options, joints = SplitResult("", "", "", "", ""), None, 0, {}, 0
        good = url.scheme in ("linuxcnc", "tcp") and host and 1 <= joints <= 16
        blank = any(character.isspace() for value in options.values() for character in value)
        if not good or host is None or blank or options.keys() != _DEFAULTS.keys():
            raise NoSuchController(
                "linuxcnc.bad-address", address=address, options=sorted(_DEFAULTS)
            )
        return cls(
            host,
            port,
            options["programs"],
            options["remote"],
            joints,
            options["ini"],
            options["password"],
            options["enable"],
        )
