"""knifetip job: list the jobs of a server and send commands to the server about them.

list, show        print the state of the jobs, their progress and the allowed actions
confirm           make the checks at the machine, one by one; the machine then starts
recheck           let the machine check a program again that it has refused
hold, resume      pause a running job, and continue it
end               state that the machine has executed a program whose end it does not report
cancel, scrap     cancel a job, or scrap an interrupted job; the user must confirm first
finish, requeue   declare an interrupted job finished, or queue it again
tracks            list the tracks of a job's program, and which of them are cut
rest              create a job that makes the rest of a sheet, or the whole program again
"""

from __future__ import annotations

from typing import Annotated, Any

import typer

from knifetip.cli.drawing import Json
from knifetip.cli.job_client import JobClient
from knifetip.cli.options import expand
from knifetip.cli.rest import NewJobOptions, RestOptions
from knifetip.cli.table_checks import ask_checks
from knifetip.cli.terminal import advice, in_words, print_json, print_line
from knifetip.messages import Message, from_json

Server = Annotated[
    str,
    typer.Option(envvar="KNIFETIP_SERVER", help="URL of the knifetip server.", show_default=True),
]
Key = Annotated[
    str, typer.Option(envvar="KNIFETIP_KEY", help="Access key of the server. Default: no key.")
]
Id = Annotated[
    str, typer.Argument(metavar="JOB", help="Id of the job, as `knifetip job list` prints it.")
]
Yes = Annotated[bool, typer.Option("--yes", "-y", help="Do not ask for confirmation.")]

SERVER = "http://127.0.0.1:8080"
#: States in which the job's board is on the machine's table.
_ON_TABLE = ("running", "held")
_PLAIN_COMMANDS = {
    "recheck": "Let the machine check a program again that it has refused.",
    "hold": "Pause a running job; the command resume continues it.",
    "end": "State that the machine has executed the program, if it does not report it.",
    "finish": "Mark an interrupted job as finished, because all its sheets are completely cut.",
    "requeue": "Queue an interrupted job again; a new sheet is cut from the first program line.",
}


def register(app: typer.Typer) -> None:
    """Add the command ``job`` with its subcommands to a Typer application."""
    job = typer.Typer(
        help="List and control the jobs of a server.",
        no_args_is_help=True,
    )
    app.add_typer(job, name="job")
    job.command("list")(list_jobs)
    job.command("show")(show_job)
    job.command("confirm")(confirm_job)
    job.command("resume")(resume_job)
    job.command("cancel")(cancel_job)
    job.command("scrap")(scrap_job)
    job.command("tracks")(list_tracks)
    job.command("rest")(expand(continue_job))
    for name, help_text in _PLAIN_COMMANDS.items():
        _add_command(job, name, help_text)


def list_jobs(
    server: Server = SERVER,
    key: Key = "",
    state: Annotated[
        list[str] | None,
        typer.Option(
            help="List only jobs in this state, such as queued or running; may be repeated. "
            "Default: all jobs."
        ),
    ] = None,
    limit: Annotated[
        int, typer.Option(min=1, max=500, help="Largest number of jobs to list.")
    ] = 50,
    json: Json = False,
) -> None:
    """List jobs, newest first, with the allowed actions in brackets."""
    params: dict[str, Any] = {"limit": limit, "state": state or []}
    rows = JobClient(server, key).request("GET", params=params)
    if json:
        print_json(rows)
        return
    for row in rows:
        event = Message("output.waits-for", event=row["waiting_for"] or "")
        waits = f"  {in_words(event)}" if row["waiting_for"] else ""
        actions = f"  [{', '.join(row['actions'])}]" if row["actions"] else ""
        print_line(
            f"{row['id']}  {row['state']:11} {row['machine']:14} {row['board']:14} "
            f"{row['drawing_name']}{waits}{actions}"
        )


def show_job(id: Id, server: Server = SERVER, key: Key = "", json: Json = False) -> None:
    """Show state, progress and allowed actions of a job."""
    row = JobClient(server, key).job(id)
    if json:
        print_json(row)
        return
    _print_job(row)


def confirm_job(
    id: Id,
    server: Server = SERVER,
    key: Key = "",
    checked: Annotated[
        str,
        typer.Option(
            metavar="ID,ID,…",
            help="Ids of the checks that were made at the machine, separated by commas. Default: "
            "each check is asked.",
        ),
    ] = "",
    changed: Annotated[
        list[int] | None,
        typer.Option(
            metavar="STATION",
            help="Number of a station into which a new tool was put; may be repeated. Default: "
            "none.",
        ),
    ] = None,
    worn_reason: Annotated[
        str,
        typer.Option(help="Why tools at the end of their lives stay in use. Default: none."),
    ] = "",
    by: Annotated[
        str,
        typer.Option(
            help="Name of the person who confirms, which is stored with the job. Default: none."
        ),
    ] = "",
) -> None:
    """Make the checks at the machine, and confirm them.

    Asks each check, unless --checked names them. The machine then starts.
    """
    client = JobClient(server, key)
    given = [one for one in checked.split(",") if one]
    body: dict[str, Any] = {"checked": given or ask_checks(id, client.checks(id))}
    more = {"changed": changed, "worn_reason": worn_reason, "by": by}
    body |= {name: value for name, value in more.items() if value}
    _print_job(client.command(id, "confirm", body))


def resume_job(
    id: Id,
    server: Server = SERVER,
    key: Key = "",
    hands_clear: Annotated[
        bool,
        typer.Option(
            "--hands-clear", help="State that hands are clear of the machine. Default: it is asked."
        ),
    ] = False,
) -> None:
    """Continue a job that is paused in a copy (state held).

    Asks whether hands are clear of the machine, unless --hands-clear states it. The machine then
    moves.
    """
    if not hands_clear:
        typer.confirm(in_words(Message("output.hands-clear")), abort=True, err=True)
    _print_job(JobClient(server, key).command(id, "resume", {"hands_clear": True}))


def cancel_job(id: Id, server: Server = SERVER, key: Key = "", yes: Yes = False) -> None:
    """Cancel a job; asks for confirmation first."""
    client = JobClient(server, key)
    if not yes:
        row = client.job(id)
        on_table = row["state"] in _ON_TABLE
        state = Message("output.job-state", state=row["state"])
        effect = Message("output.cancel-effect") if on_table else state
        question = Message("output.cancel-question", effect=effect, job=id)
        typer.confirm(in_words(question), abort=True, err=True)
    _print_job(client.command(id, "cancel"))


def scrap_job(id: Id, server: Server = SERVER, key: Key = "", yes: Yes = False) -> None:
    """Scrap an interrupted job and free its table.

    Asks for confirmation first.
    """
    client = JobClient(server, key)
    if not yes:
        typer.confirm(in_words(Message("output.scrap-question", job=id)), abort=True, err=True)
    _print_job(client.command(id, "scrap"))


def list_tracks(id: Id, server: Server = SERVER, key: Key = "", json: Json = False) -> None:
    """List the tracks of a job's program, and which of them the machine has cut.

    A track is a path of one tool between two lifts.
    """
    rows = JobClient(server, key).tracks(id)
    if json:
        print_json(rows)
        return
    for row in rows:
        (x, y), edges = row["start"], ", ".join(map(str, row["edges"]))
        track = Message(
            "output.track",
            number=f"{row['number']:5}",
            state=f"{row['state']:7}",
            station=row["station"],
            first=row["first_line"],
            last=row["last_line"],
            x=x,
            y=y,
            edges=edges,
        )
        print_line(in_words(track))


def continue_job(
    id: Id,
    server: Server = SERVER,
    key: Key = "",
    *,
    choice: RestOptions,
    new: NewJobOptions,
) -> None:
    """Create a job that makes the rest of the sheet of a job, or the whole program again.

    Without a track, a line or a station, the new job makes all tracks that the machine has not
    reported as executed.
    """
    body = {**choice.body(), **new.body()}
    _print_job(JobClient(server, key).command(id, "rest", body))


def _add_command(app: typer.Typer, name: str, help_text: str) -> None:
    """Add a subcommand that sends a command about one job to the server.

    ``app``: typer application of the command ``job``.
    ``name``: name of the subcommand and of the command to send, such as ``hold``.
    ``help_text``: help text of the subcommand.
    """

    @app.command(name, help=help_text)
    def send(id: Id, server: Server = SERVER, key: Key = "") -> None:
        _print_job(JobClient(server, key).command(id, name))


def _print_job(row: dict[str, Any]) -> None:
    """Print a summary of a job."""
    print_line(f"{row['id']}  {row['state']}  {row['drawing_name']}")
    parts = [Message("output.job-board", machine=row["machine"], board=row["board"])]
    if row["tools"]:
        tools = [
            Message("waiting.tool", name=tool["name"], station=tool["station"])
            for tool in row["tools"]
        ]
        parts.append(Message("output.job-tools", tools=tools))
    if row["lines"]:
        done = {"done": row["copies_done"], "copies": row["copies"]}
        parts.append(Message("output.job-progress", line=row["line"], lines=row["lines"], **done))
    texts = [in_words(part) for part in parts]
    if row["message"] is not None:
        message = from_json(row["message"])
        texts += filter(None, (in_words(message), advice(message)))
    if row["actions"]:
        texts.append(in_words(Message("output.actions", actions=row["actions"])))
    for text in texts:
        print_line(f"  {text}")
