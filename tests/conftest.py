"""Fixtures for all tests: the folder of drawings by other authors, and the command line."""

from __future__ import annotations

import gc
import os
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from hypothesis import settings

from knifetip.cli import main
from tests.support.certificates import share_certificates
from tests.support.command import Command
from tests.support.databases import leave_half_to_long_runs
from tests.support.examples import LEAST, QUICK
from tests.support.revisions import write_later_steps
from tests.support.routes import share_prepared_routes
from tests.support.scheduling import ModuleScheduling
from tests.support.serving.postgresql import (
    ReusedDatabase,
    create_database,
    installed_binaries,
    run_server,
    temporary_database,
)
from tests.support.statements import share_compiled_statements
from tests.support.stored import migrated_store, write_tables

# Tests do not fail because a machine is busy (`make bench` measures time) or by chance:
# every run uses the same examples; `--hypothesis-profile=explore` draws new ones. `make test`
# draws a share of them.
settings.register_profile("knifetip", deadline=None, derandomize=True)
settings.register_profile("explore", deadline=None)
settings.register_profile(QUICK, deadline=None, derandomize=True, max_examples=LEAST)
settings.load_profile("knifetip")

ROOT = Path(__file__).resolve().parents[1]
CORPUS = Path(os.environ.get("KNIFETIP_CORPUS", ROOT.parent / "shared" / "corpus"))


def pytest_configure(config: pytest.Config) -> None:
    """Let tests use the statements, routes and certificates that others have prepared."""
    patch = pytest.MonkeyPatch()
    config.add_cleanup(patch.undo)
    share_compiled_statements(patch)
    share_prepared_routes(patch)
    share_certificates(patch)


# What is imported and collected lives until the end.
gc.disable()


def pytest_collection_finish() -> None:
    """Let the garbage collector look at what the tests make only."""
    gc.freeze()
    gc.enable()


@pytest.hookimpl(tryfirst=True)  # before marked tests are deselected
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Let `make test` run each case of a test in one of the two databases, in turn."""
    leave_half_to_long_runs(items)


def pytest_xdist_make_scheduler(config: pytest.Config, log: Any) -> ModuleScheduling | None:
    """Let pytest-xdist keep the tests of a module together, if it keeps those of groups."""
    return ModuleScheduling(config, log) if config.getoption("dist") == "loadgroup" else None


@pytest.fixture(scope="session", autouse=True)
def _english() -> None:
    """Let commands, also those in other processes, print English on every computer."""
    os.environ["LC_ALL"] = "C.UTF-8"


@pytest.fixture(scope="session", autouse=True)
def _state_folder(tmp_path_factory: pytest.TempPathFactory) -> None:
    """Let gateways, also those in other processes, keep their journals in a temporary folder."""
    os.environ["XDG_STATE_HOME"] = str(tmp_path_factory.mktemp("state"))


@pytest.fixture(scope="session")
def corpus() -> Path:
    """Return the folder of drawings by other authors; skip the test if it does not exist."""
    if not CORPUS.is_dir():
        pytest.skip(f"the drawings of other authors are not at {CORPUS} (set KNIFETIP_CORPUS)")
    return CORPUS


@pytest.fixture(scope="session")
def postgresql_server() -> Iterator[str]:
    """URL of a database on a PostgreSQL server of this test run; skips if none is installed."""
    binaries = installed_binaries()
    if binaries is None:
        pytest.skip("PostgreSQL is not installed (apt-get install postgresql)")
    with run_server(binaries) as url:
        yield url


@pytest.fixture
def postgresql_url(postgresql_server: str) -> Iterator[str]:
    """URL of a new, empty PostgreSQL database."""
    with temporary_database(postgresql_server) as url:
        yield url


@pytest.fixture(params=["sqlite", "postgresql"])
def database_url(request: pytest.FixtureRequest, tmp_path: Path) -> str:
    """URL of a new, empty database: one in SQLite, then one in PostgreSQL."""
    if request.param == "sqlite":
        return f"sqlite:///{tmp_path}/shop.sqlite"
    url: str = request.getfixturevalue("postgresql_url")
    return url


class _Tables:
    """A PostgreSQL database with all tables, and the number of those that were made."""

    def __init__(self, server: str) -> None:
        self._server = server
        self._made = 0
        self._database: ReusedDatabase | None = None

    def url(self) -> str:
        """Return the URL of the database with its first rows, or of a new one."""
        if self._database is None or not self._database.reset():
            self._made += 1
            url = create_database(self._server, f"tables{self._made}")
            with migrated_store(url):
                pass
            self._database = ReusedDatabase(url)
        return self._database.url


@pytest.fixture(scope="session")
def postgresql_tables(postgresql_server: str) -> _Tables:
    """Return a PostgreSQL database with all tables, which tests use one after the other."""
    return _Tables(postgresql_server)


@pytest.fixture
def migrated_sqlite(tmp_path: Path) -> str:
    """URL of a new SQLite database with all tables."""
    file = tmp_path / "shop.sqlite"
    write_tables(file)
    return f"sqlite:///{file}"


@pytest.fixture
def migrated_postgresql(postgresql_tables: _Tables) -> str:
    """URL of a PostgreSQL database with all tables and no rows of other tests."""
    return postgresql_tables.url()


@pytest.fixture(params=["sqlite", "postgresql"])
def migrated_url(request: pytest.FixtureRequest) -> str:
    """URL of a new database with all tables: one in SQLite, then one in PostgreSQL."""
    url: str = request.getfixturevalue(f"migrated_{request.param}")
    return url


@pytest.fixture
def later_version(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[[], None]:
    """Return a function after which a later version of knifetip, with a step more, runs."""
    steps = tmp_path / "migrations"
    write_later_steps(steps)
    return lambda: monkeypatch.setattr("knifetip.service.database.schema._MIGRATIONS", steps)


@pytest.fixture
def knifetip(monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]) -> Command:
    """Return a function that runs ``knifetip`` and returns exit code, stdout and stderr."""

    def run(*words: object) -> tuple[int, str, str]:
        monkeypatch.setattr(sys, "argv", ["knifetip", *map(str, words)])
        with pytest.raises(SystemExit) as left:
            main()
        out, err = capfd.readouterr()
        assert isinstance(left.value.code, int)
        return left.value.code, out, err

    return run
