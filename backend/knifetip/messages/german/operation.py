"""operation: German texts of the messages of ``catalogue.operation``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "operation.bad-feed": Text(
        "Ein Vorschub von {feed:g} je Minute ist auf dieser Achse nicht möglich.",
        "Einen Vorschub größer als 0 und höchstens {fastest:g} je Minute angeben.",
    ),
    "operation.bad-override": Text(
        "Eine Vorschubanpassung von {percent} % ist auf dieser Maschine nicht möglich.",
        "{low} bis {high} % wählen.",
    ),
    "operation.beyond-travel": Text(
        "Die Bewegung würde bei {axis} {target:.3f} enden, außerhalb des Verfahrwegs der Achse "
        "von {low:g} bis {high:g}. Nichts hat sich bewegt.",
        "Weniger weit oder in die andere Richtung fahren.",
    ),
    "operation.expired": Text(
        "Die Bedienung wurde nicht innerhalb von {seconds:g} s ausgeführt und fallen gelassen. "
        "Nichts wurde an die Maschine gesendet.",
        "Die Verbindung des Gateways zum Server und zur Maschine prüfen, dann noch einmal "
        "versuchen.",
    ),
    "operation.gateway-absent": Text(
        "Kein Gateway von {machine} ist verbunden, also kann nichts an die Maschine gesendet "
        "werden.",
        "Die Maschine einschalten und ihr Gateway starten.",
    ),
    "operation.hands-not-clear": Text(
        "„{request:request}“ bewegt {machine}, aber in den letzten {seconds:g} s hat niemand "
        "bestätigt, dass die Hände frei sind.",
        "Nachsehen, dass niemand in die Maschine greift, auf der Seite der Station „Hände frei“ "
        "drücken, dann noch einmal anfordern.",
    ),
    "operation.jog-ended": Text(
        "Die Tippbewegung {id} ist beendet: Ihre Taste wurde nicht innerhalb von {seconds:g} s "
        "als gedrückt gemeldet, oder die Maschine hat sie abgelehnt.",
        "Die Taste loslassen und noch einmal drücken.",
    ),
    "operation.job-on-machine": Text(
        "Die Maschine führt einen Auftrag aus, also macht sie nichts anderes.",
        "Warten, bis der Auftrag beendet ist, oder ihn abbrechen.",
    ),
    "operation.job-running": Text(
        "Auftrag {job} belegt {machine} ({state:state}), also macht die Maschine nichts anderes.",
        "Warten, bis der Auftrag beendet ist, oder ihn abbrechen.",
    ),
    "operation.missing-argument": Text(
        "Die Bedienung „{request:request}“ braucht das Feld {name}.",
        "Das Feld in der Anfrage ergänzen.",
    ),
    "operation.door-open": Text(
        "Die Schutztür von {name} ist offen. Nichts wurde gesendet.",
        "Die Schutztür schließen, dann „Freigeben“ drücken.",
    ),
    "operation.nothing-held": Text(
        "{name} ist nicht angehalten, also gibt es nichts freizugeben.",
        "Sperrt ein Alarm die Maschine, sie entsperren oder eine Referenzfahrt machen.",
    ),
    "operation.no-controller": Text(
        "Das Gateway von {machine} ist nicht mit der Steuerung der Maschine verbunden.",
        "Die Steuerung einschalten und ihr Kabel prüfen.",
    ),
    "operation.no-result": Text(
        "Das Gateway hat die Bedienung erhalten, aber ihr Ergebnis nicht gemeldet.",
        "Die Maschine ansehen, bevor etwas anderes angefordert wird.",
    ),
    "operation.not-at-rest": Text(
        "{name} steht nicht: Der gemeldete Zustand ist {state}. Nichts wurde gesendet.",
        "Warten, bis die Maschine steht. Ist sie im Alarm, sie entsperren oder eine Referenzfahrt "
        "machen.",
    ),
    "operation.not-lifted": Text(
        "Das Werkzeug ist nicht gehoben: Z ist unter {height:g}. Nichts wurde gesendet.",
        "Die Maschine parken oder Z zuerst nach oben fahren.",
    ),
    "operation.not-locked": Text(
        "{name} ist nicht durch einen Alarm gesperrt, also gibt es nichts zu entsperren.",
    ),
    "operation.no-station": Text(
        "{machine} hat keine Station {station}, oder es wurde kein Punkt für sie angegeben.",
        "Eine Station der Maschine und einen Punkt auf ihrem Tisch wählen.",
    ),
    "operation.no-spindle": Text(
        "Station {station} von {machine} hat keine Spindel oder Oszillation, die von Hand "
        "geschaltet wird.",
        "Eine Station mit oszillierendem Messer oder mit Fräser wählen.",
    ),
    "operation.stopped": Text(
        "Jemand hat {name} gestoppt, bevor die Bedienung ausgeführt war.",
    ),
    "operation.unknown": Text(
        "Es gibt keine Bedienung {id} von {machine}.",
        "Die Bedienung noch einmal anfordern: Sie werden nur kurz aufbewahrt.",
    ),
    "operation.override-not-confirmed": Text(
        "{name} meldet eine Vorschubanpassung von {found} % statt {percent} %.",
        "Die Taste noch einmal drücken; ändert sie sich nicht, an der Steuerung nachsehen.",
    ),
    "operation.unknown-axis": Text(
        "Die Maschine hat keine Achse „{axis}“.",
        "Buchstaben aus {axes} verwenden.",
    ),
    "operation.unknown-output": Text(
        "Die Maschine hat keinen Ausgang {output}.",
        "Einen ihrer Ausgänge verwenden: {outputs}.",
    ),
    "operation.unreported": Text(
        "Die Steuerung von {machine} nimmt ganze Programme an und meldet nichts zurück, also kann "
        "sie „{request:request}“ nicht ausführen.",
        "Die Maschine selbst bedienen. Um die Bahn ohne Arbeit zu sehen, das Werkzeug heben oder "
        "herausnehmen, oder das Programm mit einem Stift zeichnen.",
    ),
    "operation.unsupported": Text(
        "{name} kann „{request:request}“ nicht ausführen.",
        "Es an der Maschine ausführen.",
    ),
}
