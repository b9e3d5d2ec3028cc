"""knifetip doctor: check an installation, a database, a server and the computer at a machine."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from typing import Annotated, Final

import typer

from knifetip.cli.access_key import KeyOptions
from knifetip.cli.checks import computer, machine, server, storage
from knifetip.cli.checks.check_result import CheckResult, Grade, run
from knifetip.cli.options import expand
from knifetip.cli.terminal import advice, in_words, print_json, print_line
from knifetip.messages import Message
from knifetip.service.settings import StorageSettings

_WORDS: Final = {
    Grade.OK: Message("doctor.grade-ok"),
    Grade.WARNING: Message("doctor.grade-warning"),
    Grade.PROBLEM: Message("doctor.grade-problem"),
}
_COLOURS: Final = {Grade.OK: "green", Grade.WARNING: "yellow", Grade.PROBLEM: "red"}


def doctor(
    server_url: Annotated[
        str,
        typer.Option("--server", help="URL of a server to check too; with --key or --key-file."),
    ] = "",
    machine_name: Annotated[
        str,
        typer.Option("--machine", help="Machine of the library, or its TOML file, to check too."),
    ] = "",
    controller: Annotated[
        str,
        typer.Option(help="Address of the machine's controller, as for knifetip gateway."),
    ] = "",
    host: Annotated[str, typer.Option(help="Address on which the server is to listen.")] = (
        "127.0.0.1"
    ),
    as_json: Annotated[bool, typer.Option("--json", help="Print JSON.")] = False,
    *,
    chosen: StorageSettings,
    access: KeyOptions,
) -> None:
    """Check this installation, and print what to do.

    Nothing is changed.  Exit code: 0 if all is well, 1 with warnings, 2 with problems.
    """
    headers = access.headers
    options = storage.ServerOptions(chosen.url, chosen.shown, chosen.store, host, bool(headers))
    findings: list[CheckResult] = []
    for finding in _findings(options, server_url, headers, machine_name, controller):
        findings.append(finding)
        if not as_json:
            _print(finding)
    worst = max(finding.grade for finding in findings)
    if as_json:
        print_json(
            {
                "result": worst.name.lower(),
                "findings": [
                    {
                        "grade": finding.grade.name.lower(),
                        "subject": finding.subject,
                        "text": finding.text,
                        "advice": finding.advice,
                    }
                    for finding in findings
                ],
            }
        )
    raise typer.Exit(int(worst))


def _findings(
    options: storage.ServerOptions, url: str, headers: dict[str, str], name: str, controller: str
) -> Iterator[CheckResult]:
    yield from run("python", computer.check_python)
    yield from run("packages", computer.check_packages)
    yield from run("kernels", computer.check_kernels)
    yield from run("converters", computer.check_converters)
    folder = storage.data_folder(options)
    folders = [] if folder is None else [folder]
    yield from run("disk", partial(computer.check_disks, folders))
    yield from run("database", partial(storage.check_database, options))
    yield from run("serial ports", machine.check_ports)
    if name:
        yield from run("machine", partial(machine.check_machine, name, controller))
    if url:
        yield from run("server", partial(server.check_server, url, headers))


def _print(finding: CheckResult) -> None:
    word = typer.style(f"{in_words(_WORDS[finding.grade]):8}", fg=_COLOURS[finding.grade])
    typer.echo(word, nl=False)
    print_line(f"{finding.subject}: {in_words(finding.message)}")
    if what := advice(finding.message):
        print_line(f"        {what}")


def register(app: typer.Typer) -> None:
    """Add ``doctor`` to a Typer application."""
    app.command()(expand(doctor))
