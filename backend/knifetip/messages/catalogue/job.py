"""job: messages about jobs, the machines that run them, and the processes that compile them."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "job.action-requested": entry(
        "The operator requested: {action}.",
        action="text",
    ),
    "job.at-line": entry(
        "At line {line}.",
        line="count",
    ),
    "job.awaits-kernels": entry(
        "Waiting until the functions that the machine {machine} needs are compiled, once "
        "after an installation.",
        "Wait: the job is compiled as soon as they are ready.",
        machine="text",
    ),
    "job.being-cancelled": entry(
        "Job {job} is being cancelled.",
        "Wait until the machine has stopped.",
        job="text",
    ),
    "job.cancelled": entry(
        "Cancelled.",
    ),
    "job.cancelled-before-request": entry(
        "Job {job} is being cancelled, so it cannot {request}.",
        "Wait until the machine has stopped.",
        job="text",
        request="text",
    ),
    "job.claim-returned": entry(
        "The claim was returned. {reason}",
        reason="message",
    ),
    "job.claimed": entry(
        "Claimed.",
    ),
    "job.claimed-to-confirm": entry(
        "Claimed; waits for the operator's confirmation.",
    ),
    "job.compile-cancelled": entry(
        "The compile was cancelled.",
    ),
    "job.compile-crashed": entry(
        "Internal error while compiling: {reason}. Nothing was cut.",
        "The server's log has the details.",
        reason="text",
    ),
    "job.compile-started": entry(
        "Attempt {attempt} to compile the job.",
        attempt="count",
    ),
    "job.compiles-died": entry(
        "{attempts} compiles of the job died, the last in stage {stage}.",
        "Send a smaller drawing, or report this one as a bug.",
        attempts="count",
        stage="text",
    ),
    "job.confirmed-sheet": entry(
        "Confirmed: new sheet, board {board}.",
        board="text",
    ),
    "job.confirmed-table": entry(
        "Confirmed: table clear, board {board}.",
        board="text",
    ),
    "job.copy-done": entry(
        "Copy {copy} of {copies} is done.",
        copy="count",
        copies="count",
    ),
    "job.copy-done-next-sheet": entry(
        "Copy {copy} of {copies} is done: put a new sheet on the table.",
        copy="count",
        copies="count",
    ),
    "job.declared-finished": entry(
        "Declared finished at line {line} of {lines}.",
        line="count",
        lines="count",
    ),
    "job.executed": entry(
        "Every line was executed.",
    ),
    "job.fully-executed": entry(
        "Job {job} was executed to its last line ({lines}), so it is not queued again.",
        "Look at the table. Mark the job finished if the sheet is complete, otherwise scrap it.",
        job="text",
        lines="count",
    ),
    "job.gateway-fell-silent": entry(
        "The gateway {gateway} fell silent.",
        gateway="text",
    ),
    "job.gateway-lost": entry(
        "The gateway {gateway} fell silent. The machine may have executed more lines than it "
        "reported.",
        gateway="text",
    ),
    "job.gateway-silent": entry(
        "The gateway {gateway} that claimed job {job} does not answer.",
        "Switch on the machine and its gateway, then confirm when the job waits again.",
        gateway="text",
        job="text",
    ),
    "job.held-before-start": entry(
        "Held before the first line.",
    ),
    "job.interrupted": entry(
        "Interrupted at line {line} of {lines}{copy}. {cause}",
        "{cause:hint} Look at the table. Queue the job again to cut a new sheet from the "
        "first line, mark it finished if the sheet is complete, or scrap it.",
        line="count",
        lines="count",
        copy="message?",
        cause="message",
    ),
    "job.interrupted-at-end": entry(
        "Interrupted at line {line} of {lines}{copy}. {cause}",
        "{cause:hint} Look at the table. Mark the job finished if the sheet is complete, "
        "otherwise scrap it.",
        line="count",
        lines="count",
        copy="message?",
        cause="message",
    ),
    "job.interrupted-between-copies": entry(
        "Interrupted after copy {copy} of {copies}, before a line of the next. {cause}",
        "{cause:hint} Look at the table. Queue the job again for the remaining copies, mark "
        "it finished, or scrap it.",
        copy="count",
        copies="count",
        cause="message",
    ),
    "job.late-report": entry(
        "Reported late: {report}",
        report="message",
    ),
    "job.no-confirmation-awaited": entry(
        "Job {job} is {state}, so it waits for no confirmation.",
        "{advice}",
        job="text",
        state="text",
        advice="message",
    ),
    "job.no-sheet-awaited": entry(
        "Job {job} is held, not waiting for a sheet.",
        "Resume it.",
        job="text",
    ),
    "job.no-work": entry(
        "There is nothing to make in this drawing: every edge is ignored.",
        "Give at least one edge a line type that the machine makes.",
    ),
    "job.not-confirmed": entry(
        "Job {job} was started without a confirmation of its sheet.",
        "Check the table, then confirm the job or cancel it.",
        job="text",
    ),
    "job.not-running": entry(
        "Job {job} is {state}; no machine runs it.",
        "Claim it first.",
        job="text",
        state="text",
    ),
    "job.not-taken": entry(
        "Job {job} is queued, and its machine {machine} has not taken it yet.",
        "Confirm it when its turn has come; its reason states what it waits for.",
        job="text",
        machine="text",
    ),
    "job.nothing-sent": entry(
        "The gateway sent nothing to the machine.",
    ),
    "job.nothing-to-confirm": entry(
        "Job {job} is running.",
        "There is nothing to confirm.",
        job="text",
    ),
    "job.of-copy": entry(
        " of copy {copy} of {copies}",
        copy="count",
        copies="count",
    ),
    "job.ordered": entry(
        "Ordered.",
    ),
    "job.other-board": entry(
        "Job {job} is for the board {board}, not {given}.",
        "Put {board} on the table.",
        job="text",
        board="text",
        given="text",
    ),
    "job.program-refused": entry(
        "The program does not cut what was drawn: {findings: }{more}",
        "Change the drawing, the line types or the board; nothing was cut.",
        findings="messages",
        more="message?",
    ),
    "job.released": entry(
        "Released.",
    ),
    "job.released-by-order": entry(
        "Released, as its order requested.",
    ),
    "job.requeued": entry(
        "Queued again.",
    ),
    "job.scrapped": entry(
        "Scrapped.",
    ),
    "job.stale-epoch": entry(
        "This gateway no longer owns job {job}, which is {state} (epoch {epoch}; it is in epoch "
        "{current} now).",
        "Stop the machine and claim again.",
        job="text",
        state="text",
        current="count",
        epoch="count",
    ),
    "job.started": entry(
        "Started.",
    ),
    "job.started-unconfirmed": entry(
        "Started without the operator's confirmation.",
    ),
    "job.unknown": entry("There is no job {job}.", "GET /api/jobs lists them.", job="text"),
    "job.verified": entry(
        "Compiled and verified.",
    ),
    "job.worker-silent": entry(
        "The worker {worker} stopped responding in stage {stage}.",
        worker="text",
        stage="text",
    ),
    "job.wrong-state": entry(
        "Job {job} is {state}, so it cannot become {goal}.",
        "{advice}",
        job="text",
        state="text",
        goal="text",
        advice="message",
    ),
    "job.wrong-state-for-request": entry(
        "Job {job} is {state}; the request {request} is for a job that is {states: or }.",
        "{advice}",
        job="text",
        state="text",
        request="text",
        states="texts",
        advice="message",
    ),
    "advice.compiling": entry("Wait until it is ready."),
    "advice.ended": entry("Order it again."),
    "advice.interrupted": entry(
        "Check the table, then mark the job finished, queue it again or scrap it.",
    ),
    "advice.of-reason": entry(
        "{reason:hint}",
        reason="message",
    ),
    "advice.queued": entry("Wait until its machine has taken it."),
    "advice.ready": entry("Release it first."),
    "advice.running": entry("Hold, resume or cancel it."),
    "machine.busy": entry(
        "Job {job} is on the table of {machine}.",
        "One job at a time: finish it, queue it again or scrap it.",
        job="text",
        machine="text",
    ),
    "machine.busy-with-another": entry(
        "Another job is on the table of {machine}.",
        "One job at a time: finish it, queue it again or scrap it.",
        machine="text",
    ),
    "machine.no-cutter": entry(
        "{machine} has no cutter {cutter!r}: none of its tools is a rotating cutter or a laser.",
        "Choose a machine with a rotating cutter or a laser; only these can be calibrated.",
        machine="text",
        cutter="text",
    ),
    "machine.no-such-cutter": entry(
        "{machine} has no cutter {cutter!r}.",
        "Choose one of {known:, }.",
        machine="text",
        cutter="text",
        known="texts",
    ),
    "store.no-column": entry(
        "The {kind} {id} has no {column} yet.",
        "Wait until it is compiled; its state and reason show why it may have failed.",
        kind="text",
        id="text",
        column="text",
    ),
    "store.unknown": entry(
        "The {kind} {id} does not exist.",
        "Choose one that GET /api/{kind}s lists.",
        kind="text",
        id="text",
    ),
    "worker.died": entry(
        "The process that computed the drawing ended unexpectedly (exit code {code}), probably "
        "because the memory was full.",
        "Send a smaller drawing, or split this one.",
        code="text",
    ),
    "worker.memory": entry(
        "The drawing needs more than {limit} GB of memory, the limit for one drawing.",
        "Send a smaller drawing, or split this one.",
        limit="count",
    ),
    "worker.timeout": entry(
        "The stage {stage} took longer than {seconds:.0f} s.",
        "Send a smaller drawing, or split this one.",
        stage="text",
        seconds="number",
    ),
    "database.bad-url": entry(
        "{url!r} is not the URL of a database.",
        "Write sqlite:///FILE or postgresql://USER@HOST/NAME.",
        url="text",
    ),
    "database.in-memory": entry(
        "A database in memory cannot be used, because its jobs would be lost when the server "
        "stops.",
        "Name a file: sqlite:///FILE.",
    ),
}
