"""Execute the commands and queries of XJMF as commands to jobs (ADR 96)."""

from __future__ import annotations

from collections.abc import Awaitable, Callable, Mapping
from dataclasses import dataclass
from functools import partial
from typing import Final
from xml.etree.ElementTree import Element

from fastapi import Response
from fastapi.exceptions import RequestValidationError

from knifetip.contract.job import ENDED, LEASED, OPERATOR, State
from knifetip.errors import (
    AccessDenied,
    KnifetipError,
    LibraryError,
    NotFound,
    RequestError,
    ServerBusy,
    WrongState,
)
from knifetip.fields import fault_message
from knifetip.messages import render
from knifetip.service.accounts.ownership import check_own_job, check_withdrawal
from knifetip.service.components import Service
from knifetip.service.database.tables import Job
from knifetip.service.http.principal import Principal, demand
from knifetip.service.http.scopes import AccessScope
from knifetip.service.limits.work_queue import Client
from knifetip.service.order_details.details import DetailsFilter
from knifetip.service.orders.store import JobFilter
from knifetip.service.queues.store import WaitingChange
from knifetip.service.xjdf.package import XjdfPackage
from knifetip.service.xjdf.placing import XjdfDefaults, XjdfSubmission, place_xjdf
from knifetip.service.xjdf.status import NODE_STATUS, device_info, queue_entry
from knifetip.service.xjdf.xjmf_messages import ReturnCode, XjmfAnswer, XjmfMessage
from knifetip.service.xjdf.xml import children

_MOST_ENTRIES = 200  # entries of a queue that a response contains
#: Attributes of a QueueFilter that commands may have; the last two select nothing.
_CONDITIONS = ("QueueEntryIDs", "JobID", "StatusList", "QueueEntryDetails", "UpdateGranularity")
_OPEN = tuple(state for state in State if state not in ENDED)


@dataclass(frozen=True, slots=True)
class MessageContext:
    """What the messages of one request have in common: server, sender, package and key."""

    service: Service
    principal: Principal
    client: Client
    package: XjdfPackage  #: files to which the messages refer
    defaults: XjdfDefaults
    key: str | None  #: Idempotency-Key of the request, None if it has none
    host: str = ""  #: name and port of this server, as the request names it


class _Refusal(Exception):
    """Raised to answer a message with a return code of its own."""

    def __init__(self, code: ReturnCode, *comments: str) -> None:
        super().__init__(*comments)
        self.code = code
        self.comments = comments


async def answer_messages(context: MessageContext, message: XjmfMessage) -> XjmfAnswer:
    """Execute a message and return the response; errors become return codes."""
    handler = _HANDLERS.get(message.family + message.name)
    if handler is None:
        text = f"{message.family}{message.name} is not supported. QueryKnownMessages lists what is."
        return XjmfAnswer(message, ReturnCode.NOT_IMPLEMENTED, [text])
    if message.parameters("Subscription") is not None:
        text = "Subscriptions are not supported. Use webhooks, or repeat the query."
        return XjmfAnswer(message, ReturnCode.SUBSCRIPTION_DENIED, [text])
    try:
        return XjmfAnswer(message, content=await handler(context, message))
    except _Refusal as reason:
        return XjmfAnswer(message, reason.code, reason.comments)
    except RequestValidationError as reason:
        texts = [
            render(fault_message(one, ".".join(map(str, one["loc"]))[:200]))
            for one in reason.errors()[:10]
        ]
        return XjmfAnswer(message, ReturnCode.INVALID_PARAMETERS, texts)
    except KnifetipError as reason:
        return XjmfAnswer(message, _code_of(reason), [reason.text, *filter(None, [reason.hint])])


def _code_of(reason: KnifetipError) -> ReturnCode:
    """Return the code for an error."""
    if isinstance(reason, RequestError):
        return _REQUEST_CODES.get(reason.message.code, ReturnCode.INVALID_PARAMETERS)
    return next(
        (code for kind, code in _ERROR_CODES if isinstance(reason, kind)), ReturnCode.INCAPABLE
    )


async def _submit(context: MessageContext, message: XjmfMessage) -> list[Element]:
    """Create the job of an order; without ``Activation`` it is released, as XJMF prescribes."""
    parameters = _required(message, "QueueSubmissionParams")
    activation = parameters.get("Activation", "Active")
    if activation not in ("Active", "Held"):
        raise _Refusal(
            ReturnCode.INVALID_PARAMETERS, f"Activation {activation[:40]} is not supported."
        )
    document = context.package.file(parameters.get("URL", ""))
    # Messages need no id.
    key = f"{context.key}/{message.index}/{message.id}" if context.key else None
    job = await place_xjdf(
        context.service,
        context.principal,
        context.client,
        Response(),
        XjdfSubmission(
            document,
            context.package,
            context.defaults,
            activation == "Active",
            context.host,
        ),
        key,
    )
    return [queue_entry(context.service.store.jobs.get(job.id))]


async def _modify(context: MessageContext, message: XjmfMessage) -> list[Element]:
    """Change the entries that the filter selects, all or up to the first that cannot be changed."""
    parameters = _required(message, "ModifyQueueEntryParams")
    operation = parameters.get("Operation", "")
    change = _OPERATIONS.get(operation)
    if change is None:
        raise _Refusal(
            ReturnCode.NOT_IMPLEMENTED, f"The operation {operation[:40]} is not supported."
        )
    run = context.service.orders.run
    rows = await run(partial(_selected_jobs, context, parameters), context.client)
    if not rows:
        raise _Refusal(ReturnCode.UNKNOWN_ENTRY, "The filter selects no entry of the queue.")
    changed = [
        await run(partial(_change_entry, context, change, operation, row.id), context.client)
        for row in rows
    ]
    return [queue_entry(row) for row in changed]


def _change_entry(
    context: MessageContext, change: Callable[[MessageContext, Job], None], operation: str, id: str
) -> Job:
    """Change one entry and return it as it is then."""
    jobs = context.service.store.jobs
    row = jobs.get(id)
    try:
        change(context, row)
    except WrongState as reason:
        raise _Refusal(
            _state_code(row, operation), reason.text, *filter(None, [reason.hint])
        ) from reason
    return jobs.get(id)


def _state_code(row: Job, operation: str) -> ReturnCode:
    """Return why the state of a job does not permit an operation."""
    if row.state in ENDED:
        return ReturnCode.ENDED
    if operation == "Suspend":
        return ReturnCode.NOT_RUNNING
    return ReturnCode.EXECUTING if row.state in LEASED else ReturnCode.ALREADY_SO


def _hold(context: MessageContext, row: Job) -> None:
    """Keep a waiting job in the queue, so that no machine claims it."""
    check_own_job(context.service, context.principal, row.id)
    if row.on_hold:
        raise _Refusal(ReturnCode.ALREADY_SO, "The job is already held.")
    context.service.store.queues.change(row.id, WaitingChange(on_hold=True), OPERATOR)


def _suspend(context: MessageContext, row: Job) -> None:
    """Hold the machine that works on a job."""
    demand(context.principal, AccessScope.OPERATOR)
    context.service.store.operators.hold(row.id)


def _resume(context: MessageContext, row: Job) -> None:
    """Resume a job on its machine, end its hold in the queue, or release it."""
    check_own_job(context.service, context.principal, row.id)
    store = context.service.store
    if row.state == State.HELD:
        demand(context.principal, AccessScope.STATION)
        store.operators.resume(row.id)
        return
    if not row.on_hold and row.state != State.READY:
        code = ReturnCode.ENDED if row.state in ENDED else ReturnCode.ALREADY_SO
        raise _Refusal(code, f"The job is {row.state}, and not held.")
    if row.on_hold:
        store.queues.change(row.id, WaitingChange(on_hold=False), OPERATOR)
    if row.state == State.READY:
        store.programs.release(row.id)


def _abort(context: MessageContext, row: Job) -> None:
    """Cancel a job; a machine that works on it stops."""
    check_withdrawal(context.service, context.principal, row.id)
    if row.state == State.CANCELLED:
        raise _Refusal(ReturnCode.ALREADY_SO, "The job is already cancelled.")
    context.service.store.operators.cancel(row.id)


def _remove(context: MessageContext, row: Job) -> None:
    """Cancel a job on which no machine works."""
    if row.state in LEASED:
        raise _Refusal(ReturnCode.EXECUTING, "The job is on its machine. Abort it instead.")
    _abort(context, row)


async def _queue_status(context: MessageContext, message: XjmfMessage) -> list[Element]:
    """Return the selected entries; without filter those that have not ended."""
    parameters = message.parameters("QueueStatusParams")
    run = context.service.orders.run
    rows = await run(partial(_selected_jobs, context, parameters), context.client)
    queue = Element("Queue", {"QueueSize": str(len(rows))})
    queue.extend(queue_entry(row) for row in rows)
    return [queue]


async def _status(context: MessageContext, message: XjmfMessage) -> list[Element]:
    parameters = message.parameters("StatusQuParams")
    id = "" if parameters is None else parameters.get("QueueEntryID", "")
    if not id:
        raise _Refusal(
            ReturnCode.INSUFFICIENT_PARAMETERS, "StatusQuParams/@QueueEntryID is missing."
        )
    get = partial(context.service.store.jobs.get, id)
    return [device_info(await context.service.orders.run(get, context.client))]


async def _known_messages(context: MessageContext, message: XjmfMessage) -> list[Element]:
    del context, message
    return [
        Element("MessageService", {"ResponseModes": "Response", "Type": name})
        for name in sorted(_HANDLERS)
    ]


def _selected_jobs(context: MessageContext, parameters: Element | None) -> list[Job]:
    """Return the jobs that a ``QueueFilter`` selects, newest first.

    Raises ``NotFound``: an entry that is named by its id does not exist.
    """
    filters = [] if parameters is None else children(parameters, "QueueFilter")
    attributes = filters[0].attrib if filters else {}
    if parameters is not None and "Operation" in parameters.attrib:
        _check_selection(attributes)
    jobs = context.service.store.jobs
    job = attributes.get("JobID", "")
    wanted = attributes.get("StatusList", "").split()
    if "QueueEntryIDs" in attributes:
        ids = attributes["QueueEntryIDs"].split()[:_MOST_ENTRIES]
        rows = [row for id in ids if (row := jobs.get(id)) and job in ("", row.external_id)]
    else:
        states = () if job or wanted else _OPEN
        details = JobFilter(DetailsFilter(external_id=job))
        rows = jobs.search(states, limit=_MOST_ENTRIES, wanted=details)
    if wanted:
        rows = [row for row in rows if NODE_STATUS[State(row.state)] in wanted]
    return rows


def _check_selection(attributes: Mapping[str, str]) -> None:
    """Raise ``_Refusal`` unless the filter of a command selects exactly the entries to change.

    A condition that is not supported must not be disregarded: the command would change entries
    that it excludes.
    """
    if not attributes.get("JobID") and "QueueEntryIDs" not in attributes:
        raise _Refusal(
            ReturnCode.INSUFFICIENT_PARAMETERS, "QueueFilter needs QueueEntryIDs or JobID."
        )
    for name in attributes:
        if name not in _CONDITIONS and not name.startswith("{"):
            raise _Refusal(
                ReturnCode.INVALID_PARAMETERS, f"QueueFilter/@{name[:40]} is not supported."
            )
    if len(attributes.get("QueueEntryIDs", "").split()) > _MOST_ENTRIES:
        raise _Refusal(
            ReturnCode.INVALID_PARAMETERS, f"A command changes at most {_MOST_ENTRIES} entries."
        )


def _required(message: XjmfMessage, name: str) -> Element:
    found = message.parameters(name)
    if found is None:
        raise _Refusal(ReturnCode.INSUFFICIENT_PARAMETERS, f"{name} is missing.")
    return found


_HANDLERS: Final[
    Mapping[str, Callable[[MessageContext, XjmfMessage], Awaitable[list[Element]]]]
] = {
    "CommandSubmitQueueEntry": _submit,
    "CommandModifyQueueEntry": _modify,
    "QueryQueueStatus": _queue_status,
    "QueryStatus": _status,
    "QueryKnownMessages": _known_messages,
}
_OPERATIONS: Final[Mapping[str, Callable[[MessageContext, Job], None]]] = {
    "Abort": _abort,
    "Hold": _hold,
    "Remove": _remove,
    "Resume": _resume,
    "Suspend": _suspend,
}
_REQUEST_CODES: Final[Mapping[str, ReturnCode]] = {
    "xjdf.missing": ReturnCode.INSUFFICIENT_PARAMETERS,
    "xjdf.no-file": ReturnCode.NO_REFERENCED_FILE,
}
_ERROR_CODES: Final = (
    (AccessDenied, ReturnCode.DENIED),
    (ServerBusy, ReturnCode.BUSY),
    (NotFound, ReturnCode.UNKNOWN_ENTRY),
    (LibraryError, ReturnCode.UNKNOWN_DEVICE),
)
