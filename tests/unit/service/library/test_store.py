"""Machines and boards of users: versions, conflicts, and the jobs that were compiled for them."""

from __future__ import annotations

import pytest

from knifetip.errors import LibraryError, NotFound, StaleEpoch, StaleVersion, WrongState
from knifetip.library import load
from knifetip.library.definition import Definition, Shelf
from knifetip.service.database.tables import Job
from knifetip.service.library.store import VersionNote
from knifetip.service.processes.compile_result import CompileResult
from knifetip.service.store import Store
from tests.support import job_states
from tests.support.job_states import confirm
from tests.support.stored import Clock

MACHINE = load.library_text("machines", "demo-table")
BOARD = load.library_text("boards", "e-flute")


def save(
    store: Store,
    version: int = 0,
    width: int = 1600,
    name: str = "table",
    replace_any: bool = False,
) -> int:
    """Store a version of a machine, and return its number."""
    text = MACHINE.replace("width = 1600.0", f"width = {width}.0")
    definition = Definition(Shelf.MACHINES, name, version, text)
    note = VersionNote("Ada", f"width {width}")
    return store.library.save(definition, "Own table", note, replace_any=replace_any).version


def save_board(store: Store, version: int = 0) -> int:
    definition = Definition(Shelf.BOARDS, "own", version, BOARD)
    return store.library.save(definition, "Own board").version


def ready(store: Store) -> Job:
    """Return a compiled job for the newest versions of the machine and the board."""
    machine = store.library.machine("table").version
    board = store.library.board("own").version
    job = job_states.compiling(store, board="own", machine_version=machine, board_version=board)
    store.compiles.save_result(job.id, job.epoch, job_states.RESULT)
    return store.jobs.get(job.id)


@pytest.fixture
def shop(store: Store) -> Store:
    """Return a store with a machine and a board."""
    save(store)
    save_board(store)
    return store


def test_each_change_is_a_version_and_old_versions_are_kept(store: Store, clock: Clock) -> None:
    assert save(store) == 1
    clock.now += 60.0
    assert save(store, 1, 1700) == 2
    assert (store.library.machine("table").width, store.library.machine("table").version) == (
        1700.0,
        2,
    )
    old = store.library.machine("table", 1)
    assert (old.width, old.version) == (1600.0, 1)
    newest, first = store.library.versions(Shelf.MACHINES, "table")
    assert (newest.version, newest.by, newest.note) == (2, "Ada", "width 1700")
    assert newest.at == first.at + 60.0
    assert [row.version for row in store.library.all(Shelf.MACHINES)] == [2]
    assert [machine.name for machine in store.library.machines()] == [
        "table",
        *load.names("machines"),
    ]


def test_a_change_must_name_the_newest_version(store: Store) -> None:
    save(store)
    with pytest.raises(WrongState, match="already exists"):
        save(store)
    save(store, 1)
    with pytest.raises(StaleVersion, match="version 2") as stale:
        save(store, 1)
    assert 'If-Match: "2"' in stale.value.hint
    assert save(store, 0, replace_any=True) == 3
    with pytest.raises(NotFound):
        save(store, 1, name="other")
    assert save(store, 0, name="other", replace_any=True) == 1


def test_a_deleted_entry_keeps_its_versions_and_their_numbers(store: Store) -> None:
    save(store)
    save(store, 1, 1700)
    with pytest.raises(StaleVersion):
        store.library.delete(Shelf.MACHINES, "table", 1)
    store.library.delete(Shelf.MACHINES, "table", 2)
    assert store.library.versions(Shelf.MACHINES, "table") == []
    with pytest.raises(LibraryError, match="does not exist"):
        store.library.machine("table")
    assert store.library.machine("table", 2).width == 1700.0
    with pytest.raises(NotFound):
        store.library.delete(Shelf.MACHINES, "table")
    assert save(store) == 3


def test_an_entry_of_the_library_has_only_version_0(store: Store) -> None:
    assert store.library.machine("demo-table").version == 0
    assert store.library.machine("demo-table", 0) == load.machine("demo-table")
    with pytest.raises(LibraryError, match="no version 1"):
        store.library.machine("demo-table", 1)
    save(store)
    with pytest.raises(LibraryError, match="no version 7; its newest version is 1"):
        store.library.machine("table", 7)


def test_an_entry_is_not_deleted_while_a_job_uses_it(shop: Store) -> None:
    job = ready(shop)
    for shelf, name in ((Shelf.MACHINES, "table"), (Shelf.BOARDS, "own")):
        with pytest.raises(WrongState, match=job.id):
            shop.library.delete(shelf, name)
    shop.operators.cancel(job.id)
    shop.library.delete(Shelf.MACHINES, "table")
    shop.library.delete(Shelf.BOARDS, "own")


def test_a_job_keeps_the_version_for_which_it_was_compiled(shop: Store) -> None:
    job = ready(shop)
    assert shop.library.changes([job]) == {}
    save(shop, 1, 1700)
    save_board(shop, 1)
    kept = shop.jobs.get(job.id)
    assert (kept.machine_version, kept.board_version) == (1, 1)
    assert shop.library.machine(kept.machine, kept.machine_version).width == 1600.0
    machine, board = shop.library.changes([kept])[job.id]
    assert (machine.arguments["version"], machine.arguments["newest"]) == (1, 2)
    assert board.arguments["name"] == "own"


def test_an_outdated_job_is_neither_released_nor_claimed(shop: Store) -> None:
    waiting, job = ready(shop), ready(shop)
    shop.programs.release(job.id)
    save(shop, 1, 1700)
    with pytest.raises(WrongState, match="out of date") as refused:
        shop.programs.release(waiting.id)
    assert "Compile the job again" in refused.value.hint
    assert shop.gateways.claim("table", "gateway", manual=False) is None
    fresh = ready(shop)
    shop.programs.release(fresh.id)
    claimed = shop.gateways.claim("table", "gateway", manual=False)
    assert claimed is not None
    assert claimed.id == fresh.id


def test_an_outdated_job_is_not_confirmed(shop: Store) -> None:
    job = ready(shop)
    shop.programs.release(job.id)
    claimed = shop.gateways.claim("table", "gateway", manual=True)
    assert claimed is not None
    save_board(shop, 1)
    with pytest.raises(WrongState, match="board own, whose newest version is 2") as refused:
        confirm(shop, job.id)
    assert "Compile the job again" in refused.value.hint
    heartbeat = shop.gateways.heartbeat(job.id, claimed.epoch, job_states.WAITING)
    assert heartbeat == "wait"


def test_a_recompiled_job_gets_the_newest_versions_and_returns_to_the_queue(shop: Store) -> None:
    job = ready(shop)
    shop.programs.release(job.id)
    claimed = shop.gateways.claim("table", "gateway", manual=True)
    assert claimed is not None
    save(shop, 1, 1700)
    again = shop.programs.recompile(job.id)
    assert (again.state, again.machine_version, again.program_sha256) == ("received", 2, "")
    with pytest.raises(StaleEpoch):
        shop.gateways.heartbeat(job.id, claimed.epoch, job_states.WAITING)
    taken = shop.compiles.begin("worker")
    assert taken is not None
    assert (taken.id, taken.machine_version) == (job.id, 2)
    result = CompileResult(True, None, b"M30\n", "cd", 1, b"", b"", {"seconds": 1.0})
    shop.compiles.save_result(taken.id, taken.epoch, result)
    assert shop.jobs.get(job.id).state == "queued"
    assert shop.gateways.claim("table", "gateway", manual=True) is not None
    confirm(shop, job.id)


def test_a_job_for_a_deleted_machine_is_outdated(shop: Store) -> None:
    job = job_states.compiling(shop, board="own", machine_version=1, board_version=1)
    shop.compiles.save_result(job.id, job.epoch, job_states.REFUSED)
    shop.library.delete(Shelf.MACHINES, "table")
    (change,) = shop.library.changes([shop.jobs.get(job.id)])[job.id]
    assert change.code == "library.deleted-since"
