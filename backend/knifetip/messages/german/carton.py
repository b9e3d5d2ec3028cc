"""carton: German texts of the messages of ``catalogue.carton``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "carton.ecma-a20.20": Text(
        "Faltschachtel mit Einsteckdeckeln (ECMA A20.20)",
    ),
    "carton.ecma-a20.20.description": Text(
        "Ein Einsteckdeckel an beiden Enden, gegenüber oder auf einer Seite, mit Staublaschen",
    ),
    "carton.ecma-a60.20": Text(
        "Faltschachtel mit Automatikboden (ECMA A60.20)",
    ),
    "carton.ecma-a60.20.description": Text(
        "Ein Einsteckdeckel und ein geklebter Boden, der beim Aufrichten einrastet",
    ),
    "carton.fefco-0200": Text(
        "Faltkiste, oben offen (FEFCO 0200)",
    ),
    "carton.fefco-0200.description": Text(
        "Vier Klappen schließen den Boden; oben offen, für einen Deckel oder eine größere Kiste",
    ),
    "carton.fefco-0201": Text(
        "Faltkiste (FEFCO 0201)",
    ),
    "carton.fefco-0201.description": Text(
        "Die Außenklappen stoßen in der Mitte aneinander, am Boden und oben",
    ),
    "carton.fefco-0203": Text(
        "Faltkiste mit voller Überlappung (FEFCO 0203)",
    ),
    "carton.fefco-0203.description": Text(
        "Die Außenklappen überlappen einander ganz, am Boden und oben",
    ),
    "carton.fefco-0215": Text(
        "Steckschachtel mit Steckboden (FEFCO 0215)",
    ),
    "carton.fefco-0215.description": Text(
        "Deckel mit Einstecklasche und vier Bodenklappen, die ohne Kleber verriegeln",
    ),
    "carton.fefco-0427": Text(
        "Versandschachtel mit Rollwänden (FEFCO 0427)",
    ),
    "carton.fefco-0427.description": Text(
        "Doppelte Seitenwände, deren Zungen im Boden einrasten, und ein Deckel mit Einstecklasche",
    ),
    "carton.fefco-0471": Text(
        "Versandschachtel mit doppeltem Boden (FEFCO 0471)",
    ),
    "carton.fefco-0471.description": Text(
        "Wie 0427, mit Innenwänden, deren Bodenklappen auf dem Boden liegen",
    ),
    "carton.rigid-box": Text(
        "Feste Schachtel mit V-Nuten",
    ),
    "carton.rigid-box.description": Text(
        "Unterteil oder Deckel aus Graupappe, deren Wände an V-Nuten falten",
    ),
    "carton.telescope-tray": Text(
        "Stülpschachtel (nach FEFCO 0301)",
    ),
    "carton.telescope-tray.description": Text(
        "Unterteil oder Deckel, deren Ecklaschen an die Wände geklebt oder geheftet werden",
    ),
    "carton.too-large": Text(
        "{parameter:parameter} {value:.4g} ist für diese Form in Material von {caliper:.4g} mm zu "
        "groß: höchstens {limit:.4g} mm",
        "Einen kleineren Wert wählen oder die Maße ändern, von denen die Grenze abhängt.",
    ),
    "carton.too-small": Text(
        "{parameter:parameter} {value:.4g} ist für diese Form in Material von {caliper:.4g} mm zu "
        "klein: mindestens {limit:.4g} mm",
        "Einen größeren Wert, dünneres Material oder eine andere Form wählen.",
    ),
}
