"""program_blocks: the effect of each line of a program, interpreted once for all who follow it.

The time of a program is known only when all its lines were interpreted.  The blocks are then kept,
so that the corridor and the follower of the running program need not interpret the lines again.  Of
a program with more than ``KEPT`` lines they are not kept, because a block takes about 550 bytes;
such a program is interpreted once more while it runs.
"""

from __future__ import annotations

import asyncio
import itertools
from array import array
from collections.abc import Callable, Iterable, Iterator

from knifetip.gateway.interpreter import Block, LineInterpreter, LineRefused
from knifetip.gateway.line_times import LineTimes
from knifetip.gateway.motion import Limits

#: Lines of a program whose blocks are kept at most.
KEPT = 200_000
#: Number of lines that are interpreted before other tasks can run.
TURN = 500


def lines_of(text: bytes) -> Iterator[bytes]:
    """Yield the lines of a program without newlines, without copying the whole program."""
    at = 0
    while at < len(text):
        end = text.find(b"\n", at)
        if end < 0:
            end = len(text)
        yield text[at:end]
        at = end + 1


def read_blocks(text: bytes, interpreter: LineInterpreter) -> Iterator[Block | None]:
    """Yield the effect of each line of a program; None for a line that is refused.

    Parameters
    ----------
    text
        The program.
    interpreter
        Interpreter of its lines, at the position before the first one.
    """
    for line in lines_of(text):
        try:
            yield interpreter.read(line)
        except LineRefused:
            yield None


class ProgramBlocks:
    """The blocks of a program.

    Parameters
    ----------
    text
        The program.
    interpreter
        Returns a new interpreter of its lines, at the position before the first one.
    """

    def __init__(self, text: bytes, interpreter: Callable[[], LineInterpreter]) -> None:
        self._text = text
        self._interpreter = interpreter
        self._kept: list[Block | None] | None = None

    async def measure(self, limits: Limits) -> array[float]:
        """Return the duration of each line of the program (s), as ``LineTimes`` computes it.

        Yields to the event loop after every ``TURN`` lines.
        """
        times = LineTimes(limits)
        kept: list[Block | None] | None = []
        for lines, block in enumerate(read_blocks(self._text, self._interpreter()), 1):
            times.add(block)
            if kept is not None:
                kept.append(block)
                if lines > KEPT:
                    kept = None
            if lines % TURN == 0:
                await asyncio.sleep(0)
        times.end()
        self._kept = kept
        return times.seconds

    def readers(self) -> tuple[Iterator[Block | None], Iterator[Block | None]]:
        """Return two iterators over the blocks, which may be read at different times."""
        kept: Iterable[Block | None] | None = self._kept
        if kept is not None:
            return iter(kept), iter(kept)
        first, second = itertools.tee(read_blocks(self._text, self._interpreter()))
        return first, second
