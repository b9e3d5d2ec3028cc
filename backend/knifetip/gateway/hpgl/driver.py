"""driver: sends HPGL programs to a plotter or flat cutter over a serial port or TCP.

The flow control of the connection is the only answer of such a device: it accepts bytes while its
buffer has room.  The driver therefore reports only those program lines as executed that no longer
fit into this buffer, and a person confirms the end (``open_loop``).

A program is sent in pieces of whole lines.  To stop, the driver sends no further piece, but the
instructions that raise the tool; the device executes them after all that is in its buffer.
"""

from __future__ import annotations

import asyncio
import re
from bisect import bisect_right
from collections.abc import Iterable
from contextlib import suppress
from itertools import accumulate
from urllib.parse import parse_qsl, urlencode, urlsplit

from knifetip.errors import ControllerError, NoSuchController, ProgramError
from knifetip.gateway.controller import SafeState
from knifetip.gateway.open_loop import OpenLoop
from knifetip.gateway.program_blocks import lines_of
from knifetip.gateway.transport import Transport, connect

#: TCP port on which plotters and print servers take raw data.
PORT = 9100
#: Bytes that the connection and the device may hold if the address states nothing else.
BUFFER = 1 << 16
#: Greatest size of a piece of a program (bytes): so much is at least sent after a cancel.
PIECE = 256
#: Instructions that raise the tool and put it away; the first terminator ends an open instruction.
RAISE = b";PU;SP0;\n"
#: Time for which the device may refuse to accept ``RAISE`` (s).
PATIENCE = 30.0

# XON, XOFF and ESC control the connection and the device.
_CONTROL = re.compile(rb"[^\x20-\x7e]")


class HpglPlotter(OpenLoop):
    """A plotter or flat cutter that reads HPGL; the methods are those of ``OpenLoop``.

    Parameters
    ----------
    transport
        Open connection.
    buffer
        Greatest number of bytes that the connection and the device may hold.
    """

    def __init__(self, transport: Transport, buffer: int) -> None:
        super().__init__(transport.address)
        self._transport = transport
        self._buffer = buffer
        self._discarding = asyncio.create_task(self._discard(), name=f"answers of {self.name}")

    async def check(self, lines: Iterable[bytes]) -> None:
        """Check that the lines of a program contain no bytes that control the connection.

        Raises
        ------
        ProgramError
            A line contains such a byte.
        """
        for number, line in enumerate(lines, 1):
            if found := _CONTROL.search(line):
                raise ProgramError("program.control-byte", line=number, byte=found[0].hex())

    async def hand_over(self, text: bytes) -> None:
        """Send a program; return when the connection has accepted all of it.

        Raises
        ------
        ControllerError
            The connection is lost.
        """
        ends = list(accumulate(len(line) + 1 for line in lines_of(text)))
        before_sent, before_done = self.sent, self.acknowledged
        start = 0
        while start < len(text):
            row = max(bisect_right(ends, start + PIECE), bisect_right(ends, start) + 1)
            end = min(ends[row - 1], len(text))
            self.sent = before_sent + row
            await self._transport.write(text[start:end])
            start = end
            self.acknowledged = before_done + bisect_right(ends, start - self._buffer)

    async def withdraw(self) -> ControllerError:
        """Raise the tool after what the device already has; return what a person must do."""
        try:
            async with asyncio.timeout(PATIENCE):
                await self.raise_tool()
        except TimeoutError:
            return ControllerError("hpgl.not-raised", name=self.name, seconds=PATIENCE)
        except ControllerError as lost:
            return ControllerError("hpgl.not-reached", error=lost.message)
        return ControllerError("hpgl.runs-on", name=self.name)

    async def raise_tool(self) -> None:
        """Send the instructions that raise the tool, as soon as the device accepts them.

        Raises
        ------
        ControllerError
            The connection is lost.
        """
        await self._transport.write(RAISE)

    async def close(self) -> None:
        """Close the connection; the device still executes what is in its buffer."""
        self._discarding.cancel()
        await asyncio.gather(self._discarding, return_exceptions=True)
        await self._transport.close()

    async def _discard(self) -> None:
        """Discard what the device sends, until the connection is closed."""
        while await self._transport.read():
            pass


async def dial(
    address: str, safe: SafeState | None = None, *, stop_motion: bool = False
) -> HpglPlotter:
    """Connect to a plotter.

    Parameters
    ----------
    address
        ``tcp://HOST`` (port 9100), or the address of a serial port with its flow control, for
        example ``serial:///dev/ttyUSB0?baud=9600&flow=rtscts``.  The option ``buffer`` states how
        many bytes connection and device may hold.
    safe
        Without effect: the device itself raises its tools and switches its outputs.
    stop_motion
        Whether the device may have received a part of a program; the tool is then raised.

    Raises
    ------
    ControllerError
        The address is invalid, or the connection cannot be opened.
    """
    del safe
    url, buffer = _split_address(address)
    plotter = HpglPlotter(await connect(url), buffer)
    if stop_motion:
        with suppress(TimeoutError):
            async with asyncio.timeout(PATIENCE):
                await plotter.raise_tool()
    return plotter


def _split_address(address: str) -> tuple[str, int]:
    """Return the address of the connection and the size of the buffer."""
    try:
        url = urlsplit(address if "//" in address else f"tcp://{address}")
        port = url.port if url.scheme == "tcp" else PORT
    except ValueError:
        return address, BUFFER  # refused by the transport
    options = dict(parse_qsl(url.query, keep_blank_values=True))
    buffer = options.pop("buffer", str(BUFFER))
    serial = url.scheme == "serial"
    if not buffer.isdecimal() or (serial and options.get("flow") not in ("rtscts", "xonxoff")):
        raise NoSuchController("hpgl.bad-address", address=address)
    netloc = url.netloc if port is not None else f"{url.netloc}:{PORT}"
    query = f"?{urlencode(options)}" if options else ""
    return f"{url.scheme}://{netloc}{url.path}{query}", int(buffer)
