"""knifetip job: the jobs of a server, as an operator lists and moves them.

list, show        what there is and what it waits for
confirm           at the machine: table clear, this board, these tools
hold, resume      while it runs
cancel            after a question; the same for scrap
finish, requeue   after an interruption
"""

from __future__ import annotations

from typing import Annotated, Any
from urllib.parse import quote

import typer

from knifetip.cli.drawing import Json
from knifetip.cli.terminal import show
from knifetip.errors import JobError
from knifetip.messages import from_json

Server = Annotated[
    str, typer.Option(envvar="KNIFETIP_SERVER", help="URL of the server.", show_default=True)
]
Key = Annotated[
    str, typer.Option(envvar="KNIFETIP_KEY", help="Key for the server, where it asks one.")
]
Id = Annotated[str, typer.Argument(metavar="JOB", help="Id of the job.")]
Yes = Annotated[bool, typer.Option("--yes", "-y", help="Do not ask.")]

SERVER = "http://127.0.0.1:8080"
#: States in which the machine has the job's board.
_ON_TABLE = ("running", "held")
_CANCEL = (
    "The machine holds, lifts the tool and releases its stations. The board on the table is "
    "probably lost."
)


class JobClient:
    """The job routes of a server."""

    def __init__(self, server: str, key: str = "") -> None:
        self._headers = {"X-Knifetip": "cli"}
        if key:
            self._headers["Authorization"] = f"Bearer {key}"
        self._server = server.rstrip("/")

    def request(
        self,
        method: str,
        path: str = "",
        *,
        params: dict[str, Any] | None = None,
        body: dict[str, str] | None = None,
    ) -> Any:
        """Return the answer to a request below ``/api/jobs``.

        Raises
        ------
        JobError
            The server cannot be reached, or refuses; in its own words.
        """
        import httpx  # a moment of imports that the other commands spare

        url = f"{self._server}/api/jobs{path}"
        try:
            answer = httpx.request(
                method, url, params=params, json=body, headers=self._headers, timeout=30.0
            )
        except (httpx.HTTPError, httpx.InvalidURL) as reason:
            raise JobError("server.unreachable", server=self._server, reason=reason) from reason
        try:
            content = answer.json()
        except ValueError:
            content = {}
        if answer.is_success:
            return content
        if isinstance(content, dict) and "detail" in content:
            raise JobError(from_json({"text": content["detail"], **content}))
        raise JobError("server.answered", url=url, status=answer.status_code)

    def job(self, id: str) -> dict[str, Any]:
        """Return a job."""
        return dict(self.request("GET", _path(id)))

    def command(self, id: str, command: str, body: dict[str, str] | None = None) -> dict[str, Any]:
        """Send a command to a job and return the job after it."""
        return dict(self.request("POST", f"{_path(id)}/{command}", body=body))


def _path(id: str) -> str:
    return f"/{quote(id, safe='')}"


def register(app: typer.Typer) -> None:
    """Add the commands of this module."""
    job = typer.Typer(
        help="The jobs of a server: list, show, confirm, hold, resume, cancel, finish, …",
        no_args_is_help=True,
    )
    app.add_typer(job, name="job")

    @job.command("list")
    def list_jobs(
        server: Server = SERVER,
        key: Key = "",
        state: Annotated[
            list[str] | None, typer.Option(help="Only jobs in this state; may be repeated.")
        ] = None,
        limit: Annotated[int, typer.Option(min=1, max=500)] = 50,
        json: Json = False,
    ) -> None:
        """List jobs, the newest first."""
        params: dict[str, Any] = {"limit": limit, "state": state or []}
        rows = JobClient(server, key).request("GET", params=params)
        if json:
            show(rows)
            return
        for row in rows:
            waits = f"  waits for {row['waiting_for']}" if row["waiting_for"] else ""
            typer.echo(
                f"{row['id']}  {row['state']:11} {row['machine']:14} {row['board']:14} "
                f"{row['drawing_name']}{waits}"
            )

    @job.command("show")
    def show_job(id: Id, server: Server = SERVER, key: Key = "", json: Json = False) -> None:
        """Show a job: its state, what it waits for and where it is."""
        row = JobClient(server, key).job(id)
        if json:
            show(row)
            return
        _describe(row)

    @job.command()
    def confirm(
        id: Id,
        server: Server = SERVER,
        key: Key = "",
        board: Annotated[
            str, typer.Option(help="The board on the table; another than the job's is refused.")
        ] = "",
        by: Annotated[str, typer.Option(help="Who confirms, for the record.")] = "",
    ) -> None:
        """Confirm at the machine: table clear, board and tools in place. The machine starts."""
        body = {name: value for name, value in (("board", board), ("by", by)) if value}
        _describe(JobClient(server, key).command(id, "confirm", body))

    @job.command()
    def cancel(id: Id, server: Server = SERVER, key: Key = "", yes: Yes = False) -> None:
        """Cancel a job; asks first where it is on the table."""
        client = JobClient(server, key)
        if not yes:
            row = client.job(id)
            what = _CANCEL if row["state"] in _ON_TABLE else f"The job is {row['state']}."
            typer.confirm(f"{what} Cancel job {id}?", abort=True, err=True)
        _describe(client.command(id, "cancel"))

    @job.command()
    def scrap(id: Id, server: Server = SERVER, key: Key = "", yes: Yes = False) -> None:
        """Give an interrupted job up; asks first. Its table is free afterwards."""
        client = JobClient(server, key)
        if not yes:
            what = "The job is given up with the copies that are left, and its table is free."
            typer.confirm(f"{what} Scrap job {id}?", abort=True, err=True)
        _describe(client.command(id, "scrap"))

    for name, words in _PLAIN.items():
        _add(job, name, words)


_PLAIN = {
    "hold": "Hold the machine.",
    "resume": "Let a held machine go on.",
    "finish": "Declare an interrupted job finished: all its sheets are complete.",
    "requeue": "Queue an interrupted job again, from its first line.",
}


def _add(app: typer.Typer, name: str, words: str) -> None:
    """Add a command that sends its name to a job."""

    @app.command(name, help=words)
    def send(id: Id, server: Server = SERVER, key: Key = "") -> None:
        _describe(JobClient(server, key).command(id, name))


def _describe(row: dict[str, Any]) -> None:
    """Print a job in a few lines."""
    typer.echo(f"{row['id']}  {row['state']}  {row['drawing_name']}")
    typer.echo(f"  {row['machine']}, board {row['board']}")
    if row["tools"]:
        tools = ", ".join(f"{one['name']} (station {one['station']})" for one in row["tools"])
        typer.echo(f"  tools: {tools}")
    if row["state"] not in ("received", "compiling", "refused"):
        typer.echo(
            f"  line {row['line']} of {row['lines']}, copies {row['copies_done']} of "
            f"{row['copies']}"
        )
    for text in (row["reason"], row["hint"]):
        if text:
            typer.echo(f"  {text}")
