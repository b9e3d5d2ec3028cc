"""terminal: functions for exit codes, messages, JSON output and files, used by all commands."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import typer
from pydantic_core import to_json

from knifetip.errors import (
    DrawingTooLarge,
    GatewayRefused,
    KnifetipError,
    LibraryError,
    NotADrawing,
    OpenQuestions,
)
from knifetip.harmless import harmless
from knifetip.messages import Message, from_json, hint, render
from knifetip.messages.languages import choose_language
from knifetip.model.question import Question

REFUSED = 1
QUESTIONS = 2
UNUSABLE = 3
NO_ACCESS = 4


def user_language() -> str:
    """Return the tag of the language of what a command prints, as the environment states it."""
    names = (os.environ.get(name, "") for name in ("LC_ALL", "LC_MESSAGES", "LANG"))
    return choose_language([next(filter(None, names), "")])


def in_words(message: Message) -> str:
    """Return the text of a message in the language of the user."""
    return render(message, user_language())


def advice(message: Message) -> str:
    """Return the hint of a message in the language of the user; empty if there is no hint."""
    return hint(message, user_language())


def print_stderr(text: str, colour: str | None = None) -> None:
    """Print a text line on stderr.

    Parameters
    ----------
    text
        The text line.
    colour
        Colour of the text, which is then also bold; None for plain text.
    """
    typer.secho(harmless(text, "\n"), err=True, fg=colour, bold=colour is not None)


def print_line(text: str) -> None:
    """Print a line on stdout, without the effect of control characters that a name contains."""
    typer.echo(harmless(text))


def print_message(message: Message, colour: str | None = None, *, indent: int = 0) -> None:
    """Print the text of a message on stderr.

    Parameters
    ----------
    message
        The message.
    colour
        Colour of the text as in ``print_stderr``.
    indent
        Number of blanks before the text.
    """
    print_stderr(" " * indent + in_words(message), colour)


def exit_code(error: KnifetipError) -> int:
    """Return the exit code of a process that an error ends.

    A gateway that the server refuses has a code of its own: starting it again is of no use before a
    person has given it another key.
    """
    return NO_ACCESS if isinstance(error, GatewayRefused) else UNUSABLE


def report_error(error: KnifetipError) -> None:
    """Print the text and the hint of an error on stderr.

    If the error is an ``OpenQuestions``, its questions are printed instead.
    """
    if isinstance(error, OpenQuestions):
        for question in error.questions:
            print_stderr(f"? {in_words(from_json(question))}")
        return
    print_stderr(f"knifetip: {in_words(error.message)}", "red")
    if text := advice(error.message):
        print_stderr(text)
    if error.edges:
        print_how_to_leave_out(error.edges)


def print_how_to_leave_out(edges: Iterable[int]) -> None:
    """Print the option that leaves out edges because of which no program is written."""
    rows = ",".join(str(row) for row in edges)
    print_message(Message("output.leave-out", edges=rows), indent=2)


def report_questions(questions: Sequence[Question]) -> None:
    """Print open questions with their possible answers on stderr."""
    for question in questions:
        print_stderr(f"? {question.text}", "yellow")
        for edges in question.follows:
            print_stderr(f"  {edges.message}")
        print_stderr(f"  {' | '.join(question.choices)}")


def report_warnings(warnings: Sequence[Message]) -> None:
    """Print warnings about a drawing with their hints on stderr."""
    for warning in warnings:
        print_stderr(f"! {in_words(warning)} {advice(warning)}".rstrip(), "yellow")


def print_json(data: Any) -> None:
    """Print JSON data on stdout; a terminal gets no control characters."""
    text = json_bytes(data).decode()
    sys.stdout.write(harmless(text, "\n") if sys.stdout.isatty() else text)


def read_bytes(path: Path) -> bytes:
    """Return the content of a file.

    Raises
    ------
    NotADrawing
        The file does not exist or cannot be read.
    DrawingTooLarge
        The file exceeds the size limit for drawings.
    """
    from knifetip.formats.limits import Limits  # its package imports what compiles kernels

    limit = Limits().bytes
    try:
        with path.open("rb") as file:
            data = file.read(limit + 1)
    except OSError as reason:
        raise NotADrawing(
            "command.unreadable-file", path=path, reason=reason.strerror or reason
        ) from reason
    if len(data) > limit:
        raise DrawingTooLarge("command.file-too-large", path=path, limit=limit >> 20)
    return data


def write_bytes(path: Path, data: bytes) -> None:
    """Write bytes to a file.

    Raises
    ------
    LibraryError
        The file cannot be written.
    """
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data)
    except OSError as reason:
        raise LibraryError(
            "command.unwritable-file", path=path, reason=reason.strerror or reason
        ) from reason


@contextmanager
def progress(title: str) -> Iterator[Any]:
    """Return a context that shows a progress bar on stderr if stderr is a terminal.

    Parameters
    ----------
    title
        Text before the bar.

    Yields
    ------
    callable
        ``update(stage, fraction)`` shows the name of the stage and the completed fraction (0 … 1).
    """
    if not sys.stderr.isatty():
        yield lambda _stage, _fraction: None
        return
    from rich.console import Console  # slow to import
    from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn

    columns = (
        TextColumn("[bold]{task.fields[title]}"),
        BarColumn(),
        TextColumn("{task.description}"),
        TimeElapsedColumn(),
    )
    with Progress(*columns, console=Console(stderr=True), transient=True) as bar:
        task = bar.add_task("read", total=1.0, title=title)
        yield lambda stage, fraction: bar.update(task, description=stage, completed=fraction)


def json_bytes(data: Any) -> bytes:
    """Return JSON data as indented UTF-8 bytes with a final newline.

    Numbers that are not finite are null.  The report of a large drawing has 90 MB, and the encoder
    of the standard library takes longer to indent it than the program takes to compile.
    """
    return to_json(data, indent=2, inf_nan_mode="null") + b"\n"
