"""The accounts of a server: what a request has read before a change is not kept after it."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import asynccontextmanager
from typing import Any

import pytest

from knifetip.service.accounts.access_rules import RequestFacts
from knifetip.service.accounts.account_access import Accounts
from knifetip.service.http.scopes import AccessScope
from knifetip.service.store import Store
from tests.support.stored import migrated_store


@pytest.fixture
def store(migrated_sqlite: str) -> Iterator[Store]:
    with migrated_store(migrated_sqlite) as store:
        yield store


def facts(session: str | None = None) -> RequestFacts:
    return RequestFacts(
        "GET", "/", "http", "localhost", "127.0.0.1", ("127.0.0.1", 80), user_session=session
    )


@asynccontextmanager
async def held(accounts: Accounts) -> AsyncIterator[None]:
    """Let what is read in the context wait for its end, and clear the cache there."""
    begun, goes_on = asyncio.Event(), asyncio.Event()

    async def slow(pool: ThreadPoolExecutor, call: Callable[[], Any]) -> Any:
        found = await asyncio.get_running_loop().run_in_executor(pool, call)
        begun.set()
        await goes_on.wait()
        return found

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(accounts, "_run", slow)
        yield
        await begun.wait()
    accounts.clear_cache()
    goes_on.set()


async def test_an_administrator_is_noticed_although_a_request_has_looked_before(
    store: Store,
) -> None:
    accounts = Accounts()
    accounts.store = store
    try:
        async with held(accounts):
            before = asyncio.create_task(accounts.proof(facts()))
        # The request has found none; then one was added.
        store.users.add("Ann", "four words of text", AccessScope.ADMIN)
        assert not (await before).closed
        assert (await accounts.proof(facts())).closed
    finally:
        accounts.close()


async def test_a_session_that_was_ended_meanwhile_is_not_kept(store: Store) -> None:
    accounts = Accounts()
    accounts.store = store
    try:
        store.users.add("Ann", "four words of text", AccessScope.ADMIN)
        token = await accounts.sign_in("Ann", "four words of text", "127.0.0.1")
        async with held(accounts):
            before = asyncio.create_task(accounts._find("a", lambda: accounts._user(token)))
        store.sessions.close(token)
        assert await before is not None
        assert await accounts._find("a", lambda: accounts._user(token)) is None
    finally:
        accounts.close()
