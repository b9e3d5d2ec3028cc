"""Options of the commands that let a user accept shortfalls of a program."""

from __future__ import annotations

import getpass
import re
import time
from dataclasses import dataclass
from typing import Annotated, Final

import typer

from knifetip.model.acceptance import Shortfall, with_exceptions
from knifetip.model.verdict import Acceptance, Verdict

_ACCEPT: Final = re.compile(r"(\d{1,9}(?:,\d{1,9})*):([a-z0-9.-]+)", re.ASCII)


def parse_shortfalls(text: str) -> set[Shortfall]:
    """Return the edges and the code of the text "EDGE,EDGE:CODE" of the option ``--accept``."""
    match = _ACCEPT.fullmatch(text)
    if match is None:
        raise typer.BadParameter(
            f"{text!r} is not of the form EDGE:CODE or EDGE,EDGE:CODE.", param_hint="--accept"
        )
    return {(int(edge), match[2]) for edge in match[1].split(",")}


@dataclass(frozen=True, slots=True)
class ExceptionOptions:
    """Command-line options that accept shortfalls of the program."""

    accept: Annotated[
        list[str] | None,
        typer.Option(
            metavar="EDGE:CODE",
            help="Accept the shortfall CODE at this edge (row of the drawing, as in the finding); "
            "several edges are separated by commas. May be repeated. Faults cannot be accepted.",
        ),
    ] = None
    reason: Annotated[
        str, typer.Option(help="Why the shortfalls are acceptable; required with --accept.")
    ] = ""
    by: Annotated[
        str,
        typer.Option(help="Name of the person who accepts them. Default: name of the login."),
    ] = ""

    def apply(self, verdict: Verdict) -> Verdict:
        """Return a verdict in which the shortfalls that the options name are accepted.

        Raises
        ------
        RequestError
            There is no such finding, or it is a fault or a note.
        """
        if not self.accept:
            return verdict
        if not self.reason.strip():
            raise typer.BadParameter("Give the reason why.", param_hint="--reason")
        chosen = {one for text in self.accept for one in parse_shortfalls(text)}
        acceptance = Acceptance(self.by or getpass.getuser(), self.reason.strip(), time.time())
        return with_exceptions(verdict, chosen, acceptance)
