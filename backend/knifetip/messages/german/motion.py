"""motion: German texts of the messages of ``catalogue.motion``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "verify.beam-on-rapid": Text(
        "Der Laserstrahl ist während eines Eilgangs von {length:.3f} mm an.",
        "Den Strahl vor dem Eilgang ausschalten (M5).",
    ),
    "verify.beam-refocused": Text(
        "Der Laserstrahl ist an, während der Kopf um {height:.3f} mm auf- oder abfährt.",
        "Den Strahl ausschalten (M5), bevor sich die Höhe ändert.",
    ),
    "verify.beyond-rotation": Text(
        "Achse {joint} dreht auf {position:.3f}°, aber ihr Verfahrweg ist {low:g}° bis {high:g}°.",
        "Die Zeichnung auf dem Tisch drehen oder eine Maschine wählen, deren Achse weiter drehen "
        "kann.",
    ),
    "verify.beyond-travel": Text(
        "Achse {joint} fährt auf {position:.3f} mm, aber ihr Verfahrweg ist {low:g} bis {high:g} "
        "mm.",
        "Bei Achse X oder Y die Zeichnung auf dem Tisch versetzen oder eine größere Maschine "
        "wählen. Bei Achse Z die Höhen in der Maschinendatei prüfen.",
    ),
    "verify.cutter-at-rest": Text(
        "Der Fräser fährt durch den Karton, während seine Spindel aus ist.",
        "Die Spindel einschalten (M3), bevor der Fräser in den Karton eintaucht.",
    ),
    "verify.feed-of-other-axis": Text(
        "Station {station} ist auf einem weiteren Schlitten, und ihre Bewegung hat einen Vorschub "
        "in mm/min (G94). Eine Steuerung wendet ihn vielleicht nur auf den Weg des Portals an.",
        "Die Dauer der Bewegung im zeitreziproken Modus angeben (G93).",
    ),
    "verify.head-not-located": Text(
        "Ein Schlitten fährt entlang des Portals, während die Position von {other} unbekannt ist.",
        "Alle Schlitten am Anfang des Programms parken.",
    ),
    "verify.heads-too-near": Text(
        "Zwischen {first} und {second} bleiben nur {distance:.2f} mm. Ihr kleinster Abstand ist "
        "{least:g} mm.",
        "Den nicht benutzten Schlitten vor der Bewegung parken.",
    ),
    "verify.idle-head-low": Text(
        "Der Schlitten mit Achse {letter} wird nicht benutzt, aber {letter} ist auf {height:.2f} "
        "mm. Seine Werkzeuge sind erst ab {needed:.2f} mm über dem Karton.",
        "Den Schlitten heben, bevor ein anderer benutzt wird.",
    ),
    "verify.in-zone": Text(
        "Station {station} berührt die Sperrzone {zone}: Ihre Spitze ist {depth:.1f} mm unter der "
        "Oberkante der Zone, und ihr Werkzeug oder Halter ragt in die Zone.",
        "Um die Zone herumfahren oder das Werkzeug über sie heben.",
    ),
    "verify.knife-at-rest": Text(
        "Das oszillierende Messer schneidet, während seine Oszillation aus ist.",
        "Die Oszillation einschalten (M3), bevor das Messer in den Karton eintaucht.",
    ),
    "verify.laser-off": Text(
        "Der Laser fährt eine Kante entlang, während sein Strahl aus ist, also wird sie nicht "
        "geschnitten.",
        "Den Strahl vor der Kante einschalten (M3).",
    ),
    "verify.low-without-station": Text(
        "Der Kopf fährt auf {height:.2f} mm hinunter, während keine Station gewählt ist. Alle "
        "Werkzeuge sind erst ab {needed:.2f} mm über dem Karton.",
        "Eine Station wählen, bevor der Kopf hinunterfährt, und ihn heben, bevor sie abgewählt "
        "wird.",
    ),
    "verify.lowers-second": Text(
        "Die Programmzeile senkt Station {station}, während Station {other} vielleicht noch unten "
        "ist.",
        "Station {other} vor dieser Programmzeile anheben (M65 P{output}).",
    ),
    "verify.moves-before-stated": Text(
        "Das Programm bewegt den Kopf, bevor es ausschaltet: {thing}.",
        "Vor der ersten Bewegung ausschalten: {thing}. Nur ein Abheben senkrecht auf Z "
        "{height:.3f} mm oder höher darf davor kommen.",
    ),
    "verify.moves-overlap": Text(
        "Die Steuerung beginnt diese Bewegung, bevor die davor beendet ist. Achse C dreht in "
        "beiden verschieden, also verlässt die Spitze die Bahn um bis zu {distance:.3f} mm "
        "(Toleranz {tolerance:.3f} mm).",
        "Vor dieser Programmzeile einen Genauhalt einfügen (G4 P0).",
    ),
    "verify.moves-with-beam": Text(
        "Das Programm bewegt den Kopf, bevor es die Spindel ausschaltet (M5), ein Laserstrahl ist "
        "also vielleicht noch an.",
        "M5 vor die erste Bewegung schreiben.",
    ),
    "verify.never-stated": Text(
        "Das Programm schaltet nie aus: {thing}. Ein früheres Programm kann es angelassen haben.",
        "Am Anfang des Programms ausschalten: {thing}.",
    ),
    "verify.no-station": Text(
        "Die Programmzeile schneidet, aber vorher wurde keine Station (T und M6) gewählt.",
        "Die Station vor dem ersten Schnitt wählen.",
    ),
    "verify.oscillation-on": Text(
        "Station {station} bearbeitet den Karton, während die Oszillation an ist, obwohl ihr "
        "Werkzeug nicht oszillieren darf.",
        "Die Oszillation ausschalten (M5), bevor diese Station benutzt wird.",
    ),
    "verify.output": Text(
        "Ausgang {output} (M65 P{output})",
    ),
    "verify.output-off": Text(
        "Station {station} bearbeitet den Karton, während ihr Ausgang {output} aus ist, ihr "
        "Werkzeug ist also nicht gesenkt.",
        "Ausgang {output} einschalten (M64), bevor die Station benutzt wird.",
    ),
    "verify.plunge-without-move": Text(
        "Das Werkzeug ({tool:tool}) taucht bei X{x:.3f} Y{y:.3f} (Koordinaten des Bogens) in den "
        "Karton ein und verlässt ihn ohne eine Bewegung.",
        "Das Eintauchen löschen oder den Auftrag neu berechnen.",
    ),
    "verify.rapid-in-board": Text(
        "Ein Eilgang von Station {station} ist {depth:.3f} mm unter der Oberseite des Kartons.",
        "Das Werkzeug vor dem Eilgang über den Karton heben.",
    ),
    "verify.rapid-near-sheet": Text(
        "Ein Eilgang von Station {station} ist {depth:.3f} mm unter der Oberseite des Kartons, "
        "und er ist über dem Bogen, zu nahe am Bogen oder in der Matte.",
        "Das Werkzeug vor dem Eilgang über den Karton heben oder es um den Sicherheitsabstand der "
        "Maschine neben dem Bogen halten.",
    ),
    "verify.rapid-too-low": Text(
        "Ein Eilgang von Station {station} ist nur {height:.3f} mm über dem Karton; "
        "turn_clearance der Maschine ist {needed:g} mm.",
        "Das Werkzeug vor dem Eilgang höher heben.",
    ),
    "verify.spindle": Text(
        "die Spindel (M5)",
    ),
    "verify.switches-at-unknown-height": Text(
        "Die Programmzeile schaltet einen Ausgang oder die Spindel, bevor das Programm die Höhe "
        "des Kopfes gesetzt hat.",
        "Den Kopf vor dieser Programmzeile auf Z {needed:.3f} mm heben.",
    ),
    "verify.switches-low": Text(
        "Die Programmzeile schaltet einen Ausgang oder die Spindel, während Achse Z auf "
        "{height:.3f} mm ist, das ist zu tief.",
        "Den Kopf vor dieser Programmzeile auf Z {needed:.3f} mm heben.",
    ),
    "verify.turn-at-feed": Text(
        "Achse C dreht um {degrees:.4f}° in einer Programmzeile, deren Vorschub in mm/min ist, "
        "die Dauer der Drehung ist also nicht bestimmt.",
        "Die Dauer der Bewegung im zeitreziproken Modus angeben (G93).",
    ),
    "verify.turn-in-board": Text(
        "Achse C dreht um {degrees:.3f}°, während das Werkzeug im Karton ist, aber höchstens "
        "{most:.2f}° sind erlaubt.",
        "Das Werkzeug heben, bevor es sich dreht.",
    ),
    "verify.turn-off-path": Text(
        "Achse C dreht im Karton um {degrees:.3f}°, obwohl die Bahn des Werkzeugs um {path:.3f}° "
        "dreht.",
        "Das Werkzeug um denselben Winkel drehen wie die Bahn.",
    ),
    "verify.turn-overlaps": Text(
        "Die Steuerung wartet nicht zwischen der Drehung der Achse C um {degrees:.2f}° im Karton "
        "und der Bewegung daneben, das Werkzeug dreht sich also, während es fährt.",
        "Vor dieser Programmzeile einen Genauhalt einfügen (G4 P0).",
    ),
    "verify.two-lowered": Text(
        "Station {station} bearbeitet den Karton, während auch Station {other} gesenkt ist "
        "(Ausgang {output} ist an).",
        "Station {other} anheben (M65 P{output}), bevor diese Station benutzt wird.",
    ),
    "verify.unknown-beside-zone": Text(
        "Der Kopf fährt von einer unbekannten Position, und seine Spitze ist unter {top:g} mm, "
        "der Oberkante der Sperrzone {zone}, oder auf unbekannter Höhe. Die Bewegung kann durch "
        "die Zone führen.",
        "Z vor der ersten Bewegung in X oder Y über die Zone heben.",
    ),
    "verify.unknown-position": Text(
        "Die Programmzeile bewegt den Kopf von oder zu einer Position, die das Programm nicht "
        "gesetzt hat.",
        "Vor dieser Programmzeile X, Y, Z und C angeben.",
    ),
    "verify.wrong-feed": Text(
        "Station {station} hat einen Vorschub von {feed:g} mm/min statt {planned:g} mm/min.",
        "Den Auftrag mit der jetzigen Maschinendatei neu berechnen.",
    ),
    "verify.wrong-time": Text(
        "Die Bewegung von Station {station} dauert {seconds:.4f} s statt {planned:.4f} s.",
        "Den Auftrag mit der jetzigen Maschinendatei neu berechnen.",
    ),
}
