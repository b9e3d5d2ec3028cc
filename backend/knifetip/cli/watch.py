"""knifetip watch: order jobs for drawings that are put into a folder."""

from __future__ import annotations

import signal
import threading
import time
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any

import typer

from knifetip.cli.access_key import KeyOptions
from knifetip.cli.job import SERVER, Server
from knifetip.cli.options import expand
from knifetip.cli.terminal import print_message, print_stderr
from knifetip.errors import SettingsError
from knifetip.messages import Message

_LONGEST_PAUSE = 30.0  # seconds between two attempts to reach the server


@dataclass(frozen=True, slots=True)
class OrderOptions:
    """Options that all orders of a hot folder have; a sidecar replaces them."""

    machine: Annotated[str, typer.Option(help="Name of the machine.")] = "demo-table"
    board: Annotated[
        str, typer.Option(help="Name of the board. Default: the sidecar must name it.")
    ] = ""
    profile: Annotated[
        str, typer.Option(help="Classification profile. Default: the server's default.")
    ] = ""
    release: Annotated[
        bool, typer.Option(help="Queue each job as soon as its program is accepted.")
    ] = False

    @property
    def fields(self) -> dict[str, Any]:
        """Fields of the orders that the options contain."""
        found = {"machine": self.machine, "board": self.board, "profile": self.profile}
        return {name: value for name, value in found.items() if value} | {"release": self.release}


def watch(
    folder: Annotated[
        Path, typer.Argument(metavar="DIR", help="Folder into which drawings are put.")
    ],
    server: Server = SERVER,
    interval: Annotated[
        float, typer.Option(min=0.1, max=3600.0, help="Seconds between two polls of the folder.")
    ] = 1.0,
    settle: Annotated[
        float,
        typer.Option(
            min=0.0, max=3600.0, help="Seconds for which a file must not change to be complete."
        ),
    ] = 2.0,
    drawing_wait: Annotated[
        float,
        typer.Option(
            min=0.0,
            max=86400.0,
            help="Seconds for which an order in XJDF waits for the drawing that it names.",
        ),
    ] = 300.0,
    once: Annotated[
        bool, typer.Option(help="End when the folder is empty and all jobs are compiled.")
    ] = False,
    *,
    order: OrderOptions,
    key: KeyOptions,
) -> None:
    """Order a job for each drawing that is put into a folder.

    The command runs until Ctrl-C.  A file NAME.json beside the drawing NAME contains further fields
    of the order.  A file NAME.xjdf orders the drawing that it names by a relative URL, when both
    are complete.  The drawing is moved to the folder done or failed, beside the program, a picture
    and NAME.job.json.
    """
    # Imported here: httpx is slow, and other commands do not need it.
    from knifetip.cli.hot_folder.arrivals import Arrivals
    from knifetip.cli.hot_folder.client import OrderClient
    from knifetip.cli.hot_folder.orders import OrderFolder
    from knifetip.cli.hot_folder.reservation import reserved

    with ExitStack() as opened:
        client = OrderClient(server, key.headers)
        opened.callback(client.close)
        try:
            orders = OrderFolder(folder, order.fields, client)
            opened.enter_context(reserved(folder))
        except OSError as reason:
            raise SettingsError("watch.folder", folder=str(folder), reason=reason) from reason
        stop = threading.Event()
        for number in (signal.SIGINT, signal.SIGTERM):
            signal.signal(number, lambda _number, _frame: stop.set())
        arrivals = Arrivals(folder, settle, time.monotonic, drawing_wait)
        print_message(Message("output.watching", folder=visible(str(folder)), server=server))
        pause = interval
        while not stop.is_set():
            busy, pause = _look(arrivals, orders, pause, interval)
            if once and not busy:
                break
            stop.wait(pause)


def _look(arrivals: Any, orders: Any, pause: float, interval: float) -> tuple[bool, float]:
    """Move complete files to ``working`` and advance all orders once.

    Returns tuple: whether a drawing is in the folder or being processed, and the time until the
    next poll (s).
    """
    from knifetip.cli.hot_folder.client import RetryLater

    failed = False
    names: list[str] = []
    try:
        for name in arrivals.complete():
            orders.take(name)
        names = orders.in_progress()
    except OSError as reason:
        unreadable = Message("output.folder-unreadable", reason=visible(str(reason)))
        print_message(unreadable, "yellow")
        failed = True
    for name in names:
        try:
            news = orders.advance(name)
        except RetryLater as reason:
            failed = True
            if not reason.of_one_file:
                silent = Message("output.server-silent", reason=visible(str(reason)))
                print_message(silent, "yellow")
                break  # the requests for the other files would fail too
            print_stderr(f"{visible(name)}: {visible(str(reason))}", "yellow")
            continue
        except OSError as reason:
            print_stderr(f"{visible(name)}: {visible(str(reason))}", "yellow")
            failed = True
            continue
        if news:
            print_stderr(f"{visible(name)}: {visible(news)}")
    busy = failed or bool(names) or arrivals.is_waiting
    return busy, min(2.0 * pause, _LONGEST_PAUSE) if failed else interval


def visible(text: str) -> str:
    """Return a text in one line without control characters, which affect terminals."""
    return "".join(letter if letter.isprintable() else "\ufffd" for letter in text)


def register(app: typer.Typer) -> None:
    """Add the command ``watch`` to a Typer application."""
    app.command()(expand(watch))
