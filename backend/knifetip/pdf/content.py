"""content: parse a content stream into operators with their operands.

For example, ``b"1 0 0 RG 10 20 m"`` gives the operator "RG" with [1, 0, 0] and "m" with [10, 20].

A content stream is the sequence of drawing commands of a PDF page.  It may have a hundred thousand
operators, so one regular expression finds all tokens.  Dictionaries and inline images are skipped;
arrays become lists.

Source: ISO 32000-1, chapters 7.2, 7.3 and 7.8.2.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any, Final

#: Deepest nesting of arrays and dictionaries; operators need at most three.
_MAX_DEPTH: Final = 32
#: Number of the last operands of an operator that are always kept.
_OPERANDS: Final = 10_000

_TOKEN: Final = re.compile(
    rb"[\x00\t\n\f\r ]*(?:"
    rb"((?>[-+]?(?:\d+\.?\d*|\.\d+)))(?=[\x00\t\n\f\r \[\]/<>()%{}]|\Z)"  # 1 a number
    rb"|([^\x00\t\n\f\r \[\]/<>()%{}]+)"  # 2 an operator
    rb"|/([^\x00\t\n\f\r \[\]/<>()%{}]*)"  # 3 a name
    rb"|(\()"  # 4 the start of a string
    rb"|(<<|\[)"  # 5 the start of a dictionary or an array
    rb"|(>>|\])"  # 6 the end of a dictionary or an array
    rb"|<([^<>]*)>"  # 7 a string in hexadecimal digits
    rb"|%[^\r\n]*|.)",  # skipped
    re.DOTALL,
)
_IN_STRING: Final = re.compile(rb"[()]|\\.", re.DOTALL)
_ESCAPE: Final = re.compile(rb"\\(?:([0-7]{1,3})|(\r\n|.))", re.DOTALL)
_ESCAPED: Final = {b"n": b"\n", b"r": b"\r", b"t": b"\t", b"b": b"\b", b"f": b"\f"}
#: The end of an inline image: EI between blanks, followed by text and not by samples.
_PICTURE_ENDS: Final = re.compile(rb"[\x00\t\n\f\r ]EI(?=[\x00\t\n\f\r ][\t\n\f\r -~]{0,16}|\Z)")
_NUMBERED: Final = re.compile(rb"#([0-9A-Fa-f]{2})")
_NOT_HEX: Final = re.compile(rb"[^0-9A-Fa-f]")
#: Encodings of names, in the order that pypdf tries them.
_CHARSETS: Final = ("utf-8", "gbk", "latin-1")


class TruncatedStream(Exception):
    """Raised if a content stream ends inside an object; ``pdf.page_reader`` catches it.

    Parameters
    ----------
    code
        Code of the message that names the incomplete object.
    """

    def __init__(self, code: str) -> None:
        super().__init__(code)
        self.code = code


class Name(str):
    """A PDF name, without its slash."""

    __slots__ = ()


def parse_operations(data: bytes) -> Iterator[tuple[str, list[Any]]]:
    """Yield each operator of a content stream with its operands: numbers, names, strings, lists.

    An inline image is one operator, ``BI``.

    Raises
    ------
    TruncatedStream
        The stream ends inside a string, an array or an image, or arrays are nested too deeply.
    """
    operands: list[Any] = []
    enclosing: list[list[Any]] = []
    position = 0
    while (match := _TOKEN.match(data, position)) is not None:
        kind = match.lastindex
        position = match.end()
        if kind == 1:
            operands.append(float(match[1]))
        elif kind == 2:
            operator = match[2].decode("latin-1")
            if enclosing:
                # true, false and null are the only words in an array.
                continue
            if operator == "BI":
                position = _end_of_image(data, position)
            yield operator, operands
            operands = []
        elif kind == 3:
            operands.append(decode_name(match[3]))
        elif kind == 4:
            start, position = position, _string_end(data, position)
            operands.append(_ESCAPE.sub(_unescape, data[start : position - 1]))
        elif kind == 5:
            if len(enclosing) == _MAX_DEPTH:
                raise TruncatedStream("pdf.nested-arrays")
            enclosing.append(operands)
            operands = []
        elif kind == 6 and enclosing:
            inner, operands = operands, enclosing.pop()
            operands.append(inner if match[6] == b"]" else None)
        elif kind == 7:
            digits = _NOT_HEX.sub(b"", match[7])
            operands.append(bytes.fromhex((digits + b"0" * (len(digits) % 2)).decode()))
        # Half of them at once: each deletion moves those that remain.
        if len(operands) >= 2 * _OPERANDS:
            del operands[:-_OPERANDS]
    if enclosing:
        raise TruncatedStream("pdf.open-array")


def decode_name(raw: bytes) -> Name:
    """Return the name that a content stream contains as the bytes ``raw``, without the slash."""
    if b"#" in raw:
        raw = _NUMBERED.sub(lambda match: bytes((int(match[1], 16),)), raw)
    for charset in _CHARSETS:
        try:
            return Name(raw.decode(charset))
        except UnicodeDecodeError:
            continue
    raise AssertionError("latin-1 has all bytes")


def _string_end(data: bytes, start: int) -> int:
    """Return the index after the closing parenthesis of a string in a content stream.

    ``start`` is the index in ``data`` at which the content of the string starts.

    Raises ``TruncatedStream``: the string is not closed.
    """
    deep = 1
    for match in _IN_STRING.finditer(data, start):
        if match[0] == b"(":
            deep += 1
        elif match[0] == b")":
            deep -= 1
            if deep == 0:
                return match.end()
    raise TruncatedStream("pdf.open-text")


def _unescape(match: re.Match[bytes]) -> bytes:
    """Return the bytes that an escape sequence in a PDF string represents.

    ``match`` is the match of the escape sequence; this function is a callback of ``re.sub``.
    """
    if match[1]:
        return bytes((int(match[1], 8) & 255,))
    if match[2] in (b"\n", b"\r", b"\r\n"):
        return b""
    return _ESCAPED.get(match[2], match[2])


def _end_of_image(data: bytes, start: int) -> int:
    """Return the index in ``data`` after the end of an inline image.

    ``start`` is the index after the operator BI, with which the image starts.

    Raises ``TruncatedStream``: the image has no end.
    """
    match = _PICTURE_ENDS.search(data, start)
    if match is None:
        raise TruncatedStream("pdf.open-image")
    return match.end()
