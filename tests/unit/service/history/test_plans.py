"""No step of the queue reads a whole table of the history (PostgreSQL)."""

from __future__ import annotations

from collections import defaultdict
from functools import partial

import sqlalchemy as sa

from knifetip.service.history.store import HistoryFilter
from tests.benchmarks.history import run_round, whole_tables
from tests.support.history import fill
from tests.support.stored import migrated_store


def test_no_step_reads_a_whole_table(postgresql_url: str) -> None:
    with migrated_store(postgresql_url, None) as store:
        fill(store, 20_000)
        run_round(store, defaultdict(list))
        assert whole_tables(store) == []
        # The test detects a missing index, here that of equal files.
        with store.database.writing() as session:
            session.execute(sa.text("DROP INDEX drawing_by_sha256"))
        assert len(whole_tables(store)) == 1


def test_the_sweep_of_contents_and_the_deletion_of_jobs_read_no_whole_table(
    postgresql_url: str,
) -> None:
    with migrated_store(postgresql_url, None) as store:
        fill(store, 20_000)
        first = store.history.search(HistoryFilter(), None, 100)[-1].ended
        assert whole_tables(store, store.contents.sweep) == []
        assert whole_tables(store, partial(store.history.delete_before, first)) == []
