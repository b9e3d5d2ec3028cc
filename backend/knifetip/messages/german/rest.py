"""rest: German texts of the messages of ``catalogue.rest``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "rest.bound-to-sheet": Text(
        "Auftrag {job} macht den Bogen fertig, der auf der Maschine {machine} liegt, also sind "
        "seine Maschine und seine Anzahl nicht zu ändern.",
        "Ein Exemplar mehr vom ganzen Auftrag bestellen. Dafür sind eine andere Maschine und eine "
        "andere Anzahl möglich.",
    ),
    "rest.continue-first": Text(
        "{interruption}",
        "Diesen Bogen fortsetzen, noch {tracks}. {interruption:hint}",
    ),
    "rest.continued-already": Text(
        "Auftrag {other} setzt den Bogen von Auftrag {job} schon fort.",
        "Stattdessen jenen Auftrag fortsetzen oder ihn abbrechen, bevor er beginnt.",
    ),
    "rest.continued-by": Text(
        "Auftrag {job} setzt die Arbeit dieses Auftrags fort.",
    ),
    "rest.continues": Text(
        "Der Auftrag wurde angelegt, um den Rest des Bogens von Auftrag {job} zu machen.",
    ),
    "rest.copy-of": Text(
        "Der Auftrag wurde angelegt, um das ganze Programm von Auftrag {job} noch einmal zu "
        "machen.",
    ),
    "rest.line-changed": Text(
        "Die Maschine hat inzwischen {line} ausgeführte Programmzeilen von Auftrag {job} gemeldet.",
        "Die Bahnen noch einmal ansehen und wählen, wo fortgesetzt wird.",
    ),
    "rest.no-copies": Text(
        "Von Auftrag {job} ist kein Exemplar mehr zu bestellen. Er wurde mit {copies} Exemplaren "
        "bestellt.",
        "Bei Bedarf ein Exemplar mehr vom ganzen Auftrag machen.",
    ),
    "rest.no-such-station": Text(
        "Das Programm hat keine Bahnen von Station {station}.",
        "Eine der Stationen aus der Liste der Bahnen wählen.",
    ),
    "rest.no-such-track": Text(
        "Das Programm hat keine Bahn (ununterbrochener Lauf eines Werkzeugs) mit der Nummer "
        "{track}. Es hat {count} Bahnen.",
        "Eine Bahn aus der Liste der Bahnen wählen.",
    ),
    "rest.no-tracks": Text(
        "Nach der gewählten Stelle ist keine Bahn mehr zu machen.",
        "Eine frühere Stelle wählen oder den Auftrag als fertig melden, wenn der Bogen "
        "vollständig ist.",
    ),
    "rest.not-again": Text(
        "Auftrag {job} macht den Rest eines Bogens, kann also nicht ab der ersten Zeile noch "
        "einmal eingereiht werden.",
        "Ihn ab einer Bahn fortsetzen oder ein Exemplar mehr vom ganzen Programm machen.",
    ),
    "rest.not-executed": Text(
        "{count} Bahnen würden ausgelassen, obwohl die Maschine nur {executed} ausgeführte "
        "Programmzeilen gemeldet hat. Die erste davon ist Bahn {track} von Station {station}.",
        "Ab einer früheren Bahn fortsetzen. Sind diese Bahnen auf dem Bogen vollständig, "
        "bestätigen, dass die ausgelassenen Bahnen gemacht sind.",
    ),
    "rest.old-program": Text(
        "Das Programm stammt von einer älteren Version von knifetip, die die Bahnen eines "
        "Programms nicht gespeichert hat.",
        "Ein Exemplar mehr vom ganzen Auftrag machen.",
    ),
    "rest.ordered": Text(
        "Auftrag {job} wurde angelegt, um den Rest des Bogens zu machen.",
    ),
    "rest.sheet-first": Text(
        "Auftrag {job} ist unterbrochen, und sein Bogen belegt den Tisch.",
        "Zuerst den Rest des Bogens machen oder den Auftrag verwerfen. Dann die übrigen Exemplare "
        "bestellen.",
    ),
    "rest.statement-needed": Text(
        "Die Maschine hat sicher {executed} Programmzeilen von Auftrag {job} ausgeführt, "
        "vielleicht auch mehr, bis Zeile {most}. Von {tracks:# Bahn|# Bahnen} ist nicht bekannt, "
        "wie viel gemacht ist; die erste davon ist Bahn {track}.",
        "Den Bogen ansehen und die Nummern aller vollständig gemachten Bahnen angeben (made). Der "
        "neue Auftrag macht alle anderen.",
    ),
    "rest.tracks": Text(
        "{count:# Bahn|# Bahnen}",
    ),
    "rest.tracks-between": Text(
        "{least} bis {most:# Bahn|# Bahnen}",
    ),
    "rest.whole-ordered": Text(
        "Auftrag {job} wurde angelegt, um das ganze Programm noch einmal zu machen.",
    ),
    "rest.wrong-state": Text(
        "Auftrag {job} ist {state:state}, also kann kein anderer Auftrag seine Arbeit fortsetzen.",
        "{advice}",
    ),
}
