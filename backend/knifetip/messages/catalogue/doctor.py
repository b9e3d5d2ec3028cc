"""doctor: messages of the command knifetip doctor about an installation."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "doctor.failed": entry(
        "the check failed: {reason}",
        "Report this error, with the output of knifetip doctor.",
        reason="text",
    ),
    "doctor.grade-ok": entry(
        "OK",
    ),
    "doctor.grade-warning": entry(
        "warning",
    ),
    "doctor.grade-problem": entry(
        "problem",
    ),
    "doctor.python": entry(
        "version {version} ({path})",
        version="text",
        path="text",
    ),
    "doctor.python-old": entry(
        "version {version} is too old",
        "Install Python 3.11 or newer.",
        version="text",
    ),
    "doctor.packages": entry(
        "knifetip {version} and all packages that it needs are installed",
        version="text",
    ),
    "doctor.packages-faulty": entry(
        "{faults:; }",
        "Install knifetip again: pip install --force-reinstall knifetip",
        faults="messages",
    ),
    "doctor.package-missing": entry(
        "{name} is not installed",
        name="text",
    ),
    "doctor.package-unloadable": entry(
        "{module} cannot be loaded: {reason}",
        module="text",
        reason="text",
    ),
    "doctor.package-version": entry(
        "{name} {version} is installed, but {bounds} is needed",
        name="text",
        version="text",
        bounds="text",
    ),
    "doctor.kernels": entry(
        "all compiled functions have machine code",
    ),
    "doctor.kernels-missing": entry(
        "{count:# function|# functions} in {modules:# module|# modules} {count:has|have} no "
        "current machine code",
        "The first server or worker compiles them, which takes some minutes; orders wait for it.",
        count="count",
        modules="count",
    ),
    "doctor.converter": entry(
        "{program} ({path}) converts {format} files",
        program="text",
        path="text",
        format="text",
    ),
    "doctor.converter-missing": entry(
        "{program} is not installed, so {format} files are refused",
        program="text",
        format="text",
    ),
    "doctor.disk": entry(
        "{folder}: {free:,} MB free",
        folder="text",
        free="count",
    ),
    "doctor.disk-low": entry(
        "{folder}: {free:,} MB free",
        "Make room soon: see --keep-jobs and --keep-drawings.",
        folder="text",
        free="count",
    ),
    "doctor.disk-full": entry(
        "{folder}: {free:,} MB free",
        "Make room: a server refuses uploads and orders now.",
        folder="text",
        free="count",
    ),
    "doctor.disk-unwritable": entry(
        "{folder} cannot be written: {reason}",
        "Let the user of the server write to the folder, or repair the disk.",
        folder="text",
        reason="text",
    ),
    "doctor.ports-none": entry(
        "this computer has no serial ports",
    ),
    "doctor.port": entry(
        "{port} may be opened",
        port="text",
    ),
    "doctor.port-refused": entry(
        "this user may not open {port}",
        "Add the user to the group of the port: sudo usermod -aG dialout USER",
        port="text",
    ),
    "doctor.port-missing": entry(
        "there is no serial port {port}",
        "Connect the controller, switch it on, or name another port.",
        port="text",
    ),
    "doctor.machine": entry(
        "{name}: {title}, {count:# station|# stations}",
        name="text",
        title="text",
        count="count",
    ),
    "doctor.controller": entry(
        "{address} is a valid address for {language}",
        address="text",
        language="text",
    ),
    "doctor.server": entry(
        "{url} answers",
        url="text",
    ),
    "doctor.server-unhealthy": entry(
        "{url} answers with the HTTP status {status} at /healthz",
        "Check the URL, and the proxy before the server.",
        url="text",
        status="count",
    ),
    "doctor.server-unreachable": entry(
        "{url} cannot be reached: {reason}",
        "Start the server with knifetip serve; check the URL and the network.",
        url="text",
        reason="text",
    ),
    "doctor.version": entry(
        "the server has the same version, {version}",
        version="text",
    ),
    "doctor.version-differs": entry(
        "the server has version {theirs}, but version {ours} is installed here",
        "Install the same version on all computers.",
        theirs="text",
        ours="text",
    ),
    "doctor.ready": entry(
        "the server is ready",
    ),
    "doctor.not-ready": entry(
        "the server is not ready: {reason}",
        "Run knifetip doctor on the computer of the server, and correct what it reports.",
        reason="text",
    ),
    "doctor.key": entry(
        "the server accepts the key",
    ),
    "doctor.key-unneeded": entry(
        "the server needs no key from this computer",
    ),
    "doctor.key-refused": entry(
        "the server refuses the key",
        "Create one at the server: knifetip key create TITLE --scope viewer --file FILE; give "
        "--key-file FILE.",
    ),
    "doctor.key-required": entry(
        "the server requires a key",
        "Create one at the server: knifetip key create TITLE --scope viewer --file FILE; give "
        "--key-file FILE.",
    ),
    "doctor.key-unchecked": entry(
        "the server answers with the HTTP status {status}",
        "Read the log of the server.",
        status="count",
    ),
    "doctor.database": entry(
        "{url}, revision {revision}",
        url="text",
        revision="text",
    ),
    "doctor.database-missing": entry(
        "there is no file {file} yet",
        "Start knifetip serve, which creates the file, or name another database with --database.",
        file="text",
    ),
    "doctor.database-silent": entry(
        "{url} does not answer: {reason}",
        "Start the database server; check the URL, the password and the network.",
        url="text",
        reason="text",
    ),
    "doctor.database-old": entry(
        "{url}, revision {revision}, but revision {newest} is needed",
        "Make a backup, then start knifetip serve, which migrates the database.",
        url="text",
        revision="text",
        newest="text",
    ),
    "doctor.database-old-shared": entry(
        "{url}, revision {revision}, but revision {newest} is needed",
        "Stop the servers, make a backup, and run: knifetip db upgrade",
        url="text",
        revision="text",
        newest="text",
    ),
    "doctor.writing": entry(
        "the database stores changes",
    ),
    "doctor.writing-disk-full": entry(
        "the disk of the database is full",
        "Make room on the disk.",
    ),
    "doctor.writing-refused": entry(
        "the database cannot be written: {reason}",
        "Check the permissions of the file, and whether the database is a read-only copy.",
        reason="text",
    ),
    "doctor.clock-own": entry(
        "the database has the clock of this computer",
    ),
    "doctor.clock": entry(
        "the clocks of this computer and the database differ by {seconds:.1f} s",
        seconds="number",
    ),
    "doctor.clock-differs": entry(
        "the clocks of this computer and the database differ by {seconds:.1f} s",
        "Synchronise both with NTP.",
        seconds="number",
    ),
    "doctor.store-own": entry(
        "large values are stored in the database",
    ),
    "doctor.store": entry(
        "{url} can be written and read",
        url="text",
    ),
    "doctor.store-missing": entry(
        "large values are stored in a folder or bucket, but --store is not given",
        "Give the same option --store as for the server.",
    ),
    "doctor.accounts": entry(
        "there is an administrator",
    ),
    "doctor.accounts-local": entry(
        "there is no administrator: every program on this computer may do everything",
        "Create an administrator: knifetip user add NAME --role admin",
    ),
    "doctor.accounts-key": entry(
        "there is no administrator: the key of the server gives access to everything",
        "Create an administrator: knifetip user add NAME --role admin",
    ),
    "doctor.accounts-closed": entry(
        "there is neither an administrator nor a key, so a server does not listen on {host}",
        "Create an administrator: knifetip user add NAME --role admin",
        host="text",
    ),
    "doctor.key-unbound": entry(
        "the key {title} of a gateway is for any machine",
        "Create one for each machine: knifetip key create TITLE --scope gateway --machine MACHINE; "
        "then knifetip key revoke {id}.",
        title="text",
        id="text",
    ),
    "doctor.gateway": entry(
        "the gateway of {machine} is connected",
        machine="text",
    ),
    "doctor.gateway-absent": entry(
        "jobs wait for {machine}, whose gateway is not connected",
        "Start it beside the machine: knifetip gateway --machine {machine} --server URL",
        machine="text",
    ),
    "doctor.gateways-none": entry(
        "no gateway is connected, and no job waits",
    ),
}
