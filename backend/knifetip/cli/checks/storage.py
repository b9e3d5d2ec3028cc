"""Checks of the database: tables, writing, clock, large values, accounts, gateways."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from contextlib import closing
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Final

from knifetip.cli.checks.check_result import CheckResult, ok, problem, warning
from knifetip.errors import StoreError
from knifetip.messages import Message

if TYPE_CHECKING:
    from knifetip.service.database.schema import Schema
    from knifetip.service.store import Store

_CLOCKS: Final = (2.0, 30.0)  # differences (s) that are a warning and a problem
_SILENT: Final = 60.0  # seconds without a request after which a gateway is not connected


@dataclass(frozen=True, slots=True)
class ServerOptions:
    """The options of a server that the checks use: its database, store, address and key."""

    url: str  #: of the database
    shown: str  #: without a password
    store: str  #: the option --store
    host: str  #: the option --host of the server
    has_key: bool  #: whether the server has an access key


def data_folder(options: ServerOptions) -> Path | None:
    """Return the folder of an SQLite database that exists; None for another."""
    from knifetip.service.database.url import sqlite_file

    try:
        file = sqlite_file(options.url)
    except StoreError:
        return None  # see ``check_database``
    if file is None or not file.absolute().parent.is_dir():
        return None
    return file.absolute().parent


def check_database(
    options: ServerOptions, now: Callable[[], float] = time.time
) -> Iterator[CheckResult]:
    """Check the database, and what is stored in it."""
    import sqlalchemy.exc

    from knifetip.service.database.damage import is_damaged
    from knifetip.service.database.url import sqlite_file
    from knifetip.service.store import Store

    try:
        file = sqlite_file(options.url)
    except StoreError as reason:
        yield problem("database", reason.message)
        return
    if file is not None and not file.is_file():
        yield warning("database", Message("doctor.database-missing", file=str(file)))
        return
    try:
        with closing(Store(options.url, objects=options.store)) as store:
            found = store.database.schema()
            yield _check_schema(found, options.shown, is_file=file is not None)
            if fault := store.database.damage():
                yield _damaged_database(options, fault)
                return
            if not found.is_current:
                return
            yield _check_writing(store)
            yield _check_clock(store, now(), is_file=file is not None)
            yield _check_contents(store, options.store)
            yield _check_accounts(store, options)
            yield from _check_gateway_keys(store, now())
            yield from _check_gateways(store)
    except StoreError as reason:
        yield problem("database", reason.message)
    except sqlalchemy.exc.SQLAlchemyError as reason:
        if is_damaged(reason):
            yield _damaged_database(options, str(reason).splitlines()[0])
            return
        cause = str(reason).splitlines()[0]
        message = Message("doctor.database-silent", url=options.shown, reason=cause)
        yield problem("database", message)


def _damaged_database(options: ServerOptions, fault: str) -> CheckResult:
    reason = StoreError("database.damaged", file=options.shown, reason=fault)
    return problem("database", reason.message)


def _check_schema(found: Schema, shown: str, *, is_file: bool) -> CheckResult:
    from knifetip.service.database.schema import unknown_revision

    revision = found.revision or "–"
    if found.is_current:
        return ok("database", Message("doctor.database", url=shown, revision=revision))
    if (unknown := unknown_revision(found, shown)) is not None:
        return problem("database", unknown.message)
    if is_file or found.is_empty:
        return warning(
            "database",
            Message("doctor.database-old", url=shown, revision=revision, newest=found.newest),
        )
    return problem(
        "database",
        Message("doctor.database-old-shared", url=shown, revision=revision, newest=found.newest),
    )


def _check_writing(store: Store) -> CheckResult:
    import sqlalchemy.exc

    from knifetip.service.database.damage import is_disk_full
    from knifetip.service.database.write_probe import write_probe

    try:
        write_probe(store.database)
    except sqlalchemy.exc.SQLAlchemyError as reason:
        if is_disk_full(reason):
            return problem("writing", Message("doctor.writing-disk-full"))
        cause = str(reason).splitlines()[0]
        return problem("writing", Message("doctor.writing-refused", reason=cause))
    return ok("writing", Message("doctor.writing"))


def _check_clock(store: Store, now: float, *, is_file: bool) -> CheckResult:
    if is_file:
        return ok("clock", Message("doctor.clock-own"))
    difference = abs(store.database.server_time() - now)
    if difference < _CLOCKS[0]:
        return ok("clock", Message("doctor.clock", seconds=difference))
    grade = problem if difference >= _CLOCKS[1] else warning
    return grade("clock", Message("doctor.clock-differs", seconds=difference))


def _check_contents(store: Store, url: str) -> CheckResult:
    outside = store.contents.has_outside()
    if not url:
        if outside:
            return problem("store", Message("doctor.store-missing"))
        return ok("store", Message("doctor.store-own"))
    try:
        store.contents.probe()
    except StoreError as reason:
        return problem("store", reason.message)
    return ok("store", Message("doctor.store", url=url))


def _check_accounts(store: Store, options: ServerOptions) -> CheckResult:
    from knifetip.service.accounts.access_rules import is_loopback

    if store.users.has_admin():
        return ok("accounts", Message("doctor.accounts"))
    if is_loopback(options.host):
        return warning("accounts", Message("doctor.accounts-local"))
    if options.has_key:
        return warning("accounts", Message("doctor.accounts-key"))
    return problem("accounts", Message("doctor.accounts-closed", host=options.host))


def _check_gateway_keys(store: Store, now: float) -> Iterator[CheckResult]:
    for row in store.keys.all():
        is_valid = row.revoked is None and (row.expires is None or row.expires > now)
        if is_valid and row.any_machine and "gateway" in row.scopes:
            yield warning("keys", Message("doctor.key-unbound", title=row.title, id=row.id))


def _check_gateways(store: Store) -> Iterator[CheckResult]:
    connected = store.machines.connected_machines(_SILENT)
    waiting = store.machines.machines_with_queue()
    for machine in sorted(connected):
        yield ok("gateways", Message("doctor.gateway", machine=machine))
    for machine in sorted(waiting - connected):
        yield warning("gateways", Message("doctor.gateway-absent", machine=machine))
    if not connected | waiting:
        yield ok("gateways", Message("doctor.gateways-none"))
