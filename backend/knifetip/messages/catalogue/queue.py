"""queue: messages about the queue of a machine, and about the life of its tools."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "queue.changed": entry(
        "The queue of {machine} has changed since it was displayed, so the job was not moved.",
        "Check the new order of the queue, and move the job again if necessary.",
        machine="text",
    ),
    "queue.claimed": entry(
        "The machine {machine} has taken job {job} from the queue, so its place and its copies "
        "cannot be changed.",
        "If the job is not confirmed yet, put it on hold: it then returns to the queue.",
        job="text",
        machine="text",
    ),
    "queue.copies-changed": entry(
        "The operator changed the number of copies from {former} to {copies}.",
        former="count",
        copies="count",
    ),
    "queue.copies-done": entry(
        "{done:# copy|# copies} of job {job} are complete, so the number of copies must be "
        "greater.",
        "Enter a number greater than {done}, or cancel the job.",
        job="text",
        done="count",
    ),
    "queue.does-not-fit": entry(
        "Job {job} was not moved to {machine}. {reason}",
        "{reason:hint}",
        job="text",
        machine="text",
        reason="message",
    ),
    "queue.let-go": entry(
        "The operator ended the hold of the job in the queue.",
    ),
    "queue.moved-after": entry(
        "The operator moved the job to the end of the queue, after job {after}.",
        after="text",
    ),
    "queue.moved-before": entry(
        "The operator moved the job to the head of the queue, before job {before}.",
        before="text",
    ),
    "queue.moved-between": entry(
        "The operator moved the job in the queue: between job {after} and job {before}.",
        after="text",
        before="text",
    ),
    "queue.no-neighbour": entry(
        "Job {job} cannot be moved next to job {neighbour}, which does not wait for {machine}.",
        "Look at the present queue. Name jobs that wait for the machine and are not claimed.",
        job="text",
        neighbour="text",
        machine="text",
    ),
    "queue.not-waiting": entry(
        "Job {job} is {state} and does not wait, so it cannot be changed in the queue.",
        "{advice}",
        job="text",
        state="text",
        advice="message",
    ),
    "queue.priority-changed": entry(
        "The priority of the job changed from {former} to {priority}.",
        former="count",
        priority="count",
    ),
    "queue.put-on-hold": entry(
        "The operator put the job on hold in the queue.",
    ),
    "queue.transferred": entry(
        "The operator moved the job from {former} to {machine}. Its program was compiled again.",
        former="text",
        machine="text",
    ),
    "tool-life.near": entry(
        "The tool {name} in station {station} has worked along {used:.0f} m of lines, "
        "{percent:.0f} % of its life of {life:.0f} m.",
        "Have a new tool ready. Record the change of the tool on the page of the machine.",
        name="text",
        station="count",
        used="number",
        life="number",
        percent="number",
    ),
    "tool-life.no-station": entry(
        "The machine {machine} has no station {station}.",
        "Use the number of a station from the list of the tools of the machine.",
        machine="text",
        station="count",
    ),
    "tool-life.over": entry(
        "The tool {name} in station {station} has worked along {used:.0f} m of lines, "
        "{percent:.0f} % of its life of {life:.0f} m.",
        "Change the tool and record the change, or check the tool and state why it stays in use "
        "when you confirm the job.",
        name="text",
        station="count",
        used="number",
        life="number",
        percent="number",
    ),
}
