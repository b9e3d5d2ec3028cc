"""reading: German texts of the messages of ``catalogue.reading``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "conversion.failed": Text(
        "Die Datei ist {what}. {program}, das solche Dateien umwandelt, hat mit dem Fehler "
        "„{reason}“ abgebrochen.",
        "{what:hint}",
    ),
    "conversion.failed-at": Text(
        "Die Datei ist {what}. {program}, das solche Dateien umwandelt, hat bei Byte {position:,} "
        "der Datei mit dem Fehler „{reason}“ abgebrochen.",
        "{what:hint}",
    ),
    "conversion.no-program": Text(
        "Die Datei ist {what}. knifetip liest solche Dateien nur, wenn das Programm {program} "
        "installiert ist.",
        "{what:hint} Oder den Administrator von knifetip bitten, {program} zu installieren "
        "(Befehl {command}). Ohne anderes Programm lesbar sind {formats:or}.",
    ),
    "conversion.no-result": Text(
        "Die Datei ist {what}. {program}, das solche Dateien umwandelt, hat darin keine Zeichnung "
        "gefunden.",
        "{what:hint}",
    ),
    "conversion.result-unreadable": Text(
        "Die Datei ist {what}. {program} hat sie umgewandelt, aber das Ergebnis kann nicht "
        "gelesen werden: {error}",
        "{what:hint}",
    ),
    "conversion.too-large": Text(
        "Die Datei ist {what}. Ihre Umwandlung durch {program} ergibt Dateien von mehr als "
        "{limit:.0f} MB.",
        "Eine einzelne Schachtel exportieren, ohne Bilder. {what:hint}",
    ),
    "conversion.too-slow": Text(
        "Die Datei ist {what}. Ihre Umwandlung durch {program} dauert länger als {seconds:g} s.",
        "Eine einzelne Schachtel exportieren, ohne Bilder. {what:hint}",
    ),
    "conversion.too-much-memory": Text(
        "Die Datei ist {what}. Ihre Umwandlung durch {program} braucht mehr als {limit:.0f} MB "
        "Speicher.",
        "Eine einzelne Schachtel exportieren, ohne Bilder. {what:hint}",
    ),
    "reading.crashed": Text(
        "Die Datei {name} kann nicht gelesen werden, wahrscheinlich weil sie beschädigt ist "
        "(Fehler {incident}).",
        "Die Zeichnung noch einmal als DXF, CF2, SVG oder PDF exportieren, nötigenfalls aus einem "
        "anderen Programm. Das Protokoll des Servers enthält unter dieser Nummer die Ursache.",
    ),
    "reading.cut-short": Text(
        "Die {format}-Datei ist unvollständig: Sie endet in Zeile {line}, nach {count:# Element|# "
        "Elementen}. Objekte der Zeichnung können fehlen.",
        "Die vollständige Datei senden oder die Zeichnung noch einmal exportieren.",
    ),
    "reading.damaged": Text(
        "Die {format}-Datei kann nicht gelesen werden, weil sie beschädigt ist ({reason}).",
        "Die Zeichnung noch einmal exportieren, nötigenfalls aus einem anderen Programm.",
    ),
    "reading.damaged-at": Text(
        "Die {format}-Datei ist in Zeile {line}, Spalte {column} beschädigt: {reason}.",
        "Die Zeichnung noch einmal exportieren, nötigenfalls aus einem anderen Programm.",
    ),
    "reading.empty": Text(
        "Die Datei ist leer.",
        "Die Zeichnung noch einmal exportieren und als {formats:or} senden. Eine DXF-Datei darf "
        "Text oder binär sein, in jeder Version.",
    ),
    "reading.expands-too-far": Text(
        "Die wiederholten Teile der {format}-Datei ergeben mehr als {limit:,} Elemente.",
        "Eine Zeichnung mit einer einzelnen Schachtel exportieren, ohne wiederholte Teile, die "
        "sie nicht braucht.",
    ),
    "reading.no-pages": Text(
        "Eine {format}-Datei hat keine Seiten.",
        "Nur bei einer PDF- oder PostScript-Datei sind Seiten zu wählen.",
    ),
    "reading.nested-too-deep": Text(
        "Blöcke, Symbole oder Gruppen der {format}-Datei sind mehr als {limit} Ebenen tief "
        "verschachtelt.",
        "Die Blöcke, Symbole oder Gruppen in ihrem Programm auflösen und noch einmal exportieren.",
    ),
    "reading.too-large": Text(
        "Die Datei ist {size:.1f} MB groß, erlaubt sind {limit:.1f} MB.",
        "Eine einzelne Schachtel exportieren, ohne Bilder.",
    ),
    "reading.too-many-elements": Text(
        "Die {format}-Datei hat mehr als {limit:,} Elemente.",
        "Eine Zeichnung mit einer einzelnen Schachtel exportieren.",
    ),
    "reading.too-many-entities": Text(
        "Die Datei hat {count:,} gezeichnete Objekte, erlaubt sind {limit:,}.",
        "Eine Zeichnung mit einer einzelnen Schachtel exportieren.",
    ),
    "reading.too-many-segments": Text(
        "Die {format}-Datei hat mehr als {limit:,} Linien und Kurven.",
        "Eine einzelne Schachtel exportieren, ohne Bilder aus Linien.",
    ),
    "reading.too-slow": Text(
        "Das Lesen der {format}-Datei dauert länger als {seconds:g} s.",
        "Eine einzelne Schachtel ohne Bilder exportieren und Kurven in Linien und Kreisbögen "
        "umwandeln.",
    ),
    "reading.truncated": Text(
        "Die {format}-Datei ist unvollständig, kann also nicht gelesen werden.",
        "Die vollständige Datei senden oder die Zeichnung noch einmal exportieren.",
    ),
    "reading.unexpected": Text(
        "Die {format}-Datei kann nicht gelesen werden, wahrscheinlich weil sie beschädigt ist. "
        "Das Lesen brach mit dem Fehler {reason} ab.",
        "Die Zeichnung noch einmal exportieren, nötigenfalls aus einem anderen Programm. "
        "Geschieht es wieder, den Fehler mit der Datei melden.",
    ),
    "reading.unknown-kind": Text(
        "Die Datei ist {what}, keine Zeichnung einer unterstützten Art.",
        "Die Zeichnung als {formats:or} senden. Eine DXF-Datei darf Text oder binär sein, in "
        "jeder Version. {what:hint}",
    ),
    "file.3mf": Text(
        "ein 3MF-Modell",
        "Im CAD-Programm eine ebene Zeichnung der Schachtel machen und als DXF exportieren.",
    ),
    "file.7z": Text(
        "ein 7z-Archiv",
    ),
    "file.affinity": Text(
        "ein Affinity-Dokument",
        "In Affinity „Datei > Exportieren“ und als Typ SVG oder PDF wählen.",
    ),
    "file.ard": Text(
        "ein ArtiosCAD-Entwurf (ARD)",
        "In ArtiosCAD „Datei > Ausgaben“ und als Typ CFF2 oder DXF wählen.",
    ),
    "file.binary": Text(
        "eine Binärdatei unbekannten Formats",
        "Die Zeichnung in ihrem Programm als DXF exportieren. In ArtiosCAD (.ard) „Datei > "
        "Ausgaben“ und als Typ DXF oder CFF2 wählen.",
    ),
    "file.bmp": Text(
        "ein BMP-Bild",
        "Ein Bild hat keine Linien, die geschnitten werden können. Die Zeichnung in ihrem "
        "Programm als DXF, SVG oder PDF exportieren.",
    ),
    "file.cdr": Text(
        "eine CorelDRAW-Zeichnung (CDR)",
        "In CorelDRAW „Datei > Exportieren“ und als Typ SVG oder DXF wählen.",
    ),
    "file.compound-file": Text(
        "eine alte Office-Datei oder eine CAD-Datei im selben Containerformat",
        "Die Zeichnung in ihrem Programm als DXF exportieren.",
    ),
    "file.ddes": Text(
        "eine DDES-Datei (DDES2 oder DDES3, ANSI IT8.6)",
        "In ArtiosCAD „Datei > Ausgaben“ und als Typ CFF2 oder DXF wählen. In einem anderen "
        "CAD-Programm die Zeichnung als CF2 oder DXF exportieren.",
    ),
    "file.dmpl": Text(
        "eine Plotterdatei in der Sprache DM/PL",
        "In ihrem Programm einen Plotter mit HPGL wählen oder die Zeichnung als DXF, PDF oder SVG "
        "exportieren.",
    ),
    "file.dwf": Text(
        "eine DWF-Zeichnung, die nur zum Ansehen ist",
        "Die Zeichnung in dem CAD-Programm, das sie geschrieben hat, als DXF speichern.",
    ),
    "file.dwg": Text(
        "eine DWG-Zeichnung",
        "In AutoCAD oder einem anderen CAD-Programm „Datei > Speichern unter“ und als Typ DXF "
        "wählen (etwa DXF 2013).",
    ),
    "file.eps": Text(
        "eine EPS-Datei",
        "In Illustrator die Datei öffnen und „Datei > Speichern unter > PDF“ wählen. In anderen "
        "Programmen die Zeichnung als PDF, SVG oder DXF exportieren.",
    ),
    "file.gcode": Text(
        "ein Maschinenprogramm (G-Code)",
        "Die Zeichnung senden, aus der das Programm gemacht wurde.",
    ),
    "file.gif": Text(
        "ein GIF-Bild",
        "Ein Bild hat keine Linien, die geschnitten werden können. Die Zeichnung in ihrem "
        "Programm als DXF, SVG oder PDF exportieren.",
    ),
    "file.gzip": Text(
        "ein gzip-Archiv",
    ),
    "file.html": Text(
        "eine HTML-Seite",
    ),
    "file.iges": Text(
        "eine IGES-Datei",
        "Im CAD-Programm eine ebene Zeichnung der Schachtel machen und als DXF exportieren.",
    ),
    "file.illustrator": Text(
        "eine alte Illustrator-Datei ohne PDF-Inhalt",
        "In Illustrator „Datei > Speichern unter“ mit der Option „PDF-kompatible Datei erstellen“ "
        "wählen oder die Zeichnung als PDF, SVG oder DXF exportieren.",
    ),
    "file.indesign": Text(
        "ein InDesign-Dokument",
        "In InDesign „Datei > Exportieren“ und als Typ Adobe PDF (Druck) wählen.",
    ),
    "file.jpeg": Text(
        "ein JPEG-Bild",
        "Ein Bild hat keine Linien, die geschnitten werden können. Die Zeichnung in ihrem "
        "Programm als DXF, SVG oder PDF exportieren.",
    ),
    "file.json": Text(
        "eine JSON-Datei",
    ),
    "file.metafile": Text(
        "eine Windows-Metadatei (EMF oder WMF)",
        "Die Zeichnung in ihrem Programm als SVG, PDF oder DXF exportieren.",
    ),
    "file.office": Text(
        "ein Office-Dokument",
        "Die Zeichnung darin als eigene Datei senden. Eine im Office-Programm gemachte Zeichnung "
        "kann als PDF gespeichert werden.",
    ),
    "file.old-dwg": Text(
        "eine alte DWG-Zeichnung",
        "In AutoCAD oder einem anderen CAD-Programm „Datei > Speichern unter“ und als Typ DXF "
        "wählen (etwa DXF 2013).",
    ),
    "file.photoshop": Text(
        "ein Photoshop-Bild",
        "Ein Bild hat keine Linien, die geschnitten werden können. Die Zeichnung in ihrem "
        "Programm als DXF, SVG oder PDF exportieren.",
    ),
    "file.png": Text(
        "ein PNG-Bild",
        "Ein Bild hat keine Linien, die geschnitten werden können. Die Zeichnung in ihrem "
        "Programm als DXF, SVG oder PDF exportieren.",
    ),
    "file.postscript": Text(
        "eine PostScript-Datei",
        "In Illustrator die Datei öffnen und „Datei > Speichern unter > PDF“ wählen. In anderen "
        "Programmen die Zeichnung als PDF, SVG oder DXF exportieren.",
    ),
    "file.printer": Text(
        "eine Druckerdatei (PCL oder PJL)",
        "Die Zeichnung in ihrem Programm als DXF, PDF oder SVG exportieren, statt sie in eine "
        "Datei zu drucken.",
    ),
    "file.rar": Text(
        "ein RAR-Archiv",
    ),
    "file.rhino": Text(
        "ein Rhino-Modell",
        "In Rhino die ebenen Kurven auswählen und „Datei > Auswahl exportieren“ und als Typ DXF "
        "wählen.",
    ),
    "file.riff": Text(
        "ein Bild oder ein Video (RIFF)",
        "Ein Bild hat keine Linien, die geschnitten werden können. Die Zeichnung in ihrem "
        "Programm als DXF, SVG oder PDF exportieren.",
    ),
    "file.silhouette": Text(
        "ein Projekt von Silhouette Studio",
        "In der Silhouette Studio Business Edition „Datei > Speichern unter“ und als Typ SVG oder "
        "PDF wählen.",
    ),
    "file.sketchup": Text(
        "ein SketchUp-Modell",
        "In SketchUp „Datei > Exportieren > 2D-Grafik“ und als Typ DXF oder PDF wählen.",
    ),
    "file.step": Text(
        "eine STEP-Datei",
        "Im CAD-Programm eine ebene Zeichnung der Schachtel machen und als DXF exportieren.",
    ),
    "file.stl": Text(
        "ein STL-Modell",
        "Im CAD-Programm eine ebene Zeichnung der Schachtel machen und als DXF exportieren.",
    ),
    "file.tiff": Text(
        "ein TIFF-Bild",
        "Ein Bild hat keine Linien, die geschnitten werden können. Die Zeichnung in ihrem "
        "Programm als DXF, SVG oder PDF exportieren.",
    ),
    "file.xps": Text(
        "ein XPS-Dokument",
        "Die Zeichnung in ihrem Programm als PDF, SVG oder DXF exportieren oder in ein PDF "
        "drucken.",
    ),
    "file.xml": Text(
        "eine XML-Datei der Art „{element}“",
    ),
    "file.zip": Text(
        "ein ZIP-Archiv",
        "Das Archiv entpacken und die Zeichnung darin senden.",
    ),
    "dxf.at-line": Text(
        "in Zeile {line} der Datei",
    ),
    "dxf.blocks-expand-too-far": Text(
        "Die Blöcke der DXF-Datei ergeben {count} gezeichnete Objekte, erlaubt sind {limit:,}.",
        "Eine Zeichnung mit einer einzelnen Schachtel exportieren, oder die Blöcke auflösen und "
        "nicht benötigte Kopien löschen.",
    ),
    "dxf.blocks-too-deep": Text(
        "Die Blöcke der DXF-Datei sind {depth} Ebenen tief verschachtelt, erlaubt sind {limit} "
        "Ebenen.",
        "Die Blöcke im CAD-Programm auflösen und noch einmal exportieren.",
    ),
    "dxf.coordinate-alone": Text(
        "Die DXF-Datei ist in Zeile {line} beschädigt: Die Koordinate mit Gruppencode {code} "
        "eines Objekts der Art {kind} gehört zu einem Punkt, dessen andere Koordinate fehlt.",
        "Die Zeichnung noch einmal exportieren.",
    ),
    "dxf.cut-short": Text(
        "Die DXF-Datei ist unvollständig: Sie endet {where} im Abschnitt {section}, nach {count:# "
        "gezeichneten Objekt|# gezeichneten Objekten}. Objekte der Zeichnung können fehlen.",
        "Die vollständige Datei senden oder die Zeichnung noch einmal exportieren.",
    ),
    "dxf.no-section": Text(
        "Die Datei ist keine DXF-Datei, weil sie keinen Abschnitt hat.",
        "Die Zeichnung als DXF exportieren (Text oder binär, jede Version).",
    ),
    "dxf.not-a-group-code": Text(
        "Die Datei ist keine DXF-Datei, weil in Zeile {line} „{text}“ statt eines Gruppencodes "
        "(einer ganzen Zahl) steht.",
        "Die Zeichnung als DXF exportieren (Text oder binär, jede Version).",
    ),
    "dxf.not-a-number": Text(
        "Die DXF-Datei ist in Zeile {line} beschädigt: Der Wert „{text}“ mit Gruppencode {code} "
        "eines Objekts der Art {kind} ist keine Zahl.",
        "Die Zeichnung noch einmal exportieren, mit einem Punkt als Dezimaltrennzeichen.",
    ),
    "dxf.other-kind": Text(
        "Die Datei hat das Format {kind}, nicht DXF.",
        "Die Zeichnung als DXF exportieren (Text oder binär, jede Version).",
    ),
    "dxf.too-large-unusual": Text(
        "Die DXF-Datei hat {size:.1f} MB und verwendet Bestandteile, deren Lesen lange dauert. "
        "Für solche Dateien sind {limit:.1f} MB erlaubt.",
        "Eine Zeichnung mit einer einzelnen Schachtel exportieren oder als DXF R2000 speichern.",
    ),
    "dxf.without-end-mark": Text(
        "ohne die Endmarke EOF",
    ),
    "cf2.cut-short": Text(
        "Die CF2-Datei ist unvollständig: Sie endet in Zeile {line} in: {inside}. Objekte der "
        "Zeichnung können fehlen.",
        "Die vollständige Datei senden oder die Zeichnung noch einmal als CF2 exportieren.",
    ),
    "cf2.decimal-commas": Text(
        "Zeile {line} der CF2-Datei hat {fields} statt {expected} Felder für den Datensatz "
        "{record}. Die Datei scheint Dezimalkommas zu verwenden, aber in CF2-Dateien trennen "
        "Kommas die Felder.",
        "Die Zeichnung noch einmal mit Dezimalpunkten exportieren.",
    ),
    "cf2.empty": Text(
        "Die CF2-Datei enthält keine Zeichnung: Sie hat weder einen Abschnitt MAIN noch ein "
        "Unterprogramm.",
        "Die vollständige Datei senden oder die Zeichnung noch einmal als CF2 exportieren.",
    ),
    "cf2.main": Text(
        "Abschnitt MAIN",
    ),
    "cf2.section": Text(
        "Abschnitt {name}",
    ),
    "cf2.subroutine": Text(
        "Unterprogramm {name}",
    ),
    "lightburn.doctype": Text(
        "Das LightBurn-Projekt hat einen DOCTYPE, den LightBurn nicht schreibt.",
        "Das Projekt in LightBurn noch einmal speichern.",
    ),
    "lightburn.empty": Text(
        "Das LightBurn-Projekt enthält keine Form.",
        "Die vollständige Datei senden oder das Projekt in LightBurn noch einmal speichern.",
    ),
    "plt.bad-number": Text(
        "Die Plotterdatei (HPGL) ist bei Byte {position:,} beschädigt: Die Werte der Anweisung "
        "{name} sind nicht alle Zahlen („{text}“).",
        "Die Zeichnung noch einmal als HPGL exportieren, mit einem Punkt als Dezimaltrennzeichen.",
    ),
    "plt.bad-polyline": Text(
        "Die Plotterdatei (HPGL) ist bei Byte {position:,} beschädigt: Die kodierte Polylinie "
        "(PE) kann nicht dekodiert werden.",
        "Die Zeichnung noch einmal als HPGL exportieren. Wurde die Datei als Text gesendet, sie "
        "als Binärdaten senden.",
    ),
    "plt.bad-scale": Text(
        "Die Plotterdatei (HPGL) ist bei Byte {position:,} beschädigt: Die Anweisung {name} nennt "
        "den Maßstab 0 oder eine Maßstabsart, die HPGL nicht kennt.",
        "Die Zeichnung noch einmal als HPGL exportieren.",
    ),
    "plt.cut-short": Text(
        "Die Plotterdatei (HPGL) ist unvollständig: Die Anweisung {name} bei Byte {position:,} "
        "hat kein Ende. Objekte der Zeichnung können fehlen.",
        "Die vollständige Datei senden oder die Zeichnung noch einmal als HPGL exportieren.",
    ),
    "plt.damaged": Text(
        "Die Plotterdatei (HPGL) ist bei Byte {position:,} beschädigt: „{text}“ ist keine "
        "Anweisung.",
        "Die Zeichnung noch einmal als HPGL exportieren. Wurde die Datei als Text gesendet, sie "
        "als Binärdaten senden.",
    ),
    "plt.empty": Text(
        "Die Plotterdatei (HPGL) enthält keine Zeichnung: Keine ihrer Anweisungen zeichnet eine "
        "Linie.",
        "Die vollständige Datei senden oder die Zeichnung noch einmal als HPGL exportieren.",
    ),
    "plt.several-scales": Text(
        "Die Plotterdatei (HPGL) zeichnet Linien in mehreren Maßstäben, und mindestens einer "
        "davon hängt vom Plotter und seinem Papier ab (SC ohne IP).",
        "Die Zeichnung noch einmal als HPGL in Plottereinheiten von 1/40 mm exportieren oder als "
        "DXF senden.",
    ),
    "plt.wrong-count": Text(
        "Die Plotterdatei (HPGL) ist bei Byte {position:,} beschädigt: Die Anweisung {name} hat "
        "{count:# Wert|# Werte} statt {expected:or}.",
        "Die Zeichnung noch einmal als HPGL exportieren.",
    ),
    "plt.x-without-y": Text(
        "Die Plotterdatei (HPGL) ist bei Byte {position:,} beschädigt: Die Anweisung {name} hat "
        "{count:# Wert|# Werte}, also hat der letzte Punkt keine y-Koordinate.",
        "Die Zeichnung noch einmal als HPGL exportieren.",
    ),
    "svg.empty": Text(
        "Die SVG-Datei enthält kein Element.",
        "Die Zeichnung noch einmal als einfaches SVG exportieren.",
    ),
    "svg.external-entity": Text(
        "Der DOCTYPE des SVG hat eine Entität „{name}“, die auf eine andere Datei verweist, die "
        "nicht geladen wird.",
        "Die Zeichnung als einfaches SVG ohne DOCTYPE speichern.",
    ),
    "svg.long-entity": Text(
        "Der DOCTYPE des SVG hat eine Entität „{name}“ von {length:,} Zeichen, die zu lang ist.",
        "Die Zeichnung als einfaches SVG ohne DOCTYPE speichern.",
    ),
    "svg.markup-entity": Text(
        "Der DOCTYPE des SVG hat eine Entität „{name}“ mit Auszeichnungen, was nicht unterstützt "
        "wird.",
        "Die Zeichnung als einfaches SVG ohne DOCTYPE speichern.",
    ),
    "svg.other-xml": Text(
        "Die Datei ist eine XML-Datei, aber kein SVG: Ihr äußerstes Element ist {element} statt "
        "svg.",
        "Die Zeichnung als einfaches SVG speichern.",
    ),
    "svg.packed-cut-short": Text(
        "Die komprimierte SVG-Datei (.svgz) ist unvollständig.",
        "Die vollständige Datei senden oder die Zeichnung noch einmal als einfaches SVG "
        "exportieren.",
    ),
    "svg.packed-damaged": Text(
        "Die komprimierte SVG-Datei (.svgz) ist beschädigt: {reason}.",
        "Die Zeichnung noch einmal als einfaches SVG exportieren.",
    ),
    "svg.too-many-rules": Text(
        "Das Stylesheet der SVG-Datei hat {count:,} Regeln, erlaubt sind {limit:,}.",
        "Die Zeichnung mit style-Attributen in jedem Element statt mit einem Stylesheet "
        "exportieren.",
    ),
    "svg.unpacks-too-far": Text(
        "Die komprimierte SVG-Datei (.svgz) ist entpackt größer als {limit:.1f} MB.",
        "Eine Zeichnung mit einer einzelnen Schachtel exportieren, ohne Bilder.",
    ),
    "pdf.blank": Text(
        "Die Seite des PDF enthält keine Zeichnung.",
        "Die Zeichnung noch einmal exportieren, als erste Seite des PDF.",
    ),
    "pdf.content-damaged": Text(
        "Der Inhalt des PDF ({where}) ist beschädigt: {reason}. Objekte der Zeichnung können "
        "fehlen.",
        "Die Zeichnung noch einmal exportieren oder als DXF senden.",
    ),
    "pdf.cut-short": Text(
        "Die PDF-Datei ist unvollständig: Ihre {bytes:,} Bytes enden nicht mit %%EOF. Objekte der "
        "Zeichnung können fehlen.",
        "Die vollständige Datei senden oder die Zeichnung noch einmal exportieren.",
    ),
    "pdf.encrypted": Text(
        "Das PDF ist verschlüsselt, kann also nicht gelesen werden.",
        "Das PDF ohne Passwort und ohne Einschränkungen speichern, dann noch einmal senden.",
    ),
    "pdf.expands-too-far": Text(
        "Die Seite des PDF und ihre wiederholten Formulare ergeben mehr als {limit:.1f} MB.",
        "Eine Zeichnung mit einer einzelnen Schachtel exportieren, ohne Symbole, die sie nicht "
        "braucht.",
    ),
    "pdf.form": Text(
        "Das PDF ist ein dynamisches Formular (XFA), dessen Seite keine Zeichnung enthält.",
        "Die Zeichnung in ein PDF drucken oder als DXF senden.",
    ),
    "pdf.form-named": Text(
        "Formular {name}",
    ),
    "pdf.illustrator-only": Text(
        "Die Illustrator-Datei wurde ohne PDF-Inhalt gespeichert, also enthält ihre Seite keine "
        "Zeichnung.",
        "Die Datei mit der Option „PDF-kompatible Datei erstellen“ oder als PDF speichern.",
    ),
    "pdf.layers-too-deep": Text(
        "Die Ebenen des PDF sind mehr als {limit:,} Stufen tief verschachtelt.",
        "Die Zeichnung noch einmal mit weniger verschachtelten Ebenen exportieren.",
    ),
    "pdf.nested-arrays": Text(
        "Felder (Arrays) sind zu tief verschachtelt",
    ),
    "pdf.no-header": Text(
        "Die Datei ist kein PDF: Sie beginnt nicht mit %PDF.",
        "Die Zeichnung noch einmal exportieren oder als DXF senden.",
    ),
    "pdf.no-such-page": Text(
        "Das PDF hat {pages:# Seite|# Seiten}, aber keine Seite {page}.",
        "Eine seiner Seiten wählen.",
    ),
    "pdf.no-page": Text(
        "Das PDF hat keine Seite.",
        "Die Zeichnung noch einmal exportieren oder als DXF senden.",
    ),
    "pdf.open-array": Text(
        "ein Feld (Array) hat keine schließende Klammer",
    ),
    "pdf.open-image": Text(
        "ein eingebettetes Bild ist unvollständig",
    ),
    "pdf.open-text": Text(
        "eine Zeichenkette hat keine schließende Klammer",
    ),
    "pdf.page": Text(
        "Seite",
    ),
    "pdf.page-too-large": Text(
        "Eine Seite des PDF-Blatts ist {size:g} mm vom Nullpunkt der Blattkoordinaten entfernt, "
        "erlaubt sind {limit:g} mm.",
        "Die Zeichnung in ihrer wahren Größe exportieren.",
    ),
    "pdf.part-missing": Text(
        "Ein Teil des Inhalts der PDF-Seite fehlt in der Datei. Objekte der Zeichnung können "
        "fehlen.",
        "Die Zeichnung noch einmal exportieren oder als DXF senden.",
    ),
    "pdf.stream-cut-short": Text(
        "Ein Datenstrom des PDF ist unvollständig. Objekte der Zeichnung können fehlen.",
        "Die vollständige Datei senden oder die Zeichnung noch einmal exportieren.",
    ),
    "pdf.stream-damaged": Text(
        "Ein Datenstrom des PDF ist beschädigt ({reason}). Objekte der Zeichnung können fehlen.",
        "Die Zeichnung noch einmal exportieren oder als DXF senden.",
    ),
    "pdf.stream-too-large": Text(
        "Ein Datenstrom des PDF ist entpackt größer als {limit:.1f} MB.",
        "Eine einzelne Schachtel exportieren, ohne Bilder.",
    ),
    "pdf.too-many-states": Text(
        "Das PDF speichert mehr als {limit:,} Grafikzustände (Operator q), ohne sie "
        "wiederherzustellen.",
        "Die Zeichnung noch einmal aus ihrem Programm exportieren.",
    ),
}
