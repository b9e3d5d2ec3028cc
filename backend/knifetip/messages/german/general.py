"""general: German texts of the messages of ``catalogue.general``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "stored.text": Text(
        "{text}",
        "{hint}",
    ),
    "error.at-edge": Text(
        "{error} Das betrifft {count:Kante|# Kanten:} {edges:, }. Kante {edge} gehört zum Objekt "
        "mit dem Handle {handle} auf dem Layer „{layer}“. {more}",
        "{error:hint}",
    ),
    "error.at-edges": Text(
        "Kanten {edges: und }: {error}",
        "{error:hint}",
    ),
    "error.more-edges": Text(
        "{count:# weitere Kante ist|# weitere Kanten sind} hier nicht aufgeführt.",
    ),
    "error.in-file": Text(
        "Datei {name}: {error}",
        "{error:hint}",
    ),
    "finding.at-edge": Text(
        "Kante {edge}: {fault}",
        "{fault:hint}",
    ),
    "finding.at-edge-and-line": Text(
        "Kante {edge}, Programmzeile {line}: {fault}",
        "{fault:hint}",
    ),
    "finding.at-line": Text(
        "Programmzeile {line}: {fault}",
        "{fault:hint}",
    ),
    "finding.more": Text(
        "{count:# weiterer Befund ist|# weitere Befunde sind} hier nicht aufgeführt.",
    ),
}
