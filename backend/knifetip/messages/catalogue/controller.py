"""controller: messages about the controller of a machine and the connection to it."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "controller.alarm": entry(
        "{name} stopped with ALARM:{code}: {alarm}{due}.",
        "Check the table and home the machine ($H) before the next job.",
        name="text",
        code="count",
        alarm="message",
        due="message?",
    ),
    "controller.alarm-code": entry("ALARM:{code} ({alarm})", code="count", alarm="message"),
    "controller.alarm-state": entry(
        "{name} reports alarm{due}.",
        "Check the table, then home it ($H) or unlock it ($X).",
        name="text",
        due="message",
    ),
    "controller.alarm-unknown": entry("an alarm"),
    "controller.answer-lost": entry(
        "{name} has reported {state} for {seconds:g} s{due}: an answer was lost on the way.",
        "Check the cable, then the board.",
        name="text",
        state="text",
        seconds="number",
        due="message?",
    ),
    "controller.bad-address": entry(
        "{address!r} is not the address of a controller.",
        "Write host:port, for example 127.0.0.1:2323.",
        address="text",
    ),
    "controller.busy": entry(
        "{name} is busy: it reports {state}.",
        "Wait until it is idle, or reset it at the table; nothing was sent.",
        name="text",
        state="text",
    ),
    "controller.check-end-not-confirmed": entry(
        "{name} did not confirm the end of its check mode within {seconds:g} s.",
        "Check the table, then try again.",
        name="text",
        seconds="number",
    ),
    "controller.closed": entry("The connection to {name} was closed.", name="text"),
    "controller.connection-failed": entry(
        "The connection to {address} is lost ({reason}).",
        "Check the table before anything is sent again.",
        address="text",
        reason="text",
    ),
    "controller.due": entry(
        "; the answer to line {line} ({text}) is due",
        line="count",
        text="text",
    ),
    "controller.lift-not-finished": entry(
        "{name} did not finish its lift within {seconds:g} s.",
        "Lift the tool and raise the stations at the table.",
        name="text",
        seconds="number",
    ),
    "controller.locked": entry(
        "{name} is locked by {cause}: the stations may still be lowered.",
        "Lift the tool and raise the stations at the table, then home ($H) or unlock ($X) it.",
        name="text",
        cause="message",
    ),
    "controller.locked-by-alarm": entry(
        "{name} is locked by an alarm.",
        "Home it ($H) or unlock it ($X) at the table.",
        name="text",
    ),
    "controller.lost": entry(
        "The connection to {name} is lost{due}.",
        "Check the cable, then the board.",
        name="text",
        due="message?",
    ),
    "controller.lost-in-buffer": entry(
        "The connection to {name} is lost.",
        "Check the table: the controller may still execute what is in its buffer.",
        name="text",
    ),
    "controller.not-in-laser-mode": entry(
        "{name} is not in laser mode, so a hold would leave the beam on.",
        "Set $32=1 at the controller and connect again; nothing was sent.",
        name="text",
    ),
    "controller.not-ready": entry(
        "{name} is not ready: it reports {state}.",
        "Wait until it is idle, or unlock it, then send the job again; nothing was sent.",
        name="text",
        state="text",
    ),
    "controller.not-recovered": entry("{name} was not brought into its safe state.", name="text"),
    "controller.not-secured": entry(
        "{name} cannot be brought into its safe state: it reports {state}.",
        "Lift the tool and raise the stations at the table.",
        name="text",
        state="text",
    ),
    "controller.not-stopped": entry(
        "{error} {progress} The machine is not safe: {unsafe}",
        "{unsafe:hint}",
        error="message",
        progress="message",
        unsafe="message",
    ),
    "controller.off-path": entry(
        "The machine was at X{x:.3f} Y{y:.3f} Z{z:.3f}, {distance:.1f} mm off the program's path "
        "near line {line}: a line was changed on its way to the controller, or steps were lost.",
        "Check the cable and home the machine; the board may be spoiled.",
        x="number",
        y="number",
        z="number",
        distance="number",
        line="count",
    ),
    "controller.refused-safe-state": entry(
        "{refusals: }",
        "Lift the tool and raise the stations at the table; compare the machine's file with the "
        "controller's outputs.",
        refusals="messages",
    ),
    "controller.rejected-command": entry(
        "{name} refused {command}: {error} (error:{code}).",
        "Check the table, then try again.",
        name="text",
        command="text",
        error="message",
        code="count",
    ),
    "controller.rejected-in-check": entry(
        "{name} refused line {line} ({text}): {error} (error:{code}).",
        "Nothing has moved: compile the job again for this controller.",
        name="text",
        line="count",
        text="text",
        error="message",
        code="count",
    ),
    "controller.rejected-line": entry(
        "{name} refused line {line} ({text}): {error} (error:{code}).",
        "Check the board, then compile the job again for this controller.",
        name="text",
        line="count",
        text="text",
        error="message",
        code="count",
    ),
    "controller.reports-alarm": entry(
        "{name} reports an alarm.",
        "Check the table, then home or unlock it.",
        name="text",
    ),
    "controller.reset": entry(
        "{name} was reset{due}.",
        "Check the table and home the machine: its position may be lost. Nothing continues by "
        "itself.",
        name="text",
        due="message?",
    ),
    "controller.reset-not-confirmed": entry(
        "{name} did not confirm its reset within {seconds:g} s.",
        "Check the table, then try again.",
        name="text",
        seconds="number",
    ),
    "controller.silent": entry(
        "{name} has not answered for {seconds:g} s{due}.",
        "Check the cable, then the board.",
        name="text",
        seconds="number",
        due="message?",
    ),
    "controller.stopped": entry(
        "{error} {progress} The machine was stopped and lifted to Z {height:.1f}, its stations "
        "were released.",
        "{error:hint}",
        error="message",
        progress="message",
        height="number",
    ),
    "controller.unexpected-answer": entry(
        "{name} answered a line that was not sent from here: an answer was doubled on the way, or "
        "another program sends to the controller.",
        "Check the cable, and close any other program that sends to it.",
        name="text",
    ),
    "controller.unreachable": entry(
        "No controller answers at {address} ({reason}).",
        "Switch it on, or correct the address.",
        address="text",
        reason="text",
    ),
    "controller.was-reset": entry("{name} was reset.", name="text"),
    "run.executed": entry(
        "{executed} of {lines} lines were executed.",
        executed="count",
        lines="count",
    ),
    "run.in-buffer": entry(
        "{executed} of {lines} lines were executed, and up to {rest} more, which were in the "
        "controller's buffer, may have been.",
        executed="count",
        lines="count",
        rest="count",
    ),
    "run.nothing-sent": entry("No line was sent."),
}
