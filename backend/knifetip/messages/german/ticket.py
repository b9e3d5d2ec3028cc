"""ticket: German texts of the messages of ``catalogue.ticket``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "ticket.accepted": Text("Angenommene Einschränkungen"),
    "ticket.accepted-by": Text("{finding} – angenommen von {by}, {at}: {reason}"),
    "ticket.board": Text("Material"),
    "ticket.board-thickness": Text("{board}, {caliper:g} mm dick"),
    "ticket.boxes": Text(
        "Ein Kästchen □ steht für ein Zeichen, das in den Schriften des Servers fehlt.",
    ),
    "ticket.changed": Text(
        "{drawing}, Revision {revision}. GEÄNDERT, nachdem dieser Auftrag bestellt wurde; das Bild "
        "zeigt die jetzige Zeichnung",
    ),
    "ticket.copies": Text("Exemplare"),
    "ticket.customer": Text("Kunde"),
    "ticket.drawing": Text("Zeichnung"),
    "ticket.due": Text("Fällig"),
    "ticket.job": Text("Auftrag {job}"),
    "ticket.hours": Text("{time} h"),
    "ticket.kind-crease-wheel": Text("Rillrad"),
    "ticket.kind-cutter": Text("Fräser"),
    "ticket.kind-knife": Text("Messer"),
    "ticket.kind-laser": Text("Laser"),
    "ticket.kind-v-cutter": Text("V-Messer"),
    "ticket.length": Text("Länge im Material"),
    "ticket.lengths": Text("Längen der Zeichnung"),
    "ticket.line-type": Text("{type:type}: {length:,.2f} m"),
    "ticket.machine": Text("Maschine"),
    "ticket.marks": Text("Marken"),
    "ticket.metres": Text("{length:,.2f} m"),
    "ticket.minutes": Text("{time} min"),
    "ticket.more": Text("und {count:# weitere|# weitere}"),
    "ticket.no-program": Text(
        "Es gibt noch kein Programm (Zustand: {state:state}). Nicht mit diesem Auftragszettel "
        "beginnen.",
    ),
    "ticket.no-value": Text("–"),
    "ticket.no-verdict": Text(
        "Das Programm ist nicht geprüft (Zustand: {state:state}). Nicht mit diesem Auftragszettel "
        "beginnen.",
    ),
    "ticket.notes": Text("Hinweise für den Bediener"),
    "ticket.order": Text("Bestellung"),
    "ticket.page": Text("Gedruckt {at} · Seite {page} von {pages}"),
    "ticket.place": Text("Platz auf dem Tisch"),
    "ticket.place-at": Text("linke untere Ecke des Bogens bei X {x:.1f}, Y {y:.1f} mm"),
    "ticket.place-drawing": Text("linke untere Ecke der Zeichnung bei X {x:.1f}, Y {y:.1f} mm"),
    "ticket.refused": Text(
        "ABGELEHNT: Das Programm macht die Zeichnung nicht wie gezeichnet; Befunde, die es "
        "ablehnen: {count}. Nicht mit diesem Auftragszettel beginnen.",
    ),
    "ticket.revision": Text("{drawing}, Revision {revision}"),
    "ticket.scan": Text("Station öffnen"),
    "ticket.seconds": Text("{seconds} s"),
    "ticket.sheet": Text("Bogen"),
    "ticket.sheet-any": Text("größer als die Zeichnung; seine Größe ist nicht angegeben"),
    "ticket.sheet-size": Text(
        "{width:g} × {height:g} mm, Ränder {left:g} mm links, {below:g} mm unten",
    ),
    "ticket.station": Text("Station"),
    "ticket.stations": Text("Einzusetzende Werkzeuge"),
    "ticket.time": Text("Zeit"),
    "ticket.tenths": Text("{seconds:.1f} s"),
    "ticket.times": Text("Maschinenzeit"),
    "ticket.times-all": Text("{each} je Exemplar, {all} für alle (ohne Wechsel des Bogens)"),
    "ticket.title": Text("Auftragszettel"),
    "ticket.tool": Text("Werkzeug"),
    "ticket.tool-blade": Text("Klinge {width:g} mm breit, {angle:g}° schräg"),
    "ticket.tool-cutter": Text("Ø {diameter:g} mm"),
    "ticket.tool-groove": Text("{tilt:g}° geneigt, d {back:g} mm, r {half_width:g} mm"),
    "ticket.tool-laser": Text("Schnittfuge {kerf:g} mm"),
    "ticket.tool-oscillating": Text("oszillierende Klinge {width:g} mm breit, {angle:g}° schräg"),
    "ticket.tool-wheel": Text("Ø {diameter:g} mm, Kranz {width:g} mm"),
    "ticket.verdict": Text("Prüfung des Programms"),
    "ticket.verified": Text(
        "Das Programm macht die Zeichnung auf {deviation:.3f} mm genau ({tolerance:g} mm erlaubt) "
        "und schneidet höchstens {overcut:.2f} mm über das Ende einer Linie hinaus.",
    ),
    "ticket.verified-except": Text(
        "Das Programm macht die Zeichnung auf {deviation:.3f} mm genau ({tolerance:g} mm erlaubt), "
        "außer {count:# angenommenen Einschränkung|# angenommenen Einschränkungen}.",
    ),
}
