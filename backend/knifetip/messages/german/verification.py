"""verification: German texts of the messages of ``catalogue.verification``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "verify.bad-tolerance": Text(
        "Die Toleranz der Prüfung ist {tolerance} mm, das ist keine gültige Länge.",
        "Eine Zahl größer als 0 angeben, üblich sind 0,01 mm.",
    ),
    "verify.base-not-rigid": Text(
        "Die Rilltiefen des Kartons {board}, bis {depth:.2f} mm, gelten für eine starre "
        "Rillunterlage, die Maschine hat aber eine weiche: Die Rillen werden flacher und breiter.",
        "Ein Muster rillen und die Rilltiefen des Kartons der weichen Unterlage anpassen.",
    ),
    "verify.base-not-soft": Text(
        "Die Rilltiefen des Kartons {board}, bis {depth:.2f} mm, gelten für eine weiche "
        "Rillunterlage, die Maschine hat aber eine starre: Das Rad kann die Oberseite aufschneiden "
        "oder den Karton zerdrücken.",
        "Eine weiche Rillmatte auflegen und in der Maschinendatei angeben, oder die Rilltiefen des "
        "Kartons verringern.",
    ),
    "verify.beside-line": Text(
        "Die Bahn des Werkzeugs ({tool:tool}) liegt {distance:.3f} mm neben der Kante, der sie "
        "folgen soll.",
        "Den Auftrag neu berechnen. Bleibt der Befund, ihn mit der Programmdatei als internen "
        "Fehler melden.",
    ),
    "verify.blade-bend": Text(
        "Das Messer dreht sich auf einer Biegung mit Radius {radius:.2f} mm innerhalb seiner "
        "Klingenbreite von {width:g} mm um {turn:.0f}° im Karton. Es schneidet die Oberseite bis "
        "zu {top:.3f} mm neben der Linie, und der Rücken der Klinge läuft bis zu {rear:.2f} mm "
        "daneben.",
    ),
    "verify.blade-bend-too-tight": Text(
        "Die Biegung ist für das Messer zu eng: Auf einem Radius von {radius:.2f} mm dreht es "
        "sich innerhalb seiner Klingenbreite von {width:g} mm um {turn:.0f}° im Karton. Es "
        "schneidet die Oberseite bis zu {top:.2f} mm neben der Linie (zulässig: {tolerance:g} "
        "mm), und der Rücken der Klinge läuft bis zu {rear:.2f} mm daneben.",
        "Eine Biegung mit einem Radius von mindestens {least:.1f} mm oder eine scharfe Ecke "
        "zeichnen, ein Messer mit steilerer oder schmalerer Klinge verwenden, oder die "
        "Einschränkung annehmen.",
    ),
    "verify.blade-not-parked": Text(
        "Am Ende des Programms steht das Schleppmesser von Station {station} in der Richtung "
        "{heading:.1f}°, aber das nächste Programm erwartet {park:g}°.",
        "Den Auftrag neu berechnen. Bleibt der Befund, ihn mit der Programmdatei als internen "
        "Fehler melden.",
    ),
    "verify.blade-pushed": Text(
        "Eine Bewegung von {length:.2f} mm schiebt die Spitze des Schleppmessers von seiner Achse "
        "weg, statt sie zu ziehen. Die Klinge kann dabei zu beiden Seiten umschlagen oder den "
        "Karton reißen.",
        "Den Auftrag neu berechnen. Bleibt der Befund, ihn mit der Programmdatei als internen "
        "Fehler melden.",
    ),
    "verify.bridge-near-corner": Text(
        "Der Haltesteg bei {place:.3f} mm ab Anfang der Kontur liegt {distance:.3f} mm zu nahe an "
        "einer scharfen Ecke.",
        "Den Auftrag neu berechnen oder in der Materialdatei einen kleineren Abstand der "
        "Haltestege wählen.",
    ),
    "verify.bridge-spacing": Text(
        "Der Haltesteg bei {place:.3f} mm ab Anfang der Kontur ist {distance:.3f} mm vom nächsten "
        "Haltesteg entfernt, aber das Material erlaubt höchstens {most:g} mm.",
        "Den Auftrag neu berechnen oder in der Materialdatei einen größeren Abstand der "
        "Haltestege erlauben.",
    ),
    "verify.bridge-spare": Text(
        "Der Haltesteg bei {place:.3f} mm ab Anfang der Kontur ist nicht nötig, weil die "
        "Haltestege vor und nach ihm nur {distance:.3f} mm auseinanderliegen.",
        "Den Auftrag neu berechnen. Bleibt der Befund, ihn mit der Programmdatei als internen "
        "Fehler melden.",
    ),
    "verify.bridge-width": Text(
        "Der Haltesteg bei {place:.3f} mm ab Anfang der Kontur ist an der Oberseite des Kartons "
        "{width:.3f} mm breit, aber das Material braucht Haltestege von {planned:g} mm Breite.",
        "Den Auftrag für dieses Material neu berechnen.",
    ),
    "verify.centre-off-path": Text(
        "Die Mitte des Fräsers liegt {distance:.4f} mm neben ihrer geplanten Bahn, und die "
        "Steuerung darf Ecken um weitere {rounding:.4f} mm runden. Die Toleranz ist {tolerance:g} "
        "mm.",
        "Die Toleranz erhöhen oder mit der Programmdatei einen internen Fehler melden.",
    ),
    "verify.cleaning-beyond": Text(
        "Interner Fehler beim Bereinigen: Die bereinigte Kante geht über alle Kanten der "
        "Zeichnung hinaus.",
        "Diesen Fehler mit der Zeichnung melden.",
    ),
    "verify.cleaning-dropped": Text(
        "Interner Fehler beim Bereinigen: {length:.3f} mm der Kante gingen verloren.",
        "Diesen Fehler mit der Zeichnung melden.",
    ),
    "verify.cleaning-fit": Text(
        "Interner Fehler beim Bereinigen: Die Kante liegt {distance:.4f} mm neben dem Kreisbogen, "
        "der sie ersetzt, und nur {stated:.4f} mm sind angegeben.",
        "Diesen Fehler mit der Zeichnung melden.",
    ),
    "verify.cleaning-incomplete": Text(
        "Interner Fehler beim Bereinigen: Die behaltenen, verbundenen und weggelassenen Teile der "
        "Kante ergeben zusammen nicht ihre Länge.",
        "Diesen Fehler mit der Zeichnung melden.",
    ),
    "verify.cleaning-invented": Text(
        "Interner Fehler beim Bereinigen: Die bereinigte Kante entspricht keiner Kante der "
        "Zeichnung.",
        "Diesen Fehler mit der Zeichnung melden.",
    ),
    "verify.cleaning-moved": Text(
        "Interner Fehler beim Bereinigen: Die Kante wurde um {distance:.4f} mm verschoben.",
        "Diesen Fehler mit der Zeichnung melden.",
    ),
    "verify.cleaning-type": Text(
        "Interner Fehler beim Bereinigen: Die Kante hat vorher die Linienart „{drawn:type}“ und "
        "danach „{worked:type}“.",
        "Diesen Fehler mit der Zeichnung melden.",
    ),
    "verify.comes-out-anywhere": Text(
        "Das Messer verlässt den Karton an einem Punkt, der weder das Ende einer Kante ist noch "
        "der Punkt, an dem es eingetaucht ist.",
        "Den Auftrag neu berechnen. Bleibt der Befund, ihn mit der Programmdatei als internen "
        "Fehler melden.",
    ),
    "verify.comes-out-past": Text(
        "Das Messer verlässt den Karton {distance:.3f} mm hinter dem Ende der Kante.",
        "Den Auftrag neu berechnen. Bleibt der Befund, ihn mit der Programmdatei als internen "
        "Fehler melden.",
    ),
    "verify.comes-out-short": Text(
        "Das Messer verlässt den Karton {distance:.3f} mm vor dem Ende der Kante.",
        "Den Auftrag neu berechnen. Bleibt der Befund, ihn mit der Programmdatei als internen "
        "Fehler melden.",
    ),
    "verify.contour-unreached": Text(
        "Der Fräser mit {width:.2f} mm Durchmesser passt nicht in die Kontur dieser Kante oder "
        "neben sie, also wird nichts von der Kontur geschnitten ({length:.3f} mm an dieser "
        "Kante).",
        "Einen dünneren Fräser wählen, die Öffnung vergrößern, oder annehmen, dass die Kontur "
        "nicht geschnitten wird.",
    ),
    "verify.crease-meets-cuts": Text(
        "An {count} Rillen enden Schnitte von einer Seite. Diese Rillen werden ohne Unterbrechung "
        "gemacht, weil alle Rillen vor den Schnitten gemacht werden.",
    ),
    "verify.crease-stops-at-cut": Text(
        "Schnitte kreuzen {count} Rillen. Das Rillrad hält vor diesen Schnitten an, und auf jeder "
        "Seite eines Schnitts bleiben bis zu {distance:.2f} mm ungerillt.",
        "Wenn die Faltung diese Länge braucht, ein kleineres Rillrad wählen oder den Schnitt "
        "versetzen.",
    ),
    "verify.crease-too-bent": Text(
        "Die Rille ist für das Rillrad zu eng gebogen: Ein Rad mit {wheel:g} mm Radius berührt "
        "den Karton auf einer geraden Strecke von {contact:.1f} mm, deren Enden bis zu "
        "{distance:.2f} mm neben der Rille drücken (zulässig: {tolerance:g} mm). {length:.1f} mm "
        "der Rille werden nicht gedrückt.",
        "Ein Rillrad mit höchstens {smaller:.1f} mm Radius einsetzen, eine Biegung mit mindestens "
        "{radius:d} mm Radius zeichnen, die Linienart auf „Perforation“ oder „Ritzen“ setzen, "
        "oder die Einschränkung annehmen.",
    ),
    "verify.crease-too-short": Text(
        "Die Rille ist für das Rillrad zu kurz und wird nicht gemacht: Sie ist {length:.2f} mm "
        "lang, das Rad hat einen Radius von {radius:.1f} mm und muss {clearance:.2f} mm vor jedem "
        "freien Ende anhalten.",
        "Die Rille mit einer Rille auf derselben Geraden verbinden, ihre Linienart auf "
        "„Ignoriert“ setzen, oder ein Material, bei dem kurze Rillen gedrückt werden, oder ein "
        "kleineres Rillrad wählen.",
    ),
    "verify.cut-both-ways": Text(
        "{length:.3f} mm dieser Kante werden in beiden Richtungen geschnitten. Eine schräge "
        "Klinge schneidet die Oberseite dann über beide Enden hinaus.",
        "Den Auftrag neu berechnen. Bleibt der Befund, ihn mit der Programmdatei als internen "
        "Fehler melden.",
    ),
    "verify.cut-too-short": Text(
        "Der Schnitt ist {length:.2f} mm lang und endet in einem Feld. Die schräge Klinge des "
        "Messers braucht einen Schnitt, der länger ist als {lead:.2f} mm, also wird er nicht "
        "gemacht.",
        "Einen längeren Schnitt zeichnen, ihn mit einem anderen verbinden, seine Linienart auf "
        "„Ignoriert“ setzen, oder ein Messer mit weniger schräger Klinge wählen.",
    ),
    "verify.cuts-part": Text(
        "Der Fräser schneidet seitlich in ein Teil, bis zu {depth:.3f} mm von dessen Rand.",
        "Die Teile weiter auseinandersetzen oder einen dünneren Fräser wählen.",
    ),
    "verify.deep-swivel": Text(
        "Das Schleppmesser wird in einer Tiefe von {depth:.2f} mm statt {planned:g} mm um seine "
        "Spitze gedreht.",
        "Den Auftrag neu berechnen. Bleibt der Befund, ihn mit der Programmdatei als internen "
        "Fehler melden.",
    ),
    "verify.drawn-twice": Text(
        "Zwei Linien der Art „{type:type}“ liegen auf {length:.1f} mm Länge {distance:.2f} mm "
        "auseinander, näher als der Karton dick ist. Ist dieselbe Linie zweimal gezeichnet?",
        "Die Linienart einer der beiden auf „Ignoriert“ setzen, sie auseinandersetzen, oder "
        "annehmen, dass beide gemacht werden.",
    ),
    "verify.fixed-blade": Text(
        "Das Material wird am besten mit oszillierender Klinge geschnitten, und das Messer von "
        "Station {station} steht fest: Es drückt dicken oder weichen Karton zusammen.",
        "Eine Maschine mit oszillierendem Messer wählen oder zuerst ein Muster schneiden.",
    ),
    "verify.flank-inside": Text(
        "Die Flanke der V-Nut trifft die Oberseite des Kartons {distance:.4f} mm zu nahe an der "
        "Mittellinie der Nut. Die Toleranz ist {tolerance:g} mm.",
        "Neigung und Versatz des V-Messers in der Maschinendatei prüfen, dann den Auftrag neu "
        "berechnen.",
    ),
    "verify.flank-outside": Text(
        "Die Flanke der V-Nut trifft die Oberseite des Kartons {distance:.4f} mm zu weit von der "
        "Mittellinie der Nut. Die Toleranz ist {tolerance:g} mm.",
        "Neigung und Versatz des V-Messers in der Maschinendatei prüfen, dann den Auftrag neu "
        "berechnen.",
    ),
    "verify.flank-through-cut": Text(
        "Eine Flanke der V-Nut reicht {depth:.3f} mm seitlich über den Schnitt an Kante {edge} "
        "hinaus. Der Schnitt liegt {distance:.3f} mm von der Mittellinie der Nut, {place:.1f} mm "
        "ab Anfang der Nut.",
        "Nut und Schnitt weiter auseinandersetzen oder eine flachere Nut wählen.",
    ),
    "verify.fold-angle": Text(
        "Mit der V-Nut lässt sich der Karton um {angle:.1f}° falten, aber hier muss er sich um "
        "{required:.1f}° falten lassen.",
        "Ein V-Messer mit größerer Neigung wählen oder den Faltwinkel der Schachtel in der "
        "Materialdatei angeben (fold_angle).",
    ),
    "verify.goes-in-anywhere": Text(
        "Das Messer taucht an einem Punkt in den Karton ein, an dem keine Kante beginnt.",
        "Den Auftrag neu berechnen. Bleibt der Befund, ihn mit der Programmdatei als internen "
        "Fehler melden.",
    ),
    "verify.groove-arc": Text(
        "Die V-Nut ist ein Kreisbogen, dem eine geneigte Klinge nicht folgen kann.",
        "Die V-Nut mit geraden Linien zeichnen oder eine andere Linienart wählen.",
    ),
    "verify.groove-past-ends": Text(
        "Das V-Messer schneidet {length:.2f} mm über die Enden der Nut hinaus, aber das Material "
        "erlaubt nur {most:.2f} mm Überschnitt.",
        "Ein V-Messer mit schmalerer Klinge wählen oder in der Materialdatei einen längeren "
        "Überschnitt erlauben.",
    ),
    "verify.groove-shallower": Text(
        "Das V-Messer schneidet {depth:.3f} mm tief, obwohl ein früherer Durchgang derselben Nut "
        "schon {before:.3f} mm tief war.",
        "Die Durchgänge nach zunehmender Tiefe ordnen.",
    ),
    "verify.groove-shifted": Text(
        "Die V-Nut wurde um {distance:.2f} mm verschoben, damit ihre Flanke den Schnitt daneben "
        "nicht erreicht.",
        "Wenn die Faltung sich nicht verschieben darf, den Schnitt versetzen oder groove_shift in "
        "der Materialdatei auf 0 setzen.",
    ),
    "verify.groove-too-short": Text(
        "Die V-Nut ist {length:.2f} mm lang, aber die Klinge ist {blade:.2f} mm breit, also wird "
        "die Nut nicht gemacht.",
        "Eine längere Nut zeichnen, ihre Linienart auf „Rillen“ oder „Ignoriert“ setzen, oder ein "
        "V-Messer mit schmalerer Klinge wählen.",
    ),
    "verify.grooves-at-angle": Text(
        "Zwei V-Nuten treffen sich unter {angle:.1f}° bei X{x:.3f} Y{y:.3f} (Koordinaten des "
        "Bogens), und jede ist an der Oberseite {width:.2f} mm breit. Von dort an bleibt auf "
        "{length:.1f} mm Länge kein Grat zwischen ihnen.",
        "Die Nuten unter einem größeren Winkel zeichnen oder eine vor der anderen enden lassen, in "
        "der Materialdatei eine kleinere Nuttiefe wählen, oder die Einschränkung annehmen.",
    ),
    "verify.grooves-meet": Text(
        "Zwei V-Nuten liegen {distance:.2f} mm auseinander, aber jede ist an der Oberseite "
        "{width:.2f} mm breit. Auf {length:.1f} mm Länge treffen sich ihre Flanken, und zwischen "
        "ihnen bleibt kein Grat.",
        "Die Nuten auseinandersetzen, in der Materialdatei eine kleinere Nuttiefe wählen, oder "
        "die Einschränkung annehmen.",
    ),
    "verify.hanging-piece": Text(
        "Die Kante bei X{x:.3f} Y{y:.3f} (Koordinaten des Bogens) liegt auf einem Teil des "
        "Kartons, das ab Programmzeile {line} nur noch an Haltestegen oder schmalen Verbindungen "
        "hängt und sich deshalb bewegen kann.",
        "Diese Kante vor dem Schnitt machen, der nur Haltestege oder schmale Verbindungen übrig "
        "lässt.",
    ),
    "verify.inside-part": Text(
        "Der Fräser schneidet bei X{x:.3f} Y{y:.3f} (Koordinaten des Bogens) in ein fertiges Teil.",
        "Die Teile weiter auseinandersetzen oder einen dünneren Fräser wählen.",
    ),
    "verify.loose-piece": Text(
        "Die Kante bei X{x:.3f} Y{y:.3f} (Koordinaten des Bogens) liegt auf einem Teil des "
        "Kartons, das Programmzeile {line} schon ausgeschnitten hat, also kann es sich bewegen.",
        "Diese Kante vor der Kontur machen, die dieses Teil ausschneidet. Wo sich Konturen "
        "kreuzen, sie in der Zeichnung an den Kreuzungen teilen. Macht ein Fräser offene "
        "Konturen, sie schließen oder eine Maschine mit Messer wählen.",
    ),
    "verify.made-before": Text(
        "Station {station} bearbeitet {length:.3f} mm bei X{x:.3f} Y{y:.3f} (Koordinaten des "
        "Bogens), obwohl ein früheres Programm diese Linie auf dem Bogen schon gemacht hat.",
        "Ab einer späteren Kontur fortsetzen oder einen neuen Bogen beginnen.",
    ),
    "verify.narrow-cuts": Text(
        "Zwei Schnitte liegen auf {length:.1f} mm Länge {distance:.2f} mm auseinander. Der "
        "Streifen oder Schlitz dazwischen ist schmaler, als der Karton dick ist ({caliper:g} mm), "
        "und kann reißen oder stecken bleiben.",
    ),
    "verify.narrow-lines": Text(
        "Eine Linie der Art „{type:type}“ und eine der Art „{other:type}“ liegen auf {length:.1f} "
        "mm Länge {distance:.2f} mm auseinander, zu nahe für {caliper:g} mm dicken Karton: Der "
        "schmale Streifen dazwischen wird zerdrückt oder reißt ab.",
    ),
    "verify.narrow-rim": Text(
        "Das Rillrad hat einen Rand von {width:g} mm, der für {caliper:g} mm dicken Karton schmal "
        "ist: Er kann die Oberseite aufschneiden, statt sie einzudrücken.",
        "Ein Rillrad mit einem Rand von mindestens {least:g} mm einsetzen.",
    ),
    "verify.narrow-slits": Text(
        "{count} Schlitze und Schnitte zwischen zwei Teilen ({length:.1f} mm) werden {width:g} mm "
        "breit: Der Karton auf jeder Seite verliert die Hälfte dieses Streifens.",
    ),
    "verify.no-such-shortfall": Text(
        "Das Prüfergebnis hat keinen Befund {code} an Kante {edge}.",
        "Die Befunde noch einmal lesen: Zeichnung oder Programm können sich inzwischen geändert "
        "haben.",
    ),
    "verify.not-acceptable": Text(
        "Der Befund {code} an Kante {edge} ist keine Einschränkung, kann also nicht angenommen "
        "werden. Eine Einschränkung ist eine Linie, die das Werkzeug nicht genau wie gezeichnet "
        "machen kann.",
        "Die Zeichnung, das Werkzeug oder das Material ändern und den Auftrag neu berechnen.",
    ),
    "verify.not-worked": Text(
        "Auf {length:.3f} mm entlang der Kante fehlt {work}. {where}",
        "Den Auftrag neu berechnen. Bleibt der Befund, ihn mit der Programmdatei als internen "
        "Fehler melden.",
    ),
    "verify.off-curve": Text(
        "Die Kante nähert eine Kurve der Zeichnung an und liegt {fit:.4f} mm neben ihr. Die Bahn "
        "des Werkzeugs liegt {distance:.4f} mm neben der Kante, und die Steuerung darf Ecken um "
        "weitere {rounding:.4f} mm runden. Die Summe übersteigt die Toleranz von {tolerance:g} "
        "mm.",
        "Die Kurve mit Linien und Kreisbögen zeichnen oder mit größerer Toleranz prüfen.",
    ),
    "verify.off-line": Text(
        "Die Bahn des Werkzeugs ({tool:tool}) liegt {distance:.4f} mm neben der Kante, der sie "
        "folgen soll, und die Steuerung darf Ecken um weitere {rounding:.4f} mm runden. Die "
        "Toleranz ist {tolerance:g} mm.",
        "Die Toleranz erhöhen oder mit der Programmdatei einen internen Fehler melden.",
    ),
    "verify.one-pass": Text(
        "Der Karton sollte in Durchgängen von höchstens {step:g} mm geschnitten werden, aber "
        "Programme für diese Steuerung bestimmen die Tiefe nicht: Das Messer schneidet {depth:g} "
        "mm in einem Durchgang.",
        "Das Programm mehrmals laufen lassen, zuerst mit weniger Druck auf dem Messer.",
    ),
    "verify.other-placement": Text(
        "Das Programm legt die Zeichnung auf X{x:.4f} Y{y:.4f} des Bogens, der Auftrag aber auf "
        "X{job_x:.4f} Y{job_y:.4f}.",
        "Den Auftrag neu berechnen oder das Programm mit der Lage X{x:.4f} Y{y:.4f} der Zeichnung "
        "prüfen.",
    ),
    "verify.outline-begun": Text(
        "Die Kante bei X{x:.3f} Y{y:.3f} (Koordinaten des Bogens) liegt auf einem Teil des "
        "Kartons, dessen Außenkontur das Programm in Zeile {line} zu schneiden beginnt, bevor "
        "diese Kante gemacht ist.",
        "Rillen, Nuten, Ritzungen und Perforationen vor der Außenkontur ihres Teils machen.",
    ),
    "verify.pass-alone": Text(
        "Der Fräser fräst {length:.3f} mm nur {depth:.3f} mm tief, und kein anderer Durchgang "
        "geht dort durch den Karton.",
        "Den Auftrag neu berechnen. Bleibt der Befund, ihn mit der Programmdatei als internen "
        "Fehler melden.",
    ),
    "verify.pass-too-deep": Text(
        "Das Werkzeug ({tool:tool}) schneidet auf {length:.3f} mm Länge {depth:.3f} mm tief in "
        "einem einzigen Durchgang, aber höchstens {step:g} mm je Durchgang sind erlaubt.",
        "Einen flacheren Durchgang hinzufügen oder in der Materialdatei tiefere Durchgänge "
        "erlauben.",
    ),
    "verify.program-too-large": Text(
        "Das Programm hat {bytes:,} Byte, aber die Steuerung von {machine} nimmt {limit:,}.",
        "Die Zeichnung in mehreren Aufträgen herstellen oder eine andere Maschine wählen. Die "
        "Grenze ist program_memory in der Maschinendatei.",
    ),
    "verify.swivel-mark": Text(
        "Das Schleppmesser dreht sich um {turn:.0f}° um seine Spitze, und seine schräge Schneide "
        "schneidet die Oberseite bis zu {mark:.2f} mm neben der Linie (zulässig: {tolerance:g} "
        "mm).",
        "Das Messer in geringerer Tiefe drehen lassen (`swivel_depth` des Messers), eine Klinge "
        "mit steilerer Schneide verwenden, oder die Spur annehmen.",
    ),
    "verify.past-end": Text(
        "Das Werkzeug ({tool:tool}) läuft {length:.3f} mm über das Ende der Kante hinaus.",
        "Den Auftrag neu berechnen. Bleibt der Befund, ihn mit der Programmdatei als internen "
        "Fehler melden.",
    ),
    "verify.past-open-cut": Text(
        "Der Fräser läuft {length:.3f} mm über das Ende eines offenen Schnitts hinaus.",
        "Den Auftrag neu berechnen. Bleibt der Befund, ihn mit der Programmdatei als internen "
        "Fehler melden.",
    ),
    "verify.past-stop": Text(
        "Das Werkzeug ({tool:tool}) schneidet {length:.3f} mm über den Punkt hinaus, an dem es "
        "anhalten muss.",
        "Den Auftrag neu berechnen. Bleibt der Befund, ihn mit der Programmdatei als internen "
        "Fehler melden.",
    ),
    "verify.perforation-bridge": Text(
        "Ein Steg der Perforation, der {place:.3f} mm ab Anfang der Kante beginnt, ist an der "
        "Oberseite des Kartons nur {length:.3f} mm lang, muss aber mindestens {least:.3f} mm lang "
        "sein, um den Karton zu halten.",
        "Den Auftrag für dieses Material neu berechnen.",
    ),
    "verify.perforation-cut": Text(
        "Ein Schnitt der Perforation ist {length:.3f} mm statt {planned:.3f} mm lang.",
        "Den Auftrag für dieses Material neu berechnen.",
    ),
    "verify.perforation-gap": Text(
        "Ein Steg der Perforation, der {place:.3f} mm ab Anfang der Kante beginnt, ist "
        "{length:.3f} mm lang, aber das Material braucht Stege von {planned:g} mm.",
        "Den Auftrag für dieses Material neu berechnen.",
    ),
    "verify.perforation-uneven": Text(
        "Ein Schnitt der Perforation liegt nicht an seiner geplanten Stelle: Der Steg, der "
        "{place:.3f} mm ab Anfang der Kante beginnt, ist {first:.3f} mm lang, der Steg nach dem "
        "Schnitt {second:.3f} mm.",
        "Den Auftrag für dieses Material neu berechnen.",
    ),
    "verify.released-before": Text(
        "Die Kante bei X{x:.3f} Y{y:.3f} (Koordinaten des Bogens) liegt auf einem Teil des "
        "Kartons, das ein früheres Programm auf diesem Bogen schon ganz oder teilweise "
        "ausgeschnitten hat.",
        "Ab der ersten nicht gemachten Kontur fortsetzen oder einen neuen Bogen beginnen. Hat das "
        "Werkzeug den Karton nicht durchtrennt, dies beim Fortsetzen des Auftrags angeben.",
    ),
    "verify.replaced": Text(
        "{length:.2f} mm dieser Linie der Art „{type:type}“ werden nicht gemacht, weil eine Linie "
        "der Art „{other:type}“ auf ihr liegt und stattdessen gemacht wird.",
        "Wenn „{type:type}“ gemeint ist, die Linienart der anderen Linie auf „Ignoriert“ setzen.",
    ),
    "verify.slanted": Text(
        "Station {station} bewegt sich {distance:.3f} mm seitwärts (weg von der Achse ihres "
        "Werkzeugs), während das Werkzeug in den Karton eintaucht oder ihn verlässt.",
        "Das Werkzeug beim Eintauchen und Austreten entlang seiner Achse bewegen.",
    ),
    "verify.stray": Text(
        "Das Werkzeug ({tool:tool}) bearbeitet bei X{x:.3f} Y{y:.3f} (Koordinaten des Bogens) "
        "{length:.3f} mm des Kartons, wo die Zeichnung keine Kante hat.",
        "Den Auftrag neu berechnen. Bleibt der Befund, ihn mit der Programmdatei als internen "
        "Fehler melden.",
    ),
    "verify.stray-along": Text(
        "Das Werkzeug ({tool:tool}) bearbeitet {length:.3f} mm entlang Kante {edge}, deren "
        "Linienart („{type:type}“) nicht mit diesem Werkzeug gemacht werden darf.",
        "Die Linienart der Kante prüfen, dann den Auftrag neu berechnen.",
    ),
    "verify.stray-plunge": Text(
        "Das Werkzeug ({tool:tool}) taucht bei X{x:.3f} Y{y:.3f} (Koordinaten des Bogens) in den "
        "Karton ein, wo die Zeichnung keine Kante hat.",
        "Den Auftrag neu berechnen. Bleibt der Befund, ihn mit der Programmdatei als internen "
        "Fehler melden.",
    ),
    "verify.stray-plunge-along": Text(
        "Das Werkzeug ({tool:tool}) taucht auf Kante {edge} in den Karton ein, deren Linienart "
        "(„{type:type}“) nicht mit diesem Werkzeug gemacht werden darf.",
        "Die Linienart der Kante prüfen, dann den Auftrag neu berechnen.",
    ),
    "verify.stub-too-short": Text(
        "Die letzten {length:.2f} mm des Schnitts, von einer Ecke, an der das Messer gehoben wird, "
        "bis zu einem Ende in einem Feld, werden nicht gemacht: Dort braucht die schräge Klinge "
        "einen Schnitt, der länger ist als {lead:.2f} mm.",
        "Das letzte Stück länger zeichnen, sein Ende mit einem anderen Schnitt verbinden, seine "
        "Linienart auf „Ignoriert“ setzen, oder ein Messer mit weniger schräger Klinge wählen.",
    ),
    "verify.too-few-bridges": Text(
        "Nur {bridges:# Haltesteg hält|# Haltestege halten} das Teil, aber das Material braucht "
        "mindestens {fewest:# Haltesteg|# Haltestege}.",
        "Den Auftrag neu berechnen oder in der Materialdatei weniger Haltestege verlangen. Wo "
        "sich Konturen kreuzen, sie in der Zeichnung an den Kreuzungen teilen.",
    ),
    "verify.unclassified": Text(
        "Die Kante hat keine Linienart (wie „Schneiden“ oder „Rillen“), also ist das nötige "
        "Werkzeug nicht bekannt.",
        "Der Kante eine Linienart geben.",
    ),
    "verify.unreached": Text(
        "Der Fräser erreicht {length:.3f} mm der Kante an {places:# Stelle|# Stellen} nicht, ohne "
        "in ein Teil zu schneiden. Die Kante liegt bis zu {distance:.3f} mm neben dem Karton, den "
        "der Fräser abträgt.",
        "Einen dünneren Fräser wählen, den Schlitz verbreitern, oder die Innenecken mit "
        "mindestens dem Radius des Fräsers runden.",
    ),
    "verify.wheel-below-base": Text(
        "Das Rillrad wird {depth:.3f} mm unter die Oberfläche der Matte gedrückt, {excess:.3f} mm "
        "tiefer, als die Rillunterlage nachgibt ({most:.3f} mm).",
        "Den Auftrag für diese Maschine neu berechnen, oder eine weiche Rillmatte auflegen und "
        "ihre Nachgiebigkeit in der Maschinendatei angeben.",
    ),
    "verify.where-from-start": Text(
        "Das fehlende Stück beginnt {place:.3f} mm ab Anfang der Kante.",
    ),
    "verify.where-past-end": Text(
        "Das Werkzeug muss den Karton auch hinter dem Ende der Kante bearbeiten.",
    ),
    "verify.where-past-start": Text(
        "Das Werkzeug muss den Karton auch vor dem Anfang der Kante bearbeiten.",
    ),
    "verify.wide-rim": Text(
        "Das Rillrad hat einen Rand von {width:g} mm, der für {caliper:g} mm dicken Karton breit "
        "ist: Der Wulst wird breit, und die Faltung hat keine bestimmte Linie.",
        "Ein Rillrad mit einem Rand von höchstens {most:g} mm einsetzen.",
    ),
    "verify.wide-slit": Text(
        "Der Fräser macht {length:.3f} mm des Schlitzes {width:.2f} mm breit, weil seine Mitte "
        "der Linie des Schlitzes folgt.",
        "Den Schlitz mit einem Messer schneiden, einen dünneren Fräser wählen, oder den Schlitz "
        "als Kontur in seiner gewünschten Breite zeichnen.",
    ),
    "verify.work-creased": Text(
        "die Rille",
    ),
    "verify.work-cut": Text(
        "der Schnitt",
    ),
    "verify.work-grooved": Text(
        "die Nut",
    ),
    "verify.work-grooved-from-end": Text(
        "die Nut in der Richtung vom Ende zum Anfang der Kante",
    ),
    "verify.work-grooved-from-start": Text(
        "die Nut in der Richtung vom Anfang zum Ende der Kante",
    ),
    "verify.wrong-depth": Text(
        "Das Werkzeug ({tool:tool}) ist {depth:.4f} mm statt {planned:.4f} mm unter der Oberseite "
        "des Kartons.",
        "Den Auftrag für dieses Material neu berechnen.",
    ),
    "verify.wrong-heading": Text(
        "Das Werkzeug ({tool:tool}) ist {degrees:.3f}° gegen die Richtung der Kante verdreht, was "
        "seine Schneide {swing:.3f} mm zur Seite bewegt.",
        "Den Auftrag neu berechnen. Bleibt der Befund, ihn mit der Programmdatei als internen "
        "Fehler melden.",
    ),
}
