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
        yield problem("database", reason.text, reason.hint)
        return
    if file is not None and not file.is_file():
        yield warning(
            "database", f"there is no file {file} yet", "knifetip serve creates it, or --database."
        )
        return
    try:
        with closing(Store(options.url, objects=options.store)) as store:
            found = store.database.schema()
            yield _schema(found, options.shown, is_file=file is not None)
            if fault := store.database.damage():
                yield _damaged(options, fault)
                return
            if not found.is_current:
                return
            yield _write(store)
            yield _clock(store, now(), is_file=file is not None)
            yield _contents(store, options.store)
            yield _accounts(store, options)
            yield from _unbound_keys(store, now())
            yield from _gateways(store)
    except StoreError as reason:
        yield problem("database", reason.text, reason.hint)
    except sqlalchemy.exc.SQLAlchemyError as reason:
        if is_damaged(reason):
            yield _damaged(options, str(reason).splitlines()[0])
            return
        text = f"{options.shown} does not answer: {str(reason).splitlines()[0]}"
        advice = "Start the database server; check the URL, the password and the network."
        yield problem("database", text, advice)


def _damaged(options: ServerOptions, fault: str) -> CheckResult:
    reason = StoreError("database.damaged", file=options.shown, reason=fault)
    return problem("database", reason.text, reason.hint)


def _schema(found: Schema, shown: str, *, is_file: bool) -> CheckResult:
    from knifetip.service.database.schema import unknown_revision

    text = f"{shown}, revision {found.revision or 'none'}"
    if found.is_current:
        return ok("database", text)
    if (unknown := unknown_revision(found, shown)) is not None:
        return problem("database", unknown.text, unknown.hint)
    text = f"{text}, {found.newest} is needed"
    if is_file or found.is_empty:
        return warning("database", text, "knifetip serve migrates it; back it up before.")
    return problem("database", text, "Stop the servers, back it up, and run: knifetip db upgrade")


def _write(store: Store) -> CheckResult:
    import sqlalchemy.exc

    from knifetip.service.database.damage import is_disk_full
    from knifetip.service.database.write_probe import write_probe

    try:
        write_probe(store.database)
    except sqlalchemy.exc.SQLAlchemyError as reason:
        if is_disk_full(reason):
            return problem("writing", "the disk of the database is full", "Make room on it.")
        text = f"the database cannot be written: {str(reason).splitlines()[0]}"
        return problem("writing", text, "Check the rights of the file, or whether it is a copy.")
    return ok("writing", "the database stores changes")


def _clock(store: Store, now: float, *, is_file: bool) -> CheckResult:
    if is_file:
        return ok("clock", "the database has the clock of this computer")
    difference = abs(store.database.server_time() - now)
    text = f"{difference:.1f} s between this computer and the database"
    if difference < _CLOCKS[0]:
        return ok("clock", text)
    advice = "Synchronise both with NTP."
    grade = problem if difference >= _CLOCKS[1] else warning
    return grade("clock", text, advice)


def _contents(store: Store, url: str) -> CheckResult:
    outside = store.contents.has_outside()
    if not url:
        if outside:
            text = "large values are in a folder or bucket, but none is given"
            return problem("store", text, "Give --store as for the server.")
        return ok("store", "large values are in the database")
    try:
        store.contents.probe()
    except StoreError as reason:
        return problem("store", reason.text, reason.hint)
    return ok("store", f"{url} can be written and read")


def _accounts(store: Store, options: ServerOptions) -> CheckResult:
    from knifetip.service.accounts.access_rules import is_loopback

    create = "Create an administrator: knifetip user add NAME --role admin"
    if store.users.has_admin():
        return ok("accounts", "there is an administrator")
    if is_loopback(options.host):
        text = "there is no administrator: every program on this computer may do everything"
        return warning("accounts", text, create)
    if options.has_key:
        text = "there is no administrator; one key gives access to everything"
        return warning("accounts", text, create)
    text = f"there is neither administrator nor key: a server does not listen on {options.host}"
    return problem("accounts", text, create)


def _unbound_keys(store: Store, now: float) -> Iterator[CheckResult]:
    for row in store.keys.all():
        is_valid = row.revoked is None and (row.expires is None or row.expires > now)
        if is_valid and row.any_machine and "gateway" in row.scopes:
            create = "knifetip key create TITLE --scope gateway --machine MACHINE"
            yield warning(
                "keys",
                f"the key {row.title} of a gateway is for any machine",
                f"Create one for each machine: {create}; then knifetip key revoke {row.id}.",
            )


def _gateways(store: Store) -> Iterator[CheckResult]:
    connected = store.machines.connected_machines(_SILENT)
    waiting = store.machines.machines_with_queue()
    for machine in sorted(connected):
        yield ok("gateways", f"{machine} is connected")
    for machine in sorted(waiting - connected):
        yield warning(
            "gateways",
            f"jobs wait for {machine}, whose gateway is not connected",
            f"Start it beside the machine: knifetip gateway --machine {machine} --server URL",
        )
    if not connected | waiting:
        yield ok("gateways", "none is connected and no job waits")
