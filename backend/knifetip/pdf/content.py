"""content: parse a content stream into operators with their operands.

    b"1 0 0 RG 10 20 m 30 20 l S" -> ("RG", [1, 0, 0]), ("m", [10, 20]), ("l", [30, 20]), ("S", [])

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
#: Largest number of operands of one operator.
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
        Code of the message that states what is incomplete.
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
    given: list[Any] = []
    enclosing: list[list[Any]] = []
    at = 0
    while (found := _TOKEN.match(data, at)) is not None:
        kind = found.lastindex
        at = found.end()
        if kind == 1:
            given.append(float(found[1]))
        elif kind == 2:
            operator = found[2].decode("latin-1")
            if enclosing:
                # true, false and null are the only words in an array.
                continue
            if operator == "BI":
                at = _end_of_image(data, at)
            yield operator, given
            given = []
        elif kind == 3:
            given.append(_name(found[3]))
        elif kind == 4:
            start, at = at, _string_end(data, at)
            given.append(_ESCAPE.sub(_unescape, data[start : at - 1]))
        elif kind == 5:
            if len(enclosing) == _MAX_DEPTH:
                raise TruncatedStream("pdf.nested-arrays")
            enclosing.append(given)
            given = []
        elif kind == 6 and enclosing:
            inside, given = given, enclosing.pop()
            given.append(inside if found[6] == b"]" else None)
        elif kind == 7:
            digits = _NOT_HEX.sub(b"", found[7])
            given.append(bytes.fromhex((digits + b"0" * (len(digits) % 2)).decode()))
        if len(given) > _OPERANDS:
            del given[:-_OPERANDS]
    if enclosing:
        raise TruncatedStream("pdf.open-array")


def _name(raw: bytes) -> Name:
    if b"#" in raw:
        raw = _NUMBERED.sub(lambda found: bytes((int(found[1], 16),)), raw)
    for charset in _CHARSETS:
        try:
            return Name(raw.decode(charset))
        except UnicodeDecodeError:
            continue
    raise AssertionError("latin-1 has all bytes")


def _string_end(data: bytes, at: int) -> int:
    """Return the index after the closing parenthesis of a string whose content starts at ``at``.

    Raises
    ------
    TruncatedStream
        The string is not closed.
    """
    deep = 1
    for found in _IN_STRING.finditer(data, at):
        if found[0] == b"(":
            deep += 1
        elif found[0] == b")":
            deep -= 1
            if deep == 0:
                return found.end()
    raise TruncatedStream("pdf.open-text")


def _unescape(found: re.Match[bytes]) -> bytes:
    """Return the bytes that an escape sequence in a PDF string represents.

    ``found`` is the match of the escape sequence, as the callback of ``re.sub`` gets it.
    """
    if found[1]:
        return bytes((int(found[1], 8) & 255,))
    if found[2] in (b"\n", b"\r", b"\r\n"):
        return b""
    return _ESCAPED.get(found[2], found[2])


def _end_of_image(data: bytes, at: int) -> int:
    """Return the index after the end of an inline image.

    ``at`` is the index after the operator BI, with which the image starts.

    Raises
    ------
    TruncatedStream
        The image has no end.
    """
    found = _PICTURE_ENDS.search(data, at)
    if found is None:
        raise TruncatedStream("pdf.open-image")
    return found.end()
