"""setting: German texts of the messages of ``catalogue.setting``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "setting.difference": Text(
        "{setting} ist {found}, erwartet wird {expected}: {reason}.",
        "{assignment} an der Steuerung setzen oder die Maschinendatei berichtigen.",
    ),
    "setting.faster": Text(
        "die Steuerung fährt die Achse schneller, als die Maschinendatei erlaubt",
    ),
    "setting.homes-at-other-end": Text(
        "die Steuerung setzt ihren Nullpunkt am Referenzschalter, in der Maschinendatei ist er "
        "aber am anderen Ende der Achse",
    ),
    "setting.inches": Text(
        "Positionen werden in Zoll gemeldet und würden als Millimeter genommen",
    ),
    "setting.laser-mode": Text(
        "der Laserbetrieb ist an, aber die Maschinendatei hat keinen Laser",
    ),
    "setting.laser-mode-stops-spindle": Text(
        "im Laserbetrieb schaltet die Steuerung die Spindel in Eilgängen aus, Werkzeuge würden "
        "also stehend in den Karton eintauchen",
    ),
    "setting.no-buffer-state": Text(
        "Statusmeldungen enthalten nicht den Füllstand der Puffer, verlorene Antworten werden "
        "also spät bemerkt",
    ),
    "setting.no-hard-limits": Text(
        "Endschalter halten die Maschine nicht an",
    ),
    "setting.no-homing": Text(
        "die Steuerung macht keine Referenzfahrt, kennt also nach dem Einschalten ihre Position "
        "nicht",
    ),
    "setting.no-laser-mode": Text(
        "die Steuerung ist nicht im Laserbetrieb, der Laserstrahl bliebe also bei einem "
        "Vorschubhalt an",
    ),
    "setting.no-rate": Text(
        "die höchste Geschwindigkeit der Achse ist 0, sie kann sich also nicht bewegen",
    ),
    "setting.no-soft-limits": Text(
        "die Steuerung lehnt Bewegungen über ihren Verfahrweg hinaus nicht ab",
    ),
    "setting.no-steps": Text(
        "die Anzahl der Schritte je Millimeter oder Grad der Achse ist 0, sie kann sich also nicht "
        "bewegen",
    ),
    "setting.no-work-offset": Text(
        "Positionen werden ohne den Versatz des Werkstücknullpunkts gemeldet, das Gateway weiß "
        "also nicht, wo das Werkzeug ist",
    ),
    "setting.rotary-axes": Text(
        "die Steuerung nimmt den Winkel einer Drehachse als Länge oder eine Länge als Winkel",
    ),
    "setting.short-travel": Text(
        "der Verfahrweg ist kürzer als in der Maschinendatei, die Steuerung lehnt also Aufträge "
        "nahe an den Enden ab",
    ),
    "setting.slower": Text(
        "die Steuerung fährt die Achse langsamer, als die Maschinendatei angibt, Aufträge dauern "
        "also länger als angegeben",
    ),
    "setting.spindle-limit": Text(
        "die höchste Drehzahl oder Leistung der Steuerung ist niedriger, als eine Station braucht, "
        "ihr Werkzeug liefe also langsamer oder mit weniger Leistung",
    ),
    "setting.unit-of-angle": Text(
        "die Winkeleinheit der Steuerung ist nicht Grad",
    ),
    "setting.unit-of-length": Text(
        "die Längeneinheit der Steuerung ist nicht Millimeter, Positionen würden also falsch "
        "genommen",
    ),
    "setting.z-homes-down": Text(
        "die Referenzfahrt würde das Werkzeug nach unten in den Karton fahren",
    ),
}
