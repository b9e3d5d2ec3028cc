"""edge_choice: German texts of the messages of ``catalogue.edge_choice``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "bridge.at-corner": Text(
        "Die Mitte des Haltestegs auf Kante {edge} ist {distance:.2f} mm von einem Ende der Kante "
        "entfernt, aber Steg und Werkzeug brauchen {least:.2f} mm.",
        "Den Steg verschieben oder schmaler machen.",
    ),
    "bridge.no-outline": Text(
        "Auf Kante {edge} wurde ein Haltesteg gesetzt, aber sie gehört nicht zum geschlossenen "
        "Umriss eines Teils.",
        "Den Steg entfernen oder auf den Umriss eines Teils setzen.",
    ),
    "bridge.too-near": Text(
        "Die Haltestege auf Kante {edge} und Kante {other} sind {distance:.2f} mm voneinander "
        "entfernt, aber das Werkzeug braucht {least:.2f} mm von Mitte zu Mitte.",
        "Einen der Stege verschieben oder entfernen.",
    ),
    "corner-choice.no-cutter": Text(
        "Für Kante {edge} wurde eine Eckenart gewählt, aber {machine} schneidet nicht mit Fräser "
        "oder Laser.",
        "Die Angabe entfernen oder eine andere Maschine wählen.",
    ),
    "corner-choice.other-type": Text(
        "Für Kante {edge} wurde eine Eckenart gewählt. Sie hat die Linienart {type}, aber "
        "Eckenarten gibt es nur für Schnitte.",
        "Die Angabe entfernen.",
    ),
    "crease-depth.not-set": Text(
        "Für Rillung {edge} wurde eine Tiefe gewählt, aber Programme für {machine} stellen die "
        "Tiefe des Rillrads nicht ein.",
        "Die Angabe entfernen und die Tiefe an der Maschine einstellen.",
    ),
    "crease-depth.other-type": Text(
        "Für Kante {edge} wurde eine Rilltiefe gewählt, aber sie hat die Linienart {type}.",
        "Die Angabe entfernen oder die Kante zur Rillung machen.",
    ),
    "crease-depth.too-deep": Text(
        "Die Tiefe für Rillung {edge} ist {depth:g} mm, aber der Karton ist {caliper:g} mm dick.",
        "Eine Tiefe wählen, die kleiner als die Dicke des Kartons ist.",
    ),
    "depth.not-set": Text(
        "Für Kante {edge} wurden Durchgänge oder eine Tiefe gewählt, aber Programme für {machine} "
        "stellen die Tiefe des Messers nicht ein.",
        "Die Angabe entfernen und die Tiefe an der Maschine einstellen.",
    ),
    "depth.of-cutter": Text(
        "Für Kante {edge} wurde eine Tiefe gewählt, aber der Fräser oder Laser von Station "
        "{station} schneidet den Karton immer ganz durch.",
        "Die Tiefe entfernen; für einen Fräser können Durchgänge gewählt werden.",
    ),
    "depth.one-pass": Text(
        "Für Kante {edge} wurden Durchgänge gewählt, aber das Werkzeug von Station {station} "
        "schneidet in einem Durchgang.",
        "Die Angabe entfernen oder eine andere Maschine wählen.",
    ),
    "depth.other-type": Text(
        "Für Kante {edge} wurden Durchgänge oder eine Tiefe gewählt. Sie hat die Linienart {type}, "
        "aber das geht nur für Schnitte und Ritzungen.",
        "Die Angabe entfernen.",
    ),
    "depth.several": Text(
        "Die Kontur von Kante {edge} und Kante {other} wird als Ganzes gefräst, aber für ihre "
        "Kanten wurden verschiedene Durchgänge gewählt.",
        "Für alle Kanten der Kontur dieselben Durchgänge wählen.",
    ),
    "depth.too-deep": Text(
        "Die Tiefe für Kante {edge} ist {depth:g} mm, aber bei diesem Karton und Tisch darf das "
        "Werkzeug {most:g} mm tief schneiden.",
        "Eine kleinere Tiefe wählen.",
    ),
    "depth.too-few-passes": Text(
        "Für Kante {edge} {passes:wurde # Durchgang|wurden # Durchgänge} gewählt, aber bei "
        "{step:g} mm je Durchgang braucht das Werkzeug {least} für eine Tiefe von {depth:g} mm.",
        "Mehr Durchgänge wählen oder ihre Zahl dem Werkzeug überlassen.",
    ),
    "edge-choice.bad-syntax": Text(
        "„{text}“ ist kein Wert von {option}.",
        "Als KANTEN:NAME=WERT,NAME=WERT schreiben, mit den Nummern der Kanten und was für sie "
        "gewählt ist, zum Beispiel 12,13:passes=2.",
    ),
    "edge-choice.joined": Text(
        "Kante {edge} und Kante {other} werden als eine Kante bearbeitet, aber für sie wurden "
        "verschiedene Optionen gewählt.",
        "Für beide dasselbe wählen.",
    ),
    "edge-choice.no-edge": Text(
        "Für Kante {row} wurde eine Option gewählt, aber die Zeichnung hat "
        "{count:# Kante|# Kanten}, von 0 an gezählt.",
        "Eine Kante dieser Zeichnung wählen.",
    ),
    "lead-choice.bad": Text(
        "Den für Kante {edge} gewählten Anlauf kann das Werkzeug nicht ausführen: {reason}.",
        "Einen längeren Anlauf oder einen anderen Winkel wählen.",
    ),
    "lead-choice.facing": Text(
        "Kante {edge} und Kante {other} liegen sich mit {distance:.2f} mm Abstand gegenüber, näher "
        "als das Werkzeug breit ist ({diameter:g} mm), aber für ihre Konturen wurden verschiedene "
        "Anläufe gewählt.",
        "Für beide Konturen denselben Anlauf wählen.",
    ),
    "lead-choice.no-cutter": Text(
        "Für Kante {edge} wurde ein Anlauf gewählt, aber {machine} schneidet nicht mit Fräser oder "
        "Laser.",
        "Die Angabe entfernen. Der Anlauf eines Messers steht in der Maschinendatei.",
    ),
    "lead-choice.other-type": Text(
        "Für Kante {edge} wurde ein Anlauf gewählt. Sie hat die Linienart {type}, aber nur "
        "Schnitte haben Anläufe.",
        "Die Angabe entfernen.",
    ),
    "lead-choice.several": Text(
        "Für Kante {edge} und Kante {other} derselben Kontur wurden verschiedene Anläufe gewählt.",
        "Für alle Kanten der Kontur denselben Anlauf wählen.",
    ),
    "order.bad-syntax": Text(
        "„{text}“ ist keine Reihenfolge von Kanten.",
        "Die Nummern der Kanten mit Kommas dazwischen schreiben, zum Beispiel 12,3,4.",
    ),
    "order.enclosed": Text(
        "Kante {edge} kann nicht vor Kante {other} geschnitten werden: Ihre Kontur umschließt "
        "Kante {other}, und was in einer Kontur liegt, wird geschnitten, solange der Bogen es "
        "hält.",
        "Kante {other} vor Kante {edge} setzen.",
    ),
    "order.not-made": Text(
        "Kante {edge} hat einen Platz in der Reihenfolge, aber kein Werkzeug bearbeitet sie.",
        "Die Kante aus der Reihenfolge entfernen.",
    ),
    "order.one-track": Text(
        "Kante {other} kann nicht nach Kante {edge} bearbeitet werden: Das Werkzeug macht sie in "
        "einem Zug, ohne abzuheben, mit einer Kante, die vorher kommt.",
        "Nur einer Kante jedes Zuges einen Platz in der Reihenfolge geben.",
    ),
    "order.pieces": Text(
        "Kante {edge} kann nicht vor Kante {other} bearbeitet werden: Löcher, Schlitze und innere "
        "Konturen werden vor Umrissen geschnitten und Schnitte gleicher Tiefe zusammen, damit kein "
        "Werkzeug losen Karton bearbeitet.",
        "Kante {other} vor Kante {edge} setzen.",
    ),
    "order.tools": Text(
        "Kante {edge} kann nicht vor Kante {other} bearbeitet werden: Das Werkzeug von Station "
        "{other_station} macht seine ganze Arbeit vor dem von Station {station}, damit jedes "
        "Werkzeug nur einmal gewechselt wird.",
        "Kante {other} vor Kante {edge} setzen.",
    ),
    "order.types": Text(
        "Kante {edge} ({type}) kann nicht vor Kante {other} ({other_type}) bearbeitet werden: "
        "Zuerst kommen Rillen, solange der Karton fest liegt, dann V-Nuten, Ritzungen und "
        "Perforationen, zuletzt Schnitte.",
        "Kante {other} vor Kante {edge} setzen.",
    ),
    "start.at-corner": Text(
        "Der Anfang auf Kante {edge} ist {distance:.2f} mm von einem Ende der Kante entfernt, aber "
        "der Fräser braucht {least:.2f} mm, um daneben einzutauchen.",
        "Einen Punkt weiter weg von beiden Enden der Kante wählen oder eine andere Kante der "
        "Kontur.",
    ),
    "start.bridged": Text(
        "Für Kante {edge} wurde ein Anfang oder eine Richtung gewählt, aber ihre Kontur hat "
        "Haltestege, die sie in mehrere Schnitte teilen.",
        "Die Angabe entfernen oder einen Karton ohne Haltestege wählen.",
    ),
    "start.conflict": Text(
        "Für die Kontur von Kante {edge} und Kante {other} wurden zwei Anfänge oder zwei "
        "Richtungen gewählt.",
        "Eine der beiden Angaben entfernen.",
    ),
    "start.fixed-direction": Text(
        "Kante {edge} kann nicht in der gewählten Richtung geschnitten werden: Das Werkzeug von "
        "Station {station} muss den Abfall links haben.",
        "Die andere Richtung wählen oder die Richtung frei lassen.",
    ),
    "start.not-last": Text(
        "Der Schnitt kann nicht auf Kante {edge} beginnen, denn er endet auch dort, und eine "
        "später geschnittene Kante muss das Teil lösen.",
        "Eine Kante der Kontur wählen, an der das Teil nur Abfall berührt.",
    ),
    "start.open": Text(
        "Für Kante {edge} wurde ein Anfang oder eine Richtung gewählt, aber sie gehört zu keinem "
        "geschlossenen Schnitt und zu keiner geschlossenen Ritzung.",
        "Die Angabe entfernen oder eine Kante einer geschlossenen Kontur wählen.",
    ),
    "tool-choice.facing": Text(
        "Kante {edge} und Kante {other} liegen sich mit {distance:.2f} mm Abstand gegenüber, aber "
        "für sie wurden verschiedene Werkzeuge gewählt, von denen eines {diameter:g} mm breit "
        "schneidet und in die andere Kontur geraten würde.",
        "Für beide Konturen dasselbe Werkzeug wählen.",
    ),
    "tool-choice.no-station": Text(
        "Für Kante {edge} wurde Station {station} gewählt, aber {machine} hat keine solche "
        "Station.",
        "Eine von diesen wählen: {suited:, }.",
    ),
    "tool-choice.not-made": Text(
        "Für Kante {edge} wurde ein Werkzeug gewählt, aber sie hat die Linienart {type} und wird "
        "nicht bearbeitet.",
        "Die Angabe entfernen oder der Kante eine andere Linienart geben.",
    ),
    "tool-choice.other-kind": Text(
        "Für Kante {edge} ({type}) wurde Station {station} ({name}) gewählt, aber an dieser "
        "Maschine bearbeitet ein Werkzeug anderer Art diese Linienart.",
        "Eine von diesen wählen: {suited:, }.",
    ),
    "tool-choice.several": Text(
        "Die Kontur von Kante {edge} und Kante {other} wird als Ganzes gefräst, aber für ihre "
        "Kanten wurden verschiedene Werkzeuge gewählt.",
        "Für alle Kanten der Kontur dasselbe Werkzeug wählen.",
    ),
    "tool-choice.station": Text("{station} ({name})"),
    "verify.bridge-missing": Text(
        "Das Programm lässt an der gewählten Stelle auf Kante {edge} keinen Haltesteg stehen, wo "
        "einer von {width:g} mm bleiben soll.",
        "Den Auftrag neu berechnen.",
    ),
    "verify.bridge-not-chosen": Text(
        "Das Programm lässt auf Kante {edge} einen Haltesteg von {width:.3f} mm stehen, wo keiner "
        "gesetzt wurde.",
        "Den Auftrag neu berechnen.",
    ),
    "verify.no-closed-cut": Text(
        "Für den geschlossenen Schnitt mit Kante {edge} wurde eine Richtung gewählt, aber das "
        "Programm schneidet diese Kontur nicht in einem Zug.",
        "Den Auftrag neu berechnen.",
    ),
    "verify.other-direction": Text(
        "Das Programm schneidet Kante {edge} gegen die gewählte Richtung.",
        "Den Auftrag neu berechnen.",
    ),
    "verify.other-lead": Text(
        "Die Kontur von Kante {edge} muss einen Anlauf von {length:.3f} mm haben, die Hälfte davon "
        "oder keinen, aber das Programm kommt auf einem Anlauf von {found:.3f} mm zu ihr.",
        "Den Auftrag neu berechnen.",
    ),
    "verify.other-order": Text(
        "Kante {edge} muss nach Kante {other} bearbeitet werden, aber das Programm beginnt sie "
        "vorher, in Zeile {line}.",
        "Den Auftrag neu berechnen.",
    ),
    "verify.other-passes": Text(
        "Kante {edge} muss in {passes:# Durchgang|# Durchgängen} bis {depth:g} mm unter die "
        "Oberseite geschnitten werden, aber das Programm schneidet sie in diesen Tiefen (mm): "
        "{found:, }.",
        "Den Auftrag neu berechnen.",
    ),
    "verify.other-start": Text(
        "Der geschlossene Schnitt mit Kante {edge} muss bei X {x:.3f} mm, Y {y:.3f} mm auf dieser "
        "Kante beginnen, aber das Programm beginnt ihn woanders.",
        "Einen Anfang mit mehr Platz für das Werkzeug wählen oder den Auftrag neu berechnen.",
    ),
    "verify.other-tool": Text(
        "Kante {edge} muss mit dem Werkzeug von Station {station} bearbeitet werden, aber das "
        "Programm bearbeitet sie mit dem von Station {found}.",
        "Den Auftrag neu berechnen.",
    ),
    "verify.short-lead": Text(
        "Die Kontur von Kante {edge} muss einen Anlauf von {length:.3f} mm haben, für den Platz "
        "ist, aber das Programm kommt auf einem Anlauf von {found:.3f} mm zu ihr.",
        "Den Auftrag neu berechnen.",
    ),
}
