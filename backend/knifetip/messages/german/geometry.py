"""geometry: German texts of the messages of ``catalogue.geometry``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "curve.bad-ellipse": Text(
        "Eine Ellipse hat einen ungültigen Winkelbereich, oder einer ihrer Werte ist keine Zahl.",
        "Die Ellipse löschen und neu zeichnen.",
    ),
    "curve.bad-spline": Text(
        "Ein Spline ist beschädigt: Grad {degree}, {points} Kontrollpunkte und {knots} Knoten "
        "passen nicht zusammen.",
        "Den Spline neu zeichnen oder als Linien und Kreisbögen exportieren.",
    ),
    "curve.bad-tolerance": Text(
        "Die Toleranz für das Umwandeln von Kurven ist {tolerance} mm, das ist ungültig.",
        "Eine Toleranz größer als 0 angeben.",
    ),
    "curve.not-finite": Text(
        "Eine Koordinate eines Punktes einer Kurve ist keine Zahl.",
        "Die Kurve neu zeichnen, als Linien und Kreisbögen.",
    ),
    "curve.not-fitted": Text(
        "Eine Kurve kann nicht in Linien und Kreisbögen umgewandelt werden, die höchstens "
        "{tolerance:g} mm von ihr abweichen.",
        "Die Kurve neu zeichnen, als Linien und Kreisbögen.",
    ),
    "curve.too-many-pieces": Text(
        "Mehr als {limit:,} Linien und Kreisbögen sind nötig, um eine Kurve mit höchstens "
        "{tolerance:g} mm Abweichung umzuwandeln.",
        "Eine größere Abweichung erlauben oder die Kurve vereinfachen.",
    ),
    "curve.too-many-spans": Text(
        "Ein Spline hat {spans:,} Abschnitte (Polynomstücke), erlaubt sind {limit:,}.",
        "Den Spline vor dem Export im CAD-Programm vereinfachen.",
    ),
    "edge.no-length": Text(
        "Kanten der Länge 0 haben keine Richtung: Kante {edges:, }.",
        "Diese Kanten aus der Zeichnung löschen.",
    ),
    "edge.not-finite": Text(
        "Kante {edge} hat eine Koordinate, die keine Zahl ist.",
        "Die Kante neu zeichnen.",
    ),
    "edge.place": Text(
        "Die Bewegung gehört zu Kante {edge}.",
    ),
    "edge.too-crowded": Text(
        "Mehr als {limit:,} Paare von Endpunkten von Kanten liegen näher als {distance} mm "
        "beieinander.",
        "Kanten löschen, die vielfach übereinander gezeichnet sind.",
    ),
    "edge.too-far": Text(
        "Kante {edge} liegt {distance:.3g} mm vom Nullpunkt der Zeichnung entfernt, zu weit für "
        "die Verarbeitung.",
        "Die Einheit der Zeichnung prüfen oder die Kante löschen.",
    ),
    "edge.too-many-overlaps": Text(
        "{edges:,} Kanten überlappen sich an mehr als {limit:,} Stellen.",
        "Kanten löschen, die vielfach übereinander gezeichnet sind.",
    ),
    "segment.not-finite": Text(
        "Segment {segment} der Bahn hat eine Koordinate oder eine Wölbung (Krümmung eines "
        "Kreisbogens), die keine Zahl ist.",
        "Dieses Segment der Bahn neu zeichnen.",
    ),
    "input.not-finite": Text(
        "{what} hat eine Koordinate, die keine Zahl ist.",
        "Das Objekt neu zeichnen.",
    ),
    "layer.not-finite": Text(
        "Eine Koordinate auf dem Layer {layer} ist keine Zahl.",
        "Die Kanten dieses Layers neu zeichnen.",
    ),
    "offset.bad-distance": Text(
        "Der Versatz einer Bahn (der Radius des Werkzeugs) ist negativ oder keine Zahl.",
        "Den Radius des Werkzeugs berichtigen.",
    ),
    "offset.bad-interference": Text(
        "„{interference}“ ist keine gültige Behandlung der Konturabschnitte, die das Werkzeug "
        "nicht erreicht.",
        "„trim“ (diese Abschnitte ungeschnitten lassen) oder „refuse“ (kein Programm schreiben) "
        "wählen.",
    ),
    "offset.bad-side": Text(
        "Die Seite einer Bahn muss +1 (links) oder -1 (rechts) sein.",
        "+1 oder -1 als Seite angeben.",
    ),
    "offset.cusp": Text(
        "Die versetzte Kurve in {radius:g} mm Abstand von Bahn {path} ist nicht geschlossen, weil "
        "sich die Segmente {one} und {two} der Kontur {size:.4g} mm vor der Ecke bei ({x:.4f}; "
        "{y:.4f}) mm kreuzen, an der sie sich treffen.",
        "Die beiden Segmente an ihrer Kreuzung stutzen, sodass die Ecke dort ist.",
    ),
    "offset.dead-end": Text(
        "Die versetzte Kurve in {radius:g} mm Abstand von Bahn {path} ist nicht geschlossen. Ein "
        "Stück der Kurve neben Segment {segment} der Bahn ist {depth:.4g} mm lang und schließt "
        "nicht an den Rest der Kurve an.",
        "Die Kontur so zeichnen, dass sie sich nicht selbst überlappt, oder den Radius des "
        "Werkzeugs ein wenig ändern.",
    ),
    "offset.interference": Text(
        "Ein Werkzeug mit {radius:g} mm Radius, das Segment {segment} folgt, würde {depth:.4g} mm "
        "in Segment {other} schneiden.",
        "Ein Werkzeug mit kleinerem Radius wählen, oder ungeschnittene Stellen annehmen, wo das "
        "Werkzeug nicht hineinpasst.",
    ),
    "offset.mixed-group": Text(
        "Bahn {path} hat einen anderen Werkzeugradius oder eine andere Seite des Werkzeugs als die "
        "anderen Bahnen, die mit ihr versetzt werden.",
        "Die Bahn umkehren oder getrennt versetzen.",
    ),
    "offset.self-contact": Text(
        "Die versetzte Kurve in {radius:g} mm Abstand von Bahn {path} ist nicht geschlossen, weil "
        "sich die Kontur bei ({x:.4f}; {y:.4f}) mm in den Segmenten {one} und {two} selbst "
        "berührt.",
        "Die beiden Segmente an ihrem Schnittpunkt stutzen oder eines versetzen.",
    ),
}
