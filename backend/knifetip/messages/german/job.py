"""job: German texts of the messages of ``catalogue.job``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "job.action-requested": Text(
        "Der Bediener hat „{action:request}“ angefordert.",
    ),
    "job.at-line": Text(
        "Die Maschine ist bei Programmzeile {line}.",
    ),
    "job.awaits-kernels": Text(
        "Der Auftrag wartet, bis der Server die Programmteile kompiliert hat, die die Maschine "
        "{machine} braucht. Das macht der Server einmal nach einer Installation.",
        "Warten. Der Auftrag läuft von selbst weiter.",
    ),
    "job.being-cancelled": Text(
        "Auftrag {job} wird schon abgebrochen.",
        "Warten, bis die Maschine steht.",
    ),
    "job.cancelled": Text(
        "Der Auftrag wurde abgebrochen.",
    ),
    "job.cancelled-before-request": Text(
        "Auftrag {job} wird abgebrochen, also ist „{request:request}“ nicht möglich.",
        "Warten, bis die Maschine steht.",
    ),
    "job.check-refused": Text(
        "Das Programm wurde nicht begonnen, also kam der Auftrag zurück in die Warteschlange: "
        "{reason}",
    ),
    "job.checked": Text(
        "Der Bediener hat an der Maschine geprüft: {checks:; }.",
    ),
    "job.nothing-refused": Text(
        "Auftrag {job} ist {state:state}, und keine Maschine hat sein Programm abgelehnt, also "
        "gibt es nichts noch einmal zu versuchen.",
    ),
    "job.rechecked": Text(
        "Der Bediener hat die Maschine den Auftrag noch einmal prüfen lassen.",
    ),
    "job.claim-returned": Text(
        "Das Gateway hat den Auftrag in die Warteschlange zurückgelegt. {reason}",
    ),
    "job.changed": Text(
        "Auftrag {job} wurde geändert, seit Sie ihn gelesen haben.",
        "Den Auftrag noch einmal lesen und die Änderung wiederholen, wenn sie noch nötig ist.",
    ),
    "job.claimed": Text(
        "Das Gateway der Maschine hat den Auftrag aus der Warteschlange genommen (übernommen).",
    ),
    "job.claimed-to-confirm": Text(
        "Das Gateway der Maschine hat den Auftrag aus der Warteschlange genommen. Er wartet jetzt "
        "auf die Bestätigung des Bedieners.",
    ),
    "job.compile-cancelled": Text(
        "Die Berechnung des Auftrags wurde abgebrochen.",
    ),
    "job.compile-crashed": Text(
        "Interner Fehler {incident} beim Berechnen. Nichts wurde geschnitten.",
        "Den Fehler mit dem Protokoll des Servers melden, das unter dieser Nummer die Ursache "
        "enthält.",
    ),
    "job.compile-started": Text(
        "Versuch {attempt}, den Auftrag zu berechnen, hat begonnen.",
    ),
    "job.compiles-died": Text(
        "Der Prozess, der den Auftrag berechnet, endete {attempts} Mal unerwartet, zuletzt im "
        "Schritt „{stage:stage}“.",
        "Eine kleinere Zeichnung senden oder den Fehler mit der Zeichnung melden.",
    ),
    "job.confirmed-sheet": Text(
        "Der Bediener hat bestätigt, dass ein neuer Bogen {board} auf dem Tisch liegt.",
    ),
    "job.confirmed-table": Text(
        "Der Bediener hat bestätigt, dass der Tisch frei ist und dass das Material darauf {board} "
        "ist.",
    ),
    "job.copy-done": Text(
        "Exemplar {copy} von {copies} des Auftrags ist fertig.",
    ),
    "job.copy-done-next-sheet": Text(
        "Exemplar {copy} von {copies} des Auftrags ist fertig. Das nächste Exemplar braucht einen "
        "neuen Bogen.",
        "Einen neuen Bogen auf den Tisch legen, dann auf der Seite des Auftrags den neuen Bogen "
        "bestätigen. Die Maschine beginnt danach mit dem nächsten Exemplar.",
    ),
    "job.declared-finished": Text(
        "Der Bediener hat den Auftrag als fertig gemeldet, nachdem die Maschine bei Programmzeile "
        "{line} von {lines} stehen geblieben war.",
    ),
    "job.details-changed": Text(
        "Die Angaben der Bestellung wurden geändert.",
    ),
    "job.exceptions-accepted": Text(
        "{by} hat {count:# Einschränkung|# Einschränkungen} angenommen: {reason}",
    ),
    "job.executed": Text(
        "Die Maschine hat jede Zeile des Programms ausgeführt.",
    ),
    "job.fully-executed": Text(
        "Die Maschine hat Auftrag {job} bis zur letzten Programmzeile ({lines}) ausgeführt, also "
        "kann er nicht noch einmal eingereiht werden.",
        "Den Tisch prüfen. Ist der Bogen vollständig, den Auftrag als fertig melden, sonst ihn "
        "verwerfen.",
    ),
    "job.gateway-lost": Text(
        "Das Gateway {gateway} antwortet nicht mehr.",
        "Den Rechner des Gateways und seine Netzwerkverbindung prüfen.",
    ),
    "job.gateway-silent": Text(
        "Das Gateway {gateway}, das Auftrag {job} übernommen hat, antwortet nicht.",
        "Die Maschine einschalten und ihr Gateway starten. Den Auftrag bestätigen, wenn er wieder "
        "auf eine Bestätigung wartet.",
    ),
    "job.held-before-start": Text(
        "Der Bediener hat den Auftrag angehalten, bevor die Maschine die erste Programmzeile "
        "ausgeführt hat. Die Maschine startet, wenn der Bediener den Auftrag noch einmal "
        "bestätigt.",
    ),
    "job.interrupted": Text(
        "Der Auftrag wurde bei Programmzeile {line} von {lines} unterbrochen. {cause} {copy}",
        "{cause:hint} Den Tisch prüfen. Hat sich der Bogen nicht bewegt, ihn fortsetzen: Nur die "
        "übrigen Bahnen werden gemacht. Sonst den Auftrag noch einmal einreihen (ein neuer Bogen "
        "wird ab der ersten Programmzeile geschnitten), ihn als fertig melden, wenn der Bogen "
        "vollständig ist, oder ihn verwerfen.",
    ),
    "job.interrupted-in-first-line": Text(
        "Der Auftrag wurde unterbrochen, bevor seine erste Programmzeile von {lines} ausgeführt "
        "war. Es ist nicht bekannt, ob sich die Maschine bewegt hat. {cause} {copy}",
        "{cause:hint} Den Tisch prüfen. Ist der Bogen unberührt und unbewegt, den Auftrag "
        "fortsetzen oder noch einmal einreihen. Sonst ihn verwerfen.",
    ),
    "job.interrupted-unobserved": Text(
        "Der Auftrag wurde bei Programmzeile {line} von {lines} oder später unterbrochen: {most}. "
        "{cause} {copy}",
        "{cause:hint} Den Bogen ansehen: Er zeigt, welche Bahnen gemacht sind. Zum Fortsetzen für "
        "jede Bahn, von der es nicht bekannt ist, angeben, ob sie gemacht ist.",
    ),
    "job.machine-not-free": Text(
        "Auftrag {job} kann nicht starten, weil seine Maschine jetzt keinen Auftrag annimmt. "
        "{reason}",
        "{reason:hint}",
    ),
    "job.may-have-ended": Text(
        "niemand hat die Maschine danach beobachtet, sie kann das Programm also zu Ende "
        "ausgeführt haben",
    ),
    "job.may-have-gone-on": Text(
        "niemand hat die Maschine danach beobachtet, sie kann also Zeilen bis Zeile {line} "
        "ausgeführt haben",
    ),
    "job.interrupted-at-end": Text(
        "Der Auftrag wurde bei Programmzeile {line} von {lines} unterbrochen. {cause} {copy}",
        "{cause:hint} Den Tisch prüfen. Ist der Bogen vollständig, den Auftrag als fertig melden, "
        "sonst ihn verwerfen.",
    ),
    "job.interrupted-between-copies": Text(
        "Der Auftrag wurde nach Exemplar {copy} von {copies} unterbrochen, vor der ersten "
        "Programmzeile des nächsten Exemplars. {cause}",
        "{cause:hint} Den Tisch prüfen. Dann den Auftrag für die übrigen Exemplare noch einmal "
        "einreihen, ihn als fertig melden oder ihn verwerfen.",
    ),
    "job.late-report": Text(
        "Eine verspätete Meldung des Gateways ist eingetroffen: {report}",
    ),
    "job.needs-end": Text(
        "Das ganze Programm von Auftrag {job} wurde an die Maschine gesendet, die nicht meldet, "
        "wann sie fertig ist. Es gibt also nichts fortzusetzen.",
        "Wenn die Maschine fertig ist und steht, dies auf der Seite der Station oder mit POST "
        "/api/jobs/{job}/end bestätigen.",
    ),
    "job.needs-sheet": Text(
        "Auftrag {job} wartet auf einen neuen Bogen, kann also nicht fortgesetzt werden.",
        "Einen neuen Bogen auf den Tisch legen, die Prüfungen an der Maschine machen, dann den "
        "Auftrag bestätigen.",
    ),
    "job.no-confirmation-awaited": Text(
        "Auftrag {job} ist {state:state}, er wartet also nicht auf eine Bestätigung.",
        "{advice}",
    ),
    "job.no-end-awaited": Text(
        "Auftrag {job} ist {state:state}, und seine Maschine wartet nicht darauf, dass jemand das "
        "Ende eines Programms bestätigt.",
        "Die Seite des Auftrags zeigt, worauf er wartet.",
    ),
    "job.no-sheet-awaited": Text(
        "Auftrag {job} ist angehalten, aber er wartet nicht auf einen neuen Bogen.",
        "Den Auftrag fortsetzen.",
    ),
    "job.no-shortfalls": Text(
        "Die Einschränkungen von Auftrag {job} können nicht angenommen werden, weil der Auftrag "
        "nicht abgelehnt ist oder auch aus einem anderen Grund abgelehnt wurde.",
        "Die Felder state und reason des Auftrags prüfen und zuerst diesen anderen Grund beheben.",
    ),
    "job.verdict-changed": Text(
        "Das Prüfergebnis von Auftrag {job} hat sich geändert, seit es gelesen wurde.",
        "Das Prüfergebnis noch einmal lesen, dann die Anfrage wiederholen.",
    ),
    "job.no-work": Text(
        "Die Zeichnung enthält nichts, was die Maschine machen kann: Jede Kante ist für ihr "
        "Werkzeug zu kurz oder liegt an einer Stelle, in die der Fräser nicht kommt.",
        "Die Einheit der Zeichnung und die Linienarten der Kanten prüfen. Sonst eine andere "
        "Maschine oder Maschinendatei wählen: ein kleineres Rillrad für kurze Rillen, einen "
        "dünneren Fräser oder ein Messer für enge Konturen.",
    ),
    "job.not-checked": Text(
        "In der Bestätigung von Auftrag {job} fehlt, was an der Maschine zu prüfen ist: "
        "{missing:; }.",
        "Diese Prüfungen an der Maschine machen, dann den Auftrag mit allen in `checked` "
        "bestätigen.",
    ),
    "job.not-confirmed": Text(
        "Auftrag {job} wurde gestartet, obwohl der Bediener nicht bestätigt hat, dass der Tisch "
        "bereit ist.",
        "Den Tisch prüfen, dann den Auftrag bestätigen oder abbrechen.",
    ),
    "job.not-running": Text(
        "Die Meldung wurde nicht angenommen, weil Auftrag {job} {state:state} ist und auf keiner "
        "Maschine läuft.",
        "Den Auftrag zuerst mit dem Gateway übernehmen und nur melden, solange er läuft.",
    ),
    "job.not-taken": Text(
        "Auftrag {job} ist in der Warteschlange, und das Gateway seiner Maschine {machine} hat "
        "ihn noch nicht übernommen.",
        "Den Auftrag bestätigen, nachdem das Gateway ihn übernommen hat. Das Feld reason des "
        "Auftrags zeigt, worauf er wartet.",
    ),
    "job.nothing-sent": Text(
        "Das Gateway hat nichts an die Maschine gesendet.",
    ),
    "job.nothing-to-confirm": Text(
        "Auftrag {job} läuft, also ist nichts zu bestätigen.",
        "Den Auftrag anhalten oder abbrechen, wenn die Maschine stehen bleiben muss.",
    ),
    "job.of-copy": Text(
        "Das war in Exemplar {copy} von {copies}.",
    ),
    "job.ordered": Text(
        "Der Auftrag wurde angelegt.",
    ),
    "job.other-phase": Text(
        "Auftrag {job} ist inzwischen weitergelaufen, also passt die Anfrage nicht mehr.",
        "Prüfen, worauf der Auftrag wartet, dann ihn fortsetzen, wenn die Maschine weiterlaufen "
        "darf.",
    ),
    "job.outdated": Text(
        "Das Programm von Auftrag {job} ist veraltet: {changes:; }.",
        "Den Auftrag neu berechnen. Sein Programm wird dann für die jetzige Maschine und das "
        "jetzige Material gemacht und geprüft.",
    ),
    "job.recompiled": Text(
        "Der Bediener hat den Auftrag für die jetzige Maschine und das jetzige Material neu "
        "berechnen lassen.",
    ),
    "job.program-has-shortfalls": Text(
        "Die Werkzeuge können nicht jede Linie wie gezeichnet machen: {findings: } {more}",
        "Diese Einschränkungen für den Auftrag annehmen oder die Zeichnung, die Linienarten der "
        "Kanten, die Werkzeuge oder das Material ändern.",
    ),
    "job.program-refused": Text(
        "Das Programm entspricht nicht der Zeichnung, also wurde nichts geschnitten: {findings: } "
        "{more}",
        "Eine andere Maschine oder ein anderes Material wählen, die Zeichnung ändern, oder die "
        "Linienart dieser Kanten auf „Ignoriert“ setzen und sie von Hand machen.",
    ),
    "job.released": Text(
        "Der Bediener hat den Auftrag freigegeben, er ist in der Warteschlange seiner Maschine.",
    ),
    "job.released-by-order": Text(
        "Der Auftrag wurde automatisch freigegeben, wie in der Bestellung verlangt, und ist in "
        "der Warteschlange seiner Maschine.",
    ),
    "job.requeued": Text(
        "Der Bediener hat den Auftrag noch einmal eingereiht.",
    ),
    "job.scrapped": Text(
        "Der Bediener hat den Auftrag verworfen.",
    ),
    "job.stale-epoch": Text(
        "Auftrag {job} wurde neu übernommen, also gilt die Übernahme durch dieses Gateway nicht "
        "mehr. Der Auftrag ist {state:state}. Seine gültige Übernahme hat die Nummer (epoch) "
        "{current}, aber die Anfrage nennt {epoch}.",
        "Die Maschine anhalten und den Auftrag neu übernehmen.",
    ),
    "job.started": Text(
        "Der Auftrag wurde gestartet.",
    ),
    "job.started-unconfirmed": Text(
        "Der Auftrag wurde ohne Bestätigung des Bedieners gestartet.",
    ),
    "job.stated-by-feed": Text(
        "Die automatische Bogenzufuhr hat bestätigt: {checks:; }.",
    ),
    "job.unknown": Text(
        "Auftrag {job} gibt es nicht.",
        "Einen der Aufträge wählen, die GET /api/jobs nennt.",
    ),
    "job.answered": Text(
        "Der Auftrag verwendet das geprüfte Programm von Auftrag {job}, der dieselbe Zeichnung, "
        "Maschine und Optionen hat.",
    ),
    "job.unknown-checks": Text(
        "Auftrag {job} hat keine Prüfung {unknown:, }.",
        "Seine Prüfungen sind {known:, }.",
    ),
    "job.verified": Text(
        "Der Auftrag wurde berechnet und sein Programm geprüft.",
    ),
    "job.tool-changed": Text(
        "Der Bediener hat in Station {station} ({name}) ein neues Werkzeug eingesetzt. Das alte "
        "hatte {used:.0f} m Linien bearbeitet.",
    ),
    "job.worker-silent": Text(
        "Der Prozess {worker}, der den Auftrag berechnet, antwortet im Schritt „{stage:stage}“ "
        "nicht mehr.",
        "Wenn es wieder geschieht, den Fehler mit dem Protokoll des Servers melden.",
    ),
    "job.worn-tools": Text(
        "Auftrag {job} benutzt Werkzeuge am Ende ihrer Standzeit: {tools: }",
        "Neue Werkzeuge in diese Stationen einsetzen und den Auftrag mit den Nummern der "
        "gewechselten Stationen bestätigen, oder angeben, warum die Werkzeuge im Einsatz bleiben.",
    ),
    "job.worn-tools-used": Text(
        "Der Bediener benutzt Werkzeuge am Ende ihrer Standzeit: {tools: } Grund: {reason}",
    ),
    "job.wrong-state": Text(
        "Auftrag {job} ist {state:state}, kann also nicht „{goal:state}“ werden.",
        "{advice}",
    ),
    "job.wrong-state-for-request": Text(
        "Auftrag {job} ist {state:state}, aber für „{request:request}“ muss er {states:state} "
        "sein.",
        "{advice}",
    ),
    "advice.compiling": Text(
        "Warten, bis der Auftrag berechnet ist.",
    ),
    "advice.ended": Text(
        "Den Auftrag neu bestellen.",
    ),
    "advice.interrupted": Text(
        "Den Tisch prüfen, dann den Auftrag als fertig melden, noch einmal einreihen oder "
        "verwerfen.",
    ),
    "advice.of-reason": Text(
        "{reason:hint}",
    ),
    "advice.queued": Text(
        "Warten, bis das Gateway der Maschine den Auftrag übernommen hat.",
    ),
    "advice.ready": Text(
        "Den Auftrag zuerst freigeben.",
    ),
    "advice.running": Text(
        "Den Auftrag anhalten, fortsetzen oder abbrechen.",
    ),
    "machine.busy": Text(
        "Auftrag {job} belegt schon den Tisch von {machine}.",
        "Warten, bis jener Auftrag beendet ist. Ist er unterbrochen, entscheiden, was mit ihm "
        "geschieht: als fertig melden, noch einmal einreihen oder verwerfen.",
    ),
    "machine.busy-with-another": Text(
        "Ein anderer Auftrag belegt schon den Tisch von {machine}.",
        "Warten, bis jener Auftrag beendet ist. Ist er unterbrochen, entscheiden, was mit ihm "
        "geschieht: als fertig melden, noch einmal einreihen oder verwerfen.",
    ),
    "machine.no-cutter": Text(
        "{machine} hat keinen Fräser mit dem Namen „{cutter}“, weil keines ihrer Werkzeuge ein "
        "Fräser oder ein Laser ist.",
        "Eine Maschine mit Fräser oder Laser wählen. Nur diese Werkzeuge können kalibriert werden.",
    ),
    "machine.no-such-cutter": Text(
        "{machine} hat keinen Fräser mit dem Namen „{cutter}“.",
        "Einen der Fräser {known:, } wählen.",
    ),
    "worker.died": Text(
        "Der Prozess, der die Zeichnung berechnete, endete unerwartet (Exit-Code {code}), "
        "wahrscheinlich weil er zu viel Speicher brauchte.",
        "Eine kleinere Zeichnung senden oder die Zeichnung in mehrere teilen.",
    ),
    "worker.memory": Text(
        "Die Zeichnung braucht mehr als die {limit} GB Speicher, die für eine Zeichnung erlaubt "
        "sind.",
        "Eine kleinere Zeichnung senden oder die Zeichnung in mehrere teilen.",
    ),
    "worker.timeout": Text(
        "Die Bearbeitung der Zeichnung dauerte im Schritt „{stage:stage}“ länger als "
        "{seconds:.0f} s.",
        "Eine kleinere Zeichnung senden oder die Zeichnung in mehrere teilen.",
    ),
}
