"""drawing: German texts of the messages of ``catalogue.drawing``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "drawing.all-ignored": Text(
        "Es gibt nichts zu machen: {count:Die einzige Kante|Alle # Kanten} der Zeichnung "
        "{count:ist|sind} auf „Ignoriert“ gesetzt.",
        "Den Kanten, die gemacht werden sollen, die Linienart „Schneiden“, „Rillen“ oder eine "
        "andere geben.",
    ),
    "drawing.answer-taken-back": Text(
        "Eine Antwort, die aus früheren Zeichnungen von {customer} gelernt wurde, wird nicht mehr "
        "verwendet.",
    ),
    "drawing.answer-used": Text(
        "Eine Antwort, die aus früheren Zeichnungen von {customer} gelernt wurde, wird wieder "
        "verwendet.",
    ),
    "drawing.changing": Text(
        "Eine andere Anfrage ändert gerade die Zeichnung {drawing}.",
        "Gleich noch einmal versuchen.",
    ),
    "drawing.deleted": Text(
        "Die Zeichnung wurde gelöscht.",
    ),
    "drawing.details-changed": Text(
        "Die Angaben der Bestellung wurden geändert.",
    ),
    "drawing.edited": Text(
        "Die Zeichnung hat {count:# Änderung|# Änderungen} an ihren Linien.",
    ),
    "drawing.empty": Text(
        "Es gibt nichts zu machen: Die Datei enthält keine Objekte.",
        "Die Zeichnung noch einmal exportieren, mit den Linien der Schachtel im Modellbereich.",
    ),
    "drawing.in-use": Text(
        "Die Zeichnung {drawing} kann nicht gelöscht werden, weil Auftrag {job} aus ihr gemacht "
        "wurde.",
        "Die Zeichnung behalten. Nur Zeichnungen, aus denen kein Auftrag gemacht wurde, können "
        "gelöscht werden.",
    ),
    "drawing.fits-turned": Text(
        "Die Zeichnung misst {width:.1f} × {height:.1f} mm, aber der Tisch von {machine} nur "
        "{room_x:.0f} × {room_y:.0f} mm. Um 90° gedreht passt die Zeichnung.",
        "Die Zeichnung um 90° drehen und noch einmal einlesen.",
    ),
    "drawing.larger-than-table": Text(
        "Die Zeichnung misst {width:.1f} × {height:.1f} mm, aber der Tisch von {machine} nur "
        "{room_x:.0f} × {room_y:.0f} mm.",
        "Die Einheit der Zeichnung prüfen, eine größere Maschine wählen oder die Zeichnung teilen.",
    ),
    "drawing.no-customer": Text(
        "Die Zeichnung {drawing} hat keinen Kunden, also können keine Antworten aus früheren "
        "Zeichnungen eines Kunden verwendet werden.",
        "Zuerst den Kunden der Zeichnung setzen.",
    ),
    "drawing.no-lines": Text(
        "Es gibt nichts zu machen: Die Datei enthält keine Linien, denen ein Werkzeug folgen "
        "kann. {count:Das einzige Objekt wurde|Alle # Objekte wurden} weggelassen: {reasons:; }.",
        "Die Schachtel mit Linien, Kreisbögen oder Kurven im Modellbereich zeichnen, parallel zur "
        "XY-Ebene, und noch einmal einlesen.",
    ),
    "drawing.no-lines-reason": Text(
        "{reason} ({count:# Objekt|# Objekte})",
    ),
    "drawing.of-another": Text(
        "Die Zeichnung {drawing} wurde von jemand anderem hochgeladen und ist nicht freigegeben.",
        "Den Besitzer oder einen Bediener bitten, sie für alle Gestalter freizugeben, oder die "
        "Datei noch einmal hochladen.",
    ),
    "drawing.open-questions": Text(
        "Zuerst {count:ist # Frage|sind # Fragen} zur Zeichnung zu beantworten: {questions: }",
        "Die Fragen auf der Seite der Zeichnung beantworten. Kanten ohne Antwort werden nicht "
        "geschnitten.",
    ),
    "drawing.read": Text(
        "Die Zeichnung wurde aus der Datei {name} eingelesen.",
    ),
    "drawing.reinterpreted": Text(
        "Die Zeichnung wurde mit der Einheit {unit:unit} und dem Profil {profile} noch einmal "
        "eingelesen.",
    ),
    "drawing.stale": Text(
        "Die Zeichnung {drawing} wurde geändert, nachdem Sie sie geladen haben. Die Anfrage gilt "
        "für Stand {named}, aber die Zeichnung hat Stand {revision}.",
        "Die Zeichnung noch einmal laden, prüfen und die Anfrage wiederholen.",
    ),
    "drawing.types-set": Text(
        "{count:# Kante bekam|# Kanten bekamen} eine Linienart.",
    ),
    "drawing.unit-for-cleaning": Text(
        "Die Zeichnung hat keine Einheit, also sind die Längen ihrer kurzen Kanten und Lücken "
        "nicht mit den Grenzen des Bereinigens vergleichbar, die in mm sind.",
        "Die Einheit der Zeichnung auf der Seite oder mit PATCH /api/drawings/ID setzen.",
    ),
    "drawing.unit-unknown": Text(
        "Die Einheit der Zeichnung ist nicht bekannt ({evidence}).",
        "Die Einheit der Zeichnung auf der Seite, mit --unit oder mit PATCH /api/drawings/ID "
        "setzen.",
    ),
    "drawing.unknown": Text(
        "Die Zeichnung {drawing} gibt es nicht. Vielleicht wurde sie gelöscht.",
        "Zurück zur Liste der Zeichnungen gehen und eine andere öffnen.",
    ),
    "drawing.upload-too-large": Text(
        "Die Datei {name} ist größer als {limit} MB.",
        "Eine kleinere Datei senden, zum Beispiel ohne Bilder.",
    ),
    "edit.end-elsewhere": Text(
        "Änderung {number} verschiebt ein Ende von Kante {edge}, aber dieses Ende liegt jetzt bei "
        "{x:mm}, {y:mm} mm.",
        "Die Zeichnung noch einmal laden und die Änderung wiederholen.",
    ),
    "edit.no-length": Text(
        "Nach Änderung {number} hätte eine Kante keine Länge.",
        "Zwei verschiedene Punkte wählen.",
    ),
    "edit.no-such-edge": Text(
        "Änderung {number} verschiebt ein Ende von Kante {edge}, aber die Zeichnung hat nur "
        "{count:# Kante|# Kanten}.",
        "Eine vorhandene Kantennummer wählen. Die erste Kante hat die Nummer 0.",
    ),
    "edit.no-unit": Text(
        "Die Zeichnung kann nicht geändert werden, weil ihre Einheit nicht bekannt ist.",
        "Zuerst die Einheit der Zeichnung wählen.",
    ),
    "edit.unit-changed": Text(
        "Die Einheit einer Zeichnung mit geänderten Linien kann nicht geändert werden, weil die "
        "Änderungen in mm sind.",
        "Die Änderungen zurücknehmen, die Einheit ändern und die Änderungen noch einmal machen.",
    ),
    "question.default-width": Text(
        "Linien der Standardbreite",
    ),
    "question.follows": Text(
        "Die Antwort entscheidet auch {edges:# Kante|# Kanten} auf Layer „{layer}“ (Farbe "
        "{colour}, Strichart {linetype}): {type}, wenn {questions:die Antwort|alle # Antworten zu "
        "dieser Regel} {answer} {questions:lautet|lauten}, und {other_type} bei {other_answer}.",
    ),
    "question.guess": Text(
        "Am wahrscheinlichsten ist die Linienart „{type:type}“ ({percent} %): {reason}.",
    ),
    "question.line-type": Text(
        "{edges:# Kante|# Kanten} auf Layer „{layer}“ (Farbe {colour}, Strichart {linetype}) "
        "{edges:hat|haben} keine Linienart: Gesamtlänge {length:,.1f} {unit:unit}, Ausdehnung "
        "{width:,.1f} × {height:,.1f} {unit:unit}, linke untere Ecke bei X {x:,.1f}, Y {y:,.1f}. "
        "Welche Linienart {edges:soll diese Kante|sollen diese Kanten} bekommen? {guess}",
    ),
    "question.line-type-by-width": Text(
        "{edges:# Kante|# Kanten} auf Layer „{layer}“ (Farbe {colour}, Strichart {linetype}, "
        "{lines}) {edges:hat|haben} keine Linienart: Gesamtlänge {length:,.1f} {unit:unit}, "
        "Ausdehnung {width:,.1f} × {height:,.1f} {unit:unit}, linke untere Ecke bei X {x:,.1f}, Y "
        "{y:,.1f}. Welche Linienart {edges:soll diese Kante|sollen diese Kanten} bekommen? {guess}",
    ),
    "question.line-width": Text(
        "{width:g} mm breite Linien",
    ),
    "question.line-width-without-unit": Text(
        "Linien der Breite {width:g}",
    ),
    "question.shape": Text(
        "Die Zeichnung zeigt: {reason}.",
    ),
    "question.thinnest-lines": Text(
        "dünnste Linien",
    ),
    "question.tool": Text(
        "{machine} hat kein Werkzeug für {edges:# Kante|# Kanten} der Linienart „{type:type}“. "
        "Welche andere Linienart {edges:soll diese Kante|sollen diese Kanten} bekommen?",
    ),
    "question.tool-for-folds": Text(
        "{machine} hat kein Werkzeug für {edges:# Kante|# Kanten} der Linienart „{type:type}“. Das "
        "Messer kann sie als Perforation mit den Schnitten und Stegen der "
        "Materialdatei oder als Ritzung herstellen. Welche andere Linienart "
        "{edges:soll diese Kante|sollen diese Kanten} bekommen?",
    ),
    "question.unit": Text(
        "{reason} In welcher Einheit ist die Zeichnung? Ihre möglichen Größen sind: {sizes:, }. "
        "{evidence}",
    ),
    "question.unit-contradicted": Text(
        "Die Datei nennt die Einheit {stated:unit}, aber die Größe der Zeichnung passt nicht dazu.",
    ),
    "question.unit-doubtful": Text(
        "Die Datei nennt die Einheit {stated:unit}, aber die Zeichnung könnte auch in "
        "{other:unit} sein.",
    ),
    "question.unit-evidence": Text(
        "Der stärkste Hinweis auf {unit:unit} ist: {evidence:; }.",
    ),
    "question.unit-not-stated": Text(
        "Die Datei nennt die Einheit der Zeichnung nicht.",
    ),
    "question.unit-size": Text(
        "{width:mm} × {height:mm} mm, wenn die Einheit {unit:unit} ist",
    ),
    "question.unit-unreadable": Text(
        "Die Einheit der Zeichnung ist nicht bekannt: {evidence}.",
        "Die Einheit der Zeichnung wählen.",
    ),
    "override.ambiguous": Text(
        "Die Anfrage ändert die Linienart von Kanten, wählt diese Kanten aber nicht auf genau "
        "eine Weise aus.",
        "Entweder edges (Kantennummern) oder handles oder einen Layer und/oder eine Farbe angeben.",
    ),
    "override.no-edges-there": Text(
        "Die Zeichnung hat keine Kante {place: und }.",
        "Einen Layer und eine Farbe wählen, die GET /api/drawings/ID/edges nennt.",
    ),
    "override.no-such-edge": Text(
        "Kante {edge} gibt es nicht. Die Zeichnung hat {count:# Kante|# Kanten}.",
        "Die Nummer einer vorhandenen Kante wählen. Die erste Kante hat die Nummer 0.",
    ),
    "override.no-such-handle": Text(
        "Keine Kante der Zeichnung hat das Handle „{handle}“.",
        "Ein Handle wählen, das GET /api/drawings/ID/edges nennt.",
    ),
    "override.of-colour": Text(
        "mit Farbe {colour}",
    ),
    "override.on-layer": Text(
        "auf Layer „{layer}“",
    ),
}
