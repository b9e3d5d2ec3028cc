"""knifetip profile: classification profiles of the library, of files and of a server's database.

list     names and titles        show     the rules of a profile
export   a profile as TOML       import   a TOML file into the database
"""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

import typer

from knifetip.cli.drawing import Json
from knifetip.cli.rules import (
    DATABASE_FILE,
    DATABASE_VARIABLE,
    database_of,
    find_profile,
    profile_toml,
    stored_profiles,
)
from knifetip.cli.terminal import in_words, print_json, print_line, read_bytes, write_bytes
from knifetip.errors import LibraryError, ProfileError
from knifetip.library import custom_profiles, load
from knifetip.messages import Message, from_json, with_text
from knifetip.model.profile import LineRules

Name = Annotated[str, typer.Argument(metavar="NAME", help="Name of a profile, or its TOML file.")]
Database = Annotated[
    str | None,
    typer.Option(
        help=f"SQLAlchemy URL of the database of a server. Default: ${DATABASE_VARIABLE}, then "
        f"./{DATABASE_FILE} if it exists."
    ),
]


def profile_json(name: str, rules: LineRules) -> dict[str, Any]:
    """Return the name, the title and the rules of a profile as JSON data."""
    listed = [
        {"type": rule.line_type.word, "conditions": with_text(rule.conditions)}
        for rule in rules.rules
    ]
    return {"name": name, "title": rules.title, "rules": listed}


def register(app: typer.Typer) -> None:
    """Add the command ``profile`` with its subcommands to a Typer application."""
    profile = typer.Typer(
        help="List, show, export and import classification profiles (rules for line types).",
        no_args_is_help=True,
    )
    app.add_typer(profile, name="profile")
    profile.command("list")(list_profiles)
    profile.command("show")(show_profile)
    profile.command("export")(export_profile)
    profile.command("import")(import_profile)


def list_profiles(database: Database = None, json: Json = False) -> None:
    """List the profiles of the library and of a server's database."""
    stored = stored_profiles(database)
    rows = [
        (name, custom_profiles.parse_text(name, text).title, "kept")
        for name, text in stored.items()
    ]
    rows += [
        (name, load.profile(name).title, "shipped")
        for name in load.names("profiles")
        if name not in stored
    ]
    if json:
        print_json([{"name": name, "title": title, "where": where} for name, title, where in rows])
        return
    for name, title, where in rows:
        print_line(f"{name:28} {where:8} {title}")


def show_profile(name: Name, database: Database = None, json: Json = False) -> None:
    """Show the rules of a profile.

    The first rule that matches an edge decides its line type.
    """
    rules = find_profile(name, database)
    about = profile_json(name, rules)
    if json:
        print_json(about)
        return
    print_line(rules.title)
    for number, rule in enumerate(about["rules"], 1):
        conditions = in_words(from_json(rule["conditions"]))
        print_line(f"{number:4} {rule['type']:12} {conditions}")


def export_profile(
    name: Name,
    output: Annotated[
        Path | None,
        typer.Option(
            "-o", "--output", help="File to write the profile to. Default: standard output."
        ),
    ] = None,
    database: Database = None,
) -> None:
    """Write a profile as a TOML file.

    The file can be edited and used with --profile FILE.toml.
    """
    text = profile_toml(name, database)
    if output is None:
        typer.echo(text, nl=False)
    else:
        write_bytes(output, text.encode())


def import_profile(
    file: Annotated[Path, typer.Argument(metavar="FILE", help="TOML file of the profile.")],
    name: Annotated[
        str | None,
        typer.Option(help="Name under which the profile is stored. Default: the name of the file."),
    ] = None,
    database: Database = None,
    replace: Annotated[
        bool, typer.Option(help="Replace an existing profile with this name.")
    ] = False,
) -> None:
    """Check a profile file and store it in a database.

    Without a database the file is only checked.
    """
    profile_name = custom_profiles.check_name(name or file.stem.lower())
    try:
        text = read_bytes(file).decode("utf-8-sig")
    except UnicodeDecodeError as reason:
        raise ProfileError("profile.not-utf8", name=file) from reason
    rules = custom_profiles.parse_text(profile_name, text)
    count = len(rules.rules)
    checked = Message("output.profile", name=profile_name, title=rules.title, count=count)
    print_line(in_words(checked))
    url = database_of(database)
    if url is None:
        print_line(in_words(Message("output.profile-not-stored")))
        return
    if profile_name in load.names("profiles"):
        raise LibraryError("library.shipped", shelf="profile", name=profile_name)
    from knifetip.service.store import Store

    store = Store(url)
    try:
        store.prepare()
        row = store.profiles.save(profile_name, rules.title, text, None, replace_any=replace)
    finally:
        store.close()
    print_line(in_words(Message("output.profile-stored", version=row.version)))
