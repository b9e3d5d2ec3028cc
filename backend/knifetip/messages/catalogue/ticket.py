"""ticket: the texts of job tickets."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "ticket.accepted": entry("Accepted exceptions"),
    "ticket.accepted-by": entry(
        "{finding} – accepted by {by}, {at}: {reason}",
        finding="message",
        by="text",
        at="text",
        reason="text",
    ),
    "ticket.board": entry("Board"),
    "ticket.board-thickness": entry(
        "{board}, {caliper:g} mm thick",
        board="text",
        caliper="number",
    ),
    "ticket.boxes": entry(
        "A box □ stands for a letter that the fonts of the server lack.",
    ),
    "ticket.changed": entry(
        "{drawing}, revision {revision}. CHANGED after this job was ordered; the picture shows the "
        "present drawing",
        drawing="text",
        revision="count",
    ),
    "ticket.copies": entry("Copies"),
    "ticket.customer": entry("Customer"),
    "ticket.drawing": entry("Drawing"),
    "ticket.due": entry("Due"),
    "ticket.job": entry("Job {job}", job="text"),
    "ticket.hours": entry("{time} h", time="text"),
    "ticket.kind-crease-wheel": entry("Crease wheel"),
    "ticket.kind-cutter": entry("Router bit"),
    "ticket.kind-knife": entry("Knife"),
    "ticket.kind-laser": entry("Laser"),
    "ticket.kind-v-cutter": entry("V-cutter"),
    "ticket.length": entry("Length in the board"),
    "ticket.lengths": entry("Lengths of the drawing"),
    "ticket.line-type": entry(
        "{type}: {length:,.2f} m",
        type="text",
        length="number",
    ),
    "ticket.machine": entry("Machine"),
    "ticket.marks": entry("Marks"),
    "ticket.metres": entry("{length:,.2f} m", length="number"),
    "ticket.minutes": entry("{time} min", time="text"),
    "ticket.more": entry(
        "and {count:# more|# more}",
        count="count",
    ),
    "ticket.no-program": entry(
        "There is no program yet (state: {state}). Do not begin with this ticket.",
        state="text",
    ),
    "ticket.no-value": entry("–"),
    "ticket.no-verdict": entry(
        "The program is not verified (state: {state}). Do not begin with this ticket.",
        state="text",
    ),
    "ticket.notes": entry("Notes for the operator"),
    "ticket.order": entry("Order"),
    "ticket.page": entry(
        "Printed {at} · page {page} of {pages}",
        at="text",
        page="text",
        pages="text",
    ),
    "ticket.place": entry("Place on the table"),
    "ticket.place-at": entry(
        "lower left corner of the sheet at X {x:.1f}, Y {y:.1f} mm",
        x="x",
        y="y",
    ),
    "ticket.place-drawing": entry(
        "lower left corner of the drawing at X {x:.1f}, Y {y:.1f} mm",
        x="x",
        y="y",
    ),
    "ticket.refused": entry(
        "REFUSED: the program does not make the drawing as drawn; findings that refuse it: "
        "{count}. Do not begin with this ticket.",
        count="count",
    ),
    "ticket.revision": entry("{drawing}, revision {revision}", drawing="text", revision="count"),
    "ticket.scan": entry("Open the station"),
    "ticket.seconds": entry("{seconds} s", seconds="count"),
    "ticket.sheet": entry("Sheet"),
    "ticket.sheet-any": entry("larger than the drawing; its size is not given"),
    "ticket.sheet-size": entry(
        "{width:g} × {height:g} mm, margins {left:g} mm left, {below:g} mm below",
        width="number",
        height="number",
        left="number",
        below="number",
    ),
    "ticket.station": entry("Station"),
    "ticket.stations": entry("Tools to be loaded"),
    "ticket.time": entry("Time"),
    "ticket.tenths": entry("{seconds:.1f} s", seconds="number"),
    "ticket.times": entry("Machine time"),
    "ticket.times-all": entry(
        "{each} each, {all} for all copies (without changes of the sheet)",
        each="message",
        all="message",
    ),
    "ticket.title": entry("Job ticket"),
    "ticket.tool": entry("Tool"),
    "ticket.tool-blade": entry(
        "blade {width:g} mm wide, slanted {angle:g}°",
        width="number",
        angle="number",
    ),
    "ticket.tool-cutter": entry("Ø {diameter:g} mm", diameter="number"),
    "ticket.tool-groove": entry(
        "tilted {tilt:g}°, d {back:g} mm, r {half_width:g} mm",
        tilt="number",
        back="number",
        half_width="number",
    ),
    "ticket.tool-laser": entry("kerf {kerf:g} mm", kerf="number"),
    "ticket.tool-oscillating": entry(
        "oscillating blade {width:g} mm wide, slanted {angle:g}°",
        width="number",
        angle="number",
    ),
    "ticket.tool-wheel": entry(
        "Ø {diameter:g} mm, rim {width:g} mm",
        diameter="number",
        width="number",
    ),
    "ticket.verdict": entry("Check of the program"),
    "ticket.verified": entry(
        "The program makes the drawing within {deviation:.3f} mm ({tolerance:g} mm allowed), with "
        "at most {overcut:.2f} mm cut beyond the end of a line.",
        deviation="number",
        tolerance="number",
        overcut="number",
    ),
    "ticket.verified-except": entry(
        "The program makes the drawing within {deviation:.3f} mm ({tolerance:g} mm allowed), "
        "except for {count:# accepted exception|# accepted exceptions}.",
        deviation="number",
        tolerance="number",
        count="count",
    ),
}
