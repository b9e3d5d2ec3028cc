"""gateway: messages about the causes of the end of a job, which a gateway reports."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "gateway.cancelled": entry(
        "Cancelled by the operator at line {line}.",
        line="count",
    ),
    "gateway.controller-not-idle": entry(
        "{name} is not idle: it reports {state}.",
        "Wait until it is idle, or reset it at the table.",
        name="text",
        state="text",
    ),
    "gateway.job-withdrawn": entry(
        "The server took the job back; the machine was stopped.",
    ),
    "gateway.job-withdrawn-before-start": entry(
        "The server took the job back before its start; nothing was sent to the machine.",
    ),
    "gateway.no-reason": entry(
        "The gateway ended the job and stated no reason.",
    ),
    "gateway.switched-off": entry(
        "The gateway was switched off.",
    ),
    "gateway.switched-off-before-report": entry(
        "The gateway was switched off before it could report.",
    ),
    "gateway.switched-off-in-run": entry(
        "The gateway was switched off; the machine was stopped.",
    ),
    "gateway.system-error": entry(
        "The operating system of the gateway reports: {reason}.",
        reason="text",
    ),
}
