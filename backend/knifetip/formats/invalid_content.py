"""invalid_content: the error for a value or a shape of a file that cannot be read."""

from __future__ import annotations

from knifetip.messages import Argument, Message


class InvalidContent(ValueError):
    """Raised if a value or a shape of a file cannot be read; the rest of the file is read.

    Parameters
    ----------
    code, arguments
        Code and arguments of the message that contains the reason.
    """

    def __init__(self, code: str, /, **arguments: Argument) -> None:
        self.message = Message(code, **arguments)
        super().__init__(self.message)
