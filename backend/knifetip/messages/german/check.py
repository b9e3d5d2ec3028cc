"""check: German texts of the messages of ``catalogue.check``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "check.begun-sheet": Text(
        "Der begonnene Bogen von Auftrag {job} liegt unbewegt an seinem Platz.",
    ),
    "check.board": Text(
        "Das Material auf dem Tisch ist {board}. {caliper}",
    ),
    "check.caliper": Text(
        "Es ist {caliper:g} mm dick.",
    ),
    "check.fed-sheet": Text(
        "ein Bogen vom Stapel liegt an seinem Platz",
    ),
    "check.fed-table": Text(
        "der Bogen davor wurde abgenommen",
    ),
    "check.hands": Text(
        "Hände und Personen sind nicht im Bereich der Maschine.",
    ),
    "check.named": Text(
        "{id} ({text})",
    ),
    "check.setup": Text(
        "Vorbereitet: {note}",
    ),
    "check.sheet-at-stops": Text(
        "Der gedruckte Bogen liegt an den Anschlägen, genau dort, wo die Zeichnung beginnt. "
        "{stated}",
    ),
    "check.sheet-larger": Text(
        "Ein Bogen, der größer ist als die Zeichnung, liegt an seinem Platz. {place}",
    ),
    "check.sheet-measured": Text(
        "Der gedruckte Bogen liegt unbewegt, seit seine Marken gemessen wurden. {stated}",
    ),
    "check.sheet-outline": Text(
        "Der Bogen, auf die Außenkontur der Zeichnung zugeschnitten, liegt an seinem Platz. "
        "{place}",
    ),
    "check.sheet-place": Text(
        "Seine linke untere Ecke ist bei X {x:g}, Y {y:g} mm.",
    ),
    "check.drawing-place": Text(
        "Die linke untere Ecke der Zeichnung ist bei X {x:g}, Y {y:g} mm.",
    ),
    "check.sheet-size": Text(
        "Ein Bogen von {width:g} × {height:g} mm liegt an seinem Platz. {place}",
    ),
    "check.station": Text(
        "In Station {station} ist {tool}, und das Werkzeug ist unbeschädigt.",
    ),
    "check.table": Text(
        "Außer dem Bogen liegt nichts auf dem Tisch.",
    ),
    "check.table-next": Text(
        "Der fertige Bogen ist abgenommen, und außer dem neuen liegt nichts auf dem Tisch.",
    ),
    "check.unfinished-sheet": Text(
        "Der unfertige Bogen von Auftrag {job} ist abgenommen.",
    ),
}
