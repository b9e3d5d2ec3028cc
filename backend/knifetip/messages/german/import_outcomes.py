"""import_outcomes: German texts of the messages of ``catalogue.import_outcomes``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "import.added-by-hand": Text("die Kante wurde von Hand hinzugefügt"),
    "import.all-outside-page": Text(
        "die ganze Zeichnung liegt außerhalb des sichtbaren Bereichs der Seite",
        "Die Zeichnung in ihrem Programm auf die Seite schieben, damit Objekte neben der Seite "
        "wegbleiben.",
    ),
    "import.angles-not-numbers": Text(
        "der Anfangs- oder Endwinkel des Kreisbogens ist keine Zahl",
    ),
    "import.annotations": Text(
        "{count:# Notiz oder Formularfeld|# Notizen und Formularfelder} auf der PDF-Seite "
        "{count:wird|werden} nicht geschnitten",
    ),
    "import.area-outline": Text(
        "das Objekt ist der Umriss einer gefüllten Fläche, der eingelesen wurde, weil die "
        "Zeichnung keine Linien hat",
    ),
    "import.area-outline-on-page": Text(
        "das Objekt ist der Umriss einer gefüllten Fläche, der eingelesen wurde, weil die Seite "
        "keine Linien hat",
    ),
    "import.area-outline-round-lines": Text(
        "das Objekt ist der Umriss einer gefüllten Fläche; er wurde eingelesen, weil die Linien "
        "auf dieser Fläche keinen eigenen geschlossenen Umriss haben",
    ),
    "import.array": Text(
        "das Objekt fügt den Block als Raster von Kopien ein ({columns} Spalten × {rows} Zeilen)",
    ),
    "import.aspect-ratio": Text(
        "Die Größe der Seite ({size: }) hat nicht das Verhältnis ihrer viewBox ({width:g} × "
        "{height:g}): Die Breite ergibt den Maßstab {across:.4g}, die Höhe {down:.4g}. Die "
        "Zeichnung wird im Maßstab {used:.4g} gelesen, wie Browser sie anzeigen.",
        "Die Größe der Zeichnung prüfen. Ist sie falsch, die Seitengröße in ihrem Programm "
        "berichtigen und noch einmal exportieren.",
    ),
    "import.bad-operands": Text(
        "der Pfad verwendet den PDF-Operator „{operator}“ mit falscher Anzahl oder Art von Werten",
    ),
    "import.bad-path-data": Text(
        "die Pfaddaten des Objekts sind bei Zeichen {character} ungültig („{text}“)",
        "Das Objekt in seinem Programm berichtigen und die Zeichnung noch einmal exportieren.",
    ),
    "import.bad-place": Text(
        "die Position des Objekts kann nicht gelesen werden: {reason}",
    ),
    "import.bad-points": Text(
        "die Punkte des Objekts können nicht gelesen werden: „{points}“",
    ),
    "import.bad-primitive": Text(
        "der Pfad des Objekts verbindet Punkte, die es nicht hat, oder auf unbekannte Art "
        "(„{kind}“ von {first} nach {second})",
        "Das Objekt in seinem Programm berichtigen und die Zeichnung noch einmal exportieren.",
    ),
    "import.bad-radius": Text(
        "der Radius des Objekts ist {radius:g}, muss aber größer als 0 sein",
    ),
    "import.bad-size": Text(
        "das Attribut {name} des Objekts kann nicht gelesen werden: {reason}",
    ),
    "import.bad-transform": Text(
        "das Attribut transform des Objekts kann nicht gelesen werden: {reason}",
    ),
    "import.bad-value": Text(
        "der Wert „{value}“ ist keine Länge",
    ),
    "import.bad-window": Text(
        "Position oder Größe der inneren Zeichnung kann nicht gelesen werden: {reason}",
    ),
    "import.block-external": Text(
        "das Objekt fügt den Block „{block}“ ein, der in einer anderen Datei definiert ist",
        "Die externe Referenz im CAD-Programm binden und die Zeichnung noch einmal exportieren.",
    ),
    "import.block-in-itself": Text(
        "der Block „{block}“ fügt sich selbst ein",
    ),
    "import.block-missing": Text(
        "das Objekt fügt den Block „{block}“ ein, der in der Datei nicht definiert ist",
        "Die Definition des Blocks im CAD-Programm ergänzen und die Zeichnung noch einmal "
        "exportieren.",
    ),
    "import.bridge": Text(
        "die Linie des Stanzwerkzeugs hat 1 Haltesteg (Lücke), {width:g} Dateieinheiten breit; "
        "die Kante wird ohne Lücke geschnitten",
    ),
    "import.bridges": Text(
        "die Linie des Stanzwerkzeugs hat {bridges:g} Haltestege (Lücken), je {width:g} "
        "Dateieinheiten breit; die Kante wird ohne Lücken geschnitten",
    ),
    "import.changed": Text(
        "{objects:# Objekt wird|# Objekte werden} mit einer Änderung eingelesen: {reason}.",
        "Der Importbericht nennt {objects:es|sie}. {reason:hint}",
    ),
    "import.changed-on-layer": Text(
        "{objects:# Objekt|# Objekte} auf Layer „{layer}“ {objects:wird|werden} mit einer "
        "Änderung eingelesen: {reason}.",
        "Der Importbericht nennt {objects:es|sie}. {reason:hint}",
    ),
    "import.check-drawing": Text(
        "Die Zeichnung prüfen: {reason}.",
        "{reason:hint}",
    ),
    "import.clip-path": Text(
        "das Objekt begrenzt nur den sichtbaren Bereich anderer Objekte (Beschneidungspfad)",
    ),
    "import.clipped": Text(
        "nur der Teil des Objekts, der in seinem Beschneidungspfad oder seiner Maske sichtbar "
        "ist, wurde eingelesen",
        "Soll das ganze Objekt geschnitten werden, Beschneidungspfad oder Maske entfernen und die "
        "Zeichnung noch einmal exportieren.",
    ),
    "import.clipped-away": Text(
        "das Objekt liegt außerhalb seines Beschneidungspfads oder seiner Maske, ist also nicht "
        "sichtbar",
        "Soll das Objekt geschnitten werden, Beschneidungspfad oder Maske entfernen und die "
        "Zeichnung noch einmal exportieren.",
    ),
    "import.contains-itself": Text(
        "das Objekt enthält einen Verweis auf sich selbst",
    ),
    "import.conversion-doubtful": Text(
        "{program}, das die Datei umgewandelt hat, meldet {count:# Objekt oder Stelle, die es|# "
        "Objekte oder Stellen, die es} nicht umwandeln konnte ({losses}). Objekte der Zeichnung "
        "können fehlen oder falsch sein.",
        "Die Zeichnung mit dem Original vergleichen. {what:hint}",
    ),
    "import.converted": Text(
        "die Datei wurde von {program} umgewandelt",
    ),
    "import.coordinate-not-a-number": Text(
        "eine Koordinate des Objekts ist keine Zahl",
    ),
    "import.curves-fitted": Text(
        "die Kurven des Objekts wurden in {pieces:# Linie oder Kreisbogen|# Linien und "
        "Kreisbögen} umgewandelt, {pieces:die höchstens|die höchstens} {tolerance:.2g} "
        "Dateieinheiten von den Kurven {pieces:abweicht|abweichen}",
    ),
    "import.curves-fitted-relative": Text(
        "die Kurven des Objekts wurden in {pieces:# Linie oder Kreisbogen|# Linien und "
        "Kreisbögen} umgewandelt, mit höchstens {tolerance:.2g} Dateieinheiten Abweichung von den "
        "Kurven (1/250.000 der Größe der Zeichnung)",
    ),
    "import.damaged": Text(
        "das Objekt ist beschädigt: {reason}",
    ),
    "import.damaged-or-frame": Text(
        "das Objekt ist beschädigt oder nur der Rahmen um einen Text",
    ),
    "import.dimension": Text(
        "das Objekt ist eine Bemaßung oder ein Hinweis und wird nicht geschnitten",
    ),
    "import.drawn-twice": Text(
        "das Objekt ist doppelt gezeichnet: es hat Form und Lage wie {same:, }",
    ),
    "import.drawn-twice-often": Text(
        "das Objekt ist mehrfach gezeichnet: es hat Form und Lage wie {same:, } und {more} "
        "{more:weiteres Objekt|weitere Objekte}",
    ),
    "import.empty-path": Text(
        "der Pfad des Objekts ist leer",
    ),
    "import.end-mark": Text(
        "das Objekt (SEQEND) kennzeichnet nur das Ende einer Liste von Punkten oder Attributen",
    ),
    "import.endless-line": Text(
        "das Objekt ist eine unendlich lange Konstruktionslinie",
    ),
    "import.extrusion-not-a-number": Text(
        "die Extrusionsrichtung des Objekts ist keine Zahl",
    ),
    "import.few-vertices": Text(
        "das Objekt ist eine Polylinie mit {vertices:# Punkt|# Punkten}, braucht aber mindestens 2",
    ),
    "import.filled-area": Text(
        "das Objekt ist eine gefüllte Fläche ohne Umrisslinie und wird nicht geschnitten",
    ),
    "import.filled-area-beside-strokes": Text(
        "das Objekt ist eine gefüllte Fläche ohne Umrisslinie; der Umriss einer gefüllten Fläche "
        "wird nur geschnitten, wenn die Zeichnung keine Linien hat oder die Linien auf der Fläche "
        "keinen eigenen geschlossenen Umriss haben",
    ),
    "import.filled-area-on-page": Text(
        "das Objekt ist eine gefüllte Fläche ohne Umrisslinie; Umrisse gefüllter Flächen werden "
        "nur auf Seiten ohne Linien geschnitten",
    ),
    "import.fit-points": Text(
        "die Datei nennt nur die Durchgangspunkte der Kurve, also wurde sie durch diese Punkte "
        "gezeichnet",
    ),
    "import.font-shape": Text(
        "das Objekt ist ein Symbol aus einer Schriftdatei, das nicht gelesen werden kann",
        "Das Objekt im CAD-Programm in Linien auflösen und die Zeichnung noch einmal exportieren.",
    ),
    "import.hatch": Text(
        "das Objekt ist eine Schraffur (gefüllte Fläche), deren Rand nicht gelesen wird",
        "Soll der Rand geschnitten werden, ihn im CAD-Programm als Linien zeichnen und die "
        "Zeichnung noch einmal exportieren.",
    ),
    "import.height-not-a-number": Text(
        "die Höhe (z) des Objekts ist keine Zahl",
    ),
    "import.height-too-far": Text(
        "die Höhe (z) des Objekts ist {height:g} Dateieinheiten, erlaubt sind {limit:g}",
    ),
    "import.hidden": Text(
        "das Objekt ist ausgeblendet",
    ),
    "import.hidden-layer": Text(
        "das Objekt ist ausgeblendet, weil der Layer {layer} ausgeschaltet ist",
        "Soll das Objekt geschnitten werden, den Layer einschalten und die Zeichnung noch einmal "
        "exportieren.",
    ),
    "import.image": Text(
        "das Objekt ist ein Bild und wird nicht geschnitten",
    ),
    "import.incomplete": Text(
        "das Objekt ist unvollständig: {part} fehlt",
    ),
    "import.interrupted-path": Text(
        "der Pfad hat weder Linie noch Füllung, weil ein anderes Objekt beginnt, bevor er endet",
    ),
    "import.invisible": Text(
        "das Objekt ist als unsichtbar gekennzeichnet",
    ),
    "import.kept": Text(
        "das Objekt wurde unverändert eingelesen",
    ),
    "import.kept-changed": Text(
        "das Objekt wurde eingelesen; Hinweis: {notes:; }",
    ),
    "import.laid-flat": Text(
        "das Objekt wurde von der Höhe z = {height:g} Dateieinheiten auf z = 0 gelegt",
    ),
    "import.layer-frozen": Text(
        "der Layer des Objekts ist gefroren",
        "Soll das Objekt geschnitten werden, den Layer auftauen und die Zeichnung noch einmal "
        "exportieren.",
    ),
    "import.layer-never-plotted": Text(
        "CAD-Programme drucken den Layer des Objekts nie",
        "Soll das Objekt geschnitten werden, es auf einen anderen Layer legen und die Zeichnung "
        "noch einmal exportieren.",
    ),
    "import.layer-not-plotted": Text(
        "der Layer des Objekts ist als nicht zu drucken gekennzeichnet",
        "Soll das Objekt geschnitten werden, das Drucken des Layers einschalten und die Zeichnung "
        "noch einmal exportieren.",
    ),
    "import.layer-off": Text(
        "der Layer des Objekts ist ausgeschaltet",
        "Soll das Objekt geschnitten werden, den Layer einschalten und die Zeichnung noch einmal "
        "exportieren.",
    ),
    "import.left-out": Text(
        "{objects:# Objekt wird|# Objekte werden} nicht geschnitten: {reason}.",
        "Der Importbericht nennt {objects:es|sie}. {reason:hint}",
    ),
    "import.left-out-further": Text(
        "{objects:# weiteres Objekt wird|# weitere Objekte werden} nicht geschnitten.",
        "Der Importbericht nennt den Grund für jedes Objekt.",
    ),
    "import.left-out-on-layer": Text(
        "{objects:# Objekt|# Objekte} auf Layer „{layer}“ {objects:wird|werden} nicht "
        "geschnitten: {reason}.",
        "Der Importbericht nennt {objects:es|sie}. {reason:hint}",
    ),
    "import.light": Text(
        "das Objekt ist eine Lichtquelle und wird nicht geschnitten",
    ),
    "import.lightburn-shape": Text(
        "das Objekt ist eine LightBurn-Form der Art {kind}, die nicht gelesen werden kann",
        "In LightBurn das Objekt auswählen, „Edit > Convert to Path“ wählen und das Projekt noch "
        "einmal speichern.",
    ),
    "import.line-not-numbers": Text(
        "die Werte in Zeile {line} der Datei sind nicht alle Zahlen: {values:, }",
    ),
    "import.lone-vertex": Text(
        "das Objekt ist ein Punkt, der zu keiner Polylinie gehört",
    ),
    "import.mesh": Text(
        "das Objekt ist ein räumliches Netz, keine Linie in einer Ebene",
    ),
    "import.missing-id": Text(
        "das Objekt verweist mit der Kennung „{id}“ auf ein anderes, das es in der Datei nicht "
        "gibt",
    ),
    "import.missing-subroutine": Text(
        "das Objekt fügt das Unterprogramm {name} ein, das nicht in der Datei ist",
    ),
    "import.multiple-line": Text(
        "das Objekt ist eine Mehrfachlinie (MLINE), die nicht gelesen wird",
        "Die Mehrfachlinie im CAD-Programm in Linien auflösen und die Zeichnung noch einmal "
        "exportieren.",
    ),
    "import.no-end-mark": Text(
        "die Endmarke {mark} der Datei fehlt, Objekte können also fehlen",
        "Die Zeichnung mit dem Original vergleichen oder noch einmal exportieren.",
    ),
    "import.no-length": Text(
        "die Länge des Objekts ist {length:g}, zu kurz zum Schneiden",
    ),
    "import.no-major-axis": Text(
        "die große Achse der Ellipse hat die Länge 0",
    ),
    "import.no-paint": Text(
        "das Objekt hat weder Linie noch Füllung, ist also nicht sichtbar",
    ),
    "import.no-parameter-range": Text(
        "die Ellipse hat keine Länge, weil ihr Anfangs- und ihr Endparameter beide {parameter:g} "
        "sind",
    ),
    "import.no-pen": Text(
        "das Objekt ist ohne Stift gezeichnet (Stift 0), ist also nicht sichtbar",
    ),
    "import.no-points": Text(
        "das Objekt hat keine Punkte",
    ),
    "import.no-scale": Text(
        "das Objekt hat keine Größe, weil es mit {x:g} in X und {y:g} in Y skaliert ist",
    ),
    "import.no-size": Text(
        "das Objekt hat keine Größe: seine Breite ist {width:g} und seine Höhe {height:g}",
    ),
    "import.no-stroke-width": Text(
        "die Linie des Objekts hat die Breite 0, ist also nicht sichtbar",
        "Soll das Objekt geschnitten werden, der Linie eine Breite geben und die Zeichnung noch "
        "einmal exportieren.",
    ),
    "import.no-sweep": Text(
        "der Kreisbogen hat keine Länge, weil er beim selben Winkel beginnt und endet, "
        "{degrees:g}°",
    ),
    "import.not-a-line": Text(
        "das Objekt ist von der Art {kind}, die nicht gelesen werden kann",
    ),
    "import.not-clipped": Text(
        "die Datei beschneidet das Objekt, aber es wurde vollständig eingelesen",
        "Das Objekt in seinem Programm stutzen oder den Beschneidungspfad anwenden. Dann die "
        "Zeichnung noch einmal exportieren.",
    ),
    "import.not-flat": Text(
        "das Objekt ist nicht parallel zur XY-Ebene",
    ),
    "import.not-numbers": Text(
        "die Koordinaten des Objekts sind nicht alle Zahlen: {values:, }",
    ),
    "import.not-svg": Text(
        "der Inhalt des Objekts ist nicht SVG",
    ),
    "import.not-visible": Text(
        "das Objekt ist ganz durchsichtig",
    ),
    "import.nothing-named": Text(
        "die PDF-Seite verwendet ein Formular oder Bild mit dem Namen „{name}“, das das PDF nicht "
        "enthält",
    ),
    "import.odd-points": Text(
        "die Liste der Punkte des Objekts ist unvollständig: der letzte Punkt hat keine "
        "y-Koordinate",
        "Das Objekt in seinem Programm berichtigen und die Zeichnung noch einmal exportieren.",
    ),
    "import.on-layer": Text(
        "das Objekt liegt auch auf dem Layer {layer}",
    ),
    "import.other-file": Text(
        "das Objekt ist in einer anderen Datei, „{file}“, die nicht geladen wird",
        "Das Objekt in die Datei einbetten und noch einmal exportieren.",
    ),
    "import.other-language": Text(
        "das Objekt ist für Leser einer anderen Sprache, ist also nicht sichtbar",
    ),
    "import.other-pages": Text(
        "Die Datei hat {pages:# Seite|# Seiten}, aber nur Seite {page} wird gelesen.",
        "Ist die Zeichnung auf einer anderen Seite, diese wählen oder als eigene Datei "
        "exportieren.",
    ),
    "import.other-pages-lines": Text(
        "Die Datei hat außer Seite {page} {others:# andere Seite|# andere Seiten}, und nur Seite "
        "{page} wird gelesen. Von den anderen hat Seite {most} die meisten Linien ({lines:,}).",
        "Ist die Zeichnung auf einer anderen Seite, diese wählen oder als eigene Datei "
        "exportieren.",
    ),
    "import.other-sheet": Text(
        "das Objekt ist auf Blatt {sheet} des Plots, aber nur das erste Blatt wird gelesen",
        "Soll das Objekt geschnitten werden, sein Blatt als eigene Datei exportieren.",
    ),
    "import.outside-page": Text(
        "das Objekt liegt außerhalb des sichtbaren Bereichs der Seite",
    ),
    "import.page-ends-early": Text(
        "der Pfad hat weder Linie noch Füllung, weil die Seite endet, bevor er endet",
    ),
    "import.paper-space-annotation": Text(
        "das Objekt ist eine Anmerkung oder ein Ansichtsfenster in einem Layout (Papierbereich), "
        "nicht im Modell",
    ),
    "import.paper-space": Text(
        "das Objekt ist in einem Layout (Papierbereich), nicht im Modell",
    ),
    "import.parameters-not-numbers": Text(
        "der Anfangs- oder Endparameter der Ellipse ist keine Zahl",
    ),
    "import.partly-outside-page": Text(
        "ein Teil des Objekts liegt außerhalb des sichtbaren Bereichs der Seite",
    ),
    "import.picture-block": Text(
        "der Block {block} mit {entities:# Objekt|# Objekten} ist die Darstellung einer Bemaßung "
        "oder Schraffur und wird nicht geschnitten",
    ),
    "import.pieces-drawn-twice": Text(
        "{pieces} der {all} Segmente des Objekts {pieces:ist|sind} doppelt gezeichnet: {pieces:es "
        "liegt|sie liegen} genau auf {same:, }",
    ),
    "import.pieces-drawn-twice-often": Text(
        "{pieces} der {all} Segmente des Objekts {pieces:ist|sind} mehrfach gezeichnet: "
        "{pieces:es liegt|sie liegen} genau auf {same:, } und {more} {more:weiteren "
        "Objekt|weiteren Objekten}",
    ),
    "import.pieces-no-length": Text(
        "{pieces} der {all} Segmente des Objekts {pieces:hat|haben} keine Länge",
    ),
    "import.place-not-a-number": Text(
        "die Position des Objekts ist keine Zahl",
    ),
    "import.placement-not-a-number": Text(
        "Position, Maßstab oder Drehung des Objekts ist keine Zahl",
    ),
    "import.places-block": Text(
        "das Objekt fügt den Block {block} ein",
    ),
    "import.places-subroutine": Text(
        "das Objekt fügt das Unterprogramm {name} ein",
    ),
    "import.plotter-marks": Text(
        "die Anweisung zeichnet eigene Symbole, Teilstriche oder Zeichen, die nicht geschnitten "
        "werden",
    ),
    "import.point": Text(
        "das Objekt ist ein Punkt, der keine Länge hat",
    ),
    "import.proxy": Text(
        "das Objekt ist nur von dem Programm lesbar, das es gemacht hat",
        "Das Objekt in jenem Programm in Linien auflösen und noch einmal exportieren.",
    ),
    "import.region": Text(
        "das Objekt ist eine Region, die nicht gelesen werden kann",
        "Die Region im CAD-Programm in Linien auflösen und die Zeichnung noch einmal exportieren.",
    ),
    "import.repeated": Text(
        "die Zeichnung enthält das Objekt {times} Mal",
    ),
    "import.rules-not-read": Text(
        "das Stylesheet der Zeichnung hat Regeln, die nicht unterstützt werden: {rules:, }",
    ),
    "import.script": Text(
        "das Objekt ist ein Skript, das nicht ausgeführt wird",
    ),
    "import.shading": Text(
        "das Objekt ist ein Farbverlauf und wird nicht geschnitten",
    ),
    "import.short-path-data": Text(
        "die Pfaddaten des Objekts sind unvollständig: sie enden mitten in einem Befehl",
        "Das Objekt in seinem Programm berichtigen und die Zeichnung noch einmal exportieren.",
    ),
    "import.solid": Text(
        "das Objekt ist ein Körper oder eine Fläche, keine Linie in einer Ebene",
    ),
    "import.spot-colour": Text(
        "das Objekt ist in der Sonderfarbe {colour} gezeichnet",
    ),
    "import.subroutine-in-itself": Text(
        "das Unterprogramm {name} fügt sich selbst ein",
    ),
    "import.text": Text(
        "das Objekt ist ein Text und wird nicht geschnitten",
    ),
    "import.text-unknown-letters": Text(
        "das Objekt ist ein Text und wird nicht geschnitten; sein Wortlaut kann nicht gezeigt "
        "werden, weil seine Schrift nicht nennt, welche Zeichen sie hat",
    ),
    "import.tilted": Text(
        "das Objekt ist nicht parallel zur XY-Ebene: seine Ebene ist um {degrees:g}° geneigt",
    ),
    "import.tilted-axis": Text(
        "das Objekt ist nicht parallel zur XY-Ebene: seine große Achse steigt um {rise:g} "
        "Dateieinheiten",
    ),
    "import.too-far": Text(
        "eine Koordinate des Objekts ist {coordinate:g} Dateieinheiten, erlaubt sind {limit:g}",
    ),
    "import.too-many-fit-points": Text(
        "die Kurve hat {points:,} Durchgangspunkte, erlaubt sind {limit:,}",
    ),
    "import.turned-page": Text(
        "die Linien nach dieser Anweisung sind um den Nullpunkt des Plotters gedreht, aber manche "
        "Plotter drehen das Papier, sodass diese Linien woanders liegen können",
        "Die Zeichnung mit dem Original vergleichen oder als DXF, PDF oder SVG exportieren.",
    ),
    "import.uncentred-arc": Text(
        "der Mittelpunkt des Kreisbogens ist {first:g} Dateieinheiten von seinem Anfang entfernt, "
        "aber {second:g} Dateieinheiten von seinem Ende",
    ),
    "import.underlay": Text(
        "das Objekt ist eine Unterlage (ein eingefügtes Bild oder eine PDF-Seite) und wird nicht "
        "geschnitten",
    ),
    "import.uneven-height": Text(
        "das Objekt ist nicht parallel zur XY-Ebene: seine Höhe z reicht von {low:g} bis {high:g} "
        "Dateieinheiten",
    ),
    "import.unknown-instruction": Text(
        "das Objekt ist eine Anweisung, die HPGL nicht kennt",
        "Die Zeichnung mit dem Original vergleichen oder als DXF, PDF oder SVG exportieren.",
    ),
    "import.unknown-operator": Text(
        "die PDF-Seite verwendet den Operator „{operator}“, der nicht unterstützt wird",
    ),
    "import.unknown-position": Text(
        "das Objekt beginnt an einer Position, die vom Plotter abhängt, etwa am Ende eines Textes",
        "Soll das Objekt geschnitten werden, die Zeichnung als DXF, PDF oder SVG exportieren.",
    ),
    "import.unknown-record": Text(
        "das Objekt ist ein CF2-Datensatz einer Art, die nicht unterstützt wird",
    ),
    "import.unsupported-element": Text(
        "das Objekt ist ein SVG-Element der Art {kind}, die nicht unterstützt wird",
    ),
    "import.unused-block": Text(
        "die Datei definiert den Block {block} mit {entities:# Objekt|# Objekten}, aber die "
        "Zeichnung verwendet ihn nicht",
    ),
    "import.unused-subroutine": Text(
        "die Datei definiert das Unterprogramm {name} mit {records:# Datensatz|# Datensätzen}, "
        "aber die Zeichnung verwendet es nicht",
    ),
    "import.value-angle": Text(
        "der Winkel {degrees:g}° ist nicht endlich",
    ),
    "import.value-not-numbers": Text(
        "der Wert „{value}“ ist keine Zahl",
    ),
    "import.value-not-transform": Text(
        "der Wert „{value}“ ist keine gültige Transformation",
    ),
    "import.value-transform-numbers": Text(
        "die Transformation {name} hat {count} Werte, das ist eine falsche Anzahl",
    ),
    "import.value-unit": Text(
        "der Wert „{value}“ hat eine unbekannte Längeneinheit",
    ),
    "import.viewport": Text(
        "das Objekt ist ein Ansichtsfenster, das nur einen Teil der Zeichnung zeigt",
    ),
    "import.white-area": Text(
        "das Objekt ist eine weiße Fläche ohne Umrisslinie und wird nicht geschnitten",
    ),
    "import.white-line": Text(
        "das Objekt ist weiß auf einer weißen Seite gezeichnet, ist also nicht sichtbar",
        "Soll das Objekt geschnitten werden, ihm eine andere Farbe geben und die Zeichnung noch "
        "einmal exportieren.",
    ),
    "import.wrong-field-count": Text(
        "Zeile {line} der Datei hat {fields:# Feld|# Felder}, das ist die falsche Anzahl für "
        "ihren Datensatz",
    ),
}
