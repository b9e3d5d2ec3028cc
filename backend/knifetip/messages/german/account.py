"""account: German texts of the messages of ``catalogue.account``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "key.expired-at-once": Text(
        "Der Ablauf des Schlüssels liegt in der Vergangenheit.",
        "Einen Zeitpunkt in der Zukunft wählen oder den Ablauf für einen unbegrenzt gültigen "
        "Schlüssel weglassen.",
    ),
    "key.incomplete": Text(
        "Ein API-Schlüssel braucht einen Titel und mindestens eine Berechtigung.",
        "Als Titel das Programm nennen, das den Schlüssel benutzt, und seine Berechtigungen "
        "wählen.",
    ),
    "key.limited": Text(
        "Dieser API-Schlüssel gilt nur für den Kunden {customer}, aber die Antwort auf diese "
        "Anfrage enthielte die Daten aller Kunden.",
        "Einen Schlüssel benutzen, der nicht auf einen Kunden begrenzt ist.",
    ),
    "key.other-customer": Text(
        "Dieser API-Schlüssel gilt nur für den Kunden {customer}, nicht für „{given}“.",
        "Den Kunden weglassen oder einen Schlüssel für diesen Kunden benutzen.",
    ),
    "key.other-machine": Text(
        "Dieser API-Schlüssel gilt nur für {machines:or}, nicht für die Maschine „{machine}“.",
        "Eine andere Maschine wählen oder einen Schlüssel für diese Maschine benutzen.",
    ),
    "key.revoked": Text(
        "Der API-Schlüssel {id} wurde gesperrt.",
        "Einen neuen Schlüssel anlegen.",
    ),
    "key.unlimited-scope": Text(
        "Ein Schlüssel mit der Berechtigung {scope} kann nicht auf einen Kunden oder auf Maschinen "
        "begrenzt werden.",
        "Nur Berechtigungen aus {scopes:, } wählen oder die Begrenzung weglassen.",
    ),
    "key.unknown": Text(
        "Es gibt keinen API-Schlüssel mit der Kennung {id}.",
        "Die Schlüssel mit `knifetip key list` anzeigen.",
    ),
    "oidc.bad-role": Text(
        "Die Option --oidc-role {pair} ist ungültig.",
        "Als WERT=ROLLE schreiben, mit der Rolle {roles:or}.",
    ),
    "oidc.bad-token": Text(
        "Die Anmeldung wurde abgelehnt, weil das ID-Token des Anbieters ungültig ist: {reason}.",
        "Noch einmal anmelden. Bleibt der Fehler, einen Administrator bitten, Aussteller, "
        "Client-ID und die Uhren von Anbieter und Server zu vergleichen.",
    ),
    "oidc.bad-url": Text(
        "{url} ist keine https-URL.",
        "Eine URL angeben, die mit https:// beginnt; http:// ist nur für diesen Rechner erlaubt.",
    ),
    "oidc.code-refused": Text(
        "Der Anbieter hat den Autorisierungscode der Anmeldung abgelehnt: {reason}.",
        "Noch einmal anmelden. Bleibt der Fehler, einen Administrator bitten, Client-ID, "
        "Geheimnis und Rücksprung-URL dieses Servers beim Anbieter zu prüfen.",
    ),
    "oidc.declined": Text(
        "Der Anbieter hat Sie nicht angemeldet: {reason}.",
        "Noch einmal anmelden oder den Administrator des Anbieters fragen, ob Sie diesen Server "
        "benutzen dürfen.",
    ),
    "oidc.disabled": Text(
        "Der Benutzer {name} ist gesperrt.",
        "Ein Administrator kann den Benutzer mit `knifetip user enable` entsperren.",
    ),
    "oidc.no-client": Text(
        "Die Client-ID dieses Servers beim OpenID-Connect-Anbieter fehlt.",
        "Sie mit --oidc-client-id angeben.",
    ),
    "oidc.no-issuer": Text(
        "Optionen für OpenID Connect sind gesetzt, aber der Anbieter fehlt.",
        "Die URL des Anbieters mit --oidc-issuer angeben.",
    ),
    "oidc.no-role": Text(
        "Der Benutzer {name} hat auf diesem Server keine Rolle.",
        "Den Administrator des Anbieters um eine der Rollen oder Gruppen bitten, die die Option "
        "--oidc-role dieses Servers nennt.",
    ),
    "oidc.no-roles": Text(
        "Keinem Wert des Anbieters ist eine Rolle zugeordnet, also könnte sich kein Benutzer "
        "anmelden.",
        "Mindestens ein --oidc-role WERT=ROLLE angeben, zum Beispiel shop-admins=admin.",
    ),
    "oidc.not-begun": Text(
        "Diese Anmeldung wurde nicht in diesem Browser begonnen, ist abgelaufen oder schon "
        "beendet.",
        "Noch einmal anmelden. Cookies dieses Servers müssen im Browser erlaubt sein.",
    ),
    "oidc.not-installed": Text(
        "Die Anmeldung mit OpenID Connect braucht authlib, das nicht installiert ist.",
        "Mit `pip install 'knifetip[oidc]'` installieren.",
    ),
    "oidc.unreachable": Text(
        "Der Anbieter {issuer} ist nicht erreichbar oder hat eine ungültige Antwort gesendet.",
        "In einer Minute noch einmal versuchen. Das Protokoll des Servers enthält den Grund.",
    ),
    "oidc.used": Text(
        "Diese Anmeldung beim Anbieter wurde schon benutzt.",
        "Noch einmal anmelden.",
    ),
    "sign-in.slow-down": Text(
        "Zu viele Anmeldeversuche sind fehlgeschlagen.",
        "{seconds} s warten, dann noch einmal versuchen.",
    ),
    "sign-in.wrong": Text(
        "Name oder Passwort ist falsch.",
        "Beides prüfen. Ein Administrator kann ein neues Passwort setzen.",
    ),
    "sign-in.wrong-code": Text(
        "Dieser Kopplungscode ist falsch, abgelaufen oder schon benutzt.",
        "Einen Administrator um einen neuen Code bitten. Jeder Code gilt für ein Gerät und läuft "
        "nach zehn Minuten ab.",
    ),
    "user.at-provider": Text(
        "Der Benutzer {name} meldet sich bei einem Anbieter an und hat auf diesem Server kein "
        "Passwort.",
        "Das Passwort beim Anbieter ändern.",
    ),
    "user.bad-name": Text(
        "{name} ist kein gültiger Benutzername.",
        "1 bis 64 Buchstaben, Ziffern und . _ @ + - verwenden und mit einem Buchstaben oder einer "
        "Ziffer beginnen.",
    ),
    "user.bad-password": Text(
        "Das Passwort hat {length} Zeichen, muss aber {shortest} bis {longest} haben.",
        "Ein längeres Passwort wählen, zum Beispiel vier Wörter.",
    ),
    "user.bad-role": Text(
        "Ein Benutzer kann nicht die Rolle {role} haben.",
        "{roles:or} wählen. Gateways benutzen API-Schlüssel statt Benutzern.",
    ),
    "user.exists": Text(
        "Ein Benutzer mit dem Namen {name} existiert schon.",
        "Einen anderen Namen wählen oder jenen Benutzer ändern.",
    ),
    "user.last-admin": Text(
        "{name} ist der letzte aktive Administrator.",
        "Zuerst einen anderen Benutzer zum Administrator machen.",
    ),
    "user.not-signed-in": Text(
        "Nur ein Benutzer, der sich mit einem Passwort angemeldet hat, kann es ändern.",
        "Mit Name und Passwort anmelden.",
    ),
    "user.password-blank": Text(
        "das Passwort besteht nur aus Leerzeichen",
    ),
    "user.password-common": Text(
        "das Passwort besteht aus Wörtern, die viele benutzen",
    ),
    "user.password-name": Text(
        "das Passwort besteht aus dem Namen des Benutzers oder des Programms",
    ),
    "user.password-repeated": Text(
        "das Passwort wiederholt wenige Zeichen",
    ),
    "user.password-sequence": Text(
        "die Zeichen des Passworts folgen auf der Tastatur aufeinander",
    ),
    "user.weak-password": Text(
        "Das Passwort ist zu leicht zu erraten: {why}.",
        "Ein anderes wählen, zum Beispiel vier Wörter, die nichts miteinander zu tun haben.",
    ),
    "user.unknown": Text(
        "Es gibt keinen Benutzer mit dem Namen {name}.",
        "Die Benutzer mit `knifetip user list` anzeigen.",
    ),
    "user.wrong-password": Text(
        "Das bisherige Passwort ist falsch.",
        "Das Passwort eingeben, mit dem Sie sich anmelden.",
    ),
}
