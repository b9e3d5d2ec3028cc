"""frames: the lines between a gateway and the board of an MCX314, each with a checksum.

A request is ``TAG COMMAND*CRC`` and its answer ``TAG OK …*CRC`` or ``TAG ERR CODE …*CRC``, each
with a newline.  CRC is the CRC-16 of CCITT, of all bytes before the asterisk, as four hexadecimal
digits.  A line with a wrong checksum is ignored, so the sender repeats its request with the same
tag; the board answers a repeated tag again without executing it twice.
"""

from __future__ import annotations

import binascii

#: Greatest length of a line (bytes), without its newline.
LONGEST = 512


def checksum(payload: bytes) -> bytes:
    """Return the checksum of a line, as four hexadecimal digits."""
    return b"%04X" % binascii.crc_hqx(payload, 0xFFFF)


def pack(tag: int, text: str) -> bytes:
    """Return a line with its tag, checksum and newline."""
    payload = f"{tag} {text}".encode("ascii")
    return payload + b"*" + checksum(payload) + b"\n"


def unpack(line: bytes) -> tuple[int, str] | None:
    """Return the tag and the text of a line without its newline; None if the line is damaged."""
    payload, star, check = line.rstrip(b"\r").rpartition(b"*")
    tag, _, text = payload.partition(b" ")
    if not star or check != checksum(payload) or not tag.isdigit() or not text.isascii():
        return None
    return int(tag), text.decode("ascii")


class Splitter:
    """Divides received bytes into lines; longer ones than ``LONGEST`` are dropped."""

    def __init__(self) -> None:
        self._rest = b""

    def feed(self, data: bytes) -> list[bytes]:
        """Return the lines that are complete after more bytes, without their newlines."""
        *lines, self._rest = (self._rest + data).split(b"\n")
        if len(self._rest) > LONGEST:
            self._rest = self._rest[-LONGEST - 1 :]
        return [line for line in lines if len(line) <= LONGEST]
