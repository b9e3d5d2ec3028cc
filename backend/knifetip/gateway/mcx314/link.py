"""link: requests to the board of an MCX314, repeated until each is answered once."""

from __future__ import annotations

import asyncio
from contextlib import suppress

from knifetip.errors import ConnectionLost, ControllerError, ControllerSilent
from knifetip.gateway.mcx314.frames import Splitter, pack, unpack
from knifetip.gateway.transport import Transport, connect

#: How often a request is sent before the board counts as silent.
TRIES = 3


class Link:
    """A connection to a board.

    Parameters
    ----------
    address
        Address of the board, as for ``transport.connect``.
    silence
        Seconds after which the board counts as silent if a request has no answer.
    """

    def __init__(self, address: str, silence: float) -> None:
        self.name = address
        self.repeated = 0  #: requests that were sent again
        self._silence = silence
        self._transport: Transport | None = None
        self._reading: asyncio.Task[None] | None = None
        self._waiting: dict[int, asyncio.Future[str]] = {}
        self._tag = 0

    @property
    def connected(self) -> bool:
        """Whether the connection is open."""
        return self._transport is not None

    async def open(self) -> None:
        """Connect to the board.

        Raises
        ------
        ControllerError
            The connection cannot be opened.
        """
        self._transport = await connect(self.name)
        self._reading = asyncio.create_task(self._read(self._transport), name="mcx314 answers")

    async def close(self) -> None:
        """Close the connection."""
        reading, self._reading = self._reading, None
        if reading is not None and reading is not asyncio.current_task():
            reading.cancel()
            await asyncio.gather(reading, return_exceptions=True)
        await self._drop()

    async def _drop(self) -> None:
        transport, self._transport = self._transport, None
        for future in self._waiting.values():
            if not future.done():
                future.cancel()
        self._waiting.clear()
        if transport is not None:
            with suppress(ControllerError):
                await transport.close()

    async def _read(self, transport: Transport) -> None:
        splitter = Splitter()
        while chunk := await transport.read():
            for line in splitter.feed(chunk):
                answer = unpack(line)
                future = None if answer is None else self._waiting.get(answer[0])
                if answer is not None and future is not None and not future.done():
                    future.set_result(answer[1])
        await self._drop()

    async def request(self, text: str) -> str:
        """Send a request, and return its answer.

        Raises
        ------
        ControllerSilent
            The board has not answered any of the repetitions.
        ControllerError
            The connection is lost.
        """
        self._tag += 1
        tag = self._tag
        future = self._waiting[tag] = asyncio.get_running_loop().create_future()
        try:
            for attempt in range(TRIES):
                if self._transport is None:
                    raise ConnectionLost("mcx314.lost", name=self.name)
                self.repeated += attempt > 0
                await self._transport.write(pack(tag, text))
                with suppress(TimeoutError):
                    async with asyncio.timeout(self._silence / TRIES):
                        return await asyncio.shield(future)
        except asyncio.CancelledError:
            if future.cancelled():
                raise ConnectionLost("mcx314.lost", name=self.name) from None
            raise
        finally:
            self._waiting.pop(tag, None)
        raise ControllerSilent("mcx314.silent", name=self.name, seconds=self._silence)
