"""Fixtures: one server for all tests, a clock that a test sets, and a store in two databases."""

from __future__ import annotations

from collections.abc import Iterator

import httpx
import pytest

from knifetip.service.settings import Settings
from knifetip.service.store import Store
from tests.support.serving.server import run_server
from tests.support.stored import Clock, migrated_store


@pytest.fixture(scope="session")
def client(tmp_path_factory: pytest.TempPathFactory) -> Iterator[httpx.Client]:
    folder = tmp_path_factory.mktemp("server")
    page = folder / "page"
    (page / "assets").mkdir(parents=True)
    (page / "index.html").write_text("<!doctype html><title>the built page</title>")
    (page / "docs.html").write_text("<!doctype html><title>the description</title>")
    (page / "assets" / "main-4f2a.js").write_text("export const knife = 1\n")
    (folder / "secret.txt").write_text("not for you")
    settings = Settings(database=f"sqlite:///{folder}/shop.sqlite", name="test", page=page)
    with run_server(settings) as client:
        yield client


@pytest.fixture
def clock() -> Clock:
    return Clock()


@pytest.fixture
def store(migrated_url: str, clock: Clock) -> Iterator[Store]:
    """Return a store in SQLite, then one in PostgreSQL."""
    with migrated_store(migrated_url, clock) as store:
        yield store
