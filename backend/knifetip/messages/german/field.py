"""field: German texts of the messages of ``catalogue.field``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "field.above": Text(
        "{path} ist {value}, darf aber höchstens {limit:g} sein",
    ),
    "field.below": Text(
        "{path} ist {value}, muss aber mindestens {limit:g} sein",
    ),
    "field.above-clearance": Text(
        "{path} ist {value:g} mm, darf aber nicht größer sein als clearance, {clearance:g} mm",
    ),
    "field.bad-arguments": Text(
        "{path} hat Argumente, die nicht zum Meldungscode „{name}“ passen",
    ),
    "field.blank": Text(
        "{path} ist leer",
    ),
    "field.control-character": Text(
        "{path} enthält das Steuerzeichen {character}, das man weder sieht noch tippt",
        "Es entfernen oder den Text neu eingeben.",
    ),
    "field.inconsistent": Text(
        "{path} widerspricht anderen Feldern: {fault}",
    ),
    "field.missing": Text(
        "{path} fehlt",
    ),
    "field.metadata-too-large": Text(
        "{path} ist größer als {most} kB",
    ),
    "field.misspelt": Text(
        "{path} ist kein bekanntes Feld; vielleicht ist {near} gemeint",
    ),
    "field.no-neighbour": Text(
        "{path} muss previous, next oder beides enthalten",
    ),
    "field.no-spindle": Text(
        "{path}: `spindle` und `spindle_speed` sind gesetzt, aber das Werkzeug von Station "
        "{station} hat weder Oszillation noch Spindel",
    ),
    "field.needs-heading": Text(
        "{path}: Station {station} hat ein Werkzeug, das eine Achse drehen muss, aber [axes] hat "
        "kein c. Werkzeuge einer solchen Maschine sind ein Schleppmesser, ein Fräser oder ein "
        "Laser",
    ),
    "field.gantry-not-square": Text(
        "{path}: Programme einer Maschine mit mehreren Schlitten korrigieren keinen Winkel von "
        "{angle:g}° zwischen X und Y; squareness muss 90 sein"
    ),
    "field.gantry-without-heading": Text(
        "{path}: eine Maschine mit Schlitten braucht eine Achse c in [axes]",
    ),
    "field.override-range": Text(
        "{path}: die Vorschubanpassung von {low} bis {high} % muss 100 % enthalten",
    ),
    "field.spindle-of-beam": Text(
        "{path}: `spindle` und `spindle_speed` sind gesetzt, aber Station {station} hat einen "
        "Laser, der mit M3 und seinem `power` geschaltet wird",
    ),
    "field.no-such-carriage": Text(
        "{path}: Station {station} ist auf Schlitten {carriage}, aber die Maschine hat {count:# "
        "Schlitten|# Schlitten}",
    ),
    "field.no-kind": Text(
        "{path} nennt seine Art nicht: das Feld {field} fehlt",
    ),
    "field.not-a-colour": Text(
        "{path} ist {value}, muss aber eine ganze Zahl von 1 bis 255 oder „#rrggbb“ sein",
    ),
    "field.not-a-line-type": Text(
        "{path} ist „{value}“, muss aber eine Linienart sein: {known:or}",
    ),
    "field.not-a-list": Text(
        "{path} ist {value}, muss aber eine Liste sein",
    ),
    "field.not-a-number": Text(
        "{path} ist {value}, muss aber eine Zahl sein",
    ),
    "field.not-a-profile": Text(
        "{path} ist „{value}“, muss aber ein Profil der Bibliothek sein: {known:or}",
    ),
    "field.not-a-table": Text(
        "{path} ist {value}, muss aber eine Tabelle von Feldern sein",
    ),
    "field.not-a-time": Text(
        "{path} ist {value}, muss aber eine Zeit nach RFC 3339 mit Zeitzone sein, etwa "
        "2030-01-02T03:04:05Z",
    ),
    "field.not-above": Text(
        "{path} ist {value}, muss aber größer als {limit:g} sein",
    ),
    "field.not-above-low": Text(
        "{path} ist {value:g}, muss aber größer sein als der Wert des Feldes low, {low:g}",
    ),
    "field.not-below": Text(
        "{path} ist {value}, muss aber kleiner als {limit:g} sein",
    ),
    "field.not-boolean": Text(
        "{path} ist {value}, muss aber true oder false sein",
    ),
    "field.bad-json": Text(
        "{path} ist kein gültiges JSON: Der Fehler ist in Zeile {line}, Spalte {column}",
    ),
    "field.nested-too-deep": Text(
        "{path} ist zu tief verschachtelt",
    ),
    "field.not-json": Text(
        "{path} ist kein gültiges JSON: {reason}",
    ),
    "field.not-less-than-caliper": Text(
        "{path} ist {value:g} mm, muss aber kleiner sein als die Materialdicke von {caliper:g} mm",
    ),
    "field.not-one-of": Text(
        "{path} ist {value}, muss aber {known:or} sein",
    ),
    "field.not-text": Text(
        "{path} ist {value}, muss aber Text sein",
    ),
    "field.no-year": Text(
        "{path} ist {value}, muss aber in den Jahren 1 bis 9999 von UTC liegen",
    ),
    "field.wrong-order": Text(
        "{path}: {second} darf nicht vor {first} liegen",
    ),
    "field.not-empty": Text(
        "{path} ist {value}, muss aber null sein",
    ),
    "field.wrong-form": Text(
        "{path} ist {value}, das nicht die verlangte Form hat",
    ),
    "field.not-whole": Text(
        "{path} ist {value}, muss aber eine ganze Zahl sein",
    ),
    "field.other": Text(
        "{path} ist {value}, das ist ungültig ({fault})",
    ),
    "field.outside": Text(
        "{path} ist {value}, muss aber von {low:g} bis {high:g} sein",
    ),
    "field.park-outside": Text(
        "{path} parkt bei {park:g} mm, außerhalb des Verfahrwegs seiner y-Achse von {low:g} bis "
        "{high:g} mm",
    ),
    "field.parks-too-near": Text(
        "{path} hat zwei Schlitten, die {distance:g} mm voneinander parken, aber min_distance ist "
        "{least:g} mm",
    ),
    "field.repeated-letters": Text(
        "{path} hat die Buchstaben {letters:, }; jeder Buchstabe darf nur einmal vorkommen",
    ),
    "field.repeated-numbers": Text(
        "{path} hat die Nummern {numbers:, }; jede Nummer darf nur einmal vorkommen",
    ),
    "field.rest-choice": Text(
        "{path} muss entweder nur whole enthalten (nur damit sind Exemplare möglich) oder einen "
        "Anfang (from_track oder from_line), eine Station oder beides",
    ),
    "field.edges-or-line-type": Text(
        "{path} muss entweder edges oder line_type haben",
    ),
    "field.sheet-size": Text(
        "{path} muss width und height haben, oder keines von width, height und margin",
    ),
    "field.spacing": Text(
        "{path} ist {value:g} mm, muss aber 0 oder mindestens {least:g} mm sein",
    ),
    "field.too-few": Text(
        "{path} hat {count:# Wert|# Werte}, braucht aber mindestens {least}",
    ),
    "field.too-long": Text(
        "{path} ist länger als {most} Zeichen",
    ),
    "field.too-many": Text(
        "{path} hat mehr als {most} Werte",
    ),
    "field.close-marks": Text(
        "{path}: Die Marke bei X {x:g}, Y {y:g} mm ist nur {distance:.1f} mm von einer anderen "
        "entfernt; Marken müssen mindestens {least:g} mm auseinander liegen",
    ),
    "field.measured-marks": Text(
        "{path} hat {marks} Marken, davon sind {measured} gemessen; alle messen oder keine",
    ),
    "field.too-many-copies": Text(
        "{path} enthält {count} Exemplare von Zeichnungen; ein Bogen darf {limit} haben",
    ),
    "field.too-many-passes": Text(
        "{path} ist {value:g} mm, das ist zu klein: Die V-Nut bräuchte mehr als {most} Durchgänge",
    ),
    "field.too-short": Text(
        "{path} hat weniger als {least:# Zeichen|# Zeichen}",
    ),
    "field.zone-above-travel": Text(
        "{path}: Die Oberkante der Zone {zone} ist {top:g} mm über der Matte und der "
        "Sicherheitsabstand {clearance:g} mm, aber Werkzeuge fahren bei travel_z = {travel_z:g} "
        "mm; travel_z erhöhen",
    ),
    "field.unknown": Text(
        "{path} ist kein bekanntes Feld",
    ),
    "field.unknown-kind": Text(
        "{path} hat die unbekannte Art „{value}“; bekannte Arten sind {known:, }",
    ),
}
