"""classification: German texts of the messages of ``catalogue.classification``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "classification.across": Text(
        "die Kante trifft im Zuschnitt auf andere Linien, und eine davon muss ein Schlitz sein, "
        "wenn sich der Zuschnitt zu einer Schachtel falten lässt; die Kante steht senkrecht zur "
        "längsten dieser Linien, kann also eine Faltlinie sein",
    ),
    "classification.along": Text(
        "die Kante trifft im Zuschnitt auf andere Linien, und eine davon muss ein Schlitz sein, "
        "wenn sich der Zuschnitt zu einer Schachtel falten lässt; die Kante ist parallel zur "
        "längsten dieser Linien, kann also eine Faltlinie sein",
    ),
    "classification.around": Text(
        "die Kante umschließt eine ganze Schachtel",
    ),
    "classification.arrow": Text(
        "die Kante hat eine Pfeilspitze oder hängt an einer Linie mit Pfeilspitze",
    ),
    "classification.as-its-style": Text(
        "die Kante wird wie alle Kanten mit demselben Layer, derselben Farbe und derselben "
        "Strichart behandelt",
    ),
    "classification.beside-gap": Text(
        "{reason}; dabei ist angenommen, dass neben der Kante eine gerade Linie in der Kontur "
        "fehlt, weil der Zuschnitt wie gezeichnet dort auseinanderfällt",
    ),
    "classification.bleed": Text(
        "die Kante umgibt einen Zuschnitt in gleichbleibendem Abstand, wie eine Beschnittlinie",
    ),
    "classification.board-ends": Text(
        "eine solche Kante sollte geschnitten werden",
    ),
    "classification.closes-nothing": Text(
        "die Kante gehört zu keiner geschlossenen Kontur",
    ),
    "classification.contradicted": Text(
        "{rule}, aber {reason}",
    ),
    "classification.convention": Text(
        "die Farben passen zur Farbkonvention „{name}“: mit ihr bilden die Schnittlinien eine "
        "geschlossene Kontur, und {folds} von {lines:# Linie|# Linien} in der Kontur sind "
        "Faltlinien",
    ),
    "classification.corners": Text(
        "die Kante geht an beiden Enden um eine Ecke in eine andere Linie über, wie es eine "
        "Faltlinie nicht tut",
    ),
    "classification.cuts-panel-off": Text(
        "ein Schnitt an der Stelle der Kante würde ein Feld von seinem Zuschnitt trennen",
    ),
    "classification.dashed": Text(
        "die Kanten mit diesem Layer, dieser Farbe und dieser Strichart sind gestrichelt "
        "gezeichnet",
    ),
    "classification.dimension": Text(
        "die Kante gehört zu einer Bemaßung: ein Text neben der Linie nennt ihre Länge",
    ),
    "classification.divider": Text(
        "die Kante teilt zwei Felder",
    ),
    "classification.divides-panels": Text(
        "eine Kante der Art „{type:type}“ sollte zwei Felder teilen",
    ),
    "classification.fold-end": Text(
        "die Kante liegt zwischen der Kontur und einer Faltlinie derselben zwei Felder, wie ein "
        "Schlitz, der eine Klappe verriegelt",
    ),
    "classification.follows": Text(
        "die Antwort zu anderen Kanten entscheidet diese Linienart: sie haben dieselbe Farbe und "
        "Strichart oder zeigen, ob das Profil Schneiden und Rillen vertauscht",
    ),
    "classification.frame": Text(
        "die Kante rahmt die ganze Zeichnung ein",
    ),
    "classification.free": Text(
        "die Kante liegt in einem Feld und berührt keine andere Kante",
    ),
    "classification.hole": Text(
        "die Kante schließt ein Loch in einem Feld",
    ),
    "classification.inner": Text(
        "die Kante liegt in einem Loch oder teilt ein Loch",
    ),
    "classification.labelled": Text(
        "die Kante gehört zu einer geschlossenen Form mit einem Text darin oder daneben, die ein "
        "Etikett oder ein kleines Teil sein kann",
    ),
    "classification.layer-denies": Text(
        "der Name des Layers der Kante, „{layer}“, deutet auf eine andere Linienart",
    ),
    "classification.layer-name": Text(
        "der Name des Layers der Kante enthält „{word}“",
    ),
    "classification.layer-name-against": Text(
        "aber der Name des Layers der Kante enthält „{word}“",
    ),
    "classification.learned": Text(
        "gelernt aus Zeichnungen desselben Kunden: Kanten mit diesem Layer, dieser Farbe und "
        "dieser Strichart haben diese Linienart in {drawings}",
    ),
    "classification.learned-guess": Text(
        "Kanten mit diesem Layer, dieser Farbe und dieser Strichart haben diese Linienart in "
        "{drawings} desselben Kunden",
    ),
    "classification.legend": Text(
        "die Kante liegt außerhalb aller Zuschnitte neben dem Namen einer Linienart, gehört also "
        "zu einer Legende",
    ),
    "classification.letter": Text(
        "die Kante liegt in einer Reihe kleiner Formen, wie die Umrisse von Buchstaben",
    ),
    "classification.like-outline": Text(
        "die Kante hat Layer, Farbe und Strichart der Kontur",
    ),
    "classification.like-outline-not-folds": Text(
        "die Kante hat Layer, Farbe und Strichart der Kontur, die sich von denen der Faltlinien "
        "unterscheiden",
    ),
    "classification.linetype-name": Text(
        "der Name der Strichart der Kante enthält „{word}“",
    ),
    "classification.linetype-name-against": Text(
        "aber der Name der Strichart der Kante enthält „{word}“",
    ),
    "classification.mark": Text(
        "die Kante gehört zu einer geschlossenen Form, die viel kleiner ist als der Zuschnitt",
    ),
    "classification.measured": Text(
        "ein Text neben der Kante nennt ihre Länge, sie kann also eine Maßlinie sein",
    ),
    "classification.mirror-cut": Text(
        "die Zeichnung enthält ein Spiegelbild der Kante, und dieses Spiegelbild ist ein Schnitt",
    ),
    "classification.mirror-folded": Text(
        "die Zeichnung enthält ein Spiegelbild der Kante, und dieses Spiegelbild ist eine "
        "Faltlinie",
    ),
    "classification.mixed": Text(
        "{reason} (das gilt für den größten Teil der Länge der Kante)",
    ),
    "classification.must-be-processed": Text(
        "eine solche Kante sollte nicht ignoriert werden",
    ),
    "classification.named": Text(
        "der Name des Layers kennzeichnet die Kante als nicht zur Schachtel gehörend, und die "
        "Konturen schließen sich ohne sie",
    ),
    "classification.no-rule": Text(
        "keine Regel des Profils {profile} passt auf die Kante",
    ),
    "classification.no-rule-but-shape": Text(
        "keine Regel des Profils {profile} passt auf die Kante, aber {shape}",
    ),
    "classification.none-closes": Text(
        "fast alle Kanten mit demselben Layer, derselben Farbe und derselben Strichart teilen "
        "Felder",
    ),
    "classification.not-made": Text(
        "eine solche Kante sollte ignoriert werden",
    ),
    "classification.oblique": Text(
        "die Kante trifft im Zuschnitt auf andere Linien, und eine davon muss ein Schlitz sein, "
        "wenn sich der Zuschnitt zu einer Schachtel falten lässt; die Kante ist weder parallel "
        "noch senkrecht zur längsten dieser Linien, kann also eine Faltlinie sein",
    ),
    "classification.on-cut": Text(
        "{rule}, und die Kante liegt auf einem Schnitt",
    ),
    "classification.only-fold-style": Text(
        "nur bei dieser Farbe und Strichart teilen alle Kanten Felder",
    ),
    "classification.open": Text(
        "die Kante gehört zu einer Kontur, die sich nicht schließt",
    ),
    "classification.open-flap": Text(
        "an jedem Ende der Kante beginnt eine Linie, deren anderes Ende auf nichts trifft, und "
        "beide sind gleich lang, sie können also die Seiten einer nicht geschlossenen Klappe sein",
    ),
    "classification.other-style-closes": Text(
        "der größte Teil der Kontur des Zuschnitts besteht aus Kanten mit anderem Layer, anderer "
        "Farbe oder anderer Strichart",
    ),
    "classification.outline": Text(
        "die Kante schließt die Kontur eines Zuschnitts",
    ),
    "classification.override": Text(
        "der Benutzer hat die Linienart der Kante gesetzt",
    ),
    "classification.own-width": Text(
        "die Linienbreite der Kante unterscheidet sie von anderen Kanten mit demselben Layer, "
        "derselben Farbe und derselben Strichart",
    ),
    "classification.paired": Text(
        "einige Kanten mit diesem Layer, dieser Farbe und dieser Strichart bilden Paare "
        "paralleler Linien",
    ),
    "classification.panel-hangs": Text(
        "nur diese Kante verbindet ein Feld mit dem übrigen Zuschnitt",
    ),
    "classification.panels-hang": Text(
        "die meisten Kanten mit diesem Layer, dieser Farbe und dieser Strichart sind jeweils die "
        "einzige Verbindung zwischen einem Feld und dem übrigen Zuschnitt",
    ),
    "classification.part-of-outline": Text(
        "der Name des Layers „{layer}“ bedeutet die Linienart „{type:type}“, und der größte Teil "
        "der Kontur liegt auf Layern, deren Namen Schnitte bedeuten",
    ),
    "classification.part-of-side": Text(
        "die Seite eines der Felder setzt sich hinter der Kante fort, wie neben einem Schlitz",
    ),
    "classification.ring-fold": Text(
        "die Kante trifft im Zuschnitt auf Linien, die wahrscheinlich Schlitze sind, sie ist also "
        "wahrscheinlich eine Faltlinie dazwischen",
    ),
    "classification.ring-slit": Text(
        "die Kante endet im Zuschnitt an einem Punkt mit drei Faltlinien oder ist parallel zu "
        "einer solchen Kante; wäre sie auch eine Faltlinie, träfen sich dort vier, was keine "
        "Schachtel ergibt",
    ),
    "classification.role-against": Text(
        "{role}; {against}",
    ),
    "classification.rule": Text(
        "Profil {profile}: {rule}",
    ),
    "classification.shape": Text(
        "{parts:, }",
    ),
    "classification.shared": Text(
        "die Kante liegt, wo sich gleiche Teile der Zeichnung berühren, kann also ein gemeinsamer "
        "Schnitt von Zuschnitten sein",
    ),
    "classification.slit": Text(
        "die Kante ist ein Schlitz: sie beginnt an einer anderen Kante und endet in einem Feld",
    ),
    "classification.slot": Text(
        "die Kante schließt einen Ausschnitt oder ein rundes Loch in einem Feld",
    ),
    "classification.slot-side": Text(
        "die Kante ist eine Seite eines Ausschnitts an einer Faltlinie",
    ),
    "classification.speck": Text(
        "die Kante ist kurz, liegt außerhalb aller Zuschnitte und berührt keine andere Kante",
    ),
    "classification.stray": Text(
        "die Kante liegt außerhalb aller Zuschnitte der Zeichnung",
    ),
    "classification.swapped": Text(
        "diese Regel macht Kanten der geschlossenen Kontur zu Rillen, also können Schneiden und "
        "Rillen vertauscht sein; die Antwort entscheidet auch die Kanten, die das Profil "
        "schneidet",
    ),
    "classification.swapped-both": Text(
        "diese Regel macht Kanten der geschlossenen Kontur zu Rillen und Kanten zwischen Feldern "
        "zu Schnitten, also können Schneiden und Rillen vertauscht sein; die Antwort entscheidet "
        "auch die Kanten, die das Profil schneidet",
    ),
    "classification.swapped-like": Text(
        "{reason}; {convention}",
    ),
    "classification.table": Text(
        "die Kante gehört zu Kästen mit Texten, wie in einem Schriftfeld",
    ),
    "classification.through": Text(
        "die Kante läuft im Zuschnitt durch Punkte weiter, an denen andere Linien enden; ein "
        "Schlitz würde dort enden, die Kante ist also wahrscheinlich eine Faltlinie",
    ),
    "classification.unknown": Text(
        "die Geometrie der Zeichnung zeigt nicht, welche Linienart die Kante hat",
    ),
    "classification.votes": Text(
        "{votes:; }",
    ),
    "classification.without-tabs": Text(
        "die Wände der Schachtel haben keine Klebelaschen, wie bei festen Schachteln, die an "
        "V-Nuten gefaltet werden",
    ),
    "classification.with-text": Text(
        "{reason}, und ein Text steht neben der Kante",
    ),
}
