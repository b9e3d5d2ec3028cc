"""The simulated board of an MCX314 without a network: its requests, queue, ramps and holds."""

from __future__ import annotations

import random

import numpy as np
import pytest

from knifetip.errors import ControllerError
from knifetip.gateway.mcx314.frames import Splitter, checksum, pack, unpack
from knifetip.library import load
from knifetip.simulators.mcx314.board import Board
from knifetip.simulators.mcx314.program_queue import QUEUE

TABLE = load.machine("v-groove-table")
#: A square with rounded corners of radius 4, C along it, and an arc without C, at 400 mm/s.
ROUND = """MCX314 1
PULSES X200 Y200 Z400 C100
GO Z8000
OUT 0 OFF
OSC OFF
OUT 0 ON
DWELL 150
GO X10000 Y4000 C0
GO Z800
LINE Z-920 V40000
LINE X8000 V80000
{corner}
LINE Y8000 V80000 JOIN
LINE Z920 V40000
GO X4000 Y4000
LINE Z-920 V40000
CCW X8000 Y0 I4000 J0 V80000
CCW X-4000 Y4000 I-4000 J0 V80000 JOIN
LINE X-4000 V80000 JOIN
LINE Z920 V40000
GO Z8000
OUT 0 OFF
OSC OFF
END
"""


def corner() -> str:
    """Return a quarter circle of radius 4 mm as chords in pulses, C along it."""
    angles = np.radians(np.linspace(-90.0, 0.0, 9))
    points = np.column_stack([800.0 * np.cos(angles), 800.0 * np.sin(angles) + 800.0])
    ways = np.diff(np.rint(points), axis=0).astype(int)
    turns = np.diff(np.rint(np.linspace(0.0, 9000.0, 9))).astype(int)
    return "\n".join(
        f"LINE X{x} Y{y} C{turn} V360000 JOIN" for (x, y), turn in zip(ways, turns, strict=True)
    )


LINES = ROUND.format(corner=corner()).splitlines()


class Client:
    """Sends requests to a board, each with a new tag."""

    def __init__(self, board: Board) -> None:
        self.board = board
        self.tag = 0

    def __call__(self, text: str) -> str:
        self.tag += 1
        return self.repeat(self.tag, text)

    def repeat(self, tag: int, text: str) -> str:
        answer = unpack(self.board.receive(pack(tag, text)).rstrip(b"\n"))
        assert answer is not None
        assert answer[0] == tag
        return answer[1]


def begun(sample: float = 0.0) -> tuple[Board, Client]:
    board = Board(TABLE, sample=sample)
    client = Client(board)
    assert client(f"BEGIN {len(LINES)}") == "OK PROGRAM=1"
    return board, client


def load_lines(client: Client, first: int, count: int) -> str:
    return client(f"LOAD 1 {first} {'|'.join(LINES[first - 1 : first - 1 + count])}")


# -- frames ---------------------------------------------------------------------------------------


def test_a_frame_has_the_checksum_of_ccitt() -> None:
    # The check value of CRC-16/CCITT-FALSE in the catalogues of checksums.
    assert checksum(b"123456789") == b"29B1"
    assert pack(7, "HELLO") == b"7 HELLO*" + checksum(b"7 HELLO") + b"\n"
    assert unpack(pack(7, "HELLO").rstrip(b"\n")) == (7, "HELLO")
    assert unpack(pack(7, "HELLO").rstrip(b"\n") + b"\r") == (7, "HELLO")


@pytest.mark.parametrize("place", range(8))
def test_a_changed_byte_is_noticed(place: int) -> None:
    line = bytearray(pack(7, "HELLO").rstrip(b"\n"))
    line[place] ^= 1
    assert unpack(bytes(line)) is None


def test_lines_are_divided_and_long_ones_dropped() -> None:
    splitter = Splitter()
    assert splitter.feed(b"1 A") == []
    assert splitter.feed(b"*0000\n2 B\n3") == [b"1 A*0000", b"2 B"]
    assert splitter.feed(b"x" * 5000) == []
    assert splitter.feed(b"\n4 C\n") == [b"4 C"]


# -- requests -------------------------------------------------------------------------------------


def test_a_repeated_request_is_answered_but_not_executed_again() -> None:
    _, client = begun()
    assert client.repeat(1, f"BEGIN {len(LINES)}") == "OK PROGRAM=1"
    assert client("BEGIN 5") == "ERR busy RUN"
    first = load_lines(client, 1, 4)
    assert first == f"OK FREE={QUEUE - 4}"
    assert client.repeat(client.tag, "anything") == first
    assert load_lines(client, 1, 4) == "ERR order 5"
    assert load_lines(client, 5, 4) == f"OK FREE={QUEUE - 8}"


@pytest.mark.parametrize(
    ("request_", "answer"),
    [
        ("FLY", "ERR unknown"),
        ("LOAD 1 1", "ERR syntax"),
        ("LOAD 2 1 ;", "ERR program"),
        ("LOAD 1 2 ;", "ERR order 1"),
        ("LOAD 1 1 MCX314 1|G0", "ERR line 2 syntax"),
        ("BEGIN 0", "ERR busy RUN"),
        ("GUARD here", "ERR syntax"),
        ("MOVE X5 V5", "ERR busy RUN"),
        ("OUT 3", "ERR line 0 syntax"),
    ],
)
def test_wrong_requests_are_refused(request_: str, answer: str) -> None:
    _, client = begun()
    assert client(request_) == answer


def test_damaged_requests_are_not_answered() -> None:
    board = Board(TABLE)
    assert board.receive(b"1 HELLO*0000\n1 HELLO\n\n\xff\xfe\n") == b""


def test_a_machine_without_an_mcx314_is_refused() -> None:
    with pytest.raises(ControllerError, match="does not state how"):
        Board(load.machine("demo-table"))


# -- motion ---------------------------------------------------------------------------------------


def test_corners_and_arcs_are_driven_without_lost_steps_and_within_the_ramps() -> None:
    board, client = begun(sample=0.0005)
    for first in range(1, len(LINES) + 1, 5):
        assert load_lines(client, first, 5).startswith("OK")
    board.advance(20.0)
    assert (board.refusals, board.starved) == ([], 0)
    assert board.state == "IDLE"
    assert f"DONE={len(LINES)} " in client("STATUS")
    samples = board.samples()
    low = samples[samples[:, 3] == -0.3]
    spans = np.diff(low[:, 0])
    steps = np.hypot(*np.diff(low[:, 1:3], axis=0).T)
    near = (spans > 0.0004) & (spans < 0.0006)
    # The straight steps of an arc are 1.0548 times as fast, and two pulses are rounded.
    assert (steps[near] / spans[near]).max() < 400.0 * 1.0548 + 2.0 / 200.0 / 0.0005
    circle = low[(low[:, 2] > 20.01) & (low[:, 1] > 40.0) & (low[:, 1] < 60.0) & (low[:, 4] == 90)]
    assert len(circle) > 50
    assert np.abs(np.hypot(circle[:, 1] - 40.0, circle[:, 2] - 20.0) - 20.0).max() < 0.011


def test_an_empty_queue_ends_in_a_stop_and_not_in_lost_steps() -> None:
    board, client = begun()
    for first in range(1, len(LINES) + 1):
        assert load_lines(client, first, 1).startswith("OK")
        board.advance(0.6)
    board.advance(5.0)
    assert board.refusals == []
    assert board.state == "IDLE"


def test_a_full_queue_takes_no_more() -> None:
    board = Board(TABLE)
    client = Client(board)
    client("BEGIN 200")
    client("LOAD 1 1 MCX314 1|PULSES X200 Y200 Z400 C100|DWELL 60000")
    for first in range(4, 124, 20):
        assert client(f"LOAD 1 {first} " + "|".join([";"] * 20)).startswith("OK")
    assert client("LOAD 1 124 " + "|".join([";"] * 10)) == "ERR full"


@pytest.mark.parametrize("seed", range(8))
def test_holds_and_aborts_at_any_moment_lose_no_steps(seed: int) -> None:
    chance = random.Random(seed)
    board = Board(TABLE)
    client = Client(board)
    for program in (1, 2):
        assert client(f"BEGIN {len(LINES)}") == f"OK PROGRAM={program}"
        loaded, aborted = 0, False
        for _ in range(3000):
            if loaded < len(LINES) and not aborted:
                part = LINES[loaded : loaded + chance.randint(1, 5)]
                assert client(f"LOAD {program} {loaded + 1} {'|'.join(part)}").startswith("OK")
                loaded += len(part)
            board.advance(chance.choice((0.0003, 0.002, 0.02, 0.1)))
            if chance.random() < 0.05:
                client("HOLD")
            elif chance.random() < 0.3:
                client("RESUME")
            elif chance.random() < 0.004:
                client("ABORT")
                aborted = True
            if board.state == "IDLE" and "STILL=1" in client("STATUS"):
                break
        assert board.refusals == []
        assert board.state == "IDLE"
        if not aborted:
            assert f"DONE={len(LINES)} " in client("STATUS")
