"""registration: German texts of the messages of ``catalogue.registration``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "registration.bound-to-machine": Text(
        "Der gedruckte Bogen von Auftrag {job} wurde auf der Maschine {machine} gemessen.",
        "Zuerst die gemessenen Marken an dieser Maschine verwerfen und den Bogen dort neu messen, "
        "wo er dann liegt.",
    ),
    "registration.close": Text(
        "Die Marken {other} und {mark} wurden fast am selben Ort gemessen: {distance:.2f} mm "
        "auseinander bei X {x:.2f}, Y {y:.2f} mm.",
        "Jede Marke anfahren, bevor ihre Position übernommen wird, und beide neu messen.",
    ),
    "registration.count": Text(
        "Die Anfrage hat {given} gemessene Positionen, Auftrag {job} aber {count} Marken.",
        "Jede Marke messen, in der Reihenfolge des Auftrags.",
    ),
    "registration.edge-elsewhere": Text(
        "Kante {edge} liegt {distance:.4g} mm von dem Ort entfernt, den die gemessenen Marken "
        "ergeben",
    ),
    "registration.error": Text(
        "Marke {mark} wurde bei X {x:.2f}, Y {y:.2f} mm gemessen, {distance:.2f} mm von dem Ort "
        "entfernt, den alle Marken zusammen ergeben; {limit:g} mm sind erlaubt.",
        "Die Marken neu messen. Wenn alle stimmen, ist der Druck verzerrt: im Auftrag einen "
        "größeren Fehler erlauben oder den Maßstab anpassen lassen.",
    ),
    "registration.forgotten": Text(
        "gemessene Marken verworfen; der Bogen liegt an den Anschlägen",
    ),
    "registration.laid": Text(
        "Gedruckter Bogen mit {count} Marken: Verschiebung X {x:.2f}, Y {y:.2f} mm, Drehung "
        "{turn:.3f}°, Maßstab {scale:.5f}, größter Fehler {error:.2f} mm.",
    ),
    "registration.measured": Text(
        "Marken gemessen: {count}, Drehung {turn:.3f}°, Maßstab {scale:.5f}, größter Fehler "
        "{error:.2f} mm",
    ),
    "registration.measured-in-order": Text(
        "Die Bestellung enthält gemessene Positionen von Marken. Wo ein Bogen liegt, ist erst "
        "bekannt, wenn er auf dem Tisch ist.",
        "Den Auftrag nur mit seinen Marken bestellen und die Positionen senden, wenn die Maschine "
        "wartet: POST /api/jobs/ID/registration.",
    ),
    "registration.mirrored": Text(
        "Die gemessenen Marken sind ein Spiegelbild derer in der Zeichnung.",
        "Prüfen, in welcher Reihenfolge die Marken gemessen wurden und ob die bedruckte Seite so "
        "oben liegt, wie die Zeichnung sie zeigt.",
    ),
    "registration.no-marks": Text(
        "Auftrag {job} hat keine Marken.",
        "Den Auftrag mit den Marken des gedruckten Bogens bestellen.",
    ),
    "registration.no-station": Text(
        "{machine} hat keine Station {station}.",
        "Die Station wählen, mit der die Marken gemessen wurden.",
    ),
    "registration.not-measured": Text(
        "{count} Marken sind nicht gemessen: Das Programm gilt für einen Bogen an den Anschlägen "
        "der Maschine.",
    ),
    "registration.not-waiting": Text(
        "Auftrag {job} wartet nicht an seiner Maschine auf die Bestätigung des Bedieners, also "
        "können seine Marken nicht gemessen werden.",
        "Die Marken messen, wenn die Maschine den Auftrag übernommen hat und auf den Start wartet.",
    ),
    "registration.off-table": Text(
        "Nach den gemessenen Marken liegt die Zeichnung von X {x:.1f}, Y {y:.1f} bis X "
        "{right:.1f}, Y {top:.1f} mm, aber der Tisch von {machine} reicht von 0 bis {width:.0f} × "
        "{height:.0f} mm.",
        "Den Bogen verschieben und seine Marken neu messen.",
    ),
    "registration.one-copy": Text(
        "Die Bestellung hat Marken und {copies} Exemplare, aber jeder gedruckte Bogen liegt "
        "anders.",
        "Für jeden Bogen einen Auftrag bestellen.",
    ),
    "registration.other-edges": Text(
        "die Kanten auf dem Tisch sind nicht die der Zeichnung",
    ),
    "registration.scale": Text(
        "Nach den gemessenen Marken ist der Druck {scale:.4f}-mal so groß wie die Zeichnung; "
        "{least:g} bis {most:g} ist möglich.",
        "Prüfen, welche Marken gemessen wurden, ihre Reihenfolge und die Einheit der Zeichnung.",
    ),
}
