"""cleaning: German texts of the messages of ``catalogue.cleaning``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "cleaning.as-drawn": Text(
        "die Kante wird verwendet, wie sie gezeichnet ist",
    ),
    "cleaning.dropped-off-panel": Text(
        "die Kante wurde weggelassen, weil sie zu einer Faltlinie gehört und außerhalb aller "
        "Felder liegt",
    ),
    "cleaning.dropped-speck": Text(
        "die Kante wurde weggelassen, weil sie nur {length:.4g} mm lang ist und keine anderen "
        "Kanten verbindet",
    ),
    "cleaning.end-moved": Text(
        "ein Ende der Kante wurde um {distance:.2g} mm verschoben, damit es eine andere Kante "
        "trifft",
    ),
    "cleaning.fitted": Text(
        "die Kante war Teil einer Kurve aus kurzen Linien; eine Linie oder ein Kreisbogen ersetzt "
        "diese Kurve",
    ),
    "cleaning.fitted-edge": Text(
        "die Kante und Kante {edge} waren Teile einer Kurve aus kurzen Linien; eine Linie oder "
        "ein Kreisbogen ersetzt sie und weicht höchstens {distance:.2g} mm von der Kurve ab",
    ),
    "cleaning.folds-on-cuts": Text(
        "{count:# Kante|# Kanten} mit der Linienart {type} {count:liegt|liegen} auf Schnitten und "
        "{count:wird|werden} auf {length:,.1f} mm nicht gemacht: Dort werden die Schnitte gemacht.",
        "Wenn der Karton dort zusammenhängen soll, die Linienart der Schnitte auf {type} setzen. "
        "Sonst ist nichts zu tun.",
    ),
    "cleaning.folds-trimmed": Text(
        "Rillen oder V-Nuten in {count} Kanten wurden gekürzt: {length:.2f} mm davon liegen "
        "außerhalb aller Felder und werden nicht gemacht.",
        "Wenn dort ein Feld sein soll, seine Kontur schließen. Sonst ist nichts zu tun.",
    ),
    "cleaning.ignored": Text(
        "die Kante hat die Linienart „Ignoriert“, sie wird also gezeigt, aber nicht gemacht",
    ),
    "cleaning.joined": Text(
        "die Kante und eine andere Kante auf derselben Linie wurden zu einer Kante verbunden",
    ),
    "cleaning.joined-edge": Text(
        "die Kante wurde mit Kante {edge} verbunden, die auf derselben Linie liegt",
    ),
    "cleaning.kept": Text(
        "die Kante wird ohne Änderung verwendet, wie sie gezeichnet ist",
    ),
    "cleaning.kept-changed": Text(
        "die Kante wurde mit diesen Änderungen behalten: {changes:; }",
    ),
    "cleaning.length-on-others": Text(
        "ein Teil der Kante, {length:.4g} mm lang, liegt auf anderen Kanten, er wird also nur "
        "einmal gemacht, mit ihnen",
    ),
    "cleaning.longer": Text(
        "andere Kanten auf derselben Linie wurden mit der Kante verbunden, die jetzt länger ist",
    ),
    "cleaning.loop": Text(
        "die Kante wurde weggelassen, weil sie zu einer Schleife von höchstens 0,3 mm an einer "
        "Ecke einer Kontur gehört, der kein Werkzeug folgen kann; die Kontur ist ohne sie "
        "vollständig",
    ),
    "cleaning.moved": Text(
        "ein Ende der Kante wurde verschoben, damit es eine andere Kante trifft",
    ),
    "cleaning.near": Text(
        "die Kante war doppelt gezeichnet: sie liegt dicht neben einer anderen Kante und wurde "
        "mit ihr verbunden",
    ),
    "cleaning.near-edge": Text(
        "die Kante war doppelt gezeichnet: sie liegt {distance:.2g} mm neben Kante {edge} und "
        "wurde mit ihr verbunden",
    ),
    "cleaning.no-work": Text(
        "die Kante ist unverändert, weil kein Werkzeug Kanten ihrer Linienart macht",
    ),
    "cleaning.off-panel": Text(
        "ein Teil der Faltlinie liegt außerhalb aller Felder und wurde weggelassen",
    ),
    "cleaning.on-edge": Text(
        "die Kante liegt auf Kante {edge} und wurde mit ihr verbunden",
    ),
    "cleaning.part-dropped": Text(
        "ein Teil der Kante, {length:.2g} mm lang, wurde weggelassen, weil er zu kurz ist",
    ),
    "cleaning.part-off-panel": Text(
        "ein Teil der Faltlinie, {length:.4g} mm lang, wurde weggelassen, weil er außerhalb aller "
        "Felder liegt",
    ),
    "cleaning.shortened": Text(
        "ein Teil der Kante liegt auf anderen Kanten, er wird also nur einmal gemacht, mit ihnen",
    ),
    "cleaning.speck": Text(
        "die Kante wurde weggelassen, weil sie zu kurz ist und keine anderen Kanten verbindet",
    ),
    "cleaning.twice": Text(
        "die Kante wurde entfernt, weil sie ganz auf anderen Kanten liegt",
    ),
    "cleaning.unclassified": Text(
        "die Kante hat noch keine Linienart, sie wird also gezeigt, aber nicht gemacht",
    ),
}
