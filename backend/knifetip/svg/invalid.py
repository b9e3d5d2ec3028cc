"""invalid: the error for an attribute whose value cannot be parsed."""

from __future__ import annotations

from knifetip.messages import Argument, Message


class InvalidValue(ValueError):
    """Raised if the value of an SVG attribute cannot be parsed.

    Parameters
    ----------
    code, arguments
        Code and arguments of the message that contains the reason.
    """

    def __init__(self, code: str, /, **arguments: Argument) -> None:
        self.message = Message(code, **arguments)
        super().__init__(self.message)
