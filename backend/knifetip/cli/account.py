"""knifetip user and key: users and API keys in the database of a server.

The commands work on the database itself, so that the first administrator can be created.  Passwords
are read from the terminal or from stdin, never from the command line, which other users of the
computer can see.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from knifetip.cli.drawing import Json
from knifetip.cli.options import expand
from knifetip.cli.terminal import in_words, print_json, print_line, print_message
from knifetip.messages import Message
from knifetip.service.http.scopes import AccessScope
from knifetip.service.settings import DatabaseSettings

if TYPE_CHECKING:
    from knifetip.service.store import Store

UserName = Annotated[str, typer.Argument(metavar="NAME", help="Name of the user.")]
Role = Annotated[
    AccessScope,
    typer.Option("--role", help="What the user may do: viewer, designer, operator or admin."),
]
_DAY = 86_400.0


@contextmanager
def _opened_store(database: str) -> Iterator[Store]:
    from knifetip.service.store import Store  # imported here: slow, and the help does not need it

    store = Store(database)
    try:
        store.prepare()
        yield store
    finally:
        store.close()


@contextmanager
def _open_for_change(database: str, action: str) -> Iterator[Store]:
    """Open a database for a change that gets an entry in the audit log, as a request does.

    ``action``: operation of the REST interface that makes the same change.
    """
    from knifetip.service.database.acting import ActingPrincipal, acting_as  # imports the database

    with (
        _opened_store(database) as store,
        acting_as(ActingPrincipal(kind="command", name="command line", id="", action=action)),
    ):
        yield store


def _password() -> str:
    """Return a new password: typed twice at a terminal, or the first line of stdin."""
    if sys.stdin.isatty():
        typed: str = typer.prompt(
            in_words(Message("output.password")),
            hide_input=True,
            confirmation_prompt=True,
            err=True,
        )
        return typed
    return sys.stdin.readline().rstrip("\r\n")


def add_user(name: UserName, role: Role = AccessScope.VIEWER, *, chosen: DatabaseSettings) -> None:
    """Add a user; the password is read from a prompt or from stdin."""
    password = _password()
    with _open_for_change(chosen.url, "create_user") as store:
        row = store.users.add(name, password, role, "command line")
    typer.echo(f"{row.name}: {row.role}")


def list_users(as_json: Json = False, *, chosen: DatabaseSettings) -> None:
    """List the users with their roles."""
    with _opened_store(chosen.url) as store:
        rows = store.users.all()
    if as_json:
        names = ("name", "role", "active", "created", "created_by", "signed_in")
        print_json([{name: getattr(row, name) for name in names} for row in rows])
        return
    for row in rows:
        listed = Message(
            "output.user-row",
            name=f"{row.name:20}",
            role=f"{row.role:9}",
            date=_date(row.signed_in),
            state=None if row.active else Message("output.disabled"),
        )
        print_line(in_words(listed))


def set_password(name: UserName, *, chosen: DatabaseSettings) -> None:
    """Set a new password, read from a prompt or from stdin; the user's sessions end."""
    password = _password()
    with _open_for_change(chosen.url, "change_user") as store:
        store.users.change(name, password=password)


def set_role(
    name: UserName,
    role: Annotated[AccessScope, typer.Argument(help="viewer, designer, operator or admin.")],
    *,
    chosen: DatabaseSettings,
) -> None:
    """Set the role of a user; the user's sessions end."""
    with _open_for_change(chosen.url, "change_user") as store:
        store.users.change(name, role=role)


def disable_user(name: UserName, *, chosen: DatabaseSettings) -> None:
    """Disable a user; the user's sessions end."""
    with _open_for_change(chosen.url, "change_user") as store:
        store.users.change(name, active=False)


def enable_user(name: UserName, *, chosen: DatabaseSettings) -> None:
    """Enable a disabled user."""
    with _open_for_change(chosen.url, "change_user") as store:
        store.users.change(name, active=True)


def create_key(
    title: Annotated[str, typer.Argument(metavar="TITLE", help="What uses the key.")],
    scope: Annotated[
        list[AccessScope],
        typer.Option(
            help="read, order, webhooks, station or gateway, or a role of users: viewer, designer, "
            "operator, admin; may be repeated. No role lets a key start or move a machine."
        ),
    ],
    customer: Annotated[
        str, typer.Option(help="Only customer whose jobs the key sees and orders. Default: all.")
    ] = "",
    machine: Annotated[
        list[str] | None,
        typer.Option(
            help="Only machine of the key; may be repeated. Default: all; for a gateway the first "
            "one for which it is used."
        ),
    ] = None,
    days: Annotated[
        float | None, typer.Option(min=0.001, help="Days until the key expires. Default: never.")
    ] = None,
    file: Annotated[
        Path | None,
        typer.Option(
            help="File for the secret, which its owner only can read. If it already contains a "
            "valid key with these scopes, no key is created."
        ),
    ] = None,
    *,
    chosen: DatabaseSettings,
) -> None:
    """Create an API key and print its secret, or write it to a file; it cannot be read again."""
    from knifetip.library.definition import Shelf
    from knifetip.service.database.key_limits import KeyLimits  # imports the database

    expires = None if days is None else time.time() + days * _DAY
    with _open_for_change(chosen.url, "create_key") as store, ExitStack() as stack:
        for name in machine or ():
            store.library.definition(Shelf.MACHINES, name)
        limits = KeyLimits(customer, frozenset(machine or ()))
        new_file = None
        if file is not None:
            from knifetip.cli.key_file import NewKeyFile, key_in

            kept = key_in(file, store.keys, scope, limits)
            if kept is not None:
                valid = Message("output.key-valid", file=file, id=kept.id, title=kept.title)
                print_message(valid)
                return
            new_file = NewKeyFile(file)
            stack.callback(new_file.remove)
        row, secret = store.keys.add(title, scope, expires, "command line", limits)
        if new_file is not None:
            new_file.write(secret)
    print_message(Message("output.key", id=row.id, title=row.title, scopes=row.scopes))
    if file is None:
        typer.echo(secret)


def list_keys(as_json: Json = False, *, chosen: DatabaseSettings) -> None:
    """List the API keys with their scopes and last use, without their secrets."""
    with _opened_store(chosen.url) as store:
        rows = store.keys.all()
    if as_json:
        names = (
            *("id", "title", "scopes", "customer", "machines", "any_machine"),
            *("created", "created_by", "expires", "used", "revoked"),
        )
        print_json([{name: getattr(row, name) for name in names} for row in rows])
        return
    for row in rows:
        notes = [Message("output.used", date=_date(row.used))]
        if row.revoked:
            notes.append(Message("output.revoked", date=_date(row.revoked)))
        if row.expires:
            notes.append(Message("output.expires", date=_date(row.expires)))
        if row.customer:
            notes.append(Message("output.customer", customer=row.customer))
        if row.machines:
            notes.append(Message("output.machines", names=row.machines))
        listed = {"id": row.id, "title": f"{row.title:24}", "scopes": ",".join(row.scopes)}
        print_line(in_words(Message("output.key-row", **listed, notes=notes)))


def rotate_key(
    id: Annotated[str, typer.Argument(metavar="ID", help="Id of the key.")],
    file: Annotated[
        Path | None, typer.Option(help="File for the secret, which its owner only can read.")
    ] = None,
    *,
    chosen: DatabaseSettings,
) -> None:
    """Give an API key a new secret, and print it or write it to a file; it keeps its jobs."""
    with _open_for_change(chosen.url, "rotate_key_secret") as store, ExitStack() as stack:
        new_file = None
        if file is not None:
            from knifetip.cli.key_file import NewKeyFile  # imports the database

            new_file = NewKeyFile(file)
            stack.callback(new_file.remove)
        _, secret = store.keys.rotate(id)
        if new_file is not None:
            new_file.write(secret)
    if file is None:
        typer.echo(secret)


def revoke_key(
    id: Annotated[str, typer.Argument(metavar="ID", help="Id of the key.")],
    *,
    chosen: DatabaseSettings,
) -> None:
    """Revoke an API key."""
    with _open_for_change(chosen.url, "revoke_key") as store:
        store.keys.revoke(id)


def _date(seconds: float | None) -> str:
    if seconds is None:
        return "never"
    return datetime.fromtimestamp(seconds).astimezone().strftime("%Y-%m-%d %H:%M")


def register(app: typer.Typer) -> None:
    """Add the commands ``user`` and ``key`` with their subcommands to a Typer application."""
    user = typer.Typer(
        help="Add, list and change the users of a server's database.", no_args_is_help=True
    )
    key = typer.Typer(
        help="Create, list and revoke the API keys of a server's database.", no_args_is_help=True
    )
    app.add_typer(user, name="user")
    app.add_typer(key, name="key")
    user.command("add")(expand(add_user))
    user.command("list")(expand(list_users))
    user.command("password")(expand(set_password))
    user.command("role")(expand(set_role))
    user.command("disable")(expand(disable_user))
    user.command("enable")(expand(enable_user))
    key.command("create")(expand(create_key))
    key.command("list")(expand(list_keys))
    key.command("rotate")(expand(rotate_key))
    key.command("revoke")(expand(revoke_key))
