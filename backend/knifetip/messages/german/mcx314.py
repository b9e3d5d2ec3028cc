"""mcx314: German texts of the messages of ``catalogue.mcx314``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "mcx314.no-wiring": Text(
        "Die Maschinendatei von {machine} nennt nicht, wie die Achsen mit dem Bewegungsbaustein "
        "MCX314 verbunden sind.",
        "Der Maschinendatei die Tabelle [controller] mit den Impulsen und Geschwindigkeiten der "
        "Achsen hinzufügen.",
    ),
    "mcx314.bad-rate": Text(
        "{path} ist {value}, muss aber ein Vielfaches von {step} und höchstens {limit} sein",
        "Einen anderen Wert wählen. Die Schritte ergeben sich aus dem Vielfachen der "
        "Antriebsgeschwindigkeit, das [controller] nennt.",
    ),
    "mcx314.axis-too-fast": Text(
        "{path} braucht {rate:.0f} Impulse je Sekunde, aber der Baustein MCX314 macht höchstens "
        "{limit:,}",
        "Eine niedrigere Geschwindigkeit, weniger Impulse je Millimeter oder Grad oder ein "
        "größeres Vielfaches der Antriebsgeschwindigkeit wählen.",
    ),
    "mcx314.axis-too-long": Text(
        "{path} ist {pulses:,} Impulse lang, aber der Baustein MCX314 zählt höchstens {limit:,} in "
        "einem Segment",
        "Weniger Impulse je Millimeter oder Grad wählen.",
    ),
    "mcx314.feed-too-slow": Text(
        "{path} ergibt entlang einer Diagonale {rate:.0f} Impulse je Sekunde, aber Programme "
        "brauchen für einen genauen Vorschub mindestens {limit:.0f}",
        "Einen größeren Vorschub oder mehr Impulse je Millimeter wählen.",
    ),
    "mcx314.tool-not-supported": Text(
        "{path} ist ein Werkzeug, das während eines Schnitts ein- und ausgeschaltet werden muss, "
        "was ein Programm für einen MCX314 nicht kann",
        "In dieser Station ein Messer, ein Rillrad, ein V-Messer oder einen Fräser verwenden.",
    ),
    "mcx314.spindle-not-supported": Text(
        "{path} nennt eine Richtung oder eine Drehzahl, aber ein Programm für einen MCX314 kann "
        "die Spindel nur ein- und ausschalten",
        "spindle und spindle_speed entfernen und am Antrieb einstellen.",
    ),
    "mcx314.four-axes": Text(
        "{place} bewegt vier Achsen zugleich, aber der Baustein MCX314 kann nur drei bewegen.",
        "Das Werkzeug drehen lassen, bevor oder nachdem sich seine Tiefe ändert.",
    ),
    "mcx314.speed": Text(
        "{place} braucht {rate:.0f} Impulse je Sekunde, aber der Baustein MCX314 macht nur "
        "{slowest:,} bis {fastest:,}.",
        "Einen anderen Vorschub für das Werkzeug oder ein anderes Vielfaches der "
        "Antriebsgeschwindigkeit wählen.",
    ),
    "mcx314.too-far": Text(
        "{place} braucht {pulses:,} Impulse, aber der Baustein MCX314 zählt höchstens {limit:,} in "
        "einem Segment.",
        "Die Kante teilen oder weniger Impulse je Millimeter verwenden.",
    ),
    "mcx314.bad-header": Text(
        "Das Programm beginnt nicht mit „MCX314 {version}“.",
        "Prüfen, ob es ein Programm für einen MCX314 in dieser Version des Formats ist.",
    ),
    "mcx314.no-pulses": Text(
        "Die erste Anweisung muss PULSES mit den Impulsen von X, Y, Z und C sein.",
        "Das Programm neu erstellen.",
    ),
    "mcx314.other-pulses": Text(
        "Das Programm ist für andere Impulse je Millimeter oder Grad gemacht, als {machine} hat.",
        "Das Programm für diese Maschine erstellen.",
    ),
    "mcx314.bad-line": Text(
        "Die Zeile „{text}“ ist keine Anweisung.",
        "Die Zeile berichtigen.",
    ),
    "mcx314.no-newline": Text(
        "Die letzte Zeile endet nicht mit einem Zeilenumbruch.",
        "Die Datei ist vielleicht unvollständig: das Programm neu erstellen.",
    ),
    "mcx314.no-end": Text(
        "Das Programm endet nicht mit END.",
        "Die Datei ist vielleicht unvollständig: das Programm neu erstellen.",
    ),
    "mcx314.after-end": Text(
        "Das Programm geht nach END weiter.",
        "Die Zeilen nach END entfernen.",
    ),
    "mcx314.bad-axes": Text(
        "Die Zeile bewegt {count} Achsen zugleich, aber der Baustein MCX314 bewegt eine bis drei.",
        "Die Bewegung in Bewegungen von höchstens drei Achsen teilen.",
    ),
    "mcx314.out-of-range": Text(
        "Eine Zahl in der Zeile ist größer als {limit:,}, mehr kann der Baustein MCX314 nicht "
        "zählen.",
        "Die Bewegung in kürzere teilen.",
    ),
    "mcx314.unknown-position": Text(
        "Die Zeile bewegt eine Achse um Impulse, aber keine Zeile davor nennt, wo die Achse ist.",
        "Die Achse zuerst mit GO fahren.",
    ),
    "mcx314.bad-speed": Text(
        "Die Antriebsgeschwindigkeit muss {slowest:,} bis {fastest:,} Impulse je Sekunde sein.",
        "Die Antriebsgeschwindigkeit berichtigen.",
    ),
    "mcx314.bad-arc": Text(
        "Das Ende des Kreisbogens liegt nicht auf seinem Kreis, oder der Bogen ist ein Punkt oder "
        "ein ganzer Kreis.",
        "Das Ende oder den Mittelpunkt berichtigen.",
    ),
    "mcx314.no-circle": Text(
        "Die Zeile ist ein Kreisbogen, aber X und Y haben verschiedene Impulse je Millimeter.",
        "Den Kreisbogen durch Linien ersetzen.",
    ),
    "mcx314.joins-nothing": Text(
        "Die Anweisung JOIN setzt die Bewegung der Zeile davor fort, aber diese Zeile ist weder "
        "Linie noch Kreisbogen.",
        "JOIN entfernen.",
    ),
    "mcx314.joins-short": Text(
        "Die Anweisung JOIN folgt auf ein Segment, das nur {milliseconds:.3g} ms dauert, aber das "
        "Schreiben des nächsten Segments in den Baustein dauert bis zu {refill:.3g} ms.",
        "JOIN entfernen oder das Segment davor verlängern.",
    ),
    "mcx314.unknown-output": Text(
        "Die Maschine hat keinen Ausgang {output}.",
        "Die Nummer berichtigen.",
    ),
    "mcx314.wrong-dwell": Text(
        "Die Verweilzeit muss {needed} ms dauern, so lange braucht die gewählte Station nach dem "
        "Schalten.",
        "Die Verweilzeit berichtigen.",
    ),
    "mcx314.not-settled": Text(
        "Eine Bewegung beginnt schon {seconds:g} s nach dem Schalten eines Ausgangs oder der "
        "Oszillation.",
        "Vor der Bewegung eine Verweilzeit einfügen, so lange wie die Station nach dem Schalten "
        "braucht.",
    ),
    "mcx314.ends-lowered": Text(
        "Am Ende des Programms ist Ausgang {output} an.",
        "Ihn vor END ausschalten.",
    ),
    "mcx314.ends-oscillating": Text(
        "Am Ende des Programms ist die Oszillation an.",
        "Sie vor END ausschalten.",
    ),
    "mcx314.unknown-line": Text(
        "Programmzeile {line} ({text}) ist keine Anweisung für einen MCX314.",
        "Den Auftrag für diese Maschine neu berechnen.",
    ),
    "mcx314.pulses-of-board": Text(
        "Das Programm nennt andere Impulse je Millimeter oder Grad, als {name} hat.",
        "[controller] in der Maschinendatei mit den Einstellungen der Karte vergleichen, dann den "
        "Auftrag neu berechnen.",
    ),
    "mcx314.lost": Text(
        "Die Verbindung zu {name} ist verloren.",
        "Das Kabel zur Steuerkarte prüfen, dann den Bogen auf dem Tisch prüfen.",
    ),
    "mcx314.silent": Text(
        "{name} hat seit {seconds:g} s nicht geantwortet.",
        "Prüfen, ob die Steuerkarte eingeschaltet ist, dann den Bogen auf dem Tisch prüfen.",
    ),
    "mcx314.unreadable": Text(
        "{name} hat eine Antwort gegeben, die nicht von einer Karte mit MCX314 stammt: {answer}",
        "Die Adresse der Steuerung prüfen.",
    ),
    "mcx314.refused": Text(
        "{name} hat {request} abgelehnt: {code}.",
        "Den Tisch prüfen, dann noch einmal versuchen.",
    ),
    "mcx314.reset": Text(
        "{name} wurde ausgeschaltet oder zurückgesetzt. Alle Ausgänge wurden gelöst, und die "
        "Position ist unbekannt.",
        "Prüfen, dass das Werkzeug nicht im Karton steckt, dann eine Referenzfahrt machen.",
    ),
    "mcx314.gave-up": Text(
        "{name} hat seit {seconds:g} s nichts von diesem Gateway erhalten und das Programm "
        "angehalten.",
        "Die Verbindung zur Steuerkarte prüfen, dann den Bogen auf dem Tisch prüfen.",
    ),
    "mcx314.stopped": Text(
        "{name} hat das Programm bei Zeile {line} verworfen.",
        "Ein anderes Programm ist vielleicht mit der Steuerkarte verbunden. Den Bogen auf dem "
        "Tisch prüfen.",
    ),
    "mcx314.not-at-rest": Text(
        "{name} stand nach {seconds:g} s nicht still.",
        "Am Tisch das Werkzeug heben und die Stationen anheben.",
    ),
    "mcx314.not-lifted": Text(
        "Die Ausgänge sind aus, aber das Werkzeug wurde nicht gehoben. {cause}",
        "{cause:hint}",
    ),
    "mcx314.alarm-unhomed": Text(
        "Die Achsen von {name} haben keine Referenzfahrt gemacht, ihre Positionen sind also "
        "unbekannt.",
        "Prüfen, dass das Werkzeug nicht im Karton steckt, dann eine Referenzfahrt machen.",
    ),
    "mcx314.alarm-emergency": Text(
        "{name} ist im Not-Halt.",
        "Die Ursache beheben, den Taster lösen, entsperren und eine Referenzfahrt machen.",
    ),
    "mcx314.alarm-limit": Text(
        "Die Achse {axis} von {name} steht an ihrem Endschalter.",
        "Den Tisch prüfen, dann entsperren und eine Referenzfahrt machen.",
    ),
    "mcx314.alarm-drive": Text(
        "Der Antrieb der Achse {axis} von {name} meldet eine Störung.",
        "Die Störung am Antrieb beheben, dann entsperren und eine Referenzfahrt machen.",
    ),
    "mcx314.alarm-chip": Text(
        "Der Bewegungsbaustein von {name} hat ein Segment zu spät bekommen oder abgelehnt.",
        "Den Bogen auf dem Tisch prüfen, dann entsperren und eine Referenzfahrt machen. In der "
        "Maschinendatei einen langsameren Vorschub oder mit refill mehr Zeit für das nächste "
        "Segment wählen.",
    ),
    "mcx314.alarm-other": Text(
        "{name} meldet den Alarm {alarm}.",
        "Den Tisch prüfen, dann entsperren und eine Referenzfahrt machen.",
    ),
}
