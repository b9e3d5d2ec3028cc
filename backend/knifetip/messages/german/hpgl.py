"""hpgl: German texts of the messages of ``catalogue.hpgl``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "hpgl.bad-address": Text(
        "„{address}“ ist nicht die Adresse eines Plotters.",
        "Als tcp://HOST oder serial:///dev/ttyUSB0?baud=9600&flow=rtscts schreiben; eine serielle "
        "Schnittstelle braucht flow=rtscts oder flow=xonxoff, wie am Plotter eingestellt. "
        "&buffer=1024 nennt, wie viele Bytes Verbindung und Plotter fassen.",
    ),
    "hpgl.bad-area": Text(
        "{path} ist {value}, muss aber [x0, y0, x1, y1] mit x0 < x1 und y0 < y1 sein",
        "Die Ecken des Bereichs in Plottereinheiten schreiben, die linke untere Ecke zuerst.",
    ),
    "hpgl.bad-byte": Text(
        "Die Programmzeile enthält das Byte {byte}, das in einem HPGL-Programm nicht erlaubt ist.",
        "Das Byte entfernen.",
    ),
    "hpgl.bad-feed": Text(
        "{place} hat einen Vorschub von {feed:g} mm/min, aber {device} kann nur Vielfache von "
        "{step:g} mm/min von {slowest:,} bis {fastest:,} mm/min.",
        "In der Maschinendatei einen dieser Vorschübe für das Werkzeug wählen.",
    ),
    "hpgl.bad-number": Text(
        "In der Programmzeile folgt auf ein Plus- oder Minuszeichen keine Zahl, oder eine Zahl "
        "hat zu viele Ziffern.",
        "Die Zahl berichtigen.",
    ),
    "hpgl.bad-range": Text(
        "{path} ist {value}, muss aber [kleinster, größter] mit 0 < kleinster ≤ größter sein",
        "Die beiden Werte in dieser Reihenfolge schreiben.",
    ),
    "hpgl.datum": Text(
        "{path} hat einen Versatz oder einen Ausgang, aber ein HPGL-Programm kann sie nicht "
        "verwenden: Die Maschine selbst speichert den Versatz der Werkzeuge und senkt sie",
        "Alle Werte von datum auf 0 setzen und output entfernen.",
    ),
    "hpgl.depth-change": Text(
        "{place} ändert die Tiefe des Werkzeugs während eines Schnitts, was HPGL nicht ausdrücken "
        "kann.",
        "Material und Werkzeug wählen, bei denen jeder Schnitt nur einen Durchgang braucht.",
    ),
    "hpgl.ends-down": Text(
        "Das Programm endet mit gesenktem Werkzeug.",
        "Das Werkzeug vor dem Ende des Programms heben (PU).",
    ),
    "hpgl.ends-with-pen": Text(
        "Das Programm endet mit gewähltem Stift.",
        "Den Stift vor dem Ende des Programms abwählen (SP0).",
    ),
    "hpgl.feed-not-supported": Text(
        "{path} ist {value:g} mm/min, aber {device} kann nur Vielfache von {step:g} mm/min von "
        "{slowest:g} bis {fastest:g}",
        "Einen dieser Vorschübe wählen.",
    ),
    "hpgl.force-out-of-range": Text(
        "Die Kraft (FS) in der Programmzeile liegt nicht zwischen {low} und {high}.",
        "Eine Kraft in diesem Bereich angeben.",
    ),
    "hpgl.initialised-again": Text(
        "Die Programmzeile initialisiert die Maschine (IN) ein zweites Mal.",
        "Das zweite IN löschen.",
    ),
    "hpgl.lone-letter": Text(
        "Die Programmzeile hat einen einzelnen Buchstaben, aber jede HPGL-Anweisung hat zwei "
        "Buchstaben.",
        "Die Anweisung berichtigen.",
    ),
    "hpgl.loose-number": Text(
        "Die Programmzeile hat eine Zahl, die zu keiner Anweisung gehört.",
        "Die Zahl löschen oder die Anweisung davor ergänzen.",
    ),
    "hpgl.moves-before-pa": Text(
        "Die Programmzeile bewegt das Werkzeug, bevor das Programm absolute Koordinaten (PA) "
        "gewählt hat.",
        "PA vor die erste Bewegung schreiben.",
    ),
    "hpgl.needs-no-number": Text(
        "Die Anweisung in dieser Programmzeile hat keine Zahl.",
        "Die Zahl löschen.",
    ),
    "hpgl.needs-one-number": Text(
        "Die Anweisung in dieser Programmzeile braucht genau eine Zahl.",
        "Eine Zahl angeben.",
    ),
    "hpgl.never-down": Text(
        "Der Werkzeugweg senkt nie ein Werkzeug, also würde nichts geschnitten.",
        "Mindestens einer Kante eine Linienart geben, für die die Maschine ein Werkzeug hat.",
    ),
    "hpgl.no-approach": Text(
        "Interner Fehler: {place} beginnt einen Schnitt, aber kein Eilgang führt zu seinem Anfang.",
        "Den Fehler mit der Zeichnung melden.",
    ),
    "hpgl.no-device": Text(
        "Die Maschinendatei von {machine} hat keine HPGL-Einstellungen.",
        "Die HPGL-Einstellungen unter [controller] in der Maschinendatei ergänzen: siehe die "
        "Seite „Connect a machine“ der Dokumentation.",
    ),
    "hpgl.no-force": Text(
        "{path} ist {value}, aber {device} hat keine Krafteinstellung (FS)",
        "force entfernen.",
    ),
    "hpgl.no-force-setting": Text(
        "Die Programmzeile setzt die Kraft (FS), aber die Maschine hat keine Krafteinstellung.",
        "FS entfernen.",
    ),
    "hpgl.no-instruction": Text(
        "Das Programm enthält keine Anweisung.",
        "Eine Datei mit einem HPGL-Programm wählen.",
    ),
    "hpgl.no-pen": Text(
        "Die Maschinendatei von {machine} weist der Arbeit {work} mit Station {station} keinen "
        "Stift zu.",
        "Der Maschinendatei ein [[controller.pen]] mit dieser Station und dieser Arbeit (Feld "
        "work) hinzufügen.",
    ),
    "hpgl.no-pen-selected": Text(
        "Die Programmzeile senkt das Werkzeug, aber kein Stift ist gewählt.",
        "Vor dieser Programmzeile einen Stift wählen (SP).",
    ),
    "hpgl.no-speed": Text(
        "Die Programmzeile schneidet, aber keine Geschwindigkeit wurde gesetzt.",
        "Vor dieser Programmzeile die Geschwindigkeit setzen (VS).",
    ),
    "hpgl.no-speed-setting": Text(
        "Die Programmzeile setzt die Geschwindigkeit (VS), aber die Maschine hat keine "
        "Geschwindigkeitseinstellung.",
        "VS entfernen.",
    ),
    "hpgl.no-terminator": Text(
        "Die letzte Anweisung des Programms hat kein Semikolon.",
        "Das Semikolon ergänzen oder das vollständige Programm noch einmal senden.",
    ),
    "hpgl.not-initialised": Text(
        "Die erste Anweisung des Programms ist nicht IN (initialisieren).",
        "IN an den Anfang des Programms schreiben.",
    ),
    "hpgl.outside-area": Text(
        "Die Programmzeile bewegt das Werkzeug aus dem Arbeitsbereich der Maschine hinaus.",
        "Die Zeichnung auf dem Tisch versetzen oder eine größere Maschine wählen.",
    ),
    "hpgl.not-raised": Text(
        "{name} hat seit {seconds:g} s keine Daten angenommen, der Befehl zum Heben des Werkzeugs "
        "konnte also nicht gesendet werden. Das Werkzeug ist vielleicht noch unten.",
        "Das Programm an der Maschine anhalten und das Werkzeug dort heben.",
    ),
    "hpgl.not-reached": Text(
        "{error} Die Maschine führt noch aus, was in ihrem Puffer ist, und das Werkzeug bleibt am "
        "Ende vielleicht unten.",
        "Das Programm an der Maschine anhalten und das Werkzeug dort heben.",
    ),
    "hpgl.pen-cannot": Text(
        "{path} ist „{work}“, aber das Werkzeug von Station {station} kann diese Arbeit nicht",
        "Den Stift einer anderen Station zuweisen oder im Feld work eine andere Arbeit wählen.",
    ),
    "hpgl.plunge-without-move": Text(
        "Die Programmzeile senkt das Werkzeug, aber keine Bewegung folgt, also ist die Richtung "
        "des Werkzeugs nicht bekannt.",
        "Nach der Anweisung PD eine Bewegung ergänzen.",
    ),
    "hpgl.press": Text(
        "{place} drückt eine Rille, die zum Rollen zu kurz ist: Das Werkzeug wird an einem Punkt "
        "gesenkt. Davor muss es in die Richtung der Rille gedreht werden, was HPGL nicht "
        "ausdrücken kann.",
        "Eine längere Rille zeichnen, ihre Linienart auf „Ignoriert“ setzen, oder eine andere "
        "Maschine wählen.",
    ),
    "hpgl.repeated-pen": Text(
        "{path} hat dieselbe Station und dieselbe Arbeit (Feld work) wie ein anderer Stift",
        "Einen der beiden Stifte entfernen oder für einen eine andere Arbeit wählen.",
    ),
    "hpgl.runs-on": Text(
        "Der Rest des Programms wird nicht an {name} gesendet. Die Maschine führt noch aus, was in "
        "ihrem Puffer ist, und hebt danach das Werkzeug.",
        "Vom Werkzeug fernbleiben, bis die Maschine steht, oder das Programm an der Maschine "
        "anhalten.",
    ),
    "hpgl.selects-while-down": Text(
        "Die Programmzeile wählt bei gesenktem Werkzeug einen Stift.",
        "Das Werkzeug heben (PU), bevor der Stift gewählt wird.",
    ),
    "hpgl.send-by-hand": Text(
        "Das Programm herunterladen und mit der Software der Schneidmaschine senden. Beim "
        "Schneiden an der Maschine bleiben, um sie anhalten zu können.",
    ),
    "hpgl.sets-while-down": Text(
        "Die Programmzeile setzt bei gesenktem Werkzeug die Geschwindigkeit (VS) oder die Kraft "
        "(FS).",
        "Das Werkzeug heben (PU), bevor Geschwindigkeit oder Kraft gesetzt wird.",
    ),
    "hpgl.slanted-plunge": Text(
        "{place} senkt oder hebt das Werkzeug schräg, was HPGL nicht ausdrücken kann.",
        "Ein Werkzeug wählen, das senkrecht in den Karton eintaucht.",
    ),
    "hpgl.speed-out-of-range": Text(
        "Die Geschwindigkeit (VS) in der Programmzeile liegt nicht zwischen {low} und {high}.",
        "Eine Geschwindigkeit in diesem Bereich angeben.",
    ),
    "hpgl.station-without-pen": Text(
        "{path} hat keinen Stift",
        "Ein [[controller.pen]] mit dieser Station hinzufügen.",
    ),
    "hpgl.swivel": Text(
        "{place} dreht den Kopf um die Messerspitze, weil die Maschinendatei einen Messerversatz "
        "(trail) setzt. HPGL kann diese Drehung nicht ausdrücken und braucht sie nicht: Eine "
        "HPGL-Maschine gleicht den Messerversatz selbst aus.",
        "trail des Messers in der Maschinendatei auf 0 setzen.",
    ),
    "hpgl.tool-not-supported": Text(
        "{path} ist weder Messer noch Rillwerkzeug, und HPGL kann andere Werkzeuge nicht steuern",
        "Die Station entfernen oder eine andere Steuerungssprache wählen.",
    ),
    "hpgl.swivel-depth": Text(
        "{path} ist {value:g} mm, aber ein HPGL-Programm kann die Tiefe eines gesenkten Werkzeugs "
        "nicht ändern",
        "swivel_depth auf 0 setzen.",
    ),
    "hpgl.trail": Text(
        "{path} (Messerversatz) ist {value:g} mm, aber eine HPGL-Maschine gleicht den Versatz "
        "ihres Messers selbst aus",
        "trail auf 0 setzen, oder free setzen, wenn das Gerät nicht ausgleicht.",
    ),
    "hpgl.travel": Text(
        "{path} reicht von {low:g} bis {high:g} mm, aber der Arbeitsbereich in den "
        "HPGL-Einstellungen von {least:g} bis {greatest:g} mm",
        "Den Verfahrweg der Achse verkleinern oder den Arbeitsbereich in den HPGL-Einstellungen "
        "berichtigen.",
    ),
    "hpgl.turn-in-board": Text(
        "Das Werkzeug dreht sich im Karton um {degrees:.2f}°, aber höchstens {most:.2f}° sind "
        "erlaubt.",
        "Das Werkzeug heben, bevor es sich dreht.",
    ),
    "hpgl.unknown-instruction": Text(
        "Die Anweisung {name} in der Programmzeile wird nicht unterstützt.",
        "Die Anweisung entfernen.",
    ),
    "hpgl.unknown-pen": Text(
        "Die Programmzeile wählt einen Stift, den die Maschine nicht hat.",
        "Einen Stift wählen, den die Maschinendatei nennt.",
    ),
    "hpgl.wrong-force": Text(
        "Die Programmzeile senkt Stift {pen} mit einer anderen Kraft als der dieses Stifts in der "
        "Maschinendatei (FS{force}).",
        "Vor dieser Programmzeile FS{force} schreiben.",
    ),
    "hpgl.x-without-y": Text(
        "Die Programmzeile hat eine X-Koordinate ohne Y-Koordinate.",
        "Beide Koordinaten angeben.",
    ),
}
