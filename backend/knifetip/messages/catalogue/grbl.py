"""grbl: messages with the meanings of the error and alarm codes of grbl 1.1 and grblHAL."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "grbl.alarm-1": entry(
        "a limit switch was hit; its position is lost",
    ),
    "grbl.alarm-10": entry(
        "an emergency stop is pressed",
    ),
    "grbl.alarm-11": entry(
        "it must be homed first",
    ),
    "grbl.alarm-12": entry(
        "a limit switch is closed",
    ),
    "grbl.alarm-14": entry(
        "the spindle did not reach its speed",
    ),
    "grbl.alarm-17": entry(
        "a motor driver reports a fault",
    ),
    "grbl.alarm-2": entry(
        "a move would have left the travel of the machine",
    ),
    "grbl.alarm-3": entry(
        "it was reset while moving; its position may be lost",
    ),
    "grbl.alarm-4": entry(
        "the probe was not in the expected state",
    ),
    "grbl.alarm-5": entry(
        "the probe did not touch",
    ),
    "grbl.alarm-6": entry(
        "homing was reset",
    ),
    "grbl.alarm-7": entry(
        "the door was opened during homing",
    ),
    "grbl.alarm-8": entry(
        "homing could not leave the limit switch",
    ),
    "grbl.alarm-9": entry(
        "homing did not find the limit switch",
    ),
    "grbl.error-1": entry(
        "a word without its letter",
    ),
    "grbl.error-10": entry(
        "soft limits need homing",
    ),
    "grbl.error-11": entry(
        "the line is too long",
    ),
    "grbl.error-12": entry(
        "a setting beyond its step rate",
    ),
    "grbl.error-13": entry(
        "a safety door is open",
    ),
    "grbl.error-14": entry(
        "its stored build line is too long",
    ),
    "grbl.error-15": entry(
        "a jog beyond the travel",
    ),
    "grbl.error-16": entry(
        "a jog without a feed, or with a word that has no place in it",
    ),
    "grbl.error-17": entry(
        "laser mode without a variable output",
    ),
    "grbl.error-18": entry(
        "it was reset and waits",
    ),
    "grbl.error-2": entry(
        "a number that cannot be read",
    ),
    "grbl.error-20": entry(
        "a command that it does not know",
    ),
    "grbl.error-21": entry(
        "two commands of one modal group in a line",
    ),
    "grbl.error-22": entry(
        "no feed has been set",
    ),
    "grbl.error-23": entry(
        "a command that must be a whole number is not",
    ),
    "grbl.error-24": entry(
        "two commands in a line want the axis words",
    ),
    "grbl.error-25": entry(
        "a word twice in a line",
    ),
    "grbl.error-26": entry(
        "a command without the axis words that it needs",
    ),
    "grbl.error-27": entry(
        "a line number out of range",
    ),
    "grbl.error-28": entry(
        "a command without its P or L word",
    ),
    "grbl.error-29": entry(
        "a work offset that it does not have",
    ),
    "grbl.error-3": entry(
        "a $ command that it does not know",
    ),
    "grbl.error-30": entry(
        "G53 without G0 or G1",
    ),
    "grbl.error-31": entry(
        "axis words that no command uses",
    ),
    "grbl.error-32": entry(
        "an arc without axis words in its plane",
    ),
    "grbl.error-33": entry(
        "an arc whose ends do not lie on one circle",
    ),
    "grbl.error-34": entry(
        "an arc whose radius cannot be worked out",
    ),
    "grbl.error-35": entry(
        "an arc without I and J",
    ),
    "grbl.error-36": entry(
        "words that no command uses",
    ),
    "grbl.error-37": entry(
        "a tool length offset on the wrong axis",
    ),
    "grbl.error-38": entry(
        "a tool number that is too high",
    ),
    "grbl.error-39": entry(
        "a value out of range",
    ),
    "grbl.error-4": entry(
        "a negative value where none may be",
    ),
    "grbl.error-5": entry(
        "homing is switched off in its settings",
    ),
    "grbl.error-6": entry(
        "a step pulse that is too short",
    ),
    "grbl.error-60": entry(
        "its memory card could not be opened",
    ),
    "grbl.error-7": entry(
        "its settings could not be read and were set to defaults",
    ),
    "grbl.error-79": entry(
        "an emergency stop is pressed",
    ),
    "grbl.error-8": entry(
        "this is possible only while it is idle",
    ),
    "grbl.error-9": entry(
        "it is locked by an alarm or jogs",
    ),
    "grbl.unknown-alarm": entry(
        "an alarm without a published meaning",
    ),
    "grbl.unknown-error": entry(
        "an error without a published meaning",
    ),
}
