"""grbl: messages with the meanings of the error and alarm codes of grbl 1.1 and grblHAL."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "grbl.alarm-1": entry(
        "a limit switch was hit, so the position of the machine is lost",
        "Check what the head has hit. Home the machine, or unlock it and jog it away from the "
        "switch.",
    ),
    "grbl.alarm-10": entry(
        "an emergency stop button is pressed",
        "Release the emergency stop button when the table is safe, then home the machine.",
    ),
    "grbl.alarm-11": entry(
        "the machine must be homed first",
        "Clear the table, then home the machine.",
    ),
    "grbl.alarm-12": entry(
        "a limit switch is triggered",
        "Unlock the machine, jog it away from the switch, then home it.",
    ),
    "grbl.alarm-14": entry(
        "the spindle did not reach its speed",
        "Check the spindle and its cable, then unlock the machine.",
    ),
    "grbl.alarm-17": entry(
        "a motor driver reports a fault",
        "Check the motor drivers and their supply, then home the machine.",
    ),
    "grbl.alarm-2": entry(
        "a move would have gone beyond the travel range of the machine",
        "Check the work zero and the placement of the job, then unlock the machine.",
    ),
    "grbl.alarm-3": entry(
        "the controller was reset during a move, so the position of the machine may be lost",
        "Check the table, then home the machine.",
    ),
    "grbl.alarm-4": entry(
        "the probe was not in the expected state before probing",
        "Check the probe and its cable, then unlock the machine.",
    ),
    "grbl.alarm-5": entry(
        "the probe did not touch the workpiece",
        "Check the probe and the board, then unlock the machine.",
    ),
    "grbl.alarm-6": entry(
        "the controller was reset during homing",
        "Clear the table, then home the machine again.",
    ),
    "grbl.alarm-7": entry(
        "the safety door was opened during homing",
        "Close the safety door, then home the machine again.",
    ),
    "grbl.alarm-8": entry(
        "the limit switch stayed triggered when the machine moved away from it during homing",
        "Check the limit switches and their cables, then home the machine.",
    ),
    "grbl.alarm-9": entry(
        "homing did not reach the limit switch",
        "Check the limit switches and their cables, then home the machine.",
    ),
    "grbl.error-1": entry(
        "a number has no letter before it",
    ),
    "grbl.error-10": entry(
        "soft limits can be enabled only if homing is enabled",
    ),
    "grbl.error-11": entry(
        "the line is too long",
    ),
    "grbl.error-12": entry(
        "the setting exceeds the maximum step rate of the controller",
    ),
    "grbl.error-13": entry(
        "a safety door is open",
    ),
    "grbl.error-14": entry(
        "the start-up line or the build information is too long to be stored",
    ),
    "grbl.error-15": entry(
        "the jog target lies outside the travel of the machine",
    ),
    "grbl.error-16": entry(
        "the jog command has no feed, or contains a word that is not allowed in it",
    ),
    "grbl.error-17": entry(
        "laser mode needs a PWM output",
    ),
    "grbl.error-18": entry(
        "the controller was reset, so it did not execute the command",
    ),
    "grbl.error-2": entry(
        "a number is missing or cannot be read",
    ),
    "grbl.error-20": entry(
        "the controller does not support this command",
    ),
    "grbl.error-21": entry(
        "the line has two commands of one modal group, for example G0 and G1",
    ),
    "grbl.error-22": entry(
        "no feed has been set",
    ),
    "grbl.error-23": entry(
        "the number of the command must be an integer",
    ),
    "grbl.error-24": entry(
        "the line has two commands that both need axis words",
    ),
    "grbl.error-25": entry(
        "a word is repeated in the line",
    ),
    "grbl.error-26": entry(
        "the line lacks the axis words that its command needs",
    ),
    "grbl.error-27": entry(
        "the line number is out of range",
    ),
    "grbl.error-28": entry(
        "the command lacks its P or L word",
    ),
    "grbl.error-29": entry(
        "the controller does not support this work coordinate system",
    ),
    "grbl.error-3": entry(
        "the controller does not support this $ command",
    ),
    "grbl.error-30": entry(
        "G53 is used without G0 or G1",
    ),
    "grbl.error-31": entry(
        "the line has axis words (X, Y, Z), but no command that uses them",
    ),
    "grbl.error-32": entry(
        "the arc has no axis words in its plane",
    ),
    "grbl.error-33": entry(
        "the start and end of the arc do not lie on one circle",
    ),
    "grbl.error-34": entry(
        "the radius of the arc cannot be computed",
    ),
    "grbl.error-35": entry(
        "the arc has no centre, because both I and J are missing",
    ),
    "grbl.error-36": entry(
        "the line has words (a letter with a number) that no command uses",
    ),
    "grbl.error-37": entry(
        "the tool length offset is applied to the wrong axis",
    ),
    "grbl.error-38": entry(
        "the tool number is too high",
    ),
    "grbl.error-39": entry(
        "a value is out of range",
    ),
    "grbl.error-4": entry(
        "a value is negative, but must be positive",
    ),
    "grbl.error-5": entry(
        "homing is disabled in the settings of the controller",
    ),
    "grbl.error-6": entry(
        "the step pulse is too short",
    ),
    "grbl.error-60": entry(
        "the memory card of the controller could not be opened",
    ),
    "grbl.error-7": entry(
        "the settings of the controller could not be read, so the defaults were restored",
    ),
    "grbl.error-79": entry(
        "an emergency stop button is pressed",
    ),
    "grbl.error-8": entry(
        "the command is allowed only while the controller is idle",
    ),
    "grbl.error-9": entry(
        "the controller is locked by an alarm, or is jogging",
    ),
    "grbl.unknown-alarm": entry(
        "the alarm code is not documented by Grbl",
        "Read the manual of the controller and check the table, then home the machine.",
    ),
    "grbl.unknown-error": entry(
        "the error code is not documented by Grbl",
    ),
    "grbl.axis-letter-used": entry(
        "the controller names the rotary axis {letter}, and the line already contains this letter",
        letter="text",
    ),
    "grbl.no-output": entry(
        "the controller has no digital output {output} (it has {count:# output|# outputs})",
        output="count",
        count="count",
    ),
    "grbl.no-reverse": entry(
        "this build of grbl turns the spindle in one direction only (option D), and has no M4",
        'Install a build without the option, or set `spindle = "M3"` for the station.',
    ),
    "grbl.no-rotary-axis": entry(
        "the controller has no axis that rotates the tool (its axes are {axes:, })",
        axes="texts",
    ),
}
