"""After a crash, the journal shows which job has no end."""

from __future__ import annotations

from pathlib import Path

import pytest

from knifetip.gateway import journal as module
from knifetip.gateway.journal import Journal, UnfinishedJob
from knifetip.messages import Message


def test_a_job_that_began_and_did_not_end_is_found_with_its_line(tmp_path: Path) -> None:
    path = tmp_path / "journal"
    journal = Journal(path)
    journal.begin("a", 1, "00", 50)
    journal.end("a", 1, "done", None)
    journal.begin("b", 7, "00", 50)
    journal.line("b", 0, 12, 20)
    journal.line("b", 0, 31, 40)
    assert Journal(path).unfinished() == UnfinishedJob("b", 7, "00", lines=50, line=31)


def test_a_job_that_ended_is_not_unfinished(tmp_path: Path) -> None:
    journal = Journal(tmp_path / "journal")
    assert journal.unfinished() is None
    journal.begin("a", 1, "00", 50)
    journal.end("a", 1, "cancelled", Message("gateway.cancelled", line=7))
    assert journal.unfinished() is None


def test_a_job_is_abandoned_until_the_controller_was_seen_idle(tmp_path: Path) -> None:
    path = tmp_path / "journal"
    journal = Journal(path)
    assert not journal.is_abandoned()
    journal.begin("a", 1, "00", 50)
    journal.end("a", 1, "interrupted", None)
    assert journal.is_abandoned()
    assert Journal(path).is_abandoned()
    journal.rest()
    journal.rest()
    assert not journal.is_abandoned()
    assert not Journal(path).is_abandoned()
    assert path.read_text().count('"rest"') == 1
    journal.begin("b", 2, "00", 50)
    assert Journal(path).is_abandoned()


def test_a_dry_run_is_abandoned_until_the_controller_was_seen_idle(tmp_path: Path) -> None:
    path = tmp_path / "journal"
    journal = Journal(path)
    journal.dry_run("a")
    assert journal.is_abandoned()
    assert Journal(path).is_abandoned()
    # It is no job that ran: nothing is reported to the server.
    assert Journal(path).unfinished() is None
    journal.rest()
    assert not Journal(path).is_abandoned()


def test_only_what_precedes_motion_must_be_recorded(
    tmp_path: Path, caplog: pytest.LogCaptureFixture
) -> None:
    path = tmp_path / "journal"
    journal = Journal(path)
    journal.begin("a", 1, "00", 50)
    path.unlink()
    path.mkdir()
    journal.line("a", 0, 12, 20)
    journal.line("a", 0, 13, 20)
    journal.record_copy("a", 1)
    journal.record_outcome("a", "done", None)
    journal.end("a", 1, "done", None)
    assert [record.getMessage()[:32] for record in caplog.records] == [
        "the journal cannot be written: ["
    ]
    with pytest.raises(OSError, match="directory"):
        journal.rest()
    with pytest.raises(OSError, match="directory"):
        journal.dry_run("b")
    with pytest.raises(OSError, match="directory"):
        journal.begin("b", 2, "00", 50)


def test_a_line_cut_short_by_the_power_does_not_hide_the_rest(tmp_path: Path) -> None:
    path = tmp_path / "journal"
    journal = Journal(path)
    journal.begin("a", 1, "00", 50)
    journal.line("a", 0, 12, 20)
    with path.open("ab") as file:
        file.write(b'{"event": "line", "job": "a", "exec')
    assert journal.unfinished() == UnfinishedJob("a", 1, "00", lines=50, line=12)
    # The next line is not appended to the broken one.
    Journal(path).record_outcome("a", "done", None)
    assert Journal(path).unfinished() == UnfinishedJob(
        "a", 1, "00", lines=50, line=12, outcome="done"
    )


def test_the_same_line_is_written_once(tmp_path: Path) -> None:
    path = tmp_path / "journal"
    journal = Journal(path)
    for _ in range(5):
        journal.line("a", 0, 12, 20)
    assert path.read_bytes().count(b"\n") == 1


def test_a_long_journal_is_set_aside(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "LONG", 100)
    path = tmp_path / "journal"
    journal = Journal(path)
    journal.begin("a", 1, "0" * 64, 50)
    journal.end("a", 1, "done", None)
    journal.begin("b", 1, "0" * 64, 50)
    assert path.read_bytes().count(b"\n") == 1
    assert (tmp_path / "journal.1").read_bytes().count(b"\n") == 2


def test_without_a_path_nothing_is_kept() -> None:
    journal = Journal(None)
    journal.begin("a", 1, "00", 50)
    assert journal.unfinished() is None


def test_copies_and_an_outcome_that_was_not_heard_are_found(tmp_path: Path) -> None:
    journal = Journal(tmp_path / "journal")
    journal.begin("a", 1, "00", 50, copies=2)
    journal.line("a", 0, 50, 50)
    journal.record_copy("a", 1)
    assert journal.unfinished() == UnfinishedJob(
        "a", 1, "00", lines=50, copies=2, copies_done=1, copy_begun=False
    )
    journal.begin_copy("a")
    journal.program("a", "/programs/a.ngc")
    journal.line("a", 1, 7, 9)
    journal.record_outcome("a", "cancelled", Message("gateway.cancelled", line=7), 9)
    assert journal.unfinished() == UnfinishedJob(
        "a",
        1,
        "00",
        lines=50,
        copies=2,
        copies_done=1,
        line=7,
        line_at_most=9,
        program="/programs/a.ngc",
        outcome="cancelled",
        cause=Message("gateway.cancelled", line=7),
    )


def test_a_journal_of_before_copies_were_recorded_is_read(tmp_path: Path) -> None:
    path = tmp_path / "journal"
    path.write_text(
        '{"event": "begin", "job": "a", "epoch": 1, "sha256": "00", "lines": 50}\n'
        '{"event": "line", "job": "a", "copy": 0, "executed": 50, "acknowledged": 50}\n'
    )
    left = Journal(path).unfinished()
    # A report of the last line does not prove that the machine came to rest.
    assert left == UnfinishedJob("a", 1, "00", lines=50, line=50)
    assert left.copies_done < left.copies
