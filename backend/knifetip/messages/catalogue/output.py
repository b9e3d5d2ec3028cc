"""output: what commands print besides messages of other areas."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "output.accepted-by": entry(
        "accepted by {by}: {reason}",
        by="text",
        reason="text",
    ),
    "output.actions": entry(
        "actions: {actions:, }",
        actions="texts",
    ),
    "output.add-lines": entry(
        "add these lines to the board file",
    ),
    "output.calibrated": entry(
        "{count} points, largest residual {residual:.4f} mm; {where}.",
        count="count",
        residual="number",
        where="message",
    ),
    "output.carriage": entry(
        "carriage {number}: axes {axes: }, parks at {letter}{park:g}, stations {stations:, }",
        number="count",
        axes="texts",
        letter="text",
        park="y",
        stations="texts",
    ),
    "output.carriage-without-station": entry(
        "carriage {number}: axes {axes: }, parks at {letter}{park:g}, no stations",
        number="count",
        axes="texts",
        letter="text",
        park="y",
    ),
    "output.carriages": entry(
        "carriages at least {distance:g} mm apart",
        distance="number",
    ),
    "output.check-first": entry(
        "Check at the machine before job {job} starts:",
        job="text",
    ),
    "output.check-question": entry(
        "{number} of {count}: {text} Is this true?",
        number="count",
        count="count",
        text="text",
    ),
    "output.cleaned-edge": entry(
        "{handle} edge {edge}: {outcome}",
        handle="text",
        edge="edge",
        outcome="message",
    ),
    "output.customer": entry(
        "customer {customer}",
        customer="text",
    ),
    "output.disabled": entry(
        "(disabled)",
    ),
    "output.drawn": entry(
        "drawn {drawn:.3f} mm = kept {kept:.3f} + merged {merged:.3f} + dropped {dropped:.3f}",
        drawn="number",
        kept="number",
        merged="number",
        dropped="number",
    ),
    "output.expires": entry(
        "expires {date}",
        date="text",
    ),
    "output.folder-unreadable": entry(
        "the folder cannot be read: {reason}",
        reason="text",
    ),
    "output.former-database": entry(
        "The former database is kept as {file}.",
        file="text",
    ),
    "output.gateway": entry(
        "{title}: controller {controller}, server {server}",
        title="text",
        controller="text",
        server="text",
    ),
    "output.if-so": entry(
        "If all of this is true, enter:",
    ),
    "output.job-board": entry(
        "{machine}, board {board}",
        machine="text",
        board="text",
    ),
    "output.job-progress": entry(
        "line {line} of {lines}, copies {done} of {copies}",
        line="count",
        lines="count",
        done="count",
        copies="count",
    ),
    "output.job-tools": entry(
        "tools: {tools:, }",
        tools="messages",
    ),
    "output.kernels": entry(
        "Compiled {compiled} of {total} software modules.",
        compiled="count",
        total="count",
    ),
    "output.key": entry(
        "key {id} for {title}: {scopes:, }",
        id="text",
        title="text",
        scopes="texts",
    ),
    "output.key-row": entry(
        "{id} {title} {scopes} {notes:, }",
        id="text",
        title="text",
        scopes="text",
        notes="messages",
    ),
    "output.used": entry(
        "used {date}",
        date="text",
    ),
    "output.key-valid": entry(
        "{file}: key {id} for {title} is valid",
        file="text",
        id="text",
        title="text",
    ),
    "output.leave-out": entry(
        "To leave out these edges and make them by hand: --edge {edges}=ignored",
        edges="text",
    ),
    "output.line-type": entry(
        "{type} {count} edges {length} mm",
        type="text",
        count="text",
        length="text",
    ),
    "output.listening": entry(
        "listening on {address}",
        address="text",
    ),
    "output.machine": entry(
        "{title} ({name}), language {language}, {feed} feed",
        title="text",
        name="text",
        language="text",
        feed="text",
    ),
    "output.machines": entry(
        "machines {names: }",
        names="texts",
    ),
    "output.migrated": entry(
        "The tables were migrated from revision {before} to revision {after}. {copy}",
        before="text",
        after="text",
        copy="message?",
    ),
    "output.migrated-new": entry(
        "The tables were migrated to revision {after}. {copy}",
        after="text",
        copy="message?",
    ),
    "output.migration-copy": entry(
        "A copy from before the migration is {file}.",
        file="text",
    ),
    "output.more": entry(
        "and {count} more",
        count="count",
    ),
    "output.more-lines": entry(
        "… and {count} more: --json lists them all",
        count="count",
    ),
    "output.no-tables": entry(
        "no tables; knifetip needs revision {newest}",
        newest="text",
    ),
    "output.not-cleaned": entry(
        "The drawing was not cleaned: {reason}",
        reason="message",
    ),
    "output.not-confirmed": entry(
        "Job {job} was not confirmed. The machine does not start.",
        job="text",
    ),
    "output.profile": entry(
        "{name}: {title}, {count} rules",
        name="text",
        title="text",
        count="count",
    ),
    "output.profile-not-stored": entry(
        "No database: the profile was not stored. Name one with --database.",
    ),
    "output.profile-stored": entry(
        "stored as version {version}",
        version="count",
    ),
    "output.read": entry(
        "{file}: {size}, {count} segments; {evidence}",
        file="text",
        size="text",
        count="count",
        evidence="message",
    ),
    "output.revision-current": entry(
        "revision {revision}, up to date {writer}",
        revision="text",
        writer="message?",
    ),
    "output.revision-newer": entry(
        "revision {revision}, newer than revision {newest} of this version {writer}",
        revision="text",
        writer="message?",
        newest="text",
    ),
    "output.revision-older": entry(
        "revision {revision}, older than revision {newest} of this version {writer}",
        revision="text",
        writer="message?",
        newest="text",
    ),
    "output.revoked": entry(
        "revoked {date}",
        date="text",
    ),
    "output.server-silent": entry(
        "the server does not answer: {reason}",
        reason="text",
    ),
    "output.size-and-edges": entry(
        "{file}: {size}, {count} edges",
        file="text",
        size="text",
        count="count",
    ),
    "output.station": entry(
        "{number}  {name}: {tool}, datum {datum}",
        number="count",
        name="text",
        tool="text",
        datum="text",
    ),
    "output.tables-current": entry(
        "The tables are up to date.",
    ),
    "output.time-saved": entry(
        "{seconds:.1f} s on the machine, {percent:.0f} % less than the {retracted:.1f} s with a "
        "full lift of the tool between cuts",
        seconds="number",
        percent="number",
        retracted="number",
    ),
    "output.to-accept": entry(
        'To accept: --accept {edges}:{code} --reason "..."',
        edges="text",
        code="text",
    ),
    "output.track": entry(
        "{number}  {state} station {station}  lines {first}-{last}  from X{x:.1f} Y{y:.1f}  edges "
        "{edges}",
        number="text",
        state="text",
        station="count",
        first="count",
        last="count",
        x="x",
        y="y",
        edges="text",
    ),
    "output.unreached-areas": entry(
        "the cutter does not reach {area:.2f} mm² in {count:# place|# places}, which remain uncut",
        area="number",
        count="count",
    ),
    "output.unreached-edges": entry(
        "the cutter does not reach {length:.2f} mm of the edges; they are up to {distance:.2f} mm "
        "from the cut",
        length="number",
        distance="number",
    ),
    "output.used-version": entry(
        "Version {version} of the machine is used, which was loaded before.",
        version="count",
    ),
    "output.user-row": entry(
        "{name} {role} last sign-in {date} {state}",
        name="text",
        role="text",
        date="text",
        state="message?",
    ),
    "output.verdict": entry(
        "{word}: deviation {deviation:.4f} mm (tolerance {tolerance:g} mm; of the path {path:.4f}, "
        "by rounding in the controller {blending:.4f}, of the curve fit {fit:.4f}), overcut "
        "{overcut:.3f} mm, uncut {uncut:.3f} mm, setback {setback:.3f} mm, {seconds:.1f} s at the "
        "programmed feeds",
        word="message",
        deviation="number",
        tolerance="number",
        path="number",
        blending="number",
        fit="number",
        overcut="number",
        uncut="number",
        setback="number",
        seconds="number",
    ),
    "output.waits-for": entry(
        "waits for {event}",
        event="text",
    ),
    "output.watching": entry(
        "watching {folder}, server {server}",
        folder="text",
        server="text",
    ),
    "output.wide-slits": entry(
        "{length:.2f} mm of {count:# slit|# slits} are milled as wide as the cutter",
        length="number",
        count="count",
    ),
    "output.word-accepted": entry(
        "accepted",
    ),
    "output.word-refused": entry(
        "refused",
    ),
    "output.worked": entry(
        "processed {worked:.3f} mm = kept {kept:.3f} + added by closing gaps {added:.3f}",
        worked="number",
        kept="number",
        added="number",
    ),
    "output.worker": entry(
        "compile worker for {database}",
        database="text",
    ),
    "output.worker-stuck": entry(
        "ERROR: this worker is stuck: it has not looked for jobs for {seconds:.0f} s. It exits "
        "with an error, so that systemd or the container engine starts it again.",
        seconds="number",
    ),
    "output.written-to": entry(
        "written to {file}",
        file="text",
    ),
    "output.zone": entry(
        "keep-out zone {name}: X {left:g} to {right:g}, Y {bottom:g} to {back:g}, {top:g} mm high",
        name="text",
        left="number",
        right="number",
        bottom="number",
        back="number",
        top="number",
    ),
    "output.writer": entry(
        "(made by knifetip {version})",
        version="text",
    ),
    "output.password": entry(
        "Password",
    ),
    "output.hands-clear": entry(
        "Are all hands clear of the machine?",
    ),
    "output.cancel-effect": entry(
        "The machine holds, lifts the tool and releases its stations. The board on the table is "
        "probably lost.",
    ),
    "output.cancel-question": entry(
        "{effect} Cancel job {job}?",
        effect="message",
        job="text",
    ),
    "output.job-state": entry(
        "The job is {state}.",
        state="text",
    ),
    "output.scrap-question": entry(
        "The table is freed. Order missing copies with knifetip job rest. Scrap job {job}?",
        job="text",
    ),
}
