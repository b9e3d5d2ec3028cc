"""serial: a transport over a serial or USB port, ``serial:///dev/ttyUSB0`` or ``serial://COM3``.

``?baud=250000`` sets the speed, and ``?flow=rtscts`` or ``?flow=xonxoff`` the flow control, with
which a device can stop the port from sending for any time.  The line DTR stays active from the
first opening on, also while the port is closed, because many boards reset when it becomes active.
"""

from __future__ import annotations

import asyncio
import errno
import os
import threading
from contextlib import suppress
from urllib.parse import SplitResult, parse_qsl

import serial
from serial.tools.list_ports import comports

from knifetip.errors import ConnectionLost, ControllerError, NoSuchController
from knifetip.messages import Message

#: Speed of a port whose address states none (bits per second), as in grbl.
BAUD = 115200
#: Kinds of flow control that an address can state.
FLOWS = ("none", "rtscts", "xonxoff")
#: Longest time until the operating system accepts the bytes of a write (s), without flow control.
PATIENCE = 2.0

_BITS_PER_BYTE = 10.0  # with start bit and stop bit

_MISSING = frozenset({errno.ENOENT, errno.ENODEV, errno.ENXIO})
_BUSY = frozenset({errno.EAGAIN, errno.EBUSY})


class SerialPort:
    """An open serial port.

    A thread waits for received bytes, because asyncio cannot wait for a serial port on Windows.
    """

    def __init__(self, address: str, port: serial.Serial) -> None:
        self.address = address
        self.byte_rate = port.baudrate / _BITS_PER_BYTE
        self._port = port
        self._received: asyncio.Queue[bytes] = asyncio.Queue()
        self._writing = asyncio.Lock()
        self._unfinished: asyncio.Future[object] | None = None
        self._closed = False
        self._loop = asyncio.get_running_loop()
        self._thread = threading.Thread(target=self._receive, name=address, daemon=True)
        self._thread.start()

    async def read(self) -> bytes:
        """Wait for bytes and return them; return ``b""`` if the port is closed or unplugged."""
        if data := await self._received.get():
            return data
        self._received.put_nowait(b"")  # for the next call
        return b""

    async def write(self, data: bytes) -> None:
        """Send bytes after those of earlier calls; return when the operating system has them.

        If the call is cancelled, the bytes are still sent, unless the port is closed before.

        Raises
        ------
        ControllerError
            The port is closed or unplugged, or accepts no bytes.
        """
        async with self._writing:
            if self._unfinished is not None:  # of a cancelled call
                await asyncio.wait([self._unfinished])
            self._unfinished = asyncio.ensure_future(asyncio.to_thread(self._port.write, data))
            try:
                await asyncio.shield(self._unfinished)
            except OSError as error:
                raise ConnectionLost(
                    "controller.connection-failed", address=self.address, reason=error
                ) from error

    async def close(self) -> None:
        """Close the port."""
        if not self._closed:
            self._closed = True
            self._port.cancel_read()
            if self._unfinished is not None and not self._unfinished.done():
                self._port.cancel_write()
                await asyncio.wait([self._unfinished])
                self._port.reset_output_buffer()  # closing would wait until they are sent
            await asyncio.to_thread(self._thread.join)
            self._port.close()

    def _receive(self) -> None:
        """Pass received bytes to ``read`` until the port is closed or unplugged."""
        data = b""
        with suppress(OSError, RuntimeError):  # RuntimeError: the event loop has ended
            while not self._closed:
                if data := self._port.read():
                    data += self._port.read(self._port.in_waiting)
                    self._loop.call_soon_threadsafe(self._received.put_nowait, data)
        with suppress(RuntimeError):
            self._loop.call_soon_threadsafe(self._received.put_nowait, b"")


async def open_transport(url: SplitResult) -> SerialPort:
    """Return the open serial port of a URL, locked against other programs.

    Raises
    ------
    NoSuchController
        The URL is invalid.
    ControllerError
        The port does not exist, is in use, is not permitted or cannot be configured.
    """
    name, baud, flow = _port_and_options(url)
    port = serial.Serial(
        baudrate=baud,
        rtscts=flow == "rtscts",
        xonxoff=flow == "xonxoff",
        write_timeout=PATIENCE if flow == "none" else None,
        timeout=PATIENCE,
        exclusive=True,
    )
    port.port = name
    try:
        await asyncio.to_thread(port.open)
    except (OSError, ValueError) as error:
        raise _explain(name, error) from error
    _keep_dtr(port)
    return SerialPort(f"serial://{name}", port)


def _port_and_options(url: SplitResult) -> tuple[str, int, str]:
    """Return the name of the port in a URL, its speed in bits per second and its flow control."""
    options = dict(parse_qsl(url.query, keep_blank_values=True))
    baud = options.pop("baud", str(BAUD))
    flow = options.pop("flow", "none")
    name = url.netloc + url.path
    valid = baud.isdecimal() and int(baud) and flow in FLOWS
    if not name.strip("/") or options or not valid:
        raise NoSuchController("controller.bad-serial-address", address=url.geturl())
    return name, int(baud), flow


def port_names() -> list[str]:
    """Return the names of the serial ports of this computer."""
    return sorted(port.device for port in comports())


def _keep_dtr(port: serial.Serial) -> None:
    """Keep DTR active when the port is closed, so that the next opening does not reset the board.

    Windows does not offer this setting, and some devices do not have it.
    """
    if os.name == "posix":
        import termios

        with suppress(termios.error):
            settings = termios.tcgetattr(port.fileno())
            settings[2] &= ~termios.HUPCL
            termios.tcsetattr(port.fileno(), termios.TCSANOW, settings)


def _explain(name: str, error: OSError | ValueError) -> ControllerError:
    """Return the error for a port that cannot be opened."""
    code = getattr(error, "errno", None)
    known = port_names()
    if code in _MISSING or (os.name == "nt" and name not in known):
        found = Message("controller.ports-found", ports=known) if known else None
        return ControllerError("controller.port-missing", port=name, found=found)
    if code in _BUSY:
        return ControllerError("controller.port-busy", port=name)
    if code in (errno.EACCES, errno.EPERM):
        return ControllerError("controller.port-not-permitted", port=name)
    return ControllerError("controller.port-unusable", port=name, reason=error)
