"""Read the moves of an RS274/NGC program."""

from __future__ import annotations

from operator import itemgetter
from typing import Final

from knifetip.messages import Message
from knifetip.model.board import Board
from knifetip.model.machine import Machine
from knifetip.verification.reading.moves import Moves
from knifetip.verification.reading.rs274.interpret import interpret
from knifetip.verification.reading.rs274.parse import (
    active_comments,
    comment_placement,
    parse_words,
    realtime_bytes,
)


class Rs274Reader:
    """Reader of RS274/NGC programs for LinuxCNC, which contain T words, and for grblHAL, which
    contain none.
    """

    def placement(self, text: bytes) -> tuple[float, float] | None:
        """Return the placement that the program's comments state, or None if they state none.

        The placement is the offset (x, y) in mm from the drawing's to the sheet's coordinates.
        """
        return comment_placement(text)

    def read(
        self, text: bytes, machine: Machine, board: Board
    ) -> tuple[Moves, list[tuple[int, Message]]]:
        """Return the moves of a program, and its faults (1-based line, message) in ascending order.

        Raises ProgramUnreadable if the text is not of type bytes or is too large.
        """
        del board  # the program moves every axis
        moves, faults = interpret(parse_words(text), machine)
        executed = active_comments(text) if moves.uses_tool_table else realtime_bytes(text)
        return moves, sorted(faults + executed, key=itemgetter(0))


READER: Final = Rs274Reader()
