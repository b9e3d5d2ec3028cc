"""database: messages about the database, its stored objects and its backups."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "store.no-column": entry(
        "The {kind} {id} has no {column} yet.",
        "Wait until the {kind} is compiled. If the compilation failed, the fields state and "
        "reason of the {kind} show why.",
        kind="text",
        id="text",
        column="text",
    ),
    "store.unknown": entry(
        "The {kind} {id} does not exist.",
        "Choose an id that GET /api/{kind}s lists.",
        kind="text",
        id="text",
    ),
    "backup.exists": entry(
        "The file {file} already exists.",
        "Choose another file, or replace it with --replace.",
        file="text",
    ),
    "backup.foreign": entry(
        "The database in the file {file} does not contain tables of knifetip.",
        "Choose a file that knifetip backup has written.",
        file="text",
    ),
    "backup.missing-row": entry(
        "The file {file} is damaged: a row of the table {table} refers to a row that is missing.",
        "Choose another backup.",
        file="text",
        table="text",
    ),
    "backup.not-a-backup": entry(
        "The file {file} is not a backup of a knifetip database: {reason}.",
        "Choose a file that knifetip backup has written.",
        file="text",
        reason="text",
    ),
    "backup.postgresql": entry(
        "The database {url} is on a PostgreSQL server, which has its own commands for backups.",
        "Back it up with: pg_dump --format=custom --file=FILE DATABASE. Restore it to an empty "
        "database with: pg_restore --exit-on-error --dbname=DATABASE FILE.",
        url="text",
    ),
    "backup.unwritable": entry(
        "The database cannot be copied to {file}: {reason}.",
        "Free space on the disk or choose another folder. The database was not changed.",
        file="text",
        reason="text",
    ),
    "database.bad-url": entry(
        "{url!r} is not the URL of a database.",
        "Write the URL as sqlite:///FILE or postgresql://USER@HOST/NAME.",
        url="text",
    ),
    "database.damaged": entry(
        "The database {file} is damaged: {reason}.",
        "Stop the server and put a backup in its place: knifetip restore FILE --replace. Keep the "
        "older backups until then. Check the disk.",
        file="text",
        reason="text",
    ),
    "database.folder-unusable": entry(
        "The folder {folder} of the database cannot be used: {reason}.",
        "Choose another folder with --database sqlite:///FILE, or permit this user to write there.",
        folder="text",
        reason="text",
    ),
    "database.in-use": entry(
        "The database {file} is in use.",
        "Stop the server and the workers that use it, then try again.",
        file="text",
    ),
    "database.missing": entry(
        "The database {file} does not exist.",
        "Set the database with --database sqlite:///FILE.",
        file="text",
    ),
    "database.newer": entry(
        "The database {url} was written by knifetip {writer} (revision {revision}). knifetip "
        "{version} supports revisions up to {newest} and would damage it.",
        "Use that version of knifetip or a newer one. To go back to version {version}, restore "
        "a backup from before the upgrade.",
        url="text",
        writer="text",
        revision="text",
        version="text",
        newest="text",
    ),
    "database.newer-unrecorded": entry(
        "The database {url} has revision {revision} of a newer or changed knifetip. knifetip "
        "{version} supports revisions up to {newest} and would damage it.",
        "Start the version of knifetip that wrote it. To go back to version {version}, restore "
        "a backup from before the upgrade.",
        url="text",
        revision="text",
        version="text",
        newest="text",
    ),
    "database.unreleased": entry(
        "The database {url} has revision {revision}, from before the first release. knifetip "
        "{version} migrates databases from revision {oldest} on.",
        "Start the version of knifetip that wrote it, and order unfinished jobs again with "
        "this version and a new database.",
        url="text",
        revision="text",
        version="text",
        oldest="text",
    ),
    "database.not-utf8": entry(
        "The database {url} has the encoding {encoding}, which cannot store all names.",
        "Create it with UTF-8: CREATE DATABASE knifetip ENCODING 'UTF8' TEMPLATE template0 "
        "LC_COLLATE 'C.UTF-8' LC_CTYPE 'C.UTF-8'.",
        url="text",
        encoding="text",
    ),
    "database.older": entry(
        "The database {url} has revision {revision}; knifetip {version} needs revision {newest}.",
        "Stop all servers and workers, make a backup, and run: knifetip db upgrade. "
        "Alternatively, start one server with --migrate.",
        url="text",
        revision="text",
        version="text",
        newest="text",
    ),
    "database.no-password": entry(
        "The file {file} contains no password for the database.",
        "Write only the password to the file, in UTF-8.",
        file="text",
    ),
    "database.password-file": entry(
        "The password of the database cannot be read from {file}: {reason}.",
        "Name a file that contains only the password and that this user can read.",
        file="text",
        reason="text",
    ),
    "database.unusable": entry(
        "The database cannot be used: {reason}.",
        "Check that its file, its folder and its disk exist and can be written by this user, or "
        "choose another one with --database.",
        reason="text",
    ),
    "database.unreachable": entry(
        "The database cannot be reached: {reason}",
        "Check the URL of the database, and that its server is running.",
        reason="text",
    ),
    "database.in-memory": entry(
        "The server cannot use an in-memory database, because all jobs would be lost when the "
        "server stops.",
        "Use a database file: sqlite:///FILE.",
    ),
}
