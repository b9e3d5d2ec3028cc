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
        "The machine is at program line {line}.",
        line="count",
    ),
    "job.awaits-kernels": entry(
        "The job waits until the server has compiled the software modules that the machine "
        "{machine} needs. The server does this once after an installation.",
        "Wait. The job continues automatically.",
        machine="text",
    ),
    "job.being-cancelled": entry(
        "Job {job} is already being cancelled.",
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
    "job.check-refused": entry(
        "The program was not begun, so the job was returned to the queue: {reason}",
        reason="message",
    ),
    "job.checked": entry(
        "The operator checked at the machine: {checks:; }.",
        checks="messages",
    ),
    "job.nothing-refused": entry(
        "Job {job} is {state}, and no machine has refused its program, so there is nothing to try "
        "again.",
        job="text",
        state="text",
    ),
    "job.rechecked": entry("The operator let the machine check the job again."),
    "job.claim-returned": entry(
        "The gateway put the job back into the queue. {reason}",
        reason="message",
    ),
    "job.changed": entry(
        "Job {job} was changed since you read it.",
        "Read the job again, and repeat the change if it is still necessary.",
        job="text",
    ),
    "job.claimed": entry(
        "The gateway of the machine took the job from the queue (claimed it).",
    ),
    "job.claimed-to-confirm": entry(
        "The gateway of the machine took the job from the queue. The job now waits for the "
        "confirmation of the operator.",
    ),
    "job.compile-cancelled": entry(
        "The compilation of the job was cancelled.",
    ),
    "job.compile-crashed": entry(
        "Internal error {incident} while compiling. Nothing was cut.",
        "Report the error with the log of the server, which contains its cause under this number.",
        incident="text",
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
        "The operator confirmed that the table is clear and that the board on it is {board}.",
        board="text",
    ),
    "job.copy-done": entry(
        "Copy {copy} of {copies} of the job is finished.",
        copy="count",
        copies="count",
    ),
    "job.copy-done-next-sheet": entry(
        "Copy {copy} of {copies} of the job is finished. The next copy needs a new sheet of board.",
        "Put a new sheet of board on the table, then confirm the new sheet on the page of the "
        "job. The machine then starts the next copy.",
        copy="count",
        copies="count",
    ),
    "job.declared-finished": entry(
        "The operator marked the job as finished, after the machine had stopped at program "
        "line {line} of {lines}.",
        line="count",
        lines="count",
    ),
    "job.details-changed": entry(
        "The details of the order were changed.",
    ),
    "job.exceptions-accepted": entry(
        "{by} accepted {count:# shortfall|# shortfalls}: {reason}",
        by="text",
        count="count",
        reason="text",
    ),
    "job.executed": entry(
        "The machine executed every line of the program.",
    ),
    "job.fully-executed": entry(
        "The machine executed job {job} to its last program line ({lines}), so the job cannot "
        "be queued again.",
        "Check the table. Mark the job finished if the sheet is complete, otherwise scrap the job.",
        job="text",
        lines="count",
    ),
    "job.gateway-lost": entry(
        "The gateway {gateway} stopped responding.",
        "Check the computer of the gateway and its network connection.",
        gateway="text",
    ),
    "job.gateway-silent": entry(
        "The gateway {gateway}, which claimed job {job}, does not respond.",
        "Switch on the machine and start its gateway. Confirm the job when it waits for a "
        "confirmation again.",
        gateway="text",
        job="text",
    ),
    "job.held-before-start": entry(
        "The operator paused the job before the machine executed the first program line. The "
        "machine starts when the operator confirms the job again.",
    ),
    "job.interrupted": entry(
        "The job was interrupted at program line {line} of {lines}. {cause} {copy}",
        "{cause:hint} Check the table. If the sheet has not moved, continue it: only the tracks "
        "that are left are made. Otherwise queue the job again (a new sheet is cut from the first "
        "program line), or mark the job finished if the sheet is complete, or scrap the job.",
        line="count",
        lines="count",
        copy="message?",
        cause="message",
    ),
    "job.interrupted-in-first-line": entry(
        "The job was interrupted before its first program line of {lines} was complete. It is not "
        "known whether the machine has moved. {cause} {copy}",
        "{cause:hint} Check the table. If the sheet is untouched and has not moved, continue it "
        "or queue the job again. Otherwise scrap the job.",
        lines="count",
        copy="message?",
        cause="message",
    ),
    "job.interrupted-unobserved": entry(
        "The job was interrupted at program line {line} of {lines} or later: {most}. {cause} "
        "{copy}",
        "{cause:hint} Look at the sheet: it shows which tracks are made. To continue it, state "
        "for each track that is not known whether it is made.",
        line="count",
        lines="count",
        most="message",
        copy="message?",
        cause="message",
    ),
    "job.machine-not-free": entry(
        "Job {job} cannot start, because its machine takes no job now. {reason}",
        "{reason:hint}",
        job="text",
        reason="message",
    ),
    "job.may-have-ended": entry(
        "nobody observed the machine then, so it may have executed the program to its end",
    ),
    "job.may-have-gone-on": entry(
        "nobody observed the machine then, so it may have executed lines up to line {line}",
        line="count",
    ),
    "job.interrupted-at-end": entry(
        "The job was interrupted at program line {line} of {lines}. {cause} {copy}",
        "{cause:hint} Check the table. Mark the job finished if the sheet is complete, otherwise "
        "scrap the job.",
        line="count",
        lines="count",
        copy="message?",
        cause="message",
    ),
    "job.interrupted-between-copies": entry(
        "The job was interrupted after copy {copy} of {copies}, before the first program line "
        "of the next copy. {cause}",
        "{cause:hint} Check the table. Then either queue the job again for the remaining "
        "copies, or mark the job finished, or scrap it.",
        copy="count",
        copies="count",
        cause="message",
    ),
    "job.late-report": entry(
        "A late report of the gateway arrived: {report}",
        report="message",
    ),
    "job.needs-end": entry(
        "The whole program of job {job} was sent to the machine, which does not report when it has "
        "finished, so there is nothing to resume.",
        "When the machine has finished and is at rest, confirm this on the station page or with "
        "POST /api/jobs/{job}/end.",
        job="text",
    ),
    "job.needs-sheet": entry(
        "Job {job} waits for a new sheet, so it cannot be resumed.",
        "Put a new sheet on the table, make the checks at the machine, then confirm the job.",
        job="text",
    ),
    "job.no-confirmation-awaited": entry(
        "Job {job} is {state}, so it does not wait for a confirmation.",
        "{advice}",
        job="text",
        state="text",
        advice="message",
    ),
    "job.no-end-awaited": entry(
        "Job {job} is {state}, and its machine does not wait for a person to confirm the end of a "
        "program.",
        "The page of the job shows what the job waits for.",
        job="text",
        state="text",
    ),
    "job.no-sheet-awaited": entry(
        "Job {job} is on hold, but it does not wait for a new sheet.",
        "Resume the job.",
        job="text",
    ),
    "job.no-shortfalls": entry(
        "The shortfalls of job {job} cannot be accepted, because the job is not refused, or was "
        "also refused for another reason.",
        "Check the fields state and reason of the job, and correct this other reason first.",
        job="text",
    ),
    "job.verdict-changed": entry(
        "The verdict on job {job} has changed since it was read.",
        "Read the verdict again, then repeat the request.",
        job="text",
    ),
    "job.no-work": entry(
        "The drawing contains nothing that the machine can make: every edge is too short for its "
        "tool, or in a place that the cutter does not enter.",
        "Check the unit of the drawing and the line types of its edges. Otherwise choose another "
        "machine or machine file: a smaller creasing wheel for short creases, a thinner cutter or "
        "a knife for narrow contours.",
    ),
    "job.not-checked": entry(
        "The confirmation of job {job} leaves out what must be checked at the machine: "
        "{missing:; }.",
        "Make these checks at the machine, then confirm the job with all of them in `checked`.",
        job="text",
        missing="messages",
    ),
    "job.not-confirmed": entry(
        "Job {job} was started, although the operator has not confirmed that the table is ready.",
        "Check the table, then confirm the job or cancel it.",
        job="text",
    ),
    "job.not-running": entry(
        "The report was not accepted, because job {job} is {state} and not running on a machine.",
        "Claim the job with the gateway first, and report on it only while it is running.",
        job="text",
        state="text",
    ),
    "job.not-taken": entry(
        "Job {job} is queued, and the gateway of its machine {machine} has not claimed it yet.",
        "Confirm the job after the gateway has claimed it. The field reason of the job shows "
        "what the job waits for.",
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
        "This happened in copy {copy} of {copies}.",
        copy="count",
        copies="count",
    ),
    "job.ordered": entry(
        "The job was created.",
    ),
    "job.other-phase": entry(
        "Job {job} has continued since the request was prepared, so the request no longer applies.",
        "Check what the job waits for, then resume it if the machine may continue.",
        job="text",
    ),
    "job.outdated": entry(
        "The program of job {job} is out of date: {changes:; }.",
        "Compile the job again. Its program is then made and verified for the present machine and "
        "board.",
        job="text",
        changes="messages",
    ),
    "job.recompiled": entry(
        "The operator had the job compiled again for the present machine and board.",
    ),
    "job.program-has-shortfalls": entry(
        "The tools cannot make every line as it is drawn: {findings: } {more}",
        "Accept these shortfalls for this job, or change the drawing, the line types of its "
        "edges, the tools or the board.",
        findings="messages",
        more="message?",
    ),
    "job.program-refused": entry(
        "The program does not match the drawing, so nothing was cut: {findings: } {more}",
        "Choose another machine or board, change the drawing, or set the line types of these "
        "edges to ignored and make them by hand.",
        findings="messages",
        more="message?",
    ),
    "job.released": entry(
        "The operator released the job, so it is queued for its machine.",
    ),
    "job.released-by-order": entry(
        "The job was released automatically, as its order requested, so it is queued for its "
        "machine.",
    ),
    "job.requeued": entry(
        "The operator queued the job again.",
    ),
    "job.scrapped": entry(
        "The operator scrapped the job.",
    ),
    "job.stale-epoch": entry(
        "Job {job} was claimed again, so the claim of this gateway is no longer valid. The job "
        "is {state}. Its valid claim has the epoch (claim number) {current}, but the request "
        "names epoch {epoch}.",
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
    "job.stated-by-feed": entry(
        "The automatic sheet feed confirmed: {checks:; }.",
        checks="messages",
    ),
    "job.unknown": entry(
        "Job {job} does not exist.",
        "Choose one of the jobs that GET /api/jobs lists.",
        job="text",
    ),
    "job.answered": entry(
        "The job uses the verified program of job {job}, which has the same drawing, machine and "
        "options.",
        job="text",
    ),
    "job.unknown-checks": entry(
        "Job {job} has no check {unknown:, }.",
        "Its checks are {known:, }.",
        job="text",
        unknown="texts",
        known="texts",
    ),
    "job.verified": entry(
        "The job was compiled, and its program was verified.",
    ),
    "job.tool-changed": entry(
        "The operator put a new tool into station {station} ({name}). The old tool had worked "
        "along {used:.0f} m of lines.",
        station="count",
        name="text",
        used="number",
    ),
    "job.worker-silent": entry(
        "The process {worker}, which compiles the job, stopped responding in the stage {stage}.",
        "Report the error with the log of the server if it happens again.",
        worker="text",
        stage="text",
    ),
    "job.worn-tools": entry(
        "Job {job} uses tools at the end of their lives: {tools: }",
        "Put new tools into these stations and confirm the job with the numbers of the stations "
        "that were changed, or state why the tools stay in use.",
        job="text",
        tools="messages",
    ),
    "job.worn-tools-used": entry(
        "The operator uses tools at the end of their lives: {tools: } Reason: {reason}",
        tools="messages",
        reason="text",
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
        "Wait until the gateway of the machine has claimed the job.",
    ),
    "advice.ready": entry(
        "Release the job first.",
    ),
    "advice.running": entry(
        "Hold, resume or cancel the job.",
    ),
    "machine.busy": entry(
        "Job {job} already occupies the table of {machine}.",
        "Wait until that job has ended. If that job is interrupted, choose what to do with it: "
        "mark as finished, queue again or scrap.",
        job="text",
        machine="text",
    ),
    "machine.busy-with-another": entry(
        "Another job already occupies the table of {machine}.",
        "Wait until that job has ended. If that job is interrupted, choose what to do with it: "
        "mark as finished, queue again or scrap.",
        machine="text",
    ),
    "machine.no-cutter": entry(
        "{machine} has no cutter with the name {cutter!r}, because none of its tools is a "
        "rotating cutter or a laser.",
        "Choose a machine with a rotating cutter or a laser. Only these tools can be calibrated.",
        machine="text",
        cutter="text",
    ),
    "machine.no-such-cutter": entry(
        "{machine} has no cutter with the name {cutter!r}.",
        "Choose one of the cutters {known:, }.",
        machine="text",
        cutter="text",
        known="texts",
    ),
    "worker.died": entry(
        "The process that computed the drawing ended unexpectedly (exit code {code}), probably "
        "because it used too much memory.",
        "Send a smaller drawing, or split the drawing into several drawings.",
        code="text",
    ),
    "worker.memory": entry(
        "The drawing needs more than the {limit} GB of memory that are allowed for one drawing.",
        "Send a smaller drawing, or split the drawing into several drawings.",
        limit="count",
    ),
    "worker.timeout": entry(
        "Processing the drawing took longer than {seconds:.0f} s in the stage {stage}.",
        "Send a smaller drawing, or split the drawing into several drawings.",
        stage="text",
        seconds="number",
    ),
}
