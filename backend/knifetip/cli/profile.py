"""knifetip profile: the rules that tell cuts from creases, shipped, from files or kept by a server.

list   what there is          show    the rules of one in words
export one as TOML            import  a TOML file into a server's database
"""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

import typer

from knifetip.cli.drawing import Json
from knifetip.cli.rules import BESIDE, VARIABLE, database_of, kept, named, text_of
from knifetip.cli.terminal import read_bytes, show, write_bytes
from knifetip.errors import LibraryError, ProfileError
from knifetip.library import load, own
from knifetip.model.profile import LineRules

Name = Annotated[str, typer.Argument(metavar="NAME", help="A profile, or a TOML file of one.")]
Database = Annotated[
    str | None,
    typer.Option(help=f"SQLAlchemy URL; else ${VARIABLE}, else ./{BESIDE} where there is one."),
]


def described(name: str, rules: LineRules) -> dict[str, Any]:
    """Return a profile as plain data."""
    listed = [{"type": rule.line_type.word, "words": rule.words} for rule in rules.rules]
    return {"name": name, "title": rules.title, "rules": listed}


def register(app: typer.Typer) -> None:
    """Add the commands of this module."""
    profile = typer.Typer(
        help="Classification profiles: list, show, export, import.", no_args_is_help=True
    )
    app.add_typer(profile, name="profile")

    @profile.command("list")
    def list_profiles(database: Database = None, json: Json = False) -> None:
        """List the profiles that are shipped, and those that a server keeps."""
        theirs = kept(database)
        rows = [(name, own.parsed(name, text).title, "kept") for name, text in theirs.items()]
        rows += [
            (name, load.profile(name).title, "shipped")
            for name in load.names("profiles")
            if name not in theirs
        ]
        if json:
            show([{"name": name, "title": title, "where": where} for name, title, where in rows])
            return
        for name, title, where in rows:
            typer.echo(f"{name:28} {where:8} {title}")

    @profile.command("show")
    def show_profile(name: Name, database: Database = None, json: Json = False) -> None:
        """Show the rules of a profile in words; the first that an edge meets decides."""
        rules = named(name, database)
        about = described(name, rules)
        if json:
            show(about)
            return
        typer.echo(rules.title)
        for number, rule in enumerate(about["rules"], 1):
            typer.echo(f"{number:4} {rule['type']:12} {rule['words']}")

    @profile.command("export")
    def export(
        name: Name,
        output: Annotated[
            Path | None, typer.Option("-o", "--output", help="Where it goes; else stdout.")
        ] = None,
        database: Database = None,
    ) -> None:
        """Write a profile as TOML, to be edited and used with --profile FILE.toml."""
        text = text_of(name, database)
        if output is None:
            typer.echo(text, nl=False)
        else:
            write_bytes(output, text.encode())

    @profile.command("import")
    def import_profile(
        file: Annotated[Path, typer.Argument(metavar="FILE", help="A TOML file.")],
        name: Annotated[str | None, typer.Option(help="Else that of the file.")] = None,
        database: Database = None,
        replace: Annotated[bool, typer.Option(help="If there is one of that name.")] = False,
    ) -> None:
        """Check a profile and keep it in a server's database; without one, only check it."""
        called = own.checked_name(name or file.stem.lower())
        try:
            text = read_bytes(file).decode("utf-8-sig")
        except UnicodeDecodeError as reason:
            raise ProfileError("profile.not-utf8", name=file) from reason
        rules = own.parsed(called, text)
        typer.echo(f"{called}: {rules.title}, {len(rules.rules)} rules")
        url = database_of(database)
        if url is None:
            typer.echo("No database: nothing was kept. Name one with --database.")
            return
        if called in load.names("profiles"):
            raise LibraryError("profile.shipped-command", name=called)
        from knifetip.jobs.store import Store

        store = Store(url)
        try:
            store.migrate()
            row = store.profiles.save(called, rules.title, text, None, anyway=replace)
        finally:
            store.close()
        typer.echo(f"kept as version {row.version}")
