"""table_checks: ask a person for the checks of a job that are made at the machine."""

from __future__ import annotations

import sys
from collections.abc import Mapping, Sequence
from typing import Any

import typer

from knifetip.cli.terminal import QUESTIONS, REFUSED, in_words, print_message, print_stderr
from knifetip.harmless import harmless
from knifetip.messages import Message


def ask_checks(job: str, checks: Sequence[Mapping[str, Any]]) -> list[str]:
    """Ask for each check of a job, and return the ids of all.

    Parameters
    ----------
    job
        Id of the job.
    checks
        Checks of the job as JSON data, with id and text.

    Raises
    ------
    typer.Exit
        With code 1 if the person answers one with no; with code 2 if nobody can be asked, because
        stdin is not a terminal.  The checks are then printed, with the options that state them.
    """
    if not sys.stdin.isatty():
        print_message(Message("output.check-first", job=job), "yellow")
        for check in checks:
            print_stderr(f"  {check['id']:17} {check['text']}")
        ids = ",".join(str(check["id"]) for check in checks)
        print_message(Message("output.if-so"))
        print_stderr(f"  knifetip job confirm {job} --checked {ids}")
        raise typer.Exit(QUESTIONS)
    for number, check in enumerate(checks, start=1):
        question = Message(
            "output.check-question", number=number, count=len(checks), text=check["text"]
        )
        if not typer.confirm(harmless(in_words(question)), default=None, err=True):
            print_message(Message("output.not-confirmed", job=job), "yellow")
            raise typer.Exit(REFUSED)
    return [str(check["id"]) for check in checks]
