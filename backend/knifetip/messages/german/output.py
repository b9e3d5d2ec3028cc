"""output: German texts of the messages of ``catalogue.output``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "output.accepted-by": Text(
        "angenommen von {by}: {reason}",
    ),
    "output.actions": Text(
        "Aktionen: {actions:, }",
    ),
    "output.add-lines": Text(
        "diese Zeilen in die Materialdatei schreiben",
    ),
    "output.calibrated": Text(
        "{count} Punkte, größte Abweichung {residual:.4f} mm; {where}.",
    ),
    "output.carriage": Text(
        "Schlitten {number}: Achsen {axes: }, parkt bei {letter}{park:g}, Stationen {stations:, }",
    ),
    "output.carriage-without-station": Text(
        "Schlitten {number}: Achsen {axes: }, parkt bei {letter}{park:g}, keine Stationen",
    ),
    "output.carriages": Text(
        "Schlitten mindestens {distance:g} mm auseinander",
    ),
    "output.check-first": Text(
        "Vor dem Start von Auftrag {job} an der Maschine prüfen:",
    ),
    "output.check-question": Text(
        "{number} von {count}: {text} Trifft das zu?",
    ),
    "output.cleaned-edge": Text(
        "{handle} Kante {edge}: {outcome}",
    ),
    "output.customer": Text(
        "Kunde {customer}",
    ),
    "output.disabled": Text(
        "(gesperrt)",
    ),
    "output.drawn": Text(
        "gezeichnet {drawn:.3f} mm = behalten {kept:.3f} + verbunden {merged:.3f} + weggelassen "
        "{dropped:.3f}",
    ),
    "output.expires": Text(
        "läuft ab {date}",
    ),
    "output.folder-unreadable": Text(
        "der Ordner kann nicht gelesen werden: {reason}",
    ),
    "output.former-database": Text(
        "Die bisherige Datenbank bleibt als {file} erhalten.",
    ),
    "output.gateway": Text(
        "{title}: Steuerung {controller}, Server {server}",
    ),
    "output.if-so": Text(
        "Wenn alles zutrifft, eingeben:",
    ),
    "output.job-board": Text(
        "{machine}, Material {board}",
    ),
    "output.job-progress": Text(
        "Zeile {line} von {lines}, Exemplare {done} von {copies}",
    ),
    "output.job-tools": Text(
        "Werkzeuge: {tools:, }",
    ),
    "output.kernels": Text(
        "{compiled} von {total} Programmteilen kompiliert.",
    ),
    "output.key": Text(
        "Schlüssel {id} für {title}: {scopes:, }",
    ),
    "output.key-row": Text(
        "{id} {title} {scopes} {notes:, }",
    ),
    "output.used": Text(
        "benutzt {date}",
    ),
    "output.key-valid": Text(
        "{file}: Schlüssel {id} für {title} ist gültig",
    ),
    "output.leave-out": Text(
        "Um diese Kanten auszulassen und von Hand zu machen: --edge {edges}=ignored",
    ),
    "output.line-type": Text(
        "{type} {count} Kanten {length} mm",
    ),
    "output.listening": Text(
        "erreichbar unter {address}",
    ),
    "output.machine": Text(
        "{title} ({name}), Sprache {language}, Vorschub {feed}",
    ),
    "output.machines": Text(
        "Maschinen {names: }",
    ),
    "output.migrated": Text(
        "Die Tabellen wurden von Stand {before} auf Stand {after} gebracht. {copy}",
    ),
    "output.migrated-new": Text(
        "Die Tabellen wurden auf Stand {after} gebracht. {copy}",
    ),
    "output.migration-copy": Text(
        "Eine Kopie von vorher ist {file}.",
    ),
    "output.more": Text(
        "und {count} weitere",
    ),
    "output.more-lines": Text(
        "… und {count} weitere: --json nennt alle",
    ),
    "output.no-tables": Text(
        "keine Tabellen; knifetip braucht Stand {newest}",
    ),
    "output.not-cleaned": Text(
        "Die Zeichnung wurde nicht bereinigt: {reason}",
    ),
    "output.not-confirmed": Text(
        "Auftrag {job} wurde nicht bestätigt. Die Maschine startet nicht.",
    ),
    "output.profile": Text(
        "{name}: {title}, {count} Regeln",
    ),
    "output.profile-not-stored": Text(
        "Keine Datenbank: Das Profil wurde nicht gespeichert. Mit --database eine nennen.",
    ),
    "output.profile-stored": Text(
        "als Version {version} gespeichert",
    ),
    "output.read": Text(
        "{file}: {size}, {count} Segmente; {evidence}",
    ),
    "output.revision-current": Text(
        "Stand {revision}, aktuell {writer}",
    ),
    "output.revision-newer": Text(
        "Stand {revision}, neuer als Stand {newest} dieser Version {writer}",
    ),
    "output.revision-older": Text(
        "Stand {revision}, älter als Stand {newest} dieser Version {writer}",
    ),
    "output.revoked": Text(
        "gesperrt {date}",
    ),
    "output.server-silent": Text(
        "der Server antwortet nicht: {reason}",
    ),
    "output.size-and-edges": Text(
        "{file}: {size}, {count} Kanten",
    ),
    "output.station": Text(
        "{number}  {name}: {tool}, Versatz {datum}",
    ),
    "output.tables-current": Text(
        "Die Tabellen sind aktuell.",
    ),
    "output.time-saved": Text(
        "{seconds:.1f} s auf der Maschine, {percent:.0f} % weniger als die {retracted:.1f} s mit "
        "vollem Abheben zwischen den Schnitten",
    ),
    "output.to-accept": Text(
        'Zum Annehmen: --accept {edges}:{code} --reason "..."',
    ),
    "output.track": Text(
        "{number}  {state} Station {station}  Zeilen {first}-{last}  ab X{x:.1f} Y{y:.1f}  Kanten "
        "{edges}",
    ),
    "output.unreached-areas": Text(
        "der Fräser erreicht {area:.2f} mm² an {count:# Stelle|# Stellen} nicht, die "
        "ungeschnitten bleiben",
    ),
    "output.unreached-edges": Text(
        "der Fräser erreicht {length:.2f} mm der Kanten nicht; sie liegen bis zu {distance:.2f} "
        "mm vom Schnitt entfernt",
    ),
    "output.used-version": Text(
        "Version {version} der Maschine wird benutzt, die vorher geladen wurde.",
    ),
    "output.user-row": Text(
        "{name} {role} letzte Anmeldung {date} {state}",
    ),
    "output.verdict": Text(
        "{word}: Abweichung {deviation:.4f} mm (Toleranz {tolerance:g}; Bahn {path:.4f}, Runden "
        "durch die Steuerung {blending:.4f}, Kurvenannäherung {fit:.4f}), Überschnitt "
        "{overcut:.3f} mm, ungeschnitten {uncut:.3f} mm, ausgelassen {setback:.3f} mm, "
        "{seconds:.1f} s mit den programmierten Vorschüben",
    ),
    "output.waits-for": Text(
        "wartet auf {event}",
    ),
    "output.watching": Text(
        "überwacht {folder}, Server {server}",
    ),
    "output.wide-slits": Text(
        "{length:.2f} mm von {count:# Schlitz|# Schlitzen} werden so breit wie der Fräser",
    ),
    "output.word-accepted": Text(
        "angenommen",
    ),
    "output.word-refused": Text(
        "abgelehnt",
    ),
    "output.worked": Text(
        "bearbeitet {worked:.3f} mm = behalten {kept:.3f} + durch Schließen von Lücken ergänzt "
        "{added:.3f}",
    ),
    "output.worker": Text(
        "Rechenprozess für {database}",
    ),
    "output.worker-stuck": Text(
        "FEHLER: Dieser Worker steckt fest: Er hat seit {seconds:.0f} s nicht nach Aufträgen "
        "gesehen. Er endet mit einem Fehler, damit systemd oder der Container ihn neu startet.",
    ),
    "output.written-to": Text(
        "geschrieben nach {file}",
    ),
    "output.zone": Text(
        "Sperrzone {name}: X {left:g} bis {right:g}, Y {bottom:g} bis {back:g}, {top:g} mm hoch",
    ),
    "output.writer": Text(
        "(von knifetip {version})",
    ),
    "output.password": Text(
        "Passwort",
    ),
    "output.hands-clear": Text(
        "Sind alle Hände frei von der Maschine?",
    ),
    "output.cancel-effect": Text(
        "Die Maschine hält an, hebt das Werkzeug und löst ihre Stationen. Der Bogen auf dem Tisch "
        "ist wahrscheinlich verloren.",
    ),
    "output.cancel-question": Text(
        "{effect} Auftrag {job} abbrechen?",
    ),
    "output.job-state": Text(
        "Der Auftrag ist {state:state}.",
    ),
    "output.scrap-question": Text(
        "Der Tisch wird frei. Fehlende Exemplare mit knifetip job rest bestellen. Auftrag {job} "
        "verwerfen?",
    ),
}
