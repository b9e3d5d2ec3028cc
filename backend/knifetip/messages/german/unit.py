"""unit: German texts of the messages of ``catalogue.unit``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "unit.cf2-inches": Text(
        "die CF2-Datei nennt Zoll (Datensatz UI)",
    ),
    "unit.cf2-millimetres": Text(
        "die CF2-Datei nennt Millimeter (Datensatz UM)",
    ),
    "unit.cf2-none": Text(
        "die CF2-Datei nennt keine Einheit: sie hat weder einen Datensatz UM noch UI",
    ),
    "unit.cf2-scale-applied": Text(
        "die Koordinaten in der CF2-Datei wurden mit den Faktoren im Datensatz SCALE,{x:g},{y:g} "
        "multipliziert, damit die Zeichnung die Größe in den Datensätzen LL und UR hat",
    ),
    "unit.cf2-scale-invalid": Text(
        "die Faktoren im Datensatz SCALE,{x:g},{y:g} der CF2-Datei sind ungültig, also wurde er "
        "nicht beachtet",
    ),
    "unit.cf2-scale-not-applied": Text(
        "der Datensatz SCALE,{x:g},{y:g} der CF2-Datei wurde nicht beachtet, weil die Koordinaten "
        "schon die Größe in den Datensätzen LL und UR haben",
    ),
    "unit.cf2-scale-undecided": Text(
        "der Datensatz SCALE,{x:g},{y:g} der CF2-Datei wurde nicht beachtet, weil die Datensätze "
        "LL und UR nicht zeigen, ob die Koordinaten schon skaliert sind",
    ),
    "unit.cf2-scaled": Text(
        "{unit}; {scale}",
    ),
    "unit.corner-loops": Text(
        "bei der Einheit {unit:unit} haben die Konturen an {count} Ecken kleine Schleifen von "
        "{length:mm} mm, wie Programme für Laserschneider sie zeichnen",
    ),
    "unit.dimensions-larger": Text(
        "Bemaßungen in der Zeichnung haben verschiedene Maßstäbe: {count:# Maß ist|# Maße sind} "
        "{factor:.3g}-mal größer gezeichnet als {others:das andere|die anderen #}.",
        "Prüfen, welche Maße zur Schachtel gehören, und Details löschen, die in einem anderen "
        "Maßstab gezeichnet sind.",
    ),
    "unit.dimensions-smaller": Text(
        "Bemaßungen in der Zeichnung haben verschiedene Maßstäbe: {count:# Maß ist|# Maße sind} "
        "{factor:.3g}-mal kleiner gezeichnet als {others:das andere|die anderen #}.",
        "Prüfen, welche Maße zur Schachtel gehören, und Details löschen, die in einem anderen "
        "Maßstab gezeichnet sind.",
    ),
    "unit.drawn-in-imperial": Text(
        "Zoll (gespeichert als Zahlen in {unit:unit})",
    ),
    "unit.drawn-in-inches": Text(
        "Zoll",
    ),
    "unit.drawn-in-metric": Text(
        "Millimetern (gespeichert als Zahlen in {unit:unit})",
    ),
    "unit.drawn-in-millimetres": Text(
        "Millimetern",
    ),
    "unit.given": Text(
        "der Benutzer hat die Einheit der Zeichnung gesetzt",
    ),
    "unit.header": Text(
        "der Kopf der DXF-Datei nennt die Einheit der Zeichnung ($INSUNITS = {value})",
    ),
    "unit.header-decimal-inches": Text(
        "der Kopf der DXF-Datei zeigt Längen in Fuß und dezimalen Zoll ($LUNITS = 3)",
    ),
    "unit.header-factor": Text(
        "der Kopf der DXF-Datei multipliziert die gezeigten Maße mit {factor:g} ({variable})",
    ),
    "unit.header-fractions": Text(
        "der Kopf der DXF-Datei zeigt Längen in Fuß und Bruchteilen von Zoll ($LUNITS = 4)",
    ),
    "unit.header-imperial": Text(
        "der Kopf der DXF-Datei setzt britische Einheiten ($MEASUREMENT = 0)",
    ),
    "unit.header-metric": Text(
        "der Kopf der DXF-Datei setzt metrische Einheiten ($MEASUREMENT = 1)",
    ),
    "unit.header-missing": Text(
        "die DXF-Datei nennt keine Einheit ($INSUNITS fehlt)",
    ),
    "unit.header-not-a-number": Text(
        "der Kopf der DXF-Datei nennt keine gültige Einheit: $INSUNITS = „{value}“ ist keine Zahl",
    ),
    "unit.header-undefined": Text(
        "der Kopf der DXF-Datei nennt keine gültige Einheit: $INSUNITS = {value} ist nicht "
        "definiert",
    ),
    "unit.header-unitless": Text(
        "der Kopf der DXF-Datei sagt, dass die Zeichnung keine Einheit hat ($INSUNITS = 0)",
    ),
    "unit.header-unsupported": Text(
        "der Kopf der DXF-Datei nennt eine Einheit, die nicht unterstützt wird: {name:unit} "
        "($INSUNITS = {value})",
    ),
    "unit.imprecise": Text(
        "bei der Einheit {unit:unit} sind die Längen der Kanten zu ungenau, um zu zeigen, ob sie "
        "Vielfache einer runden Zahl sind",
    ),
    "unit.inconclusive": Text(
        "{stated}, und die Geometrie der Zeichnung spricht nicht deutlich genug für {unit:unit}",
    ),
    "unit.lightburn": Text(
        "LightBurn-Projekte nennen alle Längen in Millimetern",
    ),
    "unit.multiples": Text(
        "bei der Einheit {unit:unit} {count:ist|sind} {count} von {all} verschiedenen "
        "Kantenlängen ({percent:.0f} % der Gesamtlänge) {count:ein Vielfaches|Vielfache} von "
        "{grid}",
    ),
    "unit.no-number-matches": Text(
        "bei der Einheit {unit:unit} passt keine Kantenlänge zu {all:der Zahl|einer der # Zahlen} "
        "in den Texten der Zeichnung",
    ),
    "unit.not-given": Text(
        "die Einheit der Zeichnung ist nicht bekannt",
    ),
    "unit.of-layout": Text(
        "ein Layout ist in Millimetern",
    ),
    "unit.number": Text(
        "{text}",
    ),
    "unit.number-in": Text(
        "{text} ({unit:unit})",
    ),
    "unit.numbers-match": Text(
        "bei der Einheit {unit:unit} {count:ist|sind} {count} von {all} Zahlen in den Texten der "
        "Zeichnung gleich der Länge einer Kante: {numbers:, }",
    ),
    "unit.numbers-match-often": Text(
        "bei der Einheit {unit:unit} sind {count} von {all} Zahlen in den Texten der Zeichnung "
        "gleich der Länge einer Kante, zum Beispiel {numbers:, }",
    ),
    "unit.overruled": Text(
        "{stated}, aber die Einheit der Zeichnung ist wahrscheinlicher {unit:unit}: {reason}",
    ),
    "unit.page-in-pixels": Text(
        "die Datei nennt die Größe ihrer Seite ohne Einheit, wie Dateien in Pixeln oder Punkten",
    ),
    "unit.paper-size": Text(
        "bei der Einheit {unit:unit} hat die Zeichnung genau die Größe eines Papierformats "
        "({sheet})",
    ),
    "unit.part-drawn-twice": Text(
        "Die Zeichnung enthält dasselbe Teil in zwei Größen, eine davon {factor:.3g}-mal größer "
        "als die andere. Eines der beiden ist ein Detail oder wurde mit falscher Einheit "
        "eingefügt.",
        "Das Teil mit der falschen Größe löschen oder die Linienart seiner Kanten auf „Ignoriert“ "
        "setzen.",
    ),
    "unit.parts-differ": Text(
        "Teile der Zeichnung haben verschiedene Einheiten: ein Teil ist in {one} gezeichnet, ein "
        "anderes in {other}.",
        "Eines der Teile im CAD-Programm skalieren und die Zeichnung noch einmal exportieren.",
    ),
    "unit.pdf": Text(
        "das PDF nennt seine Koordinaten in Punkt (1/72 Zoll)",
    ),
    "unit.pdf-scaled": Text(
        "das PDF nennt seine Koordinaten in Einheiten von {scale:g} Punkt (UserUnit); ein Punkt "
        "ist 1/72 Zoll",
    ),
    "unit.plotter": Text(
        "die Plotterdatei (HPGL) nennt ihre Koordinaten in Einheiten von 1/40 mm oder nennt ihren "
        "Maßstab",
    ),
    "unit.plotter-page": Text(
        "die Plotterdatei (HPGL) nennt den Maßstab ihrer Koordinaten relativ zum Papier des "
        "Plotters (SC ohne IP), und die Größe des Papiers ist nicht bekannt",
    ),
    "unit.read-against-evidence": Text(
        "Die Einheit der Zeichnung ist am wahrscheinlichsten {best:unit} ({best_width:mm} × "
        "{best_height:mm} mm), aber die Zeichnung wurde mit der Einheit {unit:unit} eingelesen "
        "({width:mm} × {height:mm} mm).",
        "Die Größe der Zeichnung prüfen und eine andere Einheit wählen, wenn sie falsch ist.",
    ),
    "unit.read-against-header": Text(
        "Die Datei nennt die Einheit {stated:unit} ({stated_width:mm} × {stated_height:mm} mm), "
        "aber die Zeichnung wurde mit der Einheit {unit:unit} eingelesen ({width:mm} × "
        "{height:mm} mm).",
        "Die Größe der Zeichnung prüfen und eine andere Einheit wählen, wenn sie falsch ist.",
    ),
    "unit.scale-mentioned": Text(
        "Ein Text in der Zeichnung erwähnt den Maßstab {scales:, }, die Zeichnung hat also "
        "vielleicht nicht ihre wahre Größe.",
        "Die Größe der Zeichnung prüfen.",
    ),
    "unit.share-stated": Text(
        "die Datei nennt die Einheit {stated:unit}, und knifetip nimmt an, dass {percent:.3g} % "
        "der Dateien mit dieser Angabe in {unit:unit} gezeichnet sind",
    ),
    "unit.share-unstated": Text(
        "die Datei nennt keine Einheit, und knifetip nimmt an, dass {percent:.3g} % der Dateien "
        "ohne diese Angabe in {unit:unit} gezeichnet sind",
    ),
    "unit.shortest-edges": Text(
        "bei der Einheit {unit:unit} sind die kürzesten Kanten der Zeichnung {length:mm} mm lang",
    ),
    "unit.size-unusual": Text(
        "bei der Einheit {unit:unit} misst die Zeichnung {width:mm} × {height:mm} mm, eine "
        "ungewöhnliche Größe für eine Schachtel",
    ),
    "unit.size-usual": Text(
        "bei der Einheit {unit:unit} misst die Zeichnung {width:mm} × {height:mm} mm, eine "
        "übliche Größe für eine Schachtel",
    ),
    "unit.svg-no-size": Text(
        "die SVG-Datei hat weder Breite noch Höhe, und {pixel}",
    ),
    "unit.svg-no-unit": Text(
        "die SVG-Datei nennt ihre Größe ohne Längeneinheit ({size: }), und {pixel}",
    ),
    "unit.svg-pixel": Text(
        "eine Koordinateneinheit ist im Browser 1/96 Zoll (0,2646 mm), in Illustrator aber 1/72 "
        "Zoll (0,3528 mm) und in alten Versionen von Inkscape 1/90 Zoll (0,2822 mm)",
    ),
    "unit.svg-size": Text(
        "die SVG-Datei nennt ihre Größe ({size: }) für eine viewBox von {width:g} × {height:g} "
        "Koordinateneinheiten",
    ),
    "unit.svg-size-in-pixels": Text(
        "die SVG-Datei nennt ihre Größe ({size: }) und hat keine viewBox, Koordinaten sind also "
        "in {pixel:unit}",
    ),
    "unit.svg-writer": Text(
        "das Programm, das die SVG-Datei geschrieben hat, verwendet {pixel:unit} als Einheit",
    ),
    "unit.text-states": Text(
        "ein Text in der Zeichnung nennt die Einheit: „{text}“",
    ),
    "unit.unsupported": Text(
        "„{unit}“ ist keine unterstützte Längeneinheit.",
        "Eine von {known:or} wählen.",
    ),
    "unit.writer": Text(
        "die Datei wurde von {writer} geschrieben, das Längen in mm schreibt",
    ),
}
