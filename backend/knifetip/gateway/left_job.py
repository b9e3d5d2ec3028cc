"""left_job: how a job ended that was under way when its gateway was switched off.

The journal has a lower bound of its executed lines.  A controller that recalls its program reports
how far it is (``takeover``); for the others the journal has an upper bound, too.  A job of which
certainly no line was executed returns to the queue.
"""

from __future__ import annotations

import logging

from knifetip.errors import KnifetipError
from knifetip.gateway.controller import Controller
from knifetip.gateway.interpreter import Interpreter, tool_offsets
from knifetip.gateway.job_run import JobEnd
from knifetip.gateway.job_server import JobServer
from knifetip.gateway.journal import UnfinishedJob
from knifetip.gateway.takeover import Found, Recalls, has_ended
from knifetip.messages import Message
from knifetip.model.machine import Machine

_log = logging.getLogger(__name__)


async def end_of(
    left: UnfinishedJob, controller: Controller | None, server: JobServer, machine: Machine
) -> JobEnd:
    """Return the end of a job that ran when the gateway was last switched off.

    Parameters
    ----------
    left
        The job, as the journal records it.
    controller
        Controller of the machine, after the gateway has connected to it; None if it cannot be
        reached.
    server
        Server of the gateway, for the text of the program.
    machine
        The machine.
    """

    def end(
        outcome: str, cause: Message | None, line: int, copies_done: int, at_most: int | None
    ) -> JobEnd:
        return JobEnd(left.job, left.epoch, outcome, cause, line, copies_done, line_at_most=at_most)

    if left.outcome:
        return end(left.outcome, left.cause, left.line, left.copies_done, left.line_at_most)
    found = _find_shown_program(left, controller)
    unbegun = not left.copy_begun or (found is not None and not found.begun)
    if unbegun and left.copies_done == 0:
        return end("returned", Message("gateway.switched-off-before-begin"), 0, 0, 0)
    ended = Message("gateway.switched-off-before-report")
    if left.copies_done >= left.copies:
        return end("done", ended, left.line, left.copies_done, left.line)
    off = Message("gateway.switched-off")
    executed = None if found is None else await _count_executed_lines(left, found, server, machine)
    if executed is None:
        # Between two copies nothing was sent of the next one.
        at_most = left.sent_at_most if left.copy_begun else 0
        return end("interrupted", off, left.line, left.copies_done, at_most)
    if executed < left.lines:
        return end("interrupted", off, executed, left.copies_done, executed)
    done = left.copies_done + 1
    if done < left.copies:
        return end("interrupted", off, 0, done, 0)
    return end("done", ended, left.lines, done, left.lines)


def _find_shown_program(left: UnfinishedJob, controller: object) -> Found | None:
    """Return what a controller shows of the program that ran last; None if it shows another one."""
    found = controller.found if isinstance(controller, Recalls) else None
    if found is None or not left.program or found.program != left.program:
        return None
    return found


async def _count_executed_lines(
    left: UnfinishedJob, found: Found, server: JobServer, machine: Machine
) -> int | None:
    """Return how many lines of the copy that ran last were executed; None if not known."""
    if found.executed is not None:
        return found.executed if left.line <= found.executed <= left.lines else None
    if found.rest is None:
        return None
    try:
        text = await server.text_of(left.job, left.sha256)
    except (KnifetipError, OSError) as error:
        _log.warning("%s", error)
        return None
    interpreter = Interpreter(found.rest, tool_offsets(machine))
    return left.lines if has_ended(text, interpreter, left.line, found.rest) else None
