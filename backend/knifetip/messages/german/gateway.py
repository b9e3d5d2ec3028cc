"""gateway: German texts of the messages of ``catalogue.gateway``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "gateway.cancelled": Text(
        "Der Bediener hat den Auftrag bei Programmzeile {line} abgebrochen.",
    ),
    "gateway.controller-not-idle": Text(
        "{name} ist nicht frei: Sie meldet den Zustand {state}.",
        "Warten, bis die Steuerung frei ist, oder sie am Tisch zurücksetzen.",
    ),
    "gateway.outdated-machine": Text(
        "Das Gateway {gateway} benutzt Version {version} der Maschine {machine}, deren neueste "
        "Version {newest} ist.",
        "Die Definition der Maschine neu laden oder das Gateway neu starten.",
    ),
    "gateway.job-withdrawn": Text(
        "Der Server hat dem Gateway (dem Programm, das Aufträge an die Maschine sendet) den "
        "Auftrag entzogen, und die Maschine wurde angehalten.",
        "Den Tisch und den Karton darauf prüfen.",
    ),
    "gateway.job-withdrawn-before-start": Text(
        "Der Server hat dem Gateway den Auftrag entzogen, bevor er gestartet wurde. Nichts wurde "
        "an die Maschine gesendet.",
    ),
    "gateway.server-silent-before-start": Text(
        "Der Server hat nicht geantwortet, bevor das Programm beginnen sollte. Nichts wurde an "
        "die Maschine gesendet.",
        "Die Netzwerkverbindung des Gateways prüfen.",
    ),
    "gateway.switched-off-before-begin": Text(
        "Das Gateway (das Programm, das Aufträge an die Maschine sendet) wurde ausgeschaltet, "
        "bevor das Programm begonnen wurde. Keine Zeile davon wurde ausgeführt.",
    ),
    "gateway.access-refused": Text(
        "Der Server {server} lehnt dieses Gateway ab: {reason}",
        "Mit knifetip key create NAME --scope gateway einen Schlüssel anlegen, ihn dem Gateway "
        "mit --key-file PFAD geben und das Gateway neu starten.",
    ),
    "gateway.machine-changed": Text(
        "Version {version} der Maschine {machine} ist nicht mehr die neueste.",
        "Die Definition der Maschine neu laden.",
    ),
    "gateway.not-claimed": Text(
        "Der Auftrag {job} wurde nicht mit diesem Schlüssel übernommen, also wird sein Programm "
        "nicht herausgegeben.",
        "Den Auftrag zuerst übernehmen.",
    ),
    "gateway.no-reason": Text(
        "Das Gateway (das Programm, das Aufträge an die Maschine sendet) hat den Auftrag ohne "
        "Angabe eines Grundes beendet.",
        "Die Ursache im Protokoll des Gateways suchen.",
    ),
    "gateway.started-in-dry-run": Text(
        "Der Auftrag wurde gestartet, während die Maschine einen Probelauf über dem Karton machte. "
        "Nichts vom Auftrag wurde an die Maschine gesendet.",
        "Den Auftrag noch einmal einreihen und starten, wenn die Maschine steht.",
    ),
    "gateway.switched-off": Text(
        "Das Gateway (das Programm, das Aufträge an die Maschine sendet) wurde beendet.",
    ),
    "gateway.switched-off-before-report": Text(
        "Die Maschine hat den Auftrag beendet, aber das Gateway (das Programm, das Aufträge an "
        "die Maschine sendet) wurde beendet, bevor es das Ergebnis gemeldet hatte.",
    ),
    "gateway.switched-off-in-run": Text(
        "Das Gateway (das Programm, das Aufträge an die Maschine sendet) wurde beendet, während "
        "die Maschine den Auftrag ausführte. Es hat der Maschine dabei den Befehl zum Anhalten "
        "gesendet.",
        "Den Tisch prüfen, dann das Gateway neu starten.",
    ),
    "gateway.system-error": Text(
        "Das Betriebssystem auf dem Rechner des Gateways meldet einen Fehler: {reason}.",
        "Die Ursache auf diesem Rechner beheben, dann das Gateway neu starten.",
    ),
}
