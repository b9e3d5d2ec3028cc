"""linuxcnc: messages about LinuxCNC and its remote shell, linuxcncrsh."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "linuxcnc.bad-address": entry(
        "{address!r} is not a valid address of LinuxCNC.",
        "Write HOST:PORT, or linuxcnc://HOST:PORT/?OPTION=VALUE&OPTION=VALUE with the options "
        "{options:, }; values have no blanks.",
        address="text",
        options="texts",
    ),
    "linuxcnc.beyond-travel": entry(
        "Program line {line} would move {axis} to {position:.3f} {unit} in coordinates of the "
        "machine, beyond the limit {limit:.3f} {unit} of LinuxCNC at {name}. Nothing has moved.",
        "Set X Y zero where the whole sheet is within the travel, or place the job elsewhere. If "
        "the machine can move farther, correct MIN_LIMIT and MAX_LIMIT of {axis} in the INI file "
        "of LinuxCNC.",
        name="text",
        line="count",
        axis="text",
        position="number",
        limit="number",
        unit="text",
    ),
    "linuxcnc.cause": entry(
        "LinuxCNC reports: {texts:; }.",
        texts="texts",
    ),
    "linuxcnc.estop": entry(
        "LinuxCNC at {name} is in emergency stop.",
        "Check the table, release the emergency stop button, then press Unlock, or reset the "
        "emergency stop and switch the machine on in LinuxCNC.",
        name="text",
    ),
    "linuxcnc.folder-not-writable": entry(
        "The program file for LinuxCNC cannot be written to the folder {folder} ({reason}).",
        "Create the folder, and permit the user of the gateway to write to it.",
        folder="text",
        reason="text",
    ),
    "linuxcnc.ini-unread": entry(
        "The gateway cannot read the INI file {path} of LinuxCNC at {name}, so it does not compare "
        "limits, velocities and accelerations with the machine file.",
        "Copy the file to the computer of the gateway, and add ini=PATH to the address.",
        name="text",
        path="text",
    ),
    "linuxcnc.lost": entry(
        "The connection to LinuxCNC at {name} is lost. LinuxCNC may still execute its program.",
        "Keep clear of the table until the machine has stopped, or press the emergency stop "
        "button. Then check that LinuxCNC and linuxcncrsh run.",
        name="text",
    ),
    "linuxcnc.machine-off": entry(
        "The machine of LinuxCNC at {name} is switched off.",
        "Check the table, then press Unlock, or switch the machine on in LinuxCNC.",
        name="text",
    ),
    "linuxcnc.not-at-rest": entry(
        "The machine of LinuxCNC at {name} has not come to rest within {seconds:g} s.",
        "Press the emergency stop button if the machine still moves, then check the table.",
        name="text",
        seconds="number",
    ),
    "linuxcnc.not-begun": entry(
        "LinuxCNC at {name} has not begun the program within {seconds:g} s.",
        "Look for a message of LinuxCNC at the machine, then try again.",
        name="text",
        seconds="number",
    ),
    "linuxcnc.not-homed": entry(
        "The machine of LinuxCNC at {name} is not homed (joints {joints:, }).",
        "Check that the table is clear, then press Home, or home all joints in LinuxCNC.",
        name="text",
        joints="texts",
    ),
    "linuxcnc.not-secured": entry(
        "The tool was not lifted and the stations were not raised. {cause}",
        "{cause:hint}",
        cause="message",
    ),
    "linuxcnc.program-not-opened": entry(
        "LinuxCNC at {name} cannot open the program file {path}. {cause}",
        "If LinuxCNC runs on another computer, share a folder with it and give its path on both "
        "computers: linuxcnc://HOST:PORT/?programs=FOLDER&remote=FOLDER_THERE. The user of "
        "LinuxCNC must be able to read it.",
        name="text",
        path="text",
        cause="message?",
    ),
    "linuxcnc.refused": entry(
        "LinuxCNC at {name} refused the command {command!r}. {cause}",
        "Check the table and LinuxCNC, then try again.",
        name="text",
        command="text",
        cause="message?",
    ),
    "linuxcnc.rejected-in-check": entry(
        "LinuxCNC at {name} refused the program before anything moved. {cause}",
        "If a tool is missing, write the tool table of the machine (knifetip machine NAME "
        "--tool-table) to LinuxCNC. Otherwise compile the job again for this controller.",
        name="text",
        cause="message",
    ),
    "linuxcnc.silent": entry(
        "LinuxCNC at {name} has not responded for {seconds:g} s. It may still execute its program.",
        "Keep clear of the table until the machine has stopped, or press the emergency stop "
        "button. Then check that LinuxCNC and linuxcncrsh run.",
        name="text",
        seconds="number",
    ),
    "linuxcnc.stopped": entry(
        "LinuxCNC at {name} reported an error near program line {line}. {cause}",
        "Check the table and the board before the next job.",
        name="text",
        line="count",
        cause="message",
    ),
    "linuxcnc.unreadable": entry(
        "LinuxCNC at {name} sent a reply that the gateway cannot read: {reply}.",
        "Close every other connection to linuxcncrsh: it mixes up the replies to two clients.",
        name="text",
        reply="text",
    ),
    "linuxcnc.wrong-password": entry(
        "linuxcncrsh at {name} refused the password of the option {option}.",
        "Give the passwords of linuxcncrsh in the address: "
        "linuxcnc://HOST:PORT/?password=CONNECTPW&enable=ENABLEPW.",
        name="text",
        option="text",
    ),
}
