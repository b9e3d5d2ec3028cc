"""compensation: German texts of the messages of ``catalogue.compensation``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "bridges.no-room": Text(
        "Die Kontur an Kante {edge} ist {length:.1f} mm lang, zu kurz für {fewest:# Haltesteg|# "
        "Haltestege} von {gap:.2f} mm Breite. Das Material verlangt Haltestege (ungeschnittene "
        "Stellen, die ein Teil halten) in höchstens {spacing:.1f} mm Abstand, nicht an Ecken und "
        "engen Schlitzen.",
        "In der Materialdatei schmalere Haltestege oder einen größeren Abstand wählen, oder ein "
        "Material ohne Haltestege.",
    ),
    "bridges.divided-blank": Text(
        "Das Teil an Kante {edge} würde von {count:# Haltesteg|# Haltestegen} gehalten, weil "
        "Schnitte seinen Zuschnitt teilen. Das Material verlangt an jedem Teil {fewest:# "
        "Haltesteg|# Haltestege} (ungeschnittene Stellen).",
        "Die Linienart der Schnitte zwischen den Teilen auf „Ignoriert“ setzen und sie von Hand "
        "machen, in der Materialdatei einen kleineren Abstand der Haltestege wählen, oder ein "
        "Material ohne Haltestege.",
    ),
    "crease.below-base": Text(
        "{count} Rillen sind bis {depth:.2f} mm tief, die Rillunterlage von {machine} erlaubt aber "
        "{most:.2f} mm, die Dicke des Kartons und die Nachgiebigkeit der Unterlage.",
        "Einen Karton mit kleineren Rilltiefen wählen, oder eine weiche Rillmatte auflegen und "
        "ihre Nachgiebigkeit in der Maschinendatei angeben.",
    ),
    "crease.tight-bend": Text(
        "Die Doppelrille an Kante {edge} ist mit einem Radius von {radius:.2f} mm gebogen, der "
        "für eine zweite Rillinie {offset:.2f} mm weiter innen zu klein ist.",
        "Die Rille mit größerem Radius zeichnen oder die Doppelrille des Materials auf 0 setzen.",
    ),
    "cut.too-many-crossings": Text(
        "Die Zeichnung hat mehr als {limit:,} Paare von Schnitten, die sich kreuzen oder "
        "nebeneinanderliegen.",
        "Schraffuren und doppelte Linien löschen oder die Zeichnung in mehrere teilen.",
    ),
    "cut.too-short": Text(
        "Der Schnitt an Kante {edge} ist {length:.2f} mm lang und endet in einem Feld oder an "
        "einem Haltesteg. Die schräge Klinge des Messers braucht einen Schnitt von mindestens "
        "{lead:.2f} mm.",
        "Die Linienart des Schnitts auf „Ignoriert“ setzen, ihn mit einem anderen verbinden, oder "
        "ein Messer mit weniger schräger Klinge wählen.",
    ),
    "cutter.contour-touches-itself": Text(
        "Eine Kontur berührt sich selbst bei X{x:.3f} Y{y:.3f}, in den Kanten {edge} und {other}, "
        "also ist die Bahn eines Fräsers mit {diameter:.3g} mm Durchmesser daneben nicht "
        "geschlossen.",
        "Die beiden Kanten an ihrem Schnittpunkt stutzen oder eine davon versetzen.",
    ),
    "cutter.corner-loop": Text(
        "Die Kanten {edge} und {other} kreuzen sich {size:.4g} mm vor der Ecke bei X{x:.3f} "
        "Y{y:.3f}, an der sie sich treffen, also ist die Bahn eines Fräsers mit {diameter:.3g} mm "
        "Durchmesser daneben nicht geschlossen.",
        "Die beiden Kanten an ihrer Kreuzung stutzen, sodass die Ecke dort ist.",
    ),
    "cutter.interference": Text(
        "Der Fräser mit {diameter:.2f} mm Durchmesser passt nicht neben Kante {edge}: Er würde "
        "{depth:.3g} mm in das Teil an Kante {other} schneiden. Der Auftrag erlaubt keine "
        "Konturabschnitte, die der Fräser ungeschnitten lässt.",
        "„Dieses Stück ungeschnitten lassen“ wählen (interference „trim“) und die Einschränkungen "
        "annehmen, die das Prüfergebnis dann nennt, oder einen dünneren Fräser wählen.",
    ),
    "cutter.misses-bridge": Text(
        "Auf der Kontur an Kante {edge} ist {distance:.1f} mm ab Anfang dieser Kante in "
        "Fräsrichtung ein Haltesteg nötig, aber der Fräser erreicht die Kontur dort nicht.",
        "Einen dünneren Fräser wählen, ein Material mit anderem Abstand der Haltestege oder eines "
        "ohne Haltestege.",
    ),
    "cutter.narrower-slits": Text(
        "{count:# Schlitz wird|# Schlitze werden} {width:g} mm breit. Der dünnste Fräser der "
        "Bibliothek, „{title}“, macht sie {diameter:g} mm breit.",
        "Einen Fräser mit {diameter:g} mm Durchmesser einsetzen, ihn in der Maschinendatei "
        "angeben und neu berechnen, oder die breiten Schlitze annehmen.",
    ),
    "cutter.thinner-chosen": Text(
        "Der Fräser mit {diameter:g} mm Durchmesser in Station {station} macht die Schnitte: Mit "
        "dem von {thickest:g} mm ließen sich nicht alle Kanten wie gezeichnet machen.",
    ),
    "cutter.thinner-needed": Text(
        "Der Fräser mit {own:g} mm Durchmesser lässt {total:# Kante|# Kanten} ungeschnitten. Ein "
        "Fräser mit {diameter:g} mm Durchmesser, etwa „{title}“ aus der Bibliothek, macht {count} "
        "davon.",
        "Einen Fräser mit {diameter:g} mm Durchmesser einsetzen, ihn in der Maschinendatei "
        "angeben und neu berechnen, oder die ungeschnittenen Kanten annehmen.",
    ),
    "cutter.short-lead": Text(
        "Der Anlauf des Fräsers ist {lead:g} mm lang, muss aber länger sein als der Radius des "
        "Fräsers, {radius:g} mm.",
        "Den Anlauf in der Maschinendatei berichtigen.",
    ),
    "lead.no-corner": Text(
        "{count:# Kontur hat|# Konturen haben} einen Anlauf senkrecht zur Kontur, weil "
        "{count:sie|sie} keine Außenecke {count:hat|haben}, die sich um mindestens {angle:g}° "
        "dreht und Platz für den Anlauf hat. X und Y auf dem Bogen in mm ({count:eine Kontur|die "
        "ersten Konturen}): {places:; }.",
        "Nichts ist zu tun. Um an Ecken zu beginnen, die sich weniger drehen, in der "
        "Maschinendatei für den Anlauf einen negativen Winkel näher an 0° setzen.",
    ),
    "lead.no-room": Text(
        "{count:# Kontur hat|# Konturen haben} keinen Anlauf oder keinen Auslauf, weil das "
        "Werkzeug dort in eine andere Kante schneiden würde. Es taucht auf der Kontur ein oder "
        "hebt auf ihr ab, was eine Spur hinterlassen kann. X und Y auf dem Bogen in mm "
        "({count:eine Kontur|die ersten Konturen}): {places:; }.",
        "Ein dünneres Werkzeug oder einen kürzeren Anlauf wählen, oder mehr Platz zwischen den "
        "Kanten lassen.",
    ),
    "lead.shortened": Text(
        "{count:# Kontur hat|# Konturen haben} einen Anlauf oder Auslauf von halber Länge, weil "
        "das Werkzeug auf der vollen Länge von {length:.3f} mm in eine andere Kante schneiden "
        "würde. X und Y auf dem Bogen in mm ({count:eine Kontur|die ersten Konturen}): "
        "{places:; }.",
        "Für die volle Länge ein dünneres Werkzeug wählen oder mehr Platz zwischen den Kanten "
        "lassen.",
    ),
    "groove.along-edge": Text(
        "Die V-Nut an Kante {edge} trifft den Rand des Kartons in einem Winkel von nur "
        "{angle:.1f}°, würde also am Rand entlanglaufen, statt dort zu enden.",
        "Die Nut vor dem Rand des Kartons enden lassen, oder den Rand mit mindestens 5° treffen "
        "lassen.",
    ),
    "groove.curved": Text(
        "{count:# V-Nut ist ein Kreisbogen|# V-Nuten sind Kreisbögen} (die erste: Kante {edge}), "
        "{count:dem|denen} eine gerade Klinge nicht folgen kann.",
        "Die V-Nuten mit geraden Linien zeichnen, in der Materialdatei Sehnen erlauben "
        "(groove_curve), oder eine andere Linienart für sie wählen.",
    ),
    "groove.overcut": Text(
        "Das V-Messer schneidet an jedem Ende einer Nut, die im Karton endet, {overrun:.2f} mm zu "
        "weit, aber das Material erlaubt nur {allowed:.2f} mm Überschnitt.",
        "Ein V-Messer mit schmalerer Klinge wählen oder in der Materialdatei einen längeren "
        "Überschnitt erlauben.",
    ),
    "groove.runs-out": Text(
        "Die V-Nut an Kante {edge} würde {distance:.2f} mm über den Rand des Kartons hinauslaufen "
        "und in das nächste Teil schneiden.",
        "Die Nut vor dem Rand des Kartons enden lassen, sie den Rand in größerem Winkel treffen "
        "lassen, oder die Teile auseinandersetzen.",
    ),
    "groove.through-cut": Text(
        "Die V-Nut an Kante {groove} ist an der Oberseite des Kartons {width:.2f} mm breit. Bei "
        "{place:.1f} mm ab Anfang der Nut reicht ihre Flanke {through:.2f} mm seitlich über den "
        "Schnitt an Kante {cut}. Der Schnitt liegt nur {distance:.2f} mm von der Mittellinie der "
        "Nut. Das Material erlaubt, eine Nut um höchstens {limit:.2f} mm von Schnitten auf einer "
        "Seite weg zu verschieben.",
        "Nut und Schnitt {through:.2f} mm weiter auseinandersetzen, oder ein Material mit "
        "flacherer Nut wählen.",
    ),
    "groove.through-cut-at-it": Text(
        "Die V-Nut an Kante {groove} ist an der Oberseite des Kartons {width:.2f} mm breit. Bei "
        "{place:.1f} mm ab Anfang der Nut reicht ihre Flanke {through:.2f} mm seitlich über den "
        "Schnitt an Kante {cut}. Der Schnitt liegt nur {distance:.2f} mm von der Mittellinie der "
        "Nut.",
        "Die Nut am Schnitt enden lassen, den Schnitt die Nut mit mindestens 45° kreuzen lassen, "
        "oder eines von beiden versetzen.",
    ),
    "groove.tight-bend": Text(
        "Die V-Nut an Kante {edge} ist mit einem Radius von {radius:.1f} mm gebogen. Eine gerade "
        "Klinge von {blade:.2f} mm Breite würde um mehr als {error:.3f} mm davon abweichen.",
        "Die Nut mit größerem Radius zeichnen, ein V-Messer mit schmalerer Klinge wählen, oder in "
        "der Materialdatei eine größere Abweichung erlauben.",
    ),
    "groove.too-deep": Text(
        "Die V-Nut an Kante {edge} ist {depth:.2f} mm tief, aber der Karton ist nur {caliper:.2f} "
        "mm dick.",
        "Eine flachere Nut oder dickeren Karton wählen.",
    ),
    "groove.too-short": Text(
        "Die V-Nut an Kante {edge} ist {length:.2f} mm lang, aber die Klinge ist {blade:.2f} mm "
        "breit.",
        "Eine längere Nut zeichnen oder ein V-Messer mit schmalerer Klinge wählen.",
    ),
    "milling.contours-cross": Text(
        "Kante {edge} gehört zu einer Kontur, die bei X{x:.3f} Y{y:.3f} eine andere Kontur oder "
        "sich selbst kreuzt, also ist nicht klar, auf welcher Seite der Fräser laufen muss.",
        "Die Konturen an ihren Kreuzungen stutzen, sodass jedes Teil eine Außenkontur hat, oder "
        "die Linienart der Kontur, die nicht geschnitten werden soll, auf „Ignoriert“ setzen. "
        "Sollen beide Konturen geschnitten werden, wie sie gezeichnet sind, eine Maschine mit "
        "Messer wählen.",
    ),
    "milling.drawn-twice": Text(
        "{count:# Schnitt liegt|# Schnitte liegen} höchstens {distance:.3f} mm neben anderen "
        "Schnitten, etwa Kante {edge} neben Kante {other}: Einen so schmalen Streifen kann der "
        "Karton nicht halten, der Fräser trägt ihn ab.",
        "Wenn dieselbe Linie zweimal gezeichnet ist, die Linienart {count:dieses # "
        "Schnitts|dieser # Schnitte} auf „Ignoriert“ setzen. Sonst eine Maschine mit Messer "
        "wählen.",
    ),
    "milling.shared-edge": Text(
        "Zwei Teile haben Kante {edge} gemeinsam. Auf ihrer Linie würde ein Fräser mit "
        "{diameter:g} mm Durchmesser an einem Ende der Kante oder an einer Linie daneben in eines "
        "der Teile schneiden.",
        "Die Teile mindestens {diameter:g} mm auseinandersetzen. Teilt die Kante einen Zuschnitt, "
        "ihre Linienart auf „Ignoriert“ setzen und sie von Hand schneiden, oder eine Maschine mit "
        "Messer wählen.",
    ),
    "tool.bad-radius": Text(
        "Der Werkzeugradius für eine Ecke einer Kontur ist negativ oder keine Zahl.",
        "Den Radius des Werkzeugs in der Maschinendatei berichtigen.",
    ),
    "tool.cannot-work": Text(
        "Station {station} ({name}) von {machine} kann nicht benutzt werden: {reason}",
        "Die Werte des Werkzeugs in der Maschinendatei berichtigen.",
    ),
    "knife.park-heading": Text(
        "Station {station} hat ein Schleppmesser: Vor dem Start des Programms muss es in Richtung "
        "{degrees:g}° stehen. Das Programm lässt es so zurück.",
    ),
    "tool.free-without-trail": Text(
        "das Messer ist als Schleppmesser eingestellt (free), aber seine Spitze liegt auf seiner "
        "Achse (trail ist 0), Bewegungen würden es also nicht drehen",
    ),
    "tool.missing": Text(
        "{machine} hat kein Werkzeug für {count:# Kante|# Kanten} der Art „{type:type}“.",
        "Eine andere Linienart für die Kanten oder eine andere Maschine wählen.",
    ),
    "tool.short-lead": Text(
        "der Anlauf von {lead:g} mm muss 0 oder größer als der Werkzeugradius von {radius:g} mm "
        "sein",
    ),
    "tool.shallow-lead": Text(
        "der Anlauf von {lead:g} mm unter einem Winkel von {angle:g}° beginnt näher an der Kontur "
        "als der Werkzeugradius von {radius:g} mm; der Winkel muss zwischen {least:.1f}° und 90° "
        "liegen oder für einen Anlauf um eine Ecke negativ sein",
    ),
    "tool.swivel-of-driven-knife": Text(
        "`swivel_depth` oder `park_heading` ist gesetzt, aber sie gelten nur für Schleppmesser "
        "(free), und dieses Messer dreht eine Achse der Maschine",
    ),
    "tool.tilted": Text(
        "Das Werkzeug ist um {tilt:.2f}° geneigt, aber nur Werkzeuge mit bis zu {limit:g}° "
        "Neigung können entlang ihrer Achse gehoben werden.",
        "Ein Werkzeug mit höchstens {limit:g}° Neigung wählen.",
    ),
    "tool.without-power": Text(
        "Die Leistung des Lasers ist 0.",
        "Die Leistung des Lasers in der Maschinendatei setzen.",
    ),
    "tool.without-speed": Text(
        "Die Spindeldrehzahl des Fräsers ist 0.",
        "Die Spindeldrehzahl des Fräsers in der Maschinendatei setzen.",
    ),
    "track.too-flat": Text(
        "Am Rand des Kartons weicht die Richtung der Werkzeugbahn {track} um {angle:.2f}° von der "
        "Senkrechten auf den Rand ab, aber höchstens {limit:g}° sind erlaubt.",
        "Die Linie im Karton enden lassen oder sie den Rand näher am rechten Winkel kreuzen "
        "lassen.",
    ),
}
