"""job: messages about jobs, the machines that run them, and the processes that compile them."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "job.action-requested": entry(
        "The operator requested the action {action}.",
        action="text",
    ),
    "job.at-line": entry(
        "The program is at line {line}.",
        line="count",
    ),
    "job.awaits-kernels": entry(
        "The job waits until the functions for the machine {machine} are compiled. This "
        "happens once after an installation.",
        "Wait. The job starts automatically when the functions are compiled.",
        machine="text",
    ),
    "job.being-cancelled": entry(
        "Job {job} is being cancelled.",
        "Wait until the machine has stopped.",
        job="text",
    ),
    "job.cancelled": entry(
        "The job was cancelled.",
    ),
    "job.cancelled-before-request": entry(
        "Job {job} is being cancelled, so the request {request} is not possible.",
        "Wait until the machine has stopped.",
        job="text",
        request="text",
    ),
    "job.claim-returned": entry(
        "The gateway returned the job to the queue. {reason}",
        reason="message",
    ),
    "job.claimed": entry(
        "The gateway claimed the job.",
    ),
    "job.claimed-to-confirm": entry(
        "The gateway claimed the job, which now waits for the confirmation of the operator.",
    ),
    "job.compile-cancelled": entry(
        "The compilation of the job was cancelled.",
    ),
    "job.compile-crashed": entry(
        "Internal error while compiling: {reason}. Nothing was cut.",
        "Report the error with the log of the server.",
        reason="text",
    ),
    "job.compile-started": entry(
        "Attempt {attempt} to compile the job has started.",
        attempt="count",
    ),
    "job.compiles-died": entry(
        "The process that compiles the job ended unexpectedly {attempts} times, the last time "
        "in the stage {stage}.",
        "Send a smaller drawing, or report the error with the drawing.",
        attempts="count",
        stage="text",
    ),
    "job.confirmed-sheet": entry(
        "The operator confirmed that a new sheet of board {board} is on the table.",
        board="text",
    ),
    "job.confirmed-table": entry(
        "The operator confirmed that the table is clear and that the board is {board}.",
        board="text",
    ),
    "job.copy-done": entry(
        "Copy {copy} of {copies} is finished.",
        copy="count",
        copies="count",
    ),
    "job.copy-done-next-sheet": entry(
        "Copy {copy} of {copies} is finished. The next copy needs a new sheet.",
        "Put a new sheet on the table.",
        copy="count",
        copies="count",
    ),
    "job.declared-finished": entry(
        "The operator marked the job as finished at line {line} of {lines}.",
        line="count",
        lines="count",
    ),
    "job.executed": entry(
        "Every line of the program was executed.",
    ),
    "job.fully-executed": entry(
        "Job {job} was executed to its last line ({lines}), so it cannot be queued again.",
        "Look at the table. Mark the job finished if the sheet is complete, otherwise scrap it.",
        job="text",
        lines="count",
    ),
    "job.gateway-fell-silent": entry(
        "The gateway {gateway} stopped responding.",
        "Check the gateway and its network connection.",
        gateway="text",
    ),
    "job.gateway-lost": entry(
        "The gateway {gateway} stopped responding. The machine may have executed more lines "
        "than the gateway reported.",
        "Check the gateway and its network connection.",
        gateway="text",
    ),
    "job.gateway-silent": entry(
        "The gateway {gateway}, which claimed job {job}, does not respond.",
        "Switch on the machine and its gateway, then confirm the job when it waits for "
        "confirmation again.",
        gateway="text",
        job="text",
    ),
    "job.held-before-start": entry(
        "The job is held before its first line.",
    ),
    "job.interrupted": entry(
        "The job was interrupted at line {line} of {lines}{copy}. {cause}",
        "{cause:hint} Check the table. Then queue the job again to cut a new sheet from the "
        "first line, mark the job finished if the sheet is complete, or scrap the job.",
        line="count",
        lines="count",
        copy="message?",
        cause="message",
    ),
    "job.interrupted-at-end": entry(
        "The job was interrupted at line {line} of {lines}{copy}. {cause}",
        "{cause:hint} Check the table. Mark the job finished if the sheet is complete, "
        "otherwise scrap it.",
        line="count",
        lines="count",
        copy="message?",
        cause="message",
    ),
    "job.interrupted-between-copies": entry(
        "The job was interrupted after copy {copy} of {copies}, before the first line of the "
        "next copy. {cause}",
        "{cause:hint} Check the table. Then queue the job again for the remaining copies, mark "
        "it finished, or scrap it.",
        copy="count",
        copies="count",
        cause="message",
    ),
    "job.late-report": entry(
        "The gateway reported late: {report}",
        report="message",
    ),
    "job.no-confirmation-awaited": entry(
        "Job {job} is {state}, so it does not wait for a confirmation.",
        "{advice}",
        job="text",
        state="text",
        advice="message",
    ),
    "job.no-sheet-awaited": entry(
        "Job {job} is held, but it does not wait for a new sheet.",
        "Resume the job.",
        job="text",
    ),
    "job.no-work": entry(
        "The drawing contains nothing to cut, crease or groove: every edge is ignored.",
        "Give at least one edge a line type for which the machine has a tool.",
    ),
    "job.not-confirmed": entry(
        "Job {job} was started without a confirmation of its sheet.",
        "Check the table, then confirm the job or cancel it.",
        job="text",
    ),
    "job.not-running": entry(
        "Job {job} is {state}, so no machine executes it.",
        "Claim the job first.",
        job="text",
        state="text",
    ),
    "job.not-taken": entry(
        "Job {job} is queued, and its machine {machine} has not claimed it yet.",
        "Confirm the job after the machine has claimed it. The reason in the job shows what "
        "the job waits for.",
        job="text",
        machine="text",
    ),
    "job.nothing-sent": entry(
        "The gateway sent nothing to the machine.",
    ),
    "job.nothing-to-confirm": entry(
        "Job {job} is running, so there is nothing to confirm.",
        "Hold or cancel the job if the machine must stop.",
        job="text",
    ),
    "job.of-copy": entry(
        " of copy {copy} of {copies}",
        copy="count",
        copies="count",
    ),
    "job.ordered": entry(
        "The job was ordered.",
    ),
    "job.other-board": entry(
        "Job {job} is for the board {board}, not {given}.",
        "Put {board} on the table.",
        job="text",
        board="text",
        given="text",
    ),
    "job.program-refused": entry(
        "The program does not match the drawing, so nothing was cut: {findings: }{more}",
        "Change the drawing, the line types or the board.",
        findings="messages",
        more="message?",
    ),
    "job.released": entry(
        "The job was released.",
    ),
    "job.released-by-order": entry(
        "The job was released automatically, as requested in its order.",
    ),
    "job.requeued": entry(
        "The job was queued again.",
    ),
    "job.scrapped": entry(
        "The job was scrapped.",
    ),
    "job.stale-epoch": entry(
        "Another claim of job {job} has replaced the claim of this gateway: the job is {state} "
        "and in epoch {current}, but the request names epoch {epoch}.",
        "Stop the machine and claim the job again.",
        job="text",
        state="text",
        current="count",
        epoch="count",
    ),
    "job.started": entry(
        "The job was started.",
    ),
    "job.started-unconfirmed": entry(
        "The job was started without the confirmation of the operator.",
    ),
    "job.unknown": entry(
        "Job {job} does not exist.",
        "Choose one of the jobs that GET /api/jobs lists.",
        job="text",
    ),
    "job.verified": entry(
        "The job was compiled and verified.",
    ),
    "job.worker-silent": entry(
        "The process {worker}, which compiles the job, stopped responding in the stage {stage}.",
        "Report the error with the log of the server if it happens again.",
        worker="text",
        stage="text",
    ),
    "job.wrong-state": entry(
        "Job {job} is {state}, so its state cannot become {goal}.",
        "{advice}",
        job="text",
        state="text",
        goal="text",
        advice="message",
    ),
    "job.wrong-state-for-request": entry(
        "Job {job} is {state}, but the request {request} needs a job that is {states: or }.",
        "{advice}",
        job="text",
        state="text",
        request="text",
        states="texts",
        advice="message",
    ),
    "advice.compiling": entry(
        "Wait until the job is compiled.",
    ),
    "advice.ended": entry(
        "Order the job again.",
    ),
    "advice.interrupted": entry(
        "Check the table, then mark the job finished, queue it again or scrap it.",
    ),
    "advice.of-reason": entry(
        "{reason:hint}",
        reason="message",
    ),
    "advice.queued": entry(
        "Wait until the machine of the job has claimed it.",
    ),
    "advice.ready": entry(
        "Release the job first.",
    ),
    "advice.running": entry(
        "Hold, resume or cancel the job.",
    ),
    "machine.busy": entry(
        "Job {job} already occupies the table of {machine}.",
        "Finish that job, queue it again or scrap it, because a machine can process only one "
        "job at a time.",
        job="text",
        machine="text",
    ),
    "machine.busy-with-another": entry(
        "Another job already occupies the table of {machine}.",
        "Finish that job, queue it again or scrap it, because a machine can process only one "
        "job at a time.",
        machine="text",
    ),
    "machine.no-cutter": entry(
        "{machine} has no cutter {cutter!r}: none of its tools is a rotating cutter or a laser.",
        "Choose a machine with a rotating cutter or a laser, because only these tools can be "
        "calibrated.",
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
        "Wait until it is compiled. If compilation failed, its state and reason show why.",
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
        "because it used too much memory.",
        "Send a smaller drawing, or split this one.",
        code="text",
    ),
    "worker.memory": entry(
        "The drawing needs more than the {limit} GB of memory that are allowed for one drawing.",
        "Send a smaller drawing, or split this one.",
        limit="count",
    ),
    "worker.timeout": entry(
        "Processing the drawing took longer than {seconds:.0f} s in the stage {stage}.",
        "Send a smaller drawing, or split this one.",
        stage="text",
        seconds="number",
    ),
    "database.bad-url": entry(
        "{url!r} is not the URL of a database.",
        "Write the URL as sqlite:///FILE or postgresql://USER@HOST/NAME.",
        url="text",
    ),
    "database.in-memory": entry(
        "The server cannot use an in-memory database, because all jobs would be lost when the "
        "server stops.",
        "Use a database file: sqlite:///FILE.",
    ),
}
