"""The sum of unanswered bytes is compared with the free bytes that a controller reports."""

from __future__ import annotations

from knifetip.gateway.grbl.receive_buffer import Count, PendingLine, ReceiveBuffer

LINE = PendingLine(b"G1 X100.0", 1)  # 10 bytes with its newline


def filled(lines: int) -> ReceiveBuffer:
    """Return a buffer of 128 bytes to which lines of 10 bytes were sent, none answered."""
    buffer = ReceiveBuffer()
    buffer.note_request(0.0)
    assert buffer.compare(128) == (Count.POSSIBLE, 1)
    for _ in range(lines):
        buffer.add(LINE)
    return buffer


def compare(buffer: ReceiveBuffer, occupied: int) -> tuple[Count, int]:
    buffer.note_request(0.0)
    return buffer.compare(128 - occupied)


def test_one_line_may_have_left_the_buffer_without_an_answer() -> None:
    buffer = filled(5)
    assert compare(buffer, 50)[0] is Count.POSSIBLE
    assert compare(buffer, 40)[0] is Count.POSSIBLE
    assert compare(buffer, 39) == (Count.MISSING, 1)
    assert compare(buffer, 30) == (Count.MISSING, 2)
    assert compare(buffer, 51) == (Count.SURPLUS, 1)
    assert compare(buffer, 40) == (Count.POSSIBLE, 1)


def test_lines_sent_after_the_request_may_not_have_arrived() -> None:
    buffer = filled(3)
    buffer.note_request(0.0)
    buffer.add(LINE)
    buffer.add(LINE)
    assert buffer.compare(128 - 20)[0] is Count.POSSIBLE
    assert compare(buffer, 20)[0] is Count.MISSING


def test_the_answers_to_several_requests_at_once_are_matched_to_the_first() -> None:
    buffer = filled(1)
    buffer.note_request(0.0)
    buffer.add(LINE)
    buffer.note_request(0.0)
    buffer.add(LINE)
    buffer.note_request(0.0)
    # One report for three requests, and then one that was requested 6 s later.
    assert buffer.compare(128)[0] is Count.POSSIBLE
    buffer.note_request(6.0)
    assert buffer.compare(128)[0] is Count.MISSING


def test_a_controller_that_reports_without_a_request_is_not_checked_for_missing_bytes() -> None:
    buffer = filled(5)
    assert buffer.compare(128)[0] is Count.POSSIBLE
    assert compare(buffer, 0)[0] is Count.POSSIBLE
    assert compare(buffer, 51)[0] is Count.SURPLUS


def test_after_a_reset_nothing_is_missing() -> None:
    buffer = filled(5)
    buffer.note_request(0.0)
    buffer.clear()
    assert buffer.compare(128)[0] is Count.POSSIBLE
    buffer.add(LINE)
    buffer.add(LINE)
    assert compare(buffer, 0)[0] is Count.MISSING


def test_a_report_without_the_free_bytes_proves_nothing() -> None:
    buffer = filled(5)
    buffer.note_request(0.0)
    assert buffer.compare(None) == (Count.POSSIBLE, 0)


def test_more_free_bytes_than_the_buffer_has_prove_nothing() -> None:
    buffer = filled(5)
    buffer.note_request(0.0)
    assert buffer.compare(1024)[0] is Count.POSSIBLE


def test_without_a_known_size_a_line_waits_for_the_answer_to_the_line_before() -> None:
    buffer = ReceiveBuffer()
    buffer.set_size(None)
    assert buffer.has_room_for(LINE)
    buffer.add(LINE)
    assert not buffer.has_room_for(LINE)
    buffer.remove_first()
    assert buffer.has_room_for(LINE)
    buffer.set_size(128)
    buffer.add(LINE)
    assert buffer.has_room_for(LINE)
