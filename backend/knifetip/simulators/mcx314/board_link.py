"""board_link: executes and answers the requests to the board, and injects faults of the link."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable
from dataclasses import dataclass

from knifetip.gateway.mcx314.frames import Splitter, pack, unpack
from knifetip.simulators.mcx314.refusal import RequestRefused

#: Answers that are kept, in case a request is repeated.
KEPT = 64


@dataclass(frozen=True, slots=True)
class LinkFaults:
    """Faults that the simulated board injects: numbers of valid requests, from 1."""

    drop_answers: frozenset[int] = frozenset()  #: executed, but not answered
    damage_answers: frozenset[int] = frozenset()  #: a byte of the answer is changed
    ignore: frozenset[int] = frozenset()  #: lost on their way to the board
    hang_up: int = 0  #: the connection breaks before this request is executed
    silent_from: int = 0  #: no request from this one on is executed or answered


class BoardLink:
    """The board's end of the link between gateway and board; a repeated request is answered again.

    Parameters
    ----------
    execute
        Function that executes a request and returns what its answer states; it may raise
        ``RequestRefused``.
    on_request
        Function that is called for each request that arrives, also for a repeated one.
    """

    def __init__(self, execute: Callable[[str], str], on_request: Callable[[], None]) -> None:
        self.requests = 0  #: valid requests that have arrived
        self._execute = execute
        self._on_request = on_request
        self._splitter = Splitter()
        self._answers: OrderedDict[int, str] = OrderedDict()

    def hangs_up(self, faults: LinkFaults) -> bool:
        """Return whether the connection breaks now (an injected fault)."""
        return 0 < faults.hang_up <= self.requests

    def connect(self) -> None:
        """Discard the rest of an earlier connection."""
        self._splitter = Splitter()
        self._answers.clear()

    def receive(self, data: bytes, faults: LinkFaults) -> bytes:
        """Process received bytes and return the answers."""
        answers = b""
        for line in self._splitter.feed(data):
            request = unpack(line)
            if request is None:
                continue
            self.requests += 1
            answers += self._answer(*request, faults)
        return answers

    def _answer(self, tag: int, text: str, faults: LinkFaults) -> bytes:
        number = self.requests
        if self.hangs_up(faults) or number in faults.ignore or 0 < faults.silent_from <= number:
            return b""
        self._on_request()
        if (answer := self._answers.get(tag)) is None:
            try:
                answer = " ".join(filter(None, ["OK", self._execute(text)]))
            except RequestRefused as refused:
                answer = f"ERR {' '.join(map(str, refused.args))}"
            self._answers[tag] = answer
            if len(self._answers) > KEPT:
                self._answers.popitem(last=False)
        packed = pack(tag, answer)
        if number in faults.damage_answers:
            packed = packed.replace(b"O", b"Q", 1).replace(b"E", b"F", 1)
        return b"" if number in faults.drop_answers else packed
