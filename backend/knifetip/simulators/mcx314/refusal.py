"""refusal: the exception with which parts of the board refuse a request."""

from __future__ import annotations

from knifetip.gateway.mcx314.instructions import BadLine, Instruction, parse


class RequestRefused(Exception):
    """Raised for a request that the board refuses; the first argument is the code."""


def parse_or_refuse(text: str, number: int = 0) -> Instruction:
    """Parse an instruction of a request, with the number of its program line.

    Raises
    ------
    RequestRefused
        The text is not an instruction.
    """
    try:
        return parse(text)
    except BadLine:
        raise RequestRefused("line", number, "syntax") from None
