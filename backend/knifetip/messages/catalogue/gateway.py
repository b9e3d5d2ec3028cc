"""gateway: messages that a gateway reports at the end of a job, to give the reason for the end."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "gateway.cancelled": entry(
        "The operator cancelled the job at program line {line}.",
        line="count",
    ),
    "gateway.controller-not-idle": entry(
        "{name} is not idle: it reports the state {state}.",
        "Wait until the controller is idle, or reset the controller at the table.",
        name="text",
        state="text",
    ),
    "gateway.outdated-machine": entry(
        "The gateway {gateway} uses version {version} of the machine {machine}, whose newest "
        "version is {newest}.",
        "Load the definition of the machine again, or restart the gateway.",
        gateway="text",
        machine="text",
        version="count",
        newest="count",
    ),
    "gateway.job-withdrawn": entry(
        "The server withdrew the job from the gateway (the program that sends jobs to the "
        "machine), and the machine was stopped.",
        "Check the table and the board on it.",
    ),
    "gateway.job-withdrawn-before-start": entry(
        "The server withdrew the job from the gateway before the job was started. Nothing was "
        "sent to the machine.",
    ),
    "gateway.server-silent-before-start": entry(
        "The server did not answer before the program was to begin. Nothing was sent to the "
        "machine.",
        "Check the network connection of the gateway.",
    ),
    "gateway.switched-off-before-begin": entry(
        "The gateway (the program that sends jobs to the machine) was switched off before the "
        "program was begun. No line of it was executed.",
    ),
    "gateway.access-refused": entry(
        "The server {server} refuses this gateway: {reason}",
        "Create a key with knifetip key create NAME --scope gateway, give it to the gateway with "
        "--key-file PATH, and start the gateway again.",
        server="text",
        reason="text",
    ),
    "gateway.machine-changed": entry(
        "Version {version} of the machine {machine} is no longer the newest.",
        "Load the definition of the machine again.",
        machine="text",
        version="count",
    ),
    "gateway.not-claimed": entry(
        "The job {job} was not claimed with this key, so its program is not given out.",
        "Claim the job first.",
        job="text",
    ),
    "gateway.no-reason": entry(
        "The gateway (the program that sends jobs to the machine) ended the job without "
        "stating a reason.",
        "Look for the cause in the log of the gateway.",
    ),
    "gateway.started-in-dry-run": entry(
        "The job was started while the machine was making a dry run above the board. Nothing of "
        "the job was sent to the machine.",
        "Queue the job again, and start it when the machine is at rest.",
    ),
    "gateway.switched-off": entry(
        "The gateway (the program that sends jobs to the machine) was stopped.",
    ),
    "gateway.switched-off-before-report": entry(
        "The machine finished the job, but the gateway (the program that sends jobs to the "
        "machine) was stopped before the result was reported.",
    ),
    "gateway.switched-off-in-run": entry(
        "The gateway (the program that sends jobs to the machine) was stopped while the "
        "machine executed the job. The gateway then sent the machine the command to stop.",
        "Check the table, then start the gateway again.",
    ),
    "gateway.system-error": entry(
        "The operating system on the computer of the gateway reports an error: {reason}.",
        "Correct the cause of the error on this computer, then start the gateway again.",
        reason="text",
    ),
}
