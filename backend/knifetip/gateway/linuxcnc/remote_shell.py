"""remote_shell: the conversation with linuxcncrsh, the remote shell of LinuxCNC.

Requests are ``get VARIABLE`` and ``set COMMAND``.  With ``verbose`` on, each request has exactly
one reply, which begins with the name of the variable or command.  Messages of LinuxCNC may contain
line ends, so lines that begin otherwise are ignored.

Some requests must not be sent: ``get spindle`` without a number ends linuxcncrsh of version 2.9.
"""

from __future__ import annotations

import asyncio
from contextlib import suppress

from knifetip.errors import (
    ConnectionLost,
    ControllerError,
    ControllerRejected,
    ControllerSilent,
    NoSuchController,
)
from knifetip.gateway.linuxcnc.address import LinuxcncAddress
from knifetip.gateway.transport import Transport, connect, is_from_web_server
from knifetip.messages import Message

#: Longest reply (bytes); a longer one is not from linuxcncrsh.
_LONGEST_REPLY = 65536
#: Most messages of LinuxCNC that are read at a time.
_MOST_MESSAGES = 20
#: Parts of the time to wait for a reply.  If the gateway itself is held up, only one of them passes
#: unnoticed, so this does not count as silence of LinuxCNC.
_PARTS = 3
#: Reply to ``get error`` if there is no message.
_NO_ERROR = "OK"


class RemoteShell:
    """A connection to linuxcncrsh.

    Parameters
    ----------
    address
        Address of the LinuxCNC, with the passwords of linuxcncrsh.
    silence
        Seconds after which LinuxCNC counts as silent if a request has no reply.
    """

    def __init__(self, address: LinuxcncAddress, silence: float) -> None:
        self._address = address
        self._silence = silence
        self._transport: Transport | None = None
        self._rest = b""
        self._lock = asyncio.Lock()
        self._loss: ControllerError | None = None  # why the connection was closed

    @property
    def name(self) -> str:
        """Host and port, for messages."""
        return self._address.name

    @property
    def connected(self) -> bool:
        """Whether the connection is open."""
        return self._transport is not None

    async def open(self) -> None:
        """Connect to linuxcncrsh, and request permission to send commands.

        Raises
        ------
        NoSuchController
            A web server answers.
        ControllerError
            There is no answer, or a password is wrong.
        """
        self._transport = await connect(f"tcp://{self.name}")
        self._rest, self._loss = b"", None
        try:
            await self._greet()
            await self.enable()
        except BaseException:
            await self.close()
            raise

    async def _greet(self) -> None:
        greeting = await self._request(f"hello {self._address.password} knifetip 1.1", "HELLO")
        if not greeting.startswith("ACK"):
            raise ControllerError("linuxcnc.wrong-password", name=self.name, option="password")
        # While the echo is on, commands are sent back as they were sent.
        await self._request("set echo off\r\nset verbose on", "SET VERBOSE")

    async def enable(self) -> None:
        """Request permission to send commands, which only one connection has at a time.

        Raises
        ------
        ControllerError
            The password is wrong.
        """
        try:
            await self.set(f"enable {self._address.enable}")
        except ControllerRejected:
            raise ControllerError(
                "linuxcnc.wrong-password", name=self.name, option="enable"
            ) from None
        await self.set("set_wait received")

    async def close(self) -> None:
        """Close the connection; LinuxCNC continues with what it does."""
        transport, self._transport = self._transport, None
        if transport is not None:
            await transport.close()

    async def get(self, variable: str) -> str:
        """Return the value of a variable.

        Raises
        ------
        ControllerError
            The connection is lost, or LinuxCNC is silent.
        """
        return await self._request(f"get {variable}", variable.upper())

    async def set(self, command: str, patience: float = 0.0) -> None:
        """Send a command; return when LinuxCNC has received it.

        Parameters
        ----------
        command
            The command with its arguments, such as ``mode auto``.
        patience
            Time to wait for the reply (s), if it is more than the limit of silence.

        Raises
        ------
        ControllerRejected
            LinuxCNC refuses the command.
        ControllerError
            The connection is lost, or LinuxCNC is silent.
        """
        name = command.split()[0].upper()
        reply = await self._request(f"set {command}", f"SET {name}", patience)
        if not reply.startswith("ACK"):
            # Passwords are part of commands, so the first word must do there.
            shown = command if name != "ENABLE" else "enable"
            raise ControllerRejected(
                "linuxcnc.refused", name=self.name, command=shown, cause=await self.cause()
            )

    async def messages(self) -> list[str]:
        """Return the messages about errors that LinuxCNC has kept, and delete them there."""
        found: list[str] = []
        while len(found) < _MOST_MESSAGES and (error := await self.get("error")) != _NO_ERROR:
            found.append(error)
        return found

    async def cause(self) -> Message | None:
        """Return the kept messages of LinuxCNC as part of an error message; None for none."""
        found = await self.messages()
        return Message("linuxcnc.cause", texts=found) if found else None

    async def _request(self, text: str, prefix: str, patience: float = 0.0) -> str:
        """Send a request, and return its reply without the prefix and blanks around it.

        ``patience``: time to wait for the reply (s), if it is more than the limit of silence.
        """
        # A caller that is cancelled must not leave a reply unread: it would be taken for the reply
        # to the next request.
        conversation = asyncio.create_task(
            self._converse(text, prefix, max(patience, self._silence)), name="linuxcnc request"
        )
        conversation.add_done_callback(_retrieve_error)
        return await asyncio.shield(conversation)

    async def _converse(self, text: str, prefix: str, patience: float) -> str:
        async with self._lock:
            if self._transport is None:
                raise self._loss or ConnectionLost("linuxcnc.lost", name=self.name)
            exchange = asyncio.create_task(self._exchange(self._transport, text, prefix))
            try:
                for _ in range(_PARTS):
                    done, _ = await asyncio.wait({exchange}, timeout=patience / _PARTS)
                    if done:
                        return exchange.result()
                raise ControllerSilent("linuxcnc.silent", name=self.name, seconds=patience)
            except ControllerError as error:
                self._loss = error
                with suppress(ControllerError):
                    await self.close()
                raise
            finally:
                exchange.cancel()
                await asyncio.gather(exchange, return_exceptions=True)

    async def _exchange(self, transport: Transport, text: str, prefix: str) -> str:
        await transport.write(f"{text}\r\n".encode())
        return await self._reply(transport, prefix)

    async def _reply(self, transport: Transport, prefix: str) -> str:
        while True:
            while b"\n" not in self._rest:
                chunk = await transport.read()
                if not chunk or len(self._rest) > _LONGEST_REPLY:
                    raise ConnectionLost("linuxcnc.lost", name=self.name)
                self._rest += chunk
            line, _, self._rest = self._rest.partition(b"\n")
            reply = line.decode("utf-8", "replace").strip()
            if reply.startswith(f"{prefix} ") or reply == prefix:
                return reply.removeprefix(prefix).strip()
            if is_from_web_server(reply):
                raise NoSuchController("controller.web-server", address=self.name)


def _retrieve_error(conversation: asyncio.Task[str]) -> None:
    """Retrieve the error of a request whose caller was cancelled: asyncio logs it otherwise."""
    if not conversation.cancelled():
        conversation.exception()
