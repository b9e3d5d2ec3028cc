"""What all commands share: exit codes, words on stderr, JSON on stdout, files in and out."""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from rich.console import Console
from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn

from knifetip.errors import (
    DrawingTooLarge,
    KnifetipError,
    LibraryError,
    NotADrawing,
    OpenQuestions,
)
from knifetip.intake.limits import Limits
from knifetip.messages import from_json
from knifetip.model.question import Question

REFUSED = 1
QUESTIONS = 2
UNUSABLE = 3

stderr = Console(stderr=True, highlight=False, soft_wrap=True)


def say(error: KnifetipError) -> None:
    """Print an error: what is wrong, then what to do."""
    if isinstance(error, OpenQuestions):
        for question in error.questions:
            stderr.print(f"? {from_json(question)}", markup=False)
        return
    stderr.print(f"knifetip: {error.message}", markup=False, style="bold red")
    if error.hint:
        stderr.print(error.hint, markup=False)


def ask(questions: Sequence[Question]) -> None:
    """Print the open questions, each with what may be answered."""
    for question in questions:
        stderr.print(f"? {question.text}", markup=False, style="bold yellow")
        stderr.print(f"  {' | '.join(question.choices)}", markup=False)


def show(data: Any) -> None:
    """Print plain data as JSON on stdout."""
    sys.stdout.write(dumped(data).decode())


def read_bytes(path: Path) -> bytes:
    """Return what is in a file.

    Raises
    ------
    NotADrawing
        The file is not there or cannot be read.
    DrawingTooLarge
        It is larger than any drawing; no more of it is read.
    """
    most = Limits().bytes
    try:
        with path.open("rb") as file:
            data = file.read(most + 1)
    except OSError as reason:
        raise NotADrawing(
            f"{path}: {reason.strerror or reason}.", "Check the name and the rights of the file."
        ) from reason
    if len(data) > most:
        raise DrawingTooLarge(
            f"{path} is larger than {most >> 20} MB.", "Export a single carton, without pictures."
        )
    return data


def write_bytes(path: Path, data: bytes) -> None:
    """Write a file.

    Raises
    ------
    LibraryError
        It cannot be written.
    """
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data)
    except OSError as reason:
        raise LibraryError(
            f"{path} cannot be written: {reason.strerror or reason}.", "Choose another place."
        ) from reason


@contextmanager
def progress(title: str) -> Iterator[Any]:
    """Show a bar on stderr while work is going on; yields a function of stage and share."""
    columns = (
        TextColumn("[bold]{task.fields[title]}"),
        BarColumn(),
        TextColumn("{task.description}"),
        TimeElapsedColumn(),
    )
    with Progress(*columns, console=stderr, transient=True, disable=not stderr.is_terminal) as bar:
        task = bar.add_task("read", total=1.0, title=title)
        yield lambda stage, share: bar.update(task, description=stage, completed=share)


def dumped(data: Any) -> bytes:
    """Return plain data as JSON for a file."""
    return (json.dumps(data, ensure_ascii=False, indent=2, allow_nan=False) + "\n").encode()
