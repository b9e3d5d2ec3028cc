"""doctor: German texts of the messages of ``catalogue.doctor``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "doctor.failed": Text(
        "die Prüfung ist fehlgeschlagen: {reason}",
        "Diesen Fehler mit der Ausgabe von knifetip doctor melden.",
    ),
    "doctor.grade-ok": Text(
        "OK",
    ),
    "doctor.grade-warning": Text(
        "Warnung",
    ),
    "doctor.grade-problem": Text(
        "Problem",
    ),
    "doctor.python": Text(
        "Version {version} ({path})",
    ),
    "doctor.python-old": Text(
        "Version {version} ist zu alt",
        "Python 3.11 oder neuer installieren.",
    ),
    "doctor.packages": Text(
        "knifetip {version} und alle benötigten Pakete sind installiert",
    ),
    "doctor.packages-faulty": Text(
        "{faults:; }",
        "knifetip neu installieren: pip install --force-reinstall knifetip",
    ),
    "doctor.package-missing": Text(
        "{name} ist nicht installiert",
    ),
    "doctor.package-unloadable": Text(
        "{module} kann nicht geladen werden: {reason}",
    ),
    "doctor.package-version": Text(
        "{name} {version} ist installiert, nötig ist aber {bounds}",
    ),
    "doctor.kernels": Text(
        "alle kompilierten Funktionen haben Maschinencode",
    ),
    "doctor.kernels-missing": Text(
        "{count:# Funktion|# Funktionen} in {modules:# Modul|# Modulen} {count:hat|haben} keinen "
        "aktuellen Maschinencode",
        "Der erste Server oder Worker kompiliert sie, was einige Minuten dauert; Bestellungen "
        "warten darauf.",
    ),
    "doctor.converter": Text(
        "{program} ({path}) wandelt {format}-Dateien um",
    ),
    "doctor.converter-missing": Text(
        "{program} ist nicht installiert, also werden {format}-Dateien abgelehnt",
    ),
    "doctor.disk": Text(
        "{folder}: {free:,} MB frei",
    ),
    "doctor.disk-low": Text(
        "{folder}: {free:,} MB frei",
        "Bald Platz schaffen: siehe --keep-jobs und --keep-drawings.",
    ),
    "doctor.disk-full": Text(
        "{folder}: {free:,} MB frei",
        "Platz schaffen: Ein Server lehnt jetzt Uploads und Bestellungen ab.",
    ),
    "doctor.disk-unwritable": Text(
        "{folder} kann nicht beschrieben werden: {reason}",
        "Dem Benutzer des Servers das Schreiben im Ordner erlauben oder die Festplatte reparieren.",
    ),
    "doctor.ports-none": Text(
        "dieser Rechner hat keine seriellen Schnittstellen",
    ),
    "doctor.port": Text(
        "{port} darf geöffnet werden",
    ),
    "doctor.port-refused": Text(
        "dieser Benutzer darf {port} nicht öffnen",
        "Den Benutzer in die Gruppe der Schnittstelle aufnehmen: sudo usermod -aG dialout BENUTZER",
    ),
    "doctor.port-missing": Text(
        "es gibt keine serielle Schnittstelle {port}",
        "Die Steuerung anschließen, sie einschalten oder eine andere Schnittstelle nennen.",
    ),
    "doctor.machine": Text(
        "{name}: {title}, {count:# Station|# Stationen}",
    ),
    "doctor.controller": Text(
        "{address} ist eine gültige Adresse für {language}",
    ),
    "doctor.server": Text(
        "{url} antwortet",
    ),
    "doctor.server-unhealthy": Text(
        "{url} antwortet unter /healthz mit dem HTTP-Status {status}",
        "Die URL und den Proxy vor dem Server prüfen.",
    ),
    "doctor.server-unreachable": Text(
        "{url} ist nicht erreichbar: {reason}",
        "Den Server mit knifetip serve starten; die URL und das Netzwerk prüfen.",
    ),
    "doctor.version": Text(
        "der Server hat dieselbe Version, {version}",
    ),
    "doctor.version-differs": Text(
        "der Server hat Version {theirs}, hier ist aber Version {ours} installiert",
        "Auf allen Rechnern dieselbe Version installieren.",
    ),
    "doctor.ready": Text(
        "der Server ist bereit",
    ),
    "doctor.not-ready": Text(
        "der Server ist nicht bereit: {reason}",
        "Auf dem Rechner des Servers knifetip doctor ausführen und beheben, was es meldet.",
    ),
    "doctor.key": Text(
        "der Server nimmt den Schlüssel an",
    ),
    "doctor.key-unneeded": Text(
        "der Server braucht von diesem Rechner keinen Schlüssel",
    ),
    "doctor.key-refused": Text(
        "der Server lehnt den Schlüssel ab",
        "Am Server einen anlegen: knifetip key create TITEL --scope viewer --file DATEI; "
        "--key-file DATEI angeben.",
    ),
    "doctor.key-required": Text(
        "der Server verlangt einen Schlüssel",
        "Am Server einen anlegen: knifetip key create TITEL --scope viewer --file DATEI; "
        "--key-file DATEI angeben.",
    ),
    "doctor.key-unchecked": Text(
        "der Server antwortet mit dem HTTP-Status {status}",
        "Das Protokoll des Servers lesen.",
    ),
    "doctor.database": Text(
        "{url}, Stand {revision}",
    ),
    "doctor.database-missing": Text(
        "die Datei {file} gibt es noch nicht",
        "knifetip serve starten, das die Datei anlegt, oder mit --database eine andere Datenbank "
        "nennen.",
    ),
    "doctor.database-silent": Text(
        "{url} antwortet nicht: {reason}",
        "Den Datenbankserver starten; URL, Passwort und Netzwerk prüfen.",
    ),
    "doctor.database-old": Text(
        "{url}, Stand {revision}, nötig ist aber Stand {newest}",
        "Eine Sicherung machen, dann knifetip serve starten, das die Datenbank umstellt.",
    ),
    "doctor.database-old-shared": Text(
        "{url}, Stand {revision}, nötig ist aber Stand {newest}",
        "Die Server anhalten, eine Sicherung machen und ausführen: knifetip db upgrade",
    ),
    "doctor.writing": Text(
        "die Datenbank speichert Änderungen",
    ),
    "doctor.writing-disk-full": Text(
        "die Festplatte der Datenbank ist voll",
        "Platz auf der Festplatte schaffen.",
    ),
    "doctor.writing-refused": Text(
        "in die Datenbank kann nicht geschrieben werden: {reason}",
        "Die Rechte der Datei prüfen, und ob die Datenbank eine Kopie nur zum Lesen ist.",
    ),
    "doctor.clock-own": Text(
        "die Datenbank hat die Uhr dieses Rechners",
    ),
    "doctor.clock": Text(
        "die Uhren dieses Rechners und der Datenbank unterscheiden sich um {seconds:.1f} s",
    ),
    "doctor.clock-differs": Text(
        "die Uhren dieses Rechners und der Datenbank unterscheiden sich um {seconds:.1f} s",
        "Beide mit NTP synchronisieren.",
    ),
    "doctor.store-own": Text(
        "große Werte sind in der Datenbank gespeichert",
    ),
    "doctor.store": Text(
        "{url} kann geschrieben und gelesen werden",
    ),
    "doctor.store-missing": Text(
        "große Werte sind in einem Ordner oder Bucket gespeichert, aber --store ist nicht "
        "angegeben",
        "Dieselbe Option --store angeben wie beim Server.",
    ),
    "doctor.accounts": Text(
        "es gibt einen Administrator",
    ),
    "doctor.accounts-local": Text(
        "es gibt keinen Administrator: Jedes Programm auf diesem Rechner darf alles",
        "Einen Administrator anlegen: knifetip user add NAME --role admin",
    ),
    "doctor.accounts-key": Text(
        "es gibt keinen Administrator: Der Schlüssel des Servers gibt Zugang zu allem",
        "Einen Administrator anlegen: knifetip user add NAME --role admin",
    ),
    "doctor.accounts-closed": Text(
        "es gibt weder einen Administrator noch einen Schlüssel, also nimmt ein Server an {host} "
        "nichts an",
        "Einen Administrator anlegen: knifetip user add NAME --role admin",
    ),
    "doctor.key-unbound": Text(
        "der Schlüssel {title} eines Gateways gilt für jede Maschine",
        "Für jede Maschine einen anlegen: knifetip key create TITEL --scope gateway --machine "
        "MASCHINE; dann knifetip key revoke {id}.",
    ),
    "doctor.gateway": Text(
        "das Gateway von {machine} ist verbunden",
    ),
    "doctor.gateway-absent": Text(
        "Aufträge warten auf {machine}, deren Gateway nicht verbunden ist",
        "Es an der Maschine starten: knifetip gateway --machine {machine} --server URL",
    ),
    "doctor.gateways-none": Text(
        "kein Gateway ist verbunden, und kein Auftrag wartet",
    ),
}
